// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Thick paths along the Hilbert curve.

#include <algorithm>
#include <cstdint>
#include <utility>

#include "osteon/models/polygon_tools.hpp"

namespace osteon::plane::models {

/// Returns step i of the Hilbert curve through a square of 4^order points.
inline point hilbert_point(long i, int order) {
  long x = 0;
  long y = 0;
  for (int level = 0; level < order; ++level, i >>= 2U) {
    const long side = 1L << level;
    const bool right = (i & 2) != 0;
    const bool upper = right != ((i & 1) != 0);
    if (!upper) {
      if (right) x = side - 1 - x, y = side - 1 - y;
      std::swap(x, y);
    }
    if (right) x += side;
    if (upper) y += side;
  }
  return {x, y};
}

/// Returns the outline of a path of width 2 along the Hilbert curve, whose points are 4 apart. With
/// `straight` every point of the curve makes two vertices, else only where the curve turns and
/// ends. At most n vertices, but at least 4.
inline ring hilbert_outline(int n, bool straight) {
  const int pairs = std::max(n / 2, 2);
  int order = 1;
  while (1L << (2 * order) < 4L * pairs) ++order;
  ring left;
  ring right;
  point before{};
  for (long i = 0;; ++i) {
    const point p = hilbert_point(i, order);
    const point next = hilbert_point(i + 1, order);
    const point out = {next[0] - p[0], next[1] - p[1]};
    const bool last = static_cast<int>(left.size()) == pairs - 1;
    const bool turns = before != out;
    if (i > 0 && !turns && !straight) continue;
    point across = {-out[1], out[0]};  // to the left
    point along = {0, 0};
    if (i == 0) {
      along = {-out[0], -out[1]};
    } else if (last) {
      across = {-before[1], before[0]};
      along = before;
    } else if (turns) {
      across = {across[0] - before[1], across[1] + before[0]};
    }
    left.push_back({4 * p[0] + along[0] + across[0], 4 * p[1] + along[1] + across[1]});
    right.push_back({4 * p[0] + along[0] - across[0], 4 * p[1] + along[1] - across[1]});
    if (last) break;
    before = out;
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

/// Returns a thick path along the Hilbert curve on the integer grid: all edges axis-parallel, odd
/// lengths, many events at the same times. An odd n gives one vertex less.
/// *Requires* n >= 4.
/// *Complexity* O(n log n).
inline region rectilinear_hilbert(int n) { return {hilbert_outline(n, false)}; }

/// Returns the same path with two vertices at each point of the curve, jittered. An odd n gives one
/// vertex less.
/// *Requires* n >= 4.
/// *Complexity* O(n log n).
inline region hilbert(int n, std::uint64_t seed) {
  dice roll(seed);
  ring points = hilbert_outline(n, true);
  for (point& p : points) p = jittered({1000 * p[0], 1000 * p[1]}, 300, roll);
  return {points};
}

}  // namespace osteon::plane::models
