// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Where the vertices of a moving polygon surely are, as boxes of doubles. Nothing is decided with
/// them: they only say which pairs cannot meet.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/core/prefetch.hpp"
#include "osteon/evaluate/normalised_lines.hpp"
#include "osteon/evaluate/separation_bound.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/estimate.hpp"
#include "osteon/kernel/integer_planes.hpp"

namespace osteon::plane {

/// Follows the vertices of a moving polygon. All results are enclosures: rounding errors are
/// bounded and added (see normalised_lines.hpp). Lengths and times are in units of their own,
/// powers of two of the integers' units. Keeps a reference to the lines.
class vertex_enclosures {
 public:
  /// Lines, and the points of the polygon: nothing leaves their box, unless it moves outside of the
  /// polygon.
  vertex_enclosures(std::span<const moving_line<integer>> lines, std::span<const std::array<integer, 2>> points, bool outside = false)
      : exact_(lines), lines_(lines, shift_of(points)) {
    for (line_id l = 0; l < static_cast<line_id>(lines.size()); ++l) speed_ = std::max(speed_, lines_[l].speed);
    for (const auto& p : points) frame_.add(box::at({to_double(p[0], lines_.shift()), to_double(p[1], lines_.shift())}));
    const double size = std::max({std::abs(frame_.low[0]), std::abs(frame_.low[1]), std::abs(frame_.high[0]), std::abs(frame_.high[1])});
    rounding_ = size * 0x1p-48;
    frame_.grow(outside ? 1e300 : rounding_);
    time_bits_ = lines_.shift() - lines_.weight_shift();
  }

  /// Returns a box that no vertex leaves.
  const box& frame() const { return frame_; }
  /// Returns a time of the integers in the units of the enclosures.
  double own_time(double t) const { return std::ldexp(t, -time_bits_); }
  /// Returns the greatest speed of a line.
  double speed() const { return speed_; }
  /// Returns whether a line does not move.
  bool is_stationary(line_id l) const { return lines_[l].speed == 0; }
  /// Tells the processor that this line will be asked about soon.
  void prefetch(line_id l) const { osteon::prefetch(lines_[l]); }

  /// Returns when three lines meet, if that is after time zero. Where rounding leaves that open,
  /// the end is infinite and they do not meet between time zero and the beginning. *Complexity*
  /// some thirty operations.
  interval time(const triple& q) const {
    const auto m = lines_.meeting(q);
    const double below = std::abs(m.speed) - m.speed_error;
    const double t = m.offset / m.speed;
    const double radius = quotient_error(t, m.offset_error, m.speed_error, below) + std::abs(t) * 0x1p-50 + smallest;
    if (below > 0 && std::abs(t) + radius < infinity) return {t - radius, t + radius};
    return {std::min(std::max(0.0, (std::abs(m.offset) - m.offset_error) / (std::abs(m.speed) + m.speed_error)), largest), infinity};
  }

  /// Returns the same within a thousandth, or nearly as sharp as doubles can say it; infinite where
  /// S is zero and the lines do not always meet. *Complexity* that of time, or of integer
  /// arithmetic where that is not sharp.
  interval sharp_time(const triple& q) const {
    const interval rough = time(q);
    if (rough.last - rough.first <= 0x1p-10 * std::abs(rough.first)) return rough;
    root_form<3> speed{0, lambdas(q, [this](line_id a, line_id b) { return cross(exact_[a].n, exact_[b].n); }), {}};
    integer d = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      d += speed.c[r] * exact_[q[r]].d;
      speed.s[r] = squared_speed(exact_[q[r]]);
    }
    const auto s = round_form(speed, 60);
    if (!s) return d == 0 ? rough : interval{infinity, infinity};
    const int d_bits = bit_length(d);
    const int s_bits = bit_length(s->value);
    const double t = std::ldexp(to_double(d, d_bits) / to_double(s->value, s_bits), d_bits - s_bits + static_cast<int>(s->precision) - time_bits_);
    if (std::abs(t) > largest) return t > 0 ? interval{largest, infinity} : interval{-infinity, -largest};
    const double radius = std::abs(t) * 0x1p-50 + smallest;
    return {t - radius, t + radius};
  }

  /// Returns where three lines meet, from the two of them that cross best.
  box place(const triple& q) const {
    const interval t = sharp_time(q);
    std::array<std::size_t, 2> best = {0, 1};
    double greatest = -1;
    for (const std::array<std::size_t, 2> pair : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
      const double sine = std::abs(unit_lines::cross(lines_[q[pair[0]]], lines_[q[pair[1]]]));
      if (sine > greatest) {
        greatest = sine;
        best = pair;
      }
    }
    if (!(t.last < infinity)) return frame_;
    return corner(lines_[q[best[0]]], lines_[q[best[1]]], t);
  }

  /// The way of a vertex.
  struct path {
    box start;
    interval since;
    std::array<interval, 2> velocity;
  };
  /// Returns the way of the vertex of two lines that starts at the place of a meeting or, without
  /// one, where the lines meet at time zero.
  path begin(line_id a, line_id b, const triple* birth) const {
    const auto& p = lines_[a];
    const auto& q = lines_[b];
    path result{};
    const interval none{0, 0};
    result.start = birth != nullptr ? place(*birth) : corner(p, q, none);
    result.since = birth != nullptr ? sharp_time(*birth) : none;
    const auto velocity = unit_lines::solve(p, q, -p.speed, -q.speed);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = velocity ? velocity->x[axis] : 0;
      const double radius = velocity ? velocity->radius(std::abs(x), p.speed + q.speed, 0) : infinity;
      result.velocity[axis] = {x - radius, x + radius};
    }
    return result;
  }

  /// Returns a box that the vertex does not leave from one time to another.
  box swept(const path& p, double from, double to) const {
    box b = at(p, from);
    b.add(at(p, to));
    b.cut(frame_);
    return b;
  }

 private:
  using unit_lines = normalised_lines<double>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double largest = std::numeric_limits<double>::max();
  static constexpr double smallest = std::numeric_limits<double>::denorm_min();

  // Lengths stay in the integers' units where no product leaves the range of doubles then.
  static int shift_of(std::span<const std::array<integer, 2>> points) {
    int bits = 0;
    for (const auto& p : points)
      for (const integer& x : p) bits = std::max(bits, bit_length(x));
    return std::max(0, bits - 400);
  }

  static integer cross(const std::array<integer, 2>& a, const std::array<integer, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }

  // Where two lines meet at a time.
  box corner(const unit_lines::line& p, const unit_lines::line& q, const interval& t) const {
    const double middle = (t.first + t.last) / 2;
    const double spread = (t.last - t.first) / 2;
    const auto found = unit_lines::solve(p, q, p.d - middle * p.speed, q.d - middle * q.speed);
    if (!found) return frame_;
    const double speeds = p.speed + q.speed;
    const double sizes = std::abs(p.d) + std::abs(q.d) + std::abs(middle) * speeds;
    box b;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = found->x[axis];
      const double radius = found->radius(std::abs(x), sizes, spread * speeds);
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
    for (std::size_t axis = 0; axis < 2; ++axis) {
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

  std::span<const moving_line<integer>> exact_;
  unit_lines lines_;
  box frame_;
  double rounding_ = 0;
  double speed_ = 0;
  int time_bits_ = 0;
};

}  // namespace osteon::plane
