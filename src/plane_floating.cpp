// SPDX-License-Identifier: MIT

/// \file
/// The plane with machine numbers.

#include "plane_recipe.hpp"

#include "osteon/kernel/double.hpp"

namespace osteon {

plane_result run_floating(const plane_question& q) {
  return {propagated(make_double_kernel(std::span<const moving_line<integer>>(q.polygon.lines)), q), std::nullopt};
}

}  // namespace osteon
