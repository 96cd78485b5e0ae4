// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The straight skeleton of a polyhedron: nodes, arcs, sheets, cells, offsets, certificate.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "osteon/door/choices.hpp"
#include "osteon/door/decimal.hpp"
#include "osteon/door/elements.hpp"
#include "osteon/door/mesh.hpp"
#include "osteon/door/polyhedron.hpp"
#include "osteon/space/preference.hpp"

namespace osteon {

struct polyhedron_document;

/// How a polyhedron's skeleton is computed.
struct polyhedron_options {
  /// which way to split a vertex of high degree
  split_preference prefer = split_preference::convex;
  /// which way to take at a saddle; nothing: default_saddle(prefer)
  std::optional<saddle_rule> saddle = std::nullopt;
  number_kernel kernel = number_kernel::sqrt;
  /// Where given, nothing is preferred: splits and outcomes of saddles are drawn, the same ones for
  /// the same number.
  std::optional<std::uint64_t> explore = std::nullopt;
};

/// How an offset is handed out.
struct offset_options {
  bool triangulate = false;  ///< all facets; else only those that have holes or touch themselves
};

/// The straight skeleton of a polyhedron as a cell complex. A value: copies share their data, which
/// never changes.
///
/// It has two levels of detail. The exact skeleton has arcs where at least three cells meet, and
/// sheets that are the common border of two cells. The raw one, raw(), is that of the solid moved
/// infinitely little so that no two events coincide: a node for each vertex and event, in order of
/// time, an arc for each moving vertex, a sheet for each moving edge. With number_kernel::floating
/// there is the raw one only.
///
/// *Threads*: const members may be called from several threads at once, also on copies.
class polyhedron_skeleton {
 public:
  struct data;
  class node;
  class arc;
  class sheet;
  class cell;

  /// Returns the nodes.
  element_range<node> nodes() const;
  /// Returns the arcs.
  element_range<arc> arcs() const;
  /// Returns the sheets. Raw sheets of collinear edges that merge are one polygon: they have the
  /// same representative.
  element_range<sheet> sheets() const;
  /// Returns the cells: one for each plane of the solid, empty where the plane's facets sweep
  /// nothing.
  element_range<cell> cells() const;

  /// Returns the same skeleton with all events told apart.
  polyhedron_skeleton raw() const;
  /// Returns whether this is the raw level of detail.
  bool is_raw() const { return view_.raw; }

  /// Returns the surface of what is left of the solid at a time: the distance that a facet of
  /// weight 1 has moved, in units of the input. What meets is decided exactly; points are rounded.
  /// At the moment of an event it is what comes after it. *Throws* input_error where the time is
  /// negative or no number. *Complexity*: linear in the skeleton, sorting, and cutting facets into
  /// triangles.
  mesh offset(const decimal& time, const offset_options& options = {}) const;
  /// Returns the volume that is left at a time, within 2^-100 (relative to the solid's). *Throws*
  /// as offset.
  double volume(const decimal& time) const;

  /// Checks the certificate of both levels of detail, exactly and without computing the skeleton
  /// again: nothing where it holds. *Source*: docs/theory/skeleton-and-certificate.md.
  std::optional<skeleton_refutation> verify() const;

  /// Returns the solid.
  polyhedron input() const;
  /// Returns the options of the run; `saddle` is set.
  const polyhedron_options& options() const&;
  polyhedron_options options() const&& { return static_cast<const polyhedron_skeleton&>(*this).options(); }
  /// Returns how many events of a kind there are in the raw skeleton.
  int events(event_kind k) const;
  /// Returns how many events of the raw skeleton had two admissible outcomes.
  int ambiguous() const;
  /// Returns how many vertices have a split that is valid but not proven to be the preferred one.
  int unproven_splits() const;

  /// Returns all there is in plain exact data, both levels of detail, without loss
  /// (osteon/door/documents.hpp).
  polyhedron_document document() const;

  using handle = shared_view<data>;
  /// Makes the view; for the library.
  explicit polyhedron_skeleton(handle view) : view_(std::move(view)) {}

 private:
  handle view_;
};

/// A vertex of the solid, or a place where arcs meet.
class polyhedron_skeleton::node {
 public:
  /// Returns its number among the nodes of its level of detail.
  int id() const { return id_; }
  /// Returns its place, correctly rounded but for a few units in the last place. *Throws*
  /// unsupported_error unless has_place().
  std::array<double, 3> point() const;
  /// Returns its time: how far a facet of weight 1 has moved, in units of the input. *Throws* as
  /// point.
  double time() const;
  /// Returns its coordinates or time with so many digits after the point, rounded correctly, halves
  /// away from zero. Any number of digits can be had. *Throws* as point.
  std::array<std::string, 3> point_exact(int digits = 20) const;
  /// Returns its time in the same way.
  std::string time_exact(int digits = 20) const;
  /// Returns whether it has a place: not where, in a raw skeleton, no three of its planes meet in a
  /// point.
  bool has_place() const;

  /// Returns what happens here.
  event_kind event() const;
  /// Returns whether an event here had two admissible outcomes.
  bool is_ambiguous() const;
  /// Returns the number of the solid's point, or -1.
  int vertex() const;
  /// Returns the planes that meet here, ascending.
  std::vector<int> planes() const;
  /// Returns the arcs that begin or end here.
  std::vector<arc> arcs() const;
  /// Returns the nodes of the raw skeleton at this place, ascending; a raw node itself.
  std::vector<node> raw_nodes() const;

  /// Returns what the library has computed. Opaque, and not to be kept longer than the node.
  const data& access() const& { return *of_.data; }
  const data& access() const&& = delete;

  using handle = polyhedron_skeleton::handle;
  node(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const node& a, const node& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// The track of a vertex of the moving surface.
class polyhedron_skeleton::arc {
 public:
  /// Returns its number among the arcs of its level of detail.
  int id() const { return id_; }
  /// Returns the node where it begins, which is not later than the target.
  node source() const;
  /// Returns the node where it ends.
  node target() const;
  /// Returns the planes whose cells meet along it, ascending; of a raw arc three.
  std::vector<int> planes() const;
  /// Returns the sheets that meet along it, ascending; one on both sides is listed twice.
  std::vector<sheet> sheets() const;

  using handle = polyhedron_skeleton::handle;
  arc(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const arc& a, const arc& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// What an edge of the moving surface sweeps: flat, with the border's arcs in no order.
class polyhedron_skeleton::sheet {
 public:
  /// Returns its number among the sheets of its level of detail.
  int id() const { return id_; }
  /// Returns the two planes between whose cells it lies, ascending.
  std::array<int, 2> planes() const;
  /// Returns the arcs of its border, each once.
  std::vector<arc> arcs() const;
  /// Returns the points of the solid's edge that swept it first; nothing where it began later, and
  /// for the exact skeleton.
  std::optional<std::array<int, 2>> input_edge() const;
  /// Returns, of a raw sheet, the number of the one that stands for all of its polygon; of another
  /// its own.
  int representative() const;

  using handle = polyhedron_skeleton::handle;
  sheet(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const sheet& a, const sheet& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// What the facets in one plane sweep.
class polyhedron_skeleton::cell {
 public:
  /// Returns the number of the plane.
  int id() const { return id_; }
  /// Returns the facets of the input in the plane, ascending.
  std::vector<int> facets() const;
  /// Returns the sheets between it and other cells, ascending.
  std::vector<sheet> sheets() const;

  using handle = polyhedron_skeleton::handle;
  cell(handle of, int id) : of_(std::move(of)), id_(id) {}
  friend bool operator==(const cell& a, const cell& b) { return a.id_ == b.id_ && a.of_.data == b.of_.data && a.of_.raw == b.of_.raw; }

 private:
  handle of_;
  int id_;
};

/// Computes the straight skeleton of a solid. *Throws* unsupported_error for what this version
/// cannot take, undecided_error (number_kernel::floating only). *Complexity*: see
/// docs/theory/events.md; a few milliseconds for a hundred facets.
polyhedron_skeleton skeletonize(const polyhedron& p, const polyhedron_options& options = {});

}  // namespace osteon
