// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Edges as pieces of moving lines, and the two questions about points on them that splitting and
/// the wavefront ask alike. A vertex (l,i,j) is the point where three planes meet.

#include <array>
#include <initializer_list>
#include <optional>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"

namespace osteon {

/// A piece of the line of two planes. Towards end s it is bounded by the plane `third[s]` (none: it
/// runs to infinity), on whose inner or outer side it lies. Planes ascend. End 0 is the tail: from
/// it the segment runs in the direction n_0 x n_1, towards end 1.
struct segment {
  std::array<plane_id, 2> planes;
  std::array<plane_id, 2> third = {-1, -1};
  std::array<bool, 2> inside = {false, false};
  bool convex;  ///< dihedral angle of the solid below 180 degrees

  /// Returns the other one of the two planes.
  plane_id other(plane_id p) const { return planes[0] == p ? planes[1] : planes[0]; }
};

/// Returns the sign of a predicate that must not be zero.
/// *Throws* degenerate_error with the question and its planes where it is zero.
template <kernel<3> K>
sign generic(const K&, sign s, const char* question, std::initializer_list<plane_id> planes) {
  if (s == sign::zero) throw degenerate_error(planes, question);
  return s;
}

/// Returns the side of plane d on which vertex (a,b,c) lies at the moment of m. *Throws* as
/// generic.
template <kernel<3> K>
sign generic_side(const K& k, plane_id d, plane_id a, plane_id b, plane_id c, const typename K::meeting& m) {
  return generic(k, k.side(d, a, b, c, m), "the distance of a vertex from a plane", {a, b, c, d});
}

/// Returns the orientation of three planes. *Throws* as generic.
template <kernel<3> K>
sign generic_orientation(const K& k, plane_id a, plane_id b, plane_id c) {
  return generic(k, k.orientation(a, b, c), "the orientation", {a, b, c});
}

/// Returns whether a segment on the line of p and q lies on the inner side of plane `third` near
/// its end there: at a tail it runs in the direction n_0 x n_1, along which h_third grows iff
/// orientation(n_0, n_1, n_third) < 0.
/// *Requires* p < q. *Throws* as generic.
template <kernel<3> K>
bool runs_inside(const K& k, plane_id p, plane_id q, plane_id third, int end) {
  return (generic_orientation(k, p, q, third) == sign::negative) == (end == 0);
}

/// Returns whether the vertex (e.planes, x) lies on the closed segment at the moment m. An end in
/// plane x is that vertex.
/// *Throws* as generic.
template <kernel<3> K>
bool on_segment(const K& k, const segment& e, plane_id x, const typename K::meeting& m) {
  for (int s = 0; s < 2; ++s)
    if (e.third[s] >= 0 && e.third[s] != x && (generic_side(k, e.third[s], e.planes[0], e.planes[1], x, m) == sign::positive) != e.inside[s])
      return false;
  return true;
}

/// Returns whether vertex (l,i,j) lies in the facet of plane l that these edges bound; nothing
/// where that cannot be seen. The first edge is decisive that a ray meets: from the vertex along
/// the line (l,i), to the inner or outer side of j, moved a little to the inner side of i so that
/// it meets no end of an edge.
/// *Requires* that the vertex lies on none of the edges; a fourth plane that passes through it must
/// be named. *Throws* as generic. *Complexity* linear in the number of edges.
template <kernel<3> K, class Segments>
std::optional<bool> locate_in_facet(const K& k, const Segments& edges_of_l, plane_id l, plane_id i, plane_id j, bool into_j,
                                    const typename K::meeting& m, plane_id fourth = -1) {
  const segment* nearest = nullptr;
  bool vertex_inside = false;  // of the nearest edge's other plane
  for (const segment& e : edges_of_l) {
    const plane_id x = e.other(l);
    if (x == i || x == j || x == fourth || k.orientation(l, i, x) == sign::zero) continue;
    if ((generic_side(k, j, l, i, x, m) == sign::positive) != into_j) continue;
    bool crossed = true;
    for (int s = 0; s < 2 && crossed; ++s) {
      if (e.third[s] < 0) continue;
      crossed = e.third[s] == i ? e.inside[s] : (generic_side(k, e.third[s], l, i, x, m) == sign::positive) == e.inside[s];
    }
    if (!crossed) continue;
    const bool here = generic_side(k, x, l, i, j, m) == sign::positive;
    if (nearest != nullptr && (nearest->other(l) == x || (generic_side(k, x, l, i, nearest->other(l), m) == sign::positive) == here)) continue;
    nearest = &e;
    vertex_inside = here;
  }
  if (nearest == nullptr) return std::nullopt;
  return vertex_inside == nearest->convex;
}

}  // namespace osteon
