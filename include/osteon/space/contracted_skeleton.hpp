// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The exact straight skeleton of a polyhedron as a cell complex: flat arrays, integer ids, no
/// coordinates.

#include <array>
#include <vector>

#include "osteon/core/planes.hpp"

namespace osteon {

/// The exact skeleton. Arcs and sheets of any degree. Arcs are where at least three cells meet; a
/// sheet is a maximal connected part of the common border of two cells, so an arc may lie within
/// it, and it may be pinched at an arc or a node.
struct contracted_skeleton {
  /// A place in the limit.
  struct node {
    std::vector<int> raw;  ///< the nodes of the raw skeleton at this place, ascending
    std::vector<int> arcs;
  };
  /// A piece of a line between two neighbouring nodes on it.
  struct arc {
    int source;  ///< not later than the target
    int target;
    std::vector<plane_id> cells;  ///< the facets whose cells meet here, ascending
    std::vector<int> sheets;      ///< ascending; a sheet on both sides is listed twice
  };
  /// A part of the common border of two cells.
  struct sheet {
    std::array<plane_id, 2> facets;
    std::vector<int> raw;  ///< representatives of the raw polygons it is made of
    std::vector<int> arcs;
  };
  std::vector<node> nodes;
  std::vector<arc> arcs;
  std::vector<sheet> sheets;
  int cells = 0;  ///< that are not empty
};

}  // namespace osteon
