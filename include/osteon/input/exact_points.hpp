// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Points of the plane with exact predicates that doubles answer where they can.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/rough_points.hpp"

namespace osteon::plane {

/// Points with integer coordinates, and the same in doubles.
template <class Int>
class exact_points {
 public:
  exact_points() = default;
  /// Takes points, numbered from 0.
  explicit exact_points(std::vector<std::array<Int, 2>> points) : points_(std::move(points)) {
    const std::span<const std::array<Int, 2>> all(points_);
    const unsigned shift = double_shift(all);
    rough_ = rounded(all, shift);
    double most = 0;
    for (const auto& p : rough_)
      for (const double x : p) most = std::max(most, std::abs(x));
    exact_ = shift == 0 && most <= 0x1p52;  // then differences of coordinates are exact, too
    // A coordinate is wrong by 2^-52 most at most (it was truncated, and shifted only where most >=
    // 2^224), a difference by three times that.
    error_ = exact_ ? 0 : 0x1p-50 * most;
  }

  /// Returns the number of points.
  std::size_t size() const { return points_.size(); }
  /// Returns a point.
  const std::array<Int, 2>& operator[](int i) const { return points_[i]; }
  /// Returns a point in doubles, which have the order of the true coordinates.
  const std::array<double, 2>& rough(int i) const { return rough_[i]; }
  /// Returns whether the doubles are the true coordinates, all of them at most 2^52.
  bool exact() const { return exact_; }

  /// Returns how points a and b compare by x, then by y.
  sign compare(int a, int b) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = rough_[a][axis];
      const double y = rough_[b][axis];
      if (x != y) return x < y ? sign::negative : sign::positive;
      if (!exact_ && points_[a][axis] != points_[b][axis]) return points_[a][axis] < points_[b][axis] ? sign::negative : sign::positive;
    }
    return sign::zero;
  }

  /// Returns whether c lies left of the line from a to b (positive), right, or on it.
  /// *Source* for the error bound: Shewchuk, Adaptive precision floating-point arithmetic, section
  /// 4.1.
  sign turn(int a, int b, int c) const {
    const double bx = rough_[b][0] - rough_[a][0];
    const double by = rough_[b][1] - rough_[a][1];
    const double cx = rough_[c][0] - rough_[a][0];
    const double cy = rough_[c][1] - rough_[a][1];
    const double l = bx * cy;
    const double r = by * cx;
    const double det = l - r;
    // Rounding of two products and of their difference: 3 * 2^-53 of the products, and a little.
    const double bound =
        0x1p-51 * (std::abs(l) + std::abs(r)) + error_ * (std::abs(bx) + std::abs(by) + std::abs(cx) + std::abs(cy)) + 2 * error_ * error_;
    if (std::abs(det) > bound) return det > 0 ? sign::positive : sign::negative;
    // Integers up to 2^53 are products without rounding.
    if (exact_ && std::abs(l) <= 0x1p53 && std::abs(r) <= 0x1p53) return det > 0 ? sign::positive : det < 0 ? sign::negative : sign::zero;
    return osteon::turn(points_[a], points_[b], points_[c]);
  }

  /// Moves point `from` to number `to`.
  void move(int from, int to) {
    if (from == to) return;
    points_[to] = std::move(points_[from]);
    rough_[to] = rough_[from];
  }
  /// Forgets the points from number `size` on.
  void shrink(std::size_t size) {
    points_.resize(size);
    rough_.resize(size);
  }

 private:
  std::vector<std::array<Int, 2>> points_;
  std::vector<std::array<double, 2>> rough_;
  bool exact_ = true;
  double error_ = 0;
};

}  // namespace osteon::plane
