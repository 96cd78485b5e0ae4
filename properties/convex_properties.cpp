// SPDX-License-Identifier: MIT

/// \file
/// Convex solids have one skeleton: the lower envelope of the times at which planes arrive, t_i(x) = (d_i - n_i . x) / sigma_i.

#include <algorithm>
#include <string>
#include <vector>

#include "laws.hpp"

namespace osteon::properties {
namespace {

rational arrival(const moving_planes& planes, plane_id p, const vector3& x) { return (planes.d(p) - dot(planes.n(p), x)) / planes.speed(p); }

std::string nodes_are_nearest(const placed_skeleton& s) {
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    const auto& n = s.raw.nodes[i];
    for (plane_id p = 0; p < s.planes.size(); ++p) {
      const rational t = arrival(s.planes, p, s.nodes[i].point);
      const bool own = n.vertex >= 0 ? std::count(s.boundary.vertices[n.vertex].facets.begin(), s.boundary.vertices[n.vertex].facets.end(), p) > 0
                                     : std::count(n.planes.begin(), n.planes.end(), p) > 0;
      if (own ? t != s.nodes[i].time : t < s.nodes[i].time) return "plane " + std::to_string(p) + " does not arrive before node " + std::to_string(i);
    }
  }
  return "";
}

// The cell of facet p as the polytope { x : 0 <= t_p(x) <= t_q(x) for all q }.
std::vector<half_space> envelope(const moving_planes& planes, plane_id p) {
  std::vector<half_space> spaces = {{planes.n(p), planes.d(p)}};
  for (plane_id q = 0; q < planes.size(); ++q) {
    if (q == p) continue;
    const rational a = 1 / planes.speed(q);
    const rational b = 1 / planes.speed(p);
    const vector3 n = a * planes.n(q) - b * planes.n(p);
    const rational d = a * planes.d(q) - b * planes.d(p);
    if (!is_zero(n)) spaces.push_back({n, d});
  }
  return spaces;
}

// The corners of each cell's polytope are nodes of the skeleton's cell; in general position there are no others.
std::string cells_are_envelopes(const placed_skeleton& s, bool generic) {
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    std::vector<vector3> nodes;
    for (const auto& a : s.raw.arcs)
      if (std::count(a.planes.begin(), a.planes.end(), p) > 0)
        for (const int n : {a.source, a.target}) nodes.push_back(s.nodes[n].point);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::vector<half_space> spaces = envelope(s.planes, p);
    const auto corners = corners_of(spaces);
    for (const vector3& x : nodes)
      for (const half_space& h : spaces)
        if (dot(h.n, x) > h.d) return "a node of cell " + std::to_string(p) + " lies outside the lower envelope's cell";
    if (!std::includes(nodes.begin(), nodes.end(), corners.begin(), corners.end()) || (generic && nodes != corners))
      return "cell " + std::to_string(p) + " has " + std::to_string(nodes.size()) + " nodes, the lower envelope's " + std::to_string(corners.size());
  }
  return "";
}

RC_GTEST_PROP(convex, no_plane_arrives_before_a_node, ()) {
  // Weighted or not. Sheets between coplanar facets of different weights cannot be.
  for_every_kernel(*rc::gen::oneOf(gen::convex(), gen::weighted(gen::convex())), nodes_are_nearest);
}

RC_GTEST_PROP(convex, cells_are_the_lower_envelope, ()) {
  const auto s = *rc::gen::oneOf(gen::convex(), gen::weighted(gen::convex()));
  const bool generic = in_general_position(*s.solid);
  RC_CLASSIFY(generic, "general position");
  for_every_kernel(s, [&](const placed_skeleton& p) { return cells_are_envelopes(p, generic); });
}

// Nothing to choose: no ambiguous event, and every preference and saddle rule gives the same skeleton.
RC_GTEST_PROP(convex, skeleton_is_unique, ()) {
  const auto s = *rc::gen::oneOf(gen::convex(), gen::weighted(gen::convex()));
  RC_TAG(s.kind);
  const auto runs = run_all(*s.solid);
  for (const run& r : runs) require(r.kernel, [&] { return std::string(r.raw.ambiguous == 0 ? "" : "an event is ambiguous"); });
  using enum split_preference;
  for (const auto prefer : {convex, reflex, min_volume, max_volume})
    for (const auto saddle : {saddle_rule::convex, saddle_rule::reflex, saddle_rule::slower, saddle_rule::faster}) {
      const auto others = run_rational(s.solid->planes, s.solid->boundary, {prefer, saddle});
      require(others[0].kernel, [&] { return difference(runs[2].raw, others[0].raw); });
      const auto by_roots = run_default(*s.solid, {prefer, saddle});
      require(by_roots.kernel, [&] { return difference(runs[0].raw, by_roots.raw); });
    }
}

}  // namespace
}  // namespace osteon::properties
