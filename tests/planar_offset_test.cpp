// SPDX-License-Identifier: MIT

// Offset polygons: simple shapes in closed form, laws of area and perimeter, rings, moments of events, places in doubles and rationals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/offset.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/propagate.hpp"
#include "planar_polygons.hpp"

namespace osteon::plane {
namespace {

using models::region;

skeleton skeleton_of(const polygon<integer>& p, bool outside = false) {
  const std::span<const moving_line<integer>> lines(p.lines);
  const auto k = perturbed(filtered(lines, make_sqrt_kernel(lines)));
  const vertex_enclosures m(lines, p.points);
  plane::skeleton_options how;
  how.outside = outside;
  return propagation(k, p.boundary, m, how).run();
}

struct case_of {
  polygon<integer> p;
  skeleton s;
  offsets o;
  explicit case_of(const rings<integer>& r) : p(make_polygon(r)), s(skeleton_of(p)), o(p, s) {}
  explicit case_of(const region& r) : case_of(models::take<integer>(r)) {}
  case_of(const case_of&) = delete;
  case_of& operator=(const case_of&) = delete;
};

rings<integer> weighted(const region& r, const std::vector<std::vector<long>>& weights) {
  auto result = models::take<integer>(r);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (const long w : weights[i]) result.all[i].weights.push_back({integer(w), 0, 0});
  return result;
}

template <class Number>
Number doubled_area(const std::vector<std::array<Number, 2>>& p) {
  Number sum = 0;
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) sum += p[j][0] * p[i][1] - p[j][1] * p[i][0];
  return sum;
}
template <class Number>
Number area(const offset_polygon<Number>& p) {
  Number sum = 0;
  for (const auto& r : p.rings) sum += doubled_area(r.points);
  return sum / 2;
}

// Sum of weight * length: how fast the area sinks.
double sinking(const case_of& c, const offset_polygon<double>& p) {
  double sum = 0;
  const double scale = power_of(c.p.weight_ten, c.p.weight_two).convert_to<double>();
  for (const auto& r : p.rings)
    for (std::size_t i = 0; i < r.points.size(); ++i) {
      const auto& a = r.points[i];
      const auto& b = r.points[(i + 1) % r.points.size()];
      sum += std::hypot(b[0] - a[0], b[1] - a[1]) * scale * c.p.lines[c.p.boundary.line[r.edges[i]]].weight.convert_to<double>();
    }
  return sum;
}

// The times of events, ascending, in the units of the input.
std::vector<double> times_of(const case_of& c) {
  std::vector<double> result;
  for (const auto& n : c.s.nodes)
    if (n.vertex < 0) result.push_back(c.o.places().meeting(n.lines).time);
  return result;
}

// Polygons with a part that edges of weight zero enclose have no skeleton.
std::unique_ptr<case_of> skeleton_if_any(const rings<integer>& r) {
  try {
    return std::make_unique<case_of>(r);
  } catch (const unsupported_error&) {
    return nullptr;
  }
}

using points = std::set<std::array<rational, 2>>;
points points_of(const offset_polygon<rational>& p) {
  points result;
  for (const auto& r : p.rings) result.insert(r.points.begin(), r.points.end());
  return result;
}
points exact(const std::vector<std::array<long, 2>>& list) {
  points result;
  for (const auto& p : list) result.insert({rational(p[0]), rational(p[1])});
  return result;
}

// ---- closed forms

TEST(planar_offset, square) {
  const case_of c(region{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
  EXPECT_EQ(points_of(c.o.exactly_at(0)), exact({{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  EXPECT_EQ(points_of(c.o.exactly_at(3)), exact({{3, 3}, {7, 3}, {7, 7}, {3, 7}}));
  EXPECT_EQ(area(c.o.exactly_at(rational(1, 4))), rational(19 * 19, 4));
  EXPECT_EQ(area(c.o.exactly_at(5 - rational(1, integer(1) << 60))), rational(1, integer(1) << 118));
  EXPECT_TRUE(c.o.exactly_at(5).rings.empty());
  EXPECT_TRUE(c.o.at(5).rings.empty());
  EXPECT_TRUE(c.o.at(500).rings.empty());
  EXPECT_THROW(c.o.at(-1), input_error);
}

TEST(planar_offset, units_of_the_input) {
  // (100.25, -7.5) + [0, 0.5] x [0, 0.25], weights 0.2, that is, times are five times distances.
  rings<integer> r;
  auto& ring = r.all.emplace_back();
  for (const auto& [x, y] : {std::pair(10025, -750), std::pair(10075, -750), std::pair(10075, -725), std::pair(10025, -725)}) {
    ring.points.push_back({exact_number<integer>{x, -2, 0}, exact_number<integer>{y, -2, 0}});
    ring.weights.push_back({2, -1, 0});
  }
  const case_of c(r);
  const auto at = [&](int x, int y) { return std::array{rational(x, 1000), rational(y, 1000)}; };
  EXPECT_EQ(points_of(c.o.exactly_at(rational(1, 2))), (points{at(100350, -7400), at(100650, -7400), at(100650, -7350), at(100350, -7350)}));
  EXPECT_TRUE(c.o.at(rational(5, 8)).rings.empty());
  EXPECT_EQ(c.o.at(rational(62, 100)).rings.size(), 1U);
  const auto start = c.o.at(0);
  ASSERT_EQ(start.rings.size(), 1U);
  EXPECT_NE(std::find(start.rings[0].points.begin(), start.rings[0].points.end(), std::array{100.75, -7.25}), start.rings[0].points.end());
}

TEST(planar_offset, dumbbell_at_its_events) {
  // Two rooms of 10 x 10 joined by a corridor of width 2: cut at time 1.
  const case_of c(region{{{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}}});
  EXPECT_EQ(c.o.at(0).rings.size(), 1U);
  EXPECT_EQ(c.o.at(rational(99, 100)).rings.size(), 1U);
  const auto p = c.o.exactly_at(1);
  ASSERT_EQ(p.rings.size(), 2U);
  EXPECT_EQ(p.parts, 2);
  EXPECT_EQ(points_of(p), exact({{1, 1}, {9, 1}, {9, 9}, {1, 9}, {21, 1}, {29, 1}, {29, 9}, {21, 9}}));  // nothing straight or of no length
  for (const auto& r : p.rings) EXPECT_EQ(r.points.size(), 4U);
  EXPECT_EQ(area(c.o.exactly_at(2)), 72);
}

TEST(planar_offset, l_and_cross) {
  const case_of l(region{{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}});
  EXPECT_EQ(points_of(l.o.exactly_at(1)), exact({{1, 1}, {9, 1}, {9, 3}, {3, 3}, {3, 9}, {1, 9}}));
  EXPECT_TRUE(l.o.at(2).rings.empty());
  const case_of cross(region{{{4, 0}, {8, 0}, {8, 4}, {12, 4}, {12, 8}, {8, 8}, {8, 12}, {4, 12}, {4, 8}, {0, 8}, {0, 4}, {4, 4}}});
  for (const auto& [t, a] : {std::pair(0, 80), std::pair(1, 36), std::pair(2, 0)}) EXPECT_EQ(area(cross.o.exactly_at(t)), a);
  EXPECT_EQ(cross.o.exactly_at(1).rings.at(0).points.size(), 12U);
}

TEST(planar_offset, hole) {
  // The hole reaches the outer ring at the right first: one ring is left.
  const case_of c(region{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{6, 6}, {6, 14}, {16, 14}, {16, 6}}});
  const auto early = c.o.exactly_at(1);
  ASSERT_EQ(early.rings.size(), 2U);
  EXPECT_EQ(early.parts, 1);
  EXPECT_FALSE(early.rings[0].hole);
  EXPECT_TRUE(early.rings[1].hole);
  EXPECT_EQ(area(early), 18 * 18 - 12 * 10);
  const auto then = c.o.exactly_at(2);
  ASSERT_EQ(then.rings.size(), 1U);
  EXPECT_EQ(area(then), 16 * 16 - 12 * 14);
  EXPECT_EQ(points_of(then), exact({{2, 2}, {18, 2}, {18, 4}, {4, 4}, {4, 16}, {18, 16}, {18, 18}, {2, 18}}));
  EXPECT_TRUE(c.o.at(3).rings.empty());
}

TEST(planar_offset, weights_and_held_edges) {
  // Left edge held, right edge twice as fast.
  const case_of c(weighted({{{0, 0}, {12, 0}, {12, 8}, {0, 8}}}, {{1, 2, 1, 0}}));
  EXPECT_EQ(points_of(c.o.exactly_at(2)), exact({{0, 2}, {8, 2}, {8, 6}, {0, 6}}));
  EXPECT_TRUE(c.o.at(4).rings.empty());
  // Only one edge moves: the width it sweeps.
  const case_of d(weighted({{{0, 0}, {12, 0}, {12, 8}, {0, 8}}}, {{3, 0, 0, 0}}));
  EXPECT_EQ(points_of(d.o.exactly_at(2)), exact({{0, 6}, {12, 6}, {12, 8}, {0, 8}}));
  EXPECT_TRUE(d.o.at(rational(8, 3)).rings.empty());
}

// An edge sweeps over a hole that is held: it is cut in two, and one again behind it.
TEST(planar_offset, swept_hole) {
  const case_of c(weighted({{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{8, 7}, {7, 11}, {10, 14}, {12, 9}}}, {{1, 0, 0, 0}, {0, 0, 0, 0}}));
  const auto early = c.o.at(3);
  ASSERT_EQ(early.rings.size(), 2U);
  EXPECT_EQ(early.parts, 1);  // though no arc joins the hole to the outer ring
  EXPECT_TRUE(early.rings[1].hole);
  const auto middle = c.o.at(10);
  ASSERT_EQ(middle.rings.size(), 1U);
  EXPECT_EQ(middle.rings[0].points.size(), 4U + 4U);
  const auto late = c.o.exactly_at(16);
  EXPECT_EQ(points_of(late), exact({{0, 16}, {20, 16}, {20, 20}, {0, 20}}));
  EXPECT_EQ(c.o.exactly_at(14).rings.size(), 1U);
  EXPECT_EQ(area(c.o.exactly_at(14)), 120);
}

// As if what happens at the moment had not happened yet: an edge has no length.
struct just_before : lines_at_time {
  using lines_at_time::lines_at_time;
  bool is_past(const triple& q) const { return level(q[0], q[1], q[2]) == -closing(q[0], q[1], q[2]); }
};

TEST(planar_offset, edges_of_no_length_are_left_out) {
  const case_of c(region{{{0, 0}, {33, 0}, {36, 4}, {36, 36}, {0, 36}}});  // the short edge vanishes at time 6
  EXPECT_EQ(c.o.exactly_at(rational(59, 10)).rings.at(0).points.size(), 5U);
  EXPECT_EQ(points_of(c.o.exactly_at(6)), exact({{6, 6}, {30, 6}, {30, 30}, {6, 30}}));
  const auto& lines = c.o.places().lines();
  const auto w = wavefront_at(c.s, c.p.boundary.line, just_before(c.p.lines, lines, 6));
  ASSERT_EQ(w.rings.size(), 1U);
  EXPECT_EQ(w.rings[0].size, 4);
  EXPECT_TRUE(wavefront_at(c.s, c.p.boundary.line, just_before(c.p.lines, lines, 18)).rings.empty());
}

// ---- outside

struct outside_of {
  polygon<integer> p;
  skeleton s;
  offsets o;
  explicit outside_of(const region& r) : p(make_polygon(models::take<integer>(r), true)), s(skeleton_of(p, true)), o(p, s) {}
  outside_of(const outside_of&) = delete;
  outside_of& operator=(const outside_of&) = delete;
};

TEST(planar_offset, outside_of_a_square) {
  const outside_of c(region{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
  const auto p = c.o.exactly_at(5);
  ASSERT_EQ(p.rings.size(), 1U);
  EXPECT_TRUE(p.rings[0].hole);
  const auto grown = complement(p);
  EXPECT_EQ(points_of(grown), exact({{-5, -5}, {15, -5}, {15, 15}, {-5, 15}}));
  EXPECT_FALSE(grown.rings[0].hole);
  EXPECT_EQ(area(grown), 400);
}

TEST(planar_offset, outside_closes_a_court) {
  // A C whose mouth of width 2 closes at time 1: the court becomes a hole, which vanishes at time 4.
  const outside_of c(region{{{0, 0}, {20, 0}, {20, 9}, {14, 9}, {14, 6}, {6, 6}, {6, 14}, {14, 14}, {14, 11}, {20, 11}, {20, 20}, {0, 20}}});
  EXPECT_EQ(complement(c.o.exactly_at(rational(1, 2))).rings.size(), 1U);
  const auto p = complement(c.o.exactly_at(2));
  ASSERT_EQ(p.rings.size(), 2U);
  EXPECT_EQ(p.parts, 1);
  EXPECT_TRUE(p.rings[1].hole);
  EXPECT_EQ(area(p), 24 * 24 - 16);
  EXPECT_EQ(area(complement(c.o.exactly_at(4))), 28 * 28);
  EXPECT_EQ(area(complement(c.o.exactly_at(1000))), 2020 * 2020);
}

TEST(planar_offset, outside_where_a_hole_touches) {
  // At (10, 10) two corners of the interior meet, and two of the outside: the notch and the hole go apart.
  const outside_of c(region{{{0, 0}, {20, 0}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}, {{10, 10}, {14, 10}, {14, 6}, {10, 6}}});
  const auto p = complement(c.o.exactly_at(1));
  ASSERT_EQ(p.rings.size(), 2U);
  EXPECT_EQ(area(p), 22 * 22 - 10 * 10 - 2 * 2);
  EXPECT_EQ(area(complement(c.o.exactly_at(2))), 24 * 24 - 10 * 10);
}

// ---- exactness

// A right triangle vanishes at 1000 - sqrt(500000), which no rational is.
TEST(planar_offset, irrational_moment) {
  const case_of c(region{{{0, 0}, {1000, 0}, {0, 1000}}});
  const integer root = isqrt(integer(500000) << 1200);
  const rational unit(1, integer(1) << 600);
  EXPECT_EQ(c.o.exactly_at(1000 - (root + 1) * unit).rings.size(), 1U);
  EXPECT_TRUE(c.o.exactly_at(1000 - root * unit).rings.empty());
  EXPECT_TRUE(c.o.at(1000 - root * unit).rings.empty());
}

// Doubles against rationals, for numbers of any size and lines that hardly cross.
TEST(planar_offset, places_in_doubles) {
  for (const auto& [ten, far] : {std::pair(0, 0L), std::pair(-3, 1000000000000L), std::pair(280, 7L), std::pair(-290, -5L)})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      models::dice roll(seed);
      rings<integer> r;
      auto& ring = r.all.emplace_back();
      // Flat arcs below and above: neighbours turn by 1e-9 or so.
      const long n = roll.between(2, 12);
      for (long i = 0; i <= n; ++i)
        ring.points.push_back({exact_number<integer>{i * 1000000 + far, ten, 0}, exact_number<integer>{i * (i - n) * 5 + far, ten, 0}});
      for (long i = n; i >= 0; --i)
        ring.points.push_back(
            {exact_number<integer>{i * 1000000 + roll.between(1, 9) + far, ten, 0}, exact_number<integer>{500000 - i * (i - n) * 3 + far, ten, 0}});
      SCOPED_TRACE("ten " + std::to_string(ten) + ", far " + std::to_string(far) + ", seed " + std::to_string(seed));
      const case_of c(r);
      const locator exact(c.p.lines);
      const input_scale u(c.p);
      const double size = rational(n * 1000000 * power_of(ten, 0)).convert_to<double>();
      for (const auto& node : c.s.nodes) {
        if (node.vertex >= 0) continue;
        const auto fast = c.o.places().meeting(node.lines);
        const auto slow = exact.meeting(node.lines);
        ASSERT_TRUE(slow);
        const auto p = u.to_input(slow->point);
        const double ulp = 4e-16 * std::max(size, std::abs(rational(far * power_of(ten, 0)).convert_to<double>()));
        EXPECT_NEAR(fast.x, p[0].convert_to<double>(), ulp);
        EXPECT_NEAR(fast.y, p[1].convert_to<double>(), ulp);
        const double t = u.to_input(slow->time).convert_to<double>();
        EXPECT_NEAR(fast.time, t, 4e-16 * t);
      }
    }
}

TEST(planar_offset, of_an_offset) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto sample = test::sample(test::shape::holes, test::weighting::none, seed);
    SCOPED_TRACE(sample.name);
    const case_of c(sample.rings);
    const rational last(times_of(c).back());
    const auto once = c.o.at(last / 5);
    rings<integer> again;
    for (const auto& r : once.rings) {
      auto& to = again.all.emplace_back();
      to.part = r.part;
      for (const auto& p : r.points) to.points.push_back({*from_double<integer>(p[0]), *from_double<integer>(p[1])});
    }
    const case_of d(again);
    for (const int i : {1, 2, 3}) {
      const double direct = area(c.o.at(last / 5 + last * i / 5));
      EXPECT_NEAR(area(d.o.at(last * i / 5)), direct, 1e-6 * area(once));
    }
  }
}

// ---- laws

class planar_offset_laws : public testing::TestWithParam<std::pair<test::shape, test::weighting>> {};

TEST_P(planar_offset_laws, area_and_perimeter) {
  const auto [shape, weighting] = GetParam();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto sample = test::sample(shape, weighting, seed);
    SCOPED_TRACE(sample.name);
    const auto any = skeleton_if_any(sample.rings);
    if (!any) continue;
    const case_of& c = *any;
    test::wide twice = 0;
    double size = 0;
    for (const auto& r : sample.points) {
      twice += test::doubled_area(r);
      for (const auto& p : r) size = std::max({size, std::abs(static_cast<double>(p[0])), std::abs(static_cast<double>(p[1]))});
    }
    const double whole = static_cast<double>(twice) / 2;
    const auto start = c.o.at(0);
    EXPECT_NEAR(area(start), whole, 1e-12 * size * size);
    EXPECT_EQ(start.parts, c.p.parts);
    std::vector<double> times = times_of(c);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end(), [](double a, double b) { return a < b * (1 - 1e-15); }));
    times.insert(times.begin(), 0);
    double before = area(start);
    for (std::size_t i = 0; i + 1 < times.size(); i += 1 + times.size() / 12) {
      const double h = times[i + 1] - times[i];
      if (h < 1e-6 * times.back()) continue;
      // Between two events the area is a quadratic function: central differences give its slope.
      const rational a = rational(times[i]) + rational(h) / 10;
      const rational b = rational(times[i]) + rational(h) / 2;
      const rational d = rational(times[i]) + rational(h) * 9 / 10;
      const auto pa = c.o.exactly_at(a, 200);
      const auto pd = c.o.exactly_at(d, 200);
      const auto pb = c.o.at(b);
      EXPECT_EQ(pa.rings.size(), pd.rings.size());  // nothing happens
      const double slope = rational((area(pd) - area(pa)) / (d - a)).convert_to<double>();
      const double expected = -sinking(c, pb);
      EXPECT_NEAR(slope, expected, 1e-9 * size + 1e-9 * std::abs(expected));
      const double now = area(pb);
      EXPECT_LE(now, before + 1e-12 * size * size);
      before = now;
      for (const auto& r : pb.rings) {
        EXPECT_GE(r.points.size(), 3U);
        EXPECT_LE((r.hole ? 1 : -1) * doubled_area(r.points), 1e-12 * size * size);
      }
      // The doubles are the rationals, rounded.
      const auto exactly = c.o.exactly_at(b);
      for (std::size_t r = 0; r < pb.rings.size(); ++r)
        for (std::size_t v = 0; v < pb.rings[r].points.size(); ++v)
          for (std::size_t axis = 0; axis < 2; ++axis)
            ASSERT_NEAR(pb.rings[r].points[v][axis], exactly.rings[r].points[v][axis].convert_to<double>(), 1e-15 * size);
    }
  }
}

// At the moment of an event (in doubles, and so just before or after it, or exactly where it is a dyadic rational) the area fits in.
TEST_P(planar_offset_laws, area_is_continuous) {
  const auto [shape, weighting] = GetParam();
  for (std::uint64_t seed = 101; seed <= 140; ++seed) {
    const auto sample = test::sample(shape, weighting, seed);
    SCOPED_TRACE(sample.name);
    const auto any = skeleton_if_any(sample.rings);
    if (!any) continue;
    const case_of& c = *any;
    std::vector<double> times = times_of(c);
    if (times.empty()) continue;
    double size = 0;
    for (const auto& r : sample.points)
      for (const auto& p : r) size = std::max({size, std::abs(static_cast<double>(p[0])), std::abs(static_cast<double>(p[1]))});
    for (std::size_t i = 0; i < times.size(); i += 1 + times.size() / 8) {
      const rational t(times[i]);
      const rational h = t / 1000000000;
      const auto now = c.o.at(t);
      EXPECT_NEAR(area(now), (area(c.o.at(t - h)) + area(c.o.at(t + h))) / 2, 1e-6 * size * size);
      for (const auto& r : now.rings) EXPECT_EQ(r.points.size(), r.edges.size());
    }
    EXPECT_TRUE(c.o.at(rational(times.back()) * rational(1000001, 1000000)).rings.empty() || weighting == test::weighting::some_zero);
  }
}

INSTANTIATE_TEST_SUITE_P(all, planar_offset_laws, testing::ValuesIn(test::shapes_and_weightings()),
                         [](const auto& p) { return test::name_of(p.param.first) + "_" + test::name_of(p.param.second); });

}  // namespace
}  // namespace osteon::plane
