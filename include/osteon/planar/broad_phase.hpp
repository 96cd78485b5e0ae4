// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The broad phase: which boxes overlap, in a tree of squares that is as fine as the boxes in it are small.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace osteon::planar {

/// A closed set of real numbers.
struct interval {
  double first;
  double last;
};

/// A closed rectangle; empty at first.
struct box {
  std::array<double, 2> low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::array<double, 2> high = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  static box at(const std::array<double, 2>& p) { return {p, p}; }
  void add(const box& b) {
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], b.low[axis]);
      high[axis] = std::max(high[axis], b.high[axis]);
    }
  }
  /// Keeps what lies in b; what does not is moved to its border, so a box never becomes empty.
  void cut(const box& b) {
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::clamp(low[axis], b.low[axis], b.high[axis]);
      high[axis] = std::clamp(high[axis], b.low[axis], b.high[axis]);
    }
  }
  void grow(double by) {
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] -= by;
      high[axis] += by;
    }
  }
  bool meets(const box& b) const { return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1]; }
};

/// Boxes of numbered things in a bucket tree: cells are halved along the axis that cuts fewer boxes (a bintree, Samet 1990). Expected logarithmic
/// time for an insertion; a search visits the leaves that the box meets.
class box_tree {
 public:
  void clear(const box& frame) {
    frame_ = frame;
    nodes_.assign(1, {});
    entries_.clear();
  }

  void insert(int id, const box& b) { insert(0, frame_, 0, id, b); }

  /// Calls body(id) for each box that meets b; for one box perhaps several times.
  template <class Body>
  void search(const box& b, Body body) const {
    search(0, frame_, b, body);
  }

 private:
  static constexpr int bucket = 12;
  static constexpr int deepest = 60;

  struct node {
    int child = -1;  ///< the first of two, or -1
    int first = -1;  ///< entry
    int count = 0;
    short limit = bucket;  ///< with more boxes it is cut
    short axis = 0;
  };
  struct entry {
    box bounds;
    int id;
    int next;
  };

  static double middle(const box& cell, int axis) { return (cell.low[axis] + cell.high[axis]) / 2; }
  static box half(box cell, int axis, int which) {
    (which == 0 ? cell.high : cell.low)[axis] = middle(cell, axis);
    return cell;
  }

  void insert(int at, box cell, int depth, int id, const box& b) {
    while (nodes_[at].child >= 0) {
      const int axis = nodes_[at].axis;
      const double cut = middle(cell, axis);
      const int child = nodes_[at].child;
      ++depth;
      if (b.low[axis] <= cut && b.high[axis] >= cut) insert(child, half(cell, axis, 0), depth, id, b);
      const int which = b.high[axis] < cut ? 0 : 1;
      cell = half(cell, axis, which);
      at = child + which;
    }
    entries_.push_back({b, id, nodes_[at].first});
    nodes_[at].first = static_cast<int>(entries_.size()) - 1;
    if (++nodes_[at].count > nodes_[at].limit && depth < deepest) split(at, cell, depth);
  }

  // Halves a leaf, unless its boxes are so great that many would be in both halves.
  void split(int at, const box& cell, int depth) {
    std::array<int, 2> cuts = {0, 0};
    for (int e = nodes_[at].first; e >= 0; e = entries_[e].next)
      for (int axis = 0; axis < 2; ++axis)
        if (const double cut = middle(cell, axis); entries_[e].bounds.low[axis] <= cut && entries_[e].bounds.high[axis] >= cut) ++cuts[axis];
    const bool wide = cell.high[0] - cell.low[0] >= cell.high[1] - cell.low[1];
    const int axis = cuts[0] != cuts[1] ? (cuts[0] < cuts[1] ? 0 : 1) : (wide ? 0 : 1);
    if (3 * cuts[axis] > nodes_[at].count) {
      nodes_[at].limit = static_cast<short>(std::min(2 * nodes_[at].count, 30000));  // ask again then
      return;
    }
    const int child = static_cast<int>(nodes_.size());
    int e = nodes_[at].first;
    nodes_[at] = {child, -1, 0, 0, static_cast<short>(axis)};
    nodes_.resize(nodes_.size() + 2);
    const double cut = middle(cell, axis);
    while (e >= 0) {
      const int next = entries_[e].next;
      const box bounds = entries_[e].bounds;
      const bool both = bounds.low[axis] <= cut && bounds.high[axis] >= cut;
      node& leaf = nodes_[child + (bounds.high[axis] < cut ? 0 : 1)];
      entries_[e].next = leaf.first;
      leaf.first = e;
      ++leaf.count;
      if (both) {
        entries_.push_back({bounds, entries_[e].id, nodes_[child].first});
        nodes_[child].first = static_cast<int>(entries_.size()) - 1;
        ++nodes_[child].count;
      }
      e = next;
    }
    for (int which = 0; which < 2; ++which)
      if (nodes_[child + which].count > bucket && depth + 1 < deepest) split(child + which, half(cell, axis, which), depth + 1);
  }

  template <class Body>
  void search(int at, box cell, const box& b, Body& body) const {
    while (nodes_[at].child >= 0) {
      const int axis = nodes_[at].axis;
      const double cut = middle(cell, axis);
      const int child = nodes_[at].child;
      if (b.low[axis] <= cut && b.high[axis] >= cut) search(child, half(cell, axis, 0), b, body);
      const int which = b.high[axis] < cut ? 0 : 1;
      cell = half(cell, axis, which);
      at = child + which;
    }
    for (int e = nodes_[at].first; e >= 0; e = entries_[e].next)
      if (entries_[e].bounds.meets(b)) body(entries_[e].id);
  }

  box frame_;
  std::vector<node> nodes_;
  std::vector<entry> entries_;
};

}  // namespace osteon::planar
