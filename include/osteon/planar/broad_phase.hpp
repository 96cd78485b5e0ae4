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

#include "osteon/prefetch.hpp"

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

/// How great the boxes of a tree are going to be, from some of them.
struct box_sizes {
  double count = 0;
  std::array<double, 2> sides{};
  double area = 0;

  void add(const box& b) {
    ++count;
    for (int axis = 0; axis < 2; ++axis) sides[axis] += b.high[axis] - b.low[axis];
    area += (b.high[0] - b.low[0]) * (b.high[1] - b.low[1]);
  }
  /// How many cells of this size their boxes meet, all together.
  double cells(const std::array<double, 2>& cell) const { return count + sides[0] / cell[0] + sides[1] / cell[1] + area / (cell[0] * cell[1]); }
};

/// Boxes of numbered things in a grid of bucket trees: cells are halved along the axis that cuts fewer boxes (a bintree, Samet 1990). Expected
/// logarithmic time for an insertion, constant where boxes are spread evenly; a search visits the leaves that the box meets. Boxes are rounded outwards
/// to a grid of 2^32 by 2^32, so that a leaf's fit into a few cache lines.
class box_tree {
 public:
  /// Empties the tree. `frame`: where boxes will be, about; others are moved to its border. `expected`: how many boxes to come, of the sizes of `sample`.
  void clear(const box& frame, std::size_t expected, const box_sizes& sample) {
    std::array<double, 2> cell{};
    for (int axis = 0; axis < 2; ++axis) {
      low_[axis] = frame.low[axis];
      cell[axis] = frame.high[axis] - frame.low[axis];
      scale_[axis] = cell[axis] > 0 ? 0x1p32 / cell[axis] : 0;
    }
    bits_ = {0, 0};
    while (std::ldexp(8, bits_[0] + bits_[1]) < static_cast<double>(expected)) {
      std::array<double, 2> halved_first = {cell[0] / 2, cell[1]};
      std::array<double, 2> halved_second = {cell[0], cell[1] / 2};
      const int axis = sample.cells(halved_first) <= sample.cells(halved_second) ? 0 : 1;
      cell[axis] /= 2;
      if (!(sample.cells(cell) < 2 * sample.count) || bits_[axis] == 16) break;
      ++bits_[axis];
    }
    nodes_.assign(std::size_t{1} << (bits_[0] + bits_[1]), {});
    blocks_.clear();
    nodes_.reserve(nodes_.size() + expected / 4);
    blocks_.reserve(expected / 6);
  }

  void insert(int id, const box& b) {
    const entry e = rounded(b, id);
    each_root(e, [&](int root, const cell& c) { insert(root, c, e); });
  }

  /// Calls body(id) for each box that meets b; for one box perhaps several times.
  template <class Body>
  void search(const box& b, Body body) const {
    const entry e = rounded(b, -1);
    each_root(e, [&](int root, const cell& c) { search(root, c, e, body); });
  }

  /// The neighbourhood of this box will be asked for soon.
  void prefetch(const box& b) const {
    if (nodes_.empty()) return;
    const entry e = rounded(box::at({(b.low[0] + b.high[0]) / 2, (b.low[1] + b.high[1]) / 2}), -1);
    each_root(e, [&](int root, const cell&) { osteon::prefetch(&nodes_[root]); });
  }

 private:
  struct entry {
    std::array<std::uint32_t, 2> low;
    std::array<std::uint32_t, 2> high;
    int id;

    bool meets(const entry& e) const { return low[0] <= e.high[0] && e.low[0] <= high[0] && low[1] <= e.high[1] && e.low[1] <= high[1]; }
  };
  static constexpr int bucket = 12;
  struct block {
    std::array<entry, bucket> entries;
    int count;
    int next;
  };
  struct node {
    int child = -1;      ///< the first of two, or -1
    int first = -1;      ///< block
    int count = 0;       ///< of boxes
    int limit = bucket;  ///< with more it is cut
    int axis = 0;
  };
  // Numbers from low to low + 2^bits on each axis.
  struct cell {
    std::array<std::uint32_t, 2> low;
    std::array<int, 2> bits;

    std::uint32_t middle(int axis) const { return low[axis] + (std::uint32_t{1} << (bits[axis] - 1)); }
    cell half(int axis, int which) const {
      cell c = *this;
      if (which == 1) c.low[axis] = middle(axis);
      --c.bits[axis];
      return c;
    }
  };
  // Calls body(node, cell) for the cells of the grid that a box meets.
  template <class Body>
  void each_root(const entry& e, Body body) const {
    const std::array<int, 2> shift = {32 - bits_[0], 32 - bits_[1]};
    const auto index = [&](std::uint32_t x, int axis) { return static_cast<std::uint32_t>(std::uint64_t{x} >> shift[axis]); };
    for (std::uint32_t i = index(e.low[0], 0); i <= index(e.high[0], 0); ++i)
      for (std::uint32_t j = index(e.low[1], 1); j <= index(e.high[1], 1); ++j)
        body(static_cast<int>(i << bits_[1] | j),
             cell{{static_cast<std::uint32_t>(std::uint64_t{i} << shift[0]), static_cast<std::uint32_t>(std::uint64_t{j} << shift[1])}, shift});
  }

  entry rounded(const box& b, int id) const {
    constexpr double most = 4294967295.0;
    entry e{{}, {}, id};
    for (int axis = 0; axis < 2; ++axis) {
      // The scale's own rounding is the same for all boxes; that of the products is monotone.
      e.low[axis] = static_cast<std::uint32_t>(std::clamp((b.low[axis] - low_[axis]) * scale_[axis], 0.0, most));
      e.high[axis] = static_cast<std::uint32_t>(std::clamp((b.high[axis] - low_[axis]) * scale_[axis], 0.0, most));
    }
    return e;
  }

  void insert(int at, cell c, const entry& e) {
    while (nodes_[at].child >= 0) {
      const int axis = nodes_[at].axis;
      const int child = nodes_[at].child;
      const std::uint32_t cut = c.middle(axis);
      if (e.low[axis] < cut && e.high[axis] >= cut) insert(child, c.half(axis, 0), e);
      const int which = e.high[axis] < cut ? 0 : 1;
      c = c.half(axis, which);
      at = child + which;
    }
    add(at, e);
    if (nodes_[at].count > nodes_[at].limit) split(at, c);
  }

  void add(int at, const entry& e) {
    int first = nodes_[at].first;
    if (first < 0 || blocks_[first].count == bucket) {
      blocks_.emplace_back();
      blocks_.back().count = 0;
      blocks_.back().next = first;
      first = nodes_[at].first = static_cast<int>(blocks_.size()) - 1;
    }
    blocks_[first].entries[blocks_[first].count++] = e;
    ++nodes_[at].count;
  }

  // Calls body for each box of a leaf.
  template <class Body>
  void visit(int at, Body body) const {
    for (int b = nodes_[at].first; b >= 0; b = blocks_[b].next)
      for (int i = 0; i < blocks_[b].count; ++i) body(blocks_[b].entries[i]);
  }

  // Halves a leaf, unless its boxes are so great that many would be in both halves.
  void split(int at, const cell& c) {
    std::array<int, 2> cuts = {0, 0};
    for (int axis = 0; axis < 2; ++axis) {
      if (c.bits[axis] == 0) {
        cuts[axis] = nodes_[at].count;
        continue;
      }
      const std::uint32_t cut = c.middle(axis);
      visit(at, [&](const entry& e) { cuts[axis] += e.low[axis] < cut && e.high[axis] >= cut ? 1 : 0; });
    }
    const int axis = cuts[0] != cuts[1] ? (cuts[0] < cuts[1] ? 0 : 1) : (c.bits[0] >= c.bits[1] ? 0 : 1);
    if (3 * cuts[axis] > nodes_[at].count) {
      nodes_[at].limit = 2 * nodes_[at].count;  // ask again then
      return;
    }
    std::vector<entry> all;
    all.reserve(nodes_[at].count);
    visit(at, [&](const entry& e) { all.push_back(e); });
    const int child = static_cast<int>(nodes_.size());
    const int freed = nodes_[at].first;
    nodes_[at] = {child, -1, 0, 0, axis};
    nodes_.resize(nodes_.size() + 2);
    blocks_[freed].count = 0;  // the first half goes on in the newest block
    blocks_[freed].next = -1;
    nodes_[child].first = freed;
    const std::uint32_t cut = c.middle(axis);
    for (const entry& e : all) {
      if (e.low[axis] < cut) add(child, e);
      if (e.high[axis] >= cut) add(child + 1, e);
    }
    for (int which = 0; which < 2; ++which)
      if (nodes_[child + which].count > bucket) split(child + which, c.half(axis, which));
  }

  template <class Body>
  void search(int at, cell c, const entry& b, Body& body) const {
    while (nodes_[at].child >= 0) {
      const int axis = nodes_[at].axis;
      const int child = nodes_[at].child;
      const std::uint32_t cut = c.middle(axis);
      if (b.low[axis] < cut && b.high[axis] >= cut) search(child, c.half(axis, 0), b, body);
      const int which = b.high[axis] < cut ? 0 : 1;
      c = c.half(axis, which);
      at = child + which;
    }
    visit(at, [&](const entry& e) {
      if (e.meets(b)) body(e.id);
    });
  }

  std::array<double, 2> low_{};
  std::array<double, 2> scale_{};
  std::array<int, 2> bits_{};  // of the numbers of cells
  std::vector<node> nodes_;    // the grid's first
  std::vector<block> blocks_;
};

}  // namespace osteon::planar
