// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Brings near, in the memory's hierarchy, what the next events will ask for. Changes no result.

#include <span>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/prefetch.hpp"
#include "osteon/plane/contact_search.hpp"
#include "osteon/plane/event_queue.hpp"
#include "osteon/plane/motion_bounds.hpp"
#include "osteon/plane/schedule.hpp"
#include "osteon/plane/traced_front.hpp"

namespace osteon::plane {

/// Walks along the wavefront from each of many candidates, for all of them at once: so they wait
/// together.
template <kernel<2> K, motion_bounds Motion>
class front_prefetch {
 public:
  front_prefetch(const traced_front& traced, const schedule<K, Motion>& times, const contact_search<K, Motion>& contacts)
      : traced_(traced), front_(traced.front), times_(times), contacts_(contacts) {}

  /// Prefetches the elements of these candidates, two neighbours on each side, and the boxes around
  /// them.
  void operator()(std::span<const candidate> candidates) {
    start(candidates);
    for (const walker& w : walkers_) prefetch(front_.vertices[w.vertex]);
    for (const bool first : {true, false}) step(first);
    for (const bool deep : {false, true})
      for (const candidate& c : candidates) contacts_.prefetch_boxes(c.vertex >= 0 ? c.vertex : front_.edges[c.edge].tail, deep);
  }

 private:
  struct walker {
    int vertex;
    bool forward;
  };

  // Two walkers from each edge, and from each vertex.
  void start(std::span<const candidate> candidates) {
    for (const candidate& c : candidates) {
      prefetch(front_.edges[c.edge]);
      if (c.vertex >= 0) prefetch(front_.vertices[c.vertex]);
    }
    walkers_.clear();
    for (const candidate& c : candidates) {
      prefetch(times_.collapse(c.edge));
      contacts_.prefetch_line(front_.edges[c.edge].line);
      walkers_.push_back({front_.edges[c.edge].tail, false});
      walkers_.push_back({front_.edges[c.edge].head, true});
      if (c.vertex >= 0)
        for (const bool forward : {false, true}) walkers_.push_back({c.vertex, forward});
    }
  }

  // To the next vertex.
  void step(bool first) {
    for (const walker& w : walkers_) {
      const auto& vertex = front_.vertices[w.vertex];
      const int e = w.forward ? vertex.out : vertex.in;
      contacts_.prefetch_track(w.vertex);
      if (first) prefetch(traced_.trace.arcs[vertex.arc]);
      prefetch(front_.edges[e]);
      prefetch(times_.collapse(e));
      contacts_.prefetch_line(w.forward ? vertex.after : vertex.before);
    }
    for (walker& w : walkers_) {
      const auto& vertex = front_.vertices[w.vertex];
      w.vertex = w.forward ? front_.edges[vertex.out].head : front_.edges[vertex.in].tail;
      prefetch(front_.vertices[w.vertex]);
    }
  }

  const traced_front& traced_;
  const wavefront& front_;
  const schedule<K, Motion>& times_;
  const contact_search<K, Motion>& contacts_;
  std::vector<walker> walkers_;
};

}  // namespace osteon::plane
