// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The caller's numbers as exact ones.

#include <string>

#include "osteon/core/error.hpp"
#include "osteon/door/decimal.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// Returns the exact value. Throws input_error(bad_number): `what` says what the number is for.
inline exact_number<integer> exact_value(const decimal& x, const std::string& what) {
  if (!x.is_text()) {
    if (auto value = from_double<integer>(x.value())) return *value;
    throw input_error(input_fault::bad_number, 0, what + " is not finite", "give a finite number");
  }
  exact_number<integer> value;
  switch (read_decimal(x.text(), value)) {
    case number_fault::malformed:
      throw input_error(input_fault::bad_number, 0, what + ", \"" + x.text() + "\", is no decimal number", "give one like 1.25 or 3e-2");
    case number_fault::too_long:
      throw input_error(input_fault::absurd_size, 0, what + " is beyond 1e400, below 1e-400 or longer than 1000 digits", "round it");
    case number_fault::none:
      break;
  }
  return value;
}

/// Returns the exact value as a rational.
inline rational rational_value(const decimal& x, const std::string& what) {
  const exact_number<integer> e = exact_value(x, what);
  const auto power = [](int base, int exponent) { return pow(integer(base), static_cast<unsigned>(exponent < 0 ? -exponent : exponent)); };
  rational r = e.mantissa;
  r = e.ten < 0 ? r / rational(power(10, e.ten)) : r * rational(power(10, e.ten));
  return e.two < 0 ? r / rational(power(2, e.two)) : r * rational(power(2, e.two));
}

/// Returns a time of zero or more. Throws input_error.
inline rational time_value(const decimal& x) {
  rational t = rational_value(x, "the time");
  if (t < 0) throw input_error(input_fault::bad_number, 0, "an offset at a negative time", "give a time of zero or more");
  return t;
}

}  // namespace osteon
