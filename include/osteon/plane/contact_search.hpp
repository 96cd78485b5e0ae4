// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Which reflex vertices may hit which edges: found window of time by window of time, by
/// overlapping boxes of what they sweep in it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/prefetch.hpp"
#include "osteon/core/short_list.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/front_surgery.hpp"
#include "osteon/plane/local_state.hpp"
#include "osteon/plane/motion_bounds.hpp"
#include "osteon/plane/schedule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/wavefront.hpp"

namespace osteon::plane {

/// Follows vertices and enters their contacts with edges into the schedule. All contacts until the
/// end of the window are in it; a contact whose elements change counts no more, because what
/// changes is searched for anew.
template <kernel<2> K, motion_bounds Motion>
class contact_search {
 public:
  contact_search(const K& k, const Motion& motion, const skeleton_options& o, const wavefront& front, schedule<K, Motion>& times)
      : k_(k), motion_(motion), options_(o), front_(front), times_(times) {}

  /// Returns the present window of time. No candidate is missing before its end.
  const interval& window() const { return window_; }

  /// Begins the paths of all vertices of the wavefront of a polygon at time zero.
  void begin(const boundary& polygon) {
    tracks_.reserve(front_.vertices.size());
    for (int v = 0; v < static_cast<int>(front_.vertices.size()); ++v)
      tracks_.push_back({motion_.begin(front_.line_before(v), front_.line_after(v), nullptr)});
    step_ = spacing(polygon) / motion_.speed() / 8;
  }

  /// Makes the next window longer, or shorter when the present one ends early because too much
  /// happens in it.
  void lengthen() { step_ *= 2; }
  /// Ends the window earlier.
  void shorten(double end) {
    step_ = std::clamp((end - window_.first) / 2, step_ / 16, step_ / 2);
    window_.last = end;
  }

  /// Opens the next window, which begins at `from`, and searches for all contacts in it. Where none
  /// can come any more it lasts until the end.
  void open_window(double from) {
    contacts_ = are_contacts_possible();
    window_ = {from, contacts_ ? std::min(std::max(from, window_.last) + step_, options_.until) : options_.until};
    if (!(window_.last > window_.first)) window_.last = infinity;
    times_.queue_until(window_.last);
    if (contacts_) search_all();
  }

  /// Searches for contacts of what has changed: these edges, vertices that live longer than was
  /// known, and the edges at them.
  void watch(const front_change& change) {
    for (const int v : change.vertices) {
      if (tracks_.size() <= static_cast<std::size_t>(v)) tracks_.resize(static_cast<std::size_t>(v) + 1);
      tracks_[v] = {motion_.begin(front_.line_before(v), front_.line_after(v), &change.lines)};
    }
    if (!contacts_) return;
    short_list<int, 18> vertices;
    for (const int e : change.edges)
      for (const int v : {front_.edges[e].tail, front_.edges[e].head}) {
        const double until = life(v);
        if (until <= tracks_[v].known_until) continue;
        tracks_[v].known_until = until;
        tracks_[v].swept = swept(v);
        vertices.push_back(v);
      }
    short_list<int, 45> edges;
    for (const int e : change.edges) edges.push_back(e);
    for (const int v : vertices) {
      edges.push_back(front_.vertices[v].in);
      edges.push_back(front_.vertices[v].out);
    }
    edges.sort_unique();
    for (const int e : edges) {
      each_box(e, [&](const box& b) { edge_boxes_.insert(e, b); });
      search_from_edge(e);
    }
    for (const int v : vertices) {
      if (!front_.vertices[v].reflex) continue;
      vertex_boxes_.insert(v, tracks_[v].swept);
      search_from_vertex(v);
    }
    consider_pairs();
  }

  /// Follows a renumbering of the wavefront.
  void renumber(const wavefront::numbering& now) {
    std::vector<track> tracks;
    tracks.reserve(front_.vertices.capacity());
    tracks.resize(front_.vertices.size());
    for (std::size_t v = 0; v < now.vertices.size(); ++v)
      if (now.vertices[v] >= 0) {
        track& t = tracks[now.vertices[v]] = tracks_[v];
        if (t.contact >= 0) t.contact = now.edges[t.contact];
      }
    tracks_ = std::move(tracks);
  }

  /// Brings near what is known of vertex v.
  void prefetch_track(int v) const { prefetch(tracks_[v]); }
  /// Brings near the boxes around vertex v (see box_tree::prefetch).
  void prefetch_boxes(int v, bool deep) const {
    edge_boxes_.prefetch(tracks_[v].swept, deep);
    vertex_boxes_.prefetch(tracks_[v].swept, deep);
  }
  /// Brings near what kernel and bounds know of a line.
  void prefetch_line(line_id l) const {
    if constexpr (requires { k_.prefetch(l); }) k_.prefetch(l);
    if constexpr (requires { motion_.prefetch(l); }) motion_.prefetch(l);
  }

 private:
  using meeting = typename K::meeting;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // What is known of the path of a vertex.
  struct alignas(64) track {
    typename Motion::path path;
    box swept{};                     ///< what it sweeps in this window
    double known_until = -infinity;  ///< so far that reaches
    int contact = -1;                ///< an edge it hits, so the queue says
  };
  struct pair {
    int vertex;
    int edge;
  };

  // How far apart things are in the beginning, about.
  double spacing(const boundary& polygon) const {
    const auto n = static_cast<double>(tracks_.size());
    const box& frame = motion_.frame();
    double length = 0;
    for (std::size_t v = 0; v < tracks_.size(); ++v) {
      const box& a = tracks_[v].path.start;
      const box& b = tracks_[polygon.next[v]].path.start;
      length += std::hypot(a.low[0] - b.low[0], a.low[1] - b.low[1]);
    }
    return std::min(length / n, std::sqrt((frame.high[0] - frame.low[0]) * (frame.high[1] - frame.low[1]) / n));
  }

  bool are_contacts_possible() const {
    const auto is_reflex = [](const auto& v) { return v.alive && v.reflex; };
    return std::ranges::any_of(front_.vertices, is_reflex) && !(options_.outside && surrounds());
  }

  // Whether the wavefront is the outside of one convex polygon: then nothing meets any more.
  bool surrounds() const {
    const auto first = std::ranges::find_if(front_.vertices, &wavefront::vertex::alive) - front_.vertices.begin();
    int v = static_cast<int>(first);
    int length = 0;
    do {
      if (!front_.vertices[v].reflex) return false;
      v = front_.edges[front_.vertices[v].out].head;
      ++length;
    } while (v != first && length < front_.living);
    return v == first && length == front_.living;
  }

  // All contacts until the end of the window.
  void search_all() {
    const int vertices = static_cast<int>(front_.vertices.size());
    box frame;
    for (int v = 0; v < vertices; ++v) {
      if (!front_.vertices[v].alive) continue;
      tracks_[v].known_until = life(v);
      tracks_[v].swept = swept(v);
      frame.add(tracks_[v].swept);
    }
    edge_boxes_.clear(frame);
    vertex_boxes_.clear(frame);
    for (int e = 0; e < static_cast<int>(front_.edges.size()); ++e)
      if (front_.edges[e].alive) each_box(e, [&](const box& b) { edge_boxes_.add(e, b); });
    const auto is_reflex = [this](int v) { return front_.vertices[v].alive && front_.vertices[v].reflex; };
    for (int v = 0; v < vertices; ++v)
      if (is_reflex(v)) vertex_boxes_.add(v, tracks_[v].swept);
    edge_boxes_.build();
    vertex_boxes_.build();
    for (int v = 0; v < vertices; ++v) {
      if (is_reflex(v)) search_from_vertex(v);
      if (pairs_.size() > 64) consider_pairs();
    }
    consider_pairs();
  }

  // No longer than this is a vertex what it is, as far as is known.
  double life(int v) const {
    const auto& vertex = front_.vertices[v];
    return std::min(window_.last, std::min(times_.collapse(vertex.in).last, times_.collapse(vertex.out).last));
  }

  // Between its start and where it may end. Vertices of nearly parallel lines are fast, but do not
  // come far.
  box swept(int v) const {
    box b = motion_.swept(tracks_[v].path, window_.first, tracks_[v].known_until);
    const int in = front_.vertices[v].in;
    const int out = front_.vertices[v].out;
    const int e = times_.collapse(in).last < times_.collapse(out).last ? in : out;
    if (times_.collapse(e).last < infinity) {
      box whole = tracks_[v].path.start;
      whole.add(motion_.place(front_.lines_around(e)));
      b.cut(whole);
    }
    return b;
  }

  // Calls body for pieces of an edge's box: long edges that are not parallel to an axis have boxes
  // that are mostly empty.
  template <class Body>
  void each_box(int e, Body body) const {
    const box& a = tracks_[front_.edges[e].tail].swept;
    const box& b = tracks_[front_.edges[e].head].swept;
    const double width = std::min(std::abs(a.low[0] - b.low[0]), std::abs(a.low[1] - b.low[1]));
    const double own = std::max({a.high[0] - a.low[0], a.high[1] - a.low[1], b.high[0] - b.low[0], b.high[1] - b.low[1], motion_.speed() * step_});
    const int pieces = std::clamp(static_cast<int>(width / own), 1, 16);
    box from = a;
    for (int i = 1; i <= pieces; ++i) {
      box to = b;
      if (i < pieces)
        for (int axis = 0; axis < 2; ++axis) {
          to.low[axis] = a.low[axis] + (b.low[axis] - a.low[axis]) * i / pieces;
          to.high[axis] = a.high[axis] + (b.high[axis] - a.high[axis]) * i / pieces;
        }
      box piece = from;
      piece.add(to);
      body(piece);
      from = to;
    }
  }

  void search_from_vertex(int v) {
    edge_boxes_.search(tracks_[v].swept, [&](int e) { pairs_.push_back({v, e}); });
  }
  void search_from_edge(int e) {
    each_box(e, [&](const box& b) { vertex_boxes_.search(b, [&](int v) { pairs_.push_back({v, e}); }); });
  }

  // Those that the searches have found, together, so that they wait together for what is far in
  // memory.
  void consider_pairs() {
    for (const auto& [v, e] : pairs_) {
      prefetch(front_.vertices[v]);
      prefetch(front_.edges[e]);
      prefetch(tracks_[v]);
    }
    std::erase_if(pairs_, [this](const pair& p) {
      const auto& vertex = front_.vertices[p.vertex];
      const auto& edge = front_.edges[p.edge];
      return !vertex.alive || !edge.alive || vertex.before == edge.line || vertex.after == edge.line || tracks_[p.vertex].contact == p.edge;
    });
    for (const auto& [v, e] : pairs_) {
      prefetch_line(front_.line_before(v));
      prefetch_line(front_.line_after(v));
      prefetch_line(front_.edges[e].line);
      prefetch(tracks_[front_.edges[e].tail].known_until);
      prefetch(tracks_[front_.edges[e].head].known_until);
    }
    for (const auto& [v, e] : pairs_) consider_contact(v, e);
    pairs_.clear();
  }

  // The reflex vertex reaches the line of the edge from inside, on the edge as it is now. Should
  // the edge change, it is looked at again. So it is when the edge between neighbours changes,
  // which is watched itself.
  void consider_contact(int v, int e) {
    if (tracks_[v].contact == e) return;
    const line_id a = front_.line_before(v);
    const line_id b = front_.line_after(v);
    const triple q = sorted(triple{a, b, front_.edges[e].line});
    const interval when = motion_.time(q);
    const double until = std::min({tracks_[v].known_until, tracks_[front_.edges[e].tail].known_until, tracks_[front_.edges[e].head].known_until});
    if (when.first > until || when.last < window_.first || are_neighbours(v, e)) return;
    const auto m = times_.coming(q);
    if (!m) return;
    // The vertex is reflex, so lambda_c is negative where its lines come in the order of the
    // triple.
    if (k_.closing(*m) != ((position(q, a) + 1) % 3 == position(q, b) ? sign::negative : sign::positive)) return;
    if (!contains_point(k_, front_, e, a, b, *m)) return;
    const interval sharp = motion_.sharp_time(q);
    if (!(sharp.first < infinity)) return;
    times_.queue(*m, {sharp, e, v, front_.vertices[v].arc});
    tracks_[v].contact = e;
  }

  // Whether one edge is between them: where it vanishes they meet.
  bool are_neighbours(int v, int e) const {
    const auto& vertex = front_.vertices[v];
    return front_.edges[e].tail == front_.edges[vertex.out].head || front_.edges[e].head == front_.edges[vertex.in].tail;
  }

  const K& k_;
  const Motion& motion_;
  const skeleton_options& options_;
  const wavefront& front_;
  schedule<K, Motion>& times_;
  interval window_{0, 0};
  double step_ = 0;            // the length of windows
  bool contacts_ = true;       // some are possible in this window
  std::vector<track> tracks_;  // by vertex
  std::vector<pair> pairs_;    // found and not yet considered
  box_tree edge_boxes_;
  box_tree vertex_boxes_;
};

}  // namespace osteon::plane
