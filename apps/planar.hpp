// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What the commands share for polygons: reading them, choosing a kernel, computing the skeleton.

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/input/rewound.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"

namespace osteon::app {

inline constexpr const char* polygon_formats =
    "a polygon as .xy text (x y [weight] a line, rings after blank lines), WKT, GeoJSON or an OBJ file with one flat face";

/// Whether an OBJ text has a single face.
inline bool has_one_face(std::istream& in) {
  int faces = 0;
  for (std::string line; faces < 2 && std::getline(in, line);)
    if (const std::size_t at = line.find_first_not_of(" \t");
        at != std::string::npos && line[at] == 'f' && at + 1 < line.size() && line[at + 1] <= ' ')
      ++faces;
  return faces == 1;
}

/// Whether a file is a polygon's: by its extension, standard input by its beginning (an OBJ text is a polyhedron's there); an OBJ file where
/// it has a single face. Standard input can be read from its beginning afterwards.
inline bool is_polygon_file(const std::string& file) {
  if (file == "-") {
    static rewound whole(std::cin, "standard input");
    const bool polygon = plane::guess_format("", whole.beginning()) != plane::format::obj;
    std::cin.rdbuf(whole.stream().rdbuf());
    return polygon;
  }
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".obj") return extension == ".xy" || extension == ".txt" || extension == ".wkt" || extension == ".geojson" || extension == ".json";
  std::ifstream in(file, std::ios::binary);
  return has_one_face(in);
}

/// A checked polygon, or what is outside of it; what was repaired is said on standard error. change(rings) is called before the check.
template <class Change>
plane::polygon<integer> read_polygon_file(const std::string& file, bool outside, Change change) {
  auto rings = [&] {
    if (file == "-") return plane::read_polygon<integer>(std::cin, "standard input");
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) throw input_error(input_fault::unreadable, 0, file + ": cannot be opened", "check the name");
    return plane::read_polygon<integer>(in, file);
  }();
  change(rings);
  auto polygon = plane::make_polygon(std::move(rings), outside);
  for (const auto& repair : polygon.repairs) fmt::print(stderr, "osteon: note: {}\n", repair);
  return polygon;
}

inline plane::polygon<integer> read_polygon_file(const std::string& file, bool outside) {
  return read_polygon_file(file, outside, [](auto&) {});
}

/// A raw skeleton and, where the kernel is exact, the contracted one.
struct planar_skeletons {
  plane::skeleton raw;
  std::optional<plane::contracted_skeleton> exact;
};

/// Calls body with the named kernel for a polygon's lines; the exact ones are filtered and perturbed.
template <class Body>
auto with_planar_kernel(const std::string& name, const plane::polygon<integer>& p, Body body) {
  const std::span<const moving_line<integer>> lines(p.lines);
  if (name == "double") return body(make_double_kernel(lines));
  const std::vector<std::array<double, 2>> anchors = anchors_of(p);
  if (name == "rational") return body(perturbed(filtered(lines, make_rational_kernel(lines), anchors)));
  return body(perturbed(filtered(lines, make_sqrt_kernel(lines), anchors)));
}

/// The skeleton of a polygon by the named kernel.
inline planar_skeletons compute_planar(const std::string& kernel, const plane::polygon<integer>& p, const plane::skeleton_options& o = {}) {
  const plane::vertex_enclosures motion(p.lines, p.points, o.outside);
  return with_planar_kernel(kernel, p, [&](const auto& k) {
    planar_skeletons result{plane::propagation(k, p.boundary, motion, o).run(), std::nullopt};
    if constexpr (requires { k.base(); }) result.exact = plane::contract(k.base(), p.boundary.line, result.raw);
    return result;
  });
}

}  // namespace osteon::app
