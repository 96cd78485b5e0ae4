// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Finds an edge and a facet of a closed surface that meet where they should not, exactly.

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osteon/geometry.hpp"

namespace osteon {

/// A closed surface of planar facets: what the check looks at. Facet f lies in the plane normals[f] . x = offsets[f].
template <class Int>
struct surface_view {
  std::span<const vec<Int>> points;
  std::span<const std::vector<int>> facets;
  std::span<const vec<Int>> normals;
  std::span<const Int> offsets;
};

/// An edge (two points) and a facet that meet outside their common corners and edges.
struct bad_contact {
  int a, b;
  int facet;
};

namespace detail {

/// Whether two edges in one plane meet although they should not: anywhere but in a common end.
template <class Int>
bool edges_meet(const surface_view<Int>& s, int a, int b, int p, int q, const std::array<int, 2>& axes) {
  if ((a == p && b == q) || (a == q && b == p)) return false;
  const auto at = [&](int i) { return point2<Int>{s.points[i][axes[0]], s.points[i][axes[1]], Int(1)}; };
  const auto on = [&](int u, int v, int w) {  // w on the closed segment uv
    const std::array<int, 3> two = {u, v, u};
    return turn(s.points[u], s.points[v], at(w), axes) == sign::zero &&
           locate_in_polygon<Int>(s.points, std::span<const int>(two).first(2), at(w), axes) == location::border;
  };
  if (a == p || a == q) return on(a, b, a == p ? q : p) || on(p, q, b);
  if (b == p || b == q) return on(a, b, b == p ? q : p) || on(p, q, a);
  const sign tp = turn(s.points[a], s.points[b], at(p), axes);
  const sign tq = turn(s.points[a], s.points[b], at(q), axes);
  const sign ta = turn(s.points[p], s.points[q], at(a), axes);
  const sign tb = turn(s.points[p], s.points[q], at(b), axes);
  if (tp * tq == sign::negative && ta * tb == sign::negative) return true;
  return on(a, b, p) || on(a, b, q) || on(p, q, a) || on(p, q, b);
}

/// Whether edge (a,b) meets facet f where it should not.
template <class Int>
bool meets(const surface_view<Int>& s, int a, int b, int f) {
  const vec<Int>& n = s.normals[f];
  const Int ha = dot(n, s.points[a]) - s.offsets[f];
  const Int hb = dot(n, s.points[b]) - s.offsets[f];
  const sign sa = sign_of(ha);
  const sign sb = sign_of(hb);
  if (sa == sb && sa != sign::zero) return false;
  const auto axes = projection(n);
  const std::vector<int>& loop = s.facets[f];
  const auto corner = [&](int p) { return std::find(loop.begin(), loop.end(), p) != loop.end(); };
  const auto where = [&](const point2<Int>& p) { return locate_in_polygon<Int>(s.points, loop, p, axes); };
  const auto at = [&](int p) { return point2<Int>{s.points[p][axes[0]], s.points[p][axes[1]], Int(1)}; };
  if (sa != sign::zero && sb != sign::zero) {
    const Int wa = ha < 0 ? Int(-ha) : ha;
    const Int wb = hb < 0 ? Int(-hb) : hb;
    const auto mix = [&](int axis) -> Int { return s.points[a][axis] * wb + s.points[b][axis] * wa; };
    return where({mix(axes[0]), mix(axes[1]), wa + wb}) != location::outside;
  }
  if (sa == sign::zero && sb == sign::zero) {
    bool own = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int p = loop[i];
      const int q = loop[(i + 1) % loop.size()];
      own = own || (p == a && q == b) || (p == b && q == a);
      if (edges_meet(s, a, b, p, q, axes)) return true;
    }
    const auto middle = [&](int axis) -> Int { return s.points[a][axis] + s.points[b][axis]; };
    return !own && where({middle(axes[0]), middle(axes[1]), Int(2)}) != location::outside;
  }
  const int touching = sa == sign::zero ? a : b;
  return !corner(touching) && where(at(touching)) != location::outside;
}

}  // namespace detail

/// The first bad contact found, or nothing. Boxes are swept along x; every decision is exact. About n log n plus the
/// number of box overlaps, each linear in its facet.
template <class Int>
std::optional<bad_contact> find_self_intersection(const surface_view<Int>& s) {
  struct box {
    std::array<double, 3> lo, hi;  // conversion is monotone, so overlapping boxes stay overlapping
  };
  const auto box_of = [&](std::span<const int> ids) {
    constexpr double big = std::numeric_limits<double>::infinity();
    box r{{big, big, big}, {-big, -big, -big}};
    for (const int p : ids)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto x = static_cast<double>(s.points[p][axis]);
        r.lo[axis] = std::min(r.lo[axis], x);
        r.hi[axis] = std::max(r.hi[axis], x);
      }
    return r;
  };
  struct item {
    box b;
    int facet;  // -1: an edge
    std::array<int, 2> ends;
  };
  std::vector<item> items;
  for (int f = 0; f < static_cast<int>(s.facets.size()); ++f) {
    const auto& loop = s.facets[f];
    items.push_back({box_of(loop), f, {}});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::array<int, 2> ends = {loop[i], loop[(i + 1) % loop.size()]};
      if (ends[0] < ends[1]) items.push_back({box_of(ends), -1, ends});
    }
  }
  std::sort(items.begin(), items.end(), [](const item& x, const item& y) { return x.b.lo[0] < y.b.lo[0]; });
  std::array<std::vector<const item*>, 2> active;  // edges, facets
  for (const item& i : items) {
    const bool facet = i.facet >= 0;
    auto& others = active[facet ? 0 : 1];
    std::erase_if(others, [&](const item* o) { return o->b.hi[0] < i.b.lo[0]; });
    for (const item* o : others) {
      if (o->b.hi[1] < i.b.lo[1] || o->b.lo[1] > i.b.hi[1] || o->b.hi[2] < i.b.lo[2] || o->b.lo[2] > i.b.hi[2]) continue;
      const item& edge = facet ? *o : i;
      const int f = facet ? i.facet : o->facet;
      if (detail::meets(s, edge.ends[0], edge.ends[1], f)) return bad_contact{edge.ends[0], edge.ends[1], f};
    }
    active[facet ? 1 : 0].push_back(&i);
  }
  return std::nullopt;
}

}  // namespace osteon
