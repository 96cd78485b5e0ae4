// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How a vertex of high degree is split: the tree of its new vertices and edges, and how one is
/// made from a triangulation of the facets around the vertex (docs/theory/vertex-splitting.md).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/corner.hpp"

namespace osteon {

/// An edge of a split corner between the facets a and b of the corner. Where a facet's plane occurs
/// twice around the corner, two of its facets may become one; then an edge runs on between both of
/// them and the facet across.
struct split_edge {
  int a, b;
  bool convex;
  std::array<int, 2> rays;  ///< the corner's own edges that it continues, -1 for none
};

/// A tree (a forest where facets of one plane join).
struct split_tree {
  /// <a,b> of the thesis, ascending: the triangulation's diagonals
  std::vector<std::pair<int, int>> operations;
  std::vector<std::array<int, 3>> vertices;      ///< three facets each, counter-clockwise
  std::vector<std::array<int, 3>> vertex_edges;  ///< edges[r] of a vertex lies opposite its facet r
  std::vector<split_edge> edges;

  /// Returns the number of convex edges that begin at the split vertex.
  int convex_edges() const { return new_edges(true); }
  /// Returns the number of reflex edges that begin at the split vertex.
  int reflex_edges() const { return new_edges(false); }

 private:
  int new_edges(bool convex) const {
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [convex](const split_edge& e) { return e.rays[0] < 0 && e.convex == convex; }));
  }
};

/// Makes trees from triangulations of the polygon of a corner's facets.
template <kernel<3> K>
class tree_builder {
 public:
  /// A diagonal (a,b) of the polygon.
  using diagonal = std::pair<int, int>;

  /// `signs` must outlive the builder.
  explicit tree_builder(const corner_signs<K>& signs) : signs_(signs) {}

  /// Returns the tree of a triangulation given by its diagonals, ascending; nothing where it breaks
  /// the local rule.
  /// *Complexity* n log n in the corner's degree.
  std::optional<split_tree> build(std::span<const diagonal> diagonals) const {
    split_tree t;
    std::vector<std::array<int, 3>> opposite;  // sides or diagonals, by vertex
    disjoint_sets same(static_cast<std::size_t>(signs_.degree()) + diagonals.size());
    if (!find_vertices(diagonals, t, opposite, same)) return std::nullopt;
    number_edges(diagonals, t, opposite, same);
    t.operations.assign(diagonals.begin(), diagonals.end());
    if (!vertices_differ(t) || !set_convexity(t) || !obeys_local_rule(t)) return std::nullopt;
    return t;
  }

 private:
  plane_id plane(int facet) const { return signs_.plane(facet); }
  bool positive(const std::array<int, 3>& v) const { return signs_.positive(v[0], v[1], v[2]); }

  // The edges of a triangulation: the facets with which each facet has one, ascending, and its
  // number: the sides of the corner, then the diagonals.
  std::vector<std::vector<std::pair<int, int>>> fans(std::span<const diagonal> diagonals) const {
    const int n = signs_.degree();
    std::vector<std::vector<std::pair<int, int>>> result(n);
    const auto join = [&](int a, int b, int number) {
      result[a].emplace_back(b, number);
      result[b].emplace_back(a, number);
    };
    for (int e = 0; e < n; ++e) join(e, (e + 1) % n, e);
    for (std::size_t e = 0; e < diagonals.size(); ++e) join(diagonals[e].first, diagonals[e].second, n + static_cast<int>(e));
    for (auto& fan : result) std::sort(fan.begin(), fan.end());
    return result;
  }

  // Every triangle is a vertex, but for one with two facets of one plane: its two edges to the
  // third facet are the same. False where three facets make no vertex.
  bool find_vertices(std::span<const diagonal> diagonals, split_tree& t, std::vector<std::array<int, 3>>& opposite, disjoint_sets& same) const {
    const auto fan = fans(diagonals);
    for (int a = 0; a < signs_.degree(); ++a)
      for (std::size_t at = 0; at + 1 < fan[a].size(); ++at) {
        const auto [b, ab] = fan[a][at];
        const auto [c, ac] = fan[a][at + 1];
        if (b < a) continue;
        const auto bc = std::lower_bound(fan[b].begin(), fan[b].end(), std::pair(c, 0))->second;
        const std::array<int, 3> e = {bc, ac, ab};
        const std::array<bool, 3> joined = {plane(b) == plane(c), plane(a) == plane(c), plane(a) == plane(b)};
        const auto pairs = std::count(joined.begin(), joined.end(), true);
        if (pairs > 1) return false;
        if (pairs == 1) {
          const int r = joined[0] ? 0 : (joined[1] ? 1 : 2);
          same.unite(e[(r + 1) % 3], e[(r + 2) % 3]);
          continue;
        }
        if (!signs_.meet(plane(a), plane(b), plane(c))) return false;
        t.vertices.push_back({a, b, c});
        opposite.push_back(e);
      }
    return true;
  }

  // Edges in the order of the sides and diagonals that they are.
  void number_edges(std::span<const diagonal> diagonals, split_tree& t, const std::vector<std::array<int, 3>>& opposite, disjoint_sets& same) const {
    const int n = signs_.degree();
    std::vector<int> number(same.size(), -1);
    for (int e = 0; e < static_cast<int>(same.size()); ++e) {
      const auto [a, b] = e < n ? std::pair(e, (e + 1) % n) : diagonals[e - n];
      if (plane(a) == plane(b)) continue;
      int& id = number[same.find(e)];
      if (id < 0) {
        id = static_cast<int>(t.edges.size());
        t.edges.push_back({a, b, true, {-1, -1}});
      }
      if (e < n) t.edges[id].rays[t.edges[id].rays[0] < 0 ? 0 : 1] = e;
    }
    for (const auto& e : opposite) {
      auto& edges = t.vertex_edges.emplace_back();
      for (int r = 0; r < 3; ++r) edges[r] = number[same.find(e[r])];
    }
  }

  // Three planes meet once: two vertices of the same planes would touch.
  bool vertices_differ(const split_tree& t) const {
    std::set<triple> seen;
    return std::all_of(t.vertices.begin(), t.vertices.end(), [&](const auto& v) {
      return seen.insert(sorted(triple{plane(v[0]), plane(v[1]), plane(v[2])})).second;
    });
  }

  // An edge of the solid keeps its kind. A new one lies between two vertices; it is convex iff (det
  // > 0) == (it runs inside), at either end (docs/theory/vertex-splitting.md). False where the two
  // halves of one edge differ.
  bool set_convexity(split_tree& t) const {
    std::vector<std::vector<std::pair<std::size_t, int>>> ends_of(t.edges.size());
    for (std::size_t v = 0; v < t.vertices.size(); ++v)
      for (int r = 0; r < 3; ++r) ends_of[t.vertex_edges[v][r]].emplace_back(v, r);
    for (std::size_t i = 0; i < t.edges.size(); ++i) {
      split_edge& e = t.edges[i];
      if (e.rays[0] >= 0) {
        e.convex = signs_.ray_is_convex(e.rays[0]);
        if (e.rays[1] >= 0 && signs_.ray_is_convex(e.rays[1]) != e.convex) return false;
        continue;
      }
      const auto& ends = ends_of[i];
      if (ends.size() != 2) return false;
      const auto& [v, r] = ends[0];
      const auto& w = t.vertices[ends[1].first];
      const int third = t.vertices[v][r];
      if (plane(third) == plane(w[ends[1].second])) return false;
      e.convex = positive(t.vertices[v]) == (signs_.side(third, w[0], w[1], w[2]) == sign::positive);
    }
    return true;
  }

  // With det > 0 all three edges run inside, or all outside, the third plane; with det < 0 neither.
  bool obeys_local_rule(const split_tree& t) const {
    for (std::size_t v = 0; v < t.vertices.size(); ++v) {
      const bool up = positive(t.vertices[v]);
      int inside = 0;
      for (int r = 0; r < 3; ++r) inside += t.edges[t.vertex_edges[v][r]].convex == up ? 1 : 0;
      if (up != (inside == 0 || inside == 3)) return false;
    }
    return true;
  }

  const corner_signs<K>& signs_;
};

}  // namespace osteon
