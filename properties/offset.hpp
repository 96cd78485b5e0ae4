// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A raw skeleton in rational numbers: where its nodes are, the faces its sheets make, and the offset solid P(t) at any time. Speeds are
/// those of the rational kernel, so for its skeletons everything here is exact; other kernels' skeletons have the same combinatorics in
/// general position, and then it is exact for the same planes with speeds rounded to 2^-64. Shares no code with the algorithms.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"
#include "polytope.hpp"
#include "run.hpp"

namespace osteon::properties {

/// What of a solid the laws need: planes with rational speeds.
class moving_planes {
 public:
  explicit moving_planes(const std::vector<moving_plane<integer>>& planes) {
    const auto kernel = rational_arithmetic(planes);
    for (plane_id i = 0; i < kernel.size(); ++i) {
      const auto& p = planes[i];
      normals_.push_back({rational(p.n[0]), rational(p.n[1]), rational(p.n[2])});
      offsets_.emplace_back(p.d);
      speeds_.emplace_back(kernel.speed(i), integer(1) << 64);
    }
  }
  plane_id size() const { return static_cast<plane_id>(normals_.size()); }
  const vector3& n(plane_id i) const { return normals_[i]; }
  const rational& d(plane_id i) const { return offsets_[i]; }
  const rational& speed(plane_id i) const { return speeds_[i]; }
  rational offset(plane_id i, const rational& t) const { return offsets_[i] - t * speeds_[i]; }
  /// h_i(x, t), positive inside.
  rational height(plane_id i, const vector3& x, const rational& t) const { return offset(i, t) - dot(normals_[i], x); }
  rational orientation(plane_id a, plane_id b, plane_id c) const { return det(normals_[a], normals_[b], normals_[c]); }

  /// The corner of three planes at a time; nothing where their normals are dependent.
  std::optional<vector3> corner(const triple& t, const rational& when) const {
    const rational whole = orientation(t[0], t[1], t[2]);
    if (whole == 0) return std::nullopt;
    vector3 sum = {0, 0, 0};
    for (int r = 0; r < 3; ++r) sum = sum + offset(t[r], when) * cross(n(t[(r + 1) % 3]), n(t[(r + 2) % 3]));
    return (1 / whole) * sum;
  }

 private:
  std::vector<vector3> normals_;
  std::vector<rational> offsets_;
  std::vector<rational> speeds_;
};

/// Place and time.
struct place {
  vector3 point;
  rational time;
};

/// An arc as a border of a sheet. At every time the sheet's edge lies on a line with the direction u = n_f x n_g (f < g its
/// facets): it begins at tails and ends at heads.
struct border {
  int arc;
  bool head;
};

/// All that is one polygon: sheets with one representative.
struct face {
  std::array<plane_id, 2> facets;
  bool convex = false;
  std::vector<border> borders;
  std::vector<std::array<int, 2>> base;  ///< edges of the solid in the direction u, as nodes
};

/// A skeleton placed in space. Throws std::domain_error where the complex is not what it should be; the message is the law broken.
class placed_skeleton {
 public:
  placed_skeleton(const solid<integer>& s, const run& r) : planes(s.planes), boundary(s.boundary), raw(r.raw), points(s.points) {
    place_nodes();
    make_faces(r.orientations);
  }

  moving_planes planes;
  const osteon::boundary& boundary;
  const skeleton& raw;
  const std::vector<vec<integer>>& points;  ///< of the solid
  std::vector<place> nodes;
  std::map<int, face> faces;  ///< by representative

  vector3 input_point(int v) const { return {rational(points[v][0]), rational(points[v][1]), rational(points[v][2])}; }

  /// The different times of nodes, ascending, from 0 on.
  std::vector<rational> moments() const {
    std::vector<rational> t;
    for (const place& n : nodes) t.push_back(n.time);
    std::sort(t.begin(), t.end());
    t.erase(std::unique(t.begin(), t.end()), t.end());
    return t;
  }

  /// A place on an arc at a time within it.
  vector3 on_arc(int a, const rational& t) const {
    const auto& arc = raw.arcs[a];
    if (const auto p = planes.corner(arc.planes, t)) return *p;
    const place& from = nodes[arc.source];
    const place& to = nodes[arc.target];
    return from.point + ((t - from.time) / (to.time - from.time)) * (to.point - from.point);
  }

  bool alive(int a, const rational& t) const { return nodes[raw.arcs[a].source].time < t && t < nodes[raw.arcs[a].target].time; }

 private:
  [[noreturn]] static void fail(const std::string& law) { throw std::domain_error(law); }

  void place_nodes() {
    for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
      const auto& n = raw.nodes[i];
      if (n.vertex < 0) {
        nodes.push_back(meeting(n.planes));
        continue;
      }
      if (n.vertex != static_cast<int>(i)) fail("the first nodes are the solid's vertices");
      nodes.push_back({input_point(n.vertex), 0});
    }
  }

  // The one solution of n_i . x + sigma_i t = d_i for four planes, by elimination.
  place meeting(const quadruple& q) const {
    std::array<std::array<rational, 5>, 4> m;
    for (int r = 0; r < 4; ++r) {
      const vector3& n = planes.n(q[r]);
      m[r] = {n[0], n[1], n[2], planes.speed(q[r]), planes.d(q[r])};
    }
    for (int c = 0; c < 4; ++c) {
      int pivot = c;
      while (pivot < 4 && m[pivot][c] == 0) ++pivot;
      if (pivot == 4) fail("the planes of an event meet in one place in the limit");
      std::swap(m[c], m[pivot]);
      for (int r = 0; r < 4; ++r) {
        if (r == c || m[r][c] == 0) continue;
        const rational factor = m[r][c] / m[c][c];
        for (int k = c; k < 5; ++k) m[r][k] -= factor * m[c][k];
      }
    }
    return {{m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2]}, m[3][4] / m[3][3]};
  }

  void make_faces(const std::vector<sign>& orientations) {
    std::map<int, int> convexity;  // by representative: 1 convex, -1 reflex
    const auto face_of = [&](int sheet, bool convex) -> face& {
      const int id = raw.sheets[sheet].representative;
      const auto [known, fresh] = convexity.emplace(id, convex ? 1 : -1);
      if (known->second != (convex ? 1 : -1)) fail("an edge stays convex or reflex while it lives: sheet " + std::to_string(id));
      face& f = faces[id];
      f.facets = raw.sheets[sheet].facets;
      f.convex = convex;
      return f;
    };
    for (int a = 0; a < static_cast<int>(raw.arcs.size()); ++a) {
      const auto& arc = raw.arcs[a];
      const rational exact = planes.orientation(arc.planes[0], arc.planes[1], arc.planes[2]);
      const bool up = exact != 0 ? exact > 0 : orientations[a] == sign::positive;
      std::size_t next = 0;  // sheets are listed by plane left out, outside before inside
      for (unsigned t = 0; t < 3; ++t)
        for (const bool inside : {false, true}) {
          const auto kind = local::corner_piece(arc.corner, t, inside);
          if (kind == local::piece::none) continue;
          if (next == arc.sheets.size()) fail("an arc bounds as many sheets as its corner has edges: arc " + std::to_string(a));
          const int s = arc.sheets[next++];
          std::array<plane_id, 2> two = {arc.planes[t == 0 ? 1 : 0], arc.planes[t == 2 ? 1 : 2]};
          if (raw.sheets[s].facets != two) fail("a corner's edges lie between its planes: arc " + std::to_string(a));
          // Along u the height over the third plane falls with det(two, third), which is det(planes) for t = 0, 2 and -det for t = 1.
          const bool falls = up == (t != 1);
          face_of(s, kind == local::piece::convex).borders.push_back({a, falls == inside});
        }
      if (next != arc.sheets.size()) fail("an arc bounds as many sheets as its corner has edges: arc " + std::to_string(a));
    }
    std::map<int, std::vector<int>> swept;  // by edge of the solid: several sheets where facets flood it
    for (int i = 0; i < static_cast<int>(raw.sheets.size()); ++i)
      if (raw.sheets[i].input_edge >= 0) swept[raw.sheets[i].input_edge].push_back(i);
    for (const auto& [e, sheets] : swept) add_base(boundary.edges[e], sheets);
  }

  // The facet e.planes[0] lies left of e.ends[0] -> e.ends[1], e.planes[1] right; from left to right each sheet begins at the facet at which
  // the one before ended.
  void add_base(const osteon::boundary::edge& e, std::vector<int> sheets) {
    plane_id left = e.planes[0];
    while (!sheets.empty()) {
      const auto next = std::find_if(sheets.begin(), sheets.end(), [&](int i) {
        const auto& f = raw.sheets[i].facets;
        return f[0] == left || f[1] == left;
      });
      if (next == sheets.end()) fail("the sheets of an input edge lead from one of its facets to the other");
      const auto& s = raw.sheets[*next];
      const auto at = faces.find(s.representative);
      if (at == faces.end()) fail("a sheet has arcs");
      const bool along = (s.facets[0] == left) == at->second.convex;
      at->second.base.push_back({e.ends[along ? 0 : 1], e.ends[along ? 1 : 0]});
      left = s.facets[s.facets[0] == left ? 1 : 0];
      sheets.erase(next);
    }
    if (left != e.planes[1]) fail("the sheets of an input edge lead from one of its facets to the other");
  }
};

// ---- the offset solid

/// A vertex of P(t): the arc that it is on.
struct offset_vertex {
  int arc;
  vector3 point;
};

/// An edge of P(t) from its tail to its head (see border).
struct offset_edge {
  std::array<int, 2> ends;  ///< vertices
  std::array<plane_id, 2> facets;
  bool convex;
};

/// P(t) at a time between two moments, for a skeleton in general position: vertices from living arcs, edges from living sheets (a sheet may
/// have several at once: its living vertices along the line, paired), facets from their edges.
class offset_solid {
 public:
  offset_solid(const placed_skeleton& s, const rational& t) : time(t), planes(s.planes) {
    std::map<int, int> vertex_of;
    for (int a = 0; a < static_cast<int>(s.raw.arcs.size()); ++a)
      if (s.alive(a, t)) {
        vertex_of[a] = static_cast<int>(vertices.size());
        vertices.push_back({a, s.on_arc(a, t)});
      }
    for (const auto& [id, f] : s.faces) add_edges(s, f, vertex_of);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      for (const plane_id p : edges[e].facets) facets[p].push_back(e);
  }

  rational time;
  const moving_planes& planes;
  std::vector<offset_vertex> vertices;
  std::vector<offset_edge> edges;
  std::map<plane_id, std::vector<int>> facets;  ///< their edges

  const vector3& end(int e, int which) const { return vertices[edges[e].ends[which]].point; }

  /// Whether a point of plane p lies in facet p: even-odd rule along a ray in the plane; `border` counts as inside.
  bool facet_contains(plane_id p, const vector3& x) const {
    const auto in = facets.find(p);
    if (in == facets.end()) return false;
    const auto [u, v] = kept_axes(planes.n(p));
    bool inside = false;
    for (const int e : in->second) {
      const vector3& a = end(e, 0);
      const vector3& b = end(e, 1);
      const rational turn = (b[u] - a[u]) * (x[v] - a[v]) - (b[v] - a[v]) * (x[u] - a[u]);
      if (turn == 0 && dot(x - a, x - b) <= 0) return true;
      if ((a[v] > x[v]) != (b[v] > x[v]) && (turn > 0) == (b[v] > a[v])) inside = !inside;
    }
    return inside;
  }

  /// Where the segment x y, which is not parallel to plane p, meets facet p; nothing where it does not.
  std::optional<vector3> pierced(plane_id p, const vector3& x, const vector3& y) const {
    const rational hx = planes.height(p, x, time);
    const rational hy = planes.height(p, y, time);
    if (hx == hy || (hx > 0 && hy > 0) || (hx < 0 && hy < 0)) return std::nullopt;
    const vector3 at = x + (hx / (hx - hy)) * (y - x);
    return facet_contains(p, at) ? std::optional(at) : std::nullopt;
  }

  /// Whether a point lies inside, by the parity of facets met on the way to a far point. Throws where all rays tried meet an edge.
  bool contains(const vector3& x) const {
    for (int attempt = 1; attempt < 50; ++attempt) {
      const vector3 far = {x[0] + 1'000'003 * attempt, x[1] + rational(7'919 * attempt * attempt, 3), x[2] + rational(104'729, attempt)};
      bool inside = false;
      bool clean = true;
      for (const auto& [p, in] : facets) {
        const rational hx = planes.height(p, x, time);
        const rational speed = dot(planes.n(p), far - x);
        if (speed == 0) {
          clean = clean && hx != 0;
          continue;
        }
        const rational s = hx / speed;
        if (s < 0) continue;
        const vector3 at = x + s * (far - x);
        for (const int e : in)
          if (on_line(at, end(e, 0), end(e, 1))) clean = false;
        if (clean && facet_contains(p, at)) inside = !inside;
      }
      if (clean) return inside;
    }
    throw std::domain_error("no ray in general position");
  }

  static std::array<std::size_t, 2> kept_axes(const vector3& n) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (abs(n[i]) > abs(n[axis])) axis = i;
    return {(axis + 1) % 3, (axis + 2) % 3};
  }

 private:
  static bool on_line(const vector3& x, const vector3& a, const vector3& b) { return is_zero(cross(x - a, b - a)); }

  void add_edges(const placed_skeleton& s, const face& f, const std::map<int, int>& vertex_of) {
    struct end_of_edge {
      rational where;
      bool head;
      int vertex;
    };
    const vector3 u = cross(planes.n(f.facets[0]), planes.n(f.facets[1]));
    std::vector<end_of_edge> ends;
    for (const border& b : f.borders)
      if (s.alive(b.arc, time)) {
        const int v = vertex_of.at(b.arc);
        ends.push_back({dot(u, vertices[v].point), b.head, v});
      }
    std::sort(ends.begin(), ends.end(), [](const end_of_edge& a, const end_of_edge& b) { return a.where < b.where; });
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (i + 1 == ends.size() || ends[i].head || !ends[i + 1].head || ends[i].where == ends[i + 1].where)
        throw std::domain_error("the living vertices along an edge's line are tail, head, tail, head ...");
      edges.push_back({{ends[i].vertex, ends[i + 1].vertex}, f.facets, f.convex});
    }
  }
};

// ---- measures, which need no pairing of vertices and so hold for degenerate solids too

/// Twice the area vectors of the facets of P(t), by plane: an edge from x to y contributes x cross y to the facet on its left, which is a
/// sum over its two ends.
inline std::vector<vector3> area_vectors(const placed_skeleton& s, const rational& t) {
  std::vector<vector3> area(static_cast<std::size_t>(s.planes.size()), vector3{0, 0, 0});
  std::map<int, vector3> at;
  for (const auto& [id, f] : s.faces) {
    const vector3 u = cross(s.planes.n(f.facets[0]), s.planes.n(f.facets[1]));
    for (const border& b : f.borders) {
      if (!s.alive(b.arc, t)) continue;
      const auto found = at.find(b.arc);
      const vector3& x = found != at.end() ? found->second : at.emplace(b.arc, s.on_arc(b.arc, t)).first->second;
      // Facet 0 lies left of a convex edge in the direction u.
      vector3 c = (dot(x, u) / dot(u, u)) * cross(x, u);
      if (b.head != f.convex) c = rational(-1) * c;
      area[f.facets[0]] = area[f.facets[0]] + c;
      area[f.facets[1]] = area[f.facets[1]] - c;
    }
  }
  return area;
}

/// Volume of P(t), and its area with each facet weighted by its speed (plane units: sigma_i / |n_i|).
struct measures {
  rational volume;
  rational weighted_area;
};

inline measures measure(const placed_skeleton& s, const rational& t) {
  measures m{0, 0};
  const auto area = area_vectors(s, t);
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    const vector3& n = s.planes.n(p);
    const rational size = dot(n, area[p]) / dot(n, n);  // twice the area over |n|
    m.volume += s.planes.offset(p, t) * size / 6;
    m.weighted_area += s.planes.speed(p) * size / 2;
  }
  return m;
}

/// Volume of the solid as given.
inline rational input_volume(const placed_skeleton& s) {
  std::vector<vector3> area(static_cast<std::size_t>(s.planes.size()), vector3{0, 0, 0});
  for (const auto& e : s.boundary.edges) {
    const vector3 c = cross(s.input_point(e.ends[0]), s.input_point(e.ends[1]));
    area[e.planes[0]] = area[e.planes[0]] + c;
    area[e.planes[1]] = area[e.planes[1]] - c;
  }
  rational six = 0;
  for (plane_id p = 0; p < s.planes.size(); ++p) six += s.planes.d(p) * dot(s.planes.n(p), area[p]) / dot(s.planes.n(p), s.planes.n(p));
  return six / 6;
}

/// The fraction with the fewest bits strictly between two numbers: short numbers keep what follows short.
inline rational simple_between(const rational& a, const rational& b) {
  integer scale = 1;
  for (;;) {
    const rational low = a * rational(scale);
    integer next = numerator(low) / denominator(low) + 1;  // a >= 0
    if (rational(next) < b * rational(scale)) return {next, scale};
    scale *= 2;
  }
}

}  // namespace osteon::properties
