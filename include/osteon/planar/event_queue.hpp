// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The candidates for events in order of time.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/planar/broad_phase.hpp"
#include "osteon/planar/kernel.hpp"

namespace osteon::planar {

/// Three lines that will meet, by what of the wavefront is on them: an edge that vanishes or, with a vertex, is hit by it.
struct candidate {
  interval when;  ///< contains the time
  int edge;
  int vertex = -1;
  int arc = -1;  ///< of the vertex, by which it is known later
};

/// Candidates in order of time. They wait in slices of time, unsorted; those of the slices that have begun are in a heap with their meetings, which
/// stays small and close at hand. Most comparisons are decided by enclosures of their times; the kernel is asked where these overlap. Simultaneous
/// meetings, which only unperturbed kernels know, come in the order of their lines.
template <planar_kernel K>
class event_queue {
 public:
  using meeting = typename K::meeting;
  struct event {
    meeting when;
    candidate what;
  };

  explicit event_queue(const K& k) : k_(k) {}

  bool empty() const { return heap_.empty() && waiting_ == 0; }

  /// Begins slices until the first event is known. warm(candidates) is told of each slice's, and meet(candidate) gives the meeting, or nothing where
  /// the candidate is no longer one. Must be called before top() and pop() after every change.
  template <class Warm, class Meet>
  void advance(Warm warm, Meet meet) {
    if (!sliced_) slice();
    while (slice_ < late_.size() && (heap_.empty() || heap_.front().when.last >= begin_[slice_])) {
      current_.clear();
      const std::size_t end = std::min(early_.size(), (slice_ + 1) * per_slice);
      current_.insert(current_.end(), early_.begin() + static_cast<std::ptrdiff_t>(slice_ * per_slice),
                      early_.begin() + static_cast<std::ptrdiff_t>(end));
      current_.insert(current_.end(), late_[slice_].begin(), late_[slice_].end());
      waiting_ -= current_.size();
      std::vector<candidate>().swap(late_[slice_]);
      ++slice_;
      warm(current_);
      for (const candidate& c : current_)
        if (const auto m = meet(c)) enter({*m, c});
    }
  }
  const event& top() const { return events_[heap_.front().id]; }
  const interval& top_time() const { return heap_.front().when; }

  void push(const meeting& m, const candidate& c) {
    if (!sliced_) {
      early_.push_back(c);
      ++waiting_;
      return;
    }
    const auto first = begin_.begin() + static_cast<std::ptrdiff_t>(slice_);
    const auto behind = std::upper_bound(first, begin_.end(), c.when.first);
    if (behind == first) {
      enter({m, c});
      return;
    }
    late_[static_cast<std::size_t>(behind - begin_.begin()) - 1].push_back(c);
    ++waiting_;
  }

  event pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later{this});
    const int id = heap_.back().id;
    heap_.pop_back();
    free_.push_back(id);
    return events_[id];
  }

  /// Before many are pushed: time is cut into slices anew afterwards. Those for which keep(candidate) is false are forgotten.
  template <class Keep>
  void restart(Keep keep) {
    std::vector<candidate> all;
    const auto add = [&](const candidate& c) {
      if (keep(c)) all.push_back(c);
    };
    for (const entry& e : heap_) add(events_[e.id].what);
    const std::size_t begun = sliced_ ? std::min(early_.size(), slice_ * per_slice) : 0;
    std::for_each(early_.begin() + static_cast<std::ptrdiff_t>(begun), early_.end(), add);
    for (const auto& late : late_) std::for_each(late.begin(), late.end(), add);
    heap_.clear();
    events_.clear();
    free_.clear();
    late_.clear();
    early_ = std::move(all);
    waiting_ = early_.size();
    sliced_ = false;
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
      const meeting& m = queue->events_[a.id].when;
      const meeting& n = queue->events_[b.id].when;
      const sign s = queue->k_.compare(m, n);
      return s != sign::zero ? s == sign::positive : triple(queue->k_.planes(m)) > triple(queue->k_.planes(n));
    }
  };
  static constexpr std::size_t per_slice = 64;

  void enter(const event& e) {
    int id = static_cast<int>(events_.size());
    if (free_.empty()) {
      events_.push_back(e);
    } else {
      id = free_.back();
      free_.pop_back();
      events_[id] = e;
    }
    heap_.push_back({e.what.when, id});
    std::push_heap(heap_.begin(), heap_.end(), later{this});
  }

  void slice() {
    std::sort(early_.begin(), early_.end(), [](const candidate& c, const candidate& d) { return c.when.first < d.when.first; });
    begin_.clear();
    for (std::size_t i = 0; i < early_.size(); i += per_slice) begin_.push_back(early_[i].when.first);
    late_.resize(begin_.size());
    slice_ = 0;
    sliced_ = true;
  }

  const K& k_;
  std::vector<entry> heap_;
  std::vector<event> events_;  // of the heap
  std::vector<int> free_;
  std::vector<candidate> early_;              // what was there when time was cut, sorted
  std::vector<double> begin_;                 // of each slice
  std::vector<std::vector<candidate>> late_;  // what has come into each slice since
  std::vector<candidate> current_;            // used by advance()
  std::size_t slice_ = 0;                     // the first that has not begun
  std::size_t waiting_ = 0;                   // how many are in slices that have not begun
  bool sliced_ = false;
};

}  // namespace osteon::planar
