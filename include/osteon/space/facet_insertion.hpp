// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Facet insertions. Where a third plane through a vertex contains the line of one of its edges (a
/// straight angle in one facet is enough), the vertex may have no valid split that stays near: the
/// third facet pushes itself between the two facets of the edge along its whole length, at infinite
/// speed. That is done here, before the vertices are split: the edge becomes two edges on the same
/// line, and the facet joins the ring around its other end.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/segment.hpp"

namespace osteon {

/// An insertion: facet `plane` between the two facets of an edge.
struct facet_insertion {
  int vertex;
  std::size_t side;    ///< the edge's position at the vertex
  plane_id plane;      ///< that contains its line
  bool convex_first;   ///< the edge between the facet before and the inserted one
  bool convex_second;  ///< the edge between the inserted facet and the one after
};

/// Returns all insertions at a vertex that leave the inserted facet a strip of positive width: its
/// two borders are parallel, and just after the start each lies on the facet's side of the other.
/// That is decided in the plane across the edge; the fourth plane of the predicates only cuts it
/// out.
/// *Complexity* quadratic in the vertex's degree.
template <kernel<3> K>
std::vector<facet_insertion> facet_insertions_at(const K& k, const boundary& b, int vertex) {
  std::vector<facet_insertion> result;
  const auto& v = b.vertices[static_cast<std::size_t>(vertex)];
  const std::size_t n = v.facets.size();
  for (std::size_t m = 0; m < n; ++m) {
    const plane_id p = v.facets[m];
    const plane_id q = v.facets[(m + 1) % n];
    const auto across = std::find_if(v.facets.begin(), v.facets.end(), [&](plane_id x) { return x != p && x != q && k.transversal(p, q, x); });
    if (across == v.facets.end()) continue;
    const plane_id x = *across;
    for (const plane_id r : v.facets) {
      if (r == p || r == q || k.transversal(p, q, r) || !k.transversal(p, r, x) || !k.transversal(r, q, x)) continue;
      // n_r = alpha n_p + beta n_q; the new edges run in the direction of the old one.
      const bool convex = b.edges[static_cast<std::size_t>(v.edges[m])].convex;
      const sign whole = k.orientation(p, q, x);
      const bool first = (k.orientation(p, r, x) == whole) == convex;
      const bool second = (k.orientation(r, q, x) == whole) == convex;
      if ((k.side(p, r, q, x, k.start()) == sign::positive) != first) continue;
      if ((k.side(q, p, r, x, k.start()) == sign::positive) != second) continue;
      result.push_back({vertex, m, r, first, second});
    }
  }
  return result;
}

/// Returns the boundary after an insertion. The edge keeps its number for its first half, the
/// second half is the last edge. Nothing moves: both lie where the edge was.
inline boundary after_insertion(boundary b, const facet_insertion& f) {
  const int e = b.vertices[static_cast<std::size_t>(f.vertex)].edges[f.side];
  const auto old = b.edges[static_cast<std::size_t>(e)];
  const int second = static_cast<int>(b.edges.size());
  const int other = old.ends[0] == f.vertex ? old.ends[1] : old.ends[0];
  {
    auto& v = b.vertices[static_cast<std::size_t>(f.vertex)];
    const plane_id p = v.facets[f.side];
    const plane_id q = v.facets[(f.side + 1) % v.facets.size()];
    b.edges[static_cast<std::size_t>(e)] = {old.ends, {p, f.plane}, f.convex_first};
    b.edges.push_back({old.ends, {f.plane, q}, f.convex_second});
    v.facets.insert(v.facets.begin() + static_cast<std::ptrdiff_t>(f.side) + 1, f.plane);
    v.edges.insert(v.edges.begin() + static_cast<std::ptrdiff_t>(f.side) + 1, second);
  }
  // Seen from the other end the two facets follow each other the other way round.
  auto& u = b.vertices[static_cast<std::size_t>(other)];
  const auto at = std::find(u.edges.begin(), u.edges.end(), e) - u.edges.begin();
  u.facets.insert(u.facets.begin() + at + 1, f.plane);
  u.edges.insert(u.edges.begin() + at, second);
  return b;
}

}  // namespace osteon
