// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The wavefront just after the start: the edges of the solid and those of the splits, joined in
/// vertices of three facets.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/front_surgery.hpp"
#include "osteon/space/initial_split.hpp"
#include "osteon/space/segment.hpp"
#include "osteon/space/split.hpp"

namespace osteon {

/// Makes the moving vertices and edges of a split solid, with a node for each vertex of the solid.
template <kernel<3> K>
class initial_front {
 public:
  /// `front` is empty; it is filled.
  initial_front(const K& k, const split_solid& s, front_surgery<K>& front) : k_(k), solid_(s.solid), split_(s), front_(front) {}

  /// Fills the front.
  /// *Throws* degenerate_error where the kernel answers zero. *Complexity* n log n.
  void run() {
    for (std::size_t e = 0; e < solid_.edges.size(); ++e) front_.add_sheet(planes_of(solid_.edges[e]), split_.origin[e]);
    add_input_edges();
    for (std::size_t v = 0; v < solid_.vertices.size(); ++v) {
      const auto& vertex = solid_.vertices[v];
      const auto& f = vertex.facets;
      const triple some = sorted(triple{f[0], f[1], f[2]});
      front_.add_node({static_cast<int>(v), {some[0], some[1], some[2], -1}, event_class::other, false, {}});
      if (f.size() == 3) {
        const auto& e = vertex.edges;
        add_corner({f[0], f[1], f[2]}, {front_edge_[e[1]], front_edge_[e[2]], front_edge_[e[0]]});
      } else if (vertex.is_majority()) {
        add_majority(vertex);
      } else {
        add_tree(vertex, split_.trees[v]);
      }
    }
    for (std::size_t v = 0; v < front_.front().vertices().size(); ++v) front_.set_sheets(static_cast<int>(v));
  }

 private:
  static std::array<plane_id, 2> planes_of(const boundary::edge& e) { return sorted(e.planes); }

  // One moving edge for each edge of the solid; one for several that become one where facets of one
  // plane join.
  void add_input_edges() {
    disjoint_sets same(solid_.edges.size());  // the first edge represents
    for (std::size_t v = 0; v < split_.trees.size(); ++v)
      for (const auto& e : split_.trees[v].edges)
        if (e.rays[1] >= 0) {
          const auto [p, q] = std::minmax({same.find(solid_.vertices[v].edges[e.rays[0]]), same.find(solid_.vertices[v].edges[e.rays[1]])});
          same.unite(q, p);
          front_.merge_sheets(q, p);
        }
    for (int e = 0; e < static_cast<int>(solid_.edges.size()); ++e) {
      const int first = same.find(e);
      front_edge_.push_back(first == e ? front_.add_edge(planes_of(solid_.edges[e]), solid_.edges[e].convex, e) : front_edge_[first]);
    }
  }

  // A vertex of three facets, counter-clockwise, and the edges opposite them.
  void add_corner(const triple& facets, const std::array<int, 3>& edges) {
    const int id = front_.add_vertex(facets);
    const bool positive = generic_orientation(k_, facets[0], facets[1], facets[2]) == sign::positive;
    for (int r = 0; r < 3; ++r) front_.join(edges[r], id, facets[r], front_.front().edges()[edges[r]].convex == positive);
  }

  void add_tree(const boundary::vertex& v, const split_tree& t) {
    std::vector<int> edges;
    for (const split_edge& e : t.edges) {
      if (e.rays[0] >= 0) {
        edges.push_back(front_edge_[v.edges[e.rays[0]]]);
      } else {
        const auto planes = sorted(std::array{v.facets[e.a], v.facets[e.b]});
        edges.push_back(front_.add_edge(planes, e.convex, front_.add_sheet(planes, -1)));
      }
    }
    for (std::size_t c = 0; c < t.vertices.size(); ++c) {
      const auto& facets = t.vertices[c];
      const auto& opposite = t.vertex_edges[c];
      add_corner({v.facets[facets[0]], v.facets[facets[1]], v.facets[facets[2]]}, {edges[opposite[0]], edges[opposite[1]], edges[opposite[2]]});
    }
  }

  void add_majority(const boundary::vertex& v) {
    const int id = front_.add_vertex({v.facets[0], v.facets[1], v.facets[2]});
    for (int m = 0; m < 6; ++m) front_.join(front_edge_[v.edges[m]], id, v.facets[(m + 2) % 6], !solid_.edges[v.edges[m]].convex);
  }

  const K& k_;
  const boundary& solid_;
  const split_solid& split_;
  front_surgery<K>& front_;
  std::vector<int> front_edge_;  // by edge of the solid
};

}  // namespace osteon
