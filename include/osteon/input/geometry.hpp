// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Exact geometry of points with integer coordinates: what checking a solid needs. The skeleton's algorithms do not
/// include this file.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "osteon/core/sign.hpp"

namespace osteon {

template <class Int>
using vec = std::array<Int, 3>;

template <class Int>
vec<Int> operator-(const vec<Int>& a, const vec<Int>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Int>
Int dot(const vec<Int>& a, const vec<Int>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Int>
vec<Int> cross(const vec<Int>& a, const vec<Int>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the area vector of a closed polygon (Newell): the outward normal where corners run counter-clockwise.
template <class Int>
vec<Int> area_vector(std::span<const vec<Int>> points, std::span<const int> loop) {
  vec<Int> sum = {Int(0), Int(0), Int(0)};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const vec<Int> c = cross(points[loop[i]], points[loop[(i + 1) % loop.size()]]);
    for (int axis = 0; axis < 3; ++axis) sum[axis] += c[axis];
  }
  return sum;
}

/// The two axes kept when a polygon with this normal is projected along the axis of its largest component, ordered so
/// that counter-clockwise stays counter-clockwise.
template <class Int>
std::array<int, 2> projection(const vec<Int>& normal) {
  int axis = 0;
  const auto size = [&](int i) -> Int { return normal[i] < 0 ? Int(-normal[i]) : normal[i]; };
  for (int i = 1; i < 3; ++i)
    if (size(i) > size(axis)) axis = i;
  std::array<int, 2> kept = {(axis + 1) % 3, (axis + 2) % 3};
  if (normal[axis] < 0) std::swap(kept[0], kept[1]);
  return kept;
}

/// A point of the plane in homogeneous coordinates, w > 0.
template <class Int>
struct point2 {
  Int x, y, w;
};

/// Sign of the area of triangle (a,b,p): positive when p lies left of a -> b.
template <class Int>
sign turn(const vec<Int>& a, const vec<Int>& b, const point2<Int>& p, const std::array<int, 2>& axes) {
  const int x = axes[0];
  const int y = axes[1];
  return sign_of(Int((b[x] - a[x]) * (p.y - a[y] * p.w) - (b[y] - a[y]) * (p.x - a[x] * p.w)));
}

enum class location : signed char { outside = -1, border = 0, inside = 1 };

/// Where a point of a facet's plane lies with respect to the facet, given by one loop that may visit points and edges
/// twice (a slit to a hole). Linear in the loop.
template <class Int>
location locate_in_polygon(std::span<const vec<Int>> points, std::span<const int> loop, const point2<Int>& p, const std::array<int, 2>& axes) {
  bool inside = false;
  const int x = axes[0];
  const int y = axes[1];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const vec<Int>& a = points[loop[i]];
    const vec<Int>& b = points[loop[(i + 1) % loop.size()]];
    const bool a_above = a[y] * p.w > p.y;
    const bool b_above = b[y] * p.w > p.y;
    const bool flat = a_above == b_above;
    if (flat && a[y] * p.w != p.y && b[y] * p.w != p.y) continue;
    const sign t = turn(a, b, p, axes);
    if (t == sign::zero) {
      const auto between = [&](int axis, const Int& c) {
        const Int lo = (a[axis] < b[axis] ? a[axis] : b[axis]) * p.w;
        const Int hi = (a[axis] < b[axis] ? b[axis] : a[axis]) * p.w;
        return lo <= c && c <= hi;
      };
      if (between(x, p.x) && between(y, p.y)) return location::border;
    }
    if (!flat && (t == sign::positive) == b_above) inside = !inside;
  }
  return inside ? location::inside : location::outside;
}

}  // namespace osteon
