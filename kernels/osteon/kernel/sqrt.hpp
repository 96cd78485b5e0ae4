// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The square-root kernel: speeds weight * |n| exactly.

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/integer_planes.hpp"
#include "osteon/kernel/square_classes.hpp"
#include "osteon/kernel/volume.hpp"

namespace osteon {

/// Speeds as square roots of integers; signs by square classes and refinement.
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

  /// Returns whether all weights are equal. Only then, and only with exact roots, is n / speed of
  /// every plane a corner of the convex hull of all.
  bool has_unit_speeds() const { return unit_; }

  using integer_planes<Dimension>::decide;
  /// Returns the sign of a form in the speeds.
  sign decide(const linear_form<integer>& f) const {
    linear_form<integer> of_roots = f;
    for (int t = 0; t < f.size; ++t) of_roots.terms[t].plane = root(f.terms[t].plane);
    return roots_.sign_of_form(of_roots.terms, of_roots.size);
  }

  /// Returns a plane's speed in units of 2^-128, less than one unit too small.
  const integer& rough_speed(plane_id p) const { return roots_.refined(root(p)); }

  /// Returns S and the greatest error of it, in units of 2^-128.
  std::pair<integer, integer> rough_speed(const std::array<integer, Dimension + 1>& lambda, const meeting_planes<Dimension>& q) const {
    std::pair<integer, integer> s = {0, 0};
    for (int r = 0; r <= Dimension; ++r) {
      s.first += lambda[r] * rough_speed(q[r]);
      s.second += abs(lambda[r]);
    }
    return s;
  }

  /// Returns the sign of volume(s) - volume(t) (see kernel_of_planes). The cube of a form in three
  /// roots is a form in those three and their product, so the difference is one linear form in
  /// roots, decided as all others are.
  sign volume_order(std::span<const triple> s, std::span<const triple> t) const {
    return sign_of_sum(volume_difference<integer, coefficients>(
        s, t, [this](plane_id i) { return plane(i).n; },
        [this](coefficients& sum, const triple& p, const lawrence_minors<integer>& minors, int factor) {
          const auto& m = minors.m;
          add_cube(sum, p, m, rational(-factor, minors.det * m[0] * m[1] * m[2]));
        }));
  }

 private:
  // Of the root of the product of the radicands of some planes; -1 stands for none.
  struct coefficients : std::map<triple, rational> {
    explicit coefficients(int) {}
  };

  // Adds factor * (sum m_r w_r sqrt(s_r))^3.
  void add_cube(coefficients& sum, const triple& abc, const std::array<integer, 3>& m, const rational& factor) const {
    std::array<integer, 3> c;
    std::array<integer, 3> square;  // (c_r sqrt(s_r))^2
    for (int r = 0; r < 3; ++r) {
      c[r] = m[r] * plane(abc[r]).weight;
      square[r] = c[r] * c[r] * this->dot(abc[r], abc[r]);
    }
    for (int r = 0; r < 3; ++r) sum[{abc[r], -1, -1}] += factor * rational(c[r] * (square[r] + 3 * square[(r + 1) % 3] + 3 * square[(r + 2) % 3]));
    sum[sorted(abc)] += factor * rational(6 * c[0] * c[1] * c[2]);
  }

  sign sign_of_sum(const coefficients& sum) const {
    integer common = 1;
    for (const auto& [planes, c] : sum) common = lcm(common, denominator(c));
    struct term {
      int plane;
      integer coefficient;
    };
    square_classes products;
    std::vector<term> terms;
    for (const auto& [planes, c] : sum) {
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

/// The arithmetic of exact speeds in space.
using sqrt_arithmetic = basic_sqrt_arithmetic<3>;
/// The square-root kernel of space.
using sqrt_kernel = arithmetic_kernel<sqrt_arithmetic>;
/// The square-root kernel of the plane.
using planar_sqrt_kernel = arithmetic_kernel<basic_sqrt_arithmetic<2>>;

/// Returns the exact kernel of these planes, which it copies.
inline sqrt_kernel make_sqrt_kernel(std::span<const moving_plane<integer>> planes) { return sqrt_kernel(sqrt_arithmetic(planes)); }
/// Returns the exact kernel of these lines, which it copies.
inline planar_sqrt_kernel make_sqrt_kernel(std::span<const moving_line<integer>> lines) {
  return planar_sqrt_kernel(basic_sqrt_arithmetic<2>(lines));
}

}  // namespace osteon
