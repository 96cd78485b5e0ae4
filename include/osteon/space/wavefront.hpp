// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The moving boundary: vertices of three planes, edges of two, and the tables to find them by
/// their planes. There are no rings and no half-edges: the planes of corners and pieces of lines,
/// with signs, say everything (docs/theory/events.md).

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/segment.hpp"

namespace osteon {

/// Flat arrays with ids that are never used again; removed elements stay as tombstones.
class wavefront {
 public:
  /// A moving vertex of three planes.
  struct vertex {
    triple planes;             ///< ascending
    std::array<int, 6> edges;  ///< by slot, -1 for none
    int arc;                   ///< that it traces
    std::uint8_t corner;       ///< one of the nine (local::corners); 0: not known yet
    bool alive;
  };
  /// A moving edge.
  struct edge : segment {
    std::array<int, 2> ends;  ///< vertices
    int sheet;                ///< that it traces
    bool alive;
    std::array<int, 2> index;  ///< in the lists of its two facets
  };

  /// An empty wavefront of so many planes.
  explicit wavefront(plane_id planes) : by_plane_(planes) {}

  /// Returns the slot of a vertex for the edge opposite its plane number t (0..2), inside or
  /// outside that plane.
  static int slot(int t, bool inside) { return 2 * t + (inside ? 1 : 0); }

  /// Adds a vertex without edges and returns its number.
  /// *Requires* ascending planes that have no vertex yet. *Complexity* expected constant.
  int add_vertex(const triple& planes, std::uint8_t corner, int arc) {
    const int id = static_cast<int>(vertices_.size());
    vertices_.push_back({planes, {-1, -1, -1, -1, -1, -1}, arc, corner, true});
    by_corner_[planes] = id;
    return id;
  }

  /// Removes a vertex; its edges are not told.
  void remove_vertex(int v) {
    vertices_[v].alive = false;
    by_corner_.erase(vertices_[v].planes);
  }

  /// Adds an edge, at first without ends, and returns its number. *Complexity* expected constant.
  int add_edge(const segment& s, int sheet) {
    const int id = static_cast<int>(edges_.size());
    edges_.push_back({s, {-1, -1}, sheet, true, {0, 0}});
    by_line_[line(s.planes[0], s.planes[1])].push_back(id);
    for (int side = 0; side < 2; ++side) {
      auto& list = by_plane_[s.planes[side]];
      edges_[id].index[side] = static_cast<int>(list.size());
      list.push_back(id);
    }
    return id;
  }

  /// Removes an edge; its ends are not told. *Complexity* linear in the edges on its line.
  void remove_edge(int e) {
    edge& gone = edges_[e];
    gone.alive = false;
    auto& same_line = by_line_[line(gone.planes[0], gone.planes[1])];
    same_line.erase(std::find(same_line.begin(), same_line.end(), e));
    for (int side = 0; side < 2; ++side) {
      auto& list = by_plane_[gone.planes[side]];
      const int last = list.back();
      list[gone.index[side]] = last;
      edges_[last].index[edges_[last].planes[0] == gone.planes[side] ? 0 : 1] = gone.index[side];
      list.pop_back();
    }
  }

  /// Makes v an end of e; there e lies on the given side of the vertex's third plane.
  void attach(int e, int end, int v, plane_id third, bool inside) {
    edge& to = edges_[e];
    to.ends[end] = v;
    to.third[end] = third;
    to.inside[end] = inside;
    vertices_[v].edges[slot(static_cast<int>(position(vertices_[v].planes, third)), inside)] = e;
  }

  /// Returns the vertex of three planes (ascending), or -1. Three planes meet once, so there is at
  /// most one. *Complexity* expected constant.
  int find_vertex(const triple& planes) const {
    const auto found = by_corner_.find(planes);
    return found == by_corner_.end() ? -1 : found->second;
  }

  /// Returns the edges on the line of two planes (ascending). *Complexity* expected constant.
  std::span<const int> on_line(plane_id p, plane_id q) const {
    const auto found = by_line_.find(line(p, q));
    return found == by_line_.end() ? std::span<const int>() : std::span<const int>(found->second);
  }

  /// Returns the number of planes.
  plane_id planes() const { return static_cast<plane_id>(by_plane_.size()); }
  /// Returns the edges of a facet.
  std::span<const int> of_facet(plane_id p) const { return by_plane_[p]; }

  /// Returns all vertices that there ever were.
  const std::vector<vertex>& vertices() const { return vertices_; }
  /// Returns all edges that there ever were.
  const std::vector<edge>& edges() const { return edges_; }
  /// Returns a vertex, to be changed.
  vertex& at_vertex(int v) { return vertices_[v]; }
  /// Returns whether no vertex is left.
  bool empty() const { return by_corner_.empty(); }

 private:
  static std::uint64_t line(plane_id p, plane_id q) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p)) << 32U | static_cast<std::uint32_t>(q);
  }

  std::vector<vertex> vertices_;
  std::vector<edge> edges_;
  std::vector<std::vector<int>> by_plane_;
  std::unordered_map<std::uint64_t, std::vector<int>> by_line_;
  std::unordered_map<triple, int, plane_hash> by_corner_;
};

/// What an event has changed in a wavefront.
struct front_changes {
  std::vector<int> edges;  ///< that have another end than before, or are new
  int first_new;           ///< the number of the first new one
};

}  // namespace osteon
