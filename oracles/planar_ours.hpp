// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library's planar skeletons in the form that the oracles are compared in, and what must hold for every skeleton. Places are found here, in
/// numbers of 300 digits, and not by the library.

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"
#include "planar_node.hpp"

namespace osteon::oracles {

/// A polygon and its skeletons by the library's default kernel.
struct planar_skeletons {
  plane::polygon<integer> polygon;
  plane::skeleton raw;
  plane::contracted_skeleton exact;
};

using planar_rings = plane::rings<integer>;

inline std::span<const moving_line<integer>> lines_in(const plane::polygon<integer>& p) { return p.lines; }

inline auto planar_default_kernel(const plane::polygon<integer>& p) {
  return perturbed(filtered(lines_in(p), make_sqrt_kernel(lines_in(p)), anchors_of(p)));
}

/// The raw skeleton under any kernel.
template <kernel<2> K>
plane::skeleton raw_skeleton(const K& k, const plane::polygon<integer>& p) {
  const plane::vertex_enclosures motion(lines_in(p), p.points);
  return plane::propagation(k, p.boundary, motion).run();
}

inline planar_skeletons skeletons_of(planar_rings rings) {
  planar_skeletons result{plane::make_polygon(std::move(rings)), {}, {}};
  const auto k = planar_default_kernel(result.polygon);
  result.raw = raw_skeleton(k, result.polygon);
  result.exact = plane::contract(k.base(), result.polygon.boundary.line, result.raw);
  return result;
}

inline planar_skeletons skeletons_of(const planar_input& input) { return skeletons_of(plane::make_rings<integer>(input.rings, input.weights)); }

/// Generated polygons as the oracles take them: exact up to 2^53.
inline planar_input doubles_of(const std::vector<std::vector<std::array<long, 2>>>& region) {
  planar_input result;
  for (const auto& points : region) {
    auto& ring = result.rings.emplace_back();
    for (const auto& p : points) ring.push_back({static_cast<double>(p[0]), static_cast<double>(p[1])});
  }
  return result;
}

/// By node of the contracted skeleton: the edges of the polygon whose faces meet there, ascending, those of a face by its representative.
inline std::vector<std::vector<int>> faces_by_node(const plane::contracted_skeleton& s) {
  std::vector<std::vector<int>> result(s.nodes.size());
  for (const auto& a : s.arcs)
    for (const int n : {a.source, a.target})
      if (n >= 0) result[static_cast<std::size_t>(n)].insert(result[static_cast<std::size_t>(n)].end(), a.faces.begin(), a.faces.end());
  for (auto& faces : result) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return result;
}

/// Places and times of vertices and meetings, in the polygon's integers and the kernel's time: D / S and Cramer's rule.
class planar_places {
 public:
  using number = boost::multiprecision::number<boost::multiprecision::gmp_float<300>, boost::multiprecision::et_off>;
  struct place {
    number x, y;
  };

  explicit planar_places(const plane::polygon<integer>& p) : polygon_(p) {
    for (const auto& l : p.lines) speeds_.push_back(number(l.weight) * sqrt(number(l.n[0] * l.n[0] + l.n[1] * l.n[1])));
  }

  const moving_line<integer>& line(int i) const { return polygon_.lines[static_cast<std::size_t>(i)]; }
  integer det(int a, int b) const { return line(a).n[0] * line(b).n[1] - line(a).n[1] * line(b).n[0]; }

  number time(const triple& q) const {
    const auto [a, b, c] = q;
    const integer d = det(b, c) * line(a).d + det(c, a) * line(b).d + det(a, b) * line(c).d;
    return number(d) / number(number(det(b, c)) * speed(a) + number(det(c, a)) * speed(b) + number(det(a, b)) * speed(c));
  }
  place corner(int a, int b, const number& t) const {
    const number u = number(line(a).d) - t * speed(a);
    const number v = number(line(b).d) - t * speed(b);
    const number d(det(a, b));
    return {(u * number(line(b).n[1]) - v * number(line(a).n[1])) / d, (v * number(line(a).n[0]) - u * number(line(b).n[0])) / d};
  }

 private:
  const number& speed(int l) const { return speeds_[static_cast<std::size_t>(l)]; }

  const plane::polygon<integer>& polygon_;
  std::vector<number> speeds_;
};

/// The inner nodes of the contracted skeleton. Requires rings that run as they should: outer ones counter-clockwise.
inline std::vector<planar_node> nodes_of(const planar_skeletons& s) {
  using number = planar_places::number;
  const auto& p = s.polygon;
  const planar_places places(p);
  const auto scale = [](int ten, int two) { return number(pow(number(10), ten) * pow(number(2), two)); };
  const number unit = scale(p.ten, p.two);
  const number time_unit = unit / scale(p.weight_ten, p.weight_two);
  const auto faces = faces_by_node(s.exact);
  std::vector<planar_node> result;
  for (std::size_t i = 0; i < s.exact.nodes.size(); ++i) {
    const auto& node = s.exact.nodes[i];
    if (node.vertex >= 0) continue;
    const number time = places.time(node.lines);
    const auto at = places.corner(node.corner[0], node.corner[1], time);
    auto& fresh = result.emplace_back();
    fresh.x = number((at.x + number(p.shift[0])) * unit).convert_to<double>();
    fresh.y = number((at.y + number(p.shift[1])) * unit).convert_to<double>();
    fresh.time = number(time * time_unit).convert_to<double>();
    for (const int face : faces[i]) fresh.edges.push_back(p.input_points[static_cast<std::size_t>(face)]);
    std::sort(fresh.edges.begin(), fresh.edges.end());
  }
  sort_by_time(result);
  return result;
}

/// Whether two reflex vertices of the wavefront meet in one place at one moment. There the straight skeleton is not continuous: that of a perturbed
/// polygon is not the usual one in the limit. Quadratic.
inline bool reflex_vertices_meet(const planar_skeletons& s) {
  using number = planar_places::number;
  const planar_places places(s.polygon);
  number size = 1;
  for (const auto& p : s.polygon.points)
    for (const integer& x : p) size = std::max(size, number(abs(x)));
  const number tiny = size * number("1e-60");
  const auto when = [&](int node) {
    const auto& n = s.raw.nodes[static_cast<std::size_t>(node)];
    return n.vertex >= 0 ? number(0) : places.time(n.lines);
  };
  struct track {
    std::array<int, 2> lines;
    number first, last;
  };
  std::vector<track> tracks;
  for (const auto& a : s.raw.arcs) {
    const auto line = [&](int face) { return s.polygon.boundary.line[static_cast<std::size_t>(face)]; };
    if (a.target >= 0 && places.det(line(a.faces[0]), line(a.faces[1])) < 0)
      tracks.push_back({{line(a.faces[0]), line(a.faces[1])}, when(a.source), when(a.target)});
  }
  for (const auto& n : s.raw.nodes) {
    if (n.vertex >= 0) continue;
    const number t = places.time(n.lines);
    int a = n.lines[0];
    int b = n.lines[1];
    if (places.det(a, b) == 0) b = n.lines[2];
    if (places.det(a, b) == 0) a = n.lines[1];
    const auto at = places.corner(a, b, t);
    int arriving = 0;
    for (const auto& r : tracks) {
      if (!(r.first < t - tiny) || r.last < t - tiny) continue;
      const auto p = places.corner(r.lines[0], r.lines[1], t);
      arriving += abs(p.x - at.x) <= tiny && abs(p.y - at.y) <= tiny ? 1 : 0;
    }
    if (arriving > 1) return true;
  }
  return false;
}

/// What is wrong with a contracted skeleton as a decomposition of the polygon's interior; empty: nothing. At every inner node at least three arcs
/// meet; arcs end, and not where they begin; every face has a border without ends; the skeleton, the boundary and the faces satisfy Euler's formula.
inline std::string fault_of(const planar_skeletons& s) {
  const auto& o = s.polygon.boundary;
  const int vertices = static_cast<int>(o.next.size());
  // Places: vertices of the polygon, then inner nodes; one where sheets without a common face touch counts for each of them.
  int inner = 0;
  std::vector<std::map<int, int>> place_at(s.exact.nodes.size());  // by node and face
  const auto unite = [&place_at](int node, const std::array<int, 2>& faces) {
    if (node < 0) return;
    auto& at = place_at[static_cast<std::size_t>(node)];
    const int from = at.try_emplace(faces[0], faces[0]).first->second;
    const int to = at.try_emplace(faces[1], faces[1]).first->second;
    for (auto& [face, root] : at)
      if (root == from) root = to;
  };
  for (const auto& a : s.exact.arcs) {
    unite(a.source, a.faces);
    unite(a.target, a.faces);
  }
  for (std::size_t i = 0; i < place_at.size(); ++i) {
    std::map<int, int> number;
    for (auto& [face, root] : place_at[i]) {
      const auto [found, fresh] = number.try_emplace(root, vertices + inner);
      if (s.exact.nodes[i].vertex >= 0)
        root = s.exact.nodes[i].vertex;
      else
        root = found->second, inner += fresh ? 1 : 0;
    }
  }
  const auto place_of = [&place_at](int node, int face) { return place_at[static_cast<std::size_t>(node)].at(face); };
  std::vector<int> degree(static_cast<std::size_t>(vertices + inner));
  std::vector<int> root(degree.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int i) {
    while (root[static_cast<std::size_t>(i)] != i)
      i = root[static_cast<std::size_t>(i)] = root[static_cast<std::size_t>(root[static_cast<std::size_t>(i)])];
    return i;
  };
  std::map<int, std::vector<std::array<int, 2>>> borders;  // of faces: arcs and edges by their ends
  std::set<int> with_arcs;
  for (const auto& a : s.exact.arcs) {
    if (a.source < 0 || a.target < 0) return "an arc does not end";
    if (a.source == a.target) return "an arc ends where it begins";
    if (a.faces[0] == a.faces[1]) return "an arc has the same face on both sides";
    const int from = place_of(a.source, a.faces[0]);
    const int to = place_of(a.target, a.faces[0]);
    for (const int at : {from, to}) ++degree[static_cast<std::size_t>(at)];
    for (const int f : a.faces) borders[f].push_back({from, to}), with_arcs.insert(f);
    root[static_cast<std::size_t>(find(from))] = find(to);
  }
  // An edge that its neighbour in the same direction overtakes at time zero has no face; that of the neighbour lies along it.
  std::vector<int> owner(static_cast<std::size_t>(vertices), -1);  // face along an edge
  for (int e = 0; e < vertices; ++e) {
    root[static_cast<std::size_t>(find(e))] = find(o.next[static_cast<std::size_t>(e)]);
    const int face = s.raw.faces[static_cast<std::size_t>(e)];
    if (with_arcs.contains(face)) owner[static_cast<std::size_t>(e)] = face;
  }
  for (bool more = true; more;) {
    more = false;
    for (int e = 0; e < vertices; ++e) {
      const auto to = static_cast<std::size_t>(o.next[static_cast<std::size_t>(e)]);
      if (degree[to] > 0) continue;
      int& a = owner[static_cast<std::size_t>(e)];
      int& b = owner[to];
      if (a >= 0 && b >= 0 && a != b) return "no arc separates the faces of edges " + std::to_string(e) + " and " + std::to_string(to);
      if ((a < 0) == (b < 0)) continue;
      (a < 0 ? a : b) = std::max(a, b);
      more = true;
    }
  }
  for (int e = 0; e < vertices; ++e) {
    if (owner[static_cast<std::size_t>(e)] < 0) return "edge " + std::to_string(e) + " has no face";
    borders[owner[static_cast<std::size_t>(e)]].push_back({e, o.next[static_cast<std::size_t>(e)]});
  }
  for (int i = vertices; i < vertices + inner; ++i)
    if (degree[static_cast<std::size_t>(i)] < 3) return "a node of degree " + std::to_string(degree[static_cast<std::size_t>(i)]);
  if (static_cast<int>(with_arcs.size()) != s.exact.faces) return "faces are miscounted";
  // Edges on one line that touch in one place share a face of several discs. With weights a face may lie around others, or fall apart where it is
  // a line for a moment: then Euler's formula leaves open how many faces its border bounds.
  int discs = 0;
  int apart = 0;
  for (const auto& [face, border] : borders) {
    std::map<int, int> ends;
    std::map<int, int> up;
    const auto top = [&up](int i) {
      while (up.at(i) != i) i = up.at(i);
      return i;
    };
    for (const auto& [from, to] : border) {
      for (const int at : {from, to}) ++ends[at], up.try_emplace(at, at);
      const int a = top(from);
      up[a] = top(to);
    }
    for (const auto& [at, times] : ends)
      if (times % 2 != 0) return "the border of face " + std::to_string(face) + " has an end";
    discs += static_cast<int>(border.size()) - static_cast<int>(ends.size()) + 1;
    --apart;
    for (const auto& [at, above] : up) apart += at == above ? 1 : 0;
  }
  int pieces = 0;
  for (std::size_t i = 0; i < root.size(); ++i) pieces += find(static_cast<int>(i)) == static_cast<int>(i) ? 1 : 0;
  const int arcs = static_cast<int>(s.exact.arcs.size());
  const int missing = pieces - (inner - arcs + discs + s.polygon.holes);
  if (missing < 0 || missing > apart)
    return std::to_string(inner) + " inner nodes, " + std::to_string(arcs) + " arcs, " + std::to_string(discs) + " faces, " +
           std::to_string(s.polygon.holes) + " holes, " + std::to_string(pieces) + " pieces do not fit together";
  return "";
}

}  // namespace osteon::oracles
