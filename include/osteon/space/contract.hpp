// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the raw skeleton of the perturbed solid to the exact skeleton of the true one (design 04): what has come
/// together in the limit becomes one, what has vanished goes.

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// The exact skeleton. Arcs and sheets of any degree. Arcs are where at least three cells meet; a sheet is a maximal connected part
/// of the common border of two cells, so an arc may lie within it, and it may be pinched at an arc or a node.
struct contracted_skeleton {
  struct node {
    std::vector<int> raw;  ///< the nodes of the raw skeleton at this place, ascending
    std::vector<int> arcs;
  };
  struct arc {
    int source;  ///< not later than the target
    int target;
    std::vector<plane_id> cells;  ///< the facets whose cells meet here, ascending
    std::vector<int> sheets;      ///< ascending; a sheet on both sides is listed twice
  };
  struct sheet {
    std::array<plane_id, 2> facets;
    std::vector<int> raw;  ///< representatives of the raw polygons it is made of
    std::vector<int> arcs;
  };
  std::vector<node> nodes;
  std::vector<arc> arcs;
  std::vector<sheet> sheets;
  int cells = 0;
};

/// Contracts under the *unperturbed* kernel, whose zeros say what coincides.
template <unperturbed_kernel<3> K>
class contraction {
 public:
  contraction(const K& k, const boundary& solid, const skeleton& raw) : k_(k), solid_(solid), raw_(raw) {}

  /// Cost: linear plus, for nodes of one moment, their pairs, and for arcs the nodes within their time.
  contracted_skeleton run() {
    merge_nodes();
    subdivide_arcs();
    find_pieces();
    decide_stretches();
    join_sheets();
    collect();
    return std::move(result_);
  }

 private:
  using meeting = typename K::meeting;

  // A place in the limit: a moment, and a corner that is there.
  struct place {
    std::optional<meeting> when;  // none: at time zero
    triple corner;
  };

  // A stretch between neighbouring places; the raw polygons on it, and the pieces of sheets, with multiplicity.
  using stretch = std::pair<int, int>;
  struct content {
    std::map<int, int> raw;
    std::map<int, int> pieces;
  };

  // ---- nodes

  void merge_nodes() {
    place_of_.resize(raw_.nodes.size());
    std::size_t first_of_moment = 0;  // among places
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const auto& node = raw_.nodes[n];
      if (node.vertex >= 0) {
        place_of_[n] = new_place({std::nullopt, {node.planes[0], node.planes[1], node.planes[2]}}, n);
        first_of_moment = places_.size();
        continue;
      }
      const place p = locate(node.planes);
      if (first_of_moment < places_.size() && k_.compare(*places_[first_of_moment].when, *p.when) != sign::zero) first_of_moment = places_.size();
      int found = -1;
      for (std::size_t q = first_of_moment; q < places_.size() && found < 0; ++q)
        if (on_planes(p, places_[q].corner)) found = static_cast<int>(q);
      if (found >= 0) members_[static_cast<std::size_t>(found)].push_back(static_cast<int>(n));
      place_of_[n] = found >= 0 ? found : new_place(p, n);
    }
  }

  int new_place(const place& p, std::size_t raw) {
    places_.push_back(p);
    members_.push_back({static_cast<int>(raw)});
    return static_cast<int>(places_.size()) - 1;
  }

  place locate(const quadruple& q) const {
    const auto when = k_.meet(q);
    if (!when) broken_invariant<K>("the planes of an event meet in the limit");
    for (unsigned r = 0; r < 4; ++r) {
      const triple t = {q[r == 0 ? 1 : 0], q[r <= 1 ? 2 : 1], q[r <= 2 ? 3 : 2]};
      if (k_.orientation(t[0], t[1], t[2]) != sign::zero) return {when, t};
    }
    broken_invariant<K>("three planes of an event meet in a point in the limit");
  }

  sign side(plane_id d, const place& p) const {
    if (std::find(p.corner.begin(), p.corner.end(), d) != p.corner.end()) return sign::zero;
    return k_.side(d, p.corner[0], p.corner[1], p.corner[2], *p.when);
  }

  bool on_planes(const place& p, const triple& planes) const {
    return std::all_of(planes.begin(), planes.end(), [&](plane_id d) { return side(d, p) == sign::zero; });
  }

  // ---- arcs

  void subdivide_arcs() {
    for (const auto& a : raw_.arcs) {
      const int from = place_of_[static_cast<std::size_t>(a.source)];
      const int to = place_of_[static_cast<std::size_t>(a.target)];
      if (from == to) continue;
      std::vector<int> stops = {from};
      for (const int p : between(a.planes, from, to)) stops.push_back(p);
      stops.push_back(to);
      for (std::size_t i = 1; i < stops.size(); ++i) {
        auto& polygons = stretches_[std::minmax(stops[i - 1], stops[i])].raw;
        for (const int s : a.sheets) ++polygons[raw_.sheets[static_cast<std::size_t>(s)].representative];
      }
    }
  }

  // The places strictly between the ends of an arc of these planes, in their order along it. Places are numbered in
  // order of time.
  std::vector<int> between(const triple& planes, int from, int to) {
    std::vector<int> result;
    const bool instant = places_[static_cast<std::size_t>(from)].when &&
                         k_.compare(*places_[static_cast<std::size_t>(from)].when, *places_[static_cast<std::size_t>(to)].when) == sign::zero;
    if (!instant) {
      for (int p = from + 1; p < to; ++p)
        if (places_[static_cast<std::size_t>(p)].when && lies_on(p, planes) && later(p, from) && later(to, p)) result.push_back(p);
      return result;
    }
    int first = std::min(from, to);
    while (first > 0 && simultaneous(first - 1, from)) --first;
    for (int p = first; p < static_cast<int>(places_.size()) && simultaneous(p, from); ++p)
      if (p != from && p != to && lies_on(p, planes) && separates(p, from, to)) result.push_back(p);
    std::sort(result.begin(), result.end(), [&](int p, int q) { return separates(p, from, q); });
    return result;
  }

  bool later(int p, int q) const {
    const auto& a = places_[static_cast<std::size_t>(p)].when;
    const auto& b = places_[static_cast<std::size_t>(q)].when;
    return a && (!b || k_.compare(*a, *b) == sign::positive);
  }
  bool simultaneous(int p, int q) const {
    const auto& a = places_[static_cast<std::size_t>(p)].when;
    const auto& b = places_[static_cast<std::size_t>(q)].when;
    return a && b && k_.compare(*a, *b) == sign::zero;
  }

  // Whether p lies between a and b, three collinear places of one moment: some plane through p has them on either side.
  bool separates(int p, int a, int b) const {
    for (const plane_id d : places_[static_cast<std::size_t>(p)].corner) {
      const sign s = side(d, places_[static_cast<std::size_t>(a)]);
      if (s != sign::zero) return s * side(d, places_[static_cast<std::size_t>(b)]) == sign::negative;
    }
    broken_invariant<K>("two places are the same or can be told apart");
  }

  // ---- sheets

  // A connected part of a polygon: a raw polygon may hang together by what has no width in the limit.
  struct piece {
    int polygon;
    std::array<plane_id, 2> facets;
    std::vector<stretch> borders;
  };

  // A polygon's border in the limit: its stretches counted modulo two. Without any, it has no area.
  void find_pieces() {
    std::map<int, std::vector<stretch>> borders;
    for (const auto& [ends, on] : stretches_)
      for (const auto& [polygon, times] : on.raw)
        if (times % 2 != 0) borders[polygon].push_back(ends);
    std::map<int, std::vector<stretch>> floors;
    for (const auto& s : raw_.sheets)
      if (s.input_edge >= 0) {
        const auto& e = solid_.edges[static_cast<std::size_t>(s.input_edge)];
        floors[s.representative].emplace_back(e.ends[0], e.ends[1]);  // vertices come first among nodes and places
      }
    for (const auto& [polygon, stretches] : borders)
      for (auto& part : connected_parts(polygon, stretches, floors[polygon])) {
        pieces_of_[part.facets].push_back(static_cast<int>(pieces_.size()));
        pieces_.push_back(std::move(part));
      }
  }

  // Groups border stretches that hang together, over edges of the solid too; a group inside another one is its hole.
  std::vector<piece> connected_parts(int polygon, const std::vector<stretch>& borders, const std::vector<stretch>& floors) {
    const auto& facets = raw_.sheets[static_cast<std::size_t>(polygon)].facets;
    std::map<int, int> parent;
    const auto root = [&parent](int p) {
      parent.emplace(p, p);
      while (parent[p] != p) p = parent[p];
      return p;
    };
    for (const auto* list : {&borders, &floors})
      for (const auto& [x, y] : *list) parent[root(x)] = root(y);
    std::map<int, piece> groups;
    for (const stretch& e : borders) {
      piece& g = groups[root(e.first)];
      g.polygon = polygon;
      g.facets = facets;
      g.borders.push_back(e);
    }
    std::vector<piece> result;
    for (auto& [id, g] : groups) result.push_back(std::move(g));
    if (result.size() == 1) return result;
    std::vector<std::vector<std::size_t>> around(result.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t j = 0; j < result.size(); ++j)
        if (i != j && contains(result[j].borders, result[i].borders.front(), facets)) around[i].push_back(j);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const std::size_t j : around[i])
        if (around[i].size() % 2 == 1 && around[j].size() + 1 == around[i].size()) {
          result[j].borders.insert(result[j].borders.end(), result[i].borders.begin(), result[i].borders.end());
          result[i].borders.clear();
          break;
        }
    std::erase_if(result, [](const piece& g) { return g.borders.empty(); });
    return result;
  }

  // The perturbation may leave an arc just beside a sheet that contains it in the limit, or a spike of no width along
  // an arc. So what a piece has to do with a stretch is decided anew: a border (once), inside (on both sides), nothing.
  void decide_stretches() {
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i)
      for (const stretch& e : pieces_[static_cast<std::size_t>(i)].borders) stretches_[e].pieces[i] = 1;
    for (auto& [ends, on] : stretches_) {
      const std::vector<plane_id> through = planes_through(ends);
      for (const plane_id a : through)
        for (const plane_id b : through) {
          const auto found = a < b ? pieces_of_.find({a, b}) : pieces_of_.end();
          if (found == pieces_of_.end()) continue;
          for (const int i : found->second) {
            const piece& p = pieces_[static_cast<std::size_t>(i)];
            if ((through.size() > 3 || on.raw.contains(p.polygon)) && !on.pieces.contains(i) && contains(p.borders, ends, p.facets)) on.pieces[i] = 2;
          }
        }
    }
  }

  std::vector<plane_id> planes_through(const stretch& e) {
    std::vector<plane_id> through;
    const auto& first = planes_through(e.first);
    const auto& second = planes_through(e.second);
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(through));
    return through;
  }

  // Whether a stretch inside or outside, but not on the borders of a piece between two facets lies inside.
  bool contains(const std::vector<stretch>& borders, const stretch& inner, const std::array<plane_id, 2>& facets) {
    const plane_id a = facets[0];
    const plane_id b = facets[1];
    const std::vector<plane_id> through = planes_through(inner);
    if (later(inner.second, inner.first)) {
      for (const plane_id third : through)
        if (k_.orientation(a, b, third) != sign::zero) return contains_over_time(borders, inner, {a, b, third});
      return false;
    }
    // All at one moment: the piece lies in plane a. The stretch lies on the line of a and some plane c.
    if (!std::all_of(borders.begin(), borders.end(),
                     [&](const stretch& e) { return simultaneous(e.first, inner.first) && simultaneous(e.second, inner.first); }))
      return false;
    const auto& corner = places_[static_cast<std::size_t>(inner.first)].corner;
    for (const plane_id c : through)
      if (c != a && c != b && std::any_of(corner.begin(), corner.end(), [&](plane_id d) { return k_.orientation(a, c, d) != sign::zero; }))
        return contains_now(borders, inner, a, c);
    return false;
  }

  // Whether all of some planes, ascending, pass through a place.
  bool lies_on(int p, const triple& planes) {
    const auto& through = planes_through(p);
    return std::includes(through.begin(), through.end(), planes.begin(), planes.end());
  }

  // Counts the borders met by the ray from within the stretch through its second end, moved a little to the inner side
  // of c so that it meets no end of a border.
  bool contains_now(const std::vector<stretch>& borders, const stretch& inner, plane_id a, plane_id c) {
    const auto& from = places_[static_cast<std::size_t>(inner.first)];
    const auto& to = places_[static_cast<std::size_t>(inner.second)];
    plane_id gate = -1;  // a plane through the second end that cuts the line
    for (const plane_id d : to.corner)
      if (side(d, from) != sign::zero) gate = d;
    if (gate < 0) return false;
    bool inside = false;
    for (const auto& [x, y] : borders) {
      const auto& p = places_[static_cast<std::size_t>(x)];
      const auto& q = places_[static_cast<std::size_t>(y)];
      const sign sp = side(c, p);
      const sign sq = side(c, q);
      if ((sp == sign::positive) == (sq == sign::positive)) continue;
      sign beyond = sign::zero;
      if (sp == sign::zero || sq == sign::zero) {
        beyond = side(gate, sp == sign::zero ? p : q);
      } else {
        for (const plane_id e : planes_through(stretch(x, y)))
          if (k_.orientation(a, c, e) != sign::zero && side(e, p) == sign::zero && side(e, q) == sign::zero) {
            beyond = e == gate ? sign::zero : k_.side(gate, a, c, e, *from.when);
            break;
          }
      }
      if (beyond != side(gate, from)) inside = !inside;
    }
    return inside;
  }

  // All planes that pass through a place at its moment, ascending; found once.
  const std::vector<plane_id>& planes_through(int number) {
    planes_.resize(places_.size());
    auto& result = planes_[static_cast<std::size_t>(number)];
    if (!result.empty()) return result;
    const int node = members_[static_cast<std::size_t>(number)][0];
    if (const int vertex = raw_.nodes[static_cast<std::size_t>(node)].vertex; vertex >= 0) {
      result = solid_.vertices[static_cast<std::size_t>(vertex)].facets;
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
    } else {
      for (plane_id p = 0; p < solid_.planes; ++p)
        if (side(p, places_[static_cast<std::size_t>(number)]) == sign::zero) result.push_back(p);
    }
    return result;
  }

  // Whether the corner of a stretch, on the line of its first two planes, is inside a polygon on that line: at a
  // moment within, an odd number of the polygon's borders lies ahead.
  bool contains_over_time(const std::vector<stretch>& borders, const stretch& inner, const triple& corner) {
    bool inside = false;
    for (const auto& [x, y] : borders) {
      const int begin = later(x, inner.first) ? x : inner.first;
      const int end = later(y, inner.second) ? inner.second : y;
      if (!later(end, begin) || (x == inner.first && y == inner.second)) continue;
      const auto& last = places_[static_cast<std::size_t>(end)];
      const plane_id c = third_plane({x, y}, corner);
      if (c < 0) continue;
      const quadruple q = {corner[0], corner[1], corner[2], c};
      const auto met = k_.meet(q);
      const sign ahead = met ? (k_.compare(*met, *last.when) == sign::negative ? -slope(*met, c) : slope(*met, c))
                             : k_.side(c, corner[0], corner[1], corner[2], *last.when);
      if (ahead * k_.orientation(corner[0], corner[1], c) == sign::positive) inside = !inside;
    }
    return inside;
  }

  // A plane that cuts the line of the corner's first two planes where the stretch is.
  plane_id third_plane(const stretch& e, const triple& corner) {
    for (const plane_id c : planes_through(e))
      if (k_.orientation(corner[0], corner[1], c) != sign::zero && c != corner[2]) return c;
    return -1;
  }

  // Sign of S / lambda_c: of the distance of the other three's corner from plane c before the meeting.
  sign slope(const meeting& m, plane_id c) const {
    const quadruple q = k_.planes(m);
    const auto r = static_cast<std::size_t>(std::find(q.begin(), q.end(), c) - q.begin());
    const triple t = {q[r == 0 ? 1 : 0], q[r <= 1 ? 2 : 1], q[r <= 2 ? 3 : 2]};
    const sign lambda = k_.orientation(t[0], t[1], t[2]);
    return k_.closing(m) * (r % 2 == 0 ? -lambda : lambda);
  }

  // Pieces between the same two facets that touch are one sheet; where only two cells meet there is no arc.
  void join_sheets() {
    root_.resize(pieces_.size());
    std::iota(root_.begin(), root_.end(), 0);
    std::map<std::pair<int, std::array<plane_id, 2>>, int> at_place;
    for (auto at = stretches_.begin(); at != stretches_.end();) {
      const auto& [ends, on] = *at;
      for (const auto& [i, times] : on.pieces)
        for (const int p : {ends.first, ends.second}) {
          const auto known = at_place.emplace(std::pair(p, pieces_[static_cast<std::size_t>(i)].facets), i).first;
          root_[static_cast<std::size_t>(root(i))] = root(known->second);
        }
      at = cells_at(on).size() >= 3 ? std::next(at) : stretches_.erase(at);
    }
  }

  int root(int i) {
    while (root_[static_cast<std::size_t>(i)] != i)
      i = root_[static_cast<std::size_t>(i)] = root_[static_cast<std::size_t>(root_[static_cast<std::size_t>(i)])];
    return i;
  }

  std::vector<plane_id> cells_at(const content& on) const {
    std::set<plane_id> cells;
    for (const auto& [i, times] : on.pieces)
      for (const plane_id f : pieces_[static_cast<std::size_t>(i)].facets) cells.insert(f);
    return {cells.begin(), cells.end()};
  }

  // ---- the result

  void collect() {
    std::vector<int> node_of(places_.size(), -1);
    std::vector<bool> used(places_.size());
    for (const auto& [ends, on] : stretches_) used[static_cast<std::size_t>(ends.first)] = used[static_cast<std::size_t>(ends.second)] = true;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (!used[p] && places_[p].when) continue;
      node_of[p] = static_cast<int>(result_.nodes.size());
      result_.nodes.push_back({members_[p], {}});
    }
    std::vector<int> sheet_of(pieces_.size(), -1);
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
      const piece& p = pieces_[static_cast<std::size_t>(i)];
      int& id = sheet_of[static_cast<std::size_t>(root(i))];
      if (id < 0) {
        id = static_cast<int>(result_.sheets.size());
        result_.sheets.push_back({p.facets, {}, {}});
      }
      auto& raw = result_.sheets[static_cast<std::size_t>(id)].raw;
      if (std::find(raw.begin(), raw.end(), p.polygon) == raw.end()) raw.push_back(p.polygon);
    }
    for (const auto& [ends, on] : stretches_) {
      const int id = static_cast<int>(result_.arcs.size());
      contracted_skeleton::arc arc{node_of[static_cast<std::size_t>(ends.first)], node_of[static_cast<std::size_t>(ends.second)], cells_at(on), {}};
      for (const auto& [i, times] : on.pieces) {
        const int sheet = sheet_of[static_cast<std::size_t>(root(i))];
        arc.sheets.insert(arc.sheets.end(), static_cast<std::size_t>(times), sheet);
      }
      std::sort(arc.sheets.begin(), arc.sheets.end());
      for (const int n : {arc.source, arc.target}) result_.nodes[static_cast<std::size_t>(n)].arcs.push_back(id);
      for (std::size_t i = 0; i < arc.sheets.size(); ++i)
        if (i == 0 || arc.sheets[i] != arc.sheets[i - 1]) result_.sheets[static_cast<std::size_t>(arc.sheets[i])].arcs.push_back(id);
      result_.arcs.push_back(std::move(arc));
    }
    result_.cells = static_cast<int>(std::count_if(raw_.cells.begin(), raw_.cells.end(), [](const auto& c) { return !c.empty(); }));
  }

  const K& k_;
  const boundary& solid_;
  const skeleton& raw_;
  std::vector<place> places_;
  std::vector<std::vector<int>> members_;
  std::vector<int> place_of_;
  std::map<stretch, content> stretches_;
  std::vector<std::vector<plane_id>> planes_;
  std::vector<piece> pieces_;
  std::map<std::array<plane_id, 2>, std::vector<int>> pieces_of_;
  std::vector<int> root_;
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
