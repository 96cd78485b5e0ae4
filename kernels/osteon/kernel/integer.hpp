// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The exact integer of the kernels: GMP through Boost.Multiprecision, without expression templates.

#include <boost/multiprecision/gmp.hpp>

#include "osteon/sign.hpp"

namespace osteon {

using integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Exact sign, constant time.
inline sign sign_of(const integer& x) { return sign_of(x.sign()); }

/// floor(sqrt(x)), x >= 0.
inline integer isqrt(const integer& x) { return boost::multiprecision::sqrt(x); }

/// Whether x >= 0 is the square of an integer.
inline bool is_square(const integer& x) { return mpz_perfect_square_p(x.backend().data()) != 0; }

}  // namespace osteon
