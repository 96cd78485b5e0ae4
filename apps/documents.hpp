// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The JSON that the program writes.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "osteon/contract.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/locate.hpp"
#include "osteon/skeleton.hpp"
#include "osteon/solid.hpp"

namespace osteon::app {

using json = nlohmann::ordered_json;

/// The events of a skeleton by class, in the thesis's order.
inline json events_document(const skeleton& s) {
  json events = json::object();
  for (std::size_t i = 0; i < s.events.size(); ++i) events[std::string(event_names[i])] = s.events[i];
  return events;
}

inline json counts_document(const contracted_skeleton& s) {
  return {{"nodes", s.nodes.size()}, {"arcs", s.arcs.size()}, {"sheets", s.sheets.size()}, {"cells", s.cells}};
}

/// The whole skeleton. Exact numbers are strings; `time` and `point` are rounded to doubles, in the units of the input.
inline json skeleton_document(const solid<integer>& of, const skeleton& s, const std::optional<contracted_skeleton>& exact) {
  const locator where(of.planes);
  const rational unit = [&] {
    const auto power = [](int base, int exponent) {
      const integer p = pow(integer(base), static_cast<unsigned>(std::abs(exponent)));
      return exponent < 0 ? rational(1, p) : rational(p);
    };
    return rational(power(10, of.ten) * power(2, of.two));
  }();
  const auto to_input = [&](const std::array<rational, 3>& p) {
    json point = json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) point.push_back(static_cast<double>(rational((p[axis] + of.shift[axis]) * unit)));
    return point;
  };

  json doc;
  doc["format"] = "osteon skeleton 1";
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
  for (const auto& a : s.arcs) doc["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"planes", a.planes}, {"sheets", a.sheets}});
  doc["sheets"] = json::array();
  for (const auto& t : s.sheets) doc["sheets"].push_back({{"facets", t.facets}, {"polygon", t.polygon}, {"arcs", t.arcs}});
  doc["cells"] = s.cells;
  if (exact) {
    json& c = doc["contracted"];
    c = {{"nodes", json::array()}, {"arcs", json::array()}, {"sheets", json::array()}};
    for (const auto& n : exact->nodes) c["nodes"].push_back({{"raw", n.raw}, {"arcs", n.arcs}});
    for (const auto& a : exact->arcs) c["arcs"].push_back({{"source", a.source}, {"target", a.target}, {"cells", a.cells}, {"sheets", a.sheets}});
    for (const auto& t : exact->sheets) c["sheets"].push_back({{"facets", t.facets}, {"raw", t.raw}, {"arcs", t.arcs}});
  }
  return doc;
}

}  // namespace osteon::app
