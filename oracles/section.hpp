// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The split of a pointed corner as thesis 3.2 sees it: the straight skeleton of a plane section. Shares with the library's splits no algorithm, only
/// the numbers; the planar skeleton is the library's own.
///
/// Facet i is n_i . x = -t * s_i, so the solid at time t is t times the solid at time 1, and its section by the plane m . x = h is that of time 1 by
/// m . x = h / t, drawn t times as large. While t grows from zero this plane comes from infinity, where it sees only the corner's own edges, towards
/// the place where the corner was: the wavefront in a plane that stays sweeps the whole split corner. Events are its vertices, moving vertices its
/// edges, and the wavefront has vanished when nothing of it is left.

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/propagate.hpp"

namespace osteon::oracles {

/// A corner whose facet i lies between rays i and i + 1, with the angle below half a turn, and moves by `speeds[i]` along -normals[i], cut across.
/// Requires general position, that of the plane included: no two lines of the section are parallel.
class section {
 public:
  using vector = std::array<integer, 3>;
  using tree = std::set<std::array<int, 3>>;  // the three facets of each vertex, ascending

  /// Cut by the plane `across` . x = h, where h > 0 is in proportion to `scale`. Nothing where that plane does not meet all rays, or where the solid
  /// lies around the polygon and not in it.
  static std::optional<section> make(std::span<const vector> rays, std::span<const vector> normals, std::span<const integer> speeds,
                                     const vector& across, long scale = 1) {
    // Coordinates in the plane: axes at a right angle, such that the polygon is seen from the vertex. They need not have length one, as nothing
    // here depends on angles or lengths: lines have speeds, not weights.
    const vector u = across[0] == 0 && across[1] == 0 ? vector{1, 0, 0} : vector{across[1], -across[0], 0};
    const vector v = cross(u, across);
    integer height = 1;
    for (const vector& r : rays) {
      if (dot(across, r) <= 0) return std::nullopt;
      height = lcm(height, dot(across, r));
    }
    height *= scale * dot(u, u) * dot(v, v);  // all points are integers
    section s;
    const integer to_plane = height * dot(across, across);
    plane::polygon<integer>& p = s.polygon_;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const vector& n = normals[i];
      const integer along = to_plane / dot(across, rays[i]);
      p.points.push_back({along * dot(rays[i], u) / dot(u, u), along * dot(rays[i], v) / dot(v, v)});
      p.lines.push_back({{dot(n, u), dot(n, v)}, -height * dot(n, across), 1});
      // Only bounds of the motion are told the weight, and their error is far more than this rounding of it.
      moving_line<integer>& l = p.lines.back();
      l.weight = isqrt((speeds[i] * speeds[i] << 200U) / inner_product(l.n, l.n));
      p.boundary.next.push_back(static_cast<int>((i + 1) % rays.size()));
      p.boundary.line.push_back(static_cast<int>(i));
    }
    p.boundary.lines = static_cast<int>(rays.size());
    plane::rank_edges(p.boundary, p.points);
    integer area = 0;
    for (std::size_t i = 0; i < p.points.size(); ++i) {
      const auto& a = p.points[i];
      const auto& b = p.points[(i + 1) % p.points.size()];
      area += a[0] * b[1] - a[1] * b[0];
    }
    if (area <= 0) return std::nullopt;
    s.speeds_.assign(speeds.begin(), speeds.end());
    return s;
  }

  /// The facets that meet in each inner node of its skeleton.
  tree nodes() const {
    const std::span<const moving_line<integer>> lines(polygon_.lines);
    const arithmetic_kernel<arithmetic> k{arithmetic(lines, speeds_)};
    const plane::vertex_enclosures motion(lines, polygon_.points);
    tree result;
    for (const auto& node : plane::propagation(k, polygon_.boundary, motion).run().nodes)
      if (node.vertex < 0) result.insert(node.lines);
    return result;
  }

 private:
  // Lines move as fast as the facets in space; weights of lines would be quotients by square roots.
  class arithmetic : public integer_planes<2> {
   public:
    static constexpr bool is_exact = true;

    arithmetic(std::span<const moving_line<integer>> lines, std::vector<integer> speeds) : integer_planes(lines), speeds_(std::move(speeds)) {}

    using integer_planes::decide;
    sign decide(const linear_form<integer>& f) const {
      integer sum = 0;
      for (int t = 0; t < f.size; ++t) sum += f.terms[t].coefficient * speeds_[static_cast<std::size_t>(f.terms[t].plane)];
      return sign_of(sum);
    }

   private:
    std::vector<integer> speeds_;
  };

  static vector cross(const vector& a, const vector& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
  static integer dot(const vector& a, const vector& b) { return inner_product(a, b); }

  plane::polygon<integer> polygon_;
  std::vector<integer> speeds_;
};

}  // namespace osteon::oracles
