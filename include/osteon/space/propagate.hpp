// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The event loop: from the boundary of a solid to its straight skeleton. One handler serves all events (design 02).

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/random.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/facet_insertion.hpp"
#include "osteon/space/preference.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/skeleton.hpp"
#include "osteon/space/wavefront.hpp"

namespace osteon {

struct skeleton_options {
  split_preference prefer = split_preference::convex;
  saddle_rule saddle = saddle_rule::convex;
  /// Where given, nothing is preferred: splits (see random_split) and outcomes of saddles are drawn, the same ones for the same number.
  std::optional<std::uint64_t> explore = std::nullopt;
};

/// One run of the wavefront. Candidates for events are meetings of four planes, nothing more: whether one is an event
/// is read off the wavefront at its moment, so candidates never become stale and need no bookkeeping.
template <kernel<3> K>
class propagation {
 public:
  propagation(const K& k, const boundary& solid, const skeleton_options& o)
      : k_(k), solid_(solid), options_(o), front_(solid.planes), now_(k.start()), queue_(later{&k}) {}

  /// Runs to the end. Throws degenerate_error, unsupported_error, undecided_error or invariant_error. A candidate costs one
  /// meeting; vertices look for contacts at all planes within the lifetime of their edges.
  skeleton run() {
    initialise();
    listed_.resize(front_.edges().size());
    for (std::size_t e = 0; e < front_.edges().size(); ++e) watch_collapse(static_cast<int>(e));
    for (std::size_t v = 0; v < front_.vertices().size(); ++v) watch_contacts(static_cast<int>(v));
    for (std::size_t e = 0; e < front_.edges().size(); ++e) watch_crossings(static_cast<int>(e));
    while (!front_.empty()) {
      if (queue_.empty()) broken_invariant<K>("the wavefront vanishes");
      const meeting m = queue_.top();
      queue_.pop();
      if (auto met = read(m)) {
        now_ = m;
        replace(*met);
      }
    }
    finish();
    return std::move(result_);
  }

 private:
  using meeting = typename K::meeting;
  using cell = local::cell;

  struct later {
    const K* k;
    bool operator()(const meeting& m, const meeting& n) const {
      const sign s = k->compare(m, n);
      return s != sign::zero ? s == sign::positive : quadruple(k->planes(m)) > quadruple(k->planes(n));
    }
  };

  // What the wavefront looks like around a meeting point: the edge of every piece, and the event.
  struct neighbourhood {
    quadruple q;
    cell small;
    std::array<std::array<int, 3>, 6> edges;
    const local::event* event;
  };

  // ---- the start

  void initialise() {
    const std::vector<split_tree> trees = split_vertices();
    for (std::size_t e = 0; e < solid_.edges.size(); ++e) {
      const auto [p, q] = std::minmax({solid_.edges[e].planes[0], solid_.edges[e].planes[1]});
      new_sheet(p, q, origin_[e]);
    }
    std::vector<int> front_edge(solid_.edges.size(), -1);
    add_input_edges(trees, front_edge);
    for (std::size_t v = 0; v < solid_.vertices.size(); ++v) {
      const auto& f = solid_.vertices[v].facets;
      quadruple some = {f[0], f[1], f[2], -1};
      std::sort(some.begin(), some.begin() + 3);
      result_.nodes.push_back({static_cast<int>(v), some, event_class::other, false, {}});
      if (f.size() == 3) {
        const auto& e = solid_.vertices[v].edges;
        add_corner({f[0], f[1], f[2]}, {front_edge[e[1]], front_edge[e[2]], front_edge[e[0]]});
      } else if (solid_.vertices[v].is_majority()) {
        add_majority(solid_.vertices[v], front_edge);
      } else {
        add_tree(solid_.vertices[v], trees[v], front_edge);
      }
    }
    for (const auto& v : front_.vertices()) set_sheets(v);
  }

  // The preferred tree of every vertex, after floods where there is none without.
  std::vector<split_tree> split_vertices() {
    for (const auto& v : solid_.vertices) input_degrees_.push_back(v.facets.size());
    origin_.resize(solid_.edges.size());
    std::iota(origin_.begin(), origin_.end(), 0);
    std::vector<split_tree> trees(solid_.vertices.size());
    std::vector<bool> unproven(solid_.vertices.size());
    std::vector<int> waiting(solid_.vertices.size());
    std::iota(waiting.begin(), waiting.end(), 0);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (auto tree = split(solid_, v)) {
        trees[v] = std::move(tree->tree);
        unproven[v] = !tree->proven;
        continue;
      }
      std::vector<facet_insertion> insertions;
      for (const bool calm : {true, false})
        for (int most = 1; most <= most_insertions && insertions.empty(); ++most) insertions = find_insertions(solid_, v, most, calm);
      if (insertions.empty()) {
        const auto& f = solid_.vertices[v].facets;
        if (f.size() == input_degrees_[v] && facet_insertions_at(k_, solid_, v).empty())
          broken_invariant<K>("a vertex of degree " + std::to_string(f.size()) + " has a valid split");
        // Floods chase each other along an edge for ever.
        throw unsupported_error("not yet: the vertex of planes " + std::to_string(f[0]) + ", " + std::to_string(f[1]) + " and " +
                                std::to_string(f[2]) +
                                " cannot be split, because a third facet contains the line of one of its edges; hint: move that facet a little");
      }
      waiting.push_back(v);
      for (const facet_insertion& f : insertions) {
        const int e = solid_.vertices[v].edges[f.side];
        waiting.push_back(solid_.edges[e].ends[solid_.edges[e].ends[0] == v ? 1 : 0]);
        origin_.push_back(origin_[e]);
        solid_ = after_insertion(std::move(solid_), f);
      }
    }
    result_.unproven_splits = static_cast<int>(std::count(unproven.begin(), unproven.end(), true));
    return trees;
  }

  // So many floods, one after the other, after which a vertex has a valid split and, if `calm`, the other ends have one too; empty where
  // there are none.
  std::vector<facet_insertion> find_insertions(const boundary& b, int v, int number, bool calm) const {
    for (const facet_insertion& f : facet_insertions_at(k_, b, v)) {
      const boundary next = after_insertion(b, f);
      const auto& ends = b.edges[b.vertices[v].edges[f.side]].ends;
      if (calm && !split(next, ends[ends[0] == v ? 1 : 0])) continue;
      if (number == 1) {
        if (split(next, v)) return {f};
        continue;
      }
      std::vector<facet_insertion> more = find_insertions(next, v, number - 1, calm);
      if (more.empty()) continue;
      more.insert(more.begin(), f);
      return more;
    }
    return {};
  }
  static constexpr int most_insertions = 3;

  // The preferred tree of a vertex, empty where it needs none; nothing where it has none.
  std::optional<chosen_split> split(const boundary& b, int v) const {
    if (b.vertices[v].facets.size() == 3 || b.vertices[v].is_majority()) return chosen_split{{}, true};
    if (b.vertices[v].facets.size() > input_degrees_[v] + most_insertions) return std::nullopt;
    const corner c = corner_at(b, v);
    return options_.explore ? random_split(k_, c, mixed(*options_.explore, v)) : preferred_split(k_, c, options_.prefer);
  }

  // One moving edge for each edge of the solid; one for several that become one where facets of one plane join.
  void add_input_edges(const std::vector<split_tree>& trees, std::vector<int>& front_edge) {
    std::vector<int> same(solid_.edges.size());
    std::iota(same.begin(), same.end(), 0);
    const auto root = [&same](int e) {
      while (same[e] != e) e = same[e];
      return e;
    };
    for (std::size_t v = 0; v < trees.size(); ++v)
      for (const auto& e : trees[v].edges)
        if (e.rays[1] >= 0) {
          const auto [p, q] = std::minmax({root(solid_.vertices[v].edges[e.rays[0]]), root(solid_.vertices[v].edges[e.rays[1]])});
          same[q] = p;
          result_.sheets[polygon_of(q)].representative = polygon_of(p);
        }
    for (int e = 0; e < static_cast<int>(same.size()); ++e) {
      const auto [p, q] = std::minmax({solid_.edges[e].planes[0], solid_.edges[e].planes[1]});
      front_edge[e] = root(e) == e ? front_.add_edge({{p, q}, {-1, -1}, {false, false}, solid_.edges[e].convex}, e) : front_edge[root(e)];
    }
  }

  // A vertex of three facets, counter-clockwise, and the edges opposite them.
  void add_corner(const triple& facets, const std::array<int, 3>& edges) {
    const int id = add_vertex(facets);
    const bool positive = generic_orientation(k_, facets[0], facets[1], facets[2]) == sign::positive;
    for (int r = 0; r < 3; ++r) join(edges[r], id, facets[r], front_.edges()[edges[r]].convex == positive);
  }

  void add_tree(const boundary::vertex& v, const split_tree& t, const std::vector<int>& front_edge) {
    std::vector<int> edges;
    for (const split_edge& e : t.edges) {
      const auto [p, q] = std::minmax({v.facets[e.a], v.facets[e.b]});
      edges.push_back(e.rays[0] >= 0 ? front_edge[v.edges[e.rays[0]]]
                                     : front_.add_edge({{p, q}, {-1, -1}, {false, false}, e.convex}, new_sheet(p, q, -1)));
    }
    for (std::size_t c = 0; c < t.vertices.size(); ++c) {
      const auto& facets = t.vertices[c];
      const auto& opposite = t.vertex_edges[c];
      add_corner({v.facets[facets[0]], v.facets[facets[1]], v.facets[facets[2]]}, {edges[opposite[0]], edges[opposite[1]], edges[opposite[2]]});
    }
  }

  void add_majority(const boundary::vertex& v, const std::vector<int>& front_edge) {
    const int id = add_vertex({v.facets[0], v.facets[1], v.facets[2]});
    for (int m = 0; m < 6; ++m) join(front_edge[v.edges[m]], id, v.facets[(m + 2) % 6], !solid_.edges[v.edges[m]].convex);
  }

  // ---- elements

  int new_sheet(plane_id p, plane_id q, int input_edge) {
    const int id = static_cast<int>(result_.sheets.size());
    result_.sheets.push_back({{p, q}, input_edge, id, {}});
    return id;
  }

  int polygon_of(int sheet) {
    while (result_.sheets[sheet].representative != sheet)
      sheet = result_.sheets[sheet].representative = result_.sheets[result_.sheets[sheet].representative].representative;
    return sheet;
  }

  // A vertex that begins at the newest node; its corner is known or set with its sheets.
  int add_vertex(triple planes, std::uint8_t corner = 0) {
    std::sort(planes.begin(), planes.end());
    if (front_.find_vertex(planes) >= 0) broken_invariant<K>("three planes meet in one vertex at most");
    const int source = static_cast<int>(result_.nodes.size()) - 1;
    const int id = front_.add_vertex(planes, static_cast<int>(result_.arcs.size()));
    result_.nodes[source].arcs.push_back(static_cast<int>(result_.arcs.size()));
    result_.arcs.push_back({source, -1, planes, corner, {}});
    return id;
  }

  void set_sheets(const wavefront::vertex& v) {
    auto& sheets = result_.arcs[v.arc].sheets;
    for (const int e : v.edges)
      if (e >= 0) sheets.push_back(front_.edges()[e].sheet);
    if (result_.arcs[v.arc].corner == 0) result_.arcs[v.arc].corner = corner_of(v);
    if (sheets.size() != 3 && sheets.size() != 6) broken_invariant<K>("a vertex has three edges, or six at a majority corner");
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

  void end_arc(int arc) {
    result_.arcs[arc].target = static_cast<int>(result_.nodes.size()) - 1;
    result_.nodes.back().arcs.push_back(arc);
  }

  // The end of edge e that faces plane `third` when e lies on the given side of it.
  int end_towards(int e, plane_id third, bool inside) const {
    const auto& planes = front_.edges()[e].planes;
    return runs_inside(k_, planes[0], planes[1], third, 0) == inside ? 0 : 1;
  }

  void join(int e, int v, plane_id third, bool inside) { front_.attach(e, end_towards(e, third, inside), v, third, inside); }

  // ---- candidates

  // Puts the meeting into the queue unless it is there, is past, or lies beyond the horizon.
  void consider(const std::optional<meeting>& m, const std::optional<meeting>& horizon) {
    if (!m || (horizon && k_.compare(*m, *horizon) == sign::positive) || k_.compare(*m, now_) != sign::positive) return;
    if (considered_.insert(k_.planes(*m)).second) queue_.push(*m);
  }

  void watch_collapse(int e) {
    if (!front_.edges()[e].alive) return;
    const auto& edge = front_.edges()[e];
    if (edge.third[0] < 0 || edge.third[1] < 0 || edge.third[0] == edge.third[1]) broken_invariant<K>("an edge has two different ends");
    collapse_.resize(std::max(collapse_.size(), static_cast<std::size_t>(e) + 1));
    auto m = k_.meet({edge.planes[0], edge.planes[1], edge.third[0], edge.third[1]});
    if (m && k_.compare(*m, now_) != sign::positive) m.reset();
    collapse_[e] = m;
    consider(m, std::nullopt);
  }

  // A vertex reaches a plane while its own edges live: only where the plane has an edge with one of its facets or, at a
  // reflex vertex, where the four planes enclose a tetrahedron; convex and majority corners nowhere
  // (tests/catalogue_test.cpp, EveryEventIsLookedFor). Beyond
  // the first collapse of one of its edges the vertex does not live, or that edge has changed and the vertex is watched again.
  void watch_contacts(int v) {
    const auto& vertex = front_.vertices()[v];
    if (!vertex.alive || !makes_contacts(v)) return;
    std::optional<meeting> horizon;
    for (const int e : vertex.edges)
      if (e >= 0 && collapse_[e] && (!horizon || k_.compare(*collapse_[e], *horizon) == sign::negative)) horizon = collapse_[e];
    // What was found up to a later horizon is in the queue.
    watched_until_.resize(std::max(watched_until_.size(), static_cast<std::size_t>(v) + 1));
    auto& until = watched_until_[v];
    if (until && (!*until || (horizon && k_.compare(*horizon, **until) != sign::positive))) return;
    until = horizon;
    std::vector<plane_id> neighbours;
    for (const plane_id p : vertex.planes)
      for (const int e : front_.of_facet(p)) {
        const auto& planes = front_.edges()[e].planes;
        neighbours.push_back(planes[planes[0] == p ? 1 : 0]);
      }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const plane_id l : neighbours) consider_contact(v, l);
    if (corner_of(v) != local::reflex) return;
    const auto& p = vertex.planes;
    for (plane_id l = 0; l < solid_.planes; ++l)
      if (!front_.of_facet(l).empty() && enclose({p[0], p[1], p[2], l})) consider_contact(v, l);
  }

  void consider_contact(int v, plane_id l) {
    const auto& p = front_.vertices()[v].planes;
    if (l != p[0] && l != p[1] && l != p[2]) consider(k_.meet({p[0], p[1], p[2], l}), *watched_until_[v]);
  }

  // Two facets have become neighbours: the vertices of either against the plane of the other.
  void watch_neighbours(int e) {
    if (!front_.edges()[e].alive) return;
    const auto& planes = front_.edges()[e].planes;
    for (const int side : {0, 1})
      for (const int f : front_.of_facet(planes[side]))
        for (const int v : front_.edges()[f].ends)
          if (makes_contacts(v)) consider_contact(v, planes[1 - side]);
  }

  std::uint8_t corner_of(int v) const { return result_.arcs[front_.vertices()[v].arc].corner; }
  bool makes_contacts(int v) const { return corner_of(v) != local::convex && corner_of(v) != local::majority; }

  // Whether the inner sides of four planes make a tetrahedron (the lambdas have one sign), or may make one where the kernel says zero.
  bool enclose(const quadruple& q) const {
    std::array<bool, 2> seen{};
    for (unsigned r = 0; r < 4; ++r) {
      const triple t = omit(q, r);
      const sign s = k_.orientation(t[0], t[1], t[2]);
      if (s != sign::zero) seen[(s == sign::positive) == (r % 2 == 0) ? 0 : 1] = true;
      if (seen[0] && seen[1]) return false;
    }
    return true;
  }

  // Two reflex edges cross, which ends a tetrahedron between them; each is watched until it collapses or changes.
  void watch_crossings(int e) {
    const auto& edge = front_.edges()[e];
    if (!edge.alive || edge.convex) return;
    if (!listed_[e]) reflex_.push_back(e);
    listed_[e] = true;
    std::size_t kept = 0;
    for (const int other : reflex_) {
      const auto& f = front_.edges()[other];
      if (!f.alive) continue;
      reflex_[kept++] = other;
      if (f.planes[0] == edge.planes[0] || f.planes[0] == edge.planes[1] || f.planes[1] == edge.planes[0] || f.planes[1] == edge.planes[1]) continue;
      const quadruple q = {edge.planes[0], edge.planes[1], f.planes[0], f.planes[1]};
      if (!enclose(q)) continue;
      const auto m = k_.meet(q);
      if (collapse_[other] && m && k_.compare(*m, *collapse_[other]) == sign::positive) continue;
      consider(m, collapse_[e]);
    }
    reflex_.resize(kept);
  }

  // ---- reading an event

  cell small_cell(const meeting& m) const {
    const quadruple q = k_.planes(m);
    const std::array<sign, 4> lambda = {-generic_orientation(k_, q[1], q[2], q[3]), generic_orientation(k_, q[0], q[2], q[3]),
                                        -generic_orientation(k_, q[0], q[1], q[3]), generic_orientation(k_, q[0], q[1], q[2])};
    cell small = 0;
    for (unsigned r = 0; r < 4; ++r)
      if (lambda[r] * k_.closing(m) == sign::positive) small |= 1U << r;
    return small;
  }

  // The local state at a meeting, or nothing where one of the planes' facets is not there.
  std::optional<neighbourhood> read(const meeting& m) const {
    neighbourhood n{k_.planes(m), 0, {}, nullptr};
    std::array<std::vector<int>, 6> near;
    unsigned with_edge = 0;
    for (unsigned p = 0; p < 6; ++p) {
      near[p] = edges_at(n.q, local::pairs[p], m);
      if (!near[p].empty()) with_edge |= 1U << local::pairs[p].i | 1U << local::pairs[p].j;
    }
    std::uint64_t key = 0;
    for (unsigned r = 0; r < 4; ++r) {
      if ((with_edge >> r & 1U) != 0) continue;
      if (!facet_contains(n.q, r, m)) return std::nullopt;
      key |= std::uint64_t{1} << (36 + r);
    }
    n.small = small_cell(m);
    for (unsigned p = 0; p < 6; ++p) {
      n.edges[p].fill(-1);
      for (unsigned w = 0; w < 3; ++w)
        for (const int e : near[p])
          if (covers(n.q, local::pairs[p], e, local::label(local::pairs[p], static_cast<local::place>(w), n.small, false))) {
            if (n.edges[p][w] >= 0) broken_invariant<K>("a piece of a line lies on one edge at most");
            n.edges[p][w] = e;
            key |= std::uint64_t{front_.edges()[e].convex ? 1U : 2U} << (2 * (3 * p + w));
          }
    }
    n.event = local::catalogue::get().find(n.small, key);
    if (n.event == nullptr) broken_invariant<K>("the boundary around a meeting point is in the catalogue");
    return n;
  }

  // The edges on the line of a pair that contain the meeting point.
  std::vector<int> edges_at(const quadruple& q, const local::pair_of_planes& p, const meeting& m) const {
    std::vector<int> result;
    const plane_id third = k_.transversal(q[p.i], q[p.j], q[p.k]) ? q[p.k] : q[p.l];
    for (const int e : front_.on_line(q[p.i], q[p.j])) {
      const auto& edge = front_.edges()[e];
      bool contains = true;
      for (int s = 0; s < 2 && contains; ++s)
        if (edge.third[s] != q[p.k] && edge.third[s] != q[p.l])
          contains = (generic_side(k_, edge.third[s], q[p.i], q[p.j], third, m) == sign::positive) == edge.inside[s];
      if (contains) result.push_back(e);
    }
    return result;
  }

  // Whether an edge through the meeting point contains the piece with the given label: each end at the point must lie
  // beyond.
  bool covers(const quadruple& q, const local::pair_of_planes& p, int e, cell label) const {
    const auto& edge = front_.edges()[e];
    for (int s = 0; s < 2; ++s)
      for (const unsigned r : {p.k, p.l})
        if (edge.third[s] == q[r] && ((label >> r & 1U) != 0) != edge.inside[s]) return false;
    return true;
  }

  // Whether the meeting point lies in the facet of q[r], none of whose edges is near.
  bool facet_contains(const quadruple& q, unsigned r, const meeting& m) const {
    const auto ids = front_.of_facet(q[r]);
    if (ids.empty()) return false;
    std::array<plane_id, 3> others{};
    for (unsigned s = 0, n = 0; s < 4; ++s)
      if (s != r) others[n++] = q[s];
    if (!k_.transversal(q[r], others[0], others[1])) std::swap(others[1], others[2]);
    if (!k_.transversal(q[r], others[0], others[1])) std::swap(others[0], others[2]);
    std::vector<segment> edges;
    edges.reserve(ids.size());
    for (const int e : ids) edges.push_back(front_.edges()[e]);
    return locate_in_facet(k_, edges, q[r], others[0], others[1], true, m, others[2]).value_or(false);
  }

  // ---- the event

  void replace(const neighbourhood& n) {
    const bool ambiguous = n.event->may_empty && n.event->may_fill;
    const bool fill = ambiguous ? choose(n) : n.event->may_fill;
    if (!n.event->may_empty && !n.event->may_fill) broken_invariant<K>("every event has an admissible outcome");
    const auto kind = local::classify(*n.event, fill);
    ++result_.events[static_cast<std::size_t>(kind)];
    result_.ambiguous += ambiguous ? 1 : 0;
    result_.nodes.push_back({-1, n.q, kind, ambiguous, {}});

    const local::state after = local::successor(*n.event, fill);
    std::array<bool, 4> before{};
    std::array<int, 4> made = {-1, -1, -1, -1};  // the new vertices, by the plane that they omit
    for (unsigned r = 0; r < 4; ++r) {
      before[r] = local::is_corner(local::corner_at(n.event->before, r, inside(n.small, r)));
      if (!before[r]) continue;
      const int v = front_.find_vertex(omit(n.q, r));
      if (v < 0) broken_invariant<K>("a corner of the local state is a vertex of the wavefront");
      end_arc(front_.vertices()[v].arc);
      front_.remove_vertex(v);
    }
    for (unsigned r = 0; r < 4; ++r) {
      const auto corner = local::corner_at(after, r, !inside(n.small, r));
      if (local::is_corner(corner)) made[r] = add_vertex(omit(n.q, r), corner);
    }

    std::vector<int> changed;
    const auto older = static_cast<int>(front_.edges().size());
    for (unsigned p = 0; p < 6; ++p) relink(n, p, after, before, made, changed);
    for (const int v : made)
      if (v >= 0) set_sheets(front_.vertices()[v]);

    listed_.resize(front_.edges().size());
    std::vector<int> watched;
    for (const int e : changed) {
      watch_collapse(e);
      for (const int v : front_.edges()[e].ends)
        if (std::find(watched.begin(), watched.end(), v) == watched.end()) watched.push_back(v);
    }
    for (const int v : watched) watch_contacts(v);
    for (int e = older; e < static_cast<int>(front_.edges().size()); ++e) watch_neighbours(e);
    for (const int e : changed) watch_crossings(e);
  }

  static bool inside(cell c, unsigned plane) { return (c >> plane & 1U) != 0; }

  // Rebuilds one line. Along it lie far_k, (i,j,k), the segment, (i,j,l), far_l before, and far_k, (i,j,l), the
  // segment, (i,j,k), far_l after; where a vertex is missing the edge runs through.
  void relink(const neighbourhood& n, unsigned p, local::state after, const std::array<bool, 4>& before, const std::array<int, 4>& made,
              std::vector<int>& changed) {
    const auto& pair = local::pairs[p];
    const plane_id k = n.q[pair.k];
    const plane_id l = n.q[pair.l];
    int at_k = n.edges[p][local::far_k];
    int at_l = n.edges[p][local::far_l];
    const int vertex_k = made[pair.l];  // (i,j,k) omits l
    const int vertex_l = made[pair.k];
    if (n.edges[p][local::segment] >= 0 && before[pair.k] && before[pair.l]) front_.remove_edge(n.edges[p][local::segment]);
    const auto side = [&](local::place w, unsigned r) { return inside(local::label(pair, w, n.small, true), r); };

    if (vertex_k < 0 && vertex_l < 0) {
      if (at_k >= 0 && at_l >= 0 && at_k != at_l) {  // two collinear edges become one
        const auto gone = front_.edges()[at_l];
        const int far = 1 - end_towards(at_l, l, side(local::far_l, pair.l));
        front_.remove_edge(at_l);
        result_.sheets[polygon_of(gone.sheet)].representative = polygon_of(front_.edges()[at_k].sheet);
        front_.attach(at_k, far, gone.ends[far], gone.third[far], gone.inside[far]);
        changed.push_back(at_k);
      }
      return;
    }
    if (at_k >= 0 && at_k == at_l) {  // an edge is cut: both pieces keep its sheet
      const auto whole = front_.edges()[at_k];
      at_l = front_.add_edge(whole, whole.sheet);
      const int far = 1 - end_towards(at_l, l, side(local::far_l, pair.l));
      front_.attach(at_l, far, whole.ends[far], whole.third[far], whole.inside[far]);
    }
    if (at_k >= 0) {
      if (vertex_l >= 0)
        join(at_k, vertex_l, l, side(local::far_k, pair.l));
      else
        join(at_k, vertex_k, k, side(local::far_k, pair.k));
      changed.push_back(at_k);
    }
    if (at_l >= 0) {
      if (vertex_k >= 0)
        join(at_l, vertex_k, k, side(local::far_l, pair.k));
      else
        join(at_l, vertex_l, l, side(local::far_l, pair.l));
      changed.push_back(at_l);
    }
    const local::piece kind = local::piece_at(after, pair, local::label(pair, local::segment, n.small, true));
    if (kind != local::piece::none && vertex_k >= 0 && vertex_l >= 0) {
      const plane_id i = n.q[pair.i];
      const plane_id j = n.q[pair.j];
      const int e = front_.add_edge({{i, j}, {-1, -1}, {false, false}, kind == local::piece::convex}, new_sheet(i, j, -1));
      join(e, vertex_k, k, side(local::segment, pair.k));
      join(e, vertex_l, l, side(local::segment, pair.l));
      changed.push_back(e);
    }
  }

  // A number that looks random.
  static std::uint64_t mixed(std::uint64_t seed, int n) { return random_stream::mixed(seed * random_stream::step + static_cast<std::uint64_t>(n)); }

  // At a saddle: whether the new cell becomes solid, which makes the new edge convex.
  bool choose(const neighbourhood& n) const {
    if (options_.explore) return (mixed(*options_.explore, -1 - static_cast<int>(result_.nodes.size())) & 1U) != 0;
    if (options_.saddle == saddle_rule::convex) return true;
    if (options_.saddle == saddle_rule::reflex) return false;
    const auto edge = [&](bool fill) {
      const local::state after = local::successor(*n.event, fill);
      const auto corner = [&](unsigned r) { return local::is_corner(local::corner_at(after, r, !inside(n.small, r))); };
      for (const auto& p : local::pairs)
        if (corner(p.k) && corner(p.l) && local::piece_at(after, p, local::label(p, local::segment, n.small, true)) != local::piece::none)
          return k_.bisector(n.q[p.i], n.q[p.j]);
      broken_invariant<K>("a saddle makes an edge");
    };
    const sign order = k_.compare(edge(true), edge(false));  // of the convex against the reflex edge
    return options_.saddle == saddle_rule::slower ? order != sign::positive : order == sign::positive;
  }

  // ---- the end

  void finish() {
    for (std::size_t s = 0; s < result_.sheets.size(); ++s) result_.sheets[s].representative = polygon_of(static_cast<int>(s));
    for (std::size_t a = 0; a < result_.arcs.size(); ++a) {
      if (result_.arcs[a].target < 0) broken_invariant<K>("every arc ends");
      for (const int s : result_.arcs[a].sheets) result_.sheets[s].arcs.push_back(static_cast<int>(a));
    }
    result_.cells.resize(solid_.planes);
    for (std::size_t s = 0; s < result_.sheets.size(); ++s)
      for (const plane_id f : result_.sheets[s].facets) result_.cells[f].push_back(static_cast<int>(s));
  }

  const K& k_;
  boundary solid_;                          // floods change it
  std::vector<std::size_t> input_degrees_;  // of the vertices before them
  std::vector<int> origin_;                 // by edge: the input's edge that it was
  skeleton_options options_;
  wavefront front_;
  skeleton result_;
  meeting now_;
  std::priority_queue<meeting, std::vector<meeting>, later> queue_;
  std::unordered_set<quadruple, plane_hash> considered_;
  std::vector<std::optional<meeting>> collapse_;
  std::vector<std::optional<std::optional<meeting>>> watched_until_;  // by vertex; inner nothing: for ever
  std::vector<int> reflex_;
  std::vector<bool> listed_;
};

/// The straight skeleton of a solid under a kernel that has its planes. See propagation::run for errors and cost.
template <kernel<3> K>
skeleton straight_skeleton(const K& k, const boundary& solid, const skeleton_options& o = {}) {
  return propagation<K>(k, solid, o).run();
}

}  // namespace osteon
