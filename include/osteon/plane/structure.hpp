// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The first part of the certificate: everything that a skeleton names exists, once where it must.

#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// Throws a refutation unless the boundary consists of rings of edges on lines 0 .. lines - 1.
inline void check_boundary(line_id lines, const boundary& polygon) {
  using certificate::demand;
  const std::size_t n = polygon.next.size();
  demand(n <= std::numeric_limits<int>::max() / 4 && polygon.line.size() == n && polygon.rank.size() == n, rule::structure, "polygon of edges", n,
         "its lists have different lengths");
  std::vector<bool> entered(n);
  for (std::size_t e = 0; e < n; ++e) {
    demand(certificate::exists(polygon.next[e], n) && !entered[polygon.next[e]] && polygon.next[e] != static_cast<int>(e), rule::structure, "edge", e,
           "is not in a ring");
    entered[polygon.next[e]] = true;
    demand(polygon.line[e] >= 0 && polygon.line[e] < lines, rule::structure, "edge", e, "names a line that is not there");
  }
}

/// Arcs by node: those of node i are list[first[i]] .. list[first[i + 1] - 1].
struct arcs_by_node {
  std::vector<int> first;
  std::vector<int> list;
  const int* begin(int node) const { return list.data() + first[node]; }
  const int* end(int node) const { return list.data() + first[node + 1]; }
  int size(int node) const { return first[node + 1] - first[node]; }
};

/// What is where in a skeleton.
struct skeleton_index {
  std::vector<int> node_of;  ///< by vertex of the polygon
  arcs_by_node starts;       ///< arcs by their sources
  arcs_by_node ends;         ///< arcs by their targets
};

/// Checks that a raw skeleton's names mean something.
class structure_check {
 public:
  structure_check(line_id lines, const boundary& polygon, const skeleton& s) : lines_(lines), n_(polygon.next.size()), s_(s) {}

  /// Returns the index of a sound skeleton; throws a refutation of another one.
  /// *Requires* a boundary that check_boundary has accepted.
  skeleton_index run() {
    certificate::demand(s_.nodes.size() >= n_ && s_.nodes.size() <= most, rule::structure, "nodes", s_.nodes.size(), "are too few or too many");
    certificate::demand(s_.arcs.size() <= most, rule::structure, "arcs", s_.arcs.size(), "are too many");
    certificate::demand(s_.faces.size() == n_, rule::structure, "faces", s_.faces.size(), "are not one for each edge");
    skeleton_index index;
    check_nodes(index.node_of);
    check_interior_nodes();
    check_faces();
    check_arcs();
    index.starts = incidence([](const skeleton::arc& arc) { return arc.source; });
    index.ends = incidence([](const skeleton::arc& arc) { return arc.target; });
    return index;
  }

 private:
  static constexpr std::size_t most = std::numeric_limits<int>::max() / 4;

  static bool exists(int id, std::size_t size) { return certificate::exists(id, size); }
  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  void check_nodes(std::vector<int>& node_of) const {
    node_of.assign(n_, -1);
    for (int i = 0; i < static_cast<int>(s_.nodes.size()); ++i) {
      const auto& node = s_.nodes[i];
      const auto& q = node.lines;
      if (static_cast<std::size_t>(i) < n_) {
        demand(exists(node.vertex, n_) && node_of[node.vertex] < 0, rule::structure, "node", i, "is no vertex, or one for the second time");
        node_of[node.vertex] = i;
        continue;
      }
      demand(node.vertex == -1, rule::structure, "node", i, "is a vertex behind the first event");
      demand(q[0] >= 0 && q[0] < q[1] && q[1] < q[2] && q[2] < lines_, rule::structure, "node", i, "needs three lines, ascending");
      demand(node.event == event_class::edge || node.event == event_class::split, rule::structure, "node", i, "has no class of event");
    }
  }

  void check_interior_nodes() const {
    for (const auto& p : s_.interior_nodes) {
      demand(exists(p.arc, s_.arcs.size()) && exists(p.node, s_.nodes.size()) && s_.nodes[p.node].vertex < 0, rule::structure, "arc", p.arc,
             "is none, or passes through no event");
      demand(s_.arcs[p.arc].source < p.node && (s_.arcs[p.arc].target < 0 || p.node < s_.arcs[p.arc].target), rule::order, "arc", p.arc,
             "passes through a node before or after its time");
    }
  }

  void check_faces() const {
    for (int f = 0; f < static_cast<int>(n_); ++f)
      demand(exists(s_.faces[f], n_) && s_.faces[s_.faces[f]] == s_.faces[f], rule::structure, "face", f, "has no representative");
  }

  void check_arcs() const {
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      demand(exists(arc.source, s_.nodes.size()) && (arc.target == -1 || exists(arc.target, s_.nodes.size())), rule::structure, "arc", a,
             "names a node that is not there");
      for (const int f : arc.faces)
        demand(exists(f, n_) && s_.faces[f] == f, rule::structure, "arc", a, "names a face that is not there or no representative");
      demand(arc.target == -1 || arc.source < arc.target, rule::order, "arc", a, "does not run forwards in time");
      demand(arc.target == -1 || static_cast<std::size_t>(arc.target) >= n_, rule::order, "arc", a, "ends in a vertex");
    }
  }

  template <class Node>
  arcs_by_node incidence(Node node) const {
    arcs_by_node result;
    result.first.assign(s_.nodes.size() + 1, 0);
    for (const auto& arc : s_.arcs)
      if (node(arc) >= 0) ++result.first[node(arc) + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    result.list.resize(static_cast<std::size_t>(result.first.back()));
    auto next = result.first;
    for (std::size_t a = 0; a < s_.arcs.size(); ++a)
      if (const int i = node(s_.arcs[a]); i >= 0) result.list[next[i]++] = static_cast<int>(a);
    return result;
  }

  const line_id lines_;
  const std::size_t n_;  // of edges of the polygon
  const skeleton& s_;
};

}  // namespace osteon::plane
