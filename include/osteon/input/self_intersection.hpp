// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Finds where a closed surface meets itself although it should not, exactly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "osteon/input/geometry.hpp"

namespace osteon {

/// A closed surface of planar facets: what the check looks at. Facet f lies in the plane normals[f] . x = offsets[f], its normal
/// has the direction of its area vector. Every edge belongs to two facets, once in each direction.
template <class Int>
struct surface_view {
  std::span<const vec<Int>> points;
  std::span<const std::vector<int>> facets;
  std::span<const vec<Int>> normals;
  std::span<const Int> offsets;
};

/// Where a surface meets itself.
struct bad_contact {
  enum class kind : std::uint8_t {
    edge,    ///< edge (a,b) meets the facet outside their common corners and edges
    corner,  ///< the facet's loop passes the point a more than once, and its inside overlaps or turns over there
    chord    ///< the facet and facet `other` pass through each other between their common corners a and b
  };
  kind what;
  int facet;
  int a;
  int b = -1;
  int other = -1;
};

namespace detail {

/// A right shift after which doubles can hold x, and products of two such.
template <class Int>
unsigned double_shift(const Int& x) {
  unsigned shift = 0;
  while (std::abs(static_cast<double>(Int(x >> shift))) > 0x1p480) shift += 256;
  return shift;
}

/// Points as doubles times 2^-shift, by a monotone function.
template <class Int>
std::vector<std::array<double, 3>> approximate(std::span<const vec<Int>> points, unsigned& shift) {
  shift = 0;
  std::vector<std::array<double, 3>> result;
  for (const auto& p : points)
    for (const Int& x : p) shift = std::max(shift, double_shift(x));
  for (const auto& p : points) {
    auto& q = result.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = static_cast<double>(Int(p[axis] >> shift));
  }
  return result;
}

struct box {
  std::array<double, 3> lo, hi;

  box(std::span<const std::array<double, 3>> points, std::span<const int> ids) : lo(points[ids[0]]), hi(lo) {
    for (const int p : ids)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(lo[axis], points[p][axis]);
        hi[axis] = std::max(hi[axis], points[p][axis]);
      }
  }
  bool overlaps(const box& o) const {
    return lo[0] <= o.hi[0] && o.lo[0] <= hi[0] && lo[1] <= o.hi[1] && o.lo[1] <= hi[1] && lo[2] <= o.hi[2] && o.lo[2] <= hi[2];
  }
};

/// See find_self_intersection.
template <class Int>
class intersection_search {
 public:
  explicit intersection_search(const surface_view<Int>& s) : s_(s), points_(approximate(s.points, shift_)) {}

  std::optional<bad_contact> run() {
    for (int f = 0; f < static_cast<int>(s_.facets.size()); ++f) {
      if (s_.facets[f].size() == 3) continue;
      check_loop(f);
      if (!found_) check_corners(f);
      if (found_) return found_;
    }
    sweep();
    if (!found_) check_chords();
    return found_;
  }

 private:
  using kind = bad_contact::kind;
  struct edge {
    int a, b;
    std::array<int, 2> facets;
  };
  // A facet's plane in doubles: the side of a point farther away than `error` is certain, else zero.
  struct rough_plane {
    std::array<double, 3> n;
    double d;
    double error;

    sign side(const std::array<double, 3>& x) const {
      const double h = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
      return h > error ? sign::positive : (h < -error ? sign::negative : sign::zero);
    }
  };

  point2<Int> at(int p, const std::array<int, 2>& axes) const { return {s_.points[p][axes[0]], s_.points[p][axes[1]], Int(1)}; }
  point2<Int> middle(int a, int b, const std::array<int, 2>& axes) const {
    return {s_.points[a][axes[0]] + s_.points[b][axes[0]], s_.points[a][axes[1]] + s_.points[b][axes[1]], Int(2)};
  }
  location where(const point2<Int>& p, int f, const std::array<int, 2>& axes) const {
    return locate_in_polygon<Int>(s_.points, s_.facets[f], p, axes);
  }
  bool is_corner(int p, int f) const {
    const auto& loop = s_.facets[f];
    return std::find(loop.begin(), loop.end(), p) != loop.end();
  }

  // Whether two edges in one plane meet although they should not: anywhere but in a common end.
  bool edges_meet(int a, int b, int p, int q, const std::array<int, 2>& axes) const {
    if ((a == p && b == q) || (a == q && b == p)) return false;
    for (const int axis : axes)
      if (std::max(points_[a][axis], points_[b][axis]) < std::min(points_[p][axis], points_[q][axis]) ||
          std::max(points_[p][axis], points_[q][axis]) < std::min(points_[a][axis], points_[b][axis]))
        return false;
    const auto on = [&](int u, int v, int w) {  // w on the closed segment uv
      const std::array<int, 2> two = {u, v};
      return locate_in_polygon<Int>(s_.points, two, at(w, axes), axes) == location::border;
    };
    if (a == p || a == q) return on(a, b, a == p ? q : p) || on(p, q, b);
    if (b == p || b == q) return on(a, b, b == p ? q : p) || on(p, q, a);
    const auto side = [&](int u, int v, int w) { return turn(s_.points[u], s_.points[v], at(w, axes), axes); };
    const sign across = side(a, b, p) * side(a, b, q);
    if (across == sign::positive) return false;
    if (across == sign::negative && side(p, q, a) * side(p, q, b) == sign::negative) return true;
    return on(a, b, p) || on(a, b, q) || on(p, q, a) || on(p, q, b);
  }

  // The loop of one facet, swept along the longer of its axes.
  void check_loop(int f) {
    const auto& loop = s_.facets[f];
    const auto axes = projection(s_.normals[f]);
    const box all(points_, loop);
    const int along = all.hi[axes[0]] - all.lo[axes[0]] >= all.hi[axes[1]] - all.lo[axes[1]] ? axes[0] : axes[1];
    struct stretch {
      double lo, hi;
      int a, b;
    };
    std::vector<stretch> sides;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      sides.push_back({std::min(points_[a][along], points_[b][along]), std::max(points_[a][along], points_[b][along]), a, b});
    }
    std::sort(sides.begin(), sides.end(), [](const stretch& x, const stretch& y) { return std::tie(x.lo, x.a, x.b) < std::tie(y.lo, y.a, y.b); });
    for (auto x = sides.begin(); x != sides.end(); ++x)
      for (auto y = x + 1; y != sides.end() && y->lo <= x->hi; ++y)
        if (edges_meet(x->a, x->b, y->a, y->b, axes)) {
          found_ = bad_contact{kind::edge, f, x->a, x->b};
          return;
        }
  }

  // At a point that the loop passes more than once, nothing may lie between the edge it leaves by and, counter-clockwise, the
  // one it arrived by: then the inside's sectors are disjoint there. Together with the absence of crossings this makes the loop
  // the oriented boundary of one region; slits (edges run along in both directions) lie inside.
  void check_corners(int f) {
    const auto& loop = s_.facets[f];
    const auto axes = projection(s_.normals[f]);
    std::vector<int> visits(loop.size());
    std::iota(visits.begin(), visits.end(), 0);
    std::sort(visits.begin(), visits.end(), [&](int i, int j) { return loop[i] < loop[j]; });
    const int n = static_cast<int>(loop.size());
    for (int i = 0, j = 0; i < n; i = j) {
      const int v = loop[visits[i]];
      struct visits_by {
        int leaving = -1;
        int arriving = -1;
      };
      std::map<int, visits_by> ends;
      for (j = i; j < n && loop[visits[j]] == v; ++j) {
        ends[loop[(visits[j] + 1) % n]].leaving = j;
        ends[loop[(visits[j] + n - 1) % n]].arriving = j;
      }
      if (j == i + 1) continue;
      const auto direction = [&](int w) {
        return std::array<Int, 2>{s_.points[w][axes[0]] - s_.points[v][axes[0]], s_.points[w][axes[1]] - s_.points[v][axes[1]]};
      };
      std::vector<std::pair<int, visits_by>> order(ends.begin(), ends.end());
      std::sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
        const auto u = direction(x.first);
        const auto w = direction(y.first);
        const bool lower_u = u[1] < 0 || (u[1] == 0 && u[0] < 0);
        const bool lower_w = w[1] < 0 || (w[1] == 0 && w[0] < 0);
        return lower_u != lower_w ? lower_w : u[0] * w[1] > u[1] * w[0];
      });
      for (std::size_t k = 0; k < order.size(); ++k) {
        const int leaving = order[k].second.leaving;
        if (leaving >= 0 && order[(k + 1) % order.size()].second.arriving != leaving) found_ = bad_contact{kind::corner, f, v};
      }
    }
  }

  sign side(int p, int f) const { return is_corner(p, f) ? sign::zero : sign_of(Int(dot(s_.normals[f], s_.points[p]) - s_.offsets[f])); }

  bool meets(const edge& e, int f) const {
    if (e.facets[0] == f || e.facets[1] == f) return false;  // seen by check_loop
    const sign sa = side(e.a, f);
    const sign sb = side(e.b, f);
    if (sa == sb && sa != sign::zero) return false;
    const int touching = sa == sign::zero ? e.a : e.b;  // if one of them does
    if (sa * sb == sign::zero && sa != sb && is_corner(touching, f)) return false;
    const auto axes = projection(s_.normals[f]);
    if (sa != sign::zero && sb != sign::zero) {
      const auto height = [&](int p) -> Int {
        const Int h = dot(s_.normals[f], s_.points[p]) - s_.offsets[f];
        return h < 0 ? Int(-h) : h;
      };
      const Int wa = height(e.a);
      const Int wb = height(e.b);
      const auto mix = [&](int axis) -> Int { return s_.points[e.a][axis] * wb + s_.points[e.b][axis] * wa; };
      return where({mix(axes[0]), mix(axes[1]), wa + wb}, f, axes) != location::outside;
    }
    if (sa == sign::zero && sb == sign::zero) {
      const auto& loop = s_.facets[f];
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (edges_meet(e.a, e.b, loop[i], loop[(i + 1) % loop.size()], axes)) return true;
      return where(middle(e.a, e.b, axes), f, axes) != location::outside;
    }
    return where(at(touching, axes), f, axes) != location::outside;
  }

  void make_edges() {
    struct directed {
      int low, high, facet;
      bool operator<(const directed& o) const { return std::tie(low, high, facet) < std::tie(o.low, o.high, o.facet); }
    };
    std::vector<directed> all;
    for (int f = 0; f < static_cast<int>(s_.facets.size()); ++f) {
      const auto& loop = s_.facets[f];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
        all.push_back({low, high, f});
      }
    }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) edges_.push_back({all[i].low, all[i].high, {all[i].facet, all[i + 1].facet}});
  }

  void make_planes() {
    double reach = 0;
    for (const auto& p : points_)
      for (const double x : p) reach = std::max(reach, std::abs(x));
    for (std::size_t f = 0; f < s_.facets.size(); ++f) {
      unsigned shift = 0;
      for (const Int& x : s_.normals[f]) shift = std::max(shift, double_shift(x));
      auto& p = planes_.emplace_back();
      double greatest = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        p.n[axis] = static_cast<double>(Int(s_.normals[f][axis] >> shift));
        greatest = std::max(greatest, std::abs(p.n[axis]));
      }
      p.d = static_cast<double>(Int(s_.offsets[f] >> (shift + shift_)));
      p.error = greatest * reach * 1e-14;  // four conversions, six roundings: at most 20 ulp of this product
    }
  }

  // Edges against facets, by their boxes along the axis with the fewest overlaps.
  void sweep() {
    make_edges();
    make_planes();
    std::vector<box> facet_boxes;
    std::vector<box> edge_boxes;
    for (const auto& loop : s_.facets) facet_boxes.emplace_back(points_, loop);
    for (const edge& e : edges_) edge_boxes.emplace_back(points_, std::array<int, 2>{e.a, e.b});
    std::size_t axis = 0;
    std::size_t fewest = 0;
    for (std::size_t candidate = 0; candidate < 3; ++candidate) {
      std::vector<double> starts;
      for (const box& b : edge_boxes) starts.push_back(b.lo[candidate]);
      std::sort(starts.begin(), starts.end());
      std::size_t overlaps = 0;
      for (const box& b : edge_boxes)
        overlaps += static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), b.hi[candidate]) -
                                             std::lower_bound(starts.begin(), starts.end(), b.lo[candidate]));
      if (candidate > 0 && overlaps >= fewest) continue;
      axis = candidate;
      fewest = overlaps;
    }
    // All that most pairs need, in the order of the sweep.
    struct edge_item {
      box b;
      std::array<std::array<double, 3>, 2> ends;
      int id;
    };
    struct facet_item {
      box b;
      rough_plane plane;
      std::array<int, 3> corners;  // the first ones
      int id;
    };
    std::vector<edge_item> edges;
    std::vector<facet_item> facets;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      edges.push_back({edge_boxes[i], {points_[edges_[i].a], points_[edges_[i].b]}, static_cast<int>(i)});
    for (std::size_t f = 0; f < facet_boxes.size(); ++f) {
      const auto& loop = s_.facets[f];
      facets.push_back({facet_boxes[f], planes_[f], {loop[0], loop[1], loop[2]}, static_cast<int>(f)});
    }
    const auto by_start = [axis](const auto& x, const auto& y) { return std::tie(x.b.lo[axis], x.id) < std::tie(y.b.lo[axis], y.id); };
    std::sort(edges.begin(), edges.end(), by_start);
    std::sort(facets.begin(), facets.end(), by_start);
    const auto test = [&](const edge_item& e, const facet_item& f) {
      if (!e.b.overlaps(f.b)) return false;
      const sign sa = f.plane.side(e.ends[0]);
      const sign sb = f.plane.side(e.ends[1]);
      const edge& of = edges_[e.id];
      if (sa != sign::zero && sa == sb) return false;
      if (sa != sb && sa * sb == sign::zero) {  // an edge that leaves a corner of the facet
        const int p = sa == sign::zero ? of.a : of.b;
        if (p == f.corners[0] || p == f.corners[1] || p == f.corners[2]) return false;
      }
      if (!meets(of, f.id)) return false;
      found_ = bad_contact{kind::edge, f.id, of.a, of.b};
      return true;
    };
    // Of a pair that overlaps along the axis, one starts within the other.
    auto first_edge = edges.begin();
    for (const facet_item& f : facets) {
      while (first_edge != edges.end() && first_edge->b.lo[axis] < f.b.lo[axis]) ++first_edge;
      for (auto e = first_edge; e != edges.end() && e->b.lo[axis] <= f.b.hi[axis]; ++e)
        if (test(*e, f)) return;
    }
    auto first_facet = facets.begin();
    for (const edge_item& e : edges) {
      while (first_facet != facets.end() && first_facet->b.lo[axis] <= e.b.lo[axis]) ++first_facet;
      for (auto f = first_facet; f != facets.end() && f->b.lo[axis] <= e.b.hi[axis]; ++f)
        if (test(e, *f)) return;
    }
  }

  // Facets that pass through each other from one common corner to another, where no edge meets the other facet's inside.
  void check_chords() {
    std::vector<std::vector<int>> at_point(s_.points.size());
    const int n = static_cast<int>(s_.facets.size());
    for (int f = 0; f < n; ++f)
      if (s_.facets[f].size() > 3)
        for (const int p : s_.facets[f])
          if (at_point[p].empty() || at_point[p].back() != f) at_point[p].push_back(f);
    std::vector<std::pair<int, int>> met(s_.facets.size(), {-1, -1});  // the facet that met it last, and where first
    for (int f = 0; f < n; ++f) {
      if (s_.facets[f].size() == 3) continue;
      const auto axes = projection(s_.normals[f]);
      std::vector<std::pair<int, int>> common;  // with facet, corner
      for (const int p : s_.facets[f])
        for (auto g = std::upper_bound(at_point[p].begin(), at_point[p].end(), f); g != at_point[p].end(); ++g) {
          auto& [with, first] = met[*g];
          if (with == f && first != p) common.insert(common.end(), {{*g, first}, {*g, p}});
          if (with != f) met[*g] = {f, p};
        }
      std::sort(common.begin(), common.end(), [this](const auto& x, const auto& y) {
        return x.first != y.first ? x.first < y.first : s_.points[x.second] < s_.points[y.second];  // in order along the common line
      });
      common.erase(std::unique(common.begin(), common.end()), common.end());
      std::map<std::pair<int, int>, bool> inside;
      for (std::size_t i = 1; i < common.size(); ++i) {
        const auto [g, b] = common[i];
        if (common[i - 1].first != g) continue;
        const int a = common[i - 1].second;
        const auto within_g = [&, g = g, b = b] {
          const auto axes_g = projection(s_.normals[g]);
          return where(middle(a, b, axes_g), g, axes_g) == location::inside;
        };
        const bool small = s_.facets[g].size() < s_.facets[f].size();  // ask it first: most chords are edges
        if (small && !within_g()) continue;
        const auto [known, fresh] = inside.try_emplace({a, b});
        if (fresh) known->second = where(middle(a, b, axes), f, axes) == location::inside;
        if (known->second && (small || within_g())) {
          found_ = bad_contact{kind::chord, f, a, b, g};
          return;
        }
      }
    }
  }

  const surface_view<Int>& s_;
  unsigned shift_ = 0;
  std::vector<std::array<double, 3>> points_;
  std::vector<edge> edges_;
  std::vector<rough_plane> planes_;
  std::optional<bad_contact> found_;
};

}  // namespace detail

/// The first bad contact found, or nothing. Boxes are swept along an axis; doubles only decide what they are certain of. About
/// n log n plus the number of overlaps along that axis, those of boxes linear in their facet.
template <class Int>
std::optional<bad_contact> find_self_intersection(const surface_view<Int>& s) {
  return detail::intersection_search<Int>(s).run();
}

}  // namespace osteon
