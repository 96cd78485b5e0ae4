// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Runs and certificates in the plane. The default kernel has algorithms of its own, since a
/// virtual call counts there (two to eight percent); so has the one of machine numbers, which knows
/// no limits.

#include "osteon/door/choices.hpp"

#include <optional>

#include "any_kernel.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon {

/// Both levels of detail; the contracted one where the kernel is exact.
struct plane_result {
  plane::skeleton raw;
  std::optional<plane::contracted_skeleton> exact;
};

/// What is asked of a run.
struct plane_question {
  const plane::polygon<integer>& polygon;
  bool exterior = false;
  std::optional<rational> until = std::nullopt;  ///< in units of the input
};

/// Computes the raw skeleton alone, with a perturbed kernel of the polygon's lines.
plane::skeleton raw_skeleton(const any_kernel<2>& k, const plane_question& q);

/// Computes a skeleton with the default kernel, with machine numbers, or with one of the others.
plane_result run_default(const plane_question& q);
plane_result run_floating(const plane_question& q);
plane_result run_other(const plane_question& q, number_kernel k);

/// Checks the certificate of both levels of detail.
std::optional<skeleton_refutation> certify_default(const plane_question& q, const plane_result& r);
std::optional<skeleton_refutation> certify_other(const plane_question& q, const plane_result& r, number_kernel k);

/// The same by the kernel's name; the certificate of machine numbers by the default kernel.
inline plane_result run(const plane_question& q, number_kernel k) {
  return k == number_kernel::sqrt ? run_default(q) : k == number_kernel::floating ? run_floating(q) : run_other(q, k);
}
inline std::optional<skeleton_refutation> certify(const plane_question& q, const plane_result& r, number_kernel k) {
  return k == number_kernel::rational ? certify_other(q, r, k) : certify_default(q, r);
}

}  // namespace osteon
