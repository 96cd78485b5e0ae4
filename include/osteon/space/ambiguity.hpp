// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How many ways there are to split a vertex (thesis 3.6, 3.7), counted without listing where there
/// are too many.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"

namespace osteon {

/// The number of valid trees of a vertex is the product of the factors, or at least that where it
/// is not exact.
struct split_count {
  std::vector<std::uint64_t> factors;
  bool exact;
};

/// Returns the factors of a lower bound for the number of valid trees, from one of them. The facets
/// below a diagonal of the tree may be joined in several ways; ways below diagonals that have no
/// facets in common combine freely, for whether a tree is valid is decided for each facet's border
/// alone, and no border belongs to two of them. Tries all ways below the diagonals of four to seven
/// facets.
/// *Requires* a valid tree, and facets in different planes.
template <kernel<3> K>
std::vector<std::uint64_t> independent_ways(const splitter<K>& s, const split_tree& t) {
  struct part {
    int first, last;
    std::uint64_t ways;
    std::size_t before;  // so many parts end before it
  };
  std::vector<part> parts;
  for (const auto& below : t.operations) {
    const int i = below.first;
    const int j = below.second;
    if (j - i < 3 || j - i > 6) continue;
    std::vector<std::pair<int, int>> outside;
    for (const auto& d : t.operations)
      if (d.first < i || d.second > j || d == below) outside.push_back(d);
    part p = {i, j, 0, 0};
    for_each_triangulation(j - i + 1, [&](std::span<const std::pair<int, int>> inside) {
      std::vector<std::pair<int, int>> all = outside;
      for (const auto& [a, b] : inside) all.emplace_back(i + a, i + b);
      std::sort(all.begin(), all.end());
      const auto other = s.tree(all);
      if (other && s.valid(*other)) ++p.ways;
    });
    if (p.ways > 1) parts.push_back(p);
  }
  // Disjoint parts with the greatest product, by their last facets; a product may round, it only
  // chooses.
  std::sort(parts.begin(), parts.end(), [](const part& x, const part& y) { return x.last < y.last; });
  std::vector<double> most = {1};  // of the first parts
  for (part& p : parts) {
    while (parts[p.before].last < p.first) ++p.before;
    most.push_back(std::max(most.back(), most[p.before] * static_cast<double>(p.ways)));
  }
  std::vector<std::uint64_t> factors;
  for (std::size_t n = parts.size(); n > 0;) {
    if (most[n] == most[n - 1]) {
      --n;
    } else {
      factors.push_back(parts[n - 1].ways);
      n = parts[n - 1].before;
    }
  }
  return factors;
}

/// Returns the number of valid trees of a vertex: exactly where there are at most `most_listed`,
/// else from below. A vertex that needs no split has one.
/// *Throws* as preferred_split.
template <kernel<3> K>
split_count count_splits(const K& k, const boundary& b, int vertex, std::uint64_t most_listed = 10'000) {
  const auto& v = b.vertices[static_cast<std::size_t>(vertex)];
  const corner c = corner_at(b, vertex);
  if (c.degree() == 3 || v.is_majority()) return {{1}, true};
  const splitter<K> s(k, c);
  if (std::all_of(c.convex.begin(), c.convex.end(), [&c](bool convex) { return convex == c.convex.front(); })) return {{1}, true};
  const auto some = preferred_split(k, c, split_preference::convex);
  if (!some) return {{0}, true};
  std::uint64_t listed = 0;
  const bool different = has_different_planes(c);
  const auto count = [&](const searched_split::diagonals& d) {
    if (!different) {  // two trees may be one forest, and facets that join may cross
      const auto t = s.tree(d);
      if (!t || !s.valid(*t)) return false;
    }
    return ++listed > most_listed;
  };
  if (split_search<K, edge_count>(s.signs(), edge_count(true)).for_each(count, 1'000'000)) return {{listed}, true};
  auto factors = different ? independent_ways(s, some->tree) : std::vector<std::uint64_t>{};
  double product = 1;
  for (const std::uint64_t f : factors) product *= static_cast<double>(f);
  return product > static_cast<double>(listed) ? split_count{std::move(factors), false} : split_count{{listed}, false};
}

}  // namespace osteon
