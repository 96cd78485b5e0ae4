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

#include "osteon/boundary.hpp"
#include "osteon/error.hpp"
#include "osteon/kernel.hpp"
#include "osteon/skeleton.hpp"

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
template <kernel K>
class contraction {
 public:
  contraction(const K& k, const boundary& solid, const skeleton& raw) : k_(k), solid_(solid), raw_(raw) {}

  /// Cost: linear plus, for nodes of one moment, their pairs, and for arcs the nodes within their time.
  contracted_skeleton run() {
    merge_nodes();
    subdivide_arcs();
    find_sheets();
    settle_stretches();
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

  // A stretch between neighbouring places and the polygons on it, with multiplicity.
  using stretch = std::pair<int, int>;
  struct content {
    std::map<int, int> polygons;
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
        auto& polygons = stretches_[std::minmax(stops[i - 1], stops[i])].polygons;
        for (const int s : a.sheets) ++polygons[raw_.sheets[static_cast<std::size_t>(s)].polygon];
      }
    }
  }

  // The places strictly between the ends of an arc of these planes, in their order along it. Places are numbered in
  // order of time.
  std::vector<int> between(const triple& planes, int from, int to) const {
    std::vector<int> result;
    const bool instant = places_[static_cast<std::size_t>(from)].when &&
                         k_.compare(*places_[static_cast<std::size_t>(from)].when, *places_[static_cast<std::size_t>(to)].when) == sign::zero;
    if (!instant) {
      for (int p = from + 1; p < to; ++p)
        if (places_[static_cast<std::size_t>(p)].when && on_planes(places_[static_cast<std::size_t>(p)], planes) && later(p, from) && later(to, p))
          result.push_back(p);
      return result;
    }
    int first = std::min(from, to);
    while (first > 0 && simultaneous(first - 1, from)) --first;
    for (int p = first; p < static_cast<int>(places_.size()) && simultaneous(p, from); ++p)
      if (p != from && p != to && on_planes(places_[static_cast<std::size_t>(p)], planes) && separates(p, from, to)) result.push_back(p);
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

  int polygon_of(int sheet) const { return raw_.sheets[static_cast<std::size_t>(sheet)].polygon; }

  // A polygon has an area iff its border, each stretch counted modulo two, is not empty; edges of the solid belong to it.
  void find_sheets() {
    root_.resize(raw_.sheets.size());
    std::iota(root_.begin(), root_.end(), 0);
    has_area_.assign(raw_.sheets.size(), false);
    for (std::size_t s = 0; s < raw_.sheets.size(); ++s)
      if (raw_.sheets[s].input_edge >= 0) has_area_[static_cast<std::size_t>(polygon_of(static_cast<int>(s)))] = true;
    for (const auto& [ends, on] : stretches_)
      for (const auto& [polygon, times] : on.polygons)
        if (times % 2 != 0) has_area_[static_cast<std::size_t>(polygon)] = true;
  }

  int root(int polygon) {
    while (root_[static_cast<std::size_t>(polygon)] != polygon)
      polygon = root_[static_cast<std::size_t>(polygon)] = root_[static_cast<std::size_t>(root_[static_cast<std::size_t>(polygon)])];
    return polygon;
  }

  // The perturbation may leave an arc just beside a sheet that contains it in the limit, or a spike of no width along
  // an arc. So what a polygon has to do with a stretch is decided anew: a border (once), inside (on both sides), nothing.
  void settle_stretches() {
    const std::vector<std::vector<plane_id>> planes = planes_through_places();
    std::map<std::array<plane_id, 2>, std::vector<int>> polygons;
    for (std::size_t s = 0; s < raw_.sheets.size(); ++s)
      if (has_area_[s]) polygons[raw_.sheets[s].facets].push_back(static_cast<int>(s));
    std::map<int, std::vector<stretch>> borders;
    for (const auto& [ends, on] : stretches_)
      for (const auto& [polygon, times] : on.polygons)
        if (times % 2 != 0) borders[polygon].push_back(ends);
    std::map<stretch, content> settled;
    for (const auto& [ends, on] : stretches_) {
      content& now = settled[ends];
      std::vector<plane_id> through;
      const auto& first = planes[static_cast<std::size_t>(ends.first)];
      const auto& second = planes[static_cast<std::size_t>(ends.second)];
      std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(through));
      for (const plane_id a : through)
        for (const plane_id b : through) {
          const auto found = a < b ? polygons.find({a, b}) : polygons.end();
          if (found == polygons.end()) continue;
          for (const int polygon : found->second) {
            const auto known = on.polygons.find(polygon);
            const bool border = known != on.polygons.end() && known->second % 2 != 0;
            if (border)
              now.polygons[polygon] = 1;
            else if ((known != on.polygons.end() || through.size() > 3) && contains(borders[polygon], ends, a, b, through))
              now.polygons[polygon] = 2;
          }
        }
    }
    stretches_ = std::move(settled);
  }

  // Whether a stretch that is no border of a polygon between facets a and b lies inside it.
  bool contains(const std::vector<stretch>& borders, const stretch& inner, plane_id a, plane_id b, const std::vector<plane_id>& through) const {
    const auto transversal = [&](const auto& planes, plane_id p, plane_id q) {
      const auto found = std::find_if(planes.begin(), planes.end(), [&](plane_id d) { return k_.orientation(p, q, d) != sign::zero; });
      return found == planes.end() ? -1 : *found;
    };
    if (later(inner.second, inner.first)) {
      const plane_id third = transversal(through, a, b);
      return third >= 0 && contains_over_time(borders, inner, {a, b, third});
    }
    // All at one moment: the polygon lies in plane a. The stretch lies on the line of a and some plane c.
    if (!std::all_of(borders.begin(), borders.end(),
                     [&](const stretch& e) { return simultaneous(e.first, inner.first) && simultaneous(e.second, inner.first); }))
      return false;
    const auto& corner = places_[static_cast<std::size_t>(inner.first)].corner;
    for (const plane_id c : through)
      if (c != a && c != b && std::any_of(corner.begin(), corner.end(), [&](plane_id d) { return k_.orientation(a, c, d) != sign::zero; }))
        return contains_now(borders, inner, a, c);
    return false;
  }

  // Counts the borders met by the ray from within the stretch through its second end, moved a little to the inner side
  // of c so that it meets no end of a border.
  bool contains_now(const std::vector<stretch>& borders, const stretch& inner, plane_id a, plane_id c) const {
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
        for (const plane_id e : cells_at(stretches_.at({x, y}).polygons))
          if (k_.orientation(a, c, e) != sign::zero && side(e, p) == sign::zero && side(e, q) == sign::zero) {
            beyond = e == gate ? sign::zero : k_.side(gate, a, c, e, *from.when);
            break;
          }
      }
      if (beyond != side(gate, from)) inside = !inside;
    }
    return inside;
  }

  // All planes that pass through each place at its moment, ascending.
  std::vector<std::vector<plane_id>> planes_through_places() const {
    std::vector<std::vector<plane_id>> result(places_.size());
    for (std::size_t n = 0; n < places_.size(); ++n) {
      if (const int vertex = raw_.nodes[static_cast<std::size_t>(members_[n][0])].vertex; vertex >= 0) {
        result[n] = solid_.vertices[static_cast<std::size_t>(vertex)].facets;
        std::sort(result[n].begin(), result[n].end());
        result[n].erase(std::unique(result[n].begin(), result[n].end()), result[n].end());
        continue;
      }
      for (plane_id p = 0; p < solid_.planes; ++p)
        if (side(p, places_[n]) == sign::zero) result[n].push_back(p);
    }
    return result;
  }

  // Whether the corner of a stretch, on the line of its first two planes, is inside a polygon on that line: at a
  // moment within, an odd number of the polygon's borders lies ahead.
  bool contains_over_time(const std::vector<stretch>& borders, const stretch& inner, const triple& corner) const {
    bool inside = false;
    for (const auto& [x, y] : borders) {
      const int begin = later(x, inner.first) ? x : inner.first;
      const int end = later(y, inner.second) ? inner.second : y;
      if (!later(end, begin) || (x == inner.first && y == inner.second)) continue;
      const auto& last = places_[static_cast<std::size_t>(end)];
      const plane_id c = third_plane(stretches_.at({x, y}), corner);
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
  plane_id third_plane(const content& on, const triple& corner) const {
    for (const plane_id c : cells_at(on.polygons))
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

  // Polygons of the same two facets that touch are one sheet; where only two cells meet there is no arc.
  void join_sheets() {
    std::map<std::pair<int, std::array<plane_id, 2>>, int> at_place;
    for (auto at = stretches_.begin(); at != stretches_.end();) {
      const auto& [ends, on] = *at;
      for (const auto& [polygon, times] : on.polygons)
        for (const int place_number : {ends.first, ends.second}) {
          const auto known = at_place.emplace(std::pair(place_number, raw_.sheets[static_cast<std::size_t>(polygon)].facets), polygon).first;
          root_[static_cast<std::size_t>(root(polygon))] = root(known->second);
        }
      at = cells_at(on.polygons).size() >= 3 ? std::next(at) : stretches_.erase(at);
    }
  }

  std::vector<plane_id> cells_at(const std::map<int, int>& polygons) const {
    std::set<plane_id> cells;
    for (const auto& [polygon, times] : polygons)
      for (const plane_id f : raw_.sheets[static_cast<std::size_t>(polygon)].facets) cells.insert(f);
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
    std::vector<int> sheet_of(raw_.sheets.size(), -1);
    for (std::size_t s = 0; s < raw_.sheets.size(); ++s) {
      const int polygon = polygon_of(static_cast<int>(s));
      if (polygon != static_cast<int>(s) || !has_area_[s]) continue;
      int& id = sheet_of[static_cast<std::size_t>(root(polygon))];
      if (id < 0) {
        id = static_cast<int>(result_.sheets.size());
        result_.sheets.push_back({raw_.sheets[s].facets, {}, {}});
      }
      result_.sheets[static_cast<std::size_t>(id)].raw.push_back(polygon);
    }
    for (const auto& [ends, on] : stretches_) {
      const int id = static_cast<int>(result_.arcs.size());
      contracted_skeleton::arc arc{
          node_of[static_cast<std::size_t>(ends.first)], node_of[static_cast<std::size_t>(ends.second)], cells_at(on.polygons), {}};
      for (const auto& [polygon, times] : on.polygons) {
        const int sheet = sheet_of[static_cast<std::size_t>(root(polygon))];
        for (int i = 0; i < times; ++i) arc.sheets.push_back(sheet);
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
  std::vector<int> root_;
  std::vector<bool> has_area_;
  contracted_skeleton result_;
};

/// The exact skeleton behind a raw one. `k` is the kernel below the perturbation.
template <kernel K>
contracted_skeleton contract(const K& k, const boundary& solid, const skeleton& raw) {
  return contraction<K>(k, solid, raw).run();
}

}  // namespace osteon
