// SPDX-License-Identifier: MIT

// Thesis 3.4: a split is valid iff its spherical skeleton does not cross itself or the spherical polygon.

#include "osteon/evaluate/spherical.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "corners.hpp"
#include "osteon/kernel/rational.hpp"

namespace osteon::test {
namespace {

using vector = spherical_skeleton::vector;

// Whether two short pieces of great circles cross.
bool cross(const vector& a, const vector& b, const vector& c, const vector& d) {
  if (local::dot(a, c) < 0) return false;
  const auto side = [](const vector& p, const vector& q, const vector& r) { return local::dot(local::cross(p, q), r) > 0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool cross(const spherical_skeleton::arc& x, const spherical_skeleton::arc& y) {
  for (const int n : x.nodes)
    if (n == y.nodes[0] || n == y.nodes[1]) return false;
  for (std::size_t i = 1; i < x.points.size(); ++i)
    for (std::size_t j = 1; j < y.points.size(); ++j)
      if (cross(x.points[i - 1], x.points[i], y.points[j - 1], y.points[j])) return true;
  return false;
}

TEST(Spherical, SkeletonsWithoutCrossingsAreTheValidOnes) {
  std::array<int, 2> seen = {0, 0};
  for (int k = 4; k <= 8; ++k)
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      const auto c = make_corner(k, static_cast<std::uint64_t>(1000 * k) + seed);
      if (!c) continue;
      const auto kernel = make_rational_kernel(c->planes);
      const splitter trees(kernel, c->of);
      for (const split_tree& t : trees.candidates()) {
        const auto s = make_spherical_skeleton(c->planes, c->of, t);
        bool crosses = false;
        for (std::size_t x = 0; x < s.arcs.size(); ++x)
          for (std::size_t y = 0; y < x; ++y) crosses = crosses || cross(s.arcs[x], s.arcs[y]);
        ASSERT_EQ(!crosses, trees.valid(t));
        ++seen[crosses ? 0 : 1];
      }
    }
  EXPECT_GE(seen[0], 100);
  EXPECT_GE(seen[1], 400);
}

TEST(Spherical, PartsAreCutAtTheHorizon) {
  const auto c = make_corner(7, 7001);
  ASSERT_TRUE(c);
  const auto kernel = make_rational_kernel(c->planes);
  const auto t = splitter(kernel, c->of).best(split_preference::convex);
  ASSERT_TRUE(t);
  const auto s = make_spherical_skeleton(c->planes, c->of, *t);
  EXPECT_EQ(s.nodes.size(), 7U + 5U);
  EXPECT_EQ(s.arcs.size(), 7U + 11U);
  const vector eye = {0.6, 0, 0.8};
  int cuts = 0;
  for (const auto& a : s.arcs) {
    const auto parts = parts_of(a, eye);
    std::size_t points = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      points += parts[i].points.size();
      for (const vector& p : parts[i].points) {
        EXPECT_NEAR(local::dot(p, p), 1, 1e-12);
        EXPECT_GE(local::dot(p, eye) * (parts[i].front ? 1 : -1), -1e-12);
      }
      if (i == 0) continue;
      ++cuts;
      EXPECT_NE(parts[i].front, parts[i - 1].front);
      EXPECT_EQ(parts[i].points.front(), parts[i - 1].points.back());
      EXPECT_NEAR(local::dot(parts[i].points.front(), eye), 0, 1e-12);
    }
    EXPECT_EQ(points, a.points.size() + 2 * (parts.size() - 1));
  }
  EXPECT_GT(cuts, 0);
}

}  // namespace
}  // namespace osteon::test
