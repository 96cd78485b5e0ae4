// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Sets of numbers that grow together.

#include <cstddef>
#include <numeric>
#include <vector>

namespace osteon {

/// A partition of 0 .. size - 1; at first each number is a set of its own. Each set has a
/// representative, one of its members.
/// *Source* Tarjan, van Leeuwen: Worst-case analysis of set union algorithms. J. ACM 31 (1984);
/// path halving.
class disjoint_sets {
 public:
  explicit disjoint_sets(std::size_t size = 0) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::size_t size() const { return parent_.size(); }

  /// Adds a number, a set of its own, and returns it.
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }

  /// Returns the representative of the set of i.
  /// *Complexity* amortised O(log size).
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Makes one set of the two; its representative is that of b. Returns whether they were two.
  bool unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace osteon
