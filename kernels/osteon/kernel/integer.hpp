// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The exact numbers of the kernels: GMP through Boost.Multiprecision, without expression
/// templates.

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>

#include "osteon/core/sign.hpp"

namespace osteon {

/// An integer of any size.
using integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
/// A quotient of such integers, in lowest terms.
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Returns the sign of an integer, in constant time.
inline sign sign_of(const integer& x) { return sign_of(x.sign()); }

/// Returns the inner product of two vectors.
template <std::size_t N>
integer inner_product(const std::array<integer, N>& a, const std::array<integer, N>& b) {
  integer sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// Returns the length of |x| in bits: the least n with |x| < 2^n.
inline int bit_length(const integer& x) { return x.is_zero() ? 0 : static_cast<int>(mpz_sizeinbase(x.backend().data(), 2)); }

/// Returns floor(sqrt(x)).
/// *Requires* x >= 0.
inline integer isqrt(const integer& x) { return boost::multiprecision::sqrt(x); }

/// Returns whether x is the square of an integer.
/// *Requires* x >= 0.
inline bool is_square(const integer& x) { return mpz_perfect_square_p(x.backend().data()) != 0; }

}  // namespace osteon
