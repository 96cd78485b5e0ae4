// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// perturbed<K>: symbolic perturbation in two levels, first of the offsets, then of the normals
/// (docs/theory/degeneracy.md).

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/kernel/arithmetic_kernel.hpp"
#include "osteon/kernel/graded_kernel.hpp"

namespace osteon {

/// The graded kernel K without ties: no answer about different planes is zero, and all meetings
/// have one strict order. Where K's answer is not zero it is the same, and little is added to its
/// cost.
template <graded_kernel K>
class perturbed {
 public:
  static constexpr bool exact = K::exact;
  static constexpr bool breaks_ties = true;  ///< see tie_breaking_kernel
  static constexpr int dimension = K::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;

  /// A meeting of the unperturbed kernel, which may be without a time.
  struct meeting {
    typename K::meeting base;
    sign closing;  ///< of the leading coefficient of S
    bool regular;  ///< that coefficient is the one of grade 0
  };
  using bisector_type = typename K::bisector_type;

  /// The kernel whose ties are broken; `mirrored` tilts all planes the other way.
  explicit perturbed(K base, bool mirrored = false) : k_(std::move(base)), mirrored_(mirrored) {}
  /// Returns the kernel without the perturbation.
  const K& base() const { return k_; }

  /// The questions of the concept kernel<K, D>, as core/kernel.hpp states them.
  ///@{
  plane_id size() const { return k_.size(); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) sign orientation(Planes... of)
  const { return orientation_of({of...}); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) bool transversal(Planes... of) const { return k_.transversal(of...); }

  std::optional<meeting> meet(const support& q) const {
    meeting m{k_.meeting_of(q), sign::zero, true};
    m.closing = k_.closing(m.base);
    if (m.closing == sign::zero) {
      m.regular = false;
      for (int g = 2; g <= 2 * dimension && m.closing == sign::zero; g += 2) m.closing = at(g, k_.closing_at(g, planes(m)));
      if (m.closing == sign::zero) return std::nullopt;  // none of them moves
    }
    return m;
  }
  support planes(const meeting& m) const { return k_.planes(m.base); }
  sign closing(const meeting& m) const { return m.closing; }
  meeting start() const { return {k_.start(), sign::positive, true}; }

  sign compare(const meeting& m, const meeting& n) const {
    const support q = planes(m);
    const support r = planes(n);
    if (q == r) return sign::zero;
    if (q == start_planes) return -compare(n, m);
    if (r == start_planes) return after_start(m);
    if (m.regular && n.regular) {
      const sign s = k_.compare(m.base, n.base);
      if (s != sign::zero) return s;
      if constexpr (requires { k_.compare_drift(m.base, n.base); })
        if (const sign d = k_.compare_drift(m.base, n.base); d != sign::zero) return d;
    }
    return leading([&](int g) { return k_.cross_at(g, q, r); }, m.regular && n.regular ? 1 : 0).value * m.closing * n.closing;
  }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const requires(dimension == 3) {
    return side_of({a, b, c, d}, m, [&] { return k_.side(d, a, b, c, m.base); });
  }
  sign side(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(dimension == 2) {
    return side_of({a, b, c}, m, [&] { return k_.side(c, a, b, m.base); });
  }

  bisector_type bisector(plane_id a, plane_id b) const { return k_.bisector(a, b); }
  sign compare(const bisector_type& e, const bisector_type& f) const requires(dimension == 3) { return k_.compare(e, f); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const requires(dimension == 3) { return k_.compare_volume(s, t); }
  ///@}

  /// The questions of the concept limit_kernel: what becomes of the answers when the perturbation
  /// goes to zero.
  ///@{
  bool has_moment(const meeting& m) const { return m.regular; }
  bool is_never(const meeting& m) const { return !m.regular && k_.offset_at(0, planes(m)) != sign::zero; }
  bool same_moment(const meeting& m, const meeting& n) const { return k_.compare(m.base, n.base) == sign::zero; }
  bool touches(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(dimension == 2) {
    return k_.transversal(a, b) && k_.side(c, a, b, m.base) == sign::zero;
  }
  ///@}

  // Beyond the concept, for algorithms that can use it.

  /// Tells the processor that this plane will be asked about soon.
  void prefetch(plane_id a) const requires requires(const K& k) { k.prefetch(a); }
  { k_.prefetch(a); }
  /// Returns what K says (see arithmetic_kernel).
  bool has_unit_speeds() const requires requires(const K& k) { k.has_unit_speeds(); }
  { return k_.has_unit_speeds(); }

 private:
  static constexpr support start_planes = start_planes_in<dimension>;

  struct leading_sign {
    sign value;
    int grade;
  };

  sign orientation_of(const corner& c) const {
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < i; ++j)
        if (c[i] == c[j]) return sign::zero;
    return leading([&](int g) { return k_.orientation_at(g, c); }, 0).value;
  }

  // The corner of all planes but the last against the last.
  template <class Unperturbed>
  sign side_of(const support& q, const meeting& m, Unperturbed unperturbed) const {
    const support r = planes(m);
    corner c{};
    std::copy_n(q.begin(), dimension, c.begin());
    if (r == start_planes) return at_start(q) * orientation_of(c);
    if (std::find(r.begin(), r.end(), q.back()) != r.end() && sorted(q) == r) return sign::zero;
    if (m.regular)
      if (const sign s = unperturbed(); s != sign::zero) return s;
    const leading_sign turn = leading([&](int g) { return k_.orientation_at(g, c); }, 0);
    // Where grade 0 is known to be zero, it is the corner's place and not its orientation.
    const int first = m.regular && turn.grade == 0 ? 1 : 0;
    return leading([&](int g) { return k_.cross_at(g, q, r); }, first).value * m.closing * turn.value;
  }

  // A coefficient of e^grade contains grade / 2 tilts.
  sign at(int grade, sign coefficient) const { return mirrored_ && grade / 2 % 2 != 0 ? -coefficient : coefficient; }

  // The first coefficient from grade `first` on that is not zero. All zero would mean that the
  // fixed perturbation is itself in special position.
  template <class Coefficient>
  leading_sign leading(Coefficient coefficient, int first) const {
    for (int g = first; g <= highest_grade_in<dimension>; ++g)
      if (const sign s = at(g, coefficient(g)); s != sign::zero) return {s, g};
    throw invariant_error("the symbolic perturbation is degenerate: all coefficients are zero");
  }

  // D / S against a moment that is later than every multiple of e and earlier than every positive
  // number.
  sign after_start(const meeting& m) const {
    const support q = planes(m);
    if (m.regular) return k_.compare(m.base, k_.start());
    const auto d = leading([&](int g) { return k_.offset_at(g, q); }, 0);
    const auto s = leading([&](int g) { return k_.closing_at(g, q); }, 2);
    return d.grade <= s.grade && d.value * s.value == sign::positive ? sign::positive : sign::negative;
  }

  // Sign of L = D - t S at that moment: the coefficients in the order of size S0, D1, S1, D2, ...;
  // D0 is zero, since the planes meet in a point at time zero.
  sign at_start(const support& q) const {
    for (int g = 0; g <= 2 * dimension + 1; ++g) {
      if (const sign d = g == 0 ? sign::zero : at(g, k_.offset_at(g, q)); d != sign::zero) return d;
      if (const sign s = at(g, k_.closing_at(g, q)); s != sign::zero) return -s;
    }
    throw invariant_error("the symbolic perturbation is degenerate: the planes of a meeting share a point at the start");
  }

  K k_;
  bool mirrored_;
};

}  // namespace osteon
