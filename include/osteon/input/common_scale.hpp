// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Brings decimal numbers and doubles to integers, all by the same factor.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/exact_number.hpp"

namespace osteon {

/// The limit of bits by which the common scale may lengthen a number. Numbers that are read from
/// text differ by at most some 8,000.
inline constexpr double most_bits_of_scale = 1e5;
/// The limit of bits by which the common scale may lengthen all numbers together, so that no input
/// can push memory beyond half a gigabyte.
inline constexpr double most_bits_of_all = 4e9;

/// A common scale of numbers: the finest of them, 10^ten * 2^two, is its unit. First all numbers
/// are added, then each is scaled.
template <class Int>
class common_scale {
 public:
  /// Lets the scale be as fine as a number demands.
  void add(const exact_number<Int>& x) {
    ++count_;
    if (x.mantissa == 0) return;
    if (!any_ || x.ten < ten_ || x.two < two_) finest_ = count_ - 1;
    ten_ = any_ ? std::min(ten_, x.ten) : x.ten;
    two_ = any_ ? std::min(two_, x.two) : x.two;
    most_ten_ = any_ ? std::max(most_ten_, long{x.ten}) : x.ten;
    most_two_ = any_ ? std::max(most_two_, long{x.two}) : x.two;
    any_ = true;
  }

  int ten() const { return ten_; }              ///< Returns the unit's power of ten
  int two() const { return two_; }              ///< Returns the unit's power of two
  std::size_t count() const { return count_; }  ///< Returns how many numbers were added
  /// Returns which of them, from 0, demands the unit
  std::size_t finest() const { return finest_; }

  /// Returns whether the scaled numbers would be longer than the limits allow.
  bool is_absurd() const { return bits() > most_bits_of_scale || all_bits() > most_bits_of_all; }

  /// Returns how much memory the scaled numbers may need, for a message: "12 MB".
  std::string memory() const { return std::to_string(static_cast<long>(all_bits() / 8e6)) + " MB"; }

  /// Returns a number in units of the scale; takes its digits away.
  /// *Requires* that the number was added, and that the scale is not absurd.
  Int scaled(exact_number<Int>&& x) {
    if (x.mantissa == 0) return Int(0);
    Int result = std::move(x.mantissa);
    if (x.ten > ten_) result *= power_of_ten(static_cast<std::size_t>(x.ten - ten_));
    if (x.two > two_) result <<= static_cast<unsigned>(x.two - two_);
    return result;
  }
  /// Does the same; the number keeps its digits.
  Int scaled(const exact_number<Int>& x) { return scaled(exact_number<Int>(x)); }

 private:
  // By how many bits the scale lengthens the coarsest number; all numbers, at most.
  double bits() const { return 3.33 * static_cast<double>(most_ten_ - ten_) + static_cast<double>(most_two_ - two_); }
  double all_bits() const { return bits() * static_cast<double>(count_); }

  // Most input needs few powers, those that it needs very often.
  const Int& power_of_ten(std::size_t exponent) {
    if (tens_.size() <= exponent) tens_.resize(exponent + 1);
    Int& power = tens_[exponent];
    if (power == 0) {
      power = 1;
      Int base = 10;
      for (std::size_t rest = exponent; rest > 0; rest >>= 1U) {
        if (rest % 2 == 1) power *= base;
        if (rest > 1) base *= base;
      }
    }
    return power;
  }

  int ten_ = 0;
  int two_ = 0;
  long most_ten_ = 0;
  long most_two_ = 0;
  std::size_t finest_ = 0;
  std::size_t count_ = 0;
  bool any_ = false;
  std::vector<Int> tens_;  // by exponent; zero: not needed so far
};

}  // namespace osteon
