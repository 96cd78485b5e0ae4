// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generators of solids for RapidCheck: exact, with integer coordinates, valid by construction or discarded with a typed input_error. They
/// shrink towards fewer facets and smaller numbers. A counterexample is shown as an OBJ file, which replays with the program.

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/registry.hpp"
#include "polytope.hpp"
#include "run.hpp"

namespace osteon {

/// Numbers of the enumerators.
inline void showValue(const skeleton_options& o, std::ostream& out) {
  out << "prefer " << static_cast<int>(o.prefer) << ", saddle " << static_cast<int>(o.saddle);
}

}  // namespace osteon

namespace osteon::properties {

/// A generated solid: the mesh as it would come from a file, and what make_solid makes of it (null where it refuses).
struct specimen {
  std::string kind;
  input_mesh<integer> input;
  std::shared_ptr<const osteon::solid<integer>> solid;
};

/// OBJ text; weights as comments.
inline void showValue(const specimen& s, std::ostream& out) {
  out << "\n# " << s.kind << '\n';
  for (const auto& p : s.input.points) out << "v " << p[0].mantissa << ' ' << p[1].mantissa << ' ' << p[2].mantissa << '\n';
  for (std::size_t f = 0; f < s.input.facets.size(); ++f) {
    if (!s.input.weights.empty()) out << "# weight " << s.input.weights[f] << '\n';
    out << 'f';
    for (const int p : s.input.facets[f]) out << ' ' << p + 1;
    out << '\n';
  }
}

/// The greatest degree of a vertex by default: Catalan(7) = 429 trees.
inline constexpr std::size_t greatest_degree = 9;

inline specimen specimen_of(std::string kind, input_mesh<integer> m) {
  specimen s{std::move(kind), std::move(m), nullptr};
  try {
    auto built = make_solid(s.input);
    for (const auto& v : built.boundary.vertices)
      if (v.facets.size() > greatest_degree) return s;
    s.solid = std::make_shared<const osteon::solid<integer>>(std::move(built));
  } catch (const input_error&) {  // discarded
  }
  return s;
}

/// Integer points of a polytope's or other rational soup: multiplied by the common denominator.
inline input_mesh<integer> scaled_mesh(const std::vector<vector3>& points, std::vector<std::vector<int>> facets) {
  integer common = 1;
  for (const auto& p : points)
    for (const rational& x : p) common = lcm(common, denominator(x));
  input_mesh<integer> m;
  for (const auto& p : points) {
    auto& q = m.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) q[axis].mantissa = numerator(p[axis]) * (common / denominator(p[axis]));
  }
  m.facets = std::move(facets);
  return m;
}

namespace gen {

using models::point;

/// lo .. hi whatever RapidCheck's size; shrinks towards lo.
inline rc::Gen<long> between(long lo, long hi) { return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<long>(lo, hi + 1)); }

/// -r .. r; shrinks towards 0.
inline rc::Gen<long> within(long r) {
  return rc::gen::map(between(0, 2 * r), [](long x) { return x % 2 != 0 ? (x + 1) / 2 : -(x / 2); });
}

inline rc::Gen<point> point_within(long r) { return rc::gen::container<point>(within(r)); }

/// least .. most elements; shrinks by leaving out and by shrinking elements.
template <class T>
rc::Gen<std::vector<T>> list(std::size_t least, std::size_t most, const rc::Gen<T>& g) {
  const auto rest = rc::gen::resize(static_cast<int>(most - least), rc::gen::container<std::vector<T>>(g));
  return rc::gen::map(rc::gen::tuple(rc::gen::container<std::vector<T>>(least, g), rest), [](std::tuple<std::vector<T>, std::vector<T>> both) {
    auto [first, second] = std::move(both);
    first.insert(first.end(), second.begin(), second.end());
    return first;
  });
}

/// Any preference and any saddle rule.
inline rc::Gen<skeleton_options> any_options() {
  return rc::gen::map(rc::gen::pair(between(0, 3), between(0, 3)), [](const std::pair<long, long>& o) {
    return skeleton_options{static_cast<split_preference>(o.first), static_cast<saddle_rule>(o.second)};
  });
}

inline vector3 exact(const point& p) { return {rational(p[0]), rational(p[1]), rational(p[2])}; }

inline specimen nothing() { return {"nothing", {}, nullptr}; }

inline rc::Gen<specimen> valid(const rc::Gen<specimen>& g) {
  return rc::gen::suchThat(g, [](const specimen& s) { return s.solid != nullptr; });
}

// ---- convex solids

/// Hulls of 4 to `most` points. With a small radius they are degenerate: coplanar points, parallel facets, symmetric corners.
inline rc::Gen<specimen> hulls(long radius, std::size_t most = 9) {
  return valid(rc::gen::map(list(4, most, point_within(radius)), [](const std::vector<point>& points) {
    std::vector<vector3> all;
    for (const auto& p : points) all.push_back(exact(p));
    const auto h = hull(all);
    return h ? specimen_of("hull", scaled_mesh(h->points, h->facets)) : nothing();
  }));
}

/// A tetrahedron cut by up to `cuts` planes around the origin. Almost all vertices have degree three.
inline rc::Gen<specimen> cut_solids(std::size_t cuts = 5) {
  using cut = std::pair<point, long>;
  const auto planes = list<cut>(0, cuts, rc::gen::pair(point_within(9), between(30, 120)));
  return valid(rc::gen::map(rc::gen::pair(planes, rc::gen::container<std::array<long, 4>>(between(200, 260))),
                            [](const std::pair<std::vector<cut>, std::array<long, 4>>& given) {
                              const std::array<point, 4> base = {{{7, 6, 8}, {-8, -7, 6}, {-6, 7, -8}, {8, -7, -6}}};
                              std::vector<half_space> spaces;
                              for (std::size_t i = 0; i < 4; ++i) spaces.push_back({exact(base[i]), rational(given.second[i])});
                              for (const auto& [n, d] : given.first)
                                if (n != point{0, 0, 0}) spaces.push_back({exact(n), rational(d)});
                              const auto h = hull(corners_of(spaces));
                              return h ? specimen_of("cut solid", scaled_mesh(h->points, h->facets)) : nothing();
                            }));
}

// ---- star-shaped solids: a triangulated sphere of directions, each vertex at its own distance

/// The triangles of a hull of directions all around the origin; nothing where the origin is not inside.
inline std::optional<polytope> directions(const std::vector<point>& more) {
  std::vector<vector3> all = {exact({9, 1, 0}), exact({-9, 2, 1}), exact({1, 9, -1}), exact({0, -9, 2}), exact({2, -1, 9}), exact({1, 2, -9})};
  for (const auto& p : more) all.push_back(exact(p));
  auto h = hull(all);
  if (!h) return std::nullopt;
  std::vector<std::vector<int>> triangles;
  for (const auto& f : h->facets)
    for (std::size_t i = 2; i < f.size(); ++i) triangles.push_back({f[0], f[i - 1], f[i]});
  h->facets = std::move(triangles);
  return h;
}

using radii = std::vector<long>;
inline constexpr std::size_t most_directions = 11;

inline std::vector<vector3> at_distances(const polytope& sphere, const radii& r, const point& centre = {0, 0, 0}) {
  std::vector<vector3> points;
  for (std::size_t i = 0; i < sphere.points.size(); ++i) points.push_back(exact(centre) + rational(r[i]) * sphere.points[i]);
  return points;
}

inline rc::Gen<radii> distances(long lo, long hi) { return rc::gen::container<radii>(most_directions, between(lo, hi)); }

/// Solids that are seen whole from the origin, `spread` the ratio of greatest and least distance.
inline rc::Gen<specimen> stars(long spread = 4, std::size_t more = 4) {
  return valid(
      rc::gen::map(rc::gen::pair(list(0, more, point_within(8)), distances(60, 60 * spread)), [](const std::pair<std::vector<point>, radii>& given) {
        const auto sphere = directions(given.first);
        if (!sphere) return nothing();
        return specimen_of("star", scaled_mesh(at_distances(*sphere, given.second), sphere->facets));
      }));
}

/// A star within a star, taken out: the solid has a void.
inline rc::Gen<specimen> hollow_stars() {
  return valid(rc::gen::map(rc::gen::tuple(list(0, 2, point_within(8)), distances(120, 240), distances(20, 100)),
                            [](const std::tuple<std::vector<point>, radii, radii>& given) {
                              const auto sphere = directions(std::get<0>(given));
                              if (!sphere) return nothing();
                              auto points = at_distances(*sphere, std::get<1>(given));
                              const auto inner = at_distances(*sphere, std::get<2>(given));
                              auto facets = sphere->facets;
                              for (auto f : sphere->facets) {
                                std::reverse(f.begin(), f.end());
                                for (int& p : f) p += static_cast<int>(points.size());
                                facets.push_back(f);
                              }
                              points.insert(points.end(), inner.begin(), inner.end());
                              return specimen_of("hollow star", scaled_mesh(points, facets));
                            }));
}

/// Two stars that do not touch.
inline rc::Gen<specimen> pairs_of_stars() {
  return valid(
      rc::gen::map(rc::gen::tuple(distances(60, 180), distances(60, 180), point_within(50)), [](const std::tuple<radii, radii, point>& given) {
        const auto sphere = directions({});
        auto points = at_distances(*sphere, std::get<0>(given));
        const point& shift = std::get<2>(given);
        const auto second = at_distances(*sphere, std::get<1>(given), {4000 + shift[0], shift[1], shift[2]});
        auto facets = sphere->facets;
        for (auto f : sphere->facets) {
          for (int& p : f) p += static_cast<int>(points.size());
          facets.push_back(f);
        }
        points.insert(points.end(), second.begin(), second.end());
        return specimen_of("two stars", scaled_mesh(points, facets));
      }));
}

// ---- corners of high degree

/// A star polygon of `least` to `most` corners below an apex, closed by a plane or by a second apex.
inline rc::Gen<specimen> cones(std::size_t least = 3, std::size_t most = greatest_degree) {
  return valid(rc::gen::map(rc::gen::tuple(list(least, most, between(40, 100)), point_within(20), rc::gen::arbitrary<bool>()),
                            [](const std::tuple<std::vector<long>, point, bool>& given) {
                              const auto& [radius, shift, both] = given;
                              const int n = static_cast<int>(radius.size());
                              std::vector<point> rim;
                              for (int i = 0; i < n; ++i) {
                                const auto p = models::on_circle(i, n, static_cast<double>(10 * radius[static_cast<std::size_t>(i)]), 0.1);
                                rim.push_back({p[0], p[1], both ? radius[static_cast<std::size_t>((i + 1) % n)] : 0});
                              }
                              models::builder b;
                              for (std::size_t i = 0; i < rim.size(); ++i) {
                                const point& p = rim[i];
                                const point& q = rim[(i + 1) % rim.size()];
                                b.facet({p, q, {shift[0], shift[1], 600 + shift[2]}});
                                if (both) b.facet({q, p, {shift[1], shift[2], -500 + shift[0]}});
                              }
                              std::reverse(rim.begin(), rim.end());
                              if (!both) b.facet(rim);
                              return specimen_of("cone", b.take<integer>());
                            }));
}

// ---- solids over grids

/// Ground plans of at most 3 x 3 cells, and numbers for their points.
struct grid {
  int w;
  int h;
  std::vector<long> heights;
  std::vector<point> shifts;
  std::vector<bool> diagonals;
};

inline rc::Gen<grid> grids(long lo, long hi, long shift, int most = 3) {
  const auto points = static_cast<std::size_t>((most + 1) * (most + 1));
  return rc::gen::map(
      rc::gen::tuple(between(1, most), between(1, most), rc::gen::container<std::vector<long>>(points, between(lo, hi)),
                     rc::gen::container<std::vector<point>>(points, point_within(shift)),
                     rc::gen::container<std::vector<bool>>(points, rc::gen::arbitrary<bool>())),
      [](const std::tuple<long, long, std::vector<long>, std::vector<point>, std::vector<bool>>& g) {
        return grid{static_cast<int>(std::get<0>(g)), static_cast<int>(std::get<1>(g)), std::get<2>(g), std::get<3>(g), std::get<4>(g)};
      });
}

/// A triangulated landscape of w x h crooked cells over an apex far below. In general position almost surely.
inline rc::Gen<specimen> landscapes() {
  return valid(rc::gen::map(grids(0, 120, 20, 2), [](const grid& g) {
    models::builder b;
    const auto at = [&](int x, int y) {
      const auto i = static_cast<std::size_t>(y * (g.w + 1) + x);
      return point{200 * x - 100 * g.w + g.shifts[i][0], 200 * y - 100 * g.h + g.shifts[i][1], g.heights[i]};
    };
    const point apex = {g.shifts[0][1], g.shifts[0][2], -400 - g.heights[0]};
    for (int x = 0; x < g.w; ++x)
      for (int y = 0; y < g.h; ++y) {
        std::array<point, 4> c = {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
        if (g.diagonals[static_cast<std::size_t>(y * g.w + x)]) std::rotate(c.begin(), c.begin() + 1, c.end());
        b.facet({c[0], c[1], c[2]});
        b.facet({c[0], c[2], c[3]});
      }
    std::vector<point> rim;
    for (int x = 0; x < g.w; ++x) rim.push_back(at(x, 0));
    for (int y = 0; y < g.h; ++y) rim.push_back(at(g.w, y));
    for (int x = g.w; x > 0; --x) rim.push_back(at(x, g.h));
    for (int y = g.h; y > 0; --y) rim.push_back(at(0, y));
    for (std::size_t i = 0; i < rim.size(); ++i) b.facet({rim[(i + 1) % rim.size()], rim[i], apex});
    return specimen_of("landscape", b.take<integer>());
  }));
}

/// A box of w x h cells whose top has small integer heights, or in each cell a pyramid or a pit (`spikes`). Degenerate: walls and
/// floor, parallel and coplanar facets, facets with holes.
inline rc::Gen<specimen> plates(bool spikes) {
  return valid(rc::gen::map(spikes ? grids(-3, 4, 1, 3) : grids(2, 5, 0, 3), [spikes](const grid& g) {
    models::builder b;
    const auto height = [&](int x, int y) { return spikes ? 8 : 4 * g.heights[static_cast<std::size_t>(y * (g.w + 1) + x)]; };
    const auto top = [&](int x, int y) { return point{4 * x, 4 * y, height(x, y)}; };
    const auto low = [&](int x, int y) { return point{4 * x, 4 * y, 0}; };
    for (int x = 0; x < g.w; ++x)
      for (int y = 0; y < g.h; ++y) {
        const auto i = static_cast<std::size_t>(y * g.w + x);
        std::array<point, 4> c = {top(x, y), top(x + 1, y), top(x + 1, y + 1), top(x, y + 1)};
        if (spikes) {
          const point apex = {4 * x + 2 + g.shifts[i][0], 4 * y + 2 + g.shifts[i][1], 8 + 2 * g.heights[i]};
          for (std::size_t s = 0; s < 4; ++s) b.facet({c[s], c[(s + 1) % 4], apex});
        } else {
          if (g.diagonals[i]) std::rotate(c.begin(), c.begin() + 1, c.end());
          b.facet({c[0], c[1], c[2]});
          b.facet({c[0], c[2], c[3]});
        }
        b.facet({low(x, y), low(x, y + 1), low(x + 1, y + 1), low(x + 1, y)});
      }
    for (int x = 0; x < g.w; ++x) {
      b.facet({low(x, 0), low(x + 1, 0), top(x + 1, 0), top(x, 0)});
      b.facet({low(x + 1, g.h), low(x, g.h), top(x, g.h), top(x + 1, g.h)});
    }
    for (int y = 0; y < g.h; ++y) {
      b.facet({low(g.w, y), low(g.w, y + 1), top(g.w, y + 1), top(g.w, y)});
      b.facet({low(0, y + 1), low(0, y), top(0, y), top(0, y + 1)});
    }
    return specimen_of(spikes ? "spiked plate" : "stepped plate", b.take<integer>());
  }));
}

/// Rings of k segments with four crooked rims: solids with a tunnel, in general position almost surely.
inline rc::Gen<specimen> rings() {
  using section = std::array<long, 8>;
  return valid(rc::gen::map(list(4, 5, rc::gen::container<section>(between(0, 100))), [](const std::vector<section>& sections) {
    const int n = static_cast<int>(sections.size());
    // Outer upper, outer lower, inner lower, inner upper: counter-clockwise around the body of the ring, seen along it.
    const auto at = [&](int i, int corner) {
      const section& s = sections[static_cast<std::size_t>(i % n)];
      const bool outer = corner < 2;
      const bool upper = corner == 0 || corner == 3;
      const auto p = models::on_circle(i % n, n, static_cast<double>((outer ? 700 : 150) + 2 * s[static_cast<std::size_t>(corner)]), 0.1);
      const long z = 80 + s[static_cast<std::size_t>(4 + corner)];
      return point{p[0], p[1], upper ? z : -z};
    };
    models::builder b;
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 4; ++c) {
        const point p = at(i, c);
        const point q = at(i + 1, c);
        const point r = at(i + 1, (c + 1) % 4);
        const point s = at(i, (c + 1) % 4);
        b.facet({p, s, r});
        b.facet({p, r, q});
      }
    return specimen_of("ring", b.take<integer>());
  }));
}

/// Unions of unit cubes, mended to manifolds: tunnels, voids, several bodies, majority corners. As degenerate as can be.
inline rc::Gen<specimen> voxels(int most = 3) {
  const auto side = between(1, most);
  const auto cubes = static_cast<std::size_t>(most * most * most);
  return valid(rc::gen::map(rc::gen::tuple(side, side, side, rc::gen::container<std::vector<bool>>(cubes, rc::gen::arbitrary<bool>())),
                            [](const std::tuple<long, long, long, std::vector<bool>>& given) {
                              const std::array<int, 3> size = {static_cast<int>(std::get<0>(given)), static_cast<int>(std::get<1>(given)),
                                                               static_cast<int>(std::get<2>(given))};
                              models::voxels v(size);
                              std::size_t i = 0;
                              for (int x = 0; x < size[0]; ++x)
                                for (int y = 0; y < size[1]; ++y)
                                  for (int z = 0; z < size[2]; ++z) v.set(x, y, z, std::get<3>(given)[i++]);
                              if (v.count() == 0) v.set(0, 0, 0, true);
                              v.mend();
                              return specimen_of("voxels", v.surface().take<integer>());
                            }));
}

/// The library's own small models.
inline rc::Gen<specimen> small_models() {
  const auto& kinds = models::kinds();
  return valid(rc::gen::map(
      rc::gen::tuple(rc::gen::inRange<std::size_t>(0, kinds.size()), between(0, 2), between(0, 1000)),
      [&kinds](const std::tuple<std::size_t, long, long>& given) {
        const auto& [number, size, seed] = given;
        const auto& kind = kinds[number];
        return specimen_of(kind.name, kind.make(kind.least_size + static_cast<int>(size), static_cast<std::uint64_t>(seed)).template take<integer>());
      }));
}

// ---- mixtures

/// Solids whose facets move at speeds 1 to 3.
inline rc::Gen<specimen> weighted(const rc::Gen<specimen>& g) {
  return valid(
      rc::gen::map(rc::gen::pair(g, rc::gen::container<std::vector<long>>(64, between(1, 3))), [](std::pair<specimen, std::vector<long>> given) {
        input_mesh<integer> m = std::move(given.first.input);
        for (std::size_t f = 0; f < m.facets.size(); ++f) m.weights.emplace_back(given.second[f % 64]);
        return specimen_of("weighted " + given.first.kind, std::move(m));
      }));
}

/// Solids in general position: no predicate is zero.
inline rc::Gen<specimen> general(const rc::Gen<specimen>& g, const skeleton_options& o = {}) {
  return rc::gen::suchThat(g, [o](const specimen& s) { return in_general_position(*s.solid, o); });
}

inline rc::Gen<specimen> unweighted_general(const skeleton_options& o = {}) {
  return general(rc::gen::oneOf(hulls(1000, 8), cut_solids(), stars(), stars(8), cones(), landscapes(), rings(), hollow_stars(), pairs_of_stars()),
                 o);
}

/// Mostly degenerate solids.
inline rc::Gen<specimen> special() { return rc::gen::oneOf(hulls(3), plates(false), plates(true), voxels(), voxels(2), small_models()); }

inline rc::Gen<specimen> unweighted() {
  return rc::gen::oneOf(hulls(1000, 8), cut_solids(), stars(), cones(), landscapes(), rings(), hollow_stars(), pairs_of_stars(), special(), special(),
                        special(), special());
}

inline rc::Gen<specimen> convex() { return rc::gen::oneOf(hulls(1000, 8), hulls(3, 8), hulls(30, 8), cut_solids()); }

}  // namespace gen
}  // namespace osteon::properties
