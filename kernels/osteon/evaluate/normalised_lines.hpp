// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Lines with normals of length one, in numbers of 53 or 106 bits, and bounds for what is computed
/// with them.
///
/// Let e be a bound for the relative errors of a line's numbers and of one operation: 2^-50 for
/// doubles, 2^-97 for double_double. By the bound of estimate.hpp:
///  - The scale of a cross product of two normals is at most one, by Cauchy's inequality. Each of
///    its ways meets two inputs and two operations, so it is wrong by less than 4 e (1 + 4 e).
///  - D = sum l_r d_r of three lines meets another input and at most three operations more, so it
///    is wrong by less than 8 e (1 + 8 e) (|d_1| + |d_2| + |d_3|), and S by the same with speeds.
///  - A quotient is wrong as stated there.
/// `error` is at least 16 e; the rest is for the roundings of the bounds. All this holds where
/// nothing underflows: lengths and weights are scaled to one or less, or far away from the limits
/// of doubles, and who decides something does not trust a bound below 2^-900.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "osteon/core/planes.hpp"
#include "osteon/evaluate/double_double.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// What lines need of a number: how it is made from an integer, and its size.
template <class Number>
struct line_number;
template <>
struct line_number<double> {
  static constexpr double error = 0x1p-46;
  /// Returns x * 2^-shift, rounded.
  static double from(const integer& x, int shift) { return to_double(x, shift); }
  /// Returns the length of a vector, rounded.
  static double length(double x, double y) { return std::hypot(x, y); }
  static double size(double x) { return std::abs(x); }
};
template <>
struct line_number<double_double> {
  static constexpr double error = 0x1p-90;
  /// Returns x * 2^-shift, rounded.
  static double_double from(const integer& x, int shift) { return to_double_double(x, shift); }
  /// Returns the length of a vector, rounded.
  static double_double length(const double_double& x, const double_double& y) { return sqrt(x * x + y * y); }
  static double size(const double_double& x) { return std::abs(x.high); }
};

/// The lines  n . x = d - t speed  of a kernel, by number: d in units of 2^shift, speeds in units
/// of 2^weight_shift, so times in units of 2^(shift - weight_shift), of the integers' units.
template <class Number>
class normalised_lines {
 public:
  /// A line whose normal has length 1.
  struct line {
    std::array<Number, 2> n;
    Number d;
    Number speed;
  };
  /// Bounds the error of a sum of a few products of the lines' numbers, relative to the sum of the
  /// sizes of the factors other than normals (see above).
  static constexpr double error = line_number<Number>::error;

  normalised_lines() = default;
  /// Lines with lengths in units of 2^shift, and weights scaled to one or less.
  normalised_lines(std::span<const moving_line<integer>> all, int length_shift) : shift_(length_shift) {
    for (const auto& l : all) weight_shift_ = std::max(weight_shift_, bit_length(l.weight));
    lines_.reserve(all.size());
    for (const auto& l : all) {
      const int bits = std::max(bit_length(l.n[0]), bit_length(l.n[1]));
      const std::array<Number, 2> n = {line_number<Number>::from(l.n[0], bits), line_number<Number>::from(l.n[1], bits)};
      const Number length = line_number<Number>::length(n[0], n[1]);
      lines_.push_back({{n[0] / length, n[1] / length},
                        line_number<Number>::from(l.d, bits + shift_) / length,
                        line_number<Number>::from(l.weight, weight_shift_)});
    }
  }

  const line& operator[](line_id i) const { return lines_[i]; }
  /// Returns the power of two by which lengths are divided.
  int shift() const { return shift_; }
  /// Returns the power of two by which weights are divided.
  int weight_shift() const { return weight_shift_; }

  /// Returns n_a x n_b, which is wrong by less than `error`.
  static Number cross(const line& a, const line& b) { return a.n[0] * b.n[1] - a.n[1] * b.n[0]; }
  /// Returns the absolute value of a number, rounded.
  static double size(const Number& x) { return line_number<Number>::size(x); }

  /// The lambdas, D and S of three lines, and bounds for the errors of D and S.
  struct forms {
    std::array<Number, 3> lambda;
    Number offset;
    Number speed;
    double offset_error;
    double speed_error;
  };
  /// Returns the forms of three lines in this order.
  forms meeting(const triple& q) const {
    const line& a = lines_[q[0]];
    const line& b = lines_[q[1]];
    const line& c = lines_[q[2]];
    const std::array<Number, 3> l = {cross(b, c), cross(c, a), cross(a, b)};
    return {l, l[0] * a.d + l[1] * b.d + l[2] * c.d, l[0] * a.speed + l[1] * b.speed + l[2] * c.speed, error * (size(a.d) + size(b.d) + size(c.d)),
            error * (size(a.speed) + size(b.speed) + size(c.speed))};
  }

  /// The solution x of  n_a . x = u, n_b . x = v.
  struct solution {
    std::array<Number, 2> x;
    double determinant;  ///< its absolute value, at least

    /// Returns a bound for the error of a coordinate: u and v are sums of products whose sizes add
    /// up to `sizes`, and wrong by `spread` beyond that, both together. The numerator is wrong by
    /// error * sizes + spread, and by the determinant's error times x.
    double radius(double coordinate, double sizes, double spread) const { return (error * (sizes + coordinate) + spread) / determinant; }
  };
  /// Solves for a point or velocity; nothing where the lines may be parallel.
  static std::optional<solution> solve(const line& a, const line& b, const Number& u, const Number& v) {
    const Number det = cross(a, b);
    const double least = size(det) - error;
    if (!(least > 0)) return std::nullopt;
    return solution{{(u * b.n[1] - v * a.n[1]) / det, (v * a.n[0] - u * b.n[0]) / det}, least};
  }

 private:
  std::vector<line> lines_;
  int shift_ = 0;
  int weight_shift_ = 0;
};

}  // namespace osteon
