// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Decimal text and doubles as exact numbers, without rounding.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace osteon {

/// mantissa * 10^ten * 2^two. `Int` is an exact integer of any size.
template <class Int>
struct exact_number {
  Int mantissa = 0;
  int ten = 0;
  int two = 0;
};

/// The numbers taken: at most so many digits without leading and trailing zeros, and 0 or between 10^-400 and 10^400.
inline constexpr int longest_mantissa = 1000;
inline constexpr int greatest_exponent = 400;

enum class number_fault : std::uint8_t { none, malformed, too_long };

/// Reads [+-]digits[.digits][e[+-]digits]; nothing may follow. The value is exact. Linear time in the text's length
/// for usual numbers.
template <class Int>
number_fault read_decimal(std::string_view text, exact_number<Int>& result) {
  std::size_t i = 0;
  const bool minus = i < text.size() && text[i] == '-';
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  int digits = 0;
  int significant = 0;
  int zeros = 0;  // trailing zeros not yet multiplied in
  long ten = 0;
  bool point = false;
  Int mantissa = 0;
  std::uint64_t chunk = 0;
  std::uint64_t chunk_scale = 1;
  const auto flush = [&] {
    if (chunk_scale == 1) return;
    mantissa = mantissa * Int(chunk_scale) + Int(chunk);
    chunk = 0;
    chunk_scale = 1;
  };
  const auto push = [&](unsigned digit) {
    chunk = chunk * 10 + digit;
    chunk_scale *= 10;
    ++significant;
    if (chunk_scale == 1'000'000'000'000'000'000U) flush();
  };
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    if (c < '0' || c > '9') break;
    ++digits;
    if (point) --ten;
    if (c == '0') {
      ++zeros;
      continue;
    }
    if (significant > 0)
      for (; zeros > 0 && significant < longest_mantissa; --zeros) push(0);
    zeros = 0;
    if (significant == longest_mantissa) return number_fault::too_long;
    push(static_cast<unsigned>(c - '0'));
  }
  flush();
  if (digits == 0) return number_fault::malformed;
  if (significant > 0) ten += zeros;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    if (i == text.size()) return number_fault::malformed;
    long exponent = 0;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i)
      if (exponent < 1'000'000) exponent = exponent * 10 + (text[i] - '0');
    ten += negative ? -exponent : exponent;
  }
  if (i != text.size()) return number_fault::malformed;
  if (significant == 0) ten = 0;
  if (significant + ten > greatest_exponent || significant + ten <= -greatest_exponent) return number_fault::too_long;
  result.mantissa = minus ? Int(-mantissa) : mantissa;
  result.ten = static_cast<int>(ten);
  result.two = 0;
  return number_fault::none;
}

/// The exact value of a double; nothing for NaN and infinities.
template <class Int>
std::optional<exact_number<Int>> from_double(double x) {
  if (!std::isfinite(x)) return std::nullopt;
  exact_number<Int> result;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m == 0) return result;
  auto bits = static_cast<std::int64_t>(std::ldexp(m, 53));
  exponent -= 53;
  while (bits % 2 == 0) {
    bits /= 2;
    ++exponent;
  }
  result.mantissa = Int(bits);
  result.two = exponent;
  return result;
}

}  // namespace osteon
