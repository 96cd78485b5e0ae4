// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Numbers of 60 digits and moving lines for the planar oracles. What coincides exactly coincides here to 1e-40 of the polygon's size.

#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <vector>

#include "planar_node.hpp"

namespace osteon::oracles {

using real = boost::multiprecision::number<boost::multiprecision::gmp_float<60>, boost::multiprecision::et_off>;

/// A place of the plane, or a direction.
struct spot {
  real x, y;
  friend spot operator+(const spot& a, const spot& b) { return {a.x + b.x, a.y + b.y}; }
  friend spot operator-(const spot& a, const spot& b) { return {a.x - b.x, a.y - b.y}; }
  friend spot operator*(const real& s, const spot& a) { return {s * a.x, s * a.y}; }
};
inline real dot(const spot& a, const spot& b) { return a.x * b.x + a.y * b.y; }
inline real cross(const spot& a, const spot& b) { return a.x * b.y - a.y * b.x; }

/// The line of an edge, normal . x = offset + time * weight; the interior is on the side of the normal, a unit vector.
struct front_line {
  spot normal, direction;  ///< the direction is the edge's, also a unit vector
  real offset, weight;
};

/// A vertex of the wavefront: start + time * velocity. The start is where its lines met at time zero.
struct moving_spot {
  spot start, velocity;
  spot at(const real& t) const { return start + t * velocity; }
};

/// The polygon in numbers of 60 digits, moved so that its first point is the origin.
struct planar_lines {
  std::vector<planar_edge> edges;  ///< as they came in
  std::vector<int> line;           ///< of each edge, by `lines_of`
  std::vector<int> next;           ///< the edge after each in its ring
  std::vector<front_line> lines;   ///< by edge; only those named by `line` are used
  spot origin;
  real size;
  real tiny;        ///< a length that is zero
  real tiny_time;   ///< the same for times
  bool weighted{};  ///< not all weights are the same

  explicit planar_lines(const planar_input& input) : edges(edges_of(input)), line(lines_of(input)), size(size_of(input)) {
    int first = 0;
    for (const auto& ring : input.rings) {
      const int n = static_cast<int>(ring.size());
      for (int i = 0; i < n; ++i) next.push_back(first + (i + 1) % n);
      first += n;
    }
    origin = {real(edges[0].from[0]), real(edges[0].from[1])};
    double fastest = 0;
    for (const planar_edge& e : edges) {
      const spot from = point(e.from);
      const spot d = point(e.to) - from;
      const spot u = real(1 / sqrt(dot(d, d))) * d;
      const spot normal = {-u.y, u.x};
      lines.push_back({normal, u, dot(normal, from), real(e.weight)});
      weighted = weighted || e.weight != edges[0].weight;
      fastest = std::max(fastest, e.weight);
    }
    tiny = size * real("1e-40");
    tiny_time = fastest > 0 ? real(tiny / fastest) : tiny;
  }

  spot point(const std::array<double, 2>& p) const { return spot{real(p[0]), real(p[1])} - origin; }

  /// How far a place lies before line `e` at a moment.
  real height(int e, const spot& p, const real& t) const {
    const front_line& l = lines[static_cast<std::size_t>(e)];
    return dot(l.normal, p) - l.offset - t * l.weight;
  }

  /// Where two lines meet for all times. Gives up on parallel ones.
  moving_spot meeting(int a, int b) const {
    const front_line& l = lines[static_cast<std::size_t>(a)];
    const front_line& m = lines[static_cast<std::size_t>(b)];
    const real det = cross(l.normal, m.normal);
    if (abs(det) < real("1e-45")) throw planar_give_up("neighbours " + std::to_string(a) + " and " + std::to_string(b) + " are parallel");
    const auto solve = [&](const real& p, const real& q) {
      return real(1 / det) * spot{p * m.normal.y - q * l.normal.y, q * l.normal.x - p * m.normal.x};
    };
    return {solve(l.offset, m.offset), solve(l.weight, m.weight)};
  }

  /// A node in doubles, its edges sorted.
  planar_node node(const spot& p, const real& t, std::vector<int> at) const {
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    const spot back = p + origin;
    return {back.x.convert_to<double>(), back.y.convert_to<double>(), t.convert_to<double>(), std::move(at)};
  }
};

}  // namespace osteon::oracles
