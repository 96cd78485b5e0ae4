// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offset polygons in numbers: many from one skeleton.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/evaluate/input_scale.hpp"
#include "osteon/evaluate/lines_at_time.hpp"
#include "osteon/evaluate/locate.hpp"
#include "osteon/evaluate/meeting.hpp"
#include "osteon/evaluate/triangulate.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/plane/offset.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// A polygon with holes, or several: in the units of the input.
template <class Number>
struct offset_polygon {
  /// A closed line, the interior on its left.
  struct ring {
    std::vector<std::array<Number, 2>> points;  ///< counter-clockwise, holes clockwise
    /// By point: the edge of the polygon on whose line the edge that starts there lies; of edges
    /// that have merged, the first one.
    std::vector<int> edges;
    bool hole;
    int part;  ///< connected piece of the interior
  };
  std::vector<ring> rings;  ///< those of a part together, its outer ring first
  int parts = 0;
};

namespace detail {

/// Gives each hole of a part without an outer ring to the smallest outer ring that contains it, and
/// numbers the parts anew. Outer rings may be nested, but do not cross.
template <class Number>
void place_holes(offset_polygon<Number>& p) {
  std::vector<bool> has_outer(p.parts, false);
  for (const auto& r : p.rings)
    if (!r.hole) has_outer[r.part] = true;
  if (std::find(has_outer.begin(), has_outer.end(), false) == has_outer.end()) return;
  struct outer {
    std::vector<flat_point> points;
    flat_point low, high;
    int part;
  };
  const auto flat = [](const std::array<Number, 2>& q) { return flat_point{static_cast<double>(q[0]), static_cast<double>(q[1])}; };
  std::vector<outer> all;
  for (const auto& r : p.rings) {
    if (r.hole) continue;
    auto& o = all.emplace_back();
    o.part = r.part;
    o.low = o.high = flat(r.points[0]);
    for (const auto& q : r.points) {
      o.points.push_back(flat(q));
      for (std::size_t axis = 0; axis < 2; ++axis) {
        o.low[axis] = std::min(o.low[axis], o.points.back()[axis]);
        o.high[axis] = std::max(o.high[axis], o.points.back()[axis]);
      }
    }
  }
  std::sort(all.begin(), all.end(), [](const outer& a, const outer& b) { return a.high[0] - a.low[0] < b.high[0] - b.low[0]; });
  std::vector<int> into(p.parts);
  std::iota(into.begin(), into.end(), 0);
  for (const auto& r : p.rings) {
    if (has_outer[r.part] || into[r.part] != r.part) continue;
    const flat_point q = flat(r.points[0]);
    const auto around = std::find_if(all.begin(), all.end(), [&](const outer& o) {
      return o.low[0] <= q[0] && q[0] <= o.high[0] && o.low[1] <= q[1] && q[1] <= o.high[1] && is_inside(o.points, q);
    });
    if (around != all.end()) into[r.part] = around->part;
  }
  std::vector<int> number(p.parts, -1);
  p.parts = 0;
  for (auto& r : p.rings) {
    int& n = number[into[r.part]];
    if (n < 0) n = p.parts++;
    r.part = n;
  }
  std::stable_sort(p.rings.begin(), p.rings.end(),
                   [](const auto& r, const auto& s) { return std::pair(r.part, r.hole) < std::pair(s.part, s.hole); });
}

}  // namespace detail

/// Returns the polygon with its rings turned round. What an offset of the outside of a polygon (see
/// make_polygon) has left out is the grown polygon; this is it. There edge i lies on the line of
/// the edge that ends, not starts, at vertex i of the polygon.
template <class Number>
offset_polygon<Number> complement(offset_polygon<Number> p) {
  p.parts = 0;
  for (auto& r : p.rings) {
    std::reverse(r.points.begin(), r.points.end());
    std::reverse(r.edges.begin(), r.edges.end());
    std::rotate(r.edges.begin(), r.edges.begin() + 1, r.edges.end());
    r.hole = !r.hole;
    r.part = p.parts++;
  }
  detail::place_holes(p);
  return p;
}

/// The offsets of a polygon inwards; of the outside of one, outwards. Times are distances that an
/// edge of weight 1 has moved, in the units of the input. Keeps references to its arguments.
/// *Complexity* linear to make; then see wavefront_at.
class offsets {
 public:
  offsets(const polygon<integer>& p, const skeleton& raw) : polygon_(p), raw_(raw), places_(p) {}

  /// Returns the wavefront at a time as rings of arcs.
  /// *Throws* input_error for a negative time.
  wavefront_rings wavefront(const rational& time) const {
    if (time < 0) throw input_error(input_fault::bad_number, 0, "an offset at a negative time", "give a time of zero or more");
    return wavefront_at(raw_, polygon_.boundary.line, lines_at_time(polygon_.lines, places_.lines(), places_.unit().to_integers(time)));
  }

  /// Returns the offset with points as doubles, correct to a few units in the last place relative
  /// to the polygon's size. Edges shorter than that may come to nothing.
  /// *Throws* input_error for a negative time.
  offset_polygon<double> at(const rational& time) const {
    const rational t = places_.unit().to_integers(time);
    const double_double scaled = places_.scaled(t);
    return fill<double>(time, [&](line_id a, line_id b) { return places_.vertex_at(a, b, t, scaled); });
  }

  /// Returns the offset with points as rationals, coordinates within 2^-bits of the polygon's
  /// integer unit 10^ten 2^two.
  /// *Throws* input_error for a negative time.
  offset_polygon<rational> exactly_at(const rational& time, unsigned bits = 64) const {
    const rational t = places_.unit().to_integers(time);
    const locator exact(polygon_.lines);
    return fill<rational>(time, [&](line_id a, line_id b) { return places_.unit().to_input(exact.vertex_at({a, b}, t, bits)); });
  }

  /// Returns what finds the places and times of nodes.
  const fast_locator& places() const { return places_; }

 private:
  template <class Number, class Place>
  offset_polygon<Number> fill(const rational& time, Place place) const {
    const wavefront_rings w = wavefront(time);
    offset_polygon<Number> result;
    result.parts = w.parts;
    for (const auto& r : w.rings) {
      auto& to = result.rings.emplace_back();
      to.hole = r.hole;
      to.part = r.part;
      for (int i = r.first; i < r.first + r.size; ++i) {
        const auto& arc = raw_.arcs[w.corners[i].arc];
        const line_id a = polygon_.boundary.line[arc.faces[0]];
        const line_id b = polygon_.boundary.line[arc.faces[1]];
        to.points.push_back(place(a, b));
        to.edges.push_back(w.corners[i].face);
      }
    }
    detail::place_holes(result);
    return result;
  }

  const polygon<integer>& polygon_;
  const skeleton& raw_;
  fast_locator places_;
};

}  // namespace osteon::plane
