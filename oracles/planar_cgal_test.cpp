// SPDX-License-Identifier: MIT

// The planar oracles against CGAL's straight skeletons.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "effort.hpp"
#include "planar_cgal.hpp"
#include "planar_node.hpp"
#include "planar_samples.hpp"
#include "planar_simulate.hpp"
#include "planar_slabs.hpp"

namespace osteon::oracles {
namespace {

class planar_cgal : public testing::Test {
 protected:
  // CGAL has faults of its own where events coincide: where edges on one line merge as a spike between them closes it may keep a face without area,
  // whose end is a node too many; and two reflex vertices that meet may pass each other. So there a difference is excused, if seldom, where the
  // envelope of slabs says what the simulation says.
  void check(const std::string& name, const planar_input& input) {
    if (input.rings.empty()) return;
    SCOPED_TRACE(name);
    ++polygons_;
    const double tolerance = 1e-8 * size_of(input);
    const auto simulated = nodes_by_simulation(input);
    std::vector<planar_node> theirs;
    try {
      theirs = nodes_by_cgal(input);
    } catch (const planar_give_up& e) {
      ++given_up_;
      std::cout << name << ": " << e.what() << "\n";
      return;
    }
    nodes_ += simulated.size();
    const auto difference = compare(input, simulated, theirs, tolerance);
    if (difference) return;
    ++excused_;
    EXPECT_TRUE(coincidences_) << difference.difference;
    EXPECT_TRUE(compare(input, simulated, nodes_by_slabs(input), tolerance)) << difference.difference;
  }
  void TearDown() override {
    std::cout << "seed " << seed() << ": " << polygons_ << " polygons, " << nodes_ << " nodes; CGAL gave up " << given_up_ << " times, was excused "
              << excused_ << " times\n";
    EXPECT_LE(100 * (excused_ + given_up_), polygons_);
  }
  static std::string title(std::uint64_t s) { return "seed " + std::to_string(s); }

  bool coincidences_ = false;  ///< the polygons may have some
  int polygons_ = 0;
  int given_up_ = 0;
  int excused_ = 0;
  std::size_t nodes_ = 0;
};

TEST_F(planar_cgal, plain_polygons) {
  coincidences_ = true;
  for (const auto& s : plain_samples()) check(s.name, s.input);
}

TEST_F(planar_cgal, stars) {
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(100, 5000); ++s)
    check(title(s), {{star_ring(5 + static_cast<int>(s % 60), s)}, {}});
}

TEST_F(planar_cgal, large_stars) {
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(3, 100); ++s) check(title(s), {{star_ring(300, s)}, {}});
}

TEST_F(planar_cgal, grown_polygons) {
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(50, 2000); ++s)
    check(title(s), {{grown_ring(10 + static_cast<int>(s % 40), 1'000'000, s)}, {}});
}

TEST_F(planar_cgal, polygons_of_few_digits) {
  coincidences_ = true;
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(300, 20'000); ++s) check(title(s), {{grown_ring(14, 6, s)}, {}});
}

TEST_F(planar_cgal, holes) {
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(100, 5000); ++s)
    check(title(s), starred_plate(8 + static_cast<int>(s % 10), static_cast<int>(s % 6), s));
}

TEST_F(planar_cgal, grids) {
  coincidences_ = true;
  for (std::uint64_t s = seed(); s < seed() + effort<std::uint64_t>(300, 10'000); ++s)
    check(title(s), grid_outline(3 + static_cast<int>(s % 7), 3 + static_cast<int>(s / 7 % 7), 60 + static_cast<int>(s % 20), s % 2 == 0, s));
}

TEST(planar_times, by_size) {
  using clock = std::chrono::steady_clock;
  const auto milliseconds = [](clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); };
  for (const int n : {10, 30, 100, 300}) {
    const planar_input input = {{star_ring(n, seed())}, {}};
    const auto start = clock::now();
    const auto nodes = nodes_by_simulation(input);
    const auto simulated = clock::now();
    nodes_by_cgal(input);
    const auto theirs = clock::now();
    const planar_slabs slabs(input);
    for (const auto& node : nodes) EXPECT_TRUE(slabs.agrees(node, 1e-12 * size_of(input)));
    const auto checked = clock::now();
    if (n <= 100) slabs.nodes();
    const auto enveloped = clock::now();
    std::cout << n << " edges: simulation " << milliseconds(simulated - start) << " ms, CGAL " << milliseconds(theirs - simulated)
              << " ms, checked by slabs " << milliseconds(checked - theirs) << " ms";
    if (n <= 100) std::cout << ", nodes by slabs " << milliseconds(enveloped - checked) << " ms";
    std::cout << "\n";
  }
}

TEST(planar_cgal_limits, are_named) {
  EXPECT_THROW(nodes_by_cgal({{{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, 1}}}), planar_give_up);
  EXPECT_THROW(nodes_by_cgal({{{{0, 0}, {1, 0}}}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace osteon::oracles
