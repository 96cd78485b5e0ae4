// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What surrounds a meeting point: the pieces of lines that the wavefront's edges cover there, and
/// the local event that they are.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/segment.hpp"
#include "osteon/space/wavefront.hpp"

namespace osteon {

/// The wavefront around a meeting point, just before the event.
struct local_state {
  quadruple planes;   ///< that meet, ascending
  local::cell small;  ///< the cell that vanishes
  /// by pair of planes and section of their line: the edge there, or -1
  std::array<std::array<int, 3>, 6> edges;
  const local::event* event;  ///< in the catalogue
};

/// Reads local states off a wavefront. A meeting whose local state is not there is no event, now or
/// ever.
template <kernel<3> K>
class local_states {
 public:
  /// Follows the wavefront as it changes.
  local_states(const K& k, const wavefront& front) : k_(k), front_(front) {}

  /// Returns the local state at a meeting, or nothing where one of the planes' facets is not there.
  /// *Requires* that the wavefront is that of the meeting's moment. *Complexity* linear in the
  /// edges on the six lines and, for a plane that has no edge near, in those of its facet.
  std::optional<local_state> at(const typename K::meeting& m) const {
    local_state s{k_.planes(m), 0, {}, nullptr};
    std::array<std::vector<int>, 6> near;
    unsigned with_edge = 0;
    for (unsigned p = 0; p < 6; ++p) {
      near[p] = edges_at(s.planes, local::pairs[p], m);
      if (!near[p].empty()) with_edge |= 1U << local::pairs[p].i | 1U << local::pairs[p].j;
    }
    std::uint64_t key = 0;
    for (unsigned r = 0; r < 4; ++r) {
      if ((with_edge >> r & 1U) != 0) continue;
      if (!facet_contains(s.planes, r, m)) return std::nullopt;
      key |= local::facet_bit(r);
    }
    s.small = small_cell(s.planes, m);
    for (unsigned p = 0; p < 6; ++p) key |= covered_pieces(s, p, near[p]);
    s.event = local::catalogue::get().find(s.small, key);
    if (s.event == nullptr) broken_invariant<K>("the boundary around a meeting point is in the catalogue");
    return s;
  }

 private:
  using meeting = typename K::meeting;

  // The cell inside the planes with lambda / S > 0: that which vanishes.
  local::cell small_cell(const quadruple& q, const meeting& m) const {
    local::cell small = 0;
    for (unsigned r = 0; r < 4; ++r) {
      const sign s = lambda(q, r, [this](plane_id a, plane_id b, plane_id c) { return generic_orientation(k_, a, b, c); });
      if (s * k_.closing(m) == sign::positive) small |= 1U << r;
    }
    return small;
  }

  // Finds which edge covers each piece of the line of pair p; returns their part of the key.
  std::uint64_t covered_pieces(local_state& s, unsigned p, const std::vector<int>& near) const {
    std::uint64_t key = 0;
    s.edges[p].fill(-1);
    for (unsigned w = 0; w < 3; ++w)
      for (const int e : near)
        if (covers(s.planes, local::pairs[p], e, local::label(local::pairs[p], static_cast<local::section>(w), s.small, false))) {
          if (s.edges[p][w] >= 0) broken_invariant<K>("a piece of a line lies on one edge at most");
          s.edges[p][w] = e;
          key |= local::piece_bits(p, w, front_.edges()[e].convex ? local::piece::convex : local::piece::reflex);
        }
    return key;
  }

  // The edges on the line of a pair that contain the meeting point.
  std::vector<int> edges_at(const quadruple& q, const local::pair_of_planes& p, const meeting& m) const {
    std::vector<int> result;
    const plane_id third = k_.transversal(q[p.i], q[p.j], q[p.k]) ? q[p.k] : q[p.l];
    for (const int e : front_.on_line(q[p.i], q[p.j])) {
      const auto& edge = front_.edges()[e];
      bool contains = true;
      for (int s = 0; s < 2 && contains; ++s)
        if (edge.third[s] != q[p.k] && edge.third[s] != q[p.l])
          contains = (generic_side(k_, edge.third[s], q[p.i], q[p.j], third, m) == sign::positive) == edge.inside[s];
      if (contains) result.push_back(e);
    }
    return result;
  }

  // Whether an edge through the meeting point contains the piece with the given label: each end at
  // the point must lie beyond.
  bool covers(const quadruple& q, const local::pair_of_planes& p, int e, local::cell label) const {
    const auto& edge = front_.edges()[e];
    for (int s = 0; s < 2; ++s)
      for (const unsigned r : {p.k, p.l})
        if (edge.third[s] == q[r] && local::is_inside(label, r) != edge.inside[s]) return false;
    return true;
  }

  // Whether the meeting point lies in the facet of q[r], none of whose edges is near.
  bool facet_contains(const quadruple& q, unsigned r, const meeting& m) const {
    const auto ids = front_.of_facet(q[r]);
    if (ids.empty()) return false;
    triple others = omit(q, r);
    if (!k_.transversal(q[r], others[0], others[1])) std::swap(others[1], others[2]);
    if (!k_.transversal(q[r], others[0], others[1])) std::swap(others[0], others[2]);
    std::vector<segment> edges;
    edges.reserve(ids.size());
    for (const int e : ids) edges.push_back(front_.edges()[e]);
    return locate_in_facet(k_, edges, q[r], others[0], others[1], true, m, others[2]).value_or(false);
  }

  const K& k_;
  const wavefront& front_;
};

}  // namespace osteon
