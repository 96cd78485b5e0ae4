// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From rings to a checked polygon: lines for a kernel, incidences for the algorithms, and the way back to the input.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/input/plane_sweep.hpp"
#include "osteon/input/polygon.hpp"

namespace osteon::plane {

/// Limits that no input can push memory beyond.
inline constexpr std::size_t most_vertices = 10'000'000;

namespace detail {

/// Numbers brought to one scale: integers times 10^ten * 2^two.
template <class Int>
struct common_scale {
  int ten = 0;
  int two = 0;
  long most_ten = 0;
  long most_two = 0;
  std::size_t finest = 0;  ///< the number that sets the scale
  std::size_t count = 0;
  bool any = false;
  std::vector<Int> tens = {Int(1)};

  void add(const exact_number<Int>& x) {
    ++count;
    if (x.mantissa == 0) return;
    if (!any || x.ten < ten || x.two < two) finest = count - 1;
    ten = any ? std::min(ten, x.ten) : x.ten;
    two = any ? std::min(two, x.two) : x.two;
    most_ten = any ? std::max(most_ten, long{x.ten}) : x.ten;
    most_two = any ? std::max(most_two, long{x.two}) : x.two;
    any = true;
  }

  /// Bits that the scale adds to the longest number.
  double bits() const { return 3.33 * static_cast<double>(most_ten - ten) + static_cast<double>(most_two - two); }
  bool absurd() const { return bits() > 2e4 || bits() * static_cast<double>(count) > 4e9; }  // half a gigabyte

  Int scaled(exact_number<Int>&& x) {
    if (x.mantissa == 0) return Int(0);
    const auto t = static_cast<std::size_t>(x.ten - ten);
    while (tens.size() <= t) tens.push_back(tens.back() * 10);
    Int result = std::move(x.mantissa);
    if (t > 0) result *= tens[t];
    if (x.two > two) result <<= static_cast<unsigned>(x.two - two);
    return result;
  }
};

/// A number of 64 bits that is equal for equal integers.
template <class Int>
std::int64_t residue(const Int& x) {
  if (std::abs(static_cast<double>(x)) < 0x1p62) return static_cast<std::int64_t>(x);
  return static_cast<std::int64_t>(Int(x % Int((std::int64_t{1} << 61) - 1)));
}

}  // namespace detail

/// See make_polygon.
template <class Int>
class polygon_builder {
 public:
  polygon_builder(rings<Int> r, bool outside) : in_(std::move(r)), outside_(outside) {}

  polygon<Int> build() {
    count();
    scale_weights();
    scale_points();
    clean_rings();
    search();
    check_nesting();
    orient();
    const bool touching = !m_.touching_vertices.empty();
    if (touching) {
      cut_edges();
      arriving_ = previous_;
      link_sectors(false);
    }
    count_loops();
    if (touching && outside_) link_sectors(true);
    if (touching) join_straight();
    finish();
    if (outside_) turn_round();
    rank_edges(p_.boundary, p_.points);
    return std::move(p_);
  }

 private:
  [[noreturn]] void fail(input_fault fault, int input, const std::string& what, const std::string& hint) const {
    throw input_error(fault, static_cast<std::size_t>(input) + 1, name(input) + what, hint);
  }

  // "ring 2, point 5", and where it was read; points are counted from one within their ring.
  int ring_of_input(int input) const {
    return static_cast<int>(std::upper_bound(first_input_.begin(), first_input_.end(), input) - first_input_.begin()) - 1;
  }
  std::string short_name(int input) const {
    const int r = ring_of_input(input);
    return "ring " + std::to_string(r + 1) + ", point " + std::to_string(input - first_input_[r] + 1);
  }
  std::string name(int input) const {
    const int r = ring_of_input(input);
    const auto& lines = in_.all[r].lines;
    const auto i = static_cast<std::size_t>(input - first_input_[r]);
    std::string text = in_.file;
    if (!text.empty() && i < lines.size()) text += ":" + std::to_string(lines[i]);
    if (!text.empty()) text += ": ";
    return text + short_name(input);
  }
  std::string edge_name(int e) const { return "the edge from " + short_name(input_[e]) + " to " + short_name(input_[next_[e]]); }
  std::string file_prefix() const { return in_.file.empty() ? "" : in_.file + ": "; }

  void note(const std::string& sentence) { p_.repairs.push_back(sentence); }
  static std::string plural(long n, const std::string& one, const std::string& many) { return std::to_string(n) + ' ' + (n == 1 ? one : many); }

  void count() {
    std::size_t n = 0;
    for (std::size_t r = 0; r < in_.all.size(); ++r) {
      const auto& ring = in_.all[r];
      if (n + ring.points.size() > most_vertices)
        throw input_error(input_fault::absurd_size, r + 1, file_prefix() + "more than ten million points", "give a smaller polygon");
      if (ring.points.size() < 3) {
        const std::string at = in_.file.empty()     ? ""
                               : ring.lines.empty() ? in_.file + ": "
                                                    : in_.file + ":" + std::to_string(ring.lines.front()) + ": ";
        throw input_error(input_fault::short_ring, r + 1,
                          at + "ring " + std::to_string(r + 1) + " has " + plural(static_cast<long>(ring.points.size()), "point", "points"),
                          "give at least three, or delete the ring");
      }
      first_input_.push_back(static_cast<int>(n));
      n += ring.points.size();
    }
    if (n == 0) throw input_error(input_fault::empty, 0, file_prefix() + "there are no points", "give at least three points");
    for (const auto& text : in_.notes) note(text);
    std::unordered_map<int, int> parts;
    for (std::size_t r = 0; r < in_.all.size(); ++r) {
      const auto [found, fresh] = parts.emplace(in_.all[r].part, static_cast<int>(outer_.size()));
      if (fresh) outer_.push_back(static_cast<int>(r));
      part_.push_back(found->second);
    }
  }

  void scale_weights() {
    detail::common_scale<Int> scale;
    bool weighted = false;
    const exact_number<Int> one = {Int(1), 0, 0};
    std::vector<int> inputs;
    for (std::size_t r = 0; r < in_.all.size(); ++r) {
      const auto& ring = in_.all[r];
      if (ring.weights.empty()) continue;
      weighted = true;
      if (ring.weights.size() != ring.points.size())
        throw input_error(input_fault::bad_weight, r + 1,
                          file_prefix() + "ring " + std::to_string(r + 1) + " has " + std::to_string(ring.weights.size()) + " weights for " +
                              std::to_string(ring.points.size()) + " points",
                          "give every point the weight of the edge that starts there, or none any");
      for (std::size_t i = 0; i < ring.weights.size(); ++i) {
        inputs.push_back(first_input_[r] + static_cast<int>(i));
        if (ring.weights[i].mantissa < 0)
          fail(input_fault::bad_weight, inputs.back(), ": the edge that starts here has a negative weight",
               "give a weight greater than zero, or zero for an edge that is held");
        scale.add(ring.weights[i]);
      }
    }
    if (!weighted) return;
    for (const auto& ring : in_.all)
      if (ring.weights.empty()) scale.add(one), inputs.push_back(first_input_[static_cast<std::size_t>(&ring - in_.all.data())]);
    if (scale.absurd())
      fail(input_fault::absurd_size, inputs[scale.finest], ": the weight has digits so fine that all weights together need too much memory",
           "round it");
    for (auto& ring : in_.all)
      for (std::size_t i = 0; i < ring.points.size(); ++i)
        weights_.push_back(scale.scaled(ring.weights.empty() ? exact_number<Int>(one) : std::move(ring.weights[i])));
    p_.weight_ten = scale.ten;
    p_.weight_two = scale.two;
  }

  // Coordinates to integers with one common scale, moved to the middle of their box: that shortens offsets.
  void scale_points() {
    detail::common_scale<Int> scale;
    for (const auto& ring : in_.all)
      for (const auto& p : ring.points)
        for (const auto& x : p) scale.add(x);
    if (scale.absurd())
      fail(input_fault::absurd_size, static_cast<int>(scale.finest / 2),
           " has digits so fine that all coordinates together need " +
               std::to_string(static_cast<long>(scale.bits() * static_cast<double>(scale.count) / 8e6)) + " MB",
           "round it");
    std::vector<std::array<Int, 2>> points;
    points.reserve(scale.count / 2);
    for (auto& ring : in_.all) {
      for (auto& p : ring.points) points.push_back({scale.scaled(std::move(p[0])), scale.scaled(std::move(p[1]))});
      ring.points = {};
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [lo, hi] = std::minmax_element(points.begin(), points.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      p_.shift[axis] = ((*lo)[axis] + (*hi)[axis]) / 2;
    }
    for (auto& p : points)
      for (std::size_t axis = 0; axis < 2; ++axis) p[axis] -= p_.shift[axis];
    p_.ten = scale.ten;
    p_.two = scale.two;
    points_ = exact_points<Int>(std::move(points));
  }

  // Removes repeated and straight vertices; refuses spikes.
  void clean_rings() {
    long repeated = 0;
    long straight = 0;
    int first_repeated = -1;
    int first_straight = -1;
    struct vertex {
      int point;
      int weight;
    };
    std::vector<vertex> ring;
    for (int r = 0; r < static_cast<int>(first_input_.size()); ++r) {
      const int begin = first_input_[r];
      const int end = r + 1 < static_cast<int>(first_input_.size()) ? first_input_[r + 1] : static_cast<int>(points_.size());
      const auto repeats = [&](int i) {
        ++repeated;
        if (first_repeated < 0) first_repeated = i;
      };
      ring.clear();
      for (int i = begin; i < end; ++i) {
        if (!ring.empty() && points_.compare(ring.back().point, i) == sign::zero) {
          ring.back().weight = i;  // the edge of length zero disappears, its successor stays
          repeats(i);
        } else {
          ring.push_back({i, i});
        }
      }
      for (; ring.size() > 1 && points_.compare(ring.back().point, begin) == sign::zero; ring.pop_back()) repeats(ring.back().point);
      const std::size_t n = ring.size();
      if (n < 3) fail(input_fault::short_ring, begin, ": the ring has fewer than three different points", "give at least three, or delete the ring");

      const auto turn_at = [&](std::size_t i) { return points_.turn(ring[(i + n - 1) % n].point, ring[i].point, ring[(i + 1) % n].point); };
      int spike = -1;
      bool flat = true;
      first_.push_back(static_cast<int>(input_.size()));
      for (std::size_t i = 0; i < n; ++i) {
        const auto& before = ring[(i + n - 1) % n];
        const auto& v = ring[i];
        if (turn_at(i) == sign::zero) {
          if (points_.compare(before.point, v.point) != points_.compare(v.point, ring[(i + 1) % n].point)) {
            if (spike < 0) spike = v.point;
          } else if (same_weight(before.weight, v.weight)) {
            ++straight;
            if (first_straight < 0) first_straight = v.point;
            continue;
          }
        } else {
          flat = false;
        }
        input_.push_back(v.point);
        weight_.push_back(v.weight);
        ring_.push_back(r);
      }
      if (flat) fail(input_fault::zero_area, begin, ": all points of the ring lie on one line", "delete the ring");
      if (spike >= 0) fail(input_fault::spike, spike, ": the boundary turns back on itself here", "delete this point");
    }
    const int n = static_cast<int>(input_.size());
    for (int i = 0; i < n; ++i) points_.move(input_[i], i);
    points_.shrink(static_cast<std::size_t>(n));
    next_.resize(static_cast<std::size_t>(n));
    std::iota(next_.begin(), next_.end(), 1);
    for (std::size_t r = 0; r < first_.size(); ++r) next_[(r + 1 < first_.size() ? first_[r + 1] : n) - 1] = first_[r];
    if (repeated > 0)
      note(plural(repeated, "point that repeats its predecessor was", "points that repeat their predecessors were") +
           " removed, the first: " + name(first_repeated));
    if (straight > 0)
      note(plural(straight, "point on a straight side was", "points on straight sides were") + " removed, the first: " + name(first_straight));
  }

  bool same_weight(int a, int b) const { return weights_.empty() || weights_[a] == weights_[b]; }

  void search() {
    crossing_search<Int> s(points_, next_, ring_, static_cast<int>(first_.size()));
    const auto bad = s.run();
    if (!bad) {
      m_ = std::move(s.found());
      if (!m_.touching_vertices.empty()) {
        ranks_.resize(next_.size());
        for (int i = 0; i < static_cast<int>(next_.size()); ++i) ranks_[i] = s.rank(i);
      }
      return;
    }
    switch (bad->what) {
      case bad_meeting::kind::crossing:
        fail(input_fault::self_intersection, input_[std::min(bad->a, bad->b)],
             ": " + edge_name(std::min(bad->a, bad->b)) + " crosses " + edge_name(std::max(bad->a, bad->b)),
             "move the points so that edges do not cross, or cut the polygon there");
      case bad_meeting::kind::overlap:
        fail(input_fault::self_intersection, input_[std::min(bad->a, bad->b)],
             ": " + edge_name(std::min(bad->a, bad->b)) + " lies partly on " + edge_name(std::max(bad->a, bad->b)), "join or separate the two sides");
      case bad_meeting::kind::at_point:
        if (bad->b_runs_through)
          fail(input_fault::self_intersection, input_[bad->a], ": the boundary crosses " + edge_name(bad->b) + " here",
               "move the point so that the boundary stays on one side");
        fail(input_fault::self_intersection, input_[std::max(bad->a, bad->b)],
             ": the boundary crosses itself in this point, which is also " + short_name(input_[std::min(bad->a, bad->b)]),
             "visit the point in another order, or cut the polygon there");
    }
  }

  void check_nesting() const {
    for (int r = 0; r < static_cast<int>(part_.size()); ++r) {
      const int part = part_[r];
      const int outer = outer_[part];
      const int around = m_.parents[r];
      const int at = input_[first_[r]];
      const auto ring_name = [](int i) { return "ring " + std::to_string(i + 1); };
      if (r == outer) {
        if (around >= 0 && outer_[part_[around]] == around)
          fail(input_fault::misplaced_ring, at, ": the ring is the outer one of its part, but lies inside of another part, " + ring_name(around),
               "make it a hole, or keep the parts apart");
      } else if (around < 0 || part_[around] != part) {
        fail(input_fault::misplaced_ring, at, ": the hole lies outside of its outer ring, " + ring_name(outer),
             "give the outer ring first, and a part of its own for what lies apart");
      } else if (around != outer) {
        fail(input_fault::misplaced_ring, at, ": the hole lies inside of another hole, " + ring_name(around),
             "delete it, or give it as a part of its own");
      }
    }
  }

  // Outer rings counter-clockwise, holes clockwise. A reversed edge starts where it ended: its number changes.
  void orient() {
    const int n = static_cast<int>(next_.size());
    const int rings = static_cast<int>(first_.size());
    reversed_.resize(first_.size());
    long outers = 0;
    long holes = 0;
    int first = -1;
    for (int r = 0; r < rings; ++r) {
      const bool outer = outer_[part_[r]] == r;
      reversed_[r] = m_.counterclockwise[r] != outer;
      if (!reversed_[r]) continue;
      (outer ? outers : holes) += 1;
      if (first < 0) first = r;
      const int begin = first_[r];
      const int end = r + 1 < rings ? first_[r + 1] : n;
      for (int i = begin; i < end; ++i) next_[i] = i > begin ? i - 1 : end - 1;
      std::rotate(weight_.begin() + begin, weight_.begin() + end - 1, weight_.begin() + end);
    }
    previous_.resize(next_.size());
    for (int i = 0; i < n; ++i) previous_[next_[i]] = i;
    if (first < 0) return;
    std::string text;
    if (outers > 0) text = plural(outers, "clockwise outer ring", "clockwise outer rings");
    if (holes > 0) text += (outers > 0 ? " and " : "") + plural(holes, "counter-clockwise hole", "counter-clockwise holes");
    note(text + (outers + holes == 1 ? " was" : " were") + " reversed, the first: ring " + std::to_string(first + 1));
  }

  // An edge that runs through a touching point becomes two; the second starts at a new vertex. Rays then name vertices only.
  void cut_edges() {
    struct cut {
      int edge, rank, touching;
    };
    std::vector<cut> cuts;
    for (auto& ray : m_.rays) {
      const int ring = ring_[ray.vertex];
      if (ray.through && reversed_[ring]) ray.vertex = previous_[ray.vertex];
      if (reversed_[ring]) ray.out = !ray.out;
    }
    for (std::size_t t = 0; t < m_.touching_vertices.size(); ++t)
      for (std::size_t i = m_.first_rays[t]; i < m_.first_rays[t + 1]; ++i)
        if (m_.rays[i].through && m_.rays[i].out) cuts.push_back({m_.rays[i].vertex, ranks_[m_.touching_vertices[t]], static_cast<int>(t)});
    std::sort(cuts.begin(), cuts.end(), [&](const cut& a, const cut& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      return ranks_[a.edge] < ranks_[next_[a.edge]] ? a.rank < b.rank : a.rank > b.rank;
    });
    vertices_ = static_cast<int>(next_.size());
    std::vector<int> fresh_of(m_.touching_vertices.size(), -1);
    for (const auto& c : cuts) {
      const int before = cut_.empty() || cut_.back() != c.edge ? c.edge : static_cast<int>(next_.size()) - 1;
      const int fresh = static_cast<int>(next_.size());
      const int touched = m_.touching_vertices[static_cast<std::size_t>(c.touching)];
      cut_.push_back(c.edge);
      next_.push_back(next_[before]);
      previous_.push_back(before);
      previous_[next_[fresh]] = fresh;
      next_[before] = fresh;
      place_.push_back(touched);
      input_.push_back(input_[touched]);
      weight_.push_back(weight_[c.edge]);
      ring_.push_back(ring_[c.edge]);
      ranks_.push_back(c.rank);
      fresh_of[static_cast<std::size_t>(c.touching)] = fresh;
    }
    for (std::size_t t = 0; t < m_.touching_vertices.size(); ++t)
      for (std::size_t i = m_.first_rays[t]; i < m_.first_rays[t + 1]; ++i)
        if (m_.rays[i].through) m_.rays[i].vertex = fresh_of[t];
  }

  int point_of(int v) const { return place_.empty() || v < vertices_ ? v : place_[v - vertices_]; }

  // The interior lies left of every edge, so rays in and out take turns around a touching point. A sector of the interior begins, going
  // counter-clockwise, with a ray out and ends with a ray in; one of the outside begins with a ray in.
  void link_sectors(bool outside) {
    for (std::size_t t = 0; t < m_.touching_vertices.size(); ++t) {
      const std::size_t begin = m_.first_rays[t];
      const std::size_t n = m_.first_rays[t + 1] - begin;
      for (std::size_t i = 0; i < n; ++i) {
        const auto& out = m_.rays[begin + (outside ? (i + 1) % n : i)];
        const auto& in = m_.rays[begin + (outside ? i : (i + 1) % n)];
        if (out.out == in.out) throw invariant_error("internal invariant violated: the interior lies on the left around a touching point");
        if (!out.out) continue;
        next_[arriving_[in.vertex]] = out.vertex;
        previous_[out.vertex] = arriving_[in.vertex];
      }
    }
  }

  // Every connected piece of the interior has one counter-clockwise boundary; a part must be one piece.
  void count_loops() {
    p_.parts = static_cast<int>(outer_.size());
    p_.holes = static_cast<int>(part_.size() - outer_.size());
    if (m_.touching_vertices.empty()) return;
    std::vector<int> loop(next_.size(), -1);
    std::vector<int> pieces(outer_.size());
    int loops = 0;
    int falls_apart = -1;  // the loop of a second piece
    for (int i = 0; i < static_cast<int>(next_.size()); ++i) {
      if (loop[i] >= 0) continue;
      Int area = 0;
      int v = i;
      do {
        loop[v] = loops;
        const auto& a = points_[point_of(v)];
        const auto& b = points_[point_of(next_[v])];
        area += a[0] * b[1] - a[1] * b[0];
        v = next_[v];
      } while (v != i);
      if (area > 0 && ++pieces[part_[ring_[i]]] > 1 && falls_apart < 0) falls_apart = loops;
      ++loops;
    }
    if (falls_apart >= 0)
      for (std::size_t t = 0; t < m_.touching_vertices.size(); ++t) {
        bool here = false;
        bool others = false;
        for (std::size_t i = m_.first_rays[t]; i < m_.first_rays[t + 1]; ++i)
          if (m_.rays[i].out) (loop[m_.rays[i].vertex] == falls_apart ? here : others) = true;
        if (!here || !others) continue;
        fail(input_fault::pinched, input_[m_.touching_vertices[t]],
             ": the boundary touches " + other_name(t) + " here, and the interior falls apart into pieces that share only points",
             "give each piece as a part of its own, or move the point");
      }
    p_.holes = loops - p_.parts;
    note("the boundary touches itself in " + plural(static_cast<long>(m_.touching_vertices.size()), "point", "points") +
         ", the first: " + name(input_[m_.touching_vertices[0]]) + " on " + other_name(0));
  }

  // What a touching point's first vertex touches.
  std::string other_name(std::size_t t) const {
    const int v = m_.touching_vertices[t];
    for (std::size_t i = m_.first_rays[t]; i < m_.first_rays[t + 1]; ++i) {
      const int u = m_.rays[i].vertex;
      if (u == v) continue;
      if (u < vertices_) return short_name(input_[u]);
      const int e = cut_[u - vertices_];
      // The other end in the input: the neighbour in the ring, next_ may be cut by now.
      const int ring = ring_[e];
      const int begin = first_[ring];
      const int end = ring + 1 < static_cast<int>(first_.size()) ? first_[ring + 1] : vertices_;
      const int other = reversed_[ring] ? (e > begin ? e - 1 : end - 1) : (e + 1 < end ? e + 1 : begin);
      return "the edge between " + short_name(input_[std::min(e, other)]) + " and " + short_name(input_[std::max(e, other)]);
    }
    return "itself";
  }

  // A touching from outside cuts nothing, and two edges in line may have become neighbours.
  void join_straight() {
    joined_.assign(next_.size(), false);
    for (const auto& ray : m_.rays) {
      const int v = ray.vertex;
      if (!ray.out || !same_weight(weight_[previous_[v]], weight_[v])) continue;
      if (points_.turn(point_of(previous_[v]), point_of(v), point_of(next_[v])) != sign::zero) continue;
      joined_[v] = true;
      next_[previous_[v]] = next_[v];
      previous_[next_[v]] = previous_[v];
    }
  }

  // Numbers vertices in the order of the input, those of cuts behind the vertex in which the cut edge starts.
  void finish() {
    const int n = static_cast<int>(next_.size());
    std::vector<int> order;
    order.reserve(static_cast<std::size_t>(n));
    if (joined_.empty()) {
      order.resize(static_cast<std::size_t>(n));
      std::iota(order.begin(), order.end(), 0);
    } else {
      std::size_t c = 0;  // cuts are sorted by edge
      for (int v = 0; v < vertices_; ++v) {
        if (!joined_[v]) order.push_back(v);
        for (; c < cut_.size() && cut_[c] == v; ++c)
          if (!joined_[vertices_ + static_cast<int>(c)]) order.push_back(vertices_ + static_cast<int>(c));
      }
    }
    std::vector<int> id(next_.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) id[order[i]] = static_cast<int>(i);
    auto& o = p_.boundary;
    o.next.reserve(order.size());
    o.line.reserve(order.size());
    p_.points.reserve(order.size());
    p_.input_points.reserve(order.size());
    p_.input_edges.reserve(order.size());
    std::size_t size = 16;
    while (size < 2 * order.size()) size *= 2;
    table_.assign(size, -1);
    for (const int v : order) {
      o.next.push_back(id[next_[v]]);
      o.line.push_back(line_of(v));
      p_.points.push_back(points_[point_of(v)]);
      p_.input_points.push_back(input_[v]);
      p_.input_edges.push_back(weight_[v]);
    }
    o.lines = static_cast<int>(p_.lines.size());
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

  // The line of the edge that starts at v; equal lines have one number.
  int line_of(int v) {
    const int a = point_of(v);
    const int b = point_of(next_[v]);
    moving_line<Int> line;
    const auto& p = points_.rough(a);
    const auto& q = points_.rough(b);
    bool small = false;
    if (points_.exact()) {
      auto nx = static_cast<std::int64_t>(q[1] - p[1]);
      auto ny = static_cast<std::int64_t>(p[0] - q[0]);
      const std::int64_t g = std::gcd(nx, ny);
      nx /= g;
      ny /= g;
      line.n = {Int(nx), Int(ny)};
      small = std::abs(static_cast<double>(nx) * p[0]) + std::abs(static_cast<double>(ny) * p[1]) < 0x1p62;
      if (small) line.d = Int(nx * static_cast<std::int64_t>(p[0]) + ny * static_cast<std::int64_t>(p[1]));
    } else {
      line.n = {points_[b][1] - points_[a][1], points_[a][0] - points_[b][0]};
      Int g = gcd(line.n[0], line.n[1]);
      if (g < 0) g = -g;
      if (g != 1)
        for (Int& x : line.n) x /= g;
    }
    if (!small) line.d = line.n[0] * points_[a][0] + line.n[1] * points_[a][1];
    if (!weights_.empty()) line.weight = weights_[weight_[v]];
    std::uint64_t h = 0;
    for (const Int* x : {&line.n[0], &line.n[1], &line.d, &line.weight}) {
      h = (h ^ static_cast<std::uint64_t>(detail::residue(*x))) * 0x9E3779B97F4A7C15U;
      h ^= h >> 29U;
    }
    const std::size_t mask = table_.size() - 1;
    for (std::size_t at = h & mask;; at = (at + 1) & mask) {
      if (table_[at] < 0) {
        table_[at] = static_cast<int>(p_.lines.size());
        p_.lines.push_back(std::move(line));
        return table_[at];
      }
      if (p_.lines[table_[at]] == line) return table_[at];
    }
  }

  rings<Int> in_;
  std::vector<int> first_input_;  // by ring: its first point, counted through all rings
  std::vector<int> part_;         // by ring
  std::vector<int> outer_;        // by part: its outer ring
  std::vector<Int> weights_;      // by point of the input; empty: all 1
  exact_points<Int> points_;      // first those of the input, then those that stay, with numbers of vertices
  // By vertex, at first those of the rings in order, then those that cut edges:
  std::vector<int> input_;   // the point of the input
  std::vector<int> weight_;  // whose weight the edge has that starts here
  std::vector<int> ring_;
  std::vector<int> next_;
  std::vector<int> previous_;
  std::vector<int> ranks_;  // order by place; empty where nothing touches
  std::vector<int> first_;  // by ring: its first vertex
  std::vector<bool> reversed_;
  meetings m_;
  int vertices_ = 0;        // without those of cuts
  std::vector<int> cut_;    // by vertex of a cut: the edge
  std::vector<int> place_;  // by vertex of a cut: a vertex at the same place
  std::vector<bool> joined_;
  std::vector<int> table_;     // of line numbers, by hash
  std::vector<int> arriving_;  // by vertex: the previous one in the rings, before sectors are linked
  const bool outside_;
  polygon<Int> p_;
};

/// Turns rings into a polygon. Repaired, and said in `repairs`: points that repeat their predecessor; points on a straight side between edges
/// of equal weight; rings with the wrong orientation (outer rings run counter-clockwise, holes clockwise; weights stay with their edges);
/// boundaries that touch themselves or each other without crossing while the interior of each part stays connected. There `outline` has one
/// vertex for each sector of the interior at the touching point, and follows the boundary of the interior instead of the rings; `holes` counts
/// the clockwise boundaries that result.
/// Throws input_error for everything else that is no polygon with disjoint parts: spikes, crossings, overlaps, holes outside of their outer
/// ring or inside of others, interiors that fall apart, negative weights. Cost: n log n time, see crossing_search.
/// With `outside` the result is what is not in the polygon: vertices and lines are the same (where nothing touches), but turned round: edge next[i]
/// of the polygon is its edge i. `parts` and `holes` are still those of the polygon. Its skeleton is unbounded.
template <class Int>
polygon<Int> make_polygon(rings<Int> r, bool outside = false) {
  return polygon_builder<Int>(std::move(r), outside).build();
}

}  // namespace osteon::plane
