// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Runs and certificates in space, one source file for each kernel behind them.

#include <optional>

#include "osteon/door/choices.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// Both levels of detail; the contracted one where the kernel is exact.
struct space_result {
  skeleton raw;
  std::optional<contracted_skeleton> exact;
};

/// Computes the raw skeleton alone with the default kernel.
skeleton raw_sqrt(const solid<integer>& s, const skeleton_options& o);

/// Computes a skeleton with the default kernel, with rational numbers, or with machine numbers.
space_result run_sqrt(const solid<integer>& s, const skeleton_options& o);
space_result run_rational(const solid<integer>& s, const skeleton_options& o);
space_result run_floating(const solid<integer>& s, const skeleton_options& o);

/// Checks the certificate of both levels of detail with one of the exact kernels.
std::optional<skeleton_refutation> certify_sqrt(const solid<integer>& s, const space_result& r);
std::optional<skeleton_refutation> certify_rational(const solid<integer>& s, const space_result& r);

}  // namespace osteon
