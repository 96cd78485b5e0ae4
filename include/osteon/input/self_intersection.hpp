// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Finds where a closed surface meets itself although it must not, exactly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/facet_chords.hpp"
#include "osteon/input/facet_loops.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/projected_facet.hpp"
#include "osteon/input/rough_points.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

namespace detail {

/// The search for edges that meet facets. Boxes are swept along one axis; doubles decide only what
/// they are certain of.
template <class Int>
class edge_facet_search {
 public:
  /// *Requires* a surface with planes, each facet of which is the boundary of one region.
  explicit edge_facet_search(const surface<Int>& s) : s_(s) {
    make_edges();
    make_boxes();
    make_items();
  }

  /// Returns an edge that meets a facet outside of their common corners and edges, or nothing.
  std::optional<bad_contact> run() const {
    // Of a pair that overlaps along the axis, one starts within the other.
    auto first_edge = edge_items_.begin();
    for (const facet_item& f : facet_items_) {
      while (first_edge != edge_items_.end() && first_edge->b.lo[axis_] < f.b.lo[axis_]) ++first_edge;
      for (auto e = first_edge; e != edge_items_.end() && e->b.lo[axis_] <= f.b.hi[axis_]; ++e)
        if (meets(*e, f)) return contact(*e, f);
    }
    auto first_facet = facet_items_.begin();
    for (const edge_item& e : edge_items_) {
      while (first_facet != facet_items_.end() && first_facet->b.lo[axis_] <= e.b.lo[axis_]) ++first_facet;
      for (auto f = first_facet; f != facet_items_.end() && f->b.lo[axis_] <= e.b.hi[axis_]; ++f)
        if (meets(e, *f)) return contact(e, *f);
    }
    return std::nullopt;
  }

 private:
  struct edge {
    int a, b;
    std::array<int, 2> facets;
  };
  // A facet's plane in doubles: the side of a point farther away than `error` is certain, else
  // zero.
  struct rough_plane {
    std::array<double, 3> n;
    double d;
    double error;

    sign side(const std::array<double, 3>& x) const {
      const double h = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
      return h > error ? sign::positive : (h < -error ? sign::negative : sign::zero);
    }
  };
  // All that most pairs need, in the order of the sweep.
  struct edge_item {
    box3 b;
    std::array<std::array<double, 3>, 2> ends;
    int id;
  };
  struct facet_item {
    box3 b;
    rough_plane plane;
    std::array<int, 3> corners;  // the first ones
    int id;
  };

  int facets() const { return static_cast<int>(s_.input.facets.size()); }
  const std::vector<int>& loop(int f) const { return s_.loop(static_cast<std::size_t>(f)); }

  void make_edges() {
    struct directed {
      int low, high, facet;
      bool operator<(const directed& o) const { return std::tie(low, high, facet) < std::tie(o.low, o.high, o.facet); }
    };
    std::vector<directed> all;
    for (int f = 0; f < facets(); ++f)
      for (std::size_t i = 0; i < loop(f).size(); ++i) {
        const auto [low, high] = std::minmax({loop(f)[i], loop(f)[(i + 1) % loop(f).size()]});
        all.push_back({low, high, f});
      }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) edges_.push_back({all[i].low, all[i].high, {all[i].facet, all[i + 1].facet}});
  }

  void make_boxes() {
    for (int f = 0; f < facets(); ++f) facet_boxes_.emplace_back(s_.rough, loop(f));
    for (const edge& e : edges_) edge_boxes_.emplace_back(s_.rough, std::array<int, 2>{e.a, e.b});
    std::size_t fewest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t overlaps = overlaps_along(axis);
      if (axis > 0 && overlaps >= fewest) continue;
      axis_ = axis;
      fewest = overlaps;
    }
  }

  // How many pairs of edges overlap along an axis, about.
  std::size_t overlaps_along(std::size_t axis) const {
    std::vector<double> starts;
    starts.reserve(edge_boxes_.size());
    for (const box3& b : edge_boxes_) starts.push_back(b.lo[axis]);
    std::sort(starts.begin(), starts.end());
    std::size_t overlaps = 0;
    for (const box3& b : edge_boxes_)
      overlaps += static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), b.hi[axis]) -
                                           std::lower_bound(starts.begin(), starts.end(), b.lo[axis]));
    return overlaps;
  }

  void make_items() {
    double reach = 0;
    for (const auto& p : s_.rough)
      for (const double x : p) reach = std::max(reach, std::abs(x));
    for (std::size_t i = 0; i < edges_.size(); ++i)
      edge_items_.push_back({edge_boxes_[i], {s_.rough[edges_[i].a], s_.rough[edges_[i].b]}, static_cast<int>(i)});
    for (int f = 0; f < facets(); ++f) facet_items_.push_back({facet_boxes_[f], rough_plane_of(f, reach), {loop(f)[0], loop(f)[1], loop(f)[2]}, f});
    const auto by_start = [this](const auto& x, const auto& y) { return std::tie(x.b.lo[axis_], x.id) < std::tie(y.b.lo[axis_], y.id); };
    std::sort(edge_items_.begin(), edge_items_.end(), by_start);
    std::sort(facet_items_.begin(), facet_items_.end(), by_start);
  }

  rough_plane rough_plane_of(int f, double reach) const {
    const auto& exact = s_.plane(static_cast<std::size_t>(f));
    unsigned shift = 0;
    for (const Int& x : exact.n) shift = std::max(shift, double_shift(x));
    rough_plane p{};
    double greatest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p.n[axis] = static_cast<double>(Int(exact.n[axis] >> shift));
      greatest = std::max(greatest, std::abs(p.n[axis]));
    }
    p.d = static_cast<double>(Int(exact.d >> (shift + s_.rough_shift)));
    // four conversions, six roundings: at most 20 ulp of this product
    p.error = greatest * reach * 1e-14;
    return p;
  }

  bool meets(const edge_item& e, const facet_item& f) const {
    if (!e.b.overlaps(f.b)) return false;
    const sign sa = f.plane.side(e.ends[0]);
    const sign sb = f.plane.side(e.ends[1]);
    const edge& of = edges_[e.id];
    if (sa != sign::zero && sa == sb) return false;
    if (sa != sb && sa * sb == sign::zero) {  // an edge that leaves a corner of the facet
      const int p = sa == sign::zero ? of.a : of.b;
      if (p == f.corners[0] || p == f.corners[1] || p == f.corners[2]) return false;
    }
    return meets(of, f.id);
  }
  bad_contact contact(const edge_item& e, const facet_item& f) const { return {bad_contact::kind::edge, f.id, edges_[e.id].a, edges_[e.id].b}; }

  bool is_corner(int p, int f) const { return std::find(loop(f).begin(), loop(f).end(), p) != loop(f).end(); }
  Int height(int p, int f) const {
    const auto& plane = s_.plane(static_cast<std::size_t>(f));
    return dot(plane.n, s_.points[p]) - plane.d;
  }
  sign side(int p, int f) const { return is_corner(p, f) ? sign::zero : sign_of(height(p, f)); }

  bool meets(const edge& e, int f) const {
    // find_fault_of_loop has looked at these
    if (e.facets[0] == f || e.facets[1] == f) return false;
    const sign sa = side(e.a, f);
    const sign sb = side(e.b, f);
    if (sa == sb && sa != sign::zero) return false;
    const int touching = sa == sign::zero ? e.a : e.b;  // if one of them does
    if (sa * sb == sign::zero && sa != sb && is_corner(touching, f)) return false;
    const projected_facet<Int> facet(s_, f);
    if (sa != sign::zero && sb != sign::zero) return facet.locate(crossing(e, f, facet.axes())) != location::outside;
    if (sa != sign::zero || sb != sign::zero) return facet.locate(facet.at(touching)) != location::outside;
    for (std::size_t i = 0; i < loop(f).size(); ++i)
      if (facet.edges_meet(e.a, e.b, loop(f)[i], loop(f)[(i + 1) % loop(f).size()])) return true;
    return facet.locate_middle(e.a, e.b) != location::outside;
  }

  // Where an edge with ends on both sides crosses the plane of a facet.
  point2<Int> crossing(const edge& e, int f, const std::array<int, 2>& axes) const {
    const auto distance = [&](int p) -> Int {
      const Int h = height(p, f);
      return h < 0 ? Int(-h) : h;
    };
    const Int wa = distance(e.a);
    const Int wb = distance(e.b);
    const auto mix = [&](int axis) -> Int { return s_.points[e.a][axis] * wb + s_.points[e.b][axis] * wa; };
    return {mix(axes[0]), mix(axes[1]), wa + wb};
  }

  const surface<Int>& s_;
  std::vector<edge> edges_;
  std::vector<box3> edge_boxes_;
  std::vector<box3> facet_boxes_;
  std::size_t axis_ = 0;  // with the fewest overlaps
  std::vector<edge_item> edge_items_;
  std::vector<facet_item> facet_items_;
};

}  // namespace detail

/// Returns a place where a surface meets itself although it must not, or nothing. Facets may have
/// points in common, and edges with those next to them.
/// *Requires* a surface with planes, of whose edges each belongs to two facets, once in each
/// direction.
/// *Complexity* about n log n plus the number of overlaps along the best axis of edges' and facets'
/// boxes, of which those of overlapping boxes are linear in their facet.
template <class Int>
std::optional<bad_contact> find_self_intersection(const surface<Int>& s) {
  for (int f = 0; f < static_cast<int>(s.input.facets.size()); ++f)
    if (const auto found = find_fault_of_loop(s, f)) return found;
  if (const auto found = detail::edge_facet_search<Int>(s).run()) return found;
  return chord_search<Int>(s).run();
}

/// Checks that a surface does not meet itself where it must not (see find_self_intersection).
/// *Throws* input_error(self_intersection).
template <class Int>
void check_self_intersection(const surface<Int>& s) {
  const auto bad = find_self_intersection(s);
  if (!bad) return;
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    s.input.refuse_facet(input_fault::self_intersection, static_cast<std::size_t>(bad->facet), what, hint);
  };
  const auto points = [&] { return "points " + std::to_string(bad->a + 1) + " and " + std::to_string(bad->b + 1); };
  switch (bad->what) {
    case bad_contact::kind::edge:
      return refuse(" is met by the edge between " + points(), "separate the two parts, or unite them into one surface");
    case bad_contact::kind::corner:
      return refuse(" passes point " + std::to_string(bad->a + 1) + " more than once and overlaps or turns over there",
                    "run the outer loop counter-clockwise, holes clockwise, and slits to them inside the facet");
    case bad_contact::kind::chord:
      return refuse(" and facet " + std::to_string(bad->other + 1) + " pass through each other between " + points(),
                    "separate them, or cut both along that line");
  }
}

}  // namespace osteon
