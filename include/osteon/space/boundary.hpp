// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The boundary of a solid as the algorithms see it: planes' numbers and incidences, no
/// coordinates.

#include <array>
#include <cstdint>
#include <vector>

#include "osteon/core/kernel.hpp"

namespace osteon {

/// Vertices, edges and facets of a solid whose adjacent facets are never coplanar. A facet is all
/// of the boundary in one plane: it may have several components and holes.
struct boundary {
  /// An edge between two facets.
  struct edge {
    std::array<int, 2> ends;
    std::array<plane_id, 2> planes;
    bool convex;
  };
  /// A vertex with one fan of facets around it.
  struct vertex {
    std::vector<plane_id> facets;  ///< counter-clockwise seen from outside
    std::vector<int> edges;        ///< edges[m] lies between facets[m] and facets[m + 1]

    /// Returns whether the vertex has three planes with two opposite facets each. Such a vertex
    /// never splits: three planes always meet in a point.
    bool is_majority() const {
      const auto& f = facets;
      return f.size() == 6 && f[0] == f[3] && f[1] == f[4] && f[2] == f[5] && f[0] != f[1] && f[1] != f[2] && f[0] != f[2];
    }
  };
  std::vector<vertex> vertices;
  std::vector<edge> edges;
  plane_id planes = 0;  ///< their number; a facet has the number of its plane
};

}  // namespace osteon
