// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The order of edges along their lines, for the certificate: needed to find the edge that is
/// cut, never to trust it.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/replayed_front.hpp"

namespace osteon::plane {

/// The edges of a replayed wavefront by line and by their order on it. Lines with one edge, which
/// are most, cost no tree.
template <kernel<2> K>
class line_order {
 public:
  using meeting = typename K::meeting;
  static constexpr int none = -1;

  line_order(const K& k, const boundary& polygon, const replayed_front<K>& front) : k_(k), polygon_(polygon), front_(front), crowd_(in_order{this}) {}
  line_order(const line_order&) = delete;
  line_order& operator=(const line_order&) = delete;

  /// Enters all edges of the start, in the order that the polygon's ranks give them.
  void begin() {
    only_.assign(static_cast<std::size_t>(k_.size()), none);
    std::vector<int> several;
    for (int e = 0; e < static_cast<int>(front_.edges.size()); ++e) {
      if (front_.edges[e].after < 0) continue;
      int& only = only_[front_.edges[e].line];
      if (only >= 0) several.push_back(only);
      if (only != none) several.push_back(e);
      only = only == none ? e : many;
    }
    std::sort(several.begin(), several.end(), [this](int e, int f) { return comes_before(e, f); });
    for (const int e : several) in_crowd(e) = crowd_.insert(crowd_.end(), e);
    events_begun_ = true;
  }

  /// Takes out an edge that is gone.
  void leave(int e) {
    int& only = only_[front_.edges[e].line];
    if (only == e) {
      only = none;
    } else {
      crowd_.erase(in_crowd(e));
      in_crowd(e) = crowd_.end();
    }
  }

  /// Enters the new edge f right after e.
  void enter(int e, int f) {
    int& only = only_[front_.edges[e].line];
    if (only >= 0) in_crowd(e) = crowd_.insert(e);
    only = many;
    const auto after = std::next(in_crowd(e));
    in_crowd(f) = crowd_.insert(after, f);
  }

  /// Returns the edge that may contain the point where line l meets line y, or none.
  int edge_through(line_id l, line_id y, const meeting& m) const {
    if (only_[l] != many) return only_[l];
    const auto e = crowd_.lower_bound(point{l, y, std::addressof(m)});
    return e == crowd_.end() || front_.edges[*e].line != l ? none : *e;
  }

 private:
  struct point {
    line_id line;
    line_id across;
    const meeting* when;
  };
  struct in_order {
    using is_transparent = void;
    const line_order* order;
    bool operator()(int e, int f) const { return order->comes_before(e, f); }
    bool operator()(int e, const point& p) const { return order->ends_before(e, p); }
  };
  using crowd = std::multiset<int, in_order>;
  static constexpr int many = -2;

  bool comes_before(int e, int f) const {
    const auto& a = front_.edges[e];
    const auto& b = front_.edges[f];
    if (a.line != b.line) return a.line < b.line;
    if (!events_begun_) return polygon_.rank[e] < polygon_.rank[f];
    return e != f && is_beyond(k_, a.line, front_.edges[a.after].line, front_.edges[b.before].line, front_.now) != sign::negative;
  }
  bool ends_before(int e, const point& p) const {
    const auto& a = front_.edges[e];
    if (a.line != p.line) return a.line < p.line;
    return is_beyond(k_, a.line, front_.edges[a.after].line, p.across, *p.when) == sign::positive;
  }

  typename crowd::iterator& in_crowd(int e) {
    if (in_crowd_.size() < front_.edges.size()) in_crowd_.resize(front_.edges.size(), crowd_.end());
    return in_crowd_[e];
  }

  const K& k_;
  const boundary& polygon_;
  const replayed_front<K>& front_;
  bool events_begun_ = false;
  std::vector<int> only_;  // by line: its only edge, or none, or many
  crowd crowd_;            // the edges of all other lines
  std::vector<typename crowd::iterator> in_crowd_;
};

}  // namespace osteon::plane
