// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The volume of the solid that one way to split a vertex leaves, up to a constant that is the same for all ways.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/kernel/formulas.hpp"

namespace osteon {

/// Visits the tree's triangles with what Lawrence's formula needs: for a direction c = ga n_a + gb n_b + gc n_c the
/// volume is the sum of (c . v)^3 / (6 det ga gb gc), v the corner (a,b,c) at t = 1, and
/// c . v = -(ga sigma_a + gb sigma_b + gc sigma_c). With Cramer's rule g_r = m_r / det, so the term is
/// -(ma sigma_a + mb sigma_b + mc sigma_c)^3 / (6 det ma mb mc). Calls visit(triangle, m, det) with the Ms and det as
/// numbers; returns false where the direction is not generic (some m is zero) for visit to be tried with another one.
/// Source: J. Lawrence, Polytope volume computation, Math. Comp. 57 (1991); design 03.
template <class Number, class Normal, class Visit>
bool visit_volume(std::span<const triple> tree, const std::array<Number, 3>& c, Normal normal, Visit visit) {
  const auto det = [](const auto& x, const auto& y, const auto& z) -> Number {
    return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
  };
  for (const triple& t : tree) {
    const std::array<Number, 3> a = normal(t[0]);
    const std::array<Number, 3> b = normal(t[1]);
    const std::array<Number, 3> d = normal(t[2]);
    const Number corner = det(a, b, d);
    if (corner == 0) throw degenerate_error({t[0], t[1], t[2]}, "the volume at a corner (it lies at infinity)");
    const std::array<Number, 3> m = {det(c, b, d), det(a, c, d), det(a, b, c)};
    if (m[0] == 0 || m[1] == 0 || m[2] == 0) return false;
    visit(t, m, corner);
  }
  return true;
}

/// Directions to try, in order: small integers, none special for many planes.
inline std::array<int, 3> volume_direction(int attempt) {
  const auto p = perturbation::of(-2 - attempt);
  return p.u;
}

}  // namespace osteon
