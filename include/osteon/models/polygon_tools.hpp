// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What generators of polygons are made with: points, rings and random numbers.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "osteon/core/random.hpp"

namespace osteon::plane::models {

/// The random numbers of the generators.
using dice = random_stream;
/// A point of the plane with integer coordinates.
using point = std::array<long, 2>;
/// A closed ring of points; the last is joined to the first.
using ring = std::vector<point>;
/// The rings of a polygon, the outer one first.
using region = std::vector<ring>;

/// Returns the point at a distance and an angle (in full turns) from a centre, rounded.
inline point polar(double radius, double turns, const point& centre = {0, 0}) {
  const double angle = 2 * std::numbers::pi * turns;
  return {centre[0] + std::lround(radius * std::cos(angle)), centre[1] + std::lround(radius * std::sin(angle))};
}

/// Returns a random number, uniform in [lo, hi).
inline double uniform(dice& roll, double lo, double hi) { return lo + (hi - lo) * static_cast<double>(roll() >> 11U) * 0x1p-53; }

/// Returns a point moved by up to `most` along each axis, at random.
inline point jittered(const point& p, long most, dice& roll) {
  const long dx = roll.between(-most, most);
  const long dy = roll.between(-most, most);
  return {p[0] + dx, p[1] + dy};
}

/// Returns a radius at which n points around a circle are tens of units apart or more, so that
/// rounding does not change their order by angle.
inline double roomy_radius(int n) { return std::max(1e6, 100.0 * n); }

/// Returns n points around a centre, angles increasing by less than half a turn, so that the ring
/// is simple and sees its centre; radii are uniform in lo .. hi.
inline ring spiky(int n, double lo, double hi, const point& centre, dice& roll) {
  ring points;
  for (int i = 0; i < n; ++i) {
    const double turns = (i + uniform(roll, -0.2, 0.2)) / n;
    points.push_back(polar(uniform(roll, lo, hi), turns, centre));
  }
  return points;
}

}  // namespace osteon::plane::models
