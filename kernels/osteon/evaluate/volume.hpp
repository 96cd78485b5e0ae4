// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The volume of the offset solid at a rational time, exactly, for solids whose speeds are all rational (boxes,
/// voxels, Pythagorean slopes).

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// The speeds of planes, rounded down to multiples of 2^-128.
inline std::vector<rational> rounded_speeds(std::span<const moving_plane<integer>> planes) {
  std::vector<rational> speeds;
  for (const auto& p : planes) {
    const integer squared = (p.n[0] * p.n[0] + p.n[1] * p.n[1] + p.n[2] * p.n[2]) * p.weight * p.weight;
    speeds.emplace_back(isqrt(squared << 256U), integer(1) << 128U);
  }
  return speeds;
}

/// Answers for one skeleton. The volume is a sum over the vertices alive at the time (Lawrence 1991; a corner is a
/// signed sum of products of half-spaces, see local::product_weight).
class rational_offsets {
 public:
  /// Exact. Throws unsupported_error where a speed is irrational.
  rational_offsets(std::span<const moving_plane<integer>> planes, const skeleton& s) : rational_offsets(planes, s, exact_speeds(planes)) {}

  /// With given speeds: as exact as they are.
  rational_offsets(std::span<const moving_plane<integer>> planes, const skeleton& s, std::vector<rational> speeds)
      : planes_(planes), s_(s), speeds_(std::move(speeds)) {
    for (const auto& n : s.nodes) times_.push_back(n.vertex >= 0 ? rational(0) : time(n.planes));
  }

  /// Limit times of the nodes.
  const std::vector<rational>& times() const { return times_; }

  /// Volume of the offset solid, in the solid's own unit cubed. At the moment of an event it is the limit from both sides. t >= 0.
  rational volume(const rational& t) const {
    for (int attempt = 0;; ++attempt)
      if (const auto v = volume_along(t, direction(attempt))) return *v;
  }

 private:
  using vector = std::array<integer, 3>;

  static std::vector<rational> exact_speeds(std::span<const moving_plane<integer>> planes) {
    std::vector<rational> speeds;
    for (const auto& p : planes) {
      const integer squared = p.n[0] * p.n[0] + p.n[1] * p.n[1] + p.n[2] * p.n[2];
      if (!is_square(squared)) throw unsupported_error("exact offset volumes need rational speeds");
      speeds.emplace_back(isqrt(squared) * p.weight);
    }
    return speeds;
  }

  static vector direction(int attempt) {
    const auto u = perturbation::of(-2 - attempt).u;
    return {u[0], u[1], u[2]};
  }

  static integer det(const vector& a, const vector& b, const vector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  rational time(const quadruple& q) const {
    const auto minor = [&](int a, int b, int c) { return det(planes_[q[a]].n, planes_[q[b]].n, planes_[q[c]].n); };
    const std::array<integer, 4> lambda = {-minor(1, 2, 3), minor(0, 2, 3), -minor(0, 1, 3), minor(0, 1, 2)};
    integer d = 0;
    rational s = 0;
    for (int r = 0; r < 4; ++r) {
      d += lambda[r] * planes_[q[r]].d;
      s += lambda[r] * speeds_[q[r]];
    }
    if (s == 0) throw invariant_error("internal invariant violated: the planes of an event meet in the limit");
    return d / s;
  }

  // With c = (ma na + mb nb + mc nc) / det and c . v = (ma da + mb db + mc dc) / det, the term is
  // (c . v)^3 / (6 |det| ga gb gc) = sign(det) (sum m h)^3 / (6 det ma mb mc).
  std::optional<rational> volume_along(const rational& t, const vector& c) const {
    rational sum = 0;
    for (const auto& a : s_.arcs) {
      if (times_[static_cast<std::size_t>(a.source)] > t || times_[static_cast<std::size_t>(a.target)] <= t) continue;
      std::array<vector, 3> n;
      std::array<rational, 3> h;
      for (int r = 0; r < 3; ++r) {
        n[r] = planes_[a.planes[r]].n;
        h[r] = planes_[a.planes[r]].d - t * speeds_[a.planes[r]];
      }
      const integer whole = det(n[0], n[1], n[2]);
      if (whole == 0) throw invariant_error("internal invariant violated: a vertex that lives for some time is a point");
      const std::array<integer, 3> m = {det(c, n[1], n[2]), det(n[0], c, n[2]), det(n[0], n[1], c)};
      if (m[0] == 0 || m[1] == 0 || m[2] == 0) return std::nullopt;
      const rational height = m[0] * h[0] + m[1] * h[1] + m[2] * h[2];
      const int weight = local::product_weight(a.corner) * whole.sign();
      sum += weight * height * height * height / rational(6 * whole * m[0] * m[1] * m[2]);
    }
    return sum;
  }

  std::span<const moving_plane<integer>> planes_;
  const skeleton& s_;
  std::vector<rational> speeds_;
  std::vector<rational> times_;
};

}  // namespace osteon
