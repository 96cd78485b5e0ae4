// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a split of a vertex is chosen for: the objectives of split_table.hpp and split_search.hpp.

#include <algorithm>
#include <array>
#include <concepts>
#include <deque>
#include <iterator>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"

namespace osteon {

/// An objective adds up what trees are good for. A `value` belongs to the best tree of a part and
/// is made from the values of smaller parts; a `sum` adds values, single vertices and single edges.
/// Both may point into the objective, which must outlive them.
template <class O>
concept split_objective = requires(O& o, const O& fixed, typename O::value v, typename O::sum& s, bool convex, const std::array<int, 3>& facets) {
  // The value of nothing.
  { fixed.none() } -> std::same_as<typename O::value>;
  // The value of a part with one more edge.
  { fixed.with_edge(v, convex) } -> std::same_as<typename O::value>;
  // The value of two parts with a vertex of three facets between them.
  { o.with_vertex(v, v, facets) } -> std::same_as<typename O::value>;
  // The value of two parts.
  { o.joined(v, v) } -> std::same_as<typename O::value>;
  // Adds to a sum.
  fixed.add(s, v);
  fixed.add_edge(s, convex);
  fixed.add_vertex(s, facets);
  // The order of sums: positive where the first is better.
  { fixed.compare(s, s) } -> std::same_as<sign>;
};

/// The objective for which all trees are equally good.
struct any_tree {
  using value = int;
  using sum = int;

  /// The operations of the concept split_objective.
  ///@{
  value none() const { return 0; }
  value with_edge(value, bool) const { return 0; }
  value with_vertex(value, value, const std::array<int, 3>&) const { return 0; }
  value joined(value, value) const { return 0; }
  void add(sum&, value) const {}
  void add_edge(sum&, bool) const {}
  void add_vertex(sum&, const std::array<int, 3>&) const {}
  sign compare(sum, sum) const { return sign::zero; }
  ///@}
};

/// The objective: most edges of one kind that begin at the vertex.
class edge_count {
 public:
  using value = int;
  using sum = int;

  /// Counts convex or reflex edges.
  explicit edge_count(bool convex) : convex_(convex) {}

  /// The operations of the concept split_objective.
  ///@{
  value none() const { return 0; }
  value with_edge(value v, bool convex) const { return v + (convex == convex_ ? 1 : 0); }
  value with_vertex(value left, value right, const std::array<int, 3>&) const { return left + right; }
  value joined(value left, value right) const { return left + right; }
  void add(sum& s, value v) const { s += v; }
  void add_edge(sum& s, bool convex) const { s += convex == convex_ ? 1 : 0; }
  void add_vertex(sum&, const std::array<int, 3>&) const {}
  sign compare(const sum& x, const sum& y) const { return sign_of(x - y); }
  ///@}

 private:
  bool convex_;
};

/// The objective: greatest or least volume of the offset. A value is a list of vertices; lists
/// share their tails.
template <kernel<3> K>
class offset_volume {
 public:
  /// A vertex, or nothing, with what is below it.
  struct part {
    const part* left;
    const part* right;
    triple vertex;
  };
  using value = const part*;
  using sum = std::vector<triple>;

  /// `signs`: of the corner; they must outlive the objective.
  offset_volume(const corner_signs<K>& signs, bool greatest) : signs_(signs), greatest_(greatest) {}

  /// The operations of the concept split_objective.
  ///@{
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
  ///@}

 private:
  static constexpr triple nothing = {-1, -1, -1};

  triple planes(const std::array<int, 3>& f) const { return {signs_.plane(f[0]), signs_.plane(f[1]), signs_.plane(f[2])}; }

  const corner_signs<K>& signs_;
  bool greatest_;
  std::deque<part> parts_;
};

}  // namespace osteon
