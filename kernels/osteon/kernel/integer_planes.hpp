// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Moving planes in exact integers: what the exact arithmetics share.

#include <span>
#include <vector>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbation.hpp"

namespace osteon {

/// Returns sigma^2 = weight^2 n . n, the square of a plane's speed.
template <int Dimension>
integer squared_speed(const moving_plane<integer, Dimension>& p) {
  return inner_product(p.n, p.n) * p.weight * p.weight;
}

/// Returns floor(sigma * 2^bits), a plane's speed in units of 2^-bits, less than one unit too
/// small.
template <int Dimension>
integer rounded_speed(const moving_plane<integer, Dimension>& p, unsigned bits) {
  return isqrt(squared_speed(p) << 2 * bits);
}

/// The numbers of planes and of their perturbations, as `formulas` wants them.
template <int Dimension>
class integer_planes {
 public:
  static constexpr int dimension = Dimension;
  using number = integer;
  using remembers_minors = void;

  explicit integer_planes(std::span<const moving_plane<integer, Dimension>> planes) : planes_(planes.begin(), planes.end()) {}

  plane_id size() const { return static_cast<plane_id>(planes_.size()); }
  /// Returns a plane.
  const moving_plane<integer, Dimension>& plane(plane_id i) const { return planes_[i]; }
  /// Returns a coordinate of a plane's normal.
  const integer& n(plane_id i, int axis) const { return planes_[i].n[axis]; }
  /// Returns a plane's offset.
  const integer& d(plane_id i) const { return planes_[i].d; }
  /// Returns a coordinate of a plane's tilt (see perturbation).
  integer u(plane_id i, int axis) const { return perturbation::of(i).u[axis]; }
  /// Returns the perturbation of a plane's offset.
  integer delta(plane_id i) const { return perturbation::of(i).delta; }
  /// Returns the sign of a number, exactly.
  sign decide(const integer& x) const { return sign_of(x); }
  /// Returns the sign of D: whether planes meet before, at or after time zero, up to the sign of S.
  sign decide_offset(const integer& d) const { return sign_of(d); }

  /// Returns n_a . n_b.
  integer dot(plane_id a, plane_id b) const { return inner_product(plane(a).n, plane(b).n); }

  /// Returns the order of the angles between n_a, n_b and between n_c, n_d: negative where the
  /// first one is smaller. The greater cosine is the smaller angle; cosines are compared by their
  /// signed squares.
  sign angle_order(plane_id a, plane_id b, plane_id c, plane_id d) const {
    const integer x = dot(a, b);
    const integer y = dot(c, d);
    if (sign_of(x) != sign_of(y)) return sign_of(x) > sign_of(y) ? sign::negative : sign::positive;
    const integer squares = x * x * dot(c, c) * dot(d, d) - y * y * dot(a, a) * dot(b, b);
    return -(sign_of(squares) * sign_of(x));
  }

 private:
  std::vector<moving_plane<integer, Dimension>> planes_;
};

}  // namespace osteon
