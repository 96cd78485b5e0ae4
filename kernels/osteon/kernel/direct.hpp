// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A kernel from the formulas and an arithmetic that always knows the sign: what the double, rational and square-root
/// kernels share.

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "osteon/error.hpp"
#include "osteon/kernel.hpp"
#include "osteon/kernel/forms.hpp"

namespace osteon {

/// The four planes of a meeting in ascending order; {-1,-1,-1,-1} is the start.
inline constexpr quadruple start_planes = {-1, -1, -1, -1};

inline quadruple ascending(quadruple q) {
  std::sort(q.begin(), q.end());
  return q;
}

/// The edge between two facets as the plane that it sweeps.
struct swept_plane {
  plane_id a, b;
};

/// Kernel over an `Arithmetic` (see forms.hpp) with, in addition, `is_exact`, decide_offset(D), which tells whether planes
/// meet at time zero, angle_order(a, b, c, d) and volume_order(tree, tree). Nothing is cached: a predicate costs its formula.
template <class Arithmetic>
class direct_kernel {
 public:
  static constexpr bool exact = Arithmetic::is_exact;

  struct meeting {
    quadruple planes;
    sign closing;
  };
  using bisector_type = swept_plane;

  explicit direct_kernel(Arithmetic a) : f_(std::move(a)) {}
  const Arithmetic& arithmetic() const { return f_.arithmetic(); }

  plane_id size() const { return f_.arithmetic().size(); }
  sign orientation(plane_id a, plane_id b, plane_id c) const { return f_.orientation_at(0, {a, b, c}); }
  bool transversal(plane_id a, plane_id b, plane_id c) const { return orientation(a, b, c) != sign::zero; }

  meeting meeting_of(const quadruple& q) const {
    const quadruple s = ascending(q);
    return {s, f_.closing_at(0, s)};
  }
  std::optional<meeting> meet(const quadruple& q) const {
    const meeting m = meeting_of(q);
    return m.closing == sign::zero ? std::nullopt : std::optional(m);
  }
  quadruple planes(const meeting& m) const { return m.planes; }
  sign closing(const meeting& m) const { return m.closing; }
  meeting start() const { return {start_planes, sign::positive}; }

  sign compare(const meeting& m, const meeting& n) const {
    if (m.planes == n.planes) return sign::zero;
    if (m.planes == start_planes) return -compare(n, m);
    if (n.planes == start_planes) return after_start(m);
    return f_.cross_at(0, m.planes, n.planes) * m.closing * n.closing;
  }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const {
    const quadruple q{a, b, c, d};
    const sign corner = orientation(a, b, c);
    return (m.planes == start_planes ? -f_.closing_at(0, q) : f_.cross_at(0, q, m.planes) * m.closing) * corner;
  }

  bisector_type bisector(plane_id a, plane_id b) const { return {a, b}; }
  sign compare(const bisector_type& e, const bisector_type& f) const { return f_.arithmetic().angle_order(e.a, e.b, f.a, f.b); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const { return f_.arithmetic().volume_order(s, t); }

  sign orientation_at(int grade, const triple& t) const { return f_.orientation_at(grade, t); }
  sign offset_at(int grade, const quadruple& q) const { return f_.offset_at(grade, q); }
  sign closing_at(int grade, const quadruple& q) const { return f_.closing_at(grade, q); }
  sign cross_at(int grade, const quadruple& q, const quadruple& r) const { return f_.cross_at(grade, q, r); }

 private:
  sign after_start(const meeting& m) const {
    return f_.arithmetic().decide_offset(f_.offset(0, m.planes)) * m.closing == sign::positive ? sign::positive : sign::negative;
  }

  formulas<Arithmetic> f_;
};

}  // namespace osteon
