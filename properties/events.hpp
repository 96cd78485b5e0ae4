// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What events do, read off the corners before and after that the skeleton keeps; found by going through the whole catalogue.

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "osteon/space/catalogue.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::properties {

/// What one event adds to the counts.
struct change {
  int arcs;            ///< that end or begin
  int sheets;          ///< that begin
  int characteristic;  ///< of the solid
  friend bool operator<(const change& a, const change& b) {
    return std::tie(a.arcs, a.sheets, a.characteristic) < std::tie(b.arcs, b.sheets, b.characteristic);
  }
};

/// What of an event is written into the skeleton: the corners before and after, by the plane of the four that they omit; 0 for none.
using event_corners = std::array<std::array<std::uint8_t, 4>, 2>;

/// The Euler characteristic of the closed solid within the open neighbourhood, by counting open faces of the arrangement of four planes.
inline int characteristic(local::state f, local::cell missing) {
  int sum = 0;
  for (unsigned through = 0; through < 15; ++through)  // the planes that contain the face
    for (unsigned label = 0; label < 16; ++label) {
      if ((label & through) != 0 || label == (missing & ~through)) continue;
      bool solid = false;
      for (unsigned c = 0; c < 16; ++c) solid = solid || ((c & ~through) == label && local::solid(f, c));
      if (solid) sum += std::popcount(through) % 2 != 0 ? 1 : -1;  // dimension 3 - number of planes
    }
  return sum;
}

inline std::pair<event_corners, change> effect(const local::event& e, bool fill) {
  const local::state after = local::successor(e, fill);
  change c{0, 0, characteristic(after, e.small) - characteristic(e.before, e.small ^ 15U)};
  event_corners g{};
  for (unsigned q = 0; q < 4; ++q) {
    const bool in = (e.small >> q & 1U) != 0;
    g[0][q] = local::corner_at(e.before, q, in);
    g[1][q] = local::corner_at(after, q, !in);
    for (auto& side : g) {
      if (!local::is_corner(side[q])) side[q] = 0;
      c.arcs += side[q] != 0 ? 1 : 0;
    }
  }
  for (const auto& p : local::pairs)
    if (g[1][p.k] != 0 && g[1][p.l] != 0 && local::piece_at(after, p, local::label(p, local::segment, e.small, true)) != local::piece::none)
      ++c.sheets;
  return {g, c};
}

struct entry {
  std::set<change> changes;
  std::set<event_class> kinds;
};

inline const std::map<event_corners, entry>& effects() {
  static const auto all = [] {
    std::map<event_corners, entry> result;
    for (local::cell small = 1; small < 16; ++small)
      for (const auto& [key, e] : local::catalogue::get().events(small))
        for (const bool fill : {false, true}) {
          if (!(fill ? e.may_fill : e.may_empty)) continue;
          const auto [g, c] = effect(e, fill);
          result[g].changes.insert(c);
          result[g].kinds.insert(local::classify(e, fill));
        }
    return result;
  }();
  return all;
}

/// The corners at an event node.
inline event_corners corners_at(const skeleton& raw, int node) {
  const auto& n = raw.nodes[node];
  event_corners g{};
  for (const int i : n.arcs) {
    const auto& a = raw.arcs[i];
    std::size_t omitted = 3;
    for (std::size_t r = 3; r-- > 0;)
      if (a.planes[r] != n.planes[r]) omitted = r;
    g[a.source == node ? 1 : 0][omitted] = a.corner;
  }
  return g;
}

/// The effect of an event node, or null where its event_corners are those of no event.
inline const entry* effect_at(const skeleton& raw, int node) {
  const auto found = effects().find(corners_at(raw, node));
  return found == effects().end() ? nullptr : &found->second;
}
/// Time reversed and the solid replaced by its complement: before and after change places, and a corner g becomes x -> not g(not x).
inline event_corners reversed(const event_corners& g) {
  event_corners result{};
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t r = 0; r < 4; ++r)
      for (unsigned x = 0; x < 8 && g[side][r] != 0; ++x)
        if ((g[side][r] >> (7 - x) & 1U) == 0) result[1 - side][r] = static_cast<std::uint8_t>(result[1 - side][r] | 1U << x);
  return result;
}

/// Whether an event can be undone: not where a facet vanishes, for none appears from nowhere (design 02, rule 2).
inline bool can_be_undone(const skeleton& raw, int node) { return effects().contains(reversed(corners_at(raw, node))); }

}  // namespace osteon::properties
