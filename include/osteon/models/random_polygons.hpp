// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Random polygons through random points, with and without holes, in general position.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "osteon/input/geometry.hpp"
#include "osteon/models/polygon_tools.hpp"

namespace osteon::plane::models {

/// Orders points into a simple chain between two others, all in general position: a random line
/// through one of the points, which becomes the chain's middle, separates the others and the ends;
/// the halves' hulls share only that point. Returns false where points are collinear or too close.
/// *Complexity* expected O(n log n).
/// *Source* space partitioning, after Auer, Held: Heuristics for the generation of random polygons.
/// CCCG 1996.
inline bool chain(const point& from, const point& to, std::span<point> inner, dice& roll) {
  if (inner.empty()) return true;
  if (inner.size() == 1) return turn(from, inner[0], to) != sign::zero;
  for (int attempt = 0; attempt < 64; ++attempt) {
    std::swap(inner[0], inner[roll() % inner.size()]);
    const point middle = inner[0];
    const double t = uniform(roll, 0, 1);
    point towards{};
    for (const int k : {0, 1}) towards[k] = from[k] + std::lround(t * static_cast<double>(to[k] - from[k]));
    const sign side = turn(middle, towards, from);
    const auto with_from = [&](const point& p) { return turn(middle, towards, p) == side; };
    const auto rest = inner.subspan(1);
    if (side == sign::zero || turn(middle, towards, to) != -side) continue;
    if (std::any_of(rest.begin(), rest.end(), [&](const point& p) { return turn(middle, towards, p) == sign::zero; })) continue;
    const auto half = static_cast<std::size_t>(std::partition(rest.begin(), rest.end(), with_from) - rest.begin());
    std::swap(inner[0], inner[half]);
    return chain(from, middle, inner.subspan(0, half), roll) && chain(middle, to, inner.subspan(half + 1), roll);
  }
  return false;
}

/// Returns a simple polygon through n uniformly random points of a square.
/// *Requires* n >= 3.
/// *Complexity* expected O(n log n).
inline region random_polygon(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  const long half = std::clamp(500L * n, 1'000'000L, 1'000'000'000L);
  for (;;) {  // seldom more than once
    ring points;
    for (int i = 0; i < n; ++i) points.push_back(jittered({0, 0}, half, roll));
    const std::span<point> all(points);
    const point a = all[0];
    const point b = all[1];
    const auto rest = all.subspan(2);
    if (a == b || std::any_of(rest.begin(), rest.end(), [&](const point& p) { return turn(a, b, p) == sign::zero; })) continue;
    const auto right = static_cast<std::size_t>(
        std::partition(rest.begin(), rest.end(), [&](const point& p) { return turn(a, b, p) == sign::negative; }) - rest.begin());
    if (!chain(a, b, rest.subspan(0, right), roll) || !chain(b, a, rest.subspan(right), roll)) continue;
    // b follows those on its right
    std::rotate(all.begin() + 1, all.begin() + 2, all.begin() + 2 + static_cast<std::ptrdiff_t>(right));
    return {points};
  }
}

/// Returns the distance from p to the edges of a polygon, computed in doubles; negative where p is
/// not inside.
inline double clearance(const region& r, const point& p) {
  double nearest = 1e300;
  bool inside = false;
  for (const ring& points : r)
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
      const auto ax = static_cast<double>(points[j][0] - p[0]);
      const auto ay = static_cast<double>(points[j][1] - p[1]);
      const auto bx = static_cast<double>(points[i][0] - p[0]);
      const auto by = static_cast<double>(points[i][1] - p[1]);
      if ((ay > 0) != (by > 0) && (ax * by - ay * bx > 0) == (by > ay)) inside = !inside;
      const double dx = bx - ax;
      const double dy = by - ay;
      const double t = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(ax + t * dx, ay + t * dy));
    }
  return inside ? nearest : -nearest;
}

/// Returns a random polygon with up to h star-shaped holes of 3 .. 8 vertices where there is room
/// for them; n vertices in all, fewer where a hole finds no room.
/// *Requires* n >= 3, h >= 0.
/// *Complexity* expected O(n (h + log n)).
inline region random_with_holes(int n, int h, std::uint64_t seed) {
  dice roll(seed);
  std::vector<int> holes;
  int outer = std::max(n, 3);
  while (static_cast<int>(holes.size()) < h && outer >= 3 + 8) outer -= holes.emplace_back(static_cast<int>(roll.between(3, 8)));
  region r = random_polygon(outer, roll());
  point lo = r[0][0];
  point hi = lo;
  for (const point& p : r[0])
    for (const int k : {0, 1}) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
  for (const int corners : holes) {
    double room = 0;
    point centre{};
    for (int attempt = 0, found = 0; attempt < 50 && found < 3; ++attempt) {
      const point p = {roll.between(lo[0], hi[0]), roll.between(lo[1], hi[1])};
      const double distance = clearance(r, p);
      if (distance > 0) ++found;
      if (distance > room) room = distance, centre = p;
    }
    if (room < 100) continue;
    ring hole = spiky(corners, 0.3 * room, 0.9 * room, centre, roll);
    std::reverse(hole.begin(), hole.end());
    r.push_back(std::move(hole));
  }
  return r;
}

/// Returns a square with k x k holes, squares that are turned, moved and scaled at random; all
/// corners are jittered. 4 k^2 + 4 vertices.
/// *Requires* k >= 1.
inline region jittered_holes(int k, std::uint64_t seed) {
  k = std::max(k, 1);
  dice roll(seed);
  const long side = 10000L * k;
  region r = {{{0, 0}, {side, 0}, {side, side}, {0, side}}};
  for (long x = 0; x < k; ++x)
    for (long y = 0; y < k; ++y) {
      const point centre = jittered({10000 * x + 5000, 10000 * y + 5000}, 1200, roll);
      const double radius = uniform(roll, 1500, 3500);
      const double turns = uniform(roll, 0, 0.25);
      ring& hole = r.emplace_back();
      for (int i = 4; i-- > 0;) hole.push_back(jittered(polar(radius, turns + i * 0.25, centre), 100, roll));
    }
  for (point& p : r[0]) p = jittered(p, 100, roll);
  return r;
}

}  // namespace osteon::plane::models
