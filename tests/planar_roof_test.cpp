// SPDX-License-Identifier: MIT

// Roofs: closed, with the volume under the offsets; gables, walls, holes, chimneys; triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/offset.hpp"
#include "osteon/evaluate/roof.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/propagate.hpp"
#include "planar_polygons.hpp"

namespace osteon::plane {
namespace {

using models::region;

struct case_of {
  polygon<integer> p;
  skeleton raw;
  contracted_skeleton s;
  explicit case_of(const rings<integer>& r) : p(make_polygon(r)) {
    const std::span<const moving_line<integer>> lines(p.lines);
    const auto k = perturbed(filtered(lines, make_sqrt_kernel(lines)));
    const vertex_enclosures m(lines, p.points);
    raw = propagation(k, p.boundary, m).run();
    s = contract(k.base(), p.boundary.line, raw);
  }
  roof_mesh roof(const roof_options& options = {}) const { return make_roof(p, raw, s, options); }
};

// Polygons with a part that edges of weight zero enclose have no skeleton.
std::unique_ptr<case_of> skeleton_if_any(const rings<integer>& r) {
  try {
    return std::make_unique<case_of>(r);
  } catch (const unsupported_error&) {
    return nullptr;
  }
}

rings<integer> weighted(const region& r, const std::vector<std::vector<long>>& weights) {
  auto result = models::take<integer>(r);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (const long w : weights[i]) result.all[i].weights.push_back({integer(w), 0, 0});
  return result;
}

// What is wrong with a closed surface; empty: nothing.
std::string fault_of(const roof_mesh& m) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& f : m.faces) {
    if (f.corners.size() < 3) return "a face with less than three corners";
    for (std::size_t i = 0; i < f.corners.size(); ++i) {
      const int a = f.corners[i];
      const int b = f.corners[(i + 1) % f.corners.size()];
      if (a < 0 || a >= static_cast<int>(m.points.size()) || a == b) return "a face with an edge from " + std::to_string(a) + " to itself";
      if (++edges[{a, b}] > 1) return "an edge passed twice, " + std::to_string(a) + " - " + std::to_string(b);
    }
  }
  for (const auto& [e, n] : edges)
    if (!edges.contains({e.second, e.first})) return "an open edge, " + std::to_string(e.first) + " - " + std::to_string(e.second);
  return "";
}

double volume(const roof_mesh& m) {
  double sum = 0;
  const auto& o = m.points[0];
  const auto at = [&](int i, std::size_t axis) { return m.points[i][axis] - o[axis]; };
  for (const auto& f : m.faces)
    for (std::size_t i = 1; i + 1 < f.corners.size(); ++i) {
      const int a = f.corners[0];
      const int b = f.corners[i];
      const int c = f.corners[i + 1];
      sum += at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) + at(a, 1) * (at(b, 2) * at(c, 0) - at(b, 0) * at(c, 2)) +
             at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
    }
  return sum / 6;
}

// How far the corners of faces are from a plane at most.
double unevenness(const roof_mesh& m) {
  double most = 0;
  for (const auto& f : m.faces) {
    std::array<double, 3> n{};
    const auto& o = m.points[f.corners[0]];
    for (std::size_t i = 0; i < f.corners.size(); ++i) {
      const auto& a = m.points[f.corners[i]];
      const auto& b = m.points[f.corners[(i + 1) % f.corners.size()]];
      for (std::size_t x = 0; x < 3; ++x) {
        const std::size_t y = (x + 1) % 3;
        const std::size_t z = (x + 2) % 3;
        n[x] += (a[y] - o[y]) * (b[z] - o[z]) - (a[z] - o[z]) * (b[y] - o[y]);
      }
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length == 0) continue;
    for (const int c : f.corners) {
      double d = 0;
      for (std::size_t x = 0; x < 3; ++x) d += n[x] * (m.points[c][x] - o[x]);
      // Slivers have no plane: their width counts.
      most = std::max(most, std::min(std::abs(d) / length, std::sqrt(length)));
    }
  }
  return most;
}

// The integral of the offsets' areas: between events the area is a quadratic function of time.
double volume_under(const case_of& c) {
  const offsets o(c.p, c.raw);
  const auto area = [&](const rational& t) {
    double sum = 0;
    for (const auto& r : o.at(t).rings) {
      const auto& q = r.points[0];
      for (std::size_t i = 1; i + 1 < r.points.size(); ++i)
        sum += (r.points[i][0] - q[0]) * (r.points[i + 1][1] - q[1]) - (r.points[i][1] - q[1]) * (r.points[i + 1][0] - q[0]);
    }
    return sum / 2;
  };
  std::vector<double> times = {0};
  for (const auto& n : c.s.nodes)
    if (n.vertex < 0) times.push_back(o.places().meeting(n.lines).time);
  std::sort(times.begin(), times.end());
  double sum = 0;
  double first = area(0);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double h = times[i + 1] - times[i];
    if (h <= 0) continue;
    const double last = area(rational(times[i + 1]));
    sum += h * (first + 4 * area((rational(times[i]) + rational(times[i + 1])) / 2) + last) / 6;
    first = last;
  }
  return sum;
}

int count(const roof_mesh& m, roof_mesh::kind k) {
  return static_cast<int>(std::count_if(m.faces.begin(), m.faces.end(), [k](const auto& f) { return f.what == k; }));
}

int euler(const roof_mesh& m) {
  std::set<std::pair<int, int>> edges;
  std::set<int> used;
  for (const auto& f : m.faces)
    for (std::size_t i = 0; i < f.corners.size(); ++i) {
      const int a = f.corners[i];
      const int b = f.corners[(i + 1) % f.corners.size()];
      edges.emplace(std::min(a, b), std::max(a, b));
      used.insert(a);
    }
  EXPECT_EQ(used.size(), m.points.size());
  return static_cast<int>(m.points.size()) - static_cast<int>(edges.size()) + static_cast<int>(m.faces.size());
}

// ---- simple shapes

TEST(planar_roof, pyramid) {
  const case_of c(models::take<integer>(region{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}}));
  const auto m = c.roof();
  EXPECT_EQ(fault_of(m), "");
  EXPECT_EQ(m.faces.size(), 5U);
  EXPECT_EQ(m.points.size(), 5U);
  EXPECT_DOUBLE_EQ(volume(m), 36);
  EXPECT_DOUBLE_EQ(volume(c.roof({.slope = 2, .eaves = 5})), 72);
  const auto house = c.roof({.slope = 1, .eaves = 5, .walls = true});
  EXPECT_EQ(fault_of(house), "");
  EXPECT_DOUBLE_EQ(volume(house), 36 + 180);
  EXPECT_EQ(count(house, roof_mesh::kind::wall), 4);
  EXPECT_EQ(euler(house), 2);
  const auto triangles = c.roof({.slope = 1, .eaves = 5, .walls = true, .triangulate = true});
  EXPECT_EQ(fault_of(triangles), "");
  EXPECT_EQ(triangles.faces.size(), 4U + 8U + 2U);
  EXPECT_DOUBLE_EQ(volume(triangles), 216);
  EXPECT_THROW(c.roof({.slope = 0}), input_error);
  EXPECT_THROW(c.roof({.slope = 1, .eaves = 0, .walls = true}), input_error);
}

TEST(planar_roof, hip_and_gable) {
  const region r = {{{0, 0}, {10, 0}, {10, 4}, {0, 4}}};
  const case_of hip(models::take<integer>(r));
  const auto m = hip.roof();
  EXPECT_EQ(fault_of(m), "");
  EXPECT_EQ(m.points.size(), 6U);
  EXPECT_EQ(m.faces.size(), 5U);
  EXPECT_NEAR(volume(m), 4 * 2 / 2.0 * 6 + 4 * 4 * 2 / 3.0, 1e-12);
  const case_of gable(weighted(r, {{1, 0, 1, 0}}));
  const auto g = gable.roof();
  EXPECT_EQ(fault_of(g), "");
  EXPECT_EQ(g.points.size(), 6U);
  EXPECT_EQ(g.faces.size(), 5U);
  EXPECT_NEAR(volume(g), 4 * 2 / 2.0 * 10, 1e-12);
  EXPECT_EQ(euler(g), 2);
}

TEST(planar_roof, court) {
  // A square ring: the floor has a hole.
  const case_of c(models::take<integer>(region{{{0, 0}, {30, 0}, {30, 30}, {0, 30}}, {{10, 10}, {10, 20}, {20, 20}, {20, 10}}}));
  const auto m = c.roof({.slope = 1, .eaves = 3, .walls = true});
  EXPECT_EQ(fault_of(m), "");
  EXPECT_EQ(euler(m), 0);
  EXPECT_NEAR(volume(m), volume_under(c) + 3 * 800, 1e-9);
  std::ostringstream text;
  write_obj(text, m);
  std::istringstream in(text.str());
  EXPECT_EQ(read_obj<integer>(in, "roof").facets.size(), m.faces.size());
}

// A moving edge passes a chimney that is held: its face has a hole.
TEST(planar_roof, chimney) {
  const case_of c(weighted({{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{8, 7}, {7, 11}, {10, 14}, {12, 9}}}, {{1, 0, 0, 0}, {0, 0, 0, 0}}));
  for (const bool triangulate : {false, true}) {
    const auto m = c.roof({.slope = 1, .eaves = 1, .walls = true, .triangulate = triangulate});
    EXPECT_EQ(fault_of(m), "");
    EXPECT_EQ(euler(m), 0);
    EXPECT_NEAR(volume(m), volume_under(c) + 400 - 19.5, 1e-9);
  }
}

TEST(planar_roof, slopes) {
  EXPECT_EQ(weight_of_slope(90), 0);
  EXPECT_EQ(weight_of_slope(45), 1);
  EXPECT_NEAR(weight_of_slope(30), std::sqrt(3.0), 1e-15);
  EXPECT_THROW(weight_of_slope(0), input_error);
  EXPECT_THROW(weight_of_slope(std::nan("")), input_error);
  // A ridge between slopes of 30 and 60 degrees over a width of 8: it is 2 * sqrt(3) high.
  auto r = models::take<integer>(region{{{0, 0}, {10, 0}, {10, 8}, {0, 8}}});
  for (const double degrees : {30, 90, 60, 90}) r.all[0].weights.push_back(*from_double<integer>(weight_of_slope(degrees)));
  const auto m = case_of(r).roof();
  EXPECT_EQ(fault_of(m), "");
  EXPECT_NEAR(volume(m), 8 * 2 * std::sqrt(3.0) / 2 * 10, 1e-12);
}

// Triangles of a polygon whose every side counts: a spiral, a comb, many holes; in a moment.
TEST(planar_roof, triangles_of_large_floors) {
  for (const auto& [name, r] : {std::pair("spiral", models::spiral(20000, 1)), std::pair("comb", models::comb(20000, 1)),
                                std::pair("holes", models::jittered_holes(40, 1)), std::pair("grid", models::grid_of_holes(40))}) {
    SCOPED_TRACE(name);
    std::vector<flat_point> points;
    std::vector<std::vector<int>> rings;
    double area = 0;
    for (const auto& ring : r) {
      rings.emplace_back();
      for (const auto& p : ring) {
        rings.back().push_back(static_cast<int>(points.size()));
        points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1])});
      }
      area += static_cast<double>(test::doubled_area(ring));
    }
    const auto triangles = ear_clipping(points).run(rings[0], {rings.begin() + 1, rings.end()});
    EXPECT_EQ(triangles.size(), points.size() - 2 + 2 * (rings.size() - 1));
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      EXPECT_EQ(turn_of(points[a], points[b], points[c]), sign::positive);
      sum += (points[b][0] - points[a][0]) * (points[c][1] - points[a][1]) - (points[b][1] - points[a][1]) * (points[c][0] - points[a][0]);
    }
    EXPECT_NEAR(sum, area, 1e-9 * area);
  }
}

// ---- all kinds of polygons

class planar_roofs : public testing::TestWithParam<std::pair<test::shape, test::weighting>> {};

TEST_P(planar_roofs, closed_and_full) {
  const auto [shape, weighting] = GetParam();
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto sample = test::sample(shape, weighting, seed);
    SCOPED_TRACE(sample.name);
    const auto c = skeleton_if_any(sample.rings);
    if (!c) continue;
    const auto m = c->roof();
    ASSERT_EQ(fault_of(m), "");
    double size = 0;
    double height = 0;
    for (const auto& p : m.points) {
      size = std::max({size, std::abs(p[0]), std::abs(p[1])});
      height = std::max(height, p[2]);
    }
    EXPECT_GT(volume(m), 0);
    EXPECT_NEAR(volume(m), volume_under(*c), 1e-10 * size * size * height);
    EXPECT_LT(unevenness(m), 1e-7 * std::max(size, height));
    const auto t = c->roof({.slope = 2, .eaves = size, .walls = true, .triangulate = true});
    ASSERT_EQ(fault_of(t), "");
    for (const auto& f : t.faces) EXPECT_EQ(f.corners.size(), 3U);
    double area = 0;
    for (const auto& r : sample.points) area += static_cast<double>(test::doubled_area(r)) / 2;
    EXPECT_NEAR(volume(t), 2 * volume(m) + size * area, 1e-10 * size * size * (height + size));
    // Seen from below, the floor is as large as the polygon, and so are its triangles in sum: none is turned over.
    double floor = 0;
    for (const auto& f : t.faces) {
      if (f.what != roof_mesh::kind::floor) continue;
      const auto& a = t.points[f.corners[0]];
      const auto& b = t.points[f.corners[1]];
      const auto& d = t.points[f.corners[2]];
      floor += std::abs((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0])) / 2;
    }
    EXPECT_NEAR(floor, area, 1e-10 * size * size);
    const auto mirrored = c->roof({.slope = 1, .eaves = size, .walls = seed % 2 == 0, .most_effort = 0});
    ASSERT_EQ(fault_of(mirrored), "");
    EXPECT_NEAR(volume(mirrored), volume(m) + (seed % 2 == 0 ? size * area : 0), 1e-10 * size * size * (height + size));
  }
}

INSTANTIATE_TEST_SUITE_P(all, planar_roofs, testing::ValuesIn(test::shapes_and_weightings()),
                         [](const auto& p) { return test::name_of(p.param.first) + "_" + test::name_of(p.param.second); });

}  // namespace
}  // namespace osteon::plane
