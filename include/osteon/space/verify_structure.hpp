// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate's rules `structure`, `order` and `incidence`: everything that a skeleton names
/// exists, nodes come in order of time, and what lies on what is said by both.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/certificate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::certificate {

/// Rule `structure`: numbers count something, planes ascend.
class structure_check {
 public:
  /// A skeleton of a solid, both to outlive the check.
  structure_check(const boundary& solid, const skeleton& s) : solid_(solid), s_(s) {}

  /// Checks all elements.
  /// *Throws* refutation. *Complexity* linear.
  void run() const {
    check_nodes();
    check_arcs();
    check_sheets();
    demand(s_.cells.size() == static_cast<std::size_t>(solid_.planes), rule::structure, "cell", solid_.planes, "there must be one for each facet");
    for (std::size_t c = 0; c < s_.cells.size(); ++c)
      for (const int s : s_.cells[c]) demand(exists(s, s_.sheets.size()), rule::structure, "cell", c, "names a sheet that is not there");
  }

 private:
  bool is_plane(plane_id p) const { return exists(p, static_cast<std::size_t>(solid_.planes)); }

  void check_nodes() const {
    std::vector<bool> seen(solid_.vertices.size());
    for (std::size_t n = 0; n < s_.nodes.size(); ++n) {
      const auto& node = s_.nodes[n];
      for (const int a : node.arcs) demand(exists(a, s_.arcs.size()), rule::structure, "node", n, "names an arc that is not there");
      if (node.vertex < 0) {
        for (int r = 0; r < 4; ++r)
          demand(is_plane(node.planes[r]) && (r == 0 || node.planes[r - 1] < node.planes[r]), rule::structure, "node", n,
                 "needs four planes, ascending");
        demand(static_cast<int>(node.event) < event_classes, rule::structure, "node", n, "has no class of event");
        continue;
      }
      demand(exists(node.vertex, solid_.vertices.size()) && !seen[node.vertex], rule::structure, "node", n,
             "is no vertex of the solid, or one for the second time");
      seen[node.vertex] = true;
      for (int r = 0; r < 3; ++r)
        demand(is_plane(node.planes[r]) && (r == 0 || node.planes[r - 1] <= node.planes[r]), rule::structure, "node", n,
               "needs three planes, ascending");
      demand(node.planes[3] == -1, rule::structure, "node", n, "has a fourth plane at a vertex");
    }
    const auto missing = std::find(seen.begin(), seen.end(), false);
    demand(missing == seen.end(), rule::structure, "vertex", missing - seen.begin(), "has no node");
  }

  void check_arcs() const {
    for (std::size_t a = 0; a < s_.arcs.size(); ++a) {
      const auto& arc = s_.arcs[a];
      demand(exists(arc.source, s_.nodes.size()) && exists(arc.target, s_.nodes.size()), rule::structure, "arc", a, "names a node that is not there");
      for (int r = 0; r < 3; ++r)
        demand(is_plane(arc.planes[r]) && (r == 0 || arc.planes[r - 1] < arc.planes[r]), rule::structure, "arc", a, "needs three planes, ascending");
      for (const int s : arc.sheets) demand(exists(s, s_.sheets.size()), rule::structure, "arc", a, "names a sheet that is not there");
    }
  }

  void check_sheets() const {
    for (std::size_t s = 0; s < s_.sheets.size(); ++s) {
      const auto& sheet = s_.sheets[s];
      demand(is_plane(sheet.facets[0]) && is_plane(sheet.facets[1]) && sheet.facets[0] < sheet.facets[1], rule::structure, "sheet", s,
             "needs two facets, ascending");
      demand(exists(sheet.representative, s_.sheets.size()) && s_.sheets[sheet.representative].representative == sheet.representative,
             rule::structure, "sheet", s, "has no polygon");
      demand(sheet.input_edge == -1 || exists(sheet.input_edge, solid_.edges.size()), rule::structure, "sheet", s, "names an edge that is not there");
      for (const int a : sheet.arcs) demand(exists(a, s_.arcs.size()), rule::structure, "sheet", s, "names an arc that is not there");
    }
  }

  const boundary& solid_;
  const skeleton& s_;
};

/// Demands rule `order`: every node has a moment, nodes come in order of time, arcs run forwards.
/// Returns the nodes' moments.
/// *Requires* rule `structure`. *Throws* refutation. *Complexity* linear.
template <kernel<3> K>
std::vector<typename K::meeting> check_order(const K& k, const skeleton& s) {
  std::vector<typename K::meeting> moments;
  for (std::size_t n = 0; n < s.nodes.size(); ++n) {
    if (s.nodes[n].vertex >= 0) {
      moments.push_back(k.start());
    } else {
      const auto m = k.meet(s.nodes[n].planes);
      demand(m.has_value(), rule::order, "node", n, "its planes do not meet");
      demand(k.compare(*m, k.start()) == sign::positive, rule::order, "node", n, "its planes meet before the start");
      moments.push_back(*m);
    }
    if (n > 0) demand(k.compare(moments[n - 1], moments[n]) != sign::positive, rule::order, "node", n, "is earlier than the node before it");
  }
  for (std::size_t a = 0; a < s.arcs.size(); ++a)
    demand(k.compare(moments[s.arcs[a].source], moments[s.arcs[a].target]) == sign::negative, rule::order, "arc", a, "does not run forwards in time");
  return moments;
}

/// Rule `incidence`: what lies on what, and both know it.
template <kernel<3> K>
class incidence_check {
 public:
  /// A skeleton of a solid, both to outlive the check.
  incidence_check(const K& k, const boundary& solid, const skeleton& s)
      : k_(k), solid_(solid), s_(s), of_node_(s.nodes.size()), of_sheet_(s.sheets.size()), bend_(s.sheets.size(), bend::none) {}

  /// Checks all elements.
  /// *Requires* rule `structure`. *Throws* refutation. *Complexity* n log n.
  void run() {
    for (std::size_t a = 0; a < s_.arcs.size(); ++a) check_arc(static_cast<int>(a));
    for (std::size_t n = 0; n < s_.nodes.size(); ++n)
      for (int r = 0; r < 3 && s_.nodes[n].vertex >= 0; ++r)
        demand(passes(static_cast<int>(n), s_.nodes[n].planes[r]), rule::incidence, "node", n, "names a plane that does not pass through its vertex");
    for (std::size_t n = 0; n < s_.nodes.size(); ++n)
      demand(same(of_node_[n], s_.nodes[n].arcs), rule::incidence, "node", n, "does not list the arcs that end in it");
    std::vector<std::vector<int>> of_cell(s_.cells.size());
    for (std::size_t s = 0; s < s_.sheets.size(); ++s) {
      const auto& sheet = s_.sheets[s];
      demand(same(of_sheet_[s], sheet.arcs), rule::incidence, "sheet", s, "does not list the arcs on its border");
      demand(s_.sheets[sheet.representative].facets == sheet.facets, rule::incidence, "sheet", s, "is part of a polygon of other facets");
      for (const plane_id f : sheet.facets) of_cell[f].push_back(static_cast<int>(s));
    }
    for (std::size_t c = 0; c < s_.cells.size(); ++c) demand(same(of_cell[c], s_.cells[c]), rule::incidence, "cell", c, "does not list its sheets");
  }

 private:
  void check_arc(int a) {
    const auto& arc = s_.arcs[a];
    for (const int n : {arc.source, arc.target}) {
      of_node_[n].push_back(a);
      for (const plane_id p : arc.planes) demand(passes(n, p), rule::incidence, "arc", a, "one of its planes does not pass through its end");
    }
    demand(is_monotone(arc.corner, 3) && depends_on_all(arc.corner, 3), rule::incidence, "arc", a, "has no corner");
    std::size_t next = 0;
    for (unsigned t = 0; t < 3; ++t)
      for (const bool inside : {false, true}) {
        const bend kind = bend_at(arc.corner, t, inside);
        if (kind == bend::none) continue;
        demand(next < arc.sheets.size(), rule::incidence, "arc", a, "misses a sheet");
        const int s = arc.sheets[next++];
        demand(s_.sheets[s].facets == omit(arc.planes, t), rule::incidence, "arc", a, "lies on the border of a sheet of other facets");
        of_sheet_[s].push_back(a);
        bend& known = bend_[s_.sheets[s].representative];
        demand(known == bend::none || known == kind, rule::incidence, "sheet", s, "is convex at one arc and reflex at another");
        known = kind;
      }
    demand(next == arc.sheets.size(), rule::incidence, "arc", a, "has a sheet too many");
  }

  static bool same(std::vector<int> x, std::vector<int> y) {
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    return x == y;
  }

  // Whether a plane passes through a node; through a vertex of the solid also when it contains the
  // line of an edge that ends there.
  bool passes(int n, plane_id p) const {
    const auto& node = s_.nodes[n];
    if (node.vertex < 0) return position(node.planes, p) < node.planes.size();
    std::vector<int> reached = {node.vertex};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const auto& v = solid_.vertices[reached[i]];
      if (std::find(v.facets.begin(), v.facets.end(), p) != v.facets.end()) return true;
      for (const int e : v.edges) {
        const auto& edge = solid_.edges[e];
        if (k_.transversal(edge.planes[0], edge.planes[1], p)) continue;
        for (const int w : edge.ends)
          if (std::find(reached.begin(), reached.end(), w) == reached.end()) reached.push_back(w);
      }
    }
    return false;
  }

  const K& k_;
  const boundary& solid_;
  const skeleton& s_;
  std::vector<std::vector<int>> of_node_;   // the arcs that end in each
  std::vector<std::vector<int>> of_sheet_;  // the arcs on the border of each
  std::vector<bend> bend_;                  // by representative of sheets
};

}  // namespace osteon::certificate
