// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a wavefront looks like in the end, when nothing happens to it any more, for the
/// certificate of the outside of polygons. Without edges of weight zero it goes once around, and
/// counting its turns is enough; with them it is compared edge by edge (docs/theory/plane.md).

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// Rings of edges that never vanish, after all meetings of a perturbed kernel that are not
/// infinitely late. On which side of a line a moving vertex is then, the meeting of the three lines
/// tells: the distance is linear in time, and S is its slope but for the sign of lambda.
template <kernel<2> K>
class terminal_wavefront {
 public:
  /// An edge, and its neighbours by their numbers in the list of the constructor.
  struct edge {
    line_id line;
    int before;  ///< ends where this one starts
    int after;   ///< starts where this one ends
  };

  terminal_wavefront(const K& k, std::vector<edge> edges) : k_(k), edges_(std::move(edges)), some_(some_meeting(k)) {}

  /// Returns whether the edges are one ring that turns right once in all: counts how often its
  /// direction passes that of one edge.
  /// *Requires* at least one edge, and none of weight zero.
  /// *Complexity* a few predicates for each edge.
  bool goes_once_around() const {
    const line_id direction = edges_.front().line;
    const auto is_right = [&](line_id l) { return k_.orientation(direction, l) == sign::negative; };
    std::size_t length = 0;
    int turns = 0;
    int e = 0;
    do {
      const line_id from = edges_[e].line;
      const line_id to = head_of(e);
      const bool left_turn = k_.orientation(from, to) == sign::positive;
      if (is_right(from) && !is_right(to) && left_turn) ++turns;
      if (!is_right(from) && is_right(to) && !left_turn) --turns;
      ++length;
      e = edges_[e].after;
    } while (e != 0);
    return length == edges_.size() && turns == -1;
  }

  /// Returns an edge that touches another one that is not its neighbour, or that has on its left
  /// what it should have on its right. Nothing: the edges bound, once, what lies on their left, and
  /// that is unbounded.
  /// *Complexity* a few predicates for each pair of an edge and a vertex.
  std::optional<int> find_crossing() const {
    std::vector<bool> seen(edges_.size());
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      const bool first_of_ring = !seen[e];
      for (int f = e; !seen[f]; f = edges_[f].after) seen[f] = true;
      int winding = 0;  // of the wavefront around a point on the left of edge e, near its head
      for (int f = 0; f < static_cast<int>(edges_.size()); ++f) {
        if (f == e) continue;
        if (e < f && touch(e, f)) return e;
        if (first_of_ring) winding += passes(e, f);
      }
      if (winding != 0) return e;
    }
    return std::nullopt;
  }

 private:
  line_id tail_of(int e) const { return edges_[edges_[e].before].line; }
  line_id head_of(int e) const { return edges_[edges_[e].after].line; }

  // The side of line c on which the vertex of two other lines is in the end; zero on one of these.
  sign side(line_id c, line_id a, line_id b) const {
    if (c == a || c == b) return sign::zero;
    const triple q = sorted(triple{a, b, c});
    const auto m = k_.meet(q);
    if (!m || is_never(*m)) return k_.side(c, a, b, some_);  // it is the same at all times
    return -(k_.closing(*m) * lambda(k_, q, position(q, c)));
  }

  // Any that has a moment. The lines of a polygon do not all move as one body, unless they do not
  // move.
  static typename K::meeting some_meeting(const K& k) {
    line_id b = 1;
    while (b + 1 < k.size() && !k.transversal(0, b)) ++b;
    for (line_id c = 1; c < k.size(); ++c) {
      if (c == b) continue;
      if (const auto m = k.meet({0, std::min(b, c), std::max(b, c)}); m && has_moment(k, *m)) return *m;
    }
    return k.start();
  }
  static bool has_moment(const K& k, const typename K::meeting& m) {
    if constexpr (limit_kernel<K>) return k.has_moment(m);
    return true;
  }

  // Where the point of lines l and y lies in the end, seen in the direction of l from that of l and
  // x.
  sign is_beyond(line_id l, line_id x, line_id y) const { return -(k_.orientation(l, x) * side(x, l, y)); }

  bool is_never(const typename K::meeting& m) const {
    if constexpr (limit_kernel<K>) return k_.is_never(m);
    return false;
  }

  // Whether edges share a point, but for that between neighbours.
  bool touch(int e, int f) const {
    const line_id l = edges_[e].line;
    const line_id y = edges_[f].line;
    if (edges_[e].after == f || edges_[f].after == e) return false;
    if (l == y) return is_beyond(l, head_of(e), tail_of(f)) != sign::positive && is_beyond(l, head_of(f), tail_of(e)) != sign::positive;
    const sign from = side(l, tail_of(f), y);
    const sign to = side(l, y, head_of(f));
    if (from == to && from != sign::zero) return false;
    return is_beyond(l, tail_of(e), y) != sign::negative && is_beyond(l, y, head_of(e)) != sign::negative;
  }

  // How edge f turns around a point on the left of edge e: whether, and to which side, it passes
  // what follows e straight on, a little to the left.
  int passes(int e, int f) const {
    const line_id l = edges_[e].line;
    const line_id y = edges_[f].line;
    if (l == y) return 0;
    const bool from = side(l, tail_of(f), y) == sign::positive;
    const bool to = side(l, y, head_of(f)) == sign::positive;
    if (from == to || (edges_[e].after != f && is_beyond(l, head_of(e), y) != sign::positive)) return 0;
    return to ? 1 : -1;
  }

  const K& k_;
  const std::vector<edge> edges_;
  const typename K::meeting some_;
};

}  // namespace osteon::plane
