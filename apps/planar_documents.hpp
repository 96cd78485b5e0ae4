// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The JSON of polygons' skeletons; docs/planar_skeleton.schema.json describes it.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "json_reader.hpp"
#include "osteon/evaluate/locate.hpp"
#include "planar.hpp"

namespace osteon::app {

inline constexpr const char* planar_format = "osteon planar skeleton 1";
inline constexpr std::array<const char*, 2> planar_event_names = {"edge", "split"};

/// How a skeleton came about.
struct planar_provenance {
  std::string kernel;
  bool outside = false;
};

/// Faces that are their own representatives.
inline int faces_of(const plane::skeleton& s) {
  int count = 0;
  for (std::size_t f = 0; f < s.faces.size(); ++f) count += s.faces[f] == static_cast<int>(f) ? 1 : 0;
  return count;
}

/// Writes the whole skeleton, without loss: planar_reader gives it back. One element a line, so that a million vertices need no more memory than the
/// skeleton has. Exact numbers are strings; `time` and `point` follow from the lines and are rounded to doubles, in the units of the input. Edge i,
/// face i and vertex i belong together (see `outline`), counted from 0.
inline void write_planar_skeleton(std::ostream& out, const plane::polygon<integer>& p, const planar_skeletons& s, const planar_provenance& by) {
  const plane::fast_locator where(p);
  const auto list = [&out](const char* name, std::size_t size, auto element) {
    fmt::print(out, "\"{}\":[", name);
    for (std::size_t i = 0; i < size; ++i) {
      fmt::print(out, "{}\n", i == 0 ? "" : ",");
      element(i);
    }
    fmt::print(out, "]");
  };
  const auto number = [](double x) { return json(x).dump(); };
  const auto place = [&](int vertex, const triple& q) {
    const plane::located at = vertex >= 0 ? where.vertex(vertex) : where.meeting(q);
    fmt::print(out, "\"time\":{},\"point\":[{},{}]}}", number(at.time), number(at.x), number(at.y));
  };
  const auto arcs = [&](const auto& all) {
    list("arcs", all.size(), [&](std::size_t i) {
      fmt::print(out, "{{\"source\":{},\"target\":{},\"faces\":[{},{}]}}", all[i].source, all[i].target, all[i].faces[0], all[i].faces[1]);
    });
  };
  fmt::print(out, "{{\"format\":{},\"kernel\":{},\"outside\":{},\n", json(planar_format).dump(), json(by.kernel).dump(), by.outside);
  fmt::print(out, "\"scale\":{{\"ten\":{},\"two\":{},\"shift\":[\"{}\",\"{}\"],\"weight_ten\":{},\"weight_two\":{}}},\n", p.ten, p.two,
             p.shift[0].str(), p.shift[1].str(), p.weight_ten, p.weight_two);
  list("lines", p.lines.size(), [&](std::size_t i) {
    const auto& l = p.lines[i];
    fmt::print(out, "{{\"n\":[\"{}\",\"{}\"],\"d\":\"{}\",\"weight\":\"{}\"}}", l.n[0].str(), l.n[1].str(), l.d.str(), l.weight.str());
  });
  fmt::print(out, ",\n");
  list("outline", p.boundary.next.size(), [&](std::size_t i) {
    fmt::print(out, "{{\"point\":{},\"next\":{},\"line\":{}}}", p.input_points[i] + 1, p.boundary.next[i], p.boundary.line[i]);
  });
  fmt::print(out, ",\n");
  list("nodes", s.raw.nodes.size(), [&](std::size_t i) {
    const auto& n = s.raw.nodes[i];
    if (n.vertex >= 0)
      fmt::print(out, "{{\"vertex\":{},\"lines\":[{},{}],", n.vertex, n.lines[0], n.lines[1]);
    else
      fmt::print(out, "{{\"event\":\"{}\",\"late\":{},\"lines\":[{},{},{}],", planar_event_names[static_cast<std::size_t>(n.event)], n.zero_length,
                 n.lines[0], n.lines[1], n.lines[2]);
    place(n.vertex, n.lines);
  });
  fmt::print(out, ",\n");
  arcs(s.raw.arcs);
  fmt::print(out, ",\n");
  list("faces", s.raw.faces.size(), [&](std::size_t i) { fmt::print(out, "{}", s.raw.faces[i]); });
  fmt::print(out, ",\n");
  list("passes", s.raw.interior_nodes.size(),
       [&](std::size_t i) { fmt::print(out, "{{\"arc\":{},\"node\":{}}}", s.raw.interior_nodes[i].arc, s.raw.interior_nodes[i].node); });
  fmt::print(out, ",\n\"events\":{{\"edge\":{},\"split\":{}}}", s.raw.events[0], s.raw.events[1]);
  if (s.exact) {
    fmt::print(out, ",\n\"contracted\":{{");
    list("nodes", s.exact->nodes.size(), [&](std::size_t i) {
      const auto& n = s.exact->nodes[i];
      fmt::print(out, "{{\"vertex\":{},\"lines\":[{},{},{}],\"corner\":[{},{}],", n.vertex, n.lines[0], n.lines[1], n.lines[2], n.corner[0],
                 n.corner[1]);
      place(n.vertex, n.lines);
    });
    fmt::print(out, ",\n");
    arcs(s.exact->arcs);
    fmt::print(out, ",\n\"vertices\":{},\"faces\":{}}}", s.exact->vertices, s.exact->faces);
  }
  fmt::print(out, "}}\n");
}

/// What a document says.
struct planar_file {
  planar_provenance by;
  std::vector<moving_line<integer>> lines;
  plane::boundary boundary;
  planar_skeletons skeletons;
};

/// Reads what write_planar_skeleton writes. Throws input_error(not_skeleton) naming the element where the text has another shape; whether the
/// numbers make sense is not looked at (verify does). Linear in the text.
class planar_reader : json_reader {
 public:
  using json_reader::json_reader;

  planar_file read(std::istream& in) const {
    const json doc = parse(in, planar_format);
    planar_file result;
    result.by = {text(doc, "kernel", ""), truth(doc, "outside", "")};
    for_each(doc, "lines", [&](const json& l, const std::string& at) {
      const auto n = exact_numbers(member(l, "n", at), at + ".n");
      if (n.size() != 2) wrong(at + ".n", "needs two numbers");
      result.lines.push_back(
          {{n[0], n[1]}, exact_number_in(member(l, "d", at), at + ".d"), exact_number_in(member(l, "weight", at), at + ".weight")});
    });
    for_each(doc, "outline", [&](const json& v, const std::string& at) {
      result.boundary.next.push_back(whole(v, "next", at));
      result.boundary.line.push_back(whole(v, "line", at));
    });
    plane::skeleton& raw = result.skeletons.raw;
    for_each(doc, "nodes", [&](const json& n, const std::string& at) {
      plane::skeleton::node node{-1, {-1, -1, -1}, plane::event_class::edge};
      if (n.is_object() && n.contains("vertex")) {
        const auto lines = tuple<2>(n, "lines", at);
        node.vertex = whole(n, "vertex", at);
        node.lines = {lines[0], lines[1], -1};
      } else {
        node.lines = tuple<3>(n, "lines", at);
        const auto found = std::find(planar_event_names.begin(), planar_event_names.end(), text(n, "event", at));
        if (found == planar_event_names.end()) wrong(at + ".event", "is no class of events");
        node.event = static_cast<plane::event_class>(found - planar_event_names.begin());
        node.zero_length = truth(n, "late", at);
      }
      raw.nodes.push_back(node);
    });
    read_arcs(doc, raw.arcs, "");
    raw.faces = list(doc, "faces", "");
    for_each(doc, "passes", [&](const json& p, const std::string& at) { raw.interior_nodes.push_back({whole(p, "arc", at), whole(p, "node", at)}); });
    const json& events = member(doc, "events", "");
    raw.events = {whole(events, "edge", "events"), whole(events, "split", "events")};
    if (doc.contains("contracted")) {
      const json& exact = doc["contracted"];
      auto& s = result.skeletons.exact.emplace();
      for_each(
          exact, "nodes",
          [&](const json& n, const std::string& at) {
            s.nodes.push_back({whole(n, "vertex", at), tuple<3>(n, "lines", at), tuple<2>(n, "corner", at)});
          },
          "contracted");
      read_arcs(exact, s.arcs, "contracted");
      s.vertices = whole(exact, "vertices", "contracted");
      s.faces = whole(exact, "faces", "contracted");
    }
    return result;
  }

 private:
  bool truth(const json& of, const char* key, const std::string& at) const {
    const json& value = member(of, key, at);
    if (!value.is_boolean()) wrong(at.empty() ? key : at + "." + key, "is neither true nor false");
    return value.get<bool>();
  }
  template <class Arcs>
  void read_arcs(const json& of, Arcs& arcs, const std::string& in) const {
    for_each(
        of, "arcs",
        [&](const json& a, const std::string& at) {
          arcs.push_back({whole(a, "source", at), whole(a, "target", at), tuple<2>(a, "faces", at)});
        },
        in);
  }
};

}  // namespace osteon::app
