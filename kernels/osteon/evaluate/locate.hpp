// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The points and times of planar nodes and moving vertices as doubles, in the units of the input:
/// fast, for output and drawing. Nothing is decided with them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/evaluate/double_double.hpp"
#include "osteon/evaluate/input_scale.hpp"
#include "osteon/evaluate/meeting.hpp"
#include "osteon/evaluate/normalised_lines.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/estimate.hpp"

namespace osteon::plane {

/// A point and a time in doubles, in the units of the input.
struct located {
  double x;
  double y;
  double time;
};

/// Finds points and times of one polygon: coordinates within a few units in the last place of the
/// polygon's size, times the same relative to themselves. Numbers of 106 bits are enough nearly
/// always; where they cannot promise that, rational numbers are asked. Overflow gives infinities.
/// Keeps a reference to the polygon.
/// *Complexity* linear to make; then a microsecond or less for each place, rarely more.
class fast_locator {
 public:
  explicit fast_locator(const polygon<integer>& p) : polygon_(p), lines_(p.lines, shift_of(p)), exact_(p.lines), scale_(p) {
    length_ = to_double_double(rational(scale_.length * power_of(0, lines_.shift())));
    for (std::size_t axis = 0; axis < 2; ++axis) shift_[axis] = to_double_double(rational(rational(p.shift[axis]) * scale_.length));
    time_ = to_double_double(rational(scale_.time * power_of(0, lines_.shift() - lines_.weight_shift())));
  }

  /// Returns the scale of the polygon.
  const input_scale& unit() const { return scale_; }
  /// Returns the lines of the polygon, all lengths at most about one.
  const normalised_lines<double_double>& lines() const { return lines_; }

  /// Returns the place of a vertex of the polygon.
  located vertex(int v) const {
    const auto& p = polygon_.points[static_cast<std::size_t>(v)];
    const auto at = [&](std::size_t axis) { return (to_double_double(p[axis], lines_.shift()) * length_ + shift_[axis]).value(); };
    return {at(0), at(1), 0};
  }

  /// Returns where and when three lines meet.
  /// *Throws* unsupported_error where they do not meet once.
  located meeting(const triple& q) const {
    const auto m = lines_.meeting(q);
    const double below = std::abs(m.speed.high) - m.speed_error;
    if (below > 0) {
      const double_double t = m.offset / m.speed;
      const double t_error = quotient_error(t.high, m.offset_error, m.speed_error, below);
      if (t_error <= 0x1p-53 * std::abs(t.high)) {
        std::size_t best = 0;
        for (std::size_t r = 1; r < 3; ++r)
          if (std::abs(m.lambda[r].high) > std::abs(m.lambda[best].high)) best = r;
        if (const auto p = cross_at(q[(best + 1) % 3], q[(best + 2) % 3], t, t_error)) return {(*p)[0], (*p)[1], (t * time_).value()};
      }
    }
    const auto p = exact_.meeting(q);
    if (!p) throw unsupported_error("three lines of a node do not meet");
    const auto in = scale_.to_input(p->point);
    return {in[0].convert_to<double>(), in[1].convert_to<double>(), scale_.to_input(p->time).convert_to<double>()};
  }

  /// Returns where two lines cross at a time of the integers; `scaled` is scaled(time).
  /// *Requires* lines that cross.
  std::array<double, 2> vertex_at(line_id a, line_id b, const rational& time, const double_double& scaled) const {
    if (const auto p = cross_at(a, b, scaled, std::abs(scaled.high) * 0x1p-100)) return *p;
    const auto in = scale_.to_input(exact_.vertex_at({a, b}, time, 64));
    return {in[0].convert_to<double>(), in[1].convert_to<double>()};
  }

  /// Returns a time of the integers in the units of lines().
  double_double scaled(const rational& time) const { return to_double_double(rational(time * power_of(0, lines_.weight_shift() - lines_.shift()))); }

 private:
  static int shift_of(const polygon<integer>& p) {
    int bits = 0;
    for (const auto& point : p.points)
      for (const integer& x : point) bits = std::max(bits, bit_length(x));
    return bits;
  }

  // In the units of the input; nothing where 106 bits are not enough.
  std::optional<std::array<double, 2>> cross_at(line_id i, line_id j, const double_double& t, double t_error) const {
    const auto& a = lines_[i];
    const auto& b = lines_[j];
    const auto found = normalised_lines<double_double>::solve(a, b, a.d - t * a.speed, b.d - t * b.speed);
    if (!found) return std::nullopt;
    const double known = std::max(std::abs(found->x[0].high), std::abs(found->x[1].high));
    const double speeds = a.speed.high + b.speed.high;
    const double sizes = std::abs(a.d.high) + std::abs(b.d.high) + std::abs(t.high) * speeds;
    if (!(found->radius(known, sizes, t_error * speeds) <= 0x1p-52 * std::max(1.0, known))) return std::nullopt;
    return std::array{(found->x[0] * length_ + shift_[0]).value(), (found->x[1] * length_ + shift_[1]).value()};
  }

  const polygon<integer>& polygon_;
  normalised_lines<double_double> lines_;
  locator exact_;
  input_scale scale_;
  double_double length_, time_;
  std::array<double_double, 2> shift_;
};

}  // namespace osteon::plane
