// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The JSON that the program writes and reads; docs/skeleton.schema.json and
/// docs/planar_skeleton.schema.json describe it.

#include <iosfwd>
#include <string>

#include "osteon/door/documents.hpp"

namespace osteon::app {

/// Writes the whole skeleton of a polyhedron, without loss. Exact numbers are strings; `time` and
/// `point` follow from the planes and are doubles, in the units of the input. Points and edges of
/// the solid go by the points' numbers in the input, from 1.
void write_document(std::ostream& out, const polyhedron_document& d);

/// Writes the whole skeleton of a polygon, without loss, one element a line. Exact numbers are
/// strings; `time` and `point` follow from the lines and are doubles, in the units of the input.
/// Edge i, face i and vertex i belong together, counted from 0.
void write_document(std::ostream& out, const polygon_document& d);

/// Reads what write_document writes. Whether the numbers make sense is not looked at
/// (osteon::verify does that), but all fit into their types. `name` is the file's. *Throws*
/// input_error(not_skeleton) naming the element where the text has another shape. *Complexity*:
/// linear.
polyhedron_document read_polyhedron_document(std::istream& in, const std::string& name);
/// The same for the skeleton of a polygon.
polygon_document read_polygon_document(std::istream& in, const std::string& name);

}  // namespace osteon::app
