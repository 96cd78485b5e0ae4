// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How the border of a facet turns in a tree, and which edges follow each other on it: two of the
/// rules that the trees of split_table.hpp obey (docs/theory/vertex-splitting.md).
///
/// Second rule: a facet's border turns by less than half a turn in all.
///
/// Third rule, for unit speeds: the convex edges of a facet follow each other. Why: at time 1 the
/// surface passes each line normal to facet f's plane at moments t(h), h the height over that
/// plane, whose slope is 1 in the cell of f and less in all others. So it enters that cell once,
/// and the facet meets each ray from the foot of the vertex in one interval. Every other plane has
/// the foot on its outer side. Hence the border runs round the foot one way along convex edges and
/// the other way along reflex ones, and runs back only beyond the facet's own wedge, at the ends.
/// (With weights it holds for facets whose n / speed is a corner of the convex hull of all.)

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"

namespace osteon {

/// What part of a facet's border has done, read from one of its ends.
struct border_progress {
  int turns;  ///< how often it passed its first direction
  /// 0: its edges are reflex; 1: with convex ones behind them; 2: with reflex ones behind these
  int phase;

  friend bool operator==(const border_progress&, const border_progress&) = default;
  friend bool operator<(const border_progress& x, const border_progress& y) { return std::tie(x.turns, x.phase) < std::tie(y.turns, y.phase); }
};
/// The progress of the two facets of an edge.
using progresses = std::array<border_progress, 2>;

/// The trees below the edge between two facets, as far as their borders matter.
struct borders_below {
  bool convex;  ///< the edge
  progresses borders;
};

/// The turns of all facets of one corner. Facets that share a plane may join; their borders are not
/// followed.
template <kernel<3> K>
class facet_turns {
 public:
  /// *Complexity* quadratic in the degree.
  explicit facet_turns(const corner_signs<K>& signs) : s_(signs), k_(signs.degree()) {
    for (int f = 0; f < k_; ++f) {
      int first = 0;
      while (!same_plane(first, f)) ++first;
      first_of_.push_back(first);
      shares_.push_back(first < f);
      if (first < f) shares_[first] = true;
    }
  }

  /// Returns whether two facets lie in one plane.
  bool same_plane(int f, int g) const { return s_.plane(f) == s_.plane(g); }
  /// Returns the first facet in the plane of f.
  int first_of(int f) const { return first_of_[f]; }

  /// Returns the progress of the facets i and i + 1 where only their common ray is below.
  progresses along_ray(int i, bool convex) const { return {{{0, next_phase(i, 0, convex)}, {0, next_phase(i + 1, 0, convex)}}}; }

  /// Returns whether two parts of facet m's border, each read from its own end, make one that obeys
  /// the rules. `between`: see wraps.
  bool meet(int m, int between, const border_progress& left, const border_progress& right) const {
    return phases_meet(left.phase, right.phase) && left.turns + right.turns + between == whole_turns(m);
  }

  /// Returns the progress of i and j where triangle (i,m,j) joins what is below its sides, or
  /// nothing where that breaks a rule: that of the nine corners, or one of the two about borders.
  /// `convex`: the edge (i,j).
  std::optional<progresses> join(int i, int m, int j, bool convex, const borders_below& left, const borders_below& right) const {
    const bool up = s_.orientation(i, m, j) == sign::positive;
    const int inside = (left.convex == up ? 1 : 0) + (right.convex == up ? 1 : 0) + (convex == up ? 1 : 0);
    if (up != (inside == 0 || inside == 3)) return std::nullopt;
    const progresses result = {{{left.borders[0].turns + wraps(i, m, j, left.convex, convex), next_phase(i, left.borders[0].phase, convex)},
                                {right.borders[1].turns + wraps(j, i, m, convex, right.convex), next_phase(j, right.borders[1].phase, convex)}}};
    if (result[0].phase < 0 || result[1].phase < 0) return std::nullopt;
    if (!meet(m, wraps(m, j, i, right.convex, left.convex), left.borders[1], right.borders[0])) return std::nullopt;
    return result;
  }

  /// Returns what the wraps of facet f must add up to.
  int whole_turns(int f) const {
    if (shares_[f]) return 0;
    const int last = (f + k_ - 1) % k_;
    return direction(f, last, s_.ray_is_convex(last)) == sign::negative ? -1 : 0;
  }

 private:
  // The phase of facet f's border after one more edge; -1 where that breaks the third rule.
  int next_phase(int f, int phase, bool convex) const {
    if (!s_.has_unit_speeds() || shares_[f]) return 0;
    if (convex) return phase == 2 ? -1 : 1;
    return phase == 0 ? 0 : 2;
  }

  // Whether the third rule holds for a border of which two parts have been read, each from its own
  // end.
  static bool phases_meet(int x, int y) { return x == 0 || y == 0 || (x == 1 && y == 1); }

  // Directions on the border of facet f, which runs counter-clockwise from its edge with f + 1 to
  // the one with f - 1: along n_f x n_x where the edge with x is convex, against it where it is
  // reflex. The side on which it lies of the first one; that one's own is zero.
  sign direction(int f, int x, bool convex) const {
    const int first = (f + 1) % k_;
    if (x == first) return sign::zero;
    const sign s = s_.orientation(f, first, x);
    return convex == s_.ray_is_convex(f) ? s : -s;
  }

  // How often the turn (of less than half a turn) from the edge with x to that with y passes the
  // first direction: -1, 0 or 1.
  int wraps(int f, int x, int y, bool x_convex, bool y_convex) const {
    if (shares_[f]) return 0;
    const sign turn = x_convex == y_convex ? s_.orientation(f, x, y) : -s_.orientation(f, x, y);
    const bool low_x = direction(f, x, x_convex) == sign::negative;
    const bool low_y = direction(f, y, y_convex) == sign::negative;
    if (low_x == low_y) return 0;
    return turn == sign::positive ? (low_x ? 1 : 0) : (low_y ? -1 : 0);
  }

  const corner_signs<K>& s_;
  int k_;
  std::vector<bool> shares_;   // by facet: its plane with another one
  std::vector<int> first_of_;  // by facet
};

}  // namespace osteon
