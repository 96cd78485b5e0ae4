// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Runs and certificates in space.

#include "osteon/door/choices.hpp"

#include <optional>

#include "any_kernel.hpp"
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

/// Computes the raw skeleton alone, with a kernel of the solid's planes.
skeleton raw_skeleton(const any_kernel<3>& k, const solid<integer>& s, const skeleton_options& o);

/// Computes a skeleton with the default kernel.
space_result run_default(const solid<integer>& s, const skeleton_options& o);

/// Computes a skeleton.
space_result run(const solid<integer>& s, const skeleton_options& o, number_kernel k);

/// Checks the certificate of both levels of detail; that of machine numbers by the default kernel.
std::optional<skeleton_refutation> certify(const solid<integer>& s, const space_result& r, number_kernel k);

}  // namespace osteon
