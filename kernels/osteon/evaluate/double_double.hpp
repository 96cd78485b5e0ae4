// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Numbers of about 106 bits, made of two doubles.

#include <cmath>

#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// An unevaluated sum of two doubles, the second at most half a unit in the last place of the
/// first. Each operation has a relative error below 2^-100, but for overflow and underflow. Needs
/// arithmetic that rounds to nearest.
/// *Source* Dekker: A floating-point technique for extending the available precision. Numerische
/// Mathematik 18 (1971). Joldes, Muller, Popescu: Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic. ACM Transactions on Mathematical Software 44 (2017).
struct double_double {
  double high = 0;
  double low = 0;

  double_double() = default;
  double_double(double x) : high(x) {}  // NOLINT: a double is one
  double_double(double h, double l) : high(h), low(l) {}

  /// Returns a + b exactly.
  /// *Requires* |a| >= |b|, or a is zero.
  static double_double quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  /// Returns a + b exactly.
  static double_double sum(double a, double b) {
    const double s = a + b;
    const double v = s - a;
    return {s, (a - (s - v)) + (b - v)};
  }
  /// Returns a * b exactly.
  static double_double product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  friend double_double operator-(const double_double& a) { return {-a.high, -a.low}; }
  friend double_double operator+(const double_double& a, const double_double& b) {
    double_double s = sum(a.high, b.high);
    const double_double t = sum(a.low, b.low);
    s = quick_sum(s.high, s.low + t.high);
    return quick_sum(s.high, s.low + t.low);
  }
  friend double_double operator-(const double_double& a, const double_double& b) { return a + -b; }
  friend double_double operator*(const double_double& a, const double_double& b) {
    const double_double p = product(a.high, b.high);
    return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend double_double operator/(const double_double& a, const double_double& b) {
    const double q = a.high / b.high;
    const double_double r = a - b * double_double(q);
    const double q2 = r.high / b.high;
    const double_double r2 = r - b * double_double(q2);
    return quick_sum(q, q2) + double_double(r2.high / b.high);
  }
  /// Returns the square root.
  /// *Requires* x > 0.
  friend double_double sqrt(const double_double& x) {
    const double s = std::sqrt(x.high);
    const double_double r = x - product(s, s);
    const double_double once = quick_sum(s, r.high / (2 * s));
    return once + double_double((x - once * once).high / (2 * s));
  }
  /// Returns the nearest double.
  double value() const { return high + low; }
};

/// Returns x * 2^-shift within a relative 2^-104.
inline double_double to_double_double(const integer& x, int shift) {
  const double high = to_double(x, shift);
  const int bits = bit_length(x);
  if (bits <= 53) return high;
  const auto drop = static_cast<unsigned>(bits - 53);
  const integer top = (abs(x) >> drop) << drop;
  return double_double::quick_sum(high, to_double(x < 0 ? integer(x + top) : integer(x - top), shift));
}

/// Returns x within a relative 2^-104; infinity beyond the range of doubles.
inline double_double to_double_double(const rational& x) {
  const auto high = x.convert_to<double>();
  if (!std::isfinite(high)) return high;
  return double_double::quick_sum(high, rational(x - rational(high)).convert_to<double>());
}

}  // namespace osteon
