// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The boundary of a polygon as the algorithms see it: lines' numbers and incidences, no
/// coordinates.

#include <vector>

namespace osteon::plane {

/// The boundary as the algorithms see it: incidences and numbers of lines, no coordinates. Edge i
/// leads from vertex i to vertex next[i]; the interior is on its left.
struct boundary {
  std::vector<int> next;
  std::vector<int> line;  ///< of edge i; edges with equal equation and weight share one
  std::vector<int> rank;  ///< of edge i among those on its line, in their direction
  int lines = 0;
};

}  // namespace osteon::plane
