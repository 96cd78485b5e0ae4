// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids over grids of squares.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "osteon/models/mesh_builder.hpp"
#include "osteon/models/voxels.hpp"

namespace osteon::models {

/// Returns n bars along x over n bars along y, sunk halfway into each other.
inline builder crossing_bars(int n) {
  voxels v({2 * n + 1, 2 * n + 1, 3});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n + 1; ++j)
      for (int z = 0; z < 2; ++z) {
        v.set(j, 2 * i + 1, z, true);
        v.set(2 * i + 1, j, z + 1, true);
      }
  return v.surface();
}

/// Returns a slab with n x n towers of heights 1 .. 3.
inline builder towers(int n, std::uint64_t seed) {
  dice roll(seed);
  voxels v({2 * n + 1, 2 * n + 1, 4});
  for (int x = 0; x < 2 * n + 1; ++x)
    for (int y = 0; y < 2 * n + 1; ++y) v.set(x, y, 0, true);
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (long z = roll.between(1, 3); z > 0; --z) v.set(2 * x + 1, 2 * y + 1, static_cast<int>(z), true);
  return v.surface();
}

/// Returns a square frame: a torus of boxes with an n x n hole.
inline builder frame(int n) {
  voxels v({n + 2, n + 2, 1});
  for (int x = 0; x < n + 2; ++x)
    for (int y = 0; y < n + 2; ++y) v.set(x, y, 0, x == 0 || y == 0 || x == n + 1 || y == n + 1);
  return v.surface();
}

/// Returns a plate with n x n pyramids on top.
inline builder spiked_plate(int n) {
  builder b;
  const long size = 3L * n;
  const auto floor = [&](const point& p, long z) { return point{10 * p[0], 10 * p[1], z}; };
  for (long x = 0; x < size; ++x)
    for (long y = 0; y < size; ++y) {
      const std::array<point, 4> c = {{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}};
      if (x % 3 == 1 && y % 3 == 1) {
        const point apex = {10 * x + 4 + x % 2, 10 * y + 5, 30 + (x + 2 * y) % 7};
        for (int i = 0; i < 4; ++i) b.facet({floor(c[i], 10), floor(c[(i + 1) % 4], 10), apex});
      } else {
        b.facet({floor(c[0], 10), floor(c[1], 10), floor(c[2], 10), floor(c[3], 10)});
      }
      b.facet({floor(c[3], 0), floor(c[2], 0), floor(c[1], 0), floor(c[0], 0)});
    }
  for (long i = 0; i < size; ++i)
    for (const auto& [p, q] : {std::pair<point, point>{{i, 0, 0}, {i + 1, 0, 0}},
                               {{size, i, 0}, {size, i + 1, 0}},
                               {{i + 1, size, 0}, {i, size, 0}},
                               {{0, i + 1, 0}, {0, i, 0}}})
      b.facet({floor(p, 0), floor(q, 0), floor(q, 10), floor(p, 10)});
  return b;
}

/// Returns a house with a hip roof of slope 1 over a footprint of squares, '#' in the rows of a
/// plan like "##|#.".
inline builder house(const std::string& plan) {
  std::vector<std::string> rows(1);
  for (const char c : plan) {
    if (c == '|')
      rows.emplace_back();
    else
      rows.back().push_back(c);
  }
  const int w = 2 * static_cast<int>(rows[0].size());
  const int h = 2 * static_cast<int>(rows.size());
  const auto full = [&](long x, long y) {
    return x >= 0 && y >= 0 && x < w && y < h && static_cast<std::size_t>(x / 2) < rows[static_cast<std::size_t>(y / 2)].size() &&
           rows[static_cast<std::size_t>(y / 2)][static_cast<std::size_t>(x / 2)] == '#';
  };
  // The roof's height over a grid point: 0 on the outline, 1 within (the arms are two units wide).
  const auto rise = [&](long x, long y) { return full(x, y) && full(x - 1, y) && full(x, y - 1) && full(x - 1, y - 1) ? 1L : 0L; };
  const long eaves = 3;
  builder b;
  for (long x = 0; x < w; ++x)
    for (long y = 0; y < h; ++y) {
      if (!full(x, y)) continue;
      b.facet({{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}});
      std::array<point, 4> c = {{{x, y, eaves + rise(x, y)},
                                 {x + 1, y, eaves + rise(x + 1, y)},
                                 {x + 1, y + 1, eaves + rise(x + 1, y + 1)},
                                 {x, y + 1, eaves + rise(x, y + 1)}}};
      // Cut along the diagonal through the corner that differs from its two neighbours.
      if (c[0][2] == c[2][2]) std::rotate(c.begin(), c.begin() + 1, c.end());
      b.facet({c[0], c[1], c[2]});
      b.facet({c[0], c[2], c[3]});
      if (!full(x, y - 1)) b.facet({{x, y, 0}, {x + 1, y, 0}, {x + 1, y, eaves}, {x, y, eaves}});
      if (!full(x + 1, y)) b.facet({{x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, eaves}, {x + 1, y, eaves}});
      if (!full(x, y + 1)) b.facet({{x + 1, y + 1, 0}, {x, y + 1, 0}, {x, y + 1, eaves}, {x + 1, y + 1, eaves}});
      if (!full(x - 1, y)) b.facet({{x, y + 1, 0}, {x, y, 0}, {x, y, eaves}, {x, y + 1, eaves}});
    }
  return b;
}

}  // namespace osteon::models
