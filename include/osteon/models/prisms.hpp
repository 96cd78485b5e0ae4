// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids over polygons, and between two profiles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "osteon/models/mesh_builder.hpp"

namespace osteon::models {

/// A polygon: one ring of points, counter-clockwise.
using polygon = std::vector<std::array<long, 2>>;

/// Returns a prism over a simple polygon from z = 0 to height > 0.
inline builder prism(const polygon& base, long height) {
  builder b;
  std::vector<point> top;
  std::vector<point> bottom;
  const std::size_t n = base.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % n];
    top.push_back({p[0], p[1], height});
    bottom.insert(bottom.begin(), {p[0], p[1], 0});
    b.facet({{p[0], p[1], 0}, {q[0], q[1], 0}, {q[0], q[1], height}, {p[0], p[1], height}});
  }
  b.facet(top);
  b.facet(bottom);
  return b;
}

/// Returns a pyramid over a polygon that sees the apex's foot, the origin, from everywhere.
inline builder pyramid(const polygon& base, long height) {
  builder b;
  std::vector<point> bottom;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % base.size()];
    bottom.insert(bottom.begin(), {p[0], p[1], 0});
    b.facet({{p[0], p[1], 0}, {q[0], q[1], 0}, {0, 0, height}});
  }
  b.facet(bottom);
  return b;
}

/// Returns corner i of n on a circle around the origin, rounded to integers; the corners are turned
/// by `offset`, in n-ths of a full turn.
inline std::array<long, 2> on_circle(int i, int n, double radius, double offset = 0) {
  const double angle = 2 * std::numbers::pi * (i + offset) / n;
  return {std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))};
}

/// Returns a box with sides a, b and c, a corner at the origin.
inline builder box(long a, long b, long c) { return prism({{0, 0}, {a, 0}, {a, b}, {0, b}}, c); }

/// Returns n steps of rise and run 1, as a prism of width n.
inline builder stairs(int n) {
  polygon profile = {{0, 0}, {n, 0}};
  for (long i = 0; i < n; ++i) {
    profile.push_back({n - i, i + 1});
    profile.push_back({n - i - 1, i + 1});
  }
  profile.pop_back();
  profile.push_back({0, n});
  return prism(profile, n);
}

/// Returns a box with a V-shaped notch of depth d along its top.
/// *Requires* 0 < d < 6.
inline builder notched_box(long d) { return prism({{0, 0}, {10, 0}, {10, 6}, {7, 6}, {5, 6 - d}, {3, 6}, {0, 6}}, 8); }

/// Returns a solid between two n-gons, the upper one turned: with `reflex` the sides fold inwards
/// (Schoenhardt's solid for n = 3), else the solid is an antiprism.
inline builder twisted_prism(int n, bool reflex) {
  builder b;
  std::vector<point> low;
  std::vector<point> high;
  for (int i = 0; i < n; ++i) {
    const auto p = on_circle(i, n, 1000);
    const auto q = on_circle(i, n, 1000, reflex ? 0.25 : 0.5);
    low.push_back({p[0], p[1], 0});
    high.push_back({q[0], q[1], 1200});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    if (reflex) {
      b.facet({low[i], low[j], high[j]});
      b.facet({low[i], high[j], high[i]});
      continue;
    }
    b.facet({low[i], low[j], high[i]});
    b.facet({low[j], high[j], high[i]});
  }
  b.facet(high);
  std::reverse(low.begin(), low.end());
  b.facet(low);
  return b;
}

/// Returns the solid under z = f(x) and above z = -g(y) over a square; f and g are polylines over
/// the same positions.
inline builder between_profiles(const std::vector<std::array<long, 2>>& f, const std::vector<std::array<long, 2>>& g) {
  builder b;
  const long lo = f.front()[0];
  const long hi = f.back()[0];
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    b.facet({{f[i][0], lo, f[i][1]}, {f[i + 1][0], lo, f[i + 1][1]}, {f[i + 1][0], hi, f[i + 1][1]}, {f[i][0], hi, f[i][1]}});
  for (std::size_t i = 0; i + 1 < g.size(); ++i)
    b.facet({{lo, g[i][0], -g[i][1]}, {lo, g[i + 1][0], -g[i + 1][1]}, {hi, g[i + 1][0], -g[i + 1][1]}, {hi, g[i][0], -g[i][1]}});
  std::vector<point> south, north, west, east;
  for (const auto& p : f) south.insert(south.begin(), {p[0], lo, p[1]}), north.push_back({p[0], hi, p[1]});
  south.push_back({lo, lo, -g.front()[1]}), south.push_back({hi, lo, -g.front()[1]});
  north.push_back({hi, hi, -g.back()[1]}), north.push_back({lo, hi, -g.back()[1]});
  for (const auto& p : g) east.push_back({hi, p[0], -p[1]}), west.insert(west.begin(), {lo, p[0], -p[1]});
  east.push_back({hi, hi, f.back()[1]}), east.push_back({hi, lo, f.back()[1]});
  west.push_back({lo, lo, f.front()[1]}), west.push_back({lo, hi, f.front()[1]});
  for (const auto& wall : {south, north, west, east}) b.facet(wall);
  return b;
}

/// Returns Held's convex solid with n facets above and n below, a thin lens: almost every facet
/// above meets every one below, so that its skeleton has about n^2 sheets (Held 1994, thesis 3.1).
inline builder held(int n) {
  std::vector<std::array<long, 2>> arch;
  for (long i = 0; i <= n; ++i) arch.push_back({100 * (2 * i - n), 2L * n * n - (2 * i - n) * (2 * i - n)});
  return between_profiles(arch, arch);
}

/// Returns a flat box with n grooves above and n across below, whose reflex edges all cross
/// (thesis, iron maiden pizza box).
inline builder pizza_box(int n) {
  std::vector<std::array<long, 2>> f, g;
  for (long i = 0; i <= 2L * n; ++i) {
    f.push_back({12 * (i - n), i % 2 == 0 ? 40 : 12 + i % 3});
    g.push_back({12 * (i - n), i % 2 == 0 ? 41 : 11 + i % 5});
  }
  return between_profiles(f, g);
}

}  // namespace osteon::models
