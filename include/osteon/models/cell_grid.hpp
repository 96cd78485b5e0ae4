// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Random connected sets of cells of a grid, and their outlines.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "osteon/models/polygon_tools.hpp"

namespace osteon::plane::models {

/// A square grid of unit cells, full or empty, within a rim of empty ones.
class cell_grid {
 public:
  /// Makes an empty grid of width by width cells, numbered from 1 in both directions.
  explicit cell_grid(int width) : width_(width), full_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(width + 2)) {}

  /// Returns the number of cells along a side.
  int width() const { return width_; }
  /// Returns whether there is a cell (x,y) that can be full.
  bool within(int x, int y) const { return x >= 1 && y >= 1 && x <= width_ && y <= width_; }
  /// Returns whether a cell is full; x and y in 0 .. width() + 1, of which the first and the last
  /// are the rim.
  bool operator()(int x, int y) const { return full_[index(x, y)]; }
  /// Makes a cell full.
  void fill(int x, int y) { full_[index(x, y)] = true; }
  /// Returns the number of a cell, or of one in the rim, among all.
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2) + static_cast<std::size_t>(x); }

  /// Returns how many vertices the outline has at a grid point, the lower left corner of cell
  /// (x,y): 0, 1, or 2 where two cells touch in that point only.
  int corners(int x, int y) const {
    const int number = (*this)(x, y) + (*this)(x - 1, y) + (*this)(x, y - 1) + (*this)(x - 1, y - 1);
    if (number != 2) return number % 2;
    return (*this)(x, y) == (*this)(x - 1, y - 1) ? 2 : 0;
  }

  /// Returns the rings around a connected set of cells, the outer one first, each of them simple;
  /// where cells touch in a point, rings do.
  /// *Complexity* O(width^2).
  region outline() const {
    region r;
    std::vector<bool> done(full_.size());
    for (int y = 1; y <= width_ + 1; ++y)
      // every ring has edges that lead right; a corner starts at most one
      for (int x = 1; x <= width_ + 1; ++x) {
        if (corners(x, y) == 0 || !(*this)(x, y) || (*this)(x, y - 1) || done[index(x, y)]) continue;
        const bool first = r.empty();
        split(walk(x, y, done), r);
        if (first) std::swap(r.front(), r.back());  // the ring of the lowest corner
      }
    return r;
  }

 private:
  // The corners from one whose edge leads right back to it, always along the same cells: left where
  // two touch.
  ring walk(int x, int y, std::vector<bool>& done) const {
    static constexpr std::array<std::array<int, 2>, 4> step = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    // the cell ahead, on the left
    static constexpr std::array<std::array<int, 2>, 4> left = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    ring points;
    for (std::size_t d = 0; d != 0 || !done[index(x, y)];) {
      points.push_back({x - 1, y - 1});
      if (d == 0) done[index(x, y)] = true;
      for (;;) {
        x += step[d][0], y += step[d][1];
        const bool on_left = (*this)(x + left[d][0], y + left[d][1]);
        const bool on_right = (*this)(x + left[(d + 3) % 4][0], y + left[(d + 3) % 4][1]);
        if (on_left && !on_right) continue;
        d = (d + (on_left ? 3 : 1)) % 4;
        break;
      }
    }
    return points;
  }

  // Cuts a ring where it visits a point again; such loops nest, so their points do not come a third
  // time. The ring of the first point comes last.
  void split(const ring& points, region& r) const {
    std::map<point, std::size_t> at;  // of the points that cells touch in: where they are in `open`
    ring open;
    for (const point& p : points) {
      const bool pinched = corners(static_cast<int>(p[0]) + 1, static_cast<int>(p[1]) + 1) == 2;
      if (const auto seen = pinched ? at.find(p) : at.end(); seen != at.end()) {
        const auto again = open.begin() + static_cast<std::ptrdiff_t>(seen->second);
        r.emplace_back(again, open.end());
        open.erase(again + 1, open.end());
        continue;
      }
      if (pinched) at.emplace(p, open.size());
      open.push_back(p);
    }
    r.push_back(std::move(open));
  }

  int width_;
  std::vector<bool> full_;
};

/// Returns a random connected set of cells, grown from one, always by the neighbour with the least
/// of random numbers (invasion percolation: long arms, holes of all sizes), until its outline has n
/// vertices or the grid is full. Cells touch in a point only if allowed.
/// *Complexity* O(n log n).
inline cell_grid random_cells(int n, bool touching, std::uint64_t seed) {
  cell_grid grid(static_cast<int>(std::sqrt(3.0 * n)) + 2);
  using candidate = std::pair<std::uint64_t, std::array<int, 2>>;
  std::priority_queue<candidate, std::vector<candidate>, std::greater<>> fringe;
  const auto around = [&grid](int x, int y) {
    return grid.corners(x, y) + grid.corners(x + 1, y) + grid.corners(x, y + 1) + grid.corners(x + 1, y + 1);
  };
  const auto weight = [&grid, seed](int x, int y) { return dice(dice(seed)() ^ grid.index(x, y))(); };
  // once the cell is full: a neighbour across a corner without one in between
  const auto touches = [&grid](int x, int y) {
    for (const int dx : {-1, 1})
      for (const int dy : {-1, 1})
        if (grid(x + dx, y + dy) && !grid(x + dx, y) && !grid(x, y + dy)) return true;
    return false;
  };
  int vertices = 0;
  fringe.push({0, {(grid.width() + 1) / 2, (grid.width() + 1) / 2}});
  while (vertices < n && !fringe.empty()) {
    const auto [x, y] = fringe.top().second;
    fringe.pop();
    // one that was refused comes again with its next neighbour
    if (grid(x, y) || (!touching && touches(x, y))) continue;
    vertices -= around(x, y);
    grid.fill(x, y);
    vertices += around(x, y);
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
      if (grid.within(x + dx, y + dy) && !grid(x + dx, y + dy)) fringe.push({weight(x + dx, y + dy), {x + dx, y + dy}});
  }
  return grid;
}

/// Returns the outline of random cells of the integer grid, with holes if any. About n vertices.
/// *Requires* n >= 4.
/// *Complexity* O(n log n).
inline region rectilinear(int n, std::uint64_t seed) { return random_cells(std::max(n, 4), false, seed).outline(); }

/// Returns the polygon of rectilinear with the lines of the grid at random distances 100 .. 1000:
/// parallel edges, but few events at the same time.
inline region stretched_cells(int n, std::uint64_t seed) {
  region r = rectilinear(n, seed);
  dice roll(seed + 1);
  std::array<std::vector<long>, 2> lines;
  for (ring& points : r)
    for (point& p : points)
      for (const std::size_t k : {0U, 1U}) {
        while (static_cast<long>(lines[k].size()) <= p[k]) lines[k].push_back((lines[k].empty() ? 0 : lines[k].back()) + roll.between(100, 1000));
        p[k] = lines[k][static_cast<std::size_t>(p[k])];
      }
  return r;
}

/// Returns the polygon of rectilinear with all vertices jittered: holes, arms and bays in general
/// position.
inline region jittered_cells(int n, std::uint64_t seed) {
  region r = rectilinear(n, seed);
  dice roll(seed + 1);
  for (ring& points : r)
    for (point& p : points) p = jittered({1000 * p[0], 1000 * p[1]}, 300, roll);
  return r;
}

/// Returns the outline of random cells that may touch in a point: rings are simple, but may share
/// vertices with one another, never edges. The interior is connected without such points. About n
/// vertices.
/// *Requires* n >= 4.
/// *Complexity* O(n log n).
inline region touching_cells(int n, std::uint64_t seed) { return random_cells(std::max(n, 4), true, seed).outline(); }

}  // namespace osteon::plane::models
