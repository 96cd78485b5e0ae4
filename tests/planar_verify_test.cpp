// SPDX-License-Identifier: MIT

// The certificate in the plane: it holds for what the event loop makes, and refutes what has been tampered with.

#include "osteon/plane/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/propagate.hpp"
#include "planar_polygons.hpp"

namespace osteon::test {
namespace {

using plane::event_class;
using plane::rule;
using plane::models::dice;

constexpr std::array all_shapes = {shape::general, shape::holes, shape::coarse, shape::rectilinear, shape::symmetric, shape::touching};

std::string text_of(const std::optional<plane::refutation>& r) {
  return r ? std::string(plane::rule_names[static_cast<std::size_t>(r->broken)]) + ": " + r->witness : "certified";
}
std::string rule_of(const std::optional<plane::refutation>& r) {
  return r ? std::string(plane::rule_names[static_cast<std::size_t>(r->broken)]) : "certified";
}

std::span<const moving_line<integer>> lines_of(const plane::polygon<integer>& p) { return p.lines; }
auto kernel_of(const plane::polygon<integer>& p) { return perturbed(filtered(lines_of(p), make_sqrt_kernel(lines_of(p)))); }
using default_kernel = decltype(kernel_of(std::declval<plane::polygon<integer>>()));

template <class K>
plane::skeleton skeleton_under(const K& k, const plane::polygon<integer>& p, bool outside = false) {
  plane::skeleton_options o;
  o.outside = outside;
  const plane::vertex_enclosures motion(lines_of(p), p.points, outside);
  return plane::propagation(k, p.boundary, motion, o).run();
}

/// A polygon and its certified skeleton, to be tampered with.
struct specimen {
  std::string name;
  plane::polygon<integer> polygon;
  default_kernel kernel;
  plane::skeleton raw;

  explicit specimen(const polygon_sample& s)
      : name(s.name), polygon(plane::make_polygon(s.rings)), kernel(kernel_of(polygon)), raw(skeleton_under(kernel, polygon)) {}
  std::optional<plane::refutation> verdict(const plane::skeleton& s) const { return plane::verify(kernel, polygon.boundary, s); }
};

// ---- what is right is certified

struct tally {
  int certified = 0;
  int unsupported = 0;
};

void certify(const polygon_sample& s, bool outside, tally& count) {
  SCOPED_TRACE(s.name + (outside ? ", outside" : ""));
  const auto p = plane::make_polygon(s.rings, outside);
  const auto k = kernel_of(p);
  try {
    const auto raw = skeleton_under(k, p, outside);
    ++count.certified;
    EXPECT_EQ(text_of(plane::verify(k, p.boundary, raw, outside, has_stationary_edge(p))), "certified");
    EXPECT_EQ(text_of(plane::verify_contraction(k.base(), p.boundary, raw, plane::contract(k.base(), p.boundary.line, raw))), "certified");
  } catch (const unsupported_error&) {
    ++count.unsupported;  // a part that is enclosed by held edges
  } catch (const std::exception& e) {
    ADD_FAILURE() << e.what();
  }
}

TEST(PlanarCertificate, OfEveryShapeAndWeighting) {
  for (const auto s : all_shapes)
    for (const auto w : weightings) {
      tally count;
      for (std::uint64_t seed = 1; seed <= 200; ++seed) certify(sample(s, w, seed), false, count);
      EXPECT_GE(count.certified, 150) << name_of(s) << ' ' << name_of(w);
      EXPECT_TRUE(w == weighting::some_zero || count.unsupported == 0) << name_of(s) << ' ' << name_of(w);
    }
}

TEST(PlanarCertificate, OfTheOutside) {
  for (const auto s : all_shapes)
    for (const auto w : weightings) {
      if (s == shape::touching && w != weighting::none) continue;
      tally count;
      for (std::uint64_t seed = 1; seed <= 100; ++seed) certify(sample(s, w, seed), true, count);
      EXPECT_TRUE(w == weighting::some_zero || count.unsupported == 0) << name_of(s) << ' ' << name_of(w);
      EXPECT_GE(count.certified, 60) << name_of(s) << ' ' << name_of(w);
    }
}

// Quadrilaterals in the cells of a grid, each held or growing.
plane::rings<integer> islands(std::uint64_t seed) {
  dice roll(seed);
  std::ostringstream text;
  const auto cells = roll.between(2, 3);
  for (long i = 0; i < cells; ++i)
    for (long j = 0; j < cells; ++j) {
      const bool stationary = roll.between(0, 1) == 0;
      const auto corner = [&](long x, long y) {
        text << 100 * i + x + roll.between(0, 20) << ' ' << 100 * j + y + roll.between(0, 20) << ' ' << (stationary ? 0 : roll.between(1, 3)) << '\n';
      };
      corner(10, 10);
      corner(60, 10);
      corner(60, 60);
      corner(10, 60);
      text << '\n';
    }
  text << "-500 -500 1\n-480 -500 1\n-490 -480 1\n";  // one that surely grows
  std::istringstream in(text.str());
  auto rings = plane::read_polygon<integer>(in, "islands");
  for (std::size_t i = 0; i < rings.all.size(); ++i) rings.all[i].part = static_cast<int>(i);
  return rings;
}

// Held edges stop the outside from going once around, so turns say nothing. Where a skeleton ends too early and no edge vanishes afterwards, only
// the rings themselves show it.
TEST(PlanarCertificate, OfTheOutsideOfIslands) {
  int crossings = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const auto p = plane::make_polygon(islands(seed), true);
    const auto k = kernel_of(p);
    const auto raw = skeleton_under(k, p, true);
    const auto verdict = [&](const plane::skeleton& of) { return text_of(plane::verify(k, p.boundary, of, true, has_stationary_edge(p))); };
    EXPECT_EQ(verdict(raw), "certified");
    for (std::size_t end = p.points.size(); end < raw.nodes.size(); ++end) {
      plane::skeleton cut = raw;
      cut.nodes.resize(end);
      cut.events = {};
      for (std::size_t n = p.points.size(); n < end; ++n) ++cut.events[static_cast<std::size_t>(cut.nodes[n].event)];
      std::erase_if(cut.arcs, [end](const auto& a) { return a.source >= static_cast<int>(end); });
      std::erase_if(cut.interior_nodes, [end](const auto& x) { return x.node >= static_cast<int>(end); });
      for (auto& a : cut.arcs)
        if (a.target >= static_cast<int>(end)) a.target = -1;
      const auto said = verdict(cut);
      EXPECT_NE(said, "certified") << end << " of " << raw.nodes.size() << " nodes";
      if (said.find("meets another one") != std::string::npos) ++crossings;
    }
  }
  EXPECT_GT(crossings, 50);
}

// Opposite sides of a notch move apart or, as here, one after the other at the same speed: perturbed they meet at an infinite time, so never.
TEST(PlanarCertificate, OfTheOutsideOfAPlus) {
  polygon_sample s;
  s.points =
      plane::models::region{{{1, 1}, {1, 10}, {-1, 10}, {-1, 1}, {-10, 1}, {-10, -1}, {-1, -1}, {-1, -10}, {1, -10}, {1, -1}, {10, -1}, {10, 1}}};
  s.rings = plane::models::take<integer>(s.points);
  s.name = "plus";
  tally count;
  certify(s, true, count);
  EXPECT_EQ(count.unsupported, 0);
  const auto p = plane::make_polygon(s.rings, true);
  EXPECT_EQ(skeleton_under(kernel_of(p), p, true).nodes.size(), 12U) << "nothing ever happens";
}

TEST(PlanarCertificate, OfManyVertices) {
  polygon_sample s;
  s.points = plane::models::random_polygon(20'000, 1);
  s.rings = plane::models::take<integer>(s.points);
  s.name = "random_polygon(20000, 1)";
  tally count;
  certify(s, false, count);
  EXPECT_EQ(count.certified, 1);
}

// The order of arcs and of vertices means nothing.
TEST(PlanarCertificate, DoesNotDependOnNumbers) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const specimen one(sample(shape::holes, weighting::small, seed));
    SCOPED_TRACE(one.name);
    auto other = one.raw;
    dice roll(seed);
    const auto shuffle = [&roll](auto first, std::size_t size) {
      for (std::size_t i = size; i > 1; --i) std::swap(first[i - 1], first[static_cast<std::size_t>(roll.between(0, static_cast<long>(i) - 1))]);
    };
    shuffle(other.arcs.begin(), other.arcs.size());
    std::vector<int> number(other.nodes.size());
    std::iota(number.begin(), number.end(), 0);
    shuffle(number.begin(), one.polygon.points.size());
    for (std::size_t i = 0; i < number.size(); ++i) other.nodes[number[i]] = one.raw.nodes[i];
    for (auto& a : other.arcs) {
      a.source = number[a.source];
      if (a.target >= 0) a.target = number[a.target];
    }
    EXPECT_EQ(text_of(one.verdict(other)), "certified");
  }
}

// ---- what is wrong is refuted, and the rule names the fault

std::vector<specimen> specimens(shape s, weighting w, int number) {
  std::vector<specimen> result;
  for (std::uint64_t seed = 1; static_cast<int>(result.size()) < number; ++seed) {
    specimen one(sample(s, w, seed));
    if (one.raw.events[1] >= 2 && one.raw.events[0] >= 6) result.push_back(std::move(one));
  }
  return result;
}

class Tampered : public testing::Test {
 protected:
  // Applies the change to many skeletons; each is refuted by one of the rules.
  static void refutes(const std::function<void(const specimen&, plane::skeleton&, dice&)>& change, const std::set<std::string>& rules) {
    static const auto all = [] {
      auto list = specimens(shape::general, weighting::none, 25);
      for (auto& s : specimens(shape::general, weighting::decimal, 25)) list.push_back(std::move(s));
      for (auto& s : specimens(shape::holes, weighting::none, 25)) list.push_back(std::move(s));
      return list;
    }();
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < all.size(); ++i) {
      SCOPED_TRACE(all[i].name);
      auto s = all[i].raw;
      dice roll(i);
      change(all[i], s, roll);
      const auto verdict = all[i].verdict(s);
      EXPECT_TRUE(rules.contains(rule_of(verdict))) << text_of(verdict);
      ++seen[rule_of(verdict)];
    }
    for (const auto& r : rules) EXPECT_GT(seen[r], 0) << "never refuted by " << r;
  }

  static int first_event(const plane::skeleton& s, event_class of, int skip = 0) {
    for (int n = 0; n < static_cast<int>(s.nodes.size()); ++n)
      if (s.nodes[n].vertex < 0 && s.nodes[n].event == of && skip-- == 0) return n;
    return -1;
  }
  static int vertices(const plane::skeleton& s) { return static_cast<int>(s.faces.size()); }
  static int random_event(const plane::skeleton& s, dice& roll) {
    return static_cast<int>(roll.between(vertices(s), static_cast<long>(s.nodes.size()) - 1));
  }
};

TEST_F(Tampered, NodesSwapLines) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        const int n = static_cast<int>(roll.between(vertices(s), static_cast<long>(s.nodes.size()) - 2));
        std::swap(s.nodes[n].lines, s.nodes[n + 1].lines);
      },
      {"place"});
}

TEST_F(Tampered, NodesSwapPlaces) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        const int n = static_cast<int>(roll.between(vertices(s), static_cast<long>(s.nodes.size()) - 2));
        std::swap(s.nodes[n], s.nodes[n + 1]);
        for (auto& a : s.arcs) {
          a.source = a.source == n ? n + 1 : a.source == n + 1 ? n : a.source;
          a.target = a.target == n ? n + 1 : a.target == n + 1 ? n : a.target;
        }
      },
      {"order"});
}

TEST_F(Tampered, LinesOfANodeAreOthers) {
  refutes(
      [](const specimen& one, plane::skeleton& s, dice& roll) {
        auto& q = s.nodes[random_event(s, roll)].lines;
        const auto old = q;
        while (q == old || q[0] == q[1] || q[1] == q[2]) {
          q = old;
          q[static_cast<std::size_t>(roll.between(0, 2))] = static_cast<line_id>(roll.between(0, one.polygon.boundary.lines - 1));
          std::sort(q.begin(), q.end());
        }
      },
      {"order", "place", "length"});
}

TEST_F(Tampered, EventOfTheOtherClass) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        auto& e = s.nodes[random_event(s, roll)].event;
        e = e == event_class::edge ? event_class::split : event_class::edge;
      },
      {"event"});
}

TEST_F(Tampered, EventsCountedWrongly) {
  refutes([](const specimen&, plane::skeleton& s, dice& roll) { ++s.events[static_cast<std::size_t>(roll.between(0, 1))]; }, {"count"});
}

TEST_F(Tampered, NodeTwice) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        const int n = random_event(s, roll);
        const auto copy = s.nodes[n];
        s.nodes.insert(s.nodes.begin() + n, copy);
        for (auto& a : s.arcs) {
          if (a.source > n) ++a.source;
          if (a.target > n) ++a.target;
        }
      },
      {"order"});
}

TEST_F(Tampered, ArcTwice) {
  refutes([](const specimen&, plane::skeleton& s, dice& roll) { s.arcs.push_back(s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)]); },
          {"start", "event"});
}

TEST_F(Tampered, ArcMissing) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) { s.arcs.erase(s.arcs.begin() + roll.between(0, static_cast<long>(s.arcs.size()) - 1)); },
      {"start", "event"});
}

TEST_F(Tampered, ArcNeverEnds) {
  refutes([](const specimen&, plane::skeleton& s, dice& roll) { s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)].target = -1; },
          {"event", "length"});
}

TEST_F(Tampered, ArcsSwapTargets) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        while (true) {
          auto& a = s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
          auto& b = s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
          if (a.target == b.target || a.source >= b.target || b.source >= a.target) continue;
          std::swap(a.target, b.target);
          return;
        }
      },
      {"place"});
}

TEST_F(Tampered, ArcRunsBackwards) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        auto& a = s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
        std::swap(a.source, a.target);
      },
      {"order"});
}

TEST_F(Tampered, FacesOfAnArcSwap) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        auto& a = s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
        std::swap(a.faces[0], a.faces[1]);
      },
      {"start", "event"});
}

TEST_F(Tampered, ArcOfAnotherFace) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        auto& a = s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
        int& f = a.faces[static_cast<std::size_t>(roll.between(0, 1))];
        const int old = f;
        while (f == old) f = s.faces[roll.between(0, static_cast<long>(s.faces.size()) - 1)];
      },
      {"start", "place", "event"});
}

TEST_F(Tampered, FacesAreOne) {
  refutes(
      [](const specimen& one, plane::skeleton& s, dice& roll) {
        int f = 0;
        int g = 0;
        while (f == g || one.polygon.boundary.line[f] == one.polygon.boundary.line[g]) {
          f = s.faces[roll.between(0, static_cast<long>(s.faces.size()) - 1)];
          g = s.faces[roll.between(0, static_cast<long>(s.faces.size()) - 1)];
        }
        for (int& h : s.faces) h = h == g ? f : h;
        for (auto& a : s.arcs)
          for (int& h : a.faces) h = h == g ? f : h;
      },
      {"place", "event", "face"});
}

// The last event of a part, and with it everything that it ends.
TEST_F(Tampered, LastEventMissing) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice&) {
        const int last = static_cast<int>(s.nodes.size()) - 1;
        --s.events[static_cast<std::size_t>(s.nodes.back().event)];
        s.nodes.pop_back();
        for (auto& a : s.arcs)
          if (a.target == last) a.target = -1;
      },
      {"end"});
}

// One event is left out: its arcs are taken for those that go on.
TEST_F(Tampered, EventMissing) {
  refutes(
      [](const specimen&, plane::skeleton& s, dice& roll) {
        const int n = first_event(s, event_class::edge, static_cast<int>(roll.between(0, 2)));
        std::vector<plane::skeleton::arc> left;
        int target = -1;
        for (const auto& a : s.arcs)
          if (a.source == n) target = a.target;
        for (auto a : s.arcs) {
          if (a.source == n) continue;
          if (a.target == n) a.target = target;
          if (a.source > n) --a.source;
          if (a.target > n) --a.target;
          left.push_back(a);
        }
        s.arcs = left;
        s.nodes.erase(s.nodes.begin() + n);
        --s.events[0];
      },
      {"place", "event", "length", "end"});
}

// ---- skeletons of something else

TEST(PlanarRefutation, OfTheSkeletonOfAnotherPolygon) {
  std::set<std::string> rules;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto make = [&](std::uint64_t which) {
      polygon_sample s;
      s.points = plane::models::noisy_star(20, which);
      s.rings = plane::models::take<integer>(s.points);
      s.name = "noisy_star(20, " + std::to_string(which) + ")";
      return specimen(s);
    };
    const specimen one = make(seed);
    const specimen other = make(seed + 1);
    SCOPED_TRACE(one.name);
    ASSERT_EQ(one.raw.faces.size(), other.raw.faces.size());
    const auto verdict = one.verdict(other.raw);
    EXPECT_TRUE(verdict) << "certified";
    rules.insert(rule_of(verdict));
  }
  EXPECT_TRUE(rules.contains("order"));
}

// The same polygon with another weight of one edge, unless that changes no event.
TEST(PlanarRefutation, OfTheSkeletonOfOtherWeights) {
  int refuted = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto s = sample(shape::general, weighting::small, seed);
    auto t = s;
    auto& w = t.rings.all[0].weights[seed % t.rings.all[0].weights.size()];
    w.mantissa += 3;
    SCOPED_TRACE(s.name);
    const specimen one(s);
    const specimen other(t);
    const auto same = [](const plane::skeleton& x, const plane::skeleton& y) {
      return std::equal(x.nodes.begin(), x.nodes.end(), y.nodes.begin(), y.nodes.end(),
                        [](const auto& m, const auto& n) { return m.vertex == n.vertex && m.lines == n.lines; });
    };
    if (one.polygon.boundary.lines != other.polygon.boundary.lines || same(one.raw, other.raw)) continue;
    EXPECT_TRUE(one.verdict(other.raw)) << "certified";
    ++refuted;
  }
  EXPECT_GT(refuted, 50);
}

/// A skeleton that knows no splits: edges vanish one after the other, whatever is in between.
plane::skeleton without_splits(const default_kernel& k, const plane::boundary& polygon) {
  const int n = static_cast<int>(polygon.next.size());
  plane::skeleton s;
  std::vector<int> before(polygon.next.size());
  std::vector<int> after = polygon.next;
  std::vector<int> arc(polygon.next.size());  // of the vertex where an edge starts
  std::vector<bool> alive(polygon.next.size(), true);
  for (int e = 0; e < n; ++e) before[after[e]] = e;
  for (int e = 0; e < n; ++e) {
    const auto [a, b] = std::array{polygon.line[before[e]], polygon.line[e]};
    s.nodes.push_back({e, {std::min(a, b), std::max(a, b), -1}, event_class::edge});
    s.faces.push_back(e);
    arc[e] = e;
    s.arcs.push_back({e, -1, {before[e], e}});
  }
  auto now = k.start();
  while (true) {
    int first = -1;
    auto when = now;
    for (int e = 0; e < n; ++e) {
      if (!alive[e]) continue;
      triple q = {polygon.line[before[e]], polygon.line[e], polygon.line[after[e]]};
      std::sort(q.begin(), q.end());
      if (q[0] == q[1] || q[1] == q[2]) continue;
      const auto m = k.meet(q);
      if (!m || k.compare(*m, now) != sign::positive || (first >= 0 && k.compare(*m, when) == sign::positive)) continue;
      first = e;
      when = *m;
    }
    if (first < 0) return s;
    now = when;
    const int in = before[first];
    const int out = after[first];
    const int node = static_cast<int>(s.nodes.size());
    s.nodes.push_back({-1, k.planes(when), event_class::edge});
    ++s.events[0];
    s.arcs[arc[first]].target = s.arcs[arc[out]].target = node;
    alive[first] = false;
    if (after[out] == in) {
      s.arcs[arc[in]].target = node;
      alive[in] = alive[out] = false;
      continue;
    }
    after[in] = out;
    before[out] = in;
    arc[out] = static_cast<int>(s.arcs.size());
    s.arcs.push_back({node, -1, {in, out}});
  }
}

TEST(PlanarRefutation, OfSkeletonsThatIgnoreSplits) {
  int convex = 0;
  int refuted = 0;
  int complete = 0;
  for (const auto s : {shape::general, shape::holes})
    for (const auto w : {weighting::none, weighting::decimal})
      for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const specimen one(sample(s, w, seed));
        SCOPED_TRACE(one.name);
        if (one.polygon.points.size() > 40) continue;
        const auto naive = without_splits(one.kernel, one.polygon.boundary);
        const bool ends = std::none_of(naive.arcs.begin(), naive.arcs.end(), [](const auto& a) { return a.target < 0; });
        const auto verdict = one.verdict(naive);
        if (one.raw.events[1] == 0) {
          ++convex;
          EXPECT_EQ(text_of(verdict), "certified");
        } else {
          ++refuted;
          complete += ends ? 1 : 0;
          EXPECT_TRUE(verdict) << "certified" << (ends ? ", and complete" : "");
        }
      }
  EXPECT_GT(convex, 20);
  EXPECT_GT(refuted, 100);
  RecordProperty("complete", complete);
}

/// A kernel for which three lines never meet.
template <class K>
struct blind {
  static constexpr bool exact = false;
  using meeting = typename K::meeting;
  const K& k;
  triple hidden;

  line_id size() const { return k.size(); }
  sign orientation(line_id a, line_id b) const { return k.orientation(a, b); }
  bool transversal(line_id a, line_id b) const { return k.transversal(a, b); }
  std::optional<meeting> meet(const triple& q) const { return q == hidden ? std::nullopt : k.meet(q); }
  triple planes(const meeting& m) const { return k.planes(m); }
  sign closing(const meeting& m) const { return k.closing(m); }
  meeting start() const { return k.start(); }
  sign compare(const meeting& m, const meeting& n) const { return k.compare(m, n); }
  sign side(line_id c, line_id a, line_id b, const meeting& m) const { return k.side(c, a, b, m); }
};

// Every split of every skeleton is left out once; the event loop goes on without it as long as it can.
TEST(PlanarRefutation, OfSkeletonsThatMissOneContact) {
  std::map<std::string, int> rules;
  int complete = 0;
  for (const auto& one : specimens(shape::general, weighting::none, 60)) {
    SCOPED_TRACE(one.name);
    for (const auto& node : one.raw.nodes) {
      if (node.vertex >= 0 || node.event != event_class::split) continue;
      const blind<default_kernel> k{one.kernel, node.lines};
      plane::skeleton wrong;
      try {
        plane::skeleton_options o;
        o.outside = true;  // hands out what has no end
        const plane::vertex_enclosures motion(lines_of(one.polygon), one.polygon.points, true);
        wrong = plane::propagation(k, one.polygon.boundary, motion, o).run();
      } catch (const error&) {
        continue;
      }
      complete += std::none_of(wrong.arcs.begin(), wrong.arcs.end(), [](const auto& a) { return a.target < 0; }) ? 1 : 0;
      const auto verdict = one.verdict(wrong);
      EXPECT_TRUE(verdict) << "certified without node of lines " << node.lines[0] << ' ' << node.lines[1] << ' ' << node.lines[2];
      ++rules[rule_of(verdict)];
    }
  }
  EXPECT_GT(rules["length"] + rules["end"], 20);
  RecordProperty("complete", complete);
}

// ---- anything at all

/// A number that a skeleton could have, or could not.
int any_number(dice& roll, int size) {
  switch (roll.between(0, 7)) {
    case 0:
      return -1;
    case 1:
      return std::numeric_limits<int>::min();
    case 2:
      return std::numeric_limits<int>::max();
    case 3:
      return size;
    default:
      return static_cast<int>(roll.between(0, std::max(1, size) - 1));
  }
}

// One number is changed; nothing but what means nothing may be certified.
TEST(PlanarGarbage, OneNumberIsAnother) {
  int changed = 0;
  for (const auto& one : specimens(shape::holes, weighting::small, 20)) {
    SCOPED_TRACE(one.name);
    const int nodes = static_cast<int>(one.raw.nodes.size());
    const int arcs = static_cast<int>(one.raw.arcs.size());
    const int faces = static_cast<int>(one.raw.faces.size());
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      dice roll(seed);
      auto s = one.raw;
      auto& node = s.nodes[roll.between(0, nodes - 1)];
      auto& arc = s.arcs[roll.between(0, arcs - 1)];
      const std::array<int*, 9> fields = {&node.vertex,   &node.lines[0], &node.lines[1],
                                          &node.lines[2], &arc.source,    &arc.target,
                                          &arc.faces[0],  &arc.faces[1],  &s.faces[roll.between(0, faces - 1)]};
      int& field = *fields[static_cast<std::size_t>(roll.between(0, 8))];
      const int old = field;
      field = any_number(roll, std::max(nodes, arcs));
      if (field == old) continue;
      ++changed;
      EXPECT_TRUE(one.verdict(s)) << "certified";
    }
  }
  EXPECT_GT(changed, 1000);
}

TEST(PlanarGarbage, ManyNumbersAreOthers) {
  const specimen one(sample(shape::coarse, weighting::small, 3));
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    dice roll(seed);
    auto s = one.raw;
    auto o = one.polygon.boundary;
    const int size = static_cast<int>(s.nodes.size());
    for (long changes = roll.between(1, 20); changes-- > 0;) {
      const auto any = [&](auto& list) -> auto& { return list[static_cast<std::size_t>(roll.between(0, static_cast<long>(list.size()) - 1))]; };
      switch (roll.between(0, 9)) {
        case 0:
          any(s.nodes).lines[static_cast<std::size_t>(roll.between(0, 2))] = any_number(roll, one.polygon.boundary.lines);
          break;
        case 1:
          any(s.nodes).event = static_cast<event_class>(roll.between(0, 255));
          break;
        case 2:
          any(s.nodes).zero_length = true;
          break;
        case 3:
          any(s.arcs).source = any_number(roll, size);
          break;
        case 4:
          any(s.arcs).target = any_number(roll, size);
          break;
        case 5:
          std::swap(any(s.arcs), any(s.arcs));
          break;
        case 6:
          std::swap(any(s.nodes), any(s.nodes));
          break;
        case 7:
          any(s.faces) = any_number(roll, static_cast<int>(s.faces.size()));
          break;
        case 8:
          any(o.line) = any_number(roll, one.polygon.boundary.lines);
          break;
        default:
          any(roll.between(0, 1) == 0 ? o.next : o.rank) = any_number(roll, static_cast<int>(o.next.size()));
      }
    }
    plane::verify(one.kernel, o, s, seed % 2 == 0);
  }
}

TEST(PlanarGarbage, FromNothing) {
  const specimen one(sample(shape::holes, weighting::none, 5));
  const int lines = one.polygon.boundary.lines;
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    dice roll(seed);
    const auto nodes = static_cast<std::size_t>(roll.between(0, 20));
    const auto faces = static_cast<std::size_t>(roll.between(0, 12));
    plane::boundary o;
    plane::skeleton s;
    for (std::size_t i = 0; i < faces; ++i) {
      o.next.push_back(seed % 3 == 0 ? any_number(roll, static_cast<int>(faces)) : static_cast<int>((i + 1) % faces));
      o.line.push_back(static_cast<int>(roll.between(0, lines - 1)));
      o.rank.push_back(any_number(roll, 10));
      s.faces.push_back(roll.between(0, 3) == 0 ? any_number(roll, static_cast<int>(faces)) : static_cast<int>(i));
    }
    for (std::size_t i = 0; i < nodes; ++i) {
      const bool vertex = i < faces;
      triple q{};
      for (auto& l : q) l = static_cast<int>(roll.between(0, lines - 1));
      std::sort(q.begin(), q.end());
      if (vertex) q = {std::min(o.line[(i + faces - 1) % faces], o.line[i]), std::max(o.line[(i + faces - 1) % faces], o.line[i]), -1};
      s.nodes.push_back({vertex ? static_cast<int>(i) : -1, q, event_class::edge, roll.between(0, 5) == 0});
    }
    for (long arcs = roll.between(0, 30); arcs-- > 0;)
      s.arcs.push_back({any_number(roll, static_cast<int>(nodes)),
                        any_number(roll, static_cast<int>(nodes)),
                        {any_number(roll, static_cast<int>(faces)), any_number(roll, static_cast<int>(faces))}});
    const auto verdict = plane::verify(one.kernel, o, s, seed % 2 == 0);
    EXPECT_TRUE(verdict || faces == 0) << "certified";
    plane::verify_contraction(one.kernel.base(), one.polygon.boundary, one.raw, {{}, {}, any_number(roll, 3), any_number(roll, 3)});
  }
}

// ---- the contracted skeleton

class TamperedContraction : public testing::Test {
 protected:
  static void refutes(const std::function<void(plane::contracted_skeleton&, dice&)>& change, const std::set<std::string>& rules) {
    std::set<std::string> seen;
    for (const auto shape : {shape::general, shape::symmetric, shape::coarse})
      for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const specimen one(sample(shape, weighting::none, seed));
        SCOPED_TRACE(one.name);
        auto s = plane::contract(one.kernel.base(), one.polygon.boundary.line, one.raw);
        if (static_cast<int>(s.nodes.size()) < s.vertices + 3) continue;
        dice roll(seed);
        change(s, roll);
        const auto verdict = plane::verify_contraction(one.kernel.base(), one.polygon.boundary, one.raw, s);
        EXPECT_TRUE(rules.contains(rule_of(verdict))) << text_of(verdict);
        seen.insert(rule_of(verdict));
      }
    EXPECT_EQ(seen, rules);
  }
  static plane::contracted_skeleton::arc& any_arc(plane::contracted_skeleton& s, dice& roll) {
    return s.arcs[roll.between(0, static_cast<long>(s.arcs.size()) - 1)];
  }
  static int inner_node(const plane::contracted_skeleton& s, dice& roll) {
    return static_cast<int>(roll.between(s.vertices, static_cast<long>(s.nodes.size()) - 1));
  }
};

TEST_F(TamperedContraction, ArcMissing) {
  refutes([](auto& s, dice& roll) { s.arcs.erase(s.arcs.begin() + (&any_arc(s, roll) - s.arcs.data())); }, {"start", "event"});
}
TEST_F(TamperedContraction, ArcTwice) {
  refutes([](auto& s, dice& roll) { s.arcs.push_back(any_arc(s, roll)); }, {"start", "event"});
}
TEST_F(TamperedContraction, ArcEndsElsewhere) {
  refutes(
      [](auto& s, dice& roll) {
        auto& a = any_arc(s, roll);
        const int old = a.target;
        while (a.target == old) a.target = inner_node(s, roll);
      },
      {"place", "order"});
}
TEST_F(TamperedContraction, ArcOfAnotherFace) {
  refutes(
      [](auto& s, dice& roll) {
        auto& a = any_arc(s, roll);
        const auto old = a.faces;
        while (a.faces[0] == old[0]) a.faces[0] = any_arc(s, roll).faces[1];
      },
      {"structure", "place", "start"});
}
// Every arc in turn: out of its vertex, forwards in time, or along a ridge from the smaller number to the greater one.
TEST(PlanarContraction, ArcsDoNotRunBackwards) {
  int ridges = 0;
  for (const auto shape : {shape::general, shape::symmetric, shape::coarse})
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      const specimen one(sample(shape, weighting::none, seed));
      SCOPED_TRACE(one.name);
      const auto right = plane::contract(one.kernel.base(), one.polygon.boundary.line, one.raw);
      for (std::size_t a = 0; a < right.arcs.size(); ++a) {
        auto wrong = right;
        auto& arc = wrong.arcs[a];
        std::swap(arc.source, arc.target);
        EXPECT_EQ(rule_of(plane::verify_contraction(one.kernel.base(), one.polygon.boundary, one.raw, wrong)), "order") << "arc " << a;
        if (arc.target < right.vertices) continue;
        const auto time_of = [&](int n) { return *one.kernel.base().meet(right.nodes[n].lines); };
        ridges += one.kernel.base().compare(time_of(arc.source), time_of(arc.target)) == sign::zero ? 1 : 0;
      }
    }
  EXPECT_GT(ridges, 10);
}
TEST_F(TamperedContraction, NodeElsewhere) {
  refutes(
      [](auto& s, dice& roll) {
        const int n = inner_node(s, roll);
        const auto old = s.nodes[n].lines;
        while (s.nodes[n].lines == old) s.nodes[n] = s.nodes[inner_node(s, roll)];
      },
      {"place", "order"});
}
TEST_F(TamperedContraction, FacesCountedWrongly) {
  refutes([](auto& s, dice&) { ++s.faces; }, {"count"});
}
TEST_F(TamperedContraction, NodeDropped) {
  refutes(
      [](auto& s, dice& roll) {
        const int n = inner_node(s, roll);
        std::erase_if(s.arcs, [n](const auto& a) { return a.source == n || a.target == n; });
      },
      {"start", "event"});
}

// ---- faces are monotone (unit weights): a perpendicular of the edge meets its face in one piece (AAAG95, section 2)

using real = boost::multiprecision::mpf_float_100;

/// Where three lines of a polygon meet.
std::array<real, 2> place_of(const plane::polygon<integer>& p, const triple& lines) {
  std::array<std::array<real, 4>, 3> rows;  // n x + t = d
  for (std::size_t r = 0; r < 3; ++r) {
    const auto& l = p.lines[lines[r]];
    const real length = sqrt(real(l.n[0]) * real(l.n[0]) + real(l.n[1]) * real(l.n[1]));
    rows[r] = {real(l.n[0]) / length, real(l.n[1]) / length, real(l.weight), real(l.d) / length};
  }
  const auto det = [&](std::size_t a, std::size_t b, std::size_t c) {
    real sum = 0;
    for (std::size_t r = 0; r < 3; ++r)
      sum += rows[r][a] * (rows[(r + 1) % 3][b] * rows[(r + 2) % 3][c] - rows[(r + 1) % 3][c] * rows[(r + 2) % 3][b]);
    return sum;
  };
  const real all = det(0, 1, 2);
  return {det(3, 1, 2) / all, det(0, 3, 2) / all};
}

TEST(PlanarFaces, AreMonotone) {
  const real near("1e-40");
  int checked = 0;
  for (const auto s : all_shapes)
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const specimen one(sample(s, weighting::none, seed));
      SCOPED_TRACE(one.name);
      const auto& p = one.polygon;
      const auto c = plane::contract(one.kernel.base(), p.boundary.line, one.raw);
      const int n = static_cast<int>(p.points.size());
      std::vector<std::array<real, 2>> places;
      for (const auto& q : p.points) places.push_back({real(q[0]), real(q[1])});
      for (const auto& node : c.nodes) places.push_back(node.vertex >= 0 ? places[node.vertex] : place_of(p, node.lines));
      const auto number = [&](int node) { return c.nodes[node].vertex >= 0 ? c.nodes[node].vertex : n + node; };
      std::vector<std::vector<std::array<int, 2>>> border(p.points.size());  // by face: pieces between places
      for (int e = 0; e < n; ++e) border[one.raw.faces[e]].push_back({e, p.boundary.next[e]});
      for (const auto& a : c.arcs)
        for (const int f : a.faces) border[f].push_back({number(a.source), number(a.target)});
      for (int f = 0; f < n; ++f) {
        if (border[f].empty()) continue;
        const auto& normal = p.lines[p.boundary.line[f]].n;
        // Of a closed border an even number of pieces passes over every point of the edge's line: none or two.
        std::vector<std::pair<real, int>> ends;
        for (const auto& piece : border[f]) {
          std::array<real, 2> at;
          for (std::size_t i = 0; i < 2; ++i) at[i] = places[piece[i]][1] * real(normal[0]) - places[piece[i]][0] * real(normal[1]);
          if (abs(real(at[0] - at[1])) < near) continue;
          ends.emplace_back(std::min(at[0], at[1]), 1);
          ends.emplace_back(std::max(at[0], at[1]), -1);
        }
        std::sort(ends.begin(), ends.end());
        int over = 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
          over += ends[i].second;
          if (i + 1 < ends.size() && ends[i + 1].first - ends[i].first < near) continue;
          EXPECT_TRUE(over == 0 || over == 2) << "face " << f << " has " << over << " pieces of border beside each other";
        }
        ++checked;
      }
    }
  EXPECT_GT(checked, 1000);
}

}  // namespace
}  // namespace osteon::test
