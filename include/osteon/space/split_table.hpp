// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The trees that a vertex of any degree may split into, by dynamic programming over intervals,
/// without listing them (docs/theory/vertex-splitting.md).
///
/// A tree is a triangulation of the polygon of facets 0 .. k-1. The part of it on the far side of
/// the diagonal (i,j) from the side (0,k-1) matters to the rest only through its apex m, the bend
/// of the edge (i,j), and what the borders of the facets i and j have done in it. Three rules are
/// local to triangles and fans: that of the nine corners, and two about borders (facet_turns.hpp).
/// Trees that obey them are the candidates; a candidate is valid unless two edges of one facet
/// cross.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/facet_turns.hpp"
#include "osteon/space/split_objective.hpp"

namespace osteon {

/// All candidates of one corner. Where facets share a plane (thesis 3.3.3), two candidates may be
/// one forest. `Objective`: an objective of split_objective.hpp. `Count` counts candidates: an
/// integer of any size for exact counts, double where their number does not matter.
/// *Complexity* k^4 / 24 signs, each asked once, and about k^4 steps; memory k^3.
template <kernel<3> K, split_objective Objective, class Count = double>
class split_table {
 public:
  using value = typename Objective::value;
  using sum = typename Objective::sum;

  /// What a task has above it, where that is no facet.
  static constexpr int root = -1;
  static constexpr int joint = -2;
  /// The end of an edge that runs on for ever.
  static constexpr int nowhere = -1;

  /// What is common to trees below a side of a triangle: with the edge across that side, which has
  /// both ends then, or, at a joint, without.
  struct summary : borders_below {
    int end;  ///< of a joint's
    value best;
    Count count;
  };
  /// To choose a tree below (i,j).
  struct task {
    int i, j;
    /// the third facet of the triangle above, where the edge (i,j) ends there; root or joint
    int above;
    int level;  ///< at which the triangle above was chosen
    int end;    ///< below a joint
    borders_below below;
    value best;
  };
  /// A way to do so: the apex, and what lies below the two sides.
  struct option {
    int apex, end;
    borders_below below;
    summary left, right;
    /// i and j share a plane, and the edge that turns round between them at the apex has two ends
    bool inner_edge;
    Count count;
  };

  split_table(const split_table&) = delete;  // values may point into the objective
  split_table& operator=(const split_table&) = delete;

  /// Fills the table.
  /// *Requires* degree >= 4.
  split_table(const corner_signs<K>& signs, Objective objective)
      : s_(signs), turns_(signs), k_(signs.degree()), objective_(std::move(objective)), below_(static_cast<std::size_t>(k_) * k_) {
    for (int size = 2; size < k_; ++size)
      for (int i = 0; i + size < k_; ++i) fill(i, i + size);
    const progresses whole = {{{turns_.whole_turns(0), any_phase}, {turns_.whole_turns(k_ - 1), any_phase}}};
    root_ = {0, k_ - 1, root, -1, nowhere, {s_.ray_is_convex(k_ - 1), whole}, objective_.none()};
    bool first = true;
    for (const state& t : at(0, k_ - 1)) {
      if (!fits(t, root_)) continue;
      count_ += t.count;
      if (first || better(t.best, root_.best)) root_.best = t.best;
      first = false;
    }
  }

  /// Returns the signs of the corner.
  const corner_signs<K>& signs() const { return s_; }
  /// Returns the turns of its facets.
  const facet_turns<K>& turns() const { return turns_; }
  /// Returns the objective.
  const Objective& objective() const { return objective_; }

  /// Returns the number of candidates.
  const Count& count() const { return count_; }
  /// Returns the task to choose a candidate.
  const task& whole() const { return root_; }

  /// Returns the ways to do a task: by apexes, convex edges before reflex ones.
  std::vector<option> options(const task& t) const {
    std::vector<option> result;
    for (int m = t.i + 1; m < t.j; ++m)
      if (const auto& all = at(t.i, t.j); std::any_of(all.begin(), all.end(), [&](const state& x) { return x.apex == m && fits(x, t); }))
        for_each_option(t.i, m, t.j, [&](const option& o) {
          if (fits(o, t)) result.push_back(o);
        });
    return result;
  }

  /// Returns what is to be done below the triangle that an option adds; the smaller part last,
  /// which is done first: it fails soonest.
  std::vector<task> sides(const task& t, const option& o, int level) const {
    const bool corner = is_corner(t.i, o.apex, t.j);
    const auto below = [&](int i, int j, int n, const summary& x) { return task{i, j, corner ? n : joint, level, x.end, x, x.best}; };
    std::vector<task> result;
    if (t.j > o.apex + 1) result.push_back(below(o.apex, t.j, t.i, o.right));
    if (o.apex > t.i + 1) result.push_back(below(t.i, o.apex, t.j, o.left));
    if (o.apex - t.i > t.j - o.apex && result.size() == 2) std::swap(result[0], result[1]);
    return result;
  }

  /// Returns whether a triangle is a vertex: its facets are of three planes.
  bool is_corner(int i, int m, int j) const { return !same(i, m) && !same(m, j) && !same(i, j); }
  /// Returns whether two facets lie in one plane.
  bool same(int f, int g) const { return turns_.same_plane(f, g); }

 private:
  static constexpr int any_phase = -1;

  // The trees below (i,j) with this apex, with an edge (i,j) that bends so and has the third facet
  // `end` at its far end, and with this progress of the facets i and j. The end is the apex, but
  // where i or j and the apex share a plane the edge goes on between the others. Where i and j
  // share one there is no edge, and the triangles on both sides of the diagonal are joints.
  struct state {
    int apex, end;
    borders_below below;
    value best;
    Count count;
  };

  std::vector<state>& at(int i, int j) { return below_[static_cast<std::size_t>(i) * k_ + j]; }
  const std::vector<state>& at(int i, int j) const { return below_[static_cast<std::size_t>(i) * k_ + j]; }

  bool better(value v, value w) const {
    sum x{};
    sum y{};
    objective_.add(x, v);
    objective_.add(y, w);
    return objective_.compare(x, y) == sign::positive;
  }

  // Whether the edge (i,j) can end in the vertices with the facets `end` and n.
  bool is_edge(int i, int j, int end, bool convex, int n) const { return !same(end, n) && convex == s_.is_convex(i, j, end, n); }

  // Adds to the one of `all` that is alike, or as another one.
  template <class All, class Alike>
  void gather(All& all, typename All::iterator first, const typename All::value_type& x, Alike alike) const {
    const auto found = std::find_if(first, all.end(), alike);
    if (found == all.end()) {
      all.push_back(x);
    } else {
      if (better(x.best, found->best)) found->best = x.best;
      found->count += x.count;
    }
  }

  // What lies below the side (i,j) of a joint.
  std::vector<summary> summarise(int i, int j) const {
    if (j == i + 1) {
      const bool convex = s_.ray_is_convex(i);
      return {{{convex, turns_.along_ray(i, convex)}, nowhere, objective_.none(), Count(1)}};
    }
    std::vector<summary> result;
    for (const state& t : at(i, j))
      gather(result, result.begin(), {t.below, t.end, t.best, t.count}, [&t](const summary& x) { return x.end == t.end && alike(x, t.below); });
    return result;
  }

  // What lies below the side (i,j) of the triangle whose third facet is n; convex before reflex.
  std::vector<summary> summarise(int i, int j, int n) const {
    if (j == i + 1) return summarise(i, j);
    std::vector<summary> result;
    for (const state& t : at(i, j)) {
      if (t.end != nowhere && !is_edge(i, j, t.end, t.below.convex, n)) continue;
      const value best = t.end == nowhere ? t.best : objective_.with_edge(t.best, t.below.convex);
      gather(result, result.begin(), {t.below, nowhere, best, t.count}, [&t](const summary& x) { return alike(x, t.below); });
    }
    std::sort(result.begin(), result.end(),
              [](const summary& x, const summary& y) { return x.convex != y.convex ? x.convex : x.borders < y.borders; });
    return result;
  }

  static bool alike(const borders_below& x, const borders_below& y) { return x.convex == y.convex && x.borders == y.borders; }

  // Calls visit(option) for every way to put triangle (i,m,j) on what is below its sides.
  template <class Visit>
  void for_each_option(int i, int m, int j, Visit visit) const {
    const int shared = (same(i, m) ? 1 : 0) + (same(m, j) ? 1 : 0) + (same(i, j) ? 1 : 0);
    if (shared == 1) for_each_joint(i, m, j, visit);
    if (shared != 0 || !s_.meets(i, m, j)) return;
    const auto left = summarise(i, m, j);
    const auto right = summarise(m, j, i);
    for (const auto& l : left)
      for (const auto& r : right)
        for (const bool convex : {true, false})
          if (const auto borders = turns_.join(i, m, j, convex, l, r)) visit(option{m, m, {convex, *borders}, l, r, false, l.count * r.count});
  }

  // The same where two of the facets share a plane, so that their edges with the third go on.
  template <class Visit>
  void for_each_joint(int i, int m, int j, Visit visit) const {
    const border_progress none = {0, 0};
    const auto left = summarise(i, m);
    const auto right = summarise(m, j);
    for (const auto& l : left)
      for (const auto& r : right) {
        const Count count = l.count * r.count;
        if (same(i, m)) {
          visit(option{m, r.end, {r.convex, {none, r.borders[1]}}, l, r, false, count});
        } else if (same(m, j)) {
          visit(option{m, l.end, {l.convex, {l.borders[0], none}}, l, r, false, count});
        } else {
          const bool inner = l.end != nowhere && r.end != nowhere;
          if (l.convex != r.convex || !turns_.meet(m, 0, l.borders[1], r.borders[0])) continue;
          if (inner && !is_edge(i, m, l.end, l.convex, r.end)) continue;
          visit(option{m, nowhere, {true, {none, none}}, l, r, inner, count});
        }
      }
  }

  value value_of(int i, int j, const option& o) {
    if (is_corner(i, o.apex, j)) return objective_.with_vertex(o.left.best, o.right.best, {i, o.apex, j});
    const value both = objective_.joined(o.left.best, o.right.best);
    return o.inner_edge ? objective_.with_edge(both, o.left.convex) : both;
  }

  void fill(int i, int j) {
    std::vector<state>& all = at(i, j);
    for (int m = i + 1; m < j; ++m) {
      const auto first = static_cast<std::ptrdiff_t>(all.size());
      for_each_option(i, m, j, [&](const option& o) {
        gather(all, all.begin() + first, {m, o.end, o.below, value_of(i, j, o), o.count},
               [&o](const state& x) { return x.end == o.end && alike(x.below, o.below); });
      });
    }
  }

  static bool agree(const progresses& made, const progresses& wanted) {
    for (const std::size_t f : {0U, 1U})
      if (made[f].turns != wanted[f].turns || (made[f].phase != wanted[f].phase && wanted[f].phase != any_phase)) return false;
    return true;
  }
  template <class Found>  // a state or an option
  bool fits(const Found& x, const task& t) const {
    if (x.below.convex != t.below.convex || !agree(x.below.borders, t.below.borders)) return false;
    if (t.above == joint) return x.end == t.end;
    return t.above == root || x.end == nowhere || is_edge(t.i, t.j, x.end, x.below.convex, t.above);
  }

  const corner_signs<K>& s_;
  facet_turns<K> turns_;
  int k_;
  Objective objective_;
  std::vector<std::vector<state>> below_;
  task root_;
  Count count_ = 0;
};

}  // namespace osteon
