// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offset polygons: the wavefront at any moment, read off the raw skeleton. No coordinates:
/// places are asked for as in the kernel.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// A moment t, and exact answers about the lines then.
template <class I>
concept moment_of_lines = requires(const I& at, line_id a, line_id b, line_id c, const triple& q) {
  // Sign of det(n_a, n_b).
  { at.orientation(a, b) } -> std::same_as<sign>;
  // Sign of L(t) and of S for lines in this order; L(t) = D - t S. Zero: the lines share a point.
  { at.level(a, b, c) } -> std::same_as<sign>;
  { at.closing(a, b, c) } -> std::same_as<sign>;
  // Whether three lines with S not zero meet at t or before.
  { at.is_past(q) } -> std::same_as<bool>;
  // Whether the direction of edges on the line is in [0, pi).
  { at.upwards(a) } -> std::same_as<bool>;
};

/// Closed rings of moving vertices, the interior on their left.
struct wavefront_rings {
  /// A vertex of the wavefront at one time.
  struct corner {
    int arc;   ///< of the raw skeleton, whose vertex is here
    int face;  ///< on whose line the edge that starts here lies
  };
  /// A closed ring of the wavefront at one time.
  struct ring {
    int first;  ///< of its corners
    int size;
    bool hole;  ///< clockwise
    int part;   ///< rings of one connected piece of the interior share it; 0 .. parts - 1
  };
  std::vector<corner> corners;
  std::vector<ring> rings;  ///< those of a part together, its outer ring first
  int parts = 0;
};

namespace detail {

template <moment_of_lines I>
class wavefront_reader {
 public:
  wavefront_reader(const skeleton& raw, const std::vector<int>& line_of_edge, const I& at) : raw_(raw), line_(line_of_edge), at_(at) {}

  wavefront_rings run() {
    find_living();
    link();
    collect();
    join_parts();
    return std::move(result_);
  }

 private:
  static constexpr int none = -1;

  line_id line_before(int arc) const { return line_[raw_.arcs[arc].faces[0]]; }
  line_id line_after(int arc) const { return line_[raw_.arcs[arc].faces[1]]; }

  // Nodes are in order of time, so those that are past come first. The lines of a late one may meet
  // always; it follows one that is not late at the same moment.
  void find_living() {
    const auto is_past = [&](int n) {
      while (n > 0 && raw_.nodes[n].zero_length) --n;
      return raw_.nodes[n].vertex >= 0 || at_.is_past(raw_.nodes[n].lines);
    };
    int end = static_cast<int>(raw_.nodes.size());
    while (past_ < end) {
      const int middle = past_ + (end - past_) / 2;
      is_past(middle) ? past_ = middle + 1 : end = middle;
    }
    for (std::size_t a = 0; a < raw_.arcs.size(); ++a)
      if (is_alive(raw_.arcs[a])) living_.push_back(static_cast<int>(a));
  }
  bool is_alive(const skeleton::arc& a) const { return a.source < past_ && (a.target < 0 || a.target >= past_); }

  // Along each face edges start and end in turns.
  void link() {
    next_.assign(raw_.arcs.size(), none);
    std::vector<int> first(raw_.faces.size() + 1, 0);  // of the ends on each face
    for (const int a : living_)
      for (const int f : raw_.arcs[a].faces) ++first[f + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<edge_end> ends(2 * living_.size());
    std::vector<int> fill(first.begin(), first.end() - 1);
    for (const int a : living_)
      for (const bool starts : {false, true}) ends[fill[raw_.arcs[a].faces[starts ? 1 : 0]]++] = {a, starts};
    for (std::size_t f = 0; f < raw_.faces.size(); ++f) link_face(ends.data() + first[f], ends.data() + first[f + 1]);
  }

  struct edge_end {
    int arc;
    bool starts;
  };

  void link_face(edge_end* from, edge_end* to) {
    if (to - from > 2) {
      std::sort(from, to, [&](const edge_end& a, const edge_end& b) { return comes_first(a, b); });
      // What is at one place for ever, where the polygon touches itself, in turns.
      for (edge_end* e = from; e != to; ++e) {
        const bool starts = (e - from) % 2 == 0;
        edge_end* x = e;
        while (x != to && x->starts != starts && !comes_first(*e, *x)) ++x;
        if (x != to && x != e && !comes_first(*e, *x)) std::swap(*e, *x);
      }
    } else if (to - from == 2 && !from->starts) {
      std::swap(from[0], from[1]);
    }
    for (edge_end* e = from; e != to; e += 2) {
      if (e + 1 == to || !e[0].starts || e[1].starts) throw invariant_error("internal invariant violated: along a face edges start and end in turns");
      next_[e[0].arc] = e[1].arc;
    }
  }

  // Whether one end of an edge comes before another on their line now or, at one place, right
  // after.
  bool comes_first(const edge_end& a, const edge_end& b) const {
    const line_id along = a.starts ? line_after(a.arc) : line_before(a.arc);
    const line_id x = a.starts ? line_before(a.arc) : line_after(a.arc);
    const line_id y = b.starts ? line_before(b.arc) : line_after(b.arc);
    if (x == y) return false;
    // The second end against x: L / det(along, y); it lies behind the first one if the line leads
    // into x there: det(along, x) < 0.
    sign s = at_.level(along, y, x);
    if (s == sign::zero) s = -at_.closing(along, y, x);
    return s * at_.orientation(along, y) * at_.orientation(along, x) == sign::negative;
  }

  // Rings without edges of no length.
  void collect() {
    ring_of_.assign(raw_.arcs.size(), none);
    std::vector<bool> seen(raw_.arcs.size(), false);
    for (const int a : living_) {
      if (seen[a]) continue;
      const int first = static_cast<int>(result_.corners.size());
      int turn = 0;
      for (int v = a; !seen[v]; v = next_[v]) {
        seen[v] = true;
        if (next_[v] < 0) throw invariant_error("internal invariant violated: the wavefront consists of rings");
        turn += turns_at(v);
        if (at_.level(line_before(v), line_after(v), line_after(next_[v])) != sign::zero) result_.corners.push_back({v, raw_.arcs[v].faces[1]});
      }
      drop_straight(first);
      const int size = static_cast<int>(result_.corners.size()) - first;
      if (size < 3) {
        result_.corners.resize(first);
        continue;
      }
      for (int i = first; i < first + size; ++i) ring_of_[result_.corners[i].arc] = static_cast<int>(result_.rings.size());
      result_.rings.push_back({first, size, turn < 0, 0});
    }
  }

  // Edges of one line in a row are one.
  void drop_straight(int first) {
    auto& c = result_.corners;
    const auto begin = c.begin() + first;
    if (begin == c.end()) return;
    int before = line_[c.back().face];
    const auto end = std::remove_if(begin, c.end(), [&](const wavefront_rings::corner& x) {
      const int line = line_[x.face];
      return std::exchange(before, line) == line;
    });
    c.erase(end, c.end());
  }

  // +1 or -1 where the direction passes that of the x-axis to the left or to the right: in all +1
  // for an outer ring and -1 for a hole.
  int turns_at(int v) const {
    const line_id a = line_before(v);
    const line_id b = line_after(v);
    const sign s = at_.orientation(a, b);
    if (s == sign::zero) throw unsupported_error("a vertex of the wavefront lies between parallel lines");
    const bool up_a = at_.upwards(a);
    const bool up_b = at_.upwards(b);
    if (s == sign::positive) return !up_a && up_b ? 1 : 0;
    return up_a && !up_b ? -1 : 0;
  }

  // What is left of the skeleton connects the rings of a part.
  void join_parts() {
    const std::size_t rings = result_.rings.size();
    disjoint_sets connected(raw_.nodes.size() - past_ + rings);
    const int offset = static_cast<int>(rings) - past_;  // nodes come behind the rings
    for (std::size_t a = 0; a < raw_.arcs.size(); ++a) {
      const auto& arc = raw_.arcs[a];
      if (arc.target >= 0 && arc.target < past_) continue;
      int x = none;
      if (arc.source >= past_)
        x = arc.source + offset;
      else if (ring_of_[a] >= 0)
        x = ring_of_[a];
      if (x >= 0 && arc.target >= 0) connected.unite(x, arc.target + offset);
    }
    std::vector<int> part(connected.size(), none);
    for (std::size_t r = 0; r < rings; ++r) {
      int& p = part[connected.find(static_cast<int>(r))];
      if (p < 0) p = result_.parts++;
      result_.rings[r].part = p;
    }
    std::stable_sort(result_.rings.begin(), result_.rings.end(),
                     [](const auto& r, const auto& s) { return std::pair(r.part, r.hole) < std::pair(s.part, s.hole); });
  }

  const skeleton& raw_;
  const std::vector<int>& line_;
  const I& at_;
  int past_ = 0;
  std::vector<int> living_;  // arcs
  std::vector<int> next_;    // the arc at the other end of the edge that starts at an arc
  std::vector<int> ring_of_;
  wavefront_rings result_;
};

}  // namespace detail

/// Returns the wavefront at a moment. At the moment of an event it is what comes after it, in the
/// limit: edges without length are left out, nothing is left when all is over. `line_of_edge` is
/// that of the outline. Parts are told apart by the rest of the skeleton; where it is unbounded
/// (held for ever, or outside of a polygon), rings that it does not join have parts of their own.
/// Throws invariant_error if the skeleton is none of these lines. Cost: linear in the skeleton, and
/// sorting where a face has several edges; exact questions only about what is alive.
template <moment_of_lines I>
wavefront_rings wavefront_at(const skeleton& raw, const std::vector<int>& line_of_edge, const I& at) {
  return detail::wavefront_reader<I>(raw, line_of_edge, at).run();
}

}  // namespace osteon::plane
