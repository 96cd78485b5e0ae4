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

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// What stands for the planes of the start.
template <int Dimension>
inline constexpr meeting_planes<Dimension> start_planes_in = [] {
  meeting_planes<Dimension> none{};
  for (plane_id& p : none) p = -1;
  return none;
}();

/// The planes of a meeting in their usual order.
template <std::size_t N>
std::array<plane_id, N> ascending(std::array<plane_id, N> q) {
  std::sort(q.begin(), q.end());
  return q;
}

/// The edge between two facets as the plane that it sweeps.
struct swept_plane {
  plane_id a, b;
};

/// The coefficients of e^2 in D and S, S within `error`.
struct tilted_planes {
  integer offset;
  integer speed;
  integer error;
};

/// The point where four planes meet, and the time, in units of 2^-128; each is wrong by at most `radius`, negative where nothing is known.
struct rough_point {
  std::array<integer, 3> x;
  integer time;
  integer radius;
};

/// What an exact kernel remembers of the planes of a meeting (ascending): D, S within `error`, and D / S, which lies within `radius` of
/// time + rest. Solids that are almost symmetric have events at times that differ in the fifteenth digit and later.
template <int Dimension>
struct remembered_planes {
  meeting_planes<Dimension> support;  ///< the planes whose lambda is not zero; -1 for the others
  integer offset;
  integer speed;
  integer error;
  mutable std::optional<tilted_planes> tilted;  ///< once asked for
  mutable std::optional<rough_point> where;     ///< once asked for
  double time = 0;
  double rest = 0;
  double radius = std::numeric_limits<double>::infinity();
};

/// An arithmetic that can bound S cheaply: rough_speed(lambda, q) gives a value and its greatest error, in units of
/// 2^-speed_bits; rough_speed(p) that of one plane, less than a unit too small.
template <class Arithmetic>
concept rough_arithmetic = requires(const Arithmetic& a, const std::array<integer, Arithmetic::dimension + 1>& lambda,
                                    const meeting_planes<Arithmetic::dimension>& q) {
  { a.rough_speed(lambda, q) } -> std::same_as<std::pair<integer, integer>>;
  { a.rough_speed(q[0]) } -> std::convertible_to<integer>;
};

/// Sign of the permutation that sorts different planes.
template <std::size_t N>
sign parity(std::array<plane_id, N> q) {
  return sort_with_parity(q);
}

/// Kernel of space or of the plane over an `Arithmetic` (see forms.hpp) with, in addition, `is_exact`, decide_offset(D), which tells whether planes
/// meet at time zero, angle_order(a, b, c, d) and volume_order(tree, tree). Nothing is cached: a predicate costs its formula.
template <class Arithmetic>
class arithmetic_kernel {
 public:
  static constexpr bool exact = Arithmetic::is_exact;
  static constexpr int dimension = Arithmetic::dimension;
  using corner = corner_planes<dimension>;
  using support = meeting_planes<dimension>;

  struct meeting {
    support planes;
    sign closing;
  };
  using bisector_type = swept_plane;

  explicit arithmetic_kernel(Arithmetic a) : f_(std::move(a)) {}
  const Arithmetic& arithmetic() const { return f_.arithmetic(); }

  plane_id size() const { return f_.arithmetic().size(); }
  bool has_unit_speeds() const requires requires(const Arithmetic& a) { a.has_unit_speeds(); }
  { return f_.arithmetic().has_unit_speeds(); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) sign orientation(Planes... of)
  const { return f_.orientation_at(0, {of...}); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == dimension) bool transversal(Planes... of) const { return orientation(of...) != sign::zero; }

  meeting meeting_of(const support& q) const {
    const support s = ascending(q);
    return {s, closing_at(0, s)};
  }
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

  sign orientation_at(int grade, const corner& c) const { return f_.orientation_at(grade, c); }
  sign offset_at(int grade, const support& q) const { return f_.offset_at(grade, q); }
  sign closing_at(int grade, const support& q) const {
    if constexpr (rough_arithmetic<Arithmetic>)
      if (grade == 0) {
        const remembered_planes<dimension>& known = recall(ascending(q));
        if (abs(known.speed) > known.error) return parity(q) * sign_of(known.speed);
      }
    return f_.closing_at(grade, q);
  }
  sign cross_at(int grade, const support& q, const support& r) const {
    if constexpr (rough_arithmetic<Arithmetic>)
      if (grade <= 2) {
        if (memory_.size() > most_remembered) memory_.clear();  // only here, so that both references below live
        const remembered_planes<dimension>& a = recall(ascending(q));
        const remembered_planes<dimension>& b = recall(ascending(r));
        // Less than four normals have one linear dependency at most, so equal supports mean proportional lambdas.
        if (grade < 2 && a.support == b.support && std::find(a.support.begin(), a.support.end(), -1) != a.support.end()) return sign::zero;
        if (grade == 0) {
          const double later = (a.time - b.time) + (a.rest - b.rest);
          if (std::abs(later) * (1 - 0x1p-50) > a.radius + b.radius)
            return parity(q) * parity(r) * sign_of(later) * sign_of(a.speed) * sign_of(b.speed);
          const integer difference = a.offset * b.speed - b.offset * a.speed;
          if (abs(difference) > abs(a.offset) * b.error + abs(b.offset) * a.error) return parity(q) * parity(r) * sign_of(difference);
        }
        if (grade == 2) {
          const tilted_planes& c = recall_tilted(a, ascending(q));
          const tilted_planes& d = recall_tilted(b, ascending(r));
          const integer difference = c.offset * b.speed - d.offset * a.speed + a.offset * d.speed - b.offset * c.speed;
          const integer error = abs(c.offset) * b.error + abs(d.offset) * a.error + abs(a.offset) * d.error + abs(b.offset) * c.error;
          if (abs(difference) > error) return parity(q) * parity(r) * sign_of(difference);
        }
      }
    return f_.cross_at(grade, q, r);
  }

  /// D and S of four planes in this order, S without the bits lost by its rounding; nothing where those could matter.
  std::optional<std::pair<integer, integer>> refined(const support& q) const requires rough_arithmetic<Arithmetic> {
    if (memory_.size() > most_remembered) memory_.clear();
    const remembered_planes<dimension>& known = recall(ascending(q));
    if (abs(known.speed) >> 60U <= known.error && known.error != 0) return std::nullopt;
    if (parity(q) == sign::positive) return std::pair(known.offset, known.speed);
    return std::pair(integer(-known.offset), integer(-known.speed));
  }
  /// Sign of h_d at the point where the planes of q (ascending) meet; zero where that is not certain.
  sign rough_side(plane_id d, const quadruple& q) const requires(dimension == 3 && rough_arithmetic<Arithmetic>) {
    const auto& a = f_.arithmetic();
    const remembered_planes<dimension>& known = recall(q);
    if (!known.where) known.where = locate(q, known);
    const rough_point& at = *known.where;
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

  /// The unit of refined speeds is 2^-speed_bits.
  static constexpr int speed_bits = Arithmetic::speed_bits;

 private:
  static constexpr support start_planes = start_planes_in<dimension>;

  // The corner of all planes but the last against the last.
  sign side_of(const support& q, const meeting& m) const {
    corner c{};
    std::copy_n(q.begin(), dimension, c.begin());
    return (m.planes == start_planes ? -closing_at(0, q) : cross_at(0, q, m.planes) * m.closing) * f_.orientation_at(0, c);
  }

  sign after_start(const meeting& m) const {
    return f_.arithmetic().decide_offset(f_.offset(0, m.planes)) * m.closing == sign::positive ? sign::positive : sign::negative;
  }

  static constexpr std::size_t most_remembered = 1U << 18U;

  const remembered_planes<dimension>& recall(const support& q) const {
    const auto [at, fresh] = memory_.try_emplace(q);
    if (fresh) {
      const auto lambda = f_.lambda(0, q);
      for (int r = 0; r <= dimension; ++r) {
        at->second.support[r] = lambda[r] == 0 ? -1 : q[r];
        at->second.offset += lambda[r] * f_.arithmetic().d(q[r]);
      }
      std::sort(at->second.support.begin(), at->second.support.end());
      std::tie(at->second.speed, at->second.error) = f_.arithmetic().rough_speed(lambda, q);
      set_time(at->second);
    }
    return at->second;
  }

  const tilted_planes& recall_tilted(const remembered_planes<dimension>& p, const support& q) const {
    if (!p.tilted) {
      const auto lambda = f_.lambda(1, q);
      p.tilted.emplace();
      for (int r = 0; r <= dimension; ++r) p.tilted->offset += lambda[r] * f_.arithmetic().d(q[r]);
      std::tie(p.tilted->speed, p.tilted->error) = f_.arithmetic().rough_speed(lambda, q);
    }
    return *p.tilted;
  }

  // The point is the solution for three of the planes, those with the greatest lambda: with t = D / S,
  //     lambda S x = sum (d_i S - D sigma_i) n_j x n_k.
  rough_point locate(const quadruple& q, const remembered_planes<3>& known) const {
    const auto& a = f_.arithmetic();
    const auto lambda = f_.lambda(0, q);
    int omitted = 0;
    for (int r = 1; r < 4; ++r)
      if (abs(lambda[r]) > abs(lambda[omitted])) omitted = r;
    triple t{};
    std::remove_copy(q.begin(), q.end(), t.begin(), q[omitted]);
    const integer det = f_.minor(0, t);
    const integer below = (abs(known.speed) - known.error) * abs(det);
    rough_point at{{}, 0, -1};
    if (sign_of(below) != sign::positive) return at;
    constexpr auto bits = static_cast<unsigned>(speed_bits);
    const integer size = abs(known.speed);
    // |D / S' - D / S| = |D| |S' - S| / |S S'|
    at.time = (known.offset << (2 * bits)) / known.speed;
    at.radius = ((abs(known.offset) << (2 * bits)) / size * known.error) / (size - known.error) + 2;
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      integer sum = 0;
      integer error = 0;
      for (int r = 0; r < 3; ++r) {
        const plane_id i = t[r];
        const plane_id j = t[(r + 1) % 3];
        const plane_id k = t[(r + 2) % 3];
        const integer normal = a.n(j, u) * a.n(k, v) - a.n(j, v) * a.n(k, u);
        sum += (a.d(i) * known.speed - known.offset * a.rough_speed(i)) * normal;
        error += (abs(a.d(i)) * known.error + abs(known.offset)) * abs(normal);
      }
      at.x[axis] = (sum << bits) / (det * known.speed);
      const integer radius = ((error + abs(sum) * known.error / size + 1) << bits) / below + 2;
      if (radius > at.radius) at.radius = radius;
    }
    return at;
  }

  // D / S in two doubles: rounded at the 128th bit of a quotient of at least 128 bits, then at the 106th.
  static void set_time(remembered_planes<dimension>& p) {
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
  mutable std::unordered_map<support, remembered_planes<dimension>, plane_hash> memory_;
};

}  // namespace osteon
