// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Solids from a fuzzer's bytes. All are valid by construction but those that decode_shape turns or moves a point of; they
/// have many ties, parallel facets, repeated planes and vertices of high degree.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "decode.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/registry.hpp"

namespace osteon::fuzz {

using shape = input_mesh<integer>;

/// What is known of a shape beyond its mesh.
struct decoded {
  shape mesh;
  bool valid = true;                     ///< a solid by construction
  std::optional<models::voxels> voxels;  ///< the mesh is the surface of these, unmoved
};

// ---- families

/// A polygon around the origin that sees all of it, of 3 .. most corners.
inline models::polygon star_polygon(decoder& d, int most) {
  static constexpr std::array<std::array<long, 2>, 16> circle = {
      {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}}};
  std::vector<int> steps;  // between directions, each below half a turn, together a whole one
  const long corners = d.between(3, most);
  int left = 16;
  for (long i = corners - 1; i > 0; --i) {
    const int least = std::max(1, left - 7 * static_cast<int>(i));
    const int step = static_cast<int>(d.between(least, std::min(7, left - static_cast<int>(i))));
    steps.push_back(step);
    left -= step;
  }
  models::polygon result;
  std::size_t at = d.index(16);
  for (long i = 0; i < corners; ++i) {
    const long r = d.between(1, 12);
    result.push_back({circle[at][0] * r, circle[at][1] * r});
    if (i + 1 < corners) at = (at + static_cast<std::size_t>(steps[static_cast<std::size_t>(i)])) % 16;
  }
  return result;
}

// Small ones are of the least size or one more.
inline models::builder model(decoder& d, bool small) {
  const auto& kinds = models::kinds();
  const auto& kind = kinds[d.index(kinds.size())];
  const int size = static_cast<int>(d.between(kind.least_size, small ? kind.least_size + 1 : std::max(kind.least_size, kind.default_size)));
  return kind.make(size, d.byte());
}

inline models::voxels decode_voxels(decoder& d, bool small) {
  const int x = static_cast<int>(d.between(1, small ? 3 : 4));
  const int y = static_cast<int>(d.between(1, small ? 2 : 3));
  models::voxels v({x, y, static_cast<int>(d.between(1, small ? 2 : 3))});
  unsigned bits = 0;
  int left = 0;
  for (int i = 0; i < v.size()[0]; ++i)
    for (int j = 0; j < v.size()[1]; ++j)
      for (int k = 0; k < v.size()[2]; ++k) {
        if (left == 0) {
          bits = d.byte();
          left = 8;
        }
        v.set(i, j, k, (bits >> --left & 1U) != 0);
      }
  if (v.count() == 0) v.set(0, 0, 0, true);
  v.mend();
  return v;
}

/// Two pyramids on one rim of any heights.
inline models::builder bipyramid(decoder& d, bool small) {
  const auto base = star_polygon(d, small ? 5 : 8);
  const long top = d.between(1, 12);
  const long low = -d.between(1, 12);
  std::vector<models::point> rim;
  for (const auto& p : base) rim.push_back({p[0], p[1], d.between(-12, 12)});
  models::builder b;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto& p = rim[i];
    const auto& q = rim[(i + 1) % rim.size()];
    b.facet({p, q, {0, 0, top}});
    b.facet({q, p, {0, 0, low}});
  }
  return b;
}

/// The common part of a box and up to nine half-spaces around the origin.
inline shape convex(decoder& d, bool small) {
  struct half_space {
    vec<integer> n;
    integer d;
  };
  std::vector<half_space> all;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      half_space h{{0, 0, 0}, 20};
      h.n[axis] = side;
      all.push_back(h);
    }
  for (long more = d.between(0, small ? 3 : 9); more > 0; --more) {
    half_space h;
    const long most = d.one_in(4) ? 100 : 2;
    for (auto& x : h.n) x = d.between(-most, most);
    h.d = d.between(most, 20 * most);
    if (h.n != vec<integer>{0, 0, 0}) all.push_back(h);
  }
  // Corners in homogeneous coordinates.
  std::vector<std::pair<vec<integer>, integer>> corners;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const auto jk = cross(all[j].n, all[k].n);
        const auto ki = cross(all[k].n, all[i].n);
        const auto ij = cross(all[i].n, all[j].n);
        integer w = dot(all[i].n, jk);
        if (w == 0) continue;
        vec<integer> x;
        for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = all[i].d * jk[axis] + all[j].d * ki[axis] + all[k].d * ij[axis];
        integer divisor = w < 0 ? integer(-1) : integer(1);
        divisor *= gcd(gcd(x[0], x[1]), gcd(x[2], w));
        for (auto& c : x) c /= divisor;
        w /= divisor;
        if (std::any_of(all.begin(), all.end(), [&](const half_space& h) { return dot(h.n, x) > h.d * w; })) continue;
        if (std::find(corners.begin(), corners.end(), std::pair(x, w)) == corners.end()) corners.emplace_back(x, w);
      }
  integer common = 1;
  for (const auto& [x, w] : corners) common = lcm(common, w);
  shape m;
  std::vector<vec<integer>> points;
  for (const auto& [x, w] : corners) {
    const integer f = common / w;
    points.push_back({x[0] * f, x[1] * f, x[2] * f});
    const auto& p = points.back();
    m.points.push_back({exact_number<integer>{p[0], 0, 0}, exact_number<integer>{p[1], 0, 0}, exact_number<integer>{p[2], 0, 0}});
  }
  std::vector<std::vector<int>> seen;
  for (const auto& h : all) {
    std::vector<int> facet;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (dot(h.n, points[p]) == h.d * common) facet.push_back(static_cast<int>(p));
    if (facet.size() < 3 || std::find(seen.begin(), seen.end(), facet) != seen.end()) continue;
    seen.push_back(facet);
    const auto& o = points[static_cast<std::size_t>(facet[0])];
    std::sort(facet.begin() + 1, facet.end(),
              [&](int a, int b) { return dot(h.n, cross(points[static_cast<std::size_t>(a)] - o, points[static_cast<std::size_t>(b)] - o)) > 0; });
    m.facets.push_back(facet);
  }
  return m;
}

/// A polyline for models::between_profiles, above zero.
inline models::builder profiles(decoder& d, bool small) {
  const long n = d.between(1, small ? 3 : 5);
  std::vector<std::array<long, 2>> f;
  std::vector<std::array<long, 2>> g;
  long x = 0;
  for (long i = 0; i <= n; ++i) {
    f.push_back({x, d.between(1, 12)});
    g.push_back({x, d.between(1, 12)});
    x += d.between(1, 6);
  }
  return models::between_profiles(f, g);
}

/// A block whose top, and perhaps bottom, is a triangulated grid of any heights.
inline models::builder terrain(decoder& d, bool small) {
  const long w = d.between(1, small ? 2 : 3);
  const long h = d.between(1, small ? 1 : 3);
  const bool both = d.flag();
  const long steep = d.flag() ? 12 : 3;
  const auto points = static_cast<std::size_t>((w + 1) * (h + 1));
  const auto at = [w](long x, long y) { return static_cast<std::size_t>(x + (w + 1) * y); };
  std::vector<long> high(points);
  std::vector<long> low(points);
  for (auto& z : high) z = d.between(1, steep);
  if (both)
    for (auto& z : low) z = -d.between(0, steep);
  models::builder b;
  const auto top = [&](long x, long y) { return models::point{4 * x, 4 * y, high[at(x, y)]}; };
  const auto bottom = [&](long x, long y) { return models::point{4 * x, 4 * y, low[at(x, y)]}; };
  for (long x = 0; x < w; ++x)
    for (long y = 0; y < h; ++y) {
      const unsigned cut = d.byte();
      for (const bool above : {true, false}) {
        std::vector<models::point> c;
        for (const auto& [i, j] : {std::pair(x, y), std::pair(x + 1, y), std::pair(x + 1, y + 1), std::pair(x, y + 1)})
          c.push_back(above ? top(i, j) : bottom(i, j));
        if (!above) std::reverse(c.begin(), c.end());
        if ((cut >> (above ? 0U : 1U) & 1U) != 0) std::rotate(c.begin(), c.begin() + 1, c.end());
        b.facet({c[0], c[1], c[2]});
        b.facet({c[0], c[2], c[3]});
      }
    }
  const auto wall = [&](long x, long y, long u, long v) { b.facet({bottom(x, y), bottom(u, v), top(u, v), top(x, y)}); };
  for (long x = 0; x < w; ++x) {
    wall(x, 0, x + 1, 0);
    wall(x + 1, h, x, h);
  }
  for (long y = 0; y < h; ++y) {
    wall(w, y, w, y + 1);
    wall(0, y + 1, 0, y);
  }
  return b;
}

inline decoded family(decoder& d, bool small) {
  decoded result;
  switch (d.between(0, 8)) {
    case 0:
      result.voxels = decode_voxels(d, small);
      result.mesh = result.voxels->surface().take<integer>();
      break;
    case 1: {
      const auto base = star_polygon(d, small ? 6 : 9);
      result.mesh = models::prism(base, d.between(1, 24)).take<integer>();
      break;
    }
    case 2: {
      const auto base = star_polygon(d, small ? 6 : 9);
      result.mesh = models::pyramid(base, d.between(1, 24)).take<integer>();
      break;
    }
    case 3:
      result.mesh = bipyramid(d, small).take<integer>();
      break;
    case 4:
      result.mesh = convex(d, small);
      break;
    case 5:
      result.mesh = profiles(d, small).take<integer>();
      break;
    case 6:
    case 7:
      result.mesh = terrain(d, small).take<integer>();
      break;
    default:
      result.mesh = model(d, small).take<integer>();
  }
  return result;
}

// ---- changes that leave a solid a solid

/// An affine image.
inline void transform(shape& m, decoder& d) {
  std::array<vec<integer>, 3> rows;
  for (auto& row : rows)
    for (auto& x : row) x = d.between(-3, 3);
  if (d.one_in(8))
    for (auto& x : rows[0]) x <<= static_cast<unsigned>(d.between(0, 60));
  const integer det = dot(rows[0], cross(rows[1], rows[2]));
  if (det == 0) return;
  for (auto& p : m.points) {
    const vec<integer> x = {p[0].mantissa, p[1].mantissa, p[2].mantissa};
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis].mantissa = dot(rows[axis], x);
  }
  if (det < 0) reverse_facets(m);
}

/// Cuts an edge in its middle and the triangles beside it.
inline void cut_edge(shape& m, decoder& d) {
  const auto& facet = m.facets[d.index(m.facets.size())];
  const std::size_t i = d.index(facet.size());
  const int a = facet[i];
  const int b = facet[(i + 1) % facet.size()];
  for (auto& p : m.points)
    for (auto& x : p) x.mantissa *= 2;
  const int middle = static_cast<int>(m.points.size());
  auto p = m.points[static_cast<std::size_t>(a)];
  for (std::size_t axis = 0; axis < 3; ++axis) p[axis].mantissa = (p[axis].mantissa + m.points[static_cast<std::size_t>(b)][axis].mantissa) / 2;
  m.points.push_back(p);
  for (std::size_t f = 0, n = m.facets.size(); f < n; ++f) {
    std::vector<int> loop = m.facets[f];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int from = loop[k];
      const int to = loop[(k + 1) % loop.size()];
      if (!(from == a && to == b) && !(from == b && to == a)) continue;
      if (loop.size() == 3) {
        const int far = loop[(k + 2) % 3];
        m.facets[f] = {from, middle, far};
        m.facets.push_back({middle, to, far});
      } else {
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
        m.facets[f] = loop;
      }
      break;
    }
  }
}

/// Least and greatest coordinates.
inline std::array<vec<integer>, 2> bounds(const shape& m) {
  std::array<vec<integer>, 2> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[0][axis] = result[1][axis] = m.points[0][axis].mantissa;
    for (const auto& p : m.points) {
      result[0][axis] = std::min(result[0][axis], p[axis].mantissa);
      result[1][axis] = std::max(result[1][axis], p[axis].mantissa);
    }
  }
  return result;
}

inline void append(shape& m, const shape& other, const vec<integer>& shift) {
  const int first = static_cast<int>(m.points.size());
  for (auto p : other.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis].mantissa += shift[axis];
    m.points.push_back(p);
  }
  for (auto f : other.facets) {
    for (int& p : f) p += first;
    m.facets.push_back(f);
  }
}

/// A second body beside the first, or a box around it, which makes it a void.
inline void add_body(shape& m, decoder& d, bool small) {
  const auto [lo, hi] = bounds(m);
  if (d.flag()) {
    const shape other = family(d, small).mesh;
    const auto [from, to] = bounds(other);
    append(m, other, {hi[0] - from[0] + d.between(1, 9), integer(d.between(-9, 9)), integer(d.between(-9, 9))});
    return;
  }
  vec<integer> a = lo;
  vec<integer> b = hi;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    a[axis] -= d.between(1, 9);
    b[axis] += d.between(1, 9);
  }
  reverse_facets(m);
  shape box = models::box(1, 1, 1).take<integer>();
  for (auto& p : box.points)
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis].mantissa = p[axis].mantissa == 0 ? a[axis] : b[axis];
  append(m, box, {0, 0, 0});
}

// ---- changes that mostly do

/// Turned by two angles and rounded: nearly what it was, with facets that are not quite planar.
inline void turn(shape& m, decoder& d) {
  const double a = 0.1 + 0.0243 * d.byte();
  const double b = 0.3 + 0.0243 * d.byte();
  const int digits = std::array{1, 2, 3, 6, 9, 15}[d.index(6)];
  const long double unit = std::pow(10.0L, digits);
  for (auto& p : m.points) {
    std::array<long double, 3> x{};
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = p[axis].mantissa.convert_to<long double>();
    const long double u = std::cos(a) * x[0] - std::sin(a) * x[1];
    const long double v = std::sin(a) * x[0] + std::cos(a) * x[1];
    const std::array<long double, 3> y = {u, std::cos(b) * v - std::sin(b) * x[2], std::sin(b) * v + std::cos(b) * x[2]};
    if (std::any_of(y.begin(), y.end(), [&](long double c) { return std::abs(c) * unit > 9e18L; })) return;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis].mantissa = integer(std::llround(y[axis] * unit));
  }
}

inline void move_point(shape& m, decoder& d) {
  auto& p = m.points[d.index(m.points.size())];
  for (auto& x : p) x.mantissa += d.between(-2, 2);
}

/// Writes a mesh as an OBJ file, exactly, where OSTEON_FUZZ_OBJ names one: a failure outlives its decoder.
inline void keep(const shape& m) {
  const char* file = std::getenv("OSTEON_FUZZ_OBJ");
  if (file == nullptr) return;
  std::ofstream out(file);
  for (const auto& p : m.points) {
    out << 'v';
    for (const auto& x : p) {
      const integer whole =
          x.two >= 0 ? integer(x.mantissa << static_cast<unsigned>(x.two)) : x.mantissa * pow(integer(5), static_cast<unsigned>(-x.two));
      out << ' ' << whole << 'e' << x.ten + std::min(x.two, 0);
    }
    out << '\n';
  }
  for (const auto& f : m.facets) {
    out << 'f';
    for (const int p : f) out << ' ' << p + 1;
    out << '\n';
  }
}

/// A shape and what was done to it; of at most `most` facets. Small ones have at most about thirty edges.
inline decoded decode_shape(decoder& d, std::size_t most, bool small = false) {
  const unsigned changes = d.byte();
  decoded result = family(d, small);
  shape& m = result.mesh;
  const auto wanted = [&](unsigned bit) { return (changes >> bit & 1U) != 0 && m.facets.size() <= most; };
  if (changes != 0) result.voxels.reset();
  if (wanted(0)) transform(m, d);
  if (wanted(1) && wanted(2)) add_body(m, d, small);
  if (wanted(3) && wanted(4)) cut_edge(m, d);
  if (wanted(5) && wanted(6)) {
    turn(m, d);
    result.valid = false;
  }
  if (wanted(7) && wanted(4)) {
    move_point(m, d);
    result.valid = false;
  }
  return result;
}

}  // namespace osteon::fuzz
