// SPDX-License-Identifier: MIT

/// \file
/// The plane with all exact kernels but the default one.

#include "plane_recipe.hpp"

#include "any_run.hpp"
#include "osteon/kernel/rational.hpp"

namespace osteon {

plane::skeleton raw_any(const any_kernel<2>& k, const plane_question& q) { return raw_skeleton(k, q); }

plane_result run_rational(const plane_question& q) {
  const auto k = make_perturbed_kernel(q.polygon, make_rational_kernel(q.polygon.lines));
  plane_result r{raw_any(any_kernel<2>(k), q), std::nullopt};
  r.exact = plane::contract(any_kernel<2>(k.base()), q.polygon.boundary.line, r.raw);
  return r;
}

std::optional<skeleton_refutation> certify_rational(const plane_question& q, const plane_result& r) {
  const auto k = make_perturbed_kernel(q.polygon, make_rational_kernel(q.polygon.lines));
  return certify(any_kernel<2>(k), any_kernel<2>(k.base()), q, r);
}

}  // namespace osteon
