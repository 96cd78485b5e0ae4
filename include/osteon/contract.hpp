// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the raw skeleton of the perturbed solid to the exact skeleton of the true one (design 04): what has come
/// together in the limit becomes one, what has vanished goes.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "osteon/error.hpp"
#include "osteon/kernel.hpp"
#include "osteon/skeleton.hpp"

namespace osteon {

/// The exact skeleton. Arcs and sheets of any degree; arcs are where at least three cells meet.
struct contracted_skeleton {
  struct node {
    std::vector<int> raw;  ///< the nodes of the raw skeleton at this place, ascending
    std::vector<int> arcs;
  };
  struct arc {
    int source;  ///< not later than the target
    int target;
    std::vector<plane_id> cells;  ///< the facets whose cells meet here, ascending
    std::vector<int> sheets;      ///< ascending; a sheet that meets itself here is listed twice
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
  contraction(const K& k, const skeleton& raw) : k_(k), raw_(raw) {}

  /// Cost: linear plus, for nodes of one moment, their pairs, and for arcs the nodes within their time.
  contracted_skeleton run() {
    merge_nodes();
    subdivide_arcs();
    find_sheets();
    join_over_false_arcs();
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

  // Where only two cells meet there is no arc: the polygons on both sides are one sheet.
  void join_over_false_arcs() {
    for (auto at = stretches_.begin(); at != stretches_.end();) {
      auto& polygons = at->second.polygons;
      std::erase_if(polygons, [this](const auto& p) { return !has_area_[static_cast<std::size_t>(p.first)]; });
      if (cells_at(polygons).size() >= 3) {
        ++at;
        continue;
      }
      for (const auto& p : polygons) root_[static_cast<std::size_t>(root(p.first))] = root(polygons.begin()->first);
      at = stretches_.erase(at);
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
        // On both sides of the arc, or on one; whiskers of no width cancel.
        const int sheet = sheet_of[static_cast<std::size_t>(root(polygon))];
        for (int i = 0; i < (times % 2 == 0 ? 2 : 1); ++i) arc.sheets.push_back(sheet);
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
contracted_skeleton contract(const K& k, const skeleton& raw) {
  return contraction<K>(k, raw).run();
}

}  // namespace osteon
