// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The JSON of polygons' skeletons; docs/planar_skeleton.schema.json describes it.

#include <fmt/format.h>

#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "json_reader.hpp"
#include "osteon/kernel/planar_locate.hpp"
#include "planar.hpp"

namespace osteon::app {

inline constexpr const char* planar_format = "osteon planar skeleton 1";

/// How a skeleton came about.
struct planar_provenance {
  std::string kernel;
  bool outside = false;
};

/// Faces that are their own representatives.
inline int faces_of(const planar::skeleton& s) {
  int count = 0;
  for (std::size_t f = 0; f < s.faces.size(); ++f) count += s.faces[f] == static_cast<int>(f) ? 1 : 0;
  return count;
}

/// What a document says.
struct planar_file {
  planar_provenance by;
  std::vector<moving_line<integer>> lines;
  planar::outline outline;
  planar_skeletons skeletons;
};

}  // namespace osteon::app
