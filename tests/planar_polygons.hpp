// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What tests of the plane share: an exact check of polygons, and an endless supply of small random ones, each named by its shape, its weights
/// and a seed, so that a failure can be replayed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "osteon/kernel/integer.hpp"
#include "osteon/models/polygons.hpp"

namespace osteon::test {

// ---- the check

__extension__ using wide = __int128;  // exact for the determinants of coordinates up to 2^61

inline int turn_sign(const plane::models::point& p, const plane::models::point& q, const plane::models::point& r) {
  const wide d = wide(q[0] - p[0]) * (r[1] - p[1]) - wide(q[1] - p[1]) * (r[0] - p[0]);
  return (d > 0) - (d < 0);
}

/// Whether r, on the line pq, lies between p and q or on one of them.
inline bool between(const plane::models::point& p, const plane::models::point& q, const plane::models::point& r) {
  return std::min(p[0], q[0]) <= r[0] && r[0] <= std::max(p[0], q[0]) && std::min(p[1], q[1]) <= r[1] && r[1] <= std::max(p[1], q[1]);
}

/// Twice the area to the left of a ring.
inline wide doubled_area(const plane::models::ring& points) {
  wide sum = 0;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
    sum += wide(points[j][0]) * points[i][1] - wide(points[j][1]) * points[i][0];
  return sum;
}

/// Whether half of p lies within a ring; arbitrary on it.
inline bool half_is_inside(const plane::models::ring& points, const plane::models::point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const plane::models::point a = {2 * points[j][0], 2 * points[j][1]};
    const plane::models::point b = {2 * points[i][0], 2 * points[i][1]};
    if ((a[1] > p[1]) != (b[1] > p[1]) && turn_sign(a, b, p) == (b[1] > a[1] ? 1 : -1)) inside = !inside;
  }
  return inside;
}

/// What is wrong with a polygon; empty: nothing. Edges meet only in the vertex between neighbours, the outer ring runs counter-clockwise, holes
/// clockwise, inside of it and outside of each other. `touching`: different rings may share vertices. Exact for coordinates up to 2^60.
/// Quadratic, but usually fast: a sweep over x.
inline std::string fault_of(const plane::models::region& polygon, bool touching = false) {
  using plane::models::point;
  struct edge {
    point a, b;
    std::size_t ring, number, last;  // its number in the ring, and that of the ring's last
    long lo() const { return std::min(a[0], b[0]); }
    long hi() const { return std::max(a[0], b[0]); }
    std::string name() const { return "edge " + std::to_string(number) + " of ring " + std::to_string(ring); }
  };
  if (polygon.empty()) return "no rings";
  std::vector<edge> edges;
  for (std::size_t r = 0; r < polygon.size(); ++r) {
    const auto& points = polygon[r];
    if (points.size() < 3) return "ring " + std::to_string(r) + " has fewer than three points";
    for (std::size_t i = 0; i < points.size(); ++i) {
      edges.push_back({points[i], points[(i + 1) % points.size()], r, i, points.size() - 1});
      if (edges.back().a == edges.back().b) return edges.back().name() + " has no length";
    }
  }
  std::sort(edges.begin(), edges.end(), [](const edge& e, const edge& f) { return e.lo() < f.lo(); });
  const auto follows = [](const edge& e, const edge& f) { return e.ring == f.ring && f.number == (e.number == e.last ? 0 : e.number + 1); };
  const auto folded = [](const point& p, const point& q, const point& r) {  // qp and qr overlap
    return turn_sign(p, q, r) == 0 && wide(p[0] - q[0]) * (r[0] - q[0]) + wide(p[1] - q[1]) * (r[1] - q[1]) > 0;
  };
  const auto meet = [](const edge& e, const edge& f) {
    const int fa = turn_sign(e.a, e.b, f.a);
    const int fb = turn_sign(e.a, e.b, f.b);
    const int ea = turn_sign(f.a, f.b, e.a);
    const int eb = turn_sign(f.a, f.b, e.b);
    if (fa * fb < 0 && ea * eb < 0) return true;
    return (fa == 0 && between(e.a, e.b, f.a)) || (fb == 0 && between(e.a, e.b, f.b)) || (ea == 0 && between(f.a, f.b, e.a)) ||
           (eb == 0 && between(f.a, f.b, e.b));
  };
  const auto only_touch = [&](const edge& e, const edge& f) {  // they share an end and nothing else
    for (const auto& [p, q] : {std::pair(e.a, e.b), std::pair(e.b, e.a)})
      for (const auto& [r, s] : {std::pair(f.a, f.b), std::pair(f.b, f.a)})
        if (p == r) return !folded(q, p, s);
    return false;
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].lo() <= edges[i].hi(); ++j) {
      const edge& e = edges[i];
      const edge& f = edges[j];
      if (std::min(e.a[1], e.b[1]) > std::max(f.a[1], f.b[1]) || std::min(f.a[1], f.b[1]) > std::max(e.a[1], e.b[1])) continue;
      bool wrong = false;
      if (follows(e, f))
        wrong = folded(e.a, e.b, f.b);
      else if (follows(f, e))
        wrong = folded(f.a, f.b, e.b);
      else
        wrong = meet(e, f) && !(touching && e.ring != f.ring && only_touch(e, f));
      if (wrong) return e.name() + " meets " + f.name();
    }
  for (std::size_t r = 0; r < polygon.size(); ++r) {
    if ((doubled_area(polygon[r]) > 0) != (r == 0)) return "ring " + std::to_string(r) + " runs the wrong way";
    if (r == 0) continue;
    const point middle = {polygon[r][0][0] + polygon[r][1][0], polygon[r][0][1] + polygon[r][1][1]};
    if (!half_is_inside(polygon[0], middle)) return "hole " + std::to_string(r) + " is outside";
    for (std::size_t other = 1; other < polygon.size(); ++other)
      if (other != r && half_is_inside(polygon[other], middle)) return "hole " + std::to_string(r) + " is inside of hole " + std::to_string(other);
  }
  return "";
}

// ---- the supply

/// general: no holes, general position but by bad luck; holes: the same with holes; coarse: such polygons rounded to a small grid, so that
/// parallel and collinear edges, straight angles and simultaneous events abound; rectilinear: axis-parallel edges of integer lengths; symmetric:
/// exactly or but for rounding; touching: rectilinear, rings may share vertices.
enum class shape : std::uint8_t { general, holes, coarse, rectilinear, symmetric, touching };
inline constexpr std::array simple_shapes = {shape::general, shape::holes, shape::coarse, shape::rectilinear, shape::symmetric};

/// Weights of the edges: all 1 and not given; integers 1 .. 5; decimals 0.01 .. 9.99; integers 0 .. 3, at least one positive. Neighbours on one
/// line always have the same.
enum class weighting : std::uint8_t { none, small, decimal, some_zero };
inline constexpr std::array weightings = {weighting::none, weighting::small, weighting::decimal, weighting::some_zero};

/// Parameters of tests that hold for all: touching polygons without weights only.
inline std::vector<std::pair<shape, weighting>> shapes_and_weightings() {
  std::vector<std::pair<shape, weighting>> result;
  for (const auto s : simple_shapes)
    for (const auto w : weightings) result.emplace_back(s, w);
  result.emplace_back(shape::touching, weighting::none);
  return result;
}

inline std::string name_of(shape s) {
  return std::array{"general", "holes", "coarse", "rectilinear", "symmetric", "touching"}[static_cast<std::size_t>(s)];
}
inline std::string name_of(weighting w) { return std::array{"none", "small", "decimal", "some_zero"}[static_cast<std::size_t>(w)]; }

/// A polygon to test with; `name` belongs into a SCOPED_TRACE.
struct polygon_sample {
  std::string name;
  plane::models::region points;
  plane::rings<integer> rings;
};

/// Rounds a polygon to multiples of 1 / grid of its extent, without repeated points and flattened holes; not always simple.
inline plane::models::region coarsened(const plane::models::region& polygon, long grid) {
  long extent = 1;
  for (const auto& points : polygon)
    for (const auto& p : points) extent = std::max({extent, std::abs(p[0]), std::abs(p[1])});
  const double scale = static_cast<double>(grid) / static_cast<double>(extent);
  plane::models::region result;
  for (const auto& points : polygon) {
    auto& to = result.emplace_back();
    for (const auto& p : points) to.push_back({std::lround(static_cast<double>(p[0]) * scale), std::lround(static_cast<double>(p[1]) * scale)});
    to.erase(std::unique(to.begin(), to.end()), to.end());
    while (to.size() > 1 && to.front() == to.back()) to.pop_back();
    if (result.size() > 1 && (to.size() < 3 || doubled_area(to) == 0)) result.pop_back();
  }
  return result;
}

/// The polygon of a shape and a seed: 3 .. 300 vertices, mostly few.
inline plane::models::region random_region(shape s, std::uint64_t seed) {
  namespace models = plane::models;
  models::dice roll(seed);
  static constexpr std::array<int, 10> most = {5, 8, 8, 12, 12, 20, 30, 60, 120, 300};
  const int n = static_cast<int>(roll.between(3, most[static_cast<std::size_t>(roll.between(0, 9))]));
  const int k = static_cast<int>(roll.between(1, n < 60 ? 2 : 8));
  const long choice = roll.between(0, 5);
  const std::uint64_t fresh = roll();
  // Rounds a polygon as much as it can bear.
  const auto coarse = [&roll](const models::region& fine) {
    for (long grid = roll.between(2, 12); grid < 1'000'000; grid += grid / 2) {
      auto rounded = coarsened(fine, grid);
      if (fault_of(rounded).empty()) return rounded;
    }
    return fine;
  };
  switch (s) {
    case shape::general:
      if (choice == 0) return models::noisy_star(n, fresh);
      if (choice == 1) return models::noisy_loop(n, fresh);
      if (choice == 2) return models::comb(n, fresh);
      if (choice == 3) return models::spiral(n, fresh);
      if (choice == 4) return models::hilbert(n, fresh);
      return models::random_polygon(n, fresh);
    case shape::holes:
      if (choice == 0) return models::jittered_holes(k, fresh);
      if (choice == 1) return models::jittered_cells(std::max(n, 30), fresh);
      return models::random_with_holes(std::max(n, 12), static_cast<int>(roll.between(1, 6)), fresh);
    case shape::coarse: {
      const int few = std::min(n, 60);
      if (choice < 2) return coarse(models::random_polygon(few, fresh));
      if (choice < 4) return coarse(models::random_with_holes(few, 3, fresh));
      return coarse(choice == 4 ? models::noisy_star(few, fresh) : models::noisy_loop(few, fresh));
    }
    case shape::rectilinear:
      if (choice == 0) return models::stairs(n);
      if (choice == 1) return models::rectilinear_hilbert(n);
      if (choice == 2) return models::grid_of_holes(k);
      if (choice == 3) return models::stretched_cells(std::max(n, 12), fresh);
      return models::rectilinear(std::max(n, 12), fresh);
    case shape::symmetric:
      if (choice == 0) return models::regular(n);
      if (choice == 1) return models::gear(n);
      if (choice == 2) return coarsened(models::regular(4 * (n / 8 + 1)), 1000);  // a multiple of four: exactly symmetric
      if (choice == 3) return coarse(models::symmetric(std::max(n, 16), fresh));
      return models::symmetric(std::max(n, 12), fresh);
    case shape::touching:
      return models::touching_cells(std::max(n, 24), fresh);
  }
  return {};
}

/// Gives the edges of a polygon weights, reproducibly.
inline void give_weights(plane::rings<integer>& rings, const plane::models::region& polygon, weighting w, std::uint64_t seed) {
  if (w == weighting::none) return;
  plane::models::dice roll(seed);
  const auto draw = [&roll, w] {
    if (w == weighting::small) return exact_number<integer>{integer(roll.between(1, 5)), 0, 0};
    if (w == weighting::decimal) return exact_number<integer>{integer(roll.between(1, 999)), -2, 0};
    return exact_number<integer>{integer(roll.between(0, 3)), 0, 0};
  };
  for (std::size_t r = 0; r < polygon.size(); ++r) {
    const auto& points = polygon[r];
    const std::size_t n = points.size();
    auto& weights = rings.all[r].weights;
    weights.assign(n, {});
    std::size_t corner = 0;  // begin where the ring is not straight
    while (turn_sign(points[(corner + n - 1) % n], points[corner], points[(corner + 1) % n]) == 0) ++corner;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = (corner + i) % n;
      const std::size_t before = (at + n - 1) % n;
      const bool straight = turn_sign(points[before], points[at], points[(at + 1) % n]) == 0;
      weights[at] = straight ? weights[before] : draw();
    }
  }
  for (const auto& r : rings.all)
    for (const auto& weight : r.weights)
      if (weight.mantissa > 0) return;
  for (auto& r : rings.all)
    for (auto& weight : r.weights) weight.mantissa = 1;
}

/// The polygon of a shape, a way to weigh and a seed. The same on every call.
inline polygon_sample sample(shape s, weighting w, std::uint64_t seed) {
  polygon_sample result;
  result.points = random_region(s, seed);
  result.rings = plane::models::take<integer>(result.points);
  give_weights(result.rings, result.points, w, seed);
  std::size_t vertices = 0;
  for (const auto& points : result.points) vertices += points.size();
  result.name = "sample(shape::" + name_of(s) + ", weighting::" + name_of(w) + ", " + std::to_string(seed) + "): " + std::to_string(vertices) +
                " vertices, " + std::to_string(result.points.size() - 1) + " holes";
  return result;
}

}  // namespace osteon::test
