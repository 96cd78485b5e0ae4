// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Statements about the thirteen classes of events (thesis 3.9) and about the nine corners.

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "events.hpp"
#include "local_picture.hpp"
#include "report.hpp"

namespace osteon::proofs {

inline constexpr int any_number = -1;

/// A class by the vertices before and after, the edges that vanish and appear, and whether an edge passes by.
struct class_rule {
  event_class name;
  int before, after, vanish, appear, passes;
};
inline constexpr std::array<class_rule, 13> class_rules = {{{event_class::E1, 2, 2, 1, 1, 0},
                                                            {event_class::E2, 3, 1, 2, any_number, any_number},
                                                            {event_class::E3, 3, 1, 3, any_number, any_number},
                                                            {event_class::E4, 4, 0, 4, any_number, any_number},
                                                            {event_class::E5, 4, 0, 5, any_number, any_number},
                                                            {event_class::E6, 4, 0, 6, any_number, any_number},
                                                            {event_class::V_E, 1, 3, 0, 2, any_number},
                                                            {event_class::V_V_I, 2, 2, 0, 1, 0},
                                                            {event_class::V_V_II, 2, 2, 0, 0, 0},
                                                            {event_class::V_V_E_I, 2, 2, 1, 0, 1},
                                                            {event_class::V_V_E_II, 2, 2, 0, any_number, 1},
                                                            {event_class::E_E, 0, 4, 0, 4, any_number},
                                                            {event_class::V_F, 1, 3, 0, 3, any_number}}};

/// The class of an event; `other` where no rule fits.
inline event_class class_of(const moment& m, const moment& then) {
  const std::array<int, 5> seen = {m.vertices(), then.vertices(), m.short_edges(), then.short_edges(), m.passing_edge() ? 1 : 0};
  for (const class_rule& r : class_rules) {
    const std::array<int, 5> rule = {r.before, r.after, r.vanish, r.appear, r.passes};
    if (std::equal(seen.begin(), seen.end(), rule.begin(), [](int x, int y) { return y == any_number || x == y; })) return r.name;
  }
  return event_class::other;
}

inline std::string name_of(event_class c) { return std::string(event_names[static_cast<std::size_t>(c)]); }

inline bool has_majority(const moment& m) {
  for (unsigned q = 0; q < planes; ++q) {
    const auto [convex, reflex] = edges_at_vertex(m, q);
    if (convex + reflex == 6) return true;
  }
  return false;
}

/// A monotone function of the four planes a, b, c, d by its least true points.
inline std::string sum_of_products(state f) {
  std::string result;
  for (cell c = 1; c <= every_plane; ++c) {
    bool least = solid_at(f, c);
    for (unsigned q = 0; q < planes; ++q) least = least && !(in(c, q) && solid_at(f, c ^ bit(q)));
    if (!least) continue;
    if (!result.empty()) result += '+';
    for (unsigned q = 0; q < planes; ++q)
      if (in(c, q)) result += static_cast<char>('a' + static_cast<char>(q));
  }
  return result;
}

/// Visits each event up to renaming with each of its outcomes: visit(before, after, class).
template <class Visit>
void for_each_outcome(Visit&& visit) {
  for (const moment& m : events_up_to_renaming())
    for (const bool fill : {false, true})
      if (const moment then = after(m, fill); admissible(then)) visit(m, then, class_of(m, then));
}

inline void prove_classes(proof& p) {
  std::map<event_class, int> members;
  std::map<std::string, int> outside;
  int with_majority = 0;
  for_each_outcome([&](const moment& m, const moment& then, event_class c) {
    const local::event* e = in_catalogue(m);
    p.check(e != nullptr && classify(*e, solid_at(then.f, then.tiny)) == c,
            [&] { return text(m) + ": the catalogue does not call it " + name_of(c); });
    ++members[c];
    if (c != event_class::other) return;
    const bool majority = has_majority(m) || has_majority(then);
    with_majority += majority ? 1 : 0;
    ++outside["V" + std::to_string(m.vertices()) + " -> V" + std::to_string(then.vertices()) + ", edges " + std::to_string(m.short_edges()) + " -> " +
              std::to_string(then.short_edges()) + (m.passing_edge() ? ", one passing" : "") +
              (majority ? ", with a majority corner" : ", F = " + sum_of_products(m.f | then.f))];
  });
  std::string list;
  for (const class_rule& r : class_rules) {
    p.check(members[r.name] > 0, [&] { return name_of(r.name) + " has no member"; });
    list += (list.empty() ? "" : ", ") + name_of(r.name) + " " + std::to_string(members[r.name]);
  }
  p.note("members: " + list);
  p.note("outside all classes: " + std::to_string(members[event_class::other]) + ", of which " + std::to_string(with_majority) +
         " have a majority corner before or after");
  for (const auto& [what, count] : outside) p.note("outside: " + std::to_string(count) + " of " + what);
}

/// Table 3.1. Time reversed, the state after an event is a state before one, whose small cell is the complement.
inline void prove_inverse_events(proof& p) {
  using enum event_class;
  const std::map<event_class, event_class> table = {
      {E1, E1},  {E2, V_E}, {E3, V_F}, {E4, E_E}, {V_E, E2}, {V_V_I, V_V_E_I}, {V_V_II, V_V_II}, {V_V_E_I, V_V_I}, {V_V_E_II, V_V_E_II},
      {E_E, E4}, {V_F, E3}};
  std::map<event_class, int> regular;
  std::map<std::string, int> exceptions;
  for_each_outcome([&](const moment& m, const moment& then, event_class c) {
    const bool was_solid = solid_at(m.f, m.tiny);
    const moment back = after(then, was_solid);
    p.check(back.f == m.f && back.tiny == m.tiny, [&] { return text(m) + ": reversing time twice is not the identity"; });
    bool vanished = false;  // a facet that was the small triangle alone; its reverse would come from nowhere
    for (unsigned q = 0; q < planes; ++q) vanished = vanished || facet_from_nowhere(m, q);
    p.check(vanished != (then.involves_all() && admissible(back)), [&] { return text(m) + " has no reverse, yet no facet vanishes"; });
    if (vanished) {
      ++exceptions[name_of(c) + " make a triangular facet vanish, which in reverse would come from nowhere"];
      p.check(c == E3 || c == E5 || c == E6 || c == other, [&] { return text(m) + " is " + name_of(c) + " and a facet vanishes"; });
      return;
    }
    p.check(c != E5 && c != E6, [&] { return text(m) + " is " + name_of(c) + " and has an inverse"; });
    const event_class inverse = class_of(then, back);
    const auto row = table.find(c);
    if (row == table.end() || inverse == other) {
      ++exceptions[name_of(c) + " have a reverse that is " + name_of(inverse)];
      p.check(c == other && inverse == other, [&] { return text(m) + ": " + name_of(c) + " has the inverse " + name_of(inverse); });
      return;
    }
    ++regular[c];
    p.check(inverse == row->second, [&] { return text(m) + ": " + name_of(c) + " has the inverse " + name_of(inverse); });
  });
  std::string list;
  for (const auto& [c, inverse] : table) {
    p.check(regular[c] > 0, [&, name = name_of(c)] { return name + " has no regular inverse"; });
    list += (list.empty() ? "" : ", ") + name_of(c) + " -> " + name_of(inverse) + " " + std::to_string(regular[c]);
  }
  p.note("as in the table: " + list);
  for (const auto& [what, count] : exceptions) p.note("exception: " + std::to_string(count) + " " + what);
}

inline void prove_nine_corners(proof& p) {
  using formula = std::function<bool(bool, bool, bool)>;
  const std::vector<std::pair<int, formula>> families = {{0, [](bool x, bool y, bool z) { return x && y && z; }},
                                                         {1, [](bool x, bool y, bool z) { return x || y || z; }},
                                                         {2, [](bool x, bool y, bool z) { return x && (y || z); }},
                                                         {3, [](bool x, bool y, bool z) { return x || (y && z); }},
                                                         {4, [](bool x, bool y, bool z) { return x + y + z >= 2; }}};
  std::map<state, int> expected;
  for (const auto& [family, f] : families)
    for (unsigned first = 0; first < 3; ++first) {
      state g = 0;
      for (cell c = 0; c < 8; ++c)
        if (f(in(c, first), in(c, (first + 1) % 3), in(c, (first + 2) % 3))) g |= state{1} << c;
      expected.emplace(g, family);
    }
  const auto dual = [](state g) {
    state d = 0;
    for (cell c = 0; c < 8; ++c)
      if (!solid_at(g, c ^ 7U)) d |= state{1} << c;
    return d;
  };
  constexpr std::array<int, 5> dual_family = {1, 0, 3, 2, 4};
  constexpr std::array<int, 5> product = {1, 1, -1, -1, -2};  // the coefficient of xyz, by inclusion and exclusion
  std::size_t corners = 0;
  std::size_t monotone_count = 0;
  std::size_t self_dual = 0;
  for (state g = 0; g < 256; ++g) {
    bool monotone = true;
    for (cell c = 0; c < 8; ++c)
      for (unsigned q = 0; q < 3; ++q) monotone = monotone && (!solid_at(g, c) || solid_at(g, c | bit(q)));
    const auto what = [&] { return "function " + std::to_string(g); };
    const auto g8 = static_cast<std::uint8_t>(g);
    if (!monotone) {
      p.check(!expected.contains(g), what);
      continue;
    }
    ++monotone_count;
    const bool all = depends_on_all(g, 3);
    p.check(all == expected.contains(g) && all == local::is_corner(g8), what);
    p.check(all == (std::find(local::corners.begin(), local::corners.end(), g8) != local::corners.end()), what);
    if (!all) continue;
    ++corners;
    const int family = expected.at(g);
    p.check(expected.contains(dual(g)) && expected.at(dual(g)) == dual_family[static_cast<std::size_t>(family)], what);
    self_dual += dual(g) == g ? 1 : 0;
    p.check((dual(g) == g) == (family == 4) && (family == 4) == (g == local::majority), what);
    // Edges: on the three lines, inside and outside the third plane, one or three solid octants of four.
    int edges = 0;
    for (unsigned t = 0; t < 3; ++t)
      for (const bool inside : {false, true}) {
        const auto octants = std::popcount(restricted(g, 3, t, inside));
        const piece kind = octants == 1 ? piece::convex : (octants == 3 ? piece::reflex : piece::none);
        edges += kind == piece::none ? 0 : 1;
        p.check(local::corner_piece(g8, t, inside) == kind, what);
      }
    p.check(edges == (family == 4 ? 6 : 3), what);
    int coefficient = 0;
    for (cell c = 0; c < 8; ++c)
      if (solid_at(g, c)) coefficient += std::popcount(c ^ 7U) % 2 == 0 ? 1 : -1;
    p.check(coefficient == product[static_cast<std::size_t>(family)] && coefficient == local::product_weight(g8), what);
  }
  p.check(corners == 9 && expected.size() == 9 && monotone_count == 20 && self_dual == 1, [&] { return std::to_string(corners) + " corners"; });
  p.note("complement and reversal of sides: and <-> or, x(y+z) <-> x+yz, majority alone is its own dual and has six edges");
}

}  // namespace osteon::proofs
