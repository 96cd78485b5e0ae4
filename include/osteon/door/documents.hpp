// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Skeletons as plain exact data: what a document must hold so that nothing is lost, and the
/// certificate of what a document says. Whole numbers of any size are decimal strings. Everything
/// is counted from 0; -1 means "none".

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "osteon/door/polygon_skeleton.hpp"
#include "osteon/door/polyhedron_skeleton.hpp"

namespace osteon {

/// A moving line n . x = d - t * weight * |n| (D = 2) or plane (D = 3), in whole numbers.
template <int D>
struct exact_plane {
  std::array<std::string, D> n;
  std::string d;
  std::string weight;
  friend bool operator==(const exact_plane&, const exact_plane&) = default;
};

/// From whole numbers to the input: x = (whole number + shift) * 10^ten * 2^two, and weights are
/// those of the planes times 10^weight_ten * 2^weight_two.
template <int D>
struct exact_scale {
  int ten = 0;
  int two = 0;
  std::array<std::string, D> shift;
  int weight_ten = 0;
  int weight_two = 0;
};

/// A polygon's skeleton. Edge i, face i and vertex i of the outline belong together.
struct polygon_document {
  /// An edge of the outline.
  struct outline_edge {
    /// of the input, where it starts; an exterior run's edge ends at the one that follows in the
    /// input
    int point;
    int next;
    int line;
  };
  /// A node of the raw skeleton.
  struct node {
    int vertex;                ///< of the outline, or -1
    event_kind event;          ///< vertex, edge or split
    bool zero_length;          ///< the edge that vanishes has length zero in the limit only
    std::array<int, 3> lines;  ///< ascending; of a vertex its two lines and -1
    /// in units of the input, like the point: for people, and not looked at
    double time = 0;
    std::array<double, 2> point{};
  };
  /// An arc of either level of detail.
  struct arc {
    int source;
    int target;                ///< -1: endless
    std::array<int, 2> faces;  ///< representatives
  };
  /// A node through whose place an arc passes in the limit.
  struct interior_node {
    int arc;
    int node;
  };
  /// A node of the contracted skeleton.
  struct exact_node {
    int vertex;                 ///< of the outline, or -1
    std::array<int, 3> lines;   ///< that meet here
    std::array<int, 2> corner;  ///< two of them that cross
    double time = 0;
    std::array<double, 2> point{};
  };
  /// The contracted skeleton.
  struct exact_skeleton {
    std::vector<exact_node> nodes;
    std::vector<arc> arcs;
    int vertices = 0;  ///< nodes that are vertices; they come first
    int faces = 0;     ///< with an area
  };

  number_kernel kernel = number_kernel::sqrt;
  osteon::region region = osteon::region::interior;
  exact_scale<2> scale;
  std::vector<exact_plane<2>> lines;
  std::vector<outline_edge> outline;
  std::vector<node> nodes;
  std::vector<arc> arcs;
  std::vector<int> faces;  ///< by edge of the outline: the representative of its face
  std::vector<interior_node> interior_nodes;
  std::array<int, 2> events{};  ///< edge, split
  std::optional<exact_skeleton> contracted;
};

/// A polyhedron's skeleton. Vertices and edges of the solid go by the numbers of points of the
/// input.
struct polyhedron_document {
  /// A node of the raw skeleton.
  struct node {
    int vertex;  ///< the point of the input, or -1
    event_kind event;
    bool ambiguous;
    std::array<int, 4> planes;  ///< ascending; of a vertex the first three of its corner and -1
    std::vector<int> arcs;
    /// time and point, in units of the input, are there; for people, and not looked at
    bool has_place = false;
    double time = 0;
    std::array<double, 3> point{};
  };
  /// An arc of the raw skeleton.
  struct arc {
    int source;
    int target;
    std::array<int, 3> planes;  ///< ascending
    int corner;                 ///< 0 .. 255: the solid around the vertex, a bit for each octant
    std::vector<int> sheets;
  };
  /// A sheet of the raw skeleton.
  struct sheet {
    std::array<int, 2> planes;
    int representative;
    std::vector<int> arcs;
    std::array<int, 2> edge = {-1, -1};  ///< points of the input
  };
  /// A node of the contracted skeleton, by the raw nodes at its place.
  struct exact_node {
    std::vector<int> raw;
    std::vector<int> arcs;
  };
  /// An arc of the contracted skeleton, between the cells of its planes.
  struct exact_arc {
    int source;
    int target;
    std::vector<int> planes;
    std::vector<int> sheets;
  };
  /// A sheet of the contracted skeleton, by the raw sheets that it is made of.
  struct exact_sheet {
    std::array<int, 2> planes;
    std::vector<int> raw;
    std::vector<int> arcs;
  };
  /// The contracted skeleton.
  struct exact_skeleton {
    std::vector<exact_node> nodes;
    std::vector<exact_arc> arcs;
    std::vector<exact_sheet> sheets;
    int cells = 0;
  };

  number_kernel kernel = number_kernel::sqrt;
  split_preference prefer = split_preference::convex;
  saddle_rule saddle = saddle_rule::convex;
  exact_scale<3> scale;
  std::vector<exact_plane<3>> planes;
  std::vector<node> nodes;
  std::vector<arc> arcs;
  std::vector<sheet> sheets;
  std::vector<std::vector<int>> cells;  ///< by plane: its sheets
  std::array<int, 14> events{};         ///< E1 .. other
  int ambiguous = 0;
  std::optional<exact_skeleton> contracted;
};

/// Checks the certificate of what a document says about a polygon: nothing where it holds. *Throws*
/// input_error where the polygon is none, or a number of the document is no number.
std::optional<skeleton_refutation> verify(const polygon& p, const polygon_document& d);
/// Does the same for a polyhedron.
std::optional<skeleton_refutation> verify(const polyhedron& p, const polyhedron_document& d);

}  // namespace osteon
