// SPDX-License-Identifier: MIT

// The planar oracles against each other, and the comparison against wrong answers.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "planar_node.hpp"
#include "planar_samples.hpp"
#include "planar_simulate.hpp"
#include "planar_slabs.hpp"
#include "planar_triangulate.hpp"

namespace osteon::oracles {
namespace {

constexpr double near = 1e-12;  // of the size; the oracles round only once

/// Nodes as if in general position: one of k faces counts as k - 2 of three.
std::size_t simple_nodes(const std::vector<planar_node>& nodes) {
  std::size_t result = 0;
  for (const auto& n : nodes) result += n.edges.size() - 2;
  return result;
}

void agree(const std::string& name, const planar_input& input, bool all_triples = true) {
  SCOPED_TRACE(name);
  const auto simulated = nodes_by_simulation(input);
  ASSERT_FALSE(simulated.empty());
  const planar_slabs slabs(input);
  for (const auto& n : simulated) EXPECT_TRUE(slabs.agrees(n, near * size_of(input))) << "node at time " << n.time;
  if (all_triples) {
    const auto c = compare(input, simulated, slabs.nodes(), near * size_of(input));
    EXPECT_TRUE(c) << c.difference;
  }
}

TEST(planar_oracles, rectangle) {
  const planar_input input = {{{{0, 0}, {5, 0}, {5, 2}, {0, 2}}}, {}};
  for (const auto& nodes : {nodes_by_simulation(input), nodes_by_slabs(input)}) {
    ASSERT_EQ(nodes.size(), 2U);
    EXPECT_EQ(nodes[0].edges, (std::vector<int>{0, 2, 3}));
    EXPECT_EQ(nodes[1].edges, (std::vector<int>{0, 1, 2}));
    EXPECT_NEAR(nodes[0].x, 1, 1e-15);
    EXPECT_NEAR(nodes[1].x, 4, 1e-15);
    EXPECT_NEAR(nodes[1].y, 1, 1e-15);
    EXPECT_NEAR(nodes[1].time, 1, 1e-15);
  }
}

TEST(planar_oracles, weighted_square) {
  // The long sides meet at time 2: the left one is at x = 2 then, the fast right one at x = 6.
  const planar_input input = {{{{0, 0}, {12, 0}, {12, 4}, {0, 4}}}, {{1, 3, 1, 1}}};
  const auto nodes = nodes_by_simulation(input);
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(nodes[0].edges, (std::vector<int>{0, 2, 3}));
  EXPECT_NEAR(nodes[0].x, 2, 1e-15);
  EXPECT_EQ(nodes[1].edges, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(nodes[1].x, 6, 1e-15);
  EXPECT_THROW(nodes_by_slabs(input), planar_give_up);
}

TEST(planar_oracles, frame_with_ridges) {
  // Around a hole the skeleton is a rectangle: four nodes of four lines.
  const auto nodes = nodes_by_simulation({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}, {}});
  ASSERT_EQ(nodes.size(), 4U);
  for (const auto& n : nodes) EXPECT_EQ(n.edges.size(), 4U);
}

TEST(planar_oracles, agree_on_plain_polygons) {
  for (const auto& s : plain_samples()) agree(s.name, s.input);
}

TEST(planar_oracles, agree_on_stars) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const int n = 5 + static_cast<int>(seed);
    const planar_input input = {{star_ring(n, seed)}, {}};
    agree("star of " + std::to_string(n) + ", seed " + std::to_string(seed), input);
    EXPECT_EQ(simple_nodes(nodes_by_simulation(input)), static_cast<std::size_t>(n) - 2) << "seed " << seed;
  }
}

TEST(planar_oracles, agree_on_large_stars) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) agree("seed " + std::to_string(seed), {{star_ring(250, seed)}, {}}, false);
}

TEST(planar_oracles, agree_on_grown_polygons) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    agree("seed " + std::to_string(seed), {{grown_ring(10 + static_cast<int>(seed), 1'000'000, seed)}, {}});
}

TEST(planar_oracles, agree_on_polygons_of_few_digits) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) agree("seed " + std::to_string(seed), {{grown_ring(14, 6, seed)}, {}});
}

TEST(planar_oracles, agree_on_holes) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const int holes = 1 + static_cast<int>(seed % 5);
    const auto input = starred_plate(12, holes, seed);
    agree("seed " + std::to_string(seed), input);
    EXPECT_EQ(simple_nodes(nodes_by_simulation(input)), edges_of(input).size() - 2 + 2 * static_cast<std::size_t>(holes)) << "seed " << seed;
  }
}

TEST(planar_oracles, agree_on_grids) {
  int used = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto input = grid_outline(3 + static_cast<int>(seed % 5), 3 + static_cast<int>(seed / 5 % 5), 65, seed % 2 == 0, seed);
    if (input.rings.empty()) continue;
    ++used;
    agree("seed " + std::to_string(seed), input);
  }
  EXPECT_GT(used, 100);
}

TEST(planar_oracles, weights_of_one_speed_only_change_time) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    planar_input input = {{star_ring(20, seed)}, {}};
    auto slow = nodes_by_simulation(input);
    input.weights = {std::vector<double>(20, 4.0)};
    const auto fast = nodes_by_simulation(input);
    for (auto& n : slow) n.time /= 4;
    const auto c = compare(input, fast, slow, near * size_of(input));
    EXPECT_TRUE(c) << "seed " << seed << ": " << c.difference;
    for (const auto& n : fast) EXPECT_TRUE(planar_slabs(input).agrees(n, near * size_of(input)));
  }
}

/// With the moving triangulation, which gives up on some coincidences: whether it did not.
bool triangulation_agrees(const std::string& name, const planar_input& input) {
  SCOPED_TRACE(name);
  const auto simulated = nodes_by_simulation(input);
  try {
    const auto c = compare(input, simulated, nodes_by_triangulation(input), near * size_of(input));
    EXPECT_TRUE(c) << c.difference;
    return true;
  } catch (const planar_give_up&) {
    return false;
  }
}

TEST(planar_oracles, triangulation_in_general_position) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    const int n = static_cast<int>(seed);
    for (const planar_input& input : {planar_input{{star_ring(5 + n, seed)}, {}}, planar_input{{grown_ring(10 + n, 1'000'000, seed)}, {}},
                                      starred_plate(8 + n % 10, n % 6, seed)}) {
      EXPECT_TRUE(triangulation_agrees(name, input)) << name;
      EXPECT_TRUE(triangulation_agrees(name + ", with weights", weighted(input, seed))) << name;
    }
  }
  EXPECT_TRUE(triangulation_agrees("large", {{star_ring(250, 1)}, {}}));
}

TEST(planar_oracles, triangulation_where_it_does_not_give_up) {
  int answers = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    answers += triangulation_agrees("seed " + std::to_string(seed), {{grown_ring(14, 6, seed)}, {}}) ? 1 : 0;
  for (const auto& s : plain_samples()) answers += triangulation_agrees(s.name, s.input) ? 1 : 0;
  EXPECT_GT(answers, 30);
  EXPECT_THROW(nodes_by_triangulation({{{{0, 0}, {5, 0}, {5, 2}, {0, 2}}}, {}}), planar_give_up);
}

TEST(planar_oracles, weighted_polygons_have_all_their_nodes) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const int holes = static_cast<int>(seed % 3);
    const auto input = weighted(starred_plate(14, holes, seed), seed);
    EXPECT_EQ(simple_nodes(nodes_by_simulation(input)), edges_of(input).size() - 2 + 2 * static_cast<std::size_t>(holes)) << "seed " << seed;
  }
}

// ---- the comparison can fail

class planted : public testing::Test {
 protected:
  const planar_input input{{star_ring(15, 4)}, {}};
  const std::vector<planar_node> right = nodes_by_simulation(input);
  std::vector<planar_node> wrong = right;
  const double tolerance = 1e-8 * size_of(input);
  bool noticed() const { return !compare(input, right, wrong, tolerance) && !compare(input, wrong, right, tolerance); }
  bool slabs_notice(std::size_t i) const { return !planar_slabs(input).agrees(wrong[i], tolerance); }
};

TEST_F(planted, nothing_is_wrong) {
  EXPECT_TRUE(compare(input, right, right, tolerance));
  EXPECT_FALSE(slabs_notice(5));
}

TEST_F(planted, moved_node) {
  wrong[5].x += 3 * tolerance;
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
  wrong[5].x = right[5].x + tolerance / 3;
  EXPECT_FALSE(noticed());
}

TEST_F(planted, late_node) {
  wrong[5].time += 3 * tolerance;
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
}

TEST_F(planted, missing_and_additional_node) {
  wrong.erase(wrong.begin() + 5);
  EXPECT_TRUE(noticed());
}

TEST_F(planted, wrong_edge) {
  for (int e = 0;; ++e)
    if (std::find(right[5].edges.begin(), right[5].edges.end(), e) == right[5].edges.end()) {
      wrong[5].edges[1] = e;
      break;
    }
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
}

TEST_F(planted, edge_that_is_not_there) {
  wrong[5].edges[0] = 15;
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
}

TEST_F(planted, missing_and_superfluous_edge) {
  wrong[5].edges.pop_back();
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
  wrong = right;
  wrong[5].edges = united(right[5].edges, right[6].edges);
  EXPECT_TRUE(noticed());
  EXPECT_TRUE(slabs_notice(5));
}

TEST_F(planted, not_finite) {
  wrong[5].x = std::nan("");
  EXPECT_TRUE(noticed());
}

TEST(planar_comparison, clusters_count_as_one_node) {
  const planar_input square = {{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {}};
  const std::vector<planar_node> one = {{1, 1, 1, {0, 1, 2, 3}}};
  EXPECT_TRUE(compare(square, one, {{1, 1, 1, {0, 1, 2}}, {1 + 1e-12, 1, 1, {0, 2, 3}}}, 1e-9));
  EXPECT_FALSE(compare(square, one, {{1, 1, 1, {0, 1, 2}}, {1 + 1e-12, 1, 1, {0, 1, 2}}}, 1e-9));
}

TEST(planar_comparison, edges_of_one_line_are_one) {
  const planar_input half = {{{{0, 0}, {3, 0}, {5, 0}, {5, 2}, {0, 2}}}, {}};
  const std::vector<planar_node> ours = {{1, 1, 1, {0, 3, 4}}, {4, 1, 1, {0, 2, 3}}};
  const std::vector<planar_node> theirs = {{1, 1, 1, {0, 3, 4}}, {3, 1, 1, {0, 1, 3}}, {4, 1, 1, {1, 2, 3}}};
  EXPECT_TRUE(compare(half, ours, theirs, 1e-9));
  EXPECT_TRUE(compare(half, nodes_by_simulation(half), theirs, 1e-9));
  EXPECT_TRUE(compare(half, nodes_by_slabs(half), theirs, 1e-9));
}

TEST(planar_lines, are_exact) {
  // The second edge leaves the first one's line in the last digit.
  EXPECT_EQ(lines_of({{{{0, 0}, {1, 1}, {2, 2}, {0, 2}}}, {}}), (std::vector<int>{0, 0, 2, 3}));
  EXPECT_EQ(lines_of({{{{0, 0}, {1, 1}, {2, std::nextafter(2.0, 3.0)}, {0, 2}}}, {}}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(lines_of({{{{0, 0}, {1, 1}, {2, 2}, {0, 2}}}, {{1, 2, 1, 1}}}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(planar_oracles, refuse_what_is_no_polygon) {
  for (const planar_input& bad : {planar_input{}, planar_input{{{{0, 0}, {1, 0}}}, {}}, planar_input{{{{0, 0}, {1, 0}, {1, 0}}}, {}},
                                  planar_input{{{{0, 0}, {1, 0}, {NAN, 1}}}, {}}, planar_input{{{{0, 0}, {1, 0}, {0, 1}}}, {{1, -1, 1}}}}) {
    EXPECT_THROW(nodes_by_simulation(bad), std::invalid_argument);
    EXPECT_THROW(nodes_by_slabs(bad), std::invalid_argument);
    EXPECT_THROW(nodes_by_triangulation(bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace osteon::oracles
