// SPDX-License-Identifier: MIT

// What a user of the kernels writes: the skeleton of a cube from doubles in memory.

#include <cstdio>

#include "osteon/input/solid.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"

int main() {
  using namespace osteon;
  const auto mesh = make_input_mesh<integer>({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                                             {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  const auto cube = make_solid(mesh);
  const perturbed kernel(filtered(std::span<const moving_plane<integer>>(cube.planes), make_sqrt_kernel(cube.planes)));
  const auto raw = straight_skeleton(kernel, cube.boundary);
  const auto exact = contract(kernel.base(), cube.boundary, raw);
  std::printf("%zu nodes, %zu arcs, %zu sheets\n", exact.nodes.size(), exact.arcs.size(), exact.sheets.size());
  return exact.nodes.size() == 9 && exact.arcs.size() == 8 && exact.sheets.size() == 12 ? 0 : 1;
}
