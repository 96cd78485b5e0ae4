// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Polygons along curves, in general position: no two edges parallel, no simultaneous events, but
/// by bad luck.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "osteon/models/polygon_tools.hpp"

namespace osteon::plane::models {

/// Returns a star-shaped polygon of random radii: long thin spikes where n is large.
/// *Requires* n >= 3.
inline region noisy_star(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  return {spiky(n, 0.4 * roomy_radius(n), roomy_radius(n), {0, 0}, roll)};
}

/// Returns a smooth star-shaped curve, a circle and a few harmonics, with noise of the size of an
/// edge.
/// *Requires* n >= 3.
inline region noisy_loop(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  std::array<std::array<double, 2>, 6> waves{};
  for (auto& [amplitude, phase] : waves) amplitude = uniform(roll, 0, 0.1), phase = uniform(roll, 0, 6.2831853);
  const double noise = std::min(0.1, 1.0 / n);
  ring points;
  for (int i = 0; i < n; ++i) {
    const double turns = (i + uniform(roll, -0.2, 0.2)) / n;
    double radius = 1 + uniform(roll, -noise, noise);
    for (std::size_t k = 0; k < waves.size(); ++k)
      radius += waves[k][0] * std::cos(2 * std::numbers::pi * static_cast<double>(k + 2) * turns + waves[k][1]);
    points.push_back(polar(radius * roomy_radius(n), turns));
  }
  return {points};
}

/// Returns a spine with about n / 4 teeth, ten times as long as wide, all vertices jittered.
/// *Requires* n >= 8.
inline region comb(int n, std::uint64_t seed) {
  n = std::max(n, 8);
  dice roll(seed);
  const long teeth = (n - 4) / 4;
  // vertices of the spine's lower side; two more close its ends
  const long below = n - 2 - 4 * teeth;
  const long length = 2000 * teeth + 1000;
  ring points;
  for (long i = 0; i < below; ++i) points.push_back({length * i / (below - 1), -1500});
  points.push_back({length, 0});
  for (long i = teeth; i-- > 0;)
    for (const point& p : {point{2000 * i + 2000, 0}, {2000 * i + 2000, 10000}, {2000 * i + 1000, 10000}, {2000 * i + 1000, 0}}) points.push_back(p);
  points.push_back({0, 0});
  for (point& p : points) p = jittered(p, 150, roll);
  return {points};
}

/// Returns both sides of an Archimedean spiral, half a winding's distance apart, slightly jittered;
/// about sqrt(n) / 5 windings.
/// *Requires* n >= 4.
inline region spiral(int n, std::uint64_t seed) {
  n = std::max(n, 4);
  dice roll(seed);
  const double pitch = 4000;
  // steps of a quarter of the pitch along the curve
  const auto at = [pitch](int i, double inwards) {
    const double turns = std::sqrt(std::numbers::pi * (i + 16)) / (2 * std::numbers::pi);
    return polar(pitch * (turns - inwards), turns);
  };
  ring points;
  for (int i = 0; i < n - n / 2; ++i) points.push_back(at(i, 0));
  for (int i = n / 2; i-- > 0;) points.push_back(at(i, 0.5));
  for (point& p : points) p = jittered(p, 80, roll);
  return {points};
}

}  // namespace osteon::plane::models
