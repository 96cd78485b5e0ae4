// SPDX-License-Identifier: MIT

// How many splits and skeletons there are, and walks through them.

#include "osteon/space/ambiguity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "osteon/models/polyhedra.hpp"
#include "osteon/space/verify.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

// The vertex of greatest degree.
int apex_of(const boundary& b) {
  const auto by_degree = [](const auto& v, const auto& w) { return v.facets.size() < w.facets.size(); };
  return static_cast<int>(std::max_element(b.vertices.begin(), b.vertices.end(), by_degree) - b.vertices.begin());
}

double product(const std::vector<std::uint64_t>& factors) {
  double p = 1;
  for (const std::uint64_t f : factors) p *= static_cast<double>(f);
  return p;
}

// Thesis 3.7: every arm has at least two ways, whatever the others do.
TEST(SplitCount, OfArmsGrowsExponentially) {
  for (const int n : {3, 4, 5, 6, 8, 12, 20}) {
    SCOPED_TRACE(std::to_string(n) + " arms");
    const auto s = make_solid(models::arms(n, 1).take<integer>());
    const auto k = default_kernel(s);
    const int apex = apex_of(s.boundary);
    const corner c = corner_at(s.boundary, apex);
    ASSERT_EQ(c.degree(), 5 * n);
    const splitter trees(k, c);
    const auto some = preferred_split(k, c, split_preference::convex);
    ASSERT_TRUE(some);
    const double at_least = product(independent_ways(trees, some->tree));
    EXPECT_GE(at_least, std::pow(2.0, n));
    const split_count counted = count_splits(k, s.boundary, apex);
    EXPECT_GE(product(counted.factors), at_least);
    if (n <= 6) {
      EXPECT_TRUE(counted.exact);
    }
  }
}

TEST(SplitCount, IsThatOfTheList) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const auto s = make_solid(models::cone(9, seed).take<integer>());
    const auto k = default_kernel(s);
    for (std::size_t v = 0; v < s.boundary.vertices.size(); ++v) {
      const split_count counted = count_splits(k, s.boundary, static_cast<int>(v));
      const corner c = corner_at(s.boundary, static_cast<int>(v));
      EXPECT_TRUE(counted.exact);
      EXPECT_EQ(product(counted.factors), c.degree() == 3 ? 1 : static_cast<double>(splitter(k, c).all().size()));
    }
  }
}

TEST(Sample, GivesEveryCandidateTheSameChance) {
  const auto s = make_solid(models::arms(3, 1).take<integer>());
  const auto k = default_kernel(s);
  const corner_signs signs(k, corner_at(s.boundary, apex_of(s.boundary)));
  using K = std::remove_cvref_t<decltype(k)>;
  const split_search<K, edge_count, std::uint64_t> search(signs, edge_count(true));
  const auto candidates = static_cast<double>(search.count());
  ASSERT_GE(candidates, 5);
  std::mt19937_64 random(1);
  std::map<searched_split::diagonals, int> drawn;
  const double each = 4000;
  for (int i = 0; i < static_cast<int>(each * candidates); ++i) ++drawn[search.sample([&](std::uint64_t n) { return random() % n; })];
  EXPECT_EQ(static_cast<double>(drawn.size()), candidates);
  for (const auto& [tree, times] : drawn) EXPECT_NEAR(times, each, 5 * std::sqrt(each));
}

TEST(Explore, SkeletonsAreCertifiedAndDiffer) {
  for (const auto& model : {models::star(5, 1), models::arms(3, 1), models::saddle(), models::crossing_bars(2)}) {
    const auto s = make_solid(model.take<integer>());
    const auto k = default_kernel(s);
    std::set<std::vector<quadruple>> seen;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      skeleton_options o;
      o.explore = seed;
      const skeleton raw = straight_skeleton(k, s.boundary, o);
      EXPECT_FALSE(verify(k, s.boundary, raw));
      std::vector<quadruple> nodes;
      for (const auto& n : raw.nodes) nodes.push_back(n.planes);
      const skeleton again = straight_skeleton(k, s.boundary, o);
      EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), again.nodes.begin(), again.nodes.end(),
                             [](const quadruple& q, const skeleton::node& n) { return q == n.planes; }));
      std::sort(nodes.begin(), nodes.end());
      seen.insert(nodes);
    }
    EXPECT_GE(seen.size(), 2U);
  }
}

}  // namespace
}  // namespace osteon::test
