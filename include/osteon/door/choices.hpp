// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The choices that polygons and polyhedra share, the classes of events, and what a refused
/// certificate says.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace osteon {

/// The numbers that decide. All results say in doubles where things are; the kernel decides what
/// there is.
enum class number_kernel : std::uint8_t {
  sqrt,      ///< exact for unit speeds: signs of linear forms in square roots; the default
  rational,  ///< exact for speeds that are rounded to 2^-64 (relative)
  /// machine numbers: fast and not exact; ends with undecided_error where its answers contradict
  /// each other
  floating
};

/// Returns the kernel's name in documents: "sqrt", "rational" or "double".
std::string_view name_of(number_kernel k);

/// What a node of a skeleton is.
enum class event_kind : std::uint8_t {
  vertex,  ///< no event: a vertex of the input, at time zero
  edge,    ///< of a polygon: an edge of the wavefront vanishes
  split,   ///< of a polygon: a vertex of the wavefront cuts an edge in two
  E1,      ///< of a polyhedron: the thesis's thirteen classes (3.9)
  E2,
  E3,
  E4,
  E5,
  E6,
  V_E,
  V_V_I,
  V_V_II,
  V_V_E_I,
  V_V_E_II,
  E_E,
  V_F,
  other,  ///< of a polyhedron: none of the thirteen
  /// of a contracted skeleton: several events at one place, which the raw skeleton tells apart
  merged
};

/// Returns the name of a kind: that of the enumerator, with "-" in place of "_" ("V-V-I").
std::string_view name_of(event_kind k);

/// Returns the kind of this name, if there is one.
std::optional<event_kind> event_of_name(std::string_view name);

/// A refuted skeleton: the first rule that it breaks, and where.
struct skeleton_refutation {
  std::string_view rule;  ///< a word of the certificate: docs/theory/skeleton-and-certificate.md
  std::string witness;    ///< the element and what is wrong with it
};

/// Returns the version of the compiled library, "MAJOR.MINOR.PATCH".
std::string_view version();

}  // namespace osteon
