// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The concept that separates the algorithms from numbers. Everything the library computes about space is said with
/// the operations below; no algorithm sees a coordinate or a number type (design 01).
///
/// Plane i has the equation  n_i . x = d_i - t * sigma_i  at time t (outward normal n_i, speed sigma_i = w_i |n_i|);
/// its inner side is  h_i(x,t) = d_i - t * sigma_i - n_i . x >= 0. For a quadruple q of planes, with lambda_r the
/// signed 3x3 minors of the normals,
///
///     D = sum lambda_r d_r,   S = sum lambda_r sigma_r,   L(t) = sum lambda_r h_r(x,t) = D - t S  for every x,
///
/// so the four planes share a point exactly at t = D / S, and vertex (i,j,k) lies inside l iff L(t) / lambda_l > 0.

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"

namespace osteon {

/// What the algorithms of both dimensions D ask: planes in space (D = 3) or lines in the plane (D = 2), D of which meet in a vertex and
/// D + 1 in an event. Line i of a plane kernel is n_i . x = d_i - t * sigma_i; an edge runs with its inner side on its left.
///
/// Laws (tests/kernel_laws.hpp runs them on every kernel that calls itself exact):
///  K1 orientation changes its sign with every transposition; it is zero iff the normals are linearly dependent.
///  K2 closing, meet and side do not depend on the order of their planes beyond what is stated.
///  K3 compare is a total preorder: antisymmetric, transitive.
///  K4 nothing changes when a plane's equation is multiplied by a positive number (adaptors that perturb: where the
///     unperturbed answer is not zero).
template <class K, int D>
concept moving_planes = std::copyable<typename K::meeting> && requires(const K& k, const meeting_planes<D>& q, const typename K::meeting& m) {
  // Whether every answer is the true one for the planes as given (for a rational kernel: for its rational speeds). An
  // inexact kernel may contradict itself; algorithms then end with undecided_error instead of an assertion.
  { K::exact } -> std::convertible_to<bool>;

  // The number of planes. `same_as` and not `convertible_to`: ids are compared with it.
  { k.size() } -> std::same_as<plane_id>;

  // Plane intersection: the moment at which D + 1 planes meet, planes in any order; empty where S = 0 (they meet
  // always or never). Not a number: the algorithm can only hand it back.
  { k.meet(q) } -> std::same_as<std::optional<typename K::meeting>>;

  // The planes of a meeting, ascending.
  { k.planes(m) } -> std::convertible_to<meeting_planes<D>>;

  // Sign of S for the planes of a meeting in ascending order; never zero, since the meeting exists.
  { k.closing(m) } -> std::same_as<sign>;

  // The moment just after the beginning: later than every meeting at time zero, earlier than all other later ones.
  { k.start() } -> std::same_as<typename K::meeting>;

  // Order in time: negative when the first meeting is the earlier one, zero when they are simultaneous.
  { k.compare(m, m) } -> std::same_as<sign>;
};

/// A kernel of the plane.
template <class K>
concept kernel_of_lines = moving_planes<K, 2> && requires(const K& k, plane_id a, plane_id b, plane_id c, const typename K::meeting& m) {
  // Sign of det(n_a, n_b): positive where an edge on b turns left from one on a. Zero: parallel.
  { k.orientation(a, b) } -> std::same_as<sign>;
  // Whether the *unperturbed* lines cross. The same as orientation != zero but for adaptors that perturb.
  { k.transversal(a, b) } -> std::same_as<bool>;
  // The moving vertex (a,b) at the moment of m against line c: positive inside. Requires orientation(a,b) != zero.
  { k.side(c, a, b, m) } -> std::same_as<sign>;
};

/// A kernel of space.
template <class K>
concept kernel_of_planes = moving_planes<K, 3> && requires(const K& k, plane_id a, plane_id b, plane_id c, plane_id d, const typename K::meeting& m,
                                                           const typename K::bisector_type& e, std::span<const triple> tree) {
  // Sign of det(n_a, n_b, n_c): how three planes meet. Zero: they have no common point, or a common line.
  { k.orientation(a, b, c) } -> std::same_as<sign>;

  // Whether the three *unperturbed* planes meet in one point. The same as orientation != zero but for adaptors that
  // perturb: a corner made by a perturbation alone is infinitely far away and cannot be part of a vertex.
  { k.transversal(a, b, c) } -> std::same_as<bool>;

  // The moving vertex (a,b,c) at the moment of m against plane d: positive inside. Zero: on the plane. Requires
  // orientation(a,b,c) != zero, and for the start that the four planes meet in one point at time zero.
  { k.side(d, a, b, c, m) } -> std::same_as<sign>;

  // The plane swept by the edge between facets a and b, and the order of two such by the angle between the outward
  // normals of their facets: negative when the first angle is the smaller one, that is, when the first edge is the
  // slower one (for unit weights). Rational, so exact without roots.
  { k.bisector(a, b) } -> std::same_as<typename K::bisector_type>;
  { k.compare(e, e) } -> std::same_as<sign>;

  // Two ways to split one vertex, each a list of its triangles (counter-clockwise seen from outside): the sign of
  // the difference of the offset solids' volumes. Requires that all planes pass through one point at time zero.
  { k.compare_volume(tree, tree) } -> std::same_as<sign>;
};

/// What a straight skeleton's algorithms ask of numbers, in the plane (D = 2) or in space (D = 3).
template <class K, int D>
concept kernel = (D == 2 && kernel_of_lines<K>) || (D == 3 && kernel_of_planes<K>);

/// A kernel, of space or of the plane, whose predicates can be asked for the coefficient of any power of an infinitesimal, which is what the
/// adaptor `perturbed` needs (design 04). Grade 0 is the unperturbed predicate; plane i is taken as
/// n_i + e^2 u_i, d_i + e delta_i with fixed integers u_i, delta_i; the answer is the coefficient of e^grade. Where the orientation of a
/// corner is zero, side answers zero.
template <class K>
concept graded_kernel = requires(const K& k, int grade, const corner_planes<K::dimension>& t, const meeting_planes<K::dimension>& q) {
  { k.orientation_at(grade, t) } -> std::same_as<sign>;
  { k.offset_at(grade, q) } -> std::same_as<sign>;    // of D
  { k.closing_at(grade, q) } -> std::same_as<sign>;   // of S
  { k.cross_at(grade, q, q) } -> std::same_as<sign>;  // of D(q1) S(q2) - D(q2) S(q1)
  // A meeting without the promise that S is not zero at grade 0.
  { k.meeting_of(q) } -> std::same_as<typename K::meeting>;
};

/// A kernel that says of itself (`K::breaks_ties`) that it never answers zero about different planes: it tells apart what coincides.
template <class K>
concept tie_breaking_kernel = requires {
  requires K::breaks_ties;
};

/// A kernel whose zeros tell what coincides.
template <class K, int D>
concept unperturbed_kernel = kernel<K, D> && !tie_breaking_kernel<K>;

/// The kernel that an adaptor has below it.
template <class K>
using base_of = std::remove_cvref_t<decltype(std::declval<const K&>().base())>;

/// A kernel that breaks the ties of another one, its base, whose zeros tell what coincides.
template <class K, int D>
concept perturbed_kernel = kernel<K, D> && tie_breaking_kernel<K> && unperturbed_kernel<base_of<K>, D>;

/// A kernel under which a raw skeleton can be contracted: by its own zeros, or by those of its base. A kernel that breaks ties and has
/// no base would merge nothing.
template <class K, int D>
concept contracting_kernel = unperturbed_kernel<K, D> || perturbed_kernel<K, D>;

/// The highest power of the infinitesimal in which D, S and their products have coefficients: lambda has degree 3 (the dimension) in
/// e^2, D one more in e, so D has degree 7, S 6 and D S 13.
template <int Dimension>
inline constexpr int highest_grade_in = 4 * Dimension + 1;
inline constexpr int highest_grade = highest_grade_in<3>;

}  // namespace osteon
