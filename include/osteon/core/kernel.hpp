// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The concept that separates the algorithms from numbers. Everything that the library computes
/// about moving planes is said with the operations below; no algorithm sees a coordinate or a
/// number type (docs/theory/numbers-and-predicates.md).
///
/// The space has dimension D: planes in space (D = 3) or lines in the plane (D = 2), both called
/// planes here. Plane i has the equation  n_i . x = d_i - t * sigma_i  at time t, with the outward
/// normal n_i and the speed sigma_i = w_i |n_i|; its inner side is  h_i(x,t) = d_i - t * sigma_i -
/// n_i . x >= 0. D planes make a corner, whose point is a moving vertex. D + 1 planes q make a
/// meeting. With lambda_r the signed D x D minor of the normals that leaves out plane r,
///
///     D(q) = sum lambda_r d_r,   S(q) = sum lambda_r sigma_r,
///     L(t) = sum lambda_r h_r(x,t) = D(q) - t S(q)   for every x,
///
/// so the planes of q share a point exactly at t = D(q) / S(q), and the corner of all planes but r
/// lies inside of plane r iff L(t) / lambda_r > 0.
///
/// Words: a *time* is a number. A *moment* is what a meeting stands for in the algorithms, which
/// know no numbers: moments have an order and nothing else.

#include <concepts>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"

namespace osteon {

/// What the algorithms ask of a kernel in either dimension: meetings and the order of their
/// moments.
///
/// Laws; tests/kernel_laws.hpp checks them for every kernel that calls itself exact:
///  K1 orientation changes its sign with every transposition; it is zero iff the normals are
///     dependent.
///  K2 closing, meet and side do not depend on the order of their planes beyond what is stated.
///  K3 compare is a total preorder: antisymmetric, transitive.
///  K4 Nothing changes when a plane's equation is multiplied by a positive number (for kernels that
///     break ties: where the unperturbed answer is not zero).
template <class K, int D>
concept moving_planes = std::copyable<typename K::meeting> && requires(const K& k, const meeting_planes<D>& q, const typename K::meeting& m) {
  // Whether every answer is the true one for the planes as given (for a rational kernel: for its
  // rational speeds). A kernel that is not exact may contradict itself; algorithms then end with
  // undecided_error instead of invariant_error.
  { K::exact } -> std::convertible_to<bool>;

  // The number of planes. `same_as` and not `convertible_to`, because numbers of planes are
  // compared with it.
  { k.size() } -> std::same_as<plane_id>;

  // The meeting of D + 1 planes, given in any order; nothing where S = 0, since such planes share a
  // point always or never. A meeting is no number: an algorithm can only hand it back.
  { k.meet(q) } -> std::same_as<std::optional<typename K::meeting>>;

  // The planes of a meeting, ascending.
  { k.planes(m) } -> std::convertible_to<meeting_planes<D>>;

  // The sign of S for the planes of a meeting in ascending order; never zero, since the meeting
  // exists.
  { k.closing(m) } -> std::same_as<sign>;

  // The moment just after time zero: later than every meeting at time zero, earlier than all that
  // are later.
  { k.start() } -> std::same_as<typename K::meeting>;

  // The order of two moments: negative where the first one is earlier, zero where they are the
  // same.
  { k.compare(m, m) } -> std::same_as<sign>;
};

/// What the algorithms of the plane ask of a kernel. An edge runs along its line with the inner
/// side on its left.
template <class K>
concept kernel_of_lines = moving_planes<K, 2> && requires(const K& k, line_id a, line_id b, line_id c, const typename K::meeting& m) {
  // The sign of det(n_a, n_b): positive where an edge on b turns left from one on a. Zero:
  // parallel.
  { k.orientation(a, b) } -> std::same_as<sign>;

  // Whether the *unperturbed* lines cross: the same as orientation != zero, but for kernels that
  // break ties.
  { k.transversal(a, b) } -> std::same_as<bool>;

  // The vertex (a,b) at the moment of m against line c: positive inside. Zero: on the line.
  // Requires orientation(a,b) != zero.
  { k.side(c, a, b, m) } -> std::same_as<sign>;
};

/// What the algorithms of space ask of a kernel.
template <class K>
concept kernel_of_planes = moving_planes<K, 3> && requires(const K& k, plane_id a, plane_id b, plane_id c, plane_id d, const typename K::meeting& m,
                                                           const typename K::bisector_type& e, std::span<const triple> tree) {
  // The sign of det(n_a, n_b, n_c). Zero: the planes have no common point, or a common line.
  { k.orientation(a, b, c) } -> std::same_as<sign>;

  // Whether the *unperturbed* planes meet in one point: the same as orientation != zero, but for
  // kernels that break ties. A corner that only a perturbation makes is infinitely far away and
  // cannot be part of a vertex.
  { k.transversal(a, b, c) } -> std::same_as<bool>;

  // The vertex (a,b,c) at the moment of m against plane d: positive inside. Zero: on the plane.
  // Requires orientation(a,b,c) != zero and, for the start, that the four planes share a point at
  // time zero.
  { k.side(d, a, b, c, m) } -> std::same_as<sign>;

  // The plane that the edge between facets a and b sweeps, and the order of two such by the angle
  // between the outward normals of their facets: negative where the first angle is the smaller one,
  // that is, where the first edge is the slower one (for unit weights).
  { k.bisector(a, b) } -> std::same_as<typename K::bisector_type>;
  { k.compare(e, e) } -> std::same_as<sign>;

  // Two ways to split one vertex, each a list of triangles, counter-clockwise seen from outside:
  // the sign of the difference of the volumes of the solids that they leave. Requires that all
  // planes pass through one point at time zero.
  { k.compare_volume(tree, tree) } -> std::same_as<sign>;
};

/// What a straight skeleton's algorithms ask of numbers, in the plane (D = 2) or in space (D = 3).
template <class K, int D>
concept kernel = (D == 2 && kernel_of_lines<K>) || (D == 3 && kernel_of_planes<K>);

/// A kernel that says of itself (`K::breaks_ties`) that it never answers zero about different
/// planes: it tells apart what coincides.
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

/// A kernel that breaks the ties of another one, its base, whose zeros tell what coincides. Its
/// answers are those of the base where these are not zero.
template <class K, int D>
concept perturbed_kernel = kernel<K, D> && tie_breaking_kernel<K> && unperturbed_kernel<base_of<K>, D>;

/// A kernel under which a raw skeleton can be contracted: by its own zeros, or by those of its
/// base. A kernel that breaks ties and has no base would merge nothing.
template <class K, int D>
concept contracting_kernel = unperturbed_kernel<K, D> || perturbed_kernel<K, D>;

/// Returns the kernel without its perturbation: the base of a perturbed kernel, else the kernel
/// itself.
template <class K>
constexpr const auto& unperturbed(const K& k) {
  if constexpr (perturbed_kernel<K, 2> || perturbed_kernel<K, 3>)
    return k.base();
  else
    return k;
}

/// Returns the sign of lambda_r of a meeting's planes, as a kernel decides it (core/planes.hpp).
/// *Requires* ascending planes, r < N.
template <class K, std::size_t N>
requires kernel < K, static_cast<int>(N)
- 1 > sign lambda(const K& k, const std::array<plane_id, N>& planes, std::size_t r) {
  return lambda(planes, r, [&k](auto... others) { return k.orientation(others...); });
}

/// A kernel of the plane that breaks ties and knows what becomes of its meetings in the limit, when
/// its perturbation goes to zero. The event loop and the certificate of the plane use it during the
/// run: in the limit an edge can have length zero for a while, and has to go then
/// (docs/theory/plane.md). They also run with a kernel that offers none of this, whose limit is the
/// kernel itself.
template <class K>
concept limit_kernel = kernel<K, 2> && requires(const K& k, line_id a, line_id b, line_id c, const typename K::meeting& m) {
  // Whether the meeting has a moment in the limit: not where S is zero there. `compare` cannot
  // tell, since it orders all meetings. A meeting without a moment belongs to the moment before it.
  { k.has_moment(m) } -> std::same_as<bool>;

  // Whether the meeting is infinitely late or early in the limit: S is zero there and D is not.
  // This is less than the lack of a moment: where D is zero too, the lines share a point at all
  // times.
  { k.is_never(m) } -> std::same_as<bool>;

  // Whether two meetings that have a moment in the limit have the same one. `compare` never says
  // so.
  { k.same_moment(m, m) } -> std::same_as<bool>;

  // Whether the vertex (a,b) lies on line c in the limit, at the moment of m; false where a and b
  // are parallel there. `side` never says so. Requires that m has a moment in the limit.
  { k.touches(c, a, b, m) } -> std::same_as<bool>;
};

}  // namespace osteon
