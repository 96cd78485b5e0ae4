// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The rational kernel: speeds rounded down to multiples of 2^-64, everything else exact. Its
/// skeleton is the exact one of weights that differ from the true ones by less than 2^-64 relative.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/integer_planes.hpp"
#include "osteon/kernel/volume.hpp"

namespace osteon {

/// Speeds as rational numbers with the denominator 2^64.
template <int Dimension>
class basic_rational_arithmetic : public integer_planes<Dimension> {
 public:
  using integer_planes<Dimension>::n;
  using integer_planes<Dimension>::plane;
  using integer_planes<Dimension>::size;
  static constexpr bool is_exact = true;
  static constexpr int speed_bits = 64;

  explicit basic_rational_arithmetic(std::span<const moving_plane<integer, Dimension>> planes) : integer_planes<Dimension>(planes) {
    for (plane_id i = 0; i < size(); ++i) {
      integer g = n(i, 0);  // rounds multiples of one equation alike (K4)
      for (int axis = 1; axis < Dimension; ++axis) g = gcd(g, n(i, axis));
      speeds_.push_back(abs(g) * isqrt((this->dot(i, i) / (g * g) * plane(i).weight * plane(i).weight) << 2 * speed_bits));
    }
  }

  using integer_planes<Dimension>::decide;
  /// Returns the sign of a form in the speeds. In units of 2^-64 they are integers.
  sign decide(const linear_form<integer>& f) const {
    integer sum = 0;
    for (int t = 0; t < f.size; ++t) sum += f.terms[t].coefficient * speeds_[f.terms[t].plane];
    return sign_of(sum);
  }

  /// Returns the sign of volume(s) - volume(t) (see kernel_of_planes).
  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    const auto difference = volume_difference<integer, rational>(
        s, t, [this](plane_id i) { return plane(i).n; },
        [this](rational& sum, const triple& p, const lawrence_minors<integer>& minors, int factor) {
          const auto& m = minors.m;
          const integer v = m[0] * speeds_[p[0]] + m[1] * speeds_[p[1]] + m[2] * speeds_[p[2]];
          sum += rational(-factor * v * v * v, minors.det * m[0] * m[1] * m[2]);
        });
    return osteon::sign_of(difference);
  }

  /// Returns a plane's speed in units of 2^-64: floor(weight * |n| * 2^64).
  const integer& speed(plane_id i) const { return speeds_[i]; }

  /// Returns S and its error, zero, in units of 2^-64.
  std::pair<integer, integer> rough_speed(const std::array<integer, Dimension + 1>& lambda, const meeting_planes<Dimension>& q) const {
    integer s = 0;
    for (int r = 0; r <= Dimension; ++r) s += lambda[r] * speeds_[q[r]];
    return {s, 0};
  }

 private:
  std::vector<integer> speeds_;
};

/// The arithmetic of rounded speeds in space.
using rational_arithmetic = basic_rational_arithmetic<3>;
/// The rational kernel of space.
using rational_kernel = arithmetic_kernel<rational_arithmetic>;
/// The rational kernel of the plane.
using planar_rational_kernel = arithmetic_kernel<basic_rational_arithmetic<2>>;

/// Returns the rational kernel of these planes, which it copies.
inline rational_kernel make_rational_kernel(std::span<const moving_plane<integer>> planes) { return rational_kernel(rational_arithmetic(planes)); }
/// Returns the rational kernel of these lines, which it copies.
inline planar_rational_kernel make_rational_kernel(std::span<const moving_line<integer>> lines) {
  return planar_rational_kernel(basic_rational_arithmetic<2>(lines));
}

}  // namespace osteon
