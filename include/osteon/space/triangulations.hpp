// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Triangulations of a convex polygon, which are the trees that a vertex may split into.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace osteon {

/// Calls visit(diagonals) for every triangulation of a convex k-gon, in the thesis's order: lists
/// of diagonals (a,b) ascending, lists in lexicographic order.
/// *Requires* k >= 3. *Complexity* there are Catalan(k - 2).
inline void for_each_triangulation(int k, const std::function<void(std::span<const std::pair<int, int>>)>& visit) {
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < k; ++a)
    for (int b = a + 2; b < k; ++b)
      if (b - a < k - 1) all.emplace_back(a, b);
  std::vector<std::pair<int, int>> chosen;
  const auto crosses = [](const std::pair<int, int>& x, const std::pair<int, int>& y) {
    return (x.first < y.first && y.first < x.second && x.second < y.second) || (y.first < x.first && x.first < y.second && y.second < x.second);
  };
  const auto extend = [&](auto&& self, std::size_t first) -> void {
    if (static_cast<int>(chosen.size()) == k - 3) {
      visit(chosen);
      return;
    }
    const std::size_t missing = static_cast<std::size_t>(k) - 3 - chosen.size();
    for (std::size_t i = first; i + missing <= all.size(); ++i) {
      if (std::any_of(chosen.begin(), chosen.end(), [&](const auto& c) { return crosses(c, all[i]); })) continue;
      chosen.push_back(all[i]);
      self(self, i + 1);
      chosen.pop_back();
    }
  };
  extend(extend, 0);
}

/// Returns the n-th Catalan number.
/// *Requires* n <= 35.
inline std::uint64_t catalan(int n) {
  std::uint64_t c = 1;
  for (int i = 0; i < n; ++i) c = c * 2 * (2 * static_cast<std::uint64_t>(i) + 1) / (static_cast<std::uint64_t>(i) + 2);
  return c;
}

}  // namespace osteon
