// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Runs with any kernel.

#include "any_kernel.hpp"
#include "plane_run.hpp"
#include "space_run.hpp"

namespace osteon {

/// Returns the raw skeleton with a perturbed kernel of the solid's planes, or of the polygon's lines.
skeleton raw_any(const any_kernel<3>& k, const solid<integer>& s, const skeleton_options& o);
plane::skeleton raw_any(const any_kernel<2>& k, const plane_question& q);

}  // namespace osteon
