// SPDX-License-Identifier: MIT

// What a user of the algorithms alone writes, with numbers of their own: here those of the machine, to check a polygon.

#include <cstdio>
#include <osteon/input/make_polygon.hpp>
#include <osteon/input/read_polygon.hpp>
#include <osteon/models/polyhedra.hpp>
#include <osteon/space/propagate.hpp>
#include <sstream>

int main() {
  std::istringstream text("0 0\n4 0\n4 3\n0 3\n");
  const auto rings = osteon::plane::read_xy<long>(text, "text");
  const auto cube = osteon::models::box(1, 1, 1).take<long>();
  std::printf("%zu points, %zu facets\n", rings.all[0].points.size(), cube.facets.size());
  return rings.all[0].points.size() == 4 && cube.facets.size() == 6 ? 0 : 1;
}
