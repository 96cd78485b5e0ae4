// SPDX-License-Identifier: MIT

/// \file
/// Fold a sheet of paper flat so that one straight cut gives a shape (Demaine, Demaine, Lubiw 1998): the creases, as SVG.
///   fold_and_cut FILE
/// FILE is a polygon without holes; the sheet is a square around it. Creases are the skeletons inside and outside of the shape, drawn red, and
/// perpendiculars from their nodes to the edges beside them, blue, which go on as mirror images beyond every skeleton arc until they leave the sheet.
/// The sheet's border is held: only the shape's edges move, and they move until they have covered the sheet. Perpendiculars may go on without end and
/// fill regions densely; each is followed over 100 creases at most. They are computed with doubles: this is a drawing.

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "osteon/kernel/anchors.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/motion.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/planar_locate.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/planar/check.hpp"
#include "osteon/planar/contract.hpp"
#include "osteon/planar/propagate.hpp"
#include "osteon/planar/read.hpp"

namespace {

using namespace osteon;
using point = std::array<double, 2>;

constexpr int sheet = -1;  // the face of its border

/// A straight piece of paper's pattern between two faces, which are edges of the shape; `inside` of the shape or not.
struct crease {
  point from;
  point to;
  std::array<int, 2> faces;
  bool inside;
};

struct pattern {
  std::vector<point> shape;
  std::array<double, 4> paper{};  // left, bottom, width, height
  std::vector<crease> arcs;
  std::vector<crease> perpendiculars;
};

/// Adds the arcs of a polygon's skeleton; edge_of gives the shape's edge for one of the polygon's.
template <class EdgeOf>
void add_skeleton(pattern& all, const planar::polygon<integer>& p, bool inside, EdgeOf edge_of) {
  const std::span<const moving_line<integer>> lines(p.lines);
  const perturbed kernel(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)));
  const auto raw = planar::propagation(kernel, p.outline, planar::motion(lines, p.points)).run();
  const auto skeleton = planar::contract(kernel.base(), p.outline.line, raw);
  const planar::unit_lines units(lines, p.points);
  const planar::fast_locator locator(p, units);
  const auto place = [&](int n) {
    const auto& node = skeleton.nodes[n];
    const auto at = node.vertex >= 0 ? locator.vertex(node.vertex) : locator.meeting(node.lines);
    return point{at.x, at.y};
  };
  for (const auto& a : skeleton.arcs) {
    const crease c = {place(a.source), place(a.target), {edge_of(a.faces[0]), edge_of(a.faces[1])}, inside};
    if (c.faces[0] != sheet && c.faces[1] != sheet) all.arcs.push_back(c);  // others are the sheet's border
  }
}

pattern skeletons(const planar::polygon<integer>& p) {
  if (p.holes > 0 || p.parts != 1) throw input_error(input_fault::not_polygon, 0, "the shape has holes or several parts", "give one ring");
  pattern all;
  const planar::unit_lines units(p.lines, p.points);
  const planar::fast_locator locator(p, units);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const auto at = locator.vertex(static_cast<int>(i));
    all.shape.push_back({at.x, at.y});
    low = std::min({low, at.x, at.y});
    high = std::max({high, at.x, at.y});
  }
  const double margin = (high - low) / 2;
  low -= margin;
  high += margin;
  all.paper = {low, low, high - low, high - low};
  add_skeleton(all, p, true, [](int e) { return e; });
  const std::vector<std::vector<point>> rings = {{{low, low}, {high, low}, {high, high}, {low, high}}, all.shape};
  const auto outside = planar::make_polygon(planar::make_rings<integer>(rings, {{0, 0, 0, 0}, std::vector<double>(all.shape.size(), 1)}));
  // Around a hole edges run the other way, so each ends where that of the shape starts.
  add_skeleton(all, outside, false, [&](int e) {
    const int start = outside.input_points[outside.outline.next[e]];
    return start < 4 ? sheet : start - 4;
  });
  return all;
}

double cross(const point& a, const point& b) { return a[0] * b[1] - a[1] * b[0]; }
point minus(const point& a, const point& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Where a ray meets a segment: multiples of d, or infinity. What starts on the segment does not meet it.
double meets(const point& p, const point& d, const point& from, const point& to, double least) {
  const point along = minus(to, from);
  const double det = cross(d, along);
  const double t = cross(minus(from, p), along) / det;
  const double u = cross(minus(from, p), d) / det;
  return det != 0 && t > least && u >= -1e-12 && u <= 1 + 1e-12 ? t : std::numeric_limits<double>::infinity();
}

/// From a node across a face to the edge of the shape beneath it, and on.
void follow(pattern& all, point p, int face, bool inside) {
  const std::size_t n = all.shape.size();
  const auto edge = [&](int e) { return std::pair(all.shape[static_cast<std::size_t>(e)], all.shape[(static_cast<std::size_t>(e) + 1) % n]); };
  const auto [a, b] = edge(face);
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  point d = {(b[1] - a[1]) / length, (a[0] - b[0]) / length};  // out of the shape
  if (!inside) d = {-d[0], -d[1]};
  const double least = all.paper[2] * 1e-9;
  for (int steps = 0; steps < 100; ++steps) {
    double first = std::numeric_limits<double>::infinity();
    const crease* through = nullptr;
    for (const crease& c : all.arcs)
      if (c.inside == inside && (c.faces[0] == face || c.faces[1] == face))
        if (const double t = meets(p, d, c.from, c.to, least); t < first) first = t, through = &c;
    const auto [from, to] = edge(face);
    const double home = meets(p, d, from, to, least);
    double border = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (d[axis] != 0) border = std::min(border, (all.paper[axis] + (d[axis] > 0 ? all.paper[2] : 0) - p[axis]) / d[axis]);
    const double t = std::min({first, home, border});
    const point q = {p[0] + t * d[0], p[1] + t * d[1]};
    all.perpendiculars.push_back({p, q, {face, face}, inside});
    p = q;
    if (t == border) return;
    if (t == home) {
      inside = !inside;
      continue;
    }
    for (const point& end : {through->from, through->to})  // from there the node's own ones go on
      if (std::hypot(end[0] - p[0], end[1] - p[1]) < least) return;
    const point along = minus(through->to, through->from);
    const double twice = 2 * (d[0] * along[0] + d[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    d = {twice * along[0] - d[0], twice * along[1] - d[1]};
    face = through->faces[through->faces[0] == face ? 1 : 0];
  }
}

void draw(const pattern& all) {
  const auto line = [&](const point& a, const point& b, const char* kind) {
    std::printf("<line class=\"%s\" x1=\"%.10g\" y1=\"%.10g\" x2=\"%.10g\" y2=\"%.10g\"/>\n", kind, a[0], -a[1], b[0], -b[1]);
  };
  const double pen = all.paper[2] / 400;
  std::printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%.10g %.10g %.10g %.10g\" width=\"800\">\n", all.paper[0],
              -all.paper[1] - all.paper[3], all.paper[2], all.paper[3]);
  std::printf(
      "<style>line{stroke-width:%.6g;stroke-linecap:round} .cut{stroke:black;stroke-width:%.6g} .arc{stroke:#c22} "
      ".perpendicular{stroke:#25c}</style>\n",
      pen, 2 * pen);
  std::printf("<rect x=\"%.10g\" y=\"%.10g\" width=\"%.10g\" height=\"%.10g\" fill=\"white\" stroke=\"black\" stroke-width=\"%.6g\"/>\n",
              all.paper[0], -all.paper[1] - all.paper[3], all.paper[2], all.paper[3], pen);
  for (const crease& c : all.perpendiculars) line(c.from, c.to, "perpendicular");
  for (const crease& c : all.arcs) line(c.from, c.to, "arc");
  for (std::size_t i = 0; i < all.shape.size(); ++i) line(all.shape[i], all.shape[(i + 1) % all.shape.size()], "cut");
  std::printf("</svg>\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fold_and_cut FILE\n");
    return 2;
  }
  try {
    std::ifstream in(argv[1], std::ios::binary);
    pattern all = skeletons(planar::make_polygon(planar::read_polygon<integer>(in, argv[1])));
    // Nodes: the ends of arcs that are neither corners of the shape nor on the border, once for each face around them.
    std::vector<std::pair<point, crease>> starts;
    const double least = all.paper[2] * 1e-9;
    const auto near = [least](const point& a, const point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]) < least; };
    for (const crease& c : all.arcs)
      for (const point& end : {c.from, c.to})
        for (const int face : c.faces) {
          bool skip = false;
          for (const point& corner : all.shape) skip = skip || near(end, corner);
          for (std::size_t axis = 0; axis < 2; ++axis)
            skip = skip || end[axis] - all.paper[axis] < least || all.paper[axis] + all.paper[2] - end[axis] < least;
          for (const auto& [p, other] : starts) skip = skip || (near(p, end) && other.faces[0] == face && other.inside == c.inside);
          if (!skip) starts.push_back({end, {end, end, {face, face}, c.inside}});
        }
    for (const auto& [p, c] : starts) follow(all, p, c.faces[0], c.inside);
    draw(all);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fold_and_cut: %s\n", e.what());
    return dynamic_cast<const input_error*>(&e) != nullptr ? 3 : 5;
  }
}
