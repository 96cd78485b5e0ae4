// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A mesh on its way to a solid: integer coordinates, incidences and planes, and the first checks.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/input/common_scale.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/half_edge_mesh.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/rough_points.hpp"

namespace osteon {

/// A surface of polygons with integer coordinates. make_solid fills it from above to below; each
/// check requires what is above it.
template <class Int>
struct surface {
  input_mesh<Int> input;

  // Filled by scale_points: input = (point + shift) * 10^ten * 2^two.
  std::vector<vec<Int>> points;
  std::vector<std::array<double, 3>> rough;  ///< the points, rounded by rounded()
  unsigned rough_shift = 0;                  ///< by how many bits
  vec<Int> shift;
  int ten = 0;
  int two = 0;

  half_edge_mesh edges;

  // Filled by find_planes.
  std::vector<moving_plane<Int>> planes;  ///< all different
  std::vector<plane_id> facet_planes;     ///< by facet

  /// Returns the points of a facet, in order.
  const std::vector<int>& loop(std::size_t f) const { return input.facets[f]; }
  /// Returns twice the area vector of a facet.
  vec<Int> area(std::size_t f) const { return area_vector<Int>(points, input.facets[f]); }
  /// Returns the plane of a facet.
  const moving_plane<Int>& plane(std::size_t f) const { return planes[facet_planes[f]]; }
  /// Returns the number of the plane of a half-edge's facet.
  plane_id plane_of(int h) const { return facet_planes[edges[h].facet]; }
  /// Returns the normal of a half-edge's facet.
  const vec<Int>& normal_of(int h) const { return planes[plane_of(h)].n; }
  /// Returns the vector along a half-edge.
  vec<Int> direction(int h) const { return points[edges.to(h)] - points[edges[h].from]; }
};

/// Checks that facets are lists of at least three points that exist and differ from their
/// successors, and that weights are positive and as many as facets, or none.
/// *Throws* input_error.
template <class Int>
void check_facets(const input_mesh<Int>& m) {
  if (m.points.empty() || m.facets.empty())
    throw input_error(input_fault::empty, 0, "there are no " + std::string(m.points.empty() ? "points" : "facets"), "give points and facets");
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const auto& loop = m.facets[f];
    if (loop.size() < 3) m.refuse_facet(input_fault::short_facet, f, " has " + std::to_string(loop.size()) + " corners", "give at least three");
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] < 0 || static_cast<std::size_t>(loop[i]) >= m.points.size())
        m.refuse_facet(input_fault::bad_index, f, " names point " + std::to_string(long{loop[i]} + 1) + " of " + std::to_string(m.points.size()),
                       "name a point that is there");
      if (loop[i] == loop[(i + 1) % loop.size()])
        m.refuse_facet(input_fault::repeated_corner, f, " names point " + std::to_string(loop[i] + 1) + " twice in a row", "name it once");
    }
  }
  if (!m.weights.empty() && m.weights.size() != m.facets.size())
    throw input_error(input_fault::weight_not_positive, std::min(m.weights.size(), m.facets.size()) + 1,
                      "there are " + std::to_string(m.weights.size()) + " weights for " + std::to_string(m.facets.size()) + " facets",
                      "give every facet one weight, or none any");
  for (std::size_t f = 0; f < m.weights.size(); ++f)
    if (m.weights[f] <= 0)
      m.refuse_facet(input_fault::weight_not_positive, f, " has a weight that is not positive", "give a weight greater than zero");
}

/// Brings the coordinates to integers with one common scale and moves them to the middle of their
/// box: that shortens the offsets of planes.
/// *Throws* input_error(absurd_size) where they would need too much memory (see common_scale).
template <class Int>
void scale_points(surface<Int>& s) {
  common_scale<Int> scale;
  for (const auto& p : s.input.points)
    for (const auto& x : p) scale.add(x);
  if (scale.is_absurd())
    s.input.refuse_point(input_fault::absurd_size, scale.finest() / 3, " has digits so fine that all coordinates together need " + scale.memory(),
                         "round it");
  s.points.reserve(s.input.points.size());
  for (const auto& p : s.input.points) s.points.push_back({scale.scaled(p[0]), scale.scaled(p[1]), scale.scaled(p[2])});
  s.ten = scale.ten();
  s.two = scale.two();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::minmax_element(s.points.begin(), s.points.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    s.shift[axis] = ((*lo)[axis] + (*hi)[axis]) / 2;
  }
  for (auto& p : s.points) p = p - s.shift;
  s.rough_shift = double_shift<Int, 3>(s.points);
  s.rough = rounded<Int, 3>(s.points, s.rough_shift);
}

/// Checks that no two points are equal, and that each belongs to a facet.
/// *Throws* input_error.
template <class Int>
void check_points(const surface<Int>& s) {
  const auto& points = s.points;
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i - 1]] == points[order[i]])
      s.input.refuse_point(input_fault::repeated_point, static_cast<std::size_t>(order[i]),
                           " is at the same place as point " + std::to_string(order[i - 1] + 1), "use one of them for both");
  std::vector<bool> used(points.size());
  for (const auto& f : s.input.facets)
    for (const int p : f) used[static_cast<std::size_t>(p)] = true;
  for (std::size_t p = 0; p < used.size(); ++p)
    if (!used[p]) s.input.refuse_point(input_fault::unused_point, p, " is in no facet", "delete it");
}

}  // namespace osteon
