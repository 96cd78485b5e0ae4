// SPDX-License-Identifier: MIT

/// \file
/// A polyhedron's skeleton as plain data, and back.

#include "polyhedron_skeleton_data.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "document_numbers.hpp"
#include "osteon/door/documents.hpp"

namespace osteon {
namespace {

// A number that no vertex or edge has: the certificate refutes it.
constexpr int none = std::numeric_limits<int>::max();

/// Finds vertices and edges of a solid by points of its input.
class solid_index {
 public:
  explicit solid_index(const solid<integer>& s) : s_(s) {
    for (std::size_t v = 0; v < s.input_points.size(); ++v) vertices_.emplace(s.input_points[v], static_cast<int>(v));
    for (std::size_t e = 0; e < s.boundary.edges.size(); ++e) {
      const auto& ends = s.boundary.edges[e].ends;
      edges_[std::minmax({s.input_points[ends[0]], s.input_points[ends[1]]})] = static_cast<int>(e);
    }
  }

  /// The vertex at a point; where fans of facets touch there, the one with these planes, ascending.
  int vertex(int point, const std::array<int, 4>& planes) const {
    const auto [first, last] = vertices_.equal_range(point);
    const auto exact = std::find_if(first, last, [&](const auto& v) {
      const auto& f = s_.boundary.vertices[v.second].facets;
      std::array<int, 3> some = {f[0], f[1], f[2]};
      std::sort(some.begin(), some.end());
      return std::equal(some.begin(), some.end(), planes.begin());
    });
    return exact != last ? exact->second : first != last ? first->second : none;
  }
  int edge(const std::array<int, 2>& points) const {
    if (points == std::array{-1, -1}) return -1;
    const auto found = edges_.find(std::minmax({points[0], points[1]}));
    return found == edges_.end() ? none : found->second;
  }

 private:
  const solid<integer>& s_;
  std::multimap<int, int> vertices_;
  std::map<std::pair<int, int>, int> edges_;
};

event_class class_of(event_kind k) {
  const int c = static_cast<int>(k) - static_cast<int>(event_kind::E1);
  return c >= 0 && c < event_classes ? static_cast<event_class>(c) : event_class::other;
}

space_result result_of(const polyhedron_document& d, const solid<integer>& s) {
  const solid_index index(s);
  space_result r;
  for (const auto& n : d.nodes) {
    const bool is_vertex = n.event == event_kind::vertex;
    r.raw.nodes.push_back(
        {is_vertex ? index.vertex(n.vertex, n.planes) : -1, n.planes, is_vertex ? event_class::other : class_of(n.event), n.ambiguous, n.arcs});
  }
  for (const auto& a : d.arcs) r.raw.arcs.push_back({a.source, a.target, a.planes, static_cast<std::uint8_t>(a.corner), a.sheets});
  for (const auto& t : d.sheets) r.raw.sheets.push_back({t.planes, index.edge(t.edge), t.representative, t.arcs});
  r.raw.cells = d.cells;
  r.raw.events = d.events;
  r.raw.ambiguous = d.ambiguous;
  if (!d.contracted) return r;
  auto& exact = r.exact.emplace();
  for (const auto& n : d.contracted->nodes) exact.nodes.push_back({n.raw, n.arcs});
  for (const auto& a : d.contracted->arcs) exact.arcs.push_back({a.source, a.target, a.planes, a.sheets});
  for (const auto& t : d.contracted->sheets) exact.sheets.push_back({t.planes, t.raw, t.arcs});
  exact.cells = d.contracted->cells;
  return r;
}

}  // namespace

polyhedron_document polyhedron_skeleton::document() const {
  const data& d = *view_.data;
  const solid<integer>& s = d.body();
  const skeleton& raw = d.result.raw;
  polyhedron_document doc;
  doc.kernel = d.options.kernel;
  doc.prefer = d.options.prefer;
  doc.saddle = *d.options.saddle;
  doc.scale = {s.ten, s.two, {s.shift[0].str(), s.shift[1].str(), s.shift[2].str()}, 0, 0};
  doc.planes = texts_of<3>(s.planes);
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    const auto& n = raw.nodes[i];
    const auto& at = d.places()[i];
    auto& to = doc.nodes.emplace_back();
    to.vertex = n.vertex < 0 ? -1 : s.input_points[n.vertex];
    to.event = node({view_.data, true}, static_cast<int>(i)).event();
    to.ambiguous = n.ambiguous;
    to.planes = n.planes;
    to.arcs = n.arcs;
    to.has_place = at.has_value();
    if (at) {
      to.time = at->time;
      to.point = at->point;
    }
  }
  for (const auto& a : raw.arcs) doc.arcs.push_back({a.source, a.target, a.planes, a.corner, a.sheets});
  for (const auto& t : raw.sheets) {
    auto& to = doc.sheets.emplace_back();
    to.planes = t.facets;
    to.representative = t.representative;
    to.arcs = t.arcs;
    if (t.input_edge < 0) continue;
    const auto& ends = s.boundary.edges[t.input_edge].ends;
    to.edge = {s.input_points[ends[0]], s.input_points[ends[1]]};
  }
  doc.cells = raw.cells;
  doc.events = raw.events;
  doc.ambiguous = raw.ambiguous;
  if (!d.result.exact) return doc;
  auto& exact = (doc.contracted = polyhedron_document::exact_skeleton()).value();
  for (const auto& n : d.result.exact->nodes) exact.nodes.push_back({n.raw, n.arcs});
  for (const auto& a : d.result.exact->arcs) exact.arcs.push_back({a.source, a.target, a.cells, a.sheets});
  for (const auto& t : d.result.exact->sheets) exact.sheets.push_back({t.facets, t.raw, t.arcs});
  exact.cells = d.result.exact->cells;
  return doc;
}

std::optional<skeleton_refutation> verify(const polyhedron& p, const polyhedron_document& d) {
  const solid<integer>& s = p.access()->checked;
  for (std::size_t i = 0; i < std::max(s.planes.size(), d.planes.size()); ++i)
    if (i >= s.planes.size() || i >= d.planes.size() || !says(d.planes[i], s.planes[i]))
      return skeleton_refutation{"structure", "plane " + std::to_string(i) + " is not that of the solid"};
  return certify(s, result_of(d, s), d.kernel);
}

}  // namespace osteon
