// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Floating-point numbers that know how wrong they may be.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// A rounded number: `value`, and `scale`, the same expression evaluated on absolute values. Every operation is rounded once,
/// so after an expression in which each path from input to result meets at most k roundings (an input itself counts
/// for two, it may be truncated) |value - true| <= k' u scale with u = 2^-53 and k' slightly above k.
/// `exact`: all inputs were integers represented exactly; then the value is true while scale stays below 2^53.
struct estimate {
  double value;
  double scale;
  bool exact;

  // The longest path in formulas.hpp: a minor has 3 inputs (6), 2 products, 2 sums, and for higher grades 6 sums more
  // (16); D and S multiply with an input and add 4 terms (23); a cross product multiplies two of them, merges up to
  // 14 terms, multiplies with an input and adds 8 terms: 2 * 23 + 1 + 14 + 3 + 8 = 72. An offset from an anchor meets 6
  // more. 100 leaves room for the rounding of scale itself and of the bound.
  static constexpr double bound = 100 * 0x1p-53;

  double error() const { return bound * scale; }

  estimate() = default;
  estimate(double v, double s, bool e) : value(v), scale(s), exact(e) {}
  explicit estimate(int x) : value(x), scale(std::abs(x)), exact(true) {}
  /// Nothing is certain of expressions in inputs that are not `fit`.
  static estimate input(double x, bool exact, bool fit = true) { return {x, fit ? std::abs(x) : std::numeric_limits<double>::infinity(), exact}; }

  /// Whether at least twenty bits are right, or all.
  bool precise() const { return (exact && scale < 0x1p53) || std::abs(value) > 0x1p20 * error(); }

  /// A number that was rounded from its exact value; zero is zero.
  static estimate rounded(double x) { return {x, std::abs(x), x == 0}; }

  friend estimate operator+(const estimate& a, const estimate& b) { return {a.value + b.value, a.scale + b.scale, a.exact && b.exact}; }
  friend estimate operator-(const estimate& a, const estimate& b) { return {a.value - b.value, a.scale + b.scale, a.exact && b.exact}; }
  friend estimate operator*(const estimate& a, const estimate& b) { return {a.value * b.value, a.scale * b.scale, a.exact && b.exact}; }
  friend estimate operator-(const estimate& a) { return {-a.value, a.scale, a.exact}; }

  /// The sign of the true number, or nothing. Outside a safe range of exponents nothing is certain.
  std::optional<sign> certain_sign() const {
    if (exact && scale < 0x1p53) return sign_of(value);
    if (scale < 1e290 && scale > 1e-250 && std::abs(value) > error()) return sign_of(value);
    return std::nullopt;
  }
};

/// Planes as estimates.
template <int Dimension>
class estimated_planes {
 public:
  static constexpr int dimension = Dimension;
  using number = estimate;

  explicit estimated_planes(std::span<const moving_plane<integer, Dimension>> planes, std::span<const std::array<double, Dimension>> anchors = {})
      : planes_(round_planes<Dimension>(planes, anchors)) {
    tilts_.resize(planes_.size());
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const auto tilt = perturbation::of(static_cast<plane_id>(i)).u;
      for (int axis = 0; axis < Dimension; ++axis)
        tilts_[i][axis] = estimate::input(std::ldexp(tilt[axis], -planes_[i].shift), planes_[i].exact, planes_[i].tilt_fit());
      unscaled_ = unscaled_ && planes_[i].unscaled();
    }
  }

  plane_id size() const { return static_cast<plane_id>(planes_.size()); }
  const rounded_plane<Dimension>& plane(plane_id i) const { return planes_[i]; }
  /// Whether no plane had to be scaled to fit into doubles.
  bool unscaled() const { return unscaled_; }
  estimate n(plane_id i, int axis) const { return estimate::input(planes_[i].n[axis], planes_[i].exact, planes_[i].fit); }
  estimate d(plane_id i) const { return estimate::input(planes_[i].d, planes_[i].exact, planes_[i].fit); }
  /// d where the anchor of another plane is the origin.
  estimate d_from(plane_id i, plane_id origin) const {
    const auto& p = planes_[i];
    estimate sum = estimate::input(p.rest, p.exact, p.fit);
    if (i == origin) return sum;
    for (int axis = 0; axis < Dimension; ++axis) sum = sum + n(i, axis) * estimate::input(p.anchor[axis] - planes_[origin].anchor[axis], true);
    return sum;
  }
  estimate u(plane_id i, int axis) const { return tilts_[i][axis]; }
  estimate delta(plane_id i) const {
    const auto& p = planes_[i];
    return estimate::input(p.unscaled() ? p.delta : std::ldexp(p.delta, -p.shift - p.offset_shift), p.exact, p.tilt_fit());
  }
  estimate speed(plane_id i) const { return estimate::input(planes_[i].speed, planes_[i].exact, planes_[i].fit); }

  estimate value(const linear_form<estimate>& f) const {
    estimate sum(0);
    for (int t = 0; t < f.size; ++t) sum = sum + f.terms[t].coefficient * speed(f.terms[t].plane);
    return sum;
  }

 private:
  std::vector<rounded_plane<Dimension>> planes_;
  std::vector<std::array<estimate, Dimension>> tilts_;  // apart from the rest, because they are rarely needed
  bool unscaled_ = true;
};

}  // namespace osteon
