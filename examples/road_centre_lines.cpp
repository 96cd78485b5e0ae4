// SPDX-License-Identifier: MIT

/// \file
/// Centre lines of roads: the arcs of the straight skeleton of the roads' surface that touch
/// no corner of it.
///   road_centre_lines FILE FILE is a polygon, its holes are the blocks between the roads. The
///   result is one line of WKT, a MULTILINESTRING M: a line from junction to junction, and as the
///   measure M of each point the width of the road there, twice the time of the wavefront. Where a
///   road leaves between two sides on one line, these become one edge of the wavefront, which
///   passes the mouth: the road is led on across the track of that edge. A branch with a dead end
///   that is not longer than half the road's width where it leaves is a spur of a rounded corner,
///   no road, and is left out. A road with a dead end stops about half its width before its surface
///   does, where the arcs into the corners begin.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "example.hpp"

namespace {

class centre_lines {
 public:
  explicit centre_lines(const osteon::polygon_skeleton& skeleton) {
    std::vector<bool> is_vertex;
    for (const auto& n : skeleton.nodes()) {
      places_.push_back({n.point()[0], n.point()[1], n.time()});
      is_vertex.push_back(n.vertex() >= 0);
    }
    for (const auto& a : skeleton.arcs()) arcs_.push_back({a.source().id(), a.target().id(), {a.faces()[0].id(), a.faces()[1].id()}});
    at_.resize(places_.size());
    // how many arcs lead from vertices to a node beside a face
    std::map<std::pair<int, int>, int> corners;
    for (const auto& a : arcs_) {
      if (!is_vertex[a.source])
        join(a.source, a.target);
      else
        for (const int f : a.faces) ++corners[{a.target, f}];
    }
    for (const auto& [key, count] : corners)
      if (count == 2) lead_on(is_vertex, key.first, key.second, skeleton.faces()[key.second].inwards());
    cut_arcs();
  }

  /// Takes spurs away, the shortest first, until there are none.
  void prune() {
    for (std::vector<int> spur = {0}; !spur.empty(); remove(spur)) {
      spur.clear();
      mark();
      for (int n = 0; n < nodes(); ++n) {
        if (at_[n].size() != 1) continue;
        const auto branch = walk(n, at_[n][0]);
        const int junction = branch.back();
        if (at_[junction].size() > 2 && length(branch) <= places_[junction].time * (1 + 1e-9) && (spur.empty() || length(branch) < length(spur)))
          spur = branch;
      }
    }
  }

  /// On standard output, each line from junction to junction once.
  void write() {
    std::vector<std::vector<int>> all;
    mark();
    for (const bool rings : {false, true})  // at last those without a junction
      for (int n = 0; n < nodes(); ++n)
        while (is_inner_[n] == rings && !at_[n].empty()) {
          all.push_back(walk(n, at_[n][0]));
          remove(all.back());
        }
    double sum = 0;
    std::printf("MULTILINESTRING M %s", all.empty() ? "EMPTY" : "");
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < all[i].size(); ++k) {
        const auto& p = places_[all[i][k]];
        std::printf("%s%.15g %.15g %.15g", k > 0 ? ", " : i > 0 ? ", (" : "((", p.x, p.y, 2 * p.time);
      }
      std::printf(")");
      sum += length(all[i]);
    }
    std::printf(all.empty() ? "\n" : ")\n");
    std::fprintf(stderr, "%zu centre lines, together %.15g long\n", all.size(), sum);
  }

 private:
  struct place {
    double x, y;
    double time;
  };
  struct arc {
    int source;
    int target;
    std::array<int, 2> faces;
  };
  struct cut {
    int arc;
    double part;  ///< of its length, from the source
    int node;
    friend bool operator<(const cut& a, const cut& b) { return std::pair(a.arc, a.part) < std::pair(b.arc, b.part); }
  };

  int nodes() const { return static_cast<int>(at_.size()); }

  void join(int n, int m) {
    at_[n].push_back(m);
    at_[m].push_back(n);
  }
  void part(int n, int m) {
    at_[n].erase(std::find(at_[n].begin(), at_[n].end(), m));
    at_[m].erase(std::find(at_[m].begin(), at_[m].end(), n));
  }
  void remove(const std::vector<int>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) part(line[i - 1], line[i]);
  }

  // In front of two vertices where the same face begins is a dead end, which lies before the face's
  // edge, or a mouth, which lies behind it. From there a line leads to the next arc of the face.
  void lead_on(const std::vector<bool>& is_vertex, int node, int face, const std::array<double, 2>& inwards) {
    const place& p = places_[node];
    const auto height = [&](const place& q) { return inwards[0] * (q.x - p.x) + inwards[1] * (q.y - p.y); };
    const auto beside = [&](const place& q) { return inwards[0] * (q.y - p.y) - inwards[1] * (q.x - p.x); };
    if (at_[node].empty() || std::any_of(at_[node].begin(), at_[node].end(), [&](int m) { return height(places_[m]) >= 0; })) return;
    cut next{-1, 0, -1};
    double nearest = 0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const auto& a = arcs_[i];
      const double from = beside(places_[a.source]);
      const double to = beside(places_[a.target]);
      if ((a.faces[0] != face && a.faces[1] != face) || a.source == node || a.target == node || (from > 0) == (to > 0)) continue;
      const double u = from / (from - to);
      const double way = (1 - u) * height(places_[a.source]) + u * height(places_[a.target]);
      if (way > 0 && (next.arc < 0 || way < nearest)) {
        next = {static_cast<int>(i), u, -1};
        nearest = way;
      }
    }
    if (next.arc < 0) return;
    const auto& a = arcs_[next.arc];
    if (next.part > 1 - 1e-9 || is_vertex[a.source]) return join(node, a.target);
    if (next.part < 1e-9) return join(node, a.source);
    next.node = nodes();
    const place from = places_[a.source];
    const place to = places_[a.target];
    const auto between = [&](double x, double y) { return x + next.part * (y - x); };
    places_.push_back({between(from.x, to.x), between(from.y, to.y), between(from.time, to.time)});
    at_.emplace_back();
    join(node, next.node);
    cuts_.push_back(next);
  }

  void cut_arcs() {
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const auto& c = cuts_[i];
      const auto& a = arcs_[c.arc];
      const int before = i > 0 && cuts_[i - 1].arc == c.arc ? cuts_[i - 1].node : a.source;
      part(before, a.target);
      join(before, c.node);
      join(c.node, a.target);
    }
  }

  // Junctions and ends stay what they are while lines are removed.
  void mark() {
    is_inner_.resize(at_.size());
    for (int n = 0; n < nodes(); ++n) is_inner_[n] = at_[n].size() == 2;
  }

  // From a node over another one to the next junction or end, or round to the first.
  std::vector<int> walk(int from, int to) const {
    std::vector<int> line = {from, to};
    while (is_inner_[line.back()] && line.back() != from) {
      const auto& next = at_[line.back()];
      line.push_back(next[next[0] == line[line.size() - 2] ? 1 : 0]);
    }
    return line;
  }

  double length(const std::vector<int>& line) const {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto& p = places_[line[i - 1]];
      const auto& q = places_[line[i]];
      sum += std::hypot(q.x - p.x, q.y - p.y);
    }
    return sum;
  }

  std::vector<place> places_;  // of nodes
  std::vector<arc> arcs_;
  std::vector<std::vector<int>> at_;  // neighbours of a node
  std::vector<bool> is_inner_;        // has two neighbours
  std::vector<cut> cuts_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: road_centre_lines FILE\n");
    return 2;
  }
  return example::run([&] {
    centre_lines lines(osteon::skeletonize(example::read(argv[1])));
    lines.prune();
    lines.write();
  });
}
