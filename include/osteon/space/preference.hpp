// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a solid's skeleton prefers where it has a choice: at vertices of high degree, and at
/// saddles.

#include <cstdint>

namespace osteon {

/// Which valid tree a vertex is split by.
enum class split_preference : std::uint8_t {
  convex,      ///< most convex edges
  reflex,      ///< most reflex edges
  min_volume,  ///< least volume of the offset
  max_volume,  ///< greatest volume of the offset
  first        ///< the first that is found
};

/// Which of the two outcomes a saddle has: the one with the convex or reflex new edge, or with the
/// new edge that moves slower or faster (by the angle between its facets' normals; the convex and
/// the reflex one in a tie).
enum class saddle_rule : std::uint8_t { convex, reflex, slower, faster };

/// Returns the rule that goes with a preference where none is asked for.
constexpr saddle_rule default_saddle(split_preference p) {
  return p == split_preference::reflex || p == split_preference::min_volume ? saddle_rule::reflex : saddle_rule::convex;
}

}  // namespace osteon
