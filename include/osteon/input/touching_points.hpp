// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Points in which the boundary of a polygon touches itself: edges are cut there, and chains follow
/// the boundary of the interior in place of the rings.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/input/exact_points.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/plane_sweep.hpp"
#include "osteon/input/ring_cleaning.hpp"
#include "osteon/input/ring_nesting.hpp"
#include "osteon/input/rings.hpp"

namespace osteon::plane {

/// Links chains anew where they touch. An edge that runs through a touching point becomes two; the
/// second starts at a new vertex, so that rays are those of vertices only. The interior lies left
/// of every edge, so rays in and out take turns around a touching point, and each sector of the
/// interior gets a vertex of its own.
template <class Int>
class touching_points {
 public:
  /// *Requires* oriented chains that do not cross. `ranks`: by vertex, see plane_sweep::rank.
  touching_points(const exact_points<Int>& points, const ring_names<Int>& names, std::vector<int> ranks, const std::vector<bool>& reversed,
                  ring_relations& relations, ring_chains& chains)
      : points_(points), names_(names), ranks_(std::move(ranks)), reversed_(reversed), relations_(relations), chains_(chains) {
    cut_edges();
    arriving_ = chains_.previous;
  }

  /// Links the chains so that each follows the boundary of one piece of the interior, or with
  /// `outside` of one piece of the rest.
  void link_sectors(bool outside) {
    for (std::size_t t = 0; t < size(); ++t) {
      const auto rays = relations_.rays_of(t);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        // Counter-clockwise, a sector of the interior begins with a ray out and ends with a ray in;
        // one of the outside begins with a ray in.
        const auto& here = rays[i];
        const auto& next = rays[(i + 1) % rays.size()];
        if (here.out == next.out) throw invariant_error("internal invariant violated: the interior lies on the left around a touching point");
        const auto& out = outside ? next : here;
        const auto& in = outside ? here : next;
        if (!out.out) continue;
        chains_.next[arriving_[in.vertex]] = out.vertex;
        chains_.previous[out.vertex] = arriving_[in.vertex];
      }
    }
  }

  /// Returns the number of boundaries of the interior's pieces, counter-clockwise and clockwise
  /// ones.
  /// *Requires* that sectors of the interior are linked.
  /// *Throws* input_error(pinched) where a part has several pieces.
  int count_boundaries(const ring_parts& parts) const {
    std::vector<int> boundary(static_cast<std::size_t>(chains_.size()), -1);  // by vertex
    std::vector<int> pieces(parts.outer.size());
    int count = 0;
    int second = -1;  // the boundary of a second piece of a part
    for (int i = 0; i < chains_.size(); ++i) {
      if (boundary[i] >= 0) continue;
      Int area = 0;
      int v = i;
      do {
        boundary[v] = count;
        const auto& a = points_[chains_.point_of(v)];
        const auto& b = points_[chains_.point_of(chains_.next[v])];
        area += cross<Int>(a[0], a[1], b[0], b[1]);
        v = chains_.next[v];
      } while (v != i);
      if (area > 0 && ++pieces[parts.part[chains_.ring[i]]] > 1 && second < 0) second = count;
      ++count;
    }
    if (second >= 0) refuse_piece(boundary, second);
    return count;
  }

  /// Removes vertices in line between edges of equal weight. A touching from outside cuts nothing
  /// in the interior, and two edges in line may have become neighbours.
  void join_straight(const std::vector<Int>& weights) {
    joined_.assign(static_cast<std::size_t>(chains_.size()), false);
    auto& next = chains_.next;
    auto& previous = chains_.previous;
    for (const auto& ray : relations_.rays) {
      const int v = ray.vertex;
      if (!ray.out || !(weights.empty() || weights[chains_.weight[previous[v]]] == weights[chains_.weight[v]])) continue;
      if (points_.turn(chains_.point_of(previous[v]), chains_.point_of(v), chains_.point_of(next[v])) != sign::zero) continue;
      joined_[v] = true;
      next[previous[v]] = next[v];
      previous[next[v]] = previous[v];
    }
  }

  /// Returns the vertices that are left in the order of the input, those of cuts behind the vertex
  /// in which the cut edge starts.
  std::vector<int> ordered() const {
    std::vector<int> order;
    order.reserve(static_cast<std::size_t>(chains_.size()));
    std::size_t c = 0;  // cuts are sorted by edge
    for (int v = 0; v < chains_.size_of_rings; ++v) {
      if (!joined_[v]) order.push_back(v);
      for (; c < cut_.size() && cut_[c] == v; ++c)
        if (const int w = chains_.size_of_rings + static_cast<int>(c); !joined_[w]) order.push_back(w);
    }
    return order;
  }

  /// Returns a sentence that tells of the touching points.
  std::string repair() const {
    return "the boundary touches itself in " + counted(size(), "point", "points") +
           ", the first: " + names_.name(chains_.input[relations_.touching_vertices[0]]) + " on " + other_name(0);
  }

 private:
  struct cut {
    int edge;
    int rank;
    std::size_t touching;
  };

  std::size_t size() const { return relations_.touching_vertices.size(); }

  // Rays as they are after rings were reversed, and the cuts along each edge.
  std::vector<cut> find_cuts() {
    for (auto& ray : relations_.rays) {
      if (!reversed_[chains_.ring[ray.vertex]]) continue;
      if (ray.through) ray.vertex = chains_.previous[ray.vertex];
      ray.out = !ray.out;
    }
    std::vector<cut> cuts;
    for (std::size_t t = 0; t < size(); ++t)
      for (const auto& ray : relations_.rays_of(t))
        if (ray.through && ray.out) cuts.push_back({ray.vertex, ranks_[relations_.touching_vertices[t]], t});
    std::sort(cuts.begin(), cuts.end(), [&](const cut& a, const cut& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      return ranks_[a.edge] < ranks_[chains_.next[a.edge]] ? a.rank < b.rank : a.rank > b.rank;
    });
    return cuts;
  }

  void cut_edges() {
    const std::vector<cut> cuts = find_cuts();
    std::vector<int> vertex_of(size(), -1);  // by touching point
    int before = -1;                         // the edge, or the last piece of it so far
    for (const cut& c : cuts) {
      if (cut_.empty() || cut_.back() != c.edge) before = c.edge;
      const int fresh = chains_.size();
      const int touched = relations_.touching_vertices[c.touching];
      cut_.push_back(c.edge);
      const int after = chains_.next[before];
      chains_.next.push_back(after);
      chains_.previous.push_back(before);
      chains_.previous[after] = fresh;
      chains_.next[before] = fresh;
      chains_.cut_at.push_back(touched);
      chains_.input.push_back(chains_.input[touched]);
      chains_.weight.push_back(chains_.weight[c.edge]);
      chains_.ring.push_back(chains_.ring[c.edge]);
      vertex_of[c.touching] = fresh;
      before = fresh;
    }
    for (std::size_t t = 0; t < size(); ++t)
      for (auto& ray : relations_.rays_of(t))
        if (ray.through) ray.vertex = vertex_of[t];
  }

  // Names a point in which a boundary meets others: there the interior falls apart.
  void refuse_piece(const std::vector<int>& boundary, int piece) const {
    for (std::size_t t = 0; t < size(); ++t) {
      bool here = false;
      bool others = false;
      for (const auto& ray : relations_.rays_of(t))
        if (ray.out) (boundary[ray.vertex] == piece ? here : others) = true;
      if (!here || !others) continue;
      names_.refuse(input_fault::pinched, chains_.input[relations_.touching_vertices[t]],
                    ": the boundary touches " + other_name(t) + " here, and the interior falls apart into pieces that share only points",
                    "give each piece as a part of its own, or move the point");
    }
  }

  // What a touching point's first vertex touches.
  std::string other_name(std::size_t t) const {
    for (const auto& ray : relations_.rays_of(t)) {
      const int u = ray.vertex;
      if (u == relations_.touching_vertices[t]) continue;
      if (u < chains_.size_of_rings) return names_.short_name(chains_.input[u]);
      const int e = cut_[u - chains_.size_of_rings];
      // The other end in the input: the neighbour in the ring; the edge is cut by now.
      const int r = chains_.ring[e];
      const int begin = chains_.first[r];
      const int end = chains_.end(r);
      const int other = reversed_[r] ? (e > begin ? e - 1 : end - 1) : (e + 1 < end ? e + 1 : begin);
      return "the edge between " + names_.short_name(chains_.input[std::min(e, other)]) + " and " +
             names_.short_name(chains_.input[std::max(e, other)]);
    }
    return "itself";
  }

  const exact_points<Int>& points_;
  const ring_names<Int>& names_;
  const std::vector<int> ranks_;
  const std::vector<bool>& reversed_;
  ring_relations& relations_;
  ring_chains& chains_;
  std::vector<int> cut_;       // by vertex of a cut: the edge of a ring that it cuts
  std::vector<int> arriving_;  // by vertex: the previous one in its ring, before sectors are linked
  std::vector<bool> joined_;   // by vertex: whether it was removed
};

}  // namespace osteon::plane
