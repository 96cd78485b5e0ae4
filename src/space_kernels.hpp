// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The kernels of space by their names.

#include "osteon/door/choices.hpp"

#include "any_kernel.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// Returns the kernel for a solid's planes, perturbed (`mirrored`: the other way) where it is
/// exact; machine numbers are not, and are both of the pair.
kernel_pair<3> make_kernels(const solid<integer>& s, number_kernel k, bool mirrored = false);

}  // namespace osteon
