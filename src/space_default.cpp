// SPDX-License-Identifier: MIT

/// \file
/// Space with the default kernel, whose questions are calls that the compiler can see through.

#include "space_run.hpp"

#include <span>

#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"

namespace osteon {

space_result run_default(const solid<integer>& s, const skeleton_options& o) {
  const std::span<const moving_plane<integer>> planes(s.planes);
  const perturbed k(filtered(planes, make_sqrt_kernel(planes)));
  space_result r{straight_skeleton(k, s.boundary, o), std::nullopt};
  r.exact = contract(k.base(), s.boundary, r.raw);
  return r;
}

}  // namespace osteon
