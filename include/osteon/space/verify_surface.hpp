// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate's rules `border` and `floor`: the surface of every cell is closed, and hangs
/// together with its facet.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/certificate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::certificate {

/// Demands rule `border`: at the solid's vertices the border of every polygon of sheets is closed,
/// and the edges of the sheets are those of the solid.
/// *Requires* rules `structure` and `incidence`. *Throws* refutation. *Complexity* n log n.
inline void check_borders(const boundary& solid, const skeleton& s) {
  std::map<std::pair<int, int>, int> ends;  // of a polygon's border, by representative and vertex
  std::map<std::pair<int, plane_id>, int> sides;
  for (const auto& sheet : s.sheets) {
    if (sheet.input_edge < 0) continue;
    for (const int v : solid.edges[sheet.input_edge].ends) ++ends[{sheet.representative, v}];
    for (const plane_id f : sheet.facets) ++sides[{sheet.input_edge, f}];
  }
  for (const auto& a : s.arcs) {
    const int v = s.nodes[a.source].vertex;
    if (v < 0) continue;
    for (const int t : a.sheets) ++ends[{s.sheets[t].representative, v}];
  }
  for (const auto& [at, times] : ends)
    demand(times % 2 == 0, rule::border, "sheet", at.first, ("has an open border at vertex " + std::to_string(at.second)).c_str());
  for (std::size_t e = 0; e < solid.edges.size(); ++e)
    for (const plane_id f : solid.edges[e].planes) ++sides[{static_cast<int>(e), f}];
  for (const auto& [at, times] : sides)
    demand(times % 2 == 0, rule::border, "edge", at.first, ("bounds no sheet, or a wrong one, of facet " + std::to_string(at.second)).c_str());
}

/// Demands rule `floor` for the cell of facet f: every part of the cell's surface that hangs
/// together touches the facet.
/// *Requires* rules `structure` and `incidence`. *Throws* refutation. *Complexity* n log n in the
/// cell's sheets and arcs.
inline void check_floor(const skeleton& s, plane_id f) {
  std::vector<int> polygons;  // the representatives of the cell's sheets, ascending
  std::set<int> arcs;
  for (const int t : s.cells[f]) {
    polygons.push_back(s.sheets[t].representative);
    arcs.insert(s.sheets[t].arcs.begin(), s.sheets[t].arcs.end());
  }
  std::sort(polygons.begin(), polygons.end());
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  const auto number = [&](const skeleton::sheet& sheet) {
    return static_cast<int>(std::lower_bound(polygons.begin(), polygons.end(), sheet.representative) - polygons.begin());
  };

  disjoint_sets parts(polygons.size());
  std::vector<bool> low(polygons.size());  // touches the facet
  for (const int t : s.cells[f])
    if (s.sheets[t].input_edge >= 0) low[number(s.sheets[t])] = true;
  for (const int a : arcs) {
    int first = -1;
    for (const int t : s.arcs[a].sheets) {
      const auto& sheet = s.sheets[t];
      if (sheet.facets[0] != f && sheet.facets[1] != f) continue;
      const int here = number(sheet);
      if (first >= 0) parts.unite(here, first);
      first = here;
      if (s.nodes[s.arcs[a].source].vertex >= 0) low[here] = true;
    }
  }
  std::vector<bool> grounded(polygons.size());
  for (std::size_t p = 0; p < low.size(); ++p)
    if (low[p]) grounded[parts.find(static_cast<int>(p))] = true;
  for (std::size_t p = 0; p < low.size(); ++p)
    demand(grounded[parts.find(static_cast<int>(p))], rule::floor, "cell", f, "has a part that does not touch its facet");
}

/// Demands rule `floor` for all cells.
inline void check_floors(const skeleton& s) {
  for (std::size_t f = 0; f < s.cells.size(); ++f) check_floor(s, static_cast<plane_id>(f));
}

}  // namespace osteon::certificate
