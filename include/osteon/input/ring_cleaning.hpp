// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From rings of points to chains of vertices: repeated points and straight corners disappear,
/// spikes are refused.

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/input/exact_points.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/rings.hpp"

namespace osteon::plane {

/// Closed chains of vertices: at first those of rings, in order, each at the point with its number.
/// Edge v starts at vertex v.
struct ring_chains {
  std::vector<int> input;  ///< by vertex: the point of the input
  /// by vertex: the point of the input whose weight the edge has that starts here
  std::vector<int> weight;
  std::vector<int> ring;  ///< by vertex
  std::vector<int> next;  ///< by vertex: where the edge leads that starts here
  /// by vertex: where the edge starts that leads here; empty before rings are oriented
  std::vector<int> previous;
  std::vector<int> first;   ///< by ring: its first vertex
  int size_of_rings = 0;    ///< how many vertices belong to rings; those behind them cut edges
  std::vector<int> cut_at;  ///< by vertex that cuts an edge: a vertex of a ring at the same point

  /// Returns the number of vertices.
  int size() const { return static_cast<int>(next.size()); }
  /// Returns the number of rings.
  int rings() const { return static_cast<int>(first.size()); }
  /// Returns the number behind that of the last vertex of a ring.
  int end(int r) const { return r + 1 < rings() ? first[r + 1] : size_of_rings; }
  /// Returns the point at which a vertex lies.
  int point_of(int v) const { return v < size_of_rings ? v : cut_at[v - size_of_rings]; }
};

/// Makes the chains. Of points that repeat their predecessors the edges of length zero disappear;
/// points on a straight side between edges of equal weight disappear.
template <class Int>
class ring_cleaning {
 public:
  /// `points`: those of the input. `weights`: by point, of the edge that starts there; empty: all
  /// equal.
  ring_cleaning(exact_points<Int>& points, const std::vector<Int>& weights, const ring_names<Int>& names)
      : points_(points), weights_(weights), names_(names) {}

  /// Returns the chains, and renumbers the points by the vertices that are left.
  /// *Throws* input_error for rings with fewer than three different points (short_ring), without
  /// area (zero_area), and with a corner at which they turn back (spike).
  ring_chains run() {
    for (int r = 0; r < names_.rings(); ++r) {
      remove_repeated(r);
      keep_corners(r);
    }
    auto& next = chains_.next;
    const int n = static_cast<int>(chains_.input.size());
    for (int i = 0; i < n; ++i) points_.move(chains_.input[i], i);
    points_.shrink(static_cast<std::size_t>(n));
    chains_.size_of_rings = n;
    next.resize(static_cast<std::size_t>(n));
    std::iota(next.begin(), next.end(), 1);
    for (int r = 0; r < chains_.rings(); ++r) next[chains_.end(r) - 1] = chains_.first[r];
    return std::move(chains_);
  }

  /// Returns what was removed, one sentence each.
  std::vector<std::string> repairs() const {
    std::vector<std::string> result;
    if (repeated_.count > 0)
      result.push_back(counted(repeated_.count, "point that repeats its predecessor was", "points that repeat their predecessors were") +
                       " removed, the first: " + names_.name(repeated_.first));
    if (straight_.count > 0)
      result.push_back(counted(straight_.count, "point on a straight side was", "points on straight sides were") +
                       " removed, the first: " + names_.name(straight_.first));
    return result;
  }

 private:
  struct corner {
    int point;
    int weight;
  };
  struct removed {
    std::size_t count = 0;
    int first = -1;

    void add(int point) {
      if (count++ == 0) first = point;
    }
  };

  // The different points of a ring, each with the weight of the edge to the next.
  void remove_repeated(int r) {
    const int begin = names_.first(r);
    ring_.clear();
    for (int i = begin; i < names_.first(r + 1); ++i) {
      if (ring_.empty() || points_.compare(ring_.back().point, i) != sign::zero) {
        ring_.push_back({i, i});
        continue;
      }
      ring_.back().weight = i;  // the edge of length zero disappears, its successor stays
      repeated_.add(i);
    }
    for (; ring_.size() > 1 && points_.compare(ring_.back().point, begin) == sign::zero; ring_.pop_back()) repeated_.add(ring_.back().point);
    if (ring_.size() < 3)
      names_.refuse(input_fault::short_ring, begin, ": the ring has fewer than three different points", "give at least three, or delete the ring");
  }

  void keep_corners(int r) {
    int spike = -1;
    bool flat = true;
    chains_.first.push_back(static_cast<int>(chains_.input.size()));
    for (std::size_t i = 0, n = ring_.size(); i < n; ++i) {
      const corner& before = ring_[(i + n - 1) % n];
      const corner& v = ring_[i];
      const int after = ring_[(i + 1) % n].point;
      if (points_.turn(before.point, v.point, after) != sign::zero) {
        flat = false;
      } else if (points_.compare(before.point, v.point) != points_.compare(v.point, after)) {
        if (spike < 0) spike = v.point;
      } else if (weights_.empty() || weights_[before.weight] == weights_[v.weight]) {
        straight_.add(v.point);
        continue;
      }
      chains_.input.push_back(v.point);
      chains_.weight.push_back(v.weight);
      chains_.ring.push_back(r);
    }
    if (flat) names_.refuse(input_fault::zero_area, names_.first(r), ": all points of the ring lie on one line", "delete the ring");
    if (spike >= 0) names_.refuse(input_fault::spike, spike, ": the boundary turns back on itself here", "delete this point");
  }

  exact_points<Int>& points_;
  const std::vector<Int>& weights_;
  const ring_names<Int>& names_;
  std::vector<corner> ring_;  // the one being cleaned
  ring_chains chains_;
  removed repeated_;
  removed straight_;
};

}  // namespace osteon::plane
