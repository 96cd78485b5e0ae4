// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The ground of design 02 in coordinates: four planes through the origin at time zero, shortly before and after. The sign
/// conventions of the local picture are read off points, not off formulas.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "local_picture.hpp"
#include "osteon/models/polyhedra.hpp"
#include "report.hpp"

namespace osteon::proofs {

using space = std::array<long, 3>;

inline space cross(const space& a, const space& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
inline long dot(const space& a, const space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Planes n . x = -t sigma; inner side h = -t sigma - n . x >= 0.
struct four_planes {
  std::array<space, 4> n;
  std::array<long, 4> sigma;

  /// A point x / w, w > 0.
  struct point {
    space x;
    long w;
  };

  /// Where three planes meet at time t, by Cramer's rule.
  point vertex(unsigned a, unsigned b, unsigned c, long t) const {
    point p{{}, dot(n[a], cross(n[b], n[c]))};
    for (std::size_t axis = 0; axis < 3; ++axis)
      p.x[axis] = -t * (sigma[a] * cross(n[b], n[c])[axis] + sigma[b] * cross(n[c], n[a])[axis] + sigma[c] * cross(n[a], n[b])[axis]);
    if (p.w < 0) p = {{-p.x[0], -p.x[1], -p.x[2]}, -p.w};
    return p;
  }
  point vertex_without(unsigned q, long t) const { return vertex(q == 0 ? 1 : 0, q <= 1 ? 2 : 1, q == 3 ? 2 : 3, t); }
  long height(unsigned q, const point& p, long t) const { return -t * sigma[q] * p.w - dot(n[q], p.x); }

  /// Between two points of a line, or as far beyond the first as the second is away.
  static point middle(const point& p, const point& q) {
    return {{p.x[0] * q.w + q.x[0] * p.w, p.x[1] * q.w + q.x[1] * p.w, p.x[2] * q.w + q.x[2] * p.w}, 2 * p.w * q.w};
  }
  static point beyond(const point& p, const point& q) {
    return {{2 * p.x[0] * q.w - q.x[0] * p.w, 2 * p.x[1] * q.w - q.x[1] * p.w, 2 * p.x[2] * q.w - q.x[2] * p.w}, p.w * q.w};
  }
};

/// The signed minors of the normals, sum lambda_r n_r = 0.
inline std::array<long, 4> minors(const four_planes& p) {
  const auto det = [&](unsigned a, unsigned b, unsigned c) { return dot(p.n[a], cross(p.n[b], p.n[c])); };
  return {-det(1, 2, 3), det(0, 2, 3), -det(0, 1, 3), det(0, 1, 2)};
}

inline void prove_local_picture(proof& p) {
  models::dice roll(1);
  constexpr int wanted = 40;
  std::array<int, 16> realised{};
  while (std::any_of(realised.begin() + 1, realised.end(), [](int n) { return n < wanted; })) {
    four_planes four{};
    for (auto& n : four.n)
      for (long& x : n) x = roll.between(-6, 6);
    for (long& s : four.sigma) s = roll.between(1, 9);
    std::array<long, 4> lambda = minors(four);
    long speed = 0;
    for (unsigned r = 0; r < planes; ++r) speed += lambda[r] * four.sigma[r];
    if (speed == 0 || std::find(lambda.begin(), lambda.end(), 0) != lambda.end()) continue;
    cell small = 0;
    for (unsigned r = 0; r < planes; ++r)
      if ((lambda[r] > 0) == (speed > 0)) small |= bit(r);
    if (realised[small]++ >= wanted) continue;
    const auto where = [&] { return "small cell " + std::to_string(small) + ", realisation " + std::to_string(realised[small]); };
    p.check(small != 0, where);  // positive speeds: not all lambda can oppose S
    for (const long t : {-1L, 1L}) {
      // The tetrahedron lies on the side of each plane where the vertex of the other three is.
      cell tiny = 0;
      for (unsigned q = 0; q < planes; ++q)
        if (four.height(q, four.vertex_without(q, t), t) > 0) tiny |= bit(q);
      p.check(tiny == (t < 0 ? small : small ^ every_plane), where);
      // In general position every cell has a vertex, so a cell that touches none does not exist.
      for (cell c = 0; c <= every_plane; ++c) {
        bool touched = false;
        for (unsigned q = 0; q < planes; ++q) touched = touched || in(c, q) == in(tiny, q);
        p.check(touched == moment{0, tiny}.exists(c), where);
      }
      for (std::size_t at = 0; at < lines.size(); ++at) {
        const line& n = lines[at];
        const auto on_k = four.vertex_without(n.l, t);
        const auto on_l = four.vertex_without(n.k, t);
        for (const section w : sections) {
          const auto x = w == local::segment ? four_planes::middle(on_k, on_l)
                                             : (w == local::far_k ? four_planes::beyond(on_k, on_l) : four_planes::beyond(on_l, on_k));
          cell label = 0;
          for (const unsigned q : {n.k, n.l})
            if (four.height(q, x, t) > 0) label |= bit(q);
          // The catalogue names a ray by the vertex that it begins at before the event.
          const section name = w == local::segment || t < 0 ? w : (w == local::far_k ? local::far_l : local::far_k);
          p.check(label == moment{0, tiny}.around(n, w) && label == local::label(local::pairs[at], name, small, t > 0), where);
        }
      }
    }
    // Each order in which four planes can pass a point is that of some direction: times 1..4 in any order, moved by a constant
    // (all times S) so that sum lambda sigma time = 0, belong to a point.
    std::array<long, 4> time = {1, 2, 3, 4};
    do {
      long sum = 0;
      for (unsigned r = 0; r < planes; ++r) sum += lambda[r] * four.sigma[r] * time[r];
      four_planes at = four;
      for (unsigned r = 0; r < planes; ++r) at.sigma[r] *= time[r] * speed - sum;
      p.check(at.height(3, at.vertex(0, 1, 2, 1), 1) == 0, where);
    } while (std::next_permutation(time.begin(), time.end()));
  }
}

}  // namespace osteon::proofs
