// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The search for crossings and touchings among closed chains of edges, and which ring lies inside
/// which: one plane sweep (Shamos and Hoey, Geometric intersection problems, FOCS 1976, section 4),
/// exact, stopped by the first crossing.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/exact_points.hpp"

namespace osteon::plane {

/// Where two chains meet although they must not. Edge i starts at vertex i.
struct bad_contact {
  /// What the two chains do.
  enum class kind : std::uint8_t {
    crossing,  ///< edges a and b cross
    overlap,   ///< edges a and b share more than a point
    /// the chains through the point of vertices a and b cross there; where b is an edge that runs
    /// through: `b_runs_through`
    at_point
  };
  kind what;
  int a;
  int b;
  bool b_runs_through = false;
};

/// How rings lie that do not cross: where they touch, their nesting and their orientation.
struct ring_relations {
  /// A direction in which a chain leaves a touching point.
  struct ray {
    int vertex;    ///< at the point, or the edge that runs through it
    bool through;  ///< whether it is such an edge
    bool out;      ///< in the direction of the chain, or against it
  };
  std::vector<ray> rays;  ///< of all touching points, counter-clockwise around each
  /// by touching point: its first one in `rays`; and their number
  std::vector<std::size_t> first_rays;
  std::vector<int> touching_vertices;  ///< one at each touching point
  std::vector<int> parents;            ///< by ring: the innermost ring around it, or -1
  std::vector<bool> counterclockwise;  ///< by ring

  /// Returns the rays of a touching point.
  std::span<ray> rays_of(std::size_t t) { return std::span(rays).subspan(first_rays[t], first_rays[t + 1] - first_rays[t]); }
  /// Does the same for constant relations.
  std::span<const ray> rays_of(std::size_t t) const { return std::span(rays).subspan(first_rays[t], first_rays[t + 1] - first_rays[t]); }
};

/// A sweep over closed chains without edges of length zero and without turns by 180 degrees: vertex
/// i is point i, and edge i leads from it to vertex next[i].
/// *Complexity* O(n log n); linear memory, some 100 bytes a vertex.
template <class Int>
class plane_sweep {
 public:
  /// `ring`: by vertex, the number of its ring among `rings`.
  plane_sweep(const exact_points<Int>& points, std::span<const int> next, std::span<const int> ring, int rings)
      : points_(points), next_(next), ring_(ring), previous_(next.size()), rank_(next.size()), where_(next.size()), status_(order{this}) {
    for (int i = 0; i < static_cast<int>(next.size()); ++i) previous_[next[i]] = i;
    found_.parents.assign(static_cast<std::size_t>(rings), -1);
    found_.counterclockwise.assign(static_cast<std::size_t>(rings), false);
    seen_.assign(static_cast<std::size_t>(rings), false);
    found_.first_rays.push_back(0);
  }
  plane_sweep(const plane_sweep&) = delete;
  plane_sweep& operator=(const plane_sweep&) = delete;

  /// Returns the first bad contact from left to right, or nothing: then found() holds.
  std::optional<bad_contact> run() {
    sort_points();
    for (std::size_t i = 0; i < sorted_.size() && !bad_;) {
      std::size_t j = i + 1;
      while (j < sorted_.size() && rank_[sorted_[j]] == rank_[sorted_[i]]) ++j;
      if (j - i > 1 || !continue_edge(sorted_[i])) pass(std::span(sorted_).subspan(i, j - i));
      i = j;
    }
    return bad_;
  }

  /// Returns how the rings lie; complete after a run without bad contacts.
  ring_relations& found() { return found_; }

  /// Returns a vertex's number in the order of points by x, then by y; vertices at one point have
  /// one number.
  int rank(int vertex) const { return rank_[vertex]; }

 private:
  // The edges that the sweep line meets, from below. An edge may take the place of another that it
  // continues.
  struct node {
    mutable int edge;
  };
  struct at {
    int vertex;
  };
  struct order {
    using is_transparent = void;
    const plane_sweep* s;
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

  // to the right, or straight up
  bool forward(int edge) const { return rank_[edge] < rank_[next_[edge]]; }
  int left(int edge) const { return forward(edge) ? edge : next_[edge]; }
  int right(int edge) const { return forward(edge) ? next_[edge] : edge; }
  // positive: the vertex lies above
  sign side(int edge, int vertex) const { return points_.turn(left(edge), right(edge), vertex); }

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

  // Two neighbours, one above the other: whether they cross later. That an end of one lies on the
  // other is found when the sweep comes there.
  void check(int lower, int upper) {
    const int p = right(lower);
    const int q = right(upper);
    if (rank_[p] == rank_[q]) return;
    const bool cross = rank_[p] < rank_[q] ? side(upper, p) == sign::positive : side(lower, q) == sign::negative;
    if (cross && !bad_) bad_ = {bad_contact::kind::crossing, lower, upper};
  }
  void check(iterator lower, iterator upper) {
    if (upper != status_.end()) check(lower->edge, upper->edge);
  }

  // The usual point: one edge ends, one starts, and no other is there. False: nothing done.
  bool continue_edge(int v) {
    const int in = previous_[v];
    const bool in_ends = rank_[in] < rank_[v];
    if (in_ends == (rank_[next_[v]] < rank_[v])) return false;
    const auto it = where_[in_ends ? in : v];
    const auto above = std::next(it);
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
  void pass(std::span<const int> vertices) {
    const auto [first, last] = edges_at(vertices);
    const int through = list_arriving(first, last, rank_[vertices[0]]);
    if (!bad_) list_leaving(vertices, through);
    if (!bad_ && (vertices.size() > 1 || through >= 0)) touch(vertices[0], through);
    if (bad_) return;
    place_rings(first);
    replace(first, last, through);
  }

  // The edges that end at a point or run through it, from below.
  std::pair<iterator, iterator> edges_at(std::span<const int> vertices) {
    const int v = vertices[0];
    int ended = -1;
    for (const int u : vertices) {
      if (rank_[previous_[u]] < rank_[v]) ended = previous_[u];
      if (rank_[next_[u]] < rank_[v]) ended = u;
    }
    auto first = ended >= 0 ? where_[ended] : status_.lower_bound(at{v});
    auto last = first;
    if (ended >= 0)
      while (first != status_.begin() && side(std::prev(first)->edge, v) == sign::zero) --first;
    while (last != status_.end() && side(last->edge, v) == sign::zero) ++last;
    return {first, last};
  }

  // Lists these edges in arriving_ and returns the one that runs through, or -1. Two of them cross.
  int list_arriving(iterator first, iterator last, int rank) {
    int through = -1;
    arriving_.clear();
    for (auto it = first; it != last && !bad_; ++it) {
      arriving_.push_back(it->edge);
      if (rank_[right(it->edge)] == rank) continue;
      if (through >= 0) bad_ = {bad_contact::kind::crossing, through, it->edge};
      through = it->edge;
    }
    return through;
  }

  // Lists the edges that start at a point or run through it in leaving_, from below. Those in one
  // direction overlap.
  void list_leaving(std::span<const int> vertices, int through) {
    const int v = vertices[0];
    leaving_.clear();
    for (const int u : vertices) {
      if (rank_[previous_[u]] > rank_[v]) leaving_.push_back(previous_[u]);
      if (rank_[next_[u]] > rank_[v]) leaving_.push_back(u);
    }
    if (through >= 0) leaving_.push_back(through);
    std::sort(leaving_.begin(), leaving_.end(), [&](int a, int b) { return points_.turn(v, right(a), right(b)) == sign::positive; });
    for (std::size_t i = 1; i < leaving_.size() && !bad_; ++i)
      if (points_.turn(v, right(leaving_[i - 1]), right(leaving_[i])) == sign::zero)
        bad_ = {bad_contact::kind::overlap, leaving_[i - 1], leaving_[i]};
  }

  // Chains that meet at a point and do not cross lie around it like brackets.
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
    std::reverse(arriving_.begin(), arriving_.end());
    for (const int e : arriving_) add(e, false);
    open_.clear();
    for (const auto& r : std::span(found_.rays).subspan(found_.first_rays.back())) {
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
    bad_ = {bad_contact::kind::at_point, a.first, b.first, b.second};
  }

  // Rings that begin at a point lie inside the ring below them, or beside it.
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

  // Puts the edges that leave a point in the place of those that arrive there.
  void replace(iterator first, iterator last, int through) {
    for (auto it = first; it != last;) it = it->edge == through ? std::next(it) : status_.erase(it);
    auto hint = through >= 0 ? where_[through] : last;
    for (const int e : leaving_) {
      if (e == through)
        hint = last;
      else
        where_[e] = status_.insert(hint, node{e});
    }
    const auto lowest = leaving_.empty() ? last : where_[leaving_.front()];
    if (lowest != status_.begin()) check(std::prev(lowest), lowest);
    if (!leaving_.empty()) check(where_[leaving_.back()], last);
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
  ring_relations found_;
  std::optional<bad_contact> bad_;
};

}  // namespace osteon::plane
