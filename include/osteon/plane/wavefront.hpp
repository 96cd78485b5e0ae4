// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The moving polygon: edges on lines, vertices between them, and the order of the edges on
/// each line.

#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"

namespace osteon::plane {

/// Rings of edges, the interior on their left. Dead elements keep their numbers until the next
/// renumbering.
struct wavefront {
  /// An edge, which moves with its line.
  struct edge {
    line_id line;
    int tail;  ///< vertex where it starts, in the direction that has the interior on the left
    int head;  ///< vertex where it ends
    int face;  ///< an edge of the polygon, whose face this edge sweeps
    /// edge behind it on its line, or -1. Edges of one line never overlap, so their order never
    /// changes
    int previous;
    int next;  ///< edge before it on its line, or -1
    bool alive;
  };
  /// A vertex, which moves with the intersection of two lines.
  struct vertex {
    int in;          ///< edge that ends here
    int out;         ///< edge that starts here
    line_id before;  ///< line of the edge that ends here
    line_id after;   ///< line of the edge that starts here
    int arc;         ///< of the skeleton, which the vertex traces
    bool alive;
    bool reflex;  ///< the polygon is the union, not the intersection, of two half-planes there
  };
  std::vector<edge> edges;
  std::vector<vertex> vertices;
  int living = 0;  ///< number of living edges, and of living vertices

  /// Returns the line of the edge that ends at vertex v.
  line_id line_before(int v) const { return vertices[v].before; }
  /// Returns the line of the edge that starts at vertex v.
  line_id line_after(int v) const { return vertices[v].after; }
  /// Returns the line of the edge that ends where edge e starts.
  line_id tail_line(int e) const { return line_before(edges[e].tail); }
  /// Returns the line of the edge that starts where edge e ends.
  line_id head_line(int e) const { return line_after(edges[e].head); }
  /// Returns the lines of an edge and of its two neighbours, ascending. Where they meet next, the
  /// edge vanishes.
  triple lines_around(int e) const { return sorted(triple{tail_line(e), edges[e].line, head_line(e)}); }

  /// Marks a living edge as dead and takes it out of its line. Its ring is left to the caller.
  void erase(int e) {
    edge& gone = edges[e];
    gone.alive = false;
    if (gone.previous >= 0) edges[gone.previous].next = gone.next;
    if (gone.next >= 0) edges[gone.next].previous = gone.previous;
    --living;
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
  /// Numbers the living elements along their rings, so that neighbours are near in memory, and each
  /// vertex as the edge that starts there; forgets the dead ones. Returns the new numbers, or
  /// nothing where a ring is not closed, which decisions that contradict each other can bring
  /// about; the wavefront is then as it was.
  /// *Complexity* linear in the number of elements, dead ones included.
  std::optional<numbering> renumber() {
    numbering now{std::vector<int>(edges.size(), -1), std::vector<int>(vertices.size(), -1)};
    wavefront kept;
    kept.living = living;
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
