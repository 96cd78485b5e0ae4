// SPDX-License-Identifier: MIT

// Polygons through the front door: values, errors, views, offsets, roofs, certificates, documents.

#include <gtest/gtest.h>
#include <osteon/osteon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace osteon::test {
namespace {

using point = polygon::point;

const std::vector<point> l_shape = {{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 9}, {0, 9}};

polygon parsed(const std::string& text, const std::string& name = "text") {
  std::istringstream in(text);
  return read_polygon(in, name);
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

double area_of(const std::vector<point>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}
double area_of(const offset_polygon& p) {
  double sum = 0;
  for (const auto& r : p.rings) sum += area_of(r.points);
  return sum;
}

// Of a point from the line of an edge of the input, positive on the left.
double distance(const std::vector<point>& all, const std::vector<int>& next, int edge, const point& p) {
  const point& a = all[edge];
  const point& b = all[next[edge]];
  return ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / std::hypot(b[0] - a[0], b[1] - a[1]);
}

struct flat_rings {
  std::vector<point> points;
  std::vector<int> next;
  explicit flat_rings(const polygon& p) {
    for (const auto& r : p.rings()) {
      const int first = static_cast<int>(points.size());
      for (std::size_t i = 0; i < r.size(); ++i) {
        points.push_back(r[i]);
        next.push_back(first + static_cast<int>((i + 1) % r.size()));
      }
    }
  }
};

void expect_closed(const mesh& m) {
  std::map<std::pair<int, int>, int> passed;
  for (const auto& f : m.facets)
    for (std::size_t i = 0; i < f.size(); ++i) ++passed[{f[i], f[(i + 1) % f.size()]}];
  EXPECT_FALSE(passed.empty());
  for (const auto& [edge, times] : passed) {
    EXPECT_EQ(times, 1);
    EXPECT_TRUE(passed.contains({edge.second, edge.first}));
  }
}

TEST(DoorPolygon, SquareAsExpected) {
  const auto s = skeletonize(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  ASSERT_EQ(s.nodes().size(), 5U);
  EXPECT_EQ(s.arcs().size(), 4U);
  EXPECT_EQ(s.faces().size(), 4U);
  const auto centre = s.nodes()[4];
  EXPECT_EQ(centre.vertex(), -1);
  EXPECT_EQ(centre.point(), (point{1, 1}));
  EXPECT_EQ(centre.time(), 1);
  EXPECT_EQ(centre.time_exact(3), "1.000");
  EXPECT_EQ(centre.event(), event_kind::merged);
  EXPECT_EQ(centre.arcs().size(), 4U);
  for (const auto n : s.nodes())
    if (n.vertex() >= 0) {
      EXPECT_EQ(n.event(), event_kind::vertex);
      EXPECT_EQ(n.time(), 0);
      ASSERT_EQ(n.arcs().size(), 1U);
      EXPECT_EQ(n.arcs()[0].source(), n);
      EXPECT_EQ(n.arcs()[0].target(), centre);
    }
  EXPECT_FALSE(s.verify());
  EXPECT_EQ(s.vertices(), 4);
  EXPECT_EQ(s.holes(), 0);
  EXPECT_EQ(s.parts(), 1);
  EXPECT_TRUE(s.notes().empty());
}

// The incircle of a right triangle: (2 - sqrt 2) / 2.
TEST(DoorPolygon, ExactDigits) {
  const auto s = skeletonize(polygon({{0, 0}, {1, 0}, {0, 1}}));
  const auto centre = s.nodes()[3];
  const std::string digits = "0.2928932188134524755991556378951509607151640623115259634116601310046337607689464805748062";
  for (const int n : {5, 17, 40, 70}) {
    std::string cut = digits.substr(0, static_cast<std::size_t>(n) + 2);
    if (digits[static_cast<std::size_t>(n) + 2] >= '5') ++cut.back();  // none of these ends in 9
    EXPECT_EQ(centre.time_exact(n), cut);
    EXPECT_EQ(centre.point_exact(n), (std::array{cut, cut}));
  }
  EXPECT_DOUBLE_EQ(centre.time(), 1 - std::sqrt(0.5));
  EXPECT_EQ(centre.event(), event_kind::edge);
  EXPECT_EQ(centre.time_exact(0), "0");
  EXPECT_EQ(s.nodes()[1].point_exact(2), (std::array<std::string, 2>{"1.00", "0.00"}));
}

// Halves are decided exactly and rounded away from zero, also where roots cancel.
TEST(DoorPolygon, ExactTies) {
  const auto s = skeletonize(polygon({{-0.25, 0}, {0, 0}, {0, 0.25}, {-0.25, 0.25}}));
  EXPECT_EQ(s.nodes()[4].point_exact(2), (std::array<std::string, 2>{"-0.13", "0.13"}));
  EXPECT_EQ(s.nodes()[4].time_exact(2), "0.13");
  // A square on its corner: all speeds are irrational, the centre is not.
  const auto d = skeletonize(polygon({{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}}));
  EXPECT_EQ(d.nodes()[4].point_exact(0), (std::array<std::string, 2>{"1", "1"}));
  EXPECT_EQ(d.nodes()[4].time_exact(30), "0.353553390593273762200422181052");
}

TEST(DoorPolygon, ViewsAreConsistent) {
  for (const auto where : {region::interior, region::exterior}) {
    const auto exact = skeletonize(polygon({l_shape, {{2, 2}, {2, 4}, {4, 4}}}), {.region = where});
    for (const auto& s : {exact, exact.raw()}) {
      EXPECT_EQ(static_cast<std::size_t>(std::ranges::distance(s.nodes())), s.nodes().size());
      std::map<int, std::set<int>> arcs_at;
      std::map<int, std::set<int>> arcs_beside;
      for (const auto a : s.arcs()) {
        arcs_at[a.source().id()].insert(a.id());
        if (!a.is_endless()) {
          arcs_at[a.target().id()].insert(a.id());
          EXPECT_LE(a.source().time(), a.target().time());
        } else {
          EXPECT_EQ(where, region::exterior);
          EXPECT_THROW(a.target(), unsupported_error);
        }
        for (const auto& f : a.faces()) arcs_beside[f.id()].insert(a.id());
      }
      for (const auto n : s.nodes()) {
        std::set<int> found;
        for (const auto& a : n.arcs()) found.insert(a.id());
        EXPECT_EQ(found, arcs_at[n.id()]);
        EXPECT_TRUE(n.has_place());
      }
      std::set<int> edges;
      for (const auto f : s.faces()) {
        std::set<int> found;
        for (const auto& a : f.arcs()) found.insert(a.id());
        EXPECT_EQ(found, arcs_beside[f.id()]);
        EXPECT_EQ(f.edges()[0], f.edge());
        for (const int e : f.edges()) EXPECT_TRUE(edges.insert(e).second);
      }
      EXPECT_EQ(edges.size(), 9U);
    }
    EXPECT_EQ(exact.raw().events(event_kind::edge) + exact.raw().events(event_kind::split) + 9, static_cast<int>(exact.raw().nodes().size()));
    EXPECT_FALSE(exact.verify());
  }
}

// The faces cover the polygon once, each lies before its edge, and each begins with it.
TEST(DoorPolygon, FacesBelongToTheirEdges) {
  for (const bool reversed : {false, true}) {
    auto ring = l_shape;
    if (reversed) std::reverse(ring.begin(), ring.end());
    const polygon p({ring, {{2, 2}, {4, 4}, {2, 4}}});
    const flat_rings flat(p);
    const auto s = skeletonize(p);
    EXPECT_EQ(s.notes().size(), 1U);  // both rings are the wrong way round, or one is
    double sum = 0;
    for (const auto f : s.faces()) {
      bool begins = false;
      for (const auto& loop : f.boundary()) {
        std::vector<point> points;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          points.push_back(loop[i].point());
          const std::set<int> ends = {loop[i].vertex(), loop[(i + 1) % loop.size()].vertex()};
          begins = begins || ends == std::set<int>{f.edge(), flat.next[f.edge()]};
          EXPECT_NEAR(std::abs(distance(flat.points, flat.next, f.edge(), points.back())), loop[i].time(), 1e-12);
        }
        sum += area_of(points);
      }
      EXPECT_TRUE(begins) << "edge " << f.edge();
    }
    EXPECT_NEAR(sum, 70 - 2, 1e-12);
  }
}

TEST(DoorPolygon, Offsets) {
  const polygon p({l_shape, {{2, 2}, {2, 4}, {4, 4}}});
  const flat_rings flat(p);
  for (const auto where : {region::interior, region::exterior}) {
    const auto s = skeletonize(p, {.region = where});
    const auto all = s.offsets({0, 0.25, "0.5", 3});
    ASSERT_EQ(all.size(), 4U);
    EXPECT_NEAR(area_of(all[0]), 68, 1e-12);
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_EQ(area_of(all[i]) < area_of(all[i - 1]), where == region::interior);
    const double t[] = {0, 0.25, 0.5, 3};
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const auto& r : all[i].rings) {
        EXPECT_EQ(area_of(r.points) < 0, r.hole);
        ASSERT_EQ(r.points.size(), r.edges.size());
        for (std::size_t k = 0; k < r.points.size(); ++k)
          for (const auto& end : {r.points[k], r.points[(k + 1) % r.points.size()]})
            EXPECT_NEAR(distance(flat.points, flat.next, r.edges[k], end), where == region::interior ? t[i] : -t[i], 1e-12);
      }
  }
  EXPECT_TRUE(skeletonize(p).offset(100).rings.empty());
  EXPECT_EQ(fault_of([&] { skeletonize(p).offset(-1); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([&] { skeletonize(p).offset("one"); }), input_fault::bad_number);
}

TEST(DoorPolygon, RunsUntilABound) {
  const polygon p({l_shape, {{2, 2}, {2, 4}, {4, 4}}});
  for (const auto where : {region::interior, region::exterior})
    for (const auto kernel : {number_kernel::sqrt, number_kernel::rational, number_kernel::floating}) {
      const auto s = skeletonize(p, {.region = where, .until = 0.1, .kernel = kernel});
      const auto whole = skeletonize(p, {.region = where});
      EXPECT_EQ(s.options().until->value(), 0.1);
      EXPECT_EQ(s.raw().nodes().size(), 9U);
      EXPECT_NEAR(area_of(s.offset(0.1)), area_of(whole.offset(0.1)), 1e-12);
      EXPECT_EQ(fault_of([&] { s.offset(0.1000001); }), input_fault::bad_number);
      EXPECT_THROW(s.verify(), unsupported_error);
      if (where == region::interior && kernel == number_kernel::sqrt) {
        EXPECT_THROW(s.roof(), unsupported_error);
      }
      // What lives then has gone on to the offset's corners.
      std::set<std::pair<long, long>> corners;
      const auto rounded = [](double x) { return std::lround(x * 1e9); };
      for (const auto& r : s.offset(0.1).rings)
        for (const auto& q : r.points) corners.emplace(rounded(q[0]), rounded(q[1]));
      EXPECT_EQ(corners.size(), 9U);
      for (const auto a : s.arcs()) {
        ASSERT_TRUE(a.is_endless());
        const auto v = a.velocity();
        const auto from = a.source().point();
        EXPECT_TRUE(corners.contains({rounded(from[0] + 0.1 * v[0]), rounded(from[1] + 0.1 * v[1])}));
      }
    }
  EXPECT_EQ(fault_of([&] { skeletonize(p, {.until = -1}); }), input_fault::bad_number);
}

TEST(DoorPolygon, Weights) {
  polygon p(l_shape);
  EXPECT_EQ(p.edges(), 6);
  EXPECT_EQ(p.weight(3), 1);
  polygon copy = p;
  copy.set_weight(0, 0);
  copy.set_weight(1, "0.1");
  EXPECT_EQ(p.weight(0), 1);  // copies are independent
  EXPECT_EQ(copy.weight(0), 0);
  EXPECT_EQ(copy.weight(1), 0.1);
  EXPECT_EQ(copy.weight(2), 1);
  const auto s = skeletonize(copy);
  EXPECT_FALSE(s.verify());
  const flat_rings flat(copy);
  for (const auto& r : s.offset(0.5).rings)
    for (std::size_t k = 0; k < r.points.size(); ++k)
      EXPECT_NEAR(distance(flat.points, flat.next, r.edges[k], r.points[k]), 0.5 * copy.weight(r.edges[k]), 1e-12);
  EXPECT_EQ(fault_of([&] { p.set_weight(6, 1); }), input_fault::bad_index);
  EXPECT_EQ(fault_of([&] { p.set_weight(-1, 1); }), input_fault::bad_index);
  EXPECT_EQ(fault_of([&] { p.set_weight(0, -1); }), input_fault::bad_weight);
  EXPECT_EQ(fault_of([&] { p.set_weight(0, std::nan("")); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([&] { p.set_weight(0, "0,5"); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([&] { p.set_weight(0, ""); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([&] { static_cast<void>(p.weight(6)); }), input_fault::bad_index);
  p.set_weights(weight_of_angle(60));
  EXPECT_NEAR(p.weight(5), std::sqrt(1.0 / 3), 1e-15);
  EXPECT_EQ(weight_of_angle(90), 0);
  EXPECT_THROW(weight_of_angle(0), input_error);
}

TEST(DoorPolygon, RoofsAreClosed) {
  for (const bool walls : {false, true})
    for (const bool triangulate : {false, true}) {
      polygon p({l_shape, {{2, 2}, {2, 4}, {4, 4}}});
      p.set_weight(0, weight_of_angle(90));
      const auto m = skeletonize(p).roof({.slope = 0.5, .eaves = 3, .walls = walls, .triangulate = triangulate});
      expect_closed(m);
      ASSERT_EQ(m.kinds.size(), m.facets.size());
      ASSERT_EQ(m.source.size(), m.facets.size());
      std::set<int> roofs;
      for (std::size_t f = 0; f < m.facets.size(); ++f) {
        EXPECT_EQ(m.source[f] < 0, m.kinds[f] == facet_kind::floor);
        if (m.kinds[f] == facet_kind::roof) roofs.insert(m.source[f]);
        EXPECT_TRUE(!triangulate || m.facets[f].size() == 3);
      }
      EXPECT_EQ(roofs.size(), 9U);
      std::ostringstream out;
      write_obj(out, m);
      EXPECT_EQ(out.str().find("g walls") != std::string::npos, walls);
      EXPECT_NE(out.str().find("g roof\n"), std::string::npos);
      EXPECT_NE(out.str().find("g floor\n"), std::string::npos);
    }
  EXPECT_EQ(fault_of([] { skeletonize(polygon(l_shape)).roof({.slope = 0}); }), input_fault::bad_number);
  EXPECT_THROW(skeletonize(polygon(l_shape), {.region = region::exterior}).roof(), unsupported_error);
  EXPECT_THROW(skeletonize(polygon({{0, 0}, {9, 1}, {1, 7}}), {.kernel = number_kernel::floating}).roof(), unsupported_error);
}

TEST(DoorPolygon, KernelsAgree) {
  const polygon p({l_shape, {{2, 2}, {2, 4}, {4, 4}}});
  const auto exact = skeletonize(p);
  const auto rational = skeletonize(p, {.kernel = number_kernel::rational});
  const auto machine = skeletonize(polygon({{0, 0}, {9, 1}, {8, 6}, {4, 3}, {1, 7}}), {.kernel = number_kernel::floating});
  EXPECT_EQ(exact.nodes().size(), rational.nodes().size());
  EXPECT_EQ(exact.arcs().size(), rational.arcs().size());
  EXPECT_FALSE(rational.verify());
  EXPECT_FALSE(machine.verify());
  EXPECT_EQ(machine.nodes().size(), machine.raw().nodes().size());
  EXPECT_THROW(machine.faces()[0].boundary(), unsupported_error);
  EXPECT_EQ(name_of(exact.options().kernel), "sqrt");
  EXPECT_EQ(name_of(machine.options().kernel), "double");
}

TEST(DoorPolygon, BadInput) {
  EXPECT_EQ(fault_of([] { polygon({{0, 0}, {1, 0}}); }), input_fault::short_ring);
  EXPECT_EQ(fault_of([] { polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}); }), input_fault::self_intersection);
  EXPECT_EQ(fault_of([] { polygon({{0, 0}, {std::nan(""), 2}, {2, 0}}); }), input_fault::bad_number);
  EXPECT_EQ(fault_of([] { read_polygon("/nowhere/plan.xy"); }), input_fault::unreadable);
  EXPECT_EQ(fault_of([] { parsed("0 0\n1 0\nx 1\n"); }), input_fault::bad_number);
  polygon later({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, checking::later);
  EXPECT_EQ(fault_of([&] { later.check(); }), input_fault::self_intersection);
  EXPECT_EQ(fault_of([&] { skeletonize(later); }), input_fault::self_intersection);
}

TEST(DoorPolygon, Reading) {
  const std::string file = testing::TempDir() + "door_plan.wkt";
  std::ofstream(file) << "POLYGON ((0 0, 10 0, 10 4, 6 4, 6 9, 0 9, 0 0), (2 2, 2 4, 4 4, 2 2))";
  const polygon p = read_polygon(file);
  EXPECT_TRUE(is_polygon_file(file));
  std::remove(file.c_str());
  EXPECT_EQ(p.edges(), 9);
  EXPECT_EQ(p.rings()[0], l_shape);
  EXPECT_EQ(parsed("0 0 0.5\n1 0\n0 1 2\n").weight(0), 0.5);
  EXPECT_EQ(parsed(R"({"type":"Polygon","coordinates":[[[0,0,7],[1,0,7],[0,1,7]]]})").notes().size(), 1U);
  EXPECT_TRUE(is_polygon_text("0 0\n1 0"));
  EXPECT_TRUE(is_polygon_text("POLYGON ((0 0"));
  EXPECT_FALSE(is_polygon_text("v 0 0 0\nf 1 2 3"));
  // An exact decimal and the double next to it are different numbers.
  EXPECT_EQ(skeletonize(parsed("0 0\n0.1 0\n0.1 0.1\n0 0.1\n")).nodes()[4].point_exact(25)[0], "0.0500000000000000000000000");
  EXPECT_EQ(skeletonize(polygon({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}})).nodes()[4].point_exact(25)[0], "0.0500000000000000027755576");
}

TEST(DoorPolygon, ViewsOutliveTheirSkeleton) {
  std::optional<polygon_skeleton::node> node;
  std::size_t count = 0;
  for (const auto a : skeletonize(polygon(l_shape)).arcs()) {
    node = a.target();
    ++count;
  }
  EXPECT_GT(count, 0U);
  EXPECT_GT(node->time(), 0);
  auto range = skeletonize(polygon(l_shape)).nodes();
  auto it = range.begin();
  range = skeletonize(polygon({{0, 0}, {1, 0}, {0, 1}})).nodes();
  EXPECT_EQ((*it).point(), (point{0, 0}));
  static_assert(std::ranges::random_access_range<decltype(range)> && std::ranges::sized_range<decltype(range)>);
}

TEST(DoorPolygon, SeveralThreads) {
  const auto s = skeletonize(polygon({l_shape, {{2, 2}, {2, 4}, {4, 4}}}));
  std::vector<std::thread> threads;
  std::array<double, 4> sums{};
  for (double& sum : sums)
    threads.emplace_back([&sum, copy = s] {
      for (const auto f : copy.faces())
        for (const auto& loop : f.boundary())
          for (const auto& n : loop) sum += n.time();
      sum += area_of(copy.offset(0.5)) + static_cast<double>(copy.roof().points.size()) + (copy.verify() ? 1 : 0);
    });
  for (auto& t : threads) t.join();
  for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

TEST(DoorPolygon, Documents) {
  for (const auto where : {region::interior, region::exterior}) {
    polygon p({l_shape, {{2, 2}, {2, 4}, {4, 4}}});
    p.set_weight(2, "0.3");
    const auto s = skeletonize(p, {.region = where});
    const polygon_document good = s.document();
    EXPECT_FALSE(verify(p, good));
    EXPECT_EQ(good.nodes.size(), s.raw().nodes().size());
    EXPECT_EQ(good.contracted->arcs.size(), s.arcs().size());
    EXPECT_EQ(good.nodes[9].time, s.raw().nodes()[9].time());
    auto bad = good;
    bad.lines[0].d += "0";
    EXPECT_EQ(verify(p, bad)->rule, "structure");
    bad = good;
    bad.nodes.pop_back();
    EXPECT_TRUE(verify(p, bad));
    bad = good;
    std::swap(bad.arcs[0].faces[0], bad.arcs[0].faces[1]);
    EXPECT_TRUE(verify(p, bad));
    bad = good;
    bad.contracted->arcs.pop_back();
    EXPECT_TRUE(verify(p, bad));
    bad = good;
    bad.lines[0].n[0] = "0x10";
    EXPECT_EQ(fault_of([&] { verify(p, bad); }), input_fault::not_skeleton);
    bad = good;
    bad.region = where == region::interior ? region::exterior : region::interior;
    EXPECT_TRUE(verify(p, bad));
  }
}

TEST(DoorPolygon, Names) {
  for (int k = 0; k <= static_cast<int>(event_kind::merged); ++k)
    EXPECT_EQ(event_of_name(name_of(static_cast<event_kind>(k))), static_cast<event_kind>(k));
  EXPECT_EQ(name_of(event_kind::V_V_E_II), "V-V-E-II");
  EXPECT_EQ(event_of_name("E7"), std::nullopt);
  EXPECT_EQ(std::count(version().begin(), version().end(), '.'), 2);
}

}  // namespace
}  // namespace osteon::test
