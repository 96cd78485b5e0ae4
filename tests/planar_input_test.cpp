// SPDX-License-Identifier: MIT

// From rings to polygons: repairs, touchings, and every verdict compared with a plain search through all pairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/input/rewound.hpp"
#include "osteon/input/write_xy.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::plane {
namespace {

using models::dice;
using point = std::array<long, 2>;

struct plain_ring {
  std::vector<point> points;
  int part = 0;
  std::vector<long> weights;
};
using plain = std::vector<plain_ring>;

rings<integer> exact(const plain& p) {
  rings<integer> r;
  for (const auto& ring : p) {
    auto& to = r.all.emplace_back();
    to.part = ring.part;
    for (const auto& q : ring.points) to.points.push_back({exact_number<integer>{q[0], 0, 0}, exact_number<integer>{q[1], 0, 0}});
    for (const long w : ring.weights) to.weights.push_back({w, 0, 0});
  }
  return r;
}

std::string print(const plain& p) {
  std::ostringstream text;
  for (const auto& ring : p) {
    text << "part " << ring.part << ":";
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      text << " (" << ring.points[i][0] << ',' << ring.points[i][1];
      if (!ring.weights.empty()) text << " w" << ring.weights[i];
      text << ')';
    }
    text << '\n';
  }
  return text.str();
}

// ---- the plain checks: quadratic, in 64 bits, for coordinates in 0 .. 12

int turn(const point& a, const point& b, const point& c) {
  const long d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return d > 0 ? 1 : d < 0 ? -1 : 0;
}
long along(const point& a, const point& b, const point& c) { return (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]); }
bool inside_edge(const point& a, const point& b, const point& p) { return turn(a, b, p) == 0 && along(p, a, b) < 0; }

// Whether direction x lies strictly between a and b, going counter-clockwise from a.
bool between(const point& p, const point& a, const point& b, const point& x) {
  const auto left = [&](const point& u, const point& v) {
    return turn(p, u, v) > 0 || (turn(p, u, v) == 0 && along(p, u, v) < 0);
  };                              // angle in (0, pi]
  const bool wide = !left(a, b);  // more than a half turn
  const auto after_a = [&](const point& u) { return turn(p, a, u) > 0; };
  const auto before_b = [&](const point& u) { return turn(p, u, b) > 0; };
  if (turn(p, a, b) == 0 && along(p, a, b) < 0) return after_a(x);
  if (!wide) return after_a(x) && before_b(x);
  return !(turn(p, b, x) > 0 && turn(p, x, a) > 0) && !(turn(p, a, x) == 0 && along(p, a, x) > 0) && !(turn(p, b, x) == 0 && along(p, b, x) > 0);
}

struct verdict {
  std::optional<input_fault> fault;
  long twice_area = 0;
  int parts = 0;
};

struct plain_edge {
  point a, b;
};

constexpr long fine = 1009;    // no two edges of the grid meet at this fraction of an edge
constexpr long units = 27720;  // divisible by 1 .. 12

bool contains(const std::vector<point>& ring, const point& p_fine) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    point a = ring[i];
    point b = ring[(i + 1) % ring.size()];
    for (long* x : {&a[0], &a[1], &b[0], &b[1]}) *x *= fine;
    if ((a[1] > p_fine[1]) == (b[1] > p_fine[1])) continue;
    if (a[1] > b[1]) std::swap(a, b);
    if (turn(a, b, p_fine) > 0) in = !in;
  }
  return in;
}

// The interior in trapezoids between the abscissas of points; those that share a piece of a side are connected.
std::pair<int, long> pieces_and_area(const std::vector<plain_edge>& edges) {
  std::set<long> xs;
  for (const auto& e : edges) xs.insert(e.a[0]);
  struct trapezoid {
    long left_lo, left_hi, right_lo, right_hi;
    int id;
  };
  std::vector<int> parent;
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  long area = 0;
  std::vector<trapezoid> before;
  for (auto x = xs.begin(); std::next(x) != xs.end(); ++x) {
    const long l = *x;
    const long r = *std::next(x);
    std::vector<std::pair<long, long>> spans;
    for (const auto& e : edges) {
      if (std::min(e.a[0], e.b[0]) > l || std::max(e.a[0], e.b[0]) < r) continue;
      const auto y = [&](long at) { return e.a[1] * units + (e.b[1] - e.a[1]) * (at - e.a[0]) * (units / (e.b[0] - e.a[0])); };
      spans.emplace_back(y(l), y(r));
    }
    std::sort(spans.begin(), spans.end(), [](const auto& s, const auto& t) { return s.first + s.second < t.first + t.second; });
    std::vector<trapezoid> now;
    for (std::size_t i = 0; i + 1 < spans.size(); i += 2) {
      now.push_back({spans[i].first, spans[i + 1].first, spans[i].second, spans[i + 1].second, static_cast<int>(parent.size())});
      parent.push_back(static_cast<int>(parent.size()));
      area += (now.back().left_hi - now.back().left_lo + now.back().right_hi - now.back().right_lo) * (r - l);
    }
    std::vector<std::pair<long, long>> walls;
    for (const auto& e : edges)
      if (e.a[0] == l && e.b[0] == l) walls.emplace_back(std::min(e.a[1], e.b[1]) * units, std::max(e.a[1], e.b[1]) * units);
    for (const auto& s : before)
      for (const auto& t : now) {
        const long lo = std::max(s.right_lo, t.left_lo);
        const long hi = std::min(s.right_hi, t.left_hi);
        if (lo >= hi) continue;
        std::set<long> cuts = {lo, hi};
        for (const auto& w : walls)
          for (const long c : {w.first, w.second})
            if (lo < c && c < hi) cuts.insert(c);
        for (auto c = cuts.begin(); std::next(c) != cuts.end(); ++c) {
          const long u = *c;
          const long v = *std::next(c);
          if (std::none_of(walls.begin(), walls.end(), [&](const auto& w) { return w.first <= u && v <= w.second; })) parent[root(s.id)] = root(t.id);
        }
      }
    before = now;
  }
  int pieces = 0;
  for (int i = 0; i < static_cast<int>(parent.size()); ++i) pieces += parent[i] == i ? 1 : 0;
  return {pieces, area / units};
}

verdict judge(const plain& p) {
  std::vector<std::vector<point>> all;
  for (const auto& ring : p) {
    std::vector<point> c;
    for (const auto& q : ring.points)
      if (c.empty() || c.back() != q) c.push_back(q);
    while (c.size() > 1 && c.back() == c.front()) c.pop_back();
    if (ring.points.size() < 3) return {input_fault::short_ring};
    all.push_back(c);
  }
  for (const auto& c : all) {
    const auto n = c.size();
    if (n < 3) return {input_fault::short_ring};
    bool flat = true;
    bool spike = false;
    for (std::size_t i = 0; i < n; ++i) {
      const int t = turn(c[i], c[(i + 1) % n], c[(i + 2) % n]);
      flat = flat && t == 0;
      spike = spike || (t == 0 && along(c[(i + 1) % n], c[i], c[(i + 2) % n]) > 0);
    }
    if (flat) return {input_fault::zero_area};
    if (spike) return {input_fault::spike};
  }
  std::vector<plain_edge> edges;
  struct corner {
    point before, at, after;
  };
  std::vector<corner> corners;
  for (const auto& c : all)
    for (std::size_t i = 0; i < c.size(); ++i) {
      edges.push_back({c[i], c[(i + 1) % c.size()]});
      corners.push_back({c[i], c[(i + 1) % c.size()], c[(i + 2) % c.size()]});
    }
  const verdict crossed = {input_fault::self_intersection};
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [a, b] = edges[i];
      const auto& [c, d] = edges[j];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return crossed;
      if (turn(a, b, c) != 0 || turn(a, b, d) != 0) continue;
      const long lo = std::max(0L, std::min(along(a, b, c), along(a, b, d)));
      const long hi = std::min(along(a, b, b), std::max(along(a, b, c), along(a, b, d)));
      if (lo < hi) return crossed;
    }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& k = corners[i];
    const auto crosses = [&](const point& c, const point& d) { return between(k.at, k.before, k.after, c) != between(k.at, k.before, k.after, d); };
    for (std::size_t j = 0; j < i; ++j)
      if (corners[j].at == k.at && crosses(corners[j].before, corners[j].after)) return crossed;
    for (const auto& e : edges)
      if (inside_edge(e.a, e.b, k.at) && crosses(e.a, e.b)) return crossed;
  }
  std::vector<std::vector<int>> around(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) {
      const point& a = all[i][0];
      const point& b = all[i][1];
      if (i != j && contains(all[j], {a[0] * fine + b[0] - a[0], a[1] * fine + b[1] - a[1]})) around[i].push_back(static_cast<int>(j));
    }
  std::map<int, int> outer;
  for (std::size_t i = 0; i < all.size(); ++i) outer.emplace(p[i].part, static_cast<int>(i));
  for (std::size_t i = 0; i < all.size(); ++i) {
    int parent = -1;
    for (const int j : around[i])
      if (parent < 0 || around[j].size() > around[parent].size()) parent = j;
    const bool is_outer = outer[p[i].part] == static_cast<int>(i);
    if (is_outer ? parent >= 0 && outer[p[parent].part] == parent : parent != outer[p[i].part]) return {input_fault::misplaced_ring};
  }
  const auto [pieces, area] = pieces_and_area(edges);
  if (pieces > static_cast<int>(outer.size())) return {input_fault::pinched};
  return {std::nullopt, area, static_cast<int>(outer.size())};
}

// ---- what holds for every polygon that make_polygon returns

void check_polygon(const plain& in, const polygon<integer>& p, const verdict& v) {
  const int n = static_cast<int>(p.boundary.next.size());
  ASSERT_EQ(p.boundary.line.size(), static_cast<std::size_t>(n));
  ASSERT_EQ(p.points.size(), static_cast<std::size_t>(n));
  ASSERT_EQ(p.input_points.size(), static_cast<std::size_t>(n));
  ASSERT_EQ(p.boundary.lines, static_cast<int>(p.lines.size()));
  std::vector<point> all_input;
  for (const auto& r : in) all_input.insert(all_input.end(), r.points.begin(), r.points.end());
  std::vector<point> at;
  for (int i = 0; i < n; ++i) {
    at.push_back({static_cast<long>(p.points[i][0] + p.shift[0]), static_cast<long>(p.points[i][1] + p.shift[1])});
    ASSERT_EQ(at.back(), all_input[p.input_points[i]]);
  }
  std::vector<int> previous(static_cast<std::size_t>(n), -1);
  for (int i = 0; i < n; ++i) {
    ASSERT_GE(p.boundary.next[i], 0);
    ASSERT_LT(p.boundary.next[i], n);
    ASSERT_EQ(previous[p.boundary.next[i]], -1);
    previous[p.boundary.next[i]] = i;
  }
  // Lines.
  std::set<moving_line<integer>> different(p.lines.begin(), p.lines.end());
  EXPECT_EQ(different.size(), p.lines.size());
  int lines = 0;
  for (int i = 0; i < n; ++i) {
    EXPECT_LE(p.boundary.line[i], lines);
    lines = std::max(lines, p.boundary.line[i] + 1);
    const auto& l = p.lines[p.boundary.line[i]];
    const auto& a = p.points[i];
    const auto& b = p.points[p.boundary.next[i]];
    EXPECT_EQ(gcd(l.n[0], l.n[1]), 1);
    EXPECT_EQ(l.n[0] * (b[0] - a[0]) + l.n[1] * (b[1] - a[1]), 0);
    EXPECT_GT(l.n[0] * (b[1] - a[1]) - l.n[1] * (b[0] - a[0]), 0);
    EXPECT_EQ(l.n[0] * a[0] + l.n[1] * a[1], l.d);
    // Its middle lies on an edge of the input with this weight.
    const point middle = {at[i][0] + at[p.boundary.next[i]][0], at[i][1] + at[p.boundary.next[i]][1]};
    bool found = false;
    for (const auto& r : in)
      for (std::size_t k = 0; k < r.points.size(); ++k) {
        point c = r.points[k];
        point d = r.points[(k + 1) % r.points.size()];
        for (long* x : {&c[0], &c[1], &d[0], &d[1]}) *x *= 2;
        if (c != d && turn(c, d, middle) == 0 && along(middle, c, d) <= 0 && l.weight == (r.weights.empty() ? 1 : r.weights[k])) found = true;
      }
    EXPECT_TRUE(found) << "edge " << i;
  }
  EXPECT_EQ(lines, p.boundary.lines);
  // Boundaries.
  long twice_area = 0;
  int outer = 0;
  int holes = 0;
  std::vector<bool> seen(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    if (seen[i]) continue;
    long area = 0;
    int length = 0;
    for (int k = i; !seen[k]; k = p.boundary.next[k]) {
      seen[k] = true;
      ++length;
      const auto& b = at[p.boundary.next[k]];
      area += at[k][0] * b[1] - at[k][1] * b[0];
    }
    EXPECT_GE(length, 3);
    EXPECT_NE(area, 0);
    (area > 0 ? outer : holes) += 1;
    twice_area += area;
  }
  EXPECT_EQ(twice_area, v.twice_area);
  EXPECT_EQ(outer, v.parts);
  EXPECT_EQ(p.parts, v.parts);
  EXPECT_EQ(p.holes, holes);
  // Corners, and nothing of the boundary inside of their sectors.
  for (int i = 0; i < n; ++i) {
    const point& before = at[previous[i]];
    const point& after = at[p.boundary.next[i]];
    EXPECT_NE(p.boundary.line[i], p.boundary.line[previous[i]]);
    EXPECT_FALSE(turn(before, at[i], after) == 0 && along(at[i], before, after) > 0);
    for (int j = 0; j < n; ++j) {
      if (j == i) continue;
      const point& c = at[j];
      const point& d = at[p.boundary.next[j]];
      if (c == at[i]) {
        EXPECT_FALSE(between(at[i], after, before, at[previous[j]]));
        EXPECT_FALSE(between(at[i], after, before, d));
      } else if (inside_edge(c, d, at[i])) {
        EXPECT_FALSE(between(at[i], after, before, c));
        EXPECT_FALSE(between(at[i], after, before, d));
      }
    }
  }
}

void compare(const plain& in, std::map<int, int>& tally) {
  const verdict v = judge(in);
  std::optional<polygon<integer>> p;
  std::optional<input_fault> fault;
  std::string what;
  try {
    p = make_polygon(exact(in));
  } catch (const input_error& e) {
    fault = e.fault;
    what = e.what();
  }
  const auto number = [](const std::optional<input_fault>& f) { return f ? static_cast<int>(*f) : -1; };
  ASSERT_EQ(number(fault), number(v.fault)) << what << '\n' << print(in);
  const bool touching = p && std::any_of(p->repairs.begin(), p->repairs.end(), [](const auto& r) { return r.rfind("the boundary touches", 0) == 0; });
  ++tally[touching ? -2 : number(fault)];
  if (p) check_polygon(in, *p, v);
}

TEST(PlanarInput, VerdictsOnRandomRings) {
  std::map<int, int> tally;
  for (std::uint64_t seed = 0; seed < 25'000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    dice d(seed);
    plain in;
    const long size = d.between(2, 8);
    const long rings = d.between(1, 3);
    const bool weighted = d.between(0, 3) == 0;
    for (long r = 0; r < rings; ++r) {
      auto& ring = in.emplace_back();
      ring.part = static_cast<int>(r == 0 ? 0 : d.between(0, 1));
      // Later rings are small, so that some are holes.
      const long corners = d.between(3, d.between(0, 2) == 0 ? 12 : 4);
      const long lo = r == 0 ? 0 : d.between(0, size / 2);
      const long hi = r == 0 ? size : d.between(lo, size);
      for (long i = 0; i < corners; ++i) {
        ring.points.push_back({d.between(lo, hi), d.between(lo, hi)});
        if (weighted) ring.weights.push_back(d.between(0, 2));
      }
      if (r == 0 && d.between(0, 1) == 0 && ring.weights.empty()) ring.points = {{0, 0}, {size, 0}, {size, size}, {0, d.between(1, size)}};
    }
    compare(in, tally);
    if (HasFailure()) {
      ADD_FAILURE() << print(in);
      return;
    }
  }
  EXPECT_GT(tally[-1], 500);
  EXPECT_GT(tally[-2], 50);
  for (const auto f : {input_fault::short_ring, input_fault::zero_area, input_fault::spike, input_fault::self_intersection,
                       input_fault::misplaced_ring, input_fault::pinched})
    EXPECT_GT(tally[static_cast<int>(f)], 30) << static_cast<int>(f);
}

// Boundaries of sets of squares, sheared, followed at random where four edges meet: touchings of every kind.
TEST(PlanarInput, VerdictsOnTouchingSquares) {
  std::map<int, int> tally;
  for (std::uint64_t seed = 0; seed < 12'000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    dice d(seed);
    const int size = static_cast<int>(d.between(2, 4));
    std::vector<std::vector<bool>> full(static_cast<std::size_t>(size), std::vector<bool>(static_cast<std::size_t>(size)));
    const long fill = d.between(40, 90);
    for (auto& row : full)
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = d.between(1, 100) <= fill;
    const auto at = [&](int x, int y) { return x >= 0 && y >= 0 && x < size && y < size && full[x][y]; };
    std::map<point, std::vector<point>> out;
    for (int x = 0; x <= size; ++x)
      for (int y = 0; y <= size; ++y) {
        if (at(x, y) && !at(x, y - 1)) out[{x, y}].push_back({x + 1, y});
        if (!at(x, y) && at(x, y - 1)) out[{x + 1, y}].push_back({x, y});
        if (at(x, y) && !at(x - 1, y)) out[{x, y + 1}].push_back({x, y});
        if (!at(x, y) && at(x - 1, y)) out[{x, y}].push_back({x, y + 1});
      }
    plain in;
    const long shear = d.between(0, 1);
    int parts = 0;
    while (!out.empty()) {
      plain_ring ring;
      point p = out.begin()->first;
      while (out.contains(p)) {
        auto& ways = out[p];
        const auto k = d.between(0, static_cast<long>(ways.size()) - 1);
        ring.points.push_back({p[0] + shear * p[1], p[1]});
        const point q = ways[static_cast<std::size_t>(k)];
        ways.erase(ways.begin() + k);
        if (ways.empty()) out.erase(p);
        p = q;
        if (d.between(0, 1) == 0 && ring.points.front() == point{p[0] + shear * p[1], p[1]}) break;
      }
      long area = 0;
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const auto& a = ring.points[i];
        const auto& b = ring.points[(i + 1) % ring.points.size()];
        area += a[0] * b[1] - a[1] * b[0];
      }
      ring.part = area > 0 ? parts++ : -1;
      in.push_back(ring);
    }
    if (in.empty()) continue;
    // Holes belong to the smallest outer ring around them, mostly.
    for (auto& hole : in) {
      if (hole.part >= 0) continue;
      const point& a = hole.points[0];
      const point& b = hole.points[1];
      std::size_t least = 0;
      for (const auto& ring : in)
        if (ring.part >= 0 && contains(ring.points, {a[0] * fine + b[0] - a[0], a[1] * fine + b[1] - a[1]}) &&
            (least == 0 || ring.points.size() < least)) {
          least = ring.points.size();
          hole.part = -2 - ring.part;
        }
      if (d.between(0, 9) == 0) hole.part = static_cast<int>(-2 - d.between(0, parts - 1));
    }
    for (auto& ring : in)
      if (ring.part < -1) ring.part = -2 - ring.part;
    std::stable_sort(in.begin(), in.end(), [](const auto& r, const auto& q) { return r.part < q.part; });
    for (auto& ring : in) {
      if (d.between(0, 3) == 0) std::reverse(ring.points.begin(), ring.points.end());
      if (d.between(0, 9) == 0) ring.points[ring.points.size() / 2][d.between(0, 1)] += d.between(1, 2);
      if (d.between(0, 29) == 0) ring.part = 0;
      if (d.between(0, 2) == 0)
        for (std::size_t i = 0; i < ring.points.size(); ++i) ring.weights.push_back(d.between(1, 2));
    }
    compare(in, tally);
    if (HasFailure()) {
      ADD_FAILURE() << print(in);
      return;
    }
  }
  EXPECT_GT(tally[-1], 500);
  EXPECT_GT(tally[-2], 500);
  for (const auto f : {input_fault::self_intersection, input_fault::misplaced_ring, input_fault::pinched})
    EXPECT_GT(tally[static_cast<int>(f)], 30) << static_cast<int>(f);
}

// An affine map keeps verdicts, vertices, incidences and which edges share a line; its numbers decide how much doubles can tell.
TEST(PlanarInput, AffineMapsChangeNothing) {
  std::map<int, int> tally;
  for (std::uint64_t seed = 0; seed < 2500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    dice d(seed);
    plain in;
    const long rings = d.between(1, 3);
    for (long r = 0; r < rings; ++r) {
      auto& ring = in.emplace_back();
      for (long i = d.between(3, r == 0 ? 5 : 4); i > 0; --i) ring.points.push_back({d.between(r > 0, 6 - (r > 0)), d.between(r > 0, 6 - (r > 0))});
      if (r == 0 && d.between(0, 1) == 0) ring.points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};
    }
    const auto outcome = [](plane::rings<integer> r) -> std::pair<int, polygon<integer>> {
      try {
        return {-1, make_polygon(std::move(r))};
      } catch (const input_error& e) {
        return {static_cast<int>(e.fault), {}};
      }
    };
    const auto expected = outcome(exact(in));
    ++tally[expected.first];
    for (const int bits : {20, 26, 30, 40, 52, 60, 200, 600}) {
      const auto entry = [&] { return (integer(d.between(-1'000'000'000, 1'000'000'000)) << bits >> 30) + d.between(-5, 5); };
      std::array<integer, 4> m;
      do
        for (auto& x : m) x = entry();
      while (m[0] * m[3] <= m[1] * m[2]);
      if (d.between(0, 1) == 0) {  // almost a line
        m[2] = m[0], m[3] = m[1] + 1;
        if (m[0] <= 0) m[0] = m[2] = 1 - m[0];
      }
      auto mapped = exact(in);
      for (auto& r : mapped.all)
        for (auto& p : r.points) {
          const integer x = m[0] * p[0].mantissa + m[1] * p[1].mantissa;
          const integer y = m[2] * p[0].mantissa + m[3] * p[1].mantissa;
          p[0].mantissa = x, p[1].mantissa = y;
        }
      const auto actual = outcome(mapped);
      ASSERT_EQ(actual.first, expected.first) << bits << '\n' << print(in);
      EXPECT_EQ(actual.second.boundary.next, expected.second.boundary.next) << bits << '\n' << print(in);
      EXPECT_EQ(actual.second.boundary.line, expected.second.boundary.line) << bits << '\n' << print(in);
      EXPECT_EQ(actual.second.input_points, expected.second.input_points) << bits << '\n' << print(in);
      const auto& p = actual.second;
      for (std::size_t i = 0; i < p.points.size(); ++i)
        for (const auto& at : {p.points[i], p.points[p.boundary.next[i]]}) {
          const auto& l = p.lines[p.boundary.line[i]];
          ASSERT_EQ(l.n[0] * at[0] + l.n[1] * at[1], l.d) << bits << '\n' << print(in);
        }
    }
  }
  EXPECT_GT(tally[-1], 500);
  EXPECT_GT(tally[static_cast<int>(input_fault::self_intersection)], 500);
}

// ---- single cases

polygon<integer> read(const std::string& text, const std::string& name = "a.xy") {
  std::istringstream in(text);
  return make_polygon(read_polygon<integer>(in, name));
}

const std::string square = "0 0\n10 0\n10 10\n0 10\n";

std::vector<point> input_places(const polygon<integer>& p) {
  std::vector<point> all;
  for (const auto& q : p.points) all.push_back({static_cast<long>(q[0] + p.shift[0]), static_cast<long>(q[1] + p.shift[1])});
  return all;
}

TEST(PlanarInput, Square) {
  const auto p = read("1 1\n3 1\n3 3\n1 3\n");
  EXPECT_EQ(p.boundary.next, (std::vector<int>{1, 2, 3, 0}));
  EXPECT_EQ(p.boundary.line, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(p.shift, (std::array<integer, 2>{2, 2}));
  EXPECT_EQ(p.points[0], (std::array<integer, 2>{-1, -1}));
  EXPECT_EQ(p.lines[0], (moving_line<integer>{{0, -1}, 1, 1}));
  EXPECT_EQ(p.lines[1], (moving_line<integer>{{1, 0}, 1, 1}));
  EXPECT_TRUE(p.repairs.empty());
}

TEST(PlanarInput, ScalesAndWeightsComeBack) {
  const auto p = read("0.5 0 0.25\n300 0 1e1 # steep\n300 20.05\n.5 20.05 0\n");
  EXPECT_EQ(p.ten, -2);
  EXPECT_EQ(p.weight_ten, -2);
  EXPECT_EQ(p.lines[p.boundary.line[0]].weight, 25);
  EXPECT_EQ(p.lines[p.boundary.line[1]].weight, 1000);
  EXPECT_EQ(p.lines[p.boundary.line[2]].weight, 100);
  EXPECT_EQ(p.lines[p.boundary.line[3]].weight, 0);
  EXPECT_EQ(p.points[1][0] + p.shift[0], 30000);
  const auto q = make_polygon(make_rings<integer>({{{0, 0}, {0.5, 0}, {0, 0x1p-40}}}, {{0.125, 3, 0}}));
  EXPECT_EQ(q.two, -40);
  EXPECT_EQ(q.points[1][0] + q.shift[0], integer(1) << 39);
  EXPECT_EQ(q.weight_two, -3);
  EXPECT_EQ(q.lines[q.boundary.line[1]].weight, 24);
}

TEST(PlanarInput, RepairsAreNamed) {
  const auto p = read("0 0\n0 10\n0 10.0\n10 10\n10 5\n10 0\n5 0\n\n1 1\n2 1\n1 2\n");
  ASSERT_EQ(p.repairs.size(), 3U);
  EXPECT_EQ(p.repairs[0], "1 point that repeats its predecessor was removed, the first: a.xy:3: ring 1, point 3");
  EXPECT_EQ(p.repairs[1], "2 points on straight sides were removed, the first: a.xy:5: ring 1, point 5");
  EXPECT_EQ(p.repairs[2], "1 clockwise outer ring and 1 counter-clockwise hole were reversed, the first: ring 1");
  EXPECT_EQ(p.input_points, (std::vector<int>{0, 1, 3, 5, 7, 8, 9}));
  EXPECT_EQ(p.boundary.next, (std::vector<int>{3, 0, 1, 2, 6, 4, 5}));
  EXPECT_EQ(p.holes, 1);
}

TEST(PlanarInput, WeightsStayWithTheirEdges) {
  // Clockwise, with a repeated point whose first weight belongs to no edge.
  const auto p = read("0 0 1\n0 10 9\n0 10 2\n10 10 3\n10 0 4\n");
  EXPECT_EQ(p.boundary.next, (std::vector<int>{3, 0, 1, 2}));
  std::vector<long> weights;
  for (const int l : p.boundary.line) weights.push_back(static_cast<long>(p.lines[l].weight));
  EXPECT_EQ(weights, (std::vector<long>{4, 1, 2, 3}));
}

TEST(PlanarInput, StraightCornersBetweenDifferentWeightsStay) {
  const auto p = read("0 0 1\n5 0 2\n10 0 1\n10 10 1\n5 10 1\n0 10\n");
  EXPECT_EQ(p.input_points, (std::vector<int>{0, 1, 2, 3, 5}));
  EXPECT_EQ(p.boundary.lines, 5);
}

TEST(PlanarInput, EdgesOnOneLineShareIt) {
  const auto p = read("0 0\n1 0\n1 1\n2 1\n2 0\n3 0\n3 2\n0 2\n");
  EXPECT_EQ(p.boundary.line[0], p.boundary.line[4]);
  EXPECT_NE(p.boundary.line[1], p.boundary.line[5]);
  EXPECT_EQ(p.boundary.lines, 7);
  const auto q = read("0 0 1\n1 0\n1 1\n2 1\n2 0 3\n3 0\n3 2\n0 2\n");
  EXPECT_EQ(q.boundary.lines, 8);
}

TEST(PlanarInput, HoleOnCorner) {
  const auto p = read(square + "\n0 0\n2 3\n3 2\n");
  EXPECT_EQ(p.boundary.next, (std::vector<int>{1, 2, 3, 4, 5, 6, 0}));
  EXPECT_EQ(p.holes, 0);
  EXPECT_EQ(p.points.size(), 7U);
  ASSERT_EQ(p.repairs.size(), 1U);
  EXPECT_EQ(p.repairs[0], "the boundary touches itself in 1 point, the first: a.xy:1: ring 1, point 1 on ring 2, point 1");
}

TEST(PlanarInput, HoleOnSide) {
  const auto p = read(square + "\n5 0\n4 3\n6 3\n");
  EXPECT_EQ(input_places(p), (std::vector<point>{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 0}, {4, 3}, {6, 3}}));
  EXPECT_EQ(p.boundary.next, (std::vector<int>{5, 2, 3, 4, 0, 6, 7, 1}));
  EXPECT_EQ(p.boundary.line[0], p.boundary.line[1]);
  EXPECT_EQ(p.boundary.lines, 7);
  EXPECT_EQ(p.input_points, (std::vector<int>{0, 4, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(p.holes, 0);
  EXPECT_EQ(p.repairs.at(0),
            "the boundary touches itself in 1 point, the first: a.xy:6: ring 2, point 1 on the edge between ring 1, point 1 and ring 1, point 2");
}

TEST(PlanarInput, TouchingFromOutsideCutsNothing) {
  const auto p = read("MULTIPOLYGON (((0 0, 10 0, 10 10, 0 10, 0 0)), ((10 5, 12 4, 12 6)))", "a.wkt");
  EXPECT_EQ(p.boundary.next, (std::vector<int>{1, 2, 3, 0, 5, 6, 4}));
  EXPECT_EQ(p.parts, 2);
  EXPECT_EQ(p.repairs.size(), 1U);
}

TEST(PlanarInput, CutsFollowTheEdge) {
  // Both ways along an edge, and of a ring that is reversed.
  for (const std::string& outer : {square, std::string("0 10\n10 10\n10 0\n0 0\n")}) {
    const auto p = read(outer + "\n2 0\n3 1\n4 1\n\n6 0\n7 1\n8 1\n\n2 10\n3 9\n4 9\n\n6 10\n7 9\n8 9\n");
    const auto at = input_places(p);
    int turns = 0;
    for (int i = 0; i < static_cast<int>(at.size()); ++i) {
      const point& b = at[p.boundary.next[i]];
      turns += at[i][1] == b[1] && at[i][1] % 10 == 0 ? 1 : 0;
      if (at[i][1] == 0 && b[1] == 0) {
        EXPECT_LT(at[i][0], b[0]);
      } else if (at[i][1] == 10 && b[1] == 10) {
        EXPECT_GT(at[i][0], b[0]);
      }
    }
    EXPECT_EQ(turns, 6);
    EXPECT_EQ(at.size(), 20U);
    EXPECT_EQ(p.holes, 0);
  }
}

TEST(PlanarInput, TouchedFromOutsideBetweenDifferentWeights) {
  auto r = exact({{{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}, 0, {1, 2, 1, 1, 1}}, {{{5, 0}, {4, -1}, {6, -1}}, 1, {}}});
  const auto p = make_polygon(r);
  EXPECT_EQ(p.boundary.next, (std::vector<int>{1, 2, 3, 4, 0, 6, 7, 5}));
  r.all[0].weights[1] = {1, 0, 0};
  EXPECT_EQ(make_polygon(r).points.size(), 7U);
}

TEST(PlanarInput, ManyHolesAreNotQuadratic) {
  std::vector<std::vector<std::array<double, 2>>> rings = {{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}};
  for (double x = 1; x < 999; x += 5)
    for (double y = 1; y < 999; y += 5) rings.push_back({{x, y}, {x + 2, y + 1}, {x + 1, y + 3}});
  const auto p = make_polygon(make_rings<integer>(rings));
  EXPECT_EQ(p.holes, 40'000);
  EXPECT_EQ(p.repairs.size(), 1U);  // reversed
}

TEST(PlanarInput, AllFormatsAgree) {
  const std::map<std::string, std::string> texts = {
      {"a.xy", "0 0 # corner\n\t1.50 0\r\n#comment\n1.5 2 \n0 20e-1\n0 0\n \n\n.5 .5\n0.5 1\n1 1"},
      {"a.TXT", "0 0\r1.5 0\r1.5 2\r0 2\r\r0.5 0.5\r0.5 1\r1 1\r"},
      {"nameless_xy", "\xEF\xBB\xBF# x\n0 0\n1.5 0\n1.5 2\n0 2\n\n0.5 0.5\n0.5 1\n1 1\n"},
      {"a.wkt", "POLYGON ((0 0, 1.5 0, 1.5 2, 0 2, 0 0), (0.5 0.5, 0.5 1, 1 1, 0.5 0.5))"},
      {"nameless_wkt", "SRID=4326;polygon((0 0,1.5 0,1.5 2,0 2,0 0)\n,(0.5 0.5,0.5 1,1 1,0.5 0.5));"},
      {"b.wkt", "MultiPolygon(((0 0, 1.5 0, 1.5 2, 0 2, 0 0), (0.5 0.5, 0.5 1, 1 1)))"},
      {"a.geojson", R"({"type": "Polygon", "coordinates": [[[0,0],[1.5,0],[1.5,2],[0,2],[0,0]], [[0.5,0.5],[0.5,1],[1,1],[0.5,0.5]]]})"},
      {"nameless_json",
       "\n{\"bbox\":[0,0,1,1], \"coordinates\": [[[[0,0],[15E-1,0],[1.5,2],[0,2],[0,0]], [[0.5,0.5],[0.5,1],[1,1.0]]]], \"type\": \"MultiPolygon\"}"},
      {"a.json", R"({"features": [{"geometry": {"geometries": [{"type": "Polygon", "coordinates": [[[0,0],[1.5,0],[1.5,2],[0,2],[0,0]],
        [[0.5,0.5],[0.5,1],[1,1],[0.5,0.5]]]}], "type": "GeometryCollection"}, "properties": {"type": ["\"}", {"coordinates": [null, true]}]},
        "id": -1.5e3, "type": "Feature"}], "type": "FeatureCollection"})"},
  };
  for (const auto& [name, text] : texts) {
    SCOPED_TRACE(name);
    const auto p = read(text, name);
    EXPECT_EQ(p.points.size(), 7U);
    EXPECT_EQ(p.holes, 1);
    EXPECT_TRUE(p.repairs.empty());
    const auto q = read("0 0\n1.5 0\n1.5 2\n0 2\n\n0.5 0.5\n0.5 1\n1 1\n");
    EXPECT_EQ(p.points, q.points);
    EXPECT_EQ(p.boundary.next, q.boundary.next);
    EXPECT_EQ(p.ten, -1);
  }
}

TEST(PlanarInput, HeightsAreLeftOutAndSaid) {
  for (const auto& [name, text] :
       std::map<std::string, std::string>{{"a.wkt", "POLYGON ZM ((0 0 1 2, 1 0 1 2, 0 1 1 2, 0 0 1 2))"},
                                          {"a.json", R"({"type":"Polygon","coordinates":[[[0,0,7],[1,0,7],[0,1,7],[0,0,7]]]})"}}) {
    const auto p = read(text, name);
    EXPECT_EQ(p.points.size(), 3U);
    EXPECT_EQ(p.repairs, std::vector<std::string>{"third coordinates and measures were left out, those of 4 points"});
  }
}

TEST(PlanarInput, FlatObj) {
  for (const std::string name : {"a.obj", "nameless"}) {
    const auto p = read("# box\nv 0 0 2\nv 1 0 2.0\nv 9 9 9\nv 1 1 20e-1\nvn 0 0 1\nf 4 2 1\n", name);
    EXPECT_EQ(p.points.size(), 3U);
    EXPECT_EQ(p.repairs, std::vector<std::string>{"1 clockwise outer ring was reversed, the first: ring 1"});
  }
}

TEST(PlanarInput, EveryPolygonOfGeoJsonIsAPart) {
  const auto p = read(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4]], [[1,1],[1,2],[2,2]]]}},
    {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[5,0],[9,0],[9,4],[5,4]], [[6,1],[6,2],[7,2]]], [[[5,5],[9,5],[9,9]]]]}},
    {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0,5],[4,5],[4,9]]]}}]})",
                      "a.geojson");
  EXPECT_EQ(p.parts, 4);
  EXPECT_EQ(p.holes, 2);
  EXPECT_TRUE(p.repairs.empty());
}

TEST(PlanarInput, FormatsAreTold) {
  for (const auto& [name, format] : std::map<std::string, format>{{"a.xy", format::xy},
                                                                  {"b.txt", format::xy},
                                                                  {"c.WKT", format::wkt},
                                                                  {"d.json", format::geojson},
                                                                  {"e.GeoJSON", format::geojson},
                                                                  {"f.obj", format::obj}})
    EXPECT_EQ(format_of_name(name), format) << name;
  for (const char* name : {"", "xy", "a.xyz", "a.wkt.bak", "obj"}) EXPECT_FALSE(format_of_name(name)) << name;
  const std::map<std::string, format> told = {
      {"0 0", format::xy},
      {"\n# x\n -1.5 2", format::xy},
      {"+.5 2", format::xy},
      {"{\"type\"", format::geojson},
      {"\xEF\xBB\xBF \n[", format::geojson},
      {"polygon((0 0", format::wkt},
      {"MultiPolygonZ (", format::wkt},
      {"# x\nSRID=4326;POLYGON", format::wkt},
      {"LINESTRING (", format::wkt},
      {"# box\r\nv 0 0 0", format::obj},
      {"mtllib a.mtl", format::obj},
      {"f\t1 2 3", format::obj},
      {"l 1 2", format::obj},
  };
  for (const auto& [text, format] : told) EXPECT_EQ(format_of_text(text), format) << text;
  for (const char* text : {"", "# only a comment", "OFF\n8 6 12", "solid cube", "<html>", "POLYGONE", "POLYGONXZ (", "---"}) {
    EXPECT_FALSE(format_of_text(text)) << text;
    EXPECT_EQ(guess_format("a.wkt", text), format::wkt) << text;
    EXPECT_EQ(guess_format("nameless", text), format::xy) << text;
  }
}

TEST(PlanarInput, ABeginningCanBeReadAgain) {
  std::string text;
  for (int i = 0; i < 40'000; ++i) text += std::to_string(i) + '\n';  // several times what is looked at
  for (const std::string& all : {text, std::string("short"), std::string()}) {
    std::istringstream in(all);
    rewound again(in, "text");
    EXPECT_EQ(again.beginning(), all.substr(0, 1U << 16U));
    std::ostringstream copy;
    copy << again.stream().rdbuf();
    EXPECT_EQ(copy.str(), all);
  }
}

TEST(PlanarInput, RingsAreWrittenAsTheyAreRead) {
  const std::string text = "0 0\n15e-1 0\n15e-1 2\n0 2\n\n5e-1 5e-1 1\n5e-1 1 25e-2\n1 1 0\n";
  std::istringstream in(text);
  const auto r = read_xy<integer>(in, "a.xy");
  std::ostringstream out;
  write_xy(out, r);
  EXPECT_EQ(out.str(), text);
  std::ostringstream doubles;
  write_xy(doubles, std::vector<std::vector<std::array<double, 2>>>{{{0.1, -2}, {1e300, 0x1p-40}}, {{1, 2}}});
  EXPECT_EQ(doubles.str(), "0.1 -2\n1e+300 9.094947017729282e-13\n\n1 2\n");
}

TEST(PlanarInput, EdgesKnowTheWayBack) {
  const auto p = read("0 0\n0 10\n0 10\n10 10\n10 5\n10 0\n");
  EXPECT_EQ(p.input_points, (std::vector<int>{0, 1, 3, 5}));
  EXPECT_EQ(p.boundary.next, (std::vector<int>{3, 0, 1, 2}));
  EXPECT_EQ(p.input_edges, (std::vector<int>{5, 0, 2, 3})) << "from 0 along edge 5, from 1 back along edge 0, and so on";
  std::istringstream in("0 0\n0 10\n0 10\n10 10\n10 5\n10 0\n");
  const auto outside = make_polygon(read_polygon<integer>(in, "a.xy"), true);
  EXPECT_EQ(outside.input_edges, (std::vector<int>{0, 2, 3, 5}));
}

TEST(PlanarInput, IslandsInHoles) {
  const auto p =
      read("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9), (1 1, 1 8, 8 8, 8 1)), ((2 2, 7 2, 7 7, 2 7), (3 3, 3 6, 6 6, 6 3)), ((4 4, 5 4, 5 5)))", "a.wkt");
  EXPECT_EQ(p.parts, 3);
  EXPECT_EQ(p.holes, 2);
  EXPECT_TRUE(p.repairs.empty());
}

}  // namespace
}  // namespace osteon::plane
