// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The square-root-extension kernel: speeds weight * |n| exactly.

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/square_classes.hpp"
#include "osteon/kernel/volume.hpp"

namespace osteon {

/// The integers of planes and their perturbations: what exact arithmetics share.
template <int Dimension>
class integer_planes {
 public:
  static constexpr int dimension = Dimension;
  using number = integer;
  using remembers_minors = void;

  explicit integer_planes(std::span<const moving_plane<integer, Dimension>> planes) : planes_(planes.begin(), planes.end()) {}

  plane_id size() const { return static_cast<plane_id>(planes_.size()); }
  const moving_plane<integer, Dimension>& plane(plane_id i) const { return planes_[i]; }
  const integer& n(plane_id i, int axis) const { return planes_[i].n[axis]; }
  const integer& d(plane_id i) const { return planes_[i].d; }
  integer u(plane_id i, int axis) const { return perturbation::of(i).u[axis]; }
  integer delta(plane_id i) const { return perturbation::of(i).delta; }
  sign decide(const integer& x) const { return sign_of(x); }
  sign decide_offset(const integer& d) const { return sign_of(d); }

  integer dot(plane_id a, plane_id b) const { return inner_product(plane(a).n, plane(b).n); }

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
  std::vector<moving_plane<integer, Dimension>> planes_;
};

/// Speeds as square roots; signs by square classes and refinement.
template <int Dimension>
class basic_sqrt_arithmetic : public integer_planes<Dimension> {
 public:
  using integer_planes<Dimension>::plane;
  using integer_planes<Dimension>::size;
  static constexpr bool is_exact = true;
  static constexpr int speed_bits = 128;

  explicit basic_sqrt_arithmetic(std::span<const moving_plane<integer, Dimension>> planes)
      : integer_planes<Dimension>(planes), root_(planes.size(), -1) {
    unit_ = std::all_of(planes.begin(), planes.end(), [&](const auto& p) { return p.weight == planes.front().weight; });
  }

  /// Whether all weights are equal. Then, and only with exact roots, is n / speed of every plane a corner of the convex hull of all.
  bool has_unit_speeds() const { return unit_; }

  using integer_planes<Dimension>::decide;
  sign decide(const linear_form<integer>& f) const {
    linear_form<integer> of_roots = f;
    for (int t = 0; t < f.size; ++t) of_roots.terms[t].plane = root(f.terms[t].plane);
    return roots_.sign_of_form(of_roots.terms, of_roots.size);
  }

  /// A speed in units of 2^-128, less than 1 too small.
  const integer& rough_speed(plane_id p) const { return roots_.refined(root(p)); }

  /// S with roots rounded to 2^-128; each is less than 1 too small in that unit.
  std::pair<integer, integer> rough_speed(const std::array<integer, Dimension + 1>& lambda, const meeting_planes<Dimension>& q) const {
    std::pair<integer, integer> s = {0, 0};
    for (int r = 0; r <= Dimension; ++r) {
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
      c[r] = m[r] * plane(abc[r]).weight;
      square[r] = c[r] * c[r] * this->dot(abc[r], abc[r]);
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
        if (p >= 0) radicand *= this->dot(p, p);
      terms.push_back({products.add(radicand), integer(numerator(c) * (common / denominator(c)))});
    }
    return products.sign_of_form(terms, static_cast<int>(terms.size()));
  }

  // The number of a plane's root. Most planes are never asked for theirs.
  int root(plane_id p) const {
    if (root_[p] < 0) root_[p] = roots_.add(this->dot(p, p), plane(p).weight);
    return root_[p];
  }

  mutable square_classes roots_;
  mutable std::vector<int> root_;
  bool unit_ = true;
};

using sqrt_arithmetic = basic_sqrt_arithmetic<3>;
using sqrt_kernel = arithmetic_kernel<sqrt_arithmetic>;
using planar_sqrt_kernel = arithmetic_kernel<basic_sqrt_arithmetic<2>>;

/// The exact kernel of unit (or weighted) speeds for these planes.
inline sqrt_kernel make_sqrt_kernel(std::span<const moving_plane<integer>> planes) { return sqrt_kernel(sqrt_arithmetic(planes)); }
inline planar_sqrt_kernel make_sqrt_kernel(std::span<const moving_line<integer>> lines) {
  return planar_sqrt_kernel(basic_sqrt_arithmetic<2>(lines));
}

}  // namespace osteon
