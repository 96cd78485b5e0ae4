// SPDX-License-Identifier: MIT

// The window: splits, ambiguity, pictures of vertices and events, predicates.

#include <gtest/gtest.h>
#include <osteon/inspect.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "osteon/models/registry.hpp"

namespace osteon::inspect::test {
namespace {

polyhedron model(const models::builder& b) {
  const auto m = b.take<long>();
  std::vector<polyhedron::point> points;
  for (const auto& p : m.points)
    points.push_back({static_cast<double>(p[0].mantissa), static_cast<double>(p[1].mantissa), static_cast<double>(p[2].mantissa)});
  return polyhedron(points, m.facets);
}
polyhedron read(const std::string& name) { return read_polyhedron(std::string(OSTEON_MODELS) + "/" + name); }

polyhedron generated(const std::string& name, int size, std::uint64_t seed) {
  for (const auto& kind : models::kinds())
    if (kind.name == name) return model(kind.make(size, seed));
  throw error("there is no such model");
}

int greatest_vertex(const polyhedron& p) {
  int best = 0;
  for (int v = 0; v < p.vertices(); ++v)
    if (p.degree(v) > p.degree(best)) best = v;
  return best;
}

TEST(Inspect, SplitsOfAVertex) {
  const auto p = read("star.obj");
  const vertex_splits splits(p, greatest_vertex(p));
  ASSERT_GT(splits.degree(), 3);
  EXPECT_FALSE(splits.is_whole());
  EXPECT_EQ(static_cast<int>(splits.planes().size()), splits.degree());
  std::set<split_tree> near;
  int far = 0;
  splits.for_each([&](const split_tree& t, bool is_near) {
    EXPECT_EQ(static_cast<int>(t.size()), splits.degree() - 3);
    is_near ? static_cast<void>(near.insert(t)) : static_cast<void>(++far);
    return false;
  });
  EXPECT_GT(near.size(), 0U);
  EXPECT_LE(near.size() + static_cast<std::size_t>(far), std::stoul(splits.trees()));
  const auto counted = splits.count();
  EXPECT_TRUE(counted.exact);
  EXPECT_EQ(counted.valid, std::to_string(near.size()));
  EXPECT_GE(std::stoul(splits.candidates()), near.size());
  int drawn = 0;
  splits.sample(50, 3, [&](const split_tree& t, bool valid) {
    ++drawn;
    EXPECT_EQ(valid, near.contains(t));
  });
  EXPECT_EQ(drawn, 50);
  for (const auto preference : {split_preference::convex, split_preference::reflex, split_preference::min_volume, split_preference::max_volume}) {
    const auto best = splits.preferred(preference);
    ASSERT_TRUE(best);
    EXPECT_TRUE(best->proven);
    EXPECT_TRUE(near.contains(best->tree));
  }
  int visited = 0;
  splits.for_each([&](const split_tree&, bool) { return ++visited == 1; });
  EXPECT_EQ(visited, 1);
  EXPECT_THROW(vertex_splits(p, p.vertices()), input_error);
}

TEST(Inspect, VerticesOfDegreeThreeStayWhole) {
  const auto p = generated("cube", 1, 1);
  const vertex_splits splits(p, 0);
  EXPECT_TRUE(splits.is_whole());
  EXPECT_EQ(splits.trees(), "1");
  EXPECT_EQ(splits.count().valid, "1");
  EXPECT_EQ(splits.candidates(), "1");
  EXPECT_FALSE(splits.preferred(split_preference::convex));
  splits.for_each([](const split_tree&, bool) {
    ADD_FAILURE();
    return true;
  });
  EXPECT_THROW(splits.spherical(split_preference::convex), unsupported_error);
}

TEST(Inspect, VerticesOfHighDegreeAreSearched) {
  const auto p = generated("cone", 20, 1);
  const vertex_splits splits(p, greatest_vertex(p));
  EXPECT_EQ(splits.degree(), 20);
  EXPECT_FALSE(splits.is_enumerated());
  EXPECT_EQ(splits.trees(), "477638700");
  EXPECT_GE(std::stoul(splits.count().valid), 1U);
  EXPECT_EQ(splits.preferred(split_preference::convex)->tree.size(), 17U);
  unsigned long visited = 0;
  splits.for_each([&](const split_tree&, bool) { return ++visited == 1000; });
  EXPECT_EQ(visited, std::min(1000UL, std::stoul(splits.count().valid)));
}

TEST(Inspect, SphericalPicture) {
  const auto p = read("star.obj");
  const vertex_splits splits(p, greatest_vertex(p));
  for (const auto& eye : {std::optional<std::array<double, 3>>(), std::optional<std::array<double, 3>>({0, 0, 1e200})}) {
    const auto picture = splits.spherical(split_preference::convex, eye);
    EXPECT_EQ(static_cast<int>(picture.nodes.size()), 2 * splits.degree() - 2);
    EXPECT_EQ(static_cast<int>(picture.arcs.size()), 3 * splits.degree() - 3);
    for (const auto& n : picture.nodes) EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-12);
    for (const auto& a : picture.arcs)
      for (const auto& part : a.parts)
        for (const auto& q : part.points) {
          const double front = q[0] * picture.eye[0] + q[1] * picture.eye[1] + q[2] * picture.eye[2];
          EXPECT_TRUE(part.front ? front > -1e-9 : front < 1e-9);
        }
  }
}

TEST(Inspect, Ambiguity) {
  const auto found = count_ambiguity(read("saddle.obj"));
  EXPECT_EQ(found.saddles, skeletonize(read("saddle.obj")).ambiguous());
  const auto star = count_ambiguity(read("star.obj"));
  EXPECT_TRUE(star.splits.exact);
  std::uint64_t product = 1;
  for (const auto& v : star.vertices) {
    EXPECT_GT(v.degree, 3);
    product *= std::stoul(v.splits.valid);
  }
  EXPECT_EQ(star.splits.valid, std::to_string(product));
}

TEST(Inspect, Exploration) {
  const auto p = read("star.obj");
  std::map<std::uint64_t, explored_skeleton> all;
  const auto tried = explore(p, {.skeletons = 3, .seed = 5, .offsets = {0, "0.05"}}, [&](const auto& s) { all[s.seed] = s; });
  EXPECT_GE(tried, all.size());
  EXPECT_GE(all.size(), 1U);
  for (const auto& [seed, s] : all) {
    const auto same = skeletonize(p, {.explore = seed});
    EXPECT_EQ(static_cast<int>(same.raw().nodes().size()), s.nodes);
    EXPECT_EQ(same.ambiguous(), s.saddles);
    ASSERT_EQ(s.volumes.size(), 2U);
    EXPECT_NEAR(s.volumes[1], same.volume("0.05"), 1e-12);
  }
  EXPECT_THROW(explore(p, {.offsets = {-1}}, [](const auto&) {}), input_error);
}

// At an event one cell goes and another comes; all else stays, and solid is never lost on the way into a plane.
TEST(Inspect, PicturesOfEvents) {
  int pictures = 0;
  for (const std::string name : {"star.obj", "saddle.obj", "house-t.obj", "twisted-prism.obj", "voxels.obj"})
    for (const auto kernel : {number_kernel::sqrt, number_kernel::rational}) {
      const auto s = skeletonize(read(name), {.kernel = kernel});
      for (const auto n : s.raw().nodes()) {
        if (n.vertex() >= 0) continue;
        const auto e = picture_of(n);
        ++pictures;
        EXPECT_EQ(e.kind, n.event());
        EXPECT_EQ(e.ambiguous, n.is_ambiguous());
        EXPECT_EQ(std::vector<int>(e.planes.begin(), e.planes.end()), n.planes());
        const unsigned small = static_cast<unsigned>(e.small);
        EXPECT_FALSE(e.after[small]);
        EXPECT_FALSE(e.before[small ^ 15U]);
        for (unsigned c = 0; c < 16; ++c) {
          EXPECT_TRUE(c == small || c == (small ^ 15U) || e.before[c] == e.after[c]);
          for (unsigned q = 0; q < 4; ++q) {
            const unsigned in = c | 1U << q;
            EXPECT_TRUE(c == small || in == small || e.after[c] <= e.after[in]);
          }
        }
      }
      EXPECT_THROW(picture_of(s.nodes()[0]), unsupported_error);
    }
  EXPECT_GT(pictures, 100);
}

TEST(Inspect, Predicates) {
  for (const auto kernel : {number_kernel::sqrt, number_kernel::rational}) {
    const auto space = count_predicates(read("house-t.obj"), {.kernel = kernel});
    EXPECT_GT(space.meetings, 0U);
    EXPECT_GT(space.side, 0U);
    EXPECT_GT(space.compare, 0U);
    EXPECT_GT(space.exact_cross + space.exact_closing + space.exact_orientation + space.exact_offset, 0U);
    const auto plane = count_predicates(polygon({{0, 0}, {7, 0}, {7, 5}, {3, 2}, {0, 5}}), {.kernel = kernel});
    EXPECT_GT(plane.meetings, 0U);
  }
  EXPECT_THROW(count_predicates(read("voxels.obj"), {.kernel = number_kernel::floating}), unsupported_error);
}

}  // namespace
}  // namespace osteon::inspect::test
