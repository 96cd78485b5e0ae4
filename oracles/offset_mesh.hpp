// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The offset polyhedron at one moment, cut out of a skeleton: points in exact rationals, facets as rings. For rational
/// speeds and solids in general position. Every step checks what the skeleton promises and throws offset_error where it does not hold.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::oracles {

struct offset_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct offset_mesh {
  /// All of one plane: outer rings counter-clockwise seen from outside, holes clockwise, in no order.
  struct facet {
    plane_id plane;
    std::vector<std::vector<int>> rings;
  };
  std::vector<std::array<rational, 3>> points;
  std::vector<int> arcs;  ///< by point
  std::vector<facet> facets;
};

/// The speeds that the rational kernel promises, for planes whose normals have no common factor: w |n| rounded down to multiples of 2^-64.
inline std::vector<rational> rational_speeds(std::span<const moving_plane<integer>> planes) {
  std::vector<rational> result;
  for (const auto& p : planes) {
    const integer square = p.weight * p.weight * (p.n[0] * p.n[0] + p.n[1] * p.n[1] + p.n[2] * p.n[2]);
    result.push_back(rational(isqrt(square << 128U), integer(1) << 64U));
  }
  return result;
}

class offset_cutter {
 public:
  offset_cutter(std::span<const moving_plane<integer>> planes, std::vector<rational> speeds, const skeleton& s)
      : planes_(planes), speeds_(std::move(speeds)), s_(s) {
    for (const auto& n : s.nodes) times_.push_back(n.vertex >= 0 ? rational(0) : meeting_time(n.planes));
  }

  /// By node.
  const std::vector<rational>& times() const { return times_; }
  rational last() const { return *std::max_element(times_.begin(), times_.end()); }

  /// Requires that t is positive and no node's time.
  offset_mesh at(const rational& t) const {
    if (t <= 0 || std::find(times_.begin(), times_.end(), t) != times_.end()) throw offset_error("the moment of an event has no single offset");
    offset_mesh m;
    std::map<int, std::vector<int>> ends;  // by polygon of the skeleton, the points of its edges
    for (std::size_t a = 0; a < s_.arcs.size(); ++a) {
      const auto& arc = s_.arcs[a];
      if (time(arc.source) > t || time(arc.target) < t) continue;
      for (const int sheet : arc.sheets) ends[s_.sheets[static_cast<std::size_t>(sheet)].representative].push_back(static_cast<int>(m.points.size()));
      m.arcs.push_back(static_cast<int>(a));
      m.points.push_back(corner(arc.planes, t));
    }
    std::map<plane_id, std::multimap<int, int>> next;  // by plane and point, where edges lead
    for (auto& [polygon, points] : ends) add_edges(m, s_.sheets[static_cast<std::size_t>(polygon)].facets, std::move(points), next);
    for (auto& [plane, edges] : next) m.facets.push_back({plane, rings(m, plane, std::move(edges))});
    return m;
  }

  /// The same corners at another moment, as if no event had happened since: what oracles must notice.
  offset_mesh carried(offset_mesh m, const rational& t) const {
    for (std::size_t p = 0; p < m.points.size(); ++p) m.points[p] = corner(s_.arcs[static_cast<std::size_t>(m.arcs[p])].planes, t);
    return m;
  }

 private:
  using vector = std::array<rational, 3>;

  const rational& time(int node) const { return times_[static_cast<std::size_t>(node)]; }
  const std::array<integer, 3>& n(plane_id i) const { return planes_[static_cast<std::size_t>(i)].n; }

  template <class A, class B>
  static rational dot(const A& a, const B& b) {
    return rational(a[0]) * rational(b[0]) + rational(a[1]) * rational(b[1]) + rational(a[2]) * rational(b[2]);
  }
  template <class A>
  static A cross(const A& a, const A& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static vector difference(const vector& a, const vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  // x where n . x = d - t sigma for three planes: sum (d_i - t sigma_i) n_j x n_k / det.
  vector corner(const triple& p, const rational& t) const {
    const rational det = dot(n(p[0]), cross(n(p[1]), n(p[2])));
    if (det == 0) throw offset_error("a vertex lives whose planes meet in no point");
    vector x = {0, 0, 0};
    for (std::size_t r = 0; r < 3; ++r) {
      const auto i = static_cast<std::size_t>(p[r]);
      const auto direction = cross(n(p[(r + 1) % 3]), n(p[(r + 2) % 3]));
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += (rational(planes_[i].d) - t * speeds_[i]) * rational(direction[axis]) / det;
    }
    return x;
  }

  // The corner of three of the planes reaches the fourth when h = now - t loss is zero.
  rational meeting_time(const quadruple& q) const {
    for (std::size_t r = 0; r < 4; ++r) {
      const triple p = {q[r], q[(r + 1) % 4], q[(r + 2) % 4]};
      if (dot(n(p[0]), cross(n(p[1]), n(p[2]))) == 0) continue;
      const auto height = [&](const rational& t) {
        const auto l = static_cast<std::size_t>(q[(r + 3) % 4]);
        return rational(planes_[l].d) - t * speeds_[l] - dot(planes_[l].n, corner(p, t));
      };
      const rational now = height(0);
      const rational loss = now - height(1);
      if (loss != 0) return now / loss;
    }
    throw offset_error("the planes of an event meet at no single moment");
  }

  // The points of one polygon, along the line of its two facets, are ends of edges in pairs. An edge runs with its facet on the left.
  void add_edges(const offset_mesh& m, const std::array<plane_id, 2>& facets, std::vector<int> points,
                 std::map<plane_id, std::multimap<int, int>>& next) const {
    const auto direction = cross(n(facets[0]), n(facets[1]));
    std::map<int, rational> along;
    for (const int p : points) along[p] = dot(direction, m.points[static_cast<std::size_t>(p)]);
    std::sort(points.begin(), points.end(), [&](int a, int b) { return along[a] != along[b] ? along[a] < along[b] : a < b; });
    if (points.size() % 2 != 0) throw offset_error("an edge has one end");
    for (std::size_t i = 0; i < points.size(); i += 2) {
      const int u = points[i];
      const int v = points[i + 1];
      if (along[u] == along[v]) throw offset_error("an edge has length zero");
      const bool convex = is_convex(m, facets, u, direction, true);
      if (convex != is_convex(m, facets, v, direction, false)) throw offset_error("an edge is convex at one end and reflex at the other");
      next[facets[convex ? 0 : 1]].emplace(u, v);
      next[facets[convex ? 1 : 0]].emplace(v, u);
    }
  }

  // The edge that leaves the corner of point p along the direction, or against it, by what the skeleton says of that corner.
  bool is_convex(const offset_mesh& m, const std::array<plane_id, 2>& facets, int p, const std::array<integer, 3>& direction, bool forwards) const {
    const auto& arc = s_.arcs[static_cast<std::size_t>(m.arcs[static_cast<std::size_t>(p)])];
    for (unsigned r = 0; r < 3; ++r) {
      const plane_id third = arc.planes[r];
      if (third == facets[0] || third == facets[1]) continue;
      const bool inside = (dot(n(third), direction) < 0) == forwards;
      const auto piece = local::corner_piece(arc.corner, r, inside);
      if (piece == local::piece::none) throw offset_error("an edge leaves a corner where the corner has none");
      return piece == local::piece::convex;
    }
    throw offset_error("a vertex is the end of an edge of other planes");
  }

  // A facet touches a point once, or at a majority corner twice: then the left turn stays in the same piece of the facet.
  std::vector<std::vector<int>> rings(const offset_mesh& m, plane_id plane, std::multimap<int, int> next) const {
    std::vector<std::vector<int>> result;
    while (!next.empty()) {
      auto& ring = result.emplace_back();
      auto edge = next.begin();
      const auto first = *edge;
      for (;;) {
        const auto [u, v] = *edge;
        ring.push_back(u);
        next.erase(edge);
        const auto [lo, hi] = next.equal_range(v);
        if (v == first.first && (lo == hi || turns_left(m, plane, u, v, first.second))) break;
        edge = lo;
        if (lo != hi && std::next(lo) != hi && !turns_left(m, plane, u, v, lo->second)) edge = std::next(lo);
        if (lo == hi) throw offset_error("a ring of edges does not close");
      }
      if (ring.size() < 3) throw offset_error("a facet has two corners");
    }
    return result;
  }

  bool turns_left(const offset_mesh& m, plane_id plane, int u, int v, int w) const {
    const auto at = [&m](int p) -> const vector& { return m.points[static_cast<std::size_t>(p)]; };
    return dot(n(plane), cross(difference(at(v), at(u)), difference(at(w), at(v)))) > 0;
  }

  std::span<const moving_plane<integer>> planes_;
  std::vector<rational> speeds_;
  const skeleton& s_;
  std::vector<rational> times_;
};

}  // namespace osteon::oracles
