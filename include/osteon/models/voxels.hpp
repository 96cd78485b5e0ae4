// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids of unit cubes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "osteon/models/mesh_builder.hpp"

namespace osteon::models {

/// A grid of unit cubes, full or empty; everything outside is empty.
class voxels {
 public:
  /// Makes an empty grid of so many cubes along x, y and z.
  explicit voxels(std::array<int, 3> size) : size_(size), full_(static_cast<std::size_t>(size[0]) * size[1] * size[2]) {}

  /// Returns the numbers of cubes along x, y and z.
  const std::array<int, 3>& size() const { return size_; }
  /// Returns whether a cube is full.
  bool operator()(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < size_[0] && y < size_[1] && z < size_[2] && full_[index(x, y, z)];
  }
  /// Makes a cube full or empty.
  /// *Requires* a cube of the grid.
  void set(int x, int y, int z, bool full) { full_[index(x, y, z)] = full; }
  /// Returns how many cubes are full.
  long count() const {
    long n = 0;
    for (const bool b : full_) n += b ? 1 : 0;
    return n;
  }

  /// Fills cubes until the surface is a manifold: no edge of four facets, no point where two fans
  /// meet.
  void mend() {
    for (bool changed = true; changed;) {
      changed = false;
      for (int x = 0; x <= size_[0]; ++x)
        for (int y = 0; y <= size_[1]; ++y)
          for (int z = 0; z <= size_[2]; ++z) changed = mend_at({x, y, z}) || changed;
    }
  }

  /// Returns the surface as unit squares.
  builder surface() const {
    builder b;
    for (int x = 0; x < size_[0]; ++x)
      for (int y = 0; y < size_[1]; ++y)
        for (int z = 0; z < size_[2]; ++z) {
          if (!(*this)(x, y, z)) continue;
          for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
              std::array<int, 3> next = {x, y, z};
              next[axis] += side == 1 ? 1 : -1;
              if (!(*this)(next[0], next[1], next[2])) b.facet(square({x, y, z}, axis, side));
            }
        }
    return b;
  }

 private:
  std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(x) * size_[1] + y) * size_[2] + z; }

  static std::vector<point> square(const std::array<int, 3>& cube, int axis, int side) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<point> corners;
    for (const auto& [du, dv] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      point p = {cube[0], cube[1], cube[2]};
      p[axis] += side;
      p[u] += side == 1 ? du : dv;  // counter-clockwise seen from outside
      p[v] += side == 1 ? dv : du;
      corners.push_back(p);
    }
    return corners;
  }

  // Looks at the eight cubes around a grid point.
  bool mend_at(const std::array<int, 3>& p) {
    const auto full = [&](int corner) { return (*this)(p[0] - 1 + (corner & 1), p[1] - 1 + (corner >> 1 & 1), p[2] - 1 + (corner >> 2)); };
    const auto fill = [&](int corner) {
      const std::array<int, 3> c = {p[0] - 1 + (corner & 1), p[1] - 1 + (corner >> 1 & 1), p[2] - 1 + (corner >> 2)};
      for (int axis = 0; axis < 3; ++axis)
        if (c[axis] < 0 || c[axis] >= size_[axis]) return false;
      if ((*this)(c[0], c[1], c[2])) return false;
      set(c[0], c[1], c[2], true);
      return true;
    };
    for (int a = 0; a < 3; ++a)
      for (const int rest : {0, 1 << a}) {
        const int u = 1 << (a + 1) % 3;
        const int v = 1 << (a + 2) % 3;
        if (full(rest) && full(rest | u | v) && !full(rest | u) && !full(rest | v)) return fill(rest | u) || fill(rest | v);
        if (full(rest | u) && full(rest | v) && !full(rest) && !full(rest | u | v)) return fill(rest) || fill(rest | u | v);
      }
    int number = 0;
    for (int c = 0; c < 8; ++c) number += full(c) ? 1 : 0;
    for (int c = 0; c < 4; ++c) {
      if (number == 2 && full(c) && full(7 - c)) return fill(c ^ 1) || fill(c ^ 2) || fill(c ^ 4);
      if (number == 6 && !full(c) && !full(7 - c)) return fill(c) || fill(7 - c);
    }
    return false;
  }

  std::array<int, 3> size_;
  std::vector<bool> full_;
};

/// Returns a random solid of cubes: each is full with the given chance in percent, then the surface
/// is mended. It may have tunnels, voids and several bodies, and majority corners. Never empty.
inline voxels random_voxels(std::array<int, 3> size, int percent, std::uint64_t seed) {
  dice roll(seed);
  voxels v(size);
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) v.set(x, y, z, roll.between(0, 99) < percent);
  if (v.count() == 0) v.set(0, 0, 0, true);
  v.mend();
  return v;
}

}  // namespace osteon::models
