// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The offset surface of a split corner in exact coordinates at time one, and whether it meets itself, decided in two ways that share
/// nothing with osteon/split.hpp: on the sphere of directions (thesis 3.4), and in space, facet by facet.

#include <algorithm>
#include <array>
#include <vector>

#include "cone.hpp"
#include "triangulations.hpp"

namespace osteon::proofs {

/// A point x / w, w > 0, or a direction, w = 0.
template <class Int>
struct homogeneous {
  vec<Int> x;
  Int w;
};

/// One edge of the surface, between facets a and b; ends are numbers of points. An input edge ends at infinity.
struct surface_edge {
  int a, b;
  std::array<std::size_t, 2> ends;
  std::array<int, 2> third;  ///< the third facet at each end, -1 at infinity
  bool convex;
};

template <class Int>
class offset_surface {
 public:
  /// `well_made` is false where a tree has a vertex at infinity.
  offset_surface(const cone& c, const std::vector<Int>& speeds, const triangulation& t) : c_(c), speed_(speeds), triangles_(t) {
    for (const auto& n : c.normal) normal_.push_back(widen(n));
    for (const auto& [i, j, k] : t) {
      const vec<Int> u = cross_product(normal(j), normal(k));
      const vec<Int> v = cross_product(normal(k), normal(i));
      const vec<Int> w = cross_product(normal(i), normal(j));
      homogeneous<Int> p{{}, inner_product(normal(i), u)};
      for (std::size_t axis = 0; axis < 3; ++axis) p.x[axis] = -(speed(i) * u[axis] + speed(j) * v[axis] + speed(k) * w[axis]);
      up_.push_back(p.w > 0);
      if (p.w == 0) return;
      if (p.w < 0) p = {{Int(-p.x[0]), Int(-p.x[1]), Int(-p.x[2])}, Int(-p.w)};
      points_.push_back(p);
    }
    const std::size_t nodes = points_.size();
    for (const auto& r : c.ray) points_.push_back({widen(r), Int(0)});
    for (std::size_t v = 0; v < nodes; ++v)
      for (int r = 0; r < 3; ++r) add(v, t[v][(r + 1) % 3], t[v][(r + 2) % 3], t[v][r]);
    for (int m = 0; m < c.degree(); ++m) {
      surface_edge& e = find(m, static_cast<int>(c.at(m + 1)));
      e.ends[1] = nodes + static_cast<std::size_t>(m);
      e.convex = c.convex[c.at(m)];
    }
    well_made_ = true;
  }

  bool well_made() const { return well_made_; }
  const std::vector<surface_edge>& edges() const { return edges_; }

  /// Seen from the vertex: every ray from there passes a surface that bounds a solid once, from outside to inside, because all facets have
  /// moved away. So the surface does not meet itself iff its image on the sphere of directions is a drawing of the tree without crossings
  /// inside the corner. Next to a ray of the corner the drawing is inside, since the nodes are inside the two facets there.
  bool free_of_crossings_on_the_sphere() const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (std::size_t f = e + 1; f < edges_.size(); ++f)
        if (meet_in_general(edges_[e].ends, edges_[f].ends, [this](std::size_t p) { return points_[p].x; })) return false;
      for (const cone::arc& a : c_.arcs()) {
        const vec<Int> from = widen(a.from);
        const vec<Int> to = widen(a.to);
        const vec<Int>& p = points_[edges_[e].ends[0]].x;
        const vec<Int>& q = points_[edges_[e].ends[1]].x;
        const bool leaf = edges_[e].third[1] < 0;  // its own ray lies on two arcs of the boundary
        if (leaf && q == from ? arcs_overlap(q, p, to) : (leaf && q == to ? arcs_overlap(q, p, from) : arcs_meet(p, q, from, to))) return false;
      }
    }
    return true;
  }

  bool facets_are_simple() const {
    for (int l = 0; l < c_.degree(); ++l) {
      const auto flat = [&](std::size_t p) { return in_plane(l, points_[p]); };
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (std::size_t f = e + 1; f < edges_.size(); ++f)
          if (bounds(edges_[e], l) && bounds(edges_[f], l) && meet_in_general(edges_[e].ends, edges_[f].ends, flat)) return false;
    }
    return true;
  }

  /// In space: every facet is a simple polygon, and no edge meets a facet that it does not touch by right.
  bool free_of_intersections_in_space() const {
    if (!facets_are_simple()) return false;
    for (const surface_edge& e : edges_)
      for (int l = 0; l < c_.degree(); ++l) {
        if (bounds(e, l) || e.third[0] == l || e.third[1] == l) continue;
        const Int h = height(l, points_[e.ends[0]]);
        const Int g = height(l, points_[e.ends[1]]);
        if (sgn(h) * sgn(g) > 0) continue;
        if (sgn(g) == 0 && points_[e.ends[1]].w == 0) continue;  // parallel
        const homogeneous<Int>& p = points_[e.ends[0]];
        const homogeneous<Int>& q = points_[e.ends[1]];
        const Int a = g < 0 ? Int(-g) : g;
        const Int b = h < 0 ? Int(-h) : h;
        homogeneous<Int> x{{}, Int(a * p.w + b * q.w)};
        for (std::size_t axis = 0; axis < 3; ++axis) x.x[axis] = a * p.x[axis] + b * q.x[axis];
        if (in_facet(l, x)) return false;
      }
    return true;
  }

  /// Design 03, from coordinates: where the edges of a vertex run, with respect to its third plane. Also the kind of each edge.
  bool obeys_local_rule() const {
    for (std::size_t v = 0; v < triangles_.size(); ++v) {
      int inside = 0;
      for (const surface_edge& e : edges_)
        for (int s : {0, 1})
          if (e.ends[s] == v) inside += runs_inside_third(e, s) ? 1 : 0;
      if (up_[v] != (inside == 0 || inside == 3)) return false;
    }
    return true;
  }
  bool kinds_agree() const {
    for (const surface_edge& e : edges_) {
      std::vector<bool> kinds;
      if (e.third[1] < 0) kinds.push_back(e.convex);
      for (int s : {0, 1})
        if (e.third[s] >= 0) kinds.push_back(up_[e.ends[s]] == runs_inside_third(e, s));
      if (kinds[0] != kinds[1]) return false;
    }
    return true;
  }

 private:
  static vec<Int> widen(const vec<long>& v) { return {Int(v[0]), Int(v[1]), Int(v[2])}; }
  const vec<Int>& normal(int f) const { return normal_[static_cast<std::size_t>(f)]; }
  const Int& speed(int f) const { return speed_[static_cast<std::size_t>(f)]; }
  static bool bounds(const surface_edge& e, int l) { return e.a == l || e.b == l; }

  surface_edge& find(int a, int b) {
    const auto at = std::find_if(edges_.begin(), edges_.end(), [&](const surface_edge& e) { return e.a == std::min(a, b) && e.b == std::max(a, b); });
    return at != edges_.end() ? *at : edges_.emplace_back(surface_edge{std::min(a, b), std::max(a, b), {}, {-1, -1}, false});
  }
  void add(std::size_t v, int a, int b, int third) {
    surface_edge& e = find(a, b);
    const std::size_t s = e.third[0] < 0 ? 0 : 1;
    e.ends[s] = v;
    e.third[s] = third;
  }

  // Two edges as arcs on the sphere of some coordinates; an end that they share does not count.
  template <class Coordinates>
  static bool meet_in_general(const std::array<std::size_t, 2>& e, const std::array<std::size_t, 2>& f, Coordinates&& x) {
    for (const int s : {0, 1})
      for (const int t : {0, 1})
        if (e[s] == f[t]) return arcs_overlap(x(e[s]), x(e[1 - s]), x(f[1 - t]));
    return arcs_meet(x(e[0]), x(e[1]), x(f[0]), x(f[1]));
  }

  Int height(int l, const homogeneous<Int>& p) const { return -(speed(l) * p.w + inner_product(normal(l), p.x)); }

  bool runs_inside_third(const surface_edge& e, int s) const { return height(e.third[s], points_[e.ends[1 - s]]) > 0; }

  // Coordinates in plane l, as directions of a half-sphere: a coordinate along which its normal is not zero is dropped.
  vec<Int> in_plane(int l, const homogeneous<Int>& p) const {
    const auto& n = normal(l);
    if (n[0] != 0) return {p.x[1], p.x[2], p.w};
    if (n[1] != 0) return {p.x[0], p.x[2], p.w};
    return {p.x[0], p.x[1], p.w};
  }

  // Counts the edges of facet l between the point and infinity, within the facet's sector; on an edge counts as inside.
  bool in_facet(int l, const homogeneous<Int>& point) const {
    const vec<Int> x = in_plane(l, point);
    const vec<Int> r = widen(c_.before(l));
    const vec<Int> s = widen(c_.ray[c_.at(l)]);
    for (int attempt = 1;; ++attempt) {
      const Int a(attempt % 7 + 1);
      const Int b(attempt % 11 + 1);
      vec<Int> g = {Int(a * r[0] + b * s[0]), Int(a * r[1] + b * s[1]), Int(a * r[2] + b * s[2])};
      if (l == c_.long_way) g = {Int(-g[0]), Int(-g[1]), Int(-g[2])};
      const vec<Int> far = in_plane(l, {g, Int(0)});
      int crossed = 0;
      bool clear = true;
      for (const surface_edge& e : edges_) {
        if (!bounds(e, l)) continue;
        const vec<Int> p = in_plane(l, points_[e.ends[0]]);
        const vec<Int> q = in_plane(l, points_[e.ends[1]]);
        if (on_arc(p, q, x)) return true;
        if (det_sign(x, far, p) == 0 || det_sign(x, far, q) == 0) clear = false;
        crossed += clear && arcs_meet(x, far, p, q) ? 1 : 0;
      }
      if (clear) return crossed % 2 == 0;
      if (attempt > 100) throw std::logic_error("no direction clear of vertices");
    }
  }

  const cone& c_;
  const std::vector<Int>& speed_;
  const triangulation& triangles_;
  std::vector<vec<Int>> normal_;
  std::vector<bool> up_;
  std::vector<homogeneous<Int>> points_;  ///< nodes, then rays
  std::vector<surface_edge> edges_;
  bool well_made_ = false;
};

}  // namespace osteon::proofs
