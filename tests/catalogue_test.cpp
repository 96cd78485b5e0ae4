// SPDX-License-Identifier: MIT
#include "osteon/space/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace osteon::local {
namespace {

using form = std::pair<cell, state>;

// The least of an event's 24 forms under renaming of planes.
form canonical(const event& e) {
  std::array<unsigned, 4> name = {0, 1, 2, 3};
  form least{~0U, ~0U};
  do {
    const auto rename = [&](cell c) {
      cell result = 0;
      for (unsigned q = 0; q < 4; ++q)
        if ((c >> q & 1U) != 0) result |= 1U << name[q];
      return result;
    };
    state f = 0;
    for (cell c = 0; c < 16; ++c)
      if (solid(e.before, c)) f |= state{1} << rename(c);
    least = std::min(least, form{rename(e.small), f});
  } while (std::next_permutation(name.begin(), name.end()));
  return least;
}

std::map<form, event> all_events() {
  std::map<form, event> result;
  for (cell small = 1; small < 16; ++small)
    for (const auto& [key, e] : catalogue::get().events(small)) result.emplace(canonical(e), e);
  return result;
}

TEST(Catalogue, HasTheEventsOfDesign02) {
  const auto events = all_events();
  EXPECT_EQ(events.size(), 105U);
  const auto outcomes = [&](int n) {
    return std::count_if(events.begin(), events.end(),
                         [n](const auto& e) { return (e.second.may_empty ? 1 : 0) + (e.second.may_fill ? 1 : 0) == n; });
  };
  EXPECT_EQ(outcomes(0), 0) << "an event without a successor";
  EXPECT_EQ(outcomes(1), 103);
  EXPECT_EQ(outcomes(2), 2) << "the saddles";
}

TEST(Catalogue, BoundaryDeterminesTheState) { EXPECT_TRUE(catalogue::get().keys_are_unique()); }

TEST(Catalogue, EveryClassHasMembers) {
  std::array<int, event_classes> members{};
  for (const auto& [least, e] : all_events())
    for (const bool fill : {false, true})
      if (fill ? e.may_fill : e.may_empty) ++members[static_cast<std::size_t>(classify(e, fill))];
  for (int c = 0; c < event_classes - 1; ++c) EXPECT_GT(members[static_cast<std::size_t>(c)], 0) << event_names[static_cast<std::size_t>(c)];
}

TEST(Catalogue, SaddlesAreE1AndDifferByAnEdgeOfEitherKind) {
  for (const auto& [least, e] : all_events()) {
    if (!e.may_empty || !e.may_fill) continue;
    EXPECT_EQ(classify(e, false), event_class::E1);
    EXPECT_EQ(classify(e, true), event_class::E1);
  }
}

// Time reversal turns the state after an event into the state before its inverse, with the planes' inner and outer
// sides kept and the small cell complemented.
TEST(Catalogue, InverseEventsAreThoseOfTable31) {
  using enum event_class;
  const std::map<event_class, event_class> inverse = {
      {E1, E1},  {E2, V_E}, {E3, V_F}, {E4, E_E}, {V_E, E2}, {V_V_I, V_V_E_I}, {V_V_II, V_V_II}, {V_V_E_I, V_V_I}, {V_V_E_II, V_V_E_II},
      {E_E, E4}, {V_F, E3}};
  int checked = 0;
  for (const auto& [least, e] : all_events())
    for (const bool fill : {false, true}) {
      if (!(fill ? e.may_fill : e.may_empty)) continue;
      const auto back = catalogue::get().find(e.small ^ 15U, key(successor(e, fill), e.small ^ 15U));
      const auto kind = classify(e, fill);
      if (back == nullptr) continue;  // not all planes are involved after the event, or nothing is left (E5, E6)
      const bool was_solid = solid(e.before, e.small);
      if (!(was_solid ? back->may_fill : back->may_empty)) continue;
      const auto other = classify(*back, was_solid);
      const auto expected = inverse.find(kind);
      if (expected == inverse.end() || other == event_class::other) continue;
      EXPECT_EQ(other, expected->second) << event_names[static_cast<std::size_t>(kind)];
      ++checked;
    }
  EXPECT_GT(checked, 20);
}

// What the event loop looks for (propagate.hpp) finds every event: an edge that collapses; a reflex or mixed corner at a plane that
// has an edge with one of the corner's facets; and, where the small cell lies inside all four planes, two reflex edges that
// cross and a reflex corner at any plane.
TEST(Catalogue, EveryEventIsLookedFor) {
  for (cell small = 1; small < 16; ++small)
    for (const auto& [boundary, e] : catalogue::get().events(small)) {
      const auto corner = [&](unsigned omitted) { return corner_at(e.before, omitted, (small >> omitted & 1U) != 0); };
      const auto line = [&](unsigned p, section w) { return piece_at(e.before, pairs[p], label(pairs[p], w, small, false)); };
      bool found = false;
      for (unsigned p = 0; p < 6; ++p) {
        const auto at = line(p, segment);
        found = found || (at != piece::none && is_corner(corner(pairs[p].k)) && is_corner(corner(pairs[p].l)));
        found = found || (small == 15U && at == piece::reflex && line(5 - p, segment) == piece::reflex);
        if (line(p, far_k) == piece::none && at == piece::none && line(p, far_l) == piece::none) continue;
        for (const unsigned l : {pairs[p].i, pairs[p].j}) {
          const auto at_l = corner(l);
          found = found || (is_corner(at_l) && at_l != convex && at_l != majority);
        }
      }
      for (unsigned l = 0; l < 4; ++l) found = found || (small == 15U && corner(l) == reflex);
      EXPECT_TRUE(found) << "small cell " << small << ", state " << e.before;
    }
}

TEST(Catalogue, NineCorners) {
  int found = 0;
  for (unsigned g = 0; g < 256; ++g) {
    bool monotone = true;
    for (unsigned x = 0; x < 8; ++x)
      for (unsigned q = 0; q < 3; ++q) monotone = monotone && ((g >> x & 1U) <= (g >> (x | 1U << q) & 1U));
    if (!monotone || !is_corner(static_cast<std::uint8_t>(g))) continue;
    ++found;
    EXPECT_NE(std::find(corners.begin(), corners.end(), g), corners.end());
  }
  EXPECT_EQ(found, 9);
  EXPECT_TRUE(is_corner(majority));
}

}  // namespace
}  // namespace osteon::local
