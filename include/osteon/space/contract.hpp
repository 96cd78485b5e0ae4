// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the raw skeleton of the perturbed solid to the exact skeleton of the true one
/// (docs/theory/degeneracy.md): what has come together in the limit becomes one, what has vanished
/// goes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/contracted_skeleton.hpp"
#include "osteon/space/limit_points.hpp"
#include "osteon/space/skeleton.hpp"
#include "osteon/space/stretch_location.hpp"

namespace osteon {

/// Contracts under the *unperturbed* kernel, whose zeros say what coincides.
template <unperturbed_kernel<3> K>
class contraction {
 public:
  /// `raw`: a skeleton of the solid by a kernel that perturbs k.
  contraction(const K& k, const boundary& solid, const skeleton& raw) : solid_(solid), raw_(raw), points_(k, solid, raw), location_(k, points_) {}

  /// Contracts and returns the exact skeleton.
  /// *Complexity* linear plus, for nodes of one moment, their pairs, and for arcs the nodes within
  /// their time.
  contracted_skeleton run() {
    subdivide_arcs();
    find_pieces();
    decide_stretches();
    join_sheets();
    collect_nodes();
    collect_sheets();
    collect_arcs();
    result_.cells = static_cast<int>(std::count_if(raw_.cells.begin(), raw_.cells.end(), [](const auto& c) { return !c.empty(); }));
    return std::move(result_);
  }

 private:
  // What lies on a stretch: the raw polygons, by representative, and the pieces of sheets, with
  // multiplicity.
  struct content {
    std::map<int, int> raw;
    std::map<int, int> pieces;
  };
  // A connected part of a polygon: a raw polygon may hang together by what has no width in the
  // limit.
  struct piece {
    int representative;  // of the polygon's sheets
    std::array<plane_id, 2> facets;
    std::vector<stretch> borders;
  };

  // ---- stretches

  void subdivide_arcs() {
    for (const auto& a : raw_.arcs) {
      const int from = points_.of_node(a.source);
      const int to = points_.of_node(a.target);
      if (from == to) continue;
      std::vector<int> stops = {from};
      for (const int p : points_.between(a.planes, from, to)) stops.push_back(p);
      stops.push_back(to);
      for (std::size_t i = 1; i < stops.size(); ++i) {
        auto& polygons = stretches_[std::minmax(stops[i - 1], stops[i])].raw;
        for (const int s : a.sheets) ++polygons[raw_.sheets[s].representative];
      }
    }
  }

  // ---- pieces

  // A polygon's border in the limit: its stretches counted modulo two. Without any, it has no area.
  void find_pieces() {
    std::map<int, std::vector<stretch>> borders;  // by representative
    for (const auto& [ends, on] : stretches_)
      for (const auto& [polygon, times] : on.raw)
        if (times % 2 != 0) borders[polygon].push_back(ends);
    std::map<int, std::vector<stretch>> floors;
    for (const auto& s : raw_.sheets)
      if (s.input_edge >= 0) {
        const auto& e = solid_.edges[s.input_edge];
        // vertices come first among nodes and points
        floors[s.representative].emplace_back(e.ends[0], e.ends[1]);
      }
    for (const auto& [polygon, stretches] : borders)
      for (auto& part : connected_parts(polygon, stretches, floors[polygon])) {
        pieces_of_[part.facets].push_back(static_cast<int>(pieces_.size()));
        pieces_.push_back(std::move(part));
      }
  }

  // Groups border stretches that hang together, over edges of the solid too; a group inside another
  // one is its hole.
  std::vector<piece> connected_parts(int polygon, const std::vector<stretch>& borders, const std::vector<stretch>& floors) {
    std::vector<int> ends;  // points, ascending
    for (const auto* list : {&borders, &floors})
      for (const auto& [x, y] : *list) ends.insert(ends.end(), {x, y});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto number = [&ends](int point) { return static_cast<int>(std::lower_bound(ends.begin(), ends.end(), point) - ends.begin()); };
    disjoint_sets connected(ends.size());
    for (const auto* list : {&borders, &floors})
      for (const auto& [x, y] : *list) connected.unite(number(x), number(y));
    std::map<int, piece> groups;
    for (const stretch& e : borders) {
      piece& g = groups[connected.find(number(e.first))];
      g.representative = polygon;
      g.facets = raw_.sheets[polygon].facets;
      g.borders.push_back(e);
    }
    std::vector<piece> result;
    for (auto& [id, g] : groups) result.push_back(std::move(g));
    if (result.size() > 1) join_holes(result);
    return result;
  }

  // Gives the borders of holes to the parts around them.
  void join_holes(std::vector<piece>& parts) {
    std::vector<std::vector<std::size_t>> around(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = 0; j < parts.size(); ++j)
        if (i != j && location_.contains(parts[j].borders, parts[i].borders.front(), parts[i].facets)) around[i].push_back(j);
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const std::size_t j : around[i])
        if (around[i].size() % 2 == 1 && around[j].size() + 1 == around[i].size()) {
          parts[j].borders.insert(parts[j].borders.end(), parts[i].borders.begin(), parts[i].borders.end());
          parts[i].borders.clear();
          break;
        }
    std::erase_if(parts, [](const piece& g) { return g.borders.empty(); });
  }

  // The perturbation may leave an arc just beside a sheet that contains it in the limit, or a spike
  // of no width along an arc. So what a piece has to do with a stretch is decided anew: a border
  // (once), inside (on both sides), nothing.
  void decide_stretches() {
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i)
      for (const stretch& e : pieces_[i].borders) stretches_[e].pieces[i] = 1;
    for (auto& [ends, on] : stretches_) {
      const std::vector<plane_id> through = points_.planes_through(ends);
      for (const plane_id a : through)
        for (const plane_id b : through) {
          const auto found = a < b ? pieces_of_.find({a, b}) : pieces_of_.end();
          if (found == pieces_of_.end()) continue;
          for (const int i : found->second) {
            const piece& p = pieces_[i];
            if ((through.size() > 3 || on.raw.contains(p.representative)) && !on.pieces.contains(i) && location_.contains(p.borders, ends, p.facets))
              on.pieces[i] = 2;
          }
        }
    }
  }

  // ---- sheets

  // Pieces between the same two facets that touch are one sheet; where only two cells meet there is
  // no arc.
  void join_sheets() {
    joined_ = disjoint_sets(pieces_.size());
    std::map<std::pair<int, std::array<plane_id, 2>>, int> at_point;
    for (auto at = stretches_.begin(); at != stretches_.end();) {
      const auto& [ends, on] = *at;
      for (const auto& [i, times] : on.pieces)
        for (const int p : {ends.first, ends.second}) joined_.unite(i, at_point.emplace(std::pair(p, pieces_[i].facets), i).first->second);
      at = cells_at(on).size() >= 3 ? std::next(at) : stretches_.erase(at);
    }
  }

  std::vector<plane_id> cells_at(const content& on) const {
    std::set<plane_id> cells;
    for (const auto& [i, times] : on.pieces)
      for (const plane_id f : pieces_[i].facets) cells.insert(f);
    return {cells.begin(), cells.end()};
  }

  // ---- the result

  void collect_nodes() {
    std::vector<bool> used(points_.size());
    for (const auto& [ends, on] : stretches_) used[ends.first] = used[ends.second] = true;
    node_of_.assign(points_.size(), -1);
    for (int p = 0; p < points_.size(); ++p) {
      if (!used[p] && points_[p].moment) continue;
      node_of_[p] = static_cast<int>(result_.nodes.size());
      result_.nodes.push_back({points_.nodes_at(p), {}});
    }
  }

  void collect_sheets() {
    std::vector<int> sheet_of_set(pieces_.size(), -1);
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
      int& id = sheet_of_set[joined_.find(i)];
      if (id < 0) {
        id = static_cast<int>(result_.sheets.size());
        result_.sheets.push_back({pieces_[i].facets, {}, {}});
      }
      sheet_of_.push_back(id);
      auto& raw = result_.sheets[id].raw;
      if (std::find(raw.begin(), raw.end(), pieces_[i].representative) == raw.end()) raw.push_back(pieces_[i].representative);
    }
  }

  void collect_arcs() {
    for (const auto& [ends, on] : stretches_) {
      const int id = static_cast<int>(result_.arcs.size());
      contracted_skeleton::arc arc{node_of_[ends.first], node_of_[ends.second], cells_at(on), {}};
      for (const auto& [i, times] : on.pieces) arc.sheets.insert(arc.sheets.end(), static_cast<std::size_t>(times), sheet_of_[i]);
      std::sort(arc.sheets.begin(), arc.sheets.end());
      for (const int n : {arc.source, arc.target}) result_.nodes[n].arcs.push_back(id);
      for (std::size_t i = 0; i < arc.sheets.size(); ++i)
        if (i == 0 || arc.sheets[i] != arc.sheets[i - 1]) result_.sheets[arc.sheets[i]].arcs.push_back(id);
      result_.arcs.push_back(std::move(arc));
    }
  }

  const boundary& solid_;
  const skeleton& raw_;
  limit_points<K> points_;
  stretch_location<K> location_;
  std::map<stretch, content> stretches_;
  std::vector<piece> pieces_;
  std::map<std::array<plane_id, 2>, std::vector<int>> pieces_of_;  // by facets
  disjoint_sets joined_;                                           // of pieces
  std::vector<int> node_of_;                                       // by point
  std::vector<int> sheet_of_;                                      // by piece
  contracted_skeleton result_;
};

/// Returns the exact skeleton behind a raw one. A perturbed kernel gives its base.
/// *Requires* a kernel with the solid's planes.
template <contracting_kernel<3> K>
contracted_skeleton contract(const K& k, const boundary& solid, const skeleton& raw) {
  if constexpr (perturbed_kernel<K, 3>)
    return contract(k.base(), solid, raw);
  else
    return contraction<K>(k, solid, raw).run();
}

}  // namespace osteon
