// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is behind a polygon of the door.

#include <memory>
#include <optional>

#include "osteon/door/polygon.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/input/rings.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// The input, and the interior's checked polygon once it is made.
struct polygon::data {
  plane::rings<integer> input;
  std::shared_ptr<const plane::polygon<integer>> checked;
};

/// Returns the checked polygon of a region. The second gives the input up.
std::shared_ptr<const plane::polygon<integer>> checked_polygon(const polygon& p, region r);
std::shared_ptr<const plane::polygon<integer>> checked_polygon(polygon&& p, region r);

}  // namespace osteon
