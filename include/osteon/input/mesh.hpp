// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Points and facets as they come in, from memory or a file, exact and unchecked.

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"

namespace osteon {

/// A set of polygons in space: each facet lists its points, numbered from 0, counter-clockwise seen
/// from outside.
template <class Int>
struct input_mesh {
  std::vector<std::array<exact_number<Int>, 3>> points;
  std::vector<std::vector<int>> facets;
  std::vector<Int> weights;              ///< speed of each facet; empty for all 1
  std::vector<std::size_t> point_lines;  ///< lines of the file, or empty
  std::vector<std::size_t> facet_lines;  ///< lines of the file, or empty
  std::string file;                      ///< for messages; empty for memory

  /// Returns "FILE:12: facet 3", or "facet 3" for memory; counted from one.
  std::string name_facet(std::size_t f) const { return name("facet", f, facet_lines); }
  /// Returns "FILE:12: point 3", or "point 3" for memory; counted from one.
  std::string name_point(std::size_t p) const { return name("point", p, point_lines); }

  /// Throws input_error for a facet: its name, followed by `what`, and the hint.
  [[noreturn]] void refuse_facet(input_fault fault, std::size_t f, const std::string& what, const std::string& hint) const {
    throw input_error(fault, f + 1, name_facet(f) + what, hint);
  }
  /// Throws input_error for a point: its name, followed by `what`, and the hint.
  [[noreturn]] void refuse_point(input_fault fault, std::size_t p, const std::string& what, const std::string& hint) const {
    throw input_error(fault, p + 1, name_point(p) + what, hint);
  }

 private:
  std::string name(const char* kind, std::size_t i, const std::vector<std::size_t>& lines) const {
    std::string text = file;
    if (!text.empty() && i < lines.size()) text += ":" + std::to_string(lines[i]);
    if (!text.empty()) text += ": ";
    return text + kind + " " + std::to_string(i + 1);
  }
};

/// Returns a mesh from doubles, taken exactly.
/// *Throws* input_error(bad_number) for NaN and infinities.
template <class Int>
input_mesh<Int> make_input_mesh(const std::vector<std::array<double, 3>>& points, std::vector<std::vector<int>> facets) {
  input_mesh<Int> m;
  for (const auto& p : points) {
    auto& exact = m.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto x = from_double<Int>(p[axis]);
      if (!x) m.refuse_point(input_fault::bad_number, m.points.size() - 1, " has a coordinate that is not finite", "give finite coordinates");
      exact[axis] = *x;
    }
  }
  m.facets = std::move(facets);
  return m;
}

}  // namespace osteon
