// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Lawrence's formula for volumes: its determinants, and the difference of the volumes that two
/// ways to split a vertex leave.
///
/// For a direction c = ga n_a + gb n_b + gc n_c in general position, the volume of a simple
/// polytope is the sum of  (c . v)^3 / (6 |det| ga gb gc)  over its vertices v, with det the
/// determinant of the normals of v's planes (a,b,c). By Cramer's rule g_r = m_r / det, with m_r the
/// same determinant with c in place of n_r, and  c . v = (ma ha + mb hb + mc hc) / det  with the
/// offsets h of the planes. So the term is
///
///     sign(det) (ma ha + mb hb + mc hc)^3 / (6 det ma mb mc).
///
/// *Source* J. Lawrence: Polytope volume computation. Mathematics of Computation 57 (1991).

#include <array>
#include <span>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/kernel/determinant.hpp"
#include "osteon/kernel/perturbation.hpp"

namespace osteon {

/// The determinants of one vertex in Lawrence's formula.
template <class Number>
struct lawrence_minors {
  Number det;
  std::array<Number, 3> m;

  /// Computes them for a direction and the normals of the vertex's planes.
  lawrence_minors(const std::array<Number, 3>& c, const std::array<std::array<Number, 3>, 3>& n)
      : det(determinant(n[0], n[1], n[2])), m{determinant(c, n[1], n[2]), determinant(n[0], c, n[2]), determinant(n[0], n[1], c)} {}

  /// Returns whether the direction is in general position with respect to this vertex.
  bool is_generic() const { return m[0] != 0 && m[1] != 0 && m[2] != 0; }
};

/// Returns directions to try, in order: small integers, none of them special for many planes.
template <class Number>
std::array<Number, 3> volume_direction(int attempt) {
  const auto u = perturbation::of(-2 - attempt).u;
  return {Number(u[0]), Number(u[1]), Number(u[2])};
}

/// Sums up volume(s) - volume(t) at time 1, for two ways to split a vertex at time zero. Each is a
/// list of triangles, counter-clockwise seen from outside; then sign(det) says how a corner is
/// bent, and without it the terms add up to a volume, whether corners are convex or not
/// (docs/theory/vertex-splitting.md). `normal(plane)` returns a plane's normal. `add(sum, triangle,
/// minors, factor)` adds factor times the term without sign(det) to a sum, which begins as Sum(0);
/// the offsets h are minus the speeds.
/// *Throws* degenerate_error where a corner is infinitely far away; undecided_error where no
/// direction is generic, which happens with rounded numbers only.
template <class Number, class Sum, class Normal, class Add>
Sum volume_difference(std::span<const triple> s, std::span<const triple> t, Normal normal, Add add) {
  constexpr int most_attempts = 100;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const auto c = volume_direction<Number>(attempt);
    Sum sum(0);
    const auto add_all = [&](std::span<const triple> tree, int factor) {
      for (const triple& corner : tree) {
        const lawrence_minors<Number> minors(c, {normal(corner[0]), normal(corner[1]), normal(corner[2])});
        if (minors.det == 0) throw degenerate_error({corner[0], corner[1], corner[2]}, "the volume at a corner (it lies at infinity)");
        if (!minors.is_generic()) return false;
        add(sum, corner, minors, factor);
      }
      return true;
    };
    if (add_all(s, 1) && add_all(t, -1)) return sum;
  }
  throw undecided_error("no direction was found in which volumes can be compared");
}

}  // namespace osteon
