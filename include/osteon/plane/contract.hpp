// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From the raw skeleton of the perturbed polygon to the exact skeleton of the true one
/// (docs/theory/degeneracy.md, docs/theory/plane.md): what has come together in the limit becomes
/// one, what has vanished goes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/node_places.hpp"
#include "osteon/plane/ridges.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// The exact skeleton: places where at least three arcs meet, and the polygon's vertices.
struct contracted_skeleton {
  /// A place where at least three arcs meet, or a vertex of the polygon.
  struct node {
    int vertex;  ///< of the polygon, or -1
    /// as of a raw node: that meet here, at a time that the unperturbed kernel knows
    triple lines;
    std::array<line_id, 2> corner;  ///< two of them that cross
  };
  /// A way along which two faces meet.
  struct arc {
    int source;                ///< not later than the target, and before it in the list of nodes
    int target;                ///< -1: never ends
    std::array<int, 2> faces;  ///< on its two sides
  };
  std::vector<node> nodes;  ///< those of vertices with an arc come first
  std::vector<arc> arcs;
  int vertices = 0;  ///< nodes that are vertices of the polygon
  int faces = 0;     ///< with an area
};

/// Contracts under the *unperturbed* kernel, whose zeros say what coincides.
template <unperturbed_kernel<2> K>
class contraction {
 public:
  contraction(const K& k, const std::vector<int>& line_of_edge, const skeleton& raw)
      : line_(line_of_edge), raw_(raw), places_(k, raw), ridges_(k, line_of_edge, raw, places_) {}
  contraction(const contraction&) = delete;
  contraction& operator=(const contraction&) = delete;

  /// Returns the contracted skeleton; to be called once.
  contracted_skeleton run() {
    places_.find();
    ridges_.find();
    collect_stretches();
    match_sides();
    join_straight();
    return collect();
  }

 private:
  // A stretch between two places, and the faces beside it.
  struct stretch {
    std::array<int, 2> ends;
    std::array<int, 2> faces;
    bool gone = false;
  };
  // One side of an arc on a stretch: the ends and a face.
  using side_of_stretch = std::array<int, 3>;

  bool is_vertex(int p) const { return raw_.nodes[places_[p].raw].vertex >= 0; }

  // The places on the way of an arc, in order of time.
  std::unordered_map<int, std::vector<int>> collect_interior_places() const {
    std::unordered_map<int, std::vector<int>> result;
    for (const auto& i : raw_.interior_nodes) {
      const int p = places_.of_node(i.node);
      for (const int f : raw_.arcs[i.arc].faces)
        if (is_vertex(p) || places_.side(line_[f], places_[p]) != sign::zero) broken_invariant<K>("an arc passes through its nodes");
      result[i.arc].push_back(p);
    }
    return result;
  }

  void collect_stretches() {
    const auto interior = collect_interior_places();
    for (std::size_t a = 0; a < raw_.arcs.size(); ++a) {
      const auto& arc = raw_.arcs[a];
      int from = places_.of_node(arc.source);
      if (const auto on_the_way = interior.find(static_cast<int>(a)); on_the_way != interior.end())
        for (const int p : on_the_way->second)
          if (p != from && (arc.target < 0 || p != places_.of_node(arc.target))) {
            add_stretch(from, p, arc.faces);
            from = p;
          }
      if (arc.target < 0)
        add_stretch(from, -1 - static_cast<int>(a), arc.faces);
      else if (const int to = places_.of_node(arc.target); from != to) {
        if (ridges_.has_no_duration(arc))
          ridges_.cut(arc, from, to, [&](int p, int q) { add_stretch(p, q, arc.faces); });
        else
          add_stretch(from, to, arc.faces);
      }
    }
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
    std::vector<side_of_stretch> by_place(sides_.size());
    for (const auto& s : sides_) by_place[end[s[0]]++] = s;
    sides_ = std::move(by_place);
    int first = 0;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      std::sort(sides_.begin() + first, sides_.begin() + end[p]);
      first = end[p];
    }
  }

  // A face that is met an even number of times is on both sides of a stretch, which then does not
  // bound it.
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
      const int middle = static_cast<int>(p);
      if (degree_[p] != 2 || is_vertex(middle)) continue;
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
      const place& at = places_[static_cast<int>(p)];
      const auto& node = raw_.nodes[at.raw];
      number[p] = static_cast<int>(result.nodes.size());
      result.vertices += node.vertex >= 0 ? 1 : 0;
      result.nodes.push_back({node.vertex, node.lines, at.across});
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

  const std::vector<int>& line_;
  const skeleton& raw_;
  node_places<K> places_;
  ridges<K> ridges_;
  std::vector<side_of_stretch> sides_;
  std::vector<stretch> stretches_;
  std::vector<int> degree_;  // by place
};

/// Contracts a raw skeleton to the exact one: what has come together in the limit of the
/// perturbation becomes one, what has vanished goes.
/// *Requires* the kernel under which the skeleton was computed, or its base, and `boundary::line`
/// of the polygon.
/// *Throws* unsupported_error where stationary edges on one line face each other.
/// *Complexity* expected linear, but for sorting what happens at one time on one line.
template <contracting_kernel<2> K>
contracted_skeleton contract(const K& k, const std::vector<int>& line_of_edge, const skeleton& raw) {
  if constexpr (perturbed_kernel<K, 2>)
    return contract(k.base(), line_of_edge, raw);
  else
    return contraction<K>(k, line_of_edge, raw).run();
}

}  // namespace osteon::plane
