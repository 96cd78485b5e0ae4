// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads polygons in any format: lines of points (.xy), well-known text, GeoJSON and OBJ, decimals
/// exactly.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

#include "osteon/core/error.hpp"
#include "osteon/input/guess_format.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/read_geojson.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/read_wkt.hpp"
#include "osteon/input/read_xy.hpp"
#include "osteon/input/rewound.hpp"
#include "osteon/input/rings.hpp"

namespace osteon::plane {

/// What a text of unknown format must be, for hints.
inline constexpr const char* polygon_formats =
    "lines of points x y, well-known text (POLYGON or MULTIPOLYGON), GeoJSON, or an OBJ file with one facet";

/// Reads OBJ with one facet in a plane z = constant. `name` of the text is for messages.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
rings<Int> read_flat_obj(std::istream& in, const std::string& name) {
  input_mesh<Int> m = read_obj<Int>(in, name);
  if (m.facets.size() != 1)
    m.refuse_facet(input_fault::not_polygon, 1, " is one of " + std::to_string(m.facets.size()) + ", and a polygon has only one",
                   "give an OBJ file with one facet, or the polygon in another format");
  rings<Int> result;
  result.file = name;
  auto& r = result.all.emplace_back();
  for (const int p : m.facets[0]) {
    const auto i = static_cast<std::size_t>(p);
    if (i >= m.points.size())
      m.refuse_facet(input_fault::bad_index, 0, " names point " + std::to_string(i + 1) + " of " + std::to_string(m.points.size()),
                     "name a point that is there");
    if (m.points[i][2] != m.points[static_cast<std::size_t>(m.facets[0][0])][2])
      m.refuse_point(input_fault::not_planar, i, " is not as high as point " + std::to_string(m.facets[0][0] + 1),
                     "give all points of the facet the same z");
    r.points.push_back({m.points[i][0], m.points[i][1]});
    r.lines.push_back(m.point_lines[i]);
  }
  return result;
}

/// Reads a polygon in the format that guess_format tells from `name`, which is that of the file and
/// for messages, and from the beginning of the text.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
rings<Int> read_polygon(std::istream& in, const std::string& name) {
  rewound text(in, name);
  const bool named = format_of_name(name).has_value();
  if (const auto rest = skip_blanks_and_comments(text.beginning()); !named && !rest.empty() && !format_of_text(rest))
    throw input_error(input_fault::not_polygon, 0, name + ": " + quote(rest.substr(0, rest.find_first_of(" \t\r\n"))) + " begins no polygon",
                      std::string("give ") + polygon_formats);
  switch (guess_format(name, text.beginning())) {
    case format::wkt:
      return named ? read_wkt<Int>(text.stream(), name) : read_wkt<Int>(text.stream(), name, polygon_formats);
    case format::geojson:
      return read_geojson<Int>(text.stream(), name);
    case format::obj:
      return read_flat_obj<Int>(text.stream(), name);
    case format::xy:
      break;
  }
  return named ? read_xy<Int>(text.stream(), name) : read_xy<Int>(text.stream(), name, polygon_formats);
}

}  // namespace osteon::plane
