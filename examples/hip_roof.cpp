// SPDX-License-Identifier: MIT

/// \file
/// A house from its outline: walls, and a hip roof that rises from every edge at the same angle.
///   hip_roof FILE [DEGREES [GABLE]] DEGREES is the angle of the roof, 45 unless given. GABLE is
///   the number of the point in the file, counted from 1, where the edge starts whose wall goes up
///   to the ridge instead: that edge gets the weight 0, it does not move. The house comes as OBJ,
///   its sizes on standard error.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "example.hpp"

namespace {

/// Twice the area of a flat facet, as a vector, from triangles; and six times the volume between it
/// and the origin.
std::array<double, 4> measure(const osteon::mesh& m, const std::vector<int>& facet) {
  std::array<double, 4> sum{};
  const auto& o = m.points[facet[0]];
  for (std::size_t i = 1; i + 1 < facet.size(); ++i) {
    const auto& a = m.points[facet[i]];
    const auto& b = m.points[facet[i + 1]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3;
      const std::size_t z = (axis + 2) % 3;
      const double x = (a[y] - o[y]) * (b[z] - o[z]) - (a[z] - o[z]) * (b[y] - o[y]);
      sum[axis] += x;
      sum[3] += x * o[axis];
    }
  }
  return sum;
}

void report(const osteon::mesh& m) {
  double ridge = 0;
  double area = 0;
  double volume = 0;
  for (const auto& p : m.points) ridge = std::max(ridge, p[2]);
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const auto x = measure(m, m.facets[f]);
    // a gable is upright
    if (m.kinds[f] == osteon::facet_kind::roof && x[2] > 0) area += std::hypot(x[0], x[1], x[2]) / 2;
    volume += x[3] / 6;
  }
  std::fprintf(stderr, "ridge at %.10g, %.10g of roof to cover, volume %.10g\n", ridge, area, volume);
}

}  // namespace

int main(int argc, char** argv) {
  const double degrees = argc > 2 ? std::atof(argv[2]) : 45;
  if (argc < 2 || argc > 4 || !(degrees > 0 && degrees < 90)) {
    std::fprintf(stderr, "usage: hip_roof FILE [DEGREES [GABLE]], with DEGREES between 0 and 90\n");
    return 2;
  }
  return example::run([&] {
    osteon::polygon outline = example::read(argv[1]);
    if (argc > 3) {
      const int gable = std::atoi(argv[3]);
      if (gable < 1 || gable > outline.edges())
        throw osteon::input_error(osteon::input_fault::bad_index, 0, "there is no such point to start a gable",
                                  "count the points of the file from 1");
      outline.set_weight(gable - 1, 0);
    }
    const double slope = std::tan(degrees * std::atan(1.0) / 45);
    const osteon::mesh house = osteon::skeletonize(outline).roof({.slope = slope, .eaves = 3, .walls = true});
    osteon::write_obj(std::cout, house);
    report(house);
  });
}
