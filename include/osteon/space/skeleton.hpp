// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The straight skeleton of a polyhedron as a cell complex: flat arrays, integer ids, no
/// coordinates (docs/theory/skeleton-and-certificate.md).

#include <array>
#include <cstdint>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/catalogue.hpp"

namespace osteon {

/// The raw skeleton: one node per input vertex and event, in order of time; one arc per moving
/// vertex; one sheet per moving edge. Counts are the thesis's (4.4). Where and when a node is
/// follows from its planes (evaluate/locate.hpp).
struct skeleton {
  /// A vertex of the solid, or an event.
  struct node {
    int vertex;  ///< the input vertex, or -1
    /// the planes that meet, ascending; of an input vertex the first three of its corner and -1
    quadruple planes;
    event_class event;  ///< of an event; meaningless for an input vertex
    bool ambiguous;     ///< the event had two admissible outcomes
    std::vector<int> arcs;
  };
  /// What a moving vertex traces.
  struct arc {
    int source;  ///< the earlier node
    int target;
    triple planes;            ///< ascending
    std::uint8_t corner;      ///< the solid around the vertex, by octants (see local::corner_at)
    std::vector<int> sheets;  ///< 3, or 6 for a majority corner
  };
  /// What a moving edge traces.
  struct sheet {
    std::array<plane_id, 2> facets;  ///< ascending
    int input_edge;                  ///< the edge of the solid that swept it first, or -1
    /// Sheets of collinear edges that merged are one polygon: all name the same representative,
    /// itself one of them.
    int representative;
    std::vector<int> arcs;
  };
  std::vector<node> nodes;
  std::vector<arc> arcs;
  std::vector<sheet> sheets;
  std::vector<std::vector<int>> cells;  ///< by facet: the sheets that bound its cell

  /// Events by class, and those with two admissible outcomes.
  std::array<int, event_classes> events{};
  int ambiguous = 0;

  /// Vertices whose split is valid but was not proven to be the preferred one
  /// (preferred_split.hpp). Tells of the run: documents do not have it.
  int unproven_splits = 0;
};

}  // namespace osteon
