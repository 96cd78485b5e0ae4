// SPDX-License-Identifier: MIT

// The valid trees of pointed corners against thesis 3.2: the weighted skeleton of a section.

#include "section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "arrangement.hpp"
#include "corners.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/split.hpp"

namespace osteon::test {
namespace {

using direction = oracles::section::vector;
using tree = oracles::section::tree;
using diagonals = std::vector<std::pair<int, int>>;

direction cross(const direction& a, const direction& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
integer det(const direction& a, const direction& b, const direction& c) { return inner_product(a, cross(b, c)); }
const direction level = {0, 0, -1};

tree tree_of(const split_tree& t) { return {t.vertices.begin(), t.vertices.end()}; }

diagonals diagonals_of(const tree& t, int k) {
  std::set<std::pair<int, int>> result;
  for (const auto& [a, b, c] : t)
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(a, c)})
      if (j - i > 1 && j - i < k - 1) result.emplace(i, j);
  return {result.begin(), result.end()};
}

/// A corner, the ways to split it, and its sections.
struct pointed_corner {
  explicit pointed_corner(const random_corner& of) : c(of), kernel(make_rational_kernel(c.planes)), splits(kernel, c.of) {
    for (int i = 0; i < kernel.size(); ++i) {
      normals.push_back(c.planes[static_cast<std::size_t>(i)].n);
      speeds.push_back(kernel.arithmetic().speed(i));
    }
  }
  pointed_corner(const pointed_corner&) = delete;
  pointed_corner& operator=(const pointed_corner&) = delete;

  int degree() const { return kernel.size(); }
  bool is_convex() const {
    return std::all_of(c.of.convex.begin(), c.of.convex.end(), [](bool convex) { return convex; });
  }

  /// The tree of a section; nothing where the plane does not cut a polygon out of the solid.
  std::optional<tree> cut(const direction& across, long scale = 1) const {
    const auto s = oracles::section::make(c.rays, normals, speeds, across, scale);
    return s ? std::optional(s->nodes()) : std::nullopt;
  }

  /// Up to `most` directions that cut a polygon out, the level one first.
  std::vector<direction> tilts(std::size_t most, std::uint64_t seed) const {
    models::dice roll(seed);
    std::vector<direction> result = {level};
    for (int tries = 0; tries < 300 && result.size() < most; ++tries) {
      const long width = roll.between(0, 2) == 0 ? 3000 : 300;
      const direction d = {roll.between(-width, width), roll.between(-width, width), roll.between(-1500, 100)};
      if (std::all_of(c.rays.begin(), c.rays.end(), [&d](const direction& r) { return inner_product(d, r) > 0; })) result.push_back(d);
    }
    return result;
  }

  /// Whether the lines of two facets turn left in both sections, or in neither.
  bool turn_alike(int a, int b, const direction& x, const direction& y) const {
    return sign_of(det(x, normals[static_cast<std::size_t>(a)], normals[static_cast<std::size_t>(b)])) ==
           sign_of(det(y, normals[static_cast<std::size_t>(a)], normals[static_cast<std::size_t>(b)]));
  }

  /// Whether a facet of the split corner has a vertex from which both its edges lead towards where the corner was, the facet between them. Seen in
  /// a section, an edge would come from nowhere there, which no wavefront does.
  bool has_births(const split_tree& t, const direction& across) const {
    for (std::size_t v = 0; v < t.vertices.size(); ++v) {
      const auto normal = [&](int r) { return normals[static_cast<std::size_t>(t.vertices[v][static_cast<std::size_t>(r % 3)])]; };
      std::array<bool, 3> convex{};
      std::array<bool, 3> inside{};  // of the edge opposite facet r: whether it runs inside that
      std::array<bool, 3> away{};    // whether it leads to where the section began
      for (int r = 0; r < 3; ++r) {
        convex[r] = t.edges[static_cast<std::size_t>(t.vertex_edges[v][r])].convex;
        inside[r] = convex[r] == (det(normal(0), normal(1), normal(2)) > 0);
        const direction line = cross(normal(r + 1), normal(r + 2));
        away[r] = (inner_product(line, across) > 0) == ((inner_product(line, normal(r)) < 0) == inside[r]);
      }
      for (int r = 0; r < 3; ++r) {
        const int a = (r + 1) % 3;
        const int b = (r + 2) % 3;
        if (!away[a] && !away[b] && inside[a] == convex[b]) return true;
      }
    }
    return false;
  }

  random_corner c;
  rational_kernel kernel;
  splitter<rational_kernel> splits;
  std::vector<direction> normals;
  std::vector<integer> speeds;
};

template <class Visit>
void for_each_corner(int least, int most, std::uint64_t seeds, Visit visit) {
  for (const bool weighted : {false, true})
    for (int k = least; k <= most; ++k)
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed) + (weighted ? ", weighted" : ""));
        if (const auto c = make_pointed_corner(k, static_cast<std::uint64_t>(1000 * k) + seed, weighted ? 5 : 1))
          visit(pointed_corner(*c), weighted, seed);
        if (testing::Test::HasFatalFailure()) return;
      }
}

// Sections see a tree without births only, and of those there is one: as a roof without valleys is over a polygon.
TEST(Section, IsTheValidTreeWithoutBirths) {
  int corners = 0;
  int several = 0;
  for_each_corner(4, 8, 100, [&](const pointed_corner& c, bool, std::uint64_t seed) {
    const auto valid = c.splits.all();
    ++corners;
    several += valid.size() > 1 ? 1 : 0;
    ASSERT_TRUE(valid.size() == 1 || !c.is_convex());
    for (const direction& across : c.tilts(4, seed)) {
      const auto t = c.cut(across);
      ASSERT_TRUE(t);
      ASSERT_EQ(t->size(), static_cast<std::size_t>(c.degree()) - 2);
      ASSERT_EQ(c.cut(across, 12345), t);
      int equal = 0;
      for (const split_tree& v : valid) {
        equal += tree_of(v) == *t ? 1 : 0;
        ASSERT_EQ(c.has_births(v, across), tree_of(v) != *t);
      }
      ASSERT_EQ(equal, 1);
    }
  });
  EXPECT_GE(corners, 950);
  EXPECT_GE(several, 40);
}

// At equal speeds the tree is the same in all planes. To change it, tilting the plane m . x = h, |m| = 1, would have to turn an edge past another one
// that it catches up with, both facing one way: then the new vertex between them runs to the other side. Two such parallel edges meet at a time
// -cos((A - B) / 2) / sin((A + B) / 2) h > h, where A and B are their facets' angles with m, from -90 to 90 degrees. But nothing is left by then: the
// time at which a place is passed is at most its distance from the surface, and so from the half-space m . x < 0, in which nothing of the solid is.
// With weights the tree may change, but only where two facets that became neighbours turn past each other.
TEST(Section, TiltedIsTheSameAtEqualSpeeds) {
  int several = 0;
  int changed = 0;
  for_each_corner(5, 8, 150, [&](const pointed_corner& c, bool weighted, std::uint64_t seed) {
    if (c.splits.all().size() == 1) return;
    ++several;
    const auto tilts = c.tilts(20, seed);
    std::vector<tree> trees;
    for (const direction& across : tilts) trees.push_back(c.cut(across).value());
    ASSERT_TRUE(weighted || std::set<tree>(trees.begin(), trees.end()).size() == 1);
    for (std::size_t i = 0; i < tilts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto pairs = diagonals_of(trees[i], c.degree());
        const auto alike = [&](const auto& p) { return c.turn_alike(p.first, p.second, tilts[i], tilts[j]); };
        ASSERT_TRUE(trees[i] == trees[j] || !std::all_of(pairs.begin(), pairs.end(), alike));
        changed += trees[i] != trees[j] ? 1 : 0;
      }
  });
  EXPECT_GE(several, 60);
  EXPECT_GE(changed, 1);
}

// Thesis 3.2 has it that tilting the plane does not matter, but proves that for equal speeds. Here facet 0 catches up with facet 2, which is parallel
// to it in the level plane.
TEST(Section, TiltedMayDifferWithWeights) {
  const std::vector<direction> rays = {{1, 2, -1}, {0, 1, -1}, {0, 0, -1}, {-2, -2, -1}, {1, -1, -1}};
  const direction to_one_side = {-5, 1, -8};
  const direction to_the_other = {-1, 2, -4};
  const tree one = {{0, 1, 2}, {0, 2, 4}, {2, 3, 4}};
  const tree other = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  for (const int weight : {1, 3}) {
    random_corner c;
    c.rays = rays;
    for (std::size_t i = 0; i < 5; ++i) {
      c.planes.push_back({cross(rays[i], rays[(i + 1) % 5]), 0, i == 0 ? weight : 1});
      c.of.facets.push_back(static_cast<int>(i));
      c.of.convex.push_back(i != 1);
    }
    const pointed_corner corner(c);
    ASSERT_FALSE(corner.turn_alike(0, 2, to_one_side, to_the_other));
    std::set<tree> valid;
    for (const split_tree& t : corner.splits.all()) valid.insert(tree_of(t));
    std::set<tree> seen;
    for (const direction& across : {to_one_side, to_the_other}) seen.insert(corner.cut(across).value());
    EXPECT_EQ(seen, valid);
    if (weight == 1) {
      EXPECT_EQ(valid.size(), 1U);
      continue;
    }
    EXPECT_EQ(oracles::arrangement(rays, corner.normals, corner.speeds).selections(), valid);
    EXPECT_EQ(corner.cut(to_one_side), one);
    EXPECT_EQ(corner.cut(to_the_other), other);
  }
}

// Where lists are too long: what the section sees is valid, and not preferred to the tree that is taken.
TEST(Section, IsNotBetterThanThePreferredTree) {
  int corners = 0;
  for_each_corner(9, 16, 5, [&](const pointed_corner& c, bool, std::uint64_t seed) {
    for (const direction& across : c.tilts(2, seed)) {
      const auto seen = c.splits.tree(diagonals_of(c.cut(across).value(), c.degree()));
      ASSERT_TRUE(seen && c.splits.valid(*seen));
      const auto taken = [&](split_preference p) { return preferred_split(c.kernel, c.c.of, p).value().tree; };
      ASSERT_GE(taken(split_preference::convex).convex_edges(), seen->convex_edges());
      ASSERT_GE(taken(split_preference::reflex).reflex_edges(), seen->reflex_edges());
      const auto least = taken(split_preference::min_volume).vertices;
      const auto most = taken(split_preference::max_volume).vertices;
      ASSERT_NE(c.kernel.compare_volume(least, seen->vertices), sign::positive);
      ASSERT_NE(c.kernel.compare_volume(most, seen->vertices), sign::negative);
    }
    ++corners;
  });
  EXPECT_GE(corners, 75);
}

TEST(Section, IsTheOnlySplitOfAConvexCorner) {
  for (const int k : {4, 5, 6, 7, 8, 12, 20, 40})
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      for (const long fastest : {1, 5}) {
        SCOPED_TRACE("degree " + std::to_string(k) + ", seed " + std::to_string(seed) + ", speeds up to " + std::to_string(fastest));
        const pointed_corner c(make_round_corner(k, seed, fastest).value());
        ASSERT_TRUE(c.is_convex());
        for (const direction& across : c.tilts(3, seed)) ASSERT_EQ(diagonals_of(c.cut(across).value(), k), only_split(c.kernel, c.c.of));
      }
}

// The comparison notices: a tree with one edge flipped is refused wherever the list does not have it, and a section with one facet at twice its speed
// is often another one.
TEST(Section, NoticesFlipsAndWrongSpeeds) {
  int flips = 0;
  int refused = 0;
  int noticed = 0;
  for_each_corner(4, 8, 40, [&](const pointed_corner& c, bool, std::uint64_t) {
    std::set<tree> valid;
    for (const split_tree& t : c.splits.all()) valid.insert(tree_of(t));
    const int k = c.degree();
    const tree seen = c.cut(level).value();
    for (const auto& [a, b] : diagonals_of(seen, k)) {
      tree flipped;
      std::set<int> ends;
      for (const auto& v : seen) {
        const bool beside = std::count(v.begin(), v.end(), a) + std::count(v.begin(), v.end(), b) == 2;
        if (!beside) flipped.insert(v);
        for (const int f : v)
          if (beside && f != a && f != b) ends.insert(f);
      }
      ASSERT_EQ(ends.size(), 2U);
      for (const int f : {a, b}) {
        std::array<int, 3> v = {*ends.begin(), *ends.rbegin(), f};
        std::sort(v.begin(), v.end());
        flipped.insert(v);
      }
      const auto t = c.splits.tree(diagonals_of(flipped, k));
      const bool accepted = t && c.splits.valid(*t);
      ASSERT_EQ(accepted, valid.contains(flipped));
      ASSERT_FALSE(accepted && c.is_convex());
      ++flips;
      refused += accepted ? 0 : 1;
    }
    std::vector<integer> speeds = c.speeds;
    speeds[0] *= 2;
    const auto wrong = oracles::section::make(c.c.rays, c.normals, speeds, level);
    ASSERT_TRUE(wrong);
    noticed += valid.contains(wrong->nodes()) ? 0 : 1;
  });
  EXPECT_GE(flips, 1100);
  EXPECT_GE(refused, flips * 9 / 10);
  EXPECT_GE(noticed, 100);
  RecordProperty("flips", flips);
  RecordProperty("refused", refused);
  RecordProperty("noticed", noticed);
}

}  // namespace
}  // namespace osteon::test
