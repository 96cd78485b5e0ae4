// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Random corners of any degree.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polyhedra.hpp"
#include "osteon/space/corner.hpp"

namespace osteon::test {

/// Facet i has plane i, and where `rays` are given it lies between rays i and i + 1.
struct random_corner {
  std::vector<moving_plane<integer>> planes;
  corner of;
  std::vector<std::array<integer, 3>> rays;
};

/// The vertex of a terrain over k sectors: convex, reflex or mixed, pointed or not. Nothing where two neighbours are coplanar.
inline std::optional<random_corner> make_corner(int k, std::uint64_t seed) {
  models::dice roll(seed);
  const long steep = std::array<long, 4>{300, 900, 3000, 12000}[static_cast<std::size_t>(roll.between(0, 3))];
  using direction = std::array<integer, 3>;
  std::vector<direction> rays;
  for (int i = 0; i < k; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.8 * static_cast<double>(roll.between(0, 1000)) / 1000) / k;
    const double length = 1000 + 2.0 * static_cast<double>(roll.between(0, 1000));
    rays.push_back(
        {integer(std::lround(length * std::cos(angle))), integer(std::lround(length * std::sin(angle))), integer(roll.between(-steep, steep))});
  }
  const auto across = [](const direction& x, const direction& y) {
    return direction{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  };
  random_corner c;
  c.rays = rays;
  for (int i = 0; i < k; ++i) {
    c.planes.push_back({across(rays[i], rays[(i + 1) % k]), integer(0)});
    c.of.facets.push_back(i);
  }
  for (int i = 0; i < k; ++i) {
    const direction bend = across(c.planes[i].n, c.planes[(i + 1) % k].n);
    const direction& ray = rays[(i + 1) % k];
    const integer s = bend[0] * ray[0] + bend[1] * ray[1] + bend[2] * ray[2];
    if (s == 0) return std::nullopt;
    c.of.convex.push_back(s < 0);
  }
  return c;
}

/// The vertex of a terrain over k sectors, some of which lie in one horizontal plane. Nothing where neighbours are coplanar.
inline std::optional<random_corner> make_flat_corner(int k, std::uint64_t seed) {
  models::dice roll(seed);
  random_corner c;
  for (int i = 0; i < k; ++i) {
    const auto p = models::on_circle(i, k, static_cast<double>(roll.between(1000, 3000)));
    c.rays.push_back({integer(p[0]), integer(p[1]), integer(roll.between(0, 9) < 6 ? 0 : roll.between(-1500, 1500))});
  }
  const auto across = [](const auto& x, const auto& y) {
    return std::array<integer, 3>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  };
  const auto at = [k](int i) { return static_cast<std::size_t>(i % k); };
  int flat = -1;
  for (int i = 0; i < k; ++i) {
    auto n = across(c.rays[at(i)], c.rays[at(i + 1)]);
    const bool level = n[0] == 0 && n[1] == 0;
    if (level && flat >= 0) {
      c.of.facets.push_back(flat);
      continue;
    }
    if (level) {
      n[2] = 1;
      flat = static_cast<int>(c.planes.size());
    }
    c.of.facets.push_back(static_cast<int>(c.planes.size()));
    c.planes.push_back({n, integer(0)});
  }
  for (int i = 0; i < k; ++i) {
    if (c.of.facets[at(i)] == c.of.facets[at(i + 1)]) return std::nullopt;
    const auto bend = across(c.planes[static_cast<std::size_t>(c.of.facets[at(i)])].n, c.planes[static_cast<std::size_t>(c.of.facets[at(i + 1)])].n);
    const auto& ray = c.rays[at(i + 1)];
    c.of.convex.push_back(bend[0] * ray[0] + bend[1] * ray[1] + bend[2] * ray[2] < 0);
  }
  return c;
}

/// The apex of a pyramid over k points of a parabola and a chord.
inline random_corner make_convex_corner(int k, std::uint64_t seed) {
  models::dice roll(seed);
  std::vector<long> at;
  for (long x = 0; static_cast<int>(at.size()) < k; x += roll.between(1, 5)) at.push_back(x);
  random_corner c;
  const long height = roll.between(1, 9) * at.back() * at.back() / 4 + 1;
  const auto ray = [&](int i) {
    const long x = at[static_cast<std::size_t>(i % k)] * 2 - at.back();
    return std::array<integer, 3>{integer(x), integer(x) * x - integer(at.back()) * at.back() / 2, integer(-height)};
  };
  for (int i = 0; i < k; ++i) {
    const auto x = ray(i);
    const auto y = ray(i + 1);
    c.planes.push_back({{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]}, integer(0)});
    c.of.facets.push_back(i);
    c.of.convex.push_back(true);
  }
  return c;
}

/// The apex over a simple polygon, counter-clockwise. Its facets' speeds are random, 1 .. fastest. Nothing where neighbours are coplanar.
inline std::optional<random_corner> make_apex_over(const std::vector<std::array<long, 2>>& polygon, long height, long fastest, models::dice& roll) {
  const std::size_t n = polygon.size();
  random_corner c;
  for (const auto& p : polygon) c.rays.push_back({integer(p[0]), integer(p[1]), integer(-height)});
  const auto across = [](const auto& x, const auto& y) {
    return std::array<integer, 3>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  };
  for (std::size_t i = 0; i < n; ++i) {
    c.planes.push_back({across(c.rays[i], c.rays[(i + 1) % n]), integer(0), integer(roll.between(1, fastest))});
    c.of.facets.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const integer s = inner_product(across(c.planes[i].n, c.planes[(i + 1) % n].n), c.rays[(i + 1) % n]);
    if (s == 0) return std::nullopt;
    c.of.convex.push_back(s < 0);
  }
  return c;
}

/// The apex over a random simple polygon. It may lie beside it, so that facets overhang. Nothing where two points of the polygon and another one are
/// collinear, as far as that is noticed.
inline std::optional<random_corner> make_pointed_corner(int k, std::uint64_t seed, long fastest) {
  models::dice roll(seed);
  using point = std::array<long, 2>;
  const auto n = static_cast<std::size_t>(k);
  std::vector<point> at;
  while (at.size() < n) at.push_back({roll.between(-1000, 1000), roll.between(-1000, 1000)});
  const auto turn = [](const point& a, const point& b, const point& c) { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
  for (bool crossed = true; crossed;) {  // ends: turning round what lies between two crossing edges makes the polygon shorter
    crossed = false;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j) {
        const point& a = at[i];
        const point& b = at[i + 1];
        const point& c = at[j];
        const point& d = at[(j + 1) % n];
        const std::array<long, 4> turns = {turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)};
        if (std::find(turns.begin(), turns.end(), 0) != turns.end()) return std::nullopt;
        if ((turns[0] > 0) == (turns[1] > 0) || (turns[2] > 0) == (turns[3] > 0)) continue;
        std::reverse(at.begin() + static_cast<std::ptrdiff_t>(i) + 1, at.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossed = true;
      }
  }
  long area = 0;
  for (std::size_t i = 0; i < n; ++i) area += at[i][0] * at[(i + 1) % n][1] - at[i][1] * at[(i + 1) % n][0];
  if (area < 0) std::reverse(at.begin(), at.end());
  const long height = std::array<long, 4>{100, 400, 1500, 6000}[static_cast<std::size_t>(roll.between(0, 3))];
  const point beside = {roll.between(0, 1) * roll.between(-3000, 3000), roll.between(-2000, 2000)};
  for (point& p : at) p = {p[0] + beside[0], p[1] + beside[1]};
  return make_apex_over(at, height, fastest, roll);
}

/// The apex over random points of a circle, in general position: make_convex_corner may be symmetric.
inline std::optional<random_corner> make_round_corner(int k, std::uint64_t seed, long fastest) {
  models::dice roll(seed);
  const std::array<long, 2> beside = {roll.between(-900'000, 900'000), roll.between(-900'000, 900'000)};
  std::vector<std::array<long, 2>> at;
  for (int i = 0; i < k; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.4 * static_cast<double>(roll.between(0, 1000)) / 1000) / k;
    at.push_back({std::lround(1e6 * std::cos(angle)) + beside[0], std::lround(1e6 * std::sin(angle)) + beside[1]});
  }
  return make_apex_over(at, roll.between(100'000, 3'000'000), fastest, roll);
}

/// The same surface with the solid on its other side.
inline random_corner complement(const random_corner& c) {
  random_corner result;
  for (auto p = c.planes.rbegin(); p != c.planes.rend(); ++p) {
    result.planes.push_back({{-p->n[0], -p->n[1], -p->n[2]}, integer(0)});
    result.of.facets.push_back(static_cast<int>(result.of.facets.size()));
    result.of.convex.push_back(false);
  }
  return result;
}

}  // namespace osteon::test
