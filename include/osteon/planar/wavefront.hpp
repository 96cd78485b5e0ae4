// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The moving polygon: edges on lines, vertices between them, and the order of the edges on each line.

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "osteon/error.hpp"
#include "osteon/planar/kernel.hpp"
#include "osteon/planar/polygon.hpp"

namespace osteon::planar {

/// Rings of edges, the interior on their left. Dead elements keep their numbers.
struct wavefront {
  struct edge {
    line_id line;
    int tail;  ///< vertex where it starts, in the direction that has the interior on the left
    int head;
    int face;
    bool alive;
  };
  struct vertex {
    int in;          ///< edge that ends here
    int out;         ///< edge that starts here
    line_id before;  ///< line of the edge that ends here
    line_id after;   ///< line of the edge that starts here
    int arc;
    bool alive;
  };
  std::vector<edge> edges;
  std::vector<vertex> vertices;

  line_id line_before(int v) const { return vertices[v].before; }
  line_id line_after(int v) const { return vertices[v].after; }
};

/// Whether points of line `of` lie inside line x beyond the point where they cross, seen in the direction of edges on `of`.
template <planar_kernel K>
bool grows(const K& k, line_id of, line_id x) {
  return k.orientation(of, x) == sign::negative;
}

/// Whether the polygon is the union, not the intersection, of two half-planes at the vertex.
template <planar_kernel K>
bool is_reflex(const K& k, const wavefront& front, int v) {
  return k.orientation(front.line_before(v), front.line_after(v)) == sign::negative;
}

/// The living edges of each line in the order of its direction. Edges of one line never overlap, so their order never changes.
template <planar_kernel K>
class edge_order {
 public:
  edge_order(const K& k, const wavefront& front, int lines) : k_(k), front_(front), only_(lines, -1) {}

  /// Adds an edge at time zero; lines that get several must be settled by sort() afterwards.
  void add_unsorted(int e) {
    const line_id line = front_.edges[e].line;
    if (only_[line] == -1) {
      only_[line] = e;
      return;
    }
    auto& edges = several_[line];
    if (edges.empty()) edges.push_back(only_[line]);
    edges.push_back(e);
    only_[line] = many;
  }
  /// Sorts the edges of lines with several by their rank.
  void sort(const std::vector<int>& rank) {
    for (auto& [line, edges] : several_) std::sort(edges.begin(), edges.end(), [&rank](int e, int f) { return rank[e] < rank[f]; });
  }

  /// Calls body(edge) for the at most three living edges of a line that may contain the point where it meets line x at the moment m.
  template <class Body>
  void near(line_id line, line_id x, const typename K::meeting& m, Body body) const {
    if (only_[line] == -1) return;
    if (only_[line] != many) {
      body(only_[line]);
      return;
    }
    const auto& edges = edges_of(line);
    // The first edge that does not end before the point, one before it (it may end there), and one behind.
    const auto at = reached(edges, x, m);
    const auto from = at == edges.begin() ? at : at - 1;
    for (auto e = from; e != edges.end() && e - at < 2; ++e) body(*e);
  }

  /// A new edge right behind `before` in the order of their line, where that meets line x at the moment m.
  void insert_after(int before, int e, line_id x, const typename K::meeting& m) {
    const line_id line = front_.edges[e].line;
    auto& edges = several_[line];
    if (only_[line] != many) edges = {only_[line]};
    only_[line] = many;
    edges.insert(place(edges, before, x, m) + 1, e);
  }

  /// Takes out an edge that ends or starts where its line meets line x at the moment m.
  void erase(int e, line_id x, const typename K::meeting& m) {
    const line_id line = front_.edges[e].line;
    if (only_[line] == e) {
      only_[line] = -1;
      return;
    }
    auto& edges = edges_of(line);
    edges.erase(place(edges, e, x, m));
    if (edges.size() == 1) {
      only_[line] = edges.front();
      several_.erase(line);
    }
  }

 private:
  static constexpr int many = -2;

  bool ends_before(int e, line_id x, const typename K::meeting& m) const {
    const line_id line = front_.edges[e].line;
    const line_id end = front_.line_after(front_.edges[e].head);
    if (end == x) return false;
    const sign s = k_.side(end, line, x, m);
    return s != sign::zero && (s == sign::positive) == grows(k_, line, end);
  }

  template <class Self>
  static auto& edges_of(Self& self, line_id line) {
    const auto at = self.several_.find(line);
    if (at == self.several_.end()) broken_invariant<K>("a line has edges");
    return at->second;
  }
  std::vector<int>& edges_of(line_id line) { return edges_of(*this, line); }
  const std::vector<int>& edges_of(line_id line) const { return edges_of(*this, line); }

  // The first edge that reaches the point or lies behind it.
  std::vector<int>::const_iterator reached(const std::vector<int>& edges, line_id x, const typename K::meeting& m) const {
    return std::partition_point(edges.begin(), edges.end(), [&](int e) { return ends_before(e, x, m); });
  }

  std::vector<int>::const_iterator place(const std::vector<int>& edges, int e, line_id x, const typename K::meeting& m) const {
    const auto at = reached(edges, x, m);
    const auto found = std::find(at - std::min<std::ptrdiff_t>(2, at - edges.begin()), edges.end(), e);
    if (found == edges.end()) broken_invariant<K>("an edge is in the order of its line");
    return found;
  }

  const K& k_;
  const wavefront& front_;
  std::vector<int> only_;  // the only edge of a line, -1 for none, `many`
  std::unordered_map<line_id, std::vector<int>> several_;
};

}  // namespace osteon::planar
