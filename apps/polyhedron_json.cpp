// SPDX-License-Identifier: MIT

/// \file
/// The JSON of polyhedra's skeletons.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "documents.hpp"
#include "json_reader.hpp"

namespace osteon::app {
namespace {

constexpr int event_classes = 14;

event_kind event_of_class(int c) { return static_cast<event_kind>(static_cast<int>(event_kind::E1) + c); }

template <int D>
json plane_json(const exact_plane<D>& p) {
  return {{"n", p.n}, {"d", p.d}, {"weight", p.weight}};
}

json node_json(const polyhedron_document::node& n) {
  json node;
  if (n.event == event_kind::vertex)
    node = {{"vertex", n.vertex + 1}, {"planes", {n.planes[0], n.planes[1], n.planes[2]}}};
  else
    node = {{"event", name_of(n.event)}, {"ambiguous", n.ambiguous}, {"planes", n.planes}};
  if (n.has_place) {
    node["time"] = n.time;
    node["point"] = n.point;
  }
  node["arcs"] = n.arcs;
  return node;
}

json sheet_json(const polyhedron_document::sheet& t) {
  json sheet = {{"facets", t.planes}, {"polygon", t.representative}, {"arcs", t.arcs}};
  if (t.edge[0] >= 0) sheet["edge"] = {t.edge[0] + 1, t.edge[1] + 1};
  return sheet;
}

json contracted_json(const polyhedron_document::exact_skeleton& s) {
  json c = {{"nodes", json::array()}, {"arcs", json::array()}, {"sheets", json::array()}, {"cells", s.cells}};
  for (const auto& n : s.nodes) c["nodes"].push_back({{"raw", n.raw}, {"arcs", n.arcs}});
  for (const auto& a : s.arcs) c["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"cells", a.planes}, {"sheets", a.sheets}});
  for (const auto& t : s.sheets) c["sheets"].push_back({{"facets", t.planes}, {"raw", t.raw}, {"arcs", t.arcs}});
  return c;
}

class polyhedron_reader : json_reader {
 public:
  using json_reader::json_reader;

  polyhedron_document read(std::istream& in) const {
    const json doc = parse(in, skeleton_format);
    polyhedron_document result;
    result.kernel = choice(doc, "kernel", kernels);
    result.prefer = choice(doc, "prefer", preferences);
    result.saddle = choice(doc, "saddle", saddles);
    for_each(doc, "planes", [&](const json& p, const std::string& at) { result.planes.push_back(plane<3>(p, at)); });
    for_each(doc, "nodes", [&](const json& n, const std::string& at) { result.nodes.push_back(node(n, at)); });
    for_each(doc, "arcs", [&](const json& a, const std::string& at) {
      const int corner = whole(a, "corner", at);
      if (corner < 0 || corner > 255) wrong(at + ".corner", "is not between 0 and 255");
      result.arcs.push_back({whole(a, "source", at), whole(a, "target", at), tuple<3>(a, "planes", at), corner, list(a, "sheets", at)});
    });
    for_each(doc, "sheets", [&](const json& t, const std::string& at) {
      auto& sheet = result.sheets.emplace_back();
      sheet = {tuple<2>(t, "facets", at), whole(t, "polygon", at), list(t, "arcs", at)};
      if (!t.contains("edge")) return;
      const auto points = tuple<2>(t, "edge", at);
      sheet.edge = {point(points[0]), point(points[1])};
    });
    for_each(doc, "cells", [&](const json& c, const std::string& at) { result.cells.push_back(list(c, at)); });
    const json& events = member(doc, "events", "");
    for (int c = 0; c < event_classes; ++c)
      result.events[static_cast<std::size_t>(c)] = whole(events, std::string(name_of(event_of_class(c))).c_str(), "events");
    result.ambiguous = whole(member(doc, "ambiguous", ""), "ambiguous");
    if (doc.contains("contracted")) result.contracted = contracted(doc["contracted"]);
    return result;
  }

 private:
  // The document counts points from 1. What is no number of a point becomes one that no solid has,
  // so that the certificate refutes it.
  static int point(int number) { return number < 1 ? std::numeric_limits<int>::max() : number - 1; }

  polyhedron_document::node node(const json& n, const std::string& at) const {
    polyhedron_document::node result{-1, event_kind::vertex, false, {-1, -1, -1, -1}, list(n, "arcs", at)};
    if (n.contains("vertex")) {
      const auto planes = tuple<3>(n, "planes", at);
      result.vertex = point(whole(n, "vertex", at));
      result.planes = {planes[0], planes[1], planes[2], -1};
      return result;
    }
    result.planes = tuple<4>(n, "planes", at);
    const auto event = event_of_name(text(n, "event", at));
    if (!event || *event < event_kind::E1 || *event > event_kind::other) wrong(at + ".event", "is no class of events");
    result.event = *event;
    result.ambiguous = truth(n, "ambiguous", at);
    return result;
  }

  polyhedron_document::exact_skeleton contracted(const json& doc) const {
    const std::string in = "contracted";
    polyhedron_document::exact_skeleton s;
    const auto each = [&](const char* key, auto visit) { for_each(doc, key, visit, in); };
    each("nodes", [&](const json& n, const std::string& at) { s.nodes.push_back({list(n, "raw", at), list(n, "arcs", at)}); });
    each("arcs", [&](const json& a, const std::string& at) {
      s.arcs.push_back({whole(a, "source", at), whole(a, "target", at), list(a, "cells", at), list(a, "sheets", at)});
    });
    each("sheets", [&](const json& t, const std::string& at) {
      s.sheets.push_back({tuple<2>(t, "facets", at), list(t, "raw", at), list(t, "arcs", at)});
    });
    s.cells = whole(doc, "cells", in);
    return s;
  }
};

}  // namespace

void write_document(std::ostream& out, const polyhedron_document& d) {
  json doc;
  doc["format"] = skeleton_format;
  doc["kernel"] = name_of(d.kernel);
  doc["prefer"] = name_in(preferences, d.prefer);
  doc["saddle"] = name_in(saddles, d.saddle);
  doc["scale"] = {{"ten", d.scale.ten}, {"two", d.scale.two}, {"shift", d.scale.shift}};
  for (const char* list : {"planes", "nodes", "arcs", "sheets"}) doc[list] = json::array();
  for (const auto& p : d.planes) doc["planes"].push_back(plane_json(p));
  for (const auto& n : d.nodes) doc["nodes"].push_back(node_json(n));
  for (const auto& a : d.arcs)
    doc["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"planes", a.planes}, {"corner", a.corner}, {"sheets", a.sheets}});
  for (const auto& t : d.sheets) doc["sheets"].push_back(sheet_json(t));
  doc["cells"] = d.cells;
  doc["events"] = json::object();
  for (int c = 0; c < event_classes; ++c) doc["events"][std::string(name_of(event_of_class(c)))] = d.events[static_cast<std::size_t>(c)];
  doc["ambiguous"] = d.ambiguous;
  if (d.contracted) doc["contracted"] = contracted_json(*d.contracted);
  out << doc.dump() << '\n';
}

polyhedron_document read_polyhedron_document(std::istream& in, const std::string& name) { return polyhedron_reader(name).read(in); }

}  // namespace osteon::app
