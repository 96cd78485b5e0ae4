// SPDX-License-Identifier: MIT

// Sorting numbers through the skeleton: the reduction that proves the lower bound n log n for polygons with holes (thesis 2.7.2). A small triangle
// stands for each number, on a line below the upper side of a box; along the upper side's face the triangles come in order.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/models/polygons.hpp"
#include "osteon/plane/propagate.hpp"

namespace osteon {
namespace {

plane::polygon<integer> box_with_triangles(const std::vector<long>& numbers) {
  const long right = 100 * *std::max_element(numbers.begin(), numbers.end()) + 1000;
  plane::models::region r = {{{-1000, -2000}, {right, -2000}, {right, 0}, {-1000, 0}}};
  for (const long x : numbers) r.push_back({{100 * x, -20}, {100 * x + 10, -40}, {100 * x - 10, -40}});
  return plane::make_polygon(plane::models::take<integer>(r));
}

// The numbers whose triangles lie along the face of edge 2, from its head to its tail.
std::vector<long> sorted_by_skeleton(const std::vector<long>& numbers) {
  const auto p = box_with_triangles(numbers);
  const std::span<const moving_line<integer>> lines(p.lines);
  const perturbed k(filtered(lines, make_sqrt_kernel(lines)));
  const plane::vertex_enclosures motion(lines, p.points);
  const plane::skeleton s = plane::propagation(k, p.boundary, motion).run();
  constexpr int top = 2;
  std::map<int, std::vector<int>> at;  // arcs of the face by node
  for (int a = 0; a < static_cast<int>(s.arcs.size()); ++a)
    if (s.arcs[a].faces[0] == top || s.arcs[a].faces[1] == top)
      for (const int n : {s.arcs[a].source, s.arcs[a].target}) at[n].push_back(a);
  std::vector<long> result;
  int node = 3;  // the upper left corner, where edge 2 ends
  for (int arc = at.at(node).front();;) {
    const int beside = s.arcs[arc].faces[s.arcs[arc].faces[0] == top ? 1 : 0];
    if (beside >= 4) {
      const long x = numbers[(p.input_points[beside] - 4) / 3];
      if (result.empty() || result.back() != x) result.push_back(x);
    }
    node = s.arcs[arc].source == node ? s.arcs[arc].target : s.arcs[arc].source;
    const auto& next = at.at(node);
    if (next.size() == 1) return result;  // the other corner
    arc = next[next[0] == arc ? 1 : 0];
  }
}

TEST(planar_sorting, the_upper_face_names_the_numbers_in_order) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    plane::models::dice dice(seed);
    std::vector<long> numbers(static_cast<std::size_t>(dice.between(1, 200)));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<long>(i) * 7 + dice.between(0, 5);
    for (std::size_t i = numbers.size(); i > 1; --i)
      std::swap(numbers[i - 1], numbers[static_cast<std::size_t>(dice.between(0, static_cast<long>(i) - 1))]);
    auto expected = numbers;
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(sorted_by_skeleton(numbers), expected);
  }
}

}  // namespace
}  // namespace osteon
