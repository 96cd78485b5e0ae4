// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The steps of a run and of a certificate in space, for any kernel.

#include "space_run.hpp"

#include <optional>
#include <span>
#include <utility>

#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/verify.hpp"

namespace osteon {

/// Returns a perturbed kernel over an exact one, floating point in front.
template <class Exact>
auto make_perturbed_kernel(const solid<integer>& s, Exact exact) {
  return perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), std::move(exact)));
}

/// Returns what is wrong with a skeleton. `base` is the kernel below the perturbation.
template <class K, class Base>
std::optional<skeleton_refutation> certify(const K& k, const Base& base, const solid<integer>& s, const space_result& r) {
  auto broken = verify(k, s.boundary, r.raw);
  if (!broken && r.exact) broken = verify_contraction(base, s.boundary, r.raw, *r.exact);
  if (!broken) return std::nullopt;
  return skeleton_refutation{rule_names[static_cast<std::size_t>(broken->broken)], broken->witness};
}

}  // namespace osteon
