// SPDX-License-Identifier: MIT

// What a user of the front door writes: the skeleton of a square.

#include <cstdio>
#include <osteon/inspect.hpp>
#include <osteon/osteon.hpp>

int main() {
  const auto s = osteon::skeletonize(osteon::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  std::printf("%zu nodes, %zu arcs, %zu faces\n", s.nodes().size(), s.arcs().size(), s.faces().size());
  return s.nodes().size() == 5 && s.arcs().size() == 4 && s.faces().size() == 4 && !s.verify() && osteon::version().size() >= 5 ? 0 : 1;
}
