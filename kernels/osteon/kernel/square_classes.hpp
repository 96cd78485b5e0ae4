// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Exact signs of linear forms  sum c_i w_i sqrt(s_i)  with integers c_i, w_i and s_i > 0
/// (docs/theory/numbers-and-predicates.md).

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// Roots of integers, grouped by square class: sqrt(a)/sqrt(b) is rational iff a*b is a square, and
/// roots of different classes are linearly independent over the rationals. So a form is zero iff
/// every class's rational coefficients add up to zero, and a form that is not zero has its sign
/// found by finite refinement.
class square_classes {
 public:
  /// Adds weight * sqrt(s) and returns its number.
  /// *Requires* s > 0. *Complexity* the residue symbols of s, then a test for a perfect square for
  /// each known class with the same symbols, hardly ever more than one.
  int add(const integer& s, const integer& weight = 1) {
    root r{s, weight, find_class(s), 0, {}};
    const integer& base = representatives_[r.square_class];
    r.ratio = rational(isqrt(s * base) * weight, base);
    for (int level = 0; level < cached; ++level) r.refined[level] = refine(r, bits(level));
    roots_.push_back(std::move(r));
    return static_cast<int>(roots_.size()) - 1;
  }

  /// Returns s of a root.
  const integer& radicand(int i) const { return roots_[i].s; }
  /// Returns the weight of a root.
  const integer& weight(int i) const { return roots_[i].weight; }

  /// Returns floor(weight * sqrt(s) * 2^precision).
  integer scaled(int i, unsigned precision) const { return refine(roots_[i], precision); }

  /// Returns floor(weight * sqrt(s) * 2^128), which is at hand.
  const integer& refined(int i) const { return roots_[i].refined[1]; }

  /// Returns whether sqrt(s) is an integer.
  bool is_integer(int i) const { return is_square(roots_[i].s); }

  /// Returns the exact sign of sum c_i root_i over `size` terms, each with a `coefficient` and, as
  /// `plane`, the number of a root. *Complexity* roots rounded to 64 bits after the point decide
  /// nearly always; a form that is zero needs its classes, any other one some more bits.
  template <class Terms>
  sign sign_of_form(const Terms& terms, int size) const {
    if (size == 0) return sign::zero;
    for (int level = 0;; ++level) {
      integer sum = 0;
      integer error = 0;  // each rounded root is less than 1 too small
      for (int i = 0; i < size; ++i) {
        const auto& t = terms[i];
        const root& r = roots_[t.plane];
        sum += t.coefficient * (level < cached ? r.refined[level] : refine(r, bits(level)));
        error += abs(t.coefficient);
      }
      if (abs(sum) >= error && sum != 0) return osteon::sign_of(sum);
      if (level == 0 && is_zero(terms, size)) return sign::zero;
    }
  }

 private:
  static constexpr int cached = 2;
  struct root {
    integer s;
    integer weight;
    int square_class;
    rational ratio;  // weight * sqrt(s) / sqrt(representative)
    std::array<integer, cached> refined;
  };

  static unsigned bits(int level) { return 64U << level; }

  static integer refine(const root& r, unsigned precision) { return isqrt((r.s * r.weight * r.weight) << (2 * precision)); }

  // The class of s, made new if there is none. Numbers of one class have equal Kronecker symbols
  // for every modulus, unless a symbol is zero (s shares a factor with the modulus); such an s is
  // compared with all classes.
  int find_class(const integer& s) {
    // Primes 2^64 - k and 2^32 - k.
    static constexpr std::array<std::uint32_t, 10> below_2_64 = {59, 83, 95, 179, 189, 257, 279, 323, 353, 363};
    static constexpr std::array<std::uint32_t, 10> below_2_32 = {5, 17, 65, 99, 107, 135, 153, 185, 209, 267};
    std::uint64_t symbols = 0;
    bool wild = false;
    const auto ask = [&](std::uint64_t modulus) {
      const int symbol = mpz_kronecker_ui(s.backend().data(), modulus);
      wild = wild || symbol == 0;
      symbols = symbols << 1U | (symbol < 0 ? 1U : 0U);
    };
    for (const auto k : below_2_64) ask(std::uint64_t{0} - k);
    for (const auto k : below_2_32) ask((std::uint64_t{1} << 32U) - k);

    const auto among = [&](const std::vector<int>& candidates) {
      for (const int c : candidates)
        if (is_square(s * representatives_[c])) return c;
      return -1;
    };
    int found = among(wild ? all_ : classes_[symbols]);
    if (found < 0 && !wild) found = among(wild_);
    if (found >= 0) return found;
    const int made = static_cast<int>(representatives_.size());
    representatives_.push_back(s);
    all_.push_back(made);
    (wild ? wild_ : classes_[symbols]).push_back(made);
    return made;
  }

  template <class Terms>
  bool is_zero(const Terms& terms, int size) const {
    std::vector<bool> done(size);
    for (int i = 0; i < size; ++i) {
      if (done[i]) continue;
      rational sum = 0;
      for (int j = i; j < size; ++j)
        if (roots_[terms[j].plane].square_class == roots_[terms[i].plane].square_class) {
          sum += rational(terms[j].coefficient) * roots_[terms[j].plane].ratio;
          done[j] = true;
        }
      if (sum != 0) return false;
    }
    return true;
  }

  std::vector<root> roots_;
  std::vector<integer> representatives_;
  std::unordered_map<std::uint64_t, std::vector<int>> classes_;  // by symbols, but for the wild
  std::vector<int> wild_;
  std::vector<int> all_;
};

}  // namespace osteon
