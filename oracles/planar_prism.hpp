// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// High prisms: where floor and roof have not arrived, the skeleton of the solid is that of the floor, drawn upwards. The library against itself, one
/// dimension up.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/mesh.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"
#include "planar_ours.hpp"

namespace osteon::oracles {

/// The skeleton of a prism: by arc that only walls meet in, the lines (lines_of) of these walls, sorted.
inline std::vector<std::vector<int>> upright_arcs(const planar_input& input, const input_mesh<integer>& prism, const std::vector<int>& wall_of_edge) {
  const auto lines = lines_of(input);
  const auto s = make_solid(prism);
  std::map<plane_id, int> line_of;  // of the planes of walls
  for (std::size_t e = 0; e < wall_of_edge.size(); ++e) line_of[s.facet_planes[static_cast<std::size_t>(wall_of_edge[e])]] = lines[e];
  const std::span<const moving_plane<integer>> planes(s.planes);
  const auto k = perturbed(filtered(planes, make_sqrt_kernel(planes)));
  const auto raw = straight_skeleton(k, s.boundary);
  std::vector<std::vector<int>> result;
  for (const auto& arc : contract(k.base(), s.boundary, raw).arcs) {
    std::vector<int> walls;
    for (const plane_id p : arc.cells)
      if (const auto found = line_of.find(p); found != line_of.end()) walls.push_back(found->second);
    if (walls.size() != arc.cells.size()) continue;
    std::sort(walls.begin(), walls.end());
    result.push_back(std::move(walls));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// A prism over a polygon of one ring, higher than twice its width.
inline input_mesh<integer> prism_over(const planar_input& input, std::vector<int>& wall_of_edge) {
  const auto& ring = input.rings.front();
  const auto n = static_cast<int>(ring.size());
  const double top = 2 * std::ceil(size_of(input)) + 1;
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>> facets(2);
  for (const double z : {0.0, top})
    for (const auto& p : ring) points.push_back({p[0], p[1], z});
  for (int i = 0; i < n; ++i) {
    facets[0].push_back(n - 1 - i);
    facets[1].push_back(n + i);
    wall_of_edge.push_back(static_cast<int>(facets.size()));
    facets.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return make_input_mesh<integer>(points, facets);
}

/// What is different between the skeleton of a polygon (one ring, no weights) and that of the prism over it; empty: nothing. The nodes of the polygon
/// must be the arcs of the solid that only walls meet in.
inline std::string prism_difference(const planar_input& input) {
  const auto lines = lines_of(input);
  std::vector<std::vector<int>> nodes;
  for (const auto& node : nodes_of(skeletons_of(input))) {
    auto& fresh = nodes.emplace_back();
    for (const int e : node.edges) fresh.push_back(lines[static_cast<std::size_t>(e)]);
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    if (fresh.size() < 3) nodes.pop_back();
  }
  std::sort(nodes.begin(), nodes.end());
  std::vector<int> walls;
  const auto prism = prism_over(input, walls);
  const auto arcs = upright_arcs(input, prism, walls);
  if (nodes == arcs) return "";
  const auto text = [](const std::vector<std::vector<int>>& a, const std::vector<std::vector<int>>& b) {
    std::vector<std::vector<int>> only;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
    std::string result;
    for (const auto& list : only) {
      result += " (";
      for (const int e : list) result += std::string(" ") + std::to_string(e);
      result += " )";
    }
    return result;
  };
  return "only nodes of the polygon:" + text(nodes, arcs) + "; only arcs of the prism:" + text(arcs, nodes);
}

}  // namespace osteon::oracles
