// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// filtered<K>: certified floating point first, K only where that cannot decide.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "osteon/core/prefetch.hpp"
#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/estimate.hpp"

namespace osteon {

/// Signs that are certain, or nothing.
template <int Dimension>
class basic_filter_arithmetic : public estimated_planes<Dimension> {
 public:
  using estimated_planes<Dimension>::estimated_planes;
  /// Returns the sign of a number, or nothing.
  std::optional<sign> decide(const estimate& x) const { return x.certain_sign(); }
  /// Returns the sign of a form in the speeds, or nothing.
  std::optional<sign> decide(const linear_form<estimate>& f) const { return this->value(f).certain_sign(); }
};
/// The arithmetic of the filter in space.
using filter_arithmetic = basic_filter_arithmetic<3>;

/// The graded kernel K with a floating-point filter in front. It always gives the same answers as
/// K.
template <class K>
class filtered {
 public:
  static constexpr bool exact = K::exact;
  static constexpr int dimension = K::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;

  /// D and S as estimates, an interval that certainly contains D / S, and one for its coefficient
  /// of e (docs/theory/degeneracy.md).
  struct meeting {
    support planes;
    sign closing;
    estimate offset;
    estimate speed;
    double earliest;
    double latest;
    double least_drift;
    double most_drift;
  };
  using bisector_type = typename K::bisector_type;

  /// The kernel K and the planes that it is about; `anchors`: see round_planes.
  filtered(std::span<const moving_plane<integer, K::dimension>> planes, K exact_kernel,
           std::span<const std::array<double, K::dimension>> anchors = {})
      : fast_(basic_filter_arithmetic<dimension>(planes, anchors)), exact_(std::move(exact_kernel)) {}
  /// Returns the kernel without the filter.
  const K& base() const { return exact_; }

  /// The questions of the concept kernel<K, D>, as core/kernel.hpp states them.
  ///@{
  plane_id size() const { return exact_.size(); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) sign orientation(Planes... of)
  const { return orientation_at(0, {of...}); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) bool transversal(Planes... of) const { return orientation(of...) != sign::zero; }

  std::optional<meeting> meet(const support& q) const {
    const meeting m = meeting_of(q);
    return m.closing == sign::zero ? std::nullopt : std::optional(m);
  }
  support planes(const meeting& m) const { return m.planes; }
  sign closing(const meeting& m) const { return m.closing; }
  meeting start() const { return {start_planes, sign::positive, estimate(0), estimate(1), 0, 0, 0, 0}; }
  sign compare(const meeting& m, const meeting& n) const {
    if (m.latest < n.earliest) return sign::negative;
    if (m.earliest > n.latest) return sign::positive;
    if (m.planes == n.planes) return sign::zero;
    if (m.planes == start_planes) return -compare(n, m);
    if (n.planes == start_planes) return offset_sign(m) * m.closing == sign::positive ? sign::positive : sign::negative;
    return cross(m, n) * m.closing * n.closing;
  }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const requires(dimension == 3) { return side_of({a, b, c, d}, m); }
  sign side(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(dimension == 2) { return side_of({a, b, c}, m); }

  bisector_type bisector(plane_id a, plane_id b) const { return exact_.bisector(a, b); }
  sign compare(const bisector_type& e, const bisector_type& f) const requires(dimension == 3) { return exact_.compare(e, f); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const requires(dimension == 3) { return exact_.compare_volume(s, t); }
  ///@}

  /// The questions of the concept graded_kernel, as graded_kernel.hpp states them.
  ///@{
  meeting meeting_of(const support& q) const {
    const support ascending = sorted(q);
    const lambdas_of lambda = fast_.lambda(0, ascending);
    meeting m = estimated(ascending, lambda);
    refine(m);
    std::tie(m.earliest, m.latest) = ratio(m.offset, m.speed);
    estimate drift(0);
    for (int r = 0; r <= dimension; ++r) drift = drift + lambda[r] * fast_.arithmetic().delta(ascending[r]);
    std::tie(m.least_drift, m.most_drift) = ratio(drift, m.speed);
    const auto s = m.speed.certain_sign();
    m.closing = s ? *s : exact_.closing_at(0, m.planes);
    return m;
  }
  sign orientation_at(int grade, const corner& c) const {
    const auto s = fast_.orientation_at(grade, c);
    return s ? *s : exact_.orientation_at(grade, c);
  }
  sign offset_at(int grade, const support& q) const {
    const auto s = fast_.offset_at(grade, q);
    return s ? *s : exact_.offset_at(grade, q);
  }
  sign closing_at(int grade, const support& q) const {
    const auto s = fast_.closing_at(grade, q);
    return s ? *s : exact_.closing_at(grade, q);
  }
  sign cross_at(int grade, const support& q, const support& r) const {
    const auto s = coefficient(grade, q, r).certain_sign();
    return s ? *s : exact_.cross_at(grade, q, r);
  }
  ///@}

  // Beyond the concept, for adaptors and algorithms that can use it.

  /// Tells the processor that this plane will be asked about soon.
  void prefetch(plane_id a) const { osteon::prefetch(fast_.arithmetic().plane(a)); }
  /// Returns what K says (see arithmetic_kernel).
  bool has_unit_speeds() const requires requires(const K& k) { k.has_unit_speeds(); }
  { return exact_.has_unit_speeds(); }
  /// Returns the order of two meetings with the same time, S not zero, by the coefficients of e in
  /// their times; zero where that is not certain.
  sign compare_drift(const meeting& m, const meeting& n) const {
    if (m.most_drift < n.least_drift) return sign::negative;
    return m.least_drift > n.most_drift ? sign::positive : sign::zero;
  }

 private:
  static constexpr support start_planes = start_planes_in<dimension>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using lambdas_of = std::array<estimate, dimension + 1>;

  // The corner of all planes but the last against the last.
  sign side_of(const support& q, const meeting& m) const {
    corner c{};
    std::copy_n(q.begin(), dimension, c.begin());
    const auto lambda = fast_.lambda(0, q);
    const auto known = lambda[dimension].certain_sign();  // the corner's orientation
    const sign turn = known ? *known : exact_.orientation_at(0, c);
    if (turn == sign::zero) return sign::zero;
    if (m.planes == start_planes) return -closing_at(0, q) * turn;
    meeting other = estimated(q, lambda);
    if (const auto s = quick_cross(other, m)) return *s * m.closing * turn;
    if constexpr (requires { exact_.rough_side(q.back(), m.planes); })
      if (std::all_of(c.begin(), c.end(), [&m](plane_id p) { return std::find(m.planes.begin(), m.planes.end(), p) != m.planes.end(); }))
        if (const sign s = exact_.rough_side(q.back(), m.planes); s != sign::zero) return s;
    refine(other);
    return cross(other, m) * m.closing * turn;
  }

  // The coefficient of e^grade in D(q) S(r) - D(r) S(q), as in formulas.hpp, but of rounded D and
  // S.
  estimate coefficient(int grade, const support& q, const support& r) const {
    struct form {
      std::array<estimate, 2 * dimension + 2> offset;  // by grade
      std::array<estimate, dimension + 1> speed;       // by half of the grade
    };
    const auto form_of = [&](const support& planes) {
      const auto& a = fast_.arithmetic();
      form f;
      for (int m = 0; m <= std::min(grade / 2, dimension); ++m) {
        const lambdas_of l = fast_.lambda(m, planes);
        f.offset[2 * m] = f.offset[2 * m + 1] = f.speed[m] = estimate(0);
        for (int i = 0; i <= dimension; ++i) {
          f.offset[2 * m] = f.offset[2 * m] + l[i] * a.d(planes[i]);
          f.offset[2 * m + 1] = f.offset[2 * m + 1] + l[i] * a.delta(planes[i]);
          f.speed[m] = f.speed[m] + l[i] * a.speed(planes[i]);
        }
      }
      return f;
    };
    const form f = form_of(q);
    const form g = form_of(r);
    estimate sum(0);
    for (int m = 0; m <= std::min(grade / 2, dimension); ++m)
      if (const int rest = grade - 2 * m; rest <= 2 * dimension + 1) sum = sum + f.offset[rest] * g.speed[m] - g.offset[rest] * f.speed[m];
    return sum;
  }

  // D and S; the sign of S and the intervals are still open.
  meeting estimated(const support& q, const lambdas_of& lambda) const {
    const auto& a = fast_.arithmetic();
    meeting m{q, sign::zero, estimate(0), estimate(0), -infinity, infinity, -infinity, infinity};
    for (int r = 0; r <= dimension; ++r) {
      m.offset = m.offset + lambda[r] * a.d_from(q[r], q[0]);
      m.speed = m.speed + lambda[r] * a.speed(q[r]);
    }
    return m;
  }

  // An interval that contains the quotient of two true numbers (see estimate.hpp).
  static std::pair<double, double> ratio(const estimate& d, const estimate& s) {
    const double below = std::abs(s.value) - s.error();
    if (!(below > 0 && s.scale > 1e-250 && (d.scale > 1e-250 || d.scale == 0) && s.scale < 1e290 && d.scale < 1e290)) return {-infinity, infinity};
    const double t = d.value / s.value;
    const double radius = quotient_error(t, d.error(), s.error(), below) + std::abs(t) * 0x1p-50;
    return {t - radius, t + radius};
  }

  // Almost coplanar planes leave few bits of D and S. Then D and S are worth being computed
  // exactly, once, and rounded: almost all comparisons that follow are decided quickly.
  void refine(meeting& m) const {
    if constexpr (requires { exact_.refined(m.planes); }) {
      if ((m.speed.precise() && m.offset.precise()) || !fast_.arithmetic().unscaled()) return;
      if (const auto known = exact_.refined(m.planes)) {
        m.offset = estimate::rounded(to_double(known->first, 0));
        m.speed = estimate::rounded(to_double(known->second, K::speed_bits));
      }
    }
  }

  static std::optional<sign> quick_cross(const meeting& m, const meeting& n) { return (m.offset * n.speed - n.offset * m.speed).certain_sign(); }

  sign cross(const meeting& m, const meeting& n) const {
    const auto s = quick_cross(m, n);
    return s ? *s : exact_.cross_at(0, m.planes, n.planes);
  }

  sign offset_sign(const meeting& m) const {
    const auto s = m.offset.certain_sign();
    return s ? *s : exact_.offset_at(0, m.planes);
  }

  formulas<basic_filter_arithmetic<dimension>> fast_;
  K exact_;
};

}  // namespace osteon
