// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Surfaces as the door hands them out.

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

namespace osteon {

/// What a facet of a mesh is.
enum class facet_kind : std::uint8_t { solid, roof, wall, floor };

/// A closed surface: every edge belongs to two facets, which run along it in opposite directions.
/// Facets are counter-clockwise seen from outside. A mesh without facets is the surface of nothing.
struct mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>> facets;  ///< numbers of points
  /// By facet, where it comes from. Of an offset: a facet of the input (the first of those in one
  /// plane). Of a roof: the edge of the polygon whose roof or wall it is (the first of those whose
  /// faces merge), -1 for a floor.
  std::vector<int> source;
  std::vector<facet_kind> kinds;  ///< by facet
};

/// Writes a mesh as Wavefront OBJ; the facets of a roof in the groups roof, walls and floor.
/// Doubles are read back the same.
void write_obj(std::ostream& out, const mesh& m);

}  // namespace osteon
