// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is behind a polyhedron's skeleton of the door.

#include "osteon/door/polyhedron_skeleton.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "lazy.hpp"
#include "osteon/evaluate/solid_offset.hpp"
#include "osteon/evaluate/volume.hpp"
#include "polyhedron_data.hpp"
#include "space_run.hpp"

namespace osteon {

/// Where and when a node is, in units of the input, rounded.
struct rounded_place {
  std::array<double, 3> point;
  double time;
};

/// The solid, the result, and what is made of it when it is asked for.
struct polyhedron_skeleton::data {
  std::shared_ptr<const polyhedron::data> input;
  polyhedron_options options;
  space_result result;

  const solid<integer>& body() const { return input->checked; }
  /// Returns whether the raw skeleton is meant: there is no other with machine numbers.
  bool is_raw(bool raw) const { return raw || !result.exact; }
  /// Returns f(skeleton) of the level of detail.
  template <class F>
  auto at(bool raw, F f) const {
    return is_raw(raw) ? f(result.raw) : f(*result.exact);
  }

  /// Returns the places of the raw nodes, nothing where they have none.
  const std::vector<std::optional<rounded_place>>& places() const;
  /// Returns a raw node at the place of a node, one with a place where there is one.
  int raw_node(bool raw, int node) const;
  const plane_speeds& speeds() const;
  const rational_offsets& volumes() const;

 private:
  lazy<std::vector<std::optional<rounded_place>>> places_;
  lazy<plane_speeds> speeds_;
  lazy<rational_offsets> volumes_;
};

/// Returns the speeds that a kernel takes for its planes, where it rounds them; nothing where it
/// does not.
std::optional<std::vector<rational>> given_speeds(const solid<integer>& s, number_kernel k);

/// Returns the exact surface of an offset, by the kernel of the run. `time` in units of the solid's
/// integers.
solid_surface surface_of(const polyhedron_skeleton::data& d, const rational& time, bool triangulate);

}  // namespace osteon
