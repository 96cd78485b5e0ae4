// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The neighbourhood of a point where four moving planes meet, from the definitions of design 02 and without the code of
/// osteon/catalogue.hpp, from which only the vocabulary is taken (cell, state, piece, section).

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "osteon/space/catalogue.hpp"

namespace osteon::proofs {

using local::cell;
using local::piece;
using local::section;
using local::state;

inline constexpr unsigned planes = 4;
inline constexpr cell every_plane = 15;

constexpr cell bit(unsigned q) { return 1U << q; }
constexpr bool in(cell c, unsigned q) { return (c & bit(q)) != 0; }
constexpr bool solid_at(state f, cell c) { return (f >> c & 1U) != 0; }

/// All monotone functions of n variables as truth tables: a lower half below an upper half for the last variable. Dedekind's numbers.
inline std::vector<state> monotone_functions(unsigned n) {
  if (n == 0) return {0, 1};
  std::vector<state> result;
  const std::vector<state> halves = monotone_functions(n - 1);
  for (const state low : halves)
    for (const state high : halves)
      if ((low & ~high) == 0) result.push_back(low | high << (1U << (n - 1)));
  return result;
}

/// The function of the other variables, in their order, where variable q of n has a value.
constexpr state restricted(state f, unsigned n, unsigned q, bool value) {
  state result = 0;
  unsigned at = 0;
  for (cell c = 0; c < 1U << n; ++c)
    if (in(c, q) == value) result |= static_cast<state>(solid_at(f, c)) << at++;
  return result;
}

constexpr bool depends_on(state f, unsigned n, unsigned q) { return restricted(f, n, q, false) != restricted(f, n, q, true); }

constexpr bool depends_on_all(state f, unsigned n) {
  for (unsigned q = 0; q < n; ++q)
    if (!depends_on(f, n, q)) return false;
  return true;
}

/// The line of planes i and j; the other two planes are k and l.
struct line {
  unsigned i, j, k, l;
};
inline std::array<line, 6> all_lines() {
  std::array<line, 6> result{};
  std::size_t at = 0;
  for (unsigned i = 0; i < planes; ++i)
    for (unsigned j = i + 1; j < planes; ++j) {
      const cell rest = every_plane ^ bit(i) ^ bit(j);
      result[at++] = {i, j, static_cast<unsigned>(std::countr_zero(rest)), static_cast<unsigned>(std::bit_width(rest)) - 1};
    }
  return result;
}
inline const std::array<line, 6> lines = all_lines();
inline constexpr std::array<section, 3> sections = {local::far_k, local::segment, local::far_l};

/// The solid around the point shortly before or after the event: `tiny` is the small tetrahedron of the moment, its complement does
/// not exist. The vertex of the planes other than q lies on the tetrahedron's side of q.
struct moment {
  state f;
  cell tiny;

  cell missing() const { return tiny ^ every_plane; }
  bool exists(cell c) const { return c != missing(); }

  /// A facet on plane q parts the cells c and c ^ q.
  bool facet(unsigned q, cell c) const { return exists(c) && exists(c ^ bit(q)) && solid_at(f, c) != solid_at(f, c ^ bit(q)); }
  bool involves(unsigned q) const {
    for (cell c = 0; c <= every_plane; ++c)
      if (facet(q, c)) return true;
    return false;
  }
  bool involves_all() const { return involves(0) && involves(1) && involves(2) && involves(3); }

  /// The solid on the inner side of every plane that it changes at.
  bool monotone() const {
    for (cell c = 0; c <= every_plane; ++c)
      for (unsigned q = 0; q < planes; ++q)
        if (!in(c, q) && facet(q, c) && solid_at(f, c)) return false;
    return true;
  }

  /// The cells around a piece of a line, less its two planes' bits. The ray beyond (i,j,k) lies on the other side of k.
  cell around(const line& n, section w) const {
    const cell here = tiny & (bit(n.k) | bit(n.l));
    return w == local::segment ? here : here ^ bit(w == local::far_k ? n.k : n.l);
  }
  /// A convex edge has one solid cell of four around it, a reflex edge three; two are a facet that passes.
  piece edge(const line& n, section w) const {
    const cell c = around(n, w);
    int count = 0;
    for (const cell d : {c, c | bit(n.i), c | bit(n.j), c | bit(n.i) | bit(n.j)}) count += solid_at(f, d) ? 1 : 0;
    return count == 1 ? piece::convex : (count == 3 ? piece::reflex : piece::none);
  }

  /// The solid near the vertex of the planes other than q, and whether that is a vertex of the solid.
  state corner(unsigned q) const { return restricted(f, planes, q, in(tiny, q)); }
  bool vertex(unsigned q) const { return depends_on_all(corner(q), planes - 1); }
  int vertices() const {
    int count = 0;
    for (unsigned q = 0; q < planes; ++q) count += vertex(q) ? 1 : 0;
    return count;
  }
  /// An edge between two vertices that shrinks to, or grows from, the point.
  bool short_edge(const line& n) const { return edge(n, local::segment) != piece::none && vertex(n.k) && vertex(n.l); }
  int short_edges() const {
    return static_cast<int>(std::count_if(lines.begin(), lines.end(), [this](const line& n) { return short_edge(n); }));
  }
  /// An edge that runs past both of its planes' vertices here.
  bool passing_edge() const {
    return std::any_of(lines.begin(), lines.end(),
                       [this](const line& n) { return edge(n, local::segment) != piece::none && !vertex(n.k) && !vertex(n.l); });
  }
};

inline std::string text(const moment& m) { return "state " + std::to_string(m.f) + " with small cell " + std::to_string(m.tiny); }

/// Whether the facet component on plane q that contains the tetrahedron's triangle is that triangle alone. The other three planes cut
/// plane q into regions; two are neighbours where they differ in one bit.
inline bool facet_from_nowhere(const moment& m, unsigned q) {
  if (!m.facet(q, m.tiny)) return false;
  std::vector<cell> component = {m.tiny | bit(q)};
  for (std::size_t at = 0; at < component.size(); ++at)
    for (unsigned r = 0; r < planes; ++r) {
      const cell next = component[at] ^ bit(r);
      if (r != q && m.facet(q, next) && std::find(component.begin(), component.end(), next) == component.end()) component.push_back(next);
    }
  return component.size() == 1;
}

/// The event keeps the solid on the cells that stay and chooses it on the new one.
inline moment after(const moment& before, bool fill) {
  const state kept = before.f & ~(state{1} << before.tiny);
  return {fill ? kept | state{1} << before.missing() : kept, before.missing()};
}

inline bool admissible(const moment& m) {
  for (unsigned q = 0; q < planes; ++q)
    if (facet_from_nowhere(m, q)) return false;
  return m.monotone();
}

/// All local events: monotone states in which all four planes are involved, for all sign patterns of lambda. A monotone function on 15
/// cells extends to the missing one, so all are restrictions of the monotone functions of four variables.
inline std::vector<moment> all_events() {
  std::vector<moment> result;
  const std::vector<state> functions = monotone_functions(planes);
  for (cell small = 1; small <= every_plane; ++small) {
    std::set<state> states;
    for (const state f : functions) states.insert(f & ~(state{1} << (small ^ every_plane)));
    for (const state f : states)
      if (const moment m{f, small}; m.involves_all()) result.push_back(m);
  }
  return result;
}

/// The least of the 24 forms under renaming of planes.
inline std::pair<cell, state> up_to_renaming(const moment& m) {
  std::array<unsigned, planes> name = {0, 1, 2, 3};
  std::pair<cell, state> least{~0U, ~0U};
  do {
    const auto rename = [&](cell c) {
      cell result = 0;
      for (unsigned q = 0; q < planes; ++q)
        if (in(c, q)) result |= bit(name[q]);
      return result;
    };
    state f = 0;
    for (cell c = 0; c <= every_plane; ++c)
      if (solid_at(m.f, c)) f |= state{1} << rename(c);
    least = std::min(least, std::pair(rename(m.tiny), f));
  } while (std::next_permutation(name.begin(), name.end()));
  return least;
}

/// One event of every kind up to renaming.
inline std::vector<moment> events_up_to_renaming() {
  std::set<std::pair<cell, state>> seen;
  std::vector<moment> result;
  for (const moment& m : all_events())
    if (seen.insert(up_to_renaming(m)).second) result.push_back(m);
  return result;
}

/// The event's entry in the catalogue of the library, or null.
inline const local::event* in_catalogue(const moment& m) {
  for (const auto& [key, e] : local::catalogue::get().events(m.tiny))
    if (e.before == m.f) return &e;
  return nullptr;
}

inline bool may(const local::event& e, bool fill) { return fill ? e.may_fill : e.may_empty; }

}  // namespace osteon::proofs
