// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The wavefront and the skeleton that it traces: what is cut, joined and relinked at an event.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/local_state.hpp"
#include "osteon/space/segment.hpp"
#include "osteon/space/skeleton.hpp"
#include "osteon/space/wavefront.hpp"

namespace osteon {

/// A wavefront, and the nodes, arcs and sheets that it has traced until now. Moving vertices trace
/// arcs and moving edges sheets; each begins at the newest node.
template <kernel<3> K>
class front_surgery {
 public:
  /// An empty wavefront of so many planes.
  front_surgery(const K& k, plane_id planes) : k_(k), front_(planes) {}

  /// Returns the wavefront as it is now.
  const wavefront& front() const { return front_; }
  /// Returns what it has traced until now.
  const skeleton& traced() const { return result_; }

  /// Adds a node: a vertex of the solid or an event.
  void add_node(const skeleton::node& n) { result_.nodes.push_back(n); }

  /// Adds a sheet between two facets (ascending) and returns its number. `input_edge`: the edge of
  /// the solid that sweeps it, or -1.
  int add_sheet(const std::array<plane_id, 2>& facets, int input_edge) {
    result_.sheets.push_back({facets, input_edge, -1, {}});
    return polygons_.add();
  }

  /// Makes two sheets parts of one polygon; the kept one's representative represents it.
  void merge_sheets(int gone, int kept) { polygons_.unite(gone, kept); }

  /// Adds a moving edge that has no ends yet and returns its number.
  int add_edge(const std::array<plane_id, 2>& planes, bool convex, int sheet) {
    return front_.add_edge({planes, {-1, -1}, {false, false}, convex}, sheet);
  }

  /// Adds a vertex that begins at the newest node and returns its number. Its corner is given here,
  /// or found by set_sheets.
  int add_vertex(const triple& planes, std::uint8_t corner = 0) {
    const triple ascending = sorted(planes);
    if (front_.find_vertex(ascending) >= 0) broken_invariant<K>("three planes meet in one vertex at most");
    const int source = static_cast<int>(result_.nodes.size()) - 1;
    const int arc = static_cast<int>(result_.arcs.size());
    result_.nodes[source].arcs.push_back(arc);
    result_.arcs.push_back({source, -1, ascending, corner, {}});
    return front_.add_vertex(ascending, corner, arc);
  }

  /// Makes a vertex the end of an edge; near it the edge lies inside or outside the vertex's third
  /// plane.
  void join(int edge, int vertex, plane_id third, bool inside) { front_.attach(edge, end_towards(edge, third, inside), vertex, third, inside); }

  /// Names the sheets beside a vertex's arc, and its corner.
  /// *Requires* that all its edges are joined.
  void set_sheets(int vertex) {
    auto& v = front_.at_vertex(vertex);
    auto& arc = result_.arcs[v.arc];
    for (const int e : v.edges)
      if (e >= 0) arc.sheets.push_back(front_.edges()[e].sheet);
    if (v.corner == 0) v.corner = arc.corner = corner_of(v);
    if (arc.sheets.size() != 3 && arc.sheets.size() != 6) broken_invariant<K>("a vertex has three edges, or six at a majority corner");
  }

  /// Replaces what surrounds an event by what follows it. `fill`: the cell that the event creates
  /// is solid.
  front_changes replace(const local_state& s, bool fill) {
    const local::state after = local::successor(*s.event, fill);
    record_event(s, fill);
    std::array<bool, 4> before{};
    for (unsigned r = 0; r < 4; ++r) {
      before[r] = local::is_corner(local::corner_at(s.event->before, r, local::is_inside(s.small, r)));
      if (before[r]) end_vertex(omit(s.planes, r));
    }
    std::array<int, 4> made = {-1, -1, -1, -1};
    for (unsigned r = 0; r < 4; ++r) {
      const auto corner = local::corner_at(after, r, !local::is_inside(s.small, r));
      if (local::is_corner(corner)) made[r] = add_vertex(omit(s.planes, r), corner);
    }
    front_changes changes{{}, static_cast<int>(front_.edges().size())};
    for (unsigned p = 0; p < 6; ++p) relink({s, after, before, made}, p, changes.edges);
    for (const int v : made)
      if (v >= 0) set_sheets(v);
    return changes;
  }

  /// Completes the skeleton and returns it.
  /// *Requires* that the wavefront is empty.
  skeleton finish() {
    for (std::size_t s = 0; s < result_.sheets.size(); ++s) result_.sheets[s].representative = polygons_.find(static_cast<int>(s));
    for (std::size_t a = 0; a < result_.arcs.size(); ++a) {
      if (result_.arcs[a].target < 0) broken_invariant<K>("every arc ends");
      for (const int s : result_.arcs[a].sheets) result_.sheets[s].arcs.push_back(static_cast<int>(a));
    }
    result_.cells.resize(front_.planes());
    for (std::size_t s = 0; s < result_.sheets.size(); ++s)
      for (const plane_id f : result_.sheets[s].facets) result_.cells[f].push_back(static_cast<int>(s));
    return std::move(result_);
  }

 private:
  // An event while it is carried out.
  struct transition {
    const local_state& at;
    local::state after;
    const std::array<bool, 4>& before;  // whether there was a vertex, by the plane that it omits
    const std::array<int, 4>& made;     // the new vertices, by the plane that they omit
  };

  void record_event(const local_state& s, bool fill) {
    const bool ambiguous = s.event->may_empty && s.event->may_fill;
    const event_class kind = local::classify(*s.event, fill);
    ++result_.events[static_cast<std::size_t>(kind)];
    result_.ambiguous += ambiguous ? 1 : 0;
    add_node({-1, s.planes, kind, ambiguous, {}});
  }

  // Ends the vertex of three planes, and its arc, in the newest node.
  void end_vertex(const triple& planes) {
    const int v = front_.find_vertex(planes);
    if (v < 0) broken_invariant<K>("a corner of the local state is a vertex of the wavefront");
    const int arc = front_.vertices()[v].arc;
    result_.arcs[arc].target = static_cast<int>(result_.nodes.size()) - 1;
    result_.nodes.back().arcs.push_back(arc);
    front_.remove_vertex(v);
  }

  // The corner with the edges of a vertex.
  std::uint8_t corner_of(const wavefront::vertex& v) const {
    for (const std::uint8_t g : local::corners) {
      bool fits = true;
      for (int slot = 0; slot < 6 && fits; ++slot) {
        const int e = v.edges[slot];
        const auto kind = e < 0 ? local::piece::none : (front_.edges()[e].convex ? local::piece::convex : local::piece::reflex);
        fits = local::corner_piece(g, static_cast<unsigned>(slot / 2), slot % 2 != 0) == kind;
      }
      if (fits) return g;
    }
    broken_invariant<K>("the edges of a vertex make one of the nine corners");
  }

  // The end of edge e that faces plane `third` when e lies on the given side of it.
  int end_towards(int e, plane_id third, bool inside) const {
    const auto& planes = front_.edges()[e].planes;
    return runs_inside(k_, planes[0], planes[1], third, 0) == inside ? 0 : 1;
  }

  // Gives an edge the end of another one.
  void take_end(int edge, const wavefront::edge& from, int end) { front_.attach(edge, end, from.ends[end], from.third[end], from.inside[end]); }

  // Rebuilds one line. Along it lie far_k, (i,j,k), the segment, (i,j,l), far_l before, and far_k,
  // (i,j,l), the segment, (i,j,k), far_l after; where a vertex is missing the edge runs through.
  void relink(const transition& t, unsigned p, std::vector<int>& changed) {
    const auto& pair = local::pairs[p];
    const auto& pieces = t.at.edges[p];
    const plane_id l = t.at.planes[pair.l];
    int at_k = pieces[local::far_k];
    int at_l = pieces[local::far_l];
    const int vertex_k = t.made[pair.l];  // (i,j,k) omits l
    const int vertex_l = t.made[pair.k];
    if (pieces[local::segment] >= 0 && t.before[pair.k] && t.before[pair.l]) front_.remove_edge(pieces[local::segment]);

    if (vertex_k < 0 && vertex_l < 0) {
      if (at_k >= 0 && at_l >= 0 && at_k != at_l) {  // two collinear edges become one
        const auto gone = front_.edges()[at_l];
        const int far = 1 - end_towards(at_l, l, side(t, p, local::far_l, pair.l));
        front_.remove_edge(at_l);
        merge_sheets(gone.sheet, front_.edges()[at_k].sheet);
        take_end(at_k, gone, far);
        changed.push_back(at_k);
      }
      return;
    }
    if (at_k >= 0 && at_k == at_l) {  // an edge is cut: both pieces keep its sheet
      const auto whole = front_.edges()[at_k];
      at_l = front_.add_edge(whole, whole.sheet);
      take_end(at_l, whole, 1 - end_towards(at_l, l, side(t, p, local::far_l, pair.l)));
    }
    if (at_k >= 0) {
      join_piece(t, p, at_k, local::far_k, vertex_l >= 0 ? pair.l : pair.k);
      changed.push_back(at_k);
    }
    if (at_l >= 0) {
      join_piece(t, p, at_l, local::far_l, vertex_k >= 0 ? pair.k : pair.l);
      changed.push_back(at_l);
    }
    const local::piece kind = local::piece_at(t.after, pair, local::label(pair, local::segment, t.at.small, true));
    if (kind != local::piece::none && vertex_k >= 0 && vertex_l >= 0) {
      const std::array<plane_id, 2> planes = {t.at.planes[pair.i], t.at.planes[pair.j]};
      const int e = add_edge(planes, kind == local::piece::convex, add_sheet(planes, -1));
      join_piece(t, p, e, local::segment, pair.k);
      join_piece(t, p, e, local::segment, pair.l);
      changed.push_back(e);
    }
  }

  // Joins an edge, which covers a piece of the line of pair p after the event, to the new vertex of
  // the line and plane number r.
  void join_piece(const transition& t, unsigned p, int e, local::section w, unsigned r) {
    const auto& pair = local::pairs[p];
    join(e, t.made[r == pair.k ? pair.l : pair.k], t.at.planes[r], side(t, p, w, r));
  }

  // Whether a piece of the line of pair p lies inside plane number r after the event.
  static bool side(const transition& t, unsigned p, local::section w, unsigned r) {
    return local::is_inside(local::label(local::pairs[p], w, t.at.small, true), r);
  }

  const K& k_;
  wavefront front_;
  skeleton result_;
  disjoint_sets polygons_;  // of sheets
};

}  // namespace osteon
