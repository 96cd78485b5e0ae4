// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From rings to a checked polygon: lines for a kernel, incidences for the algorithms, and the way
/// back to the input.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/common_scale.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/exact_points.hpp"
#include "osteon/input/line_table.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/plane_sweep.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/input/ring_cleaning.hpp"
#include "osteon/input/ring_nesting.hpp"
#include "osteon/input/rings.hpp"
#include "osteon/input/touching_points.hpp"

namespace osteon::plane {

/// The limit of points of a polygon, so that no input can push memory beyond.
inline constexpr std::size_t most_vertices = 10'000'000;

namespace detail {

/// Checks that there are rings, of at least three points each, and not more points than the limit.
/// *Throws* input_error.
template <class Int>
void check_rings(const rings<Int>& r) {
  const std::string file = r.file.empty() ? "" : r.file + ": ";
  std::size_t n = 0;
  for (std::size_t i = 0; i < r.all.size(); ++i) {
    const auto& ring = r.all[i];
    n += ring.points.size();
    if (n > most_vertices) throw input_error(input_fault::absurd_size, i + 1, file + "more than ten million points", "give a smaller polygon");
    if (ring.points.size() < 3)
      ring_names<Int>(r).refuse_ring(input_fault::short_ring, static_cast<int>(i), " has " + counted(ring.points.size(), "point", "points"),
                                     "give at least three, or delete the ring");
  }
  if (n == 0) throw input_error(input_fault::empty, 0, file + "there are no points", "give at least three points");
}

/// See make_polygon.
template <class Int>
class polygon_builder {
 public:
  /// Takes rings that check_rings has accepted.
  polygon_builder(rings<Int> r, bool outside) : in_(std::move(r)), outside_(outside), names_(in_), parts_(parts_of(in_)) { p_.repairs = in_.notes; }

  /// Returns the polygon. To be called once.
  polygon<Int> build() {
    scale_weights();
    scale_points();
    clean();
    std::vector<int> ranks = search();
    check_nesting(parts_, chains_, relations_, names_);
    const reversed_rings reversed = orient(chains_, parts_, relations_);
    note(reversed.repair);
    p_.parts = static_cast<int>(parts_.outer.size());
    p_.holes = chains_.rings() - p_.parts;
    std::optional<touching_points<Int>> touching;
    if (!relations_.touching_vertices.empty()) {
      touching.emplace(points_, names_, std::move(ranks), reversed.reversed, relations_, chains_);
      touching->link_sectors(false);
      p_.holes = touching->count_boundaries(parts_) - p_.parts;
      note(touching->repair());
      if (outside_) touching->link_sectors(true);
      touching->join_straight(weights_);
    }
    fill(touching ? touching->ordered() : all_vertices());
    if (outside_) turn_round();
    rank_edges(p_.boundary, p_.points);
    return std::move(p_);
  }

 private:
  void note(const std::string& sentence) {
    if (!sentence.empty()) p_.repairs.push_back(sentence);
  }

  // Weights by point of the input, brought to integers with one common scale; none where no ring
  // has any.
  void scale_weights() {
    const exact_number<Int> one = {Int(1), 0, 0};
    if (std::all_of(in_.all.begin(), in_.all.end(), [](const auto& ring) { return ring.weights.empty(); })) return;
    common_scale<Int> scale;
    for (std::size_t r = 0; r < in_.all.size(); ++r) {
      const auto& ring = in_.all[r];
      if (!ring.weights.empty() && ring.weights.size() != ring.points.size())
        names_.refuse_ring(input_fault::bad_weight, static_cast<int>(r),
                           " has " + std::to_string(ring.weights.size()) + " weights for " + std::to_string(ring.points.size()) + " points",
                           "give every point the weight of the edge that starts there, or none any");
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const exact_number<Int>& weight = ring.weights.empty() ? one : ring.weights[i];
        if (weight.mantissa < 0)
          names_.refuse(input_fault::bad_weight, names_.first(static_cast<int>(r)) + static_cast<int>(i),
                        ": the edge that starts here has a negative weight",
                        "give a weight greater than zero, or zero for an edge that stands still");
        scale.add(weight);
      }
    }
    if (scale.is_absurd())
      names_.refuse(input_fault::absurd_size, static_cast<int>(scale.finest()),
                    ": the weight has digits so fine that all weights together need too much memory", "round it");
    for (auto& ring : in_.all)
      for (std::size_t i = 0; i < ring.points.size(); ++i)
        weights_.push_back(ring.weights.empty() ? scale.scaled(one) : scale.scaled(std::move(ring.weights[i])));
    p_.weight_ten = scale.ten();
    p_.weight_two = scale.two();
  }

  // Coordinates to integers with one common scale, moved to the middle of their box: that shortens
  // offsets.
  void scale_points() {
    common_scale<Int> scale;
    for (const auto& ring : in_.all)
      for (const auto& p : ring.points)
        for (const auto& x : p) scale.add(x);
    if (scale.is_absurd())
      names_.refuse(input_fault::absurd_size, static_cast<int>(scale.finest() / 2),
                    " has digits so fine that all coordinates together need " + scale.memory(), "round it");
    std::vector<std::array<Int, 2>> points;
    points.reserve(scale.count() / 2);
    for (auto& ring : in_.all) {
      for (auto& p : ring.points) points.push_back({scale.scaled(std::move(p[0])), scale.scaled(std::move(p[1]))});
      ring.points.clear();
      ring.points.shrink_to_fit();  // a tenth of all memory
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [lo, hi] = std::minmax_element(points.begin(), points.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      p_.shift[axis] = ((*lo)[axis] + (*hi)[axis]) / 2;
    }
    for (auto& p : points)
      for (std::size_t axis = 0; axis < 2; ++axis) p[axis] -= p_.shift[axis];
    p_.ten = scale.ten();
    p_.two = scale.two();
    points_ = exact_points<Int>(std::move(points));
  }

  void clean() {
    ring_cleaning<Int> cleaning(points_, weights_, names_);
    chains_ = cleaning.run();
    for (const auto& sentence : cleaning.repairs()) note(sentence);
  }

  // Finds how the rings lie; returns the rank of each vertex in the sweep, nothing where no points
  // touch.
  std::vector<int> search() {
    plane_sweep<Int> sweep(points_, chains_.next, chains_.ring, chains_.rings());
    if (const auto bad = sweep.run()) refuse(*bad);
    relations_ = std::move(sweep.found());
    std::vector<int> ranks;
    if (relations_.touching_vertices.empty()) return ranks;
    for (int v = 0; v < chains_.size(); ++v) ranks.push_back(sweep.rank(v));
    return ranks;
  }

  [[noreturn]] void refuse(const bad_contact& bad) const {
    const auto [first, second] = std::minmax({bad.a, bad.b});
    const auto name = [this](int vertex) { return names_.short_name(chains_.input[vertex]); };
    const auto edge = [&](int e) { return "the edge from " + name(e) + " to " + name(chains_.next[e]); };
    const auto fail = [&](int vertex, const std::string& what, const std::string& hint) {
      names_.refuse(input_fault::self_intersection, chains_.input[vertex], what, hint);
    };
    switch (bad.what) {
      case bad_contact::kind::crossing:
        fail(first, ": " + edge(first) + " crosses " + edge(second), "move the points so that edges do not cross, or cut the polygon there");
        break;
      case bad_contact::kind::overlap:
        fail(first, ": " + edge(first) + " lies partly on " + edge(second), "join or separate the two sides");
        break;
      case bad_contact::kind::at_point:
        if (bad.b_runs_through)
          fail(bad.a, ": the boundary crosses " + edge(bad.b) + " here", "move the point so that the boundary stays on one side");
        break;
    }
    names_.refuse(input_fault::self_intersection, chains_.input[second], ": the boundary crosses itself in this point, which is also " + name(first),
                  "visit the point in another order, or cut the polygon there");
  }

  std::vector<int> all_vertices() const {
    std::vector<int> order(static_cast<std::size_t>(chains_.size()));
    std::iota(order.begin(), order.end(), 0);
    return order;
  }

  // Numbers the vertices in the given order, and finds the lines of their edges.
  void fill(const std::vector<int>& order) {
    std::vector<int> id(chains_.next.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) id[order[i]] = static_cast<int>(i);
    auto& b = p_.boundary;
    b.next.reserve(order.size());
    b.line.reserve(order.size());
    p_.points.reserve(order.size());
    p_.input_points.reserve(order.size());
    p_.input_edges.reserve(order.size());
    line_table<Int> lines(order.size());
    for (const int v : order) {
      const int from = chains_.point_of(v);
      auto line = line_through(points_, from, chains_.point_of(chains_.next[v]));
      if (!weights_.empty()) line.weight = weights_[chains_.weight[v]];
      b.next.push_back(id[chains_.next[v]]);
      b.line.push_back(lines.number(std::move(line)));
      p_.points.push_back(points_[from]);
      p_.input_points.push_back(chains_.input[v]);
      p_.input_edges.push_back(chains_.weight[v]);
    }
    p_.lines = lines.take();
    b.lines = static_cast<int>(p_.lines.size());
  }

  // What is left of every edge changes sides.
  void turn_round() {
    for (auto& l : p_.lines) {
      for (Int& x : l.n) x = -x;
      l.d = -l.d;
    }
    const boundary given = p_.boundary;
    const std::vector<int> edges = p_.input_edges;
    for (std::size_t i = 0; i < given.next.size(); ++i) {
      const int to = given.next[i];
      p_.boundary.next[to] = static_cast<int>(i);
      p_.boundary.line[to] = given.line[i];
      p_.input_edges[to] = edges[i];
    }
  }

  rings<Int> in_;
  const bool outside_;
  const ring_names<Int> names_;
  const ring_parts parts_;
  std::vector<Int> weights_;  // by point of the input; empty: all 1
  // first those of the input, then those that stay, with numbers of vertices
  exact_points<Int> points_;
  ring_chains chains_;
  ring_relations relations_;
  polygon<Int> p_;
};

}  // namespace detail

/// Returns the polygon that rings bound, or with `outside` what is not in it.
///
/// Repaired, and said in `repairs`: points that repeat their predecessor; points on a straight side
/// between edges of equal weight; rings with the wrong orientation (outer rings run
/// counter-clockwise, holes clockwise; weights stay with their edges); boundaries that touch
/// themselves or each other without crossing while the interior of each part stays connected. There
/// the boundary has one vertex for each sector of the interior at the touching point, and follows
/// the interior in place of the rings; `holes` counts the clockwise rings that result.
///
/// With `outside`, vertices and lines are the same (where nothing touches), but turned round: edge
/// next[i] of the polygon is its edge i. `parts` and `holes` are still those of the polygon. Its
/// skeleton is unbounded.
///
/// *Throws* input_error for everything else that is no polygon with disjoint parts: spikes,
/// crossings, overlaps, holes outside of their outer ring or inside of others, interiors that fall
/// apart, negative weights.
/// *Complexity* O(n log n), see plane_sweep.
template <class Int>
polygon<Int> make_polygon(rings<Int> r, bool outside = false) {
  detail::check_rings(r);
  return detail::polygon_builder<Int>(std::move(r), outside).build();
}

}  // namespace osteon::plane
