// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a solid promises, checked by its coordinates, and that it is the solid that its mesh describes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "check.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon::fuzz {

inline rational value(const exact_number<integer>& x) {
  const auto power = [](int base, int exponent) {
    const integer p = pow(integer(base), static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? rational(1, p) : rational(p);
  };
  return rational(x.mantissa) * power(10, x.ten) * power(2, x.two);
}

/// Six times the volume that a mesh encloses.
inline rational volume_of(const input_mesh<integer>& m) {
  using place = std::array<rational, 3>;
  std::vector<place> points;
  for (const auto& p : m.points) points.push_back({value(p[0]), value(p[1]), value(p[2])});
  rational sum = 0;
  for (const auto& f : m.facets)
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
      const place& a = points[static_cast<std::size_t>(f[0])];
      const place& b = points[static_cast<std::size_t>(f[i])];
      const place& c = points[static_cast<std::size_t>(f[i + 1])];
      sum += dot(a, cross(b, c));
    }
  return sum;
}

class solid_check {
 public:
  explicit solid_check(const solid<integer>& s) : s_(s), b_(s.boundary) {}

  void run() const {
    check_planes();
    check_edges();
    check_vertices();
    check_rings();
  }

  /// Six times the volume, in the solid's own unit cubed: requires that run() passes.
  integer volume() const {
    integer sum = 0;
    for (const auto& ring : rings()) sum += dot(area_vector<integer>(s_.points, ring.corners), s_.points[ring.corners[0]]);
    return sum;
  }

  void check_against(const input_mesh<integer>& m) const {
    require(s_.facet_planes.size() == m.facets.size(), "every facet of the mesh has a plane");
    require(s_.input_points.size() == s_.points.size(), "every vertex comes from a point");
    for (std::size_t v = 0; v < s_.points.size(); ++v) {
      const auto p = static_cast<std::size_t>(s_.input_points[v]);
      require(p < m.points.size(), "a vertex comes from a point of the mesh");
      for (std::size_t axis = 0; axis < 3; ++axis)
        require(value({s_.points[v][axis] + s_.shift[axis], s_.ten, s_.two}) == value(m.points[p][axis]), "a vertex is where its point is");
    }
    for (std::size_t f = 0; f < m.facets.size(); ++f) {
      require(s_.facet_planes[f] >= 0 && s_.facet_planes[f] < b_.planes, "the plane of a facet is there");
      const auto& plane = s_.planes[s_.facet_planes[f]];
      require(m.weights.empty() ? plane.weight == 1 : plane.weight == m.weights[f], "a plane has its facet's weight");
    }
    const rational unit = value({1, s_.ten, s_.two});
    require(rational(volume()) * unit * unit * unit == volume_of(m), "the solid has the volume of the mesh");
  }

 private:
  void check_planes() const {
    require(b_.planes == static_cast<plane_id>(s_.planes.size()) && b_.planes >= 4, "a solid has four planes");
    for (const auto& p : s_.planes) {
      require(gcd(p.n[0], gcd(p.n[1], p.n[2])) == 1, "normals are primitive");
      require(p.weight > 0, "weights are positive");
    }
    auto sorted = s_.planes;
    std::sort(sorted.begin(), sorted.end());
    require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(), "planes differ");
  }

  bool on_plane(int v, plane_id p) const { return dot(s_.planes[p].n, s_.points[v]) == s_.planes[p].d; }

  void check_edges() const {
    require(b_.vertices.size() == s_.points.size(), "every vertex has a point");
    for (const auto& e : b_.edges) {
      for (const int v : e.ends) require(v >= 0 && v < static_cast<int>(b_.vertices.size()), "the ends of an edge are there");
      for (const plane_id p : e.planes) require(p >= 0 && p < b_.planes, "the planes of an edge are there");
      require(e.ends[0] != e.ends[1] && e.planes[0] != e.planes[1], "an edge has two ends and two facets");
      for (const int v : e.ends)
        for (const plane_id p : e.planes) require(on_plane(v, p), "an edge lies in its facets");
      const auto along = s_.points[e.ends[1]] - s_.points[e.ends[0]];
      const integer angle = dot(along, cross(s_.planes[e.planes[0]].n, s_.planes[e.planes[1]].n));
      require(angle != 0 && e.convex == (angle > 0), "an edge is convex or reflex");
    }
  }

  void check_vertices() const {
    std::vector<int> uses(b_.edges.size());
    for (std::size_t v = 0; v < b_.vertices.size(); ++v) {
      const auto& [facets, edges] = b_.vertices[v];
      const std::size_t n = facets.size();
      require(n >= 3 && edges.size() == n, "a vertex has as many edges as facets, three at least");
      for (std::size_t m = 0; m < n; ++m) {
        require(facets[m] >= 0 && facets[m] < b_.planes && on_plane(static_cast<int>(v), facets[m]), "a vertex lies in its facets");
        require(edges[m] >= 0 && edges[m] < static_cast<int>(b_.edges.size()), "the edges of a vertex are there");
        const auto& e = b_.edges[edges[m]];
        const bool out = e.ends[0] == static_cast<int>(v);
        require(out || e.ends[1] == static_cast<int>(v), "the edges of a vertex end there");
        require(e.planes[out ? 1 : 0] == facets[m] && e.planes[out ? 0 : 1] == facets[(m + 1) % n], "edges lie between the facets around a vertex");
        ++uses[edges[m]];
      }
    }
    require(std::all_of(uses.begin(), uses.end(), [](int u) { return u == 2; }), "every edge is at two vertices");
  }

  struct loop {
    plane_id plane;
    std::vector<int> corners;
  };

  // Along each half-edge with its facet on the left; next comes the edge before it around the vertex where it ends.
  std::vector<loop> rings() const {
    std::vector<loop> result;
    std::vector<std::array<bool, 2>> seen(b_.edges.size());
    for (std::size_t first = 0; first < b_.edges.size(); ++first)
      for (const int side : {0, 1}) {
        if (seen[first][side]) continue;
        loop& r = result.emplace_back();
        r.plane = b_.edges[first].planes[side];
        for (int e = static_cast<int>(first), s = side; !seen[e][s];) {
          seen[e][s] = true;
          require(b_.edges[e].planes[s] == r.plane, "a ring stays in its plane");
          r.corners.push_back(b_.edges[e].ends[s]);
          const int to = b_.edges[e].ends[1 - s];
          const auto& edges = b_.vertices[to].edges;
          const auto at = std::find(edges.begin(), edges.end(), e) - edges.begin();
          e = edges[(static_cast<std::size_t>(at) + edges.size() - 1) % edges.size()];
          s = b_.edges[e].ends[0] == to ? 0 : 1;
        }
      }
    return result;
  }

  void check_rings() const {
    std::vector<vec<integer>> areas(s_.planes.size());
    for (const loop& r : rings()) {
      require(r.corners.size() >= 3, "a ring has three corners");
      const auto a = area_vector<integer>(s_.points, r.corners);
      for (std::size_t axis = 0; axis < 3; ++axis) areas[r.plane][axis] += a[axis];
    }
    for (std::size_t p = 0; p < areas.size(); ++p) {
      require(dot(areas[p], s_.planes[p].n) > 0, "a facet has area, and its normal points outwards");
      require(cross(areas[p], s_.planes[p].n) == vec<integer>{0, 0, 0}, "a facet lies in its plane");
    }
    require(volume() > 0, "the volume is positive");
  }

  const solid<integer>& s_;
  const boundary& b_;
};

}  // namespace osteon::fuzz
