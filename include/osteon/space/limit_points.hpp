// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Where the nodes of a raw skeleton are in the limit, when the perturbation has gone to zero.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// Two neighbouring points on an arc, the lower number first. It is not empty.
using stretch = std::pair<int, int>;

/// The points in space and time at which a raw skeleton's nodes are in the limit, numbered in order
/// of time; those of the solid's vertices come first. Nodes of one point differ only by the
/// perturbation: the kernel's zeros tell.
template <unperturbed_kernel<3> K>
class limit_points {
 public:
  using meeting = typename K::meeting;

  /// A point in space at a moment.
  struct point {
    std::optional<meeting> moment;  ///< none: time zero
    /// that meet only in the point; of a vertex of the solid any three of its planes
    triple planes;
  };

  /// Finds the points.
  /// *Complexity* linear plus, for nodes of one moment, their pairs.
  limit_points(const K& k, const boundary& solid, const skeleton& raw) : k_(k), solid_(solid), raw_(raw), of_node_(raw.nodes.size()) {
    std::size_t first_of_moment = 0;  // among points
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const auto& node = raw_.nodes[n];
      if (node.vertex >= 0) {
        of_node_[n] = add({std::nullopt, {node.planes[0], node.planes[1], node.planes[2]}}, n);
        first_of_moment = points_.size();
        continue;
      }
      const point p = locate(node.planes);
      if (first_of_moment < points_.size() && k_.compare(*points_[first_of_moment].moment, *p.moment) != sign::zero) first_of_moment = points_.size();
      int found = -1;
      for (std::size_t q = first_of_moment; q < points_.size() && found < 0; ++q)
        if (on_planes(p, points_[q].planes)) found = static_cast<int>(q);
      if (found >= 0) nodes_at_[found].push_back(static_cast<int>(n));
      of_node_[n] = found >= 0 ? found : add(p, n);
    }
    planes_.resize(points_.size());
  }

  /// Returns the number of points.
  int size() const { return static_cast<int>(points_.size()); }
  /// Returns point number p.
  const point& operator[](int p) const { return points_[p]; }
  /// Returns the number of a raw node's point.
  int of_node(int n) const { return of_node_[n]; }
  /// Returns the raw nodes at a point, ascending.
  const std::vector<int>& nodes_at(int p) const { return nodes_at_[p]; }

  /// Returns whether point p is strictly later than q.
  bool later(int p, int q) const {
    const auto& a = points_[p].moment;
    const auto& b = points_[q].moment;
    return a && (!b || k_.compare(*a, *b) == sign::positive);
  }
  /// Returns whether two points are of one moment after time zero.
  bool simultaneous(int p, int q) const {
    const auto& a = points_[p].moment;
    const auto& b = points_[q].moment;
    return a && b && k_.compare(*a, *b) == sign::zero;
  }

  /// Returns the side of plane d on which a point lies: zero on the plane.
  /// *Requires* a point after time zero.
  sign side(plane_id d, const point& p) const {
    if (position(p.planes, d) < p.planes.size()) return sign::zero;
    return k_.side(d, p.planes[0], p.planes[1], p.planes[2], *p.moment);
  }

  /// Returns all planes that pass through a point at its moment, ascending; found once.
  /// *Complexity* linear in the number of planes.
  const std::vector<plane_id>& planes_through(int p) {
    auto& result = planes_[p];
    if (!result.empty()) return result;
    if (const int vertex = raw_.nodes[nodes_at_[p][0]].vertex; vertex >= 0) {
      result = solid_.vertices[vertex].facets;
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
    } else {
      for (plane_id d = 0; d < solid_.planes; ++d)
        if (side(d, points_[p]) == sign::zero) result.push_back(d);
    }
    return result;
  }
  /// Returns all planes that pass through both ends of a stretch, ascending.
  std::vector<plane_id> planes_through(const stretch& e) {
    std::vector<plane_id> through;
    const auto& first = planes_through(e.first);
    const auto& second = planes_through(e.second);
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(through));
    return through;
  }

  /// Returns the points strictly between the ends of an arc of these planes (ascending), in their
  /// order along it.
  /// *Complexity* linear in the points within its time.
  std::vector<int> between(const triple& planes, int from, int to) {
    std::vector<int> result;
    if (!simultaneous(from, to)) {
      for (int p = from + 1; p < to; ++p)
        if (points_[p].moment && lies_on(p, planes) && later(p, from) && later(to, p)) result.push_back(p);
      return result;
    }
    int first = std::min(from, to);
    while (first > 0 && simultaneous(first - 1, from)) --first;
    for (int p = first; p < size() && simultaneous(p, from); ++p)
      if (p != from && p != to && lies_on(p, planes) && separates(p, from, to)) result.push_back(p);
    std::sort(result.begin(), result.end(), [&](int p, int q) { return separates(p, from, q); });
    return result;
  }

 private:
  int add(const point& p, std::size_t node) {
    points_.push_back(p);
    nodes_at_.push_back({static_cast<int>(node)});
    return size() - 1;
  }

  point locate(const quadruple& q) const {
    const auto moment = k_.meet(q);
    if (!moment) broken_invariant<K>("the planes of an event meet in the limit");
    for (unsigned r = 0; r < 4; ++r)
      if (const triple t = omit(q, r); k_.orientation(t[0], t[1], t[2]) != sign::zero) return {moment, t};
    broken_invariant<K>("three planes of an event meet in a point in the limit");
  }

  bool on_planes(const point& p, const triple& planes) const {
    return std::all_of(planes.begin(), planes.end(), [&](plane_id d) { return side(d, p) == sign::zero; });
  }

  // Whether all of three planes, ascending, pass through a point.
  bool lies_on(int p, const triple& planes) {
    const auto& through = planes_through(p);
    return std::includes(through.begin(), through.end(), planes.begin(), planes.end());
  }

  // Whether p lies between a and b, three collinear points of one moment: some plane through p has
  // them on either side.
  bool separates(int p, int a, int b) const {
    for (const plane_id d : points_[p].planes) {
      const sign s = side(d, points_[a]);
      if (s != sign::zero) return s * side(d, points_[b]) == sign::negative;
    }
    broken_invariant<K>("two points are the same or can be told apart");
  }

  const K& k_;
  const boundary& solid_;
  const skeleton& raw_;
  std::vector<point> points_;
  std::vector<std::vector<int>> nodes_at_;
  std::vector<int> of_node_;
  std::vector<std::vector<plane_id>> planes_;  // by point, where they have been asked for
};

}  // namespace osteon
