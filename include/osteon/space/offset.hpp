// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offset solids: the moving surface at any moment, read off the raw skeleton. No coordinates. What
/// surrounds what is asked of the perturbed kernel, for which nothing ever coincides; what has come
/// together at the moment itself is asked of the moment.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// A moment t, and exact answers about the unperturbed planes then.
template <class I>
concept moment_of_planes = requires(const I& at, const quadruple& q) {
  // Whether four planes, in any order, share a point at t. Requires three of them that meet in a
  // point.
  { at.meets(q) } -> std::same_as<bool>;
  // Whether four planes that meet once have met before t or at t.
  { at.is_past(q) } -> std::same_as<bool>;
  // Whether four planes meet once: S is not zero.
  { at.meets_once(q) } -> std::same_as<bool>;
};

/// A closed surface of facets that lie in the planes of a solid.
struct wavefront_surface {
  /// One walk along the border of a facet, which is on the left seen from outside. Edges without
  /// length are left out.
  struct ring {
    plane_id plane;
    std::vector<int> points;
  };
  std::vector<int> arcs;    ///< by point: one of the raw skeleton's arcs whose vertex is there
  std::vector<ring> rings;  ///< ascending by plane; holes and outer rings of one plane in no order
};

namespace detail {

template <kernel<3> K, moment_of_planes I>
class surface_reader {
 public:
  surface_reader(const K& k, const skeleton& raw, const I& at) : k_(k), raw_(raw), at_(at) {}

  wavefront_surface run() {
    find_past();
    if (past_ == static_cast<int>(raw_.nodes.size())) return {};  // all is over
    collect_ends();
    link_lines();
    trace();
    collect();
    return std::move(result_);
  }

 private:
  using meeting = typename K::meeting;

  // Where an edge ends at a vertex: the slot says on which side of the vertex's third plane the
  // edge lies, as in wavefront::slot.
  struct edge_end {
    int arc;
    int slot;
    bool starts;  ///< the edge leads away in the direction n_i x n_j of its planes, ascending
  };
  struct edge {
    std::array<int, 2> ends;  ///< along that direction
    std::array<plane_id, 2> planes;
    bool convex;
    bool is_zero;  ///< has no length at the moment
  };

  // Nodes are in order of time, so those that are past come first. Of planes that meet always or
  // never only the order tells.
  void find_past() {
    const auto is_past = [&](int n) {
      while (raw_.nodes[n].vertex < 0 && !at_.meets_once(raw_.nodes[n].planes)) --n;
      return raw_.nodes[n].vertex >= 0 || at_.is_past(raw_.nodes[n].planes);
    };
    int end = static_cast<int>(raw_.nodes.size());
    while (past_ < end) {
      const int middle = past_ + (end - past_) / 2;
      is_past(middle) ? past_ = middle + 1 : end = middle;
    }
  }
  bool is_alive(const skeleton::arc& a) const { return a.source < past_ && a.target >= past_; }

  void collect_ends() {
    const auto next = k_.meet(raw_.nodes[past_].planes);
    if (!next) broken_invariant<K>("the planes of an event meet");
    next_ = *next;
    ends_of_.assign(raw_.arcs.size(), {-1, -1, -1, -1, -1, -1});
    for (std::size_t a = 0; a < raw_.arcs.size(); ++a) {
      const auto& arc = raw_.arcs[a];
      if (!is_alive(arc)) continue;
      const bool positive = k_.orientation(arc.planes[0], arc.planes[1], arc.planes[2]) == sign::positive;
      std::size_t sheet = 0;
      for (int slot = 0; slot < 6; ++slot) {
        if (piece_at(arc, slot) == local::piece::none) continue;
        if (sheet == arc.sheets.size()) broken_invariant<K>("a vertex has as many sheets as edges");
        // det(n_i, n_j, n_third): the sign changes where the third plane is the middle one.
        const bool falls = positive == (slot / 2 != 1);
        ends_of_[a][static_cast<std::size_t>(slot)] = static_cast<int>(ends_.size());
        ends_.push_back({static_cast<int>(a), slot, (slot % 2 != 0) != falls});
        polygons_.push_back(raw_.sheets[arc.sheets[sheet++]].representative);
      }
    }
  }
  static local::piece piece_at(const skeleton::arc& a, int slot) {
    return local::corner_piece(a.corner, static_cast<unsigned>(slot / 2), slot % 2 != 0);
  }

  // Along a line edges start and end in turns.
  void link_lines() {
    std::vector<int> order(ends_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(), [this](int a, int b) { return std::pair(polygons_[a], a) < std::pair(polygons_[b], b); });
    edge_of_.assign(ends_.size(), -1);
    for (auto from = order.begin(); from != order.end();) {
      auto to = from;
      while (to != order.end() && polygons_[*to] == polygons_[*from]) ++to;
      std::sort(from, to, [this](int a, int b) { return comes_first(a, b); });
      for (; from != to; from += 2) {
        if (from + 1 == to || !ends_[from[0]].starts || ends_[from[1]].starts) broken_invariant<K>("along a line edges start and end in turns");
        add_edge(from[0], from[1]);
      }
    }
  }

  void add_edge(int tail, int head) {
    const auto& planes = raw_.sheets[polygons_[tail]].facets;
    const auto piece = piece_at(raw_.arcs[ends_[tail].arc], ends_[tail].slot);
    const plane_id x = third(tail);
    const plane_id y = third(head);
    edge_of_[tail] = edge_of_[head] = static_cast<int>(edges_.size());
    edges_.push_back({{tail, head}, planes, piece == local::piece::convex, x != y && at_.meets({planes[0], planes[1], x, y})});
  }

  plane_id third(int end) const { return raw_.arcs[ends_[end].arc].planes[static_cast<std::size_t>(ends_[end].slot / 2)]; }

  // Whether one of two ends on a line comes first just before the next event. One vertex has two
  // there where an edge goes on beyond it.
  bool comes_first(int a, int b) const {
    const plane_id x = third(a);
    const plane_id y = third(b);
    if (x == y) return !ends_[a].starts && ends_[b].starts;
    // h_y falls along the line where det(n_i, n_j, n_y) > 0.
    const auto& line = raw_.sheets[polygons_[a]].facets;
    const sign inside = side_before(y, line[0], line[1], x);
    return inside == k_.orientation(line[0], line[1], y);
  }

  // The corner (i,j,x) against plane y; of the planes of the event itself what is so before it.
  sign side_before(plane_id y, plane_id i, plane_id j, plane_id x) const {
    if (const sign s = k_.side(y, i, j, x, next_); s != sign::zero) return s;
    quadruple q = {i, j, x, y};
    std::sort(q.begin(), q.end());
    const auto r = static_cast<unsigned>(std::find(q.begin(), q.end(), y) - q.begin());
    const triple t = omit(q, r);
    const sign turn = k_.orientation(t[0], t[1], t[2]);
    return k_.closing(next_) * (r % 2 == 0 ? -turn : turn);
  }

  // A half-edge is 2 * edge + number of its facet among the edge's two. A convex edge has its first
  // facet on the left.
  int tail_of(int half) const { return edges_[half / 2].ends[edges_[half / 2].convex == (half % 2 == 0) ? 0 : 1]; }
  int head_of(int half) const { return edges_[half / 2].ends[edges_[half / 2].convex == (half % 2 == 0) ? 1 : 0]; }

  // Where the border of a facet goes on: at the vertex's other edge in the facet; at a majority
  // corner, where the facet has two opposite angles, at the one on the other side.
  int after(int half) const {
    const plane_id facet = edges_[half / 2].planes[half % 2];
    const edge_end& at = ends_[head_of(half)];
    const auto& planes = raw_.arcs[at.arc].planes;
    int other = 0;  // the slot's third plane: neither the facet's nor the one of this slot
    while (other == at.slot / 2 || planes[static_cast<std::size_t>(other)] == facet) ++other;
    // The new edge lies in the facet and in the old third plane; its third plane is the edge's
    // other one.
    const auto& slots = ends_of_[at.arc];
    int end = slots[static_cast<std::size_t>(2 * other + (at.slot % 2 != 0 ? 0 : 1))];
    if (end < 0) end = slots[static_cast<std::size_t>(2 * other + at.slot % 2)];
    if (end < 0 || edge_of_[end] < 0) broken_invariant<K>("a facet has two edges at its corner");
    const int e = edge_of_[end];
    const int next = 2 * e + (edges_[e].planes[0] == facet ? 0 : 1);
    if (tail_of(next) != end) broken_invariant<K>("the border of a facet runs one way");
    return next;
  }

  // Rings of half-edges that have a length, with the facet on the left.
  void trace() {
    std::vector<bool> seen(2 * edges_.size(), false);
    before_.assign(seen.size(), -1);
    for (std::size_t h = 0; h < seen.size(); ++h) {
      if (seen[h]) continue;
      auto& ring = rings_.emplace_back();
      for (int at = static_cast<int>(h); !seen[at]; at = after(at)) {
        seen[at] = true;
        if (!edges_[at / 2].is_zero) ring.push_back(at);
      }
      for (std::size_t i = 0; i < ring.size(); ++i) before_[ring[i]] = ring[i == 0 ? ring.size() - 1 : i - 1];
    }
  }

  // A point is a fan of facets: half-edges leave it whose predecessors are twins of others that do.
  void collect() {
    disjoint_sets fans(before_.size());
    for (std::size_t h = 0; h < before_.size(); ++h)
      if (before_[h] >= 0) fans.unite(static_cast<int>(h), before_[h] ^ 1);
    std::vector<int> degree(before_.size(), 0);  // by representative
    for (std::size_t h = 0; h < before_.size(); ++h)
      if (before_[h] >= 0) ++degree[fans.find(static_cast<int>(h))];
    std::vector<int> point(before_.size(), -1);
    for (const auto& ring : rings_) {
      wavefront_surface::ring to{-1, {}};
      for (const int h : ring) {
        const int fan = fans.find(h);
        // Where nothing but one edge passes there is no point.
        if (degree[fan] == 2 && edges_[h / 2].planes == edges_[before_[h] / 2].planes) continue;
        if (point[fan] < 0) {
          point[fan] = static_cast<int>(result_.arcs.size());
          result_.arcs.push_back(ends_[tail_of(h)].arc);
        }
        to.plane = edges_[h / 2].planes[h % 2];
        to.points.push_back(point[fan]);
      }
      if (to.points.size() >= 3) result_.rings.push_back(std::move(to));
    }
    std::stable_sort(result_.rings.begin(), result_.rings.end(), [](const auto& r, const auto& s) { return r.plane < s.plane; });
  }

  const K& k_;
  const skeleton& raw_;
  const I& at_;
  int past_ = 0;               // so many nodes
  meeting next_ = k_.start();  // the next event
  std::vector<edge_end> ends_;
  std::vector<int> polygons_;                // by end: the representative of its sheet
  std::vector<std::array<int, 6>> ends_of_;  // by arc and slot
  std::vector<edge> edges_;
  std::vector<int> edge_of_;  // by end
  std::vector<std::vector<int>> rings_;
  std::vector<int> before_;  // by half-edge that has a length
  wavefront_surface result_;
};

}  // namespace detail

/// Returns the surface at a moment. At the moment of an event it is what comes after it, in the
/// limit; nothing is left when all is over. Facets that have come to nothing are left out, with two
/// corners or less. `k` is the perturbed kernel that the skeleton was made with. *Throws*
/// invariant_error if the skeleton is none of these planes. *Complexity*: linear in the skeleton,
/// and sorting where several edges lie on one line.
template <kernel<3> K, moment_of_planes I>
wavefront_surface surface_at(const K& k, const skeleton& raw, const I& at) {
  return detail::surface_reader<K, I>(k, raw, at).run();
}

}  // namespace osteon
