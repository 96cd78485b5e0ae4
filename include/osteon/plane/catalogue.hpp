// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// All local events of the plane: the inversion of a triangle of three lines (design 06). The
/// cells around the point where three lines meet are numbered by three bits, bit r set inside line
/// r; the polygon there is a monotone function of the cells.

#include <array>
#include <cstdint>

#include "osteon/core/local_events.hpp"

namespace osteon::plane::local {

using osteon::local::cell;
/// Which cells around a meeting are inside of the polygon: a bit for each name of a cell.
using state = std::uint8_t;

/// Returns whether cell c is inside the polygon.
constexpr bool inside(state f, cell c) { return osteon::local::solid(f, c); }

/// Says which three pieces of line r exist at a time: two rays and the segment between the other
/// lines. A piece's label is the cell on its outer side. Before the event the segment's label is
/// `small` without bit r, afterwards the opposite one; those of the rays stay.
constexpr cell segment_label(cell small, unsigned r, bool after) { return (after ? small ^ 7U : small) & ~(1U << r); }

/// Returns whether the piece of line r with this label belongs to an edge.
constexpr bool has_edge(state f, unsigned r, cell label) { return inside(f, label) != inside(f, label | 1U << r); }

/// What is seen of a state: a bit for each piece.
using view = std::uint32_t;
/// Returns the bit of a view for the piece of line r with a label.
constexpr view piece_bit(unsigned r, cell label) { return view{1} << (8 * r + label); }
/// Returns which pieces of the lines are edges around a meeting, for a state and the name of the
/// small cell.
constexpr view view_of(state f, cell small) {
  view v = 0;
  for (unsigned r = 0; r < 3; ++r)
    for (cell label = 0; label < 8; ++label)
      if ((label >> r & 1U) == 0 && label != segment_label(small, r, true) && has_edge(f, r, label)) v |= piece_bit(r, label);
  return v;
}

/// One local event.
struct event {
  view before;
  state after;
};

/// The events for one small cell.
struct event_list {
  std::array<event, 12> all{};
  int size = 0;
};

/// Returns all local events with all three lines involved: for each of the seven sign patterns of
/// lambda (the triangle is never outside of all lines while it shrinks) the states before and the
/// only admissible one after. 32 entries, ten up to the names of the lines
/// (tests/planar_catalogue_test.cpp).
constexpr std::array<event_list, 8> make_catalogue() {
  std::array<event_list, 8> result{};
  osteon::local::for_each_event<3>([&result](const osteon::local::event& e) {
    event_list& events = result[e.small];
    const auto before = static_cast<state>(e.before);
    for (const bool fill : {false, true})
      if (fill ? e.may_fill : e.may_empty)
        events.all[events.size++] = {view_of(before, e.small), static_cast<state>(osteon::local::successor<3>(before, e.small, fill))};
  });
  return result;
}
/// All local events, by the name of the small cell.
inline constexpr std::array<event_list, 8> catalogue = make_catalogue();

/// Returns the event seen, or null.
constexpr const event* find(cell small, view seen) {
  const event_list& events = catalogue[small];
  for (int i = 0; i < events.size; ++i)
    if (events.all[i].before == seen) return &events.all[i];
  return nullptr;
}

}  // namespace osteon::plane::local
