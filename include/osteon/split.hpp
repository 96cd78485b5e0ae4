// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The ways to split a vertex of degree k into k - 2 vertices of degree three (thesis 3.3, design 03).

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/error.hpp"
#include "osteon/kernel.hpp"
#include "osteon/segment.hpp"

namespace osteon {

/// Which valid tree a vertex is split by.
enum class split_preference : std::uint8_t {
  convex,      ///< most convex edges
  reflex,      ///< most reflex edges
  min_volume,  ///< least volume of the offset
  max_volume   ///< greatest volume of the offset
};

/// The corner of a vertex: facets counter-clockwise seen from outside, and whether the edge between facet m and m + 1
/// is convex.
struct corner {
  std::vector<plane_id> facets;
  std::vector<bool> convex;

  int degree() const { return static_cast<int>(facets.size()); }
};

/// A split operation <a,b> of the thesis, a < b: facets number a and b of the corner become adjacent.
struct split_edge {
  int a, b;
  bool convex;
};

/// A tree: k - 3 operations in ascending order, and the k - 2 vertices that it makes, counter-clockwise.
struct split_tree {
  std::vector<split_edge> edges;
  std::vector<std::array<int, 3>> vertices;

  int convex_edges() const {
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const split_edge& e) { return e.convex; }));
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
template <kernel K>
class splitter {
 public:
  /// Requires degree >= 4. Throws unsupported_error where the degree exceeds greatest_split_degree or a plane occurs
  /// twice. `bounded` demands that all vertices stay near, as a solid needs it. Without it three planes that share a line may
  /// make a vertex too, which is infinitely far away; a perturbed kernel places it.
  splitter(const K& k, corner c, bool bounded = true) : k_(k), c_(std::move(c)), start_(k.start()), bounded_(bounded) {
    if (c_.degree() > greatest_split_degree)
      throw unsupported_error("not yet: a vertex of degree " + std::to_string(c_.degree()) + " (at most " + std::to_string(greatest_split_degree) +
                              ")");
    std::vector<plane_id> sorted = c_.facets;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw unsupported_error("not yet: a vertex with two corners of one facet that is no majority corner");
    const int n = c_.degree();
    sides_.assign(static_cast<std::size_t>(n) * n * n * n, unknown);
  }

  /// All trees that obey the local rule, in the thesis's order.
  std::vector<split_tree> candidates() const {
    std::vector<split_tree> result;
    for_each_triangulation(c_.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
      split_tree t;
      if (make(diagonals, t)) result.push_back(std::move(t));
    });
    return result;
  }

  /// Whether the offset surface of a tree that obeys the local rule has no self-intersection, exactly: no edge meets
  /// a facet that it does not bound, which includes the other edges of its own two facets.
  bool valid(const split_tree& t) const {
    const std::vector<segment> edges = segments(t);
    std::vector<std::vector<segment>> facets(c_.facets.size());
    for (const segment& e : edges)
      for (int f = 0; f < c_.degree(); ++f)
        if (c_.facets[f] == e.planes[0] || c_.facets[f] == e.planes[1]) facets[f].push_back(e);
    for (const segment& e : edges)
      for (int f = 0; f < c_.degree(); ++f)
        if (pierces(e, c_.facets[f], facets[f])) return false;
    return true;
  }

  /// All valid trees in the thesis's order.
  std::vector<split_tree> all() const {
    std::vector<split_tree> trees = candidates();
    std::erase_if(trees, [this](const split_tree& t) { return !valid(t); });
    return trees;
  }

  /// The preferred valid tree; among equals the first in the thesis's order. A valid tree exists (thesis 3.5).
  split_tree best(split_preference preference) const {
    std::vector<split_tree> trees = candidates();
    std::stable_sort(trees.begin(), trees.end(), [&](const split_tree& s, const split_tree& t) { return better(s, t, preference); });
    const auto found = std::find_if(trees.begin(), trees.end(), [this](const split_tree& t) { return valid(t); });
    if (found == trees.end()) broken_invariant<K>("a vertex of degree " + std::to_string(c_.degree()) + " has a valid split");
    return *found;
  }

  /// The edges around and inside the split vertex; those of the solid run to infinity.
  std::vector<segment> segments(const split_tree& t) const {
    std::vector<segment> result;
    for (const auto& v : t.vertices)
      for (int r = 0; r < 3; ++r) add_segment(result, t, v[r], v[(r + 1) % 3], v[(r + 2) % 3]);
    return result;
  }

 private:
  static constexpr signed char unknown = 2;

  plane_id plane(int facet) const { return c_.facets[facet]; }
  bool meet(plane_id a, plane_id b, plane_id c) const { return bounded_ ? k_.transversal(a, b, c) : k_.orientation(a, b, c) != sign::zero; }
  bool is_side(int a, int b) const { return b == a + 1 || (a == 0 && b == c_.degree() - 1); }

  // The vertex (a,b,c) against facet d just after the start, remembered.
  sign side(int d, int a, int b, int c) const {
    const int n = c_.degree();
    std::array<int, 3> abc = {a, b, c};
    std::sort(abc.begin(), abc.end());
    signed char& known = sides_[((static_cast<std::size_t>(d) * n + abc[0]) * n + abc[1]) * n + abc[2]];
    if (known == unknown) known = static_cast<signed char>(generic_side(k_, plane(d), plane(abc[0]), plane(abc[1]), plane(abc[2]), start_));
    return static_cast<sign>(known);
  }

  // The apexes of the triangles on edge (a,b), a < b: the one between a and b first, -1 where the edge is a side.
  std::array<int, 2> apexes(std::span<const std::pair<int, int>> diagonals, int a, int b) const {
    const auto joined = [&](int x, int y) {
      if (x > y) std::swap(x, y);
      return is_side(x, y) || std::find(diagonals.begin(), diagonals.end(), std::pair(x, y)) != diagonals.end();
    };
    std::array<int, 2> result = {-1, -1};
    for (int c = 0; c < c_.degree(); ++c)
      if (c != a && c != b && joined(a, c) && joined(b, c)) result[a < c && c < b ? 0 : 1] = c;
    return result;
  }

  // Builds the tree of a triangulation; false where it breaks the local rule.
  bool make(std::span<const std::pair<int, int>> diagonals, split_tree& t) const {
    for (const auto& [a, b] : diagonals) {
      const auto [inner, outer] = apexes(diagonals, a, b);
      if (!meet(plane(a), plane(b), plane(inner)) || !meet(plane(a), plane(b), plane(outer))) return false;
      const bool inside = side(inner, a, b, outer) == sign::positive;
      t.edges.push_back({a, b, (k_.orientation(plane(a), plane(inner), plane(b)) == sign::positive) == inside});
    }
    for (int a = 0; a < c_.degree(); ++a)
      for (int b = a + 1; b < c_.degree(); ++b) {
        if (!is_side(a, b) && std::find(diagonals.begin(), diagonals.end(), std::pair(a, b)) == diagonals.end()) continue;
        const int c = apexes(diagonals, a, b)[0];
        if (c >= 0) t.vertices.push_back({a, c, b});
      }
    return std::all_of(t.vertices.begin(), t.vertices.end(), [&](const auto& v) { return obeys_local_rule(t, v); });
  }

  bool edge_convex(const split_tree& t, int a, int b) const {
    if (a > b) std::swap(a, b);
    if (b == a + 1) return c_.convex[a];
    if (a == 0 && b == c_.degree() - 1) return c_.convex[b];
    return std::find_if(t.edges.begin(), t.edges.end(), [&](const split_edge& e) { return e.a == a && e.b == b; })->convex;
  }

  // Design 03: with det > 0 all three edges run inside, or all outside, the third plane; with det < 0 neither. An edge
  // is convex iff (det > 0) == (it runs inside).
  bool obeys_local_rule(const split_tree& t, const std::array<int, 3>& v) const {
    if (!meet(plane(v[0]), plane(v[1]), plane(v[2]))) return false;
    const bool positive = k_.orientation(plane(v[0]), plane(v[1]), plane(v[2])) == sign::positive;
    int inside = 0;
    for (int r = 0; r < 3; ++r) inside += edge_convex(t, v[r], v[(r + 1) % 3]) == positive ? 1 : 0;
    return positive == (inside == 0 || inside == 3);
  }

  // Adds the end of edge (a,b) at the vertex (a,b,third), counter-clockwise.
  void add_segment(std::vector<segment>& edges, const split_tree& t, int a, int b, int third) const {
    const plane_id p = std::min(plane(a), plane(b));
    const plane_id q = std::max(plane(a), plane(b));
    auto e = std::find_if(edges.begin(), edges.end(), [&](const segment& s) { return s.planes == std::array{p, q}; });
    const bool convex = edge_convex(t, a, b);
    if (e == edges.end()) e = edges.insert(edges.end(), segment{{p, q}, {-1, -1}, {false, false}, convex});
    const bool positive = k_.orientation(plane(a), plane(b), plane(third)) == sign::positive;
    const bool inside = convex == positive;
    const int end = runs_inside(k_, p, q, plane(third), 0) == inside ? 0 : 1;
    e->third[end] = plane(third);
    e->inside[end] = inside;
  }

  bool pierces(const segment& e, plane_id l, const std::vector<segment>& facet) const {
    if (e.planes[0] == l || e.planes[1] == l || e.third[0] == l || e.third[1] == l) return false;
    if (!meet(e.planes[0], e.planes[1], l) || !on_segment(k_, e, l, start_)) return false;
    for (const segment& b : facet)  // does it meet an edge of the facet that lies in one of its own two facets?
      for (const int s : {0, 1})
        if (b.other(l) == e.planes[s] && on_segment(k_, b, e.planes[1 - s], start_)) return true;
    return in_facet(l, facet, e.planes[0], e.planes[1]);
  }

  // Whether the corner (l,i,j) lies in the unbounded facet of l. Where neither line through it meets an edge, all
  // edges lie in one quadrant of the two lines, and the corner is in the facet iff that covers more than half a turn.
  bool in_facet(plane_id l, const std::vector<segment>& facet, plane_id i, plane_id j) const {
    for (const auto& [first, second] : {std::pair(i, j), std::pair(j, i)}) {
      std::vector<segment> across;
      std::copy_if(facet.begin(), facet.end(), std::back_inserter(across),
                   [&](const segment& e) { return e.other(l) != first && meet(l, first, e.other(l)); });
      for (const bool into : {true, false})
        if (const auto seen = look(k_, across, l, first, second, into, start_)) return *seen;
    }
    const auto at = static_cast<std::size_t>(std::find(c_.facets.begin(), c_.facets.end(), l) - c_.facets.begin());
    const std::size_t n = c_.facets.size();
    const std::size_t before = (at + n - 1) % n;
    const bool positive = k_.orientation(c_.facets[before], l, c_.facets[(at + 1) % n]) == sign::positive;
    return (c_.convex[at] == positive) != c_.convex[before];
  }

  bool better(const split_tree& s, const split_tree& t, split_preference preference) const {
    switch (preference) {
      case split_preference::convex:
        return s.convex_edges() > t.convex_edges();
      case split_preference::reflex:
        return s.convex_edges() < t.convex_edges();
      case split_preference::min_volume:
        return k_.compare_volume(planes(s), planes(t)) == sign::negative;
      case split_preference::max_volume:
        return k_.compare_volume(planes(s), planes(t)) == sign::positive;
    }
    return false;
  }

  std::vector<triple> planes(const split_tree& t) const {
    std::vector<triple> result;
    for (const auto& v : t.vertices) result.push_back({plane(v[0]), plane(v[1]), plane(v[2])});
    return result;
  }

  const K& k_;
  corner c_;
  typename K::meeting start_;
  bool bounded_;
  mutable std::vector<signed char> sides_;
};

}  // namespace osteon
