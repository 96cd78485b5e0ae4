// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Points in which several fans of facets touch: which of them a solid may have.

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// The check of points with several fans. Each fan must bound material of its own there: as the
/// facets move, the fans part. Two fans that bound the same material (two voids that touch) would
/// make a tunnel between them.
template <class Int>
class touching_fans {
 public:
  /// *Requires* a surface with planes and half-edges that does not meet itself but in such points.
  explicit touching_fans(const surface<Int>& s) : s_(s) {}

  /// Refuses with input_error(non_manifold_vertex) a point in which a fan lies on the inner side of
  /// another.
  void check() const {
    std::map<int, std::vector<int>> at;  // the fans of a point
    for (const int h : s_.edges.fans()) at[s_.edges[h].from].push_back(h);
    for (const auto& [p, fans] : at)
      for (const int f : fans)
        for (const int g : fans)
          if (f != g && is_inside(f, g))
            s_.input.refuse_point(input_fault::non_manifold_vertex, static_cast<std::size_t>(p),
                                  " joins two fans of facets with material between them, a tunnel of no width",
                                  "move one fan a little away, with a point of its own");
  }

 private:
  // Where a direction in the plane of half-edge h's facet lies: in the facet's angle at h's corner,
  // on its border, or outside.
  location in_angle(int h, const vec<Int>& d) const {
    const vec<Int>& n = s_.normal_of(h);
    const vec<Int> a = s_.direction(h);
    const vec<Int> b = s_.points[s_.edges[s_.edges[h].previous].from] - s_.points[s_.edges[h].from];
    const auto left = [&](const vec<Int>& x, const vec<Int>& y) { return sign_of(Int(dot(n, cross(x, y)))); };
    const bool convex = left(a, b) == sign::positive;
    const sign from_a = left(a, d);
    const sign to_b = left(d, b);
    if ((from_a == sign::zero && dot(a, d) > 0) || (to_b == sign::zero && dot(b, d) > 0)) return location::border;
    const bool inside = convex ? from_a == sign::positive && to_b == sign::positive : from_a == sign::positive || to_b == sign::positive;
    return inside ? location::inside : location::outside;
  }

  // Whether the fan of half-edge g starts on the inner side of the fan of half-edge f around the
  // same point. Follows the straight way from g's direction to a direction within a facet of f,
  // chosen so that the way meets no edge of f.
  bool is_inside(int f, int g) const {
    const std::vector<int> facets = s_.edges.fan(f);
    for (unsigned attempt = 1; attempt <= 64; ++attempt) {
      for (const int target : facets) {
        const vec<Int> turned = cross(s_.normal_of(target), s_.direction(target));
        vec<Int> to = s_.direction(target);
        for (std::size_t x = 0; x < 3; ++x) to[x] = to[x] * (Int(1) << 2 * attempt) + turned[x];
        if (in_angle(target, to) != location::inside) continue;
        const auto from_inside = meets_from_inside(facets, target, s_.direction(g), to);
        if (from_inside) return *from_inside;
      }
    }
    return true;
  }

  // Whether the straight way from one direction to another, in the target's facet, meets the first
  // of the facets from inside; nothing where it meets that facet in an edge.
  std::optional<bool> meets_from_inside(const std::vector<int>& facets, int target, const vec<Int>& from, const vec<Int>& to) const {
    sign side = sign_of(Int(dot(s_.normal_of(target), from)));
    if (side == sign::zero) return std::nullopt;
    Int done = 1;  // the way to the first facet as done / whole
    Int whole = 1;
    for (const int h : facets) {
      const vec<Int>& n = s_.normal_of(h);
      Int start = dot(n, from);
      Int end = dot(n, to);
      const sign here = sign_of(start);
      if (h == target || here * sign_of(end) != sign::negative) continue;
      if (start < 0) start = -start;
      if (end < 0) end = -end;
      vec<Int> hit;
      for (std::size_t x = 0; x < 3; ++x) hit[x] = from[x] * end + to[x] * start;
      const bool opposite = hit[0] == 0 && hit[1] == 0 && hit[2] == 0;
      const location where = in_angle(h, hit);
      if (opposite || where == location::border) return std::nullopt;
      if (where == location::inside && start * whole < done * (start + end)) {
        done = start;
        whole = start + end;
        side = here;
      }
    }
    return side == sign::negative;
  }

  const surface<Int>& s_;
};

}  // namespace osteon
