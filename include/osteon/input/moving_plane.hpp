// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A moving plane in exact numbers: what kernels are made from. One dimension down it is a moving
/// line.

#include <array>
#include <tuple>

namespace osteon {

/// The plane n . x = d - t * weight * |n|. `Int` is an exact integer of any size. Outward normal
/// `n` (not zero, in units of length^-1 after the input was scaled to integers), offset `d`, speed
/// `weight` relative to the unit speed of the input divided by a common denominator: positive, or
/// zero for a line that stands still.
template <class Int, int Dimension = 3>
struct moving_plane {
  std::array<Int, Dimension> n;
  Int d;
  Int weight = 1;

  /// Returns whether two planes have equal numbers.
  friend bool operator==(const moving_plane&, const moving_plane&) = default;
  /// Returns whether a plane comes first in the order of normals, then offsets, then weights.
  friend bool operator<(const moving_plane& a, const moving_plane& b) { return std::tie(a.n, a.d, a.weight) < std::tie(b.n, b.d, b.weight); }
};

/// An edge of a polygon moves on such a line.
template <class Int>
using moving_line = moving_plane<Int, 2>;

}  // namespace osteon
