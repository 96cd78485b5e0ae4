// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The kernel concept one dimension down (design 01, 06): lines instead of planes, three of which meet in an event. The same laws hold.

#include <concepts>
#include <optional>

#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"

namespace osteon::plane {

/// A line's number in the kernel: 0 .. size() - 1.
using line_id = plane_id;

/// What the algorithms ask of the plane. Line i is  n_i . x = d_i - t * sigma_i, its inner side n_i . x < d_i - t * sigma_i; an edge runs with its
/// inner side on its left. The laws are those of osteon::kernel.
template <class K>
concept planar_kernel = std::copyable<typename K::meeting> &&
    requires(const K& k, line_id a, line_id b, line_id c, const triple& q, const typename K::meeting& m) {
  { K::exact } -> std::convertible_to<bool>;
  { k.size() } -> std::same_as<line_id>;

  // Sign of det(n_a, n_b): positive where an edge on b turns left from one on a. Zero: parallel.
  { k.orientation(a, b) } -> std::same_as<sign>;
  // Whether the unperturbed lines cross.
  { k.transversal(a, b) } -> std::same_as<bool>;
  // The moment at which three lines share a point; empty where that is always or never.
  { k.meet(q) } -> std::same_as<std::optional<typename K::meeting>>;
  { k.planes(m) } -> std::convertible_to<triple>;
  { k.closing(m) } -> std::same_as<sign>;
  { k.start() } -> std::same_as<typename K::meeting>;
  { k.compare(m, m) } -> std::same_as<sign>;
  // The moving vertex (a,b) at the moment of m against line c: positive inside.
  { k.side(c, a, b, m) } -> std::same_as<sign>;
};

/// A kernel that knows what becomes of its answers when its perturbation goes to zero.
template <class K>
concept limit_kernel = planar_kernel<K> && requires(const K& k, line_id a, const typename K::meeting& m) {
  { k.has_moment(m) } -> std::same_as<bool>;
  // Infinitely late or early in the limit.
  { k.is_never(m) } -> std::same_as<bool>;
  { k.same_moment(m, m) } -> std::same_as<bool>;
  // Whether the corner of the last two lines lies on the first at the moment.
  { k.touches(a, a, a, m) } -> std::same_as<bool>;
};

}  // namespace osteon::plane
