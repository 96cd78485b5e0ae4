// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is behind a polyhedron of the door.

#include <cstddef>
#include <vector>

#include "osteon/door/polyhedron.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// The checked solid.
struct polyhedron::data {
  solid<integer> checked;
  /// by facet of the checked mesh: the one given; empty where these are the same
  std::vector<int> given;

  int given_facet(int f) const { return given.empty() ? f : given[static_cast<std::size_t>(f)]; }
};

/// Returns the length of the solid's unit in that of the input.
rational unit_of(const solid<integer>& s);

}  // namespace osteon
