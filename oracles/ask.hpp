// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Asks kernels of either dimension with lists of planes, so that one test serves both.

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"

namespace osteon::oracles {

/// Returns a kernel's orientation of a corner.
template <class K, std::size_t N>
sign orientation(const K& k, const std::array<plane_id, N>& corner) {
  return std::apply([&](auto... planes) { return k.orientation(planes...); }, corner);
}

/// Returns whether a kernel calls a corner transversal.
template <class K, std::size_t N>
bool transversal(const K& k, const std::array<plane_id, N>& corner) {
  return std::apply([&](auto... planes) { return k.transversal(planes...); }, corner);
}

/// Returns the side of a plane on which a corner is at the moment of a meeting.
template <class K, std::size_t N>
sign side(const K& k, plane_id plane, const std::array<plane_id, N>& corner, const typename K::meeting& m) {
  return std::apply([&](auto... planes) { return k.side(plane, planes..., m); }, corner);
}

/// Returns the list without its last plane.
template <std::size_t N>
std::array<plane_id, N - 1> all_but_last(const std::array<plane_id, N>& planes) {
  std::array<plane_id, N - 1> result{};
  std::copy_n(planes.begin(), N - 1, result.begin());
  return result;
}

}  // namespace osteon::oracles
