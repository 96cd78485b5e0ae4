// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Exact answers about the lines of a polygon at one time.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/evaluate/double_double.hpp"
#include "osteon/evaluate/input_scale.hpp"
#include "osteon/evaluate/normalised_lines.hpp"
#include "osteon/evaluate/separation_bound.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/integer_planes.hpp"

namespace osteon::plane {

/// The lines of a wavefront at a time t, as wavefront_at wants them (see plane/offset.hpp): t is a
/// number, no moment of a kernel. Numbers of 106 bits decide nearly always, else integers. Keeps
/// references to the lines.
class lines_at_time {
 public:
  /// Lines, the same normalised (see fast_locator::lines), and a time in the units of the integers.
  /// *Requires* a time that is not negative.
  lines_at_time(std::span<const moving_line<integer>> lines, const normalised_lines<double_double>& normalised, const rational& time)
      : exact_(lines), lines_(normalised), p_(numerator(time)), q_(denominator(time)) {
    t_ = to_double_double(rational(time * power_of(0, normalised.weight_shift() - normalised.shift())));
  }

  /// Returns the sign of det(n_a, n_b).
  sign orientation(line_id a, line_id b) const {
    const double_double det = unit_lines::cross(lines_[a], lines_[b]);
    if (std::abs(det.high) > unit_lines::error) return sign_of(det.high);
    return sign_of(cross(a, b));
  }

  /// Returns the sign of the determinant L(t) = D - t S of three lines in this order. Zero: they
  /// share a point now, or no two of them cross. The vertex (a,b) is inside c where the sign is
  /// that of orientation(a,b).
  sign level(line_id a, line_id b, line_id c) const {
    const auto& x = lines_[a];
    const auto& y = lines_[b];
    const auto& z = lines_[c];
    const std::array<double_double, 3> l = {unit_lines::cross(y, z), unit_lines::cross(z, x), unit_lines::cross(x, y)};
    const double_double value = l[0] * (x.d - t_ * x.speed) + l[1] * (y.d - t_ * y.speed) + l[2] * (z.d - t_ * z.speed);
    const double bound = unit_lines::error * (std::abs(x.d.high) + std::abs(y.d.high) + std::abs(z.d.high) +
                                              2 * std::abs(t_.high) * (x.speed.high + y.speed.high + z.speed.high));
    if (std::abs(value.high) > bound && bound > least) return sign_of(value.high);
    root_form<3> form = speed({a, b, c});  // S; L(t) q = D q - S p
    const triple q = {a, b, c};
    for (std::size_t r = 0; r < 3; ++r) {
      form.a += form.c[r] * exact_[q[r]].d * q_;
      form.c[r] *= -p_;
    }
    return sign_of(form);
  }

  /// Returns the sign of the determinant S of three lines in this order: L sinks where it is
  /// positive.
  sign closing(line_id a, line_id b, line_id c) const {
    const auto m = lines_.meeting({a, b, c});
    if (std::abs(m.speed.high) > m.speed_error && m.speed_error > least) return sign_of(m.speed.high);
    return sign_of(speed({a, b, c}));
  }

  /// Returns whether three lines meet now or have met before.
  /// *Requires* that S is not zero.
  bool is_past(const triple& q) const { return level(q[0], q[1], q[2]) != closing(q[0], q[1], q[2]); }

  /// Returns whether the direction of edges on the line points up, or to the right: whether its
  /// angle is in [0, pi).
  bool upwards(line_id a) const {
    const auto& n = exact_[a].n;  // the direction is n turned left
    return n[0] != 0 ? n[0] > 0 : n[1] < 0;
  }

 private:
  using unit_lines = normalised_lines<double_double>;
  static constexpr double least = 0x1p-900;  // of error bounds that underflow does not spoil

  integer cross(line_id i, line_id j) const { return exact_[i].n[0] * exact_[j].n[1] - exact_[i].n[1] * exact_[j].n[0]; }

  root_form<3> speed(const triple& q) const {
    root_form<3> form{0, lambdas(q, [this](line_id i, line_id j) { return cross(i, j); }), {}};
    for (std::size_t r = 0; r < 3; ++r) form.s[r] = squared_speed(exact_[q[r]]);
    return form;
  }

  std::span<const moving_line<integer>> exact_;
  const unit_lines& lines_;
  integer p_;
  integer q_;
  double_double t_;
};

}  // namespace osteon::plane
