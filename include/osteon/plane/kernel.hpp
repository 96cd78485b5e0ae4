// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What algorithms of the plane may ask of a kernel beyond the concept.

#include <concepts>
#include <cstddef>
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

/// Returns the sign of lambda_r of three lines: of the determinant of the other two lines' normals, negated for the middle one (see kernel.hpp of
/// core). *Requires* ascending lines, r < 3.
template <kernel<2> K>
sign lambda(const K& k, const triple& lines, std::size_t r) {
  return osteon::lambda(lines, r, [&k](line_id a, line_id b) { return k.orientation(a, b); });
}

}  // namespace osteon::plane
