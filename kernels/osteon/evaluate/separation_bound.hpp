// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How far from zero a form  x = a + c_1 sqrt(s_1) + ... + c_N sqrt(s_N)  with integers a, c_r and
/// s_r >= 0 is if it is not zero; and rounding it to any number of correct bits. S of D + 1 planes
/// is such a form, with the squares of speeds for s, and so is L(t) q for a time t = p / q.
///
/// x lies in the field F that the N roots generate over the rationals. F is the splitting field of
/// the product of the polynomials X^2 - s_r, so it is a Galois extension; an automorphism of it is
/// given by the signs that it gives to the roots, so there are m <= 2^N of them. The image of x
/// under each is a + sum +- c_r sqrt(s_r), of absolute value at most
///
///     M = |a| + |c_1| sqrt(s_1) + ... + |c_N| sqrt(s_N).
///
/// The product of all images, the norm of x, is rational, because the automorphisms permute the
/// images; and it is an integer, because x is an algebraic integer. It is zero only if x is. So if
/// x is not zero, then 1 <= |x| M^(m - 1), hence M >= 1 and
///
///     |x| >= M^-(2^N - 1).
///
/// The kernels need no such bound: they recognise zero by square classes (see square_classes.hpp).
/// That pays where the same roots are asked for again and again.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>

#include "osteon/core/sign.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// A form a + sum c_r sqrt(s_r).
template <std::size_t N>
struct root_form {
  integer a;
  std::array<integer, N> c;
  std::array<integer, N> s;  ///< not negative

  /// Returns b such that the form is zero or its absolute value at least 2^-b.
  unsigned separation_bits() const {
    int most = bit_length(a);  // of a term: it is below 2^most
    for (std::size_t r = 0; r < N; ++r) most = std::max(most, bit_length(c[r]) + (bit_length(s[r]) + 1) / 2);
    const int bits = most + static_cast<int>(std::bit_width(N));  // N + 1 <= 2^bit_width(N) terms
    return ((1U << N) - 1) * static_cast<unsigned>(bits);
  }
};

/// A number in units of 2^-precision.
struct rounded_number {
  integer value;
  unsigned precision;
};

/// Returns a form within a relative error of 2^-bits, so also its sign; nothing where it is zero.
/// *Complexity* a few products and N square roots of numbers of 128 bits and more, nearly always;
/// of as many bits as twice the separation bound where the form is zero.
template <std::size_t N>
std::optional<rounded_number> round_form(const root_form<N>& x, unsigned bits) {
  integer error = 0;  // of the value: each root is less than a unit too small
  for (const integer& c : x.c) error += abs(c);
  // From this precision on |value| > |x| 2^precision - error >= error 2^bits, if x is not zero.
  const unsigned enough = x.separation_bits() + static_cast<unsigned>(bit_length(error)) + bits + 1;
  for (unsigned precision = 128;; precision *= 2) {
    integer value = x.a << precision;
    for (std::size_t r = 0; r < N; ++r) value += x.c[r] * isqrt(x.s[r] << 2 * precision);
    if (value != 0 && abs(value) >= error << bits) return rounded_number{std::move(value), precision};
    if (precision >= enough) return std::nullopt;
  }
}

/// Returns the sign of a form.
template <std::size_t N>
sign sign_of(const root_form<N>& x) {
  const auto value = round_form(x, 0);
  return value ? sign_of(value->value) : sign::zero;
}

}  // namespace osteon
