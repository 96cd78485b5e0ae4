// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The search for crossings and touchings among closed chains of edges, and which ring lies inside which: one plane sweep
/// (Shamos and Hoey, Geometric intersection problems, FOCS 1976, section 4), exact, stopped by the first crossing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/sign.hpp"

namespace osteon::plane {

/// Points with exact predicates that doubles answer where they can.
template <class Int>
class exact_points {
 public:
  exact_points() = default;
  explicit exact_points(std::vector<std::array<Int, 2>> points) : points_(std::move(points)), rough_(points_.size()) {
    unsigned shift = 0;  // after which doubles can hold products of two coordinates
    for (const auto& p : points_)
      for (const Int& x : p)
        while (std::abs(static_cast<double>(Int(x >> shift))) > 0x1p480) shift += 256;
    double most = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        rough_[i][axis] = shift == 0 ? static_cast<double>(points_[i][axis]) : static_cast<double>(Int(points_[i][axis] >> shift));
        most = std::max(most, std::abs(rough_[i][axis]));
      }
    exact_ = shift == 0 && most <= 0x1p52;  // then differences of coordinates are exact, too
    // A coordinate is wrong by 2^-52 most at most (it was truncated, and shifted only where most >= 2^224), a difference by three times that.
    error_ = exact_ ? 0 : 0x1p-50 * most;
  }

  std::size_t size() const { return points_.size(); }
  const std::array<Int, 2>& operator[](int i) const { return points_[i]; }
  const std::array<double, 2>& rough(int i) const { return rough_[i]; }  ///< monotone in the true coordinates
  bool exact() const { return exact_; }                                  ///< rough coordinates are the true ones, at most 2^52

  /// Order by x, then by y; constant time.
  sign compare(int a, int b) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = rough_[a][axis];
      const double y = rough_[b][axis];
      if (x != y) return x < y ? sign::negative : sign::positive;
      if (!exact_ && points_[a][axis] != points_[b][axis]) return points_[a][axis] < points_[b][axis] ? sign::negative : sign::positive;
    }
    return sign::zero;
  }

  /// Positive where c lies left of a -> b, zero on their line; constant time but for the length of the integers. Error bound after
  /// Shewchuk, Adaptive precision floating-point arithmetic, section 4.1.
  sign turn(int a, int b, int c) const {
    const double bx = rough_[b][0] - rough_[a][0];
    const double by = rough_[b][1] - rough_[a][1];
    const double cx = rough_[c][0] - rough_[a][0];
    const double cy = rough_[c][1] - rough_[a][1];
    const double l = bx * cy;
    const double r = by * cx;
    const double det = l - r;
    // Rounding of two products and of their difference: 3 * 2^-53 of the products, and a little.
    const double bound =
        0x1p-51 * (std::abs(l) + std::abs(r)) + error_ * (std::abs(bx) + std::abs(by) + std::abs(cx) + std::abs(cy)) + 2 * error_ * error_;
    if (std::abs(det) > bound) return det > 0 ? sign::positive : sign::negative;
    // Integers up to 2^53 are products without rounding.
    if (exact_ && std::abs(l) <= 0x1p53 && std::abs(r) <= 0x1p53) return det > 0 ? sign::positive : det < 0 ? sign::negative : sign::zero;
    const auto& p = points_[a];
    const Int left = (points_[b][0] - p[0]) * (points_[c][1] - p[1]);
    const Int right = (points_[b][1] - p[1]) * (points_[c][0] - p[0]);
    return left > right ? sign::positive : left < right ? sign::negative : sign::zero;
  }

  /// Moves point `from` to number `to` and forgets those from `size` on.
  void move(int from, int to) {
    if (from == to) return;
    points_[to] = std::move(points_[from]);
    rough_[to] = rough_[from];
  }
  void shrink(std::size_t size) {
    points_.resize(size);
    rough_.resize(size);
  }

 private:
  std::vector<std::array<Int, 2>> points_;
  std::vector<std::array<double, 2>> rough_;
  bool exact_ = true;
  double error_ = 0;
};

/// Where two chains meet as they must not. Edge i starts at vertex i.
struct bad_meeting {
  enum class kind : std::uint8_t {
    crossing,  ///< edges a and b cross
    overlap,   ///< edges a and b share more than a point
    at_point   ///< the chains through the point of vertices a and b cross there; where b is an edge that runs through: `b_runs_through`
  };
  kind what;
  int a;
  int b;
  bool b_runs_through = false;
};

/// What the sweep has found, apart from bad meetings.
struct meetings {
  /// A direction in which a chain leaves a touching point.
  struct ray {
    int vertex;    ///< at the point, or the edge that runs through it
    bool through;  ///< whether it is such an edge
    bool out;      ///< in the direction of the chain, or against it
  };
  std::vector<ray> rays;                ///< of all touching points, counter-clockwise around each
  std::vector<std::size_t> first_rays;  ///< of each touching point in `rays`, and their number
  std::vector<int> touching_vertices;   ///< one at each touching point
  std::vector<int> parents;             ///< by ring: the innermost ring around it, or -1
  std::vector<bool> counterclockwise;   ///< by ring
};

/// Searches closed chains without edges of length zero and without turns by 180 degrees: vertex i is point i, and edge i leads from it to
/// point next[i]. n log n time; linear memory, some 100 bytes a vertex.
template <class Int>
class crossing_search {
 public:
  crossing_search(const exact_points<Int>& points, std::span<const int> next, std::span<const int> ring, int rings)
      : points_(points), next_(next), ring_(ring), previous_(next.size()), rank_(next.size()), where_(next.size()), status_(order{this}) {
    for (int i = 0; i < static_cast<int>(next.size()); ++i) previous_[next[i]] = i;
    found_.parents.assign(static_cast<std::size_t>(rings), -1);
    found_.counterclockwise.assign(static_cast<std::size_t>(rings), false);
    seen_.assign(static_cast<std::size_t>(rings), false);
    found_.first_rays.push_back(0);
  }
  crossing_search(const crossing_search&) = delete;
  crossing_search& operator=(const crossing_search&) = delete;

  /// The first bad meeting from left to right, or none: then found() holds.
  std::optional<bad_meeting> run() {
    sort_points();
    for (std::size_t i = 0; i < sorted_.size() && !bad_;) {
      std::size_t j = i + 1;
      while (j < sorted_.size() && rank_[sorted_[j]] == rank_[sorted_[i]]) ++j;
      if (j - i > 1 || !run_on(sorted_[i])) meet(std::span(sorted_).subspan(i, j - i));
      i = j;
    }
    return bad_;
  }

  meetings& found() { return found_; }

  /// Order of vertices by place, equal for equal places.
  int rank(int vertex) const { return rank_[vertex]; }

 private:
  // The edges that the sweep line meets, from below. An edge may take the place of another that it continues.
  struct node {
    mutable int edge;
  };
  struct at {
    int vertex;
  };
  struct order {
    using is_transparent = void;
    const crossing_search* s;
    bool operator()(const node& a, const node& b) const { return s->below(a.edge, b.edge); }
    bool operator()(const node& a, const at& p) const { return s->side(a.edge, p.vertex) == sign::positive; }
    bool operator()(const at& p, const node& a) const { return s->side(a.edge, p.vertex) == sign::negative; }
  };
  using status = std::set<node, order>;
  using iterator = typename status::iterator;

  void sort_points() {
    struct item {
      double x, y;
      int vertex;
    };
    std::vector<item> items;
    items.reserve(next_.size());
    for (int i = 0; i < static_cast<int>(next_.size()); ++i) items.push_back({points_.rough(i)[0], points_.rough(i)[1], i});
    std::sort(items.begin(), items.end(), [this](const item& a, const item& b) {
      if (points_.exact()) return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.vertex < b.vertex;
      const sign s = a.x != b.x ? (a.x < b.x ? sign::negative : sign::positive) : points_.compare(a.vertex, b.vertex);
      return s == sign::zero ? a.vertex < b.vertex : s == sign::negative;
    });
    sorted_.reserve(items.size());
    int rank = 0;
    for (const auto& i : items) {
      if (!sorted_.empty() && points_.compare(sorted_.back(), i.vertex) != sign::zero) ++rank;
      rank_[i.vertex] = rank;
      sorted_.push_back(i.vertex);
    }
  }

  bool forward(int edge) const { return rank_[edge] < rank_[next_[edge]]; }  // to the right, or straight up
  int left(int edge) const { return forward(edge) ? edge : next_[edge]; }
  int right(int edge) const { return forward(edge) ? next_[edge] : edge; }
  sign side(int edge, int vertex) const { return points_.turn(left(edge), right(edge), vertex); }  // positive: the vertex lies above

  // For edges that do not cross and have abscissas in common.
  bool below(int a, int b) const {
    const int p = left(a);
    const int q = left(b);
    if (rank_[p] >= rank_[q]) {
      const sign s = points_.turn(q, right(b), p);
      return s == sign::zero ? points_.turn(p, right(a), right(b)) == sign::positive : s == sign::negative;
    }
    const sign s = points_.turn(p, right(a), q);
    return s == sign::zero ? points_.turn(q, right(a), right(b)) == sign::positive : s == sign::positive;
  }

  // Two neighbours, one above the other: whether they cross later. That an end of one lies on the other is found when the sweep comes there.
  void check(int lower, int upper) {
    const int p = right(lower);
    const int q = right(upper);
    if (rank_[p] == rank_[q]) return;
    const bool cross = rank_[p] < rank_[q] ? side(upper, p) == sign::positive : side(lower, q) == sign::negative;
    if (cross && !bad_) bad_ = {bad_meeting::kind::crossing, lower, upper};
  }
  void check(iterator lower, iterator upper) {
    if (upper != status_.end()) check(lower->edge, upper->edge);
  }

  // The usual point: one edge ends, one starts, and no other is there. False: nothing done.
  bool run_on(int v) {
    const int in = previous_[v];
    const bool in_ends = rank_[in] < rank_[v];
    if (in_ends == (rank_[next_[v]] < rank_[v])) return false;
    const iterator it = where_[in_ends ? in : v];
    const iterator above = std::next(it);
    const bool lowest = it == status_.begin();
    if (!lowest && side(std::prev(it)->edge, v) == sign::zero) return false;
    if (above != status_.end() && side(above->edge, v) == sign::zero) return false;
    const int started = in_ends ? v : in;
    it->edge = started;
    where_[started] = it;
    if (!lowest) check(std::prev(it), it);
    check(it, above);
    return true;
  }

  // Any point, with all vertices there.
  void meet(std::span<const int> vertices) {
    const int v = vertices[0];
    const int rank = rank_[v];
    // The edges that end here or run through, from below.
    iterator first;
    iterator last;
    int ended = -1;
    for (const int u : vertices) {
      if (rank_[previous_[u]] < rank) ended = previous_[u];
      if (rank_[next_[u]] < rank) ended = u;
    }
    if (ended >= 0) {
      first = last = where_[ended];
      while (first != status_.begin() && side(std::prev(first)->edge, v) == sign::zero) --first;
    } else {
      first = last = status_.lower_bound(at{v});
    }
    while (last != status_.end() && side(last->edge, v) == sign::zero) ++last;

    int through = -1;
    arriving_.clear();
    leaving_.clear();
    for (iterator it = first; it != last; ++it) {
      arriving_.push_back(it->edge);
      if (rank_[right(it->edge)] == rank) continue;
      if (through >= 0) {
        bad_ = {bad_meeting::kind::crossing, through, it->edge};
        return;
      }
      through = it->edge;
    }
    for (const int u : vertices) {
      if (rank_[previous_[u]] > rank) leaving_.push_back(previous_[u]);
      if (rank_[next_[u]] > rank) leaving_.push_back(u);
    }
    if (through >= 0) leaving_.push_back(through);
    std::sort(leaving_.begin(), leaving_.end(), [&](int a, int b) { return points_.turn(v, right(a), right(b)) == sign::positive; });
    for (std::size_t i = 1; i < leaving_.size(); ++i)
      if (points_.turn(v, right(leaving_[i - 1]), right(leaving_[i])) == sign::zero) {
        bad_ = {bad_meeting::kind::overlap, leaving_[i - 1], leaving_[i]};
        return;
      }
    if (vertices.size() > 1 || through >= 0) {
      touch(v, through);
      if (bad_) return;
    }
    place_rings(first);

    for (iterator it = first; it != last;) it = it->edge == through ? std::next(it) : status_.erase(it);
    iterator hint = through >= 0 ? where_[through] : last;
    for (const int e : leaving_) {
      if (e == through)
        hint = last;
      else
        where_[e] = status_.insert(hint, node{e});
    }
    const iterator above = last;
    const iterator lowest = leaving_.empty() ? last : where_[leaving_.front()];
    if (lowest != status_.begin()) check(std::prev(lowest), lowest);
    if (!leaving_.empty()) check(where_[leaving_.back()], above);
  }

  // Chains that meet here and do not cross lie around the point like brackets.
  void touch(int v, int through) {
    const int rank = rank_[v];
    const auto add = [&](int edge, bool leaves) {
      const bool out = leaves == forward(edge);
      if (edge == through)
        found_.rays.push_back({edge, true, out});
      else
        found_.rays.push_back({rank_[edge] == rank ? edge : next_[edge], false, out});
    };
    for (const int e : leaving_) add(e, true);
    for (auto e = arriving_.rbegin(); e != arriving_.rend(); ++e) add(*e, false);
    open_.clear();
    for (std::size_t i = found_.first_rays.back(); i < found_.rays.size(); ++i) {
      const auto& r = found_.rays[i];
      const std::pair<int, bool> chain = {r.vertex, r.through};
      if (!open_.empty() && open_.back() == chain)
        open_.pop_back();
      else
        open_.push_back(chain);
    }
    found_.first_rays.push_back(found_.rays.size());
    found_.touching_vertices.push_back(v);
    if (open_.empty()) return;
    auto a = open_[0];
    auto b = open_[1];
    if (a.second) std::swap(a, b);
    bad_ = {bad_meeting::kind::at_point, a.first, b.first, b.second};
  }

  // Rings that begin here lie inside the ring below them, or beside it.
  void place_rings(iterator first) {
    int under = first == status_.begin() ? -1 : std::prev(first)->edge;
    for (const int e : leaving_) {
      const int r = ring_[e];
      if (!seen_[r]) {
        seen_[r] = true;
        found_.counterclockwise[r] = forward(e);
        if (under >= 0) {
          const int q = ring_[under];
          found_.parents[r] = forward(under) == found_.counterclockwise[q] ? q : found_.parents[q];
        }
      }
      under = e;
    }
  }

  const exact_points<Int>& points_;
  std::span<const int> next_;
  std::span<const int> ring_;
  std::vector<int> previous_;
  std::vector<int> rank_;
  std::vector<int> sorted_;
  std::vector<iterator> where_;  // by edge
  status status_;
  std::vector<bool> seen_;  // by ring
  std::vector<int> arriving_, leaving_;
  std::vector<std::pair<int, bool>> open_;
  meetings found_;
  std::optional<bad_meeting> bad_;
};

}  // namespace osteon::plane
