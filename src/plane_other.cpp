// SPDX-License-Identifier: MIT

/// \file
/// The plane with all exact kernels but the default one.

#include "plane_recipe.hpp"

#include "osteon/core/error.hpp"
#include "osteon/kernel/rational.hpp"

namespace osteon {
namespace {

kernel_pair<2> make_kernels(const plane::polygon<integer>& p, number_kernel k) {
  if (k != number_kernel::rational) throw invariant_error("internal invariant violated: a kernel of the plane has a name");
  return erased<2>(make_perturbed_kernel(p, make_rational_kernel(p.lines)));
}

}  // namespace

plane::skeleton raw_skeleton(const any_kernel<2>& k, const plane_question& q) { return propagated(k, q); }

plane_result run_other(const plane_question& q, number_kernel k) {
  const auto kernels = make_kernels(q.polygon, k);
  plane_result r{propagated(kernels.perturbed, q), std::nullopt};
  r.exact = plane::contract(kernels.base, q.polygon.boundary.line, r.raw);
  return r;
}

std::optional<skeleton_refutation> certify_other(const plane_question& q, const plane_result& r, number_kernel k) {
  const auto kernels = make_kernels(q.polygon, k);
  return certified(kernels.perturbed, kernels.base, q, r);
}

}  // namespace osteon
