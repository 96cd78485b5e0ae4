// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From a mesh to a checked solid: planes for a kernel, incidences for the algorithms, and the way back to the input.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/self_intersection.hpp"
#include "osteon/space/boundary.hpp"

namespace osteon {

/// A checked solid. Coordinates are integers: input = (coordinate + shift) * 10^ten * 2^two.
template <class Int>
struct solid {
  std::vector<moving_plane<Int>> planes;
  osteon::boundary boundary;
  std::vector<vec<Int>> points;        ///< of the boundary's vertices
  std::vector<int> input_points;       ///< their numbers in the mesh, from 0
  std::vector<plane_id> facet_planes;  ///< by facet of the mesh
  int facets = 0;                      ///< after merging coplanar neighbours, components counted separately
  vec<Int> shift;
  int ten = 0;
  int two = 0;
};

/// Turns a mesh into a solid. Coplanar neighbours are merged, vertices of degree two removed, planes with equal
/// equation and weight share one number (design 04). Checks everything that design asks of a solid and throws
/// input_error naming the first fault, its element and the hint.
/// Cost: linear, but for sorting and the search for self-intersections (see find_self_intersection).
template <class Int>
class solid_builder {
 public:
  explicit solid_builder(input_mesh<Int> m) : m_(std::move(m)) {}

  solid<Int> build() {
    check_corners();
    scale_points();
    check_points();
    make_half_edges();
    make_planes();
    find_fans();
    check_self_intersections();
    check_orientation();
    check_touching_fans();
    make_boundary();
    return std::move(s_);
  }

  /// Reverses all facets.
  static void flip(input_mesh<Int>& m) {
    for (auto& f : m.facets) std::reverse(f.begin(), f.end());
  }

  /// Cuts every facet that is not planar into triangles (ears of its projection).
  static void triangulate(input_mesh<Int>& m) {
    solid_builder b(m);
    b.check_corners();
    b.scale_points();
    std::vector<std::vector<int>> facets;
    std::vector<std::size_t> lines;
    std::vector<Int> weights;
    for (std::size_t f = 0; f < m.facets.size(); ++f) {
      std::vector<std::vector<int>> pieces = {m.facets[f]};
      if (!b.is_planar(f)) pieces = b.ears(f);
      for (const auto& piece : pieces) {
        facets.push_back(piece);
        if (f < m.facet_lines.size()) lines.push_back(m.facet_lines[f]);
        if (f < m.weights.size()) weights.push_back(m.weights[f]);
      }
    }
    m.facets = std::move(facets);
    m.facet_lines = std::move(lines);
    m.weights = std::move(weights);
  }

 private:
  // A half-edge leads from its corner to the next one of its facet.
  struct half_edge {
    int from;
    int facet;
    int next;
    int previous;
    int twin;
  };

  [[noreturn]] void fail(input_fault fault, std::size_t element, const std::string& what, const std::string& hint) const {
    throw input_error(fault, element + 1, what, hint);
  }
  std::string edge_name(int a, int b) const { return "the edge between points " + std::to_string(a + 1) + " and " + std::to_string(b + 1); }

  void check_corners() const {
    if (m_.points.empty() || m_.facets.empty())
      throw input_error(input_fault::empty, 0, "there are no " + std::string(m_.points.empty() ? "points" : "facets"), "give points and facets");
    for (std::size_t f = 0; f < m_.facets.size(); ++f) {
      const auto& loop = m_.facets[f];
      if (loop.size() < 3)
        fail(input_fault::short_facet, f, m_.name_facet(f) + " has " + std::to_string(loop.size()) + " corners", "give at least three");
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i] < 0 || static_cast<std::size_t>(loop[i]) >= m_.points.size())
          fail(input_fault::bad_index, f,
               m_.name_facet(f) + " names point " + std::to_string(long{loop[i]} + 1) + " of " + std::to_string(m_.points.size()),
               "name a point that is there");
        if (loop[i] == loop[(i + 1) % loop.size()])
          fail(input_fault::repeated_corner, f, m_.name_facet(f) + " names point " + std::to_string(loop[i] + 1) + " twice in a row", "name it once");
      }
    }
    if (!m_.weights.empty() && m_.weights.size() != m_.facets.size())
      fail(input_fault::weight_not_positive, std::min(m_.weights.size(), m_.facets.size()),
           "there are " + std::to_string(m_.weights.size()) + " weights for " + std::to_string(m_.facets.size()) + " facets",
           "give every facet one weight, or none any");
    for (std::size_t f = 0; f < m_.weights.size(); ++f)
      if (m_.weights[f] <= 0)
        fail(input_fault::weight_not_positive, f, m_.name_facet(f) + " has a weight that is not positive", "give a weight greater than zero");
  }

  // Coordinates to integers with one common scale, moved to the middle of their box: that shortens offsets.
  void scale_points() {
    s_.ten = s_.two = 0;
    long most_ten = 0;
    long most_two = 0;
    std::size_t finest = 0;
    bool any = false;
    for (std::size_t i = 0; i < m_.points.size(); ++i)
      for (const auto& x : m_.points[i]) {
        if (x.mantissa == 0) continue;
        if (!any || x.ten < s_.ten || x.two < s_.two) finest = i;
        s_.ten = any ? std::min(s_.ten, x.ten) : x.ten;
        s_.two = any ? std::min(s_.two, x.two) : x.two;
        most_ten = any ? std::max(most_ten, long{x.ten}) : x.ten;
        most_two = any ? std::max(most_two, long{x.two}) : x.two;
        any = true;
      }
    const double bits = 3.33 * static_cast<double>(most_ten - s_.ten) + static_cast<double>(most_two - s_.two);
    if (bits > 1e5 || bits * 3 * static_cast<double>(m_.points.size()) > 4e9)  // half a gigabyte
      fail(input_fault::absurd_size, finest,
           m_.name_point(finest) + " has digits so fine that all coordinates together need " +
               std::to_string(static_cast<long>(bits * 3 * static_cast<double>(m_.points.size()) / 8e6)) + " MB",
           "round it");
    std::vector<Int> tens = {Int(1)};
    for (const auto& p : m_.points) {
      auto& q = points_.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& x = p[axis];
        if (x.mantissa == 0) continue;
        while (tens.size() <= static_cast<std::size_t>(x.ten - s_.ten)) tens.push_back(tens.back() * 10);
        q[axis] = (x.mantissa * tens[static_cast<std::size_t>(x.ten - s_.ten)]) << static_cast<unsigned>(x.two - s_.two);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lo, hi] = std::minmax_element(points_.begin(), points_.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      s_.shift[axis] = ((*lo)[axis] + (*hi)[axis]) / 2;
    }
    for (auto& p : points_) p = p - s_.shift;
    unsigned shift = 0;
    rough_ = detail::approximate<Int>(points_, shift);
  }

  void check_points() const {
    std::vector<int> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](int a, int b) { return points_[a] != points_[b] ? points_[a] < points_[b] : a < b; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (points_[order[i - 1]] == points_[order[i]])
        fail(input_fault::repeated_point, static_cast<std::size_t>(order[i]),
             m_.name_point(static_cast<std::size_t>(order[i])) + " is at the same place as point " + std::to_string(order[i - 1] + 1),
             "use one of them for both");
    std::vector<bool> used(points_.size());
    for (const auto& f : m_.facets)
      for (const int p : f) used[static_cast<std::size_t>(p)] = true;
    for (std::size_t p = 0; p < used.size(); ++p)
      if (!used[p]) fail(input_fault::unused_point, p, m_.name_point(p) + " is in no facet", "delete it");
  }

  void make_half_edges() {
    std::unordered_map<std::uint64_t, std::vector<int>> by_ends;  // undirected
    const auto key = [](int a, int b) { return static_cast<std::uint64_t>(std::min(a, b)) << 32U | static_cast<std::uint32_t>(std::max(a, b)); };
    for (std::size_t f = 0; f < m_.facets.size(); ++f) {
      const auto& loop = m_.facets[f];
      const int n = static_cast<int>(loop.size());
      const int first = static_cast<int>(half_edges_.size());
      for (int i = 0; i < n; ++i) {
        by_ends[key(loop[i], loop[(i + 1) % n])].push_back(first + i);
        half_edges_.push_back({loop[i], static_cast<int>(f), first + (i + 1) % n, first + (i + n - 1) % n, -1});
      }
    }
    for (int h = 0; h < static_cast<int>(half_edges_.size()); ++h) {
      if (half_edges_[h].twin >= 0) continue;
      const int a = half_edges_[h].from;
      const int b = half_edges_[half_edges_[h].next].from;
      const auto& both = by_ends[key(a, b)];
      const auto f = static_cast<std::size_t>(half_edges_[h].facet);
      if (both.size() == 1)
        fail(input_fault::not_closed, f, m_.name_facet(f) + ": " + edge_name(a, b) + " has no second facet, so the surface is not closed",
             "close the hole");
      if (both.size() > 2)
        fail(input_fault::non_manifold_edge, f, m_.name_facet(f) + ": " + edge_name(a, b) + " has " + std::to_string(both.size()) + " facets",
             "use separate points for the parts that touch there");
      const int other = both[0] == h ? both[1] : both[0];
      if (half_edges_[other].from == a)
        fail(input_fault::inconsistent, f,
             m_.name_facet(f) + ": " + edge_name(a, b) + " runs in the same direction in facet " + std::to_string(half_edges_[other].facet + 1),
             "reverse one of the two facets");
      half_edges_[h].twin = other;
      half_edges_[other].twin = h;
    }
  }

  vec<Int> area(std::size_t f) const { return area_vector<Int>(points_, m_.facets[f]); }

  bool is_planar(std::size_t f) const {
    const vec<Int> n = area(f);
    if (n == vec<Int>{Int(0), Int(0), Int(0)}) return true;
    const auto& loop = m_.facets[f];
    return std::all_of(loop.begin(), loop.end(), [&](int p) { return dot(n, points_[p]) == dot(n, points_[loop[0]]); });
  }

  void make_planes() {
    std::map<moving_plane<Int>, plane_id> ids;
    for (std::size_t f = 0; f < m_.facets.size(); ++f) {
      vec<Int> n = area(f);
      if (n == vec<Int>{Int(0), Int(0), Int(0)})
        fail(input_fault::zero_area, f, m_.name_facet(f) + " has area zero", "delete it and join its neighbours");
      Int divisor = n[0];
      for (const int axis : {1, 2}) divisor = gcd(divisor, n[axis]);
      for (Int& x : n) x /= divisor < 0 ? Int(-divisor) : divisor;
      const auto& loop = m_.facets[f];
      const Int d = dot(n, points_[loop[0]]);
      for (const int p : loop)
        if (dot(n, points_[p]) != d) fail_not_planar(f, n, d);
      const moving_plane<Int> plane{n, d, f < m_.weights.size() ? m_.weights[f] : Int(1)};
      const auto [at, fresh] = ids.emplace(plane, static_cast<plane_id>(s_.planes.size()));
      if (fresh) s_.planes.push_back(plane);
      s_.facet_planes.push_back(at->second);
    }
    for (const auto& h : half_edges_) {
      const auto& p = s_.planes[s_.facet_planes[h.facet]];
      const auto& q = s_.planes[s_.facet_planes[half_edges_[h.twin].facet]];
      const auto f = static_cast<std::size_t>(h.facet);
      const std::string pair = m_.name_facet(f) + " and facet " + std::to_string(half_edges_[h.twin].facet + 1);
      if (p.n == q.n && p.weight != q.weight)
        fail(input_fault::weight_conflict, f, pair + " lie in one plane but have different weights", "give both the same weight");
      if (p.n == vec<Int>{-q.n[0], -q.n[1], -q.n[2]}) fail(input_fault::folded, f, pair + " are folded onto each other", "delete both");
    }
  }

  static double log10_of(const Int& x) {
    const unsigned shift = detail::double_shift(x);
    return std::log10(static_cast<double>(Int(x >> shift))) + shift * std::log10(2.0);
  }

  [[noreturn]] void fail_not_planar(std::size_t f, const vec<Int>& n, const Int& d) const {
    Int farthest = 0;
    int worst = 0;
    for (const int p : m_.facets[f]) {
      Int away = dot(n, points_[p]) - d;
      if (away < 0) away = -away;
      if (away > farthest) {
        farthest = away;
        worst = p;
      }
    }
    // In logarithms: neither these numbers nor the distance need fit a double.
    const double distance = log10_of(farthest) - log10_of(Int(dot(n, n))) / 2 + s_.ten + s_.two * std::log10(2.0);
    const double exponent = std::abs(distance) < 300 ? 0 : std::floor(distance);
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), exponent == 0 ? "%.3g" : "%.3ge%.0f", std::pow(10.0, distance - exponent), exponent);
    fail(input_fault::not_planar, f, m_.name_facet(f) + " is not planar: point " + std::to_string(worst + 1) + " is off by " + text.data(),
         "give --triangulate to cut such facets");
  }

  // Ear clipping of the projected facet; what cannot be cut (self-intersecting) is left to the checks.
  std::vector<std::vector<int>> ears(std::size_t f) const {
    std::vector<int> loop = m_.facets[f];
    const auto axes = projection(area(f));
    const auto at = [&](int p) { return point2<Int>{points_[p][axes[0]], points_[p][axes[1]], Int(1)}; };
    std::vector<std::vector<int>> result;
    std::size_t start = 0;
    while (loop.size() > 3) {
      const std::size_t n = loop.size();
      std::size_t ear = n;
      for (std::size_t k = 0; k < n && ear == n; ++k) {
        const std::size_t i = (start + k) % n;
        const std::array<int, 3> t = {loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]};
        if (turn(points_[t[0]], points_[t[1]], at(t[2]), axes) != sign::positive) continue;
        const detail::box near(rough_, t);
        const bool empty = std::none_of(loop.begin(), loop.end(), [&](int p) {
          const auto& q = rough_[p];
          for (const int axis : axes)
            if (q[axis] < near.lo[axis] || q[axis] > near.hi[axis]) return false;
          return p != t[0] && p != t[1] && p != t[2] && locate_in_polygon<Int>(points_, t, at(p), axes) != location::outside;
        });
        if (empty) ear = i;
      }
      if (ear == n) break;
      result.push_back({loop[(ear + n - 1) % n], loop[ear], loop[(ear + 1) % n]});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
      start = ear;  // going on instead of starting anew keeps the time quadratic
    }
    result.push_back(loop);
    return result;
  }

  // The half-edges out of a point, counter-clockwise, starting with h.
  std::vector<int> fan(int h) const {
    std::vector<int> result;
    int g = h;
    do {
      result.push_back(g);
      g = half_edges_[half_edges_[g].previous].twin;
    } while (g != h);
    return result;
  }

  void find_fans() {
    fan_of_.assign(half_edges_.size(), -1);
    for (int h = 0; h < static_cast<int>(half_edges_.size()); ++h) {
      if (fan_of_[h] >= 0) continue;
      for (const int g : fan(h)) fan_of_[g] = static_cast<int>(fans_.size());
      fans_.push_back(h);
    }
  }

  // Where several fans meet in a point each must bound material of its own: as the facets move, the fans part. Two fans that bound the same
  // material (two voids that touch) would make a tunnel there.
  void check_touching_fans() const {
    std::map<int, std::vector<int>> at;  // the fans of a point
    for (const int h : fans_) at[half_edges_[h].from].push_back(h);
    for (const auto& [p, fans] : at)
      for (const int f : fans)
        for (const int g : fans)
          if (f != g && is_inside(f, g))
            fail(input_fault::non_manifold_vertex, static_cast<std::size_t>(p),
                 m_.name_point(static_cast<std::size_t>(p)) + " joins two fans of facets with material between them, a tunnel of no width",
                 "move one fan a little away, with a point of its own");
  }

  vec<Int> direction(int h) const { return points_[half_edges_[half_edges_[h].next].from] - points_[half_edges_[h].from]; }

  // Where a direction in the plane of half-edge h's facet lies: in the facet's angle at h's corner, on its border, or outside.
  location in_angle(int h, const vec<Int>& d) const {
    const vec<Int>& n = s_.planes[plane_of(h)].n;
    const vec<Int> a = direction(h);
    const vec<Int> b = points_[half_edges_[half_edges_[h].previous].from] - points_[half_edges_[h].from];
    const auto left = [&](const vec<Int>& x, const vec<Int>& y) { return sign_of(Int(dot(n, cross(x, y)))); };
    const bool convex = left(a, b) == sign::positive;
    const sign from_a = left(a, d);
    const sign to_b = left(d, b);
    if ((from_a == sign::zero && dot(a, d) > 0) || (to_b == sign::zero && dot(b, d) > 0)) return location::border;
    const bool inside = convex ? from_a == sign::positive && to_b == sign::positive : from_a == sign::positive || to_b == sign::positive;
    return inside ? location::inside : location::outside;
  }

  // Whether the fan of half-edge g starts on the inner side of the fan of half-edge f around the same point. Looks from g's direction straight at a
  // direction in a facet of f.
  bool is_inside(int f, int g) const {
    const std::vector<int> facets = fan(f);
    for (unsigned attempt = 1; attempt <= 64; ++attempt) {
      for (const int target : facets) {
        const vec<Int> turned = cross(s_.planes[plane_of(target)].n, direction(target));
        vec<Int> to = direction(target);
        for (std::size_t x = 0; x < 3; ++x) to[x] = to[x] * (Int(1) << 2 * attempt) + turned[x];
        if (in_angle(target, to) != location::inside) continue;
        const auto seen = sees_inside(facets, target, direction(g), to);
        if (seen) return *seen;
      }
    }
    return true;
  }

  // Whether the first facet passed on the way from one direction to another in the target facet is seen from inside; nothing where it is passed in an
  // edge.
  std::optional<bool> sees_inside(const std::vector<int>& facets, int target, const vec<Int>& from, const vec<Int>& to) const {
    sign side = sign_of(Int(dot(s_.planes[plane_of(target)].n, from)));
    if (side == sign::zero) return std::nullopt;
    Int done = 1;  // the way to the first facet as done / whole
    Int whole = 1;
    for (const int h : facets) {
      const vec<Int>& n = s_.planes[plane_of(h)].n;
      Int start = dot(n, from);
      Int end = dot(n, to);
      const sign here = sign_of(start);
      if (h == target || here * sign_of(end) != sign::negative) continue;
      if (start < 0) start = -start;
      if (end < 0) end = -end;
      vec<Int> hit;
      for (std::size_t x = 0; x < 3; ++x) hit[x] = from[x] * end + to[x] * start;
      const bool opposite = hit[0] == 0 && hit[1] == 0 && hit[2] == 0;
      const location where = in_angle(h, hit);
      if (opposite || where == location::border) return std::nullopt;
      if (where == location::inside && start * whole < done * (start + end)) {
        done = start;
        whole = start + end;
        side = here;
      }
    }
    return side == sign::negative;
  }

  void check_self_intersections() const {
    std::vector<vec<Int>> normals;
    std::vector<Int> offsets;
    for (const plane_id p : s_.facet_planes) {
      normals.push_back(s_.planes[p].n);
      offsets.push_back(s_.planes[p].d);
    }
    const auto bad = find_self_intersection<Int>({points_, m_.facets, normals, offsets});
    if (!bad) return;
    const auto f = static_cast<std::size_t>(bad->facet);
    const auto points = [&] { return "points " + std::to_string(bad->a + 1) + " and " + std::to_string(bad->b + 1); };
    switch (bad->what) {
      case bad_contact::kind::edge:
        fail(input_fault::self_intersection, f, m_.name_facet(f) + " is met by the edge between " + points(),
             "separate the two parts, or unite them into one surface");
      case bad_contact::kind::corner:
        fail(input_fault::self_intersection, f,
             m_.name_facet(f) + " passes point " + std::to_string(bad->a + 1) + " more than once and overlaps or turns over there",
             "run the outer loop counter-clockwise, holes clockwise, and slits to them inside the facet");
      case bad_contact::kind::chord:
        fail(input_fault::self_intersection, f,
             m_.name_facet(f) + " and facet " + std::to_string(bad->other + 1) + " pass through each other between " + points(),
             "separate them, or cut both along that line");
    }
  }

  // Every shell must enclose material if an even number of others encloses it, and a void otherwise.
  void check_orientation() const {
    std::vector<int> shell(m_.facets.size(), -1);
    std::vector<std::vector<int>> shells;
    for (std::size_t f = 0; f < shell.size(); ++f) {
      if (shell[f] >= 0) continue;
      std::vector<int> stack = {static_cast<int>(f)};
      shell[f] = static_cast<int>(shells.size());
      auto& members = shells.emplace_back();
      while (!stack.empty()) {
        const int g = stack.back();
        stack.pop_back();
        members.push_back(g);
        for (int h = first_half_edge(g), start = h;;) {
          const int next = half_edges_[half_edges_[h].twin].facet;
          if (shell[next] < 0) {
            shell[next] = shell[f];
            stack.push_back(next);
          }
          h = half_edges_[h].next;
          if (h == start) break;
        }
      }
    }
    std::vector<detail::box> boxes;
    for (const auto& members : shells) {
      std::vector<int> corners;
      for (const int f : members) corners.insert(corners.end(), m_.facets[f].begin(), m_.facets[f].end());
      boxes.emplace_back(rough_, corners);
    }
    std::vector<int> depth(shells.size());  // how many others enclose a shell
    std::vector<bool> passed(points_.size());
    for (std::size_t j = 0; j < shells.size(); ++j) {
      for (const int f : shells[j])
        for (const int p : m_.facets[f]) passed[p] = true;
      for (std::size_t i = 0; i < shells.size(); ++i) {
        if (i == j || !boxes[i].overlaps(boxes[j])) continue;
        const int p = point_beside(shells[i], passed);
        if (p < 0) {
          const auto f = static_cast<std::size_t>(shells[i][0]);
          fail(input_fault::non_manifold_vertex, f, m_.name_facet(f) + " belongs to a shell all points of which are points of another one",
               "move some of them a little away");
        }
        if (detail::box(rough_, std::span(&p, 1)).overlaps(boxes[j]) && encloses(shells[j], points_[p])) ++depth[i];
      }
      for (const int f : shells[j])
        for (const int p : m_.facets[f]) passed[p] = false;
    }
    std::size_t wrong = 0;
    std::size_t example = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
      Int volume = 0;
      for (const int f : shells[i]) volume += dot(area(static_cast<std::size_t>(f)), points_[m_.facets[f][0]]);
      if ((volume > 0) != (depth[i] % 2 == 0)) {
        ++wrong;
        example = static_cast<std::size_t>(shells[i][0]);
      }
    }
    if (wrong == shells.size())
      fail(input_fault::inverted, example, m_.name_facet(example) + " and all others are inside-out: their normals point inwards",
           "give --flip to reverse all facets");
    if (wrong > 0)
      fail(input_fault::inverted, example, m_.name_facet(example) + " and the shell it belongs to are inside-out",
           "reverse that shell: outer shells run counter-clockwise seen from outside, voids seen from inside");
  }

  // A point of a shell that another one does not pass; -1 where there is none.
  int point_beside(const std::vector<int>& shell, const std::vector<bool>& passed) const {
    for (const int f : shell) {
      const auto& loop = m_.facets[f];
      const auto found = std::find_if(loop.begin(), loop.end(), [&passed](int p) { return !passed[p]; });
      if (found != loop.end()) return *found;
    }
    return -1;
  }

  int first_half_edge(int f) const {
    if (facet_start_.empty()) {
      int h = 0;
      for (const auto& loop : m_.facets) {
        facet_start_.push_back(h);
        h += static_cast<int>(loop.size());
      }
    }
    return facet_start_[f];
  }

  // Parity of the crossings of a ray in a direction that meets no edge.
  bool encloses(const std::vector<int>& shell, const vec<Int>& p) const {
    for (int attempt = 1;; ++attempt) {
      const vec<Int> r = {Int(attempt * 97 + 4), Int(attempt * attempt + 10), Int(attempt * 31 - 17)};
      bool inside = false;
      bool clean = true;
      for (const int f : shell) {
        const auto& plane = s_.planes[s_.facet_planes[f]];
        Int speed = dot(plane.n, r);
        Int distance = plane.d - dot(plane.n, p);
        if (speed == 0) {
          clean = clean && distance != 0;
          continue;
        }
        if (speed < 0) {
          speed = -speed;
          distance = -distance;
        }
        if (distance <= 0) continue;
        const auto axes = projection(plane.n);
        const auto where = locate_in_polygon<Int>(
            points_, m_.facets[f], {p[axes[0]] * speed + r[axes[0]] * distance, p[axes[1]] * speed + r[axes[1]] * distance, speed}, axes);
        if (where == location::border) clean = false;
        if (where == location::inside) inside = !inside;
      }
      if (clean) return inside;
    }
  }

  plane_id plane_of(int h) const { return s_.facet_planes[half_edges_[h].facet]; }

  // Edges between different planes; where a fan has two of them they run on. Every other fan is a vertex.
  void make_boundary() {
    const auto n = fans_.size();
    std::vector<std::vector<int>> rays(n);  // half-edges out of each fan whose edge stays, counter-clockwise
    std::vector<int> vertex(n, -1);
    std::vector<std::size_t> order(n);  // of the points
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return half_edges_[fans_[a]].from < half_edges_[fans_[b]].from; });
    for (const std::size_t i : order) {
      for (const int h : fan(fans_[i]))
        if (plane_of(h) != plane_of(half_edges_[h].twin)) rays[i].push_back(h);
      if (rays[i].size() < 3) continue;
      vertex[i] = static_cast<int>(s_.points.size());
      s_.points.push_back(points_[half_edges_[fans_[i]].from]);
      s_.input_points.push_back(half_edges_[fans_[i]].from);
    }
    auto& b = s_.boundary;
    b.planes = static_cast<plane_id>(s_.planes.size());
    b.vertices.resize(s_.points.size());
    std::unordered_map<int, int> edge_of;  // by the half-edges out of its two vertices
    for (const std::size_t i : order) {
      if (vertex[i] < 0) continue;
      for (const int h : rays[i]) {
        if (!edge_of.contains(h)) {
          int last = h;  // the half-edge that arrives at the other vertex
          int q = fan_of_[half_edges_[last].next];
          while (vertex[q] < 0) {
            const int back = half_edges_[last].twin;
            last = rays[q][0] == back ? rays[q][1] : rays[q][0];
            q = fan_of_[half_edges_[last].next];
          }
          const int e = static_cast<int>(b.edges.size());
          const vec<Int> along = s_.points[vertex[q]] - s_.points[vertex[i]];
          const plane_id left = plane_of(h);
          const plane_id right = plane_of(half_edges_[h].twin);
          const bool convex = dot(along, cross(s_.planes[left].n, s_.planes[right].n)) > 0;
          b.edges.push_back({{vertex[i], vertex[q]}, {left, right}, convex});
          edge_of[h] = e;
          edge_of[half_edges_[last].twin] = e;
        }
        auto& v = b.vertices[vertex[i]];
        // The edge of h lies between the facet right of h, which comes first, and the one left of it.
        v.facets.push_back(plane_of(h));
        v.edges.push_back(edge_of[h]);
      }
      auto& v = b.vertices[vertex[i]];
      std::rotate(v.edges.begin(), v.edges.begin() + 1, v.edges.end());  // edges[m] between facets[m] and [m + 1]
    }
    count_facets();
  }

  void count_facets() {
    std::vector<int> parent(m_.facets.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int f) {
      while (parent[f] != f) f = parent[f] = parent[parent[f]];
      return f;
    };
    s_.facets = static_cast<int>(parent.size());
    for (const auto& h : half_edges_) {
      const int f = root(h.facet);
      const int g = root(half_edges_[h.twin].facet);
      if (f == g || s_.facet_planes[h.facet] != s_.facet_planes[half_edges_[h.twin].facet]) continue;
      parent[f] = g;
      --s_.facets;
    }
  }

  input_mesh<Int> m_;
  std::vector<vec<Int>> points_;
  std::vector<std::array<double, 3>> rough_;  // the points by a monotone function, for boxes
  std::vector<half_edge> half_edges_;
  std::vector<int> fans_;    // a half-edge out of each fan
  std::vector<int> fan_of_;  // by half-edge: the fan around its corner
  mutable std::vector<int> facet_start_;
  solid<Int> s_;
};

/// See solid_builder.
template <class Int>
solid<Int> make_solid(input_mesh<Int> m) {
  return solid_builder<Int>(std::move(m)).build();
}

}  // namespace osteon
