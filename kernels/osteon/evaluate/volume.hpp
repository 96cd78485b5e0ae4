// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The volume of an offset solid as a function of time, exactly where all speeds are rational
/// (boxes, voxels, Pythagorean slopes).

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/integer_planes.hpp"
#include "osteon/kernel/volume.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// Returns the speeds of planes, rounded down to multiples of 2^-128.
inline std::vector<rational> rounded_speeds(std::span<const moving_plane<integer>> planes) {
  std::vector<rational> speeds;
  for (const auto& p : planes) speeds.emplace_back(rounded_speed(p, 128), integer(1) << 128U);
  return speeds;
}

/// Answers for one skeleton. The volume is a sum over the vertices that are alive at the time (see
/// kernel/volume.hpp); a corner that is not convex is a signed sum of products of half-spaces (see
/// local::product_weight). Keeps references to the planes and the skeleton.
class rational_offsets {
 public:
  /// With the planes' own speeds: everything is exact.
  /// *Throws* unsupported_error where a speed is irrational.
  rational_offsets(std::span<const moving_plane<integer>> planes, const skeleton& s) : rational_offsets(planes, s, exact_speeds(planes)) {}

  /// With given speeds: as exact as they are.
  rational_offsets(std::span<const moving_plane<integer>> planes, const skeleton& s, std::vector<rational> speeds)
      : planes_(planes), s_(s), speeds_(std::move(speeds)) {
    for (const auto& n : s.nodes) times_.push_back(n.vertex >= 0 ? rational(0) : time(n.planes));
  }

  /// Returns the times of the nodes in the limit, by node.
  const std::vector<rational>& times() const { return times_; }

  /// Returns the volume of the offset solid, in the solid's own unit cubed. At the time of an event
  /// it is the limit from both sides.
  /// *Requires* t >= 0. *Complexity* linear in the number of arcs.
  rational volume(const rational& t) const {
    for (int attempt = 0;; ++attempt)
      if (const auto v = volume_along(t, volume_direction<integer>(attempt))) return *v;
  }

 private:
  using vector = std::array<integer, 3>;

  static std::vector<rational> exact_speeds(std::span<const moving_plane<integer>> planes) {
    std::vector<rational> speeds;
    for (const auto& p : planes) {
      const integer squared = squared_speed(p);
      if (!is_square(squared)) throw unsupported_error("exact offset volumes need rational speeds");
      speeds.emplace_back(isqrt(squared));
    }
    return speeds;
  }

  rational time(const quadruple& q) const {
    const auto lambda = lambdas(q, [this](plane_id a, plane_id b, plane_id c) { return determinant(planes_[a].n, planes_[b].n, planes_[c].n); });
    integer d = 0;
    rational s = 0;
    for (std::size_t r = 0; r < q.size(); ++r) {
      d += lambda[r] * planes_[q[r]].d;
      s += lambda[r] * speeds_[q[r]];
    }
    if (s == 0) throw invariant_error("internal invariant violated: the planes of an event meet in the limit");
    return d / s;
  }

  // Nothing where the direction is not generic.
  std::optional<rational> volume_along(const rational& t, const vector& c) const {
    rational sum = 0;
    for (const auto& a : s_.arcs) {
      if (times_[static_cast<std::size_t>(a.source)] > t || times_[static_cast<std::size_t>(a.target)] <= t) continue;
      const lawrence_minors<integer> minors(c, {planes_[a.planes[0]].n, planes_[a.planes[1]].n, planes_[a.planes[2]].n});
      if (minors.det == 0) throw invariant_error("internal invariant violated: a vertex that lives for some time is a point");
      if (!minors.is_generic()) return std::nullopt;
      rational height = 0;
      for (std::size_t r = 0; r < 3; ++r) height += minors.m[r] * (planes_[a.planes[r]].d - t * speeds_[a.planes[r]]);
      const int weight = local::product_weight(a.corner) * minors.det.sign();
      sum += weight * height * height * height / rational(6 * minors.det * minors.m[0] * minors.m[1] * minors.m[2]);
    }
    return sum;
  }

  std::span<const moving_plane<integer>> planes_;
  const skeleton& s_;
  std::vector<rational> speeds_;
  std::vector<rational> times_;
};

}  // namespace osteon
