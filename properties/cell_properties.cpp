// SPDX-License-Identifier: MIT

/// \file
/// Laws of cells: what a facet sweeps.

#include <array>
#include <string>
#include <vector>

#include "laws.hpp"

namespace osteon::properties {
namespace {

// The integral of time over a face, times its normal (the area vector's direction in which borders run counter-clockwise in (u, t)). Fans of
// triangles from one of its nodes: signed, so that holes and several parts need no care.
vector3 time_over(const placed_skeleton& s, const face& f) {
  const place& centre = s.nodes[s.raw.arcs[f.borders[0].arc].source];
  vector3 sum = {0, 0, 0};
  const auto add = [&](int from, int to) {
    const place& a = s.nodes[from];
    const place& b = s.nodes[to];
    sum = sum + ((centre.time + a.time + b.time) / 6) * cross(a.point - centre.point, b.point - centre.point);
  };
  for (const border& b : f.borders) {  // up along heads, down along tails
    const auto& a = s.raw.arcs[b.arc];
    b.head ? add(a.source, a.target) : add(a.target, a.source);
  }
  for (const auto& e : f.base) add(e[0], e[1]);
  return sum;
}

// The volume of each cell by the divergence of the field "height over the floor, towards the floor's inner side", which sheets alone
// carry: integral over the cell's outer side of height times normal. Heights are t * sigma / |n|.
std::vector<rational> cell_volumes(const placed_skeleton& s) {
  std::vector<rational> volume(static_cast<std::size_t>(s.planes.size()), 0);
  for (const auto& [id, f] : s.faces) {
    const vector3 flux = time_over(s, f);
    for (const int side : {0, 1}) {
      const plane_id p = f.facets[static_cast<std::size_t>(side)];
      // Seen with u to the right and time upwards a convex edge's sheet shows its back to the cell of facet 0.
      const rational out = dot(s.planes.n(p), flux) * s.planes.speed(p) / dot(s.planes.n(p), s.planes.n(p));
      volume[p] += f.convex == (side == 0) ? out : rational(-out);
    }
  }
  return volume;
}

std::string volumes_add_up(const placed_skeleton& s) {
  rational sum = 0;
  const auto volumes = cell_volumes(s);
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    if (volumes[p] < 0) return "the volume of cell " + std::to_string(p) + " is negative";
    sum += volumes[p];
  }
  const rational whole = input_volume(s);
  return sum == whole ? "" : "cells have volume " + sum.str() + ", the solid " + whole.str();
}

// ---- one interval

using point2 = std::array<rational, 2>;

// A cell's sheets and floor, projected along its floor's normal.
struct shadow {
  std::vector<std::vector<std::array<point2, 2>>> polygons;
  std::vector<point2> corners;
};

shadow shadow_of(const placed_skeleton& s, plane_id p) {
  const vector3& n = s.planes.n(p);
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(n[i]) < abs(n[least])) least = i;
  vector3 axis = {0, 0, 0};
  axis[least] = 1;
  const vector3 u = cross(n, axis);
  const vector3 v = cross(n, u);
  std::vector<point2> flat;
  for (const place& x : s.nodes) flat.push_back({dot(u, x.point), dot(v, x.point)});
  shadow result;
  std::vector<bool> seen(s.nodes.size());
  const auto see = [&](int node) {
    if (!seen[node]) result.corners.push_back(flat[node]);
    seen[node] = true;
  };
  for (const auto& [id, f] : s.faces) {
    if (f.facets[0] != p && f.facets[1] != p) continue;
    auto& polygon = result.polygons.emplace_back();
    const auto add = [&](int a, int b) {
      polygon.push_back({flat[a], flat[b]});
      see(a);
      see(b);
    };
    for (const border& b : f.borders) add(s.raw.arcs[b.arc].source, s.raw.arcs[b.arc].target);
    for (const auto& e : f.base) add(e[0], e[1]);
  }
  auto& floor = result.polygons.emplace_back();
  for (const auto& e : s.boundary.edges)
    if (e.planes[0] == p || e.planes[1] == p) floor.push_back({flat[e.ends[0]], flat[e.ends[1]]});
  return result;
}

// How many of the polygons a perpendicular line meets; -1 where it meets a border. A sheet is plane and never perpendicular to its
// floors, so each is met once at most.
int crossings(const shadow& cell, const point2& x) {
  int number = 0;
  for (const auto& polygon : cell.polygons) {
    bool inside = false;
    for (const auto& [a, b] : polygon) {
      const bool above = a[1] > x[1];
      if (above == (b[1] > x[1])) continue;
      const rational turn = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
      if (turn == 0) return -1;
      if ((turn > 0) == (b[1] > a[1])) inside = !inside;
    }
    number += inside ? 1 : 0;
  }
  return number;
}

std::string meets_lines_once(const placed_skeleton& s, const std::vector<std::array<int, 4>>& samples) {
  for (plane_id p = 0; p < s.planes.size(); ++p) {
    const shadow cell = shadow_of(s, p);
    const std::size_t n = cell.corners.size();
    for (const auto& sample : samples) {  // a point within the triangle of three corners
      point2 x;
      for (std::size_t axis = 0; axis < 2; ++axis)
        x[axis] =
            (sample[3] * cell.corners[static_cast<std::size_t>(sample[0]) % n][axis] +
             2 * cell.corners[static_cast<std::size_t>(sample[1]) % n][axis] + 3 * cell.corners[static_cast<std::size_t>(sample[2]) % n][axis]) /
            (5 + sample[3]);
      const int met = crossings(cell, x);
      if (met > 2 || met == 1)
        return "a line perpendicular to facet " + std::to_string(p) + " meets the surface of its cell " + std::to_string(met) + " times";
    }
  }
  return "";
}

// A cell of an unweighted skeleton meets every line perpendicular to its facet in one interval (thesis 2.4; design 05).
RC_GTEST_PROP(cells, are_monotone, ()) {
  const auto s = *gen::unweighted();
  const auto o = *gen::any_options();
  const auto samples = *rc::gen::container<std::vector<std::array<int, 4>>>(
      20, rc::gen::map(rc::gen::container<std::array<long, 4>>(gen::between(1, 100)), [](const std::array<long, 4>& x) {
        return std::array<int, 4>{static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2]), static_cast<int>(x[3])};
      }));
  for_every_kernel(
      s, [&](const placed_skeleton& p) { return meets_lines_once(p, samples); }, o);
}

// The volumes of the cells, each measured over its own floor, add up to the solid's. Weighted or not.
RC_GTEST_PROP(cells, volumes_add_up, ()) {
  const auto s = *rc::gen::oneOf(gen::unweighted(), gen::unweighted(), gen::weighted(gen::convex()), gen::weighted(gen::stars()));
  for_every_kernel(s, volumes_add_up, *gen::any_options());
}

}  // namespace
}  // namespace osteon::properties
