// A plan's skeleton, offsets, roof and certificate.
#include <iostream>
#include <osteon/osteon.hpp>

int main() {
  osteon::polygon plan({{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 9}, {0, 9}});
  plan.set_weight(4, 0);  // the edge that starts at point 4 stands still: a gable
  const auto s = osteon::skeletonize(plan);
  for (const auto arc : s.arcs()) std::cout << arc.source().point()[0] << " to " << arc.target().point()[0] << '\n';
  for (const auto& left : s.offsets({0.5, "1.25"})) std::cout << left.rings.size() << " rings\n";
  write_obj(std::cout, s.roof({.slope = 0.8, .eaves = 3, .walls = true}));
  if (const auto refuted = s.verify()) std::cout << refuted->rule << ": " << refuted->witness << '\n';
}
