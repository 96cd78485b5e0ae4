// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The places and times of a skeleton's nodes as numbers, for output and drawing. Nothing is decided with them.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// A node in the coordinates of the solid (see solid::shift for the way back to the input) and its time in the same unit.
struct located_node {
  std::array<rational, 3> point;
  rational time;
};

/// Solves for nodes with speeds rounded at a precision that grows until D / S has at least 60 correct bits.
class locator {
 public:
  explicit locator(std::span<const moving_plane<integer>> planes) : planes_(planes) {}

  /// The meeting of four planes; nothing where no three of them meet in a point or S is zero.
  std::optional<located_node> meeting(const quadruple& q) const {
    const std::array<integer, 4> lambda = {-minor(q[1], q[2], q[3]), minor(q[0], q[2], q[3]), -minor(q[0], q[1], q[3]), minor(q[0], q[1], q[2])};
    integer d = 0;
    integer error = 0;
    int best = -1;
    for (int r = 0; r < 4; ++r) {
      d += lambda[r] * planes_[q[r]].d;
      error += abs(lambda[r]);
      if (lambda[r] != 0 && (best < 0 || abs(lambda[r]) > abs(lambda[best]))) best = r;
    }
    if (best < 0) return std::nullopt;
    for (unsigned precision = 128; precision <= 65536; precision *= 2) {
      integer s = 0;
      for (int r = 0; r < 4; ++r) s += lambda[r] * speed(q[r], precision);
      if (abs(s) < error << 60U) continue;
      const rational time(d << precision, s);
      triple t{};
      for (int r = 0, n = 0; r < 4; ++r)
        if (r != best) t[n++] = q[r];
      return located_node{point(t, time, precision), time};
    }
    return std::nullopt;
  }

 private:
  const integer& n(plane_id i, int axis) const { return planes_[i].n[axis]; }

  integer minor(plane_id i, plane_id j, plane_id k) const {
    return n(i, 0) * (n(j, 1) * n(k, 2) - n(j, 2) * n(k, 1)) + n(i, 1) * (n(j, 2) * n(k, 0) - n(j, 0) * n(k, 2)) +
           n(i, 2) * (n(j, 0) * n(k, 1) - n(j, 1) * n(k, 0));
  }

  integer speed(plane_id i, unsigned precision) const {
    const auto& p = planes_[i];
    const integer squared = (p.n[0] * p.n[0] + p.n[1] * p.n[1] + p.n[2] * p.n[2]) * p.weight * p.weight;
    return isqrt(squared << 2 * precision);
  }

  // Cramer's rule for the corner of three planes at a time.
  std::array<rational, 3> point(const triple& t, const rational& time, unsigned precision) const {
    std::array<rational, 3> result = {0, 0, 0};
    const rational det = minor(t[0], t[1], t[2]);
    for (int r = 0; r < 3; ++r) {
      const plane_id a = t[(r + 1) % 3];
      const plane_id b = t[(r + 2) % 3];
      const rational offset = planes_[t[r]].d - time * rational(speed(t[r], precision), integer(1) << precision);
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        result[axis] += offset * (n(a, u) * n(b, v) - n(a, v) * n(b, u)) / det;
      }
    }
    return result;
  }

  std::span<const moving_plane<integer>> planes_;
};

}  // namespace osteon
