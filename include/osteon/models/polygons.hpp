// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generated polygons with integer coordinates for tests, measurements and first steps.
///
/// All but those of touching_cells are simple: edges meet only in the vertex between neighbours.
/// Outer rings run counter-clockwise, holes clockwise; the interior is connected. Equal arguments
/// give equal polygons (to the last digit where the machine's sine and cosine agree). `n` is the
/// number of vertices, met exactly unless the function says otherwise; sizes below the stated least
/// one are taken as that one. Time and space are linear unless stated otherwise.

#include "osteon/input/exact_number.hpp"
#include "osteon/input/rings.hpp"
#include "osteon/models/cell_grid.hpp"
#include "osteon/models/hilbert.hpp"
#include "osteon/models/polygon_tools.hpp"
#include "osteon/models/random_polygons.hpp"
#include "osteon/models/regular_polygons.hpp"
#include "osteon/models/smooth_polygons.hpp"

namespace osteon::plane::models {

/// Returns a polygon as input of the library, unweighted, one part.
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

}  // namespace osteon::plane::models
