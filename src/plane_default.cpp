// SPDX-License-Identifier: MIT

/// \file
/// The plane with the default kernel.

#include "plane_recipe.hpp"

#include "osteon/kernel/sqrt.hpp"

namespace osteon {

plane_result run_default(const plane_question& q) {
  const auto k = make_perturbed_kernel(q.polygon, make_sqrt_kernel(q.polygon.lines));
  plane_result r{propagated(k, q), std::nullopt};
  r.exact = plane::contract(k.base(), q.polygon.boundary.line, r.raw);
  return r;
}

std::optional<skeleton_refutation> certify_default(const plane_question& q, const plane_result& r) {
  const auto k = make_perturbed_kernel(q.polygon, make_sqrt_kernel(q.polygon.lines));
  return certified(k, k.base(), q, r);
}

}  // namespace osteon
