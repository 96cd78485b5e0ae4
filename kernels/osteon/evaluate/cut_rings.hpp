// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Flat regions as facets of a mesh: polygons without holes, which pass no point twice, or
/// triangles.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/evaluate/triangulate.hpp"
#include "osteon/input/geometry.hpp"

namespace osteon {

/// Returns twice the area of a ring of points, by their numbers: positive where it runs
/// counter-clockwise. Rounded.
inline double doubled_area(const std::vector<flat_point>& points, const std::vector<int>& ring) {
  double sum = 0;
  const flat_point& o = points[ring[0]];
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += twice_area(o, points[ring[i]], points[ring[i + 1]]);
  return sum;
}

/// Returns whether a ring passes no point twice.
inline bool is_simple(std::vector<int> ring) {
  std::sort(ring.begin(), ring.end());
  return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
}

/// Calls body(corners) for facets that together have the rings as their borders: outer rings run
/// counter-clockwise, holes clockwise. A ring without holes that is simple stays whole unless
/// `triangulate`. Whatever rounding has done to the points, the facets' sides are those of the
/// rings and pairs of opposite ones. *Requires* a ring. *Complexity*: holes times corners, and see
/// ear_clipping.
template <class Body>
void cut_rings(const std::vector<flat_point>& points, std::vector<std::vector<int>> rings, bool triangulate, Body body) {
  std::vector<std::vector<int>> outer;
  std::vector<std::vector<int>> inner;
  const bool alone = rings.size() == 1;
  for (auto& r : rings) (alone || doubled_area(points, r) > 0 ? outer : inner).push_back(std::move(r));
  if (outer.empty()) {  // too flat to tell
    outer.push_back(std::move(inner.back()));
    inner.pop_back();
  }
  std::vector<std::vector<std::vector<int>>> holes(outer.size());
  for (auto& h : inner) {
    std::size_t in = 0;
    for (std::size_t o = 0; o < outer.size() && outer.size() > 1; ++o) {
      std::vector<flat_point> ring;
      for (const int v : outer[o]) ring.push_back(points[v]);
      if (is_inside(ring, points[h[0]])) in = o;
    }
    holes[in].push_back(std::move(h));
  }
  for (std::size_t o = 0; o < outer.size(); ++o) {
    if (!triangulate && holes[o].empty() && is_simple(outer[o])) {
      body(std::move(outer[o]));
      continue;
    }
    for (const auto& t : ear_clipping(points).run(std::move(outer[o]), std::move(holes[o]))) body(std::vector<int>(t.begin(), t.end()));
  }
}

}  // namespace osteon
