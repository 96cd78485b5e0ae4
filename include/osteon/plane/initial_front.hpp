// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The wavefront at time zero.

#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/traced_front.hpp"

namespace osteon::plane {

/// Builds the wavefront of a polygon at time zero: a node, and an arc that begins there, for each
/// vertex where the boundary turns.
template <kernel<2> K>
class initial_front {
 public:
  initial_front(const K& k, const boundary& polygon, traced_front& to) : k_(k), polygon_(polygon), to_(to), front_(to.front) {}

  /// Fills the empty `to` of the constructor. Edge i and vertex i are those of the polygon.
  /// *Complexity* linear, but for kernels without a line across within reach (see is_faster).
  void build() {
    reserve();
    copy_rings();
    straighten();
    for (int v = 0; v < static_cast<int>(front_.vertices.size()); ++v)
      if (front_.vertices[v].alive) begin_arc(v);
    order_edges();
  }

 private:
  // In general position there are as many events as vertices, half of them edges that vanish.
  void reserve() {
    const std::size_t n = polygon_.next.size();
    to_.trace.nodes.reserve(2 * n);
    to_.trace.arcs.reserve(3 * n);
    front_.edges.reserve(3 * n / 2);
    front_.vertices.reserve(n);
    to_.faces = disjoint_sets(n);
  }

  void copy_rings() {
    const int n = static_cast<int>(polygon_.next.size());
    std::vector<int> previous(polygon_.next.size());
    for (int i = 0; i < n; ++i) previous[polygon_.next[i]] = i;
    for (int i = 0; i < n; ++i) {
      triple lines = {polygon_.line[previous[i]], polygon_.line[i], -1};
      if (lines[0] > lines[1]) std::swap(lines[0], lines[1]);
      to_.trace.nodes.push_back({i, lines, event_class::edge});
      front_.edges.push_back({polygon_.line[i], i, polygon_.next[i], i, -1, -1, true});
      front_.vertices.push_back({previous[i], i, polygon_.line[previous[i]], polygon_.line[i], -1, true, false});
    }
    front_.living = n;
  }

  // Of two edges that point in the same direction and meet at a vertex, one runs along the other
  // infinitely fast: the faster one where the perturbation makes the vertex convex, else the slower
  // one. Edges of one line become one.
  void straighten() {
    std::vector<int> waiting(front_.vertices.size());
    for (std::size_t v = 0; v < waiting.size(); ++v) waiting[v] = static_cast<int>(v);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (!front_.vertices[v].alive) continue;
      const int in = front_.vertices[v].in;
      const int out = front_.vertices[v].out;
      const line_id a = front_.edges[in].line;
      const line_id b = front_.edges[out].line;
      if (a != b && k_.transversal(a, b)) continue;
      const bool in_stays = a == b || (k_.orientation(a, b) == sign::positive) == is_faster(a, b);
      waiting.push_back(in_stays ? prolong_head(in, out) : prolong_tail(out, in));
      front_.vertices[v].alive = false;
      --front_.living;
      if (a == b) to_.merge_faces(front_.edges[in].face, front_.edges[out].face);
    }
  }

  // An edge takes the place of the one behind its head; returns its new head.
  int prolong_head(int stays, int gone) {
    const int head = front_.edges[gone].head;
    front_.edges[gone].alive = false;
    front_.edges[stays].head = head;
    front_.vertices[head].in = stays;
    front_.vertices[head].before = front_.edges[stays].line;
    return head;
  }
  // The same at its tail.
  int prolong_tail(int stays, int gone) {
    const int tail = front_.edges[gone].tail;
    front_.edges[gone].alive = false;
    front_.edges[stays].tail = tail;
    front_.vertices[tail].out = stays;
    front_.vertices[tail].after = front_.edges[stays].line;
    return tail;
  }

  // Whether line a is faster than the parallel line b: with any third line, S = lambda_a (sigma_a -
  // sigma_b).
  bool is_faster(line_id a, line_id b) const {
    line_id c = 0;
    while (!k_.transversal(a, c)) ++c;
    const triple q = sorted(triple{a, b, c});
    return k_.closing(*k_.meet(q)) == lambda(k_, q, position(q, a));
  }

  void begin_arc(int v) {
    auto& vertex = front_.vertices[v];
    vertex.reflex = k_.orientation(vertex.before, vertex.after) == sign::negative;
    to_.begin_arc(v, v);
  }

  // Links the edges of each line in their order.
  void order_edges() {
    std::vector<int> ranked(front_.edges.size());
    for (int e = 0; e < static_cast<int>(ranked.size()); ++e) ranked[polygon_.rank[e]] = e;
    int last = -1;
    for (const int e : ranked) {
      if (!front_.edges[e].alive) continue;
      if (last >= 0 && front_.edges[last].line == front_.edges[e].line) front_.insert_after(last, e);
      last = e;
    }
  }

  const K& k_;
  const boundary& polygon_;
  traced_front& to_;
  wavefront& front_;
};

}  // namespace osteon::plane
