// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Polyhedra as a caller has them: points and facets.

#include <array>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "osteon/core/error.hpp"

namespace osteon {

/// What may be changed in a mesh before it is checked.
struct mesh_repairs {
  bool flip = false;         ///< reverse all facets, for a mesh whose normals point inwards
  bool triangulate = false;  ///< cut facets that are not planar into triangles
};

/// A solid bounded by flat facets: of any shape, with tunnels, voids and several bodies. A value
/// that never changes; copies share their data.
///
/// Points and facets are numbered from 0, as they were given. Coplanar neighbours count as one
/// facet, and points where they alone meet are no vertices.
///
/// *Threads*: const members may be called from several threads at once.
class polyhedron {
 public:
  using point = std::array<double, 3>;

  /// Makes a solid from points and facets, which are counter-clockwise seen from outside. Doubles
  /// are taken exactly. *Throws* input_error naming the fault, the element and a hint.
  /// *Complexity*: linear but for sorting and a search for self-intersections.
  polyhedron(const std::vector<point>& points, std::vector<std::vector<int>> facets, const mesh_repairs& repairs = {});

  /// Returns how many vertices, edges and facets there are, coplanar neighbours merged.
  int vertices() const;
  /// Returns how many edges there are between facets in different planes.
  int edges() const;
  /// Returns how many facets there are, coplanar neighbours merged.
  int facets() const;
  /// Returns how many planes the facets lie in. Skeletons go by these numbers.
  int planes() const;

  /// Returns the point of a vertex, or the vertex at a point. Several vertices may lie at one
  /// point: the first. *Throws* input_error(bad_index) where there is none.
  int point_of(int vertex) const;
  /// Returns the vertex at a point of the input, the first where there are several. *Throws*
  /// input_error(bad_index) where there is none.
  int vertex_at(int point) const;
  /// Returns how many edges meet in a vertex. *Throws* input_error(bad_index).
  int degree(int vertex) const;
  /// Returns the plane of a facet as given (the first, if it was cut). *Throws*
  /// input_error(bad_index).
  int plane_of(int facet) const;
  /// Returns the facets as given that lie in a plane, ascending. *Throws* input_error(bad_index).
  std::vector<int> facets_in(int plane) const;

  /// What the library has made of the mesh. Opaque.
  struct data;
  /// Returns it.
  const std::shared_ptr<const data>& access() const { return data_; }
  /// Takes it.
  explicit polyhedron(std::shared_ptr<const data> d) : data_(std::move(d)) {}

 private:
  std::shared_ptr<const data> data_;
};

/// Reads a closed polyhedron as Wavefront OBJ. Decimals are taken exactly. *Throws* input_error
/// naming the line, the element and a hint.
polyhedron read_polyhedron(const std::string& file, const mesh_repairs& repairs = {});
/// Reads a polyhedron from a stream; `name` is for messages.
polyhedron read_polyhedron(std::istream& in, const std::string& name, const mesh_repairs& repairs = {});

}  // namespace osteon
