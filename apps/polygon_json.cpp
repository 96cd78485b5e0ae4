// SPDX-License-Identifier: MIT

/// \file
/// The JSON of polygons' skeletons.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "documents.hpp"
#include "json_reader.hpp"

namespace osteon::app {
namespace {

std::string number(double x) { return json(x).dump(); }

/// One element a line, so that a million vertices need no more memory than the document has.
template <class Element>
void write_list(std::ostream& out, const char* name, std::size_t size, Element element) {
  fmt::print(out, "\"{}\":[", name);
  for (std::size_t i = 0; i < size; ++i) {
    fmt::print(out, "{}\n", i == 0 ? "" : ",");
    element(i);
  }
  fmt::print(out, "]");
}

void write_arcs(std::ostream& out, const std::vector<polygon_document::arc>& arcs) {
  write_list(out, "arcs", arcs.size(), [&](std::size_t i) {
    fmt::print(out, "{{\"source\":{},\"target\":{},\"faces\":[{},{}]}}", arcs[i].source, arcs[i].target, arcs[i].faces[0], arcs[i].faces[1]);
  });
}

/// The end of a node.
template <class Node>
void write_place(std::ostream& out, const Node& n) {
  fmt::print(out, "\"time\":{},\"point\":[{},{}]}}", number(n.time), number(n.point[0]), number(n.point[1]));
}

void write_node(std::ostream& out, const polygon_document::node& n) {
  if (n.vertex >= 0)
    fmt::print(out, "{{\"vertex\":{},\"lines\":[{},{}],", n.vertex, n.lines[0], n.lines[1]);
  else
    fmt::print(out, "{{\"event\":\"{}\",\"late\":{},\"lines\":[{},{},{}],", name_of(n.event), n.zero_length, n.lines[0], n.lines[1], n.lines[2]);
  write_place(out, n);
}

void write_contracted(std::ostream& out, const polygon_document::exact_skeleton& s) {
  fmt::print(out, ",\n\"contracted\":{{");
  write_list(out, "nodes", s.nodes.size(), [&](std::size_t i) {
    const auto& n = s.nodes[i];
    fmt::print(out, "{{\"vertex\":{},\"lines\":[{},{},{}],\"corner\":[{},{}],", n.vertex, n.lines[0], n.lines[1], n.lines[2], n.corner[0],
               n.corner[1]);
    write_place(out, n);
  });
  fmt::print(out, ",\n");
  write_arcs(out, s.arcs);
  fmt::print(out, ",\n\"vertices\":{},\"faces\":{}}}", s.vertices, s.faces);
}

class polygon_reader : json_reader {
 public:
  using json_reader::json_reader;

  polygon_document read(std::istream& in) const {
    const json doc = parse(in, planar_format);
    polygon_document result;
    result.kernel = choice(doc, "kernel", kernels);
    result.region = truth(doc, "outside", "") ? region::exterior : region::interior;
    for_each(doc, "lines", [&](const json& l, const std::string& at) { result.lines.push_back(plane<2>(l, at)); });
    for_each(doc, "outline", [&](const json& v, const std::string& at) {
      result.outline.push_back({-1, whole(v, "next", at), whole(v, "line", at)});
    });
    for_each(doc, "nodes", [&](const json& n, const std::string& at) { result.nodes.push_back(node(n, at)); });
    result.arcs = arcs(doc, "");
    result.faces = list(doc, "faces", "");
    for_each(doc, "passes", [&](const json& p, const std::string& at) {
      result.interior_nodes.push_back({whole(p, "arc", at), whole(p, "node", at)});
    });
    const json& events = member(doc, "events", "");
    result.events = {whole(events, "edge", "events"), whole(events, "split", "events")};
    if (doc.contains("contracted")) result.contracted = contracted(doc["contracted"]);
    return result;
  }

 private:
  polygon_document::node node(const json& n, const std::string& at) const {
    polygon_document::node result{-1, event_kind::vertex, false, {-1, -1, -1}};
    if (n.is_object() && n.contains("vertex")) {
      const auto lines = tuple<2>(n, "lines", at);
      result.vertex = whole(n, "vertex", at);
      result.lines = {lines[0], lines[1], -1};
      return result;
    }
    result.lines = tuple<3>(n, "lines", at);
    const auto event = event_of_name(text(n, "event", at));
    if (event != event_kind::edge && event != event_kind::split) wrong(at + ".event", "is no class of events");
    result.event = *event;
    result.zero_length = truth(n, "late", at);
    return result;
  }

  std::vector<polygon_document::arc> arcs(const json& of, const std::string& in) const {
    std::vector<polygon_document::arc> result;
    for_each(
        of, "arcs",
        [&](const json& a, const std::string& at) {
          result.push_back({whole(a, "source", at), whole(a, "target", at), tuple<2>(a, "faces", at)});
        },
        in);
    return result;
  }

  polygon_document::exact_skeleton contracted(const json& doc) const {
    const std::string in = "contracted";
    polygon_document::exact_skeleton s;
    for_each(
        doc, "nodes",
        [&](const json& n, const std::string& at) {
          s.nodes.push_back({whole(n, "vertex", at), tuple<3>(n, "lines", at), tuple<2>(n, "corner", at)});
        },
        in);
    s.arcs = arcs(doc, in);
    s.vertices = whole(doc, "vertices", in);
    s.faces = whole(doc, "faces", in);
    return s;
  }
};

}  // namespace

void write_document(std::ostream& out, const polygon_document& d) {
  fmt::print(out, "{{\"format\":\"{}\",\"kernel\":\"{}\",\"outside\":{},\n", planar_format, name_of(d.kernel), d.region == region::exterior);
  fmt::print(out, "\"scale\":{{\"ten\":{},\"two\":{},\"shift\":[\"{}\",\"{}\"],\"weight_ten\":{},\"weight_two\":{}}},\n", d.scale.ten, d.scale.two,
             d.scale.shift[0], d.scale.shift[1], d.scale.weight_ten, d.scale.weight_two);
  write_list(out, "lines", d.lines.size(), [&](std::size_t i) {
    const auto& l = d.lines[i];
    fmt::print(out, "{{\"n\":[\"{}\",\"{}\"],\"d\":\"{}\",\"weight\":\"{}\"}}", l.n[0], l.n[1], l.d, l.weight);
  });
  fmt::print(out, ",\n");
  write_list(out, "outline", d.outline.size(), [&](std::size_t i) {
    fmt::print(out, "{{\"point\":{},\"next\":{},\"line\":{}}}", d.outline[i].point + 1, d.outline[i].next, d.outline[i].line);
  });
  fmt::print(out, ",\n");
  write_list(out, "nodes", d.nodes.size(), [&](std::size_t i) { write_node(out, d.nodes[i]); });
  fmt::print(out, ",\n");
  write_arcs(out, d.arcs);
  fmt::print(out, ",\n");
  write_list(out, "faces", d.faces.size(), [&](std::size_t i) { fmt::print(out, "{}", d.faces[i]); });
  fmt::print(out, ",\n");
  write_list(out, "passes", d.interior_nodes.size(),
             [&](std::size_t i) { fmt::print(out, "{{\"arc\":{},\"node\":{}}}", d.interior_nodes[i].arc, d.interior_nodes[i].node); });
  fmt::print(out, ",\n\"events\":{{\"edge\":{},\"split\":{}}}", d.events[0], d.events[1]);
  if (d.contracted) write_contracted(out, *d.contracted);
  fmt::print(out, "}}\n");
}

polygon_document read_polygon_document(std::istream& in, const std::string& name) { return polygon_reader(name).read(in); }

}  // namespace osteon::app
