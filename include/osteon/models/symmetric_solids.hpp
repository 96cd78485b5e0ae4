// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Symmetric solids.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "osteon/models/mesh_builder.hpp"

namespace osteon::models {

/// Returns a regular tetrahedron: four corners of a cube.
inline builder tetrahedron() {
  builder b;
  const std::array<point, 4> p = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  b.facet({p[0], p[1], p[2]}), b.facet({p[0], p[2], p[3]}), b.facet({p[0], p[3], p[1]}), b.facet({p[1], p[3], p[2]});
  return b;
}

/// Returns the octahedron |x| + |y| + |z| <= r.
inline builder octahedron(long r) {
  builder b;
  for (const long x : {-r, r})
    for (const long y : {-r, r})
      for (const long z : {-r, r}) {
        if (x * y * z > 0)
          b.facet({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
        else
          b.facet({{x, 0, 0}, {0, 0, z}, {0, y, 0}});
      }
  return b;
}

/// Returns a cube of side 2s with its corners cut off at distance c < s along the edges.
inline builder cut_cube(long s, long c) {
  builder b;
  for (int axis = 0; axis < 3; ++axis)
    for (const long side : {-s, s}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      std::vector<point> octagon;
      for (const auto& [pu, pv] : {std::pair(-s + c, -s), std::pair(s - c, -s), std::pair(s, -s + c), std::pair(s, s - c), std::pair(s - c, s),
                                   std::pair(-s + c, s), std::pair(-s, s - c), std::pair(-s, -s + c)}) {
        point p{};
        p[axis] = side, p[u] = pu, p[v] = pv;
        octagon.push_back(p);
      }
      if (side < 0) std::reverse(octagon.begin(), octagon.end());
      b.facet(octagon);
    }
  for (const long x : {-s, s})
    for (const long y : {-s, s})
      for (const long z : {-s, s}) {
        const auto in = [&](long k) { return k > 0 ? k - c : k + c; };
        if (x * y * z > 0)
          b.facet({{in(x), y, z}, {x, in(y), z}, {x, y, in(z)}});
        else
          b.facet({{in(x), y, z}, {x, y, in(z)}, {x, in(y), z}});
      }
  return b;
}

/// Returns a cube of side 2s with a pyramid of height h on every facet.
inline builder stellated_cube(long s, long h) {
  builder b;
  for (int axis = 0; axis < 3; ++axis)
    for (const long side : {-s, s}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      std::vector<point> c;
      for (const auto& [pu, pv] : {std::pair(-s, -s), std::pair(s, -s), std::pair(s, s), std::pair(-s, s)}) {
        point p{};
        p[axis] = side, p[u] = pu, p[v] = pv;
        c.push_back(p);
      }
      if (side < 0) std::reverse(c.begin(), c.end());
      point apex = {0, 0, 0};
      apex[axis] = side > 0 ? side + h : side - h;
      for (int i = 0; i < 4; ++i) b.facet({c[i], c[(i + 1) % 4], apex});
    }
  return b;
}

}  // namespace osteon::models
