// A solid's skeleton, an offset, its certificate.
#include <iostream>
#include <osteon/osteon.hpp>

int main(int, char** argv) {
  const auto s = osteon::skeletonize(osteon::read_polyhedron(argv[1]), {.prefer = osteon::split_preference::min_volume});
  for (const auto node : s.nodes()) std::cout << node.time() << ' ' << node.time_exact(30) << '\n';
  write_obj(std::cout, s.offset(0.1));
  return s.verify() ? 1 : 0;
}
