// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Every predicate of the kernels, in the plane and in space, by CGAL's CORE::Expr, whose square roots are exact and
/// whose zero test is a root bound. Shares no formula with the kernels: determinants are sums over permutations, times
/// quotients, vertices come from Cramer's rule, volumes from tetrahedra, coefficients of the infinitesimal from polynomials.

#include <CGAL/CORE_BigInt.h>
#include <CGAL/CORE_Expr.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbation.hpp"

namespace osteon::oracles {

/// The planes n . x = d - t w |n| in a space of dimension D.
template <int D>
class core_signs {
 public:
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;

  explicit core_signs(std::span<const moving_plane<integer, D>> planes) {
    std::map<integer, CORE::Expr> roots;  // one number for equal lengths keeps root bounds small
    for (const auto& p : planes) {
      plane made;
      integer square = 0;
      for (std::size_t axis = 0; axis < D; ++axis) {
        square += p.n[axis] * p.n[axis];
        made.n[axis] = number(p.n[axis]);
      }
      square *= p.weight * p.weight;
      const auto [at, fresh] = roots.try_emplace(square);
      if (fresh) at->second = CORE::sqrt(CORE::Expr(number(square)));
      made.d = number(p.d);
      made.sigma = at->second;
      planes_.push_back(made);
    }
  }

  sign orientation(const corner& c) const { return of(determinant(normals(c))); }

  /// Sign of S, planes in this order.
  sign closing(const support& q) const { return of(speed(q)); }

  /// Order of the times of two meetings, which must exist.
  sign compare(const support& q, const support& r) const { return of(time(q) - time(r)); }

  /// Order of the time of a meeting and a time just after zero.
  sign compare_with_start(const support& q) const { return of(time(q)) == sign::positive ? sign::positive : sign::negative; }

  /// The corner against plane d when the planes of q meet.
  sign side(plane_id d, const corner& c, const support& q) const {
    const auto h = height(d, c);
    return of(CORE::Expr(h.now) - time(q) * h.loss) * h.orientation;
  }

  /// The same just after the beginning, for planes that share a point at the beginning.
  sign side_at_start(plane_id d, const corner& c) const {
    const auto h = height(d, c);
    return of(CORE::Expr(0) - h.loss) * h.orientation;
  }

  // ---- in space

  /// Order of the angles between the normals of a and b and of c and d.
  sign compare_angles(plane_id a, plane_id b, plane_id c, plane_id d) const requires(D == 3) {
    const auto cosine = [this](plane_id i, plane_id j) {
      return CORE::Expr(dot(n(i), n(j))) / CORE::sqrt(CORE::Expr(dot(n(i), n(i)) * dot(n(j), n(j))));
    };
    return of(cosine(c, d) - cosine(a, b));
  }

  /// Order of the volumes that two triangulations of one cycle of planes through a point leave at time 1. With T(i,j,k) what a corner
  /// adds to a volume, T(abc) - T(abd) + T(acd) - T(bcd) is the volume of a tetrahedron with the sign of the orientation,
  /// -S^3 / (6 product of the lambdas); so every triangle can be replaced by three with one plane in common and a tetrahedron, and the
  /// three add up to the same for both triangulations. Nothing where some lambda is zero.
  std::optional<sign> compare_volume(std::span<const triple> s, std::span<const triple> t) const requires(D == 3) {
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

  sign orientation_at(int grade, const corner& c) const { return of(at(minor(c), grade)); }
  sign offset_at(int grade, const support& q) const { return of(at(tilted_offset(q), grade)); }
  sign closing_at(int grade, const support& q) const { return of(tilted_speed(q, grade)); }
  sign cross_at(int grade, const support& q, const support& r) const {
    const polynomial d = tilted_offset(q);
    const polynomial e = tilted_offset(r);
    CORE::Expr sum = 0;
    for (int g = 0; g <= grade; ++g) sum += CORE::Expr(at(d, grade - g)) * tilted_speed(r, g) - CORE::Expr(at(e, grade - g)) * tilted_speed(q, g);
    return of(sum);
  }

 private:
  using vector = std::array<CORE::BigInt, D>;
  using matrix = std::array<vector, D>;
  using polynomial = std::vector<CORE::BigInt>;
  struct plane {
    vector n;
    CORE::BigInt d;
    CORE::Expr sigma;
  };
  struct moving_height {  // now - t loss, times the sign of the corner's orientation
    CORE::BigInt now;
    CORE::Expr loss;
    sign orientation;
  };

  static CORE::BigInt number(const integer& x) { return CORE::BigInt(x.backend().data()); }
  static sign of(const CORE::Expr& x) { return sign_of(x.sign()); }
  static sign of(const CORE::BigInt& x) { return sign_of(CORE::sign(x)); }

  const vector& n(plane_id i) const { return planes_[static_cast<std::size_t>(i)].n; }
  const CORE::BigInt& d(plane_id i) const { return planes_[static_cast<std::size_t>(i)].d; }
  const CORE::Expr& sigma(plane_id i) const { return planes_[static_cast<std::size_t>(i)].sigma; }

  static CORE::BigInt dot(const vector& a, const vector& b) {
    CORE::BigInt sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += a[axis] * b[axis];
    return sum;
  }

  // Calls visit(order, factor) for all permutations of the axes; the factor is the permutation's sign.
  template <class Visit>
  static void for_each_permutation(Visit visit) {
    std::array<std::size_t, D> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      int inversions = 0;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
      visit(order, inversions % 2 == 0 ? 1 : -1);
    } while (std::next_permutation(order.begin(), order.end()));
  }

  static CORE::BigInt determinant(const matrix& m) {  // Leibniz
    CORE::BigInt sum = 0;
    for_each_permutation([&](const auto& order, int factor) {
      CORE::BigInt product = factor;
      for (std::size_t row = 0; row < D; ++row) product *= m[row][order[row]];
      sum += product;
    });
    return sum;
  }

  matrix normals(const corner& c) const {
    matrix m;
    for (std::size_t r = 0; r < D; ++r) m[r] = n(c[r]);
    return m;
  }

  // The planes without number r, and the sign of their minor in the last column of the matrix with rows (n, *).
  static std::pair<corner, int> cofactor(const support& q, std::size_t r) {
    corner c{};
    for (std::size_t s = 0, k = 0; s <= D; ++s)
      if (s != r) c[k++] = q[s];
    return {c, (r + D) % 2 == 0 ? 1 : -1};
  }

  std::array<CORE::BigInt, D + 1> lambda(const support& q) const {
    std::array<CORE::BigInt, D + 1> result;
    for (std::size_t r = 0; r <= D; ++r) {
      const auto [c, factor] = cofactor(q, r);
      result[r] = determinant(normals(c)) * CORE::BigInt(factor);
    }
    return result;
  }

  CORE::Expr speed(const support& q) const {
    const auto l = lambda(q);
    CORE::Expr sum = 0;
    for (std::size_t r = 0; r <= D; ++r) sum += CORE::Expr(l[r]) * sigma(q[r]);
    return sum;
  }

  CORE::Expr time(const support& q) const {
    const auto [at, fresh] = times_.try_emplace(q);
    if (fresh) {
      const auto l = lambda(q);
      CORE::BigInt offset = 0;
      for (std::size_t r = 0; r <= D; ++r) offset += l[r] * d(q[r]);
      at->second = CORE::Expr(offset) / speed(q);
    }
    return at->second;
  }

  // The corner is x = sum (d_r - t sigma_r) y_r / det, where y_r is the vector with n . y_r = the determinant with n in row r.
  moving_height height(plane_id above, const corner& c) const {
    const matrix m = normals(c);
    const CORE::BigInt det = determinant(m);
    moving_height h{det * d(above), CORE::Expr(det) * sigma(above), of(det)};
    for (std::size_t r = 0; r < D; ++r) {
      matrix replaced = m;
      replaced[r] = n(above);
      const CORE::BigInt share = determinant(replaced);
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

  polynomial minor(const corner& c) const {
    polynomial sum;
    for_each_permutation([&](const auto& order, int factor) {
      polynomial term = {CORE::BigInt(1)};
      for (std::size_t row = 0; row < D; ++row) term = product(term, entry(c[row], order[row]));
      add(sum, term, factor);
    });
    return sum;
  }

  std::array<polynomial, D + 1> tilted_lambda(const support& q) const {
    std::array<polynomial, D + 1> result;
    for (std::size_t r = 0; r <= D; ++r) {
      const auto [c, factor] = cofactor(q, r);
      add(result[r], minor(c), factor);
    }
    return result;
  }

  polynomial tilted_offset(const support& q) const {
    const auto l = tilted_lambda(q);
    polynomial sum;
    for (std::size_t r = 0; r <= D; ++r) add(sum, product(l[r], {d(q[r]), CORE::BigInt(perturbation::of(q[r]).delta)}), 1);
    return sum;
  }

  CORE::Expr tilted_speed(const support& q, int grade) const {
    const auto l = tilted_lambda(q);
    CORE::Expr sum = 0;
    for (std::size_t r = 0; r <= D; ++r)
      if (const CORE::BigInt c = at(l[r], grade); CORE::sign(c) != 0) sum += CORE::Expr(c) * sigma(q[r]);
    return sum;
  }

  std::vector<plane> planes_;
  mutable std::map<support, CORE::Expr> times_;
};

}  // namespace osteon::oracles
