// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Integers and integer points as doubles, by monotone functions: for boxes and filters.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace osteon {

/// Returns a number of bits by which an integer can be shifted right so that doubles hold it and
/// products of two such: zero unless it is beyond 2^480.
template <class Int>
unsigned double_shift(const Int& x) {
  unsigned shift = 0;
  for (auto rest = static_cast<double>(x); std::abs(rest) > 0x1p480; rest = static_cast<double>(Int(x >> shift))) shift += 256;
  return shift;
}

/// Returns the greatest double_shift of the coordinates of points.
template <class Int, std::size_t Dimension>
unsigned double_shift(std::span<const std::array<Int, Dimension>> points) {
  unsigned shift = 0;
  for (const auto& p : points)
    for (const Int& x : p) shift = std::max(shift, double_shift(x));
  return shift;
}

/// Returns the points divided by 2^shift and rounded: coordinates keep their order, equal ones stay
/// equal.
/// *Requires* that `shift` is at least that of double_shift.
template <class Int, std::size_t Dimension>
std::vector<std::array<double, Dimension>> rounded(std::span<const std::array<Int, Dimension>> points, unsigned shift) {
  std::vector<std::array<double, Dimension>> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t axis = 0; axis < Dimension; ++axis)
      result[i][axis] = shift == 0 ? static_cast<double>(points[i][axis]) : static_cast<double>(Int(points[i][axis] >> shift));
  return result;
}

/// A closed box in space.
struct box3 {
  std::array<double, 3> lo, hi;

  /// The box of some of the points, at least one.
  box3(std::span<const std::array<double, 3>> points, std::span<const int> ids) : lo(points[ids[0]]), hi(lo) {
    for (const int p : ids)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(lo[axis], points[p][axis]);
        hi[axis] = std::max(hi[axis], points[p][axis]);
      }
  }

  /// Returns whether two boxes have a point in common.
  bool overlaps(const box3& o) const {
    return lo[0] <= o.hi[0] && o.lo[0] <= hi[0] && lo[1] <= o.hi[1] && o.lo[1] <= hi[1] && lo[2] <= o.hi[2] && o.lo[2] <= hi[2];
  }
};

}  // namespace osteon
