// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The straight skeleton of a polygon: flat arrays, integer ids, no coordinates (design 05, 06).

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// How a skeleton is computed.
struct skeleton_options {
  bool outside = false;  ///< the interior is not bounded: vertices may move for ever
  /// When to stop, in the unit of time of the bounds on motion; needs bounds. Nothing later is
  /// computed; vertices that live then have no target.
  double until = std::numeric_limits<double>::infinity();
};

/// What an event does to the wavefront: an edge vanishes, or a vertex cuts an edge in two.
enum class event_class : std::uint8_t { edge, split };

/// The raw skeleton of a perturbed polygon: one node for each vertex and each event, in order of
/// time; one arc for each moving vertex.
struct skeleton {
  /// A vertex of the polygon or an event.
  struct node {
    int vertex;         ///< of the polygon, or -1
    triple lines;       ///< that meet, ascending; of a vertex its two lines and -1
    event_class event;  ///< meaningless for a vertex
    /// the edge that vanishes has length zero in the limit only (see
    /// propagation::collapse_zero_length_edges)
    bool zero_length = false;
  };
  /// The way of a moving vertex.
  struct arc {
    int source;
    int target;  ///< -1: the vertex moves for ever (outside of the polygon)
    /// the edge of the wavefront that ends at the moving vertex, and the one that starts there
    std::array<int, 2> faces;
  };
  std::vector<node> nodes;  ///< those of the vertices come first
  std::vector<arc> arcs;
  /// Each edge of the polygon sweeps a face; face i begins with edge i. Edges on one line that
  /// merge on their way share a face: all name the same representative, itself one of them. The
  /// faces of arcs are representatives.
  std::vector<int> faces;
  /// An arc and a node through whose place it passes in the limit: an edge of length zero there has
  /// become part of another one on its line.
  struct interior_node {
    int arc;
    int node;
  };
  std::vector<interior_node> interior_nodes;
  std::array<int, 2> events{};  ///< by class
};

}  // namespace osteon::plane
