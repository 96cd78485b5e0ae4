// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Skeletons by every exact kernel. Compiled once: the laws themselves see no kernel.

#include <string>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::properties {

/// A raw skeleton, and what its kernel says about its arcs: how their three planes meet. A corner that only the perturbation makes
/// has no orientation in rational coordinates.
struct run {
  std::string kernel;
  skeleton raw;
  std::vector<sign> orientations;
};

/// perturbed<filtered<sqrt>>, perturbed<sqrt>, perturbed<filtered<rational>>, perturbed<rational>; their number is exact_kernels.
std::vector<run> run_all(const solid<integer>& s, const skeleton_options& o = {});
inline constexpr int exact_kernels = 4;

/// By the default kernel only.
run run_default(const solid<integer>& s, const skeleton_options& o = {});

/// By perturbed<filtered<rational>> and perturbed<rational>, whose skeletons have rational places and times; for any planes and boundary.
std::vector<run> run_rational(const std::vector<moving_plane<integer>>& planes, const boundary& b, const skeleton_options& o = {});

/// The same kernels without a perturbation; requires general position.
std::vector<run> run_unperturbed(const solid<integer>& s, const skeleton_options& o = {});

/// Whether no predicate that the algorithm asks about this solid is zero: the kernel without a perturbation gets through.
bool in_general_position(const solid<integer>& s, const skeleton_options& o = {});

/// Empty where two skeletons are the same, number by number; else what differs first.
std::string difference(const skeleton& a, const skeleton& b);

/// One of each set of equal skeletons, named after all its kernels: laws about geometry need not be checked twice.
std::vector<run> distinct(std::vector<run> runs);

}  // namespace osteon::properties
