// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The rational kernel: speeds rounded down to multiples of 2^-64, everything else exact. Its skeleton is the exact
/// one of weights that differ from the true ones by less than 2^-64 relative.

#include "osteon/kernel/sqrt.hpp"

namespace osteon {

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
      speeds_.push_back(abs(g) * isqrt((this->dot(i, i) / (g * g) * plane(i).weight * plane(i).weight) << 128U));
    }
  }

  using integer_planes<Dimension>::decide;

  /// Speeds in units of 2^-64: the unit of time changes, no sign does.
  sign decide(const linear_form<integer>& f) const {
    integer sum = 0;
    for (int t = 0; t < f.size; ++t) sum += f.terms[t].coefficient * speeds_[f.terms[t].plane];
    return sign_of(sum);
  }

  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    for (int attempt = 0;; ++attempt) {
      const auto small = volume_direction(attempt);
      rational difference = 0;
      const auto term = [&](int factor) {
        return [&, factor](const triple& abc, const std::array<integer, 3>& m, const integer& det) {
          const integer v = m[0] * speeds_[abc[0]] + m[1] * speeds_[abc[1]] + m[2] * speeds_[abc[2]];
          difference += rational(-factor * v * v * v, det * m[0] * m[1] * m[2]);
        };
      };
      const auto normal = [this](plane_id i) { return plane(i).n; };
      const std::array<integer, 3> c = {integer(small[0]), integer(small[1]), integer(small[2])};
      if (visit_volume<integer>(s, c, normal, term(1)) && visit_volume<integer>(t, c, normal, term(-1))) return osteon::sign_of(difference);
    }
  }

  /// S itself.
  std::pair<integer, integer> rough_speed(const std::array<integer, Dimension + 1>& lambda, const meeting_planes<Dimension>& q) const {
    integer s = 0;
    for (int r = 0; r <= Dimension; ++r) s += lambda[r] * speeds_[q[r]];
    return {s, 0};
  }

  /// floor(weight * |n| * 2^64).
  const integer& speed(plane_id i) const { return speeds_[i]; }

 private:
  std::vector<integer> speeds_;
};

using rational_arithmetic = basic_rational_arithmetic<3>;
using rational_kernel = arithmetic_kernel<rational_arithmetic>;
using planar_rational_kernel = arithmetic_kernel<basic_rational_arithmetic<2>>;

inline rational_kernel make_rational_kernel(std::span<const moving_plane<integer>> planes) { return rational_kernel(rational_arithmetic(planes)); }
inline planar_rational_kernel make_rational_kernel(std::span<const moving_line<integer>> lines) {
  return planar_rational_kernel(basic_rational_arithmetic<2>(lines));
}

}  // namespace osteon
