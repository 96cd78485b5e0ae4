// SPDX-License-Identifier: MIT
#include "osteon/plane/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace osteon::plane::local {
namespace {

using osteon::local::involved;
using osteon::local::makes_facet_from_nowhere;
using osteon::local::monotone;
using osteon::local::successor;

// All states before with all lines involved, found anew from the states themselves.
struct entry {
  cell small;
  state before;
  std::vector<state> after;
};

std::vector<entry> all_entries() {
  std::vector<entry> result;
  for (cell small = 1; small < 8; ++small)
    for (unsigned f = 0; f < 256; ++f) {
      const auto before = static_cast<state>(f);
      if (inside(before, small ^ 7U) || !monotone<3>(before, small ^ 7U)) continue;
      bool all = true;
      for (unsigned r = 0; r < 3; ++r) all = all && involved<3>(before, r, small ^ 7U);
      if (!all) continue;
      entry e{small, before, {}};
      for (const bool fill : {false, true})
        if (const auto after = successor<3>(before, small, fill); monotone<3>(after, small) && !makes_facet_from_nowhere<3>(after, small ^ 7U))
          e.after.push_back(static_cast<state>(after));
      result.push_back(std::move(e));
    }
  return result;
}

// The least of six forms under renaming of lines.
std::pair<cell, state> canonical(const entry& e) {
  std::array<unsigned, 3> name = {0, 1, 2};
  std::pair<cell, state> least{~0U, state{255}};
  do {
    const auto rename = [&](cell c) {
      cell result = 0;
      for (unsigned r = 0; r < 3; ++r)
        if ((c >> r & 1U) != 0) result |= 1U << name[r];
      return result;
    };
    unsigned f = 0;
    for (cell c = 0; c < 8; ++c)
      if (inside(e.before, c)) f |= 1U << rename(c);
    least = std::min(least, {rename(e.small), static_cast<state>(f)});
  } while (std::next_permutation(name.begin(), name.end()));
  return least;
}

// How many edges there are on line r, and whether one lies on the segment and beyond its ends or not.
bool has_segment(const entry& e, unsigned r) { return has_edge(e.before, r, segment_label(e.small, r, false)); }

std::vector<cell> rays(const entry& e, unsigned r) {
  std::vector<cell> result;
  for (cell label = 0; label < 8; ++label)
    if ((label >> r & 1U) == 0 && label != segment_label(e.small, r, false) && label != segment_label(e.small, r, true)) result.push_back(label);
  return result;
}

TEST(planar_catalogue, has_thirty_two_entries) {
  int size = 0;
  for (const auto& events : catalogue) size += events.size;
  EXPECT_EQ(size, 32);
  EXPECT_EQ(catalogue[0].size, 0) << "the triangle that shrinks is not outside of all lines";
  EXPECT_EQ(all_entries().size(), 32U);
}

TEST(planar_catalogue, has_ten_events_but_for_the_names_of_lines) {
  std::set<std::pair<cell, state>> forms;
  for (const auto& e : all_entries()) forms.insert(canonical(e));
  EXPECT_EQ(forms.size(), 10U);
}

TEST(planar_catalogue, every_event_has_exactly_one_successor) {
  for (const auto& e : all_entries()) {
    ASSERT_EQ(e.after.size(), 1U) << "small cell " << e.small << ", state " << int{e.before};
    const event* found = find(e.small, view_of(e.before, e.small));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->after, e.after[0]);
  }
}

TEST(planar_catalogue, what_is_seen_tells_the_state) {
  for (cell small = 1; small < 8; ++small) {
    std::set<view> views;
    const event_list& events = catalogue[small];
    for (int i = 0; i < events.size; ++i) EXPECT_TRUE(views.insert(events.all[static_cast<std::size_t>(i)].before).second) << "small cell " << small;
  }
  EXPECT_EQ(find(7, 0), nullptr);
}

TEST(planar_catalogue, no_cell_but_the_small_one_changes) {
  for (const auto& e : all_entries())
    for (cell c = 0; c < 8; ++c) {
      if (c == e.small || c == (e.small ^ 7U)) continue;
      EXPECT_EQ(inside(e.after.at(0), c), inside(e.before, c));
    }
}

// Nothing appears: each edge after the event was there before, on the same line.
TEST(planar_catalogue, no_line_gets_its_first_edge) {
  for (const auto& e : all_entries())
    for (unsigned r = 0; r < 3; ++r) {
      bool before = false;
      for (cell label = 0; label < 8; ++label) before = before || ((label >> r & 1U) == 0 && has_edge(e.before, r, label));
      EXPECT_TRUE(before);
    }
}

// What the event loop looks for (propagate.hpp) finds every event: an edge that collapses, that is, one on a segment that goes on beyond neither end;
// or a reflex vertex of two lines that reaches an edge on the third.
TEST(planar_catalogue, every_event_is_looked_for) {
  int collapses = 0;
  int contacts = 0;
  for (const auto& e : all_entries()) {
    bool collapse = false;
    bool contact = false;
    for (unsigned r = 0; r < 3; ++r) {
      const auto beyond = rays(e, r);
      ASSERT_EQ(beyond.size(), 2U);
      const bool far = has_edge(e.before, r, beyond[0]) || has_edge(e.before, r, beyond[1]);
      collapse = collapse || (has_segment(e, r) && !far);
      // The corner of the other two lines: its four cells on the side of line r where it is before the event, that of the small cell.
      const unsigned j = r == 0 ? 1 : 0;
      const unsigned k = r == 2 ? 1 : 2;
      const cell side = e.small & 1U << r;
      const bool reflex = !inside(e.before, side) && inside(e.before, side | 1U << j) && inside(e.before, side | 1U << k) &&
                          inside(e.before, side | 1U << j | 1U << k);
      contact = contact || (reflex && (far || has_segment(e, r)));
    }
    EXPECT_TRUE(collapse || contact) << "small cell " << e.small << ", state " << int{e.before};
    collapses += collapse ? 1 : 0;
    contacts += contact ? 1 : 0;
  }
  EXPECT_GT(collapses, 0);
  EXPECT_GT(contacts, 0);
}

}  // namespace
}  // namespace osteon::plane::local
