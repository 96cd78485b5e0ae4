// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The candidates for events in order of time.

#include <algorithm>
#include <utility>
#include <vector>

#include "osteon/planar/broad_phase.hpp"
#include "osteon/planar/kernel.hpp"

namespace osteon::planar {

/// A binary heap of meetings. Most comparisons are decided by enclosures of their times, next to each other in memory; the kernel is asked where
/// these overlap. Simultaneous meetings, which only unperturbed kernels know, come in the order of their lines.
template <planar_kernel K>
class event_queue {
 public:
  using meeting = typename K::meeting;

  explicit event_queue(const K& k) : k_(k) {}

  bool empty() const { return heap_.empty(); }
  const meeting& top() const { return meetings_[heap_.front().id]; }
  const interval& top_time() const { return heap_.front().when; }

  /// `when` contains the time of m.
  void push(const meeting& m, const interval& when) {
    int id = static_cast<int>(meetings_.size());
    if (free_.empty()) {
      meetings_.push_back(m);
    } else {
      id = free_.back();
      free_.pop_back();
      meetings_[id] = m;
    }
    heap_.push_back({when, id});
    std::push_heap(heap_.begin(), heap_.end(), later{this});
  }

  meeting pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later{this});
    const int id = heap_.back().id;
    heap_.pop_back();
    free_.push_back(id);
    return meetings_[id];
  }

  /// Calls body(meeting) for candidates that come soon, the first of them not included.
  template <class Body>
  void visit_next(Body body) const {
    for (std::size_t i = 1; i < std::min<std::size_t>(heap_.size(), 3); ++i) body(meetings_[heap_[i].id]);
  }

 private:
  struct entry {
    interval when;
    int id;
  };
  struct later {
    const event_queue* queue;
    bool operator()(const entry& a, const entry& b) const {
      if (a.when.last < b.when.first) return false;
      if (a.when.first > b.when.last) return true;
      const meeting& m = queue->meetings_[a.id];
      const meeting& n = queue->meetings_[b.id];
      const sign s = queue->k_.compare(m, n);
      return s != sign::zero ? s == sign::positive : triple(queue->k_.planes(m)) > triple(queue->k_.planes(n));
    }
  };

  const K& k_;
  std::vector<entry> heap_;
  std::vector<meeting> meetings_;
  std::vector<int> free_;
};

}  // namespace osteon::planar
