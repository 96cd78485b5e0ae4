// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// All generated models by name, as `osteon generate` knows them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "osteon/models/polygons.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::models {

/// A kind of models: its name, what `size` means there, the sizes that it takes and the one that is
/// taken where none is given, and the model of a size and a seed.
template <class Model>
struct kind_of {
  std::string name;
  std::string size;
  int default_size;
  int least_size;
  int greatest_size;
  std::function<Model(int, std::uint64_t)> make;
  /// of polygons: whether rings may share points, so that not all algorithms take the polygon
  bool touching = false;
};

/// Returns the kind of a name, or a null pointer.
template <class Model>
const kind_of<Model>* find_kind(const std::vector<kind_of<Model>>& kinds, std::string_view name) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [name](const auto& k) { return k.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

/// A kind of polyhedra.
using kind = kind_of<builder>;

/// Returns all kinds of polyhedra.
inline const std::vector<kind>& kinds() {
  constexpr int most = 1000;
  static const std::vector<kind> all = {
      {"box", "the three sides are random up to this", 10, 1, most,
       [](int n, std::uint64_t s) {
         dice d(s);
         return box(d.between(1, n), d.between(1, n), d.between(1, n));
       }},
      {"cube", "side", 1, 1, most, [](int n, std::uint64_t) { return box(n, n, n); }},
      {"prism", "corners of the regular base", 6, 3, most,
       [](int n, std::uint64_t) {
         polygon p;
         for (int i = 0; i < n; ++i) p.push_back(on_circle(i, n, 1000));
         return prism(p, 800);
       }},
      {"stairs", "steps", 5, 1, most, [](int n, std::uint64_t) { return stairs(n); }},
      {"notched-box", "depth of the notch, below 6", 3, 1, most, [](int n, std::uint64_t) { return notched_box(std::min(n, 5)); }},
      {"house-l", "no meaning", 1, 1, most, [](int, std::uint64_t) { return house("##|#."); }},
      {"house-t", "no meaning", 1, 1, most, [](int, std::uint64_t) { return house("###|.#."); }},
      {"house-u", "no meaning", 1, 1, most, [](int, std::uint64_t) { return house("###|#.#"); }},
      {"house-x", "no meaning", 1, 1, most, [](int, std::uint64_t) { return house(".#.|###|.#."); }},
      {"towers", "towers a side", 3, 1, most, [](int n, std::uint64_t s) { return towers(n, s); }},
      {"voxels", "cubes a side; fill and size vary with the seed", 4, 1, most,
       [](int n, std::uint64_t s) {
         dice d(s);
         const std::array<int, 3> size = {static_cast<int>(d.between(1, n)), static_cast<int>(d.between(1, n)), static_cast<int>(d.between(1, n))};
         const int percent = static_cast<int>(d.between(25, 90));
         return random_voxels(size, percent, s).surface();
       }},
      {"tetrahedron", "no meaning", 1, 1, most, [](int, std::uint64_t) { return tetrahedron(); }},
      {"octahedron", "radius", 1, 1, most, [](int n, std::uint64_t) { return octahedron(n); }},
      {"antiprism", "corners of each base", 6, 3, most, [](int n, std::uint64_t) { return twisted_prism(n, false); }},
      {"twisted-prism", "corners of each base; 3 gives Schoenhardt's solid", 5, 3, most, [](int n, std::uint64_t) { return twisted_prism(n, true); }},
      {"cut-cube", "half a side; corners are cut at distance 1", 3, 2, most, [](int n, std::uint64_t) { return cut_cube(n, 1); }},
      {"stellated-cube", "height of the pyramids on a cube of side 4", 2, 1, most, [](int n, std::uint64_t) { return stellated_cube(2, n); }},
      {"frame", "side of the hole", 1, 1, most, [](int n, std::uint64_t) { return frame(n); }},
      {"held", "facets above and below", 5, 2, most, [](int n, std::uint64_t) { return held(n); }},
      {"pizza-box", "grooves above and below", 3, 1, most, [](int n, std::uint64_t) { return pizza_box(n); }},
      {"crossing-bars", "bars each way", 2, 1, most, [](int n, std::uint64_t) { return crossing_bars(n); }},
      {"spiked-plate", "pyramids a side", 2, 1, most, [](int n, std::uint64_t) { return spiked_plate(n); }},
      {"saddle", "no meaning", 1, 1, most, [](int, std::uint64_t) { return saddle(); }},
      {"star", "points", 5, 3, most, [](int n, std::uint64_t s) { return star(n, s); }},
      {"cone", "degree of the apex", 8, 3, most, [](int n, std::uint64_t s) { return cone(n, s); }},
      {"spire", "degree of the apex", 8, 3, most, [](int n, std::uint64_t s) { return spire(n, s); }},
      {"peak", "degree of the middle", 8, 3, most, [](int n, std::uint64_t s) { return peak(n, s); }},
      {"arms", "arms around the apex, five facets each", 4, 3, most, [](int n, std::uint64_t s) { return arms(n, s); }},
  };
  return all;
}

}  // namespace osteon::models

namespace osteon::plane::models {

/// A kind of polygons.
using kind = osteon::models::kind_of<region>;

/// Returns all kinds of polygons.
inline const std::vector<kind>& kinds() {
  constexpr int most = 10'000'000;  // vertices
  static const std::vector<kind> all = {
      {"noisy-star", "vertices", 30, 3, most, noisy_star},
      {"noisy-loop", "vertices", 60, 3, most, noisy_loop},
      {"comb", "vertices", 40, 8, most, comb},
      {"spiral", "vertices", 80, 4, most, spiral},
      {"random", "vertices", 40, 3, most, random_polygon},
      {"random-with-holes", "vertices; one hole for each 15, up to 25", 60, 3, most,
       [](int n, std::uint64_t s) { return random_with_holes(n, std::min(n / 15, 25), s); }},
      {"jittered-holes", "holes a side", 4, 1, 1500, jittered_holes},
      {"hilbert", "vertices", 128, 4, most, hilbert},
      {"jittered-cells", "vertices, about", 60, 4, most, jittered_cells},
      {"rectilinear-hilbert", "vertices", 128, 4, most, [](int n, std::uint64_t) { return rectilinear_hilbert(n); }},
      {"rectilinear", "vertices, about", 60, 4, most, rectilinear},
      {"stretched-cells", "vertices, about", 60, 4, most, stretched_cells},
      {"touching-cells", "vertices, about", 60, 4, most, touching_cells, true},
      {"grid-of-holes", "holes a side", 4, 1, 1500, [](int k, std::uint64_t) { return grid_of_holes(k); }},
      {"staircase", "vertices", 20, 4, most, [](int n, std::uint64_t) { return stairs(n); }},
      {"symmetric", "vertices", 40, 4, most, symmetric},
      {"regular", "vertices", 12, 3, most, [](int n, std::uint64_t) { return regular(n); }},
      {"gear", "vertices", 48, 8, most, [](int n, std::uint64_t) { return gear(n); }},
  };
  return all;
}

}  // namespace osteon::plane::models
