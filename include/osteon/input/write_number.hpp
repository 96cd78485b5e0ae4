// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Writes numbers as decimal text from which the same numbers are read.

#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string_view>

#include "osteon/input/exact_number.hpp"

namespace osteon {

/// Writes an integer of any type.
template <class Int>
void write_number(std::ostream& out, const Int& x) {
  out << x;
}

/// Writes a finite double with as few digits as tell it from all other doubles.
inline void write_number(std::ostream& out, double x) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  out << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

/// Writes an exact number: the digits of an integer, and an exponent where it is not zero.
template <class Int>
void write_number(std::ostream& out, const exact_number<Int>& x) {
  // 2^-k = 5^k * 10^-k.
  Int digits = x.mantissa;
  int ten = x.ten;
  if (x.two > 0) digits <<= static_cast<unsigned>(x.two);
  for (int k = x.two; k < 0; ++k) digits *= 5;
  if (x.two < 0) ten += x.two;
  out << digits;
  if (ten != 0 && digits != 0) out << 'e' << ten;
}

}  // namespace osteon
