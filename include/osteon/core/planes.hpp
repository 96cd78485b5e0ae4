// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Numbers of planes, and lists of as many as meet in a vertex or an event. In the plane they are the numbers of lines.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "osteon/core/sign.hpp"

namespace osteon {

/// A plane's number in the kernel: 0 .. size() - 1. Negative numbers mean "none".
using plane_id = std::int32_t;
/// Three planes: a vertex. Four planes: an event.
using triple = std::array<plane_id, 3>;
using quadruple = std::array<plane_id, 4>;
/// As many planes as meet in a vertex and in an event, in space of this dimension.
template <int Dimension>
using corner_planes = std::array<plane_id, Dimension>;
template <int Dimension>
using meeting_planes = std::array<plane_id, Dimension + 1>;

/// Hash of a list of planes (multiplicative, after Knuth, TAOCP 6.4).
struct plane_hash {
  template <std::size_t N>
  std::size_t operator()(const std::array<plane_id, N>& planes) const noexcept {
    std::uint64_t h = 0;
    for (const plane_id p : planes) h = (h ^ static_cast<std::uint32_t>(p)) * 0x9E3779B97F4A7C15U ^ h >> 29U;
    return static_cast<std::size_t>(h);
  }
};

/// Returns the list in ascending order.
template <std::size_t N>
constexpr std::array<plane_id, N> sorted(std::array<plane_id, N> planes) {
  std::sort(planes.begin(), planes.end());
  return planes;
}

/// Returns the list without its entry r.
/// *Requires* r < N.
template <std::size_t N>
constexpr std::array<plane_id, N - 1> omit(const std::array<plane_id, N>& planes, std::size_t r) {
  std::array<plane_id, N - 1> rest{};
  std::size_t size = 0;
  for (std::size_t i = 0; i < N; ++i)
    if (i != r) rest[size++] = planes[i];
  return rest;
}

/// Returns where a plane stands in a list; N where it does not.
template <std::size_t N>
constexpr std::size_t position(const std::array<plane_id, N>& planes, plane_id p) {
  return static_cast<std::size_t>(std::find(planes.begin(), planes.end(), p) - planes.begin());
}

/// Returns the sign of lambda_r, the signed minor of the normals of a meeting's planes that leaves out plane r (see kernel.hpp):
/// lambda_r = (-1)^(N-1-r) det(the other normals). `orientation` is asked for the sign of that determinant.
/// *Requires* r < N.
template <std::size_t N, class Orientation>
constexpr sign lambda(const std::array<plane_id, N>& planes, std::size_t r, Orientation orientation) {
  const sign minor = std::apply(orientation, omit(planes, r));
  return (N - 1 - r) % 2 == 0 ? minor : -minor;
}

}  // namespace osteon
