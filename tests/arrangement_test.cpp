// SPDX-License-Identifier: MIT

// The valid trees against thesis 3.11: selections of cells of the moved planes' arrangement.

#include "arrangement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "corners.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/space/split.hpp"

namespace osteon::test {
namespace {

TEST(Arrangement, ItsSelectionsAreTheValidTrees) {
  std::size_t several = 0;
  for (int k = 4; k <= 7; ++k)
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      const auto c = make_corner(k, static_cast<std::uint64_t>(1000 * k) + seed);
      if (!c) continue;
      const auto kernel = make_rational_kernel(c->planes);
      std::set<oracles::arrangement::tree> valid;
      for (const split_tree& t : splitter(kernel, c->of).all()) {
        auto& vertices = *valid.insert({t.vertices.begin(), t.vertices.end()}).first;
        ASSERT_EQ(vertices.size(), static_cast<std::size_t>(k) - 2);
      }
      std::vector<std::array<integer, 3>> normals;
      std::vector<integer> speeds;
      for (int i = 0; i < k; ++i) {
        normals.push_back(c->planes[static_cast<std::size_t>(i)].n);
        speeds.push_back(kernel.arithmetic().speed(i));
      }
      ASSERT_EQ(oracles::arrangement(c->rays, normals, speeds).selections(), valid);
      several += valid.size() > 1 ? 1U : 0U;
    }
  EXPECT_GE(several, 100U);
}

}  // namespace
}  // namespace osteon::test
