// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The points and times of meetings as rational numbers, for any input. Nothing is decided with
/// them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "osteon/core/planes.hpp"
#include "osteon/evaluate/separation_bound.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/determinant.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/integer_planes.hpp"

namespace osteon {

/// A point and a time, in the units of the planes' integers. A solid and a polygon tell the way
/// back to the input's units (see input_scale.hpp).
template <int Dimension>
struct exact_place {
  std::array<rational, Dimension> point;
  rational time;
};

/// Solves for meetings and for moving vertices with speeds that are rounded as precisely as it
/// takes. Keeps a reference to the planes.
template <int Dimension>
class basic_locator {
 public:
  using plane = moving_plane<integer, Dimension>;
  using corner = corner_planes<Dimension>;
  using support = meeting_planes<Dimension>;

  explicit basic_locator(std::span<const plane> planes) : planes_(planes) {}

  /// Returns where and when D + 1 planes meet: the time within a relative error of 2^-60, and a
  /// point that the vertex passes at a time that near to the true one. Nothing where no D of the
  /// planes meet in a point or S is zero.
  std::optional<exact_place<Dimension>> meeting(const support& q) const {
    root_form<Dimension + 1> speed{0, lambdas(q, [this](auto... planes) { return minor({planes...}); }), {}};
    integer offset = 0;
    std::size_t best = 0;
    for (std::size_t r = 0; r < q.size(); ++r) {
      offset += speed.c[r] * planes_[q[r]].d;
      speed.s[r] = squared_speed(planes_[q[r]]);
      if (abs(speed.c[r]) > abs(speed.c[best])) best = r;
    }
    if (speed.c[best] == 0) return std::nullopt;
    const auto s = round_form(speed, 60);
    if (!s) return std::nullopt;
    const rational time(offset << s->precision, s->value);
    return exact_place<Dimension>{point(omit(q, best), time, s->precision), time};
  }

  /// Returns where D planes meet at a time, each coordinate within 2^-bits of a unit and a multiple
  /// of that.
  /// *Requires* that they meet in one point.
  std::array<rational, Dimension> vertex_at(const corner& c, const rational& time, unsigned bits) const {
    int size = 4;
    for (const plane_id i : c)
      for (const integer& x : planes_[i].n) size = std::max(size, bit_length(x) + 4);
    const integer whole = numerator(time) / denominator(time);
    auto p = point(c, time, bits + static_cast<unsigned>((Dimension - 1) * size + bit_length(whole) + 4));
    for (rational& x : p) x = rounded_to(x, bits);
    return p;
  }

 private:
  integer minor(const corner& c) const {
    return determinant<Dimension>([&](int row, int axis) -> const integer& { return planes_[c[row]].n[axis]; });
  }

  // Cramer's rule: offsets take the place of one column of the matrix of normals after the other.
  std::array<rational, Dimension> point(const corner& c, const rational& time, unsigned precision) const {
    const integer unit = denominator(time) << precision;  // offsets are in units of 1 / unit
    std::array<integer, Dimension> offsets;
    for (std::size_t r = 0; r < c.size(); ++r) offsets[r] = planes_[c[r]].d * unit - numerator(time) * rounded_speed(planes_[c[r]], precision);
    const integer det = minor(c) * unit;
    std::array<rational, Dimension> result;
    for (int column = 0; column < Dimension; ++column) {
      const integer top =
          determinant<Dimension>([&](int row, int axis) -> const integer& { return axis == column ? offsets[row] : planes_[c[row]].n[axis]; });
      result[column] = rational(top, det);
    }
    return result;
  }

  // The nearest multiple of 2^-bits.
  static rational rounded_to(const rational& x, unsigned bits) {
    const integer top = (numerator(x) << (bits + 1)) + denominator(x);
    const integer bottom = 2 * denominator(x);
    integer q = top / bottom;
    if (q * bottom > top) --q;  // division truncates
    return {q, integer(1) << bits};
  }

  std::span<const plane> planes_;
};

/// Solves for meetings in space.
using locator = basic_locator<3>;

namespace plane {

/// Solves for meetings in the plane.
using locator = basic_locator<2>;

}  // namespace plane
}  // namespace osteon
