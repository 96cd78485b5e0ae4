// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The event loop: from the boundary of a solid to its straight skeleton
/// (docs/theory/events.md). One handler serves all events.
///
/// Notation.
/// * Planes i, j, k, l are four planes of the solid; a *meeting* is the moment at which they share
///   a point (core/kernel.hpp). The wavefront is the boundary of what is left of the solid.
/// * Vertex (i,j,k) of the wavefront is a *corner* of three planes; it traces an arc. An edge lies
///   on the line (i,j); it traces a sheet.
/// * A *candidate* is a meeting that may be an event. Nothing else is kept of it, and whether it is
///   an event is read off the wavefront at its moment: candidates never become stale.
/// * The planes of a meeting cut its point's neighbourhood into cells; which of them are solid is
///   the *local state* (core/local_events.hpp). The vertices (j,k,l) .. (i,j,k) around the point
///   bound the small cell, which the event replaces by its opposite, solid or not.
/// * A *saddle* is an event with two admissible outcomes.
///
/// initial_split    every vertex of the solid becomes a tree of vertices of three planes
/// initial_front    the wavefront just after the start
/// contact_search   candidates, in order of time
/// local_state      what surrounds a candidate's point
/// front_surgery    the wavefront after an event, and the skeleton traced until then

#include <optional>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/contact_search.hpp"
#include "osteon/space/front_surgery.hpp"
#include "osteon/space/initial_front.hpp"
#include "osteon/space/initial_split.hpp"
#include "osteon/space/local_state.hpp"
#include "osteon/space/skeleton.hpp"
#include "osteon/space/skeleton_options.hpp"

namespace osteon {

/// One run of the wavefront.
template <kernel<3> K>
class propagation {
 public:
  /// `solid` must outlive the run.
  propagation(const K& k, const boundary& solid, const skeleton_options& o = {})
      : k_(k), solid_(solid), options_(o), surgery_(k, solid.planes), search_(k, surgery_.front()) {}

  /// Runs to the end and returns the skeleton.
  /// *Throws* degenerate_error, unsupported_error, undecided_error or invariant_error.
  /// *Complexity* a meeting for each candidate. Vertices look for contacts at all planes within the
  /// lifetime of their edges.
  skeleton run() {
    const int unproven = start();
    const local_states<K> states(k_, surgery_.front());
    while (!surgery_.front().empty()) {
      const auto candidate = search_.next();
      if (!candidate) broken_invariant<K>("the wavefront vanishes");
      if (const auto state = states.at(*candidate)) search_.update(*candidate, surgery_.replace(*state, fills(*state)));
    }
    skeleton result = surgery_.finish();
    result.unproven_splits = unproven;
    return result;
  }

 private:
  // Returns the number of splits that were not proven to be the preferred ones.
  int start() {
    const split_solid split = initial_split<K>(k_, solid_, options_).run();
    initial_front<K>(k_, split, surgery_).run();
    search_.start();
    return split.unproven;
  }

  // Whether the cell that an event creates becomes solid. At a saddle that makes the new edge
  // convex.
  bool fills(const local_state& s) const {
    if (!s.event->may_empty && !s.event->may_fill) broken_invariant<K>("every event has an admissible outcome");
    if (!s.event->may_empty || !s.event->may_fill) return s.event->may_fill;
    if (options_.explore) return (drawn_number(*options_.explore, -1 - static_cast<int>(surgery_.traced().nodes.size())) & 1U) != 0;
    if (options_.saddle == saddle_rule::convex) return true;
    if (options_.saddle == saddle_rule::reflex) return false;
    const auto edge = [&](bool fill) {
      const int p = local::new_edge(*s.event, fill);
      if (p < 0) broken_invariant<K>("a saddle makes an edge");
      return k_.bisector(s.planes[local::pairs[p].i], s.planes[local::pairs[p].j]);
    };
    // of the convex against the reflex edge
    const sign order = k_.compare(edge(true), edge(false));
    return options_.saddle == saddle_rule::slower ? order != sign::positive : order == sign::positive;
  }

  const K& k_;
  const boundary& solid_;
  skeleton_options options_;
  front_surgery<K> surgery_;
  contact_search<K> search_;
};

/// Returns the straight skeleton of a solid under a kernel that has its planes.
/// *Throws* and *Complexity* as propagation::run.
template <kernel<3> K>
skeleton straight_skeleton(const K& k, const boundary& solid, const skeleton_options& o = {}) {
  return propagation<K>(k, solid, o).run();
}

}  // namespace osteon
