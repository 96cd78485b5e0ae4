// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The start of the certificate's replay: the polygon, and one arc from each vertex.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/replayed_front.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/structure.hpp"

namespace osteon::plane {

/// Builds the wavefront at time zero and compares it with what a skeleton claims to begin.
template <kernel<2> K>
class replay_start {
 public:
  replay_start(const K& k, const boundary& polygon, const skeleton& s, const skeleton_index& index, replayed_front<K>& front)
      : k_(k), polygon_(polygon), s_(s), index_(index), front_(front), edges_(front.edges) {}

  /// Fills the front, or throws a refutation.
  void run() {
    copy_rings();
    straighten();
    check_arcs();
  }

 private:
  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  void copy_rings() {
    const int n = static_cast<int>(polygon_.next.size());
    edges_.resize(polygon_.next.size());
    for (int e = 0; e < n; ++e) {
      edges_[e].line = polygon_.line[e];
      edges_[e].face = e;
      edges_[e].after = polygon_.next[e];
      edges_[e].arc = -1;
      edges_[polygon_.next[e]].before = e;
    }
    front_.faces = disjoint_sets(polygon_.next.size());
    for (int v = 0; v < n; ++v) {
      const line_id a = edges_[edges_[v].before].line;
      const line_id b = edges_[v].line;
      demand(s_.nodes[index_.node_of[v]].lines == triple{std::min(a, b), std::max(a, b), -1}, rule::start, "node", index_.node_of[v],
             "does not name the two lines of its vertex");
    }
  }

  // Where a boundary is straight there is no vertex. Edges on one line are one; of two on parallel
  // lines one vanishes at once: the slower one where the perturbation makes the vertex convex, else
  // the faster one (as the event loop documents). Where several do so beside each other the outcome
  // depends on the order; it is from the last vertex to the first, but the next vertex behind a
  // vanished edge comes at once.
  void straighten() {
    const int n = static_cast<int>(edges_.size());
    head_at_.resize(edges_.size());
    std::vector<int> tail_at(edges_.size());  // the edge that starts at a vertex
    vanished_.assign(edges_.size(), false);
    std::iota(tail_at.begin(), tail_at.end(), 0);
    for (int v = 0; v < n; ++v) head_at_[v] = edges_[v].before;
    std::vector<int> tail(tail_at);  // the vertex where an edge starts
    std::vector<int> waiting(tail_at);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (vanished_[v]) continue;
      const int in = head_at_[v];
      const int out = tail_at[v];
      demand(in != out, rule::structure, "edge", in, "is a ring of its own");
      const line_id a = edges_[in].line;
      const line_id b = edges_[out].line;
      if (a != b && k_.transversal(a, b)) continue;
      const bool in_stays = a == b || (k_.orientation(a, b) == sign::positive) == is_faster(a, b);
      const int gone = in_stays ? out : in;
      const int stays = in_stays ? in : out;
      const int head = tail[edges_[out].after];
      const int far = in_stays ? head : tail[in];
      edges_[edges_[gone].before].after = edges_[gone].after;
      edges_[edges_[gone].after].before = edges_[gone].before;
      edges_[gone].before = edges_[gone].after = -1;
      if (in_stays) {
        head_at_[far] = stays;
      } else {
        tail_at[far] = stays;
        tail[stays] = far;
      }
      vanished_[v] = true;
      waiting.push_back(far);
      if (a == b) front_.merge_faces(s_, in, out, "edge", out);
    }
  }

  // Whether line a is faster than the parallel line b: with any line c across, S = lambda_a
  // (sigma_a - sigma_b), lambda_a = det(n_b, n_c).
  bool is_faster(line_id a, line_id b) {
    if (across_[0] < 0) find_across();
    const line_id c = k_.transversal(a, across_[0]) ? across_[0] : across_[1];
    const triple q = sorted(triple{a, b, c});
    const auto m = k_.meet(q);
    demand(m.has_value(), rule::structure, "line", a, "touches a parallel line of the same speed");
    return k_.closing(*m) == lambda(k_, q, position(q, a));
  }

  // Two lines that cross: every line crosses one of them.
  void find_across() {
    line_id c = 1;
    while (c < k_.size() && !k_.transversal(0, c)) ++c;
    demand(c < k_.size(), rule::structure, "line", 0, "is parallel to all others");
    across_ = {0, c};
  }

  void check_arcs() {
    front_.edge_of.assign(s_.arcs.size(), -1);
    for (int v = 0; v < static_cast<int>(edges_.size()); ++v) {
      const int node = index_.node_of[v];
      if (vanished_[v]) {
        demand(index_.starts.size(node) == 0, rule::start, "node", node, "has an arc although its edges are one from the start");
        continue;
      }
      demand(index_.starts.size(node) == 1, rule::start, "node", node, "does not have one arc");
      const int a = *index_.starts.begin(node);
      const int in = head_at_[v];
      const int out = edges_[in].after;
      demand(s_.arcs[a].faces == std::array<int, 2>{s_.faces[in], s_.faces[out]}, rule::start, "arc", a,
             "does not begin between the edges of its vertex");
      edges_[in].arc = a;
      front_.edge_of[a] = in;
    }
  }

  const K& k_;
  const boundary& polygon_;
  const skeleton& s_;
  const skeleton_index& index_;
  replayed_front<K>& front_;
  std::vector<typename replayed_front<K>::edge>& edges_;
  std::vector<int> head_at_;    // by vertex: the edge that ends there
  std::vector<bool> vanished_;  // by vertex
  std::array<line_id, 2> across_ = {-1, -1};
};

}  // namespace osteon::plane
