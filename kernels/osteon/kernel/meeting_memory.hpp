// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What an exact kernel remembers of meetings: D exactly and S to 64 or 128 bits after the point.
/// That decides nearly all questions that a filter leaves open.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "osteon/core/planes.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// The coefficients of e^2 in D and S, S within `error`.
struct tilted_forms {
  integer offset;
  integer speed;
  integer error;
};

/// The point in which the planes of a meeting meet, and the time, in units of 2^-speed_bits (the
/// time in 2^-(2 speed_bits) of the speeds' unit). Each number is wrong by at most `radius`, which
/// is negative where nothing is known.
struct rough_point {
  std::array<integer, 3> x;
  integer time;
  integer radius;
};

/// What is remembered of a meeting: D, S within `error`, and D / S, which lies within `radius` of
/// time + rest. Two doubles, because solids that are almost symmetric have events at times that
/// differ in the fifteenth digit and later.
template <int Dimension>
struct known_meeting {
  meeting_planes<Dimension> support;  ///< ascending; -1 where lambda is zero
  integer offset;
  integer speed;
  integer error;
  mutable std::optional<tilted_forms> tilted;  ///< once asked for
  mutable std::optional<rough_point> where;    ///< once asked for
  double time = 0;
  double rest = 0;
  double radius = std::numeric_limits<double>::infinity();
};

/// An arithmetic that can bound S cheaply: rough_speed(lambda, q) gives a value and its greatest
/// error, in units of 2^-speed_bits; rough_speed(p) the speed of one plane, less than a unit too
/// small.
template <class Arithmetic>
concept rough_arithmetic = requires(const Arithmetic& a, const std::array<integer, Arithmetic::dimension + 1>& lambda,
                                    const meeting_planes<Arithmetic::dimension>& q) {
  { a.rough_speed(lambda, q) } -> std::same_as<std::pair<integer, integer>>;
  { a.rough_speed(q[0]) } -> std::convertible_to<integer>;
};

/// Meetings by their planes, which are always ascending here. At most 2^18 are kept.
template <rough_arithmetic Arithmetic>
class meeting_memory {
 public:
  static constexpr int dimension = Arithmetic::dimension;
  using support = meeting_planes<dimension>;
  using known = known_meeting<dimension>;

  /// Forgets everything where too much is kept. References that `recall` has returned end here
  /// only.
  void make_room() {
    constexpr std::size_t most = 1U << 18U;
    if (all_.size() > most) all_.clear();
  }

  /// Returns what is known of a meeting.
  const known& recall(const formulas<Arithmetic>& f, const support& q) {
    const auto [at, fresh] = all_.try_emplace(q);
    if (fresh) {
      const auto lambda = f.lambda(0, q);
      for (int r = 0; r <= dimension; ++r) {
        at->second.support[r] = lambda[r] == 0 ? -1 : q[r];
        at->second.offset += lambda[r] * f.arithmetic().d(q[r]);
      }
      std::sort(at->second.support.begin(), at->second.support.end());
      std::tie(at->second.speed, at->second.error) = f.arithmetic().rough_speed(lambda, q);
      set_time(at->second);
    }
    return at->second;
  }

  /// Returns D and S of grade 2.
  static const tilted_forms& tilted(const formulas<Arithmetic>& f, const known& m, const support& q) {
    if (!m.tilted) {
      const auto lambda = f.lambda(1, q);
      m.tilted.emplace();
      for (int r = 0; r <= dimension; ++r) m.tilted->offset += lambda[r] * f.arithmetic().d(q[r]);
      std::tie(m.tilted->speed, m.tilted->error) = f.arithmetic().rough_speed(lambda, q);
    }
    return *m.tilted;
  }

  /// Returns the point and time of a meeting in space.
  static const rough_point& point(const formulas<Arithmetic>& f, const known& m, const support& q) requires(dimension == 3) {
    if (!m.where) m.where = locate(f, m, q);
    return *m.where;
  }

 private:
  // The point is the solution for three of the planes, those with the greatest lambda: with t = D /
  // S,
  //     lambda S x = sum (d_i S - D sigma_i) n_j x n_k.
  static rough_point locate(const formulas<Arithmetic>& f, const known& m, const support& q) {
    const auto& a = f.arithmetic();
    const auto lambda = f.lambda(0, q);
    std::size_t omitted = 0;
    for (std::size_t r = 1; r < q.size(); ++r)
      if (abs(lambda[r]) > abs(lambda[omitted])) omitted = r;
    const triple t = omit(q, omitted);
    const integer det = f.minor(0, t);
    const integer below = (abs(m.speed) - m.error) * abs(det);
    rough_point at{{}, 0, -1};
    if (sign_of(below) != sign::positive) return at;
    constexpr auto bits = static_cast<unsigned>(Arithmetic::speed_bits);
    const integer size = abs(m.speed);
    // See estimate.hpp for the error of a quotient; the error of D is zero.
    at.time = (m.offset << (2 * bits)) / m.speed;
    at.radius = ((abs(m.offset) << (2 * bits)) / size * m.error) / (size - m.error) + 2;
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
        sum += (a.d(i) * m.speed - m.offset * a.rough_speed(i)) * normal;
        error += (abs(a.d(i)) * m.error + abs(m.offset)) * abs(normal);
      }
      at.x[axis] = (sum << bits) / (det * m.speed);
      const integer radius = ((error + abs(sum) * m.error / size + 1) << bits) / below + 2;
      if (radius > at.radius) at.radius = radius;
    }
    return at;
  }

  // D / S in two doubles: rounded at the 128th bit of a quotient of at least 128 bits, then at the
  // 106th.
  static void set_time(known& m) {
    const integer size = abs(m.speed);
    if (size >> 8U <= m.error) return;
    const int shift = std::max(0, 128 + bit_length(m.speed) - bit_length(m.offset));
    const integer quotient = (m.offset << static_cast<unsigned>(shift)) / m.speed;
    m.time = to_double(quotient, shift);
    if (std::abs(m.time) < 1e-200 || std::abs(m.time) > 1e200) return;
    m.rest = to_double(quotient - integer(std::ldexp(m.time, shift)), shift);
    // The error of the quotient (see estimate.hpp), relative; the error of D is zero.
    const double relative = to_double((m.error << 200U) / (size - m.error) + 1, 200);
    m.radius = std::abs(m.time) * (relative * (1 + 0x1p-40) + 0x1p-100);
  }

  std::unordered_map<support, known, plane_hash> all_;
};

}  // namespace osteon
