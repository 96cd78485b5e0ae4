// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Convex polytopes by brute force in exact numbers: the hull of points and the meet of half-spaces. Slow, short, and written apart from
/// the library, so that generators can build on it and laws can check against it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "osteon/kernel/integer.hpp"

namespace osteon::properties {

using vector3 = std::array<rational, 3>;

inline vector3 operator+(const vector3& a, const vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline vector3 operator-(const vector3& a, const vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline vector3 operator*(const rational& s, const vector3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline rational dot(const vector3& a, const vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline vector3 cross(const vector3& a, const vector3& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
inline rational det(const vector3& a, const vector3& b, const vector3& c) { return dot(a, cross(b, c)); }
inline bool is_zero(const vector3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// The half-space n . x <= d.
struct half_space {
  vector3 n;
  rational d;
};

/// Corners, and facets counter-clockwise seen from outside. `planes` are the facets' half-spaces.
struct polytope {
  std::vector<vector3> points;
  std::vector<std::vector<int>> facets;
  std::vector<half_space> planes;
};

/// Orders the points of one facet counter-clockwise about n. They are the corners of a convex polygon.
inline std::vector<int> ring_of(const std::vector<vector3>& points, std::vector<int> corners, const vector3& n) {
  // Gift wrapping: from each corner to the one that has all others to its left.
  std::vector<int> ring = {corners.front()};
  while (ring.size() <= corners.size()) {
    int next = -1;
    for (const int c : corners) {
      if (c == ring.back()) continue;
      if (next < 0 || det(n, points[next] - points[ring.back()], points[c] - points[ring.back()]) < 0) next = c;
    }
    if (next == ring.front()) return ring;
    ring.push_back(next);
  }
  return {};
}

/// The corners among points of one plane: those that are no convex combination of two others. Points on edges go.
inline std::vector<int> corners_of(const std::vector<vector3>& points, const std::vector<int>& in_plane) {
  std::vector<int> result;
  const vector3* origin = &points[in_plane[0]];
  vector3 n = {0, 0, 0};
  for (const int a : in_plane)
    for (const int b : in_plane)
      if (is_zero(n)) n = cross(points[a] - *origin, points[b] - *origin);
  if (is_zero(n)) return {};
  for (const int p : in_plane) {
    // p is a corner iff some line through p and another point has all points on one side and p at an end.
    bool corner = false;
    for (const int q : in_plane) {
      if (q == p || corner) continue;
      corner = true;
      const vector3 along = points[q] - points[p];
      for (const int r : in_plane) {
        const rational side = det(n, along, points[r] - points[p]);
        if (side < 0 || (side == 0 && dot(along, points[r] - points[p]) < 0)) corner = false;
      }
    }
    if (corner) result.push_back(p);
  }
  return result;
}

/// The convex hull; nothing where all points lie in one plane.
inline std::optional<polytope> hull(const std::vector<vector3>& all) {
  std::vector<vector3> points = all;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const int n = static_cast<int>(points.size());
  std::map<std::vector<int>, half_space> supports;  // by the points on them
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c) {
        vector3 normal = cross(points[b] - points[a], points[c] - points[a]);
        if (is_zero(normal)) continue;
        bool above = false;
        bool below = false;
        std::vector<int> on;
        for (int p = 0; p < n; ++p) {
          const rational h = dot(normal, points[p] - points[a]);
          (h > 0 ? above : below) = (h > 0 ? above : below) || h != 0;
          if (h == 0) on.push_back(p);
        }
        if (above == below) continue;
        if (above) normal = rational(-1) * normal;
        supports.emplace(on, half_space{normal, dot(normal, points[a])});
      }
  if (supports.empty()) return std::nullopt;
  polytope result;
  std::vector<int> number(points.size(), -1);
  for (const auto& [on, plane] : supports) {
    const std::vector<int> ring = ring_of(points, corners_of(points, on), plane.n);
    if (ring.size() < 3) return std::nullopt;
    auto& facet = result.facets.emplace_back();
    for (const int p : ring) {
      if (number[p] < 0) {
        number[p] = static_cast<int>(result.points.size());
        result.points.push_back(points[p]);
      }
      facet.push_back(number[p]);
    }
    result.planes.push_back(plane);
  }
  return result;
}

/// The corners of a bounded meet of half-spaces, by trying all triples of planes.
inline std::vector<vector3> corners_of(const std::vector<half_space>& spaces) {
  std::vector<vector3> result;
  const std::size_t n = spaces.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const vector3 line = cross(spaces[i].n, spaces[j].n);
      if (is_zero(line)) continue;
      for (std::size_t k = j + 1; k < n; ++k) {
        const rational whole = dot(line, spaces[k].n);
        if (whole == 0) continue;
        const vector3 sum = spaces[i].d * cross(spaces[j].n, spaces[k].n) + spaces[j].d * cross(spaces[k].n, spaces[i].n) + spaces[k].d * line;
        const vector3 p = (1 / whole) * sum;
        if (std::all_of(spaces.begin(), spaces.end(), [&](const half_space& h) { return dot(h.n, p) <= h.d; })) result.push_back(p);
      }
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Volume by cones from the first corner.
inline rational volume(const polytope& p) {
  rational six = 0;
  for (const auto& f : p.facets)
    for (std::size_t i = 2; i < f.size(); ++i)
      six += det(p.points[f[0]] - p.points[0], p.points[f[i - 1]] - p.points[0], p.points[f[i]] - p.points[0]);
  return six / 6;
}

}  // namespace osteon::properties
