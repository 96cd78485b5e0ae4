// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the boundary of a polygon to its straight skeleton. One handler serves all events
/// (docs/theory/plane.md).
///
/// Notation
///   front      the wavefront: rings of edges on moving lines, the interior on their left
///   (wavefront.hpp)
///   node, arc  what an event, and what a moving vertex leaves behind (skeleton.hpp)
///   meeting    three lines and the time at which they share a point; only the kernel knows the
///   time
///   candidate  what of the front is on the lines of a meeting: an edge that vanishes between its
///   neighbours (a collapse), or a reflex vertex and an
///              edge that it hits (a contact). A candidate whose elements have changed counts no
///              more: what changes is looked at anew
///   moment     all meetings that are simultaneous in the limit of the perturbation
///   window     a stretch of time for which all contacts are in the schedule
///
/// The rooms
///   initial_front      the front at time zero
///   contact_search     which reflex vertices may hit which edges: windows of time, and boxes of
///   what moves in them
///   schedule           when edges collapse, which candidates count, and which is the first
///   local_state        what surrounds a meeting on the front, and so which event of the catalogue
///   it is
///   front_surgery      carries out the event, and tells which edges have new ends
///   zero_length_edges  what collapses at the end of a moment

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/contact_search.hpp"
#include "osteon/plane/front_prefetch.hpp"
#include "osteon/plane/front_surgery.hpp"
#include "osteon/plane/initial_front.hpp"
#include "osteon/plane/local_state.hpp"
#include "osteon/plane/motion_bounds.hpp"
#include "osteon/plane/schedule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/traced_front.hpp"
#include "osteon/plane/zero_length_edges.hpp"

namespace osteon::plane {

/// One run of the wavefront.
template <kernel<2> K, motion_bounds Motion>
class propagation {
 public:
  propagation(const K& k, const boundary& polygon, const Motion& motion, const skeleton_options& o = {})
      : k_(k), polygon_(polygon), motion_(motion), options_(o) {}
  propagation(const propagation&) = delete;
  propagation& operator=(const propagation&) = delete;

  /// Runs to the end and returns the skeleton; to be called once.
  skeleton run() {
    if (!(motion_.speed() > 0)) refuse(0);
    begin();
    while (front_.living > 0) {
      times_.advance([this](std::span<const candidate> candidates) { prefetch_(candidates); });
      if (contacts_.window().last < infinity) {
        if (times_.empty() || !(times_.first_time().last <= contacts_.window().last)) {
          if (contacts_.window().last >= options_.until) break;
          open_next_window();
          continue;
        }
        if (2 * changes_ > static_cast<int>(front_.edges.size()) + 100) {
          cut_window();
          continue;
        }
      } else if (times_.empty()) {
        if (!collapse_zero_length_edges()) break;
        continue;
      }
      if (!zero_.empty() && !zero_.is_same_moment(times_.first().when) && collapse_zero_length_edges()) continue;
      if (const auto next = times_.take())
        if (const auto state = reader_.read(next->what, next->when)) {
          times_.enter(*next);
          zero_.enter(next->when);
          ++changes_;
          watch(surgery_.replace(*state));
        }
    }
    if (front_.living > 0 && !options_.outside && !(options_.until < infinity)) explain_rest();
    return traced_.take();
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void begin() {
    times_.reserve(3 * polygon_.next.size() / 2);
    initial_front<K>(k_, polygon_, traced_).build();
    contacts_.begin(polygon_);
    for (int e = 0; e < static_cast<int>(front_.edges.size()); ++e)
      if (front_.edges[e].alive && times_.watch(e)) zero_.note(e);
    numbered_ = static_cast<int>(traced_.trace.nodes.size());
  }

  // Nothing more happens in this window.
  void open_next_window() {
    if (8 * changes_ < static_cast<int>(front_.edges.size())) contacts_.lengthen();
    const interval& window = contacts_.window();
    // A meeting whose time is not known well must not be overtaken.
    open_window(times_.empty() ? window.last : std::clamp(times_.first_time().first, window.first, window.last));
  }

  // Too much happens in this window: what has changed crowds the trees of boxes.
  void cut_window() {
    const interval& window = contacts_.window();
    const double now = std::clamp(times_.present().first, window.first, window.last);
    contacts_.shorten(now);
    open_window(now);
  }

  void open_window(double from) {
    changes_ = 0;
    // Every time would be slower where little happens in a window.
    if (numbered_ + front_.living / 4 < static_cast<int>(traced_.trace.nodes.size()))
      renumber();
    else
      times_.restart();
    contacts_.open_window(from);
  }

  // Neighbours become neighbours in memory, and dead elements are forgotten.
  void renumber() {
    const auto now = front_.renumber();
    if (!now) broken_invariant<K>("the wavefront consists of closed rings");
    numbered_ = static_cast<int>(traced_.trace.nodes.size());
    traced_.dead_slots.clear();
    contacts_.renumber(*now);
    zero_.renumber(*now);
    times_.renumber(*now);
  }

  // What has changed is looked at anew.
  void watch(const front_change& change) {
    for (const merged_edge& m : change.mergers) zero_.note(m);
    for (const int e : change.edges)
      if (times_.watch(e)) zero_.note(e);
    contacts_.watch(change);
  }

  bool collapse_zero_length_edges() {
    return zero_.collapse([this](int e) { watch(surgery_.remove(e)); });
  }

  // Only edges that do not move may be left.
  [[noreturn]] void explain_rest() const {
    for (const auto& e : front_.edges)
      if (e.alive && !motion_.is_stationary(e.line)) broken_invariant<K>("the wavefront vanishes");
    refuse(std::find_if(front_.edges.begin(), front_.edges.end(), [](const auto& e) { return e.alive; })->face);
  }
  [[noreturn]] static void refuse(int edge) {
    throw unsupported_error("edges of weight zero, among them that of vertex " + std::to_string(edge) +
                            ", enclose a part of the polygon that never vanishes; hint: give one of them a weight");
  }

  const K& k_;
  const boundary& polygon_;
  const Motion& motion_;
  const skeleton_options options_;
  traced_front traced_;
  wavefront& front_ = traced_.front;
  schedule<K, Motion> times_{k_, motion_, front_};
  contact_search<K, Motion> contacts_{k_, motion_, options_, front_, times_};
  front_prefetch<K, Motion> prefetch_{traced_, times_, contacts_};
  local_reader<K> reader_{k_, front_};
  front_surgery<K> surgery_{k_, traced_};
  zero_length_edges<K> zero_{k_, traced_};
  int changes_ = 0;   // in this window
  int numbered_ = 0;  // how many nodes there were when elements got their numbers
};

/// Returns the raw straight skeleton of a polygon's interior.
/// *Requires* a checked boundary whose lines are the kernel's, in general position for it
/// (perturbed<K>), and bounds that hold for them.
/// *Throws* unsupported_error where a part of the wavefront stands still for ever, undecided_error
/// where an inexact kernel contradicts itself, invariant_error where an exact one does.
/// *Complexity* O(n log n) in practice for n vertices; memory linear.
template <kernel<2> K, motion_bounds Motion>
skeleton straight_skeleton(const K& k, const boundary& polygon, const Motion& motion, const skeleton_options& o = {}) {
  return propagation<K, Motion>(k, polygon, motion, o).run();
}

/// Does the same with a kernel alone, without bounds on motion.
/// *Throws* unsupported_error also where `until` is given: without bounds no time is known.
/// *Complexity* O(n^2) predicates and more.
template <kernel<2> K>
skeleton straight_skeleton(const K& k, const boundary& polygon, const skeleton_options& o = {}) {
  if (o.until < std::numeric_limits<double>::infinity()) throw unsupported_error("to stop at a time, a skeleton needs bounds on motion");
  return straight_skeleton(k, polygon, unbounded_motion{}, o);
}

}  // namespace osteon::plane
