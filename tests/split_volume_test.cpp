// SPDX-License-Identifier: MIT

// The questions that only kernels of space answer: volumes of splits and angles of edges.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "kernel_planes.hpp"
#include "osteon/space/split.hpp"

namespace osteon::laws {
namespace {

// A corner as the graph of a function: edges at ascending angles with random slopes. Its planes pass through the origin.
struct random_corner {
  planes_in<3> p;
  corner c;
};

random_corner make_corner(dice& r, int degree, bool pythagorean = false) {
  static constexpr std::array<std::array<int, 2>, 8> around = {{{7, 0}, {5, 5}, {0, 7}, {-5, 5}, {-7, 0}, {-5, -5}, {0, -7}, {5, -5}}};
  for (;;) {
    std::vector<vector_in<3>> edges;
    for (int e = 0; e < degree; ++e) {
      const auto& a = around[degree <= 4 ? 2 * e : e];
      const int jitter = pythagorean ? 0 : 1;
      edges.push_back({integer(a[0] + r.between(-jitter, jitter)), integer(a[1] + r.between(-jitter, jitter)), integer(r.between(-6, 6))});
    }
    random_corner result;
    for (int m = 0; m < degree; ++m) {
      const vector_in<3>& x = edges[m];
      const vector_in<3>& y = edges[(m + 1) % degree];
      const vector_in<3> n = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
      result.p.push_back({n, integer(0)});
      result.c.facets.push_back(m);
    }
    bool generic_corner = true;
    for (int m = 0; m < degree; ++m) {
      const integer below = dot(result.p[m].n, edges[(m + 2) % degree]);
      result.c.convex.push_back(below < 0);
      generic_corner = generic_corner && below != 0;
      for (int a = 0; a < m; ++a)
        for (int b = 0; b < a; ++b) generic_corner = generic_corner && true_orientation<3>(result.p, {m, a, b}) != sign::zero;
    }
    if (generic_corner) return result;
  }
}

std::vector<triple> triangles(const split_tree& t) { return {t.vertices.begin(), t.vertices.end()}; }

TEST(Volume, OrderOfTreesAndAgreement) {
  dice r(1100);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    const random_corner x = make_corner(r, r.between(4, 7));
    const auto exact = make_sqrt_kernel(x.p);
    const auto rounded = make_rational_kernel(x.p);
    const auto machine = make_double_kernel(x.p);
    std::vector<std::vector<triple>> trees;
    for_each_triangulation(x.c.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
      if (trees.size() == 8) return;
      trees.emplace_back();  // of all triangulations, whether a boundary or not: the formula is the same
      const auto joined = [&](int a, int b) {
        return b == a + 1 || (a == 0 && b == x.c.degree() - 1) || std::find(diagonals.begin(), diagonals.end(), std::pair(a, b)) != diagonals.end();
      };
      for (int a = 0; a < x.c.degree(); ++a)
        for (int b = a + 1; b < x.c.degree(); ++b)
          for (int c = b + 1; c < x.c.degree(); ++c)
            if (joined(a, b) && joined(b, c) && joined(a, c)) trees.back().push_back({a, b, c});
      ASSERT_EQ(static_cast<int>(trees.back().size()), x.c.degree() - 2);
    });
    const std::size_t n = trees.size();
    std::vector<std::vector<sign>> order(n, std::vector<sign>(n));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        order[a][b] = exact.compare_volume(trees[a], trees[b]);
        EXPECT_EQ(order[a][b] == sign::zero, a == b);
        EXPECT_EQ(rounded.compare_volume(trees[a], trees[b]), order[a][b]);
        if (a != b) {
          EXPECT_EQ(machine.compare_volume(trees[a], trees[b]), order[a][b]);
        }
        ++compared;
      }
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        EXPECT_EQ(order[a][b], -order[b][a]);
        for (std::size_t c = 0; c < n; ++c) {
          if (order[a][b] == sign::negative && order[b][c] == sign::negative) {
            EXPECT_EQ(order[a][c], sign::negative);
          }
        }
      }
  }
  EXPECT_GT(compared, 500);
}

// The two ways to split four planes differ by the tetrahedron between them, whose signed volume is -S^3 / (6 l0 l1 l2 l3)
// at time one; it is empty where the planes keep a common point.
TEST(Volume, TwoTreesOfFourPlanesDifferByATetrahedron) {
  for (const family f : {family::small, family::pythagorean, family::symmetric, family::doubled, family::weighted, family::long_normals}) {
    SCOPED_TRACE(trace(f));
    dice r(1200 + static_cast<std::uint64_t>(f));
    int seen = 0;
    for (int round = 0; round < 400 && seen < 60; ++round) {
      const planes_in<3> p = random_planes<3>(f, 4, r, true);
      const auto k = make_sqrt_kernel(p);
      sign tetrahedron = -k.closing_at(0, {0, 1, 2, 3});
      bool corners = true;
      for (int s = 0; s < 4; ++s) {
        corners = corners && lambda_of(k, quadruple{0, 1, 2, 3}, s) != sign::zero;
        tetrahedron = tetrahedron * lambda_of(k, quadruple{0, 1, 2, 3}, s);
      }
      if (!corners) continue;
      ++seen;
      const std::vector<triple> s = {{0, 1, 2}, {0, 2, 3}};
      const std::vector<triple> t = {{0, 1, 3}, {1, 2, 3}};
      EXPECT_EQ(k.compare_volume(s, t), tetrahedron);
      EXPECT_EQ(with_filter<roots<3>>{}(p).compare_volume(t, s), -tetrahedron);
      if (rational_lengths(f)) {
        EXPECT_EQ(make_rational_kernel(p).compare_volume(s, t), tetrahedron);
      }
    }
    EXPECT_GE(seen, 30);
  }
}

TEST(Volume, TheReflexSplitOfASaddleIsTheSmaller) {
  dice r(1300);
  int saddles = 0;
  for (int round = 0; round < 500 && saddles < 60; ++round) {
    const random_corner x = make_corner(r, 4);
    const auto k = make_sqrt_kernel(x.p);
    std::vector<split_tree> trees;
    try {
      trees = splitter<sqrt_kernel>(k, x.c).all();
    } catch (const degenerate_error&) {
      continue;  // S = 0
    }
    ASSERT_FALSE(trees.empty());
    if (trees.size() != 2) continue;
    ++saddles;
    ASSERT_NE(trees[0].convex_edges(), trees[1].convex_edges());
    if (trees[0].convex_edges() == 0) std::swap(trees[0], trees[1]);
    EXPECT_EQ(k.compare_volume(triangles(trees[1]), triangles(trees[0])), sign::negative);
    const splitter<sqrt_kernel> split(k, x.c);
    EXPECT_EQ(split.best(split_preference::min_volume)->convex_edges(), 0);
    EXPECT_EQ(split.best(split_preference::max_volume)->convex_edges(), 1);
  }
  EXPECT_GE(saddles, 20);
}

TEST(Angle, SortsLikeTheArcCosine) {
  for (const family f : {family::small, family::pythagorean, family::symmetric, family::long_normals}) {
    SCOPED_TRACE(trace(f));
    dice r(1400 + static_cast<std::uint64_t>(f));
    const planes_in<3> p = random_planes<3>(f, 14, r);
    const auto k = make_sqrt_kernel(p);
    const auto machine = make_double_kernel(p);
    const auto angle = [&](plane_id a, plane_id b) {
      const auto real = [](const integer& x) { return to_double(x, 0); };
      return std::acos(
          std::clamp(real(dot(p[a].n, p[b].n)) / std::sqrt(real(dot(p[a].n, p[a].n))) / std::sqrt(real(dot(p[b].n, p[b].n))), -1.0, 1.0));
    };
    for (int i = 0; i < 2000; ++i) {
      const quadruple q = r.distinct<4>(14);
      const double difference = angle(q[0], q[1]) - angle(q[2], q[3]);
      const sign s = k.compare(k.bisector(q[0], q[1]), k.bisector(q[2], q[3]));
      if (std::abs(difference) > 1e-6) {
        EXPECT_EQ(s, signed_if(difference > 0));
        EXPECT_EQ(machine.compare(machine.bisector(q[0], q[1]), machine.bisector(q[2], q[3])), s);
      }
      if (s == sign::zero) {
        EXPECT_LT(std::abs(difference), 1e-6);
      }
      EXPECT_EQ(k.compare(k.bisector(q[0], q[1]), k.bisector(q[1], q[0])), sign::zero);
    }
  }
}

}  // namespace
}  // namespace osteon::laws
