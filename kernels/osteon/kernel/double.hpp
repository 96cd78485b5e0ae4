// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The double kernel: everything in machine numbers. It is fast and may be wrong; algorithms end
/// with undecided_error when its answers contradict each other.

#include <array>
#include <cmath>
#include <span>

#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/estimate.hpp"
#include "osteon/kernel/volume.hpp"

namespace osteon {

/// Signs of rounded values, right or wrong.
template <int Dimension>
class basic_double_arithmetic : public estimated_planes<Dimension> {
 public:
  using estimated_planes<Dimension>::plane;
  static constexpr bool is_exact = false;
  static constexpr int speed_bits = 0;
  using estimated_planes<Dimension>::estimated_planes;

  /// Returns the sign of the rounded value.
  sign decide(const estimate& x) const { return sign_of(x.value); }
  /// Returns the sign of the rounded value of a form in the speeds.
  sign decide(const linear_form<estimate>& f) const { return sign_of(this->value(f).value); }
  /// Returns the sign of D where it is certain, else zero: of planes that meet at time zero, as all
  /// at one vertex do, D is nothing but rounding errors.
  sign decide_offset(const estimate& x) const { return x.certain_sign().value_or(sign::zero); }

  /// Returns the order of the angles between n_a, n_b and between n_c, n_d.
  sign angle_order(plane_id a, plane_id b, plane_id c, plane_id d) const { return sign_of(cosine(c, d) - cosine(a, b)); }

  /// Returns the sign of volume(s) - volume(t) (see kernel_of_planes).
  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    return sign_of(volume_difference<double, double>(
        s, t, [this](plane_id i) { return plane(i).n; },
        [this](double& sum, const triple& p, const lawrence_minors<double>& minors, int factor) {
          const auto& m = minors.m;
          const double v = m[0] * plane(p[0]).speed + m[1] * plane(p[1]).speed + m[2] * plane(p[2]).speed;
          sum -= factor * v * v * v / (minors.det * m[0] * m[1] * m[2]);
        }));
  }

 private:
  double dot(plane_id a, plane_id b) const { return plane(a).n[0] * plane(b).n[0] + plane(a).n[1] * plane(b).n[1] + plane(a).n[2] * plane(b).n[2]; }
  double cosine(plane_id a, plane_id b) const { return dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)); }
};

/// The arithmetic of machine numbers in space.
using double_arithmetic = basic_double_arithmetic<3>;
/// The double kernel of space.
using double_kernel = arithmetic_kernel<double_arithmetic>;
/// The double kernel of the plane.
using planar_double_kernel = arithmetic_kernel<basic_double_arithmetic<2>>;

/// Returns the double kernel of these planes.
inline double_kernel make_double_kernel(std::span<const moving_plane<integer>> planes) { return double_kernel(double_arithmetic(planes)); }
/// Returns the double kernel of these lines.
inline planar_double_kernel make_double_kernel(std::span<const moving_line<integer>> lines) {
  return planar_double_kernel(basic_double_arithmetic<2>(lines));
}

}  // namespace osteon
