// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What algorithms of the plane may ask of a kernel beyond the concept.

#include <concepts>
#include <optional>

#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"

namespace osteon::plane {

/// A line's number in the kernel: 0 .. size() - 1.
using line_id = plane_id;

/// A kernel that knows what becomes of its answers when its perturbation goes to zero.
template <class K>
concept limit_kernel = kernel<K, 2> && requires(const K& k, line_id a, const typename K::meeting& m) {
  { k.has_moment(m) } -> std::same_as<bool>;
  // Infinitely late or early in the limit.
  { k.is_never(m) } -> std::same_as<bool>;
  { k.same_moment(m, m) } -> std::same_as<bool>;
  // Whether the corner of the last two lines lies on the first at the moment.
  { k.touches(a, a, a, m) } -> std::same_as<bool>;
};

}  // namespace osteon::plane
