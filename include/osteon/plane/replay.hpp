// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate's replay of events.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/short_list.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/line_order.hpp"
#include "osteon/plane/replayed_front.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/structure.hpp"

namespace osteon::plane {

/// Repeats on a wavefront what a skeleton claims to happen, event by event, and checks that it can.
template <kernel<2> K>
class replay {
 public:
  replay(const K& k, const boundary& polygon, const skeleton& s, const skeleton_index& index, replayed_front<K>& front)
      : k_(k), polygon_(polygon), s_(s), index_(index), front_(front), edges_(front.edges), order_(k, polygon, front) {}

  /// Replays all nodes behind those of vertices; throws a refutation where one cannot be.
  /// *Requires* the front of the start.
  void run() {
    order_.begin();
    for (int n = static_cast<int>(polygon_.next.size()); n < static_cast<int>(s_.nodes.size()); ++n) {
      if (s_.nodes[n].zero_length)
        replay_zero_length(n);
      else
        replay_event(n);
    }
    check_shifted();
  }

 private:
  using meeting = typename K::meeting;

  // What a line contributes to an event: an edge that comes into the point, one that goes out of
  // it, and one that vanishes.
  struct pieces {
    int in = -1;
    int out = -1;
    int gone = -1;
  };
  // An arc that begins, between an edge that came in and one that goes out; by the numbers of their
  // lines in the node.
  struct link {
    int arc;
    std::size_t in;
    std::size_t out;
  };
  // An event as the skeleton claims it.
  struct claim {
    int node;
    const triple& lines;
    const meeting& when;
    std::array<pieces, 3> at{};  ///< by line
    bool vanishes = false;       ///< an edge does
    bool cut = false;            ///< an edge is cut in two
    short_list<link, 3> links{};
    int through = -1;  ///< the line on which two edges become one
  };

  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  // ---- one event

  void replay_event(int node) {
    const triple& q = s_.nodes[node].lines;
    const auto m = k_.meet(q);
    demand(m.has_value(), rule::order, "node", node, "its lines do not meet");
    demand(k_.compare(*m, front_.now) == sign::positive, rule::order, "node", node, "is not later than what comes before it");
    claim c{node, q, *m};
    collect_ends(c);
    find_cut(c);
    check_lengths(c);
    collect_starts(c);
    find_through(c);
    demand((s_.nodes[node].event == event_class::edge) == c.vanishes, rule::event, "node", node, "is of the other class");
    check_shifted();
    front_.now = *m;
    if constexpr (limit_kernel<K>)
      if (k_.has_moment(*m)) moment_ = *m;
    carry_out(c);
  }

  // The edges beside the arcs that end.
  void collect_ends(claim& c) const {
    const int ending = index_.ends.size(c.node);
    demand(ending >= 1 && ending <= 3, rule::event, "node", c.node, "ends no arc, or more than three");
    demand(index_.starts.size(c.node) <= 3, rule::event, "node", c.node, "begins more than three arcs");
    const auto set = [&c](int& to, int e) {
      demand(to < 0 || to == e, rule::event, "node", c.node, "two edges lie on one another");
      to = e;
    };
    for (const int* a = index_.ends.begin(c.node); a != index_.ends.end(c.node); ++a) {
      const int e = front_.edge_of[*a];
      const int f = edges_[e].after;
      const std::size_t r = position(c.lines, edges_[e].line);
      const std::size_t s = position(c.lines, edges_[f].line);
      demand(r < 3 && s < 3, rule::place, "arc", *a, "ends where its lines do not meet");
      const bool whole_e = s_.arcs[edges_[edges_[e].before].arc].target == c.node;
      const bool whole_f = s_.arcs[edges_[f].arc].target == c.node;
      set(whole_e ? c.at[r].gone : c.at[r].in, e);
      set(whole_f ? c.at[s].gone : c.at[s].out, f);
      c.vanishes = c.vanishes || whole_e;
    }
  }

  // A line without an edge beside those arcs has one that is cut.
  void find_cut(claim& c) const {
    const int ending = index_.ends.size(c.node);
    for (std::size_t r = 0; r < 3; ++r) {
      auto& [in, out, gone] = c.at[r];
      demand(gone < 0 || (in < 0 && out < 0), rule::event, "node", c.node, "two edges lie on one another");
      if (in >= 0 || out >= 0 || gone >= 0) continue;
      demand(ending == 1, rule::event, "node", c.node, "an edge on one of its lines is not concerned");
      in = out = order_.edge_through(c.lines[r], across(c.lines, r), c.when);
      demand(in >= 0, rule::event, "node", c.node, "no edge is there to be cut");
      c.cut = true;
    }
    demand(ending > 1 || c.cut, rule::event, "node", c.node, "an arc ends and nothing happens");
  }

  // Edges with an end in the point still have a length.
  void check_lengths(const claim& c) const {
    // The neighbour at the other end: zero where that end is in the point, too.
    const auto side_of_end = [&](std::size_t r, int neighbour) {
      const line_id x = edges_[neighbour].line;
      return position(c.lines, x) < 3 ? sign::zero : is_beyond(k_, c.lines[r], x, across(c.lines, r), c.when);
    };
    for (std::size_t r = 0; r < 3; ++r) {
      const auto& [in, out, gone] = c.at[r];
      if (in >= 0)
        demand(side_of_end(r, edges_[in].before) == sign::positive, rule::length, "node", c.node, "an edge that ends here has vanished before");
      if (out >= 0)
        demand(side_of_end(r, edges_[out].after) == sign::negative, rule::length, "node", c.node, "an edge that starts here has vanished before");
    }
  }

  // What goes on: every arc links an edge that came in to one that goes out.
  void collect_starts(claim& c) const {
    for (const int* a = index_.starts.begin(c.node); a != index_.starts.end(c.node); ++a) {
      const auto& faces = s_.arcs[*a].faces;
      const std::size_t r = position(c.lines, polygon_.line[faces[0]]);
      const std::size_t s = position(c.lines, polygon_.line[faces[1]]);
      demand(r < 3 && s < 3, rule::place, "arc", *a, "begins where its lines do not meet");
      demand(r != s && c.at[r].in >= 0 && c.at[s].out >= 0 && !is_linked(c, r, &link::in) && !is_linked(c, s, &link::out), rule::event, "arc", *a,
             "begins between edges that do not end and start there");
      demand(s_.faces[edges_[c.at[r].in].face] == faces[0] && s_.faces[edges_[c.at[s].out].face] == faces[1], rule::face, "arc", *a,
             "begins between edges of other faces");
      demand(edges_[c.at[r].in].after != c.at[s].out, rule::event, "arc", *a, "begins between the same edges as one that ends");
      c.links.push_back({*a, r, s});
    }
  }
  static bool is_linked(const claim& c, std::size_t r, std::size_t link::*side) {
    for (const link& l : c.links)
      if (l.*side == r) return true;
    return false;
  }

  // What is left over is one line's and becomes one edge.
  void find_through(claim& c) const {
    for (std::size_t r = 0; r < 3; ++r) {
      const auto& [in, out, gone] = c.at[r];
      const bool in_linked = is_linked(c, r, &link::in);
      const bool out_linked = is_linked(c, r, &link::out);
      if ((in < 0 || in_linked) && (out < 0 || out_linked)) continue;
      demand(in >= 0 && out >= 0 && !in_linked && !out_linked && in != out && c.through < 0, rule::event, "node", c.node,
             "edges that come in do not go on");
      c.through = static_cast<int>(r);
    }
  }

  // The replacement.
  void carry_out(claim& c) {
    for (auto& p : c.at) {
      if (p.gone >= 0) order_.leave(p.gone);
      if (c.cut && p.in >= 0 && p.in == p.out) {
        p.out = static_cast<int>(edges_.size());
        edges_.push_back(edges_[p.in]);
        front_.edge_of[edges_[p.out].arc] = p.out;
        edges_[edges_[p.out].after].before = p.out;
      }
    }
    for (const int* a = index_.ends.begin(c.node); a != index_.ends.end(c.node); ++a) front_.edge_of[*a] = -1;
    for (const link& l : c.links) {
      const int e = c.at[l.in].in;
      const int f = c.at[l.out].out;
      edges_[e].after = f;
      edges_[e].arc = l.arc;
      edges_[f].before = e;
      front_.edge_of[l.arc] = e;
    }
    if (c.through >= 0) {
      const int e = c.at[c.through].in;
      const int f = c.at[c.through].out;
      front_.merge_faces(s_, edges_[e].face, edges_[f].face, "node", c.node);
      edges_[e].after = edges_[f].after;
      edges_[e].arc = edges_[f].arc;
      edges_[edges_[f].after].before = e;
      front_.edge_of[edges_[f].arc] = e;
      order_.leave(f);
    }
    if (c.cut)
      for (const auto& p : c.at)
        if (p.out == static_cast<int>(edges_.size()) - 1) order_.enter(p.in, p.out);
  }

  // Another line through the point of an event, not parallel to line r.
  line_id across(const triple& q, std::size_t r) const {
    const line_id j = q[r == 0 ? 1 : 0];
    return k_.transversal(q[r], j) ? j : q[r == 2 ? 1 : 2];
  }

  // ---- edges of length zero

  // An edge goes that in the limit, but not before, has length zero at the last moment.
  void replay_zero_length(int node) {
    const int ending = index_.ends.size(node);
    demand(ending == 2 || ending == 3, rule::event, "node", node, "is of an edge without length and does not end two arcs or three");
    const int e = short_edge_between(node);
    const int in = edges_[e].before;
    const int out = edges_[e].after;
    for (const int* a = index_.ends.begin(node); a != index_.ends.end(node); ++a) front_.edge_of[*a] = -1;
    order_.leave(e);
    if (ending == 3) {
      demand(edges_[out].after == in && index_.starts.size(node) == 0, rule::event, "node", node, "ends three arcs that are not those of a triangle");
      order_.leave(in);
      order_.leave(out);
      return;
    }
    demand(index_.starts.size(node) == 1 && edges_[out].after != in, rule::event, "node", node,
           "is of an edge without length and does not begin one arc");
    const int a = *index_.starts.begin(node);
    demand(s_.arcs[a].faces == std::array<int, 2>{s_.faces[edges_[in].face], s_.faces[edges_[out].face]}, rule::face, "arc", a,
           "begins between edges of other faces");
    edges_[in].after = out;
    edges_[in].arc = a;
    edges_[out].before = in;
    edges_[e].after = -1;
    front_.edge_of[a] = in;
    shifted_.push_back(in);
    shifted_.push_back(out);
  }

  // The edge that goes in a node of zero length.
  int short_edge_between(int node) const {
    int e = -1;
    bool vanishes = false;
    for (const int* a = index_.ends.begin(node); a != index_.ends.end(node) && !vanishes; ++a) {
      const int f = edges_[front_.edge_of[*a]].after;
      if (s_.arcs[edges_[f].arc].target != node) continue;
      e = f;
      vanishes = is_short(f);
    }
    demand(e >= 0, rule::event, "node", node, "is of an edge without length, and none is between the arcs that end");
    const triple q = sorted(triple{edges_[edges_[e].before].line, edges_[e].line, edges_[edges_[e].after].line});
    demand(q == s_.nodes[node].lines && q[0] != q[1] && q[1] != q[2], rule::place, "node", node, "is not on the lines of the edge that vanishes");
    demand(vanishes, rule::length, "node", node, "is of an edge without length, but no edge has length zero in the limit");
    demand(s_.nodes[node].event == event_class::edge, rule::event, "node", node, "is of the other class");
    return e;
  }

  // Whether an edge has length zero in the limit at the last moment.
  bool is_short(int e) const {
    if constexpr (limit_kernel<K>) {
      const line_id out = edges_[edges_[e].after].line;
      return moment_ && k_.transversal(edges_[e].line, out) && k_.touches(out, edges_[edges_[e].before].line, edges_[e].line, *moment_);
    } else {
      return false;
    }
  }

  // Edges with an end that has jumped have a positive length, if they are still there.
  void check_shifted() {
    for (const int e : shifted_) {
      const auto& x = edges_[e];
      if (x.after < 0 || front_.edge_of[x.arc] != e) continue;
      demand(is_beyond(k_, x.line, edges_[x.before].line, edges_[x.after].line, front_.now) == sign::positive, rule::length, "edge on line", x.line,
             "is turned round where an edge without length goes");
    }
    shifted_.clear();
  }

  const K& k_;
  const boundary& polygon_;
  const skeleton& s_;
  const skeleton_index& index_;
  replayed_front<K>& front_;
  std::vector<typename replayed_front<K>::edge>& edges_;
  line_order<K> order_;
  std::optional<meeting> moment_;  // the last one that has a moment in the limit
  // edges of which an end has jumped where an edge without length went
  std::vector<int> shifted_;
};

}  // namespace osteon::plane
