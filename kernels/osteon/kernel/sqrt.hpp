// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The square-root-extension kernel: speeds weight * |n| exactly.

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "osteon/kernel/direct.hpp"
#include "osteon/kernel/square_classes.hpp"
#include "osteon/kernel/volume.hpp"
#include "osteon/plane.hpp"

namespace osteon {

/// The integers of planes and their perturbations: what exact arithmetics share.
class integer_planes {
 public:
  using number = integer;
  using remembers_minors = void;

  explicit integer_planes(std::span<const moving_plane<integer>> planes) : planes_(planes.begin(), planes.end()) {
    tilts_.reserve(planes_.size());
    for (plane_id i = 0; i < size(); ++i) {
      const perturbation p = perturbation::of(i);
      tilts_.push_back({{integer(p.u[0]), integer(p.u[1]), integer(p.u[2])}, integer(p.delta)});
    }
  }

  plane_id size() const { return static_cast<plane_id>(planes_.size()); }
  const moving_plane<integer>& plane(plane_id i) const { return planes_[i]; }
  const integer& n(plane_id i, int axis) const { return planes_[i].n[axis]; }
  const integer& d(plane_id i) const { return planes_[i].d; }
  const integer& u(plane_id i, int axis) const { return tilts_[i].u[axis]; }
  const integer& delta(plane_id i) const { return tilts_[i].delta; }
  sign decide(const integer& x) const { return sign_of(x); }
  sign decide_offset(const integer& d) const { return sign_of(d); }

  integer dot(plane_id a, plane_id b) const { return n(a, 0) * n(b, 0) + n(a, 1) * n(b, 1) + n(a, 2) * n(b, 2); }

  /// Order of the angles between n_a, n_b and between n_c, n_d: the greater cosine is the smaller angle; cosines are
  /// compared by their signed squares.
  sign angle_order(plane_id a, plane_id b, plane_id c, plane_id d) const {
    const integer x = dot(a, b);
    const integer y = dot(c, d);
    if (sign_of(x) != sign_of(y)) return sign_of(x) > sign_of(y) ? sign::negative : sign::positive;
    const integer squares = x * x * dot(c, c) * dot(d, d) - y * y * dot(a, a) * dot(b, b);
    return -(sign_of(squares) * sign_of(x));
  }

 private:
  struct tilt {
    std::array<integer, 3> u;
    integer delta;
  };
  std::vector<moving_plane<integer>> planes_;
  std::vector<tilt> tilts_;
};

/// Speeds as square roots; signs by square classes and refinement.
class sqrt_arithmetic : public integer_planes {
 public:
  static constexpr bool is_exact = true;
  static constexpr int speed_bits = 128;

  explicit sqrt_arithmetic(std::span<const moving_plane<integer>> planes) : integer_planes(planes) {
    for (plane_id i = 0; i < size(); ++i) roots_.add(dot(i, i), plane(i).weight);
    unit_ = std::all_of(planes.begin(), planes.end(), [&](const auto& p) { return p.weight == planes.front().weight; });
  }

  /// Whether all weights are equal. Then, and only with exact roots, is n / speed of every plane a corner of the convex hull of all.
  bool has_unit_speeds() const { return unit_; }

  using integer_planes::decide;
  sign decide(const linear_form<integer>& f) const { return roots_.sign_of_form(f.terms, f.size); }
  const square_classes& roots() const { return roots_; }

  /// A speed in units of 2^-128, less than 1 too small.
  const integer& rough_speed(plane_id p) const { return roots_.refined(p); }

  /// S with roots rounded to 2^-128; each is less than 1 too small in that unit.
  std::pair<integer, integer> rough_speed(const std::array<integer, 4>& lambda, const quadruple& q) const {
    std::pair<integer, integer> s = {0, 0};
    for (int r = 0; r < 4; ++r) {
      s.first += lambda[r] * rough_speed(q[r]);
      s.second += abs(lambda[r]);
    }
    return s;
  }

  /// Sign of volume(s) - volume(t). The cube of a form in three roots is a form in those three and their product, so
  /// the difference is one linear form in roots, decided as all others are.
  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    for (int attempt = 0;; ++attempt) {
      const auto small = volume_direction(attempt);
      const std::array<integer, 3> c = {integer(small[0]), integer(small[1]), integer(small[2])};
      std::map<triple, rational> coefficients;  // of the root of the product of the planes' radicands; -1 for none
      const auto normal = [this](plane_id i) { return plane(i).n; };
      const auto term = [&](int factor) {
        return [&, factor](const triple& abc, const std::array<integer, 3>& m, const integer& det) {
          add_cube(coefficients, abc, m, rational(-factor, det * m[0] * m[1] * m[2]));
        };
      };
      if (visit_volume<integer>(s, c, normal, term(1)) && visit_volume<integer>(t, c, normal, term(-1))) return sign_of_sum(coefficients);
    }
  }

 private:
  // Adds factor * (sum m_r w_r sqrt(s_r))^3.
  void add_cube(std::map<triple, rational>& sum, const triple& abc, const std::array<integer, 3>& m, const rational& factor) const {
    std::array<integer, 3> c;
    std::array<integer, 3> square;  // (c_r sqrt(s_r))^2
    for (int r = 0; r < 3; ++r) {
      c[r] = m[r] * roots_.weight(abc[r]);
      square[r] = c[r] * c[r] * roots_.radicand(abc[r]);
    }
    for (int r = 0; r < 3; ++r) sum[{abc[r], -1, -1}] += factor * rational(c[r] * (square[r] + 3 * square[(r + 1) % 3] + 3 * square[(r + 2) % 3]));
    triple all = abc;
    std::sort(all.begin(), all.end());
    sum[all] += factor * rational(6 * c[0] * c[1] * c[2]);
  }

  sign sign_of_sum(const std::map<triple, rational>& coefficients) const {
    integer common = 1;
    for (const auto& [planes, c] : coefficients) common = lcm(common, denominator(c));
    struct term {
      int plane;
      integer coefficient;
    };
    square_classes products;
    std::vector<term> terms;
    for (const auto& [planes, c] : coefficients) {
      if (c == 0) continue;
      integer radicand = 1;
      for (const plane_id p : planes)
        if (p >= 0) radicand *= roots_.radicand(p);
      terms.push_back({products.add(radicand), integer(numerator(c) * (common / denominator(c)))});
    }
    return products.sign_of_form(terms, static_cast<int>(terms.size()));
  }

  square_classes roots_;
  bool unit_ = true;
};

using sqrt_kernel = direct_kernel<sqrt_arithmetic>;

/// The exact kernel of unit (or weighted) speeds for these planes.
inline sqrt_kernel make_sqrt_kernel(std::span<const moving_plane<integer>> planes) { return sqrt_kernel(sqrt_arithmetic(planes)); }

}  // namespace osteon
