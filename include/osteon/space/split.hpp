// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The ways to split a vertex of degree k into k - 2 vertices of degree three (thesis 3.3, design 03).

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/preference.hpp"
#include "osteon/space/segment.hpp"

namespace osteon {

/// An edge of a split corner between the facets a and b of the corner. Where a facet's plane occurs twice around the
/// corner, two of its facets may become one; then an edge runs on between both of them and the facet across.
struct split_edge {
  int a, b;
  bool convex;
  std::array<int, 2> rays;  ///< the corner's own edges that it continues, -1 for none
};

/// A tree (a forest where facets of one plane join): the operations <a,b> of the thesis, ascending, the vertices of three facets
/// that it makes, counter-clockwise, and all edges.
struct split_tree {
  std::vector<std::pair<int, int>> operations;
  std::vector<std::array<int, 3>> vertices;
  std::vector<std::array<int, 3>> vertex_edges;  ///< edges[r] of a vertex lies opposite its facet r
  std::vector<split_edge> edges;

  /// Among the edges that begin here.
  int convex_edges() const { return new_edges(true); }
  int reflex_edges() const { return new_edges(false); }

 private:
  int new_edges(bool convex) const {
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [convex](const split_edge& e) { return e.rays[0] < 0 && e.convex == convex; }));
  }
};

/// The greatest degree that enumeration takes.
inline constexpr int greatest_split_degree = 12;

/// Calls visit(diagonals) for every triangulation of a convex k-gon, in the thesis's order: lists of diagonals (a,b)
/// ascending, lists in lexicographic order. There are Catalan(k - 2).
inline void for_each_triangulation(int k, const std::function<void(std::span<const std::pair<int, int>>)>& visit) {
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < k; ++a)
    for (int b = a + 2; b < k; ++b)
      if (b - a < k - 1) all.emplace_back(a, b);
  std::vector<std::pair<int, int>> chosen;
  const auto crosses = [](const std::pair<int, int>& x, const std::pair<int, int>& y) {
    return (x.first < y.first && y.first < x.second && x.second < y.second) || (y.first < x.first && x.first < y.second && y.second < x.second);
  };
  const auto extend = [&](auto&& self, std::size_t first) -> void {
    if (static_cast<int>(chosen.size()) == k - 3) {
      visit(chosen);
      return;
    }
    const std::size_t missing = static_cast<std::size_t>(k) - 3 - chosen.size();
    for (std::size_t i = first; i + missing <= all.size(); ++i) {
      if (std::any_of(chosen.begin(), chosen.end(), [&](const auto& c) { return crosses(c, all[i]); })) continue;
      chosen.push_back(all[i]);
      self(self, i + 1);
      chosen.pop_back();
    }
  };
  extend(extend, 0);
}

/// Catalan(n) as an exact decimal number, n <= 35.
inline std::uint64_t catalan(int n) {
  std::uint64_t c = 1;
  for (int i = 0; i < n; ++i) c = c * 2 * (2 * static_cast<std::uint64_t>(i) + 1) / (static_cast<std::uint64_t>(i) + 2);
  return c;
}

/// Splits of one corner, decided by a kernel.
template <kernel<3> K>
class splitter {
 public:
  /// Requires degree >= 4; `bounded` as for corner_signs.
  splitter(const K& k, corner c, bool bounded = true) : signs_(k, std::move(c), bounded) {}

  const corner_signs<K>& signs() const { return signs_; }

  /// All trees that obey the local rule, in the thesis's order. Throws unsupported_error where the degree exceeds greatest_split_degree.
  std::vector<split_tree> candidates() const {
    if (signs_.degree() > greatest_split_degree)
      throw unsupported_error("a list of all trees of a vertex of degree " + std::to_string(signs_.degree()) + " (at most " +
                              std::to_string(greatest_split_degree) + "); hint: search them");
    std::vector<split_tree> result;
    for_each_triangulation(signs_.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
      split_tree t;
      if (make(diagonals, t)) result.push_back(std::move(t));
    });
    return result;
  }

  /// The tree of a triangulation given by its diagonals, ascending; nothing where it breaks the local rule.
  std::optional<split_tree> tree(std::span<const std::pair<int, int>> diagonals) const {
    split_tree t;
    return make(diagonals, t) ? std::optional(std::move(t)) : std::nullopt;
  }

  /// Whether the offset surface of a tree that obeys the local rule has no self-intersection, exactly: no edge meets
  /// a facet that it does not bound, which includes the other edges of its own two facets.
  bool valid(const split_tree& t) const {
    const std::vector<segment> edges = segments(t);
    std::map<plane_id, std::vector<segment>> facets;
    for (const segment& e : edges)
      for (const plane_id p : e.planes) facets[p].push_back(e);
    for (const segment& e : edges)
      for (const auto& [p, facet] : facets)
        if (pierces(e, p, facet)) return false;
    return true;
  }

  /// All valid trees in the thesis's order.
  std::vector<split_tree> all() const {
    std::vector<split_tree> trees = candidates();
    std::erase_if(trees, [this](const split_tree& t) { return !valid(t); });
    return trees;
  }

  /// The preferred valid tree; among equals the first in the thesis's order. Nothing where no tree is valid: thesis 3.5 proves
  /// that there is one, but where three planes share an edge's line all of them may have a vertex at infinity.
  std::optional<split_tree> best(split_preference preference) const {
    std::vector<split_tree> trees = candidates();
    std::stable_sort(trees.begin(), trees.end(), [&](const split_tree& s, const split_tree& t) { return better(s, t, preference); });
    const auto found = std::find_if(trees.begin(), trees.end(), [this](const split_tree& t) { return valid(t); });
    return found == trees.end() ? std::nullopt : std::optional(*found);
  }

  /// The edges around and inside the split vertex; those of the solid run to infinity.
  std::vector<segment> segments(const split_tree& t) const {
    std::vector<segment> result;
    for (const split_edge& e : t.edges) {
      const auto [p, q] = std::minmax({plane(e.a), plane(e.b)});
      result.push_back({{p, q}, {-1, -1}, {false, false}, e.convex});
    }
    for (std::size_t v = 0; v < t.vertices.size(); ++v)
      for (int r = 0; r < 3; ++r) {
        segment& e = result[static_cast<std::size_t>(t.vertex_edges[v][r])];
        const plane_id third = plane(t.vertices[v][r]);
        const bool inside = e.convex == positive(t.vertices[v]);
        const int end = runs_inside(signs_.kernel(), e.planes[0], e.planes[1], third, 0) == inside ? 0 : 1;
        e.third[end] = third;
        e.inside[end] = inside;
      }
    return result;
  }

 private:
  plane_id plane(int facet) const { return signs_.plane(facet); }
  bool positive(const std::array<int, 3>& v) const { return signs_.positive(v[0], v[1], v[2]); }

  // The edges of a triangulation: the facets with which each facet has one, ascending, and its number: the sides of the corner, then the diagonals.
  std::vector<std::vector<std::pair<int, int>>> fans(std::span<const std::pair<int, int>> diagonals) const {
    const int n = signs_.degree();
    std::vector<std::vector<std::pair<int, int>>> result(static_cast<std::size_t>(n));
    const auto join = [&](int a, int b, int number) {
      result[static_cast<std::size_t>(a)].emplace_back(b, number);
      result[static_cast<std::size_t>(b)].emplace_back(a, number);
    };
    for (int e = 0; e < n; ++e) join(e, (e + 1) % n, e);
    for (std::size_t e = 0; e < diagonals.size(); ++e) join(diagonals[e].first, diagonals[e].second, n + static_cast<int>(e));
    for (auto& fan : result) std::sort(fan.begin(), fan.end());
    return result;
  }

  // Builds the tree of a triangulation; false where it breaks the local rule. A triangle with two facets of one plane
  // is no vertex: its two edges to the third facet are one.
  bool make(std::span<const std::pair<int, int>> diagonals, split_tree& t) const {
    const int n = signs_.degree();
    std::vector<int> same(static_cast<std::size_t>(n) + diagonals.size());
    std::iota(same.begin(), same.end(), 0);
    const auto root = [&same](int e) {
      while (same[static_cast<std::size_t>(e)] != e) e = same[static_cast<std::size_t>(e)];
      return e;
    };
    const auto fan = fans(diagonals);
    std::vector<std::array<int, 3>> opposite;  // edge numbers of the vertices
    for (int a = 0; a < n; ++a)
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
          same[static_cast<std::size_t>(root(e[(r + 1) % 3]))] = root(e[(r + 2) % 3]);
          continue;
        }
        if (!signs_.meet(plane(a), plane(b), plane(c))) return false;
        t.vertices.push_back({a, b, c});
        opposite.push_back(e);
      }
    std::vector<int> number(same.size(), -1);
    for (int e = 0; e < static_cast<int>(same.size()); ++e) {
      const auto [a, b] = e < n ? std::pair(e, (e + 1) % n) : diagonals[static_cast<std::size_t>(e - n)];
      if (plane(a) == plane(b)) continue;
      int& id = number[static_cast<std::size_t>(root(e))];
      if (id < 0) {
        id = static_cast<int>(t.edges.size());
        t.edges.push_back({a, b, true, {-1, -1}});
      }
      if (e < n) t.edges[static_cast<std::size_t>(id)].rays[t.edges[static_cast<std::size_t>(id)].rays[0] < 0 ? 0 : 1] = e;
    }
    for (const auto& e : opposite) {
      auto& edges = t.vertex_edges.emplace_back();
      for (int r = 0; r < 3; ++r) edges[r] = number[static_cast<std::size_t>(root(e[r]))];
    }
    t.operations.assign(diagonals.begin(), diagonals.end());
    return vertices_differ(t) && set_convexity(t) && obeys_local_rule(t);
  }

  // Three planes meet once: two vertices of the same planes would touch.
  bool vertices_differ(const split_tree& t) const {
    std::set<triple> seen;
    for (const auto& v : t.vertices) {
      triple planes = {plane(v[0]), plane(v[1]), plane(v[2])};
      std::sort(planes.begin(), planes.end());
      if (!seen.insert(planes).second) return false;
    }
    return true;
  }

  // An edge of the solid keeps its kind. A new one lies between two vertices, and design 03 tells: it is convex iff
  // (det > 0) == (it runs inside), at either end. False where the two halves of one edge differ.
  bool set_convexity(split_tree& t) const {
    std::vector<std::vector<std::pair<std::size_t, int>>> ends_of(t.edges.size());
    for (std::size_t v = 0; v < t.vertices.size(); ++v)
      for (int r = 0; r < 3; ++r) ends_of[static_cast<std::size_t>(t.vertex_edges[v][r])].emplace_back(v, r);
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

  // Design 03: with det > 0 all three edges run inside, or all outside, the third plane; with det < 0 neither.
  bool obeys_local_rule(const split_tree& t) const {
    for (std::size_t v = 0; v < t.vertices.size(); ++v) {
      const bool up = positive(t.vertices[v]);
      int inside = 0;
      for (int r = 0; r < 3; ++r) inside += t.edges[static_cast<std::size_t>(t.vertex_edges[v][r])].convex == up ? 1 : 0;
      if (up != (inside == 0 || inside == 3)) return false;
    }
    return true;
  }

  bool pierces(const segment& e, plane_id l, const std::vector<segment>& facet) const {
    const K& k = signs_.kernel();
    if (e.planes[0] == l || e.planes[1] == l || e.third[0] == l || e.third[1] == l) return false;
    if (!signs_.meet(e.planes[0], e.planes[1], l) || !on_segment(k, e, l, signs_.start())) return false;
    for (const segment& b : facet)  // does it meet an edge of the facet that lies in one of its own two facets?
      for (const int s : {0, 1})
        if (b.other(l) == e.planes[s] && on_segment(k, b, e.planes[1 - s], signs_.start())) return true;
    return in_facet(l, facet, e.planes[0], e.planes[1]);
  }

  // Whether the corner (l,i,j) lies in the unbounded facet of l. Where neither line through it meets an edge, all
  // edges lie in one quadrant of the two lines, and the corner is in the facet iff that covers more than half a turn.
  bool in_facet(plane_id l, const std::vector<segment>& facet, plane_id i, plane_id j) const {
    const K& k = signs_.kernel();
    for (const auto& [first, second] : {std::pair(i, j), std::pair(j, i)}) {
      std::vector<segment> across;
      for (const segment& e : facet)
        if (e.other(l) != first && signs_.meet(l, first, e.other(l))) across.push_back(e);
      for (const bool into : {true, false})
        if (const auto seen = locate_in_facet(k, across, l, first, second, into, signs_.start())) return *seen;
    }
    const auto& [facets, convex] = signs_.of();
    const std::size_t n = facets.size();
    for (std::size_t at = 0; at < n; ++at) {
      if (facets[at] != l) continue;
      const std::size_t before = (at + n - 1) % n;
      if (!k.transversal(facets[before], l, facets[(at + 1) % n])) continue;  // half a turn, or none at all
      const bool up = k.orientation(facets[before], l, facets[(at + 1) % n]) == sign::positive;
      if ((convex[at] == up) != convex[before]) return true;
    }
    return false;
  }

  bool better(const split_tree& s, const split_tree& t, split_preference preference) const {
    switch (preference) {
      case split_preference::convex:
        return s.convex_edges() > t.convex_edges();
      case split_preference::reflex:
        return s.reflex_edges() > t.reflex_edges();
      case split_preference::min_volume:
        return signs_.kernel().compare_volume(planes(s), planes(t)) == sign::negative;
      case split_preference::max_volume:
        return signs_.kernel().compare_volume(planes(s), planes(t)) == sign::positive;
      case split_preference::first:
        return false;
    }
    return false;
  }

  std::vector<triple> planes(const split_tree& t) const {
    std::vector<triple> result;
    for (const auto& v : t.vertices) result.push_back({plane(v[0]), plane(v[1]), plane(v[2])});
    return result;
  }

  corner_signs<K> signs_;
};

}  // namespace osteon
