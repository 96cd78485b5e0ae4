// SPDX-License-Identifier: MIT

// Inputs that once failed; each file tells how.

#include <gtest/gtest.h>

#include <filesystem>

#include "osteon/space/contract.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

TEST(Regressions, EveryPreferenceAndSaddleRuleEnds) {
  for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(OSTEON_MODELS) / ".." / "regressions")) {
    if (file.path().extension() != ".obj") continue;
    const auto s = read_solid(file.path(), true);
    const auto k = default_kernel(s);
    for (const auto p : {split_preference::convex, split_preference::reflex, split_preference::min_volume, split_preference::max_volume})
      for (const auto r : {saddle_rule::convex, saddle_rule::reflex, saddle_rule::slower, saddle_rule::faster}) {
        SCOPED_TRACE(file.path().filename().string());
        EXPECT_NO_THROW(contract(k.base(), s.boundary, straight_skeleton(k, s.boundary, {p, r})));
      }
  }
}

}  // namespace
}  // namespace osteon::test
