// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Floating-point numbers that know how wrong they may be, and the two bounds that all of the
/// library's filters and enclosures use.
///
/// *Sums of products.* Evaluate an expression of +, - and * with numbers that are rounded once in
/// each operation, to a relative error of at most u; let its scale be the same expression with
/// absolute values everywhere and + for -. The value is the sum of the expression's products, each
/// times factors 1 + e with |e| <= u, one for each rounding on the ways from its inputs to the
/// result. If no way from an input to the result meets more than k roundings, counting all inputs
/// of a product, then
///
///     |value - truth| <= ((1 + u)^k - 1) scale <= k u / (1 - k u) scale.
///
/// *Quotients.* For D' and S' within errors of D and S, where |S'| is greater than its error,
///
///     |D' / S' - D / S| = |D' - D - (D' / S') (S' - S)| / |S|
///                      <= (|D' - D| + |D' / S'| |S' - S|) / |S|.

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/kernel/to_double.hpp"

namespace osteon {

/// Returns a bound for the error of a quotient D' / S' (see above) apart from the rounding of the
/// quotient itself. `least` is positive and at most |S|, as is |S'| minus its error. The factor
/// covers the roundings of this function.
inline double quotient_error(double quotient, double offset_error, double speed_error, double least) {
  return (offset_error + std::abs(quotient) * speed_error) / least * (1 + 0x1p-40);
}

/// A rounded number: `value`, and `scale`, a sum of products of absolute values (see above). An
/// input counts for two roundings, since GMP truncates. `exact`: all inputs are integers
/// represented exactly; then the value is true while the scale stays below 2^53.
struct estimate {
  double value;
  double scale;
  bool exact;

  /// How many units of 2^-53 of its scale a number may be wrong by. The most roundings are met in
  /// formulas.hpp: a minor has 3 inputs (6), 2 products, 2 sums, and for higher grades 6 sums more
  /// (16); D and S multiply with an input and add 4 terms (23); a cross product multiplies two of
  /// them, merges up to 14 terms, multiplies with an input and adds 8 terms: 2 * 23 + 1 + 14 + 3 +
  /// 8 = 72. An offset from an anchor meets 6 more. 100 leaves room for the rounding of the scale
  /// itself and of the bound.
  static constexpr double bound = 100 * 0x1p-53;

  /// Returns a bound for |value - truth|.
  double error() const { return bound * scale; }

  estimate() = default;
  estimate(double v, double s, bool e) : value(v), scale(s), exact(e) {}
  explicit estimate(int x) : value(x), scale(std::abs(x)), exact(true) {}
  /// Returns an input. Nothing is certain of expressions in inputs that are not `fit` (see
  /// rounded_plane).
  static estimate input(double x, bool exact, bool fit = true) { return {x, fit ? std::abs(x) : std::numeric_limits<double>::infinity(), exact}; }
  /// Returns a number that was rounded once from its exact value; zero is zero.
  static estimate rounded(double x) { return {x, std::abs(x), x == 0}; }

  /// Returns whether at least twenty bits are right, or all.
  bool precise() const { return (exact && scale < 0x1p53) || std::abs(value) > 0x1p20 * error(); }

  friend estimate operator+(const estimate& a, const estimate& b) { return {a.value + b.value, a.scale + b.scale, a.exact && b.exact}; }
  friend estimate operator-(const estimate& a, const estimate& b) { return {a.value - b.value, a.scale + b.scale, a.exact && b.exact}; }
  friend estimate operator*(const estimate& a, const estimate& b) { return {a.value * b.value, a.scale * b.scale, a.exact && b.exact}; }
  friend estimate operator-(const estimate& a) { return {-a.value, a.scale, a.exact}; }

  /// Returns the sign of the true number, or nothing where it is not certain. Outside of a safe
  /// range of exponents nothing is certain.
  std::optional<sign> certain_sign() const {
    if (exact && scale < 0x1p53) return sign_of(value);
    if (scale < 1e290 && scale > 1e-250 && std::abs(value) > error()) return sign_of(value);
    return std::nullopt;
  }
};

/// The numbers of planes and of their perturbations as estimates, as `formulas` wants them.
template <int Dimension>
class estimated_planes {
 public:
  static constexpr int dimension = Dimension;
  using number = estimate;

  /// Rounds planes; `anchors`: see round_planes.
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
  /// Returns a plane as rounded.
  const rounded_plane<Dimension>& plane(plane_id i) const { return planes_[i]; }
  /// Returns whether no plane had to be scaled to fit into doubles.
  bool unscaled() const { return unscaled_; }
  /// Returns a coordinate of a plane's normal.
  estimate n(plane_id i, int axis) const { return estimate::input(planes_[i].n[axis], planes_[i].exact, planes_[i].fit); }
  /// Returns a plane's offset.
  estimate d(plane_id i) const { return estimate::input(planes_[i].d, planes_[i].exact, planes_[i].fit); }
  /// Returns d for the anchor of another plane as the origin. Where all planes of a meeting have
  /// the same origin, D is the same as ever.
  estimate d_from(plane_id i, plane_id origin) const {
    const auto& p = planes_[i];
    estimate sum = estimate::input(p.rest, p.exact, p.fit);
    if (i == origin) return sum;
    for (int axis = 0; axis < Dimension; ++axis) sum = sum + n(i, axis) * estimate::input(p.anchor[axis] - planes_[origin].anchor[axis], true);
    return sum;
  }
  /// Returns a coordinate of a plane's tilt (see perturbation).
  estimate u(plane_id i, int axis) const { return tilts_[i][axis]; }
  /// Returns the perturbation of a plane's offset.
  estimate delta(plane_id i) const {
    const auto& p = planes_[i];
    return estimate::input(p.unscaled() ? p.delta : std::ldexp(p.delta, -p.shift - p.offset_shift), p.exact, p.tilt_fit());
  }
  /// Returns a plane's speed sigma.
  estimate speed(plane_id i) const { return estimate::input(planes_[i].speed, planes_[i].exact, planes_[i].fit); }

  /// Returns the value of a form in the speeds.
  estimate value(const linear_form<estimate>& f) const {
    estimate sum(0);
    for (int t = 0; t < f.size; ++t) sum = sum + f.terms[t].coefficient * speed(f.terms[t].plane);
    return sum;
  }

 private:
  std::vector<rounded_plane<Dimension>> planes_;
  std::vector<std::array<estimate, Dimension>> tilts_;  // apart, because rarely needed
  bool unscaled_ = true;
};

}  // namespace osteon
