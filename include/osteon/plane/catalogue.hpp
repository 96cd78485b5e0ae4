// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// All local events of the plane: the inversion of a triangle of three lines (design 06). The cells around the point where three lines meet
/// are numbered by three bits, bit r set inside line r; the polygon there is a monotone function of the cells.

#include <array>
#include <cstdint>

namespace osteon::plane::local {

using cell = unsigned;
using state = std::uint8_t;

constexpr bool inside(state f, cell c) { return (f >> c & 1U) != 0; }

/// Three pieces of line r exist at a time: two rays and the segment between the other lines. A piece's label is the cell on its outer side.
/// Before the event the segment's label is `small` without bit r, afterwards the opposite one; those of the rays stay.
constexpr cell segment_label(cell small, unsigned r, bool after) { return (after ? small ^ 7U : small) & ~(1U << r); }

/// Whether the piece of line r with this label belongs to an edge.
constexpr bool has_edge(state f, unsigned r, cell label) { return inside(f, label) != inside(f, label | 1U << r); }

/// Whether no cell becomes part of the polygon on the way out through a line.
constexpr bool monotone(state f, cell missing) {
  for (cell c = 0; c < 8; ++c)
    for (unsigned r = 0; r < 3; ++r) {
      const cell d = c | 1U << r;
      if (d != c && c != missing && d != missing && inside(f, c) && !inside(f, d)) return false;
    }
  return true;
}

/// Whether an edge on line r reaches the point.
constexpr bool involved(state f, unsigned r, cell missing) {
  for (cell c = 0; c < 8; ++c)
    if (c != missing && (c ^ 1U << r) != missing && inside(f, c) != inside(f, c ^ 1U << r)) return true;
  return false;
}

/// Whether the segment on some line would be an edge of its own, from nowhere.
constexpr bool edge_from_nowhere(state after, cell small) {
  for (unsigned r = 0; r < 3; ++r) {
    if (!has_edge(after, r, segment_label(small, r, true))) continue;
    bool attached = false;
    for (cell label = 0; label < 8; ++label) {
      const bool ray = (label >> r & 1U) == 0 && label != segment_label(small, r, true) && label != segment_label(small, r, false);
      attached = attached || (ray && has_edge(after, r, label));
    }
    if (!attached) return true;
  }
  return false;
}

/// The state after the event with the new cell outside or inside the polygon.
constexpr state successor(state before, cell small, bool fill) {
  return static_cast<state>((before & ~(1U << small)) | (fill ? 1U << (small ^ 7U) : 0U));
}

/// What is seen of a state: a bit for each piece.
using view = std::uint32_t;
constexpr view piece_bit(unsigned r, cell label) { return view{1} << (8 * r + label); }
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

/// All local events with all three lines involved: for each of the seven sign patterns of lambda (the triangle is never outside of all lines
/// while it shrinks) the states before and the only admissible one after. 32 entries, ten up to the names of the lines
/// (tests/planar_catalogue_test.cpp).
constexpr std::array<event_list, 8> make_catalogue() {
  std::array<event_list, 8> result{};
  for (cell small = 1; small < 8; ++small)
    for (unsigned f = 0; f < 256; ++f) {
      const auto before = static_cast<state>(f);
      if (inside(before, small ^ 7U) || !monotone(before, small ^ 7U)) continue;
      bool all = true;
      for (unsigned r = 0; r < 3; ++r) all = all && involved(before, r, small ^ 7U);
      if (!all) continue;
      for (const bool fill : {false, true}) {
        const state after = successor(before, small, fill);
        if (monotone(after, small) && !edge_from_nowhere(after, small)) result[small].all[result[small].size++] = {view_of(before, small), after};
      }
    }
  return result;
}
inline constexpr std::array<event_list, 8> catalogue = make_catalogue();

/// The event seen, or null.
constexpr const event* find(cell small, view seen) {
  const event_list& events = catalogue[small];
  for (int i = 0; i < events.size; ++i)
    if (events.all[i].before == seen) return &events.all[i];
  return nullptr;
}

}  // namespace osteon::plane::local
