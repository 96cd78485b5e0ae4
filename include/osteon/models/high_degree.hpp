// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids with a vertex of high degree.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "osteon/input/geometry.hpp"
#include "osteon/models/mesh_builder.hpp"
#include "osteon/models/prisms.hpp"

namespace osteon::models {

/// Returns a pyramid whose base is a star polygon of k corners with random radii: an apex of degree
/// k, about half of its edges reflex.
inline builder cone(int k, std::uint64_t seed) {
  dice roll(seed);
  polygon base;
  for (int i = 0; i < k; ++i) base.push_back(on_circle(i, k, static_cast<double>(roll.between(400'000, 1'000'000))));
  return pyramid(base, 500'000 + roll.between(0, 99'999));
}

/// Returns a pyramid over a random simple polygon of k corners, seldom star-shaped: grown from a
/// triangle, a corner at a time, across random edges.
inline builder spire(int k, std::uint64_t seed) {
  dice roll(seed);
  const auto draw = [&roll] { return std::array<long, 2>{roll.between(-1'000'000, 1'000'000), roll.between(-1'000'000, 1'000'000)}; };
  const auto left = [](const auto& p, const auto& q, const auto& r) { return turn(p, q, r) == sign::positive; };
  const auto meet = [&left](const auto& p, const auto& q, const auto& r, const auto& s) {
    return left(p, q, r) != left(p, q, s) && left(r, s, p) != left(r, s, q);
  };
  polygon base = {{-900'000, -800'000}, {900'000, -700'000}, {0, 900'000}};
  while (static_cast<int>(base.size()) < k) {
    const auto fresh = draw();
    const auto at = static_cast<std::size_t>(roll.between(0, static_cast<long>(base.size()) - 1));
    const std::size_t next = (at + 1) % base.size();
    bool free = true;
    for (std::size_t i = 0; i < base.size() && free; ++i) {
      const std::size_t j = (i + 1) % base.size();
      free = turn(base[i], base[j], fresh) != sign::zero;
      for (const std::size_t end : {at, next})
        if (i != end && j != end) free = free && !meet(base[end], fresh, base[i], base[j]);
    }
    if (free) base.insert(base.begin() + static_cast<std::ptrdiff_t>(at) + 1, fresh);
  }
  long area = 0;
  for (std::size_t i = 0; i < base.size(); ++i) area += twice_area({0, 0}, base[i], base[(i + 1) % base.size()]) / 1000;
  if (area < 0) std::reverse(base.begin(), base.end());
  return pyramid(base, 500'000 + roll.between(0, 99'999));
}

/// Returns a plate whose top is a fan of triangles around the origin, between neighbours of a rim
/// that runs round it; the floor is flat, at height `floor`.
inline builder fan_on_plate(const std::vector<point>& rim, long floor) {
  builder b;
  std::vector<point> low = rim;
  for (point& p : low) p[2] = floor;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t j = (i + 1) % rim.size();
    b.facet({rim[i], rim[j], {0, 0, 0}});
    b.facet({low[i], low[j], rim[j], rim[i]});
  }
  std::reverse(low.begin(), low.end());
  b.facet(low);
  return b;
}

/// Returns a fan on a plate with random heights at the rim: a vertex of degree k, its edges convex
/// and reflex at random, seldom pointed.
inline builder peak(int k, std::uint64_t seed) {
  dice roll(seed);
  std::vector<point> rim;
  for (int i = 0; i < k; ++i) {
    const auto p = on_circle(i, k, static_cast<double>(roll.between(600'000, 1'000'000)));
    rim.push_back({p[0], p[1], roll.between(-500'000, 500'000)});
  }
  return fan_on_plate(rim, -2'000'000);
}

/// Returns a pyramid over a hub with n arms of five corners each, slightly irregular: every arm can
/// be split in several ways whatever the others do, so that the number of ways to split the apex
/// grows exponentially (thesis 3.7).
inline builder arms(int n, std::uint64_t seed) {
  dice roll(seed);
  polygon base;
  const double hub = 250'000.0 * n;
  const auto corner = [&](int arm, double out, double across) {
    const double radius = hub + out;
    const auto p = on_circle(arm, n, std::hypot(radius, across), std::atan2(across, radius) * n / (2 * std::numbers::pi));
    base.push_back({p[0] + roll.between(-99, 99), p[1] + roll.between(-99, 99)});
  };
  for (int arm = 0; arm < n; ++arm) {
    corner(arm, 0, -500'000);
    corner(arm, 500'000, -100'000);
    corner(arm, 1'500'000, -10'000);
    corner(arm, 500'000, 100'000);
    corner(arm, 0, 500'000);
  }
  return pyramid(base, 1'000'000);
}

/// Returns a star of n points with two vertices of degree 2n, slightly irregular.
inline builder star(int n, std::uint64_t seed) {
  dice roll(seed);
  builder b;
  std::vector<point> rim;
  for (int i = 0; i < 2 * n; ++i) {
    const auto p = on_circle(i, 2 * n, i % 2 == 0 ? 1000 : 420);
    rim.push_back({p[0] + roll.between(-20, 20), p[1] + roll.between(-20, 20), i % 2 == 0 ? roll.between(60, 90) : roll.between(-90, -60)});
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const point& p = rim[i];
    const point& q = rim[(i + 1) % rim.size()];
    b.facet({p, q, {0, 0, 300}});
    b.facet({q, p, {0, 0, -300}});
  }
  return b;
}

/// Returns a block whose top corners are lifted and lowered in turn around a middle point: a saddle
/// of degree four.
inline builder saddle() {
  builder b;
  const std::array<point, 4> top = {{{50, 50, 90}, {-40, 60, 40}, {-55, -45, 95}, {45, -60, 35}}};
  const std::array<point, 4> low = {{{50, 50, -60}, {-40, 60, -60}, {-55, -45, -60}, {45, -60, -60}}};
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    b.facet({top[i], top[j], {3, 2, 55}});
    b.facet({low[i], low[j], top[j], top[i]});
  }
  b.facet({low[3], low[2], low[1], low[0]});
  return b;
}

}  // namespace osteon::models
