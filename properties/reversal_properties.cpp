// SPDX-License-Identifier: MIT

/// \file
/// Time runs backwards. Stop between two events: P(t) taken out of a large box is a solid whose inner facets, moving into it, retrace the way
/// that P(t) came: the planes are the same with reversed normals. So the skeleton of that box begins with the same events in reverse order.
///
/// What can be had, and what not:
///  - An event that makes a facet vanish (a triangle, a tetrahedron) cannot come back: no facet appears from nowhere (design 02, rule 2), and P(t)
///    does not know the plane any more. So the way is compared back to the last such event; the catalogue tells which events have an inverse.
///  - The way back may pass a saddle, which has two outcomes; from there on the two ways may differ, and nothing is compared.
///  - Offsets at time t are rational only for rational speeds: the law is run on the rational kernels.

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "events.hpp"
#include "laws.hpp"

namespace osteon::properties {
namespace {

struct complement {
  std::vector<moving_plane<integer>> planes;
  osteon::boundary boundary;
};

// Facets around a vertex of three planes, counter-clockwise seen from outside, and the edges between them.
void add_vertices(const offset_solid& p, complement& r) {
  for (int v = 0; v < static_cast<int>(p.vertices.size()); ++v) {
    // The facet left of an edge is the first one of a convex edge from tail to head. Around a vertex, seen from outside, the facet right of an
    // outgoing edge comes before the one left of it.
    std::map<plane_id, std::pair<plane_id, int>> next;  // by the facet before: the one after, and the edge between
    for (int e = 0; e < static_cast<int>(p.edges.size()); ++e) {
      const auto& edge = p.edges[e];
      if (edge.ends[0] != v && edge.ends[1] != v) continue;
      const bool first_left = edge.convex == (edge.ends[0] == v);
      next[edge.facets[first_left ? 1 : 0]] = {edge.facets[first_left ? 0 : 1], e};
    }
    osteon::boundary::vertex around;
    plane_id f = next.begin()->first;
    for (int m = 0; m < 3; ++m) {
      around.facets.push_back(f);
      around.edges.push_back(next.at(f).second);
      f = next.at(f).first;
    }
    if (f != around.facets[0]) throw std::domain_error("the facets around a vertex of an offset are a cycle");
    // The complement is seen from the other side: facets in reverse order, and edges[m] between facets[m] and [m + 1].
    std::reverse(around.facets.begin(), around.facets.end());
    std::reverse(around.edges.begin(), around.edges.end());
    std::rotate(around.edges.begin(), around.edges.begin() + 1, around.edges.end());
    r.boundary.vertices.push_back(around);
  }
}

// A box around everything minus P(t). Lengths are multiplied so that all numbers are integers; the scale of time is the same.
complement box_minus(const placed_skeleton& s, const solid<integer>& original, const rational& t) {
  const offset_solid p(s, t);
  const integer scale = denominator(t) << 64;
  complement r;
  integer size = 0;
  for (plane_id i = 0; i < s.planes.size(); ++i) {
    const auto& plane = original.planes[i];
    const rational d = rational(scale) * s.planes.offset(i, t);
    r.planes.push_back({{-plane.n[0], -plane.n[1], -plane.n[2]}, -numerator(d), plane.weight});
    size = std::max(size, integer(abs(plane.d)));
  }
  for (const auto& x : original.points)
    for (const integer& c : x) size = std::max(size, integer(abs(c)));
  const integer far = (size + 1) * scale * 1'000'000;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {1, -1}) {
      moving_plane<integer> plane{{0, 0, 0}, far, 1};
      plane.n[static_cast<std::size_t>(axis)] = side;
      r.planes.push_back(plane);
    }
  r.boundary.planes = static_cast<plane_id>(r.planes.size());
  for (const auto& e : p.edges) {
    // planes[0] left of ends[0] -> ends[1] seen from outside; from inside left is right.
    const auto left = e.facets[e.convex ? 0 : 1];
    const auto right = e.facets[e.convex ? 1 : 0];
    r.boundary.edges.push_back({e.ends, {right, left}, !e.convex});
  }
  add_vertices(p, r);
  // The box: corners by three bits (set: the positive side), planes 2 * axis for the positive side, 2 * axis + 1 for the other.
  const auto base = static_cast<plane_id>(s.planes.size());
  const auto first = static_cast<int>(r.boundary.vertices.size());
  const auto wall = [&](int corner, int axis) { return base + 2 * axis + ((corner >> axis & 1) != 0 ? 0 : 1); };
  std::map<std::pair<int, int>, int> edge_of;  // by the corner with a bit clear, and the axis
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0) continue;
      // From the lower to the upper corner, n_left x n_right is the axis' direction.
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const bool positive = ((corner >> u & 1) != 0) == ((corner >> v & 1) != 0);
      edge_of[{corner, axis}] = static_cast<int>(r.boundary.edges.size());
      r.boundary.edges.push_back(
          {{first + corner, first + (corner | 1 << axis)}, {wall(corner, positive ? u : v), wall(corner, positive ? v : u)}, true});
    }
  for (int corner = 0; corner < 8; ++corner) {
    osteon::boundary::vertex v;
    const bool positive = ((corner & 1) + (corner >> 1 & 1) + (corner >> 2)) % 2 != 0;  // x, y, z counter-clockwise
    const std::array<int, 3> axes = positive ? std::array<int, 3>{0, 1, 2} : std::array<int, 3>{0, 2, 1};
    for (std::size_t m = 0; m < 3; ++m) {
      v.facets.push_back(wall(corner, axes[m]));
      const int along = axes[(m + 2) % 3];  // between facets m and m + 1 lies the edge along the third axis
      v.edges.push_back(edge_of.at({corner & ~(1 << along), along}));
    }
    r.boundary.vertices.push_back(v);
  }
  return r;
}

std::string retraces(const solid<integer>& original, const run& forward, long choice, std::size_t kernel, long& compared) {
  const placed_skeleton s(original, forward);
  // Stop after an event that can be undone, and go back to the last one that cannot.
  std::vector<int> stops;
  for (int i = static_cast<int>(original.boundary.vertices.size()); i + 1 < static_cast<int>(s.nodes.size()); ++i)
    if (can_be_undone(forward.raw, i) && s.nodes[i].time < s.nodes[i + 1].time) stops.push_back(i);
  if (stops.empty()) return "";
  const int stop = stops[static_cast<std::size_t>(choice) % stops.size()];
  const rational t = simple_between(s.nodes[stop].time, s.nodes[stop + 1].time);
  const complement r = box_minus(s, original, t);
  const run back = run_rational(r.planes, r.boundary)[kernel];
  int node = static_cast<int>(r.boundary.vertices.size());
  for (int i = stop; forward.raw.nodes[i].vertex < 0 && can_be_undone(forward.raw, i); --i, ++node) {
    if (node >= static_cast<int>(back.raw.nodes.size())) return "the way back ends early";
    const auto& there = forward.raw.nodes[i];
    const auto& here = back.raw.nodes[node];
    if (here.planes != there.planes) return "the way back from time " + t.str() + " meets other planes than event " + std::to_string(i) + " had";
    if (here.ambiguous || there.ambiguous) return "";
    if (corners_at(back.raw, node) != reversed(corners_at(forward.raw, i)))
      return "the way back undoes event " + std::to_string(i) + " in another way";
    ++compared;
  }
  return "";
}

RC_GTEST_PROP(reversal, retraces_the_way_to_the_start, ()) {
  const auto o = *gen::any_options();
  const auto s = *gen::general(rc::gen::oneOf(gen::stars(8), gen::stars(), gen::cones(), gen::landscapes(), gen::rings(), gen::hollow_stars()), o);
  const long choice = *gen::between(0, 99);
  const auto forward = run_rational(s.solid->planes, s.solid->boundary, o);
  long compared = 0;
  for (std::size_t k = 0; k < forward.size(); ++k) require(forward[k].kernel, [&] { return retraces(*s.solid, forward[k], choice, k, compared); });
  RC_TAG(compared == 0 ? "no event compared" : compared < 6 ? "1 or 2 events compared" : "3 or more events compared");
}

}  // namespace
}  // namespace osteon::properties
