// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The predicates' formulas, written once for every number type (design 01, and 04 for the grades). A policy
/// `Arithmetic` supplies numbers and says what the sign of a number and of a linear form in the speeds is.

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/kernel.hpp"
#include "osteon/sign.hpp"

namespace osteon {

/// The symbolic perturbation of a plane: n + e^2 u, d + e delta. Fixed for a plane's number, so every run and every
/// kernel perturbs alike. Twenty bits keep small exact inputs exact in double precision.
struct perturbation {
  std::array<int, 3> u;
  int delta;

  static perturbation of(plane_id id) {
    std::uint64_t seed = static_cast<std::uint64_t>(id) + 1;
    const auto draw = [&seed] {  // splitmix64 (Steele, Lea, Flood 2014)
      seed += 0x9E3779B97F4A7C15U;
      std::uint64_t z = seed;
      z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
      z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
      return static_cast<int>((z ^ z >> 31U) & 0xFFFFFU) - 0x80000;
    };
    perturbation p{};
    p.delta = draw();
    for (int& x : p.u) x = draw();
    return p;
  }
};

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

/// `Arithmetic` has: number (a ring), plane_count(), n(i, axis), d(i), u(i, axis), delta(i) giving numbers, and
/// decide(number), decide(linear_form) giving sign or optional<sign>.
template <class Arithmetic>
class formulas {
 public:
  using number = typename Arithmetic::number;
  using form = linear_form<number>;

  explicit formulas(Arithmetic a) : a_(std::move(a)) {}
  const Arithmetic& arithmetic() const { return a_; }

  /// Coefficient of e^(2m) in det(n_i, n_j, n_k). Remembered where numbers are long (at most 2^18 of them).
  number minor(int m, plane_id i, plane_id j, plane_id k) const {
    if constexpr (!remembers) {
      return compute_minor(m, i, j, k);
    } else {
      quadruple key = {i, j, k, m};
      std::sort(key.begin(), key.begin() + 3);
      if (minors_.size() > (1U << 18U)) minors_.clear();
      const auto [at, fresh] = minors_.try_emplace(key);
      if (fresh) at->second = compute_minor(m, key[0], key[1], key[2]);
      const int inversions = (i > j ? 1 : 0) + (i > k ? 1 : 0) + (j > k ? 1 : 0);
      return inversions % 2 == 0 ? at->second : number(-at->second);
    }
  }

  /// Coefficients of e^(2m) in the lambdas: the cofactors of the last column of the matrix with rows (n_r, *).
  std::array<number, 4> lambda(int m, const quadruple& q) const {
    return {-minor(m, q[1], q[2], q[3]), minor(m, q[0], q[2], q[3]), -minor(m, q[0], q[1], q[3]), minor(m, q[0], q[1], q[2])};
  }

  /// Coefficient of e^grade in D.
  number offset(int grade, const quadruple& q) const {
    if (grade > 7) return number(0);
    const auto l = lambda(grade / 2, q);
    auto sum = number(0);
    for (int r = 0; r < 4; ++r) sum = sum + l[r] * (grade % 2 == 0 ? a_.d(q[r]) : a_.delta(q[r]));
    return sum;
  }

  /// Coefficient of e^grade in S.
  form speed(int grade, const quadruple& q) const {
    form f;
    if (grade % 2 != 0 || grade > 6) return f;
    const auto l = lambda(grade / 2, q);
    for (int r = 0; r < 4; ++r) f.add(q[r], l[r]);
    return f;
  }

  auto orientation_at(int grade, const triple& t) const {
    return a_.decide(grade % 2 != 0 || grade > 6 ? number(0) : minor(grade / 2, t[0], t[1], t[2]));
  }
  auto offset_at(int grade, const quadruple& q) const { return a_.decide(offset(grade, q)); }
  auto closing_at(int grade, const quadruple& q) const { return a_.decide(speed(grade, q)); }

  /// Sign of the coefficient of e^grade in D(q) S(r) - D(r) S(q): the order of two meeting times up to the signs of
  /// S(q), S(r), and a moving vertex against a plane up to the signs of S(r) and lambda.
  auto cross_at(int grade, const quadruple& q, const quadruple& r) const {
    form f;
    for (int g = 0; g <= grade && g <= 6; g += 2) {  // S has even grades up to 6, D all up to 7
      if (grade - g > 7) continue;
      accumulate(f, offset(grade - g, q), speed(g, r));
      accumulate(f, -offset(grade - g, r), speed(g, q));
    }
    return a_.decide(f);
  }

 private:
  static constexpr bool remembers = requires { typename Arithmetic::remembers_minors; };

  number compute_minor(int m, plane_id i, plane_id j, plane_id k) const {
    if (m == 0) return det(i, j, k, 0);
    auto sum = number(0);
    for (unsigned tilted = 1; tilted < 8; ++tilted)
      if (static_cast<int>((tilted & 1U) + (tilted >> 1U & 1U) + (tilted >> 2U)) == m) sum = sum + det(i, j, k, tilted);
    return sum;
  }

  number entry(plane_id p, int axis, bool tilted) const { return tilted ? a_.u(p, axis) : a_.n(p, axis); }

  number det(plane_id i, plane_id j, plane_id k, unsigned tilted) const {
    const bool ti = (tilted & 1U) != 0;
    const bool tj = (tilted & 2U) != 0;
    const bool tk = (tilted & 4U) != 0;
    const auto m = [&](int a, int b) { return entry(j, a, tj) * entry(k, b, tk) - entry(j, b, tj) * entry(k, a, tk); };
    return entry(i, 0, ti) * m(1, 2) + entry(i, 1, ti) * m(2, 0) + entry(i, 2, ti) * m(0, 1);
  }

  static void accumulate(form& f, const number& factor, const form& s) {
    for (int t = 0; t < s.size; ++t) f.add(s.terms[t].plane, factor * s.terms[t].coefficient);
  }

  struct nothing {};
  Arithmetic a_;
  [[no_unique_address]] mutable std::conditional_t<remembers, std::unordered_map<quadruple, number, plane_hash>, nothing> minors_;
};

}  // namespace osteon
