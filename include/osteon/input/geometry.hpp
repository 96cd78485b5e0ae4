// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Exact geometry of points with integer coordinates, in space and in the plane: what checking and
/// generating input needs. The skeleton's algorithms do not include this file.

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "osteon/core/sign.hpp"

namespace osteon {

/// A point or vector of space. `Int` is an exact integer of any size.
template <class Int>
using vec = std::array<Int, 3>;

/// Returns the vector from b to a.
template <class Int>
vec<Int> operator-(const vec<Int>& a, const vec<Int>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Returns the inner product of two vectors.
template <class Int>
Int dot(const vec<Int>& a, const vec<Int>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns the cross product of two vectors of space.
template <class Int>
vec<Int> cross(const vec<Int>& a, const vec<Int>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns the cross product of the vectors (ax, ay) and (bx, by) of the plane: positive where b
/// points to the left of a, zero where they are parallel.
template <class Number>
Number cross(const Number& ax, const Number& ay, const Number& bx, const Number& by) {
  return ax * by - ay * bx;
}

/// Returns the two products whose difference is twice the signed area of the triangle abc. Filters
/// compare the difference with their sum.
template <class Number>
std::array<Number, 2> area_products(const std::array<Number, 2>& a, const std::array<Number, 2>& b, const std::array<Number, 2>& c) {
  return {Number((b[0] - a[0]) * (c[1] - a[1])), Number((b[1] - a[1]) * (c[0] - a[0]))};
}

/// Returns twice the signed area of the triangle abc of the plane: positive where its corners run
/// counter-clockwise. For integers of a fixed size the caller must know that nothing overflows:
/// long is exact for points of a square of side 2^31.
template <class Number>
Number twice_area(const std::array<Number, 2>& a, const std::array<Number, 2>& b, const std::array<Number, 2>& c) {
  const auto products = area_products(a, b, c);
  return products[0] - products[1];
}

/// Returns whether the way from a over b to c turns left (positive), right, or not at all.
/// *Requires* what twice_area requires.
template <class Number>
sign turn(const std::array<Number, 2>& a, const std::array<Number, 2>& b, const std::array<Number, 2>& c) {
  return sign_of(twice_area(a, b, c));
}

/// Returns twice the area vector of a closed polygon (Newell): the outward normal where corners run
/// counter-clockwise. `loop` names the corners by their numbers in `points`.
template <class Int>
vec<Int> area_vector(std::span<const vec<Int>> points, std::span<const int> loop) {
  vec<Int> sum = {Int(0), Int(0), Int(0)};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const vec<Int> c = cross(points[loop[i]], points[loop[(i + 1) % loop.size()]]);
    for (int axis = 0; axis < 3; ++axis) sum[axis] += c[axis];
  }
  return sum;
}

/// Returns the two axes that are kept when a polygon with this normal is projected along the axis
/// of its largest component, in the order in which counter-clockwise stays counter-clockwise.
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

/// The point (x / w, y / w) of the plane, w > 0.
template <class Int>
struct point2 {
  Int x, y, w;
};

/// Returns the projection of a point of space along the axis that is not in `axes`.
template <class Int>
point2<Int> projected(const vec<Int>& p, const std::array<int, 2>& axes) {
  return {p[axes[0]], p[axes[1]], Int(1)};
}

/// Returns whether the way from a over b to p turns left (positive), right, or not at all, where a
/// and b are projected to the plane of `axes`.
template <class Int>
sign turn(const vec<Int>& a, const vec<Int>& b, const point2<Int>& p, const std::array<int, 2>& axes) {
  const int x = axes[0];
  const int y = axes[1];
  return sign_of(cross<Int>(b[x] - a[x], b[y] - a[y], p.x - a[x] * p.w, p.y - a[y] * p.w));
}

/// Where a point lies with respect to a closed region.
enum class location : signed char { outside = -1, border = 0, inside = 1 };

/// Returns where a point of a facet's plane lies with respect to the facet. The facet is one loop,
/// named by its corners' numbers in `points`, that may visit points and edges twice (a slit to a
/// hole). Facet and point are projected to the plane of `axes`.
/// *Complexity* linear in the loop.
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
