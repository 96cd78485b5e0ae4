// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Statements about the trees that split a vertex of degree k: triangulations of a convex k-gon, and the thesis's lists of
/// operations <a,b> (3.3.1), counted and put into bijection.

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/space/split.hpp"
#include "report.hpp"

namespace osteon::proofs {

/// Its triangles a < b < c, ascending.
using triangulation = std::vector<std::array<int, 3>>;
using operations = std::vector<std::pair<int, int>>;

/// All triangulations of the corners first .. last of a polygon, by the apex over its side (first, last).
inline std::vector<triangulation> triangulations(int first, int last) {
  if (last - first < 2) return {{}};
  std::vector<triangulation> result;
  for (int apex = first + 1; apex < last; ++apex) {
    const std::vector<triangulation> left = triangulations(first, apex);
    const std::vector<triangulation> right = triangulations(apex, last);
    for (const triangulation& l : left)
      for (const triangulation& r : right) {
        triangulation t = {{first, apex, last}};
        t.insert(t.end(), l.begin(), l.end());
        t.insert(t.end(), r.begin(), r.end());
        std::sort(t.begin(), t.end());
        result.push_back(std::move(t));
      }
  }
  return result;
}
inline std::vector<triangulation> triangulations(int k) { return triangulations(0, k - 1); }

/// The list of a triangulation: its diagonals, ascending.
inline operations encode(int k, const triangulation& t) {
  operations list;
  for (const auto& [a, b, c] : t)
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(a, c)})
      if (q - p > 1 && q - p < k - 1) list.emplace_back(p, q);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());  // a diagonal has two triangles
  return list;
}

/// The thesis's operation: the node around which facets a and b both lie, not side by side, becomes two. False where there is none.
inline bool split_node(std::vector<std::vector<int>>& nodes, int a, int b) {
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const std::vector<int> node = nodes[n];
    const auto at = std::find(node.begin(), node.end(), a);
    const auto to = std::find(node.begin(), node.end(), b);
    if (at == node.end() || to == node.end() || to - at < 2 || to - at == static_cast<std::ptrdiff_t>(node.size()) - 1) continue;
    nodes[n].assign(at, to + 1);
    std::vector<int>& rest = nodes.emplace_back(node.begin(), at + 1);
    rest.insert(rest.end(), to, node.end());
    return true;
  }
  return false;
}

/// The nodes after all operations; nothing where one cannot be done.
inline triangulation decode(int k, std::span<const std::pair<int, int>> list) {
  std::vector<std::vector<int>> nodes(1);
  for (int f = 0; f < k; ++f) nodes[0].push_back(f);
  for (const auto& [a, b] : list)
    if (!split_node(nodes, a, b)) return {};
  triangulation t;
  for (const auto& n : nodes)
    if (n.size() == 3) t.push_back({n[0], n[1], n[2]});
  std::sort(t.begin(), t.end());
  return t;
}

/// The thesis's generation to the letter: extend every list by each greater operation that can be done; drop lists that cannot grow.
inline std::vector<operations> lists_of_the_thesis(int k) {
  std::vector<operations> lists = {{}};
  for (int step = 0; step < k - 3; ++step) {
    std::vector<operations> longer;
    for (const operations& list : lists)
      for (int a = 0; a < k; ++a)
        for (int b = a + 2; b < k; ++b) {
          if (!list.empty() && std::pair(a, b) <= list.back()) continue;
          std::vector<std::vector<int>> nodes(1);
          for (int f = 0; f < k; ++f) nodes[0].push_back(f);
          for (const auto& [c, d] : list) split_node(nodes, c, d);
          if (!split_node(nodes, a, b)) continue;
          longer.push_back(list);
          longer.back().emplace_back(a, b);
        }
    lists = std::move(longer);
  }
  return lists;
}

inline std::string text(std::span<const std::pair<int, int>> list) {
  std::string s;
  for (const auto& [a, b] : list) s += '<' + std::to_string(a) + ',' + std::to_string(b) + '>';
  return s;
}

inline void prove_catalan(proof& p) {
  // C(n+1) = sum C(i) C(n-i); and the closed form, by 128 bits' worth of care: binomials of Pascal's triangle.
  std::vector<std::uint64_t> c = {1};
  std::vector<std::uint64_t> row = {1};
  for (int n = 0; n < 30; ++n) {
    const auto what = [n] { return "C(" + std::to_string(n) + ")"; };
    p.check(c.back() == row[static_cast<std::size_t>(n)] / (static_cast<std::uint64_t>(n) + 1) && c.back() == catalan(n), what);
    std::uint64_t next = 0;
    for (std::size_t i = 0; i < c.size(); ++i) next += c[i] * c[c.size() - 1 - i];
    c.push_back(next);
    for (int twice : {0, 1}) {
      (void)twice;
      std::vector<std::uint64_t> below(row.size() + 1, 1);
      for (std::size_t i = 1; i < row.size(); ++i) below[i] = row[i - 1] + row[i];
      row = std::move(below);
    }
  }
  std::string counts;
  for (int k = 3; k <= 13; ++k) {
    const auto what = [k] { return "degree " + std::to_string(k); };
    const std::vector<triangulation> all = triangulations(k);
    const std::uint64_t expected = c[static_cast<std::size_t>(k) - 2];
    p.check(all.size() == expected && std::set<triangulation>(all.begin(), all.end()).size() == expected, what);
    counts += (k == 3 ? "" : ", ") + std::to_string(all.size());

    std::vector<operations> encoded;
    for (const triangulation& t : all) {
      encoded.push_back(encode(k, t));
      p.check(t.size() == static_cast<std::size_t>(k) - 2 && decode(k, encoded.back()) == t, [&] { return what() + ": " + text(encoded.back()); });
    }
    std::sort(encoded.begin(), encoded.end());

    operations last;
    std::size_t at = 0;
    for_each_triangulation(k, [&](std::span<const std::pair<int, int>> list) {
      const operations now(list.begin(), list.end());
      const auto which = [&] { return what() + ": " + text(list); };
      p.check(static_cast<int>(now.size()) == k - 3 && std::is_sorted(now.begin(), now.end()) && (at == 0 || last < now), which);
      p.check(at < encoded.size() && encoded[at] == now && encode(k, decode(k, now)) == now, which);
      last = now;
      ++at;
    });
    p.check(at == expected, what);
    if (k <= 8) p.check(lists_of_the_thesis(k) == encoded, what);
  }
  p.note("for k = 3 .. 13: " + counts);

  // As printed: degree 5 with facets 1 .. 5, degree 6 with facets 0 .. 5.
  const std::vector<operations> five = {{{1, 3}, {1, 4}}, {{1, 3}, {3, 5}}, {{1, 4}, {2, 4}}, {{2, 4}, {2, 5}}, {{2, 5}, {3, 5}}};
  std::vector<operations> ours;
  for (const operations& list : lists_of_the_thesis(5)) {
    ours.push_back(list);
    for (auto& [a, b] : ours.back()) a++, b++;
  }
  p.check(ours == five, [] { return std::string("the five lists of figure 3.11"); });
  const std::vector<operations> six = {{{0, 2}, {0, 3}, {0, 4}}, {{0, 2}, {0, 3}, {3, 5}}, {{0, 2}, {0, 4}, {2, 4}}, {{0, 2}, {2, 4}, {2, 5}},
                                       {{0, 2}, {2, 5}, {3, 5}}, {{0, 3}, {0, 4}, {1, 3}}, {{0, 3}, {1, 3}, {3, 5}}, {{0, 4}, {1, 3}, {1, 4}},
                                       {{0, 4}, {1, 4}, {2, 4}}, {{1, 3}, {1, 4}, {1, 5}}, {{1, 3}, {1, 5}, {3, 5}}, {{1, 4}, {1, 5}, {2, 4}},
                                       {{1, 5}, {2, 4}, {2, 5}}, {{1, 5}, {2, 5}, {3, 5}}};
  ours.clear();
  for_each_triangulation(6, [&](std::span<const std::pair<int, int>> list) { ours.emplace_back(list.begin(), list.end()); });
  p.check(ours == six && lists_of_the_thesis(6) == six, [] { return std::string("the fourteen lists of section 3.3.1"); });
}

}  // namespace osteon::proofs
