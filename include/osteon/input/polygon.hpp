// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Polygons: as they come in, exact and unchecked, and checked, ready for a kernel and for the algorithms.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "osteon/input/exact_number.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/plane/boundary.hpp"

namespace osteon::plane {

/// Closed rings of points as read; the last point of a ring is joined to its first.
template <class Int>
struct rings {
  struct ring {
    std::vector<std::array<exact_number<Int>, 2>> points;
    std::vector<exact_number<Int>> weights;  ///< of the edge that starts at each point; empty: all 1
    std::vector<std::size_t> lines;          ///< of the file, by point; or empty
    int part = 0;                            ///< polygon of a multipolygon; the first ring of a part is its outer one
  };
  std::vector<ring> all;
  std::string file;                ///< for messages; empty for memory
  std::vector<std::string> notes;  ///< what the reader left out, one sentence each
};

/// A checked polygon. Coordinates are integers: input = (coordinate + shift) * 10^ten * 2^two; the input's weights are the lines' times
/// 10^weight_ten * 2^weight_two.
template <class Int>
struct polygon {
  std::vector<moving_line<Int>> lines;
  plane::boundary boundary;
  std::vector<std::array<Int, 2>> points;  ///< of the vertices
  std::vector<int> input_points;           ///< their numbers in the input, counted through all rings from 0
  std::vector<int> input_edges;            ///< by edge of the boundary: an edge of the input that it is part of, by the number of its first point
  int holes = 0;                           ///< clockwise boundaries of the outline: holes that touch are one, none if they touch the outer ring
  int parts = 0;                           ///< counter-clockwise ones: connected pieces of the interior
  std::array<Int, 2> shift{};
  int ten = 0;
  int two = 0;
  int weight_ten = 0;
  int weight_two = 0;
  std::vector<std::string> repairs;  ///< what was changed or accepted, one sentence each; empty: nothing
};

/// Whether an edge has weight zero: it stays where it is.
template <class Int>
bool has_stationary_edge(const polygon<Int>& p) {
  return std::any_of(p.lines.begin(), p.lines.end(), [](const auto& l) { return l.weight == 0; });
}

/// Sets the ranks of edges from the points of their tails. Cost: sorting.
template <class Int>
void rank_edges(boundary& o, const std::vector<std::array<Int, 2>>& points) {
  std::vector<int> order(o.next.size());
  std::iota(order.begin(), order.end(), 0);
  const auto first = [&](int e, int f) {
    if (o.line[e] != o.line[f]) return o.line[e] < o.line[f];
    const auto& p = points[e];
    const auto& q = points[f];
    const auto& h = points[o.next[e]];
    return p[0] != h[0] ? (p[0] < h[0]) == (p[0] < q[0]) && p[0] != q[0] : (p[1] < h[1]) == (p[1] < q[1]) && p[1] != q[1];
  };
  std::sort(order.begin(), order.end(), first);
  o.rank.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) o.rank[order[i]] = static_cast<int>(i);
}

}  // namespace osteon::plane
