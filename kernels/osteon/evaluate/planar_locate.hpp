// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Places and times of a planar skeleton as numbers, for output and drawing: as rationals, and fast as doubles. And questions about one moment,
/// answered exactly, for offsets.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"
#include "osteon/plane/kernel.hpp"

namespace osteon {

/// An unevaluated sum of two doubles with about 106 bits (Dekker 1971; Joldes, Muller, Popescu 2017). Needs arithmetic that rounds to nearest.
struct double_double {
  double high = 0;
  double low = 0;

  double_double() = default;
  double_double(double x) : high(x) {}  // NOLINT: a double is one
  double_double(double h, double l) : high(h), low(l) {}

  static double_double quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static double_double sum(double a, double b) {
    const double s = a + b;
    const double v = s - a;
    return {s, (a - (s - v)) + (b - v)};
  }
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
  /// Requires x > 0.
  friend double_double sqrt(const double_double& x) {
    const double s = std::sqrt(x.high);
    const double_double r = x - product(s, s);
    const double_double once = quick_sum(s, r.high / (2 * s));
    return once + double_double((x - once * once).high / (2 * s));
  }
  double value() const { return high + low; }
};

/// x * 2^-shift within a relative 2^-104.
inline double_double to_double_double(const integer& x, int shift) {
  const double high = to_double(x, shift);
  const int bits = bit_length(x);
  if (bits <= 53) return high;
  const auto drop = static_cast<unsigned>(bits - 53);
  const integer top = (abs(x) >> drop) << drop;
  return double_double::quick_sum(high, to_double(x < 0 ? integer(x + top) : integer(x - top), shift));
}

/// 10^ten * 2^two.
inline rational power_of(int ten, int two) {
  rational r = 1;
  const integer t = pow(integer(10), static_cast<unsigned>(std::abs(ten)));
  const integer b = integer(1) << static_cast<unsigned>(std::abs(two));
  r = ten < 0 ? r / rational(t) : r * rational(t);
  return two < 0 ? r / rational(b) : r * rational(b);
}

/// The nearest double_double, about; infinite beyond the range of doubles.
inline double_double to_double_double(const rational& x) {
  const double high = x.convert_to<double>();
  if (!std::isfinite(high)) return high;
  return double_double::quick_sum(high, rational(x - rational(high)).convert_to<double>());
}

namespace plane {

/// Between a polygon's integers and the units of its input. Time there is distance divided by weight.
struct input_scale {
  std::array<integer, 2> shift{};
  rational length = 1;  ///< of one integer unit of length, in the input's
  rational moment = 1;  ///< of one integer unit of time, in the input's

  input_scale() = default;
  explicit input_scale(const polygon<integer>& p)
      : shift(p.shift), length(power_of(p.ten, p.two)), moment(power_of(p.ten - p.weight_ten, p.two - p.weight_two)) {}

  rational to_integers(const rational& time) const { return time / moment; }
  rational to_input(const rational& time) const { return time * moment; }
  std::array<rational, 2> to_input(const std::array<rational, 2>& p) const {
    return {rational((p[0] + rational(shift[0])) * length), rational((p[1] + rational(shift[1])) * length)};
  }
};

/// Where and when, in the units of the integers.
struct exact_place {
  std::array<rational, 2> point;
  rational time;
};

/// Solves with rationals: slow, for any input. Speeds are rounded at a precision that grows until it suffices.
class locator {
 public:
  explicit locator(std::span<const moving_line<integer>> lines) : lines_(lines) {}

  /// The meeting of three lines, with at least 60 correct bits of S (so the error of the time is below 2^-60 relative, and the point's is that of a
  /// vertex at such a time); nothing where no two of the lines cross or S is zero.
  std::optional<exact_place> meeting(const triple& q) const {
    const std::array<integer, 3> lambda = {cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1])};
    integer d = 0;
    integer error = 0;
    int best = -1;
    int bits = 0;
    for (int r = 0; r < 3; ++r) {
      d += lambda[r] * lines_[q[r]].d;
      error += abs(lambda[r]);
      bits = std::max({bits, bit_length(lambda[r]) + bit_length(lines_[q[r]].n[0]), bit_length(lambda[r]) + bit_length(lines_[q[r]].n[1])});
      if (lambda[r] != 0 && (best < 0 || abs(lambda[r]) > abs(lambda[best]))) best = r;
    }
    if (best < 0) return std::nullopt;
    // S is an algebraic number of degree 8 at most, of this size: when 2^-most does not show it, it is zero.
    for (const int w : {bit_length(lines_[q[0]].weight), bit_length(lines_[q[1]].weight), bit_length(lines_[q[2]].weight)})
      bits = std::max(bits, bits + w);
    const auto most = static_cast<unsigned>(8 * (bits + 4) + 128);
    for (unsigned precision = 128;; precision *= 2) {
      integer s = 0;
      for (int r = 0; r < 3; ++r) s += lambda[r] * speed(q[r], precision);
      if (abs(s) < error << 60U) {
        if (precision > most) return std::nullopt;
        continue;
      }
      const rational time(d << precision, s);
      return exact_place{vertex(q[(best + 1) % 3], q[(best + 2) % 3], time, precision), time};
    }
  }

  /// Where two lines cross at a time, each coordinate within 2^-bits of a unit and a multiple of that. Requires lines that cross.
  std::array<rational, 2> vertex_at(line_id a, line_id b, const rational& time, unsigned bits) const {
    const integer det = cross(a, b);
    int size = 4;
    for (const line_id l : {a, b}) size = std::max({size, bit_length(lines_[l].n[0]) + 4, bit_length(lines_[l].n[1]) + 4});
    const integer whole = numerator(time) / denominator(time);
    const unsigned precision = bits + static_cast<unsigned>(size + bit_length(whole) + 4);
    auto p = vertex(a, b, time, precision);
    for (auto& x : p) {
      const integer top = (numerator(x) << (bits + 1)) + denominator(x);
      const integer bottom = 2 * denominator(x);
      integer q = top / bottom;
      if (q * bottom > top) --q;  // division truncates
      x = rational(q, integer(1) << bits);
    }
    return p;
  }

 private:
  integer cross(line_id i, line_id j) const { return lines_[i].n[0] * lines_[j].n[1] - lines_[i].n[1] * lines_[j].n[0]; }

  // floor(speed * 2^precision)
  integer speed(line_id i, unsigned precision) const {
    const auto& l = lines_[i];
    return isqrt((inner_product(l.n, l.n) * l.weight * l.weight) << 2 * precision);
  }

  std::array<rational, 2> vertex(line_id a, line_id b, const rational& time, unsigned precision) const {
    const auto offset = [&](line_id l) { return rational(lines_[l].d - time * rational(speed(l, precision), integer(1) << precision)); };
    const rational det = cross(a, b);
    const rational u = offset(a);
    const rational v = offset(b);
    const auto& n = lines_[a].n;
    const auto& m = lines_[b].n;
    return {rational((u * m[1] - v * n[1]) / det), rational((v * n[0] - u * m[0]) / det)};
  }

  std::span<const moving_line<integer>> lines_;
};

/// Lines with normals of length one in numbers of 106 bits, lengths divided by 2^shift and weights by 2^weight_shift so that all are at most about
/// one. Every number has an error of at most 2^-97 relative.
struct unit_lines {
  struct line {
    std::array<double_double, 2> n;
    double_double d;
    double speed;
    double speed_low;
    double_double rate() const { return {speed, speed_low}; }
  };
  std::vector<line> lines;
  int shift = 0;
  int weight_shift = 0;
  /// Of sums of a few products of these numbers, relative to the sum of the products' sizes.
  static constexpr double error = 0x1p-90;

  unit_lines() = default;
  unit_lines(std::span<const moving_line<integer>> all, std::span<const std::array<integer, 2>> points) {
    for (const auto& p : points)
      for (const integer& x : p) shift = std::max(shift, bit_length(x));
    for (const auto& l : all) weight_shift = std::max(weight_shift, bit_length(l.weight));
    lines.reserve(all.size());
    for (const auto& l : all) {
      const int bits = std::max(bit_length(l.n[0]), bit_length(l.n[1]));
      const std::array<double_double, 2> n = {to_double_double(l.n[0], bits), to_double_double(l.n[1], bits)};
      const double_double length = sqrt(n[0] * n[0] + n[1] * n[1]);
      const double_double w = to_double_double(l.weight, weight_shift);
      lines.push_back({{n[0] / length, n[1] / length}, to_double_double(l.d, bits + shift) / length, w.high, w.low});
    }
  }

  static double_double cross(const line& a, const line& b) { return a.n[0] * b.n[1] - a.n[1] * b.n[0]; }
};

/// A place and time in doubles, in the units of the input.
struct located {
  double x;
  double y;
  double time;
};

/// The places of nodes and moving vertices as doubles, in the units of the input: coordinates within a few units in the last place of the polygon's
/// size, times the same relative to themselves. Where numbers of 106 bits cannot promise that, the locator is asked. Overflow gives infinities.
/// Keeps references to its arguments. Setup is linear; then a microsecond or less for each place, rarely more.
class fast_locator {
 public:
  fast_locator(const polygon<integer>& p, const unit_lines& lines) : polygon_(p), lines_(lines), exact_(p.lines), units_(p) {
    const rational scale = power_of(0, lines.shift);
    length_ = to_double_double(rational(units_.length * scale));
    for (int axis = 0; axis < 2; ++axis) shift_[axis] = to_double_double(rational(rational(p.shift[axis]) * units_.length));
    moment_ = to_double_double(rational(units_.moment * power_of(0, lines.shift - lines.weight_shift)));
  }

  const input_scale& unit() const { return units_; }

  /// A vertex of the polygon.
  located vertex(int v) const {
    const auto& p = polygon_.points[static_cast<std::size_t>(v)];
    const auto at = [&](int axis) { return (to_double_double(p[axis], lines_.shift) * length_ + shift_[axis]).value(); };
    return {at(0), at(1), 0};
  }

  /// The meeting of three lines. Throws unsupported_error where they do not meet.
  located meeting(const triple& q) const {
    const auto& a = lines_.lines[q[0]];
    const auto& b = lines_.lines[q[1]];
    const auto& c = lines_.lines[q[2]];
    const std::array<double_double, 3> l = {unit_lines::cross(b, c), unit_lines::cross(c, a), unit_lines::cross(a, b)};
    const double_double d = l[0] * a.d + l[1] * b.d + l[2] * c.d;
    const double_double s = l[0] * a.rate() + l[1] * b.rate() + l[2] * c.rate();
    const double d_error = unit_lines::error * (std::abs(a.d.high) + std::abs(b.d.high) + std::abs(c.d.high));
    const double s_error = unit_lines::error * (a.speed + b.speed + c.speed);
    const double below = std::abs(s.high) - s_error;
    if (below > 0) {
      const double_double t = d / s;
      const double t_error = (d_error + std::abs(t.high) * s_error) / below;
      if (t_error <= 0x1p-53 * std::abs(t.high)) {
        int best = 0;
        for (int r = 1; r < 3; ++r)
          if (std::abs(l[r].high) > std::abs(l[best].high)) best = r;
        if (const auto p = cross_at(q[(best + 1) % 3], q[(best + 2) % 3], t, t_error)) return {(*p)[0], (*p)[1], (t * moment_).value()};
      }
    }
    const auto p = exact_.meeting(q);
    if (!p) throw unsupported_error("three lines of a node do not meet");
    const auto in = units_.to_input(p->point);
    return {in[0].convert_to<double>(), in[1].convert_to<double>(), units_.to_input(p->time).convert_to<double>()};
  }

  /// Where two lines cross at a time (of the integers). Requires lines that cross.
  std::array<double, 2> vertex_at(line_id a, line_id b, const rational& time, const double_double& scaled) const {
    if (const auto p = cross_at(a, b, scaled, std::abs(scaled.high) * 0x1p-100)) return *p;
    const auto in = units_.to_input(exact_.vertex_at(a, b, time, 64));
    return {in[0].convert_to<double>(), in[1].convert_to<double>()};
  }

  /// A time of the integers for the function above.
  double_double scaled(const rational& time) const { return to_double_double(rational(time * power_of(0, lines_.weight_shift - lines_.shift))); }

 private:
  std::optional<std::array<double, 2>> cross_at(line_id i, line_id j, const double_double& t, double t_error) const {
    const auto& a = lines_.lines[i];
    const auto& b = lines_.lines[j];
    const double_double det = unit_lines::cross(a, b);
    const double size = std::abs(det.high) - unit_lines::error;
    if (!(size > 0)) return std::nullopt;
    const double_double u = a.d - t * a.rate();
    const double_double v = b.d - t * b.rate();
    const double_double x = (u * b.n[1] - v * a.n[1]) / det;
    const double_double y = (v * a.n[0] - u * b.n[0]) / det;
    const double known = std::max(std::abs(x.high), std::abs(y.high));
    const double radius = (unit_lines::error * (std::abs(a.d.high) + std::abs(b.d.high) + std::abs(t.high) * (a.speed + b.speed) + known) +
                           t_error * (a.speed + b.speed)) /
                          size;
    if (!(radius <= 0x1p-52 * std::max(1.0, known))) return std::nullopt;
    return std::array{(x * length_ + shift_[0]).value(), (y * length_ + shift_[1]).value()};
  }

  const polygon<integer>& polygon_;
  const unit_lines& lines_;
  locator exact_;
  input_scale units_;
  double_double length_, moment_;
  std::array<double_double, 2> shift_;
};

/// One moment t of the wavefront and exact answers about it; the argument of wavefront_at (offset.hpp). Numbers of 106 bits decide nearly always.
class instant {
 public:
  /// `time` in the units of the integers, not negative. Keeps references to `lines` and `units`.
  instant(std::span<const moving_line<integer>> lines, const unit_lines& units, const rational& time)
      : lines_(lines), units_(units), p_(numerator(time)), q_(denominator(time)) {
    t_ = to_double_double(rational(time * power_of(0, units.weight_shift - units.shift)));
  }

  /// Sign of det(n_a, n_b).
  sign orientation(line_id a, line_id b) const {
    const double_double det = unit_lines::cross(units_.lines[a], units_.lines[b]);
    if (std::abs(det.high) > unit_lines::error) return sign_of(det.high);
    return sign_of(integer(lines_[a].n[0] * lines_[b].n[1] - lines_[a].n[1] * lines_[b].n[0]));
  }

  /// Sign of the determinant L(t) = D - t S of three lines in this order. Zero: they share a point at this moment, or no two of them cross. The
  /// vertex (a,b) is inside c where it is that of orientation(a,b).
  sign level(line_id a, line_id b, line_id c) const {
    const auto& x = units_.lines[a];
    const auto& y = units_.lines[b];
    const auto& z = units_.lines[c];
    const std::array<double_double, 3> l = {unit_lines::cross(y, z), unit_lines::cross(z, x), unit_lines::cross(x, y)};
    const double_double value = l[0] * (x.d - t_ * x.rate()) + l[1] * (y.d - t_ * y.rate()) + l[2] * (z.d - t_ * z.rate());
    const double bound =
        unit_lines::error * (std::abs(x.d.high) + std::abs(y.d.high) + std::abs(z.d.high) + 2 * std::abs(t_.high) * (x.speed + y.speed + z.speed));
    if (std::abs(value.high) > bound && bound > least) return sign_of(value.high);
    const triple q = {a, b, c};
    const auto lambda = minors(q);
    integer d = 0;
    for (int r = 0; r < 3; ++r) d += lambda[r] * lines_[q[r]].d;
    return decide(d * q_, {lambda[0] * -p_, lambda[1] * -p_, lambda[2] * -p_}, q);
  }

  /// Sign of the determinant S of three lines in this order: L sinks where it is positive.
  sign closing(line_id a, line_id b, line_id c) const {
    const auto& x = units_.lines[a];
    const auto& y = units_.lines[b];
    const auto& z = units_.lines[c];
    const double_double value = unit_lines::cross(y, z) * x.rate() + unit_lines::cross(z, x) * y.rate() + unit_lines::cross(x, y) * z.rate();
    const double bound = unit_lines::error * (x.speed + y.speed + z.speed);
    if (std::abs(value.high) > bound && bound > least) return sign_of(value.high);
    return decide(0, minors({a, b, c}), {a, b, c});
  }

  /// Whether three lines meet at this moment or before.
  bool is_past(const triple& q) const { return level(q[0], q[1], q[2]) != closing(q[0], q[1], q[2]); }

  /// Whether the direction of edges on the line points up, or to the right: halves the full turn.
  bool upwards(line_id a) const {
    const auto& n = lines_[a].n;  // the direction is n turned left
    return n[0] != 0 ? n[0] > 0 : n[1] < 0;
  }

 private:
  static constexpr double least = 0x1p-900;  // of error bounds that underflow does not spoil

  std::array<integer, 3> minors(const triple& q) const { return {cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1])}; }
  integer cross(line_id i, line_id j) const { return lines_[i].n[0] * lines_[j].n[1] - lines_[i].n[1] * lines_[j].n[0]; }

  // Sign of a + sum c_r sigma_r. It is an algebraic integer; all its at most eight conjugates are below 2^size, so if it is not zero it is at least
  // 2^(-7 size): their product is an integer.
  sign decide(const integer& a, std::array<integer, 3> c, const triple& q) const {
    std::array<integer, 3> squares;
    int size = bit_length(a);
    for (int r = 0; r < 3; ++r) {
      const auto& l = lines_[q[r]];
      squares[r] = inner_product(l.n, l.n);
      c[r] *= l.weight;
      size = std::max(size, bit_length(c[r]) + (bit_length(squares[r]) + 1) / 2);
    }
    size += 2;
    const integer error = abs(c[0]) + abs(c[1]) + abs(c[2]);
    const auto most = static_cast<unsigned>(7 * size + bit_length(error) + 2);
    for (unsigned precision = 128;; precision = std::min(2 * precision, most)) {
      integer sum = a << precision;
      for (int r = 0; r < 3; ++r) sum += c[r] * isqrt(squares[r] << 2 * precision);
      if (abs(sum) > error) return sign_of(sum);
      if (precision >= most) return sign::zero;
    }
  }

  std::span<const moving_line<integer>> lines_;
  const unit_lines& units_;
  integer p_;
  integer q_;
  double_double t_;
};

}  // namespace plane
}  // namespace osteon
