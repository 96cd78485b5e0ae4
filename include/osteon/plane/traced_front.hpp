// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A wavefront together with the part of the skeleton that it has traced.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/wavefront.hpp"

namespace osteon::plane {

/// The wavefront, and the nodes and arcs behind it.
struct traced_front {
  wavefront front;
  skeleton trace;               ///< but for its faces
  disjoint_sets faces;          ///< edges of the polygon; those in one set sweep one face
  std::vector<int> dead_slots;  ///< numbers of dead vertices, to be given to new ones

  /// Lets vertex v trace an arc that begins at a node.
  void begin_arc(int v, int node) {
    auto& vertex = front.vertices[v];
    vertex.arc = static_cast<int>(trace.arcs.size());
    trace.arcs.push_back({node, -1, {front.edges[vertex.in].face, front.edges[vertex.out].face}});
  }

  /// Ends a living vertex and its arc at a node.
  void end_vertex(int v, int node) {
    front.vertices[v].alive = false;
    trace.arcs[front.vertices[v].arc].target = node;
    dead_slots.push_back(v);
  }

  /// Makes one face of two; the smaller one of their representatives stands for both.
  void merge_faces(int f, int g) {
    f = faces.find(f);
    g = faces.find(g);
    faces.unite(std::max(f, g), std::min(f, g));
  }

  /// Returns the skeleton. All faces are named by their representatives from then on.
  skeleton take() {
    trace.faces.resize(faces.size());
    for (std::size_t f = 0; f < trace.faces.size(); ++f) trace.faces[f] = faces.find(static_cast<int>(f));
    for (auto& a : trace.arcs)
      for (int& f : a.faces) f = trace.faces[f];
    return std::move(trace);
  }
};

}  // namespace osteon::plane
