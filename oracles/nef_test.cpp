// SPDX-License-Identifier: MIT

// Offsets are nested: a later one lies inside an earlier one, by CGAL's Nef polyhedra.

#include <CGAL/Nef_polyhedron_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cgal_mesh.hpp"
#include "effort.hpp"
#include "test_solids.hpp"

namespace osteon::oracles {
namespace {

using nef = CGAL::Nef_polyhedron_3<exact_kernel>;

struct census {
  int solids = 0;
  int skipped = 0;
  int pairs = 0;
  std::size_t most_triangles = 0;
};

void check(const std::optional<skeletal_solid>& s, int times, census& c) {
  if (!s) {
    ++c.skipped;
    return;
  }
  ++c.solids;
  const auto cutter = s->cutter();
  // The solid itself is the first; later ones do not touch the earlier ones' surface.
  std::optional<nef> earlier;
  std::vector<rational> at = {cutter.last() / 1'000'000};
  for (const auto& t : moments(cutter, times)) at.push_back(t);
  for (const rational& t : at) {
    SCOPED_TRACE("at time " + t.str());
    const auto surface = to_cgal(cutter.at(t), s->body.planes);
    ASSERT_TRUE(surface) << "not a closed surface";
    c.most_triangles = std::max<std::size_t>(c.most_triangles, surface->number_of_faces());
    const nef later(*surface);
    ASSERT_FALSE(later.is_empty());
    ASSERT_TRUE(later.is_bounded());
    if (earlier) {
      EXPECT_TRUE((later - earlier->interior()).is_empty());
      EXPECT_FALSE((*earlier - later).is_empty());
      ++c.pairs;
    }
    earlier = later;
  }
}

void print(const char* what, const census& c) {
  std::cout << what << ", seed " << seed() << ": " << c.solids << " solids (" << c.skipped << " skipped), " << c.pairs << " pairs, "
            << c.most_triangles << " triangles at most\n";
}

TEST(Nested, Balls) {
  census c;
  const int solids = effort(10, 300);
  for (int i = 0; i < solids && !HasFailure(); ++i) {
    SCOPED_TRACE("solid " + std::to_string(i) + ", OSTEON_ORACLE_SEED=" + std::to_string(seed()));
    check(try_skeleton(ball(10 + i % 7, 60, seed() + static_cast<std::uint64_t>(i)).take<integer>()), 3, c);
  }
  print("balls", c);
  EXPECT_GT(c.solids, solids / 2);
}

TEST(Nested, ShakenVoxels) {
  census c;
  const int solids = effort(10, 300);
  for (int i = 0; i < solids && !HasFailure(); ++i) {
    SCOPED_TRACE("solid " + std::to_string(i) + ", OSTEON_ORACLE_SEED=" + std::to_string(seed()));
    const auto stream = seed() + static_cast<std::uint64_t>(i);
    const auto v = models::random_voxels({2, 2, 2}, 60, stream);
    check(try_skeleton(shaken(v.surface(), 10'000, 1500, stream)), 3, c);
  }
  print("shaken voxels", c);
  EXPECT_GT(c.solids, solids / 2);
}

TEST(Nested, ShakenSpikedPlates) {
  census c;
  const int solids = effort(5, 100);
  for (int i = 0; i < solids && !HasFailure(); ++i) {
    SCOPED_TRACE("solid " + std::to_string(i) + ", OSTEON_ORACLE_SEED=" + std::to_string(seed()));
    const auto stream = seed() + static_cast<std::uint64_t>(i);
    check(try_skeleton(shaken(models::spiked_plate(1), 1000, 600, stream)), 3, c);
  }
  print("spiked plates", c);
  EXPECT_GT(c.solids, solids / 2);
}

}  // namespace
}  // namespace osteon::oracles
