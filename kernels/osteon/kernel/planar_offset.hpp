// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offset polygons in numbers: many from one skeleton.

#include <array>
#include <cstddef>
#include <vector>

#include "osteon/error.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/planar_locate.hpp"
#include "osteon/planar/offset.hpp"
#include "osteon/planar/polygon.hpp"
#include "osteon/planar/skeleton.hpp"

namespace osteon::planar {

/// A polygon with holes, or several: in the units of the input.
template <class Number>
struct offset_polygon {
  struct ring {
    std::vector<std::array<Number, 2>> points;  ///< counter-clockwise, holes clockwise
    std::vector<int> edges;                     ///< of the polygon: the one (the first of those merged) whose line the edge from each point is on
    bool hole;
    int part;  ///< connected piece of the interior
  };
  std::vector<ring> rings;  ///< those of a part together, its outer ring first
  int parts = 0;
};

/// Offsets of a polygon inwards. Time is the distance that an edge of weight 1 has moved, in the units of the input. Keeps references to its
/// arguments. Setup: linear.
class offsets {
 public:
  offsets(const polygon<integer>& p, const skeleton& raw) : polygon_(p), raw_(raw), lines_(p.lines, p.points), places_(p, lines_) {}

  /// Rings as numbers of arcs. Throws input_error for a negative time. Cost: see wavefront_at.
  wavefront_rings wavefront(const rational& time) const {
    if (time < 0) throw input_error(input_fault::bad_number, 0, "an offset at a negative time", "give a time of zero or more");
    return wavefront_at(raw_, polygon_.outline.line, instant(polygon_.lines, lines_, places_.unit().to_integers(time)));
  }

  /// With points as doubles, correct to a few units in the last place relative to the polygon's size: edges shorter than that may come to nothing.
  offset_polygon<double> at(const rational& time) const {
    const rational t = places_.unit().to_integers(time);
    const double_double scaled = places_.scaled(t);
    return fill<double>(time, [&](line_id a, line_id b) { return places_.vertex_at(a, b, t, scaled); });
  }

  /// With points as rationals, coordinates within 2^-bits of the polygon's integer unit 10^ten 2^two.
  offset_polygon<rational> exactly_at(const rational& time, unsigned bits = 64) const {
    const rational t = places_.unit().to_integers(time);
    const locator exact(polygon_.lines);
    return fill<rational>(time, [&](line_id a, line_id b) { return places_.unit().to_input(exact.vertex_at(a, b, t, bits)); });
  }

  /// The places and times of nodes.
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
        const line_id a = polygon_.outline.line[arc.faces[0]];
        const line_id b = polygon_.outline.line[arc.faces[1]];
        to.points.push_back(place(a, b));
        to.edges.push_back(w.corners[i].face);
      }
    }
    return result;
  }

  const polygon<integer>& polygon_;
  const skeleton& raw_;
  unit_lines lines_;
  fast_locator places_;
};

}  // namespace osteon::planar
