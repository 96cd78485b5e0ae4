// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The double kernel: everything in machine numbers. Fast, and may be wrong; algorithms end with undecided_error when
/// its answers contradict each other.

#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/estimate.hpp"
#include "osteon/kernel/volume.hpp"

namespace osteon {

template <int Dimension>
class basic_double_arithmetic : public estimated_planes<Dimension> {
 public:
  using estimated_planes<Dimension>::plane;
  static constexpr bool is_exact = false;
  static constexpr int speed_bits = 0;
  using estimated_planes<Dimension>::estimated_planes;

  sign decide(const estimate& x) const { return sign_of(x.value); }
  sign decide(const linear_form<estimate>& f) const { return sign_of(this->value(f).value); }
  /// Planes that meet at time zero, as all at one vertex do, leave nothing but rounding errors.
  sign decide_offset(const estimate& x) const { return x.certain_sign().value_or(sign::zero); }

  sign angle_order(plane_id a, plane_id b, plane_id c, plane_id d) const { return sign_of(cosine(c, d) - cosine(a, b)); }

  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    for (int attempt = 0;; ++attempt) {
      const auto small = volume_direction(attempt);
      double difference = 0;
      const auto term = [&](int factor) {
        return [&, factor](const triple& abc, const std::array<double, 3>& m, double det) {
          const double v = m[0] * plane(abc[0]).speed + m[1] * plane(abc[1]).speed + m[2] * plane(abc[2]).speed;
          difference -= factor * v * v * v / (det * m[0] * m[1] * m[2]);
        };
      };
      const auto normal = [this](plane_id i) { return plane(i).n; };
      const std::array<double, 3> c = {double(small[0]), double(small[1]), double(small[2])};
      if (visit_volume<double>(s, c, normal, term(1)) && visit_volume<double>(t, c, normal, term(-1))) return sign_of(difference);
      if (attempt == 100) throw undecided_error("the double kernel finds no direction to compare volumes in");
    }
  }

 private:
  double dot(plane_id a, plane_id b) const { return plane(a).n[0] * plane(b).n[0] + plane(a).n[1] * plane(b).n[1] + plane(a).n[2] * plane(b).n[2]; }
  double cosine(plane_id a, plane_id b) const { return dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)); }
};

using double_arithmetic = basic_double_arithmetic<3>;
using double_kernel = arithmetic_kernel<double_arithmetic>;
using planar_double_kernel = arithmetic_kernel<basic_double_arithmetic<2>>;

inline double_kernel make_double_kernel(std::span<const moving_plane<integer>> planes) { return double_kernel(double_arithmetic(planes)); }
inline planar_double_kernel make_double_kernel(std::span<const moving_line<integer>> lines) {
  return planar_double_kernel(basic_double_arithmetic<2>(lines));
}

}  // namespace osteon
