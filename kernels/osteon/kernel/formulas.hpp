// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The predicates' formulas, written once for every number type (design 01, and 04 for the grades). A policy
/// `Arithmetic` supplies numbers and says what the sign of a number and of a linear form in the speeds is.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/random.hpp"
#include "osteon/core/sign.hpp"

namespace osteon {

/// The symbolic perturbation of a plane: n + e^2 u, d + e delta. Fixed for a plane's number, so every run and every
/// kernel perturbs alike. Twenty bits keep small exact inputs exact in double precision.
struct perturbation {
  std::array<int, 3> u;
  int delta;

  static perturbation of(plane_id id) {
    random_stream random(static_cast<std::uint64_t>(id) + 1);
    const auto draw = [&random] { return static_cast<int>(random() & 0xFFFFFU) - 0x80000; };
    perturbation p{};
    p.delta = draw();
    for (int& x : p.u) x = draw();
    return p;
  }
};

/// Sorts planes; the sign of the permutation that does it.
inline sign sort_with_parity(std::span<plane_id> planes) {
  sign parity = sign::positive;
  for (std::size_t i = 1; i < planes.size(); ++i)
    for (std::size_t j = i; j > 0 && planes[j - 1] > planes[j]; --j) {
      std::swap(planes[j - 1], planes[j]);
      parity = -parity;
    }
  return parity;
}

/// A linear form sum c_i sigma_i over at most eight planes.
template <class Number>
struct linear_form {
  struct term {
    plane_id plane;
    Number coefficient;
  };
  std::array<term, 8> terms;
  int size = 0;

  /// Adds c * sigma_plane; terms of one plane are merged, so that cancellation is seen.
  void add(plane_id plane, const Number& c) {
    for (int i = 0; i < size; ++i)
      if (terms[i].plane == plane) {
        terms[i].coefficient = terms[i].coefficient + c;
        return;
      }
    terms[size++] = {plane, c};
  }
};

/// `Arithmetic` has: dimension (2 or 3), number (a ring), n(i, axis), d(i), u(i, axis), delta(i) giving numbers, and
/// decide(number), decide(linear_form) giving sign or optional<sign>.
template <class Arithmetic>
class formulas {
 public:
  static constexpr int dimension = Arithmetic::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;
  using number = typename Arithmetic::number;
  using form = linear_form<number>;

  explicit formulas(Arithmetic a) : a_(std::move(a)) {}
  const Arithmetic& arithmetic() const { return a_; }

  /// Coefficient of e^(2m) in the determinant of normals. Remembered where numbers are long (at most 2^18 of them).
  number minor(int m, const corner& c) const {
    if constexpr (!remembers) {
      return compute_minor(m, c);
    } else {
      support key{};
      std::copy(c.begin(), c.end(), key.begin());
      const sign order = sort_with_parity(std::span(key).template first<dimension>());
      key.back() = m;
      if (minors_.size() > (1U << 18U)) minors_.clear();
      const auto [at, fresh] = minors_.try_emplace(key);
      if (fresh) {
        corner sorted{};
        std::copy_n(key.begin(), dimension, sorted.begin());
        at->second = compute_minor(m, sorted);
      }
      return order == sign::positive ? at->second : number(-at->second);
    }
  }

  /// Coefficients of e^(2m) in the lambdas: the cofactors of the last column of the matrix with rows (n_r, *).
  std::array<number, dimension + 1> lambda(int m, const support& q) const {
    if constexpr (dimension == 2)
      return {minor(m, {q[1], q[2]}), -minor(m, {q[0], q[2]}), minor(m, {q[0], q[1]})};
    else
      return {-minor(m, {q[1], q[2], q[3]}), minor(m, {q[0], q[2], q[3]}), -minor(m, {q[0], q[1], q[3]}), minor(m, {q[0], q[1], q[2]})};
  }

  /// Coefficient of e^grade in D.
  number offset(int grade, const support& q) const {
    if (grade > 2 * dimension + 1) return number(0);
    const auto l = lambda(grade / 2, q);
    auto sum = number(0);
    for (int r = 0; r <= dimension; ++r) sum = sum + l[r] * (grade % 2 == 0 ? a_.d(q[r]) : a_.delta(q[r]));
    return sum;
  }

  /// Coefficient of e^grade in S.
  form speed(int grade, const support& q) const {
    form f;
    if (grade % 2 != 0 || grade > 2 * dimension) return f;
    const auto l = lambda(grade / 2, q);
    for (int r = 0; r <= dimension; ++r) f.add(q[r], l[r]);
    return f;
  }

  auto orientation_at(int grade, const corner& c) const {
    return a_.decide(grade % 2 != 0 || grade > 2 * dimension ? number(0) : minor(grade / 2, c));
  }
  auto offset_at(int grade, const support& q) const { return a_.decide(offset(grade, q)); }
  auto closing_at(int grade, const support& q) const { return a_.decide(speed(grade, q)); }

  /// Sign of the coefficient of e^grade in D(q) S(r) - D(r) S(q): the order of two meeting times up to the signs of
  /// S(q), S(r), and a moving vertex against a plane up to the signs of S(r) and lambda.
  auto cross_at(int grade, const support& q, const support& r) const {
    form f;
    for (int g = 0; g <= grade && g <= 2 * dimension; g += 2) {  // S has even grades up to 6 in space, D all up to 7
      if (grade - g > 2 * dimension + 1) continue;
      accumulate(f, offset(grade - g, q), speed(g, r));
      accumulate(f, -offset(grade - g, r), speed(g, q));
    }
    return a_.decide(f);
  }

 private:
  static constexpr bool remembers = requires { typename Arithmetic::remembers_minors; };

  number compute_minor(int m, const corner& c) const {
    if (m == 0) return det([&](int row, int axis) { return a_.n(c[row], axis); });
    auto sum = number(0);
    for (unsigned tilted = 1; tilted < 1U << static_cast<unsigned>(dimension); ++tilted)
      if (std::popcount(tilted) == m)
        sum =
            sum + det([&](int row, int axis) { return (tilted >> static_cast<unsigned>(row) & 1U) != 0 ? a_.u(c[row], axis) : a_.n(c[row], axis); });
    return sum;
  }

  // The determinant of the entries at(row, axis).
  template <class At>
  static number det(At at) {
    if constexpr (dimension == 2) {
      return at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
    } else {
      const auto m = [&](int a, int b) { return at(1, a) * at(2, b) - at(1, b) * at(2, a); };
      return at(0, 0) * m(1, 2) + at(0, 1) * m(2, 0) + at(0, 2) * m(0, 1);
    }
  }

  static void accumulate(form& f, const number& factor, const form& s) {
    for (int t = 0; t < s.size; ++t) f.add(s.terms[t].plane, factor * s.terms[t].coefficient);
  }

  struct nothing {};
  Arithmetic a_;
  [[no_unique_address]] mutable std::conditional_t<remembers, std::unordered_map<support, number, plane_hash>, nothing> minors_;
};

}  // namespace osteon
