// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What the commands share for polygons: reading them, choosing a kernel, computing the skeleton.

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "input.hpp"
#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"

namespace osteon::app {

/// A checked polygon, or what is outside of it; what was repaired is said on standard error. change(rings) is called before the check.
template <class Change>
plane::polygon<integer> read_polygon_text(input_text text, bool outside, Change change) {
  auto rings = [&] {
    switch (text.format()) {
      case text_format::xy:
        return plane::read_xy<integer>(text.stream(), text.name());
      case text_format::wkt:
        return plane::read_wkt<integer>(text.stream(), text.name());
      case text_format::geojson:
        return plane::read_geojson<integer>(text.stream(), text.name());
      case text_format::obj:
        break;
    }
    return plane::read_flat_obj<integer>(text.stream(), text.name());
  }();
  change(rings);
  auto polygon = plane::make_polygon(std::move(rings), outside);
  for (const auto& repair : polygon.repairs) fmt::print(stderr, "osteon: note: {}\n", repair);
  return polygon;
}

inline plane::polygon<integer> read_polygon_text(input_text text, bool outside) {
  return read_polygon_text(std::move(text), outside, [](auto&) {});
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
