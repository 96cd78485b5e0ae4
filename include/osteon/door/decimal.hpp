// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Exact numbers that a caller hands over: weights, distances, times.

#include <concepts>
#include <string>
#include <utility>

namespace osteon {

/// An exact number: a double, taken with all its bits, or decimal text such as "0.1" or "-2.5e-3",
/// taken as written. The text is not looked at before the number is used: what takes a decimal
/// throws input_error(bad_number) where the text is no number.
class decimal {
 public:
  /// Takes a floating-point number exactly.
  template <std::floating_point Number>
  decimal(Number x) : value_(static_cast<double>(x)) {}  // NOLINT: a number is one
  /// Takes a whole number exactly.
  template <std::integral Number>
  decimal(Number x) : text_(std::to_string(x)), is_text_(true) {}  // NOLINT
  /// Takes decimal text.
  decimal(std::string text) : text_(std::move(text)), is_text_(true) {}  // NOLINT
  /// Takes decimal text.
  decimal(const char* text) : text_(text), is_text_(true) {}  // NOLINT

  /// Returns whether this is a text, and no double.
  bool is_text() const { return is_text_; }
  /// Returns the text. *Requires* is_text().
  const std::string& text() const { return text_; }
  /// Returns the double. *Requires* !is_text().
  double value() const { return value_; }

  /// Returns whether the first number is less, exactly. *Throws* input_error(bad_number or
  /// absurd_size) where one of them is no number.
  friend bool operator<(const decimal& a, const decimal& b) { return is_less(a, b); }

 private:
  static bool is_less(const decimal& a, const decimal& b);

  double value_ = 0;
  std::string text_;
  bool is_text_ = false;
};

}  // namespace osteon
