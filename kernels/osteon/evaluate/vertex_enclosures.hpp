// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Where the vertices of a moving polygon surely are, as boxes of doubles. Nothing is decided with them: they only say which pairs need
/// not be looked at.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/prefetch.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/to_double.hpp"
#include "osteon/plane/kernel.hpp"

namespace osteon::plane {

/// Follows vertices of two lines. All results are enclosures: rounding errors are bounded and added.
class vertex_enclosures {
 public:
  /// Lines, and the points of the polygon: nothing leaves their box, unless it moves outside of the polygon.
  vertex_enclosures(std::span<const moving_line<integer>> lines, std::span<const std::array<integer, 2>> points, bool outside = false)
      : lines_(lines) {
    int coordinate_bits = 0;
    for (const auto& p : points)
      for (const integer& x : p) coordinate_bits = std::max(coordinate_bits, bit_length(x));
    const int shift = std::max(0, coordinate_bits - 400);  // so that no product leaves the range of doubles
    int weight_bits = 0;
    for (const auto& l : lines) weight_bits = std::max(weight_bits, bit_length(l.weight));
    units_.reserve(lines.size());
    for (const auto& l : lines) {
      const int bits = std::max(bit_length(l.n[0]), bit_length(l.n[1]));
      const std::array<double, 2> n = {to_double(l.n[0], bits), to_double(l.n[1], bits)};
      const double length = std::hypot(n[0], n[1]);
      speed_ = std::max(speed_, to_double(l.weight, weight_bits));
      units_.push_back({{n[0] / length, n[1] / length}, to_double(l.d, bits + shift) / length, to_double(l.weight, weight_bits)});
    }
    for (const auto& p : points) frame_.add(box::at({to_double(p[0], shift), to_double(p[1], shift)}));
    const double size = std::max({std::abs(frame_.low[0]), std::abs(frame_.low[1]), std::abs(frame_.high[0]), std::abs(frame_.high[1])});
    rounding_ = size * 0x1p-48;
    frame_.grow(outside ? 1e300 : rounding_);
    unit_bits_ = shift - weight_bits;
  }

  const box& frame() const { return frame_; }
  /// This time as it counts here: the kernels' is too great or small for doubles where coordinates are.
  double moment(double kernel_time) const { return std::ldexp(kernel_time, -unit_bits_); }
  /// The greatest speed of a line.
  double speed() const { return speed_; }
  /// Whether a line does not move.
  bool is_stationary(line_id l) const { return units_[l].speed == 0; }
  /// What belongs to this line will be asked for soon.
  void prefetch(line_id l) const { osteon::prefetch(units_[l]); }

  /// When three lines meet, if that is after time zero; where rounding leaves it open, not before the first moment given.
  interval time(const triple& q) const {
    const unit_line& a = units_[q[0]];
    const unit_line& b = units_[q[1]];
    const unit_line& c = units_[q[2]];
    const std::array<double, 3> l = {cross(b.n, c.n), cross(c.n, a.n), cross(a.n, b.n)};
    const double d = l[0] * a.d + l[1] * b.d + l[2] * c.d;
    const double s = l[0] * a.speed + l[1] * b.speed + l[2] * c.speed;
    const double d_error = error * (std::abs(a.d) + std::abs(b.d) + std::abs(c.d));  // |l| <= 1 within error / 2
    const double s_error = error * (a.speed + b.speed + c.speed);
    const double below = std::abs(s) - s_error;
    const double t = d / s;
    const double radius = (d_error + std::abs(t) * s_error) / below * (1 + 0x1p-40) + std::abs(t) * 0x1p-50 + smallest;
    if (below > 0 && std::abs(t) + radius < infinity) return {t - radius, t + radius};
    return {std::min(std::max(0.0, (std::abs(d) - d_error) / (std::abs(s) + s_error)), largest), infinity};
  }

  /// The same within a thousandth, or nearly as sharp as doubles can say it; infinite where S is zero and the lines do not always meet. Slower.
  interval sharp_time(const triple& q) const {
    const interval rough = time(q);
    if (rough.last - rough.first <= 0x1p-10 * std::abs(rough.first)) return rough;
    const auto cross_of = [&](int i, int j) {
      const auto& m = lines_[q[i]].n;
      const auto& n = lines_[q[j]].n;
      return integer(m[0] * n[1] - m[1] * n[0]);
    };
    const std::array<integer, 3> l = {cross_of(1, 2), cross_of(2, 0), cross_of(0, 1)};
    integer d = 0;
    integer size = 0;
    for (int r = 0; r < 3; ++r) {
      d += l[r] * lines_[q[r]].d;
      size += abs(l[r]);
    }
    // S is an algebraic integer of degree 8 at most; what is below this bound is zero (as in locator::meeting).
    int bits = bit_length(size) + 2;
    for (const line_id i : q) bits += bit_length(lines_[i].weight) + bit_length(lines_[i].n[0]) + bit_length(lines_[i].n[1]);
    const auto most = static_cast<unsigned>(8 * bits + 128);
    for (unsigned precision = 128; precision <= 4 * most; precision *= 4) {
      integer s = 0;  // in units of 2^-precision; each root is less than one too small
      for (int r = 0; r < 3; ++r)
        s += l[r] * isqrt(inner_product(lines_[q[r]].n, lines_[q[r]].n) * lines_[q[r]].weight * lines_[q[r]].weight << 2 * precision);
      if (abs(s) <= size << 60U) continue;
      const int d_bits = bit_length(d);
      const int s_bits = bit_length(s);
      const double t = std::ldexp(to_double(d, d_bits) / to_double(s, s_bits), d_bits - s_bits + static_cast<int>(precision) - unit_bits_);
      if (std::abs(t) > largest) return t > 0 ? interval{largest, infinity} : interval{-infinity, -largest};
      const double radius = std::abs(t) * 0x1p-50 + smallest;
      return {t - radius, t + radius};
    }
    return d == 0 ? rough : interval{infinity, infinity};  // S is zero
  }

  /// Where three lines meet, from the two of them that cross best.
  box place(const triple& q) const {
    const interval t = sharp_time(q);
    std::array<int, 2> best = {0, 1};
    double greatest = -1;
    for (const std::array<int, 2> pair : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
      const double sine = std::abs(cross(units_[q[pair[0]]].n, units_[q[pair[1]]].n));
      if (sine > greatest) {
        greatest = sine;
        best = pair;
      }
    }
    if (!(t.last < infinity)) return frame_;
    return corner(units_[q[best[0]]], units_[q[best[1]]], t);
  }

  /// A vertex that starts at the place of a meeting or, without one, where its lines meet at time zero.
  struct path {
    box start;
    interval since;
    std::array<interval, 2> velocity;
  };
  path begin(line_id a, line_id b, const triple* birth) const {
    const unit_line& p = units_[a];
    const unit_line& q = units_[b];
    path result{};
    const interval none{0, 0};
    result.start = birth != nullptr ? place(*birth) : corner(p, q, none);
    result.since = birth != nullptr ? sharp_time(*birth) : none;
    // n_a . v = -s_a, n_b . v = -s_b
    const double det = cross(p.n, q.n);
    const double size = std::abs(det) - error;
    for (int axis = 0; axis < 2; ++axis) {
      const double sign = axis == 0 ? -1 : 1;
      const double x = sign * (p.speed * q.n[1 - axis] - q.speed * p.n[1 - axis]) / det;
      const double radius = size > 0 ? error * (p.speed + q.speed + std::abs(x)) / size : infinity;
      result.velocity[axis] = {x - radius, x + radius};
    }
    return result;
  }

  /// Where a vertex is at some time between two moments.
  box swept(const path& p, double from, double to) const {
    box b = at(p, from);
    b.add(at(p, to));
    b.cut(frame_);
    return b;
  }

 private:
  // A line with a normal of length one; numbers within a relative error of 2^-50.
  struct unit_line {
    std::array<double, 2> n;
    double d;
    double speed;
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double largest = std::numeric_limits<double>::max();
  static constexpr double smallest = std::numeric_limits<double>::denorm_min();
  static constexpr double error = 0x1p-46;  // of the expressions above, relative to the sum of their terms' sizes

  static double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }

  box corner(const unit_line& p, const unit_line& q, const interval& t) const {
    const double det = cross(p.n, q.n);
    const double size = std::abs(det) - error;
    if (!(size > 0)) return frame_;
    const double middle = (t.first + t.last) / 2;
    const double spread = (t.last - t.first) / 2;
    const double u = p.d - middle * p.speed;
    const double v = q.d - middle * q.speed;
    box b;
    for (int axis = 0; axis < 2; ++axis) {
      const double sign = axis == 0 ? 1 : -1;
      const double x = sign * (u * q.n[1 - axis] - v * p.n[1 - axis]) / det;
      const double radius =
          (error * (std::abs(p.d) + std::abs(q.d) + middle * (p.speed + q.speed) + std::abs(x)) + spread * (p.speed + q.speed)) / size;
      b.low[axis] = x - radius;
      b.high[axis] = x + radius;
    }
    b.cut(frame_);
    return b;
  }

  box at(const path& p, double t) const {
    const double least = std::max(0.0, t - p.since.last);
    const double most = std::max(0.0, t - p.since.first);
    box b = p.start;
    for (int axis = 0; axis < 2; ++axis) {
      const interval& v = p.velocity[axis];
      if (most > 0 && !(most * std::max(std::abs(v.first), std::abs(v.last)) < infinity)) return frame_;
      if (most == 0) continue;
      b.low[axis] += std::min(least * v.first, most * v.first);
      b.high[axis] += std::max(least * v.last, most * v.last);
      const double slack = rounding_ + 0x1p-48 * std::max(std::abs(b.low[axis]), std::abs(b.high[axis]));
      b.low[axis] -= slack;
      b.high[axis] += slack;
    }
    return b;
  }

  std::vector<unit_line> units_;
  box frame_;
  double rounding_ = 0;
  double speed_ = 0;
  int unit_bits_ = 0;
  std::span<const moving_line<integer>> lines_;
};

}  // namespace osteon::plane
