// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Which four planes may be an event, and when: edges that collapse, vertices that reach a plane,
/// edges that cross.

#include <algorithm>
#include <array>
#include <optional>
#include <queue>
#include <unordered_set>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/catalogue.hpp"
#include "osteon/space/wavefront.hpp"

namespace osteon {

/// The candidates of a wavefront in order of time. A candidate is a meeting, nothing more: it never
/// becomes stale.
template <kernel<3> K>
class contact_search {
 public:
  using meeting = typename K::meeting;

  /// Follows the wavefront as it changes.
  contact_search(const K& k, const wavefront& front) : k_(k), front_(front), now_(k.start()), queue_(later{&k}) {}

  /// Looks for candidates of the whole wavefront, just after the start.
  /// *Complexity* a meeting for each candidate; reflex vertices look at all planes, reflex edges at
  /// each other.
  void start() {
    for (std::size_t e = 0; e < front_.edges().size(); ++e) watch_collapse(static_cast<int>(e));
    for (std::size_t v = 0; v < front_.vertices().size(); ++v) watch_contacts(static_cast<int>(v));
    for (std::size_t e = 0; e < front_.edges().size(); ++e) watch_crossings(static_cast<int>(e));
  }

  /// Looks for candidates of what an event has changed.
  void update(const meeting& now, const front_changes& changes) {
    now_ = now;
    std::vector<int> watched;
    for (const int e : changes.edges) {
      watch_collapse(e);
      for (const int v : front_.edges()[e].ends)
        if (std::find(watched.begin(), watched.end(), v) == watched.end()) watched.push_back(v);
    }
    for (const int v : watched) watch_contacts(v);
    for (int e = changes.first_new; e < static_cast<int>(front_.edges().size()); ++e) watch_neighbours(e);
    for (const int e : changes.edges) watch_crossings(e);
  }

  /// Removes and returns the earliest candidate; nothing where there is none.
  std::optional<meeting> next() {
    if (queue_.empty()) return std::nullopt;
    std::optional<meeting> m = queue_.top();
    queue_.pop();
    return m;
  }

 private:
  // By time; candidates of one moment by their planes.
  struct later {
    const K* k;
    bool operator()(const meeting& m, const meeting& n) const {
      const sign s = k->compare(m, n);
      return s != sign::zero ? s == sign::positive : quadruple(k->planes(m)) > quadruple(k->planes(n));
    }
  };

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

  // A vertex reaches a plane while its own edges live: only where the plane has an edge with one of
  // its facets or, at a reflex vertex, where the four planes enclose a tetrahedron; convex and
  // majority corners nowhere (tests/catalogue_test.cpp, EveryEventIsLookedFor). Beyond the first
  // collapse of one of its edges the vertex does not live, or that edge has changed and the vertex
  // is watched again.
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
      for (const int e : front_.of_facet(p)) neighbours.push_back(front_.edges()[e].other(p));
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const plane_id l : neighbours) consider_contact(v, l);
    if (vertex.corner != local::reflex) return;
    const auto& p = vertex.planes;
    for (plane_id l = 0; l < front_.planes(); ++l)
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

  bool makes_contacts(int v) const {
    const auto corner = front_.vertices()[v].corner;
    return corner != local::convex && corner != local::majority;
  }

  // Whether the inner sides of four planes make a tetrahedron (the lambdas have one sign), or may
  // make one where the kernel says zero.
  bool enclose(const quadruple& q) const {
    std::array<bool, 2> seen{};
    for (unsigned r = 0; r < 4; ++r) {
      const sign s = lambda(q, r, [this](plane_id a, plane_id b, plane_id c) { return k_.orientation(a, b, c); });
      if (s != sign::zero) seen[s == sign::negative ? 0 : 1] = true;
      if (seen[0] && seen[1]) return false;
    }
    return true;
  }

  // Two reflex edges cross, which ends a tetrahedron between them; each is watched until it
  // collapses or changes.
  void watch_crossings(int e) {
    const auto& edge = front_.edges()[e];
    if (!edge.alive || edge.convex) return;
    listed_.resize(front_.edges().size());
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

  const K& k_;
  const wavefront& front_;
  meeting now_;
  std::priority_queue<meeting, std::vector<meeting>, later> queue_;
  std::unordered_set<quadruple, plane_hash> considered_;
  std::vector<std::optional<meeting>> collapse_;  // by edge
  // by vertex; inner nothing: for ever
  std::vector<std::optional<std::optional<meeting>>> watched_until_;
  std::vector<int> reflex_;  // edges
  // by edge: in that list, now or once
  std::vector<bool> listed_;
};

}  // namespace osteon
