// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Every predicate of the kernels by CGAL's CORE::Expr, whose square roots are exact and whose zero test is a root bound.
/// Shares no formula with the kernels: times are quotients, vertices come from Cramer's rule, volumes from tetrahedra,
/// coefficients of the infinitesimal from polynomials.

#include <CGAL/CORE_BigInt.h>
#include <CGAL/CORE_Expr.h>

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbation.hpp"

namespace osteon::oracles {

/// The planes n . x = d - t w |n|.
class core_signs {
 public:
  explicit core_signs(std::span<const moving_plane<integer>> planes) {
    std::map<integer, CORE::Expr> roots;  // one number for equal lengths keeps root bounds small
    for (const auto& p : planes) {
      const integer square = p.weight * p.weight * (p.n[0] * p.n[0] + p.n[1] * p.n[1] + p.n[2] * p.n[2]);
      const auto [at, fresh] = roots.try_emplace(square);
      if (fresh) at->second = CORE::sqrt(CORE::Expr(number(square)));
      planes_.push_back({{number(p.n[0]), number(p.n[1]), number(p.n[2])}, number(p.d), at->second});
    }
  }

  sign orientation(plane_id a, plane_id b, plane_id c) const { return of(determinant(n(a), n(b), n(c))); }

  /// Sign of S, planes in this order.
  sign closing(const quadruple& q) const { return of(speed(q)); }

  /// Order of the times of two meetings, which must exist.
  sign compare(const quadruple& q, const quadruple& r) const { return of(time(q) - time(r)); }

  /// Order of the time of a meeting and a moment just after zero.
  sign compare_with_start(const quadruple& q) const { return of(time(q)) == sign::positive ? sign::positive : sign::negative; }

  /// The corner (a,b,c) against plane d when the planes of q meet.
  sign side(plane_id d, const triple& corner, const quadruple& q) const {
    const auto h = height(d, corner);
    return of(CORE::Expr(h.now) - time(q) * h.loss) * h.corner;
  }

  /// The same just after the beginning, for planes that share a point at the beginning.
  sign side_at_start(plane_id d, const triple& corner) const {
    const auto h = height(d, corner);
    return of(CORE::Expr(0) - h.loss) * h.corner;
  }

  /// Order of the angles between the normals of a and b and of c and d.
  sign compare_angles(plane_id a, plane_id b, plane_id c, plane_id d) const {
    const auto cosine = [this](plane_id i, plane_id j) {
      return CORE::Expr(dot(n(i), n(j))) / CORE::sqrt(CORE::Expr(dot(n(i), n(i)) * dot(n(j), n(j))));
    };
    return of(cosine(c, d) - cosine(a, b));
  }

  /// Order of the volumes that two triangulations of one cycle of planes through a point leave at time 1. With T(i,j,k) what a corner
  /// adds to a volume, T(abc) - T(abd) + T(acd) - T(bcd) is the volume of a tetrahedron with the sign of the orientation,
  /// -S^3 / (6 product of the lambdas); so every triangle can be replaced by three with one plane in common and a tetrahedron, and the
  /// three add up to the same for both triangulations. Nothing where some lambda is zero.
  std::optional<sign> compare_volume(std::span<const triple> s, std::span<const triple> t) const {
    const plane_id common = s[0][0];
    CORE::Expr difference = 0;
    for (const auto& [tree, factor] : {std::pair(s, 1), std::pair(t, -1)})
      for (const triple& c : tree) {
        if (c[0] == common || c[1] == common || c[2] == common) continue;
        const quadruple q = {c[0], c[1], c[2], common};
        CORE::BigInt product = 6;
        for (const auto& l : lambda(q)) product *= l;
        if (CORE::sign(product) == 0) return std::nullopt;
        const CORE::Expr speed_of_q = speed(q);
        difference -= speed_of_q * speed_of_q * speed_of_q * CORE::Expr(factor) / CORE::Expr(product);
      }
    return of(difference);
  }

  // ---- coefficients of e^grade for the planes n + e^2 u, d + e delta

  sign orientation_at(int grade, const triple& t) const { return of(at(minor(t), grade)); }
  sign offset_at(int grade, const quadruple& q) const { return of(at(tilted_offset(q), grade)); }
  sign closing_at(int grade, const quadruple& q) const { return of(tilted_speed(q, grade)); }
  sign cross_at(int grade, const quadruple& q, const quadruple& r) const {
    const polynomial d = tilted_offset(q);
    const polynomial e = tilted_offset(r);
    CORE::Expr sum = 0;
    for (int g = 0; g <= grade; ++g) sum += CORE::Expr(at(d, grade - g)) * tilted_speed(r, g) - CORE::Expr(at(e, grade - g)) * tilted_speed(q, g);
    return of(sum);
  }

 private:
  using vector = std::array<CORE::BigInt, 3>;
  using polynomial = std::vector<CORE::BigInt>;
  struct plane {
    vector n;
    CORE::BigInt d;
    CORE::Expr sigma;
  };
  struct moving_height {  // now - t loss, times the sign of the corner
    CORE::BigInt now;
    CORE::Expr loss;
    sign corner;
  };

  static CORE::BigInt number(const integer& x) { return CORE::BigInt(x.backend().data()); }
  static sign of(const CORE::Expr& x) { return sign_of(x.sign()); }
  static sign of(const CORE::BigInt& x) { return sign_of(CORE::sign(x)); }

  const vector& n(plane_id i) const { return planes_[static_cast<std::size_t>(i)].n; }
  const CORE::BigInt& d(plane_id i) const { return planes_[static_cast<std::size_t>(i)].d; }
  const CORE::Expr& sigma(plane_id i) const { return planes_[static_cast<std::size_t>(i)].sigma; }

  static CORE::BigInt dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static CORE::BigInt determinant(const vector& a, const vector& b, const vector& c) {  // Sarrus
    return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[1] * b[0] * c[2] - a[0] * b[2] * c[1];
  }

  // The cofactors of the last column of the matrix with rows (n, *).
  std::array<CORE::BigInt, 4> lambda(const quadruple& q) const {
    std::array<CORE::BigInt, 4> result;
    for (std::size_t r = 0; r < 4; ++r) {
      triple t{};
      for (std::size_t s = 0, k = 0; s < 4; ++s)
        if (s != r) t[k++] = q[s];
      result[r] = determinant(n(t[0]), n(t[1]), n(t[2]));
      if (r % 2 == 0) result[r] = -result[r];
    }
    return result;
  }

  CORE::Expr speed(const quadruple& q) const {
    const auto l = lambda(q);
    CORE::Expr sum = 0;
    for (std::size_t r = 0; r < 4; ++r) sum += CORE::Expr(l[r]) * sigma(q[r]);
    return sum;
  }

  CORE::Expr time(const quadruple& q) const {
    const auto [at, fresh] = times_.try_emplace(q);
    if (fresh) {
      const auto l = lambda(q);
      CORE::BigInt offset = 0;
      for (std::size_t r = 0; r < 4; ++r) offset += l[r] * d(q[r]);
      at->second = CORE::Expr(offset) / speed(q);
    }
    return at->second;
  }

  // The corner is x = sum (d_i - t sigma_i) n_j x n_k / det.
  moving_height height(plane_id above, const triple& c) const {
    const CORE::BigInt det = determinant(n(c[0]), n(c[1]), n(c[2]));
    moving_height h{det * d(above), CORE::Expr(det) * sigma(above), of(det)};
    for (std::size_t r = 0; r < 3; ++r) {
      const CORE::BigInt share = determinant(n(above), n(c[(r + 1) % 3]), n(c[(r + 2) % 3]));
      h.now -= share * d(c[r]);
      h.loss -= CORE::Expr(share) * sigma(c[r]);
    }
    return h;
  }

  static CORE::BigInt at(const polynomial& p, int power) {
    return static_cast<std::size_t>(power) < p.size() ? p[static_cast<std::size_t>(power)] : CORE::BigInt(0);
  }
  static polynomial product(const polynomial& a, const polynomial& b) {
    polynomial result(a.size() + b.size() - 1, CORE::BigInt(0));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    return result;
  }
  static void add(polynomial& sum, const polynomial& p, int factor) {
    sum.resize(std::max(sum.size(), p.size()), CORE::BigInt(0));
    for (std::size_t i = 0; i < p.size(); ++i) sum[i] += p[i] * CORE::BigInt(factor);
  }

  polynomial entry(plane_id p, std::size_t axis) const { return {n(p)[axis], CORE::BigInt(0), CORE::BigInt(perturbation::of(p).u[axis])}; }

  polynomial minor(const triple& t) const {
    static constexpr std::array<std::array<std::size_t, 3>, 6> orders = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {1, 0, 2}, {0, 2, 1}}};
    polynomial sum;
    for (std::size_t o = 0; o < 6; ++o)
      add(sum, product(product(entry(t[0], orders[o][0]), entry(t[1], orders[o][1])), entry(t[2], orders[o][2])), o < 3 ? 1 : -1);
    return sum;
  }

  std::array<polynomial, 4> tilted_lambda(const quadruple& q) const {
    std::array<polynomial, 4> result;
    for (std::size_t r = 0; r < 4; ++r) {
      triple t{};
      for (std::size_t s = 0, k = 0; s < 4; ++s)
        if (s != r) t[k++] = q[s];
      add(result[r], minor(t), r % 2 == 0 ? -1 : 1);
    }
    return result;
  }

  polynomial tilted_offset(const quadruple& q) const {
    const auto l = tilted_lambda(q);
    polynomial sum;
    for (std::size_t r = 0; r < 4; ++r) add(sum, product(l[r], {d(q[r]), CORE::BigInt(perturbation::of(q[r]).delta)}), 1);
    return sum;
  }

  CORE::Expr tilted_speed(const quadruple& q, int grade) const {
    const auto l = tilted_lambda(q);
    CORE::Expr sum = 0;
    for (std::size_t r = 0; r < 4; ++r)
      if (const CORE::BigInt c = at(l[r], grade); CORE::sign(c) != 0) sum += CORE::Expr(c) * sigma(q[r]);
    return sum;
  }

  std::vector<plane> planes_;
  mutable std::map<quadruple, CORE::Expr> times_;
};

}  // namespace osteon::oracles
