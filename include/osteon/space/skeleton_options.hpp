// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What may be chosen where a solid has several straight skeletons: the splits of its vertices and
/// the outcomes of saddles.

#include <cstdint>
#include <optional>

#include "osteon/core/random.hpp"
#include "osteon/space/split.hpp"

namespace osteon {

/// Which of the two outcomes a saddle has: the one with the convex or reflex new edge, or with the
/// new edge that moves slower or faster (by the angle between its facets' normals; the convex and
/// the reflex one in a tie).
enum class saddle_rule : std::uint8_t { convex, reflex, slower, faster };

/// The choices of one run.
struct skeleton_options {
  split_preference prefer = split_preference::convex;
  saddle_rule saddle = saddle_rule::convex;
  /// Where given, nothing is preferred: splits (see random_split) and outcomes of saddles are
  /// drawn, the same ones for the same number.
  std::optional<std::uint64_t> explore = std::nullopt;
};

/// Returns the rule for saddles that goes with a preference where none is asked for.
constexpr saddle_rule default_saddle(split_preference p) {
  return p == split_preference::reflex || p == split_preference::min_volume ? saddle_rule::reflex : saddle_rule::convex;
}

/// Returns the random number that a run draws for its n-th choice: vertices of the solid count from
/// zero up, saddles from minus one down.
constexpr std::uint64_t drawn_number(std::uint64_t explore, int n) {
  return random_stream::mixed(explore * random_stream::step + static_cast<std::uint64_t>(n));
}

}  // namespace osteon
