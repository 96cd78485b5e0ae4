// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Symmetric and regular polygons, stairs, and squares with a grid of holes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "osteon/models/polygon_tools.hpp"

namespace osteon::plane::models {

/// Returns a square with k x k unit squares as holes, one apart. 4 k^2 + 4 vertices.
/// *Requires* k >= 1.
inline region grid_of_holes(int k) {
  k = std::max(k, 1);
  const long side = 2L * k + 1;
  region r = {{{0, 0}, {side, 0}, {side, side}, {0, side}}};
  for (long x = 1; x < side; x += 2)
    for (long y = 1; y < side; y += 2) r.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
  return r;
}

/// Returns steps of rise and run 1 on the legs of a right angle. An odd n gives one vertex less.
/// *Requires* n >= 4.
inline region stairs(int n) {
  const long steps = std::max(n / 2 - 1, 1);
  ring points = {{0, 0}};
  for (long i = 0; i < steps; ++i) {
    points.push_back({steps - i, i});
    points.push_back({steps - i, i + 1});
  }
  points.push_back({0, steps});
  return {points};
}

/// Returns a star with random radii that is exactly symmetric in both axes and both diagonals:
/// events come by eights at a time, or all at the origin. An n that is no multiple of four gives up
/// to three vertices less.
/// *Requires* n >= 4.
inline region symmetric(int n, std::uint64_t seed) {
  n = std::max(n, 4);
  dice roll(seed);
  const int inner = n / 8;
  const double radius = roomy_radius(n);
  ring octant;  // from the x axis to the diagonal, without it
  if (n % 8 >= 4) octant.push_back({std::lround(uniform(roll, 0.4, 1) * radius), 0});
  for (int i = 0; i < inner; ++i) octant.push_back(polar(uniform(roll, 0.4, 1) * radius, (i + 0.5 + uniform(roll, -0.2, 0.2)) / (8.0 * inner)));
  ring points = octant;
  for (std::size_t i = octant.size(); i-- > 0;)
    if (octant[i][1] != 0) points.push_back({octant[i][1], octant[i][0]});
  const std::size_t quarter = points.size();
  for (std::size_t i = 0; i < 3 * quarter; ++i) points.push_back({-points[i][1], points[i][0]});
  return {points};
}

/// Returns a regular polygon, rounded so slightly that it stays strictly convex: almost all events
/// at almost one time.
/// *Requires* n >= 3.
inline region regular(int n) {
  n = std::max(n, 3);
  const double radius = std::max(1e6, static_cast<double>(n) * n);
  ring points;
  for (int i = 0; i < n; ++i) points.push_back(polar(radius, static_cast<double>(i) / n));
  return {points};
}

/// Returns a rounded gear of n / 4 tapered teeth. An n that is no multiple of four gives up to
/// three vertices less.
/// *Requires* n >= 8.
inline region gear(int n) {
  const int teeth = std::max(n / 4, 2);
  const double radius = roomy_radius(4 * teeth);
  const double root = radius * (1 - std::min(1.0 / 3, 4 * std::numbers::pi / teeth));
  ring points;
  for (int i = 0; i < teeth; ++i) {
    points.push_back(polar(root, (i + 0.0) / teeth));
    points.push_back(polar(radius, (i + 0.15) / teeth));
    points.push_back(polar(radius, (i + 0.4) / teeth));
    points.push_back(polar(root, (i + 0.55) / teeth));
  }
  return {points};
}

}  // namespace osteon::plane::models
