// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Whether a stretch of an arc lies inside a sheet that is given by its borders, in the limit.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/limit_points.hpp"

namespace osteon {

/// Locates stretches by counting the borders that a ray meets.
template <unperturbed_kernel<3> K>
class stretch_location {
 public:
  /// Both must outlive the object.
  stretch_location(const K& k, limit_points<K>& points) : k_(k), points_(points) {}

  /// Returns whether a stretch lies inside a part, with these borders, of the common border of two
  /// facets' cells.
  /// *Requires* that it lies inside or outside, not on the borders. *Complexity* linear in the
  /// borders.
  bool contains(const std::vector<stretch>& borders, const stretch& inner, const std::array<plane_id, 2>& facets) {
    const plane_id a = facets[0];
    const plane_id b = facets[1];
    const std::vector<plane_id> through = points_.planes_through(inner);
    if (points_.later(inner.second, inner.first)) {
      for (const plane_id third : through)
        if (k_.orientation(a, b, third) != sign::zero) return contains_over_time(borders, inner, {a, b, third});
      return false;
    }
    // All at one moment: the part lies in plane a. The stretch lies on the line of a and some plane
    // c.
    if (!std::all_of(borders.begin(), borders.end(),
                     [&](const stretch& e) { return points_.simultaneous(e.first, inner.first) && points_.simultaneous(e.second, inner.first); }))
      return false;
    const auto& planes = points_[inner.first].planes;
    for (const plane_id c : through)
      if (c != a && c != b && std::any_of(planes.begin(), planes.end(), [&](plane_id d) { return k_.orientation(a, c, d) != sign::zero; }))
        return contains_at_once(borders, inner, a, c);
    return false;
  }

 private:
  using meeting = typename K::meeting;

  // For a stretch of one moment: counts the borders met by the ray from within the stretch through
  // its second end, moved a little to the inner side of c so that it meets no end of a border.
  bool contains_at_once(const std::vector<stretch>& borders, const stretch& inner, plane_id a, plane_id c) {
    const auto& from = points_[inner.first];
    plane_id gate = -1;  // a plane through the second end that cuts the line
    for (const plane_id d : points_[inner.second].planes)
      if (points_.side(d, from) != sign::zero) gate = d;
    if (gate < 0) return false;
    bool inside = false;
    for (const stretch& e : borders) {
      const sign first = points_.side(c, points_[e.first]);
      const sign second = points_.side(c, points_[e.second]);
      if ((first == sign::positive) == (second == sign::positive)) continue;
      sign beyond = sign::zero;
      if (first == sign::zero || second == sign::zero)
        beyond = points_.side(gate, points_[first == sign::zero ? e.first : e.second]);
      else
        beyond = side_of_crossing(gate, e, a, c, *from.moment);
      if (beyond != points_.side(gate, from)) inside = !inside;
    }
    return inside;
  }

  // The side of plane `gate` on which a border in plane a crosses plane c.
  sign side_of_crossing(plane_id gate, const stretch& border, plane_id a, plane_id c, const meeting& moment) {
    for (const plane_id e : points_.planes_through(border))
      if (k_.orientation(a, c, e) != sign::zero && points_.side(e, points_[border.first]) == sign::zero &&
          points_.side(e, points_[border.second]) == sign::zero)
        return e == gate ? sign::zero : k_.side(gate, a, c, e, moment);
    return sign::zero;
  }

  // Whether the vertex of three planes, the first two those of the part, is inside: at a moment
  // within the stretch an odd number of the part's borders lies ahead on the line of those two.
  bool contains_over_time(const std::vector<stretch>& borders, const stretch& inner, const triple& planes) {
    bool inside = false;
    for (const auto& [x, y] : borders) {
      const int begin = points_.later(x, inner.first) ? x : inner.first;
      const int end = points_.later(y, inner.second) ? inner.second : y;
      if (!points_.later(end, begin) || (x == inner.first && y == inner.second)) continue;
      const meeting& last = *points_[end].moment;
      const plane_id c = third_plane({x, y}, planes);
      if (c < 0) continue;
      const auto met = k_.meet({planes[0], planes[1], planes[2], c});
      const sign ahead =
          met ? (k_.compare(*met, last) == sign::negative ? -slope(*met, c) : slope(*met, c)) : k_.side(c, planes[0], planes[1], planes[2], last);
      if (ahead * k_.orientation(planes[0], planes[1], c) == sign::positive) inside = !inside;
    }
    return inside;
  }

  // A plane through a border, not the third, that cuts the line of the first two planes.
  plane_id third_plane(const stretch& border, const triple& planes) {
    for (const plane_id c : points_.planes_through(border))
      if (k_.orientation(planes[0], planes[1], c) != sign::zero && c != planes[2]) return c;
    return -1;
  }

  // Sign of S / lambda_c: of the distance of the other three planes' vertex from plane c before the
  // meeting.
  sign slope(const meeting& m, plane_id c) const {
    const quadruple q = k_.planes(m);
    return k_.closing(m) * lambda(q, position(q, c), [this](plane_id i, plane_id j, plane_id l) { return k_.orientation(i, j, l); });
  }

  const K& k_;
  limit_points<K>& points_;
};

}  // namespace osteon
