// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Local events, in the plane and in space: what may happen where D + 1 planes of dimension D meet
/// in a point (docs/theory/events.md). The planes cut the point's neighbourhood into cells, and an
/// event replaces the one small cell by its opposite. Which cells are solid before the event is
/// given; whether the new cell is solid is decided by two rules: the solid stays monotone, and no
/// facet appears from nowhere.
///
/// Notation. `Planes` is D + 1: 3 lines in the plane, 4 planes in space. A cell is a number whose
/// bit q says "inside plane q". `small` is the cell that vanishes: the small triangle or
/// tetrahedron before the event. Its complement, the `created` cell, exists only after it.

#include <array>
#include <cstdint>

namespace osteon::local {

/// A cell of the neighbourhood: bit q is set inside plane q.
using cell = unsigned;
/// A set of cells: bit c is set iff cell c is solid.
using state = std::uint32_t;

/// The cell inside all planes; `c ^ every_plane<Planes>` is the cell opposite to c.
template <unsigned Planes>
inline constexpr cell every_plane = (1U << Planes) - 1U;

/// Returns whether a cell lies inside plane q.
constexpr bool is_inside(cell c, unsigned q) { return (c >> q & 1U) != 0; }

/// Returns whether cell c is solid.
constexpr bool solid(state f, cell c) { return (f >> c & 1U) != 0; }

/// Returns whether f, on all cells but `missing`, never loses solid on the way into a plane.
template <unsigned Planes>
constexpr bool monotone(state f, cell missing) {
  for (cell c = 0; c <= every_plane<Planes>; ++c)
    for (unsigned q = 0; q < Planes; ++q) {
      const cell d = c | 1U << q;
      if (d != c && c != missing && d != missing && solid(f, c) && !solid(f, d)) return false;
    }
  return true;
}

/// Returns whether a facet on plane q reaches the common point: f changes across the plane between
/// two cells that exist.
template <unsigned Planes>
constexpr bool involved(state f, unsigned q, cell missing) {
  for (cell c = 0; c <= every_plane<Planes>; ++c) {
    const cell d = c ^ 1U << q;
    if (c != missing && d != missing && solid(f, c) != solid(f, d)) return true;
  }
  return false;
}

/// Returns whether the created cell makes a facet of its own on some plane: one that no neighbour
/// across another plane continues.
template <unsigned Planes>
constexpr bool makes_facet_from_nowhere(state after, cell created) {
  for (unsigned q = 0; q < Planes; ++q) {
    if (solid(after, created) == solid(after, created ^ 1U << q)) continue;
    bool attached = false;
    for (unsigned r = 0; r < Planes; ++r) {
      const cell next = created ^ 1U << r;
      if (r != q && solid(after, next) != solid(after, next ^ 1U << q)) attached = true;
    }
    if (!attached) return true;
  }
  return false;
}

/// Returns the state after the event, with the created cell solid or not.
template <unsigned Planes>
constexpr state successor(state before, cell small, bool fill) {
  const state kept = before & ~(state{1} << small);
  return fill ? kept | state{1} << (small ^ every_plane<Planes>) : kept;
}

/// One local event: the state before, in which the created cell is left empty, and what may follow.
struct event {
  state before;
  cell small;
  bool may_empty;  ///< the created cell may stay outside the solid
  bool may_fill;   ///< the created cell may become solid
};

/// Calls visit(event) for every local event in which all planes are involved, in ascending order of
/// small cells and states. An event with two outcomes is ambiguous; none has no outcome
/// (tests/catalogue_test.cpp, tests/planar_catalogue_test.cpp).
/// *Complexity* 2^(2^Planes) steps for each small cell.
template <unsigned Planes, class Visit>
constexpr void for_each_event(Visit visit) {
  constexpr state states = state{1} << (1U << Planes);
  for (cell small = 1; small <= every_plane<Planes>; ++small) {
    const cell created = small ^ every_plane<Planes>;
    for (state f = 0; f < states; ++f) {
      if (solid(f, created) || !monotone<Planes>(f, created)) continue;
      bool all = true;
      for (unsigned q = 0; q < Planes; ++q) all = all && involved<Planes>(f, q, created);
      if (!all) continue;
      std::array<bool, 2> may{};
      for (const bool fill : {false, true}) {
        const state after = successor<Planes>(f, small, fill);
        may[fill ? 1 : 0] = monotone<Planes>(after, small) && !makes_facet_from_nowhere<Planes>(after, created);
      }
      visit(event{f, small, may[0], may[1]});
    }
  }
}

}  // namespace osteon::local
