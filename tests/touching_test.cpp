// SPDX-License-Identifier: MIT

// Solids whose parts share single points: several fans of facets around one vertex (design 04).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/volume.hpp"
#include "osteon/models/polyhedra.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/verify.hpp"
#include "support.hpp"
#include "voxel_erosion.hpp"

namespace osteon::test {
namespace {

using models::point;
using loop = std::vector<point>;

// Two parts as one solid, the second moved.
models::builder united(const std::vector<loop>& first, const std::vector<loop>& second, const point& by) {
  models::builder b;
  for (const auto& f : first) b.facet(f);
  for (const auto& f : second) {
    loop moved = f;
    for (point& p : moved)
      for (std::size_t x = 0; x < 3; ++x) p[x] += by[x];
    b.facet(moved);
  }
  return b;
}

std::vector<loop> turned_over(std::vector<loop> part) {  // a half turn about the x-axis
  for (loop& f : part)
    for (point& p : f) p = {p[0], -p[1], -p[2]};
  return part;
}

// A pyramid over a star that hangs down from the origin.
std::vector<loop> cone(int k, std::uint64_t seed) {
  models::dice roll(seed);
  loop base;
  for (int i = 0; i < k; ++i) {
    const auto p = models::on_circle(i, k, static_cast<double>(roll.between(400, 1000)));
    base.push_back({p[0], p[1], -700});
  }
  std::vector<loop> part;
  for (int i = 0; i < k; ++i) part.push_back({base[static_cast<std::size_t>(i)], base[static_cast<std::size_t>((i + 1) % k)], {0, 0, 0}});
  std::reverse(base.begin(), base.end());
  part.push_back(base);
  return part;
}

// A box with a pit in its upper side; the bottom of the pit is the origin.
std::vector<loop> pit() {
  const point a = {-9, -9, 5};
  const point b = {9, -8, 5};
  const point c = {8, 9, 5};
  const point d = {-8, 8, 5};
  const std::array<point, 4> low = {point{-20, -20, -20}, point{20, -20, -20}, point{20, 20, -20}, point{-20, 20, -20}};
  std::array<point, 4> high = low;
  for (point& p : high) p[2] = 5;
  std::vector<loop> part = {{low[3], low[2], low[1], low[0]}};
  for (std::size_t i = 0; i < 4; ++i) part.push_back({low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]});
  const std::array<point, 4> rim = {a, b, c, d};
  for (std::size_t i = 0; i < 4; ++i) {
    const point& p = rim[i];
    const point& q = rim[(i + 1) % 4];
    part.push_back({high[i], high[(i + 1) % 4], q});
    part.push_back({high[i], q, p});
    part.push_back({p, q, {0, 0, 0}});
  }
  return part;
}

// Touching parts have the skeletons that they have apart.
void expect_parts(const std::vector<loop>& first, const std::vector<loop>& second, const point& apart) {
  std::array<std::array<std::size_t, 6>, 2> sizes;
  for (const bool touch : {true, false}) {
    const auto s = make_solid(united(first, second, touch ? point{0, 0, 0} : apart).take<integer>());
    const auto k = default_kernel(s);
    const skeleton raw = straight_skeleton(k, s.boundary);
    const auto broken = verify(k, s.boundary, raw);
    EXPECT_FALSE(broken) << broken->witness;
    const contracted_skeleton exact = contract(k.base(), s.boundary, raw);
    EXPECT_FALSE(verify_contraction(k.base(), s.boundary, raw, exact));
    sizes[touch ? 0 : 1] = {raw.nodes.size(), raw.arcs.size(), raw.sheets.size(), exact.nodes.size(), exact.arcs.size(), exact.sheets.size()};
  }
  EXPECT_EQ(sizes[0], sizes[1]);
}

TEST(Touching, HourglassesPart) {
  for (const int k : {4, 5, 8, 13})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      expect_parts(cone(k, seed), turned_over(cone(k, 100 + seed)), {0, 0, 3001});
    }
}

TEST(Touching, ATipLeavesItsPit) {
  std::vector<loop> tip;
  for (loop f : turned_over(cone(4, 3))) {
    for (point& p : f) p[2] *= 4;  // steeper than the pit
    tip.push_back(f);
  }
  expect_parts(pit(), tip, {0, 0, 30});
}

// Chains of boxes, corner to corner.
TEST(Touching, VoxelsMayMeetInPoints) {
  models::dice roll(1);
  for (int n = 0; n < 50; ++n) {
    models::voxels grid({8, 8, 8});
    std::array<int, 3> at = {0, 0, 0};
    for (;;) {
      std::array<int, 3> size{};
      for (int& x : size) x = static_cast<int>(roll.between(1, 3));
      if (at[0] + size[0] > 8 || at[1] + size[1] > 8 || at[2] + size[2] > 8) break;
      for (int x = 0; x < size[0]; ++x)
        for (int y = 0; y < size[1]; ++y)
          for (int z = 0; z < size[2]; ++z) grid.set(at[0] + x, at[1] + y, at[2] + z, true);
      for (std::size_t x = 0; x < 3; ++x) at[x] += size[x];
    }
    if (grid.count() == 0) continue;
    const auto s = make_solid(grid.surface().take<integer>());
    const auto k = default_kernel(s);
    const skeleton raw = straight_skeleton(k, s.boundary);
    EXPECT_FALSE(verify(k, s.boundary, raw));
    const rational_offsets offsets(s.planes, raw);
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(1, 4), std::pair(1, 2), std::pair(3, 4), std::pair(1, 1), std::pair(5, 4)})
      EXPECT_EQ(offsets.volume(rational(p, q)), rational(oracles::eroded_cells(
                                                             grid.size(), [&grid](int x, int y, int z) { return grid(x, y, z); }, p, q),
                                                         q * q * q));
  }
}

}  // namespace
}  // namespace osteon::test
