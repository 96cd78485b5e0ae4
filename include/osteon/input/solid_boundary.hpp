// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From a checked surface to the boundary that the algorithms see: coplanar neighbours become one
/// facet, and points between two collinear edges disappear.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/surface.hpp"
#include "osteon/space/boundary.hpp"

namespace osteon {

/// Makes the boundary. Its edges are those between different planes; where a fan of facets has two
/// of them they are one edge that runs on, and where it has more it is a vertex.
template <class Int>
class solid_boundary {
 public:
  /// *Requires* a surface with planes and half-edges that encloses material.
  explicit solid_boundary(const surface<Int>& s) : s_(s), rays_(s.edges.fans().size()), vertex_(rays_.size(), -1), order_(rays_.size()) {
    const auto& fans = s_.edges.fans();
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return s_.edges[fans[a]].from < s_.edges[fans[b]].from; });
    find_vertices();
    boundary_.planes = static_cast<plane_id>(s_.planes.size());
    boundary_.vertices.resize(points_.size());
    for (const std::size_t i : order_)
      if (vertex_[i] >= 0) surround(i);
  }

  /// Returns the boundary, to be taken away; vertices are numbered in the order of their points.
  boundary& result() { return boundary_; }
  /// Returns the point of each vertex, by its number in the mesh; to be taken away.
  std::vector<int>& points() { return points_; }

 private:
  void find_vertices() {
    for (const std::size_t i : order_) {
      for (const int h : s_.edges.fan(s_.edges.fans()[i]))
        if (s_.plane_of(h) != s_.plane_of(s_.edges[h].twin)) rays_[i].push_back(h);
      if (rays_[i].size() < 3) continue;
      vertex_[i] = static_cast<int>(points_.size());
      points_.push_back(s_.edges[s_.edges.fans()[i]].from);
    }
  }

  // Lists the facets and edges around the vertex of a fan.
  void surround(std::size_t fan) {
    auto& v = boundary_.vertices[vertex_[fan]];
    for (const int h : rays_[fan]) {
      if (!edge_of_.contains(h)) add_edge(vertex_[fan], h);
      // The edge of h lies between the facet right of h, which comes first, and the one left of it.
      v.facets.push_back(s_.plane_of(h));
      v.edges.push_back(edge_of_[h]);
    }
    // edges[m] between facets[m] and [m + 1]
    std::rotate(v.edges.begin(), v.edges.begin() + 1, v.edges.end());
  }

  // The edge that leaves a vertex by half-edge h, through fans with two rays up to the next vertex.
  void add_edge(int from, int h) {
    int last = h;  // the half-edge that arrives at the other vertex
    int fan = s_.edges.fan_of(s_.edges[last].next);
    while (vertex_[fan] < 0) {
      const int back = s_.edges[last].twin;
      last = rays_[fan][0] == back ? rays_[fan][1] : rays_[fan][0];
      fan = s_.edges.fan_of(s_.edges[last].next);
    }
    const int to = vertex_[fan];
    const int back = s_.edges[last].twin;
    const vec<Int> along = s_.points[points_[to]] - s_.points[points_[from]];
    const bool convex = dot(along, cross(s_.normal_of(h), s_.normal_of(s_.edges[h].twin))) > 0;
    edge_of_[h] = edge_of_[back] = static_cast<int>(boundary_.edges.size());
    boundary_.edges.push_back({{from, to}, {s_.plane_of(h), s_.plane_of(s_.edges[h].twin)}, convex});
  }

  const surface<Int>& s_;
  // by fan: the half-edges out of it between different planes, counter-clockwise
  std::vector<std::vector<int>> rays_;
  std::vector<int> vertex_;               // by fan; -1: none
  std::vector<std::size_t> order_;        // fans in the order of their points
  std::vector<int> points_;               // by vertex
  std::unordered_map<int, int> edge_of_;  // by the half-edges out of its two vertices
  boundary boundary_;
};

/// Returns the number of facets where coplanar neighbours count as one.
template <class Int>
int count_facets(const surface<Int>& s) {
  disjoint_sets pieces(s.input.facets.size());
  int count = static_cast<int>(pieces.size());
  for (const auto& h : s.edges) {
    const int g = s.edges[h.twin].facet;
    if (s.facet_planes[h.facet] == s.facet_planes[g] && pieces.unite(h.facet, g)) --count;
  }
  return count;
}

}  // namespace osteon
