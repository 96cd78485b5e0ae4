// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Numbers of planes, and lists of as many as meet in a vertex or an event. In the plane they are
/// the numbers of lines.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace osteon {

/// A plane's number in the kernel: 0 .. size() - 1. Negative numbers mean "none".
using plane_id = std::int32_t;
/// The same in the plane, where planes are lines.
using line_id = plane_id;
/// Three planes: a corner of space; three lines: a meeting in the plane.
using triple = std::array<plane_id, 3>;
/// Four planes: a meeting in space.
using quadruple = std::array<plane_id, 4>;
/// As many planes as make a corner, in a space of this dimension.
template <int Dimension>
using corner_planes = std::array<plane_id, Dimension>;
/// As many planes as make a meeting, in a space of this dimension.
template <int Dimension>
using meeting_planes = std::array<plane_id, Dimension + 1>;

/// Hash of a list of planes. *Source* Knuth, The Art of Computer Programming 3, 6.4
/// (multiplicative).
struct plane_hash {
  /// Returns a hash that depends on the order of the planes.
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

/// Returns lambda_r of a meeting (see kernel.hpp), the signed minor of the normals that leaves out
/// plane r: lambda_r = (-1)^(N-1-r) minor(the other planes). `minor` is called with N - 1 plane
/// numbers and returns the determinant of their normals, or its sign; what it returns needs a unary
/// minus.
/// *Requires* r < N.
template <std::size_t N, class Minor>
constexpr auto lambda(const std::array<plane_id, N>& planes, std::size_t r, Minor minor) {
  auto value = std::apply(minor, omit(planes, r));
  return (N - 1 - r) % 2 == 0 ? value : decltype(value)(-value);
}

/// Returns all lambdas of a meeting (see lambda), in order.
template <std::size_t N, class Minor>
constexpr auto lambdas(const std::array<plane_id, N>& planes, Minor minor) {
  // Places are constants here, because the kernels' filter spends its time with this.
  const auto at = [&]<std::size_t r, std::size_t... i>(std::integral_constant<std::size_t, r>, std::index_sequence<i...>) {
    auto value = minor(planes[i < r ? i : i + 1]...);
    if constexpr ((N - 1 - r) % 2 == 0)
      return value;
    else
      return decltype(value)(-value);
  };
  return [&]<std::size_t... r>(std::index_sequence<r...>) {
    return std::array{at(std::integral_constant<std::size_t, r>{}, std::make_index_sequence<N - 1>{})...};
  }
  (std::make_index_sequence<N>{});
}

}  // namespace osteon
