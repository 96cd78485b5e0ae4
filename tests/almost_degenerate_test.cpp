// SPDX-License-Identifier: MIT

// Voxel solids and prisms turned by irrational angles, rounded and triangulated: neighbours are almost coplanar, edges almost
// vanish, and straight angles that survive the rounding make facets flood edges (flood.hpp).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ctime>
#include <iostream>

#include "osteon/input/mesh_repair.hpp"
#include "osteon/models/registry.hpp"
#include "osteon/space/contract.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

// Turned by two irrational angles, rounded to so many digits after the point, and triangulated.
input_mesh<integer> turned(const input_mesh<integer>& m, double a, double b, int digits) {
  input_mesh<integer> result;
  const long double unit = std::pow(10.0L, digits);
  const auto rounded = [&](long double x) { return exact_number<integer>{integer(std::llround(x * unit)), -digits, 0}; };
  for (const auto& p : m.points) {
    std::array<long double, 3> x{};
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = p[axis].mantissa.convert_to<long double>();
    const long double u = std::cos(a) * x[0] - std::sin(a) * x[1];
    const long double v = std::sin(a) * x[0] + std::cos(a) * x[1];
    result.points.push_back({rounded(u), rounded(std::cos(b) * v - std::sin(b) * x[2]), rounded(std::sin(b) * v + std::cos(b) * x[2])});
  }
  for (const auto& f : m.facets) {
    if (f.size() == 4) {
      result.facets.push_back({f[0], f[1], f[2]});
      result.facets.push_back({f[0], f[2], f[3]});
    } else {
      result.facets.push_back(f);
    }
  }
  triangulate_facets(result);
  return result;
}

input_mesh<integer> voxels(int seed) {
  models::dice roll(static_cast<std::uint64_t>(seed));
  const std::array<int, 3> size = {static_cast<int>(roll.between(1, 3)), static_cast<int>(roll.between(1, 3)), static_cast<int>(roll.between(1, 3))};
  return models::random_voxels(size, static_cast<int>(roll.between(25, 90)), static_cast<std::uint64_t>(seed)).surface().take<integer>();
}

// A prism over a star-shaped polygon. No three corners on a line: rounding would turn the triangle between them inside out.
input_mesh<integer> prism(int seed) {
  models::dice roll(static_cast<std::uint64_t>(seed));
  const auto collinear = [](const models::polygon& p) {
    const auto n = p.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          if ((p[j][0] - p[i][0]) * (p[k][1] - p[i][1]) == (p[j][1] - p[i][1]) * (p[k][0] - p[i][0])) return true;
    return false;
  };
  models::polygon base;
  do {
    base.clear();
    const int n = static_cast<int>(roll.between(3, 9));
    for (int i = 0; i < n; ++i) base.push_back(models::on_circle(i, n, static_cast<double>(roll.between(10, 40)), 0.1));
  } while (collinear(base));
  return models::prism(base, roll.between(5, 60)).take<integer>();
}

// Time spent per facet, in seconds of this process.
struct cost {
  double seconds = 0;
  std::size_t facets = 0;
  double per_facet() const { return seconds / static_cast<double>(facets); }
};

void complete(const input_mesh<integer>& m, cost& spent) {
  const std::clock_t start = std::clock();
  const auto s = make_solid(m);
  const auto k = default_kernel(s);
  skeleton raw;
  ASSERT_NO_THROW(raw = straight_skeleton(k, s.boundary));
  ASSERT_NO_THROW(contract(k.base(), s.boundary, raw));
  spent.seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  spent.facets += static_cast<std::size_t>(s.facets);
  EXPECT_GE(raw.arcs.size(), s.boundary.vertices.size());
}

class AlmostDegenerate : public testing::TestWithParam<input_mesh<integer> (*)(int)> {};

// 150 solids, each also turned and rounded to 6, 9 and 15 digits: all complete, and from the mesh to the exact skeleton a facet
// takes at most three times as long.
TEST_P(AlmostDegenerate, SolidsCompleteInAtMostThriceTheTime) {
  cost plain;
  std::array<cost, 3> rounded;
  for (int seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto m = GetParam()(seed);
    complete(m, plain);
    for (std::size_t i = 0; i < 3; ++i) complete(turned(m, 0.1 + seed * 0.7123, 0.3 + seed * 1.234, std::array{6, 9, 15}[i]), rounded[i]);
    if (HasFatalFailure()) return;
  }
  cost all;
  for (const cost& c : rounded) {
    all.seconds += c.seconds;
    all.facets += c.facets;
    std::cout << "a facet takes " << c.per_facet() / plain.per_facet() << " times as long\n";
  }
  EXPECT_LE(all.per_facet(), 3 * plain.per_facet());
}

INSTANTIATE_TEST_SUITE_P(Kinds, AlmostDegenerate, testing::Values(voxels, prism),
                         [](const auto& kind) { return kind.param == voxels ? "Voxels" : "Prisms"; });

TEST(Scale, TinyAndHugeModelsAreAsGoodAsAny) {
  for (const int ten : {-12, 12}) {
    for (const auto& kind : models::kinds()) {
      SCOPED_TRACE(kind.name);
      auto m = kind.make(kind.default_size, 3).take<integer>();
      const auto s = make_solid(m);
      for (auto& p : m.points)
        for (auto& x : p) x.ten += ten;
      const auto scaled = make_solid(m);
      const auto a = straight_skeleton(default_kernel(s), s.boundary);
      const auto b = straight_skeleton(default_kernel(scaled), scaled.boundary);
      ASSERT_EQ(a.nodes.size(), b.nodes.size());
      for (std::size_t n = 0; n < a.nodes.size(); ++n) EXPECT_EQ(a.nodes[n].planes, b.nodes[n].planes);
    }
  }
}

}  // namespace
}  // namespace osteon::test
