// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Between the integers of a checked solid or polygon and the units of its input.

#include <array>
#include <cstddef>
#include <cstdlib>

#include "osteon/kernel/integer.hpp"

namespace osteon {

/// Returns 10^ten * 2^two.
inline rational power_of(int ten, int two) {
  rational r = 1;
  const integer t = pow(integer(10), static_cast<unsigned>(std::abs(ten)));
  const integer b = integer(1) << static_cast<unsigned>(std::abs(two));
  r = ten < 0 ? r / rational(t) : r * rational(t);
  return two < 0 ? r / rational(b) : r * rational(b);
}

/// The scale of a checked input. The input's time is distance divided by weight.
template <int Dimension>
struct basic_input_scale {
  std::array<integer, Dimension> shift{};  ///< to be added to coordinates, in integer units
  rational length = 1;                     ///< the integer unit of length, in the input's
  rational time = 1;                       ///< the integer unit of time, in the input's

  /// The scale of an input in its own units.
  basic_input_scale() = default;
  /// The scale of a solid or polygon.
  template <class Checked>
  explicit basic_input_scale(const Checked& p) : shift(p.shift), length(power_of(p.ten, p.two)), time(length) {
    if constexpr (requires { p.weight_ten; }) time = power_of(p.ten - p.weight_ten, p.two - p.weight_two);
  }

  /// Returns a time of the input in units of the integers.
  rational to_integers(const rational& t) const { return t / time; }
  /// Returns a time of the integers in units of the input.
  rational to_input(const rational& t) const { return t * time; }
  /// Returns a point of the integers in units of the input.
  std::array<rational, Dimension> to_input(const std::array<rational, Dimension>& p) const {
    std::array<rational, Dimension> result;
    for (std::size_t axis = 0; axis < p.size(); ++axis) result[axis] = (p[axis] + rational(shift[axis])) * length;
    return result;
  }
};

namespace plane {

/// The scale of a polygon.
using input_scale = basic_input_scale<2>;

}  // namespace plane
}  // namespace osteon
