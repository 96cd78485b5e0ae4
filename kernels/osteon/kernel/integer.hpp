// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The exact integer of the kernels: GMP through Boost.Multiprecision, without expression templates.

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>

#include "osteon/core/sign.hpp"

namespace osteon {

using integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Exact sign, constant time.
inline sign sign_of(const integer& x) { return sign_of(x.sign()); }

/// n_a . n_b of two normals.
template <std::size_t N>
integer inner_product(const std::array<integer, N>& a, const std::array<integer, N>& b) {
  integer sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// floor(sqrt(x)), x >= 0.
inline integer isqrt(const integer& x) { return boost::multiprecision::sqrt(x); }

/// Whether x >= 0 is the square of an integer.
inline bool is_square(const integer& x) { return mpz_perfect_square_p(x.backend().data()) != 0; }

}  // namespace osteon
