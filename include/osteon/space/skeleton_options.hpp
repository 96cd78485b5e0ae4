// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What may be chosen where a solid has several straight skeletons: the splits of its vertices and
/// the outcomes of saddles.

#include <cstdint>
#include <optional>

#include "osteon/core/random.hpp"
#include "osteon/space/preference.hpp"

namespace osteon {

/// The choices of one run.
struct skeleton_options {
  split_preference prefer = split_preference::convex;
  saddle_rule saddle = saddle_rule::convex;
  /// Where given, nothing is preferred: splits (see random_split) and outcomes of saddles are
  /// drawn, the same ones for the same number.
  std::optional<std::uint64_t> explore = std::nullopt;
};

/// Returns the random number that a run draws for its n-th choice: vertices of the solid count from
/// zero up, saddles from minus one down.
constexpr std::uint64_t drawn_number(std::uint64_t explore, int n) {
  return random_stream::mixed(explore * random_stream::step + static_cast<std::uint64_t>(n));
}

}  // namespace osteon
