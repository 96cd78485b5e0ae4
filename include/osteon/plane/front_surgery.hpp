// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What an event does to the wavefront: edges end, are cut in two or become one, and are
/// linked anew.

#include <array>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/short_list.hpp"
#include "osteon/plane/catalogue.hpp"
#include "osteon/plane/local_state.hpp"
#include "osteon/plane/traced_front.hpp"

namespace osteon::plane {

/// An edge that has become one with another on its line, in a node.
struct merged_edge {
  int edge;
  int node;
  line_id across;  ///< another line through the node, not parallel to the edge
};

/// What is new on the wavefront.
struct front_change {
  triple lines;                        ///< of the node in which it has changed
  short_list<int, 9> edges;            ///< with a new end
  short_list<int, 3> vertices;         ///< that begin
  short_list<merged_edge, 3> mergers;  ///< edges that two have become
};

/// Changes a wavefront and lets it trace its skeleton.
template <kernel<2> K>
class front_surgery {
 public:
  front_surgery(const K& k, traced_front& traced) : k_(k), traced_(traced), front_(traced.front) {}

  /// Carries out the event of a local state: a node, the ends of arcs, and the beginnings of
  /// others.
  front_change replace(const local_state& s) {
    const int node = begin_node(s.lines, false);
    if (node > 8 * static_cast<int>(traced_.faces.size())) broken_invariant<K>("there are not more events than edges and vertices");
    front_change change{s.lines, {}, {}, {}};
    const bool vanished = end_arcs(s, node);
    std::array<joint, 3> joints;  // by the line that is not there
    for (unsigned r = 0; r < 3; ++r)
      if (const int merged = relink(s, r, joints); merged >= 0) {
        const auto [j, k] = others(r);
        change.edges.push_back(merged);
        change.mergers.push_back({merged, node, k_.transversal(s.lines[r], s.lines[j]) ? s.lines[j] : s.lines[k]});
      }
    count_event(node, vanished ? event_class::edge : event_class::split);
    for (const joint& c : joints) {
      if (c.in < 0 && c.out < 0) continue;
      if (c.in < 0 || c.out < 0) broken_invariant<K>("a vertex joins two edges");
      change.vertices.push_back(join(c, node));
      change.edges.push_back(c.in);
      change.edges.push_back(c.out);
    }
    change.edges.sort_unique();
    return change;
  }

  /// Takes an edge of length zero out of its ring. Where nothing else is left of the ring, the
  /// whole ring ends.
  front_change remove(int e) {
    const int tail = front_.edges[e].tail;
    const int head = front_.edges[e].head;
    const joint joined = {front_.vertices[tail].in, front_.vertices[head].out};
    front_change change{front_.lines_around(e), {}, {}, {}};
    const int node = begin_node(change.lines, true);
    count_event(node, event_class::edge);
    front_.erase(e);
    traced_.end_vertex(tail, node);
    traced_.end_vertex(head, node);
    // nothing is left of the ring
    if (front_.edges[joined.in].tail == front_.edges[joined.out].head) {
      traced_.end_vertex(front_.edges[joined.in].tail, node);
      front_.erase(joined.in);
      front_.erase(joined.out);
      return change;
    }
    change.vertices.push_back(join(joined, node));
    change.edges.push_back(joined.in);
    change.edges.push_back(joined.out);
    return change;
  }

 private:
  // Where two of the three lines meet after the event: the edge that ends there and the one that
  // starts.
  struct joint {
    int in = -1;
    int out = -1;
  };

  int begin_node(const triple& lines, bool zero_length) {
    traced_.trace.nodes.push_back({-1, lines, event_class::edge, zero_length});
    return static_cast<int>(traced_.trace.nodes.size()) - 1;
  }
  void count_event(int node, event_class what) {
    traced_.trace.nodes[node].event = what;
    ++traced_.trace.events[static_cast<std::size_t>(what)];
  }

  // The vertices at the point end; tells whether an edge between two of them vanishes.
  bool end_arcs(const local_state& s, int node) {
    bool vanished = false;
    for (unsigned r = 0; r < 3; ++r) {
      const int e = s.edges[r][local::segment_label(s.small, r, false)];
      for (const int f : s.edges[r]) {
        if (f < 0) continue;
        end_arc(front_.edges[f].tail, s.lines, node);
        end_arc(front_.edges[f].head, s.lines, node);
      }
      if (e < 0) continue;
      const auto [j, k] = others(r);
      const line_id t = front_.tail_line(e);
      const line_id h = front_.head_line(e);
      vanished = vanished || (t == s.lines[j] && h == s.lines[k]) || (t == s.lines[k] && h == s.lines[j]);
    }
    return vanished;
  }

  // A vertex ends if both of its lines meet in the node.
  void end_arc(int v, const triple& lines, int node) {
    const auto meets = [&lines](line_id l) { return position(lines, l) < lines.size(); };
    if (front_.vertices[v].alive && meets(front_.line_before(v)) && meets(front_.line_after(v))) traced_.end_vertex(v, node);
  }

  // The pieces of line r after the event: its first ray, the segment and its last ray, in the
  // direction of the line, and the joints between them. Returns an edge that two have become, or
  // -1.
  int relink(const local_state& s, unsigned r, std::array<joint, 3>& joints) {
    const auto [j, k] = others(r);
    const local::cell last = (s.grows[r][j] ? 1U << j : 0U) | (s.grows[r][k] ? 1U << k : 0U);
    const local::cell first = last ^ (1U << j | 1U << k);
    const local::cell segment = local::segment_label(s.small, r, true);
    // The joint between the first ray and the segment is where the cell changes its bit.
    joint& near = joints[((first ^ segment) == 1U << j) ? k : j];
    joint& far = joints[((last ^ segment) == 1U << j) ? k : j];
    const bool through_first = local::has_edge(s.event->after, r, first);
    const bool through_segment = local::has_edge(s.event->after, r, segment);
    const bool through_last = local::has_edge(s.event->after, r, last);
    const int e = s.edges[r][first];
    int f = s.edges[r][last];
    const int middle = s.edges[r][local::segment_label(s.small, r, false)];
    if ((through_first && e < 0) || (through_last && f < 0)) broken_invariant<K>("rays stay what they are in an event");
    const bool joins = through_first && through_last && through_segment && e != f;
    if (middle >= 0 && middle != e && middle != f) front_.erase(middle);
    if (joins) merge(e, f);
    if (through_first && through_last && !through_segment && e == f) f = cut(e);
    if (through_first && !(through_segment && through_last)) (through_segment ? far : near).in = e;
    if (through_last && !(through_segment && through_first)) (through_segment ? near : far).out = f;
    if (through_segment && !through_first && !through_last) broken_invariant<K>("no edge comes from nowhere");
    return joins ? e : -1;
  }

  // Edge e takes in edge f, which is before it on its line.
  void merge(int e, int f) {
    front_.erase(f);
    front_.edges[e].head = front_.edges[f].head;
    front_.vertices[front_.edges[f].head].in = e;
    traced_.merge_faces(front_.edges[e].face, front_.edges[f].face);
  }

  // Cuts edge e in two; returns the second part, which has its head.
  int cut(int e) {
    const int f = static_cast<int>(front_.edges.size());
    const auto whole = front_.edges[e];
    front_.edges.push_back({whole.line, -1, whole.head, whole.face, -1, -1, true});
    front_.insert_after(e, f);
    front_.vertices[whole.head].in = f;
    ++front_.living;
    return f;
  }

  // A new vertex gets the number of one that has ended: what is near in the plane stays near in
  // memory.
  int join(const joint& c, int node) {
    if (traced_.dead_slots.empty()) {
      traced_.dead_slots.push_back(static_cast<int>(front_.vertices.size()));
      front_.vertices.emplace_back();
    }
    const int v = traced_.dead_slots.back();
    traced_.dead_slots.pop_back();
    const line_id before = front_.edges[c.in].line;
    const line_id after = front_.edges[c.out].line;
    front_.vertices[v] = {c.in, c.out, before, after, -1, true, k_.orientation(before, after) == sign::negative};
    front_.edges[c.in].head = v;
    front_.edges[c.out].tail = v;
    traced_.begin_arc(v, node);
    return v;
  }

  const K& k_;
  traced_front& traced_;
  wavefront& front_;
};

}  // namespace osteon::plane
