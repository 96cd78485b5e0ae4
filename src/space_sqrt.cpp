// SPDX-License-Identifier: MIT

/// \file
/// Space with the default kernel.

#include "space_recipe.hpp"

#include "osteon/kernel/sqrt.hpp"

namespace osteon {

skeleton raw_sqrt(const solid<integer>& s, const skeleton_options& o) {
  return straight_skeleton(make_perturbed_kernel(s, make_sqrt_kernel(s.planes)), s.boundary, o);
}

space_result run_sqrt(const solid<integer>& s, const skeleton_options& o) {
  const auto k = make_perturbed_kernel(s, make_sqrt_kernel(s.planes));
  space_result r{straight_skeleton(k, s.boundary, o), std::nullopt};
  r.exact = contract(k.base(), s.boundary, r.raw);
  return r;
}

std::optional<skeleton_refutation> certify_sqrt(const solid<integer>& s, const space_result& r) {
  const auto k = make_perturbed_kernel(s, make_sqrt_kernel(s.planes));
  return certify(k, k.base(), s, r);
}

}  // namespace osteon
