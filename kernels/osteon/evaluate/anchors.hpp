// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A point on each line of a polygon, for filters.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "osteon/input/polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// Returns for each line the vertex where an edge of it starts (see round_planes); nothing at all
/// where coordinates are too long for doubles.
/// *Complexity* linear.
inline std::vector<std::array<double, 2>> anchors_of(const plane::polygon<integer>& p) {
  std::vector<std::array<double, 2>> anchors(p.lines.size());
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const auto& point = p.points[i];
    if (std::max(bit_length(point[0]), bit_length(point[1])) > 53) return {};
    anchors[p.boundary.line[i]] = {to_double(point[0], 0), to_double(point[1], 0)};
  }
  return anchors;
}

}  // namespace osteon
