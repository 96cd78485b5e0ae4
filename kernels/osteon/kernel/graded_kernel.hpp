// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What the adaptor `perturbed` needs of a kernel beyond the concept. No algorithm asks for it.

#include <concepts>

#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"

namespace osteon {

/// A kernel that can be asked for the coefficient of any power of an infinitesimal e > 0: it takes
/// plane i as  (n_i + e^2 u_i) . x = d_i + e delta_i - t sigma_i  with fixed integers u_i and
/// delta_i (see `perturbation`), which makes lambda, D and S polynomials in e
/// (docs/theory/degeneracy.md). The grade of a coefficient is its power; the coefficient of grade 0
/// is what is without perturbation.
///
/// The sign of a polynomial in e is that of its first coefficient that is not zero, and a kernel's
/// answers are products of signs of the four polynomials below. So they are all that can be asked
/// for:
///  - a corner's orientation is the sign of the determinant of its normals;
///  - whether and how planes meet is the sign of S;
///  - the side of a plane on which a corner is just after the start is the sign of D - t S for a
///    time t that is smaller than every positive number and greater than every multiple of e, so it
///    needs the coefficients of D and of S;
///  - the order of two meetings is the sign of  D(q) / S(q) - D(r) / S(r), and the side of a plane
///    on which a corner is at the moment of a meeting the sign of  D(q) - S(q) D(r) / S(r). But for
///    factors whose signs are known, both are  D(q) S(r) - D(r) S(q).
/// Products of lambda, D and S could be asked for one by one, but the last form is no product: its
/// coefficients are linear forms in square roots, whose sign is not found from signs.
template <class K>
concept graded_kernel = requires(const K& k, int grade, const corner_planes<K::dimension>& c, const meeting_planes<K::dimension>& q) {
  // The sign of the coefficient of e^grade in the determinant of the normals of a corner; in D; in
  // S; and in D(q) S(r) - D(r) S(q). Zero for a grade above the degree of the polynomial. Planes in
  // any order, which counts; different planes in each corner and meeting.
  { k.orientation_at(grade, c) } -> std::same_as<sign>;
  { k.offset_at(grade, q) } -> std::same_as<sign>;
  { k.closing_at(grade, q) } -> std::same_as<sign>;
  { k.cross_at(grade, q, q) } -> std::same_as<sign>;

  // The meeting of D + 1 planes, even where S is zero without perturbation: the perturbed planes
  // meet, and the adaptor keeps the meeting of its base for when it can be compared. Its closing is
  // zero where S is.
  { k.meeting_of(q) } -> std::same_as<typename K::meeting>;
};

/// The highest grade that the four polynomials can have. lambda has the degree of the dimension in
/// e^2, D one more in e: so D has degree 7 in space, S 6 and D S 13.
template <int Dimension>
inline constexpr int highest_grade_in = 4 * Dimension + 1;
/// The same in space.
inline constexpr int highest_grade = highest_grade_in<3>;

}  // namespace osteon
