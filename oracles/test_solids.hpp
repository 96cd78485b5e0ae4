// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids in general position for the oracles: random integer coordinates, so that no two events coincide.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "offset_mesh.hpp"
#include "osteon/core/error.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/models/polyhedra.hpp"
#include "osteon/space/propagate.hpp"

namespace osteon::oracles {

using triangle_list = std::vector<std::array<std::size_t, 3>>;

/// The facets of the convex hull of points in general position, as their numbers. Sorted, since CGAL's order depends on addresses.
inline triangle_list hull_facets(const std::vector<std::array<double, 3>>& points) {
  using kernel_type = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::map<kernel_type::Point_3, std::size_t> numbers;
  std::vector<kernel_type::Point_3> cloud;
  for (const auto& p : points) {
    cloud.emplace_back(p[0], p[1], p[2]);
    numbers.emplace(cloud.back(), cloud.size() - 1);
  }
  CGAL::Surface_mesh<kernel_type::Point_3> hull;
  CGAL::convex_hull_3(cloud.begin(), cloud.end(), hull);
  triangle_list result;
  for (const auto f : hull.faces()) {
    std::array<std::size_t, 3> corners{};
    std::size_t i = 0;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f))) corners[i++] = numbers.at(hull.point(v));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.push_back(corners);
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline models::builder surface(const std::vector<models::point>& points, const triangle_list& facets) {
  models::builder b;
  for (const auto& f : facets) b.facet({points[f[0]], points[f[1]], points[f[2]]});
  return b;
}

/// Points in random directions, joined like the convex hull of the directions, each at its own distance from the origin: up to
/// `depth` percent nearer than the others. The origin sees every facet from inside, so the surface cannot pass through itself; draws that leave
/// the origin outside (one in eleven with ten points) are repeated.
inline models::builder ball(int points, int depth, std::uint64_t seed) {
  models::dice roll(seed);
  for (;;) {
    std::vector<std::array<double, 3>> directions;
    std::vector<models::point> corners;
    while (static_cast<int>(directions.size()) < points) {
      const std::array<long, 3> r = {roll.between(-10'000, 10'000), roll.between(-10'000, 10'000), roll.between(-10'000, 10'000)};
      const double length = std::sqrt(static_cast<double>(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]));
      if (length < 1000 || length > 10'000) continue;
      const double distance = 1000.0 * static_cast<double>(100 - roll.between(0, depth));
      auto& direction = directions.emplace_back();
      auto& corner = corners.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        direction[axis] = static_cast<double>(r[axis]) / length;
        corner[axis] = std::lround(distance * direction[axis]);
      }
    }
    const auto facets = hull_facets(directions);
    // Coordinates are below 2^17, so these determinants fit.
    const auto seen = [&corners](const std::array<std::size_t, 3>& f) {
      const auto& p = corners[f[0]];
      const auto& q = corners[f[1]];
      const auto& r = corners[f[2]];
      return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]) > 0;
    };
    if (std::all_of(facets.begin(), facets.end(), seen)) return surface(corners, facets);
  }
}

/// The convex hull of random points in a cube.
inline models::builder random_hull(int points, std::uint64_t seed) {
  models::dice roll(seed);
  std::vector<models::point> corners(static_cast<std::size_t>(points));
  std::vector<std::array<double, 3>> cloud;
  for (auto& p : corners) {
    for (auto& x : p) x = roll.between(-1'000'000, 1'000'000);
    cloud.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  }
  return surface(corners, hull_facets(cloud));
}

/// A model with every corner moved a little and every facet cut into triangles: of general shape, with tunnels and voids if the model has some.
inline input_mesh<integer> shaken(const models::builder& model, long scale, long most, std::uint64_t seed) {
  models::dice roll(seed);
  auto m = model.take<integer>();
  for (auto& p : m.points)
    for (auto& x : p) x = {x.mantissa * scale + roll.between(-most, most), 0, 0};
  std::vector<std::vector<int>> triangles;
  for (const auto& f : m.facets) {
    const std::size_t turn = static_cast<std::size_t>(roll.between(0, static_cast<long>(f.size()) - 1));
    for (std::size_t i = 1; i + 1 < f.size(); ++i) triangles.push_back({f[turn], f[(turn + i) % f.size()], f[(turn + i + 1) % f.size()]});
  }
  m.facets = std::move(triangles);
  return m;
}

/// A solid, its skeleton for rational speeds, and the way to its offsets.
struct skeletal_solid {
  solid<integer> body;
  skeleton raw;

  explicit skeletal_solid(input_mesh<integer> m, const skeleton_options& o = {}) : body(make_solid(std::move(m))) {
    const perturbed k(filtered(std::span<const moving_plane<integer>>(body.planes), make_rational_kernel(body.planes)));
    raw = straight_skeleton(k, body.boundary, o);
  }
  offset_cutter cutter() const { return {body.planes, rational_speeds(body.planes), raw}; }
};

/// Empty where a vertex has a degree that the library does not take.
inline std::optional<skeletal_solid> try_skeleton(input_mesh<integer> m, const skeleton_options& o = {}) {
  try {
    return skeletal_solid(std::move(m), o);
  } catch (const unsupported_error&) {
    return std::nullopt;
  }
}

/// Moments between events, in order: spread over the life of a solid, and over its events, most of which are early. Few digits, because
/// exact points get long.
inline std::vector<rational> moments(const offset_cutter& c, int number) {
  auto times = c.times();
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<rational> result;
  for (int i = 0; i < number; ++i) {
    const rational share(2 * i + 1, 2 * number);
    const auto by_time = std::upper_bound(times.begin(), times.end() - 1, share * times.back());
    const auto by_rank = times.begin() + 1 + static_cast<std::ptrdiff_t>(times.size() - 1) * (2 * i + 1) / (2 * number);
    const auto after = i % 2 == 0 ? by_time : by_rank;
    const rational& least = *(after - 1);
    integer scale = 1;
    rational t;
    do {
      scale *= 2;
      const rational next = least * scale;
      t = rational(numerator(next) / denominator(next) + 1, scale);
    } while (t >= *after);
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace osteon::oracles
