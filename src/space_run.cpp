// SPDX-License-Identifier: MIT

/// \file
/// Space, with all kernels: the default one as it is (space_default.cpp), the others erased.

#include "space_run.hpp"

#include <string>

#include "osteon/core/error.hpp"
#include "osteon/space/verify.hpp"
#include "space_kernels.hpp"

namespace osteon {
namespace {

// What an exact kernel promises machine numbers break.
skeleton machine_skeleton(const any_kernel<3>& k, const solid<integer>& s, const skeleton_options& o) try {
  return straight_skeleton(k, s.boundary, o);
} catch (const invariant_error& e) {
  const std::string text = e.what();
  throw undecided_error("the kernel's answers contradict each other (" + text.substr(text.find(": ") + 2) + "); hint: use an exact kernel");
}

}  // namespace

skeleton raw_skeleton(const any_kernel<3>& k, const solid<integer>& s, const skeleton_options& o) { return straight_skeleton(k, s.boundary, o); }

space_result run(const solid<integer>& s, const skeleton_options& o, number_kernel k) {
  if (k == number_kernel::sqrt) return run_default(s, o);
  const auto kernels = make_kernels(s, k);
  if (k == number_kernel::floating) return {machine_skeleton(kernels.perturbed, s, o), std::nullopt};
  space_result r{straight_skeleton(kernels.perturbed, s.boundary, o), std::nullopt};
  r.exact = contract(kernels.base, s.boundary, r.raw);
  return r;
}

std::optional<skeleton_refutation> certify(const solid<integer>& s, const space_result& r, number_kernel k) {
  const auto kernels = make_kernels(s, k == number_kernel::rational ? k : number_kernel::sqrt);
  auto broken = verify(kernels.perturbed, s.boundary, r.raw);
  if (!broken && r.exact) broken = verify_contraction(kernels.base, s.boundary, r.raw, *r.exact);
  if (!broken) return std::nullopt;
  return skeleton_refutation{rule_names[static_cast<std::size_t>(broken->broken)], broken->witness};
}

}  // namespace osteon
