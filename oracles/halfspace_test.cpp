// SPDX-License-Identifier: MIT

// Offsets of convex solids, cut out of their skeletons, against CGAL's intersection of half-spaces.

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cgal_mesh.hpp"
#include "effort.hpp"
#include "offset_mesh.hpp"
#include "test_solids.hpp"

namespace osteon::oracles {
namespace {

using point = exact_kernel::Point_3;
using cycle = std::vector<int>;  // smallest first

/// Points in lexicographic order, and facets as cycles of their numbers.
struct shape {
  std::vector<point> points;
  std::set<cycle> facets;
  friend bool operator==(const shape&, const shape&) = default;
};

class shape_maker {
 public:
  explicit shape_maker(std::vector<point> points) : sorted_(std::move(points)) { std::sort(sorted_.begin(), sorted_.end()); }
  void facet(const std::vector<point>& corners) {
    cycle c;
    for (const auto& p : corners) c.push_back(static_cast<int>(std::lower_bound(sorted_.begin(), sorted_.end(), p) - sorted_.begin()));
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    facets_.insert(c);
  }
  shape take() const { return {sorted_, facets_}; }

 private:
  std::vector<point> sorted_;
  std::set<cycle> facets_;
};

std::vector<exact_kernel::Plane_3> half_spaces(const skeletal_solid& s, const rational& t) {
  const auto speeds = rational_speeds(s.body.planes);
  std::vector<exact_kernel::Plane_3> result;
  for (std::size_t i = 0; i < s.body.planes.size(); ++i) {
    const auto& p = s.body.planes[i];
    result.emplace_back(to_cgal(rational(p.n[0])), to_cgal(rational(p.n[1])), to_cgal(rational(p.n[2])), to_cgal(t * speeds[i] - rational(p.d)));
  }
  return result;
}

shape by_half_spaces(const skeletal_solid& s, const rational& t) {
  const auto planes = half_spaces(s, t);
  exact_mesh m;
  CGAL::halfspace_intersection_3(planes.begin(), planes.end(), m);
  std::vector<point> points;
  for (const auto v : m.vertices()) points.push_back(m.point(v));
  shape_maker maker(points);
  for (const auto f : m.faces()) {
    std::vector<point> corners;
    for (const auto v : m.vertices_around_face(m.halfedge(f))) corners.push_back(m.point(v));
    maker.facet(corners);
  }
  return maker.take();
}

shape by_skeleton(const offset_mesh& m) {
  std::vector<point> points;
  for (const auto& p : m.points) points.push_back(to_cgal(p));
  shape_maker maker(points);
  for (const auto& f : m.facets)
    for (const auto& ring : f.rings) {
      std::vector<point> corners;
      for (const int p : ring) corners.push_back(points[static_cast<std::size_t>(p)]);
      maker.facet(corners);
    }
  return maker.take();
}

TEST(HalfSpaces, OffsetsOfRandomHulls) {
  const int solids = effort(40, 1000);
  long offsets = 0;
  long vertices = 0;
  std::size_t most_facets = 0;
  int skipped = 0;
  int missed = 0;  // on purpose
  for (int i = 0; i < solids; ++i) {
    const auto solid_seed = seed() + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("solid " + std::to_string(i) + ", OSTEON_ORACLE_SEED=" + std::to_string(seed()));
    const auto s = try_skeleton(random_hull(5 + i % 26, solid_seed).take<integer>());
    if (!s) {
      ++skipped;
      continue;
    }
    const auto cutter = s->cutter();
    std::optional<offset_mesh> earlier;
    for (const rational& t : moments(cutter, 6)) {
      const offset_mesh now = cutter.at(t);
      const shape ours = by_skeleton(now);
      const shape theirs = by_half_spaces(*s, t);
      ASSERT_EQ(ours.points.size(), theirs.points.size()) << "at time " << t;
      ASSERT_EQ(ours.facets.size(), theirs.facets.size()) << "at time " << t;
      ASSERT_TRUE(ours.points == theirs.points) << "at time " << t;
      ASSERT_TRUE(ours.facets == theirs.facets) << "at time " << t;
      if (earlier && earlier->arcs != now.arcs) {
        ASSERT_FALSE(by_skeleton(cutter.carried(*earlier, t)) == theirs) << "missed events are not noticed at time " << t;
        ++missed;
      }
      earlier = now;
      ++offsets;
      vertices += static_cast<long>(ours.points.size());
      most_facets = std::max(most_facets, ours.facets.size());
    }
    // Nothing is left just after the end, and something just before.
    const auto late = half_spaces(*s, cutter.last() * rational(1'000'001, 1'000'000));
    EXPECT_FALSE(CGAL::halfspace_intersection_interior_point_3(late.begin(), late.end()));
    const rational before = cutter.last() * rational(999'999, 1'000'000);
    EXPECT_TRUE(by_skeleton(cutter.at(before)) == by_half_spaces(*s, before));
  }
  std::cout << "seed " << seed() << ": " << solids - skipped << " solids, " << offsets << " offsets, " << vertices << " vertices, " << most_facets
            << " facets at most; skipped " << skipped << "\n";
  EXPECT_GT(offsets, 3L * solids);
  EXPECT_GT(missed, solids);
}

}  // namespace
}  // namespace osteon::oracles
