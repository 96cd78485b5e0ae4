// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Repairs that a user may ask for: reversing all facets, and cutting facets that are not planar.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/input/facet_planes.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/rough_points.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// Reverses all facets, for a mesh whose normals point inwards.
template <class Int>
void reverse_facets(input_mesh<Int>& m) {
  for (auto& f : m.facets) std::reverse(f.begin(), f.end());
}

namespace detail {

/// Returns whether the triangle of three successive corners is an ear of a loop: it turns left, and
/// contains no other corner. All is projected to the plane of `axes`.
template <class Int>
bool is_ear(const surface<Int>& s, const std::vector<int>& loop, const std::array<int, 3>& corners, const std::array<int, 2>& axes) {
  const auto at = [&](int p) { return projected(s.points[p], axes); };
  if (turn(s.points[corners[0]], s.points[corners[1]], at(corners[2]), axes) != sign::positive) return false;
  const box3 near(s.rough, corners);
  return std::none_of(loop.begin(), loop.end(), [&](int p) {
    const auto& q = s.rough[p];
    for (const int axis : axes)
      if (q[axis] < near.lo[axis] || q[axis] > near.hi[axis]) return false;
    return std::find(corners.begin(), corners.end(), p) == corners.end() &&
           locate_in_polygon<Int>(s.points, corners, at(p), axes) != location::outside;
  });
}

/// Returns a facet cut into triangles by ears of its projection (Meisters 1975). What cannot be
/// cut, because the loop crosses itself, is left as one piece, for the checks to refuse.
/// *Complexity* quadratic in the facet where ears are easy to find, else cubic.
template <class Int>
std::vector<std::vector<int>> cut_ears(const surface<Int>& s, std::size_t f) {
  std::vector<int> loop = s.loop(f);
  const auto axes = projection(s.area(f));
  std::vector<std::vector<int>> result;
  std::size_t start = 0;
  while (loop.size() > 3) {
    const std::size_t n = loop.size();
    const auto corners_at = [&](std::size_t i) { return std::array<int, 3>{loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]}; };
    std::size_t tried = 0;
    while (tried < n && !is_ear(s, loop, corners_at((start + tried) % n), axes)) ++tried;
    if (tried == n) break;
    const std::size_t ear = (start + tried) % n;
    const auto corners = corners_at(ear);
    result.emplace_back(corners.begin(), corners.end());
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
    start = ear;  // going on instead of starting anew keeps the time quadratic
  }
  result.push_back(std::move(loop));
  return result;
}

}  // namespace detail

/// Cuts every facet that is not planar into triangles; planar facets stay whole. Returns the facet
/// that each facet of the result was, or is a part of, by its former number.
/// *Throws* input_error where facets name no points (see check_facets) or coordinates are absurd.
template <class Int>
std::vector<int> triangulate_facets(input_mesh<Int>& m) {
  check_facets(m);
  surface<Int> s;
  s.input = m;
  scale_points(s);
  std::vector<int> former;
  std::vector<std::vector<int>> facets;
  std::vector<std::size_t> lines;
  std::vector<Int> weights;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    auto pieces = is_planar(s, f) ? std::vector<std::vector<int>>{std::move(m.facets[f])} : detail::cut_ears(s, f);
    for (auto& piece : pieces) {
      former.push_back(static_cast<int>(f));
      facets.push_back(std::move(piece));
      if (f < m.facet_lines.size()) lines.push_back(m.facet_lines[f]);
      if (f < m.weights.size()) weights.push_back(m.weights[f]);
    }
  }
  m.facets = std::move(facets);
  m.facet_lines = std::move(lines);
  m.weights = std::move(weights);
  return former;
}

}  // namespace osteon
