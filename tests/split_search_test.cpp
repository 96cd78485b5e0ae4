// SPDX-License-Identifier: MIT

// Dynamic programming over intervals, and the search among its candidates, against the list of all trees.

#include "osteon/space/split_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "corners.hpp"
#include "osteon/models/registry.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/verify.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

using diagonals = std::vector<std::pair<int, int>>;

auto kernel_of(const random_corner& c) { return perturbed(filtered(std::span<const moving_plane<integer>>(c.planes), make_sqrt_kernel(c.planes))); }

// Whether every facet's border turns by less than half a turn, by angles.
bool turns_little(const random_corner& c, const split_tree& t) {
  using vector = std::array<double, 3>;
  const int k = c.of.degree();
  const auto normal = [&c](int f) {
    vector n{};
    for (std::size_t i = 0; i < 3; ++i) n[i] = c.planes[static_cast<std::size_t>(f)].n[i].template convert_to<double>();
    return n;
  };
  const auto across = [](const vector& x, const vector& y) {
    return vector{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  };
  const auto dot = [](const vector& x, const vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  for (int f = 0; f < k; ++f) {
    std::vector<std::pair<int, vector>> border;  // by the place of the other facet behind f
    for (const split_edge& e : t.edges) {
      if (e.a != f && e.b != f) continue;
      const int x = e.a == f ? e.b : e.a;
      vector d = across(normal(f), normal(x));
      if (!e.convex)
        for (double& z : d) z = -z;
      border.emplace_back((x - f + k) % k, d);
    }
    std::sort(border.begin(), border.end());
    double turn = 0;
    for (std::size_t i = 1; i < border.size(); ++i) {
      const auto& [x, d] = border[i - 1];
      const auto& [y, e] = border[i];
      const vector n = normal(f);
      turn += std::atan2(dot(across(d, e), n) / std::sqrt(dot(n, n)), dot(d, e));
    }
    if (std::abs(turn) >= std::numbers::pi) return false;
  }
  return true;
}

// Whether the convex edges of every facet follow each other.
bool has_convex_blocks(const random_corner& c, const split_tree& t) {
  const int k = c.of.degree();
  for (int f = 0; f < k; ++f) {
    std::vector<std::pair<int, bool>> border;
    for (const split_edge& e : t.edges)
      if (e.a == f || e.b == f) border.emplace_back(((e.a == f ? e.b : e.a) - f + k) % k, e.convex);
    std::sort(border.begin(), border.end());
    const auto convex = [](const auto& e) { return e.second; };
    const auto first = std::find_if(border.begin(), border.end(), convex);
    if (std::any_of(std::find_if_not(first, border.end(), convex), border.end(), convex)) return false;
  }
  return true;
}

std::vector<triple> planes_of(const split_tree& t) {
  return {t.vertices.begin(), t.vertices.end()};  // facet i has plane i
}

template <class Search>
std::set<diagonals> listed_by(Search& search) {
  std::set<diagonals> found;
  search.for_each([&](const diagonals& d) {
    EXPECT_TRUE(found.insert(d).second) << "a tree comes twice";
    return false;
  });
  return found;
}

TEST(SplitSearch, AgreesWithTheListOn5000Corners) {
  int corners = 0;
  std::size_t valid_trees = 0;
  std::size_t turning_trees = 0;
  for (int k = 4; k <= 11; ++k) {
    const int wanted = k <= 9 ? 720 : (k == 10 ? 450 : 230);
    for (int n = 0, seed = 1; n < wanted; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      const auto c = make_corner(k, static_cast<std::uint64_t>(1000 * k + seed));
      if (!c) continue;
      ++n;
      ++corners;
      const auto kernel = kernel_of(*c);
      using K = std::remove_cvref_t<decltype(kernel)>;
      const splitter s(kernel, c->of);
      std::set<diagonals> valid;
      std::size_t candidates = 0;
      std::array<int, 2> most = {-1, -1};
      std::array<std::optional<split_tree>, 2> extreme;
      for (const split_tree& t : s.candidates()) {
        candidates += turns_little(*c, t) && has_convex_blocks(*c, t) ? 1U : 0U;
        turning_trees += turns_little(*c, t) ? 0U : 1U;
        if (!s.valid(t)) continue;
        ASSERT_TRUE(turns_little(*c, t));
        ASSERT_TRUE(has_convex_blocks(*c, t));
        valid.insert(t.operations);
        most[0] = std::max(most[0], t.convex_edges());
        most[1] = std::max(most[1], t.reflex_edges());
        for (const std::size_t side : {0U, 1U})
          if (!extreme[side] || kernel.compare_volume(planes_of(t), planes_of(*extreme[side])) == (side == 0 ? sign::negative : sign::positive))
            extreme[side] = t;
      }
      ASSERT_FALSE(valid.empty());
      valid_trees += valid.size();
      split_search<K, edge_count, std::uint64_t> search(s.signs(), edge_count(true));
      ASSERT_EQ(search.count(), candidates);
      ASSERT_EQ(listed_by(search), valid);
      const auto accepts = [&valid](const diagonals& d) { return valid.contains(d); };
      for (const bool convex : {true, false}) {
        const auto best = split_search<K, edge_count>(s.signs(), edge_count(convex)).best(accepts);
        ASSERT_EQ(best.end, search_end::best);
        const auto t = s.tree(best.tree);
        ASSERT_EQ(convex ? t->convex_edges() : t->reflex_edges(), most[convex ? 0 : 1]);
      }
      for (const bool greatest : {false, true}) {
        const auto best = split_search<K, offset_volume<K>>(s.signs(), offset_volume<K>(s.signs(), greatest)).best(accepts);
        ASSERT_EQ(best.end, search_end::best);
        ASSERT_EQ(kernel.compare_volume(planes_of(*s.tree(best.tree)), planes_of(*extreme[greatest ? 1 : 0])), sign::zero);
      }
      if (valid.size() == 1) {
        ASSERT_TRUE(accepts(preferred_split(kernel, c->of, split_preference::convex)->tree.operations));
      }
    }
  }
  EXPECT_GE(corners, 5000);
  EXPECT_GT(valid_trees, 10000U);
  EXPECT_GT(turning_trees, 1000U);
}

// Thesis 3.3.3: facets of one plane may join, and trees are forests.
TEST(SplitSearch, AgreesWithTheListWhereFacetsShareAPlane) {
  int corners = 0;
  int joined = 0;
  for (int k = 5; k <= 11; ++k)
    for (std::uint64_t seed = 1; seed <= (k < 11 ? 1500U : 300U); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      const auto c = make_flat_corner(k, static_cast<std::uint64_t>(1000 * k) + seed);
      if (!c || has_different_planes(c->of)) continue;
      ++corners;
      const auto kernel = kernel_of(*c);
      using K = std::remove_cvref_t<decltype(kernel)>;
      const splitter s(kernel, c->of);
      std::set<diagonals> valid;
      std::array<int, 2> most = {-1, -1};
      std::array<std::optional<split_tree>, 2> extreme;
      const auto planes = [&c](const split_tree& t) {
        std::vector<triple> result;
        for (const auto& v : t.vertices) {
          auto& made = result.emplace_back();
          for (std::size_t r = 0; r < 3; ++r) made[r] = c->of.facets[static_cast<std::size_t>(v[r])];
        }
        return result;
      };
      for (const split_tree& t : s.all()) {
        valid.insert(t.operations);
        joined += t.vertices.size() + 2 < static_cast<std::size_t>(k) ? 1 : 0;
        most[0] = std::max(most[0], t.convex_edges());
        most[1] = std::max(most[1], t.reflex_edges());
        for (const std::size_t side : {0U, 1U})
          if (!extreme[side] || kernel.compare_volume(planes(t), planes(*extreme[side])) == (side == 0 ? sign::negative : sign::positive))
            extreme[side] = t;
      }
      split_search<K, edge_count, std::uint64_t> search(s.signs(), edge_count(true));
      const auto accepts = [&s](const diagonals& d) {
        const auto t = s.tree(d);
        return t && s.valid(*t);
      };
      std::set<diagonals> found = listed_by(search);
      std::erase_if(found, [&accepts](const diagonals& d) { return !accepts(d); });
      ASSERT_EQ(found, valid);
      for (const bool convex : {true, false}) {
        const auto best = split_search<K, edge_count>(s.signs(), edge_count(convex)).best(accepts);
        ASSERT_EQ(best.end, valid.empty() ? search_end::none : search_end::best);
        if (valid.empty()) continue;
        const auto t = s.tree(best.tree);
        ASSERT_EQ(convex ? t->convex_edges() : t->reflex_edges(), most[convex ? 0 : 1]);
      }
      for (const bool greatest : {false, true}) {
        const auto best = split_search<K, offset_volume<K>>(s.signs(), offset_volume<K>(s.signs(), greatest)).best(accepts);
        ASSERT_EQ(best.end, valid.empty() ? search_end::none : search_end::best);
        if (valid.empty()) continue;
        ASSERT_EQ(kernel.compare_volume(planes(*s.tree(best.tree)), planes(*extreme[greatest ? 1 : 0])), sign::zero);
      }
    }
  EXPECT_GE(corners, 500);
  EXPECT_GE(joined, 500);
}

void expect_certified(const solid<integer>& s, split_preference preference, bool proven) {
  const auto k = default_kernel(s);
  const auto raw = straight_skeleton(k, s.boundary, preferring(preference));
  const auto broken = verify(k, s.boundary, raw);
  EXPECT_FALSE(broken) << broken->witness;
  if (proven) {
    EXPECT_EQ(raw.unproven_splits, 0);
  }
}

TEST(SplitSearch, SolidsWithVerticesOfHighDegreeAreCertified) {
  for (const char* kind : {"cone", "spire", "peak"})
    for (const int degree : {16, 24, 40, 64, 100})
      for (const std::uint64_t seed : {1U, 2U})
        for (const auto preference : {split_preference::convex, split_preference::reflex}) {
          SCOPED_TRACE(kind + (" of degree " + std::to_string(degree)) + ", seed " + std::to_string(seed));
          const auto& all = models::kinds();
          const auto& k = *std::find_if(all.begin(), all.end(), [kind](const auto& x) { return x.name == kind; });
          expect_certified(make_solid(k.make(degree, seed).take<integer>()), preference, preference == split_preference::convex || degree <= 40);
        }
  for (const auto preference : {split_preference::min_volume, split_preference::max_volume, split_preference::first})
    expect_certified(make_solid(models::peak(20, 1).take<integer>()), preference, true);
}

// A quarter of the facets around the middle lies in the plane z = 0.
TEST(SplitSearch, FacetsMayShareAPlane) {
  for (const int degree : {8, 12, 16, 24, 40})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      models::dice roll(seed);
      std::vector<models::point> rim;
      for (int i = 0; i < degree; ++i) {
        const auto p = models::on_circle(i, degree, static_cast<double>(roll.between(600, 1000)));
        rim.push_back({p[0], p[1], i % 4 < 2 ? 0 : roll.between(-500, 500)});
      }
      expect_certified(make_solid(models::fan_on_plate(rim, -2000).take<integer>()), split_preference::convex, false);
    }
}

// A corner over a convex polygon, and its complement: one tree, found without looking at others.
TEST(OnlySplit, IsTheOneOfTheList) {
  for (int k = 4; k <= 9; ++k)
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed));
      const auto c = make_convex_corner(k, seed);
      for (const bool reflex : {false, true}) {
        const random_corner either = reflex ? complement(c) : c;
        const auto kernel = kernel_of(either);
        const auto all = splitter(kernel, either.of).all();
        ASSERT_EQ(all.size(), 1U);
        ASSERT_EQ(only_split(kernel, either.of), all.front().operations);
      }
    }
}

TEST(OnlySplit, TakesTimeLikeTheDegree) {
  for (const int k : {100, 1000, 10000}) {
    const auto c = make_convex_corner(k, 1);
    const auto tree = preferred_split(kernel_of(c), c.of, split_preference::convex);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->tree.vertices.size(), static_cast<std::size_t>(k) - 2);
  }
}

}  // namespace
}  // namespace osteon::test
