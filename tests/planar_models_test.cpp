// SPDX-License-Identifier: MIT

// The generated polygons are what they promise, and so is the supply of samples for other tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/solid.hpp"
#include "osteon/input/write_xy.hpp"
#include "osteon/models/polygons.hpp"
#include "osteon/models/registry.hpp"
#include "planar_polygons.hpp"

namespace osteon::test {
namespace {

namespace models = plane::models;
using models::region;

std::size_t vertices(const region& r) {
  std::size_t n = 0;
  for (const auto& points : r) n += points.size();
  return n;
}

bool axis_parallel(const region& r) {
  for (const auto& points : r)
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
      if (points[i][0] != points[j][0] && points[i][1] != points[j][1]) return false;
  return true;
}

const models::kind& kind_of(const std::string& name) {
  for (const auto& k : models::kinds())
    if (k.name == name) return k;
  throw std::invalid_argument(name);
}

// ---- the check itself: it must refuse

TEST(FaultOf, TakesWhatIsValid) {
  EXPECT_EQ(fault_of({{{0, 0}, {1, 0}, {0, 1}}}), "");
  EXPECT_EQ(fault_of({{{0, 0}, {1, 0}, {2, 0}, {2, 2}}}), "");  // a straight angle
  EXPECT_EQ(fault_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}), "");
  EXPECT_EQ(fault_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{0, 0}, {3, 6}, {6, 3}}}, true), "");
}

TEST(FaultOf, RefusesWhatIsNot) {
  const models::ring square = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const std::vector<std::pair<std::string, region>> wrong = {
      {"nothing", {}},
      {"two points", {{{0, 0}, {1, 0}}}},
      {"a repeated point", {{{0, 0}, {9, 0}, {9, 0}, {0, 9}}}},
      {"clockwise", {{{0, 0}, {0, 1}, {1, 0}}}},
      {"a bow tie", {{{0, 0}, {9, 9}, {9, 0}, {0, 8}}}},
      {"no area", {{{0, 0}, {5, 0}, {9, 0}}}},
      {"a spike", {{{0, 0}, {9, 0}, {5, 0}, {5, 5}}}},
      {"a vertex on an edge", {{{0, 0}, {9, 0}, {9, 9}, {5, 0}, {0, 9}}}},
      {"a vertex on a vertex", {{{0, 0}, {4, 4}, {9, 0}, {9, 9}, {4, 4}, {0, 9}}}},
      {"edges that overlap", {{{0, 0}, {9, 0}, {9, 9}, {7, 9}, {7, 0}, {3, 0}, {3, 9}, {0, 9}}}},
      {"a hole like a body", {square, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}},
      {"a hole outside", {square, {{13, 3}, {13, 6}, {16, 6}, {16, 3}}}},
      {"a hole across", {square, {{3, 3}, {3, 6}, {16, 6}, {16, 3}}}},
      {"a hole in a hole", {square, {{2, 2}, {2, 8}, {8, 8}, {8, 2}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}},
      {"a hole that touches", {square, {{0, 0}, {3, 6}, {6, 3}}}},
  };
  for (const auto& [what, r] : wrong) EXPECT_NE(fault_of(r), "") << what;
  EXPECT_NE(fault_of({square, {{0, 0}, {0, 6}, {6, 3}}}, true), "") << "touching rings that share an edge";
  EXPECT_NE(fault_of({square, {{0, 4}, {3, 6}, {6, 3}}}, true), "") << "a vertex on an edge, where only vertices may touch";
}

// ---- every kind

class PlanarModels : public testing::TestWithParam<std::string> {};

TEST_P(PlanarModels, AreValidForEverySize) {
  const auto& k = kind_of(GetParam());
  const bool by_side = k.greatest_size < 10'000'000;
  const std::vector<int> sizes =
      by_side ? std::vector{1, 2, 3, 5, 9, 20} : std::vector{3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 16, 19, 24, 31, 50, 100, 257, 400, 2000};
  for (const int size : sizes)
    for (std::uint64_t seed = 1; seed <= (size < 50 ? 40U : 4U); ++seed) {
      if (size < k.least_size) continue;
      SCOPED_TRACE(k.name + " of size " + std::to_string(size) + ", seed " + std::to_string(seed));
      const region r = k.make(size, seed);
      ASSERT_EQ(fault_of(r, k.touching), "");
      ASSERT_EQ(r, k.make(size, seed)) << "equal seeds, equal polygons";
      const auto n = static_cast<int>(vertices(r));
      const int promised = by_side ? 4 * size * size + 4 : size;
      const bool about = k.name.find("cells") != std::string::npos || k.name == "rectilinear";
      ASSERT_GE(n, promised - (k.name == "random-with-holes" ? promised / 2 : 3));
      ASSERT_LE(n, promised + (about ? 4 : 0));
    }
}

TEST_P(PlanarModels, TakeTheLeastSizeForSmallerOnes) {
  const auto& k = kind_of(GetParam());
  EXPECT_GE(k.default_size, k.least_size);
  EXPECT_LE(k.default_size, k.greatest_size);
  EXPECT_EQ(fault_of(k.make(k.default_size, 1), k.touching), "");
  for (const int size : {-5, 0, 1, 2}) EXPECT_EQ(fault_of(k.make(size, 7), k.touching), "") << k.name << " of size " << size;
}

INSTANTIATE_TEST_SUITE_P(Kinds, PlanarModels, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& k : models::kinds()) names.push_back(k.name);
                           return names;
                         }()),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(PlanarModel, SeedsMatter) {
  for (const char* name : {"noisy-star", "noisy-loop", "comb", "spiral", "random", "random-with-holes", "jittered-holes", "hilbert", "jittered-cells",
                           "rectilinear", "stretched-cells", "touching-cells", "symmetric"})
    EXPECT_NE(kind_of(name).make(40, 1), kind_of(name).make(40, 2)) << name;
}

TEST(PlanarModel, SomeAreAxisParallel) {
  for (const char* name : {"rectilinear-hilbert", "rectilinear", "touching-cells", "grid-of-holes", "staircase"})
    EXPECT_TRUE(axis_parallel(kind_of(name).make(40, 1))) << name;
  for (const char* name : {"hilbert", "jittered-cells"}) EXPECT_FALSE(axis_parallel(kind_of(name).make(40, 1))) << name;
}

TEST(PlanarModel, RandomCellsHaveTheirArea) {
  for (const bool touching : {false, true})
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const auto grid = models::random_cells(200, touching, seed);
      wide cells = 0;
      for (int y = 1; y <= grid.width(); ++y)
        for (int x = 1; x <= grid.width(); ++x) cells += grid(x, y) ? 1 : 0;
      const region r = grid.outline();
      wide area = 0;
      for (const auto& points : r) area += doubled_area(points);
      ASSERT_TRUE(area == 2 * cells) << "seed " << seed;
      for (const auto& points : r)  // every vertex is a corner
        for (std::size_t i = 0; i < points.size(); ++i)
          ASSERT_NE(turn_sign(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]), 0) << "seed " << seed;
    }
}

TEST(PlanarModel, RandomCellsTouchAndHaveHoles) {
  int touching = 0;
  int holes = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    touching += fault_of(models::touching_cells(60, seed)).empty() ? 0 : 1;
    holes += static_cast<int>(models::rectilinear(60, seed).size()) - 1;
  }
  EXPECT_GT(touching, 10);
  EXPECT_GT(holes, 5);
}

TEST(PlanarModel, SymmetricStarsAreSymmetric) {
  for (const int n : {4, 8, 12, 40, 400})
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto points = models::symmetric(n, seed)[0];
      const std::set<models::point> all(points.begin(), points.end());
      for (const auto& [x, y] : points) {
        EXPECT_TRUE(all.count({y, x}) == 1 && all.count({-x, y}) == 1) << n << ", seed " << seed;
      }
    }
}

TEST(PlanarModel, RegularPolygonsAreStrictlyConvex) {
  for (const int n : {3, 5, 6, 12, 100, 999, 5000}) {
    const auto points = models::regular(n)[0];
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_GT(turn_sign(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]), 0) << n;
  }
}

TEST(PlanarModel, RandomPolygonsHaveTheHolesAskedFor) {
  int holes = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto r = models::random_with_holes(100, 5, seed);
    EXPECT_LE(r.size(), 6U);
    EXPECT_LE(vertices(r), 100U);
    holes += static_cast<int>(r.size()) - 1;
  }
  EXPECT_GE(holes, 90);
}

TEST(PlanarModel, LargeOnesAreValid) {
  for (const auto& k : models::kinds()) {
    const int size = k.greatest_size < 10'000'000 ? 40 : 20'000;
    EXPECT_EQ(fault_of(k.make(size, 5), k.touching), "") << k.name;
  }
}

TEST(PlanarModel, HilbertPointsFillTheSquare) {
  std::set<models::point> all;
  for (long i = 0; i < 256; ++i) {
    const auto p = models::hilbert_point(i, 4);
    all.insert(p);
    EXPECT_TRUE(p[0] >= 0 && p[1] >= 0 && p[0] < 16 && p[1] < 16);
    const auto q = models::hilbert_point(i + 1, 4);
    EXPECT_TRUE(i == 255 || std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) == 1) << i;
  }
  EXPECT_EQ(all.size(), 256U);
}

TEST(PlanarModel, IsTakenAndWritten) {
  const region r = models::grid_of_holes(1);
  std::ostringstream text;
  plane::write_xy(text, r);
  EXPECT_EQ(text.str(), "0 0\n3 0\n3 3\n0 3\n\n1 1\n1 2\n2 2\n2 1\n");
  const auto rings = models::take<integer>(r);
  ASSERT_EQ(rings.all.size(), 2U);
  ASSERT_EQ(rings.all[1].points.size(), 4U);
  EXPECT_EQ(rings.all[1].points[1][1].mantissa, 2);
  EXPECT_EQ(rings.all[1].points[1][1].ten, 0);
  EXPECT_TRUE(rings.all[0].weights.empty());
}

// ---- the registry

TEST(Registry, NamesAreDifferent) {
  std::set<std::string> names;
  for (const auto& k : osteon::models::kinds()) EXPECT_TRUE(names.insert(k.name).second) << k.name;
  for (const auto& k : models::kinds()) EXPECT_TRUE(names.insert(k.name).second) << k.name;
  for (const auto& k : osteon::models::kinds()) EXPECT_EQ(osteon::models::find_kind(osteon::models::kinds(), k.name), &k);
  EXPECT_EQ(osteon::models::find_kind(models::kinds(), "cube"), nullptr);
  EXPECT_EQ(osteon::models::find_kind(osteon::models::kinds(), "comb"), nullptr);
}

TEST(Registry, PolyhedraAreSolidsFromTheLeastSizeOn) {
  for (const auto& k : osteon::models::kinds()) {
    EXPECT_LE(k.least_size, k.default_size) << k.name;
    EXPECT_LE(k.default_size, k.greatest_size) << k.name;
    EXPECT_FALSE(k.size.empty()) << k.name;
    for (const int size : {k.least_size, k.least_size + 1, k.default_size})
      EXPECT_NO_THROW(make_solid(k.make(size, 3).take<integer>())) << k.name << " of size " << size;
  }
}

// ---- the samples of other tests

TEST(Samples, AreValidAndVaried) {
  for (const shape s : {shape::general, shape::holes, shape::coarse, shape::rectilinear, shape::symmetric, shape::touching}) {
    std::size_t least = 1000;
    std::size_t most = 0;
    std::size_t holes = 0;
    std::set<std::size_t> sizes;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const auto p = sample(s, weighting::none, seed);
      SCOPED_TRACE(p.name);
      ASSERT_EQ(fault_of(p.points, s == shape::touching), "");
      ASSERT_EQ(p.points, sample(s, weighting::small, seed).points) << "weights do not change the shape";
      const std::size_t n = vertices(p.points);
      ASSERT_LE(n, 304U);
      least = std::min(least, n);
      most = std::max(most, n);
      holes += p.points.size() - 1;
      sizes.insert(n);
    }
    EXPECT_LE(least, s == shape::touching ? 24U : 8U) << name_of(s);
    EXPECT_GE(most, s == shape::coarse ? 40U : 200U) << name_of(s);
    EXPECT_GE(sizes.size(), 20U) << name_of(s);
    EXPECT_EQ(holes == 0, s == shape::general || s == shape::symmetric) << name_of(s);
  }
}

TEST(Samples, TouchingOnesTouch) {
  int touching = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) touching += fault_of(random_region(shape::touching, seed)).empty() ? 0 : 1;
  EXPECT_GE(touching, 30);
}

TEST(Samples, CoarseOnesAreDegenerate) {
  int straight = 0;
  int tiny = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto points = random_region(shape::coarse, seed)[0];
    long extent = 0;
    bool flat = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      extent = std::max({extent, std::abs(points[i][0]), std::abs(points[i][1])});
      flat = flat || turn_sign(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) == 0;
    }
    straight += flat ? 1 : 0;
    tiny += extent <= 50 ? 1 : 0;
  }
  EXPECT_GE(straight, 30);
  EXPECT_GE(tiny, 150);
}

TEST(Samples, HaveWeights) {
  for (const weighting w : weightings) {
    bool zero = false;
    for (const shape s : simple_shapes)
      for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto p = sample(s, w, seed);
        SCOPED_TRACE(p.name);
        bool positive = false;
        for (std::size_t r = 0; r < p.points.size(); ++r) {
          const auto& weights = p.rings.all[r].weights;
          const auto& points = p.points[r];
          const std::size_t n = points.size();
          ASSERT_EQ(weights.size(), w == weighting::none ? 0 : n);
          for (std::size_t i = 0; i < weights.size(); ++i) {
            ASSERT_GE(weights[i].mantissa, w == weighting::some_zero ? 0 : 1);
            positive = positive || weights[i].mantissa > 0;
            zero = zero || weights[i].mantissa == 0;
            const std::size_t next = (i + 1) % n;
            ASSERT_TRUE(turn_sign(points[i], points[next], points[(i + 2) % n]) != 0 || weights[i].mantissa == weights[next].mantissa);
          }
        }
        ASSERT_EQ(positive, w != weighting::none);
      }
    EXPECT_EQ(zero, w == weighting::some_zero);
  }
}

}  // namespace
}  // namespace osteon::test
