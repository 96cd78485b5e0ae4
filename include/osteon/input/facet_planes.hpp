// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The planes of a surface's facets.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/rough_points.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// Returns whether the points of a facet lie in one plane; true where the facet has no area.
/// *Complexity* linear in the facet.
template <class Int>
bool is_planar(const surface<Int>& s, std::size_t f) {
  const vec<Int> n = s.area(f);
  if (n == vec<Int>{Int(0), Int(0), Int(0)}) return true;
  const auto& loop = s.loop(f);
  return std::all_of(loop.begin(), loop.end(), [&](int p) { return dot(n, s.points[p]) == dot(n, s.points[loop[0]]); });
}

namespace detail {

/// Returns the logarithm of a positive integer that need not fit a double.
template <class Int>
double log10_of(const Int& x) {
  const unsigned shift = double_shift(x);
  return std::log10(static_cast<double>(Int(x >> shift))) + shift * std::log10(2.0);
}

/// Throws that a facet has points outside of the plane n . x = d; names the farthest.
template <class Int>
[[noreturn]] void refuse_not_planar(const surface<Int>& s, std::size_t f, const vec<Int>& n, const Int& d) {
  Int farthest = 0;
  int worst = 0;
  for (const int p : s.loop(f)) {
    Int away = dot(n, s.points[p]) - d;
    if (away < 0) away = -away;
    if (away > farthest) {
      farthest = away;
      worst = p;
    }
  }
  // In logarithms: neither these numbers nor the distance need fit a double.
  const double distance = log10_of(farthest) - log10_of(Int(dot(n, n))) / 2 + s.ten + s.two * std::log10(2.0);
  const double exponent = std::abs(distance) < 300 ? 0 : std::floor(distance);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), exponent == 0 ? "%.3g" : "%.3ge%.0f", std::pow(10.0, distance - exponent), exponent);
  s.input.refuse_facet(input_fault::not_planar, f, " is not planar: point " + std::to_string(worst + 1) + " is off by " + text.data(),
                       "cut such facets into triangles (--triangulate)");
}

/// Checks that adjacent facets in one plane have one weight and are not folded onto each other.
template <class Int>
void check_neighbours(const surface<Int>& s) {
  for (const auto& h : s.edges) {
    const auto f = static_cast<std::size_t>(h.facet);
    const auto g = static_cast<std::size_t>(s.edges[h.twin].facet);
    const auto& p = s.plane(f);
    const auto& q = s.plane(g);
    const auto refuse = [&](input_fault fault, const std::string& what, const std::string& hint) {
      s.input.refuse_facet(fault, f, " and facet " + std::to_string(g + 1) + what, hint);
    };
    if (p.n == q.n && p.weight != q.weight)
      refuse(input_fault::weight_conflict, " lie in one plane but have different weights", "give both the same weight");
    if (p.n == vec<Int>{-q.n[0], -q.n[1], -q.n[2]}) refuse(input_fault::folded, " are folded onto each other", "delete both");
  }
}

}  // namespace detail

/// Finds the planes of all facets. Facets with equal plane and weight share a number; planes are
/// numbered in the order of their first facets.
/// *Throws* input_error for facets without area or not planar, and for adjacent facets in one plane
/// that are folded onto each other or have different weights.
/// *Complexity* linear, but for sorting.
template <class Int>
void find_planes(surface<Int>& s) {
  const auto& weights = s.input.weights;
  std::map<moving_plane<Int>, plane_id> ids;
  for (std::size_t f = 0; f < s.input.facets.size(); ++f) {
    vec<Int> n = s.area(f);
    if (n == vec<Int>{Int(0), Int(0), Int(0)}) s.input.refuse_facet(input_fault::zero_area, f, " has area zero", "delete it and join its neighbours");
    Int divisor = n[0];
    for (const int axis : {1, 2}) divisor = gcd(divisor, n[axis]);
    for (Int& x : n) x /= divisor < 0 ? Int(-divisor) : divisor;
    const auto& loop = s.loop(f);
    const Int d = dot(n, s.points[loop[0]]);
    for (const int p : loop)
      if (dot(n, s.points[p]) != d) detail::refuse_not_planar(s, f, n, d);
    const moving_plane<Int> plane{n, d, f < weights.size() ? weights[f] : Int(1)};
    const auto [at, fresh] = ids.emplace(plane, static_cast<plane_id>(s.planes.size()));
    if (fresh) s.planes.push_back(plane);
    s.facet_planes.push_back(at->second);
  }
  detail::check_neighbours(s);
}

}  // namespace osteon
