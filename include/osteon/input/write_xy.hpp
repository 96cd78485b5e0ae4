// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Writes rings as lines of points (.xy).

#include <cstddef>
#include <ostream>

#include "osteon/input/rings.hpp"
#include "osteon/input/write_number.hpp"

namespace osteon::plane {

/// Writes rings as lines `x y`, with a blank line between rings. A ring is a range of points, each
/// of which holds two integers, doubles or exact numbers.
template <class Rings>
void write_xy(std::ostream& out, const Rings& all) {
  bool first = true;
  for (const auto& ring : all) {
    if (!first) out << '\n';
    first = false;
    for (const auto& p : ring) {
      write_number(out, p[0]);
      out << ' ';
      write_number(out, p[1]);
      out << '\n';
    }
  }
}

/// Writes rings as lines `x y` or `x y weight`, without loss but for parts, which the format does
/// not tell apart.
template <class Int>
void write_xy(std::ostream& out, const rings<Int>& all) {
  bool first = true;
  for (const auto& ring : all.all) {
    if (!first) out << '\n';
    first = false;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      write_number(out, ring.points[i][0]);
      out << ' ';
      write_number(out, ring.points[i][1]);
      if (!ring.weights.empty()) {
        out << ' ';
        write_number(out, ring.weights[i]);
      }
      out << '\n';
    }
  }
}

}  // namespace osteon::plane
