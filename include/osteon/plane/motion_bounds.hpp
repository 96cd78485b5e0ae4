// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Bounds on the motion of a wavefront: an optional policy that spares a kernel most
/// questions and decides nothing.

#include <concepts>
#include <limits>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// Where lines meet and vertices move, as enclosures: intervals and boxes that surely contain the
/// true values. Coordinates and times are in units of the policy's own, which need not be the
/// kernel's.
template <class M>
concept motion_bounds = requires(const M& m, const triple& q, const triple* birth, line_id a, typename M::path p, double t) {
  // A box that contains the wavefront at all times.
  { m.frame() } -> std::convertible_to<box>;
  // The greatest speed of a line; zero: nothing moves.
  { m.speed() } -> std::convertible_to<double>;
  // Whether a line may be one that does not move.
  { m.is_stationary(a) } -> std::same_as<bool>;
  // When three lines meet, if that is after time zero.
  { m.time(q) } -> std::same_as<interval>;
  // The same, as sharp as the policy can; {infinity, infinity} where the lines never meet in the
  // limit of a perturbation.
  { m.sharp_time(q) } -> std::same_as<interval>;
  // The point in which three lines meet.
  { m.place(q) } -> std::same_as<box>;
  // What a policy knows of the path of a vertex of two lines (before it, after it): `path::start`
  // is a box that contains its start, which is the meeting of `birth` or, where that is null, the
  // lines' intersection at time zero.
  { m.begin(a, a, birth) } -> std::same_as<typename M::path>;
  { p.start } -> std::convertible_to<box>;
  // All points of a path between two times.
  { m.swept(p, t, t) } -> std::same_as<box>;
};

/// Whether sharp_time of a policy recognises lines that never meet in the limit. Where a member
/// `is_sharp` says no, the kernel is asked.
template <motion_bounds M>
inline constexpr bool has_sharp_times = !requires {
  requires !M::is_sharp;
};

/// The policy that knows nothing: everything may be everywhere at any time. All questions are then
/// the kernel's: one for each pair of a reflex vertex and an edge, and again whenever one of them
/// changes.
struct unbounded_motion {
  static constexpr bool is_sharp = false;
  /// A path of which nothing is known.
  struct path {
    box start;
  };
  /// Returns a box whose size means nothing, since all boxes of this policy are the same.
  box frame() const { return box::at({0, 0}); }
  /// Returns a number that is not zero.
  double speed() const { return 1; }
  /// Returns true: any line may stand still.
  bool is_stationary(line_id /*l*/) const { return true; }
  /// Returns the interval of all times.
  interval time(const triple& /*lines*/) const { return {0, std::numeric_limits<double>::infinity()}; }
  /// Returns the interval of all times.
  interval sharp_time(const triple& lines) const { return time(lines); }
  /// Returns frame().
  box place(const triple& /*lines*/) const { return frame(); }
  /// Returns the path of which nothing is known.
  path begin(line_id /*before*/, line_id /*after*/, const triple* /*birth*/) const { return {frame()}; }
  /// Returns frame().
  box swept(const path& /*p*/, double /*from*/, double /*to*/) const { return frame(); }
};
static_assert(motion_bounds<unbounded_motion>);

}  // namespace osteon::plane
