// SPDX-License-Identifier: MIT

/// \file
/// A polygon's skeleton as plain data, and back.

#include "document_numbers.hpp"
#include "osteon/door/documents.hpp"
#include "polygon_data.hpp"
#include "polygon_skeleton_data.hpp"

namespace osteon {
namespace {

template <class Arc>
std::vector<polygon_document::arc> arcs_of(const std::vector<Arc>& arcs) {
  std::vector<polygon_document::arc> result;
  result.reserve(arcs.size());
  for (const auto& a : arcs) result.push_back({a.source, a.target, a.faces});
  return result;
}

template <class Arc>
std::vector<Arc> arcs_from(const std::vector<polygon_document::arc>& arcs) {
  std::vector<Arc> result;
  result.reserve(arcs.size());
  for (const auto& a : arcs) result.push_back({a.source, a.target, a.faces});
  return result;
}

plane_result result_of(const polygon_document& d) {
  plane_result r;
  for (const auto& n : d.nodes)
    r.raw.nodes.push_back({n.vertex, n.lines, n.event == event_kind::split ? plane::event_class::split : plane::event_class::edge, n.zero_length});
  r.raw.arcs = arcs_from<plane::skeleton::arc>(d.arcs);
  r.raw.faces = d.faces;
  for (const auto& p : d.interior_nodes) r.raw.interior_nodes.push_back({p.arc, p.node});
  r.raw.events = d.events;
  if (!d.contracted) return r;
  auto& exact = r.exact.emplace();
  for (const auto& n : d.contracted->nodes) exact.nodes.push_back({n.vertex, n.lines, n.corner});
  exact.arcs = arcs_from<plane::contracted_skeleton::arc>(d.contracted->arcs);
  exact.vertices = d.contracted->vertices;
  exact.faces = d.contracted->faces;
  return r;
}

bool is_of(const polygon_document& d, const plane::polygon<integer>& p) {
  const auto& b = p.boundary;
  bool same = d.lines.size() == p.lines.size() && d.outline.size() == b.next.size();
  for (std::size_t i = 0; same && i < d.outline.size(); ++i) same = d.outline[i].next == b.next[i] && d.outline[i].line == b.line[i];
  for (std::size_t i = 0; same && i < d.lines.size(); ++i) same = says(d.lines[i], p.lines[i]);
  return same;
}

}  // namespace

polygon_document polygon_skeleton::document() const {
  const data& d = *view_.data;
  const plane::polygon<integer>& p = *d.input;
  polygon_document doc;
  doc.kernel = d.options.kernel;
  doc.region = d.options.region;
  doc.scale = {p.ten, p.two, {p.shift[0].str(), p.shift[1].str()}, p.weight_ten, p.weight_two};
  doc.lines = texts_of<2>(p.lines);
  for (std::size_t i = 0; i < p.boundary.next.size(); ++i) doc.outline.push_back({p.input_points[i], p.boundary.next[i], p.boundary.line[i]});
  doc.nodes.reserve(d.result.raw.nodes.size());
  for (std::size_t i = 0; i < d.result.raw.nodes.size(); ++i) {
    const auto& n = d.result.raw.nodes[i];
    const plane::located at = d.place(true, static_cast<int>(i));
    const event_kind kind = n.vertex >= 0 ? event_kind::vertex : (n.event == plane::event_class::edge ? event_kind::edge : event_kind::split);
    doc.nodes.push_back({n.vertex, kind, n.zero_length, n.lines, at.time, {at.x, at.y}});
  }
  doc.arcs = arcs_of(d.result.raw.arcs);
  doc.faces = d.result.raw.faces;
  for (const auto& x : d.result.raw.interior_nodes) doc.interior_nodes.push_back({x.arc, x.node});
  doc.events = d.result.raw.events;
  if (!d.result.exact) return doc;
  auto& exact = (doc.contracted = polygon_document::exact_skeleton()).value();
  exact.nodes.reserve(d.result.exact->nodes.size());
  for (std::size_t i = 0; i < d.result.exact->nodes.size(); ++i) {
    const auto& n = d.result.exact->nodes[i];
    const plane::located at = d.place(false, static_cast<int>(i));
    exact.nodes.push_back({n.vertex, n.lines, n.corner, at.time, {at.x, at.y}});
  }
  exact.arcs = arcs_of(d.result.exact->arcs);
  exact.vertices = d.result.exact->vertices;
  exact.faces = d.result.exact->faces;
  return doc;
}

std::optional<skeleton_refutation> verify(const polygon& p, const polygon_document& d) {
  const auto checked = checked_polygon(p, d.region);
  if (!is_of(d, *checked)) return skeleton_refutation{"structure", "the lines and edges are not those of the polygon"};
  const plane_question q{*checked, d.region == region::exterior};
  return certify(q, result_of(d), d.kernel);
}

}  // namespace osteon
