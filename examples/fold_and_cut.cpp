// SPDX-License-Identifier: MIT

/// \file
/// A sheet of paper folded flat so that one straight cut leaves the polygon: the creases
/// after Demaine, Demaine, Lubiw (1998).
///   fold_and_cut FILE [MARGIN] FILE is a polygon, with holes if you like; MARGIN is the paper
///   around it, by default a quarter of its greater extent. The result is SVG, in the coordinates
///   of the file: solid the polygon's sides, which the cut goes along, dashed red the straight
///   skeleton, blue the perpendiculars.
///
/// The creases are the skeleton inside and outside, of the polygon alone, as if the paper had no
/// border: nobody cuts along that, so it must not move, nor stop anything, as even an edge that is
/// held would. What lies beyond the paper is cut off. From each node of the skeleton go
/// perpendiculars to the edges whose faces they enter there, mirrored at every arc, until they
/// leave the sheet or meet a node. There are polygons where they never do and lie densely; so each
/// one is given up after a number of arcs, which standard error then tells, as it does where one
/// meets a node from behind: there the polygon is so special that two perpendiculars would have to
/// lie on each other. The skeleton is exact, the perpendiculars are doubles: this is a drawing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "example.hpp"

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

/// Walls cut the plane into faces, one on each side of each edge: the arcs of both skeletons, which
/// are creases, and the edges themselves.
class fold {
 public:
  fold(const polygon& p, double margin) {
    for (int e = 0; e < p.edges(); ++e)
      if (p.weight(e) != p.weight(0))
        throw input_error(input_fault::bad_weight, 0, "paper folds at bisectors only, so no edge may have a weight of its own",
                          "leave the weights out");
    const polygon_skeleton inside = skeletonize(p);
    add_vertices(inside);
    const double m = margin > 0 ? margin : size_ / 4;
    low_ = low_ - vec{m, m};
    high_ = high_ + vec{m, m};
    size_ += 2 * m;
    add_skeleton(inside);
    const int inner = static_cast<int>(faces_.size());
    // No edge's line is farther than that from any place on the paper.
    add_skeleton(skeletonize(p, {.region = region::exterior, .until = 2 * size_ / p.weight(0)}));
    add_sides(inside, inner);
  }

  /// From each node of the skeleton on the paper. The others' do not matter: creases that only pass
  /// can be left out.
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

  static vec at(const polygon_skeleton::node& n) { return {n.point()[0], n.point()[1]}; }

  // The polygon's vertices, and how far it reaches.
  void add_vertices(const polygon_skeleton& s) {
    std::set<std::array<double, 2>> places;
    for (const auto& n : s.nodes()) {
      if (n.vertex() < 0) continue;
      if (!places.insert(n.point()).second)
        throw unsupported_error("the polygon touches itself, so its corners outside are others than inside; hint: move that point a little");
      vertex_at_[n.vertex()] = static_cast<int>(nodes_.size());
      nodes_.push_back({at(n), {}});
    }
    vertices_ = static_cast<int>(nodes_.size());
    low_ = high_ = nodes_[0].at;
    for (const node& n : nodes_) {
      low_ = {std::min(low_.x, n.at.x), std::min(low_.y, n.at.y)};
      high_ = {std::max(high_.x, n.at.x), std::max(high_.y, n.at.y)};
    }
    size_ = std::max(high_.x - low_.x, high_.y - low_.y);
  }

  void add_skeleton(const polygon_skeleton& s) {
    const int first = static_cast<int>(faces_.size());
    for (const auto& f : s.faces()) faces_.push_back({{-f.inwards()[0], -f.inwards()[1]}, {}});
    std::vector<int> number;
    for (const auto& n : s.nodes()) {
      number.push_back(n.vertex() >= 0 ? vertex_at_.at(n.vertex()) : static_cast<int>(nodes_.size()));
      if (n.vertex() < 0) nodes_.push_back({at(n), {}});
    }
    for (const auto& a : s.arcs()) {
      const int source = number[a.source().id()];
      const std::array<int, 2> faces = {first + a.faces()[0].id(), first + a.faces()[1].id()};
      const vec from = nodes_[source].at;
      if (a.is_endless()) {
        const vec far = from + 8 * (size_ + length(from - low_)) * unit({a.velocity()[0], a.velocity()[1]});
        add_wall({source, -1, from, far, faces, true});
      } else {
        const int target = number[a.target().id()];
        add_wall({source, target, from, nodes_[target].at, faces, true});
      }
    }
  }

  // The polygon's edges, between the faces inside and those from `outer` on: where the boundary of
  // a face goes from vertex to vertex.
  void add_sides(const polygon_skeleton& inside, int outer) {
    for (const auto& swept : inside.faces())
      for (const auto& loop : swept.boundary())
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto& from = loop[i];
          const auto& to = loop[(i + 1) % loop.size()];
          if (from.vertex() < 0 || to.vertex() < 0) continue;
          const int v = vertex_at_.at(from.vertex());
          const int w = vertex_at_.at(to.vertex());
          add_wall({v, w, nodes_[v].at, nodes_[w].at, {swept.id(), common_face(v, w, outer)}, false});
        }
  }

  // The face from `outer` on between the arcs of two vertices.
  int common_face(int v, int w, int outer) const {
    for (const int a : nodes_[v].walls)
      for (const int b : nodes_[w].walls)
        for (const int f : walls_[a].faces)
          if (f >= outer && (f == walls_[b].faces[0] || f == walls_[b].faces[1])) return f;
    throw invariant_error("an edge has no face outside");
  }

  vec direction(const wall& w, int from) const { return unit(w.from == from ? w.b - w.a : w.a - w.b); }

  void find_starts(int n) {
    auto around = nodes_[n].walls;
    const auto angle = [&](vec d) { return std::atan2(d.y, d.x); };
    std::sort(around.begin(), around.end(), [&](int v, int w) { return angle(direction(walls_[v], n)) < angle(direction(walls_[w], n)); });
    // The face behind each wall: one of the first wall's two, and from there on each wall leads
    // from one of its faces to the other.
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
        // Two edges on one line have become one: where their tracks touch is a crease, too, the
        // bisector of those edges.
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

  // what is no farther apart, of the paper's size, is one point
  static constexpr double near = 1e-10;

  int vertices_ = 0;
  std::map<int, int> vertex_at_;  // by point of the file: the node
  vec low_{}, high_{};            // the paper
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
  return example::run([&] {
    fold creases(example::read(argv[1]), margin);
    creases.add_perpendiculars();
    creases.write();
  });
}
