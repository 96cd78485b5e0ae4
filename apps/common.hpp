// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What several commands of the program share: reading a model, naming options, choosing a kernel.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"

namespace osteon::app {

inline const std::map<std::string, split_preference> preferences = {{"convex", split_preference::convex},
                                                                    {"reflex", split_preference::reflex},
                                                                    {"min-volume", split_preference::min_volume},
                                                                    {"max-volume", split_preference::max_volume},
                                                                    {"first", split_preference::first}};
inline const std::map<std::string, saddle_rule> saddles = {
    {"convex", saddle_rule::convex}, {"reflex", saddle_rule::reflex}, {"slower", saddle_rule::slower}, {"faster", saddle_rule::faster}};

inline std::string name_of(saddle_rule rule) {
  return std::find_if(saddles.begin(), saddles.end(), [rule](const auto& s) { return s.second == rule; })->first;
}

template <class Value>
std::vector<std::string> names(const std::map<std::string, Value>& of) {
  std::vector<std::string> result;
  for (const auto& [name, value] : of) result.push_back(name);
  return result;
}

/// Takes numbers for which `holds`, nothing else; what they are is said by `what`.
inline CLI::Validator number_that(std::function<bool(double)> holds, const std::string& what) {
  return CLI::Validator(
      [holds = std::move(holds), what](const std::string& text) {
        double x = 0;
        return CLI::detail::lexical_cast(text, x) && holds(x) ? std::string() : text + " is no " + what;
      },
      "");
}

/// Takes finite numbers of at least this, nothing else.
inline CLI::Validator finite_from(double least) {
  return number_that([least](double x) { return std::isfinite(x) && x >= least; },
                     "finite number" + (least < 0 ? "" : fmt::format(" of at least {}", least)));
}
inline const CLI::Validator finite = finite_from(std::numeric_limits<double>::lowest());

/// A file with the repairs that the user asked for.
struct model {
  std::string file;
  bool flip = false;
  bool triangulate = false;

  void add_to(CLI::App& command, const std::string& what = "a closed polyhedron as Wavefront OBJ") {
    command.add_option("FILE", file, what + "; - for standard input")->required();
    command.add_flag("--flip", flip, "reverse all facets, for a model whose normals point inwards");
    command.add_flag("--triangulate", triangulate, "cut facets that are not planar into triangles");
  }

  /// For commands that take polyhedra only.
  solid<integer> read(const std::string& command) const { return read(input_text(file, command, subject::polyhedron)); }

  solid<integer> read(input_text text) const {
    input_mesh<integer> m = read_obj<integer>(text.stream(), text.name());
    if (flip) solid_builder<integer>::flip(m);
    if (triangulate) solid_builder<integer>::triangulate(m);
    return make_solid(std::move(m));
  }
};

/// A raw skeleton and, where the kernel is exact, the contracted one.
struct both_skeletons {
  skeleton raw;
  std::optional<contracted_skeleton> exact;
};

template <kernel<3> K>
both_skeletons compute(const perturbed<K>& k, const boundary& b, const skeleton_options& o) {
  both_skeletons result{straight_skeleton(k, b, o), std::nullopt};
  result.exact = contract(k.base(), b, result.raw);
  return result;
}

inline both_skeletons compute(const double_kernel& k, const boundary& b, const skeleton_options& o) {
  return {straight_skeleton(k, b, o), std::nullopt};
}

/// Calls body with the named kernel. The exact ones are filtered and perturbed, so that no input is degenerate.
template <class Body>
auto with_kernel(const std::string& name, std::span<const moving_plane<integer>> planes, Body body) {
  if (name == "double") return body(make_double_kernel(planes));
  if (name == "rational") return body(perturbed(filtered(planes, make_rational_kernel(planes))));
  return body(perturbed(filtered(planes, make_sqrt_kernel(planes))));
}

/// The kernel that commands use which do not ask for one.
inline auto default_kernel(const solid<integer>& s) {
  return perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_sqrt_kernel(s.planes)));
}

/// The number of a solid's vertex at a point, counted from 1, of the file.
inline int vertex_at(const solid<integer>& s, const std::string& file, int point) {
  const auto found = std::find(s.input_points.begin(), s.input_points.end(), point - 1);
  if (found == s.input_points.end())
    throw input_error(input_fault::bad_index, static_cast<std::size_t>(std::max(point, 0)),
                      fmt::format("{}: point {} is no vertex of the solid", file, point), "name a point where at least three planes meet");
  return static_cast<int>(found - s.input_points.begin());
}

}  // namespace osteon::app
