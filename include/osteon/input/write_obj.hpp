// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Writes points and facets as Wavefront OBJ.

#include <ostream>

#include "osteon/input/mesh.hpp"
#include "osteon/input/write_number.hpp"

namespace osteon {

/// Writes a point as a line `v x y z`. `Point` holds three integers, doubles or exact numbers.
template <class Point>
void write_obj_point(std::ostream& out, const Point& p) {
  out << 'v';
  for (const auto& x : p) {
    out << ' ';
    write_number(out, x);
  }
  out << '\n';
}

/// Writes a facet as a line `f`. `Loop` lists the numbers of its points, from 0.
template <class Loop>
void write_obj_facet(std::ostream& out, const Loop& loop) {
  out << 'f';
  for (const int p : loop) out << ' ' << p + 1;
  out << '\n';
}

/// Writes points and facets, without loss.
template <class Points, class Facets>
void write_obj(std::ostream& out, const Points& points, const Facets& facets) {
  for (const auto& p : points) write_obj_point(out, p);
  for (const auto& f : facets) write_obj_facet(out, f);
}

/// Writes a mesh, without loss but for weights, which OBJ has no place for.
template <class Int>
void write_obj(std::ostream& out, const input_mesh<Int>& m) {
  write_obj(out, m.points, m.facets);
}

}  // namespace osteon
