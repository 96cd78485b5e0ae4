// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A kernel from the formulas and an arithmetic that always knows the sign: what the double,
/// rational and square-root kernels share.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/meeting_memory.hpp"

namespace osteon {

/// What stands for the planes of the start.
template <int Dimension>
inline constexpr meeting_planes<Dimension> start_planes_in = [] {
  meeting_planes<Dimension> none{};
  for (plane_id& p : none) p = -1;
  return none;
}();

/// The edge between two facets as the plane that it sweeps.
struct swept_plane {
  plane_id a, b;
};

/// A graded kernel of space or of the plane over an `Arithmetic` (see formulas.hpp) whose `decide`
/// always knows the sign. It has in addition:
///  - is_exact: whether the signs are the true ones;
///  - decide_offset(D): the sign of D for the order of a meeting and the start;
///  - in space angle_order(a, b, c, d) and volume_order(tree, tree), which answer the concept's
///    comparisons.
/// An arithmetic of long numbers remembers minors, and a rough one (see meeting_memory.hpp) the
/// meetings it was asked about; so a question costs its formula the first time and less later, and
/// one kernel must not be used by two threads at once.
template <class Arithmetic>
class arithmetic_kernel {
 public:
  static constexpr bool exact = Arithmetic::is_exact;
  static constexpr int dimension = Arithmetic::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;

  /// The planes of a meeting, ascending, and the sign of S.
  struct meeting {
    support planes;
    sign closing;
  };
  using bisector_type = swept_plane;

  explicit arithmetic_kernel(Arithmetic a) : f_(std::move(a)) {}
  /// Returns the numbers that the kernel is about.
  const Arithmetic& arithmetic() const { return f_.arithmetic(); }

  /// The questions of the concept kernel<K, D>, as core/kernel.hpp states them.
  ///@{
  plane_id size() const { return f_.arithmetic().size(); }
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
  meeting start() const { return {start_planes, sign::positive}; }
  sign compare(const meeting& m, const meeting& n) const {
    if (m.planes == n.planes) return sign::zero;
    if (m.planes == start_planes) return -compare(n, m);
    if (n.planes == start_planes) return after_start(m);
    return cross_at(0, m.planes, n.planes) * m.closing * n.closing;
  }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const requires(dimension == 3) { return side_of({a, b, c, d}, m); }
  sign side(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(dimension == 2) { return side_of({a, b, c}, m); }

  bisector_type bisector(plane_id a, plane_id b) const { return {a, b}; }
  sign compare(const bisector_type& e, const bisector_type& f) const requires(dimension == 3) {
    return f_.arithmetic().angle_order(e.a, e.b, f.a, f.b);
  }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const requires(dimension == 3) {
    return f_.arithmetic().volume_order(s, t);
  }
  ///@}

  /// The questions of the concept graded_kernel, as graded_kernel.hpp states them.
  ///@{
  meeting meeting_of(const support& q) const {
    const support s = sorted(q);
    return {s, closing_at(0, s)};
  }
  sign orientation_at(int grade, const corner& c) const { return f_.orientation_at(grade, c); }
  sign offset_at(int grade, const support& q) const { return f_.offset_at(grade, q); }
  sign closing_at(int grade, const support& q) const {
    if constexpr (remembers)
      if (grade == 0) {
        const auto& known = memory_.recall(f_, sorted(q));
        if (abs(known.speed) > known.error) return parity(q) * sign_of(known.speed);
      }
    return f_.closing_at(grade, q);
  }
  sign cross_at(int grade, const support& q, const support& r) const {
    if constexpr (remembers)
      if (const auto s = known_cross(grade, q, r)) return *s;
    return f_.cross_at(grade, q, r);
  }
  ///@}

  // Beyond the concept, for adaptors and algorithms that can use it.

  /// Returns whether all planes have the same weight, and the kernel treats roots exactly.
  bool has_unit_speeds() const requires requires(const Arithmetic& a) { a.has_unit_speeds(); }
  { return f_.arithmetic().has_unit_speeds(); }

  /// Returns D and S of planes in this order, S in units of 2^-speed_bits with at least 60 correct
  /// bits; nothing where it has fewer.
  std::optional<std::pair<integer, integer>> refined(const support& q) const requires rough_arithmetic<Arithmetic> {
    memory_.make_room();
    const auto& known = memory_.recall(f_, sorted(q));
    if (abs(known.speed) >> 60U <= known.error && known.error != 0) return std::nullopt;
    if (parity(q) == sign::positive) return std::pair(known.offset, known.speed);
    return std::pair(integer(-known.offset), integer(-known.speed));
  }
  static constexpr int speed_bits = Arithmetic::speed_bits;

  /// Returns on which side of plane d the planes of q, ascending, meet; zero where that is not
  /// certain.
  sign rough_side(plane_id d, const quadruple& q) const requires(dimension == 3 && rough_arithmetic<Arithmetic>) {
    const auto& a = f_.arithmetic();
    const rough_point& at = memory_.point(f_, memory_.recall(f_, q), q);
    if (at.radius < 0) return sign::zero;
    constexpr auto bits = static_cast<unsigned>(speed_bits);
    integer inner = 0;
    integer size = 0;
    for (int axis = 0; axis < 3; ++axis) {
      inner += a.n(d, axis) * at.x[axis];
      size += abs(a.n(d, axis));
    }
    const integer speed = a.rough_speed(d);
    const integer value = (a.d(d) << (2 * bits)) - speed * at.time - (inner << bits);
    const integer error = at.radius * (speed + 1) + abs(at.time) + (at.radius * size << bits);
    return abs(value) > error ? sign_of(value) : sign::zero;
  }

 private:
  static constexpr support start_planes = start_planes_in<dimension>;
  static constexpr bool remembers = rough_arithmetic<Arithmetic>;

  // The corner of all planes but the last against the last.
  sign side_of(const support& q, const meeting& m) const {
    corner c{};
    std::copy_n(q.begin(), dimension, c.begin());
    return (m.planes == start_planes ? -closing_at(0, q) : cross_at(0, q, m.planes) * m.closing) * f_.orientation_at(0, c);
  }

  sign after_start(const meeting& m) const {
    return f_.arithmetic().decide_offset(f_.offset(0, m.planes)) * m.closing == sign::positive ? sign::positive : sign::negative;
  }

  // cross_at from what is remembered; nothing where that leaves it open.
  std::optional<sign> known_cross(int grade, const support& q, const support& r) const requires(remembers) {
    if (grade > 2) return std::nullopt;
    memory_.make_room();
    const auto& a = memory_.recall(f_, sorted(q));
    const auto& b = memory_.recall(f_, sorted(r));
    // Less than four normals have one linear dependency at most, so equal supports mean
    // proportional lambdas.
    if (grade < 2 && a.support == b.support && a.support.front() < 0) return sign::zero;
    if (grade == 0) {
      const double later = (a.time - b.time) + (a.rest - b.rest);
      if (std::abs(later) * (1 - 0x1p-50) > a.radius + b.radius) return parity(q) * parity(r) * sign_of(later) * sign_of(a.speed) * sign_of(b.speed);
      const integer difference = a.offset * b.speed - b.offset * a.speed;
      if (abs(difference) > abs(a.offset) * b.error + abs(b.offset) * a.error) return parity(q) * parity(r) * sign_of(difference);
    }
    if (grade == 2) {
      const tilted_forms& c = memory_.tilted(f_, a, sorted(q));
      const tilted_forms& d = memory_.tilted(f_, b, sorted(r));
      const integer difference = c.offset * b.speed - d.offset * a.speed + a.offset * d.speed - b.offset * c.speed;
      const integer error = abs(c.offset) * b.error + abs(d.offset) * a.error + abs(a.offset) * d.error + abs(b.offset) * c.error;
      if (abs(difference) > error) return parity(q) * parity(r) * sign_of(difference);
    }
    return std::nullopt;
  }

  struct nothing {};
  template <class A>
  struct memory_of {
    using type = nothing;
  };
  template <rough_arithmetic A>
  struct memory_of<A> {
    using type = meeting_memory<A>;
  };

  formulas<Arithmetic> f_;
  [[no_unique_address]] mutable typename memory_of<Arithmetic>::type memory_;
};

}  // namespace osteon
