// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the raw skeleton of the perturbed polygon to the exact skeleton of the true one (design 04, 06): what has come together in the limit
/// becomes one, what has vanished goes.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// The exact skeleton: places where at least three arcs meet, and the polygon's vertices.
struct contracted_skeleton {
  struct node {
    int vertex;                     ///< of the polygon, or -1
    triple lines;                   ///< as of a raw node: that meet here, at a time that the unperturbed kernel knows
    std::array<line_id, 2> corner;  ///< two of them that cross
  };
  struct arc {
    int source;                ///< not later than the target
    int target;                ///< -1: never ends
    std::array<int, 2> faces;  ///< on its two sides
  };
  std::vector<node> nodes;  ///< those of vertices with an arc come first
  std::vector<arc> arcs;
  int vertices = 0;  ///< nodes that are vertices of the polygon
  int faces = 0;     ///< with an area
};

/// Contracts under the *unperturbed* kernel, whose zeros say what coincides.
template <kernel<2> K>
class contraction {
 public:
  contraction(const K& k, const std::vector<int>& line_of_edge, const skeleton& raw) : k_(k), line_(line_of_edge), raw_(raw) {}

  /// Expected linear time, but for sorting what happens at one moment on one line.
  contracted_skeleton run() {
    merge_nodes();
    collect_stretches();
    match_sides();
    join_straight();
    return collect();
  }

 private:
  using meeting = typename K::meeting;
  static constexpr std::size_t ahead = 16;  // so many nodes before their turn their lines are asked for

  struct place {
    int raw;     ///< its first node
    int moment;  ///< -1: no other node has the same
    std::array<line_id, 2> corner;
    int same = -1;  ///< an earlier place that it has turned out to be
  };
  // A stretch between two places, and the faces beside it.
  struct stretch {
    std::array<int, 2> ends;
    std::array<int, 2> faces;
    bool gone = false;
  };
  // One side of an arc on a stretch: the ends and a face.
  using side_of_stretch = std::array<int, 3>;

  // ---- places

  void merge_nodes() {
    place_of_.resize(raw_.nodes.size());
    places_.reserve(raw_.nodes.size());
    std::optional<meeting> moment;
    std::size_t first = 0;  // node of the moment
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const auto& node = raw_.nodes[n];
      if (n + ahead < raw_.nodes.size()) prefetch_lines(raw_.nodes[n + ahead].lines);
      if (node.vertex >= 0) {
        place_of_[n] = add_place(n, -1, {node.lines[0], node.lines[1]});
        continue;
      }
      const auto when = k_.meet(node.lines);
      if (!when)
        throw unsupported_error("held edges on one line face each other at the lines " + std::to_string(node.lines[0]) + ", " +
                                std::to_string(node.lines[1]) + " and " + std::to_string(node.lines[2]) +
                                ": whether the polygon is open between them cannot be told; hint: move one of them a little");
      if (!moment || k_.compare(*moment, *when) != sign::zero) {
        if (moment) merge_moment(*moment, first, n);
        moment = when;
        first = n;
      }
    }
    if (moment) merge_moment(*moment, first, raw_.nodes.size());
    for (int& p : place_of_) p = root(p);
  }

  int add_place(std::size_t node, int moment, const std::array<line_id, 2>& corner) {
    places_.push_back({static_cast<int>(node), moment, corner});
    return static_cast<int>(places_.size()) - 1;
  }

  void prefetch_lines(const triple& lines) const {
    if constexpr (requires { k_.prefetch(lines[0]); })
      for (const line_id l : lines)
        if (l >= 0) k_.prefetch(l);
  }

  // Places for the nodes from first to last, which are those of one moment.
  void merge_moment(const meeting& when, std::size_t first, std::size_t last) {
    if (last - first == 1) {
      place_of_[first] = add_place(first, -1, corner_of(raw_.nodes[first].lines));
      return;
    }
    const int moment = static_cast<int>(moments_.size());
    moments_.push_back(when);
    crowded_.resize(raw_.nodes.size());
    std::fill(crowded_.begin() + static_cast<std::ptrdiff_t>(first), crowded_.begin() + static_cast<std::ptrdiff_t>(last), true);
    std::unordered_map<line_id, std::vector<int>> here;  // places on each line, in their order
    for (std::size_t n = first; n < last; ++n) {
      const auto& node = raw_.nodes[n];
      const int fresh = add_place(n, moment, corner_of(node.lines));
      int found = -1;
      std::array<int, 3> at{};
      for (int r = 0; r < 3; ++r) {
        const line_id line = node.lines[r];
        const auto& places = here[line];
        at[r] = static_cast<int>(
            std::partition_point(places.begin(), places.end(), [&](int q) { return comes_first(line, places_[q], places_[fresh]); }) -
            places.begin());
        if (at[r] == static_cast<int>(places.size()) || comes_first(line, places_[fresh], places_[places[at[r]]])) continue;
        // Several, so far without a common line, may turn out to be one.
        const int same = root(places[at[r]]);
        if (found >= 0 && found != same) places_[std::max(found, same)].same = std::min(found, same);
        found = found < 0 ? same : std::min(found, same);
      }
      if (found >= 0) places_.pop_back();
      place_of_[n] = found >= 0 ? found : fresh;
      for (int r = 0; r < 3; ++r) {
        auto& places = here[node.lines[r]];
        if (at[r] == static_cast<int>(places.size()) || root(places[at[r]]) != place_of_[n]) places.insert(places.begin() + at[r], place_of_[n]);
      }
    }
  }

  int root(int p) const {
    while (places_[p].same >= 0) p = places_[p].same;
    return p;
  }

  std::array<line_id, 2> corner_of(const triple& lines) const {
    for (const std::array<int, 2> pair : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}})
      if (k_.transversal(lines[pair[0]], lines[pair[1]])) return {lines[pair[0]], lines[pair[1]]};
    broken_invariant<K>("two lines of an event cross in the limit");
  }

  sign side(line_id l, const place& p) const {
    if (l == p.corner[0] || l == p.corner[1]) return sign::zero;
    return k_.side(l, p.corner[0], p.corner[1], p.moment < 0 ? *k_.meet(raw_.nodes[p.raw].lines) : moments_[p.moment]);
  }

  // ---- arcs

  void collect_stretches() {
    find_ridges();
    std::unordered_map<int, std::vector<int>> passed;  // places on the way of an arc, in order of time
    for (const auto& p : raw_.interior_nodes) {
      const place& at = places_[place_of_[p.node]];
      for (const int f : raw_.arcs[p.arc].faces)
        if (raw_.nodes[at.raw].vertex >= 0 || side(line_[f], at) != sign::zero) broken_invariant<K>("an arc passes through its nodes");
      passed[p.arc].push_back(place_of_[p.node]);
    }
    for (std::size_t a = 0; a < raw_.arcs.size(); ++a) {
      const auto& arc = raw_.arcs[a];
      int from = place_of_[arc.source];
      const auto on_the_way = passed.find(static_cast<int>(a));
      if (on_the_way != passed.end())
        for (const int p : on_the_way->second)
          if (p != from && (arc.target < 0 || p != place_of_[arc.target])) {
            add_stretch(from, p, arc.faces);
            from = p;
          }
      if (arc.target < 0)
        add_stretch(from, -1 - static_cast<int>(a), arc.faces);
      else if (const int to = place_of_[arc.target]; from != to)
        is_instant(arc) ? cut_ridge(arc, from, to) : add_stretch(from, to, arc.faces);
    }
  }

  bool is_instant(const skeleton::arc& arc) const {
    if (arc.target < 0 || crowded_.empty() || !crowded_[arc.source] || !crowded_[arc.target]) return false;
    const int from = root(place_of_[arc.source]);
    const int to = root(place_of_[arc.target]);
    return from != to && places_[from].moment == places_[to].moment;
  }

  // The lines of an arc without duration coincide, and with them perhaps others of that moment. A ridge is such a line with the places on it in their
  // order; those that fall together are one.
  void find_ridges() {
    for (const auto& arc : raw_.arcs) {  // places without a common line are one where an arc of no length joins them
      if (!is_instant(arc)) continue;
      const int p = root(place_of_[arc.source]);
      const int q = root(place_of_[arc.target]);
      const auto& corner = places_[q].corner;
      if (side(corner[0], places_[p]) == sign::zero && side(corner[1], places_[p]) == sign::zero) places_[std::max(p, q)].same = std::min(p, q);
    }
    for (int& p : place_of_) p = root(p);
    for (const auto& arc : raw_.arcs) {
      if (!is_instant(arc)) continue;
      const int m = places_[place_of_[arc.source]].moment;
      auto& same = ridge_of_[m];
      const line_id of = ridge(same, line_[arc.faces[1]]);
      same.try_emplace(of, of);
      same[ridge(same, line_[arc.faces[0]])] = of;
    }
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const int m = places_[place_of_[n]].moment;
      const auto same = ridge_of_.find(m);
      if (same == ridge_of_.end()) continue;
      for (const line_id l : raw_.nodes[n].lines)
        if (same->second.contains(l)) on_ridge_[ridge_key(m, ridge(same->second, l))].push_back(place_of_[n]);
    }
    for (auto& [key, places] : on_ridge_) {
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      const auto along = static_cast<line_id>(key & 0xFFFFFFFFU);
      std::sort(places.begin(), places.end(), [&](int p, int q) { return comes_first(along, places_[p], places_[q]); });
      for (std::size_t i = 1; i < places.size(); ++i)
        if (!comes_first(along, places_[places[i - 1]], places_[places[i]])) {
          const auto [p, q] = std::minmax({root(places[i - 1]), root(places[i])});
          if (p != q) places_[q].same = p;
        }
    }
    for (int& p : place_of_) p = root(p);
    for (auto& [key, places] : on_ridge_) {
      for (int& p : places) p = root(p);
      places.erase(std::unique(places.begin(), places.end()), places.end());
    }
  }

  static std::uint64_t ridge_key(int moment, line_id line) { return static_cast<std::uint64_t>(moment) << 32U | static_cast<std::uint32_t>(line); }

  // The line that stands for all that coincide with this one.
  using coincidence = std::unordered_map<line_id, line_id>;
  static line_id ridge(const coincidence& same, line_id l) {
    while (true) {
      const auto up = same.find(l);
      if (up == same.end() || up->second == l) return l;
      l = up->second;
    }
  }

  // The places on the way cut an arc without duration.
  void cut_ridge(const skeleton::arc& arc, int source, int target) {
    const int m = places_[source].moment;
    const line_id along = ridge(ridge_of_[m], line_[arc.faces[0]]);
    const auto& places = on_ridge_[ridge_key(m, along)];
    const auto find = [&](int p) {
      return std::partition_point(places.begin(), places.end(), [&](int q) { return comes_first(along, places_[q], places_[p]); });
    };
    auto from = find(source);
    auto to = find(target);
    if (to < from) std::swap(from, to);
    if (to == places.end() || std::min(*from, *to) != std::min(source, target) || std::max(*from, *to) != std::max(source, target))
      broken_invariant<K>("an arc ends on its lines");
    for (; from != to; ++from) add_stretch(*from, *(from + 1), arc.faces);
  }

  // Whether p comes before q on a line on which both lie.
  bool comes_first(line_id along, const place& p, const place& q) const {
    for (const line_id x : p.corner)
      if (k_.transversal(along, x)) {
        const sign s = side(x, q);
        return s != sign::zero && (s == sign::positive) == (k_.orientation(along, x) == sign::negative);
      }
    broken_invariant<K>("two lines cross at a place");
  }

  void add_stretch(int from, int to, const std::array<int, 2>& faces) {
    if (to >= 0 && from > to) std::swap(from, to);
    for (const int f : faces) sides_.push_back({from, to, f});
  }

  // By first places, each of which has few.
  void sort_sides() {
    std::vector<int> end(places_.size() + 1, 0);  // of the sides at a place; first where they begin
    for (const auto& s : sides_) ++end[s[0] + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<side_of_stretch> sorted(sides_.size());
    for (const auto& s : sides_) sorted[end[s[0]]++] = s;
    sides_ = std::move(sorted);
    int first = 0;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      std::sort(sides_.begin() + first, sides_.begin() + end[p]);
      first = end[p];
    }
  }

  // A face that is met an even number of times is on both sides of a stretch, which then does not bound it.
  void match_sides() {
    sort_sides();
    for (std::size_t i = 0; i < sides_.size();) {
      const int from = sides_[i][0];
      const int to = sides_[i][1];
      stretch s{{from, to}, {-1, -1}};
      int count = 0;
      while (i < sides_.size() && sides_[i][0] == from && sides_[i][1] == to) {
        std::size_t next = i;
        while (next < sides_.size() && sides_[next] == sides_[i]) ++next;
        if ((next - i) % 2 != 0) {
          if (count == 2) broken_invariant<K>("an arc has two sides in the limit");
          s.faces[count++] = sides_[i][2];
        }
        i = next;
      }
      if (count == 1) broken_invariant<K>("an arc has two sides in the limit");
      if (count == 2) stretches_.push_back(s);
    }
    std::vector<side_of_stretch>().swap(sides_);
  }

  // ---- the result

  // Two stretches between the same faces that meet at a place where nothing else does are one.
  void join_straight() {
    degree_.assign(places_.size(), 0);
    std::vector<std::array<int, 2>> at(places_.size(), {-1, -1});
    for (std::size_t i = 0; i < stretches_.size(); ++i)
      for (const int p : stretches_[i].ends)
        if (p >= 0 && degree_[p]++ < 2) at[p][degree_[p] - 1] = static_cast<int>(i);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (degree_[p] != 2 || raw_.nodes[places_[p].raw].vertex >= 0) continue;
      const int middle = static_cast<int>(p);
      const auto [i, j] = at[p];
      if (stretches_[i].faces != stretches_[j].faces) broken_invariant<K>("at a node at least three arcs meet");
      const auto far = [&](int s) { return stretches_[s].ends[stretches_[s].ends[0] == middle ? 1 : 0]; };
      const int end = far(j);
      stretches_[i].ends[stretches_[i].ends[0] == middle ? 0 : 1] = end;
      stretches_[j].gone = true;
      degree_[p] = 0;
      if (end >= 0 && degree_[end] <= 2)
        for (int& s : at[end])
          if (s == j) s = i;
    }
    std::erase_if(stretches_, [](const stretch& s) { return s.gone; });
  }

  contracted_skeleton collect() const {
    contracted_skeleton result;
    std::vector<int> number(places_.size(), -1);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (degree_[p] == 0) continue;
      const auto& node = raw_.nodes[places_[p].raw];
      number[p] = static_cast<int>(result.nodes.size());
      result.vertices += node.vertex >= 0 ? 1 : 0;
      result.nodes.push_back({node.vertex, node.lines, places_[p].corner});
    }
    std::vector<bool> seen(raw_.faces.size(), false);
    for (const auto& s : stretches_) {
      int from = s.ends[0];
      int to = s.ends[1];
      if (to < 0 || from < 0)
        from = std::max(from, to), to = -1;
      else if (from > to)
        std::swap(from, to);
      result.arcs.push_back({number[from], to < 0 ? -1 : number[to], s.faces});
      for (const int f : s.faces) {
        result.faces += seen[f] ? 0 : 1;
        seen[f] = true;
      }
    }
    return result;
  }

  const K& k_;
  const std::vector<int>& line_;
  const skeleton& raw_;
  std::vector<meeting> moments_;  // those of several nodes
  std::vector<place> places_;     // in order of time
  std::vector<int> place_of_;
  std::vector<bool> crowded_;                                     // by node: others are of the same moment; empty: none
  std::unordered_map<int, coincidence> ridge_of_;                 // by moment
  std::unordered_map<std::uint64_t, std::vector<int>> on_ridge_;  // places in order
  std::vector<side_of_stretch> sides_;
  std::vector<stretch> stretches_;
  std::vector<int> degree_;
};

template <kernel<2> K>
contracted_skeleton contract(const K& k, const std::vector<int>& line_of_edge, const skeleton& raw) {
  return contraction<K>(k, line_of_edge, raw).run();
}

}  // namespace osteon::plane
