// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The event loop in the plane: from the outline of a polygon to its straight skeleton. One handler serves all events (design 02, 06).

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/box_tree.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/prefetch.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/catalogue.hpp"
#include "osteon/plane/event_queue.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/wavefront.hpp"

namespace osteon::plane {

/// Where lines meet and vertices move, as enclosures (see motion.hpp of the kernels). Decides nothing: it only spares the kernel questions.
template <class M>
concept motion_bounds = requires(const M& m, const triple& q, const triple* birth, line_id a, typename M::path p, double t) {
  { m.frame() } -> std::convertible_to<box>;
  { m.speed() } -> std::convertible_to<double>;
  { m.is_stationary(a) } -> std::same_as<bool>;
  { m.time(q) } -> std::same_as<interval>;
  { m.sharp_time(q) } -> std::same_as<interval>;
  { m.place(q) } -> std::same_as<box>;
  { m.begin(a, a, birth) } -> std::same_as<typename M::path>;
  { m.swept(p, t, t) } -> std::same_as<box>;
};

struct skeleton_options {
  bool outside = false;  ///< the interior is not bounded: vertices may move for ever
  /// When to stop, in the motion's unit of time. Nothing later is computed; vertices that live then have no target.
  double until = std::numeric_limits<double>::infinity();
};

/// One run of the wavefront. A candidate for an event is an edge that vanishes, or a reflex vertex and an edge that it may hit; one whose elements
/// have changed is dropped, because what changes is looked at anew. What the event is, is read off the wavefront at its moment. Reflex vertices and
/// the edges they may reach are found window of time by window of time, by overlapping boxes of what they sweep in it.
template <kernel<2> K, motion_bounds Motion>
class propagation {
 public:
  propagation(const K& k, const boundary& polygon, const Motion& motion, const skeleton_options& o = {})
      : k_(k), polygon_(polygon), motion_(motion), options_(o), now_(k.start()), moment_(now_), queue_(k) {}

  /// Runs to the end. Throws unsupported_error (a part of the wavefront stands still for ever), undecided_error or invariant_error.
  /// Cost: n log n in practice for n vertices; memory linear.
  skeleton run() {
    if (!(motion_.speed() > 0)) never_vanishes(0);
    initialise();
    while (alive_ > 0) {
      queue_.advance([this](std::span<const candidate> candidates) { prefetch_around(candidates); },
                     [this](const candidate& c) { return is_current(c) ? k_.meet(lines_of(c)) : std::nullopt; });
      if (window_.last < infinity) {
        if (queue_.empty() || !(queue_.top_time().last <= window_.last)) {
          if (window_.last >= options_.until) break;
          if (8 * changes_ < static_cast<int>(front_.edges.size())) step_ *= 2;
          // A meeting whose time is not known well must not be overtaken.
          open_window(queue_.empty() ? window_.last : std::clamp(queue_.top_time().first, window_.first, window_.last));
          continue;
        }
        if (2 * changes_ > static_cast<int>(front_.edges.size()) + 100) {
          // Too much happens: what has changed crowds the trees.
          const double time = std::clamp(when_.first, window_.first, window_.last);
          step_ = std::clamp((time - window_.first) / 2, step_ / 16, step_ / 2);
          window_.last = time;
          open_window(time);
          continue;
        }
      } else {
        if (queue_.empty() && !collapse_zero_length_edges()) break;
        if (queue_.empty()) continue;
      }
      if ((!fresh_.empty() || !merged_.empty()) && !same_moment(queue_.top().when) && collapse_zero_length_edges()) continue;
      const auto [m, c] = queue_.pop();
      if (!is_current(c) || lines_of(c) != triple(k_.planes(m)) || k_.compare(m, now_) != sign::positive) continue;
      if (const auto found = read(c, m)) {
        now_ = m;
        if constexpr (limit_kernel<K>)
          if (k_.has_moment(now_)) moment_ = now_;
        when_ = c.when;
        replace(*found);
      }
    }
    if (alive_ > 0 && !options_.outside && !(options_.until < infinity)) {
      for (const auto& e : front_.edges)
        if (e.alive && !motion_.is_stationary(e.line)) broken_invariant<K>("the wavefront vanishes");
      never_vanishes(std::find_if(front_.edges.begin(), front_.edges.end(), [](const auto& e) { return e.alive; })->face);
    }

    for (auto& f : result_.faces) f = face_of(static_cast<int>(&f - result_.faces.data()));
    for (auto& a : result_.arcs)
      for (int& f : a.faces) f = result_.faces[f];
    return std::move(result_);
  }

 private:
  using meeting = typename K::meeting;
  using cell = local::cell;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr interval never = {infinity, infinity};

  // What is known of the way of a vertex.
  struct alignas(64) track {
    typename Motion::path path;
    box swept{};                                                    ///< what it sweeps in this window
    double known_until = -std::numeric_limits<double>::infinity();  ///< so far that reaches
    int contact = -1;                                               ///< an edge it hits, so the queue says
  };

  // What the wavefront looks like around a meeting point: the edge on every piece of the three lines, by label.
  struct neighbourhood {
    triple q;
    cell small;
    const local::event* event;
    std::array<std::array<int, 8>, 3> edges;
    std::array<std::array<bool, 3>, 3> grows;  ///< by two of the lines
  };

  [[noreturn]] static void never_vanishes(int edge) {
    throw unsupported_error("edges of weight zero, among them that of vertex " + std::to_string(edge) +
                            ", enclose a part of the polygon that never vanishes; hint: give one of them a weight");
  }

  // ---- the start

  void initialise() {
    const int n = static_cast<int>(polygon_.next.size());
    // In general position there are as many events as vertices, half of them edges that vanish.
    result_.nodes.reserve(2 * polygon_.next.size());
    result_.arcs.reserve(3 * polygon_.next.size());
    result_.faces.reserve(polygon_.next.size());
    front_.edges.reserve(3 * polygon_.next.size() / 2);
    collapse_.reserve(3 * polygon_.next.size() / 2);
    front_.vertices.reserve(polygon_.next.size());
    tracks_.reserve(polygon_.next.size());
    std::vector<int> previous(n);
    for (int i = 0; i < n; ++i) previous[polygon_.next[i]] = i;
    for (int i = 0; i < n; ++i) {
      triple lines = {polygon_.line[previous[i]], polygon_.line[i], -1};
      if (lines[0] > lines[1]) std::swap(lines[0], lines[1]);
      result_.nodes.push_back({i, lines, event_class::edge});
      result_.faces.push_back(i);
      front_.edges.push_back({polygon_.line[i], i, polygon_.next[i], i, -1, -1, true});
      front_.vertices.push_back({previous[i], i, polygon_.line[previous[i]], polygon_.line[i], -1, true, false});
    }
    alive_ = n;
    straighten();
    for (int v = 0; v < n; ++v)
      if (front_.vertices[v].alive) begin_arc(v, v);
    std::vector<int> ranked(n);
    for (int e = 0; e < n; ++e) ranked[polygon_.rank[e]] = e;
    int last = -1;
    for (const int e : ranked) {
      if (!front_.edges[e].alive) continue;
      if (last >= 0 && front_.edges[last].line == front_.edges[e].line) front_.insert_after(last, e);
      last = e;
    }
    for (int v = 0; v < n; ++v) tracks_.push_back({motion_.begin(front_.line_before(v), front_.line_after(v), nullptr)});
    collapse_.assign(n, never);
    for (int e = 0; e < n; ++e)
      if (front_.edges[e].alive) watch_collapse(e);
    numbered_ = n;
    window_ = {0, 0};
    step_ = spacing() / motion_.speed() / 8;
  }

  // How far apart things are in the beginning, about.
  double spacing() const {
    const auto n = static_cast<double>(tracks_.size());
    const box& frame = motion_.frame();
    double length = 0;
    for (std::size_t v = 0; v < tracks_.size(); ++v) {
      const box& a = tracks_[v].path.start;
      const box& b = tracks_[polygon_.next[v]].path.start;
      length += std::hypot(a.low[0] - b.low[0], a.low[1] - b.low[1]);
    }
    return std::min(length / n, std::sqrt((frame.high[0] - frame.low[0]) * (frame.high[1] - frame.low[1]) / n));
  }

  // Of two edges that point in the same direction and meet at a vertex, one runs along the other infinitely fast: the faster one where the
  // perturbation makes the vertex convex, else the slower one. Edges of one line become one.
  void straighten() {
    std::vector<int> waiting(front_.vertices.size());
    for (std::size_t v = 0; v < waiting.size(); ++v) waiting[v] = static_cast<int>(v);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (!front_.vertices[v].alive) continue;
      const int in = front_.vertices[v].in;
      const int out = front_.vertices[v].out;
      const line_id a = front_.edges[in].line;
      const line_id b = front_.edges[out].line;
      if (a != b && k_.transversal(a, b)) continue;
      const bool in_stays = a == b || (k_.orientation(a, b) == sign::positive) == is_faster(a, b);
      front_.vertices[v].alive = false;
      --alive_;
      if (in_stays) {
        front_.edges[out].alive = false;
        front_.edges[in].head = front_.edges[out].head;
        front_.vertices[front_.edges[out].head].in = in;
        front_.vertices[front_.edges[out].head].before = a;
        waiting.push_back(front_.edges[out].head);
      } else {
        front_.edges[in].alive = false;
        front_.edges[out].tail = front_.edges[in].tail;
        front_.vertices[front_.edges[in].tail].out = out;
        front_.vertices[front_.edges[in].tail].after = b;
        waiting.push_back(front_.edges[in].tail);
      }
      if (a == b) merge_faces(front_.edges[in].face, front_.edges[out].face);
    }
  }

  // Whether line a is faster than the parallel line b: with any third line, S = lambda_a (sigma_a - sigma_b).
  bool is_faster(line_id a, line_id b) const {
    line_id c = 0;
    while (!k_.transversal(a, c)) ++c;
    triple q = {a, b, c};
    std::sort(q.begin(), q.end());
    return k_.closing(*k_.meet(q)) == lambda(q, static_cast<unsigned>(std::find(q.begin(), q.end(), a) - q.begin()));
  }

  static triple sorted(triple q) {
    std::sort(q.begin(), q.end());
    return q;
  }

  int face_of(int f) {
    while (result_.faces[f] != f) f = result_.faces[f] = result_.faces[result_.faces[f]];
    return f;
  }
  void merge_faces(int f, int g) {
    f = face_of(f);
    g = face_of(g);
    result_.faces[std::max(f, g)] = std::min(f, g);
  }

  void begin_arc(int v, int node) {
    auto& vertex = front_.vertices[v];
    vertex.reflex = k_.orientation(vertex.before, vertex.after) == sign::negative;
    vertex.arc = static_cast<int>(result_.arcs.size());
    result_.arcs.push_back({node, -1, {front_.edges[vertex.in].face, front_.edges[vertex.out].face}});
  }

  // ---- windows and candidates

  // Whether the wavefront is the outside of one convex polygon: then nothing meets any more.
  bool surrounds() const {
    const auto first = std::ranges::find_if(front_.vertices, &wavefront::vertex::alive) - front_.vertices.begin();
    int v = static_cast<int>(first);
    int length = 0;
    do {
      if (!front_.vertices[v].reflex) return false;
      v = front_.edges[front_.vertices[v].out].head;
      ++length;
    } while (v != first && length < alive_);
    return v == first && length == alive_;
  }

  // Neighbours become neighbours in memory, and dead elements are forgotten.
  void renumber() {
    const auto renumbered = front_.renumber();
    if (!renumbered) broken_invariant<K>("the wavefront consists of closed rings");
    const wavefront::numbering& now = *renumbered;
    numbered_ = static_cast<int>(result_.nodes.size());
    std::vector<interval> collapse;
    std::vector<track> tracks;
    collapse.reserve(front_.edges.capacity());
    tracks.reserve(front_.vertices.capacity());
    collapse.resize(front_.edges.size());
    tracks.resize(front_.vertices.size());
    for (std::size_t e = 0; e < now.edges.size(); ++e)
      if (now.edges[e] >= 0) collapse[now.edges[e]] = collapse_[e];
    for (std::size_t v = 0; v < now.vertices.size(); ++v)
      if (now.vertices[v] >= 0) {
        track& t = tracks[now.vertices[v]] = tracks_[v];
        if (t.contact >= 0) t.contact = now.edges[t.contact];
      }
    collapse_ = std::move(collapse);
    tracks_ = std::move(tracks);
    free_.clear();
    for (int& e : fresh_) e = now.edges[e];
    for (merge& m : merged_) m.edge = now.edges[m.edge];
    std::erase(fresh_, -1);
    std::erase_if(merged_, [](const merge& m) { return m.edge < 0; });
    queue_.restart([&](candidate& c) {
      c.edge = now.edges[c.edge];
      if (c.vertex >= 0) c.vertex = now.vertices[c.vertex];
      return c.edge >= 0 && (c.arc < 0 || c.vertex >= 0) && is_current(c);
    });
  }

  // Looks for all contacts of the next stretch of time.
  void open_window(double from) {
    changes_ = 0;
    // Every time would be slower where little happens in a window.
    if (numbered_ + alive_ / 4 < static_cast<int>(result_.nodes.size()))
      renumber();
    else
      queue_.restart([this](const candidate& c) { return is_current(c); });
    const int edges = static_cast<int>(front_.edges.size());
    const int vertices = static_cast<int>(front_.vertices.size());
    const auto is_reflex = [](const auto& v) { return v.alive && v.reflex; };
    contacts_ = std::ranges::any_of(front_.vertices, is_reflex) && !(options_.outside && surrounds());
    window_ = {from, contacts_ ? std::min(std::max(from, window_.last) + step_, options_.until) : options_.until};
    if (!(window_.last > window_.first)) window_.last = infinity;
    for (int e = 0; e < edges; ++e)
      if (front_.edges[e].alive && collapse_[e].first > queued_until_ && collapse_[e].first <= window_.last && collapse_[e].first < infinity &&
          !queue_collapse(e, lines_at(e), collapse_[e]))
        collapse_[e] = never;
    queued_until_ = std::max(queued_until_, window_.last);
    if (!contacts_) return;
    box frame;
    for (int v = 0; v < vertices; ++v) {
      if (!front_.vertices[v].alive) continue;
      tracks_[v].known_until = life(v);
      tracks_[v].swept = swept(v);
      frame.add(tracks_[v].swept);
    }
    edge_boxes_.clear(frame);
    vertex_boxes_.clear(frame);
    for (int e = 0; e < edges; ++e)
      if (front_.edges[e].alive) boxes_of_edge(e, [&](const box& b) { edge_boxes_.add(e, b); });
    for (int v = 0; v < vertices; ++v)
      if (is_reflex(front_.vertices[v])) vertex_boxes_.add(v, tracks_[v].swept);
    edge_boxes_.build();
    vertex_boxes_.build();
    for (int v = 0; v < vertices; ++v) {
      if (is_reflex(front_.vertices[v])) look_from_vertex(v);
      if (pairs_.size() > 64) consider_pairs();
    }
    consider_pairs();
  }

  // No longer than this is a vertex what it is, as far as is known.
  double life(int v) const { return std::min(window_.last, std::min(collapse_[front_.vertices[v].in].last, collapse_[front_.vertices[v].out].last)); }

  // Between its start and where it may end. Vertices of nearly parallel lines are fast, but do not come far.
  box swept(int v) const {
    box b = motion_.swept(tracks_[v].path, window_.first, tracks_[v].known_until);
    const int in = front_.vertices[v].in;
    const int out = front_.vertices[v].out;
    const int e = collapse_[in].last < collapse_[out].last ? in : out;
    if (collapse_[e].last < infinity) {
      box whole = tracks_[v].path.start;
      whole.add(motion_.place(lines_at(e)));
      b.cut(whole);
    }
    return b;
  }

  // The lines of an edge and of its neighbours.
  triple lines_at(int e) const {
    return sorted({front_.line_before(front_.edges[e].tail), front_.edges[e].line, front_.line_after(front_.edges[e].head)});
  }

  // Pieces of an edge's box: long edges that are not parallel to an axis have boxes that are mostly empty.
  template <class Body>
  void boxes_of_edge(int e, Body body) const {
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

  void insert_edge(int e) {
    boxes_of_edge(e, [&](const box& b) { edge_boxes_.insert(e, b); });
  }
  void insert_vertex(int v) { vertex_boxes_.insert(v, tracks_[v].swept); }

  void look_from_vertex(int v) {
    edge_boxes_.search(tracks_[v].swept, [&](int e) { pairs_.push_back({v, e}); });
  }
  void look_from_edge(int e) {
    boxes_of_edge(e, [&](const box& b) { vertex_boxes_.search(b, [&](int v) { pairs_.push_back({v, e}); }); });
  }

  // Those that the searches have found, together, so that they wait together for what is far in memory.
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

  // The reflex vertex reaches the line of the edge from inside, on the edge as it is now. Should the edge change, it is looked at again. So it is
  // when the edge between neighbours changes, which is watched itself.
  void consider_contact(int v, int e) {
    const line_id a = front_.line_before(v);
    const line_id b = front_.line_after(v);
    const line_id c = front_.edges[e].line;
    if (tracks_[v].contact == e) return;
    const triple q = sorted({a, b, c});
    const interval when = motion_.time(q);
    const double until = std::min({tracks_[v].known_until, tracks_[front_.edges[e].tail].known_until, tracks_[front_.edges[e].head].known_until});
    if (when.first > until || when.last < window_.first || are_neighbours(v, e)) return;
    const auto m = k_.meet(q);
    if (!m || k_.compare(*m, now_) != sign::positive) return;
    // The vertex is reflex, so lambda_c is negative where its lines come in the order of the triple.
    const auto place = [&q](line_id l) { return std::find(q.begin(), q.end(), l) - q.begin(); };
    if (k_.closing(*m) != ((place(a) + 1) % 3 == place(b) ? sign::negative : sign::positive)) return;
    const line_id x = k_.transversal(c, a) ? a : b;
    if (!contains(e, x, a, b, *m)) return;
    const interval sharp = motion_.sharp_time(q);
    if (!(sharp.first < infinity)) return;
    queue_.push(*m, {sharp, e, v, front_.vertices[v].arc});
    tracks_[v].contact = e;
  }

  // Whether one edge is between them: where it vanishes they meet.
  bool are_neighbours(int v, int e) const {
    const auto& vertex = front_.vertices[v];
    return front_.edges[e].tail == front_.edges[vertex.out].head || front_.edges[e].head == front_.edges[vertex.in].tail;
  }

  // Whether the point where the edge's line meets lines a and b lies on the edge; x is the one of these to be asked.
  bool contains(int e, line_id x, line_id a, line_id b, const meeting& m) const {
    const line_id line = front_.edges[e].line;
    const line_id t = front_.line_before(front_.edges[e].tail);
    const line_id h = front_.line_after(front_.edges[e].head);
    // Behind a convex tail, and before a reflex head, the line is inside of the other one.
    if (t != a && t != b && (k_.side(t, line, x, m) == sign::positive) == front_.vertices[front_.edges[e].tail].reflex) return false;
    return h == a || h == b || (k_.side(h, line, x, m) == sign::positive) != front_.vertices[front_.edges[e].head].reflex;
  }

  void watch_collapse(int e) {
    collapse_[e] = never;
    const triple q = lines_at(e);
    if (q[0] == q[1] || q[1] == q[2]) return;
    const interval when = motion_.sharp_time(q);
    if (when.last < when_.first || !(when.first < infinity)) return;
    if (when.first <= when_.last) fresh_.push_back(e);
    collapse_[e] = when;
    if (when.first <= queued_until_ && !queue_collapse(e, q, when)) collapse_[e] = never;
  }

  // Whether three lines still meet. Collapses beyond all windows so far wait: most edges have changed by then.
  bool queue_collapse(int e, const triple& q, const interval& when) {
    const auto m = k_.meet(q);
    if (!m || k_.compare(*m, now_) != sign::positive) return false;
    queue_.push(*m, {when, e});
    return true;
  }

  // ---- events

  // Brings near what the handling of these candidates will ask for: their elements and their neighbours along the wavefront, step by step, at each of
  // which all wait together.
  void prefetch_around(std::span<const candidate> candidates) {
    for (const candidate& c : candidates) {
      prefetch(front_.edges[c.edge]);
      if (c.vertex >= 0) prefetch(front_.vertices[c.vertex]);
    }
    walkers_.clear();
    for (const candidate& c : candidates) {
      prefetch(collapse_[c.edge]);
      prefetch_line(front_.edges[c.edge].line);
      walkers_.push_back({front_.edges[c.edge].tail, false});
      walkers_.push_back({front_.edges[c.edge].head, true});
      if (c.vertex >= 0)
        for (const bool forward : {false, true}) walkers_.push_back({c.vertex, forward});
    }
    for (const walker& w : walkers_) prefetch(front_.vertices[w.vertex]);
    for (int step = 0; step < 2; ++step) {
      for (const walker& w : walkers_) {
        const auto& vertex = front_.vertices[w.vertex];
        const int e = w.forward ? vertex.out : vertex.in;
        prefetch(tracks_[w.vertex]);
        if (step == 0) prefetch(result_.arcs[vertex.arc]);
        prefetch(front_.edges[e]);
        prefetch(collapse_[e]);
        prefetch_line(w.forward ? vertex.after : vertex.before);
      }
      for (walker& w : walkers_) {
        const auto& vertex = front_.vertices[w.vertex];
        w.vertex = w.forward ? front_.edges[vertex.out].head : front_.edges[vertex.in].tail;
        prefetch(front_.vertices[w.vertex]);
      }
    }
    for (const bool deep : {false, true})
      for (const candidate& c : candidates) {
        const box& swept = tracks_[c.vertex >= 0 ? c.vertex : front_.edges[c.edge].tail].swept;
        edge_boxes_.prefetch(swept, deep);
        vertex_boxes_.prefetch(swept, deep);
      }
  }
  void prefetch_line(line_id l) const {
    if constexpr (requires { k_.prefetch(l); }) k_.prefetch(l);
    if constexpr (requires { motion_.prefetch(l); }) motion_.prefetch(l);
  }

  // Sign of lambda_r of an ascending triple.
  sign lambda(const triple& q, unsigned r) const {
    if (r == 0) return k_.orientation(q[1], q[2]);
    return r == 1 ? -k_.orientation(q[0], q[2]) : k_.orientation(q[0], q[1]);
  }

  static std::array<unsigned, 2> others(unsigned r) { return {r == 0 ? 1U : 0U, r == 2 ? 1U : 2U}; }

  // Whether the edge and its neighbours, or the vertex, are still there.
  bool is_current(const candidate& c) const {
    if (!front_.edges[c.edge].alive) return false;
    if (c.vertex >= 0) return front_.vertices[c.vertex].alive && front_.vertices[c.vertex].arc == c.arc;
    return collapse_[c.edge].first == c.when.first && collapse_[c.edge].last == c.when.last;
  }
  triple lines_of(const candidate& c) const {
    return c.vertex < 0 ? lines_at(c.edge) : sorted({front_.line_before(c.vertex), front_.line_after(c.vertex), front_.edges[c.edge].line});
  }

  // What the wavefront looks like where and when lines of it meet; nothing where that is beside the edge.
  std::optional<neighbourhood> read(const candidate& c, const meeting& m) const {
    neighbourhood n{k_.planes(m), 0, nullptr, {}, {}};
    const std::array<sign, 3> turns = {k_.orientation(n.q[1], n.q[2]), -k_.orientation(n.q[0], n.q[2]), k_.orientation(n.q[0], n.q[1])};
    for (unsigned r = 0; r < 3; ++r) {
      n.edges[r].fill(-1);
      if (turns[r] == k_.closing(m)) n.small |= 1U << r;
      for (const unsigned o : others(r)) n.grows[r][o] = (o == (r + 1) % 3) == (turns[3 - r - o] == sign::negative);
    }
    const auto& e = front_.edges[c.edge];
    if (c.vertex >= 0) {
      const line_id a = front_.line_before(c.vertex);
      const line_id b = front_.line_after(c.vertex);
      if (!contains(c.edge, k_.transversal(e.line, a) ? a : b, a, b, m)) return std::nullopt;
    }
    const int before = front_.vertices[c.vertex >= 0 ? c.vertex : e.tail].in;
    const int after = front_.vertices[c.vertex >= 0 ? c.vertex : e.head].out;
    local::view seen = 0;
    for (const int f : {c.edge, before, after}) {
      unsigned r = 0;
      while (n.q[r] != front_.edges[f].line) ++r;
      const local::view own = see(n, r, f);
      if (own == 0) return std::nullopt;
      seen |= own;
      // Another edge on the line reaches the point only with an end on one of the other two lines.
      for (int g = front_.edges[f].previous; g >= 0 && is_other(n, r, front_.line_after(front_.edges[g].head)); g = front_.edges[g].previous)
        seen |= see(n, r, g);
      for (int g = front_.edges[f].next; g >= 0 && is_other(n, r, front_.line_before(front_.edges[g].tail)); g = front_.edges[g].next)
        seen |= see(n, r, g);
    }
    n.event = local::find(n.small, seen);
    if (n.event == nullptr) return std::nullopt;
    return n;
  }

  // Whether a line is one of the two that are not line r.
  static bool is_other(const neighbourhood& n, unsigned r, line_id l) { return l != n.q[r] && std::find(n.q.begin(), n.q.end(), l) != n.q.end(); }

  // Notes the pieces of line r that an edge covers.
  local::view see(neighbourhood& n, unsigned r, int e) const {
    const line_id t = front_.line_before(front_.edges[e].tail);
    const line_id h = front_.line_after(front_.edges[e].head);
    cell never_in = 1U << r;  // sides of the lines where it is not
    cell always_in = 0;
    for (const unsigned o : others(r)) {
      if (t == n.q[o]) (n.grows[r][o] ? always_in : never_in) |= 1U << o;
      if (h == n.q[o]) (n.grows[r][o] ? never_in : always_in) |= 1U << o;
    }
    local::view seen = 0;
    for (cell label = 0; label < 8; ++label) {
      if ((label & never_in) != 0 || (always_in & ~label) != 0 || label == local::segment_label(n.small, r, true)) continue;
      n.edges[r][label] = e;
      seen |= local::piece_bit(r, label);
    }
    return seen;
  }

  // A corner of two of the three lines after the event: the edge that ends there and the one that starts.
  struct corner {
    int in = -1;
    int out = -1;
  };

  void replace(const neighbourhood& n) {
    const int node = static_cast<int>(result_.nodes.size());
    if (node > 8 * static_cast<int>(polygon_.next.size())) broken_invariant<K>("there are not more events than edges and vertices");
    result_.nodes.push_back({-1, n.q, event_class::edge});
    ++changes_;
    const bool vanished = end_arcs(n, node);
    std::array<corner, 3> corners;  // by the line that is not there
    std::array<int, 3> merged{};
    for (unsigned r = 0; r < 3; ++r) merged[r] = relink(n, r, corners);
    result_.nodes.back().event = vanished ? event_class::edge : event_class::split;
    ++result_.events[vanished ? 0 : 1];
    std::array<int, 9> touched{};
    int count = 0;
    for (unsigned r = 0; r < 3; ++r)
      if (merged[r] >= 0) {
        touched[count++] = merged[r];
        const auto [j, k] = others(r);
        merged_.push_back({merged[r], node, k_.transversal(n.q[r], n.q[j]) ? n.q[j] : n.q[k]});
      }
    for (const corner& c : corners) {
      if (c.in < 0 && c.out < 0) continue;
      if (c.in < 0 || c.out < 0) broken_invariant<K>("a vertex joins two edges");
      add_vertex(c, n.q, node);
      touched[count++] = c.in;
      touched[count++] = c.out;
    }
    std::sort(touched.begin(), touched.begin() + count);
    count = static_cast<int>(std::unique(touched.begin(), touched.begin() + count) - touched.begin());
    watch(touched, count);
  }

  // Edges with a new end.
  void watch(const std::array<int, 9>& edges, int count) {
    for (int i = 0; i < count; ++i) watch_collapse(edges[i]);
    watch_contacts(edges, count);
  }

  // Whether the present moment goes on with this meeting, as far as it matters to settle().
  bool same_moment(const meeting& m) const {
    if constexpr (limit_kernel<K>) return !k_.has_moment(m) || k_.same_moment(m, moment_);
    return true;
  }

  // At the end of a moment. Where two reflex vertices meet, the edges between them vanish together; perturbed, one goes first and another one,
  // of length zero in the limit, would grow again. The skeleton is discontinuous there, and by its definition edges of length zero go (AAAG95, 2). So
  // they do: what that changes is infinitely small. Tells whether there was one.
  bool collapse_zero_length_edges() {
    bool any = false;
    if constexpr (limit_kernel<K>)
      for (std::size_t i = 0; i < fresh_.size(); ++i)
        if (const int e = fresh_[i]; front_.edges[e].alive) {
          const line_id t = front_.line_before(front_.edges[e].tail);
          const line_id h = front_.line_after(front_.edges[e].head);
          const line_id line = front_.edges[e].line;
          // Between parallel edges of different speed it is needed as their step.
          if (!k_.transversal(t, h) || !k_.transversal(line, h) || !k_.touches(h, t, line, moment_)) continue;
          remove(e);
          any = true;
        }
    if constexpr (limit_kernel<K>)
      for (const merge& m : merged_) {
        const auto& e = front_.edges[m.edge];
        if (!e.alive) continue;
        for (const int v : {e.tail, e.head})
          if (result_.arcs[front_.vertices[v].arc].source < m.node && k_.touches(m.other, front_.line_before(v), front_.line_after(v), moment_))
            result_.interior_nodes.push_back({front_.vertices[v].arc, m.node});
      }
    merged_.clear();
    fresh_.clear();
    return any;
  }

  // Takes an edge of length zero out of its ring.
  void remove(int e) {
    const int tail = front_.edges[e].tail;
    const int head = front_.edges[e].head;
    const corner joined = {front_.vertices[tail].in, front_.vertices[head].out};
    const triple lines = lines_at(e);
    const int node = static_cast<int>(result_.nodes.size());
    result_.nodes.push_back({-1, lines, event_class::edge, true});
    ++result_.events[0];
    erase_edge(e);
    const auto end = [&](int v) { end_vertex(v, node); };
    end(tail);
    end(head);
    if (front_.edges[joined.in].tail == front_.edges[joined.out].head) {  // nothing is left of the ring
      end(front_.edges[joined.in].tail);
      for (const int last : {joined.in, joined.out}) erase_edge(last);
      return;
    }
    add_vertex(joined, lines, node);
    watch({joined.in, joined.out}, 2);
  }

  // The vertices at the point end; tells whether an edge between two of them vanishes.
  bool end_arcs(const neighbourhood& n, int node) {
    bool vanished = false;
    for (unsigned r = 0; r < 3; ++r) {
      const int e = n.edges[r][local::segment_label(n.small, r, false)];
      for (const int f : n.edges[r]) {
        if (f < 0) continue;
        end_arc(front_.edges[f].tail, n, node);
        end_arc(front_.edges[f].head, n, node);
      }
      if (e < 0) continue;
      const auto [j, k] = others(r);
      const line_id t = front_.line_before(front_.edges[e].tail);
      const line_id h = front_.line_after(front_.edges[e].head);
      vanished = vanished || (t == n.q[j] && h == n.q[k]) || (t == n.q[k] && h == n.q[j]);
    }
    return vanished;
  }

  void end_arc(int v, const neighbourhood& n, int node) {
    auto& vertex = front_.vertices[v];
    const auto meets = [&](line_id l) { return std::find(n.q.begin(), n.q.end(), l) != n.q.end(); };
    if (!vertex.alive || !meets(front_.line_before(v)) || !meets(front_.line_after(v))) return;
    end_vertex(v, node);
  }
  void end_vertex(int v, int node) {
    front_.vertices[v].alive = false;
    result_.arcs[front_.vertices[v].arc].target = node;
    free_.push_back(v);
  }

  // The pieces of line r after the event: its first ray, the segment and its last ray, in the direction of the line, and the corners between them.
  // Returns an edge that two have become, or -1.
  int relink(const neighbourhood& n, unsigned r, std::array<corner, 3>& corners) {
    const line_id line = n.q[r];
    const auto [j, k] = others(r);
    const cell last = (n.grows[r][j] ? 1U << j : 0U) | (n.grows[r][k] ? 1U << k : 0U);
    const cell first = last ^ (1U << j | 1U << k);
    const cell segment = local::segment_label(n.small, r, true);
    // The corner between the first ray and the segment is where the cell changes its bit.
    corner& near = corners[((first ^ segment) == 1U << j) ? k : j];
    corner& far = corners[((last ^ segment) == 1U << j) ? k : j];
    const bool through_first = local::has_edge(n.event->after, r, first);
    const bool through_segment = local::has_edge(n.event->after, r, segment);
    const bool through_last = local::has_edge(n.event->after, r, last);
    int e = n.edges[r][first];
    int f = n.edges[r][last];
    const int middle = n.edges[r][local::segment_label(n.small, r, false)];
    if ((through_first && e < 0) || (through_last && f < 0)) broken_invariant<K>("rays stay what they are in an event");
    const bool middle_dies = middle >= 0 && middle != e && middle != f;
    const bool joins = through_first && through_last && through_segment && e != f;
    if (middle_dies) erase_edge(middle);
    if (joins) erase_edge(f);
    if (joins) {  // two edges of a line become one
      front_.edges[e].head = front_.edges[f].head;
      front_.vertices[front_.edges[f].head].in = e;
      merge_faces(front_.edges[e].face, front_.edges[f].face);
    }
    if (through_first && through_last && !through_segment && e == f) {  // cut in two
      f = static_cast<int>(front_.edges.size());
      front_.edges.push_back({line, -1, front_.edges[e].head, front_.edges[e].face, -1, -1, true});
      front_.insert_after(e, f);
      front_.vertices[front_.edges[e].head].in = f;
      collapse_.push_back(never);
      ++alive_;
    }
    if (through_first && !(through_segment && through_last)) (through_segment ? far : near).in = e;
    if (through_last && !(through_segment && through_first)) (through_segment ? near : far).out = f;
    if (through_segment && !through_first && !through_last) broken_invariant<K>("no edge comes from nowhere");
    return joins ? e : -1;
  }

  void erase_edge(int e) {
    front_.erase(e);
    --alive_;
  }

  // In the place of one that has ended: what is near in the plane stays near in memory.
  void add_vertex(const corner& c, const triple& birth, int node) {
    if (free_.empty()) {
      free_.push_back(static_cast<int>(front_.vertices.size()));
      front_.vertices.emplace_back();
      tracks_.emplace_back();
    }
    const int v = free_.back();
    free_.pop_back();
    front_.vertices[v] = {c.in, c.out, front_.edges[c.in].line, front_.edges[c.out].line, -1, true, false};
    front_.edges[c.in].head = v;
    front_.edges[c.out].tail = v;
    begin_arc(v, node);
    tracks_[v] = {motion_.begin(front_.edges[c.in].line, front_.edges[c.out].line, &birth)};
  }

  // These edges, vertices that live longer than was known, and the edges at them, are looked at anew.
  void watch_contacts(const std::array<int, 9>& edges, int count) {
    if (!contacts_) return;
    std::array<int, 18> vertices{};
    int more = 0;
    for (int i = 0; i < count; ++i)
      for (const int v : {front_.edges[edges[i]].tail, front_.edges[edges[i]].head}) {
        const double until = life(v);
        if (until <= tracks_[v].known_until) continue;
        tracks_[v].known_until = until;
        tracks_[v].swept = swept(v);
        vertices[more++] = v;
      }
    std::array<int, 45> changed{};
    int all = count;
    std::copy_n(edges.begin(), count, changed.begin());
    for (int i = 0; i < more; ++i) {
      changed[all++] = front_.vertices[vertices[i]].in;
      changed[all++] = front_.vertices[vertices[i]].out;
    }
    std::sort(changed.begin(), changed.begin() + all);
    all = static_cast<int>(std::unique(changed.begin(), changed.begin() + all) - changed.begin());
    for (int i = 0; i < all; ++i) {
      insert_edge(changed[i]);
      look_from_edge(changed[i]);
    }
    for (int i = 0; i < more; ++i) {
      if (!front_.vertices[vertices[i]].reflex) continue;
      insert_vertex(vertices[i]);
      look_from_vertex(vertices[i]);
    }
    consider_pairs();
  }

  const K& k_;
  const boundary& polygon_;
  const Motion& motion_;
  const skeleton_options options_;
  wavefront front_;
  meeting now_;
  meeting moment_;  // the last one that has a moment in the limit
  event_queue<K> queue_;
  skeleton result_;
  int alive_ = 0;
  std::vector<int> free_;  // dead vertices

  interval window_{0, 0};
  interval when_{0, 0};              // contains the present moment
  double queued_until_ = -infinity;  // so far all collapses are in the queue
  double step_ = 0;
  bool contacts_ = true;    // some are possible
  int changes_ = 0;         // in this window
  int numbered_ = 0;        // how many nodes there were when elements got their numbers
  std::vector<int> fresh_;  // edges that have changed at this moment and may have no length
  // Edges that have become one with another on their line at this moment, at a node of a third line.
  struct merge {
    int edge;
    int node;
    line_id other;
  };
  std::vector<merge> merged_;
  std::vector<track> tracks_;       // by vertex
  std::vector<interval> collapse_;  // by edge: when it vanishes, as it is
  struct walker {
    int vertex;
    bool forward;
  };
  std::vector<walker> walkers_;  // used by warm()
  struct pair {
    int vertex;
    int edge;
  };
  std::vector<pair> pairs_;  // used by consider_pairs()
  box_tree edge_boxes_;
  box_tree vertex_boxes_;
};

}  // namespace osteon::plane
