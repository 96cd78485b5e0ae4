// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// When edges vanish, which candidates still count, and what comes next.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/plane/event_queue.hpp"
#include "osteon/plane/motion_bounds.hpp"
#include "osteon/plane/wavefront.hpp"

namespace osteon::plane {

/// All candidates for events, and the present time. Edges that vanish later than all windows of
/// time so far are not yet in the queue: most edges have changed by then.
template <kernel<2> K, motion_bounds Motion>
class schedule {
 public:
  using meeting = typename K::meeting;
  using event = typename event_queue<K>::event;

  schedule(const K& k, const Motion& motion, const wavefront& front) : k_(k), motion_(motion), front_(front), now_(k.start()), queue_(k) {}

  /// Returns the last meeting that has happened.
  const meeting& now() const { return now_; }
  /// Returns an interval that contains its time.
  const interval& present() const { return present_; }
  /// Returns when an edge vanishes while its neighbours are what they are; {infinity, infinity}:
  /// never.
  const interval& collapse(int e) const { return collapse_[e]; }

  /// Reserves memory for this number of edges.
  void reserve(std::size_t edges) { collapse_.reserve(edges); }

  /// Determines anew when an edge vanishes. Returns whether it may have length zero at the present
  /// time.
  bool watch(int e) {
    if (collapse_.size() <= static_cast<std::size_t>(e)) collapse_.resize(static_cast<std::size_t>(e) + 1, never);
    collapse_[e] = never;
    const triple q = front_.lines_around(e);
    if (q[0] == q[1] || q[1] == q[2]) return false;
    const interval when = motion_.sharp_time(q);
    if (when.last < present_.first || !(when.first < infinity)) return false;
    if constexpr (!has_sharp_times<Motion>)
      if (!meeting_of(q)) return false;
    collapse_[e] = when;
    if (when.first <= queued_until_ && !queue_collapse(e, q)) collapse_[e] = never;
    return when.first <= present_.last;
  }

  /// Enters all edges into the queue that may vanish until then.
  void queue_until(double time) {
    for (int e = 0; e < static_cast<int>(front_.edges.size()); ++e)
      if (front_.edges[e].alive && collapse_[e].first > queued_until_ && collapse_[e].first <= time && collapse_[e].first < infinity &&
          !queue_collapse(e, front_.lines_around(e)))
        collapse_[e] = never;
    if (time > queued_until_) queued_until_ = time;
  }
  /// Enters a contact.
  void queue(const meeting& m, const candidate& c) { queue_.push(m, c); }

  /// Returns the meeting of three lines if it is still to come.
  std::optional<meeting> coming(const triple& lines) const {
    auto m = meeting_of(lines);
    if (m && k_.compare(*m, now_) != sign::positive) m.reset();
    return m;
  }

  /// Returns whether a candidate's edge and its neighbours, or its vertex, are still there.
  bool is_current(const candidate& c) const {
    if (!front_.edges[c.edge].alive) return false;
    if (c.vertex >= 0) return front_.vertices[c.vertex].alive && front_.vertices[c.vertex].arc == c.arc;
    return collapse_[c.edge].first == c.when.first && collapse_[c.edge].last == c.when.last;
  }
  /// Returns the lines that meet in a candidate, ascending.
  triple lines_of(const candidate& c) const {
    if (c.vertex < 0) return front_.lines_around(c.edge);
    return sorted(triple{front_.line_before(c.vertex), front_.line_after(c.vertex), front_.edges[c.edge].line});
  }

  /// Makes known which candidate is the first; to be called before empty(), first(), first_time()
  /// and take() after every change. `prefetch_around` is told of candidates that will be handled
  /// soon.
  template <class Prefetch>
  void advance(Prefetch prefetch_around) {
    queue_.advance(prefetch_around, [this](const candidate& c) { return is_current(c) ? meeting_of(lines_of(c)) : std::nullopt; });
  }
  /// Returns whether no candidate is in the queue.
  bool empty() const { return queue_.empty(); }
  /// Returns the first candidate in the queue and its meeting.
  const event& first() const { return queue_.top(); }
  /// Returns an interval that contains its time.
  const interval& first_time() const { return queue_.top_time(); }
  /// Takes the first candidate out of the queue and returns it, or nothing where it does not count
  /// any more.
  std::optional<event> take() {
    event next = queue_.pop();
    const auto& [m, c] = next;
    if (!is_current(c) || lines_of(c) != triple(k_.planes(m)) || k_.compare(m, now_) != sign::positive) return std::nullopt;
    return next;
  }
  /// Makes the time of an event the present one.
  void enter(const event& e) {
    now_ = e.when;
    present_ = e.what.when;
  }

  /// Forgets candidates that do not count any more. To be called before many are entered.
  void restart() {
    queue_.restart([this](const candidate& c) { return is_current(c); });
  }
  /// Does the same, and follows a renumbering of the wavefront.
  void renumber(const wavefront::numbering& now) {
    std::vector<interval> collapse;
    collapse.reserve(front_.edges.capacity());
    collapse.resize(front_.edges.size());
    for (std::size_t e = 0; e < now.edges.size(); ++e)
      if (now.edges[e] >= 0) collapse[now.edges[e]] = collapse_[e];
    collapse_ = std::move(collapse);
    queue_.restart([&](candidate& c) {
      c.edge = now.edges[c.edge];
      if (c.vertex >= 0) c.vertex = now.vertices[c.vertex];
      return c.edge >= 0 && (c.arc < 0 || c.vertex >= 0) && is_current(c);
    });
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr interval never = {infinity, infinity};

  bool queue_collapse(int e, const triple& lines) {
    const auto m = coming(lines);
    if (m) queue_.push(*m, {collapse_[e], e});
    return m.has_value();
  }

  // The meeting of three lines, unless it is infinitely late in the limit, which sharp bounds have
  // told before.
  std::optional<meeting> meeting_of(const triple& lines) const {
    auto m = k_.meet(lines);
    if constexpr (limit_kernel<K> && !has_sharp_times<Motion>)
      if (m && k_.is_never(*m)) m.reset();
    return m;
  }

  const K& k_;
  const Motion& motion_;
  const wavefront& front_;
  meeting now_;
  event_queue<K> queue_;
  interval present_{0, 0};
  double queued_until_ = -infinity;  // so far all collapses are in the queue
  std::vector<interval> collapse_;   // by edge
};

}  // namespace osteon::plane
