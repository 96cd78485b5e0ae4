// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The wavefront as the certificate replays it.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// Rings of edges at a time of the replay.
template <kernel<2> K>
struct replayed_front {
  /// An edge; the vertex at its head moves along an arc.
  struct edge {
    line_id line;
    int face;    ///< an edge of the polygon
    int before;  ///< the edge that ends where this one starts; meaningless for an edge that is gone
    /// the edge that starts where this one ends, or -1 for an edge that is gone from the start or
    /// with length zero
    int after;
    int arc;  ///< of its head, or -1
  };
  std::vector<edge> edges;
  /// by arc: the edge that ends at the moving vertex, -1 unless it moves now
  std::vector<int> edge_of;
  disjoint_sets faces;      ///< edges of the polygon that have become one
  typename K::meeting now;  ///< the last event

  /// Makes one of two edges' faces. Throws a refutation with the given witness where the skeleton
  /// gives them different faces.
  void merge_faces(const skeleton& s, int f, int g, const char* what, int number) {
    certificate::demand(s.faces[f] == s.faces[g], rule::face, what, number, "edges become one, but not their faces");
    faces.unite(f, g);
  }
};

/// Returns where the point in which line `l` meets line y lies at the time of m, seen in the
/// direction of l from the point where it meets line x.
/// *Requires* lines x and y that are not parallel to l.
template <kernel<2> K>
sign is_beyond(const K& k, line_id l, line_id x, line_id y, const typename K::meeting& m) {
  if (x == y) return sign::zero;
  return -(k.orientation(l, x) * k.side(x, l, y, m));
}

}  // namespace osteon::plane
