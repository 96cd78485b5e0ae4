// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What generators of polyhedra are made with: points, facets and random numbers.

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "osteon/core/random.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/mesh.hpp"

namespace osteon::models {

/// A point with integer coordinates.
using point = std::array<long, 3>;

/// The random numbers of the generators.
using dice = random_stream;

/// Collects the points and facets of a mesh; equal points become one.
class builder {
 public:
  /// Returns the number of a point, a new one where it was not there.
  int at(const point& p) {
    const auto [found, fresh] = ids_.emplace(p, static_cast<int>(points_.size()));
    if (fresh) points_.push_back(p);
    return found->second;
  }
  /// Adds a facet, its corners counter-clockwise seen from outside.
  void facet(const std::vector<point>& corners) {
    auto& f = facets_.emplace_back();
    for (const auto& p : corners) f.push_back(at(p));
  }

  /// Returns the mesh as input of the library.
  template <class Int>
  input_mesh<Int> take() const {
    input_mesh<Int> m;
    for (const auto& p : points_)
      m.points.push_back({exact_number<Int>{Int(p[0]), 0, 0}, exact_number<Int>{Int(p[1]), 0, 0}, exact_number<Int>{Int(p[2]), 0, 0}});
    m.facets = facets_;
    return m;
  }

 private:
  std::map<point, int> ids_;
  std::vector<point> points_;
  std::vector<std::vector<int>> facets_;
};

}  // namespace osteon::models
