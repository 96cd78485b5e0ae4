// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What surrounds a meeting: the state of the catalogue, and the edges of the wavefront that
/// make it up.

#include <array>
#include <cstddef>
#include <optional>

#include "osteon/core/kernel.hpp"
#include "osteon/plane/catalogue.hpp"
#include "osteon/plane/event_queue.hpp"
#include "osteon/plane/wavefront.hpp"

namespace osteon::plane {

/// Returns the other two of the numbers 0, 1, 2, ascending.
constexpr std::array<unsigned, 2> others(unsigned r) { return {r == 0 ? 1U : 0U, r == 2 ? 1U : 2U}; }

/// The wavefront around the point of a meeting just before it. Pieces of lines have labels as in
/// catalogue.hpp.
struct local_state {
  triple lines;                         ///< that meet, ascending
  local::cell small = 0;                ///< the cell that vanishes in the meeting
  const local::event* event = nullptr;  ///< what happens
  /// by line and label: the edge that covers the piece, or -1
  std::array<std::array<int, 8>, 3> edges;
  /// by two of the lines: whether the first one leads into the inner side of the second one
  std::array<std::array<bool, 3>, 3> grows{};
};

/// Returns whether the point where the line of edge e meets lines a and b lies on the edge, at the
/// time of their meeting m.
template <kernel<2> K>
bool contains_point(const K& k, const wavefront& front, int e, line_id a, line_id b, const typename K::meeting& m) {
  const auto& edge = front.edges[e];
  const line_id across = k.transversal(edge.line, a) ? a : b;
  const line_id t = front.line_before(edge.tail);
  const line_id h = front.line_after(edge.head);
  // Behind a convex tail, and before a reflex head, the line is inside of the other one.
  if (t != a && t != b && (k.side(t, edge.line, across, m) == sign::positive) == front.vertices[edge.tail].reflex) return false;
  return h == a || h == b || (k.side(h, edge.line, across, m) == sign::positive) != front.vertices[edge.head].reflex;
}

/// Reads local states off a wavefront.
template <kernel<2> K>
class local_reader {
 public:
  local_reader(const K& k, const wavefront& front) : k_(k), front_(front) {}

  /// Returns what surrounds a candidate's meeting m, or nothing where the wavefront has no event
  /// there.
  std::optional<local_state> read(const candidate& c, const typename K::meeting& m) const {
    local_state s{.lines = k_.planes(m), .edges = {}};
    orient(s, k_.closing(m));
    const auto& e = front_.edges[c.edge];
    if (c.vertex >= 0 && !contains_point(k_, front_, c.edge, front_.line_before(c.vertex), front_.line_after(c.vertex), m)) return std::nullopt;
    const int before = front_.vertices[c.vertex >= 0 ? c.vertex : e.tail].in;
    const int after = front_.vertices[c.vertex >= 0 ? c.vertex : e.head].out;
    local::view seen = 0;
    for (const int f : {c.edge, before, after}) {
      const local::view covered = covered_on_line_of(s, f);
      if (covered == 0) return std::nullopt;
      seen |= covered;
    }
    s.event = local::find(s.small, seen);
    if (s.event == nullptr) return std::nullopt;
    return s;
  }

 private:
  // The cell that vanishes, and the directions of the lines.
  void orient(local_state& s, sign closing) const {
    const std::array<sign, 3> lambdas = {lambda(k_, s.lines, 0), lambda(k_, s.lines, 1), lambda(k_, s.lines, 2)};
    for (unsigned r = 0; r < 3; ++r) {
      s.edges[r].fill(-1);
      if (lambdas[r] == closing) s.small |= 1U << r;
      for (const unsigned o : others(r)) s.grows[r][o] = (o == (r + 1) % 3) == (lambdas[3 - r - o] == sign::negative);
    }
  }

  // Notes the pieces that edge f and others on its line cover; none where f covers none.
  local::view covered_on_line_of(local_state& s, int f) const {
    const auto r = static_cast<unsigned>(position(s.lines, front_.edges[f].line));
    local::view covered = covered_pieces(s, r, f);
    if (covered == 0) return 0;
    // Another edge on the line reaches the point only with an end on one of the other two lines.
    for (int g = front_.edges[f].previous; g >= 0 && is_other(s, r, front_.head_line(g)); g = front_.edges[g].previous)
      covered |= covered_pieces(s, r, g);
    for (int g = front_.edges[f].next; g >= 0 && is_other(s, r, front_.tail_line(g)); g = front_.edges[g].next) covered |= covered_pieces(s, r, g);
    return covered;
  }

  // Whether a line is one of the two that are not line r.
  static bool is_other(const local_state& s, unsigned r, line_id l) { return l != s.lines[r] && position(s.lines, l) < s.lines.size(); }

  // Notes the pieces of line r that an edge covers.
  local::view covered_pieces(local_state& s, unsigned r, int e) const {
    const line_id t = front_.tail_line(e);
    const line_id h = front_.head_line(e);
    local::cell never_in = 1U << r;  // sides of the lines where it is not
    local::cell always_in = 0;
    for (const unsigned o : others(r)) {
      if (t == s.lines[o]) (s.grows[r][o] ? always_in : never_in) |= 1U << o;
      if (h == s.lines[o]) (s.grows[r][o] ? never_in : always_in) |= 1U << o;
    }
    local::view covered = 0;
    for (local::cell label = 0; label < 8; ++label) {
      if ((label & never_in) != 0 || (always_in & ~label) != 0 || label == local::segment_label(s.small, r, true)) continue;
      s.edges[r][label] = e;
      covered |= local::piece_bit(r, label);
    }
    return covered;
  }

  const K& k_;
  const wavefront& front_;
};

}  // namespace osteon::plane
