// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The window beside the door: what happens inside. Ways to split a vertex, how many skeletons a
/// solid may have, pictures of vertices and events, and what the predicates cost. Like the door it
/// shows the standard library only.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osteon/osteon.hpp"

namespace osteon::inspect {

/// A tree that splits a vertex: operations <a,b>, by which the facets a and b of the vertex become
/// adjacent, ascending. Facets are counted from 0 counter-clockwise seen from outside.
using split_tree = std::vector<std::pair<int, int>>;

/// A number of trees, as a decimal of any size.
struct split_count {
  std::string valid;
  bool exact;  ///< false: there are at least so many
};

/// The tree that is preferred.
struct preferred_split {
  split_tree tree;
  bool proven;  ///< no valid tree is preferred to it
};

/// The spherical skeleton of a vertex (thesis 3.4): what a small sphere around the vertex cuts out
/// of the solid's facets and of the sheets of a split. Points on the unit sphere are directions
/// from the vertex; all numbers are rounded.
struct spherical_picture {
  using vector = std::array<double, 3>;
  /// A part of an arc on one side of the plane through the vertex across the direction of view.
  struct part {
    bool front;
    std::vector<vector> points;  ///< along a great circle
  };
  /// An arc of the spherical skeleton, between the parts of two facets.
  struct arc {
    /// around the vertex; the second is -1 for a side of the spherical polygon
    std::array<int, 2> facets;
    std::array<int, 2> nodes;
    bool convex;  ///< of the edge that sweeps it; of a side meaningless
    std::vector<part> parts;
  };
  vector eye;  ///< the direction of view
  /// first the vertex's edges, then the tree's vertices in the direction in which they move
  std::vector<vector> nodes;
  std::vector<arc> arcs;
};

/// The ways to split one vertex of a solid into vertices of degree three. Keeps the solid alive.
class vertex_splits {
 public:
  /// *Requires* a vertex of the solid (see polyhedron::vertex_at). *Throws* input_error(bad_index).
  vertex_splits(const polyhedron& p, int vertex);

  /// Returns the number of edges.
  int degree() const;
  /// Returns the planes of the facets around the vertex.
  std::vector<int> planes() const;
  /// Returns whether the vertex never splits: three facets, or three planes with six.
  bool is_whole() const;
  /// Returns how many trees there are, valid or not: a Catalan number.
  std::string trees() const;
  /// Returns whether for_each lists by enumeration (up to degree 12): then also trees with vertices
  /// infinitely far away on an edge of the solid.
  bool is_enumerated() const;

  /// Calls visit(tree, near) for every valid tree until it answers true; `near` is false where one
  /// of its vertices lies infinitely far away, so that the tree splits the vertex but not the
  /// solid. Nothing for a whole vertex. *Throws* unsupported_error above degree 300. *Complexity*:
  /// exponential in the degree.
  void for_each(const std::function<bool(const split_tree&, bool near)>& visit) const;
  /// Returns how many trees obey the rules of single vertices and edges, exactly. *Throws* as
  /// for_each.
  std::string candidates() const;
  /// Returns how many trees are valid: exactly up to ten thousand, else from below. *Throws* as
  /// for_each.
  split_count count() const;
  /// Calls visit(tree, valid) for candidates that are drawn, each with the same chance. In a tree
  /// that is not valid two edges of a facet cross. *Throws* as for_each.
  void sample(int number, std::uint64_t seed, const std::function<void(const split_tree&, bool valid)>& visit) const;
  /// Returns the preferred valid tree; nothing for a whole vertex, and where no tree is valid,
  /// which happens where three planes share an edge's line.
  std::optional<preferred_split> preferred(split_preference p) const;
  /// Draws the preferred split seen from a direction, or from that of the sum of all edges.
  /// *Throws* unsupported_error where facets around the vertex share a plane.
  spherical_picture spherical(split_preference p, const std::optional<std::array<double, 3>>& eye = std::nullopt) const;

 private:
  polyhedron solid_;
  int vertex_;
};

/// How many skeletons a solid may have.
struct ambiguity {
  /// A vertex that can be split in several ways.
  struct vertex {
    int point;  ///< of the input
    int degree;
    split_count splits;
  };
  std::vector<vertex> vertices;  ///< those with several valid splits, or none
  split_count splits;            ///< their product
  /// that the skeleton of most convex edges meets, each with two outcomes
  int saddles;
};

/// Counts the choices that a solid's skeleton has.
ambiguity count_ambiguity(const polyhedron& p);

/// A skeleton among those that a solid may have.
struct explored_skeleton {
  std::uint64_t seed;       ///< polyhedron_options::explore
  int nodes, arcs, sheets;  ///< of the raw skeleton
  int events;
  int saddles;
  std::vector<double> volumes;  ///< of the offsets asked for, in units of the input cubed
};

/// Which skeletons to visit.
struct exploration {
  int skeletons = 1;             ///< how many different ones
  std::uint64_t seed = 1;        ///< of the first choice
  std::vector<decimal> offsets;  ///< times of volumes
};

/// Calls visit for different skeletons of a solid, which draw their choices at random, until there
/// are as many as asked for or 20 times as many seeds and a hundred have been tried. Returns how
/// many seeds were tried. *Throws* input_error for a negative time.
std::uint64_t explore(const polyhedron& p, const exploration& e, const std::function<void(const explored_skeleton&)>& visit);

/// What surrounds an event, just before and just after: four planes cut space into 15 cells.
struct event_picture {
  event_kind kind;
  bool ambiguous;
  std::array<int, 4> planes;  ///< ascending
  /// the small tetrahedron before the event, as the number of a cell; its complement is there only
  /// after
  int small;
  /// Whether a cell is solid, by its number: bit q says that it lies inside plane q.
  std::array<bool, 16> before;  ///< false for what is not there
  std::array<bool, 16> after;
};

/// Returns the picture of an event. *Requires* a raw node that is an event, of a skeleton that is
/// certified. *Throws* unsupported_error else.
event_picture picture_of(const polyhedron_skeleton::node& event);

/// How often the algorithms asked each predicate, and how often floating point left a sign to exact
/// numbers. In units of questions; an exact number of them is that of one run and says nothing
/// about time.
struct predicate_statistics {
  std::uint64_t orientation = 0;     ///< how planes meet
  std::uint64_t side = 0;            ///< on which side of a plane a vertex is
  std::uint64_t compare = 0;         ///< which of two meetings is earlier
  std::uint64_t meetings = 0;        ///< made from planes
  std::uint64_t compare_volume = 0;  ///< of two splits

  std::uint64_t exact_orientation = 0;  ///< determinants of normals
  std::uint64_t exact_offset = 0;       ///< numerators of times
  std::uint64_t exact_closing = 0;      ///< denominators of times
  std::uint64_t exact_cross = 0;        ///< differences of times
};

/// Computes a raw skeleton and counts. *Requires* an exact kernel. *Throws* as skeletonize, and
/// unsupported_error for number_kernel::floating.
predicate_statistics count_predicates(const polyhedron& p, const polyhedron_options& options = {});
/// Does the same for a polygon, with a run to the end.
predicate_statistics count_predicates(const polygon& p, const polygon_options& options = {});

}  // namespace osteon::inspect
