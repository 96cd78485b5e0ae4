// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Straight skeletons of polygons without weights by CGAL: exact decisions, rounded places.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planar_node.hpp"

namespace osteon::oracles {

/// The skeleton's nodes by CGAL; those nearer than 1e-9 of the polygon's size are merged. Edges on one line that meet on their way stay apart in
/// CGAL, which leaves nodes of fewer than three lines: they are dropped. Throws planar_give_up for weights, where CGAL has no answer, and where it
/// throws.
inline std::vector<planar_node> nodes_by_cgal(const planar_input& input) {
  using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using ring = CGAL::Polygon_2<kernel>;
  const auto edges = edges_of(input);
  const auto lines = lines_of(input);
  std::map<std::array<std::array<double, 2>, 2>, int> numbers;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].weight != 1) throw planar_give_up("CGAL 5.5 knows no weights");
    numbers.emplace(std::array{edges[e].from, edges[e].to}, static_cast<int>(e));
  }
  std::vector<ring> rings;
  for (const auto& r : input.rings) {
    ring& fresh = rings.emplace_back();
    for (const auto& p : r) fresh.push_back({p[0], p[1]});
  }
  decltype(CGAL::create_interior_straight_skeleton_2(rings.front(), kernel())) skeleton;
  try {
    skeleton =
        CGAL::create_interior_straight_skeleton_2(rings[0].vertices_begin(), rings[0].vertices_end(), rings.begin() + 1, rings.end(), kernel());
  } catch (const std::exception& e) {
    throw planar_give_up(std::string("CGAL: ") + e.what());
  }
  if (!skeleton) throw planar_give_up("CGAL: no skeleton");
  const auto number = [&](const auto& half) {  // of a contour edge that has its face on the left
    const auto& from = half->opposite()->vertex()->point();
    const auto& to = half->vertex()->point();
    const auto found = numbers.find({std::array{from.x(), from.y()}, std::array{to.x(), to.y()}});
    if (found == numbers.end()) throw planar_give_up("CGAL: a face without an edge of the polygon");
    return lines[static_cast<std::size_t>(found->second)];
  };
  std::vector<planar_node> nodes;
  for (auto v = skeleton->vertices_begin(); v != skeleton->vertices_end(); ++v) {
    if (!v->is_skeleton()) continue;
    planar_node& n = nodes.emplace_back(planar_node{v->point().x(), v->point().y(), v->time(), {}});
    auto around = v->halfedge_around_vertex_begin();
    const auto first = around;
    do n.edges.push_back(number((*around)->defining_contour_edge()));
    while (++around != first);
    std::sort(n.edges.begin(), n.edges.end());
    n.edges.erase(std::unique(n.edges.begin(), n.edges.end()), n.edges.end());
  }
  nodes = merged(nodes, size_of(input) * 1e-9);
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), [](const planar_node& n) { return n.edges.size() < 3; }), nodes.end());
  return nodes;
}

}  // namespace osteon::oracles
