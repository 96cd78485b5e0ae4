// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Decimal text and doubles as exact numbers, without rounding.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace osteon {

/// The number mantissa * 10^ten * 2^two. `Int` is an exact integer of any size.
template <class Int>
struct exact_number {
  Int mantissa = 0;
  int ten = 0;
  int two = 0;

  /// Returns whether two numbers are written alike. Numbers that both come from decimal text, or
  /// both from doubles, are equal only if they are written alike.
  friend bool operator==(const exact_number&, const exact_number&) = default;
};

/// The limit of digits of a number in text, leading and trailing zeros not counted.
inline constexpr int longest_mantissa = 1000;
/// The limit of magnitude of a number in text: it is zero, or its absolute value lies between
/// 10^-greatest_exponent and 10^greatest_exponent.
inline constexpr int greatest_exponent = 400;

/// Why a text is no number: it is not written like one, or it is beyond the limits above.
enum class number_fault : std::uint8_t { none, malformed, too_long };

namespace detail {

/// The digits of a decimal number, one after the other. Leading and trailing zeros cost nothing.
template <class Int>
class digit_string {
 public:
  /// Adds a digit; false where there are too many.
  bool add(unsigned digit) {
    if (digit == 0) {
      ++zeros_;
      return true;
    }
    if (significant_ > 0)
      for (; zeros_ > 0 && significant_ < longest_mantissa; --zeros_) push(0);
    zeros_ = 0;
    if (significant_ == longest_mantissa) return false;
    push(digit);
    return true;
  }

  /// digits from the first to the last that is not zero
  int significant() const { return significant_; }
  int zeros() const { return zeros_; }  ///< zeros behind them

  /// Returns the digits without the zeros behind them.
  Int take() {
    flush();
    return std::move(value_);
  }

 private:
  void push(unsigned digit) {
    chunk_ = chunk_ * 10 + digit;
    chunk_scale_ *= 10;
    ++significant_;
    if (chunk_scale_ == 1'000'000'000'000'000'000U) flush();
  }
  void flush() {
    if (chunk_scale_ == 1) return;
    value_ = value_ * Int(chunk_scale_) + Int(chunk_);
    chunk_ = 0;
    chunk_scale_ = 1;
  }

  Int value_ = 0;
  std::uint64_t chunk_ = 0;  // the digits not yet in the value, and the power of ten for so many
  std::uint64_t chunk_scale_ = 1;
  int significant_ = 0;
  int zeros_ = 0;
};

/// Reads the digits of an exponent, with or without a sign, up to the end of the text; nothing
/// where there is something else. Exponents beyond a million are as good as infinite.
inline std::optional<long> read_exponent(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  long exponent = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    if (exponent < 1'000'000) exponent = exponent * 10 + (c - '0');
  }
  return negative ? -exponent : exponent;
}

}  // namespace detail

/// Reads [+-]digits[.digits][e[+-]digits], exactly; nothing may follow. `result` changes only where
/// the text is a number.
/// *Complexity* linear in the text's length for usual numbers.
template <class Int>
number_fault read_decimal(std::string_view text, exact_number<Int>& result) {
  std::size_t i = 0;
  const bool minus = i < text.size() && text[i] == '-';
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  detail::digit_string<Int> digits;
  bool any = false;
  bool point = false;
  long ten = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    if (c < '0' || c > '9') break;
    any = true;
    if (point) --ten;
    if (!digits.add(static_cast<unsigned>(c - '0'))) return number_fault::too_long;
  }
  if (!any) return number_fault::malformed;
  if (digits.significant() > 0) ten += digits.zeros();
  if (i < text.size()) {
    if (text[i] != 'e' && text[i] != 'E') return number_fault::malformed;
    const auto exponent = detail::read_exponent(text.substr(i + 1));
    if (!exponent) return number_fault::malformed;
    ten += *exponent;
  }
  if (digits.significant() == 0) ten = 0;
  // the number is less than 10^size, and at least a tenth of that
  const long size = digits.significant() + ten;
  if (size > greatest_exponent || size <= -greatest_exponent) return number_fault::too_long;
  result.mantissa = minus ? Int(-digits.take()) : digits.take();
  result.ten = static_cast<int>(ten);
  result.two = 0;
  return number_fault::none;
}

/// Returns the exact value of a double, its mantissa odd or zero; nothing for NaN and infinities.
template <class Int>
std::optional<exact_number<Int>> from_double(double x) {
  if (!std::isfinite(x)) return std::nullopt;
  exact_number<Int> result;
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
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
