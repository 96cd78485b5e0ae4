// SPDX-License-Identifier: MIT

/// \file
/// Centre lines of roads: the arcs of the straight skeleton of the roads' surface that touch no corner of it.
///   road_centre_lines FILE
/// FILE is a polygon, its holes are the blocks between the roads. The result is one line of WKT, a MULTILINESTRING M: a line from junction to
/// junction, and as the measure M of each point the width of the road there, twice the time of the wavefront. A branch with a dead end that is not
/// longer than half the road's width where it leaves is a spur of a rounded corner, no road, and is left out. A road with a dead end ends about half
/// its width before the surface does: from there on arcs lead into the corners.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
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

/// What is left of the skeleton: a graph from which arcs are taken.
class centre_lines {
 public:
  explicit centre_lines(const planar::polygon<integer>& p) {
    const std::span<const moving_line<integer>> lines(p.lines);
    const perturbed kernel(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)));
    const auto raw = planar::propagation(kernel, p.outline, planar::motion(lines, p.points)).run();
    const auto skeleton = planar::contract(kernel.base(), p.outline.line, raw);
    const planar::unit_lines units(lines, p.points);
    const planar::fast_locator locator(p, units);
    for (const auto& n : skeleton.nodes) places_.push_back(n.vertex >= 0 ? locator.vertex(n.vertex) : locator.meeting(n.lines));
    at_.resize(places_.size());
    for (const auto& a : skeleton.arcs)
      if (skeleton.nodes[a.source].vertex < 0) {
        at_[a.source].push_back(a.target);
        at_[a.target].push_back(a.source);
      }
  }

  /// Takes spurs away, shorter ones first, until there are none.
  void prune() {
    while (true) {
      std::vector<int> shortest;
      for (int n = 0; n < nodes(); ++n) {
        if (at_[n].size() != 1) continue;
        const auto branch = walk(n, at_[n][0]);
        if (at_[branch.back()].size() > 2 && length(branch) <= places_[branch.back()].time * (1 + 1e-9) &&
            (shortest.empty() || length(branch) < length(shortest)))
          shortest = branch;
      }
      if (shortest.empty()) return;
      remove(shortest);
    }
  }

  void write() {
    std::vector<std::vector<int>> all;
    const auto take = [&](int n) {
      while (!at_[n].empty()) {
        all.push_back(walk(n, at_[n][0]));
        remove(all.back());
      }
    };
    std::vector<int> ends;
    for (int n = 0; n < nodes(); ++n)
      if (at_[n].size() != 2) ends.push_back(n);
    for (const int n : ends) take(n);
    for (int n = 0; n < nodes(); ++n) take(n);  // rings without a junction
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
  int nodes() const { return static_cast<int>(at_.size()); }

  // From a node over another one to the next junction or end, or round to the first.
  std::vector<int> walk(int from, int to) const {
    std::vector<int> line = {from, to};
    while (at_[line.back()].size() == 2 && line.back() != from) {
      const auto& next = at_[line.back()];
      line.push_back(next[next[0] == line[line.size() - 2] ? 1 : 0]);
    }
    return line;
  }

  void remove(const std::vector<int>& line) {
    for (std::size_t i = 1; i < line.size(); ++i)
      for (const auto& [n, m] : {std::pair(line[i], line[i - 1]), std::pair(line[i - 1], line[i])})
        at_[n].erase(std::find(at_[n].begin(), at_[n].end(), m));
  }

  double length(const std::vector<int>& line) const {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      sum += std::hypot(places_[line[i]].x - places_[line[i - 1]].x, places_[line[i]].y - places_[line[i - 1]].y);
    return sum;
  }

  std::vector<planar::located> places_;
  std::vector<std::vector<int>> at_;  // neighbours of a node
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: road_centre_lines FILE\n");
    return 2;
  }
  try {
    std::ifstream in(argv[1], std::ios::binary);
    centre_lines lines(planar::make_polygon(planar::read_polygon<integer>(in, argv[1])));
    lines.prune();
    lines.write();
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "road_centre_lines: %s\n", e.what());
    return dynamic_cast<const input_error*>(&e) != nullptr ? 3 : 5;
  }
}
