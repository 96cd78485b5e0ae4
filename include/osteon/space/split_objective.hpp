// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a split of a vertex is worth, as split_search adds it up: a `value` for the best tree of a part, made from the values of smaller parts; a
/// `sum` of values, single vertices and single edges; an order of sums, positive where the first is better.

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"

namespace osteon {

/// All trees are worth the same.
struct any_tree {
  using value = int;
  using sum = int;

  value none() const { return 0; }
  value with_edge(value, bool) const { return 0; }
  value with_vertex(value, value, const std::array<int, 3>&) const { return 0; }
  value joined(value, value) const { return 0; }
  void add(sum&, value) const {}
  void add_edge(sum&, bool) const {}
  void add_vertex(sum&, const std::array<int, 3>&) const {}
  sign compare(sum, sum) const { return sign::zero; }
};

/// Worth of a tree: the number of edges of one kind that begin at the vertex.
class edge_count {
 public:
  using value = int;
  using sum = int;

  explicit edge_count(bool convex) : convex_(convex) {}

  value none() const { return 0; }
  value with_edge(value v, bool convex) const { return v + (convex == convex_ ? 1 : 0); }
  value with_vertex(value left, value right, const std::array<int, 3>&) const { return left + right; }
  value joined(value left, value right) const { return left + right; }
  void add(sum& s, value v) const { s += v; }
  void add_edge(sum& s, bool convex) const { s += convex == convex_ ? 1 : 0; }
  void add_vertex(sum&, const std::array<int, 3>&) const {}
  /// Positive where the first is better.
  sign compare(const sum& x, const sum& y) const { return sign_of(x - y); }

 private:
  bool convex_;
};

/// Worth of a tree: the offset's volume, greatest or least. Lists of vertices that share their tails.
template <kernel<3> K>
class offset_volume {
 public:
  struct part {
    const part* left;
    const part* right;
    triple vertex;
  };
  using value = const part*;
  using sum = std::vector<triple>;

  offset_volume(const corner_signs<K>& signs, bool greatest) : signs_(signs), greatest_(greatest) {}

  value none() const { return nullptr; }
  value with_edge(value v, bool) const { return v; }
  value with_vertex(value left, value right, const std::array<int, 3>& facets) { return &parts_.emplace_back(part{left, right, planes(facets)}); }
  value joined(value left, value right) { return &parts_.emplace_back(part{left, right, nothing}); }
  void add(sum& s, value v) const {
    std::vector<value> waiting = {v};
    while (!waiting.empty()) {
      const value p = waiting.back();
      waiting.pop_back();
      if (p == nullptr) continue;
      if (p->vertex != nothing) s.push_back(p->vertex);
      waiting.push_back(p->left);
      waiting.push_back(p->right);
    }
  }
  void add_edge(sum&, bool) const {}
  void add_vertex(sum& s, const std::array<int, 3>& facets) const { s.push_back(planes(facets)); }
  sign compare(sum x, sum y) const {
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    sum only_x;  // common terms cancel
    sum only_y;
    std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(only_x));
    std::set_difference(y.begin(), y.end(), x.begin(), x.end(), std::back_inserter(only_y));
    if (only_x.empty() && only_y.empty()) return sign::zero;
    const sign s = signs_.kernel().compare_volume(only_x, only_y);
    return greatest_ ? s : -s;
  }

 private:
  static constexpr triple nothing = {-1, -1, -1};

  triple planes(const std::array<int, 3>& f) const { return {signs_.plane(f[0]), signs_.plane(f[1]), signs_.plane(f[2])}; }

  const corner_signs<K>& signs_;
  bool greatest_;
  std::deque<part> parts_;
};

}  // namespace osteon
