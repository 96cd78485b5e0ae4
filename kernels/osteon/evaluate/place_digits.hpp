// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Places and times of nodes with as many decimal digits as are asked for, rounded correctly. A
/// time is D / S and a coordinate is a quotient of two sums over the planes, all of them linear
/// forms in square roots, whose signs are decided exactly (docs/theory/numbers-and-predicates.md).

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/planes.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/square_classes.hpp"

namespace osteon {

/// Returns x / 10^digits as text, x >= 0, with a minus sign in front where it is wanted and x is
/// not zero.
inline std::string decimal_text(const integer& x, int digits, bool negative) {
  std::string text = x.str();
  const auto after = static_cast<std::size_t>(digits);
  if (text.size() <= after) text.insert(0, after + 1 - text.size(), '0');
  if (after > 0) text.insert(text.size() - after, 1, '.');
  return negative && x != 0 ? "-" + text : text;
}

/// Returns a rational with `digits` digits after the point, rounded to nearest, halves away from
/// zero.
inline std::string decimal_digits(const rational& x, int digits) {
  const integer above = 2 * abs(integer(numerator(x))) * pow(integer(10), static_cast<unsigned>(digits));
  return decimal_text((above / denominator(x) + 1) / 2, digits, x < 0);
}

/// A number p / q, both linear forms: rational + sum of root[i] times the speed of plane i.
template <int Dimension>
struct root_quotient {
  /// A linear form in the speeds of a meeting's planes.
  struct form {
    integer rational = 0;
    std::array<integer, Dimension + 1> root{};  ///< coefficients of the speeds

    friend form operator+(form a, const form& b) {
      a.rational += b.rational;
      for (std::size_t r = 0; r < a.root.size(); ++r) a.root[r] += b.root[r];
      return a;
    }
    friend form operator*(const integer& x, form a) {
      a.rational *= x;
      for (auto& c : a.root) c *= x;
      return a;
    }
  };
  form numerator;
  form denominator;
};

/// The place and time where Dimension + 1 planes meet, as quotients of forms, and their decimal
/// digits. Coordinates and time are in the units of the planes' integers; `digits_of` takes them to
/// those of the input.
template <int Dimension>
class place_digits {
 public:
  using quotient = root_quotient<Dimension>;
  using form = typename quotient::form;
  using meeting = meeting_planes<Dimension>;

  /// *Requires* planes that stay where they are while this is used.
  place_digits(std::span<const moving_plane<integer, Dimension>> planes, const meeting& q) : planes_(planes), planes_of_(q) {
    for (const plane_id p : q) roots_.add(inner_product(at(p).n, at(p).n), at(p).weight);
    one_ = roots_.add(1);
    for (int r = 0; r <= Dimension; ++r) {
      const integer lambda = minor(r);
      offset_.rational += lambda * at(q[r]).d;
      speed_.root[r] = lambda;
      if (lambda != 0 && (best_ < 0 || abs(lambda) > abs(speed_.root[best_]))) best_ = r;
    }
    exists_ = best_ >= 0 && sign_of(speed_) != sign::zero;
  }

  /// Returns whether the planes meet in one point at one moment.
  bool exists() const { return exists_; }
  /// Returns the time. *Requires* exists().
  quotient time() const { return {offset_, speed_}; }
  /// Returns a coordinate. *Requires* exists().
  quotient coordinate(int axis) const {
    // Cramer's rule for the other planes at t = D / S: sum (d_i S - D sigma_i) cofactor_i / (det
    // S).
    form sum;
    for (int r = 0; r <= Dimension; ++r) {
      if (r == best_) continue;
      const integer c = cofactor(r, axis);
      sum = sum + (c * at(planes_of_[r]).d) * speed_;
      sum.root[r] -= c * offset_.rational;
    }
    return {sum, determinant() * speed_};
  }

  /// Returns (x + shift) * scale with `digits` digits after the point, rounded to nearest, halves
  /// away from zero. *Requires* scale > 0.
  std::string digits_of(const quotient& x, const integer& shift, const rational& scale, int digits) const {
    const form p = integer(numerator_of(scale)) * (x.numerator + shift * x.denominator);
    const form q = integer(denominator_of(scale)) * x.denominator;
    const sign s = sign_of(p) * sign_of(q);
    if (s == sign::zero) return decimal_text(0, digits, false);
    const integer power = pow(integer(10), static_cast<unsigned>(digits));
    const form twice = (2 * power) * absolute(p);
    const form below = absolute(q);
    return decimal_text(rounded_half(twice, below), digits, s == sign::negative);
  }

 private:
  struct term {
    int plane;
    integer coefficient;
  };

  const moving_plane<integer, Dimension>& at(plane_id p) const { return planes_[static_cast<std::size_t>(p)]; }
  const integer& n(int r, int axis) const { return at(planes_of_[r]).n[axis]; }
  static integer numerator_of(const rational& x) { return numerator(x); }
  static integer denominator_of(const rational& x) { return denominator(x); }

  // Signed minors: sum over r of lambda_r n_r is zero.
  integer minor(int omitted) const {
    std::array<int, Dimension> r{};
    for (int i = 0, k = 0; i <= Dimension; ++i)
      if (i != omitted) r[k++] = i;
    const integer det = det_of(r);
    return (omitted + Dimension) % 2 == 0 ? det : integer(-det);
  }
  integer det_of(const std::array<int, Dimension>& r) const {
    if constexpr (Dimension == 2) {
      return n(r[0], 0) * n(r[1], 1) - n(r[0], 1) * n(r[1], 0);
    } else {
      integer sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        sum += n(r[0], axis) * (n(r[1], u) * n(r[2], v) - n(r[1], v) * n(r[2], u));
      }
      return sum;
    }
  }
  // Of the planes other than number best_, in ascending order.
  std::array<int, Dimension> corner() const {
    std::array<int, Dimension> r{};
    for (int i = 0, k = 0; i <= Dimension; ++i)
      if (i != best_) r[k++] = i;
    return r;
  }
  integer determinant() const { return det_of(corner()); }
  integer cofactor(int of, int axis) const {
    const auto r = corner();
    if constexpr (Dimension == 2) {
      const int other = r[0] == of ? r[1] : r[0];
      const integer c = n(other, 1 - axis);
      return (r[0] == of) == (axis == 0) ? c : integer(-c);
    } else {
      const int i = r[0] == of ? 0 : (r[1] == of ? 1 : 2);
      const int a = r[(i + 1) % 3];
      const int b = r[(i + 2) % 3];
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      return n(a, u) * n(b, v) - n(a, v) * n(b, u);
    }
  }

  sign sign_of(const form& f) const {
    std::vector<term> terms;
    if (f.rational != 0) terms.push_back({one_, f.rational});
    for (int r = 0; r <= Dimension; ++r)
      if (f.root[r] != 0 && at(planes_of_[r]).weight != 0) terms.push_back({r, f.root[r]});
    return roots_.sign_of_form(terms, static_cast<int>(terms.size()));
  }
  form absolute(const form& f) const { return sign_of(f) == sign::negative ? integer(-1) * f : f; }

  // f * 2^precision: a value and its greatest error.
  std::pair<integer, integer> scaled(const form& f, unsigned precision) const {
    std::pair<integer, integer> sum = {f.rational << precision, 0};
    for (int r = 0; r <= Dimension; ++r) {
      sum.first += f.root[r] * roots_.scaled(r, precision);
      sum.second += abs(f.root[r]);
    }
    return sum;
  }

  // floor((p / q + 1) / 2) for positive p and q: p / q is known better and better until at most one
  // odd number may lie below or above it, and that is compared exactly.
  integer rounded_half(const form& p, const form& q) const {
    for (unsigned precision = 128;; precision *= 2) {
      const auto [a, a_error] = scaled(p, precision);
      const auto [b, b_error] = scaled(q, precision);
      if (b <= b_error) continue;
      // rounded down
      const integer least = (a > a_error ? integer(a - a_error) : integer(0)) / (b + b_error);
      const integer most = (a + a_error) / (b - b_error);
      if (most - least > 1) continue;
      const integer odd = most % 2 == 0 ? integer(most - 1) : most;
      if (odd <= least) return (least + 1) / 2;
      return sign_of(p + integer(-odd) * q) == sign::negative ? integer((odd - 1) / 2) : integer((odd + 1) / 2);
    }
  }

  std::span<const moving_plane<integer, Dimension>> planes_;
  meeting planes_of_;
  square_classes roots_;
  int one_ = 0;
  form offset_;  // D, which has no roots
  form speed_;   // S, which has nothing else
  int best_ = -1;
  bool exists_ = false;
};

}  // namespace osteon
