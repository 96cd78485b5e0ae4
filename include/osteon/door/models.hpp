// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generated models: solids and polygons to play with, the same ones for the same numbers.

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace osteon {

/// A kind of generated models.
struct model_kind {
  std::string name;
  std::string size;  ///< what the size means
  int default_size;
  int least_size;
  int greatest_size;
  bool is_polygon;
};

/// Returns all kinds, polyhedra first.
const std::vector<model_kind>& model_kinds();

/// Writes the model of a kind, a size and a seed: a polyhedron as Wavefront OBJ, a polygon as .xy
/// text. *Throws* input_error(bad_index) where there is no such kind, input_error(absurd_size)
/// where the kind has no such size.
void write_model(std::ostream& out, std::string_view kind, int size, std::uint64_t seed = 1);

}  // namespace osteon
