// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Whether the offset of a split corner is embedded, by brute force on rational coordinates: every edge against every facet. Shares nothing with
/// split.hpp; knows no local rule.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon::fuzz {

/// A corner at the origin: ray i is the edge between facets i - 1 and i; the plane of facet i is n . x = -speed at time one.
class split_oracle {
 public:
  split_oracle(std::vector<vec<integer>> rays, std::vector<vec<integer>> normals, std::vector<integer> speeds)
      : rays_(std::move(rays)), normals_(std::move(normals)), speeds_(std::move(speeds)) {}

  /// For a triangulation of the facets, given by its diagonals; nothing where something only touches, so that a perturbation decides, or
  /// lies at infinity.
  std::optional<bool> embedded(std::span<const std::pair<int, int>> diagonals) const {
    const int n = static_cast<int>(rays_.size());
    std::vector<std::vector<bool>> joined(static_cast<std::size_t>(n), std::vector<bool>(static_cast<std::size_t>(n)));
    const auto join = [&](int a, int b) { joined[a][b] = joined[b][a] = true; };
    for (int a = 0; a < n; ++a) join(a, (a + 1) % n);
    for (const auto& [a, b] : diagonals) join(a, b);

    std::vector<polygon> facets(static_cast<std::size_t>(n));
    std::vector<edge> edges;
    for (int a = 0; a < n; ++a) {
      // Around facet a from the one before to the one after: each two neighbours with a make a vertex.
      std::vector<int> around = {(a + n - 1) % n};
      for (int k = 2; k < n; ++k)
        if (const int b = (a + n - k) % n; joined[a][b]) around.push_back(b);
      polygon& f = facets[a];
      for (std::size_t i = 0; i + 1 < around.size(); ++i) {
        const auto v = vertex(a, around[i], around[i + 1]);
        if (!v) return std::nullopt;
        f.push_back(*v);
      }
      const auto far = [&](const point& v, int ray) {
        point p = v;
        for (int axis = 0; axis < 3; ++axis) p[axis] += rational(rays_[ray][axis] << far_bits);
        return p;
      };
      f.insert(f.begin(), far(f.front(), a));
      f.push_back(far(f.back(), (a + 1) % n));
      for (std::size_t i = 0; i < around.size(); ++i)
        if (a < around[i]) edges.push_back({{a, around[i]}, {f[i], f[i + 1]}});
    }
    bool touches = false;
    for (const edge& e : edges)
      for (int f = 0; f < n; ++f) {
        if (f == e.facets[0] || f == e.facets[1]) continue;
        if (pierces(e, f, facets[f], touches)) return false;
      }
    for (int f = 0; f < n; ++f)
      if (crosses_itself(f, facets[f], touches)) return false;
    return touches ? std::nullopt : std::optional(true);
  }

 private:
  using point = std::array<rational, 3>;
  using polygon = std::vector<point>;
  struct edge {
    std::array<int, 2> facets;
    std::array<point, 2> ends;
  };

  // Beyond every crossing: the speeds have about 70 bits, the minors of the normals less than 40.
  static constexpr unsigned far_bits = 200;

  static rational dot(const vec<integer>& n, const point& p) { return rational(n[0]) * p[0] + rational(n[1]) * p[1] + rational(n[2]) * p[2]; }
  rational height(int f, const point& p) const { return -speeds_[f] - dot(normals_[f], p); }

  std::optional<point> vertex(int a, int b, int c) const {
    const auto bc = cross(normals_[b], normals_[c]);
    const auto ca = cross(normals_[c], normals_[a]);
    const auto ab = cross(normals_[a], normals_[b]);
    const integer det = osteon::dot(normals_[a], bc);
    if (det == 0) return std::nullopt;
    point p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = rational(-(speeds_[a] * bc[axis] + speeds_[b] * ca[axis] + speeds_[c] * ab[axis]), integer(1)) / rational(det);
    return p;
  }

  std::array<int, 2> axes(int f) const { return projection(normals_[f]); }

  static rational turn(const point& a, const point& b, const point& p, const std::array<int, 2>& axes) {
    const auto [x, y] = axes;
    return (b[x] - a[x]) * (p[y] - a[y]) - (b[y] - a[y]) * (p[x] - a[x]);
  }

  bool pierces(const edge& e, int f, const polygon& facet, bool& touches) const {
    const std::array<rational, 2> h = {height(f, e.ends[0]), height(f, e.ends[1])};
    // An end on the plane is a vertex of this facet, where the edge leaves it.
    for (const int s : {0, 1})
      if (h[s] == 0) {
        if (h[1 - s] == 0 || std::find(facet.begin(), facet.end(), e.ends[s]) == facet.end()) touches = true;
        return false;
      }
    if ((h[0] > 0) == (h[1] > 0)) return false;
    point p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = (e.ends[0][axis] * h[1] - e.ends[1][axis] * h[0]) / (h[1] - h[0]);
    bool inside = false;
    const auto [x, y] = axes(f);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const point& a = facet[i];
      const point& b = facet[(i + 1) % facet.size()];
      const rational t = turn(a, b, p, {x, y});
      const bool above_a = a[y] > p[y];
      const bool above_b = b[y] > p[y];
      if (t == 0 && std::min(a[x], b[x]) <= p[x] && p[x] <= std::max(a[x], b[x]) && std::min(a[y], b[y]) <= p[y] && p[y] <= std::max(a[y], b[y])) {
        touches = true;  // of one edge by another, which the facets of both see
        return false;
      }
      if (above_a != above_b && (t > 0) == above_b) inside = !inside;
    }
    return inside;
  }

  // Sides that are not neighbours; the closing one is far away.
  bool crosses_itself(int f, const polygon& facet, bool& touches) const {
    const auto kept = axes(f);
    const std::size_t sides = facet.size() - 1;
    for (std::size_t i = 0; i < sides; ++i)
      for (std::size_t j = i + 2; j < sides; ++j) {
        const std::array<rational, 4> t = {turn(facet[i], facet[i + 1], facet[j], kept), turn(facet[i], facet[i + 1], facet[j + 1], kept),
                                           turn(facet[j], facet[j + 1], facet[i], kept), turn(facet[j], facet[j + 1], facet[i + 1], kept)};
        if (std::find(t.begin(), t.end(), 0) != t.end()) touches = true;
        if (t[0] * t[1] < 0 && t[2] * t[3] < 0) return true;
      }
    return false;
  }

  std::vector<vec<integer>> rays_;
  std::vector<vec<integer>> normals_;
  std::vector<integer> speeds_;
};

}  // namespace osteon::fuzz
