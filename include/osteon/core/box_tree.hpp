// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The broad phase: which boxes overlap, in a tree of squares that is as fine as the boxes in
/// it are small.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "osteon/core/prefetch.hpp"

namespace osteon {

/// A closed set of real numbers.
struct interval {
  double first;
  double last;
};

/// A closed rectangle; empty at first.
struct box {
  std::array<double, 2> low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::array<double, 2> high = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  /// Returns the box that holds one point.
  static box at(const std::array<double, 2>& p) { return {p, p}; }
  /// Grows the box until it contains b.
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
  /// Moves every side outwards.
  void grow(double by) {
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] -= by;
      high[axis] += by;
    }
  }
  /// Returns whether the boxes share a point.
  bool meets(const box& b) const { return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1]; }
};

/// Boxes of numbered things in a tree of grids: a cell with too many boxes is cut into so many
/// parts, along one axis or both, that few boxes are in each and few in several. Expected constant
/// time for an insertion where boxes are spread evenly; where they crowd, a level more for each
/// cut, at most 64; a search visits the leaves that the box meets. Boxes are rounded outwards to a
/// grid of 2^32 by 2^32, so that a leaf's fit into a few cache lines.
class box_tree {
 public:
  /// Empties the tree. `frame`: where boxes will be, about; others are moved to its border.
  void clear(const box& frame) {
    for (int axis = 0; axis < 2; ++axis) {
      low_[axis] = frame.low[axis];
      const double size = frame.high[axis] - frame.low[axis];
      scale_[axis] = size > 0 ? 0x1p32 / size : 0;
    }
    nodes_.assign(1, {});
    blocks_.clear();
    free_ = -1;
  }

  /// Adds one of many boxes; build() must follow before a search.
  void add(int id, const box& b) { add(0, rounded(b, id)); }
  /// Makes a tree of what was added. Cost: a few passes over it.
  void build() {
    if (nodes_[0].count > nodes_[0].limit) split(0, whole);
  }

  /// Inserts a box into a tree that is built.
  void insert(int id, const box& b) { insert(0, whole, rounded(b, id)); }

  /// Calls body(id) for each box that meets b; for one box perhaps several times.
  template <class Body>
  void search(const box& b, Body body) const {
    search(0, whole, rounded(b, -1), body);
  }

  /// Tells the processor that what is around this box will be asked for soon. To be called for many
  /// boxes, then for all of them with `deep`: only so do they wait together.
  void prefetch(const box& b, bool deep) const {
    if (nodes_.empty()) return;
    const entry e = rounded(box::at({(b.low[0] + b.high[0]) / 2, (b.low[1] + b.high[1]) / 2}), -1);
    int at = 0;
    cell c = whole;
    do {
      if (nodes_[at].child < 0) break;
      each_part(at, c, e, [&](int child, const cell& part) {
        at = child;
        c = part;
      });
    } while (deep);
    if (!deep)
      osteon::prefetch(nodes_[at]);
    else if (nodes_[at].first >= 0)
      osteon::prefetch(blocks_[nodes_[at].first]);
  }

 private:
  struct entry {
    std::array<std::uint32_t, 2> low;
    std::array<std::uint32_t, 2> high;
    int id;

    bool meets(const entry& e) const { return low[0] <= e.high[0] && e.low[0] <= high[0] && low[1] <= e.high[1] && e.low[1] <= high[1]; }
  };
  static constexpr int room = 6;
  struct block {
    int count;
    int next;
    std::array<entry, room> entries;
  };
  struct node {
    int child = -1;             ///< the first of its parts, or -1
    int first = -1;             ///< block
    int count = 0;              ///< of boxes
    int limit = 6 * room;       ///< with more it is cut
    std::array<int, 2> bits{};  ///< of the numbers of parts on each axis
  };
  // Numbers from low to low + 2^bits on each axis.
  struct cell {
    std::array<std::uint32_t, 2> low;
    std::array<int, 2> bits;
  };
  static constexpr cell whole = {{0, 0}, {32, 32}};

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

  // Calls body(part, its cell) for the parts of a cell that a box meets.
  template <class Body>
  void each_part(int at, const cell& c, const entry& e, Body body) const {
    const node& n = nodes_[at];
    std::array<std::uint32_t, 2> from{};
    std::array<std::uint32_t, 2> to{};
    std::array<int, 2> shift{};
    for (int axis = 0; axis < 2; ++axis) {
      shift[axis] = c.bits[axis] - n.bits[axis];
      const std::uint32_t last = c.low[axis] + static_cast<std::uint32_t>((std::uint64_t{1} << c.bits[axis]) - 1);
      from[axis] = static_cast<std::uint32_t>(std::uint64_t{std::clamp(e.low[axis], c.low[axis], last) - c.low[axis]} >> shift[axis]);
      to[axis] = static_cast<std::uint32_t>(std::uint64_t{std::clamp(e.high[axis], c.low[axis], last) - c.low[axis]} >> shift[axis]);
    }
    const int child = n.child;
    const int row = n.bits[1];
    for (std::uint32_t i = from[0]; i <= to[0]; ++i)
      for (std::uint32_t j = from[1]; j <= to[1]; ++j)
        body(child + static_cast<int>(i << row | j), cell{{c.low[0] + static_cast<std::uint32_t>(std::uint64_t{i} << shift[0]),
                                                           c.low[1] + static_cast<std::uint32_t>(std::uint64_t{j} << shift[1])},
                                                          shift});
  }

  void insert(int at, const cell& c, const entry& e) {
    if (nodes_[at].child >= 0) {
      each_part(at, c, e, [&](int child, const cell& part) { insert(child, part, e); });
      return;
    }
    add(at, e);
    if (nodes_[at].count > nodes_[at].limit) split(at, c);
  }

  void add(int at, const entry& e) {
    int first = nodes_[at].first;
    if (first < 0 || blocks_[first].count == room) {
      int fresh = free_;
      if (fresh >= 0) {
        free_ = blocks_[fresh].next;
      } else {
        fresh = static_cast<int>(blocks_.size());
        blocks_.emplace_back();
      }
      blocks_[fresh].count = 0;
      blocks_[fresh].next = first;
      first = nodes_[at].first = fresh;
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

  // Into how many parts a leaf is to be cut: 2^bits on each axis; none where its boxes are so great
  // that many would be in several.
  std::array<int, 2> parts(int at, const cell& c) const {
    const double count = nodes_[at].count;
    std::array<double, 2> sides{};
    double area = 0;
    visit(at, [&](const entry& e) {
      std::array<double, 2> side{};  // in the cell, which is 1 by 1
      for (int axis = 0; axis < 2; ++axis) {
        const double size = std::ldexp(1, c.bits[axis]);
        const double low = std::max(0.0, static_cast<double>(e.low[axis]) - c.low[axis]);
        const double high = std::min(size, static_cast<double>(e.high[axis]) + 1 - c.low[axis]);
        side[axis] = (high - low) / size;
        sides[axis] += side[axis];
      }
      area += side[0] * side[1];
    });
    // How many parts their boxes meet, all together, where a side is cut into so many; the expected
    // number for boxes at random.
    const auto met = [&](double m, double n) { return count + sides[0] * (m - 1) + sides[1] * (n - 1) + area * (m - 1) * (n - 1); };
    std::array<int, 2> bits{};
    while (std::ldexp(2 * room, bits[0] + bits[1]) < count && bits[0] + bits[1] < 20) {
      const double m = std::ldexp(1, bits[0]);
      const double n = std::ldexp(1, bits[1]);
      const double first = bits[0] < c.bits[0] ? met(2 * m, n) : 4 * count;
      const double second = bits[1] < c.bits[1] ? met(m, 2 * n) : 4 * count;
      if (!(std::min(first, second) < 1.25 * count)) break;
      ++bits[first <= second ? 0 : 1];
    }
    return bits;
  }

  // Cuts a leaf.
  void split(int at, const cell& c) {
    const std::array<int, 2> bits = parts(at, c);
    if (bits[0] + bits[1] == 0) {
      nodes_[at].limit = 2 * nodes_[at].count;  // ask again then
      return;
    }
    std::vector<entry> all;
    all.reserve(nodes_[at].count);
    visit(at, [&](const entry& e) { all.push_back(e); });
    int last = nodes_[at].first;
    while (blocks_[last].next >= 0) last = blocks_[last].next;
    blocks_[last].next = free_;
    free_ = nodes_[at].first;
    const int child = static_cast<int>(nodes_.size());
    const int size = 1 << (bits[0] + bits[1]);
    nodes_[at].child = child;
    nodes_[at].first = -1;
    nodes_[at].bits = bits;
    nodes_.resize(nodes_.size() + size);
    for (const entry& e : all) each_part(at, c, e, [&](int part, const cell&) { add(part, e); });
    std::vector<entry>().swap(all);
    for (int i = 0; i < size; ++i)
      if (nodes_[child + i].count > nodes_[child + i].limit) {
        cell part = c;
        for (int axis = 0; axis < 2; ++axis) part.bits[axis] -= bits[axis];
        part.low[0] += static_cast<std::uint32_t>(static_cast<std::uint64_t>(i >> bits[1]) << part.bits[0]);
        part.low[1] += static_cast<std::uint32_t>(static_cast<std::uint64_t>(i & ((1 << bits[1]) - 1)) << part.bits[1]);
        split(child + i, part);
      }
  }

  template <class Body>
  void search(int at, const cell& c, const entry& b, Body& body) const {
    if (nodes_[at].child >= 0)
      each_part(at, c, b, [&](int child, const cell& part) { search(child, part, b, body); });
    else
      visit(at, [&](const entry& e) {
        if (e.meets(b)) body(e.id);
      });
  }

  std::array<double, 2> low_{};
  std::array<double, 2> scale_{};
  std::vector<node> nodes_;
  std::vector<block> blocks_;
  int free_ = -1;  // the first of the blocks that are not used
};

}  // namespace osteon
