// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The errors of the library. Bad input is a typed value that names the element and the hint;
/// a kernel that cannot decide is an error of its own; a broken invariant names itself.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace osteon {

/// Base of all errors that this library throws.
struct error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What can be wrong with a solid or a polygon, or with the file it comes from.
enum class input_fault : std::uint8_t {
  unreadable,           ///< the file cannot be opened or read
  empty,                ///< no points or no facets
  not_obj,              ///< a line that no OBJ file has
  bad_number,           ///< a coordinate that is no finite decimal number
  absurd_size,          ///< a number, line or count beyond the stated limits
  bad_index,            ///< a facet names a point that is not there
  short_facet,          ///< a facet with fewer than three corners
  repeated_corner,      ///< a facet names the same point twice in a row
  repeated_point,       ///< two points with the same coordinates
  unused_point,         ///< a point in no facet
  not_closed,           ///< an edge with one facet
  non_manifold_edge,    ///< an edge with three or more facets
  inconsistent,         ///< two facets run along an edge in the same direction
  inverted,             ///< all normals point inwards, or a void is wound like a body
  zero_area,            ///< a facet of area zero
  not_planar,           ///< a facet whose points do not lie in one plane
  folded,               ///< two facets that meet at an angle of zero
  non_manifold_vertex,  ///< two fans of facets share only a point and have material between them
  self_intersection,    ///< two facets meet where they should not
  weight_not_positive,  ///< the weight of a facet is not greater than zero
  weight_conflict,      ///< adjacent coplanar facets with different weights
  not_skeleton,         ///< a text that is no skeleton document
  not_polygon,          ///< a text or geometry that is no polygon
  short_ring,           ///< a ring with fewer than three different points
  spike,                ///< a boundary that turns back on itself
  pinched,              ///< a polygon whose interior falls apart where its boundary touches itself
  /// a hole that is not directly inside its outer ring, or a part inside another part
  misplaced_ring,
  bad_weight  ///< the weight of an edge is less than zero, or missing
};

/// The input is not a solid or polygon. `element` is the point's, facet's or line's number, counted
/// from one, or 0.
struct input_error : error {
  input_error(input_fault f, std::size_t number, const std::string& what, std::string remedy)
      : error(what + "; hint: " + remedy), fault(f), element(number), hint(std::move(remedy)) {}
  input_fault fault;
  std::size_t element;
  std::string hint;
};

/// The solid is valid, but this version cannot take it. Names the vertex or planes.
struct unsupported_error : error {
  using error::error;
};

/// The planes are in special position and the kernel has no way to break the tie.
struct degenerate_error : unsupported_error {
  explicit degenerate_error(std::vector<std::int32_t> ids, const std::string& question)
      : unsupported_error(describe(ids, question)), planes(std::move(ids)) {}
  std::vector<std::int32_t> planes;

 private:
  static std::string describe(const std::vector<std::int32_t>& ids, const std::string& question) {
    std::string text = "degenerate, not yet: " + question + " is zero for planes";
    for (auto id : ids) text += ' ' + std::to_string(id);
    return text + "; use a perturbed kernel";
  }
};

/// The kernel contradicted itself or could not decide (only kernels that are not exact).
struct undecided_error : error {
  using error::error;
};

/// An internal invariant does not hold although the kernel is exact: a defect of this library.
struct invariant_error : error {
  using error::error;
};

/// Reports a broken invariant: the kernel's fault where it is not exact, else ours.
template <class K>
[[noreturn]] void broken_invariant(const std::string& name) {
  if constexpr (K::exact) throw invariant_error("internal invariant violated: " + name);
  throw undecided_error("the kernel's answers contradict each other (" + name + "); hint: use an exact kernel");
}

}  // namespace osteon
