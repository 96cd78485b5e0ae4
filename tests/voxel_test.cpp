// SPDX-License-Identifier: MIT

// Random voxel solids, the harshest degenerate input there is, against counting cells.

#include <gtest/gtest.h>

#include <array>
#include <tuple>
#include <utility>

#include "osteon/evaluate/volume.hpp"
#include "osteon/models/polyhedra.hpp"
#include "osteon/space/contract.hpp"
#include "support.hpp"
#include "voxel_erosion.hpp"

namespace osteon::test {
namespace {

constexpr std::array<std::pair<int, int>, 10> times = {{{0, 1}, {1, 8}, {1, 5}, {1, 3}, {3, 7}, {1, 2}, {2, 3}, {3, 4}, {1, 1}, {3, 2}}};

// Seeds first .. first + 249. The offset of an axis-parallel solid is its erosion in the maximum norm: of all valid offsets the greatest.
class VoxelSolids : public testing::TestWithParam<int> {};

TEST_P(VoxelSolids, OffsetsAreErosions) {
  for (int seed = GetParam(); seed < GetParam() + 250; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    models::dice roll(static_cast<std::uint64_t>(seed));
    const std::array<int, 3> size = {static_cast<int>(roll.between(1, 6)), static_cast<int>(roll.between(1, 6)),
                                     static_cast<int>(roll.between(1, 6))};
    const auto v = models::random_voxels(size, static_cast<int>(roll.between(25, 90)), static_cast<std::uint64_t>(seed));
    const auto s = make_solid(v.surface().take<integer>());
    const auto k = default_kernel(s);
    const auto raw = straight_skeleton(k, s.boundary);
    const auto exact = contract(k.base(), s.boundary, raw);
    EXPECT_GE(raw.nodes.size(), exact.nodes.size());
    const rational_offsets offsets(s.planes, raw);
    const rational unit = rational(pow(integer(10), static_cast<unsigned>(s.ten)) * pow(integer(2), static_cast<unsigned>(s.two)));
    for (const auto& [p, q] : times) {
      const auto full = [&v](int x, int y, int z) { return v(x, y, z); };
      const rational expected = rational(oracles::eroded_cells(size, full, p, q)) / (q * q * q);
      ASSERT_EQ(offsets.volume(rational(p, q) / unit) * unit * unit * unit, expected) << "at time " << p << "/" << q;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TwoThousand, VoxelSolids, testing::Range(0, 2000, 250));

// The oracle itself, by hand.
TEST(VoxelErosion, OfABlock) {
  const auto block = [](int, int, int) { return true; };
  EXPECT_EQ(oracles::eroded_cells({3, 3, 3}, block, 1, 1), 1);
  EXPECT_EQ(oracles::eroded_cells({3, 3, 3}, block, 1, 2), 4 * 4 * 4);
  EXPECT_EQ(oracles::eroded_cells({2, 3, 4}, block, 1, 4), 6 * 10 * 14);
  EXPECT_EQ(oracles::eroded_cells({1, 1, 1}, block, 1, 2), 0);
}

// Shapes that random solids have: tunnels, voids, several bodies and majority corners.
TEST(VoxelSolids, AreVaried) {
  int majority_corners = 0;
  int bodies = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto s = make_solid(models::random_voxels({5, 5, 5}, 40, seed).surface().take<integer>());
    long euler = static_cast<long>(s.boundary.vertices.size()) - static_cast<long>(s.boundary.edges.size());
    for (const auto& v : s.boundary.vertices) majority_corners += v.is_majority() ? 1 : 0;
    bodies += euler != 0 ? 1 : 0;
  }
  EXPECT_GT(majority_corners, 10);
  EXPECT_GT(bodies, 10);
}

}  // namespace
}  // namespace osteon::test
