// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The moving polygon: edges on lines, vertices between them, and the order of the edges on each line.

#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// Rings of edges, the interior on their left. Dead elements keep their numbers.
struct wavefront {
  struct edge {
    line_id line;
    int tail;  ///< vertex where it starts, in the direction that has the interior on the left
    int head;
    int face;
    int previous;  ///< edge behind it on its line, or -1. Edges of one line never overlap, so their order never changes
    int next;      ///< edge before it on its line, or -1
    bool alive;
  };
  struct vertex {
    int in;          ///< edge that ends here
    int out;         ///< edge that starts here
    line_id before;  ///< line of the edge that ends here
    line_id after;   ///< line of the edge that starts here
    int arc;
    bool alive;
    bool reflex;  ///< the polygon is the union, not the intersection, of two half-planes there
  };
  std::vector<edge> edges;
  std::vector<vertex> vertices;

  line_id line_before(int v) const { return vertices[v].before; }
  line_id line_after(int v) const { return vertices[v].after; }

  /// A living edge has ended: takes it out of its line.
  void erase(int e) {
    edge& gone = edges[e];
    gone.alive = false;
    if (gone.previous >= 0) edges[gone.previous].next = gone.next;
    if (gone.next >= 0) edges[gone.next].previous = gone.previous;
  }
  /// Puts edge f right before edge e on its line.
  void insert_after(int e, int f) {
    edges[f].previous = e;
    edges[f].next = edges[e].next;
    edges[e].next = f;
    if (edges[f].next >= 0) edges[edges[f].next].previous = f;
  }

  /// New numbers by old ones, -1 for what is dead.
  struct numbering {
    std::vector<int> edges;
    std::vector<int> vertices;
  };
  /// Numbers the living elements along their rings, so that neighbours are near in memory, and each vertex as the edge that starts there; forgets the
  /// dead ones. Nothing where a ring is not closed, which decisions that contradict each other can bring about; the wavefront is as it was then.
  std::optional<numbering> renumber() {
    numbering now{std::vector<int>(edges.size(), -1), std::vector<int>(vertices.size(), -1)};
    wavefront kept;
    kept.edges.reserve(edges.size());
    kept.vertices.reserve(edges.size());
    for (int first = 0; first < static_cast<int>(edges.size()); ++first)
      for (int e = first; edges[e].alive && now.edges[e] < 0; e = vertices[edges[e].head].out) {
        now.edges[e] = now.vertices[edges[e].tail] = static_cast<int>(kept.edges.size());
        kept.edges.push_back(edges[e]);
        kept.vertices.push_back(vertices[edges[e].tail]);
      }
    for (edge& e : kept.edges) {
      e.tail = now.vertices[e.tail];
      e.head = now.vertices[e.head];
      if (e.head < 0) return std::nullopt;
      if (e.previous >= 0) e.previous = now.edges[e.previous];
      if (e.next >= 0) e.next = now.edges[e.next];
    }
    for (vertex& v : kept.vertices) {
      v.in = now.edges[v.in];
      v.out = now.edges[v.out];
      if (v.in < 0 || v.out < 0) return std::nullopt;
    }
    *this = std::move(kept);
    return now;
  }
};

}  // namespace osteon::plane
