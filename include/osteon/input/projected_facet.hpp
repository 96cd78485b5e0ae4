// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A facet and what lies in its plane, projected to two axes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// Where a surface meets itself although it must not.
struct bad_contact {
  /// What touches what.
  enum class kind : std::uint8_t {
    edge,  ///< edge (a,b) meets the facet outside their common corners and edges
    /// the facet's loop passes the point a more than once, and its inside overlaps or turns over
    /// there
    corner,
    /// the facet and facet `other` pass through each other between their common corners a and b
    chord
  };
  kind what;
  int facet;
  int a;
  int b = -1;
  int other = -1;
};

/// A facet of a surface, projected along the axis of its normal's largest component. Points are
/// numbers of the surface's points; they lie in the facet's plane.
template <class Int>
class projected_facet {
 public:
  /// *Requires* a surface with planes.
  projected_facet(const surface<Int>& s, int f)
      : s_(s), loop_(s.loop(static_cast<std::size_t>(f))), axes_(projection(s.plane(static_cast<std::size_t>(f)).n)) {}

  /// Returns the points of the facet, in order.
  const std::vector<int>& loop() const { return loop_; }
  /// Returns the axes that are kept, in the order in which counter-clockwise stays
  /// counter-clockwise.
  const std::array<int, 2>& axes() const { return axes_; }
  /// Returns the projection of a point.
  point2<Int> at(int p) const { return projected(s_.points[p], axes_); }

  /// Returns where a point of the facet's plane lies.
  location locate(const point2<Int>& p) const { return locate_in_polygon<Int>(s_.points, loop_, p, axes_); }
  /// Returns where the middle between two points lies.
  location locate_middle(int a, int b) const {
    const auto sum = [&](int axis) -> Int { return s_.points[a][axis] + s_.points[b][axis]; };
    return locate({sum(axes_[0]), sum(axes_[1]), Int(2)});
  }

  /// Returns whether the edges (a,b) and (p,q) meet anywhere but in a common end, or but as a
  /// whole.
  bool edges_meet(int a, int b, int p, int q) const {
    if ((a == p && b == q) || (a == q && b == p)) return false;
    for (const int axis : axes_) {
      const auto x = [&](int point) { return s_.rough[point][axis]; };
      if (std::max(x(a), x(b)) < std::min(x(p), x(q)) || std::max(x(p), x(q)) < std::min(x(a), x(b))) return false;
    }
    const auto on = [&](int u, int v, int w) {  // w on the closed segment uv
      const std::array<int, 2> two = {u, v};
      return locate_in_polygon<Int>(s_.points, two, at(w), axes_) == location::border;
    };
    if (a == p || a == q) return on(a, b, a == p ? q : p) || on(p, q, b);
    if (b == p || b == q) return on(a, b, b == p ? q : p) || on(p, q, a);
    const auto side = [&](int u, int v, int w) { return turn(s_.points[u], s_.points[v], at(w), axes_); };
    const sign across = side(a, b, p) * side(a, b, q);
    if (across == sign::positive) return false;
    if (across == sign::negative && side(p, q, a) * side(p, q, b) == sign::negative) return true;
    return on(a, b, p) || on(a, b, q) || on(p, q, a) || on(p, q, b);
  }

 private:
  const surface<Int>& s_;
  const std::vector<int>& loop_;
  std::array<int, 2> axes_;
};

}  // namespace osteon
