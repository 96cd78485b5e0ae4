// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Determinants of two or three rows, of any numbers.

namespace osteon {

/// Returns the determinant of the matrix with the entries at(row, column), which are called once or
/// twice each. Numbers need +, - and *.
template <int Dimension, class At>
constexpr auto determinant(At at) {
  static_assert(Dimension == 2 || Dimension == 3);
  if constexpr (Dimension == 2) {
    return at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
  } else {
    const auto minor = [&](int a, int b) { return at(1, a) * at(2, b) - at(1, b) * at(2, a); };
    return at(0, 0) * minor(1, 2) + at(0, 1) * minor(2, 0) + at(0, 2) * minor(0, 1);
  }
}

/// Returns the determinant of three vectors of space.
template <class Vector>
constexpr auto determinant(const Vector& a, const Vector& b, const Vector& c) {
  return determinant<3>([&](int row, int axis) -> const auto& { return (row == 0 ? a : row == 1 ? b : c)[static_cast<unsigned>(axis)]; });
}

}  // namespace osteon
