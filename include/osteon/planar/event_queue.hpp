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
#include "osteon/prefetch.hpp"

namespace osteon::planar {

/// Meetings in order of time. Most comparisons are decided by enclosures of their times; the kernel is asked where these overlap. Simultaneous
/// meetings, which only unperturbed kernels know, come in the order of their lines. Candidates wait in slices of time, unsorted; only those of the
/// slices that have begun are in a heap, which stays small and close at hand.
template <planar_kernel K>
class event_queue {
 public:
  using meeting = typename K::meeting;

  /// Three lines that will meet, and what of the wavefront is on them: an edge that vanishes or, with a vertex, is hit by it.
  struct candidate {
    meeting when;
    int edge;
    int vertex;  ///< or -1
  };

  explicit event_queue(const K& k) : k_(k) {}

  bool empty() const { return near_.empty() && far_size_ == 0; }

  /// Calls begin(ids) for the candidates of each slice that begins, so that what belongs to them can be brought near; at(id) is the
  /// candidate. Must be called before top() and pop() after every change.
  template <class Begin>
  void advance(Begin begin) {
    if (!sliced_) slice();
    while (slice_ < slices() && (near_.empty() || near_.front().when.last >= first_of(slice_))) {
      fresh_.clear();
      const std::size_t end = std::min(order_.size(), (slice_ + 1) * per_slice);
      for (std::size_t i = slice_ * per_slice; i < end; ++i) prefetch(&waiting_[order_[i].second]);
      for (std::size_t i = slice_ * per_slice; i < end; ++i) fresh_.push_back(enter(waiting_[order_[i].second]));
      for (const auto& w : late_[slice_]) fresh_.push_back(enter(w));
      far_size_ -= fresh_.size();
      std::vector<waiting>().swap(late_[slice_]);
      ++slice_;
      begin(fresh_);
    }
  }
  const candidate& top() const { return candidates_[near_.front().id]; }
  const interval& top_time() const { return near_.front().when; }
  const candidate& at(int id) const { return candidates_[id]; }

  /// `when` contains the time of the meeting.
  void push(const candidate& c, const interval& when) {
    if (!sliced_) {
      waiting_.push_back({when, c});
      ++far_size_;
      return;
    }
    // The first slice that begins behind the moment is one too far.
    const auto behind = std::upper_bound(order_begin_.begin() + slice_, order_begin_.end(), when.first);
    if (behind == order_begin_.begin() + slice_) {
      enter({when, c});
      return;
    }
    late_[static_cast<std::size_t>(behind - order_begin_.begin()) - 1].push_back({when, c});
    ++far_size_;
  }

  candidate pop() {
    std::pop_heap(near_.begin(), near_.end(), later{this});
    const int id = near_.back().id;
    near_.pop_back();
    free_.push_back(id);
    return candidates_[id];
  }

  /// Before many are pushed: time is cut into slices anew afterwards.
  void restart() {
    std::vector<waiting> all;
    all.reserve(near_.size() + far_size_);
    for (const entry& e : near_) all.push_back({e.when, candidates_[e.id]});
    if (!sliced_) 
      all.insert(all.end(), waiting_.begin(), waiting_.end());
    else
      for (; slice_ < slices(); ++slice_) {
        for (std::size_t i = slice_ * per_slice; i < std::min(order_.size(), (slice_ + 1) * per_slice); ++i) all.push_back(waiting_[order_[i].second]);
        all.insert(all.end(), late_[slice_].begin(), late_[slice_].end());
      }
    near_.clear();
    candidates_.clear();
    free_.clear();
    waiting_ = std::move(all);
    far_size_ = waiting_.size();
    sliced_ = false;
  }

 private:
  struct waiting {
    interval when;
    candidate what;
  };
  struct entry {
    interval when;
    int id;
  };
  struct later {
    const event_queue* queue;
    bool operator()(const entry& a, const entry& b) const {
      if (a.when.last < b.when.first) return false;
      if (a.when.first > b.when.last) return true;
      const meeting& m = queue->candidates_[a.id].when;
      const meeting& n = queue->candidates_[b.id].when;
      const sign s = queue->k_.compare(m, n);
      return s != sign::zero ? s == sign::positive : triple(queue->k_.planes(m)) > triple(queue->k_.planes(n));
    }
  };
  static constexpr std::size_t per_slice = 64;

  std::size_t slices() const { return late_.size(); }
  double first_of(std::size_t slice) const { return order_begin_[slice]; }

  int enter(const waiting& c) {
    int id = static_cast<int>(candidates_.size());
    if (free_.empty()) {
      candidates_.push_back(c.what);
    } else {
      id = free_.back();
      free_.pop_back();
      candidates_[id] = c.what;
    }
    near_.push_back({c.when, id});
    std::push_heap(near_.begin(), near_.end(), later{this});
    return id;
  }

  void slice() {
    order_.clear();
    for (std::size_t i = 0; i < waiting_.size(); ++i) order_.push_back({waiting_[i].when.first, static_cast<int>(i)});
    std::sort(order_.begin(), order_.end());
    order_begin_.clear();
    for (std::size_t i = 0; i < order_.size(); i += per_slice) order_begin_.push_back(order_[i].first);
    late_.clear();
    late_.resize(order_begin_.size());
    slice_ = 0;
    sliced_ = true;
  }

  const K& k_;
  std::vector<entry> near_;  // a heap
  std::vector<candidate> candidates_;  // of the heap
  std::vector<int> free_;
  std::vector<int> fresh_;
  std::vector<waiting> waiting_;
  std::vector<std::pair<double, int>> order_;  // of those that wait, by time
  std::vector<double> order_begin_;            // of each slice
  std::vector<std::vector<waiting>> late_;   // what has come into each slice since
  std::size_t slice_ = 0;                      // the first that has not begun
  std::size_t far_size_ = 0;
  bool sliced_ = false;
};

}  // namespace osteon::planar
