// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The candidates for events in order of time.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// Three lines that will meet, by what of the wavefront is on them: an edge that vanishes or, with
/// a vertex, is hit by it.
struct candidate {
  interval when;  ///< contains the time
  int edge;
  int vertex = -1;
  int arc = -1;  ///< of the vertex, by which it is known later
};

/// Candidates in order of time. They wait in slices of time, unsorted. A slice that begins is
/// sorted and taken by portions into a heap with their meetings, which stays small and close at
/// hand. Most comparisons are decided by enclosures of their times; the kernel is asked where these
/// overlap. Simultaneous meetings, which only unperturbed kernels know, come in the order of their
/// lines.
template <kernel<2> K>
class event_queue {
 public:
  using meeting = typename K::meeting;
  /// A candidate that has been asked for its meeting.
  struct event {
    meeting when;
    candidate what;
  };

  explicit event_queue(const K& k) : k_(k) {}

  bool empty() const { return heap_.empty() && waiting_ == 0; }

  /// Takes portions until the first event is known. warm(candidates) is told of each, and
  /// meet(candidate) gives the meeting, or nothing where the candidate is no longer one. Must be
  /// called before top() and pop() after every change.
  template <class Prefetch, class Meet>
  void advance(Prefetch prefetch_around, Meet meet) {
    if (!sliced_) slice();
    while (waiting_ > 0 && (heap_.empty() || heap_.front().when.last >= next_begin())) {
      if (taken_ == current_.size()) {
        current_.swap(slices_[slice_]);
        std::vector<candidate>().swap(slices_[slice_]);
        std::sort(current_.begin(), current_.end(), [](const candidate& c, const candidate& d) { return c.when.first < d.when.first; });
        taken_ = 0;
        ++slice_;
        continue;
      }
      const auto portion = std::span<const candidate>(current_).subspan(taken_, std::min(per_portion, current_.size() - taken_));
      taken_ += portion.size();
      waiting_ -= portion.size();
      prefetch_around(portion);
      for (const candidate& c : portion)
        if (const auto m = meet(c)) enter({*m, c});
    }
  }
  /// Returns the earliest event. *Requires* a queue that is not empty.
  const event& top() const { return events_[heap_.front().id]; }
  /// Returns the enclosure of the earliest event's time. *Requires* a queue that is not empty.
  const interval& top_time() const { return heap_.front().when; }

  /// Adds a candidate with its meeting.
  void push(const meeting& m, const candidate& c) {
    if (sliced_ && (slice_ == slices_.size() || c.when.first < begin_[slice_])) {
      enter({m, c});
      return;
    }
    (sliced_ ? slice_of(c) : unsliced_).push_back(c);
    ++waiting_;
  }

  /// Removes the earliest event and returns it. *Requires* a queue that is not empty.
  event pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later{this});
    const int id = heap_.back().id;
    heap_.pop_back();
    free_.push_back(id);
    return events_[id];
  }

  /// Prepares for many pushes: time is cut into slices anew afterwards. Those for which
  /// keep(candidate), which may change it, is false are forgotten.
  template <class Keep>
  void restart(Keep keep) {
    std::vector<candidate> all;
    const auto add = [&](candidate c) {
      if (keep(c)) all.push_back(c);
    };
    for (const entry& e : heap_) add(events_[e.id].what);
    std::for_each(unsliced_.begin(), unsliced_.end(), add);
    std::for_each(current_.begin() + static_cast<std::ptrdiff_t>(taken_), current_.end(), add);
    for (const auto& s : slices_) std::for_each(s.begin(), s.end(), add);
    heap_.clear();
    events_.clear();
    free_.clear();
    current_.clear();
    taken_ = 0;
    slices_.clear();
    unsliced_ = std::move(all);
    waiting_ = unsliced_.size();
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
  static constexpr std::size_t per_portion = 64;
  static constexpr std::size_t sampled = 32;    // one of so many is in the sample,
  static constexpr std::size_t per_slice = 32;  // of which so many make a slice

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

  // What waits is not earlier.
  double next_begin() const { return taken_ < current_.size() ? current_[taken_].when.first : begin_[slice_]; }

  std::vector<candidate>& slice_of(const candidate& c) {
    const auto behind = std::upper_bound(begin_.begin() + 1, begin_.end(), c.when.first);
    return slices_[static_cast<std::size_t>(behind - begin_.begin()) - 1];
  }

  // Cuts time where a sample says that about the same number is in each slice.
  void slice() {
    std::vector<double> sample;
    for (std::size_t i = 0; i < unsliced_.size(); i += sampled) sample.push_back(unsliced_[i].when.first);
    std::sort(sample.begin(), sample.end());
    begin_ = {-std::numeric_limits<double>::infinity()};
    for (std::size_t i = per_slice; i < sample.size(); i += per_slice) begin_.push_back(sample[i]);
    slices_.resize(begin_.size());
    slice_ = 0;
    for (const candidate& c : unsliced_) slice_of(c).push_back(c);
    std::vector<candidate>().swap(unsliced_);
    sliced_ = true;
  }

  const K& k_;
  std::vector<entry> heap_;
  std::vector<event> events_;  // of the heap
  std::vector<int> free_;
  std::vector<candidate> unsliced_;  // what has come since time was to be cut anew
  std::vector<double> begin_;        // of each slice
  std::vector<std::vector<candidate>> slices_;
  std::size_t slice_ = 0;           // the first that has not begun
  std::vector<candidate> current_;  // the slice that has begun last, sorted
  std::size_t taken_ = 0;           // how many of it are in the heap
  std::size_t waiting_ = 0;         // how many are not
  bool sliced_ = false;
};

}  // namespace osteon::plane
