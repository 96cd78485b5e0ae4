// SPDX-License-Identifier: MIT

// Polyhedra through the front door: values, errors, views, offsets against independent volumes, certificates, documents.

#include <gtest/gtest.h>
#include <osteon/osteon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "osteon/models/registry.hpp"
#include "voxel_erosion.hpp"

namespace osteon::test {
namespace {

using point = polyhedron::point;
using facet_list = std::vector<std::vector<int>>;

const std::vector<point> cube_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const facet_list cube_facets = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
polyhedron cube() { return polyhedron(cube_points, cube_facets); }

polyhedron model(const models::builder& b) {
  const auto m = b.take<long>();
  std::vector<point> points;
  for (const auto& p : m.points)
    points.push_back({static_cast<double>(p[0].mantissa), static_cast<double>(p[1].mantissa), static_cast<double>(p[2].mantissa)});
  return polyhedron(points, m.facets);
}

template <class F>
std::optional<input_fault> fault_of(F f) {
  try {
    f();
  } catch (const input_error& e) {
    return e.fault;
  }
  return std::nullopt;
}

double volume_of(const mesh& m) {
  double sum = 0;
  for (const auto& f : m.facets)
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
      const auto& o = m.points[f[0]];
      const auto& a = m.points[f[i]];
      const auto& b = m.points[f[i + 1]];
      sum += o[0] * (a[1] * b[2] - a[2] * b[1]) + o[1] * (a[2] * b[0] - a[0] * b[2]) + o[2] * (a[0] * b[1] - a[1] * b[0]);
    }
  return sum / 6;
}

// Every edge is passed as often one way as the other; once, but where a surface touches itself along an edge.
void expect_closed(const mesh& m, bool once = true) {
  std::map<std::pair<int, int>, int> passed;
  std::set<int> used;
  for (const auto& f : m.facets) {
    EXPECT_GE(f.size(), 3U);
    for (std::size_t i = 0; i < f.size(); ++i) {
      ++passed[{f[i], f[(i + 1) % f.size()]}];
      used.insert(f[i]);
    }
  }
  for (const auto& [edge, times] : passed) {
    EXPECT_NE(edge.first, edge.second);
    EXPECT_TRUE(!once || times == 1);
    const auto back = passed.find({edge.second, edge.first});
    ASSERT_TRUE(back != passed.end());
    EXPECT_EQ(times, back->second);
  }
  EXPECT_EQ(used.size(), m.points.size());
  EXPECT_EQ(m.source.size(), m.facets.size());
}

TEST(DoorPolyhedron, CubeAsExpected) {
  const auto s = skeletonize(cube());
  ASSERT_EQ(s.nodes().size(), 9U);
  EXPECT_EQ(s.arcs().size(), 8U);
  EXPECT_EQ(s.sheets().size(), 12U);
  EXPECT_EQ(s.cells().size(), 6U);
  int centres = 0;
  for (const auto n : s.nodes()) {
    if (n.vertex() >= 0) {
      EXPECT_EQ(n.point(), cube_points[static_cast<std::size_t>(n.vertex())]);
      EXPECT_EQ(n.event(), event_kind::vertex);
      EXPECT_EQ(n.planes().size(), 3U);
      continue;
    }
    ++centres;
    EXPECT_EQ(n.point(), (point{0.5, 0.5, 0.5}));
    EXPECT_EQ(n.time(), 0.5);
    EXPECT_EQ(n.time_exact(4), "0.5000");
    EXPECT_EQ(n.point_exact(0), (std::array<std::string, 3>{"1", "1", "1"}));
    EXPECT_EQ(n.event(), event_kind::merged);
    EXPECT_EQ(n.planes().size(), 6U);
    EXPECT_EQ(n.arcs().size(), 8U);
    EXPECT_GT(n.raw_nodes().size(), 1U);
  }
  EXPECT_EQ(centres, 1);
  for (const auto c : s.cells()) {
    EXPECT_EQ(c.sheets().size(), 4U);
    EXPECT_EQ(c.facets().size(), 1U);
    EXPECT_EQ(s.input().plane_of(c.facets()[0]), c.id());
  }
  EXPECT_FALSE(s.verify());
  EXPECT_EQ(*s.options().saddle, saddle_rule::convex);
}

// The insphere of a corner of a cube: 1 / (3 + sqrt 3).
TEST(DoorPolyhedron, ExactDigits) {
  const auto s = skeletonize(polyhedron({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}));
  ASSERT_EQ(s.nodes().size(), 5U);
  const auto centre = s.nodes()[4];
  EXPECT_EQ(centre.event(), event_kind::E6);
  EXPECT_EQ(centre.time_exact(30), "0.211324865405187117745425609749");
  EXPECT_EQ(centre.point_exact(30)[2], "0.211324865405187117745425609749");
  EXPECT_DOUBLE_EQ(centre.time(), 1 / (3 + std::sqrt(3.0)));
}

TEST(DoorPolyhedron, ViewsAreConsistent) {
  for (const auto& entry : std::filesystem::directory_iterator(OSTEON_MODELS)) {
    SCOPED_TRACE(entry.path().string());
    const auto p = read_polyhedron(entry.path().string());
    const auto exact = skeletonize(p, {.prefer = split_preference::min_volume});
    for (const auto& s : {exact, exact.raw()}) {
      std::map<int, std::set<int>> arcs_at;
      std::map<int, std::set<int>> arcs_of;
      for (const auto a : s.arcs()) {
        for (const auto& n : {a.source(), a.target()}) arcs_at[n.id()].insert(a.id());
        EXPECT_LE(a.source().time(), a.target().time() * (1 + 1e-14));
        for (const auto& t : a.sheets()) {
          arcs_of[t.id()].insert(a.id());
          for (const int plane : t.planes()) EXPECT_TRUE(std::ranges::count(a.planes(), plane) == 1);
        }
      }
      for (const auto n : s.nodes()) {
        std::set<int> found;
        for (const auto& a : n.arcs()) found.insert(a.id());
        EXPECT_EQ(found, arcs_at[n.id()]);
      }
      std::size_t sides = 0;
      for (const auto c : s.cells()) sides += c.sheets().size();
      EXPECT_EQ(sides, 2 * s.sheets().size());
      for (const auto t : s.sheets()) {
        std::set<int> found;
        for (const auto& a : t.arcs()) found.insert(a.id());
        EXPECT_EQ(found, arcs_of[t.id()]);
      }
    }
    int events = 0;
    for (int k = 0; k <= static_cast<int>(event_kind::merged); ++k) events += exact.events(static_cast<event_kind>(k));
    EXPECT_EQ(events + p.vertices(), static_cast<int>(exact.raw().nodes().size()));
    int edges = 0;
    for (const auto t : exact.raw().sheets()) edges += t.input_edge() ? 1 : 0;
    EXPECT_EQ(edges, p.edges());
    EXPECT_FALSE(exact.verify());
  }
}

TEST(DoorPolyhedron, InputAndRepairs) {
  const auto p = cube();
  EXPECT_EQ(p.vertices(), 8);
  EXPECT_EQ(p.edges(), 12);
  EXPECT_EQ(p.facets(), 6);
  EXPECT_EQ(p.planes(), 6);
  EXPECT_EQ(p.degree(0), 3);
  for (int v = 0; v < 8; ++v) EXPECT_EQ(p.vertex_at(p.point_of(v)), v);
  for (int f = 0; f < 6; ++f) EXPECT_EQ(p.facets_in(p.plane_of(f)), std::vector<int>{f});
  EXPECT_EQ(fault_of([&] { static_cast<void>(p.vertex_at(8)); }), input_fault::bad_index);
  EXPECT_EQ(fault_of([&] { static_cast<void>(p.plane_of(6)); }), input_fault::bad_index);
  EXPECT_EQ(fault_of([&] { static_cast<void>(p.facets_in(-1)); }), input_fault::bad_index);
  EXPECT_EQ(fault_of([&] { static_cast<void>(p.degree(8)); }), input_fault::bad_index);
  auto inwards = cube_facets;
  for (auto& f : inwards) std::reverse(f.begin(), f.end());
  EXPECT_EQ(fault_of([&] { polyhedron(cube_points, inwards); }), input_fault::inverted);
  EXPECT_EQ(polyhedron(cube_points, inwards, {.flip = true}).vertices(), 8);
  auto bent = cube_points;
  bent[6] = {1.25, 1.25, 1.5};
  EXPECT_EQ(fault_of([&] { polyhedron(bent, cube_facets); }), input_fault::not_planar);
  const polyhedron cut(bent, cube_facets, {.triangulate = true});
  EXPECT_EQ(cut.planes(), 9);
  std::set<int> seen;
  for (int plane = 0; plane < cut.planes(); ++plane)
    for (const int f : cut.facets_in(plane)) seen.insert(f);
  EXPECT_EQ(seen, (std::set<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(fault_of([&] { static_cast<void>(cut.plane_of(6)); }), input_fault::bad_index);
  for (const auto& source : skeletonize(cut).offset(0.1).source) EXPECT_TRUE(source >= 0 && source < 6);
  EXPECT_EQ(fault_of([] { read_polyhedron("/nowhere/model.obj"); }), input_fault::unreadable);
  std::istringstream text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(fault_of([&] { read_polyhedron(text, "text"); }), input_fault::not_closed);
}

// Of convex solids: the intersection of the moved half-spaces, by its corners. Shares nothing with the library.
class half_spaces {
 public:
  half_spaces(const std::vector<point>& points, const facet_list& facets) {
    for (const auto& f : facets) {
      const point n = cross(minus(points[f[1]], points[f[0]]), minus(points[f[2]], points[f[0]]));
      const double length = std::sqrt(dot(n, n));
      planes_.push_back({{n[0] / length, n[1] / length, n[2] / length}, dot(n, points[f[0]]) / length});
    }
  }

  double volume(double t) const {
    double sum = 0;
    for (const auto& p : planes_) sum += (p.d - t) * area(p, t) / 3;
    return sum;
  }

 private:
  struct plane {
    point n;
    double d;
  };
  static point minus(const point& a, const point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static point cross(const point& a, const point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
  static double dot(const point& a, const point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  // A large square in the plane, cut by all others.
  double area(const plane& p, double t) const {
    const point any = std::abs(p.n[0]) < 0.6 ? point{1, 0, 0} : point{0, 1, 0};
    const point u = cross(p.n, any);
    const point v = cross(p.n, u);
    std::vector<point> ring;
    for (const auto& [a, b] : {std::pair(1e4, 1e4), std::pair(-1e4, 1e4), std::pair(-1e4, -1e4), std::pair(1e4, -1e4)}) {
      ring.emplace_back();
      for (std::size_t x = 0; x < 3; ++x) ring.back()[x] = p.n[x] * (p.d - t) + a * u[x] + b * v[x];
    }
    for (const auto& q : planes_) {
      if (&q == &p) continue;
      std::vector<point> cut;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const point& a = ring[i];
        const point& b = ring[(i + 1) % ring.size()];
        const double ha = q.d - t - dot(q.n, a);
        const double hb = q.d - t - dot(q.n, b);
        if (ha >= 0) cut.push_back(a);
        if ((ha >= 0) == (hb >= 0)) continue;
        cut.emplace_back();
        for (std::size_t x = 0; x < 3; ++x) cut.back()[x] = a[x] + (b[x] - a[x]) * (ha / (ha - hb));
      }
      ring = std::move(cut);
    }
    point sum = {0, 0, 0};
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const point c = cross(minus(ring[i], ring[0]), minus(ring[i + 1], ring[0]));
      for (std::size_t x = 0; x < 3; ++x) sum[x] += c[x] / 2;
    }
    return std::sqrt(dot(sum, sum));
  }

  std::vector<plane> planes_;
};

TEST(DoorPolyhedron, OffsetsOfConvexSolidsAreHalfSpaces) {
  models::dice roll(7);
  int checked = 0;
  for (int i = 0; i < 30; ++i) {
    // A prism or pyramid over a regular base, sheared and stretched: no two speeds or events agree.
    const int n = static_cast<int>(roll.between(3, 9));
    const bool pyramid = i % 2 == 0;
    const auto skew = [&](double x, double y, double z) { return point{x + 0.3 * z, y - 0.2 * z + 0.1 * x, z * (1 + 0.125 * n) + 0.05 * x * y * 0}; };
    std::vector<point> points;
    for (int k = 0; k < n; ++k) points.push_back(skew(std::cos(6.28318 * k / n), std::sin(6.28318 * k / n), 0));
    facet_list facets(1);
    for (int k = n; k-- > 0;) facets[0].push_back(k);
    if (pyramid) {
      points.push_back(skew(0.1, 0.05, 1));
      for (int k = 0; k < n; ++k) facets.push_back({k, (k + 1) % n, n});
    } else {
      // A frustum whose top is cut by triangles, so that all facets are flat.
      for (int k = 0; k < n; ++k) points.push_back(skew(0.5 * std::cos(6.28318 * (k + 0.5) / n), 0.5 * std::sin(6.28318 * (k + 0.5) / n), 1));
      facets.emplace_back();
      for (int k = 0; k < n; ++k) facets.back().push_back(n + k);
      for (int k = 0; k < n; ++k) {
        facets.push_back({k, (k + 1) % n, n + k});
        facets.push_back({(k + 1) % n, n + (k + 1) % n, n + k});
      }
    }
    const polyhedron p(points, facets, {.triangulate = true});
    const half_spaces expected(points, facets);
    for (const auto kernel : {number_kernel::sqrt, number_kernel::rational}) {
      const auto s = skeletonize(p, {.kernel = kernel});
      double last = 0;
      for (const auto node : s.nodes()) last = std::max(last, node.time());
      for (const double part : {0.0, 0.1, 0.35, 0.7, 0.9, 0.99}) {
        const mesh m = s.offset(part * last);
        expect_closed(m);
        const double volume = expected.volume(part * last);
        EXPECT_NEAR(volume_of(m), volume, 1e-9) << i << " at " << part;
        EXPECT_NEAR(s.volume(part * last), volume, 1e-9);
        for (const int f : m.source) EXPECT_TRUE(f >= 0 && f < static_cast<int>(facets.size()));
        ++checked;
      }
      EXPECT_TRUE(s.offset(last * 1.0001).facets.empty());
    }
  }
  EXPECT_EQ(checked, 360);
}

// Axis-parallel solids erode; offsets at thirds, halves and whole cells, many of them moments of events.
TEST(DoorPolyhedron, OffsetsOfVoxelsAreErosions) {
  int with_holes = 0;
  for (int seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    models::dice roll(static_cast<std::uint64_t>(seed));
    const std::array<int, 3> size = {static_cast<int>(roll.between(1, 5)), static_cast<int>(roll.between(1, 5)),
                                     static_cast<int>(roll.between(1, 5))};
    const auto v = models::random_voxels(size, static_cast<int>(roll.between(25, 90)), static_cast<std::uint64_t>(seed));
    const auto s = skeletonize(model(v.surface()));
    for (const auto& [p, q] : {std::pair{0, 1}, {1, 4}, {1, 3}, {1, 2}, {2, 3}, {1, 1}, {3, 2}}) {
      const auto full = [&v](int x, int y, int z) { return v(x, y, z); };
      const double expected = static_cast<double>(oracles::eroded_cells(size, full, p, q)) / (q * q * q);
      for (const bool triangulate : {false, true}) {
        const mesh m = s.offset(static_cast<double>(p) / q, {.triangulate = triangulate});
        expect_closed(m, p * 3 == q);  // at halves surfaces may touch along edges
        EXPECT_NEAR(volume_of(m), expected, 1e-9) << p << "/" << q;
        for (const auto& f : m.facets) EXPECT_TRUE(!triangulate || f.size() == 3);
        if (!triangulate) with_holes += std::ranges::count_if(m.facets, [](const auto& f) { return f.size() == 3; }) > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(with_holes, 20);
}

TEST(DoorPolyhedron, OffsetsOfModels) {
  for (const auto& kind : models::kinds()) {
    SCOPED_TRACE(kind.name);
    const auto p = model(kind.make(kind.default_size, 3));
    const auto s = skeletonize(p);
    double last = 0;
    for (const auto n : s.nodes()) last = std::max(last, n.time());
    for (const double part : {0.0, 0.2, 0.5, 0.8}) {
      const mesh m = s.offset(part * last);
      expect_closed(m, false);
      EXPECT_NEAR(volume_of(m) / s.volume(0), s.volume(part * last) / s.volume(0), 1e-9);
    }
  }
}

TEST(DoorPolyhedron, OffsetErrors) {
  const auto s = skeletonize(cube());
  EXPECT_EQ(fault_of([&] { s.offset(-1); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([&] { s.volume("x"); }), input_fault::bad_number);
  EXPECT_TRUE(s.offset(0.5).facets.empty());
  EXPECT_EQ(s.volume("0.25"), 0.125);
  EXPECT_THROW(skeletonize(cube(), {.kernel = number_kernel::floating}).offset(0.1), error);
  std::ostringstream out;
  write_obj(out, s.offset(0.25));
  EXPECT_EQ(std::ranges::count(out.str(), 'v'), 8);
  EXPECT_EQ(out.str().find('g'), std::string::npos);
}

TEST(DoorPolyhedron, KernelsAndOptions) {
  const auto p = read_polyhedron(std::string(OSTEON_MODELS) + "/star.obj");
  const auto exact = skeletonize(p);
  const auto rational = skeletonize(p, {.kernel = number_kernel::rational});
  EXPECT_EQ(exact.nodes().size(), rational.nodes().size());
  EXPECT_FALSE(rational.verify());
  EXPECT_NEAR(volume_of(exact.offset(0.1)), volume_of(rational.offset(0.1)), 1e-9);
  const auto drawn = skeletonize(p, {.explore = 5});
  EXPECT_FALSE(drawn.verify());
  EXPECT_EQ(drawn.raw().nodes().size(), skeletonize(p, {.explore = 5}).raw().nodes().size());
  const auto saddle = skeletonize(p, {.prefer = split_preference::max_volume, .saddle = saddle_rule::slower});
  EXPECT_GT(saddle.ambiguous(), 0);
  EXPECT_EQ(saddle.unproven_splits(), 0);
  EXPECT_FALSE(saddle.verify());
  int ambiguous = 0;
  for (const auto n : saddle.raw().nodes()) ambiguous += n.is_ambiguous() ? 1 : 0;
  EXPECT_EQ(ambiguous, saddle.ambiguous());
}

TEST(DoorPolyhedron, ViewsOutliveTheirSkeletonAndThreadsShareIt) {
  std::optional<polyhedron_skeleton::node> node;
  for (const auto a : skeletonize(cube()).arcs()) node = a.target();
  EXPECT_EQ(node->time(), 0.5);
  const auto s = skeletonize(read_polyhedron(std::string(OSTEON_MODELS) + "/house-t.obj"));
  std::vector<std::thread> threads;
  std::array<double, 4> sums{};
  for (double& sum : sums)
    threads.emplace_back([&sum, copy = s] {
      for (const auto n : copy.nodes()) sum += n.time() + n.point()[0];
      sum += volume_of(copy.offset(0.2)) + copy.volume(0.1) + (copy.verify() ? 1 : 0);
    });
  for (auto& t : threads) t.join();
  for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

TEST(DoorPolyhedron, Documents) {
  for (const std::string name : {"/house-t.obj", "/touching-cubes.obj", "/twisted-prism.obj"}) {
    const auto p = read_polyhedron(OSTEON_MODELS + name);
    const auto s = skeletonize(p);
    const polyhedron_document good = s.document();
    EXPECT_FALSE(verify(p, good)) << name;
    EXPECT_EQ(good.nodes.size(), s.raw().nodes().size());
    EXPECT_EQ(good.contracted->sheets.size(), s.sheets().size());
    auto bad = good;
    bad.planes[1].d = "12345";
    EXPECT_EQ(verify(p, bad)->witness, "plane 1 is not that of the solid");
    bad = good;
    bad.nodes[0].vertex = 1000;
    EXPECT_TRUE(verify(p, bad));
    bad = good;
    std::swap(bad.arcs[0].source, bad.arcs[0].target);
    EXPECT_TRUE(verify(p, bad));
    bad = good;
    bad.contracted->cells += 1;
    EXPECT_EQ(verify(p, bad)->rule, "contraction");
    bad = good;
    bad.planes[0].weight = "one";
    EXPECT_EQ(fault_of([&] { verify(p, bad); }), input_fault::not_skeleton);
  }
}

}  // namespace
}  // namespace osteon::test
