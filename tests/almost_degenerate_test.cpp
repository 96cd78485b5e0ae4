// SPDX-License-Identifier: MIT

// Voxel solids turned by irrational angles, rounded and triangulated: neighbours are almost coplanar, edges almost
// vanish, and straight angles that survive the rounding make facets flood edges (flood.hpp).

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "osteon/contract.hpp"
#include "osteon/models.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

mesh<integer> turned(const mesh<integer>& m, double a, double b, int digits) {
  mesh<integer> result;
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
    result.facets.push_back({f[0], f[1], f[2]});
    result.facets.push_back({f[0], f[2], f[3]});
  }
  return result;
}

class TurnedVoxels : public testing::TestWithParam<int> {};

TEST_P(TurnedVoxels, Complete) {
  const int digits = GetParam();
  for (int seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    models::dice roll(static_cast<std::uint64_t>(seed));
    const std::array<int, 3> size = {static_cast<int>(roll.between(1, 3)), static_cast<int>(roll.between(1, 3)),
                                     static_cast<int>(roll.between(1, 3))};
    const auto v = models::random_voxels(size, static_cast<int>(roll.between(25, 90)), static_cast<std::uint64_t>(seed));
    const auto s = make_solid(turned(v.surface().take<integer>(), 0.1 + seed * 0.7123, 0.3 + seed * 1.234, digits));
    const auto k = default_kernel(s);
    skeleton raw;
    ASSERT_NO_THROW(raw = straight_skeleton(k, s.boundary));
    ASSERT_NO_THROW(contract(k.base(), s.boundary, raw));
    EXPECT_GE(raw.arcs.size(), s.boundary.vertices.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Digits, TurnedVoxels, testing::Values(6, 9, 15));

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
