// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The JSON that the program writes and reads; docs/skeleton.schema.json describes it.

#include <algorithm>
#include <cstdint>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "json_reader.hpp"
#include "osteon/core/error.hpp"
#include "osteon/evaluate/meeting.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::app {

inline constexpr const char* skeleton_format = "osteon skeleton 2";

/// The events of a skeleton by class, in the thesis's order.
inline json events_document(const skeleton& s) {
  json events = json::object();
  for (std::size_t i = 0; i < s.events.size(); ++i) events[std::string(event_names[i])] = s.events[i];
  return events;
}

inline json counts_document(const contracted_skeleton& s) {
  return {{"nodes", s.nodes.size()}, {"arcs", s.arcs.size()}, {"sheets", s.sheets.size()}, {"cells", s.cells}};
}

/// The length of the solid's unit in the input's.
inline rational unit_of(const solid<integer>& s) {
  const auto power = [](int base, int exponent) {
    const integer p = pow(integer(base), static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? rational(1, p) : rational(p);
  };
  return power(10, s.ten) * power(2, s.two);
}

/// How a skeleton came about.
struct provenance {
  std::string kernel, prefer, saddle;
};

/// The whole skeleton, without loss: read_skeleton gives it back. Exact numbers are strings; `time` and `point` follow from the planes and are
/// rounded to doubles, in the units of the input. Points and edges of the solid go by the points' numbers in the input, from 1.
inline json skeleton_document(const solid<integer>& of, const skeleton& s, const std::optional<contracted_skeleton>& exact, const provenance& by) {
  const locator where(of.planes);
  const rational unit = unit_of(of);
  const auto to_input = [&](const std::array<rational, 3>& p) {
    json point = json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) point.push_back(static_cast<double>(rational((p[axis] + of.shift[axis]) * unit)));
    return point;
  };

  json doc;
  doc["format"] = skeleton_format;
  doc["kernel"] = by.kernel;
  doc["prefer"] = by.prefer;
  doc["saddle"] = by.saddle;
  doc["scale"] = {{"ten", of.ten}, {"two", of.two}, {"shift", {of.shift[0].str(), of.shift[1].str(), of.shift[2].str()}}};
  doc["planes"] = json::array();
  for (const auto& p : of.planes)
    doc["planes"].push_back({{"n", {p.n[0].str(), p.n[1].str(), p.n[2].str()}}, {"d", p.d.str()}, {"weight", p.weight.str()}});
  doc["nodes"] = json::array();
  for (const auto& n : s.nodes) {
    json node;
    if (n.vertex >= 0) {
      const auto& p = of.points[static_cast<std::size_t>(n.vertex)];
      node = {{"vertex", of.input_points[static_cast<std::size_t>(n.vertex)] + 1},
              {"planes", {n.planes[0], n.planes[1], n.planes[2]}},
              {"time", 0.0},
              {"point", to_input({rational(p[0]), rational(p[1]), rational(p[2])})}};
    } else {
      node = {{"event", event_names[static_cast<std::size_t>(n.event)]}, {"ambiguous", n.ambiguous}, {"planes", n.planes}};
      if (const auto at = where.meeting(n.planes)) {
        node["time"] = static_cast<double>(rational(at->time * unit));
        node["point"] = to_input(at->point);
      }
    }
    node["arcs"] = n.arcs;
    doc["nodes"].push_back(std::move(node));
  }
  doc["arcs"] = json::array();
  for (const auto& a : s.arcs)
    doc["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"planes", a.planes}, {"corner", a.corner}, {"sheets", a.sheets}});
  doc["sheets"] = json::array();
  for (const auto& t : s.sheets) {
    json sheet = {{"facets", t.facets}, {"polygon", t.representative}, {"arcs", t.arcs}};
    if (t.input_edge >= 0) {
      const auto& ends = of.boundary.edges[static_cast<std::size_t>(t.input_edge)].ends;
      sheet["edge"] = {of.input_points[static_cast<std::size_t>(ends[0])] + 1, of.input_points[static_cast<std::size_t>(ends[1])] + 1};
    }
    doc["sheets"].push_back(std::move(sheet));
  }
  doc["cells"] = s.cells;
  doc["events"] = events_document(s);
  doc["ambiguous"] = s.ambiguous;
  if (exact) {
    json& c = doc["contracted"];
    c = {{"nodes", json::array()}, {"arcs", json::array()}, {"sheets", json::array()}, {"cells", exact->cells}};
    for (const auto& n : exact->nodes) c["nodes"].push_back({{"raw", n.raw}, {"arcs", n.arcs}});
    for (const auto& a : exact->arcs) c["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"cells", a.cells}, {"sheets", a.sheets}});
    for (const auto& t : exact->sheets) c["sheets"].push_back({{"facets", t.facets}, {"raw", t.raw}, {"arcs", t.arcs}});
  }
  return doc;
}

/// What a document says.
struct skeleton_file {
  provenance by;
  std::vector<moving_plane<integer>> planes;
  skeleton raw;
  std::optional<contracted_skeleton> exact;
};

/// Reads what skeleton_document writes. Throws input_error(not_skeleton) naming the element where the text has another shape; whether the numbers
/// make sense is not looked at (verify does), but all fit into their types. Linear in the text.
class skeleton_reader : json_reader {
 public:
  skeleton_reader(std::string name, const solid<integer>& of) : json_reader(std::move(name)), of_(of) {}

  skeleton_file read(std::istream& in) {
    const json doc = parse(in, skeleton_format);
    skeleton_file result;
    result.by = {text(doc, "kernel", ""), text(doc, "prefer", ""), text(doc, "saddle", "")};
    for_each(doc, "planes", [&](const json& p, const std::string& at) {
      const auto n = exact_numbers(member(p, "n", at), at + ".n");
      if (n.size() != 3) wrong(at + ".n", "needs three numbers");
      result.planes.push_back(
          {{n[0], n[1], n[2]}, exact_number_in(member(p, "d", at), at + ".d"), exact_number_in(member(p, "weight", at), at + ".weight")});
    });
    read_raw(doc, result.raw);
    if (doc.contains("contracted")) read_contracted(doc["contracted"], result.exact.emplace());
    return result;
  }

 private:
  void read_raw(const json& doc, skeleton& s) const {
    std::multimap<int, int> vertices_at;  // by point of the input; several where fans of facets touch
    for (std::size_t v = 0; v < of_.input_points.size(); ++v) vertices_at.emplace(of_.input_points[v] + 1, static_cast<int>(v));
    std::map<std::pair<int, int>, int> edge_of;  // by points
    for (std::size_t e = 0; e < of_.boundary.edges.size(); ++e) {
      const auto& ends = of_.boundary.edges[e].ends;
      edge_of[std::minmax({of_.input_points[static_cast<std::size_t>(ends[0])] + 1, of_.input_points[static_cast<std::size_t>(ends[1])] + 1})] =
          static_cast<int>(e);
    }
    // A number that no vertex or edge has: the certificate refutes it.
    const int none = std::numeric_limits<int>::max();
    const auto vertex = [&](int point, const std::array<int, 3>& planes) {
      const auto [first, last] = vertices_at.equal_range(point);
      const auto exact = std::find_if(first, last, [&](const auto& v) {
        const auto& f = of_.boundary.vertices[static_cast<std::size_t>(v.second)].facets;
        std::array<int, 3> some = {f[0], f[1], f[2]};
        std::sort(some.begin(), some.end());
        return some == planes;
      });
      return exact != last ? exact->second : first != last ? first->second : none;
    };

    for_each(doc, "nodes", [&](const json& n, const std::string& at) {
      skeleton::node node{-1, {-1, -1, -1, -1}, event_class::other, false, list(n, "arcs", at)};
      if (n.contains("vertex")) {
        const auto planes = tuple<3>(n, "planes", at);
        node.vertex = vertex(whole(n, "vertex", at), planes);
        node.planes = {planes[0], planes[1], planes[2], -1};
      } else {
        node.planes = tuple<4>(n, "planes", at);
        const auto found = std::find(event_names.begin(), event_names.end(), text(n, "event", at));
        if (found == event_names.end()) wrong(at + ".event", "is no class of events");
        node.event = static_cast<event_class>(found - event_names.begin());
        if (!member(n, "ambiguous", at).is_boolean()) wrong(at + ".ambiguous", "is neither true nor false");
        node.ambiguous = n["ambiguous"].get<bool>();
      }
      s.nodes.push_back(std::move(node));
    });
    for_each(doc, "arcs", [&](const json& a, const std::string& at) {
      const int corner = whole(a, "corner", at);
      if (corner < 0 || corner > 255) wrong(at + ".corner", "is not between 0 and 255");
      s.arcs.push_back(
          {whole(a, "source", at), whole(a, "target", at), tuple<3>(a, "planes", at), static_cast<std::uint8_t>(corner), list(a, "sheets", at)});
    });
    for_each(doc, "sheets", [&](const json& t, const std::string& at) {
      int edge = -1;
      if (t.contains("edge")) {
        const auto points = tuple<2>(t, "edge", at);
        const auto found = edge_of.find(std::minmax({points[0], points[1]}));
        edge = found == edge_of.end() ? none : found->second;
      }
      s.sheets.push_back({tuple<2>(t, "facets", at), edge, whole(t, "polygon", at), list(t, "arcs", at)});
    });
    for_each(doc, "cells", [&](const json& c, const std::string& at) { s.cells.push_back(list(c, at)); });
    for (std::size_t c = 0; c < event_names.size(); ++c)
      s.events[c] = whole(member(doc, "events", ""), std::string(event_names[c]).c_str(), "events");
    s.ambiguous = whole(member(doc, "ambiguous", ""), "ambiguous");
  }

  void read_contracted(const json& doc, contracted_skeleton& s) const {
    const std::string in = "contracted";
    for_each(
        doc, "nodes",
        [&](const json& n, const std::string& at) {
          s.nodes.push_back({list(n, "raw", at), list(n, "arcs", at)});
        },
        in);
    for_each(
        doc, "arcs",
        [&](const json& a, const std::string& at) {
          s.arcs.push_back({whole(a, "source", at), whole(a, "target", at), list(a, "cells", at), list(a, "sheets", at)});
        },
        in);
    for_each(
        doc, "sheets",
        [&](const json& t, const std::string& at) {
          s.sheets.push_back({tuple<2>(t, "facets", at), list(t, "raw", at), list(t, "arcs", at)});
        },
        in);
    s.cells = whole(doc, "cells", in);
  }

  const solid<integer>& of_;
};

}  // namespace osteon::app
