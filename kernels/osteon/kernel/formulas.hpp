// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The formulas of the predicates, written once for every number type and dimension
/// (docs/theory/numbers-and-predicates.md; docs/theory/degeneracy.md for the grades).

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/kernel/determinant.hpp"

namespace osteon {

/// Sorts planes in place; returns the sign of the permutation that does it.
/// *Requires* different planes. *Complexity* quadratic, for the few planes of a meeting.
inline sign sort_with_parity(std::span<plane_id> planes) {
  sign parity = sign::positive;
  for (std::size_t i = 1; i < planes.size(); ++i)
    for (std::size_t j = i; j > 0 && planes[j - 1] > planes[j]; --j) {
      std::swap(planes[j - 1], planes[j]);
      parity = -parity;
    }
  return parity;
}

/// Returns the sign of the permutation that sorts different planes.
template <std::size_t N>
sign parity(std::array<plane_id, N> planes) {
  return sort_with_parity(planes);
}

/// A linear form  sum c_i sigma_i  in the speeds of at most eight planes, those of two meetings.
template <class Number>
struct linear_form {
  /// A plane's speed with its coefficient.
  struct term {
    plane_id plane;
    Number coefficient;
  };
  std::array<term, 8> terms;
  int size = 0;

  /// Adds c * sigma_plane. Terms of one plane are merged, so that cancellation is seen.
  void add(plane_id plane, const Number& c) {
    for (int i = 0; i < size; ++i)
      if (terms[i].plane == plane) {
        terms[i].coefficient = terms[i].coefficient + c;
        return;
      }
    terms[size++] = {plane, c};
  }
};

/// The formulas over the numbers of some planes. `Arithmetic` has:
///  - dimension, 2 or 3, and number, the type of a ring, made from int;
///  - n(i, axis), d(i), u(i, axis), delta(i): the numbers of plane i and of its perturbation;
///  - decide(number) and decide(linear_form<number>): their sign, or an optional sign. The
///    functions below that end in _at return what decide returns;
///  - optionally a type remembers_minors: then minors are kept, which pays where numbers are long.
template <class Arithmetic>
class formulas {
 public:
  static constexpr int dimension = Arithmetic::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;
  using number = typename Arithmetic::number;
  using form = linear_form<number>;

  explicit formulas(Arithmetic a) : a_(std::move(a)) {}
  /// Returns the numbers that the formulas are about.
  const Arithmetic& arithmetic() const { return a_; }

  /// Returns the coefficient of e^(2m) in the determinant of a corner's normals.
  number minor(int m, const corner& c) const {
    if constexpr (!remembers) {
      return compute_minor(m, c);
    } else {
      support key{};
      std::copy(c.begin(), c.end(), key.begin());
      const sign order = sort_with_parity(std::span(key).template first<dimension>());
      key.back() = m;
      if (minors_.size() > most_remembered) minors_.clear();
      const auto [at, fresh] = minors_.try_emplace(key);
      if (fresh) {
        corner sorted{};
        std::copy_n(key.begin(), dimension, sorted.begin());
        at->second = compute_minor(m, sorted);
      }
      return order == sign::positive ? at->second : number(-at->second);
    }
  }

  /// Returns the coefficients of e^(2m) in the lambdas of a meeting.
  std::array<number, dimension + 1> lambda(int m, const support& q) const {
    return lambdas(q, [&](auto... planes) { return minor(m, {planes...}); });
  }

  /// Returns the coefficient of e^grade in D.
  number offset(int grade, const support& q) const {
    if (grade > 2 * dimension + 1) return number(0);
    const auto l = lambda(grade / 2, q);
    auto sum = number(0);
    for (int r = 0; r <= dimension; ++r) sum = sum + l[r] * (grade % 2 == 0 ? a_.d(q[r]) : a_.delta(q[r]));
    return sum;
  }

  /// Returns the coefficient of e^grade in S.
  form speed(int grade, const support& q) const {
    form f;
    if (grade % 2 != 0 || grade > 2 * dimension) return f;
    const auto l = lambda(grade / 2, q);
    for (int r = 0; r <= dimension; ++r) f.add(q[r], l[r]);
    return f;
  }

  /// Decides the coefficient of e^grade in the determinant of a corner's normals.
  auto orientation_at(int grade, const corner& c) const {
    return a_.decide(grade % 2 != 0 || grade > 2 * dimension ? number(0) : minor(grade / 2, c));
  }
  /// Decides the coefficient of e^grade in D.
  auto offset_at(int grade, const support& q) const { return a_.decide(offset(grade, q)); }
  /// Decides the coefficient of e^grade in S.
  auto closing_at(int grade, const support& q) const { return a_.decide(speed(grade, q)); }

  /// Decides the coefficient of e^grade in D(q) S(r) - D(r) S(q): the order of the times of two
  /// meetings up to the signs of S(q) and S(r), and a moving vertex against a plane up to those of
  /// S(r) and lambda.
  auto cross_at(int grade, const support& q, const support& r) const {
    form f;
    for (int g = 0; g <= grade && g <= 2 * dimension; g += 2) {  // S has even grades only
      if (grade - g > 2 * dimension + 1) continue;
      accumulate(f, offset(grade - g, q), speed(g, r));
      accumulate(f, -offset(grade - g, r), speed(g, q));
    }
    return a_.decide(f);
  }

 private:
  static constexpr bool remembers = requires { typename Arithmetic::remembers_minors; };
  static constexpr std::size_t most_remembered = 1U << 18U;

  // A determinant is linear in each row: the sum over all choices of m rows that are tilted.
  number compute_minor(int m, const corner& c) const {
    if (m == 0) return determinant<dimension>([&](int row, int axis) -> decltype(auto) { return a_.n(c[row], axis); });
    auto sum = number(0);
    for (unsigned tilted = 1; tilted < 1U << static_cast<unsigned>(dimension); ++tilted)
      if (std::popcount(tilted) == m)
        sum = sum + determinant<dimension>([&](int row, int axis) {
                return (tilted >> static_cast<unsigned>(row) & 1U) != 0 ? a_.u(c[row], axis) : a_.n(c[row], axis);
              });
    return sum;
  }

  static void accumulate(form& f, const number& factor, const form& s) {
    for (int t = 0; t < s.size; ++t) f.add(s.terms[t].plane, factor * s.terms[t].coefficient);
  }

  struct nothing {};
  Arithmetic a_;
  [[no_unique_address]] mutable std::conditional_t<remembers, std::unordered_map<support, number, plane_hash>, nothing> minors_;
};

}  // namespace osteon
