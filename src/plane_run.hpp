// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Runs and certificates in the plane, one source file for each kernel behind them.

#include <limits>
#include <optional>

#include "osteon/core/certificate.hpp"
#include "osteon/door/choices.hpp"
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

/// Computes a skeleton with the default kernel, with rational numbers, or with machine numbers.
plane_result run_sqrt(const plane_question& q);
plane_result run_rational(const plane_question& q);
plane_result run_floating(const plane_question& q);

/// Checks the certificate of both levels of detail with one of the exact kernels.
std::optional<skeleton_refutation> certify_sqrt(const plane_question& q, const plane_result& r);
std::optional<skeleton_refutation> certify_rational(const plane_question& q, const plane_result& r);

}  // namespace osteon
