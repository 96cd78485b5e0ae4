// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A kernel from the formulas and an arithmetic that always knows the sign: what the double, rational and square-root
/// kernels share.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "osteon/error.hpp"
#include "osteon/kernel.hpp"
#include "osteon/kernel/forms.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

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

/// What an exact kernel remembers of four planes (ascending): D, S within `error`, and D / S, which lies within `radius` of
/// time + rest. Solids that are almost symmetric have events at times that differ in the fifteenth digit and later.
struct remembered_planes {
  quadruple support;  ///< the planes whose lambda is not zero; -1 for the others
  integer offset;
  integer speed;
  integer error;
  double time = 0;
  double rest = 0;
  double radius = std::numeric_limits<double>::infinity();
};

/// An arithmetic that can bound S cheaply: rough_speed(lambda, q) gives a value and its greatest error, in some unit of time.
template <class Arithmetic>
concept rough_arithmetic = requires(const Arithmetic& a, const std::array<integer, 4>& lambda, const quadruple& q) {
  { a.rough_speed(lambda, q) } -> std::same_as<std::pair<integer, integer>>;
};

/// Sign of the permutation that sorts four different planes.
inline sign parity(const quadruple& q) {
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += q[i] > q[j] ? 1 : 0;
  return inversions % 2 == 0 ? sign::positive : sign::negative;
}

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
    return {s, closing_at(0, s)};
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
    return cross_at(0, m.planes, n.planes) * m.closing * n.closing;
  }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const {
    const quadruple q{a, b, c, d};
    const sign corner = orientation(a, b, c);
    return (m.planes == start_planes ? -closing_at(0, q) : cross_at(0, q, m.planes) * m.closing) * corner;
  }

  bisector_type bisector(plane_id a, plane_id b) const { return {a, b}; }
  sign compare(const bisector_type& e, const bisector_type& f) const { return f_.arithmetic().angle_order(e.a, e.b, f.a, f.b); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const { return f_.arithmetic().volume_order(s, t); }

  sign orientation_at(int grade, const triple& t) const { return f_.orientation_at(grade, t); }
  sign offset_at(int grade, const quadruple& q) const { return f_.offset_at(grade, q); }
  sign closing_at(int grade, const quadruple& q) const {
    if constexpr (rough_arithmetic<Arithmetic>)
      if (grade == 0) {
        const remembered_planes& known = recall(ascending(q));
        if (abs(known.speed) > known.error) return parity(q) * sign_of(known.speed);
      }
    return f_.closing_at(grade, q);
  }
  sign cross_at(int grade, const quadruple& q, const quadruple& r) const {
    if constexpr (rough_arithmetic<Arithmetic>)
      if (grade <= 1) {
        if (memory_.size() > most_remembered) memory_.clear();  // only here, so that both references below live
        const remembered_planes& a = recall(ascending(q));
        const remembered_planes& b = recall(ascending(r));
        // Less than four normals have one linear dependency at most, so equal supports mean proportional lambdas.
        if (a.support == b.support && std::find(a.support.begin(), a.support.end(), -1) != a.support.end()) return sign::zero;
        if (grade == 0) {
          const double later = (a.time - b.time) + (a.rest - b.rest);
          if (std::abs(later) * (1 - 0x1p-50) > a.radius + b.radius)
            return parity(q) * parity(r) * sign_of(later) * sign_of(a.speed) * sign_of(b.speed);
          const integer difference = a.offset * b.speed - b.offset * a.speed;
          if (abs(difference) > abs(a.offset) * b.error + abs(b.offset) * a.error) return parity(q) * parity(r) * sign_of(difference);
        }
      }
    return f_.cross_at(grade, q, r);
  }

  /// D and S of four planes in this order, S without the bits lost by its rounding; nothing where those could matter.
  std::optional<std::pair<integer, integer>> refined(const quadruple& q) const requires rough_arithmetic<Arithmetic> {
    if (memory_.size() > most_remembered) memory_.clear();
    const remembered_planes& known = recall(ascending(q));
    if (abs(known.speed) >> 60U <= known.error && known.error != 0) return std::nullopt;
    if (parity(q) == sign::positive) return std::pair(known.offset, known.speed);
    return std::pair(integer(-known.offset), integer(-known.speed));
  }
  /// The unit of refined speeds is 2^-speed_bits.
  static constexpr int speed_bits = Arithmetic::speed_bits;

 private:
  sign after_start(const meeting& m) const {
    return f_.arithmetic().decide_offset(f_.offset(0, m.planes)) * m.closing == sign::positive ? sign::positive : sign::negative;
  }

  static constexpr std::size_t most_remembered = 1U << 18U;

  const remembered_planes& recall(const quadruple& q) const {
    const auto [at, fresh] = memory_.try_emplace(q);
    if (fresh) {
      const auto lambda = f_.lambda(0, q);
      for (int r = 0; r < 4; ++r) {
        at->second.support[r] = lambda[r] == 0 ? -1 : q[r];
        at->second.offset += lambda[r] * f_.arithmetic().d(q[r]);
      }
      std::sort(at->second.support.begin(), at->second.support.end());
      std::tie(at->second.speed, at->second.error) = f_.arithmetic().rough_speed(lambda, q);
      set_time(at->second);
    }
    return at->second;
  }

  // D / S in two doubles: rounded at the 128th bit of a quotient of at least 128 bits, then at the 106th.
  static void set_time(remembered_planes& p) {
    const integer size = abs(p.speed);
    if (size >> 8U <= p.error) return;
    const int shift = std::max(0, 128 + bit_length(p.speed) - bit_length(p.offset));
    const integer quotient = (p.offset << static_cast<unsigned>(shift)) / p.speed;
    p.time = to_double(quotient, shift);
    if (std::abs(p.time) < 1e-200 || std::abs(p.time) > 1e200) return;
    p.rest = to_double(quotient - integer(std::ldexp(p.time, shift)), shift);
    // |D / S' - D / S| <= |D / S'| error / (|S'| - error)
    const double relative = to_double((p.error << 200U) / (size - p.error) + 1, 200);
    p.radius = std::abs(p.time) * (relative * (1 + 0x1p-40) + 0x1p-100);
  }

  formulas<Arithmetic> f_;
  mutable std::unordered_map<quadruple, remembered_planes, plane_hash> memory_;
};

}  // namespace osteon
