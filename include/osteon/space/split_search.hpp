// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Splits of vertices of any degree by dynamic programming over intervals (design 03), and a search among what it leaves.
///
/// A tree is a triangulation of the polygon of facets 0 .. k-1. The part of it on the far side of the diagonal (i,j) from the side (0,k-1) matters to
/// the rest only through its apex m, the bend of the edge (i,j), and what the borders of the facets i and j have done in it. Three rules are local
/// to triangles and fans: that of the nine corners; that a facet's border turns by less than half a turn in all; and, for unit speeds, that the
/// convex edges of a facet follow each other. Trees that obey them are the candidates; a candidate is valid unless two edges of one facet cross.
///
/// Why the third rule: at time 1 the surface passes each line normal to facet f's plane at moments t(h), h the height over that plane, whose slope is
/// 1 in the cell of f and less in all others. So it enters that cell once, and the facet meets each ray from the foot of the vertex in one interval.
/// Every other plane has the foot on its outer side. Hence the border runs round the foot one way along convex edges and the other way along reflex
/// ones, and runs back only beyond the facet's own wedge, at the ends. (With weights it holds for facets whose n / speed is a corner of the convex
/// hull of all.)

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/split_objective.hpp"

namespace osteon {

/// How a search has ended.
enum class search_end : std::uint8_t {
  best,    ///< with the best tree
  some,    ///< with a tree, out of steps before it was known that none is better
  none,    ///< there is no tree
  unknown  ///< out of steps before one was found
};

/// What a search has found.
struct searched_split {
  using diagonals = std::vector<std::pair<int, int>>;  ///< ascending
  search_end end;
  diagonals tree;
};

/// All candidates of one corner, without listing them. Requires degree >= 4. Where facets share a plane (thesis 3.3.3), two candidates may be one
/// forest, and one without crossing edges need not be valid. `Count` counts them: an integer of any size for exact counts, double where their number
/// does not matter. Cost: k^4 / 24 signs, each asked once, and about k^4 steps; memory k^3.
template <kernel<3> K, class Measure, class Count = double>
class split_search {
 public:
  using diagonals = searched_split::diagonals;
  using visitor = std::function<bool(const diagonals&)>;

  split_search(const split_search&) = delete;  // values may point into the measure
  split_search& operator=(const split_search&) = delete;
  split_search(const corner_signs<K>& signs, Measure measure)
      : s_(signs), k_(signs.degree()), measure_(std::move(measure)), below_(static_cast<std::size_t>(k_) * k_) {
    for (int f = 0; f < k_; ++f) {
      int first = 0;
      while (!same(first, f)) ++first;
      first_of_.push_back(first);
      shares_.push_back(first < f);
      if (first < f) shares_[first] = true;
    }
    for (int size = 2; size < k_; ++size)
      for (int i = 0; i + size < k_; ++i) fill(i, i + size);
    root_ = {
        0, k_ - 1, root, -1, nowhere, s_.ray_is_convex(k_ - 1), {{{whole_turns(0), any_phase}, {whole_turns(k_ - 1), any_phase}}}, measure_.none()};
    bool first = true;
    for (const state& t : at(0, k_ - 1)) {
      if (!fits(t, root_)) continue;
      count_ += t.count;
      if (first || better(t.best, root_.best)) root_.best = t.best;
      first = false;
    }
  }

  /// How many candidates there are.
  const Count& count() const { return count_; }

  /// A candidate: below(n) draws a number from 0 to n - 1, each with equal chance; then every candidate has. Requires count() > 0.
  template <class Below>
  diagonals sample(Below&& below) const {
    diagonals result;
    std::vector<task> waiting = {root_};
    while (!waiting.empty()) {
      const task t = waiting.back();
      waiting.pop_back();
      const std::vector<option> all = options(t);
      Count total = 0;
      for (const option& o : all) total += o.count;
      Count drawn = below(total);
      std::size_t chosen = 0;
      while (chosen + 1 < all.size() && !(drawn < all[chosen].count)) drawn -= all[chosen++].count;
      const option& o = all[chosen];
      if (t.above != root) result.emplace_back(t.i, t.j);
      for (const task& side : sides(t, o, 0)) waiting.push_back(side);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Calls visit(diagonals) for every candidate without crossing edges, diagonals ascending, until it answers true: whether all were visited, which
  /// needs at most `most_steps`. Order: apexes from the side (0,k-1) down, the smaller part first, convex edges before reflex ones.
  bool for_each(const visitor& visit, std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max()) {
    return run(std::nullopt, false, false, most_steps, visit) == outcome::none;
  }

  /// The best tree that is accepted, the first of for_each's order among equals. To prove it best takes exponentially many steps in the worst case,
  /// and the search gives up after a multiple of `most_steps`.
  searched_split best(const visitor& accepts, std::uint64_t most_steps = 1'000'000) {
    std::optional<std::pair<diagonals, sum>> found;
    const auto find = [&](std::optional<sum> limit, bool strictly, bool best_first) {
      return run(std::move(limit), strictly, best_first, most_steps, [&](const diagonals& d) {
        if (!accepts(d)) return false;
        found = {d, decided_};
        return true;
      });
    };
    sum most{};
    measure_.add(most, root_.best);
    if (find(most, false, false) == outcome::found) return {search_end::best, found->first};
    outcome next = find(std::nullopt, false, true);
    if (next == outcome::none) return {search_end::none, {}};
    if (next == outcome::out_of_steps) return {search_end::unknown, {}};
    while (next == outcome::found) next = find(found->second, true, true);
    if (next == outcome::none) next = find(found->second, false, false);
    return {next == outcome::found ? search_end::best : search_end::some, found->first};
  }

 private:
  using value = typename Measure::value;
  using sum = typename Measure::sum;

  // What part of a facet's border has done, read from one of its ends.
  struct progress {
    int turns;  // how often it passed its first direction
    int phase;  // its edges are reflex, with convex ones behind them, with reflex ones behind these

    friend bool operator==(const progress&, const progress&) = default;
    friend bool operator<(const progress& x, const progress& y) { return std::tie(x.turns, x.phase) < std::tie(y.turns, y.phase); }
  };
  using progresses = std::array<progress, 2>;
  static constexpr int any_phase = -1;

  // What a task has above it, where that is no facet.
  static constexpr int root = -1;
  static constexpr int joint = -2;
  // The end of an edge that runs on for ever.
  static constexpr int nowhere = -1;

  // The trees below (i,j) with this apex, with an edge (i,j) that bends so and has the third facet `end` at its far end, and with this progress of
  // the facets i and j. The end is the apex, but where i or j and the apex share a plane the edge goes on between the others. Where i and j share one
  // there is no edge, and the triangles on both sides of the diagonal are joints.
  struct state {
    int apex, end;
    bool convex;
    progresses borders;
    value best;
    Count count;
  };
  // What is common to trees below a side of a triangle: with the edge across that side, which has both ends then, or, at a joint, without.
  struct summary {
    int end;  // of a joint's
    bool convex;
    progresses borders;
    value best;
    Count count;
  };
  // To choose a tree below (i,j); the triangle above was chosen at `level`, and its third facet is `above` where the edge (i,j) ends there.
  struct task {
    int i, j, above, level;
    int end;  // below a joint
    bool convex;
    progresses borders;
    value best;
  };
  // A way to do so: the apex, and what lies below the two sides.
  struct option {
    int apex, end;
    bool convex;
    progresses borders;
    summary left, right;
    bool inner_edge;  // i and j share a plane, and the edge that turns round between them at the apex has two ends
    Count count;
  };
  using levels = std::vector<bool>;
  enum class outcome : std::uint8_t { found, none, out_of_steps };
  using border = typename corner_signs<K>::border;
  struct placed {
    border edge;
    int level;
  };

  std::vector<state>& at(int i, int j) { return below_[static_cast<std::size_t>(i) * k_ + j]; }
  const std::vector<state>& at(int i, int j) const { return below_[static_cast<std::size_t>(i) * k_ + j]; }

  bool better(value v, value w) const {
    sum x{};
    sum y{};
    measure_.add(x, v);
    measure_.add(y, w);
    return measure_.compare(x, y) == sign::positive;
  }

  bool same(int f, int g) const { return s_.plane(f) == s_.plane(g); }

  // Whether the edge (i,j) can end in the vertices with the facets `end` and n.
  bool is_edge(int i, int j, int end, bool convex, int n) const { return !same(end, n) && convex == s_.is_convex(i, j, end, n); }

  template <class Same>
  void gather(std::vector<summary>& all, const summary& x, Same is_same) const {
    const auto found = std::find_if(all.begin(), all.end(), is_same);
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
      return {{nowhere, convex, {{{0, next_phase(i, 0, convex)}, {0, next_phase(j, 0, convex)}}}, measure_.none(), Count(1)}};
    }
    std::vector<summary> result;
    for (const state& t : at(i, j))
      gather(result, {t.end, t.convex, t.borders, t.best, t.count},
             [&t](const summary& x) { return x.end == t.end && x.convex == t.convex && x.borders == t.borders; });
    return result;
  }

  // What lies below the side (i,j) of the triangle whose third facet is n; convex before reflex.
  std::vector<summary> summarise(int i, int j, int n) const {
    if (j == i + 1) return summarise(i, j);
    std::vector<summary> result;
    for (const state& t : at(i, j)) {
      if (t.end != nowhere && !is_edge(i, j, t.end, t.convex, n)) continue;
      gather(result, {nowhere, t.convex, t.borders, t.end == nowhere ? t.best : measure_.with_edge(t.best, t.convex), t.count},
             [&t](const summary& x) { return x.convex == t.convex && x.borders == t.borders; });
    }
    std::sort(result.begin(), result.end(),
              [](const summary& x, const summary& y) { return x.convex != y.convex ? x.convex : x.borders < y.borders; });
    return result;
  }

  // The phase of facet f's border after one more edge; -1 where that breaks the third rule. Facets that share a plane may join: their borders are not
  // followed.
  int next_phase(int f, int phase, bool convex) const {
    if (!s_.has_unit_speeds() || shares_[f]) return 0;
    if (convex) return phase == 2 ? -1 : 1;
    return phase == 0 ? 0 : 2;
  }
  // Whether the third rule holds for a border of which two parts have been read, each from its own end.
  static bool phases_meet(int x, int y) { return x == 0 || y == 0 || (x == 1 && y == 1); }

  bool borders_meet(int m, int between, const summary& left, const summary& right) const {
    const progress& l = left.borders[1];
    const progress& r = right.borders[0];
    return phases_meet(l.phase, r.phase) && l.turns + r.turns + between == whole_turns(m);
  }

  // The progress of i and j where triangle (i,m,j) joins what is below its sides, or nothing where that breaks a rule.
  std::optional<progresses> join(int i, int m, int j, bool convex, const summary& left, const summary& right) const {
    const bool up = s_.orientation(i, m, j) == sign::positive;
    const int inside = (left.convex == up ? 1 : 0) + (right.convex == up ? 1 : 0) + (convex == up ? 1 : 0);
    if (up != (inside == 0 || inside == 3)) return std::nullopt;
    const progresses result = {{{left.borders[0].turns + wraps(i, m, j, left.convex, convex), next_phase(i, left.borders[0].phase, convex)},
                                {right.borders[1].turns + wraps(j, i, m, convex, right.convex), next_phase(j, right.borders[1].phase, convex)}}};
    if (result[0].phase < 0 || result[1].phase < 0) return std::nullopt;
    if (!borders_meet(m, wraps(m, j, i, right.convex, left.convex), left, right)) return std::nullopt;
    return result;
  }

  // Calls visit(option) for every way to put triangle (i,m,j) on what is below its sides.
  template <class Visit>
  void for_each_option(int i, int m, int j, Visit visit) const {
    const int shared = (same(i, m) ? 1 : 0) + (same(m, j) ? 1 : 0) + (same(i, j) ? 1 : 0);
    if (shared > 1) return;
    if (shared == 0) {
      if (!s_.meets(i, m, j)) return;
      const auto left = summarise(i, m, j);
      const auto right = summarise(m, j, i);
      for (const auto& l : left)
        for (const auto& r : right)
          for (const bool convex : {true, false})
            if (const auto borders = join(i, m, j, convex, l, r)) visit(option{m, m, convex, *borders, l, r, false, l.count * r.count});
      return;
    }
    const progress none = {0, 0};
    const auto left = summarise(i, m);
    const auto right = summarise(m, j);
    for (const auto& l : left)
      for (const auto& r : right) {
        const Count count = l.count * r.count;
        if (same(i, m)) {
          visit(option{m, r.end, r.convex, {none, r.borders[1]}, l, r, false, count});
        } else if (same(m, j)) {
          visit(option{m, l.end, l.convex, {l.borders[0], none}, l, r, false, count});
        } else {
          const bool inner = l.end != nowhere && r.end != nowhere;
          if (l.convex != r.convex || !borders_meet(m, 0, l, r)) continue;
          if (inner && !is_edge(i, m, l.end, l.convex, r.end)) continue;
          visit(option{m, nowhere, true, {none, none}, l, r, inner, count});
        }
      }
  }

  bool is_corner(int i, int m, int j) const { return !same(i, m) && !same(m, j) && !same(i, j); }

  value value_of(int i, int j, const option& o) {
    if (is_corner(i, o.apex, j)) return measure_.with_vertex(o.left.best, o.right.best, {i, o.apex, j});
    const value both = measure_.joined(o.left.best, o.right.best);
    return o.inner_edge ? measure_.with_edge(both, o.left.convex) : both;
  }

  void fill(int i, int j) {
    std::vector<state>& all = at(i, j);
    for (int m = i + 1; m < j; ++m) {
      const auto first = static_cast<std::ptrdiff_t>(all.size());
      for_each_option(i, m, j, [&](const option& o) {
        const value best = value_of(i, j, o);
        const auto known = std::find_if(all.begin() + first, all.end(),
                                        [&o](const state& x) { return x.end == o.end && x.convex == o.convex && x.borders == o.borders; });
        if (known == all.end()) {
          all.push_back({m, o.end, o.convex, o.borders, best, o.count});
        } else {
          if (better(best, known->best)) known->best = best;
          known->count += o.count;
        }
      });
    }
  }

  // ---- the search

  static bool agree(const progresses& made, const progresses& wanted) {
    for (const std::size_t f : {0U, 1U})
      if (made[f].turns != wanted[f].turns || (made[f].phase != wanted[f].phase && wanted[f].phase != any_phase)) return false;
    return true;
  }
  template <class Found>  // a state or an option
  bool fits(const Found& t, const task& w) const {
    if (t.convex != w.convex || !agree(t.borders, w.borders)) return false;
    if (w.above == joint) return t.end == w.end;
    return w.above == root || t.end == nowhere || is_edge(w.i, w.j, t.end, t.convex, w.above);
  }

  std::vector<option> options(const task& t) const {
    std::vector<option> result;
    for (int m = t.i + 1; m < t.j; ++m)
      if (const auto& all = at(t.i, t.j); std::any_of(all.begin(), all.end(), [&](const state& x) { return x.apex == m && fits(x, t); }))
        for_each_option(t.i, m, t.j, [&](const option& o) {
          if (fits(o, t)) result.push_back(o);
        });
    return result;
  }

  // What is to be done below the triangle that an option adds; the smaller part last, which is done first: it fails soonest.
  std::vector<task> sides(const task& t, const option& o, int level) const {
    const bool corner = is_corner(t.i, o.apex, t.j);
    const auto below = [&](int i, int j, int n, const summary& x) {
      return task{i, j, corner ? n : joint, level, x.end, x.convex, x.borders, x.best};
    };
    std::vector<task> result;
    if (t.j > o.apex + 1) result.push_back(below(o.apex, t.j, t.i, o.right));
    if (o.apex > t.i + 1) result.push_back(below(t.i, o.apex, t.j, o.left));
    if (o.apex - t.i > t.j - o.apex && result.size() == 2) std::swap(result[0], result[1]);
    return result;
  }

  // What an option adds to the decisions: its triangle, and the edges that have both ends now.
  void decide(sum& s, const task& t, const option& o) const {
    if (is_corner(t.i, o.apex, t.j)) measure_.add_vertex(s, {t.i, o.apex, t.j});
    if (o.inner_edge) measure_.add_edge(s, o.left.convex);
    if (t.above >= 0 && o.end != nowhere) measure_.add_edge(s, t.convex);
  }
  // The best that an option may come to.
  void add_best(sum& s, const task& t, const option& o) const {
    decide(s, t, o);
    measure_.add(s, o.left.best);
    measure_.add(s, o.right.best);
  }
  sum best_of(const task& t, const option& o) const {
    sum s{};
    add_best(s, t, o);
    return s;
  }

  // Whether the decisions until now and an option can still lead to a tree within the limit.
  bool may_do(const task& t, const option& o) const {
    if (!limit_) return true;
    sum s = decided_;
    add_best(s, t, o);
    for (const task& w : pending_) measure_.add(s, w.best);
    const sign than_limit = measure_.compare(s, *limit_);
    return than_limit == sign::positive || (than_limit == sign::zero && !strictly_);
  }

  // Calls visit(f, edge) for every edge whose ends are known with an option of task t, seen from both its facets; f is the first facet of the same
  // plane.
  template <class Visit>
  void for_each_edge(const task& t, const option& o, Visit visit) const {
    const auto both = [&](int f, int g, std::array<int, 2> ends, bool convex) {
      visit(first_of_[f], {f, g, ends, convex});
      visit(first_of_[g], {g, f, ends, convex});
    };
    if (same(t.i, t.j)) {
      both(t.i, o.apex, {o.left.end, o.right.end}, o.left.convex);
      return;
    }
    if (t.above != joint) both(t.i, t.j, {o.end, t.above}, t.convex);
    if (!is_corner(t.i, o.apex, t.j)) return;
    if (o.apex == t.i + 1) both(t.i, o.apex, {t.j, nowhere}, o.left.convex);
    if (o.apex == t.j - 1) both(o.apex, t.j, {t.i, nowhere}, o.right.convex);
  }

  // The first level at which an edge was placed that an edge of the option crosses; -1 where there is none.
  int crossed_level(const task& t, const option& o) const {
    int first = -1;
    for_each_edge(t, o, [&](int f, const border& e) {
      for (const placed& p : borders_[f])
        if ((first < 0 || p.level < first) && s_.cross(p.edge, e)) first = p.level;
    });
    return first;
  }

  outcome run(std::optional<sum> limit, bool strictly, bool best_first, std::uint64_t most_steps, const visitor& visit) {
    steps_left_ = most_steps;
    limit_ = std::move(limit);
    strictly_ = strictly;
    best_first_ = best_first;
    visit_ = &visit;
    decided_ = sum{};
    chosen_.clear();
    lossy_.assign(k_, false);
    borders_.assign(k_, {});
    pending_.clear();
    if (count_ == Count(0)) return outcome::none;
    pending_.push_back(root_);
    levels ignored(k_, false);
    return descend(0, ignored);
  }

  // Does the pending tasks until visit is content. Where nothing is found, `blame` tells the levels whose decisions made it fail; where the level
  // above is not among them, all its options fail alike and it need not try them (backjumping).
  outcome descend(int level, levels& blame) {
    if (pending_.empty()) {
      diagonals d = chosen_;
      std::sort(d.begin(), d.end());
      blame.assign(k_, true);
      return (*visit_)(d) ? outcome::found : outcome::none;
    }
    const task t = pending_.back();
    pending_.pop_back();
    if (t.level >= 0) blame[t.level] = true;
    std::vector<option> all = options(t);
    if (best_first_)
      std::stable_sort(all.begin(), all.end(),
                       [&](const option& x, const option& y) { return measure_.compare(best_of(t, x), best_of(t, y)) == sign::positive; });
    for (const option& o : all) {
      if (steps_left_-- == 0) return outcome::out_of_steps;
      if (!may_do(t, o)) {
        for (int l = 0; l < level; ++l) blame[l] = blame[l] || lossy_[l];
        continue;
      }
      if (const int crossed = crossed_level(t, o); crossed >= 0) {
        blame[crossed] = true;
        continue;
      }
      levels below(k_, false);
      if (const outcome done = try_option(t, o, level, below); done != outcome::none) return done;
      if (!below[level]) {
        blame = below;
        break;
      }
      below[level] = false;
      for (int l = 0; l < level; ++l) blame[l] = blame[l] || below[l];
    }
    pending_.push_back(t);
    return outcome::none;
  }

  outcome try_option(const task& t, const option& o, int level, levels& blame) {
    const std::size_t waiting = pending_.size();
    for (const task& side : sides(t, o, level)) pending_.push_back(side);
    if (t.above != root) chosen_.emplace_back(t.i, t.j);
    for_each_edge(t, o, [&](int f, const border& e) { borders_[f].push_back({e, level}); });
    sum before = decided_;
    decide(decided_, t, o);
    sum most{};
    measure_.add(most, t.best);
    lossy_[level] = limit_ && measure_.compare(best_of(t, o), most) != sign::zero;
    if (const outcome done = descend(level + 1, blame); done != outcome::none) return done;
    decided_ = std::move(before);
    for_each_edge(t, o, [&](int f, const border&) { borders_[f].pop_back(); });
    if (t.above != root) chosen_.pop_back();
    pending_.resize(waiting, root_);
    return outcome::none;
  }

  // ---- how a border turns

  // Directions on the border of facet f, which runs counter-clockwise from its edge with f + 1 to the one with f - 1: along n_f x n_x where the
  // edge with x is convex, against it where it is reflex. The side on which it lies of the first one; that one's own is zero.
  sign direction(int f, int x, bool convex) const {
    const int first = (f + 1) % k_;
    if (x == first) return sign::zero;
    const sign s = s_.orientation(f, first, x);
    return convex == s_.ray_is_convex(f) ? s : -s;
  }

  // How often the turn (of less than half a turn) from the edge with x to that with y passes the first direction: -1, 0 or 1.
  int wraps(int f, int x, int y, bool x_convex, bool y_convex) const {
    if (shares_[f]) return 0;
    const sign turn = x_convex == y_convex ? s_.orientation(f, x, y) : -s_.orientation(f, x, y);
    const bool low_x = direction(f, x, x_convex) == sign::negative;
    const bool low_y = direction(f, y, y_convex) == sign::negative;
    if (low_x == low_y) return 0;
    return turn == sign::positive ? (low_x ? 1 : 0) : (low_y ? -1 : 0);
  }

  // What the wraps of facet f must add up to.
  int whole_turns(int f) const {
    if (shares_[f]) return 0;
    const int last = (f + k_ - 1) % k_;
    return direction(f, last, s_.ray_is_convex(last)) == sign::negative ? -1 : 0;
  }

  const corner_signs<K>& s_;
  int k_;
  Measure measure_;
  std::vector<bool> shares_;   // by facet: its plane with another one
  std::vector<int> first_of_;  // by facet: the first one of its plane
  std::vector<std::vector<state>> below_;
  task root_;
  Count count_ = 0;

  // The search: what it is for, and where it is.
  std::optional<sum> limit_;  // trees must be as good,
  bool strictly_ = false;     // or better
  bool best_first_ = false;
  const visitor* visit_ = nullptr;
  std::uint64_t steps_left_ = 0;
  std::vector<task> pending_;
  diagonals chosen_;
  sum decided_{};
  std::vector<bool> lossy_;                   // by level: whether its option was not the best one
  std::vector<std::vector<placed>> borders_;  // by facet
};

}  // namespace osteon
