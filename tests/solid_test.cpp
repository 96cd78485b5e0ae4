// SPDX-License-Identifier: MIT
#include "osteon/input/solid.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/write_obj.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {
namespace {

using points = std::vector<std::array<double, 3>>;
using facets = std::vector<std::vector<int>>;

struct model {
  points p;
  facets f;

  /// Adds another, its facets reversed for a void.
  model& add(const model& m, bool reversed = false) {
    const int first = static_cast<int>(p.size());
    p.insert(p.end(), m.p.begin(), m.p.end());
    for (auto loop : m.f) {
      for (int& i : loop) i += first;
      if (reversed) std::reverse(loop.begin(), loop.end());
      f.push_back(loop);
    }
    return *this;
  }
  input_mesh<integer> to_mesh() const { return make_input_mesh<integer>(p, f); }
  solid<integer> to_solid() const { return make_solid(to_mesh()); }
};

model box(std::array<double, 3> lo, std::array<double, 3> hi) {
  model m;
  for (const double z : {lo[2], hi[2]}) m.p.insert(m.p.end(), {{lo[0], lo[1], z}, {hi[0], lo[1], z}, {hi[0], hi[1], z}, {lo[0], hi[1], z}});
  m.f = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return m;
}

model cube() { return box({0, 0, 0}, {1, 1, 1}); }

/// A polygon, counter-clockwise, from z = 0 to 1.
model prism(const std::vector<std::array<double, 2>>& polygon) {
  model m;
  const int n = static_cast<int>(polygon.size());
  m.f.resize(2);
  for (const double z : {0.0, 1.0})
    for (const auto& q : polygon) m.p.push_back({q[0], q[1], z});
  for (int i = 0; i < n; ++i) {
    m.f[0].push_back(n - 1 - i);
    m.f[1].push_back(n + i);
    m.f.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
  }
  return m;
}

/// Every facet as a fan of triangles.
model triangulated(const model& m) {
  model t{m.p, {}};
  for (const auto& loop : m.f)
    for (std::size_t i = 2; i < loop.size(); ++i) t.f.push_back({loop[0], loop[i - 1], loop[i]});
  return t;
}

/// The boundary of a set of unit cells; facets are the cells' sides.
model voxels(const std::set<std::array<int, 3>>& cells) {
  model m;
  std::map<std::array<int, 3>, int> ids;
  for (const auto& c : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        auto next = c;
        next[static_cast<std::size_t>(axis)] += side == 1 ? 1 : -1;
        if (cells.contains(next)) continue;
        std::vector<int> loop;
        for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          auto q = c;
          q[static_cast<std::size_t>(axis)] += side;
          q[static_cast<std::size_t>((axis + 1) % 3)] += u;
          q[static_cast<std::size_t>((axis + 2) % 3)] += v;
          const auto [at, fresh] = ids.emplace(q, static_cast<int>(m.p.size()));
          if (fresh) m.p.push_back({static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])});
          loop.push_back(at->second);
        }
        if (side == 0) std::reverse(loop.begin(), loop.end());
        m.f.push_back(loop);
      }
  return m;
}

void expect_counts(const solid<integer>& s, std::size_t vertices, std::size_t edges, int facet_count, std::size_t planes) {
  EXPECT_EQ(s.boundary.vertices.size(), vertices);
  EXPECT_EQ(s.boundary.edges.size(), edges);
  EXPECT_EQ(s.facets, facet_count);
  EXPECT_EQ(s.planes.size(), planes);
  EXPECT_EQ(static_cast<std::size_t>(s.boundary.planes), planes);
  EXPECT_EQ(s.input_points.size(), vertices);
  EXPECT_EQ(s.points.size(), vertices);
  // What the algorithms rely on.
  for (std::size_t v = 0; v < s.boundary.vertices.size(); ++v) {
    const auto& [around, out] = s.boundary.vertices[v];
    ASSERT_GE(around.size(), 3U);
    ASSERT_EQ(around.size(), out.size());
    for (std::size_t m = 0; m < out.size(); ++m) {
      const auto& e = s.boundary.edges[static_cast<std::size_t>(out[m])];
      EXPECT_TRUE(e.ends[0] == static_cast<int>(v) || e.ends[1] == static_cast<int>(v));
      const std::set<plane_id> two = {around[m], around[(m + 1) % around.size()]};
      EXPECT_EQ(two, (std::set<plane_id>{e.planes[0], e.planes[1]}));
    }
    for (const plane_id p : around) EXPECT_EQ(dot(s.planes[static_cast<std::size_t>(p)].n, s.points[v]), s.planes[static_cast<std::size_t>(p)].d);
  }
}

input_fault fault_of(const input_mesh<integer>& m) {
  try {
    make_solid(m);
  } catch (const input_error& e) {
    return e.fault;
  }
  ADD_FAILURE() << "accepted";
  return {};
}

std::size_t convex_edges(const solid<integer>& s) {
  return static_cast<std::size_t>(std::count_if(s.boundary.edges.begin(), s.boundary.edges.end(), [](const auto& e) { return e.convex; }));
}

TEST(Solid, CoplanarNeighboursAreMerged) {
  expect_counts(cube().to_solid(), 8, 12, 6, 6);
  expect_counts(triangulated(cube()).to_solid(), 8, 12, 6, 6);
  std::set<std::array<int, 3>> cells;
  for (int i = 0; i < 27; ++i) cells.insert({i % 3, i / 3 % 3, i / 9});
  expect_counts(voxels(cells).to_solid(), 8, 12, 6, 6);
}

TEST(Solid, CollinearPointsAreRemoved) {
  expect_counts(prism({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {0, 2}, {0, 1}}).to_solid(), 8, 12, 6, 6);
  model m = cube();  // points on one edge, in both facets
  m.p.push_back({0.25, 0, 0});
  m.p.push_back({0.75, 0, 0});
  m.f[0] = {3, 2, 1, 9, 8, 0};
  m.f[2] = {0, 8, 9, 1, 5, 4};
  const auto s = m.to_solid();
  expect_counts(s, 8, 12, 6, 6);
  EXPECT_EQ(s.input_points, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
}

// The top of a box with a pit: 16 points, its facet with a hole.
TEST(Solid, FacetsMayHaveHoles) {
  model pit = box({0, 0, 0}, {4, 4, 4});
  pit.add(box({1, 1, 2}, {3, 3, 4}), true);
  std::erase(pit.f, std::vector<int>{15, 14, 13, 12});  // the pit's lid
  std::erase(pit.f, std::vector<int>{4, 5, 6, 7});
  model slit = pit;
  slit.f.push_back({4, 5, 6, 7, 4, 12, 15, 14, 13, 12});
  model frame = pit;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    frame.f.push_back({4 + i, 4 + j, 12 + j});
    frame.f.push_back({4 + i, 12 + j, 12 + i});
  }
  for (const auto& m : {slit, frame}) {
    const auto s = m.to_solid();
    expect_counts(s, 16, 24, 11, 11);
    EXPECT_EQ(convex_edges(s), 16U);
  }
  model spur = slit;  // a slit that ends within the facet
  spur.p.push_back({3.5, 3.5, 4});
  spur.f.back() = {4, 5, 6, 16, 6, 7, 4, 12, 15, 14, 13, 12};
  expect_counts(spur.to_solid(), 16, 24, 11, 11);
  spur.p.back() = {4.5, 4.5, 4};  // the same outside
  EXPECT_EQ(fault_of(spur.to_mesh()), input_fault::self_intersection);
  spur.p.back() = {2, 2, 4};  // and across the hole
  EXPECT_EQ(fault_of(spur.to_mesh()), input_fault::self_intersection);
}

TEST(Solid, HolesMayTouchTheOuterLoop) {
  // A square pit whose corner is a corner of the top: the loop passes that point twice.
  model m = box({0, 0, 0}, {4, 4, 4});
  m.p.insert(m.p.end(), {{2, 1, 4}, {2, 2, 4}, {1, 2, 4}, {1.5, 1.5, 3}});
  m.f[1] = {4, 5, 6, 7, 4, 10, 9, 8};
  m.f.insert(m.f.end(), {{4, 8, 11}, {8, 9, 11}, {9, 10, 11}, {10, 4, 11}});
  const auto s = m.to_solid();
  expect_counts(s, 12, 20, 10, 10);
  EXPECT_EQ(s.boundary.vertices[4].facets.size(), 6U);
  m.f[1] = {4, 8, 9, 10, 4, 5, 6, 7};  // the hole the wrong way round
  EXPECT_NE(fault_of(m.to_mesh()), input_fault::unreadable);
}

TEST(Solid, TunnelsVoidsAndSeveralBodies) {
  std::set<std::array<int, 3>> ring;
  for (int i = 0; i < 9; ++i)
    if (i != 4) ring.insert({i % 3, i / 3, 0});
  const auto tunnel = voxels(ring).to_solid();
  expect_counts(tunnel, 16, 24, 10, 10);
  EXPECT_EQ(convex_edges(tunnel), 20U);

  model hollow = box({0, 0, 0}, {5, 5, 5});
  hollow.add(box({1, 1, 1}, {4, 4, 4}), true);
  const auto with_void = hollow.to_solid();
  expect_counts(with_void, 16, 24, 12, 12);
  EXPECT_EQ(convex_edges(with_void), 12U);
  hollow.add(box({2, 2, 2}, {3, 3, 3}));
  expect_counts(hollow.to_solid(), 24, 36, 18, 18);
  hollow.add(box({6, 0, 0}, {7, 5, 1}));  // three sides in planes of the large box, one in that of the void's floor
  const auto two = hollow.to_solid();
  expect_counts(two, 32, 48, 24, 20);
}

TEST(Solid, PlanesAreIdentified) {
  // Two towers of one height: one plane, two facets.
  const auto u = prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const auto s = u.to_solid();
  expect_counts(s, 16, 24, 10, 9);
  EXPECT_EQ(s.facet_planes[4], s.facet_planes[8]);
  EXPECT_EQ(convex_edges(s), 22U);
}

// Three planes, each with two facets at one point.
TEST(Solid, MajorityCornerIsARingOfSixFacets) {
  const auto s = voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).to_solid();
  const vec<integer> middle = {integer(1) - s.shift[0], integer(1) - s.shift[1], integer(1) - s.shift[2]};
  const auto at = std::find(s.points.begin(), s.points.end(), middle);
  ASSERT_NE(at, s.points.end());
  const auto& v = s.boundary.vertices[static_cast<std::size_t>(at - s.points.begin())];
  ASSERT_EQ(v.facets.size(), 6U);
  for (std::size_t m = 0; m < 6; ++m) {
    EXPECT_EQ(v.facets[m], v.facets[(m + 3) % 6]);
    EXPECT_NE(s.boundary.edges[static_cast<std::size_t>(v.edges[m])].convex, s.boundary.edges[static_cast<std::size_t>(v.edges[(m + 1) % 6])].convex);
  }
  EXPECT_EQ(convex_edges(s), s.boundary.edges.size() - 3);
}

TEST(Solid, FlipAndTriangulate) {
  auto m = cube().to_mesh();
  reverse_facets(m);
  EXPECT_EQ(fault_of(m), input_fault::inverted);
  reverse_facets(m);
  EXPECT_NO_THROW(make_solid(m));
  triangulate_facets(m);
  EXPECT_EQ(m.facets.size(), 6U) << "planar facets stay whole";

  auto bent = cube();
  bent.p[6] = {1.25, 1.5, 1.125};
  m = bent.to_mesh();
  m.weights = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(fault_of(m), input_fault::not_planar);
  EXPECT_EQ(triangulate_facets(m), (std::vector<int>{0, 1, 1, 2, 3, 3, 4, 4, 5}));
  EXPECT_EQ(m.facets.size(), 9U);
  EXPECT_EQ(m.weights, (std::vector<integer>{1, 2, 2, 3, 4, 4, 5, 5, 6}));
  expect_counts(make_solid(m), 8, 15, 9, 9);
}

TEST(Solid, TriangulatesFacetsThatAreNotConvex) {
  // A star whose top is bumpy, with points in line.
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 20; ++i)
    star.push_back({std::cos(i * std::numbers::pi / 10) * (i % 2 == 0 ? 3 : 1), std::sin(i * std::numbers::pi / 10) * (i % 2 == 0 ? 3 : 1)});
  model m = prism(star);
  for (std::size_t i = 20; i < 40; ++i) m.p[i][2] += 0.001 * static_cast<double>(i * i % 7);
  auto exact = m.to_mesh();
  EXPECT_EQ(fault_of(exact), input_fault::not_planar);
  triangulate_facets(exact);
  const auto s = make_solid(exact);
  EXPECT_EQ(s.boundary.vertices.size(), 40U);
}

TEST(Solid, DoublesAreTakenExactly) {
  // 0.1 + 0.2 != 0.3: the two points differ by 2^-54, and this is no cube.
  auto m = cube();
  for (auto& p : m.p) p[2] = p[2] == 0 ? 0.3 : 1;
  EXPECT_NO_THROW(m.to_solid());
  m.p[0][2] = 0.1 + 0.2;
  EXPECT_EQ(fault_of(m.to_mesh()), input_fault::not_planar);
  try {
    make_solid(m.to_mesh());
  } catch (const input_error& e) {
    EXPECT_NE(std::string(e.what()).find("e-17"), std::string::npos) << e.what();
  }
  const auto s = box({0.1, -0.7, 1e-300}, {0.3, 4.9e-324, 1e300}).to_solid();
  expect_counts(s, 8, 12, 6, 6);
  EXPECT_THROW(make_input_mesh<integer>({{0, 0, std::nan("")}}, {}), input_error);
}

TEST(Solid, ScaleDoesNotMatter) {
  const auto reference = prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}).to_solid();
  for (const char* scale : {"e-380", "e-12", "e12", "e380"}) {
    std::ostringstream text;
    const auto m = prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});
    for (const auto& p : m.p) text << "v " << p[0] << scale << ' ' << p[1] << scale << ' ' << p[2] << scale << '\n';
    for (const auto& f : m.f) {
      text << 'f';
      for (const int i : f) text << ' ' << i + 1;
      text << '\n';
    }
    std::istringstream in(text.str());
    const auto s = make_solid(read_obj<integer>(in, "scaled"));
    EXPECT_EQ(s.points, reference.points) << scale;
    EXPECT_EQ(s.planes, reference.planes);
    EXPECT_EQ(std::to_string(s.ten), std::string(scale + 1));
  }
}

TEST(Solid, IsWrittenAsItIsRead) {
  const std::string text = "v 0 0 0\nv 15e-1 0 0\nv 0 1 0\nv 0 0 3e2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  std::istringstream in(text);
  const auto m = read_obj<integer>(in, "text");
  std::ostringstream out;
  write_obj(out, m);
  EXPECT_EQ(out.str(), text);
  std::ostringstream doubles;
  write_obj(doubles, points{{0.1, -2, 1e300}}, facets{{0, 2, 1}});
  EXPECT_EQ(doubles.str(), "v 0.1 -2 1e+300\nf 1 3 2\n");
}

// Coordinates mean (coordinate + shift) * 10^ten * 2^two.
TEST(Solid, KnowsTheWayBack) {
  const auto s = box({10.5, -3, 0.25}, {11.5, 7, 0.75}).to_solid();
  EXPECT_EQ(s.ten, 0);
  EXPECT_EQ(s.two, -2);
  const auto& first = s.points[0];
  EXPECT_EQ(integer(first[0] + s.shift[0]), 42);
  EXPECT_EQ(integer(first[1] + s.shift[1]), -12);
  EXPECT_EQ(integer(first[2] + s.shift[2]), 1);
}

TEST(Solid, WeightsArePositiveAndAgreeInAPlane) {
  auto m = triangulated(cube()).to_mesh();
  m.weights.assign(12, 2);
  expect_counts(make_solid(m), 8, 12, 6, 6);
  m.weights[1] = 3;
  EXPECT_EQ(fault_of(m), input_fault::weight_conflict);
  m.weights[0] = 3;
  EXPECT_NO_THROW(make_solid(m));
  m.weights[0] = 0;
  EXPECT_EQ(fault_of(m), input_fault::weight_not_positive);
  m.weights[0] = -1;
  EXPECT_EQ(fault_of(m), input_fault::weight_not_positive);
  m.weights = {1, 1};
  EXPECT_EQ(fault_of(m), input_fault::weight_not_positive) << "too few";

  m = prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}).to_mesh();
  m.weights.assign(10, 1);
  m.weights[4] = 2;  // one of two coplanar facets that are not adjacent
  EXPECT_EQ(make_solid(m).planes.size(), 10U);
}

// Two quadrilaterals cross along the line between two common corners: no edge meets the inside of either.
TEST(Solid, FacetsThatCrossAlongAChordAreRefused) {
  const points p = {{0, 0, 1}, {0, 0, -1}, {1, 1, 0}, {1, -1, 0}, {-2, -2, 0}, {-2, 2, 0}};
  const facets f = {{0, 2, 1, 4}, {0, 4, 3}, {0, 3, 1, 5}, {0, 5, 2}, {1, 3, 4}, {1, 2, 5}};
  EXPECT_EQ(fault_of(make_input_mesh<integer>(p, f)), input_fault::self_intersection);
}

// Inputs at which a quadratic search, or exact arithmetic without a filter, takes minutes.
TEST(Solid, LargeMeshesAreQuick) {
  const auto circle = [](int n) {
    std::vector<std::array<double, 2>> result;
    for (int i = 0; i < n; ++i) result.push_back({std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n)});
    return result;
  };
  const auto begin = std::chrono::steady_clock::now();
  expect_counts(prism(circle(5000)).to_solid(), 10000, 15000, 5002, 5002);
  model needle;  // all of it over one spot of the plane
  for (int i = 0; i < 1000; ++i)
    for (const auto& q : circle(7)) needle.p.push_back({q[0] + 0.01 * (i % 3), q[1], i * 1e6});
  needle.f = {{6, 5, 4, 3, 2, 1, 0}, {6993, 6994, 6995, 6996, 6997, 6998, 6999}};
  for (int i = 0; i < 999; ++i)
    for (int k = 0; k < 7; ++k) {
      const int a = 7 * i + k;
      const int b = 7 * i + (k + 1) % 7;
      needle.f.push_back({a, b, b + 7});
      needle.f.push_back({a, b + 7, a + 7});
    }
  EXPECT_GT(needle.to_solid().points.size(), 6000U);
  auto vast = needle.to_mesh();  // the same where doubles overflow
  for (auto& p : vast.points)
    for (auto& x : p) x.two += 2000;
  vast.points[0][2] = {-1, 0, -1000};
  triangulate_facets(vast);
  EXPECT_GT(make_solid(vast).points.size(), 6000U);
  model many;
  for (int i = 0; i < 1500; ++i) many.add(box({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}));
  EXPECT_EQ(many.to_solid().facets, 9000);
  std::vector<std::array<double, 2>> comb = {{0, -1}, {3000, -1}};
  for (int i = 3000; i >= 0; --i) comb.push_back({static_cast<double>(i), i % 2 * 1e6});
  EXPECT_EQ(prism(comb).to_solid().facets, 3005);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60)) << "measured: 2 s in a release build";
}

}  // namespace
}  // namespace osteon
