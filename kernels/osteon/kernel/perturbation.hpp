// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The fixed integers of the symbolic perturbation.

#include <array>
#include <cstdint>

#include "osteon/core/planes.hpp"
#include "osteon/core/random.hpp"

namespace osteon {

/// The symbolic perturbation of a plane: n + e^2 u, d + e delta. In the plane only the first two
/// numbers of u count. Numbers of twenty bits keep small integers exact in double precision.
struct perturbation {
  std::array<int, 3> u;
  int delta;

  /// Returns the perturbation of a plane. It depends on the plane's number alone, so every run and
  /// every kernel perturbs alike. Negative numbers, which no plane has, give more such numbers.
  static perturbation of(plane_id id) {
    random_stream random(static_cast<std::uint64_t>(id) + 1);
    const auto draw = [&random] { return static_cast<int>(random() & 0xFFFFFU) - 0x80000; };
    perturbation p{};
    p.delta = draw();
    for (int& x : p.u) x = draw();
    return p;
  }
};

}  // namespace osteon
