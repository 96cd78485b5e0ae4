// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Planes as machine numbers, for the double kernel and the filter.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/integer_planes.hpp"
#include "osteon/kernel/perturbation.hpp"

namespace osteon {

/// One plane, rounded: relative error of every number at most 2^-52 (GMP truncates). Numbers are
/// scaled by powers of two where they are too long for doubles. In the plane it fits into one line
/// of a processor's memory.
template <int Dimension>
struct alignas(Dimension == 2 ? 64 : alignof(double)) rounded_plane {
  std::array<double, Dimension> n;
  std::array<double, Dimension> anchor;  ///< integers: a point near what lies on the plane
  double rest;                           ///< d - n . anchor
  double speed;
  double d;
  std::int32_t delta;         ///< of the perturbation, in integers
  std::uint8_t shift;         ///< n is in units of 2^shift; 120 stands for more, too
  std::uint8_t offset_shift;  ///< d is in units of 2^(shift + offset_shift); likewise
  bool exact;                 ///< all numbers are integers and nothing was lost
  bool fit;                   ///< n and d are zero or so great that no product underflows

  /// Returns whether no number was scaled.
  bool unscaled() const { return shift == 0 && offset_shift == 0; }
  /// Returns whether the perturbation, in the same units, is so great that no product underflows.
  bool tilt_fit() const { return shift + offset_shift < 120; }
};

/// Returns x * 2^-shift, rounded towards zero.
inline double to_double(const integer& x, int shift) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, x.backend().data());
  return std::ldexp(mantissa, static_cast<int>(exponent) - shift);
}

/// Returns whether x * 2^-shift is zero or at least 2^-120, so that a product of eight such numbers
/// is a normal number.
inline bool is_fit(const integer& x, int shift) { return x == 0 || bit_length(x) - shift > -120; }

/// Rounds planes. Products of seven normals and an offset must neither overflow nor lose bits to
/// underflow, so where numbers are long each plane is scaled by a power of two, which changes no
/// sign (K4), and so are all offsets together, which changes the unit of length and time. `anchors`
/// are a point for each plane with integers for coordinates, or none at all. Where planes are near
/// their anchors and these near each other, far from the origin, D loses fewer bits; nothing else
/// depends on anchors.
template <int Dimension>
std::vector<rounded_plane<Dimension>> round_planes(std::span<const moving_plane<integer, Dimension>> planes,
                                                   std::span<const std::array<double, Dimension>> anchors = {}) {
  constexpr int longest = 100;  // bits of n, and of d beyond n: 8 * 100 + 2 * 100 < 1023
  std::vector<int> shifts;
  int offset_shift = 0;
  for (const auto& p : planes) {
    int bits = 0;
    for (const integer& x : p.n) bits = std::max(bits, bit_length(x));
    shifts.push_back(bits > longest ? bits : 0);
    offset_shift = std::max(offset_shift, bit_length(p.d) - shifts.back() - 2 * longest);
  }
  const bool anchored = !anchors.empty() && offset_shift == 0 && std::all_of(shifts.begin(), shifts.end(), [](int s) { return s == 0; });
  std::vector<rounded_plane<Dimension>> result;
  result.reserve(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& p = planes[i];
    const int shift = shifts[i];
    const integer squared = squared_speed(p);
    rounded_plane<Dimension> r{};
    r.delta = perturbation::of(static_cast<plane_id>(i)).delta;
    for (int axis = 0; axis < Dimension; ++axis) r.n[axis] = to_double(p.n[axis], shift);
    r.d = to_double(p.d, shift + offset_shift);
    r.rest = r.d;
    if (anchored) {
      r.anchor = anchors[i];
      integer rest = p.d;
      for (int axis = 0; axis < Dimension; ++axis) rest -= p.n[axis] * integer(r.anchor[axis]);
      r.rest = to_double(rest, 0);
    }
    const auto small = [](const integer& x) { return bit_length(x) <= 53; };
    r.exact =
        shift == 0 && offset_shift == 0 && std::all_of(p.n.begin(), p.n.end(), small) && small(p.d) && is_square(squared) && small(isqrt(squared));
    // The root halves the relative error.
    r.speed = r.exact ? to_double(isqrt(squared), 0) : std::sqrt(to_double(squared, 2 * shift));
    r.shift = static_cast<std::uint8_t>(std::min(shift, 120));
    r.offset_shift = static_cast<std::uint8_t>(std::min(offset_shift, 120));
    r.fit = std::all_of(p.n.begin(), p.n.end(), [shift](const integer& x) { return is_fit(x, shift); }) && is_fit(p.d, shift + offset_shift);
    result.push_back(r);
  }
  return result;
}

}  // namespace osteon
