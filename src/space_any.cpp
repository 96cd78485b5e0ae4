// SPDX-License-Identifier: MIT

/// \file
/// Space with all kernels but the default one.

#include "space_recipe.hpp"

#include <string>

#include "any_run.hpp"
#include "osteon/core/error.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/rational.hpp"

namespace osteon {

skeleton raw_any(const any_kernel<3>& k, const solid<integer>& s, const skeleton_options& o) { return straight_skeleton(k, s.boundary, o); }

space_result run_rational(const solid<integer>& s, const skeleton_options& o) {
  const auto k = make_perturbed_kernel(s, make_rational_kernel(s.planes));
  space_result r{raw_any(any_kernel<3>(k), s, o), std::nullopt};
  r.exact = contract(any_kernel<3>(k.base()), s.boundary, r.raw);
  return r;
}

space_result run_floating(const solid<integer>& s, const skeleton_options& o) {
  const auto k = make_double_kernel(s.planes);
  try {
    return {raw_any(any_kernel<3>(k), s, o), std::nullopt};
  } catch (const invariant_error& e) {  // what an exact kernel promises machine numbers break
    const std::string text = e.what();
    throw undecided_error("the kernel's answers contradict each other (" + text.substr(text.find(": ") + 2) + "); hint: use an exact kernel");
  }
}

std::optional<skeleton_refutation> certify_rational(const solid<integer>& s, const space_result& r) {
  const auto k = make_perturbed_kernel(s, make_rational_kernel(s.planes));
  return certify(any_kernel<3>(k), any_kernel<3>(k.base()), s, r);
}

}  // namespace osteon
