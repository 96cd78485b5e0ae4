// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generated polygons with integer coordinates for tests, measurements and first steps.
///
/// All but those of touching_cells are simple: edges meet only in the vertex between neighbours. Outer rings run counter-clockwise, holes
/// clockwise; the interior is connected. Equal arguments give equal polygons (to the last digit where the machine's sine and cosine agree). `n` is
/// the number of vertices, met exactly unless the function says otherwise; sizes below the stated least one are taken as that one. Time and space
/// are linear unless stated otherwise.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/input/polygon.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::plane::models {

using osteon::models::dice;
using point = std::array<long, 2>;
using ring = std::vector<point>;
using region = std::vector<ring>;  ///< the outer ring first

// ---- tools

/// Twice the signed area of the triangle pqr: positive where it turns left. Exact while the points lie in a square of side 2^31.
inline long turn(const point& p, const point& q, const point& r) { return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); }

/// The point at a distance and an angle (in full turns) from a centre, rounded.
inline point polar(double radius, double turns, const point& centre = {0, 0}) {
  const double angle = 2 * 3.14159265358979323846 * turns;
  return {centre[0] + std::lround(radius * std::cos(angle)), centre[1] + std::lround(radius * std::sin(angle))};
}

/// Uniform in [lo, hi).
inline double uniform(dice& roll, double lo, double hi) { return lo + (hi - lo) * static_cast<double>(roll() >> 11U) * 0x1p-53; }

inline point jittered(const point& p, long most, dice& roll) {
  const long dx = roll.between(-most, most);
  const long dy = roll.between(-most, most);
  return {p[0] + dx, p[1] + dy};
}

/// A radius at which n points around a circle are tens of units apart or more, so that rounding does not change their order by angle.
inline double roomy_radius(int n) { return std::max(1e6, 100.0 * n); }

/// n points around a centre, angles increasing by less than half a turn, so that the ring is simple and sees its centre; radii uniform in lo .. hi.
inline ring spiky(int n, double lo, double hi, const point& centre, dice& roll) {
  ring points;
  for (int i = 0; i < n; ++i) {
    const double turns = (i + uniform(roll, -0.2, 0.2)) / n;
    points.push_back(polar(uniform(roll, lo, hi), turns, centre));
  }
  return points;
}

// ---- general position: no two edges parallel, no simultaneous events, but by bad luck

/// A star-shaped polygon of random radii: long thin spikes where n is large. n >= 3.
inline region noisy_star(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  return {spiky(n, 0.4 * roomy_radius(n), roomy_radius(n), {0, 0}, roll)};
}

/// A smooth star-shaped curve, a circle and a few harmonics, with noise of the size of an edge. n >= 3.
inline region noisy_loop(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  std::array<std::array<double, 2>, 6> waves{};
  for (auto& [amplitude, phase] : waves) amplitude = uniform(roll, 0, 0.1), phase = uniform(roll, 0, 6.2831853);
  const double noise = std::min(0.1, 1.0 / n);
  ring points;
  for (int i = 0; i < n; ++i) {
    const double turns = (i + uniform(roll, -0.2, 0.2)) / n;
    double radius = 1 + uniform(roll, -noise, noise);
    for (std::size_t k = 0; k < waves.size(); ++k)
      radius += waves[k][0] * std::cos(2 * 3.14159265358979323846 * static_cast<double>(k + 2) * turns + waves[k][1]);
    points.push_back(polar(radius * roomy_radius(n), turns));
  }
  return {points};
}

/// A spine with about n / 4 teeth, ten times as long as wide, all vertices jittered. n >= 8.
inline region comb(int n, std::uint64_t seed) {
  n = std::max(n, 8);
  dice roll(seed);
  const long teeth = (n - 4) / 4;
  const long below = n - 2 - 4 * teeth;  // vertices of the spine's lower side; two more close its ends
  const long length = 2000 * teeth + 1000;
  ring points;
  for (long i = 0; i < below; ++i) points.push_back({length * i / (below - 1), -1500});
  points.push_back({length, 0});
  for (long i = teeth; i-- > 0;)
    for (const point& p : {point{2000 * i + 2000, 0}, {2000 * i + 2000, 10000}, {2000 * i + 1000, 10000}, {2000 * i + 1000, 0}}) points.push_back(p);
  points.push_back({0, 0});
  for (point& p : points) p = jittered(p, 150, roll);
  return {points};
}

/// Both sides of an Archimedean spiral, half a winding's distance apart, slightly jittered; about sqrt(n) / 5 windings. n >= 4.
inline region spiral(int n, std::uint64_t seed) {
  n = std::max(n, 4);
  dice roll(seed);
  const double pitch = 4000;
  const auto at = [pitch](int i, double inwards) {  // steps of a quarter of the pitch along the curve
    const double turns = std::sqrt(3.14159265358979323846 * (i + 16)) / (2 * 3.14159265358979323846);
    return polar(pitch * (turns - inwards), turns);
  };
  ring points;
  for (int i = 0; i < n - n / 2; ++i) points.push_back(at(i, 0));
  for (int i = n / 2; i-- > 0;) points.push_back(at(i, 0.5));
  for (point& p : points) p = jittered(p, 80, roll);
  return {points};
}

/// Orders points into a simple chain between two others, all in general position: a random line through one of the points, which becomes the
/// chain's middle, parts the others and the ends; the halves' hulls share only that point. False where points are collinear or too close.
/// Expected O(n log n). Space partitioning, after Auer and Held, Heuristics for the generation of random polygons, CCCG 1996.
inline bool chain(const point& from, const point& to, std::span<point> inner, dice& roll) {
  if (inner.empty()) return true;
  if (inner.size() == 1) return turn(from, inner[0], to) != 0;
  for (int attempt = 0; attempt < 64; ++attempt) {
    std::swap(inner[0], inner[roll() % inner.size()]);
    const point middle = inner[0];
    const double t = uniform(roll, 0, 1);
    point towards{};
    for (const int k : {0, 1}) towards[k] = from[k] + std::lround(t * static_cast<double>(to[k] - from[k]));
    const bool left = turn(middle, towards, from) > 0;
    const auto with_from = [&](const point& p) { return (turn(middle, towards, p) > 0) == left; };
    const auto rest = inner.subspan(1);
    if (with_from(to) || turn(middle, towards, from) == 0 || turn(middle, towards, to) == 0) continue;
    if (std::any_of(rest.begin(), rest.end(), [&](const point& p) { return turn(middle, towards, p) == 0; })) continue;
    const auto half = static_cast<std::size_t>(std::partition(rest.begin(), rest.end(), with_from) - rest.begin());
    std::swap(inner[0], inner[half]);
    return chain(from, middle, inner.subspan(0, half), roll) && chain(middle, to, inner.subspan(half + 1), roll);
  }
  return false;
}

/// A simple polygon through n uniformly random points of a square. n >= 3. Expected O(n log n).
inline region random_polygon(int n, std::uint64_t seed) {
  n = std::max(n, 3);
  dice roll(seed);
  const long half = std::clamp(500L * n, 1'000'000L, 1'000'000'000L);
  for (;;) {  // seldom more than once
    ring points;
    for (int i = 0; i < n; ++i) points.push_back(jittered({0, 0}, half, roll));
    const std::span<point> all(points);
    const point a = all[0];
    const point b = all[1];
    const auto rest = all.subspan(2);
    if (a == b || std::any_of(rest.begin(), rest.end(), [&](const point& p) { return turn(a, b, p) == 0; })) continue;
    const auto right =
        static_cast<std::size_t>(std::partition(rest.begin(), rest.end(), [&](const point& p) { return turn(a, b, p) < 0; }) - rest.begin());
    if (!chain(a, b, rest.subspan(0, right), roll) || !chain(b, a, rest.subspan(right), roll)) continue;
    std::rotate(all.begin() + 1, all.begin() + 2, all.begin() + 2 + static_cast<std::ptrdiff_t>(right));  // b follows those on its right
    return {points};
  }
}

/// The distance from p to a closed polygon's edges; negative where p is not inside. Linear time, in doubles.
inline double clearance(const region& r, const point& p) {
  double nearest = 1e300;
  bool inside = false;
  for (const ring& points : r)
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
      const auto ax = static_cast<double>(points[j][0] - p[0]);
      const auto ay = static_cast<double>(points[j][1] - p[1]);
      const auto bx = static_cast<double>(points[i][0] - p[0]);
      const auto by = static_cast<double>(points[i][1] - p[1]);
      if ((ay > 0) != (by > 0) && (ax * by - ay * bx > 0) == (by > ay)) inside = !inside;
      const double dx = bx - ax;
      const double dy = by - ay;
      const double t = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(ax + t * dx, ay + t * dy));
    }
  return inside ? nearest : -nearest;
}

/// A random polygon with up to h star-shaped holes of 3 .. 8 vertices where there is room for them; n vertices in all, fewer where a hole finds no
/// room. n >= 3, h >= 0. Expected O(n (h + log n)).
inline region random_with_holes(int n, int h, std::uint64_t seed) {
  dice roll(seed);
  std::vector<int> holes;
  int outer = std::max(n, 3);
  while (static_cast<int>(holes.size()) < h && outer >= 3 + 8) outer -= holes.emplace_back(static_cast<int>(roll.between(3, 8)));
  region r = random_polygon(outer, roll());
  point lo = r[0][0];
  point hi = lo;
  for (const point& p : r[0])
    for (const int k : {0, 1}) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
  for (const int corners : holes) {
    double room = 0;
    point centre{};
    for (int attempt = 0, found = 0; attempt < 50 && found < 3; ++attempt) {
      const point p = {roll.between(lo[0], hi[0]), roll.between(lo[1], hi[1])};
      const double distance = clearance(r, p);
      if (distance > 0) ++found;
      if (distance > room) room = distance, centre = p;
    }
    if (room < 100) continue;
    ring hole = spiky(corners, 0.3 * room, 0.9 * room, centre, roll);
    std::reverse(hole.begin(), hole.end());
    r.push_back(std::move(hole));
  }
  return r;
}

/// A square with k x k holes, squares that are turned, moved and scaled at random; all corners are jittered. 4 k^2 + 4 vertices. k >= 1.
inline region jittered_holes(int k, std::uint64_t seed) {
  k = std::max(k, 1);
  dice roll(seed);
  const long side = 10000L * k;
  region r = {{{0, 0}, {side, 0}, {side, side}, {0, side}}};
  for (long x = 0; x < k; ++x)
    for (long y = 0; y < k; ++y) {
      const point centre = jittered({10000 * x + 5000, 10000 * y + 5000}, 1200, roll);
      const double radius = uniform(roll, 1500, 3500);
      const double turns = uniform(roll, 0, 0.25);
      ring& hole = r.emplace_back();
      for (int i = 4; i-- > 0;) hole.push_back(jittered(polar(radius, turns + i * 0.25, centre), 100, roll));
    }
  for (point& p : r[0]) p = jittered(p, 100, roll);
  return r;
}

// ---- the Hilbert curve

/// Step i of the Hilbert curve through a square of 4^order points.
inline point hilbert_point(long i, int order) {
  long x = 0;
  long y = 0;
  for (int level = 0; level < order; ++level, i >>= 2U) {
    const long side = 1L << level;
    const bool right = (i & 2) != 0;
    const bool upper = right != ((i & 1) != 0);
    if (!upper) {
      if (right) x = side - 1 - x, y = side - 1 - y;
      std::swap(x, y);
    }
    if (right) x += side;
    if (upper) y += side;
  }
  return {x, y};
}

/// The outline of a path of width 2 along the Hilbert curve, whose points are 4 apart. With `straight` every point of the curve makes two vertices,
/// else only where the curve turns and ends. At most n vertices, but at least 4.
inline ring hilbert_outline(int n, bool straight) {
  const int pairs = std::max(n / 2, 2);
  int order = 1;
  while (1L << (2 * order) < 4L * pairs) ++order;
  ring left;
  ring right;
  point before{};
  for (long i = 0;; ++i) {
    const point p = hilbert_point(i, order);
    const point next = hilbert_point(i + 1, order);
    const point out = {next[0] - p[0], next[1] - p[1]};
    const bool last = static_cast<int>(left.size()) == pairs - 1;
    const bool turns = before != out;
    if (i > 0 && !turns && !straight) continue;
    point across = {-out[1], out[0]};  // to the left
    point along = {0, 0};
    if (i == 0) {
      along = {-out[0], -out[1]};
    } else if (last) {
      across = {-before[1], before[0]};
      along = before;
    } else if (turns) {
      across = {across[0] - before[1], across[1] + before[0]};
    }
    left.push_back({4 * p[0] + along[0] + across[0], 4 * p[1] + along[1] + across[1]});
    right.push_back({4 * p[0] + along[0] - across[0], 4 * p[1] + along[1] - across[1]});
    if (last) break;
    before = out;
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

/// A thick path along the Hilbert curve on the integer grid: all edges axis-parallel, odd lengths, many events at the same times. n even, >= 4; odd n
/// gives one less. O(n log n).
inline region rectilinear_hilbert(int n) { return {hilbert_outline(n, false)}; }

/// The same path with two vertices at each point of the curve, jittered. n even, >= 4; odd n gives one less. O(n log n).
inline region hilbert(int n, std::uint64_t seed) {
  dice roll(seed);
  ring points = hilbert_outline(n, true);
  for (point& p : points) p = jittered({1000 * p[0], 1000 * p[1]}, 300, roll);
  return {points};
}

// ---- cells of a grid

/// A square grid of unit cells, full or empty, within a rim of empty ones.
class cell_grid {
 public:
  explicit cell_grid(int width) : width_(width), full_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(width + 2)) {}

  int width() const { return width_; }
  bool within(int x, int y) const { return x >= 1 && y >= 1 && x <= width_ && y <= width_; }
  bool operator()(int x, int y) const { return full_[index(x, y)]; }  ///< 0 .. width() + 1, where the first and the last are empty
  void fill(int x, int y) { full_[index(x, y)] = true; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2) + static_cast<std::size_t>(x); }

  /// The outline's vertices at a grid point, the lower left corner of cell (x,y): 0, 1, or 2 where two cells touch in that point only.
  int corners(int x, int y) const {
    const int number = (*this)(x, y) + (*this)(x - 1, y) + (*this)(x, y - 1) + (*this)(x - 1, y - 1);
    if (number != 2) return number % 2;
    return (*this)(x, y) == (*this)(x - 1, y - 1) ? 2 : 0;
  }

  /// The rings around a connected set of cells, the outer one first, each of them simple; where cells touch in a point, rings do. O(width^2).
  region outline() const {
    region r;
    std::vector<bool> done(full_.size());
    for (int y = 1; y <= width_ + 1; ++y)
      for (int x = 1; x <= width_ + 1; ++x) {  // every ring has edges that lead right; a corner starts at most one
        if (corners(x, y) == 0 || !(*this)(x, y) || (*this)(x, y - 1) || done[index(x, y)]) continue;
        const bool first = r.empty();
        split(walk(x, y, done), r);
        if (first) std::swap(r.front(), r.back());  // the ring of the lowest corner
      }
    return r;
  }

 private:
  // The corners from one whose edge leads right back to it, always along the same cells: left where two touch.
  ring walk(int x, int y, std::vector<bool>& done) const {
    static constexpr std::array<std::array<int, 2>, 4> step = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    static constexpr std::array<std::array<int, 2>, 4> left = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};  // the cell ahead, on the left
    ring points;
    for (std::size_t d = 0; d != 0 || !done[index(x, y)];) {
      points.push_back({x - 1, y - 1});
      if (d == 0) done[index(x, y)] = true;
      for (;;) {
        x += step[d][0], y += step[d][1];
        const bool on_left = (*this)(x + left[d][0], y + left[d][1]);
        const bool on_right = (*this)(x + left[(d + 3) % 4][0], y + left[(d + 3) % 4][1]);
        if (on_left && !on_right) continue;
        d = (d + (on_left ? 3 : 1)) % 4;
        break;
      }
    }
    return points;
  }

  // Cuts a ring where it visits a point again; such loops nest, so their points do not come a third time. The ring of the first point comes last.
  void split(const ring& points, region& r) const {
    std::map<point, std::size_t> at;  // of the points that cells touch in: where they are in `open`
    ring open;
    for (const point& p : points) {
      const bool pinched = corners(static_cast<int>(p[0]) + 1, static_cast<int>(p[1]) + 1) == 2;
      if (const auto seen = pinched ? at.find(p) : at.end(); seen != at.end()) {
        const auto again = open.begin() + static_cast<std::ptrdiff_t>(seen->second);
        r.emplace_back(again, open.end());
        open.erase(again + 1, open.end());
        continue;
      }
      if (pinched) at.emplace(p, open.size());
      open.push_back(p);
    }
    r.push_back(std::move(open));
  }

  int width_;
  std::vector<bool> full_;
};

/// A random connected set of cells, grown from one, always by the neighbour with the least of random numbers (invasion percolation: long arms,
/// holes of all sizes), until its outline has n vertices or the grid is full. Cells touch in a point only if allowed. O(n log n).
inline cell_grid random_cells(int n, bool touching, std::uint64_t seed) {
  cell_grid grid(static_cast<int>(std::sqrt(3.0 * n)) + 2);
  using candidate = std::pair<std::uint64_t, std::array<int, 2>>;
  std::priority_queue<candidate, std::vector<candidate>, std::greater<>> fringe;
  const auto around = [&grid](int x, int y) {
    return grid.corners(x, y) + grid.corners(x + 1, y) + grid.corners(x, y + 1) + grid.corners(x + 1, y + 1);
  };
  const auto weight = [&grid, seed](int x, int y) { return dice(dice(seed)() ^ grid.index(x, y))(); };
  const auto touches = [&grid](int x, int y) {  // once the cell is full: a neighbour across a corner without one in between
    for (const int dx : {-1, 1})
      for (const int dy : {-1, 1})
        if (grid(x + dx, y + dy) && !grid(x + dx, y) && !grid(x, y + dy)) return true;
    return false;
  };
  int vertices = 0;
  fringe.push({0, {(grid.width() + 1) / 2, (grid.width() + 1) / 2}});
  while (vertices < n && !fringe.empty()) {
    const auto [x, y] = fringe.top().second;
    fringe.pop();
    if (grid(x, y) || (!touching && touches(x, y))) continue;  // one that was refused comes again with its next neighbour
    vertices -= around(x, y);
    grid.fill(x, y);
    vertices += around(x, y);
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
      if (grid.within(x + dx, y + dy) && !grid(x + dx, y + dy)) fringe.push({weight(x + dx, y + dy), {x + dx, y + dy}});
  }
  return grid;
}

/// The outline of random cells of the integer grid, with holes if any. About n vertices, n >= 4. O(n log n).
inline region rectilinear(int n, std::uint64_t seed) { return random_cells(std::max(n, 4), false, seed).outline(); }

/// The same with the lines of the grid at random distances 100 .. 1000: parallel edges, but few events at the same time. About n vertices, n >= 4.
/// O(n log n).
inline region stretched_cells(int n, std::uint64_t seed) {
  region r = rectilinear(n, seed);
  dice roll(seed + 1);
  std::array<std::vector<long>, 2> lines;
  for (ring& points : r)
    for (point& p : points)
      for (const std::size_t k : {0U, 1U}) {
        while (static_cast<long>(lines[k].size()) <= p[k]) lines[k].push_back((lines[k].empty() ? 0 : lines[k].back()) + roll.between(100, 1000));
        p[k] = lines[k][static_cast<std::size_t>(p[k])];
      }
  return r;
}

/// The same with all vertices jittered: holes, arms and bays in general position. About n vertices, n >= 4. O(n log n).
inline region jittered_cells(int n, std::uint64_t seed) {
  region r = rectilinear(n, seed);
  dice roll(seed + 1);
  for (ring& points : r)
    for (point& p : points) p = jittered({1000 * p[0], 1000 * p[1]}, 300, roll);
  return r;
}

/// The outline of random cells that may touch in a point: rings are simple, but may share vertices with one another, never edges. The interior is
/// connected without such points. About n vertices, n >= 4. O(n log n).
inline region touching_cells(int n, std::uint64_t seed) { return random_cells(std::max(n, 4), true, seed).outline(); }

/// A square with k x k unit squares as holes, one apart. 4 k^2 + 4 vertices. k >= 1.
inline region grid_of_holes(int k) {
  k = std::max(k, 1);
  const long side = 2L * k + 1;
  region r = {{{0, 0}, {side, 0}, {side, side}, {0, side}}};
  for (long x = 1; x < side; x += 2)
    for (long y = 1; y < side; y += 2) r.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
  return r;
}

/// Steps of rise and run 1 on the legs of a right angle. n even, >= 4; odd n gives one less.
inline region stairs(int n) {
  const long steps = std::max(n / 2 - 1, 1);
  ring points = {{0, 0}};
  for (long i = 0; i < steps; ++i) {
    points.push_back({steps - i, i});
    points.push_back({steps - i, i + 1});
  }
  points.push_back({0, steps});
  return {points};
}

// ---- symmetric

/// A star with random radii that is exactly symmetric in both axes and both diagonals: events come by eights at a time, or all at the origin. n a
/// multiple of four, >= 4; others give up to three less.
inline region symmetric(int n, std::uint64_t seed) {
  n = std::max(n, 4);
  dice roll(seed);
  const int inner = n / 8;
  const double radius = roomy_radius(n);
  ring octant;  // from the x axis to the diagonal, without it
  if (n % 8 >= 4) octant.push_back({std::lround(uniform(roll, 0.4, 1) * radius), 0});
  for (int i = 0; i < inner; ++i) octant.push_back(polar(uniform(roll, 0.4, 1) * radius, (i + 0.5 + uniform(roll, -0.2, 0.2)) / (8.0 * inner)));
  ring points = octant;
  for (std::size_t i = octant.size(); i-- > 0;)
    if (octant[i][1] != 0) points.push_back({octant[i][1], octant[i][0]});
  const std::size_t quarter = points.size();
  for (std::size_t i = 0; i < 3 * quarter; ++i) points.push_back({-points[i][1], points[i][0]});
  return {points};
}

/// A regular polygon, rounded so slightly that it stays strictly convex: almost all events at almost one time. n >= 3.
inline region regular(int n) {
  n = std::max(n, 3);
  const double radius = std::max(1e6, static_cast<double>(n) * n);
  ring points;
  for (int i = 0; i < n; ++i) points.push_back(polar(radius, static_cast<double>(i) / n));
  return {points};
}

/// A rounded gear of n / 4 tapered teeth. n a multiple of four, >= 8; others give up to three less.
inline region gear(int n) {
  const int teeth = std::max(n / 4, 2);
  const double radius = roomy_radius(4 * teeth);
  const double root = radius * (1 - std::min(1.0 / 3, 4 * 3.14159265358979323846 / teeth));
  ring points;
  for (int i = 0; i < teeth; ++i) {
    points.push_back(polar(root, (i + 0.0) / teeth));
    points.push_back(polar(radius, (i + 0.15) / teeth));
    points.push_back(polar(radius, (i + 0.4) / teeth));
    points.push_back(polar(root, (i + 0.55) / teeth));
  }
  return {points};
}

// ---- by name

/// What the generator knows: a name, what `size` means there, its default, least and greatest value (ten million vertices), and the polygon of a
/// size and a seed.
struct kind {
  std::string name;
  std::string size;
  int default_size;
  int least_size;
  int greatest_size;
  bool touching;  ///< whether rings may share points, so that not all algorithms take the polygon
  std::function<region(int, std::uint64_t)> make;
};

inline const std::vector<kind>& kinds() {
  constexpr int most = 10'000'000;
  static const std::vector<kind> all = {
      {"noisy-star", "vertices", 30, 3, most, false, noisy_star},
      {"noisy-loop", "vertices", 60, 3, most, false, noisy_loop},
      {"comb", "vertices", 40, 8, most, false, comb},
      {"spiral", "vertices", 80, 4, most, false, spiral},
      {"random", "vertices", 40, 3, most, false, random_polygon},
      {"random-with-holes", "vertices; one hole for each 15, up to 25", 60, 3, most, false,
       [](int n, std::uint64_t s) { return random_with_holes(n, std::min(n / 15, 25), s); }},
      {"jittered-holes", "holes a side", 4, 1, 1500, false, jittered_holes},
      {"hilbert", "vertices", 128, 4, most, false, hilbert},
      {"jittered-cells", "vertices, about", 60, 4, most, false, jittered_cells},
      {"rectilinear-hilbert", "vertices", 128, 4, most, false, [](int n, std::uint64_t) { return rectilinear_hilbert(n); }},
      {"rectilinear", "vertices, about", 60, 4, most, false, rectilinear},
      {"stretched-cells", "vertices, about", 60, 4, most, false, stretched_cells},
      {"touching-cells", "vertices, about", 60, 4, most, true, touching_cells},
      {"grid-of-holes", "holes a side", 4, 1, 1500, false, [](int k, std::uint64_t) { return grid_of_holes(k); }},
      {"staircase", "vertices", 20, 4, most, false, [](int n, std::uint64_t) { return stairs(n); }},
      {"symmetric", "vertices", 40, 4, most, false, symmetric},
      {"regular", "vertices", 12, 3, most, false, [](int n, std::uint64_t) { return regular(n); }},
      {"gear", "vertices", 48, 8, most, false, [](int n, std::uint64_t) { return gear(n); }},
  };
  return all;
}

/// As the input of the library, unweighted, one part.
template <class Int>
rings<Int> take(const region& r) {
  rings<Int> result;
  for (const ring& points : r) {
    auto& to = result.all.emplace_back();
    to.points.reserve(points.size());
    for (const point& p : points) to.points.push_back({exact_number<Int>{Int(p[0]), 0, 0}, exact_number<Int>{Int(p[1]), 0, 0}});
  }
  return result;
}

/// As text: a point `x y` a line, a blank line between rings.
inline std::string to_xy(const region& r) {
  std::string text;
  for (const ring& points : r) {
    if (!text.empty()) text += '\n';
    for (const point& p : points) text += std::to_string(p[0]) + ' ' + std::to_string(p[1]) + '\n';
  }
  return text;
}

}  // namespace osteon::plane::models
