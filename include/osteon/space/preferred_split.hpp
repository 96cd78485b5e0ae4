// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The split that is taken: one of a kind where all edges are convex or all reflex, else the best
/// of all.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/segment.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"

namespace osteon {

/// Returns the only valid tree of a corner whose edges are all convex, or all reflex (thesis 3.8),
/// as its diagonals, ascending. Facets join in random order, each taking the vertices that it cuts
/// off (reflex: fills) by flips.
/// *Requires* degree >= 4 and facets in different planes. *Throws* degenerate_error where the
/// kernel answers zero. *Complexity* expected O(k log k), a constant number of predicates for each
/// facet.
template <kernel<3> K>
std::vector<std::pair<int, int>> only_split(const K& k, const corner& c) {
  const int n = c.degree();
  const auto start = k.start();
  const auto plane = [&c](int f) { return c.facets[static_cast<std::size_t>(f)]; };
  const auto cuts = [&](int f, int a, int b, int d) {
    return (generic_side(k, plane(f), plane(a), plane(b), plane(d), start) == sign::negative) == c.convex.front();
  };

  // The facets' order, and the neighbours of each when it joins.
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::minstd_rand random(1);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
  std::vector<int> before(order.size());
  std::vector<int> after(order.size());
  for (int f = 0; f < n; ++f) {
    before[static_cast<std::size_t>(f)] = (f + n - 1) % n;
    after[static_cast<std::size_t>(f)] = (f + 1) % n;
  }
  for (std::size_t i = order.size() - 1; i > 2; --i) {
    const auto f = static_cast<std::size_t>(order[i]);
    after[static_cast<std::size_t>(before[f])] = after[f];
    before[static_cast<std::size_t>(after[f])] = before[f];
  }

  // The third facet of the triangle on the left of a directed edge.
  std::map<std::pair<int, int>, int> apex;
  const auto add = [&apex](int a, int b, int d) {
    apex[{a, b}] = d;
    apex[{b, d}] = a;
    apex[{d, a}] = b;
  };
  std::sort(order.begin(), order.begin() + 3);
  add(order[0], order[1], order[2]);
  for (std::size_t i = 3; i < order.size(); ++i) {
    const int f = order[i];
    std::vector<std::pair<int, int>> seen = {{before[static_cast<std::size_t>(f)], after[static_cast<std::size_t>(f)]}};
    while (!seen.empty()) {
      const auto [a, b] = seen.back();
      seen.pop_back();
      const auto across = apex.find({a, b});
      if (across == apex.end() || !cuts(f, a, b, across->second)) {
        add(a, f, b);
        continue;
      }
      const int d = across->second;
      for (const auto& edge : {std::pair(a, b), std::pair(b, d), std::pair(d, a)}) apex.erase(edge);
      seen.emplace_back(a, d);
      seen.emplace_back(d, b);
    }
  }
  std::vector<std::pair<int, int>> diagonals;
  for (const auto& [edge, third] : apex)
    if (edge.first < edge.second && apex.count({edge.second, edge.first}) != 0) diagonals.push_back(edge);
  return diagonals;
}

/// The tree that splits a vertex.
struct chosen_split {
  split_tree tree;
  bool proven;  ///< that no valid tree is preferred to it
};

/// Returns the preferred valid tree; nothing where no tree is valid, which thesis 3.5 excludes but
/// where three planes share an edge's line. Among equals: up to degree greatest_listed_degree the
/// first in the thesis's order, above it the first in the order of split_search.
/// *Requires* degree >= 4. *Throws* unsupported_error where a split is not found in so many steps,
/// or would take too much memory: above greatest_remembered_degree where edges are both convex and
/// reflex.
template <kernel<3> K>
std::optional<chosen_split> preferred_split(const K& k, const corner& c, split_preference preference) {
  constexpr int greatest_listed_degree = 7;  // up to here listing is as fast
  const splitter<K> s(k, c);
  const auto chosen = [](std::optional<split_tree> t, bool proven) { return t ? std::optional(chosen_split{std::move(*t), proven}) : std::nullopt; };
  const bool different = has_different_planes(c);
  if (different && std::all_of(c.convex.begin(), c.convex.end(), [&c](bool convex) { return convex == c.convex.front(); }))
    return chosen(s.tree(only_split(k, c)), true);
  if (c.degree() <= greatest_listed_degree) return chosen(s.best(preference), true);
  if (c.degree() > greatest_remembered_degree)
    throw unsupported_error("not yet: the split of a vertex of degree " + std::to_string(c.degree()) + " with convex and reflex edges (at most " +
                            std::to_string(greatest_remembered_degree) + ")");
  const auto search = [&](auto objective) {
    return split_search<K, decltype(objective)>(s.signs(), std::move(objective)).best([&s](const searched_split::diagonals& diagonals) {
      const auto t = s.tree(diagonals);
      return t && s.valid(*t);
    });
  };
  const auto preferred = [&] {
    switch (preference) {
      case split_preference::convex:
      case split_preference::reflex:
        return search(edge_count(preference == split_preference::convex));
      case split_preference::min_volume:
      case split_preference::max_volume:
        return search(offset_volume<K>(s.signs(), preference == split_preference::max_volume));
      case split_preference::first:
        break;
    }
    return search(any_tree());
  };
  searched_split found = preferred();
  const bool proven = found.end == search_end::best;
  for (const bool convex : {true, false})  // any tree is better than none
    if (found.end == search_end::unknown) found = search(edge_count(convex));
  if (found.end == search_end::unknown)
    throw unsupported_error("not yet: a split of a vertex of degree " + std::to_string(c.degree()) + " that takes so many steps to find");
  return found.end == search_end::none ? std::nullopt : chosen(s.tree(found.tree), proven);
}

/// Returns one of the valid trees, each with the same chance, by rejection among candidates of
/// split_search; the preferred one of most convex edges where a thousand of them are rejected.
/// *Requires* and *Throws* as preferred_split.
template <kernel<3> K>
std::optional<chosen_split> random_split(const K& k, const corner& c, std::uint64_t seed) {
  const splitter<K> s(k, c);
  std::mt19937_64 random(seed);
  if (c.degree() <= greatest_remembered_degree) {
    const split_search<K, edge_count> search(s.signs(), edge_count(true));
    for (int tries = 0; tries < 1000 && search.count() > 0; ++tries) {
      const auto diagonals = search.sample([&random](double n) { return static_cast<double>(random() >> 11U) * 0x1p-53 * n; });
      auto t = s.tree(diagonals);
      if (t && s.valid(*t)) return chosen_split{std::move(*t), true};
    }
  }
  return preferred_split(k, c, split_preference::convex);
}

}  // namespace osteon
