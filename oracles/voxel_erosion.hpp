// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The volume of an eroded voxel solid by counting: for axis-parallel solids the offset is the erosion in the maximum
/// norm. Shares no code with the library.

#include <array>
#include <functional>
#include <vector>

namespace osteon::oracles {

/// Number of cells of side 1/q that are left when everything within distance p/q (maximum norm) of the outside is
/// removed from a solid of unit cubes. The volume is this number over q^3. Exact; time and memory size * q^3.
inline long eroded_cells(const std::array<int, 3>& size, const std::function<bool(int, int, int)>& full, int p, int q) {
  const std::array<int, 3> n = {size[0] * q, size[1] * q, size[2] * q};
  const auto at = [&n](int x, int y, int z) { return (static_cast<std::size_t>(x) * n[1] + y) * n[2] + z; };
  std::vector<char> solid(static_cast<std::size_t>(n[0]) * n[1] * n[2]);
  for (int x = 0; x < n[0]; ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z) solid[at(x, y, z)] = full(x / q, y / q, z / q) ? 1 : 0;
  // A cell stays iff all cells in the cube of 2p + 1 cells around it are solid: one axis after the other.
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < n[u]; ++i)
      for (int j = 0; j < n[v]; ++j) {
        const auto cell = [&](int k) {
          std::array<int, 3> c{};
          c[axis] = k;
          c[u] = i;
          c[v] = j;
          return at(c[0], c[1], c[2]);
        };
        std::vector<int> run(n[axis] + 1, 0);  // solid cells that end just before
        for (int k = 0; k < n[axis]; ++k) run[k + 1] = solid[cell(k)] != 0 ? run[k] + 1 : 0;
        for (int k = 0; k < n[axis]; ++k) solid[cell(k)] = k + p < n[axis] && run[k + p + 1] >= 2 * p + 1 ? 1 : 0;
      }
  }
  long count = 0;
  for (const char c : solid) count += c;
  return count;
}

}  // namespace osteon::oracles
