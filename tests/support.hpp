// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What tests share: models from files and skeletons of them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/propagate.hpp"

namespace osteon::test {

inline solid<integer> read_solid(std::istream& in, const std::string& name, bool triangulate = false) {
  auto m = read_obj<integer>(in, name);
  if (triangulate) triangulate_facets(m);
  return make_solid(std::move(m));
}

inline solid<integer> read_solid(const std::filesystem::path& file, bool triangulate = false) {
  std::ifstream in(file);
  return read_solid(in, file.filename().string(), triangulate);
}

inline solid<integer> parse_solid(const std::string& text) {
  std::istringstream in(text);
  return read_solid(in, "text");
}

inline auto default_kernel(const solid<integer>& s) {
  return perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_sqrt_kernel(s.planes)));
}

inline auto rational_default_kernel(const solid<integer>& s) {
  return perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_rational_kernel(s.planes)));
}

inline skeleton_options preferring(split_preference p) { return {p, default_saddle(p)}; }

/// The thesis's two ways through a saddle.
inline skeleton_options as_in_the_thesis(split_preference p) {
  return {p, p == split_preference::min_volume ? saddle_rule::faster : saddle_rule::slower};
}

inline std::filesystem::path corpus() { return OSTEON_CORPUS; }

/// Skips a test that needs the thesis's models, which are not part of the project.
#define OSTEON_NEEDS_CORPUS() \
  if (!std::filesystem::exists(::osteon::test::corpus() / "tables.csv")) GTEST_SKIP() << "the thesis's corpus is not here"

}  // namespace osteon::test
