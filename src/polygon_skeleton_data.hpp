// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is behind a polygon's skeleton of the door.

#include "osteon/door/polygon_skeleton.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lazy.hpp"
#include "osteon/evaluate/locate.hpp"
#include "osteon/evaluate/offset.hpp"
#include "osteon/plane/faces.hpp"
#include "plane_run.hpp"

namespace osteon {

/// Arcs by node and by face, of one level of detail.
struct plane_incidences {
  /// Lists one behind the other: that of i is all[first[i]] .. all[first[i + 1]].
  struct lists {
    std::vector<int> first;
    std::vector<int> all;
    std::span<const int> operator[](int i) const { return {all.data() + first[i], all.data() + first[i + 1]}; }
  };
  std::vector<int> faces;    ///< by number of the face: its representative
  std::vector<int> face_of;  ///< by edge of the checked polygon: its face, or -1
  lists arcs_of_node;
  lists arcs_of_face;
};

/// The input, the result, and what is made of it when it is asked for.
struct polygon_skeleton::data {
  std::shared_ptr<const plane::polygon<integer>> input;
  polygon_options options;
  std::optional<rational> until;
  plane_result result;

  /// Returns whether the raw skeleton is meant: there is no other with machine numbers.
  bool is_raw(bool raw) const { return raw || !result.exact; }
  bool is_exterior() const { return options.region == region::exterior; }
  plane_question question() const { return {*input, is_exterior(), until}; }

  const plane::offsets& offsets() const {
    return *offsets_.get([this] { return std::make_unique<const plane::offsets>(*input, result.raw); });
  }
  const plane_incidences& incidences(bool raw) const;
  const plane::face_loops& loops() const;

  int nodes(bool raw) const { return static_cast<int>(is_raw(raw) ? result.raw.nodes.size() : result.exact->nodes.size()); }
  int arcs(bool raw) const { return static_cast<int>(is_raw(raw) ? result.raw.arcs.size() : result.exact->arcs.size()); }
  /// Returns the vertex of the checked polygon at a node, or -1.
  int vertex(bool raw, int node) const { return is_raw(raw) ? result.raw.nodes[node].vertex : result.exact->nodes[node].vertex; }
  /// Returns the lines that meet in a node that is no vertex.
  const triple& lines(bool raw, int node) const { return is_raw(raw) ? result.raw.nodes[node].lines : result.exact->nodes[node].lines; }
  /// Returns an arc's source, target and two faces, by their representatives.
  std::array<int, 4> arc(bool raw, int a) const {
    const auto of = [](const auto& x) { return std::array<int, 4>{x.source, x.target, x.faces[0], x.faces[1]}; };
    return is_raw(raw) ? of(result.raw.arcs[a]) : of(result.exact->arcs[a]);
  }
  /// Returns the place and time of a node.
  plane::located place(bool raw, int node) const {
    const int v = vertex(raw, node);
    return v >= 0 ? offsets().places().vertex(v) : offsets().places().meeting(lines(raw, node));
  }
  /// Returns the unit vector in which an edge of the checked polygon moves.
  std::array<double, 2> inwards(int edge) const;

 private:
  lazy<std::unique_ptr<const plane::offsets>> offsets_;
  std::array<lazy<plane_incidences>, 2> incidences_;
  lazy<plane::face_loops> loops_;
};

}  // namespace osteon
