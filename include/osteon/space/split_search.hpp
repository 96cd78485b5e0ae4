// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A search for the best valid split of a vertex, among the candidates of split_table.hpp.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/split_objective.hpp"
#include "osteon/space/split_table.hpp"

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

/// All candidates of one corner: counted, drawn, listed, optimised. Where facets share a plane, a
/// candidate without crossing edges need not be valid. Parameters as for split_table.
template <kernel<3> K, split_objective Objective, class Count = double>
class split_search {
 public:
  using diagonals = searched_split::diagonals;
  /// Is called with a candidate's diagonals, and answers true to end the search.
  using visitor = std::function<bool(const diagonals&)>;

  /// *Requires* degree >= 4. *Complexity* as split_table.
  split_search(const corner_signs<K>& signs, Objective objective) : table_(signs, std::move(objective)) {}

  /// Returns the number of candidates.
  const Count& count() const { return table_.count(); }

  /// Returns a candidate. `below(n)` draws a number from 0 to n - 1, each with equal chance; then
  /// every candidate has.
  /// *Requires* count() > 0.
  template <class Below>
  diagonals sample(Below&& below) const {
    diagonals result;
    std::vector<task> waiting = {table_.whole()};
    while (!waiting.empty()) {
      const task t = waiting.back();
      waiting.pop_back();
      const std::vector<option> all = table_.options(t);
      Count total = 0;
      for (const option& o : all) total += o.count;
      Count drawn = below(total);
      std::size_t chosen = 0;
      while (chosen + 1 < all.size() && !(drawn < all[chosen].count)) drawn -= all[chosen++].count;
      const option& o = all[chosen];
      if (t.above != table::root) result.emplace_back(t.i, t.j);
      for (const task& side : table_.sides(t, o, 0)) waiting.push_back(side);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Calls visit(diagonals) for every candidate without crossing edges, diagonals ascending, until
  /// it answers true. Returns whether all were visited, which needs at most `most_steps`. Order:
  /// apexes from the side (0,k-1) down, the smaller part first, convex edges before reflex ones.
  bool for_each(const visitor& visit, std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max()) {
    return run(std::nullopt, false, false, most_steps, visit) == outcome::none;
  }

  /// Returns the best tree that `accepts` answers true for, the first of for_each's order among
  /// equals.
  /// *Complexity* to prove a tree best takes exponentially many steps in the worst case; the search
  /// gives up after a multiple of `most_steps`.
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
    table_.objective().add(most, table_.whole().best);
    if (find(most, false, false) == outcome::found) return {search_end::best, found->first};
    outcome next = find(std::nullopt, false, true);
    if (next == outcome::none) return {search_end::none, {}};
    if (next == outcome::out_of_steps) return {search_end::unknown, {}};
    while (next == outcome::found) next = find(found->second, true, true);
    if (next == outcome::none) next = find(found->second, false, false);
    return {next == outcome::found ? search_end::best : search_end::some, found->first};
  }

 private:
  using table = split_table<K, Objective, Count>;
  using task = typename table::task;
  using option = typename table::option;
  using sum = typename Objective::sum;
  using border = typename corner_signs<K>::border;
  using levels = std::vector<bool>;
  enum class outcome : std::uint8_t { found, none, out_of_steps };
  // An edge on a facet's border, and the level at which its ends became known.
  struct placed {
    border edge;
    int level;
  };

  std::size_t degree() const { return static_cast<std::size_t>(table_.signs().degree()); }

  // What an option adds to the decisions: its triangle, and the edges that have both ends now.
  void decide(sum& s, const task& t, const option& o) const {
    if (table_.is_corner(t.i, o.apex, t.j)) table_.objective().add_vertex(s, {t.i, o.apex, t.j});
    if (o.inner_edge) table_.objective().add_edge(s, o.left.convex);
    if (t.above >= 0 && o.end != table::nowhere) table_.objective().add_edge(s, t.below.convex);
  }
  // The best that an option may come to.
  void add_best(sum& s, const task& t, const option& o) const {
    decide(s, t, o);
    table_.objective().add(s, o.left.best);
    table_.objective().add(s, o.right.best);
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
    for (const task& w : pending_) table_.objective().add(s, w.best);
    const sign than_limit = table_.objective().compare(s, *limit_);
    return than_limit == sign::positive || (than_limit == sign::zero && !strictly_);
  }

  // Calls visit(f, edge) for every edge whose ends are known with an option of task t, seen from
  // both its facets; f is the first facet of the same plane.
  template <class Visit>
  void for_each_edge(const task& t, const option& o, Visit visit) const {
    const auto both = [&](int f, int g, std::array<int, 2> ends, bool convex) {
      visit(table_.turns().first_of(f), {f, g, ends, convex});
      visit(table_.turns().first_of(g), {g, f, ends, convex});
    };
    if (table_.same(t.i, t.j)) {
      both(t.i, o.apex, {o.left.end, o.right.end}, o.left.convex);
      return;
    }
    if (t.above != table::joint) both(t.i, t.j, {o.end, t.above}, t.below.convex);
    if (!table_.is_corner(t.i, o.apex, t.j)) return;
    if (o.apex == t.i + 1) both(t.i, o.apex, {t.j, table::nowhere}, o.left.convex);
    if (o.apex == t.j - 1) both(o.apex, t.j, {t.i, table::nowhere}, o.right.convex);
  }

  // The first level at which an edge was placed that an edge of the option crosses; -1 where there
  // is none.
  int crossed_level(const task& t, const option& o) const {
    int first = -1;
    for_each_edge(t, o, [&](int f, const border& e) {
      for (const placed& p : borders_[f])
        if ((first < 0 || p.level < first) && table_.signs().cross(p.edge, e)) first = p.level;
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
    lossy_.assign(degree(), false);
    borders_.assign(degree(), {});
    pending_.clear();
    if (count() == Count(0)) return outcome::none;
    pending_.push_back(table_.whole());
    levels ignored(degree(), false);
    return descend(0, ignored);
  }

  // Does the pending tasks until visit is content. Where nothing is found, `blame` tells the levels
  // whose decisions made it fail; where the level above is not among them, all its options fail
  // alike and it need not try them (backjumping).
  outcome descend(int level, levels& blame) {
    if (pending_.empty()) {
      diagonals d = chosen_;
      std::sort(d.begin(), d.end());
      blame.assign(degree(), true);
      return (*visit_)(d) ? outcome::found : outcome::none;
    }
    const task t = pending_.back();
    pending_.pop_back();
    if (t.level >= 0) blame[t.level] = true;
    std::vector<option> all = table_.options(t);
    if (best_first_)
      std::stable_sort(all.begin(), all.end(),
                       [&](const option& x, const option& y) { return table_.objective().compare(best_of(t, x), best_of(t, y)) == sign::positive; });
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
      levels below(degree(), false);
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
    for (const task& side : table_.sides(t, o, level)) pending_.push_back(side);
    if (t.above != table::root) chosen_.emplace_back(t.i, t.j);
    for_each_edge(t, o, [&](int f, const border& e) { borders_[f].push_back({e, level}); });
    sum before = decided_;
    decide(decided_, t, o);
    sum most{};
    table_.objective().add(most, t.best);
    lossy_[level] = limit_ && table_.objective().compare(best_of(t, o), most) != sign::zero;
    if (const outcome done = descend(level + 1, blame); done != outcome::none) return done;
    decided_ = std::move(before);
    for_each_edge(t, o, [&](int f, const border&) { borders_[f].pop_back(); });
    if (t.above != table::root) chosen_.pop_back();
    pending_.resize(waiting, table_.whole());
    return outcome::none;
  }

  table table_;

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
