// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offset solids in numbers: closed meshes with exact incidences, many from one skeleton.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/evaluate/cut_rings.hpp"
#include "osteon/evaluate/triangulate.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/determinant.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/square_classes.hpp"
#include "osteon/kernel/to_double.hpp"
#include "osteon/space/offset.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// The speeds of planes, weight * |n|: square roots, or rational numbers in their place. Answers
/// are exact.
class plane_speeds {
 public:
  /// Takes the true speeds.
  explicit plane_speeds(std::span<const moving_plane<integer>> planes) {
    for (const auto& p : planes) roots_.add(inner_product(p.n, p.n), p.weight);
    one_ = roots_.add(1);
  }
  /// Takes given ones, one for each plane: those of a kernel that rounds.
  explicit plane_speeds(std::vector<rational> given) : given_(std::move(given)) {}

  /// Returns the sign of a + sum c_r sigma_r over four planes.
  sign sign_of(const integer& a, const std::array<integer, 4>& c, const quadruple& q) const {
    if (!given_.empty()) {
      rational sum = a;
      for (std::size_t r = 0; r < 4; ++r) sum += c[r] * given_[static_cast<std::size_t>(q[r])];
      return osteon::sign_of(sum.sign());
    }
    std::array<term, 5> terms;
    int size = 0;
    for (std::size_t r = 0; r < 4; ++r)
      if (c[r] != 0) terms[static_cast<std::size_t>(size++)] = {q[r], c[r]};
    if (a != 0) terms[static_cast<std::size_t>(size++)] = {one_, a};
    return roots_.sign_of_form(terms, size);
  }

  /// Returns a speed: exact where it is given, else less than 2^-precision too small.
  rational rounded(plane_id p, unsigned precision) const {
    if (!given_.empty()) return given_[static_cast<std::size_t>(p)];
    return {roots_.scaled(p, precision), integer(1) << precision};
  }

 private:
  struct term {
    int plane;
    integer coefficient;
  };

  square_classes roots_;  // number p is that of plane p
  int one_ = -1;
  std::vector<rational> given_;
};

/// One moment t of the moving planes: exact answers, and where their corners are. The argument of
/// surface_at.
class instant_of_planes {
 public:
  /// *Requires* a time of zero or more, in units of the planes' integers. Keeps references to
  /// `planes` and `speeds`.
  instant_of_planes(std::span<const moving_plane<integer>> planes, const plane_speeds& speeds, const rational& time)
      : planes_(planes), speeds_(speeds), time_(time), p_(numerator(time)), q_(denominator(time)) {}

  /// Returns whether four planes share a point now.
  bool meets(const quadruple& q) const { return level(q, lambda(q)) == sign::zero; }
  /// Returns whether four planes meet at one moment only.
  bool meets_once(const quadruple& q) const { return speeds_.sign_of(0, lambda(q), q) != sign::zero; }
  /// Returns whether four planes that meet once have met now or before: whether D / S <= t.
  bool is_past(const quadruple& q) const {
    const auto l = lambda(q);
    return level(q, l) * speeds_.sign_of(0, l, q) != sign::positive;
  }

  /// Returns the corner of three planes, each coordinate within 2^-bits; exact where the speeds are
  /// rational. *Throws* invariant_error where they have none.
  std::array<rational, 3> corner(const triple& t, unsigned bits = 64) const {
    const integer det = minor(t[0], t[1], t[2]);
    if (det == 0) throw invariant_error("internal invariant violated: a vertex that lives for some time is a point");
    int size = bit_length(integer(p_ / q_)) + 8;
    for (const plane_id i : t) {
      int longest = 0;
      for (const integer& x : at(i).n) longest = std::max(longest, bit_length(x));
      size += longest;
    }
    const unsigned precision = bits + static_cast<unsigned>(size);
    std::array<rational, 3> x = {0, 0, 0};
    for (std::size_t r = 0; r < 3; ++r) {
      const auto& a = at(t[(r + 1) % 3]).n;
      const auto& b = at(t[(r + 2) % 3]).n;
      const rational offset = (rational(at(t[r]).d) - time_ * speeds_.rounded(t[r], precision)) / rational(det);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        x[axis] += offset * rational(a[u] * b[v] - a[v] * b[u]);
      }
    }
    return x;
  }

 private:
  const moving_plane<integer>& at(plane_id i) const { return planes_[static_cast<std::size_t>(i)]; }

  integer minor(plane_id i, plane_id j, plane_id k) const { return determinant(at(i).n, at(j).n, at(k).n); }
  std::array<integer, 4> lambda(const quadruple& q) const {
    return lambdas(q, [this](auto... planes) { return minor(planes...); });
  }
  // Sign of L(t) = D - t S.
  sign level(const quadruple& q, std::array<integer, 4> l) const {
    integer d = 0;
    for (std::size_t r = 0; r < 4; ++r) {
      d += l[r] * at(q[r]).d;
      l[r] *= -p_;
    }
    return speeds_.sign_of(d * q_, l, q);
  }

  std::span<const moving_plane<integer>> planes_;
  const plane_speeds& speeds_;
  rational time_;
  integer p_;
  integer q_;
};

/// A closed surface: every edge belongs to two facets, which pass it in opposite directions. Facets
/// are counter-clockwise seen from outside.
struct solid_surface {
  /// A facet of the surface, by its rings of corners.
  struct facet {
    std::vector<int> corners;
    plane_id plane;
  };
  /// in the units of the planes' integers, within 2^-64; exact where the speeds are rational
  std::vector<std::array<rational, 3>> points;
  std::vector<facet> facets;
};

/// Returns what is left of a solid at a time, in units of the planes' integers; at the moment of an
/// event what comes after it. What meets is decided exactly. Facets with holes, and those that
/// touch themselves, are cut into triangles; all are with `triangulate`. `k` is the perturbed
/// kernel that the skeleton was made with, `speeds` are its speeds. *Requires* a time of zero or
/// more. *Throws* invariant_error if the skeleton is none of these planes. *Complexity*: see
/// surface_at and cut_rings.
template <kernel<3> K>
solid_surface offset_surface(const K& k, std::span<const moving_plane<integer>> planes, const plane_speeds& speeds, const skeleton& raw,
                             const rational& time, bool triangulate = false) {
  const instant_of_planes now(planes, speeds, time);
  wavefront_surface w = surface_at(k, raw, now);
  solid_surface result;
  for (const int a : w.arcs) result.points.push_back(now.corner(raw.arcs[static_cast<std::size_t>(a)].planes));
  std::vector<flat_point> flat(result.points.size());
  for (auto from = w.rings.begin(); from != w.rings.end();) {
    const plane_id plane = from->plane;
    std::vector<std::vector<int>> rings;
    for (; from != w.rings.end() && from->plane == plane; ++from) rings.push_back(std::move(from->points));
    // Along the axis nearest to the normal, so that the facet is seen from outside.
    const auto& n = planes[static_cast<std::size_t>(plane)].n;
    std::size_t axis = 0;
    for (std::size_t x = 1; x < 3; ++x)
      if (abs(n[x]) > abs(n[axis])) axis = x;
    std::size_t u = (axis + 1) % 3;
    std::size_t v = (axis + 2) % 3;
    if (n[axis] < 0) std::swap(u, v);
    for (const auto& r : rings)
      for (const int p : r) flat[p] = {result.points[p][u].convert_to<double>(), result.points[p][v].convert_to<double>()};
    cut_rings(flat, std::move(rings), triangulate, [&](std::vector<int> corners) { result.facets.push_back({std::move(corners), plane}); });
  }
  return result;
}

}  // namespace osteon
