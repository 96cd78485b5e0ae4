// SPDX-License-Identifier: MIT

/// \file
/// A sheet of paper folded flat so that one straight cut leaves the polygon: the creases after Demaine, Demaine, Lubiw (1998).
///   fold_and_cut FILE [MARGIN]
/// FILE is a polygon, with holes if you like; MARGIN is the paper around it, by default a quarter of its greater extent. The result is SVG, in the
/// coordinates of the file: solid the polygon's sides, which the cut goes along, dashed red the straight skeleton, blue the perpendiculars.
///
/// The creases are the skeleton inside and outside, of the polygon alone, as if the paper had no border: nobody cuts along that, so it must not
/// move, nor stop anything, as even an edge that is held would. What lies beyond the paper is cut off. From each node of the skeleton go
/// perpendiculars to the edges whose faces they enter there, mirrored at every arc, until they leave the sheet or meet a node. There are polygons
/// where they never do and lie densely; so each one is given up after a number of arcs, which standard error then tells, as it does where one meets
/// a node from behind: there the polygon is so special that two perpendiculars would have to lie on each other. The skeleton is exact, the
/// perpendiculars are doubles: this is a drawing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/locate.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"

namespace {

using namespace osteon;

struct vec {
  double x, y;
  friend vec operator+(vec a, vec b) { return {a.x + b.x, a.y + b.y}; }
  friend vec operator-(vec a, vec b) { return {a.x - b.x, a.y - b.y}; }
  friend vec operator*(double s, vec a) { return {s * a.x, s * a.y}; }
};
double dot(vec a, vec b) { return a.x * b.x + a.y * b.y; }
double cross(vec a, vec b) { return a.x * b.y - a.y * b.x; }
double length(vec a) { return std::hypot(a.x, a.y); }
vec unit(vec a) { return 1 / length(a) * a; }

/// Walls cut the plane into faces, one on each side of each edge: the arcs of both skeletons, which are creases, and the edges themselves.
class fold {
 public:
  /// A polygon and what is outside of it.
  fold(const plane::polygon<integer>& p, const plane::polygon<integer>& rest, double margin) : vertices_(static_cast<int>(p.points.size())) {
    for (const auto& l : p.lines)
      if (l.weight != p.lines[0].weight)
        throw input_error(input_fault::bad_weight, 0, "paper folds at bisectors only, so no edge may have a weight of its own",
                          "leave the weights out");
    if (rest.points != p.points)
      throw unsupported_error("the polygon touches itself, so its corners outside are others than inside; hint: move that point a little");
    nodes_.resize(vertices_);
    const auto inner = add_skeleton(p, false);
    low_ = high_ = nodes_[0].at;
    for (int v = 0; v < vertices_; ++v) {
      low_ = {std::min(low_.x, nodes_[v].at.x), std::min(low_.y, nodes_[v].at.y)};
      high_ = {std::max(high_.x, nodes_[v].at.x), std::max(high_.y, nodes_[v].at.y)};
    }
    size_ = std::max(high_.x - low_.x, high_.y - low_.y);
    const double m = margin > 0 ? margin : size_ / 4;
    low_ = low_ - vec{m, m};
    high_ = high_ + vec{m, m};
    size_ += 2 * m;
    const auto outer = add_skeleton(rest, true);
    for (int v = 0; v < vertices_; ++v) {
      const int w = p.boundary.next[v];
      add_wall({v, w, nodes_[v].at, nodes_[w].at, {inner[v], vertices_ + outer[w]}, false});
    }
  }

  /// From each node of the skeleton on the paper. The others' do not matter: creases that only pass can be left out.
  void add_perpendiculars() {
    for (int n = vertices_; n < static_cast<int>(nodes_.size()); ++n)
      if (is_on_paper(nodes_[n].at)) find_starts(n);
    for (auto& [s, taken] : starts_)
      if (!taken) follow(s);
  }

  void write() const {
    std::printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" viewBox=\"%.15g %.15g %.15g %.15g\">\n", low_.x, -high_.y, high_.x - low_.x,
                high_.y - low_.y);
    std::printf(
        "<style>* { fill: none; stroke-width: %.3g } .paper { fill: white } .side { stroke: black; stroke-width: %.3g; stroke-linecap: round }\n",
        size_ / 400, size_ / 150);
    std::printf(".arc { stroke: #c03020; stroke-dasharray: %.3g } .perpendicular { stroke: #3060c0; stroke-width: %.3g }</style>\n", size_ / 80,
                size_ / 600);
    std::printf("<g transform=\"scale(1,-1)\">\n<rect class=\"paper\" x=\"%.15g\" y=\"%.15g\" width=\"%.15g\" height=\"%.15g\"/>\n", low_.x, low_.y,
                high_.x - low_.x, high_.y - low_.y);
    int arcs = 0;
    for (const bool crease : {true, false})
      for (const wall& w : walls_) {
        vec a = w.a;
        vec b = w.b;
        if (w.crease != crease || !clip(a, b)) continue;
        write_line(crease ? "arc" : "side", {a, b});
        if (crease) ++arcs;
      }
    for (const auto& p : perpendiculars_) write_line("perpendicular", p);
    std::printf("</g>\n</svg>\n");
    std::fprintf(stderr, "%d arcs, %zu perpendiculars\n", arcs, perpendiculars_.size());
    if (endless_ > 0) std::fprintf(stderr, "%d perpendiculars were given up after %d arcs\n", endless_, most_arcs);
    if (behind_ > 0) std::fprintf(stderr, "%d perpendiculars meet a node from behind and end there; move a vertex a little to avoid that\n", behind_);
  }

 private:
  static constexpr int most_arcs = 100;  // that a perpendicular crosses

  struct node {
    vec at{};
    std::vector<int> walls;
  };
  struct wall {
    int from;
    int to;  ///< -1: never ends; then b is far away
    vec a, b;
    std::array<int, 2> faces;
    bool crease;
  };
  struct face {
    vec down{};  ///< the direction towards its edge
    std::vector<int> walls;
  };

  struct start {
    int node;
    int face;
    bool down;  ///< to the edge, or away from it
    friend auto operator<=>(const start&, const start&) = default;
  };

  void add_wall(const wall& w) {
    const int i = static_cast<int>(walls_.size());
    walls_.push_back(w);
    for (const int f : w.faces) faces_[f].walls.push_back(i);
    nodes_[w.from].walls.push_back(i);
    if (w.to >= 0) nodes_[w.to].walls.push_back(i);
  }

  // Returns the face in front of each edge.
  std::vector<int> add_skeleton(const plane::polygon<integer>& p, bool outside) {
    const std::span<const moving_line<integer>> lines(p.lines);
    const perturbed kernel(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)));
    const plane::vertex_enclosures motion(lines, p.points, outside);
    const plane::fast_locator locator(p);
    plane::skeleton_options o{.outside = outside};
    // No edge's line is farther than that from any place on the paper.
    if (outside) o.until = motion.own_time(locator.unit().to_integers(rational(2 * size_)).convert_to<double>());
    const auto raw = plane::propagation(kernel, p.boundary, motion, o).run();
    const auto skeleton = plane::contract(kernel.base(), p.boundary.line, raw);
    const int first = static_cast<int>(faces_.size());
    for (const int l : p.boundary.line) faces_.push_back({{units.lines[l].n[0].high, units.lines[l].n[1].high}, {}});
    std::vector<int> number;
    for (int v = 0; v < vertices_; ++v) nodes_[v].at = at(locator.vertex(v));
    for (const auto& n : skeleton.nodes) {
      number.push_back(n.vertex >= 0 ? n.vertex : static_cast<int>(nodes_.size()));
      if (n.vertex < 0) nodes_.push_back({at(locator.meeting(n.lines)), {}});
    }
    for (const auto& a : skeleton.arcs) {
      const vec from = nodes_[number[a.source]].at;
      const vec m = faces_[first + a.faces[0]].down;
      const vec n = faces_[first + a.faces[1]].down;
      // An arc that never ends moves with the velocity v where m v = n v = -1.
      const vec far = a.target >= 0 ? vec{} : from + 8 * (size_ + length(from - low_)) * unit(1 / cross(m, n) * vec{m.y - n.y, n.x - m.x});
      const int to = a.target >= 0 ? number[a.target] : -1;
      add_wall({number[a.source], to, from, to >= 0 ? nodes_[to].at : far, {first + a.faces[0], first + a.faces[1]}, true});
    }
    return raw.faces;
  }
  static vec at(const plane::located& p) { return {p.x, p.y}; }

  vec direction(const wall& w, int from) const { return unit(w.from == from ? w.b - w.a : w.a - w.b); }

  void find_starts(int n) {
    auto around = nodes_[n].walls;
    const auto angle = [&](vec d) { return std::atan2(d.y, d.x); };
    std::sort(around.begin(), around.end(), [&](int v, int w) { return angle(direction(walls_[v], n)) < angle(direction(walls_[w], n)); });
    // The face behind each wall: one of the first wall's two, and from there on each wall leads from one of its faces to the other.
    for (const int first : walls_[around[0]].faces) {
      std::vector<int> behind = {first};
      while (behind.size() <= around.size()) {
        const auto& f = walls_[around[behind.size() % around.size()]].faces;
        if (f[0] != behind.back() && f[1] != behind.back()) break;
        behind.push_back(f[f[0] == behind.back() ? 1 : 0]);
      }
      if (behind.size() <= around.size() || behind.back() != first) continue;
      for (std::size_t i = 0; i < around.size(); ++i) {
        const vec here = direction(walls_[around[i]], n);
        const vec next = direction(walls_[around[(i + 1) % around.size()]], n);
        const vec down = faces_[behind[i]].down;
        const auto turn = [&](vec d) { return std::fmod(angle(d) - angle(here) + 4 * std::acos(-1.0), 2 * std::acos(-1.0)); };
        if (turn(down) < turn(next)) starts_[{n, behind[i], true}] = false;
        // Two edges on one line have become one: where their tracks touch is a crease, too, the bisector of those edges.
        if (turn(-1 * down) < turn(next) && dot(here, down) > 0 && dot(next, down) > 0) starts_[{n, behind[i], false}] = false;
      }
      return;
    }
    throw invariant_error("the faces around a node do not fit");
  }

  void follow(const start& s) {
    std::vector<vec> way = {nodes_[s.node].at};
    int f = s.face;
    bool down = s.down;
    std::vector<int> skip = nodes_[s.node].walls;
    for (int arcs = 0;;) {
      const vec p = way.back();
      const vec d = down ? faces_[f].down : -1 * faces_[f].down;
      int hit = -1;
      double nearest = 4 * size_;
      for (const int i : faces_[f].walls) {
        const wall& w = walls_[i];
        const vec along = w.b - w.a;
        const double part = cross(w.a - p, d) / cross(d, along);
        const double t = cross(w.a - p, along) / cross(d, along);
        if (std::find(skip.begin(), skip.end(), i) == skip.end() && part > -near && part < 1 + near && t > 0 && t < nearest) {
          nearest = t;
          hit = i;
        }
      }
      vec q = p + nearest * d;
      int n = -1;
      if (hit >= 0)
        for (const int end : {walls_[hit].from, walls_[hit].to})
          if (end >= 0 && length(nodes_[end].at - q) < near * size_) n = end;
      if (n >= 0) q = nodes_[n].at;
      const bool leaves = !is_on_paper(q);
      if (leaves) {
        vec from = p;
        clip(from, q);
      }
      way.push_back(q);
      if (leaves || hit < 0) break;
      if (n >= vertices_) {  // from there the same one starts, unless this one comes from behind
        const auto same = starts_.find({n, f, !down});
        if (same == starts_.end())
          ++behind_;
        else
          same->second = true;
        break;
      }
      if (n >= 0) hit = arc_at(n, f);
      if (walls_[hit].crease && ++arcs > most_arcs) {
        ++endless_;
        break;
      }
      // Across a bisector the perpendicular of one edge becomes that of the other.
      const wall& w = walls_[hit];
      const vec u = unit(w.b - w.a);
      f = w.faces[w.faces[0] == f ? 1 : 0];
      down = dot(d - 2 * dot(d, u) * u, faces_[f].down) > 0;
      skip = n >= 0 ? nodes_[n].walls : std::vector{hit};
    }
    perpendiculars_.push_back(way);
  }

  // The arc between the faces at a vertex of the polygon, of which f is one.
  int arc_at(int vertex, int f) const {
    for (const int i : nodes_[vertex].walls)
      if (walls_[i].crease && (walls_[i].faces[0] == f || walls_[i].faces[1] == f)) return i;
    throw invariant_error("a vertex has no arc");
  }

  bool is_on_paper(vec p) const { return p.x > low_.x && p.x < high_.x && p.y > low_.y && p.y < high_.y; }

  // What of a segment is on the paper; false: nothing.
  bool clip(vec& a, vec& b) const {
    const vec d = b - a;
    double first = 0;
    double last = 1;
    for (const auto& [speed, room] :
         {std::pair(-d.x, a.x - low_.x), std::pair(d.x, high_.x - a.x), std::pair(-d.y, a.y - low_.y), std::pair(d.y, high_.y - a.y)}) {
      if (speed < 0) first = std::max(first, room / speed);
      if (speed > 0) last = std::min(last, room / speed);
      if (speed == 0 && room < 0) return false;
    }
    if (first >= last) return false;
    b = a + last * d;
    a = a + first * d;
    return true;
  }

  static void write_line(const char* what, const std::vector<vec>& points) {
    std::printf("<polyline class=\"%s\" points=\"", what);
    for (const vec& p : points) std::printf(" %.15g,%.15g", p.x, p.y);
    std::printf("\"/>\n");
  }

  static constexpr double near = 1e-10;  // what is no farther apart, of the paper's size, is one point

  int vertices_;
  vec low_{}, high_{};  // the paper
  double size_ = 0;
  std::vector<node> nodes_;  // the polygon's vertices come first
  std::vector<wall> walls_;
  std::vector<face> faces_;       // inside by edge, then outside
  std::map<start, bool> starts_;  // of perpendiculars, and whether another one has come there
  std::vector<std::vector<vec>> perpendiculars_;
  int endless_ = 0;
  int behind_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const double margin = argc > 2 ? std::atof(argv[2]) : 0;
  if (argc < 2 || argc > 3 || (argc > 2 && !(margin > 0))) {
    std::fprintf(stderr, "usage: fold_and_cut FILE [MARGIN], with a MARGIN above 0\n");
    return 2;
  }
  try {
    std::ifstream in(argv[1], std::ios::binary);
    auto rings = plane::read_polygon<integer>(in, argv[1]);
    const auto rest = plane::make_polygon(rings, true);
    const auto polygon = plane::make_polygon(std::move(rings));
    for (const auto& repair : polygon.repairs) std::fprintf(stderr, "fold_and_cut: note: %s\n", repair.c_str());
    fold creases(polygon, rest, margin);
    creases.add_perpendiculars();
    creases.write();
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fold_and_cut: %s\n", e.what());
    return dynamic_cast<const input_error*>(&e) != nullptr ? 3 : 5;
  }
}
