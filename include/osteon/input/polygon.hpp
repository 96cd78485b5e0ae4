// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Checked polygons, ready for a kernel and for the algorithms.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/plane/boundary.hpp"

namespace osteon::plane {

/// A checked polygon, or what is outside of one. Coordinates are integers: input = (coordinate +
/// shift) * 10^ten * 2^two. The input's weights are those of the lines times 10^weight_ten *
/// 2^weight_two.
template <class Int>
struct polygon {
  std::vector<moving_line<Int>> lines;  ///< all different
  plane::boundary boundary;
  std::vector<std::array<Int, 2>> points;  ///< of the vertices
  /// their numbers in the input, counted through all rings from 0
  std::vector<int> input_points;
  /// by edge: an edge of the input that it is part of, by the number of its first point
  std::vector<int> input_edges;
  /// clockwise rings of the boundary: holes that touch are one, none if they touch the outer ring
  int holes = 0;
  /// counter-clockwise rings: connected pieces of the interior
  int parts = 0;
  std::array<Int, 2> shift{};
  int ten = 0;
  int two = 0;
  int weight_ten = 0;
  int weight_two = 0;
  /// what was changed or accepted, one sentence each; empty: nothing
  std::vector<std::string> repairs;
};

/// Returns whether an edge of a polygon has weight zero: it stays where it is.
template <class Int>
bool has_stationary_edge(const polygon<Int>& p) {
  return std::any_of(p.lines.begin(), p.lines.end(), [](const auto& l) { return l.weight == 0; });
}

/// Sets the rank of each edge among those on its line, in their direction, from the points where
/// edges start.
/// *Complexity* O(n log n).
template <class Int>
void rank_edges(boundary& b, const std::vector<std::array<Int, 2>>& points) {
  std::vector<int> order(b.next.size());
  std::iota(order.begin(), order.end(), 0);
  const auto first = [&](int e, int f) {
    if (b.line[e] != b.line[f]) return b.line[e] < b.line[f];
    const auto& p = points[e];
    const auto& q = points[f];
    const auto& h = points[b.next[e]];
    return p[0] != h[0] ? (p[0] < h[0]) == (p[0] < q[0]) && p[0] != q[0] : (p[1] < h[1]) == (p[1] < q[1]) && p[1] != q[1];
  };
  std::sort(order.begin(), order.end(), first);
  b.rank.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) b.rank[order[i]] = static_cast<int>(i);
}

}  // namespace osteon::plane
