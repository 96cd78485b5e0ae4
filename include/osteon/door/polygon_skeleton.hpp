// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The straight skeleton of a polygon: nodes, arcs, faces, offsets, roofs, certificate.

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "osteon/door/choices.hpp"
#include "osteon/door/decimal.hpp"
#include "osteon/door/elements.hpp"
#include "osteon/door/mesh.hpp"
#include "osteon/door/polygon.hpp"

namespace osteon {

struct polygon_document;

/// How a polygon's skeleton is computed.
struct polygon_options {
  osteon::region region = osteon::region::interior;
  /// The time at which to stop, in units of the input, inclusive: offsets up to it are there, and
  /// what lives then has no target. Nothing: never.
  std::optional<decimal> until = std::nullopt;
  number_kernel kernel = number_kernel::sqrt;
};

/// The polygon that is left, or has grown, at some time.
struct offset_polygon {
  /// A closed line, the interior on its left.
  struct ring {
    std::vector<std::array<double, 2>> points;  ///< counter-clockwise, holes clockwise
    /// by point: the edge of the input on whose moved line the ring goes on (the first of those
    /// merged)
    std::vector<int> edges;
    bool hole;
    int part;  ///< connected piece of the interior, 0 .. parts - 1
  };
  /// those of a part together, its outer ring first; none where nothing is left
  std::vector<ring> rings;
  int parts = 0;
};

/// How a roof is built. Edges have slopes of their own by their weights: an edge of weight w rises
/// by slope / w, weight 0 is a gable.
struct roof_options {
  /// height for each unit that an edge of weight 1 has moved inwards; greater than zero
  double slope = 1;
  double eaves = 0;          ///< height of the polygon
  bool walls = false;        ///< down from the eaves to height 0; requires eaves greater than zero
  bool triangulate = false;  ///< all faces; else only those with holes
};

/// The straight skeleton of a polygon. A value: copies share their data, which never changes.
///
/// It has two levels of detail. The exact skeleton has a node wherever at least three arcs meet,
/// and at the polygon's vertices. The raw one, raw(), is that of the polygon moved infinitely
/// little so that no two events coincide: a node for each vertex and event, in order of time, and
/// arcs that may have length zero in the limit. With number_kernel::floating there is the raw one
/// only.
///
/// *Threads*: const members may be called from several threads at once, also on copies.
class polygon_skeleton {
 public:
  struct data;
  class node;
  class arc;
  class face;

  /// Returns the nodes; those that are vertices of the polygon come first.
  element_range<node> nodes() const;
  /// Returns the arcs: the tracks of the wavefront's vertices.
  element_range<arc> arcs() const;
  /// Returns the faces: what the polygon's edges sweep. Edges on one line that merge on their way
  /// share a face; one of weight 0 may have none.
  element_range<face> faces() const;

  /// Returns the same skeleton with all events told apart.
  polygon_skeleton raw() const;
  /// Returns whether this is the raw level of detail.
  bool is_raw() const { return view_.raw; }

  /// Returns the polygon at a time: the distance that an edge of weight 1 has moved, in units of
  /// the input. Of an exterior run the polygon that has grown. At the moment of an event it is what
  /// comes after it. Points are correct to a few units in the last place of the polygon's size.
  /// *Throws* input_error where the time is negative, no number, or later than the run's `until`.
  /// *Complexity*: linear, and sorting.
  offset_polygon offset(const decimal& time) const;
  /// Returns the offsets at several times, in their order. *Throws* as offset.
  std::vector<offset_polygon> offsets(std::span<const decimal> times) const;
  std::vector<offset_polygon> offsets(std::initializer_list<decimal> times) const;

  /// Returns the roof over the polygon as a closed mesh: one face for each face of the skeleton,
  /// walls, a floor. *Throws* unsupported_error for an exterior or stopped run and for
  /// number_kernel::floating, input_error for options without sense. *Complexity*: sorting; a floor
  /// with holes, and all triangles, the square of their rings' sizes.
  mesh roof(const roof_options& options = {}) const;

  /// Checks the certificate of both levels of detail, exactly and without computing the skeleton
  /// again: nothing where it holds. *Throws* unsupported_error for a stopped run. *Source*:
  /// docs/theory/skeleton-and-certificate.md.
  std::optional<skeleton_refutation> verify() const;

  /// Returns how many vertices, holes and connected pieces the checked polygon has.
  int vertices() const;
  /// Returns how many clockwise boundaries the checked polygon has.
  int holes() const;
  /// Returns how many connected pieces the interior of the checked polygon has.
  int parts() const;
  /// Returns what was left out or repaired in the input, one sentence each.
  const std::vector<std::string>& notes() const&;
  std::vector<std::string> notes() const&& { return static_cast<const polygon_skeleton&>(*this).notes(); }
  /// Returns the options of the run.
  const polygon_options& options() const&;
  polygon_options options() const&& { return static_cast<const polygon_skeleton&>(*this).options(); }
  /// Returns how many events of a kind (edge or split) there are in the raw skeleton.
  int events(event_kind k) const;

  /// Returns all there is in plain exact data, both levels of detail, without loss
  /// (osteon/door/documents.hpp).
  polygon_document document() const;

  using handle = shared_view<data>;
  /// Makes the view; for the library.
  explicit polygon_skeleton(handle view) : view_(std::move(view)) {}

 private:
  handle view_;
};

/// A vertex of the polygon, or a place where arcs meet.
class polygon_skeleton::node {
 public:
  /// Returns its number among the nodes of its level of detail.
  int id() const { return id_; }
  /// Returns its place, correct to a few units in the last place of the polygon's size. *Throws*
  /// unsupported_error unless has_place().
  std::array<double, 2> point() const;
  /// Returns its time: how far an edge of weight 1 has moved, in units of the input. *Throws* as
  /// point.
  double time() const;
  /// Returns its coordinates or time with so many digits after the point, rounded correctly, halves
  /// away from zero. Any number of digits can be had. *Throws* as point.
  std::array<std::string, 2> point_exact(int digits = 20) const;
  /// Returns its time in the same way.
  std::string time_exact(int digits = 20) const;
  /// Returns whether it has a place: not where, in a raw skeleton, its lines have come to meet
  /// always or never.
  bool has_place() const;

  /// Returns what happens here.
  event_kind event() const;
  /// Returns the number of the polygon's point, or -1.
  int vertex() const;
  /// Returns the arcs that begin or end here, ascending by number.
  std::vector<arc> arcs() const;

  using handle = polygon_skeleton::handle;
  node(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const node& a, const node& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// The track of a vertex of the wavefront, between the faces of the two edges that meet in it.
class polygon_skeleton::arc {
 public:
  /// Returns its number among the arcs of its level of detail.
  int id() const { return id_; }
  /// Returns the node where it begins, which is not later than the target.
  node source() const;
  /// Returns the node where it ends. *Requires* !is_endless().
  node target() const;
  /// Returns whether it does not end: for ever, or not before the run's `until`.
  bool is_endless() const;
  /// Returns the faces on its right and left, seen along the way from source to target.
  std::array<face, 2> faces() const;
  /// Returns the direction in which an endless arc moves on: the way that it takes in one unit of
  /// time.
  std::array<double, 2> velocity() const;

  using handle = polygon_skeleton::handle;
  arc(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const arc& a, const arc& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// What an edge of the polygon sweeps on its way.
class polygon_skeleton::face {
 public:
  /// Returns its number among the faces of its level of detail.
  int id() const { return id_; }
  /// Returns the edge of the input that it begins with, the first of those that share it.
  int edge() const;
  /// Returns all edges of the input that share it, as far as the checked polygon tells them apart.
  std::vector<int> edges() const;
  /// Returns its boundary: closed walks through nodes with the face on the left; one, but for a
  /// face that surrounds the track of a hole. *Throws* unsupported_error where the run was exterior
  /// or stopped, and for the raw skeleton.
  std::vector<std::vector<node>> boundary() const;
  /// Returns the arcs beside it, ascending by number.
  std::vector<arc> arcs() const;
  /// Returns the unit vector in which its edge moves.
  std::array<double, 2> inwards() const;

  using handle = polygon_skeleton::handle;
  face(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const face& a, const face& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// Computes the straight skeleton of a polygon. *Throws* input_error where it is no polygon,
/// unsupported_error where a part of the wavefront stands still for ever, undecided_error
/// (number_kernel::floating only). *Complexity*: n log n in practice, memory linear.
polygon_skeleton skeletonize(const polygon& p, const polygon_options& options = {});
/// Does the same, with less memory: the polygon's input is given up.
polygon_skeleton skeletonize(polygon&& p, const polygon_options& options = {});

}  // namespace osteon
