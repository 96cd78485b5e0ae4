// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The boundaries of a skeleton's faces, as closed walks through its nodes.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// Walks through the nodes of a contracted skeleton. Each arc is passed twice, once each way, and
/// each side of the polygon once.
struct face_loops {
  /// A closed walk around a face.
  struct loop {
    int face;                ///< its representative edge; -1: the polygon itself, seen from below
    std::vector<int> nodes;  ///< the face on the left, where time points up from its line
  };
  std::vector<loop> loops;  ///< by face; a face that surrounds the track of a hole has several
  /// Sides of the polygon, from node to node; straight vertices have no node.
  struct side {
    int from;
    int to;
    int face;
  };
  std::vector<side> sides;
  std::vector<int> rings;  ///< of loops of face -1: connected piece of the polygon
};

namespace detail {

template <class Angle>
class face_tracer {
 public:
  face_tracer(const boundary& o, const skeleton& raw, const contracted_skeleton& s, Angle angle) : o_(o), raw_(raw), s_(s), angle_(angle) {}

  face_loops run() {
    collect_sides();
    group();
    orient();
    link();
    trace();
    trace_polygon();
    return std::move(result_);
  }

 private:
  // An arc or a side of the polygon as part of a face's boundary.
  struct part {
    int face;
    int from;
    int to;
    int mate;  ///< the same arc in the other face, or -1
    bool known;
    int next = -1;
  };

  void collect_sides() {
    for (const auto& a : s_.arcs) {
      if (a.target < 0) throw unsupported_error("a face of the skeleton is unbounded");
      const int i = static_cast<int>(parts_.size());
      parts_.push_back({a.faces[0], a.source, a.target, i + 1, false});
      parts_.push_back({a.faces[1], a.target, a.source, i, false});
    }
    const std::size_t n = o_.next.size();
    node_of_.assign(n, -1);
    for (int v = 0; v < s_.vertices; ++v) node_of_[s_.nodes[v].vertex] = v;
    std::vector<int> out(n, -1);  // face of the side that starts at a vertex
    for (const auto& a : raw_.arcs)
      if (raw_.nodes[a.source].vertex >= 0) out[raw_.nodes[a.source].vertex] = a.faces[1];
    for (std::size_t v = 0; v < n; ++v) {
      if (node_of_[v] < 0) continue;
      int w = o_.next[v];
      while (node_of_[w] < 0) w = o_.next[w];
      result_.sides.push_back({node_of_[v], node_of_[w], out[v]});
      parts_.push_back({out[v], node_of_[v], node_of_[w], -1, true});
    }
  }

  // Ends of parts by face and node.
  void group() {
    for (std::size_t i = 0; i < parts_.size(); ++i)
      for (const int node : {parts_[i].from, parts_[i].to}) ends_.push_back({parts_[i].face, node, static_cast<int>(i)});
    std::sort(ends_.begin(), ends_.end());
    groups_of_.assign(parts_.size(), {-1, -1});
    for (std::size_t i = 0; i < ends_.size();) {
      const std::size_t begin = i;
      while (i < ends_.size() && ends_[i][0] == ends_[begin][0] && ends_[i][1] == ends_[begin][1]) ++i;
      if ((i - begin) % 2 != 0) throw invariant_error("internal invariant violated: a face has a closed boundary");
      if (i - begin > 2) {  // the face touches itself: counter-clockwise around the node
        const int node = ends_[begin][1];
        std::vector<std::pair<double, int>> around;
        for (std::size_t k = begin; k < i; ++k) {
          const part& p = parts_[ends_[k][2]];
          around.emplace_back(angle_(p.face, node, p.from == node ? p.to : p.from), ends_[k][2]);
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = begin; k < i; ++k) ends_[k][2] = around[k - begin].second;
      }
      const int g = static_cast<int>(groups_.size());
      groups_.emplace_back(static_cast<int>(begin), static_cast<int>(i));
      for (std::size_t k = begin; k < i; ++k) {
        auto& of = groups_of_[ends_[k][2]];
        of[of[0] < 0 ? 0 : 1] = g;
      }
    }
  }

  // The sides of the polygon have the interior on their left; from there on, arcs pass in and out
  // of nodes in turns, and two faces pass an arc in opposite directions.
  void orient() {
    std::vector<int> waiting;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (parts_[i].known) waiting.push_back(static_cast<int>(i));
    std::size_t found = waiting.size();
    const auto learn = [&](int i, int from) {
      part& p = parts_[i];
      if (p.known) {
        if (p.from != from) throw invariant_error("internal invariant violated: the boundaries of faces run one way");
        return;
      }
      if (p.from != from) std::swap(p.from, p.to);
      p.known = true;
      ++found;
      waiting.push_back(i);
    };
    while (!waiting.empty()) {
      const int i = waiting.back();
      waiting.pop_back();
      const part p = parts_[i];
      if (p.mate >= 0) learn(p.mate, p.to);
      for (const int g : groups_of_[i]) {
        const auto [begin, end] = groups_[g];
        const int node = ends_[begin][1];
        int at = begin;
        while (ends_[at][2] != i) ++at;
        for (int k = begin; k < end; ++k) {
          const part& q = parts_[ends_[k][2]];
          const int other = q.from == node ? q.to : q.from;
          const bool leaves = (p.from == node) == ((k - at) % 2 == 0);
          learn(ends_[k][2], leaves ? node : other);
        }
      }
    }
    if (found != parts_.size()) throw invariant_error("internal invariant violated: a skeleton hangs together");
  }

  // A walk that comes in leaves by the next part clockwise: the face is between them.
  void link() {
    for (const auto& [begin, end] : groups_) {
      const int node = ends_[begin][1];
      for (int k = begin; k < end; ++k) {
        part& p = parts_[ends_[k][2]];
        if (p.to == node) p.next = ends_[k == begin ? end - 1 : k - 1][2];
      }
    }
  }

  void trace() {
    std::vector<bool> seen(parts_.size(), false);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (seen[i]) continue;
      auto& l = result_.loops.emplace_back();
      l.face = parts_[i].face;
      for (int p = static_cast<int>(i); !seen[p]; p = parts_[p].next) {
        seen[p] = true;
        l.nodes.push_back(parts_[p].from);
      }
    }
    std::stable_sort(result_.loops.begin(), result_.loops.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
  }

  // The rings of the polygon backwards; the faces between them say which belong together.
  void trace_polygon() {
    const std::size_t sides = result_.sides.size();
    disjoint_sets connected(s_.nodes.size());
    std::vector<int> of_face(o_.next.size(), -1);
    for (const auto& p : parts_) {
      int& f = of_face[p.face];
      if (f < 0) f = p.from;
      connected.unite(p.from, f);
      connected.unite(p.to, f);
    }
    std::vector<int> before(s_.nodes.size(), -1);
    for (const auto& s : result_.sides) before[s.to] = s.from;
    std::vector<int> piece(s_.nodes.size(), -1);
    std::vector<bool> seen(s_.nodes.size(), false);
    int pieces = 0;
    for (std::size_t i = 0; i < sides; ++i) {
      const int first = result_.sides[i].from;
      if (seen[first]) continue;
      auto& l = result_.loops.emplace_back();
      l.face = -1;
      for (int v = first; !seen[v]; v = before[v]) {
        seen[v] = true;
        l.nodes.push_back(v);
      }
      int& p = piece[connected.find(first)];
      if (p < 0) p = pieces++;
      result_.rings.push_back(p);
    }
  }

  const boundary& o_;
  const skeleton& raw_;
  const contracted_skeleton& s_;
  Angle angle_;
  std::vector<int> node_of_;
  std::vector<part> parts_;
  std::vector<std::array<int, 3>> ends_;       // face, node, part
  std::vector<std::pair<int, int>> groups_;    // of ends at one node of one face
  std::vector<std::array<int, 2>> groups_of_;  // of the two ends of a part
  face_loops result_;
};

}  // namespace detail

/// Returns the boundaries of all faces of a bounded skeleton, and of the polygon. `angle(face,
/// node, other)` is asked only where a face touches itself in a node: a number that grows with the
/// direction from there to another node, counter-clockwise in coordinates of place along the face's
/// line and time. Throws unsupported_error for a skeleton with unbounded faces, invariant_error
/// where arcs do not fit. Cost: sorting.
template <class Angle>
face_loops trace_faces(const boundary& o, const skeleton& raw, const contracted_skeleton& s, Angle angle) {
  return detail::face_tracer<Angle>(o, raw, s, angle).run();
}

}  // namespace osteon::plane
