// SPDX-License-Identifier: MIT

/// \file
/// Laws of the raw skeleton as a cell complex: incidences, cycles, orientation, and Euler's counts. Nothing here depends on coordinates, so
/// every law holds for every solid under every kernel.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "events.hpp"
#include "laws.hpp"

namespace osteon::properties {
namespace {

std::string at(const char* what, int i) {
  std::string text = " (";
  text += what;
  text += ' ';
  text += std::to_string(i);
  return text += ')';
}

// ---- incidences

std::string incidences(const placed_skeleton& s) {
  const auto& raw = s.raw;
  for (int i = 0; i < static_cast<int>(raw.arcs.size()); ++i) {
    const auto& a = raw.arcs[i];
    if (a.source < 0 || a.source >= a.target || a.target >= static_cast<int>(raw.nodes.size()))
      return "an arc runs from an earlier node to a later one" + at("arc", i);
    if (!(a.planes[0] < a.planes[1] && a.planes[1] < a.planes[2])) return "an arc's planes ascend" + at("arc", i);
    if (a.sheets.size() != (a.corner == local::majority ? 6U : 3U)) return "an arc bounds three sheets, six at a majority corner" + at("arc", i);
    for (const int end : {a.source, a.target}) {
      const auto& n = raw.nodes[end];
      if (std::count(n.arcs.begin(), n.arcs.end(), i) != 1) return "a node lists its arcs" + at("arc", i);
      for (const plane_id p : a.planes) {
        const bool meets = n.vertex < 0 ? std::count(n.planes.begin(), n.planes.end(), p) == 1
                                        : std::count(s.boundary.vertices[n.vertex].facets.begin(), s.boundary.vertices[n.vertex].facets.end(), p) > 0;
        // A flood brings a facet to a vertex where it was not.
        if (!meets && n.vertex < 0) return "an arc's planes meet at its ends" + at("arc", i);
        if (s.planes.height(p, s.nodes[end].point, s.nodes[end].time) != 0) return "an arc's ends lie on its planes" + at("arc", i);
      }
    }
    if (s.nodes[a.source].time > s.nodes[a.target].time) return "time does not run backwards along an arc" + at("arc", i);
  }
  for (int i = 0; i < static_cast<int>(raw.nodes.size()); ++i) {
    const auto& n = raw.nodes[i];
    if (n.vertex < 0 && i > 0 && s.nodes[i].time < s.nodes[i - 1].time) return "nodes are in order of time" + at("node", i);
    if (n.arcs.empty()) return "a node has arcs" + at("node", i);
  }
  std::vector<std::set<int>> of_arcs(raw.sheets.size());
  for (int i = 0; i < static_cast<int>(raw.arcs.size()); ++i)
    for (const int x : raw.arcs[i].sheets) of_arcs[x].insert(i);
  for (int i = 0; i < static_cast<int>(raw.sheets.size()); ++i) {
    const auto& x = raw.sheets[i];
    if (std::set<int>(x.arcs.begin(), x.arcs.end()) != of_arcs[i]) return "a sheet lists its arcs" + at("sheet", i);
    if (raw.sheets[x.representative].representative != x.representative || raw.sheets[x.representative].facets != x.facets)
      return "a polygon represents itself" + at("sheet", i);
    for (const plane_id f : x.facets)
      if (std::count(raw.cells[f].begin(), raw.cells[f].end(), i) != 1) return "a sheet bounds the cells of its two facets" + at("sheet", i);
  }
  const auto in_cells =
      std::accumulate(raw.cells.begin(), raw.cells.end(), std::size_t{0}, [](std::size_t n, const auto& c) { return n + c.size(); });
  return in_cells == 2 * raw.sheets.size() ? "" : "a sheet bounds two cells";
}

// ---- cycles and orientation

// The border of a face as a chain, counter-clockwise with u to the right and time upwards; visit(from, to, arc or -1).
template <class Visit>
void walk(const placed_skeleton& s, const face& f, Visit visit) {
  for (const border& b : f.borders) {
    const auto& a = s.raw.arcs[b.arc];
    b.head ? visit(a.source, a.target, b.arc) : visit(a.target, a.source, b.arc);
  }
  for (const auto& e : f.base) visit(e[0], e[1], -1);
}

std::string sheets_are_cycles(const placed_skeleton& s) {
  for (const auto& [id, f] : s.faces) {
    std::map<int, int> balance;
    walk(s, f, [&](int from, int to, int) {
      --balance[from];
      ++balance[to];
    });
    for (const auto& [node, b] : balance)
      if (b != 0) return "the border of a sheet is closed" + at("polygon", id) + at("node", node);
  }
  return "";
}

std::string cells_are_closed(const placed_skeleton& s) {
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    std::map<std::pair<int, int>, int> balance;  // (arc, -1) or the ends of an edge of the solid
    for (const auto& [id, f] : s.faces) {
      if (f.facets[0] != p && f.facets[1] != p) continue;
      const int out = f.convex == (f.facets[0] == p) ? -1 : 1;
      walk(s, f, [&](int from, int to, int arc) { balance[arc >= 0 ? std::pair(arc, -1) : std::minmax({from, to})] += from < to ? out : -out; });
    }
    for (const auto& e : s.boundary.edges)
      for (const int side : {0, 1})
        if (e.planes[static_cast<std::size_t>(side)] == p)
          balance[std::minmax({e.ends[0], e.ends[1]})] += (e.ends[0] < e.ends[1]) == (side == 0) ? 1 : -1;
    for (const auto& [what, b] : balance)
      if (b != 0) return "sheets and floor of a cell make a closed oriented surface" + at("cell", p) + (what.second < 0 ? at("arc", what.first) : "");
  }
  return "";
}

// ---- Euler's counts

// What an event does follows from the corners before and after: without this the counts below would not be laws.
TEST(complex, corners_tell_what_an_event_does) {
  for (const auto& [g, e] : effects()) {
    EXPECT_EQ(e.changes.size(), 1U);
    EXPECT_EQ(e.kinds.size(), 1U);
    for (const event_class kind : e.kinds)
      if (kind != event_class::other) {
        EXPECT_EQ(e.changes.begin()->arcs, 4);
      }
  }
}

std::string events_are_in_the_catalogue(const placed_skeleton& s) {
  for (int i = 0; i < static_cast<int>(s.raw.nodes.size()); ++i) {
    if (s.raw.nodes[i].vertex >= 0) continue;
    const entry* e = effect_at(s.raw, i);
    if (e == nullptr) return "the corners before and after an event are those of an event of the catalogue" + at("node", i);
    if (*e->kinds.begin() != s.raw.nodes[i].event) return "an event's class is that of its corners" + at("node", i);
  }
  return "";
}

struct counts {
  long arcs = 0;
  long sheets = 0;
  long characteristic = 0;
};

counts of_events(const skeleton& raw) {
  counts sum;
  for (int i = 0; i < static_cast<int>(raw.nodes.size()); ++i) {
    if (raw.nodes[i].vertex >= 0) continue;
    const entry* e = effect_at(raw, i);
    if (e == nullptr) throw std::domain_error("an event is in the catalogue");
    sum.arcs += e->changes.begin()->arcs;
    sum.sheets += e->changes.begin()->sheets;
    sum.characteristic += e->changes.begin()->characteristic;
  }
  return sum;
}

// N = V + events;  2 A = sum over vertices of (k - 2), 1 at majority corners, + arcs at events;  S = E + sum of (k - 3) + edges that events make.
// Where facets of one plane join at a vertex or one floods an edge, the vertex has other counts.
std::string counts_add_up(const placed_skeleton& s) {
  const auto& raw = s.raw;
  const auto& b = s.boundary;
  long events = 0;
  for (std::size_t kind = 0; kind < raw.events.size(); ++kind) {
    events += raw.events[kind];
    const auto listed = std::count_if(raw.nodes.begin(), raw.nodes.end(),
                                      [&](const skeleton::node& n) { return n.vertex < 0 && n.event == static_cast<event_class>(kind); });
    if (listed != raw.events[kind]) return "events of each class are counted";
  }
  if (raw.nodes.size() != b.vertices.size() + static_cast<std::size_t>(events)) return "each input vertex and each event is one node";
  std::set<int> swept;
  for (const auto& x : raw.sheets)
    if (x.input_edge >= 0 && !swept.insert(x.input_edge).second) return "";  // flooded
  const counts c = of_events(raw);
  long arcs = c.arcs;
  long sheets = c.sheets + static_cast<long>(b.edges.size());
  for (const auto& v : b.vertices) {
    const auto k = static_cast<long>(v.facets.size());
    if (v.is_majority()) {
      arcs += 1;
    } else if (std::set<plane_id>(v.facets.begin(), v.facets.end()).size() != v.facets.size()) {
      return "";
    } else {
      arcs += k - 2;
      sheets += k - 3;
    }
  }
  if (2 * static_cast<long>(raw.arcs.size()) != arcs) return "every arc has two ends, counted by vertices and events";
  if (static_cast<long>(raw.sheets.size()) != sheets) return "every sheet begins at an edge, a split or an event";
  return "";
}

// The solid ends as nothing: its Euler characteristic, half of that of its surface, is what its events take away.
std::string characteristic_is_used_up(const placed_skeleton& s, const input_mesh<integer>& m) {
  const auto ends = std::accumulate(m.facets.begin(), m.facets.end(), std::size_t{0}, [](std::size_t n, const auto& f) { return n + f.size(); });
  const long surface = static_cast<long>(m.points.size()) - static_cast<long>(ends / 2) + static_cast<long>(m.facets.size());
  const long taken = -of_events(s.raw).characteristic;
  if (surface == 2 * taken) return "";
  return "the events take away the solid's Euler characteristic: " + std::to_string(surface) + " / 2, they take " + std::to_string(taken);
}

// V - E + F of a cell's surface, where each face is one simple cycle. Where the surface touches itself in a node, that counts once for each
// part (each cycle of arcs and sheets around it). Nothing where a face is no disk.
std::optional<long> surface_characteristic(const placed_skeleton& s, plane_id p) {
  std::vector<std::vector<std::pair<int, int>>> borders;
  for (const auto& [id, f] : s.faces) {
    if (f.facets[0] != p && f.facets[1] != p) continue;
    auto& border = borders.emplace_back();
    walk(s, f, [&](int from, int to, int) { border.emplace_back(from, to); });
  }
  auto& floor = borders.emplace_back();
  for (const auto& e : s.boundary.edges)
    if (e.planes[0] == p || e.planes[1] == p) floor.emplace_back(e.ends[0], e.ends[1]);
  std::map<int, std::map<std::pair<int, int>, std::vector<std::size_t>>> around;  // by node, by other end: the faces
  std::set<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    std::map<int, std::vector<int>> next;
    for (const auto& [a, b] : borders[i]) {
      if (!edges.insert(std::minmax({a, b})).second && std::count(borders[i].begin(), borders[i].end(), std::pair(a, b)) > 1) return std::nullopt;
      next[a].push_back(b);
      next[b].push_back(a);
      around[a][std::minmax({a, b})].push_back(i);
      around[b][std::minmax({a, b})].push_back(i);
    }
    std::size_t length = 0;
    int previous = -1;
    int node = borders[i].front().first;
    do {
      if (next[node].size() != 2) return std::nullopt;
      const int step = next[node][0] == previous ? next[node][1] : next[node][0];
      previous = node;
      node = step;
      ++length;
    } while (node != borders[i].front().first && length <= borders[i].size());
    if (length != borders[i].size()) return std::nullopt;
  }
  long vertices = 0;
  for (const auto& [node, fans] : around) {
    std::vector<std::vector<std::size_t>> groups;
    for (const auto& [edge, faces] : fans) {
      if (faces.size() != 2) return std::nullopt;
      std::vector<std::size_t> joined = faces;
      for (auto& g : groups)
        if (std::any_of(g.begin(), g.end(), [&](std::size_t f) { return std::count(joined.begin(), joined.end(), f) > 0; })) {
          joined.insert(joined.end(), g.begin(), g.end());
          g.clear();
        }
      groups.push_back(joined);
    }
    vertices += std::count_if(groups.begin(), groups.end(), [](const auto& g) { return !g.empty(); });
  }
  return vertices - static_cast<long>(edges.size()) + static_cast<long>(borders.size());
}

std::string surfaces_are_even(const placed_skeleton& s) {
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    const auto c = surface_characteristic(s, p);
    if (c && *c % 2 != 0) return "the Euler characteristic of a cell's surface is even" + at("cell", p);
  }
  return "";
}

RC_GTEST_PROP(complex, incidences_agree, ()) { for_every_kernel(*gen::unweighted(), incidences, *gen::any_options()); }

RC_GTEST_PROP(complex, sheets_are_cycles, ()) { for_every_kernel(*gen::unweighted(), sheets_are_cycles, *gen::any_options()); }

RC_GTEST_PROP(complex, cells_are_closed_and_oriented, ()) { for_every_kernel(*gen::unweighted(), cells_are_closed, *gen::any_options()); }

RC_GTEST_PROP(complex, events_are_in_the_catalogue, ()) { for_every_kernel(*gen::unweighted(), events_are_in_the_catalogue, *gen::any_options()); }

RC_GTEST_PROP(complex, counts_add_up, ()) { for_every_kernel(*gen::unweighted(), counts_add_up, *gen::any_options()); }

RC_GTEST_PROP(complex, events_use_up_the_characteristic, ()) {
  const auto s = *gen::unweighted();
  for_every_kernel(
      s, [&](const placed_skeleton& p) { return characteristic_is_used_up(p, s.input); }, *gen::any_options());
}

RC_GTEST_PROP(complex, surfaces_have_even_characteristic, ()) { for_every_kernel(*gen::unweighted(), surfaces_are_even, *gen::any_options()); }

// Convex: every cell is a ball with disks for faces, and the cells fill a ball.
RC_GTEST_PROP(complex, convex_cells_are_balls, ()) {
  for_every_kernel(*gen::general(rc::gen::oneOf(gen::hulls(1000, 8), gen::cut_solids())), [](const placed_skeleton& s) -> std::string {
    for (plane_id p = 0; p < s.planes.size(); ++p)
      if (surface_characteristic(s, p).value_or(0) != 2) return "the cell of a facet of a convex solid is a ball" + at("cell", p);
    const auto number = [](const auto& list) { return static_cast<long>(list.size()); };
    // There are as many facets as cells.
    const long whole = number(s.raw.nodes) - number(s.raw.arcs) - number(s.boundary.edges) + number(s.faces);
    return whole == 1 ? "" : "nodes - arcs - edges + sheets + facets - cells = 1";
  });
}

}  // namespace
}  // namespace osteon::properties
