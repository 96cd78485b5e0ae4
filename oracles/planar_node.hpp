// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What the planar oracles take and give: polygons as doubles, straight skeletons as lists of nodes, and a comparison of two such lists.
/// Shares nothing with the library.

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace osteon::oracles {

/// A polygon with holes: the outer ring first, counter-clockwise, then the holes, clockwise. Coordinates mean exactly what the doubles say. Weights
/// are speeds by ring and edge, edge i leads from point i to the next; empty: all 1. The oracles believe that it is valid.
struct planar_input {
  std::vector<std::vector<std::array<double, 2>>> rings;
  std::vector<std::vector<double>> weights;
};

/// A place where three or more faces meet inside of the polygon. Edges are numbered through all rings, ascending; those on one line with one
/// direction and weight count as one and have the smallest of their numbers (`lines_of`), since their faces merge when they meet.
struct planar_node {
  double x, y, time;
  std::vector<int> edges;
};

/// The oracle cannot answer: the polygon is degenerate in a way that this oracle leaves alone, or the answer is ambiguous. Not a finding.
struct planar_give_up : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The edges of all rings, one after the other.
struct planar_edge {
  std::array<double, 2> from, to;
  double weight;
};

/// All edges. Throws std::invalid_argument where the input is no polygon at all: short rings, numbers that are not finite, edges without length.
inline std::vector<planar_edge> edges_of(const planar_input& input) {
  std::vector<planar_edge> result;
  for (std::size_t r = 0; r < input.rings.size(); ++r) {
    const auto& ring = input.rings[r];
    if (ring.size() < 3) throw std::invalid_argument("a ring of less than three points");
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double w = r < input.weights.size() && !input.weights[r].empty() ? input.weights[r].at(i) : 1.0;
      result.push_back({ring[i], ring[(i + 1) % ring.size()], w});
      if (!std::isfinite(ring[i][0]) || !std::isfinite(ring[i][1]) || !std::isfinite(w) || w < 0) throw std::invalid_argument("a number");
      if (result.back().from == result.back().to) throw std::invalid_argument("an edge without length");
    }
  }
  if (result.empty()) throw std::invalid_argument("no rings");
  return result;
}

/// The longer side of the bounding box.
inline double size_of(const planar_input& input) {
  double size = 0;
  for (const std::size_t axis : {0U, 1U}) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const auto& ring : input.rings)
      for (const auto& p : ring) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
    size = std::max(size, high - low);
  }
  return size;
}

/// For each edge the smallest edge on the same line with the same direction and weight: exact.
inline std::vector<int> lines_of(const planar_input& input) {
  using exact = boost::multiprecision::mpq_rational;
  const auto cross = [](const auto& x1, const auto& y1, const auto& x2, const auto& y2) { return x1 * y2 - y1 * x2; };
  const auto edges = edges_of(input);
  std::vector<int> result;
  for (std::size_t j = 0; j < edges.size(); ++j) {
    const auto& f = edges[j];
    const double fx = f.to[0] - f.from[0];
    const double fy = f.to[1] - f.from[1];
    result.push_back(static_cast<int>(j));
    for (std::size_t i = 0; i < j; ++i) {
      const auto& e = edges[i];
      const double ex = e.to[0] - e.from[0];
      const double ey = e.to[1] - e.from[1];
      // Differences of doubles are good to 2^-53, so this spares exact numbers without deciding anything.
      if (e.weight != f.weight || std::abs(cross(ex, ey, fx, fy)) > 1e-14 * std::hypot(ex, ey) * std::hypot(fx, fy)) continue;
      const exact dx = exact(e.to[0]) - exact(e.from[0]);
      const exact dy = exact(e.to[1]) - exact(e.from[1]);
      const exact gx = exact(f.to[0]) - exact(f.from[0]);
      const exact gy = exact(f.to[1]) - exact(f.from[1]);
      if (cross(dx, dy, gx, gy) != 0 || exact(dx * gx + dy * gy) <= 0) continue;
      if (cross(dx, dy, exact(exact(f.from[0]) - exact(e.from[0])), exact(exact(f.from[1]) - exact(e.from[1]))) != 0) continue;
      result.back() = result[i];
      break;
    }
  }
  return result;
}

inline std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

inline void sort_by_time(std::vector<planar_node>& nodes) {
  std::sort(nodes.begin(), nodes.end(),
            [](const planar_node& a, const planar_node& b) { return std::tie(a.time, a.x, a.y, a.edges) < std::tie(b.time, b.x, b.y, b.edges); });
}

/// The number of each node's cluster: nodes nearer than `tolerance` in place and time belong together, and so do chains of such nodes.
inline std::vector<std::size_t> clusters_of(const std::vector<planar_node>& nodes, double tolerance) {
  std::vector<std::size_t> root(nodes.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  std::vector<std::size_t> order = root;
  std::sort(order.begin(), order.end(), [&nodes](std::size_t a, std::size_t b) { return nodes[a].time < nodes[b].time; });
  const auto find = [&root](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const planar_node& p = nodes[order[a]];
      const planar_node& q = nodes[order[b]];
      if (q.time - p.time > tolerance) break;
      if (std::abs(p.x - q.x) <= tolerance && std::abs(p.y - q.y) <= tolerance) root[find(order[a])] = find(order[b]);
    }
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = find(i);
  return root;
}

/// One node for each cluster, with the edges of all. Sorted by time.
inline std::vector<planar_node> merged(const std::vector<planar_node>& nodes, double tolerance) {
  const auto cluster = clusters_of(nodes, tolerance);
  std::vector<planar_node> result;
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    if (cluster[c] != c) continue;
    result.push_back(nodes[c]);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (cluster[i] == c) result.back().edges = united(result.back().edges, nodes[i].edges);
  }
  sort_by_time(result);
  return result;
}

/// Whether two lists of nodes say the same.
struct comparison {
  std::string difference;  ///< the first one in order of time; empty: they agree
  explicit operator bool() const { return difference.empty(); }
};

/// Compares clusters of nodes that lie within `tolerance` of each other (a length) in place and time: each must have the same lines in both lists.
/// Edges may be any of their line. A cluster of one list that the other does not have may be missing if it has fewer than three lines. O(n^2).
inline comparison compare(const planar_input& input, const std::vector<planar_node>& ours, const std::vector<planar_node>& theirs, double tolerance) {
  const auto lines = lines_of(input);
  std::vector<planar_node> all = ours;
  all.insert(all.end(), theirs.begin(), theirs.end());
  for (planar_node& n : all) {
    if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.time)) return {"a node that is not finite"};
    for (int& e : n.edges) {
      if (e < 0 || e >= static_cast<int>(lines.size())) return {"a node of edge " + std::to_string(e) + ", which is not there"};
      e = lines[static_cast<std::size_t>(e)];
    }
    std::sort(n.edges.begin(), n.edges.end());
    n.edges.erase(std::unique(n.edges.begin(), n.edges.end()), n.edges.end());
  }
  const auto cluster = clusters_of(all, tolerance);
  struct pair {
    std::vector<int> ours, theirs;
    bool in_ours = false, in_theirs = false;
  };
  std::vector<pair> pairs(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    pair& p = pairs[cluster[i]];
    auto& mine = i < ours.size() ? p.ours : p.theirs;
    mine = united(mine, all[i].edges);
    (i < ours.size() ? p.in_ours : p.in_theirs) = true;
  }
  const auto text = [](bool there, const std::vector<int>& edges) {
    std::string result = there ? "edges" : "no node";
    for (const int e : edges) result += ' ' + std::to_string(e);
    return result;
  };
  std::size_t first = all.size();
  for (std::size_t c = 0; c < all.size(); ++c) {
    const pair& p = pairs[c];
    if (p.ours == p.theirs || (first < all.size() && all[first].time <= all[c].time)) continue;
    if (p.in_ours != p.in_theirs && std::max(p.ours.size(), p.theirs.size()) < 3) continue;
    first = c;
  }
  if (first == all.size()) return {};
  std::ostringstream out;
  out.precision(17);
  out << "at time " << all[first].time << ", place (" << all[first].x << ", " << all[first].y
      << "): " << text(pairs[first].in_ours, pairs[first].ours) << "; the other: " << text(pairs[first].in_theirs, pairs[first].theirs);
  return {out.str()};
}

}  // namespace osteon::oracles
