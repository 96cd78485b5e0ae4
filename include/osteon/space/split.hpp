// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The ways to split a vertex of degree k into k - 2 vertices of degree three, listed and examined
/// (thesis 3.3, docs/theory/vertex-splitting.md).

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/preference.hpp"
#include "osteon/space/segment.hpp"
#include "osteon/space/split_tree.hpp"
#include "osteon/space/triangulations.hpp"

namespace osteon {

/// The greatest degree at which all trees are listed.
inline constexpr int greatest_split_degree = 12;

/// The splits of one corner, decided by a kernel.
template <kernel<3> K>
class splitter {
 public:
  /// `bounded`: as for corner_signs.
  /// *Requires* degree >= 4.
  splitter(const K& k, corner c, bool bounded = true) : signs_(k, std::move(c), bounded) {}

  /// Returns the signs of the corner.
  const corner_signs<K>& signs() const { return signs_; }

  /// Returns the tree of a triangulation given by its diagonals, ascending; nothing where it breaks
  /// the local rule.
  std::optional<split_tree> tree(std::span<const std::pair<int, int>> diagonals) const { return tree_builder<K>(signs_).build(diagonals); }

  /// Returns all trees that obey the local rule, in the thesis's order.
  /// *Throws* unsupported_error where the degree exceeds greatest_split_degree.
  std::vector<split_tree> candidates() const {
    if (signs_.degree() > greatest_split_degree)
      throw unsupported_error("a list of all trees of a vertex of degree " + std::to_string(signs_.degree()) + " (at most " +
                              std::to_string(greatest_split_degree) + "); hint: search them");
    std::vector<split_tree> result;
    for_each_triangulation(signs_.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
      if (auto t = tree(diagonals)) result.push_back(std::move(*t));
    });
    return result;
  }

  /// Returns whether the offset surface of a tree that obeys the local rule has no
  /// self-intersection, exactly: no edge meets a facet that it does not bound, which includes the
  /// other edges of its own two facets.
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

  /// Returns all valid trees in the thesis's order. *Throws* as candidates().
  std::vector<split_tree> all() const {
    std::vector<split_tree> trees = candidates();
    std::erase_if(trees, [this](const split_tree& t) { return !valid(t); });
    return trees;
  }

  /// Returns the preferred valid tree; among equals the first in the thesis's order. Nothing where
  /// no tree is valid: thesis 3.5 proves that there is one, but where three planes share an edge's
  /// line all of them may have a vertex at infinity. *Throws* as candidates().
  std::optional<split_tree> best(split_preference preference) const {
    std::vector<split_tree> trees = candidates();
    std::stable_sort(trees.begin(), trees.end(), [&](const split_tree& s, const split_tree& t) { return better(s, t, preference); });
    const auto found = std::find_if(trees.begin(), trees.end(), [this](const split_tree& t) { return valid(t); });
    return found == trees.end() ? std::nullopt : std::optional(*found);
  }

  /// Returns the edges around and inside the split vertex, one for each of the tree; those of the
  /// solid run to infinity.
  std::vector<segment> segments(const split_tree& t) const {
    std::vector<segment> result;
    for (const split_edge& e : t.edges) result.push_back({sorted(std::array{plane(e.a), plane(e.b)}), {-1, -1}, {false, false}, e.convex});
    for (std::size_t v = 0; v < t.vertices.size(); ++v)
      for (int r = 0; r < 3; ++r) {
        segment& e = result[t.vertex_edges[v][r]];
        const plane_id third = plane(t.vertices[v][r]);
        const bool inside = e.convex == signs_.positive(t.vertices[v][0], t.vertices[v][1], t.vertices[v][2]);
        const int end = runs_inside(signs_.kernel(), e.planes[0], e.planes[1], third, 0) == inside ? 0 : 1;
        e.third[end] = third;
        e.inside[end] = inside;
      }
    return result;
  }

 private:
  plane_id plane(int facet) const { return signs_.plane(facet); }

  bool pierces(const segment& e, plane_id l, const std::vector<segment>& facet) const {
    const K& k = signs_.kernel();
    if (e.planes[0] == l || e.planes[1] == l || e.third[0] == l || e.third[1] == l) return false;
    if (!signs_.meet(e.planes[0], e.planes[1], l) || !on_segment(k, e, l, signs_.start())) return false;
    // does it meet an edge of the facet that lies in one of its own two facets?
    for (const segment& b : facet)
      for (const int s : {0, 1})
        if (b.other(l) == e.planes[s] && on_segment(k, b, e.planes[1 - s], signs_.start())) return true;
    return in_facet(l, facet, e.planes[0], e.planes[1]);
  }

  // Whether the corner (l,i,j) lies in the unbounded facet of l. Where neither line through it
  // meets an edge, all edges lie in one quadrant of the two lines, and the corner is in the facet
  // iff that covers more than half a turn.
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
      // half a turn, or none at all
      if (!k.transversal(facets[before], l, facets[(at + 1) % n])) continue;
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
