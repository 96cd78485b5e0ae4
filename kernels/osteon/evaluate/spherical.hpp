// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The spherical skeleton of a vertex (thesis 3.4): what a small sphere around the vertex cuts out
/// of the solid's facets and of the sheets of a split. For pictures; nothing is decided with its
/// numbers.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/split.hpp"

namespace osteon {

/// Points on the unit sphere are directions from the vertex. Nodes: first the corner's edges (edge
/// m between the facets m and m + 1), then the tree's vertices, in the direction in which they
/// move. Arcs: first the sides of the spherical polygon, where the facets are, with -1 for the
/// second facet; then those of the skeleton, where two facets meet as they move.
struct spherical_skeleton {
  using vector = std::array<double, 3>;
  /// An arc of a great circle.
  struct arc {
    std::array<int, 2> facets;  ///< places around the corner
    std::array<int, 2> nodes;
    bool convex;                 ///< of the edge that sweeps it; of a side meaningless
    std::vector<vector> points;  ///< along a great circle, less than `step` apart
  };
  /// A part of an arc on one side of the plane through the vertex across a direction of view.
  struct part {
    bool front;
    std::vector<vector> points;
  };
  std::vector<vector> nodes;
  std::vector<arc> arcs;
};

namespace local {

/// A vector of space, as a direction.
using direction = spherical_skeleton::vector;

/// Returns the cross product.
inline direction cross(const direction& a, const direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Returns the inner product.
inline double dot(const direction& a, const direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// Returns the vector of length 1 in a direction.
inline direction unit(const direction& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// Returns points from a to b counter-clockwise around the axis (a unit vector across both), less
/// than `step` radians apart.
inline std::vector<direction> turn(const direction& a, const direction& b, const direction& axis, double step) {
  double angle = std::atan2(dot(cross(a, b), axis), dot(a, b));
  if (angle <= 0) angle += 2 * std::numbers::pi;
  const int pieces = static_cast<int>(angle / step) + 1;
  const direction side = cross(axis, a);
  std::vector<direction> result;
  for (int i = 0; i <= pieces; ++i) {
    const double at = angle * i / pieces;
    result.push_back({});
    for (std::size_t x = 0; x < 3; ++x) result.back()[x] = std::cos(at) * a[x] + std::sin(at) * side[x];
  }
  return result;
}

}  // namespace local

/// Returns the spherical skeleton of a split, in doubles. `planes` are the solid's. Requires a tree
/// of degree - 2 vertices. Cost: linear in the degree and in 1 / step.
inline spherical_skeleton make_spherical_skeleton(std::span<const moving_plane<integer>> planes, const corner& c, const split_tree& t,
                                                  double step = std::numbers::pi / 60) {
  using namespace local;
  const auto k = static_cast<std::size_t>(c.degree());
  std::vector<direction> n;  // unit normals
  std::vector<double> speed;
  for (const plane_id p : c.facets) {
    const auto& plane = planes[static_cast<std::size_t>(p)];
    direction exact{};
    for (std::size_t x = 0; x < 3; ++x) exact[x] = static_cast<double>(plane.n[x]);
    n.push_back(unit(exact));
    speed.push_back(static_cast<double>(plane.weight));
  }
  spherical_skeleton s;
  for (std::size_t m = 0; m < k; ++m) {
    const direction& p = n[m];
    const direction& q = n[(m + 1) % k];
    s.nodes.push_back(unit(c.convex[m] ? cross(q, p) : cross(p, q)));
  }
  for (const auto& v : t.vertices) {
    std::array<std::size_t, 3> f{};
    for (std::size_t r = 0; r < 3; ++r) f[r] = static_cast<std::size_t>(v[r]);
    direction at{};  // det * velocity
    for (std::size_t r = 0; r < 3; ++r) {
      const direction part = cross(n[f[(r + 1) % 3]], n[f[(r + 2) % 3]]);
      for (std::size_t x = 0; x < 3; ++x) at[x] -= speed[f[r]] * part[x];
    }
    if (dot(n[f[0]], cross(n[f[1]], n[f[2]])) < 0)
      for (double& x : at) x = -x;
    s.nodes.push_back(unit(at));
  }
  for (std::size_t f = 0; f < k; ++f) {
    const std::size_t before = (f + k - 1) % k;
    s.arcs.push_back(
        {{static_cast<int>(f), -1}, {static_cast<int>(before), static_cast<int>(f)}, false, turn(s.nodes[before], s.nodes[f], n[f], step)});
  }
  std::vector<std::vector<int>> ends(t.edges.size());
  for (std::size_t e = 0; e < t.edges.size(); ++e)
    if (t.edges[e].rays[0] >= 0) ends[e].push_back(t.edges[e].rays[0]);
  for (std::size_t v = 0; v < t.vertices.size(); ++v)
    for (const int e : t.vertex_edges[v]) ends[static_cast<std::size_t>(e)].push_back(static_cast<int>(k + v));
  for (std::size_t e = 0; e < t.edges.size(); ++e) {
    const direction& a = s.nodes[static_cast<std::size_t>(ends[e][0])];
    const direction& b = s.nodes[static_cast<std::size_t>(ends[e][1])];
    s.arcs.push_back({{t.edges[e].a, t.edges[e].b}, {ends[e][0], ends[e][1]}, t.edges[e].convex, turn(a, b, unit(cross(a, b)), step)});
  }
  return s;
}

/// Cuts an arc where it passes from the front to the back, seen by an eye far away in the direction
/// `eye`.
inline std::vector<spherical_skeleton::part> parts_of(const spherical_skeleton::arc& a, const spherical_skeleton::vector& eye) {
  using namespace local;
  std::vector<spherical_skeleton::part> parts;
  for (const direction& p : a.points) {
    const bool front = dot(p, eye) >= 0;
    if (!parts.empty() && parts.back().front != front) {
      const direction& before = parts.back().points.back();
      const double share = dot(before, eye) / (dot(before, eye) - dot(p, eye));
      direction edge{};
      for (std::size_t x = 0; x < 3; ++x) edge[x] = before[x] + share * (p[x] - before[x]);
      edge = unit(edge);
      parts.back().points.push_back(edge);
      parts.push_back({front, {edge}});
    }
    if (parts.empty()) parts.push_back({front, {}});
    parts.back().points.push_back(p);
  }
  return parts;
}

}  // namespace osteon
