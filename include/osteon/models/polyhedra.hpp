// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generated models: solids with integer coordinates for tests, measurements and first steps. All are exact and valid.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/random.hpp"
#include "osteon/input/mesh.hpp"

namespace osteon::models {

using point = std::array<long, 3>;

/// Random numbers of the generators.
using dice = random_stream;

/// Points and facets that share equal points.
class builder {
 public:
  int at(const point& p) {
    const auto [found, fresh] = ids_.emplace(p, static_cast<int>(points_.size()));
    if (fresh) points_.push_back(p);
    return found->second;
  }
  void facet(const std::vector<point>& corners) {
    auto& f = facets_.emplace_back();
    for (const auto& p : corners) f.push_back(at(p));
  }

  template <class Int>
  input_mesh<Int> take() const {
    input_mesh<Int> m;
    for (const auto& p : points_)
      m.points.push_back({exact_number<Int>{Int(p[0]), 0, 0}, exact_number<Int>{Int(p[1]), 0, 0}, exact_number<Int>{Int(p[2]), 0, 0}});
    m.facets = facets_;
    return m;
  }

 private:
  std::map<point, int> ids_;
  std::vector<point> points_;
  std::vector<std::vector<int>> facets_;
};

/// A grid of unit cubes, full or empty; everything outside is empty.
class voxels {
 public:
  explicit voxels(std::array<int, 3> size) : size_(size), full_(static_cast<std::size_t>(size[0]) * size[1] * size[2]) {}

  const std::array<int, 3>& size() const { return size_; }
  bool operator()(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < size_[0] && y < size_[1] && z < size_[2] && full_[index(x, y, z)];
  }
  void set(int x, int y, int z, bool full) { full_[index(x, y, z)] = full; }
  long count() const {
    long n = 0;
    for (const bool b : full_) n += b ? 1 : 0;
    return n;
  }

  /// Adds cubes until the surface is a manifold: no edge of four facets, no point where two fans meet.
  void mend() {
    for (bool changed = true; changed;) {
      changed = false;
      for (int x = 0; x <= size_[0]; ++x)
        for (int y = 0; y <= size_[1]; ++y)
          for (int z = 0; z <= size_[2]; ++z) changed = mend_at({x, y, z}) || changed;
    }
  }

  /// The surface as unit squares.
  builder surface() const {
    builder b;
    for (int x = 0; x < size_[0]; ++x)
      for (int y = 0; y < size_[1]; ++y)
        for (int z = 0; z < size_[2]; ++z) {
          if (!(*this)(x, y, z)) continue;
          for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
              std::array<int, 3> next = {x, y, z};
              next[axis] += side == 1 ? 1 : -1;
              if (!(*this)(next[0], next[1], next[2])) b.facet(square({x, y, z}, axis, side));
            }
        }
    return b;
  }

 private:
  std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(x) * size_[1] + y) * size_[2] + z; }

  static std::vector<point> square(const std::array<int, 3>& cube, int axis, int side) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<point> corners;
    for (const auto& [du, dv] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      point p = {cube[0], cube[1], cube[2]};
      p[axis] += side;
      p[u] += side == 1 ? du : dv;  // counter-clockwise seen from outside
      p[v] += side == 1 ? dv : du;
      corners.push_back(p);
    }
    return corners;
  }

  // Looks at the eight cubes around a grid point.
  bool mend_at(const std::array<int, 3>& p) {
    const auto full = [&](int corner) { return (*this)(p[0] - 1 + (corner & 1), p[1] - 1 + (corner >> 1 & 1), p[2] - 1 + (corner >> 2)); };
    const auto fill = [&](int corner) {
      const std::array<int, 3> c = {p[0] - 1 + (corner & 1), p[1] - 1 + (corner >> 1 & 1), p[2] - 1 + (corner >> 2)};
      for (int axis = 0; axis < 3; ++axis)
        if (c[axis] < 0 || c[axis] >= size_[axis]) return false;
      if ((*this)(c[0], c[1], c[2])) return false;
      set(c[0], c[1], c[2], true);
      return true;
    };
    for (int a = 0; a < 3; ++a)
      for (const int rest : {0, 1 << a}) {
        const int u = 1 << (a + 1) % 3;
        const int v = 1 << (a + 2) % 3;
        if (full(rest) && full(rest | u | v) && !full(rest | u) && !full(rest | v)) return fill(rest | u) || fill(rest | v);
        if (full(rest | u) && full(rest | v) && !full(rest) && !full(rest | u | v)) return fill(rest) || fill(rest | u | v);
      }
    int number = 0;
    for (int c = 0; c < 8; ++c) number += full(c) ? 1 : 0;
    for (int c = 0; c < 4; ++c) {
      if (number == 2 && full(c) && full(7 - c)) return fill(c ^ 1) || fill(c ^ 2) || fill(c ^ 4);
      if (number == 6 && !full(c) && !full(7 - c)) return fill(c) || fill(7 - c);
    }
    return false;
  }

  std::array<int, 3> size_;
  std::vector<bool> full_;
};

/// A random voxel solid: each cube is full with the given chance in percent, then mended. May have tunnels, voids and
/// several bodies, and majority corners. Never empty.
inline voxels random_voxels(std::array<int, 3> size, int percent, std::uint64_t seed) {
  dice roll(seed);
  voxels v(size);
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) v.set(x, y, z, roll.between(0, 99) < percent);
  if (v.count() == 0) v.set(0, 0, 0, true);
  v.mend();
  return v;
}

// ---- solids over polygons

using polygon = std::vector<std::array<long, 2>>;

/// A prism over a simple polygon (counter-clockwise) from z = 0 to height > 0.
inline builder prism(const polygon& base, long height) {
  builder b;
  std::vector<point> top;
  std::vector<point> bottom;
  const std::size_t n = base.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % n];
    top.push_back({p[0], p[1], height});
    bottom.insert(bottom.begin(), {p[0], p[1], 0});
    b.facet({{p[0], p[1], 0}, {q[0], q[1], 0}, {q[0], q[1], height}, {p[0], p[1], height}});
  }
  b.facet(top);
  b.facet(bottom);
  return b;
}

/// A pyramid over a polygon that sees the apex's foot, the origin, from everywhere.
inline builder pyramid(const polygon& base, long height) {
  builder b;
  std::vector<point> bottom;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % base.size()];
    bottom.insert(bottom.begin(), {p[0], p[1], 0});
    b.facet({{p[0], p[1], 0}, {q[0], q[1], 0}, {0, 0, height}});
  }
  b.facet(bottom);
  return b;
}

/// Corner i of n on a circle, rounded to integers; `turn` in n-ths.
inline std::array<long, 2> on_circle(int i, int n, double radius, double turn = 0) {
  const double angle = 2 * 3.14159265358979323846 * (i + turn) / n;
  return {std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))};
}

inline builder box(long a, long b, long c) { return prism({{0, 0}, {a, 0}, {a, b}, {0, b}}, c); }

/// n steps of rise and run 1, as a prism of width n.
inline builder stairs(int n) {
  polygon profile = {{0, 0}, {n, 0}};
  for (long i = 0; i < n; ++i) {
    profile.push_back({n - i, i + 1});
    profile.push_back({n - i - 1, i + 1});
  }
  profile.pop_back();
  profile.push_back({0, n});
  return prism(profile, n);
}

/// A box with a V-shaped notch of depth d along its top, 0 < d < 6.
inline builder notched_box(long d) { return prism({{0, 0}, {10, 0}, {10, 6}, {7, 6}, {5, 6 - d}, {3, 6}, {0, 6}}, 8); }

/// A pyramid whose base is a star polygon of k corners with random radii: a corner of degree k, about half of its edges reflex.
inline builder cone(int k, std::uint64_t seed) {
  dice roll(seed);
  polygon base;
  for (int i = 0; i < k; ++i) base.push_back(on_circle(i, k, static_cast<double>(roll.between(400'000, 1'000'000))));
  return pyramid(base, 500'000 + roll.between(0, 99'999));
}

/// A pyramid over a random simple polygon of k corners, seldom star-shaped: grown from a triangle, a corner at a time, across random edges.
inline builder spire(int k, std::uint64_t seed) {
  dice roll(seed);
  const auto draw = [&roll] { return std::array<long, 2>{roll.between(-1'000'000, 1'000'000), roll.between(-1'000'000, 1'000'000)}; };
  const auto turn = [](const std::array<long, 2>& p, const std::array<long, 2>& q, const std::array<long, 2>& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  const auto meet = [&turn](const auto& p, const auto& q, const auto& r, const auto& s) {
    return (turn(p, q, r) > 0) != (turn(p, q, s) > 0) && (turn(r, s, p) > 0) != (turn(r, s, q) > 0);
  };
  polygon base = {{-900'000, -800'000}, {900'000, -700'000}, {0, 900'000}};
  while (static_cast<int>(base.size()) < k) {
    const auto fresh = draw();
    const auto at = static_cast<std::size_t>(roll.between(0, static_cast<long>(base.size()) - 1));
    const std::size_t next = (at + 1) % base.size();
    bool free = true;
    for (std::size_t i = 0; i < base.size() && free; ++i) {
      const std::size_t j = (i + 1) % base.size();
      free = turn(base[i], base[j], fresh) != 0;
      for (const std::size_t end : {at, next})
        if (i != end && j != end) free = free && !meet(base[end], fresh, base[i], base[j]);
    }
    if (free) base.insert(base.begin() + static_cast<std::ptrdiff_t>(at) + 1, fresh);
  }
  long area = 0;
  for (std::size_t i = 0; i < base.size(); ++i) area += turn({0, 0}, base[i], base[(i + 1) % base.size()]) / 1000;
  if (area < 0) std::reverse(base.begin(), base.end());
  return pyramid(base, 500'000 + roll.between(0, 99'999));
}

/// A plate whose top is a fan of triangles around the origin, between neighbours of a rim that runs round it; the floor is flat, at height `floor`.
inline builder fan_on_plate(const std::vector<point>& rim, long floor) {
  builder b;
  std::vector<point> low = rim;
  for (point& p : low) p[2] = floor;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t j = (i + 1) % rim.size();
    b.facet({rim[i], rim[j], {0, 0, 0}});
    b.facet({low[i], low[j], rim[j], rim[i]});
  }
  std::reverse(low.begin(), low.end());
  b.facet(low);
  return b;
}

/// A fan on a plate with random heights at the rim: a corner of degree k, convex and reflex at random and seldom pointed.
inline builder peak(int k, std::uint64_t seed) {
  dice roll(seed);
  std::vector<point> rim;
  for (int i = 0; i < k; ++i) {
    const auto p = on_circle(i, k, static_cast<double>(roll.between(600'000, 1'000'000)));
    rim.push_back({p[0], p[1], roll.between(-500'000, 500'000)});
  }
  return fan_on_plate(rim, -2'000'000);
}

/// A pyramid over a hub with n arms of five corners each, slightly irregular: every arm can be split in several ways whatever the others do, so that
/// the number of ways to split the apex grows exponentially (thesis 3.7).
inline builder arms(int n, std::uint64_t seed) {
  dice roll(seed);
  polygon base;
  const double hub = 250'000.0 * n;
  const auto corner = [&](int arm, double out, double across) {
    const double radius = hub + out;
    const auto p = on_circle(arm, n, std::hypot(radius, across), std::atan2(across, radius) * n / (2 * 3.14159265358979323846));
    base.push_back({p[0] + roll.between(-99, 99), p[1] + roll.between(-99, 99)});
  };
  for (int arm = 0; arm < n; ++arm) {
    corner(arm, 0, -500'000);
    corner(arm, 500'000, -100'000);
    corner(arm, 1'500'000, -10'000);
    corner(arm, 500'000, 100'000);
    corner(arm, 0, 500'000);
  }
  return pyramid(base, 1'000'000);
}

/// A star of n points with two corners of degree 2n, slightly irregular.
inline builder star(int n, std::uint64_t seed) {
  dice roll(seed);
  builder b;
  std::vector<point> rim;
  for (int i = 0; i < 2 * n; ++i) {
    const auto p = on_circle(i, 2 * n, i % 2 == 0 ? 1000 : 420);
    rim.push_back({p[0] + roll.between(-20, 20), p[1] + roll.between(-20, 20), i % 2 == 0 ? roll.between(60, 90) : roll.between(-90, -60)});
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const point& p = rim[i];
    const point& q = rim[(i + 1) % rim.size()];
    b.facet({p, q, {0, 0, 300}});
    b.facet({q, p, {0, 0, -300}});
  }
  return b;
}

/// Two n-gons, the upper one turned: with `reflex` the sides fold inwards (Schoenhardt's solid for n = 3), else the
/// solid is an antiprism.
inline builder twisted_prism(int n, bool reflex) {
  builder b;
  std::vector<point> low;
  std::vector<point> high;
  for (int i = 0; i < n; ++i) {
    const auto p = on_circle(i, n, 1000);
    const auto q = on_circle(i, n, 1000, reflex ? 0.25 : 0.5);
    low.push_back({p[0], p[1], 0});
    high.push_back({q[0], q[1], 1200});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    if (reflex) {
      b.facet({low[i], low[j], high[j]});
      b.facet({low[i], high[j], high[i]});
      continue;
    }
    b.facet({low[i], low[j], high[i]});
    b.facet({low[j], high[j], high[i]});
  }
  b.facet(high);
  std::reverse(low.begin(), low.end());
  b.facet(low);
  return b;
}

/// A block whose corners are lifted and lowered in turn around a middle point on top: a saddle of degree four.
inline builder saddle() {
  builder b;
  const std::array<point, 4> top = {{{50, 50, 90}, {-40, 60, 40}, {-55, -45, 95}, {45, -60, 35}}};
  const std::array<point, 4> low = {{{50, 50, -60}, {-40, 60, -60}, {-55, -45, -60}, {45, -60, -60}}};
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    b.facet({top[i], top[j], {3, 2, 55}});
    b.facet({low[i], low[j], top[j], top[i]});
  }
  b.facet({low[3], low[2], low[1], low[0]});
  return b;
}

// ---- solids between two height fields: a function of x above, one of y below

/// The solid under z = f(x) and above z = -g(y) over a square; f and g are polylines over the same positions.
inline builder between_profiles(const std::vector<std::array<long, 2>>& f, const std::vector<std::array<long, 2>>& g) {
  builder b;
  const long lo = f.front()[0];
  const long hi = f.back()[0];
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    b.facet({{f[i][0], lo, f[i][1]}, {f[i + 1][0], lo, f[i + 1][1]}, {f[i + 1][0], hi, f[i + 1][1]}, {f[i][0], hi, f[i][1]}});
  for (std::size_t i = 0; i + 1 < g.size(); ++i)
    b.facet({{lo, g[i][0], -g[i][1]}, {lo, g[i + 1][0], -g[i + 1][1]}, {hi, g[i + 1][0], -g[i + 1][1]}, {hi, g[i][0], -g[i][1]}});
  std::vector<point> south, north, west, east;
  for (const auto& p : f) south.insert(south.begin(), {p[0], lo, p[1]}), north.push_back({p[0], hi, p[1]});
  south.push_back({lo, lo, -g.front()[1]}), south.push_back({hi, lo, -g.front()[1]});
  north.push_back({hi, hi, -g.back()[1]}), north.push_back({lo, hi, -g.back()[1]});
  for (const auto& p : g) east.push_back({hi, p[0], -p[1]}), west.insert(west.begin(), {lo, p[0], -p[1]});
  east.push_back({hi, hi, f.back()[1]}), east.push_back({hi, lo, f.back()[1]});
  west.push_back({lo, lo, f.front()[1]}), west.push_back({lo, hi, f.front()[1]});
  for (const auto& wall : {south, north, west, east}) b.facet(wall);
  return b;
}

/// Held's convex solid with n facets above and n below, a thin lens: almost every facet above meets every one below, so that
/// its skeleton has about n^2 sheets (Held 1994, thesis 3.1).
inline builder held(int n) {
  std::vector<std::array<long, 2>> arch;
  for (long i = 0; i <= n; ++i) arch.push_back({100 * (2 * i - n), 2L * n * n - (2 * i - n) * (2 * i - n)});
  return between_profiles(arch, arch);
}

/// A flat box with n grooves above and n across below, whose reflex edges all cross (thesis, iron maiden pizza box).
inline builder pizza_box(int n) {
  std::vector<std::array<long, 2>> f, g;
  for (long i = 0; i <= 2L * n; ++i) {
    f.push_back({12 * (i - n), i % 2 == 0 ? 40 : 12 + i % 3});
    g.push_back({12 * (i - n), i % 2 == 0 ? 41 : 11 + i % 5});
  }
  return between_profiles(f, g);
}

// ---- solids over grids

/// Bars along x over bars along y, n each, sunk halfway into each other.
inline builder crossing_bars(int n) {
  voxels v({2 * n + 1, 2 * n + 1, 3});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n + 1; ++j)
      for (int z = 0; z < 2; ++z) {
        v.set(j, 2 * i + 1, z, true);
        v.set(2 * i + 1, j, z + 1, true);
      }
  return v.surface();
}

/// A slab with n x n towers of heights 1 .. 3.
inline builder towers(int n, std::uint64_t seed) {
  dice roll(seed);
  voxels v({2 * n + 1, 2 * n + 1, 4});
  for (int x = 0; x < 2 * n + 1; ++x)
    for (int y = 0; y < 2 * n + 1; ++y) v.set(x, y, 0, true);
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (long z = roll.between(1, 3); z > 0; --z) v.set(2 * x + 1, 2 * y + 1, static_cast<int>(z), true);
  return v.surface();
}

/// A square frame: a torus of boxes with an n x n hole.
inline builder frame(int n) {
  voxels v({n + 2, n + 2, 1});
  for (int x = 0; x < n + 2; ++x)
    for (int y = 0; y < n + 2; ++y) v.set(x, y, 0, x == 0 || y == 0 || x == n + 1 || y == n + 1);
  return v.surface();
}

/// A plate with n x n pyramids on top.
inline builder spiked_plate(int n) {
  builder b;
  const long size = 3L * n;
  const auto floor = [&](const point& p, long z) { return point{10 * p[0], 10 * p[1], z}; };
  for (long x = 0; x < size; ++x)
    for (long y = 0; y < size; ++y) {
      const std::array<point, 4> c = {{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}};
      if (x % 3 == 1 && y % 3 == 1) {
        const point apex = {10 * x + 4 + x % 2, 10 * y + 5, 30 + (x + 2 * y) % 7};
        for (int i = 0; i < 4; ++i) b.facet({floor(c[i], 10), floor(c[(i + 1) % 4], 10), apex});
      } else {
        b.facet({floor(c[0], 10), floor(c[1], 10), floor(c[2], 10), floor(c[3], 10)});
      }
      b.facet({floor(c[3], 0), floor(c[2], 0), floor(c[1], 0), floor(c[0], 0)});
    }
  for (long i = 0; i < size; ++i)
    for (const auto& [p, q] : {std::pair<point, point>{{i, 0, 0}, {i + 1, 0, 0}},
                               {{size, i, 0}, {size, i + 1, 0}},
                               {{i + 1, size, 0}, {i, size, 0}},
                               {{0, i + 1, 0}, {0, i, 0}}})
      b.facet({floor(p, 0), floor(q, 0), floor(q, 10), floor(p, 10)});
  return b;
}

/// A house with a hip roof of slope 1 over a footprint of squares, '#' in the rows of a plan like "##|#.".
inline builder house(const std::string& plan) {
  std::vector<std::string> rows(1);
  for (const char c : plan) {
    if (c == '|')
      rows.emplace_back();
    else
      rows.back().push_back(c);
  }
  const int w = 2 * static_cast<int>(rows[0].size());
  const int h = 2 * static_cast<int>(rows.size());
  const auto full = [&](long x, long y) {
    return x >= 0 && y >= 0 && x < w && y < h && static_cast<std::size_t>(x / 2) < rows[static_cast<std::size_t>(y / 2)].size() &&
           rows[static_cast<std::size_t>(y / 2)][static_cast<std::size_t>(x / 2)] == '#';
  };
  // The roof's height over a grid point: 0 on the outline, 1 within (the arms are two units wide).
  const auto rise = [&](long x, long y) { return full(x, y) && full(x - 1, y) && full(x, y - 1) && full(x - 1, y - 1) ? 1L : 0L; };
  const long eaves = 3;
  builder b;
  for (long x = 0; x < w; ++x)
    for (long y = 0; y < h; ++y) {
      if (!full(x, y)) continue;
      b.facet({{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}});
      std::array<point, 4> c = {{{x, y, eaves + rise(x, y)},
                                 {x + 1, y, eaves + rise(x + 1, y)},
                                 {x + 1, y + 1, eaves + rise(x + 1, y + 1)},
                                 {x, y + 1, eaves + rise(x, y + 1)}}};
      // Cut along the diagonal through the corner that differs from its two neighbours.
      if (c[0][2] == c[2][2]) std::rotate(c.begin(), c.begin() + 1, c.end());
      b.facet({c[0], c[1], c[2]});
      b.facet({c[0], c[2], c[3]});
      if (!full(x, y - 1)) b.facet({{x, y, 0}, {x + 1, y, 0}, {x + 1, y, eaves}, {x, y, eaves}});
      if (!full(x + 1, y)) b.facet({{x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, eaves}, {x + 1, y, eaves}});
      if (!full(x, y + 1)) b.facet({{x + 1, y + 1, 0}, {x, y + 1, 0}, {x, y + 1, eaves}, {x + 1, y + 1, eaves}});
      if (!full(x - 1, y)) b.facet({{x, y + 1, 0}, {x, y, 0}, {x, y, eaves}, {x, y + 1, eaves}});
    }
  return b;
}

// ---- symmetric solids

inline builder tetrahedron() {
  builder b;
  const std::array<point, 4> p = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  b.facet({p[0], p[1], p[2]}), b.facet({p[0], p[2], p[3]}), b.facet({p[0], p[3], p[1]}), b.facet({p[1], p[3], p[2]});
  return b;
}

/// The octahedron |x| + |y| + |z| <= r.
inline builder octahedron(long r) {
  builder b;
  for (const long x : {-r, r})
    for (const long y : {-r, r})
      for (const long z : {-r, r}) {
        if (x * y * z > 0)
          b.facet({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
        else
          b.facet({{x, 0, 0}, {0, 0, z}, {0, y, 0}});
      }
  return b;
}

/// A cube of side 2s with its corners cut off at distance c < s along the edges.
inline builder cut_cube(long s, long c) {
  builder b;
  for (int axis = 0; axis < 3; ++axis)
    for (const long side : {-s, s}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      std::vector<point> octagon;
      for (const auto& [pu, pv] : {std::pair(-s + c, -s), std::pair(s - c, -s), std::pair(s, -s + c), std::pair(s, s - c), std::pair(s - c, s),
                                   std::pair(-s + c, s), std::pair(-s, s - c), std::pair(-s, -s + c)}) {
        point p{};
        p[axis] = side, p[u] = pu, p[v] = pv;
        octagon.push_back(p);
      }
      if (side < 0) std::reverse(octagon.begin(), octagon.end());
      b.facet(octagon);
    }
  for (const long x : {-s, s})
    for (const long y : {-s, s})
      for (const long z : {-s, s}) {
        const auto in = [&](long k) { return k > 0 ? k - c : k + c; };
        if (x * y * z > 0)
          b.facet({{in(x), y, z}, {x, in(y), z}, {x, y, in(z)}});
        else
          b.facet({{in(x), y, z}, {x, y, in(z)}, {x, in(y), z}});
      }
  return b;
}

/// A cube of side 2s with a pyramid of height h on every facet.
inline builder stellated_cube(long s, long h) {
  builder b;
  for (int axis = 0; axis < 3; ++axis)
    for (const long side : {-s, s}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      std::vector<point> c;
      for (const auto& [pu, pv] : {std::pair(-s, -s), std::pair(s, -s), std::pair(s, s), std::pair(-s, s)}) {
        point p{};
        p[axis] = side, p[u] = pu, p[v] = pv;
        c.push_back(p);
      }
      if (side < 0) std::reverse(c.begin(), c.end());
      point apex = {0, 0, 0};
      apex[axis] = side > 0 ? side + h : side - h;
      for (int i = 0; i < 4; ++i) b.facet({c[i], c[(i + 1) % 4], apex});
    }
  return b;
}

// ---- by name

/// What `osteon generate` knows: a name, what `size` means there, its default, and the solid of a size and a seed.
struct kind {
  std::string name;
  std::string size;
  int default_size;
  int least_size;
  std::function<builder(int, std::uint64_t)> make;
};

inline const std::vector<kind>& kinds() {
  static const std::vector<kind> all = {
      {"box", "the three sides are random up to this", 10, 1,
       [](int n, std::uint64_t s) {
         dice d(s);
         return box(d.between(1, n), d.between(1, n), d.between(1, n));
       }},
      {"cube", "side", 1, 1, [](int n, std::uint64_t) { return box(n, n, n); }},
      {"prism", "corners of the regular base", 6, 3,
       [](int n, std::uint64_t) {
         polygon p;
         for (int i = 0; i < n; ++i) p.push_back(on_circle(i, n, 1000));
         return prism(p, 800);
       }},
      {"stairs", "steps", 5, 1, [](int n, std::uint64_t) { return stairs(n); }},
      {"notched-box", "depth of the notch, below 6", 3, 1, [](int n, std::uint64_t) { return notched_box(std::min(n, 5)); }},
      {"house-l", "no meaning", 1, 1, [](int, std::uint64_t) { return house("##|#."); }},
      {"house-t", "no meaning", 1, 1, [](int, std::uint64_t) { return house("###|.#."); }},
      {"house-u", "no meaning", 1, 1, [](int, std::uint64_t) { return house("###|#.#"); }},
      {"house-x", "no meaning", 1, 1, [](int, std::uint64_t) { return house(".#.|###|.#."); }},
      {"towers", "towers a side", 3, 1, [](int n, std::uint64_t s) { return towers(n, s); }},
      {"voxels", "cubes a side; fill and size vary with the seed", 4, 1,
       [](int n, std::uint64_t s) {
         dice d(s);
         const std::array<int, 3> size = {static_cast<int>(d.between(1, n)), static_cast<int>(d.between(1, n)), static_cast<int>(d.between(1, n))};
         const int percent = static_cast<int>(d.between(25, 90));
         return random_voxels(size, percent, s).surface();
       }},
      {"tetrahedron", "no meaning", 1, 1, [](int, std::uint64_t) { return tetrahedron(); }},
      {"octahedron", "radius", 1, 1, [](int n, std::uint64_t) { return octahedron(n); }},
      {"antiprism", "corners of each base", 6, 3, [](int n, std::uint64_t) { return twisted_prism(n, false); }},
      {"twisted-prism", "corners of each base; 3 gives Schoenhardt's solid", 5, 3, [](int n, std::uint64_t) { return twisted_prism(n, true); }},
      {"cut-cube", "half a side; corners are cut at distance 1", 3, 2, [](int n, std::uint64_t) { return cut_cube(n, 1); }},
      {"stellated-cube", "height of the pyramids on a cube of side 4", 2, 1, [](int n, std::uint64_t) { return stellated_cube(2, n); }},
      {"frame", "side of the hole", 1, 1, [](int n, std::uint64_t) { return frame(n); }},
      {"held", "facets above and below", 5, 2, [](int n, std::uint64_t) { return held(n); }},
      {"pizza-box", "grooves above and below", 3, 1, [](int n, std::uint64_t) { return pizza_box(n); }},
      {"crossing-bars", "bars each way", 2, 1, [](int n, std::uint64_t) { return crossing_bars(n); }},
      {"spiked-plate", "pyramids a side", 2, 1, [](int n, std::uint64_t) { return spiked_plate(n); }},
      {"saddle", "no meaning", 1, 1, [](int, std::uint64_t) { return saddle(); }},
      {"star", "points", 5, 3, [](int n, std::uint64_t s) { return star(n, s); }},
      {"cone", "degree of the apex", 8, 3, [](int n, std::uint64_t s) { return cone(n, s); }},
      {"spire", "degree of the apex", 8, 3, [](int n, std::uint64_t s) { return spire(n, s); }},
      {"peak", "degree of the middle", 8, 3, [](int n, std::uint64_t s) { return peak(n, s); }},
      {"arms", "arms around the apex, five facets each", 4, 3, [](int n, std::uint64_t s) { return arms(n, s); }},
  };
  return all;
}

}  // namespace osteon::models
