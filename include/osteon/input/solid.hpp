// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From a mesh to a checked solid: planes for a kernel, incidences for the algorithms, and the way
/// back to the input.

#include <utility>
#include <vector>

#include "osteon/core/planes.hpp"
#include "osteon/input/facet_planes.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/half_edge_mesh.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/self_intersection.hpp"
#include "osteon/input/shells.hpp"
#include "osteon/input/solid_boundary.hpp"
#include "osteon/input/surface.hpp"
#include "osteon/input/touching_fans.hpp"
#include "osteon/space/boundary.hpp"

namespace osteon {

/// A checked solid. Coordinates are integers: input = (coordinate + shift) * 10^ten * 2^two.
template <class Int>
struct solid {
  std::vector<moving_plane<Int>> planes;  ///< all different
  osteon::boundary boundary;
  std::vector<vec<Int>> points;        ///< of the boundary's vertices
  std::vector<int> input_points;       ///< by vertex: the number of its point in the mesh, from 0
  std::vector<plane_id> facet_planes;  ///< by facet of the mesh
  /// after merging coplanar neighbours, components counted separately
  int facets = 0;
  vec<Int> shift;
  int ten = 0;
  int two = 0;
};

/// Returns the solid whose surface is a mesh. Coplanar neighbours are merged, vertices of degree
/// two removed, and planes with equal equation and weight share one number
/// (docs/theory/degeneracy.md).
/// *Throws* input_error naming the first fault, its element and a hint, unless the mesh is the
/// boundary of a solid: closed, of planar facets that meet only in common edges and points, normals
/// pointing outwards. A point may join several fans of facets only if each bounds material of its
/// own.
/// *Complexity* linear, but for sorting and the search for self-intersections.
template <class Int>
solid<Int> make_solid(input_mesh<Int> m) {
  surface<Int> s;
  s.input = std::move(m);
  check_facets(s.input);
  scale_points(s);
  check_points(s);
  s.edges = make_half_edge_mesh(s.input);
  find_planes(s);
  check_self_intersection(s);
  shells<Int>(s).check();
  touching_fans<Int>(s).check();
  solid_boundary<Int> boundary(s);
  solid<Int> result;
  for (const int p : boundary.points()) result.points.push_back(s.points[p]);
  result.input_points = std::move(boundary.points());
  result.boundary = std::move(boundary.result());
  result.facets = count_facets(s);
  result.planes = std::move(s.planes);
  result.facet_planes = std::move(s.facet_planes);
  result.shift = std::move(s.shift);
  result.ten = s.ten;
  result.two = s.two;
  return result;
}

}  // namespace osteon
