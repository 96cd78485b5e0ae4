// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Straight skeletons by a triangulation of the wavefront's interior that moves with it (Aichholzer, Aurenhammer 1996; thesis 2.2). Everything that
/// happens is the collapse of a triangle: a side of the wavefront vanishes, a vertex hits a side of the wavefront, or a vertex hits a diagonal, which
/// then flips. Times of collapse are roots of quadratics. For polygons in general position, with or without weights.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include "planar_lines.hpp"
#include "planar_node.hpp"

namespace osteon::oracles {

/// Diagonals that cut a polygon with holes into triangles, the shortest first. Corners are doubles, edges pairs of them; O(n^3).
class planar_diagonals {
 public:
  using edge = std::array<int, 2>;

  planar_diagonals(std::vector<std::array<double, 2>> points, std::vector<edge> boundary) : points_(std::move(points)), edges_(std::move(boundary)) {
    const int n = static_cast<int>(points_.size());
    before_.resize(points_.size());
    after_.resize(points_.size());
    for (const auto& [from, to] : edges_) {
      after_[static_cast<std::size_t>(from)] = to;
      before_[static_cast<std::size_t>(to)] = from;
    }
    std::vector<std::pair<double, edge>> all;
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j)
        if (opens(i, j) && opens(j, i)) all.push_back({std::hypot(at(i)[0] - at(j)[0], at(i)[1] - at(j)[1]), {i, j}});
    std::sort(all.begin(), all.end());
    const std::size_t sides = edges_.size();
    for (const auto& [length, e] : all)
      if (is_free(e)) edges_.push_back(e);
    // The triangle to the left of an edge has the neighbour that comes first, counter-clockwise.
    std::vector<std::vector<int>> neighbours(points_.size());
    for (const auto& [a, b] : edges_) {
      neighbours[static_cast<std::size_t>(a)].push_back(b);
      neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (const bool back : {false, true}) {
        if (back && k < sides) continue;
        const int u = edges_[k][back ? 1 : 0];
        const int v = edges_[k][back ? 0 : 1];
        int third = -1;
        for (const int w : neighbours[static_cast<std::size_t>(u)])
          if (turn(u, v, w) > 0 && (third < 0 || turn(u, w, third) > 0)) third = w;
        if (third < 0) throw planar_give_up("no triangulation");
        if (u < v && u < third) triangles_.push_back({u, v, third});
      }
  }

  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

 private:
  const std::array<double, 2>& at(int i) const { return points_[static_cast<std::size_t>(i)]; }

  // In doubles where that is certain.
  int turn(int i, int j, int k) const {
    const auto& [p, q, r] = std::array{at(i), at(j), at(k)};
    const double left = (q[0] - p[0]) * (r[1] - p[1]);
    const double right = (q[1] - p[1]) * (r[0] - p[0]);
    const double d = left - right;
    if (std::abs(d) > 1e-14 * (std::abs(left) + std::abs(right))) return d > 0 ? 1 : -1;
    const real exact = (real(q[0]) - p[0]) * (real(r[1]) - p[1]) - (real(q[1]) - p[1]) * (real(r[0]) - p[0]);
    return exact.sign();
  }

  // Whether the interior at i is towards j.
  bool opens(int i, int j) const {
    const int a = before_[static_cast<std::size_t>(i)];
    const int b = after_[static_cast<std::size_t>(i)];
    if (j == a || j == b) return false;
    if (turn(a, i, b) > 0) return turn(i, b, j) > 0 && turn(a, i, j) > 0;
    return turn(i, b, j) > 0 || turn(a, i, j) > 0;
  }

  bool is_free(const edge& e) const {
    const auto [i, j] = e;
    return std::all_of(edges_.begin(), edges_.end(), [&, i = i, j = j](const edge& f) {
      const auto [k, l] = f;
      // Beyond a common end only an edge on the same line can be in the way, and its other end is on e or e's is on it.
      if (i == k || i == l || j == k || j == l) {
        const int end = i == k || i == l ? i : j;
        const int mine = i + j - end;
        const int other = k + l - end;
        return mine != other && (turn(end, mine, other) != 0 || leads_away(end, mine, other));
      }
      const int tk = turn(i, j, k);
      const int tl = turn(i, j, l);
      const int ti = turn(k, l, i);
      const int tj = turn(k, l, j);
      if (tk == 0 && tl == 0) return are_apart(e, f);
      return tk * tl > 0 || ti * tj > 0;
    });
  }
  // Of segments on one line.
  bool are_apart(const edge& e, const edge& f) const {
    for (const std::size_t axis : {0U, 1U}) {
      const auto [a, b, c, d] = std::array{at(e[0])[axis], at(e[1])[axis], at(f[0])[axis], at(f[1])[axis]};
      if (std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b)) return true;
    }
    return false;
  }
  bool leads_away(int end, int a, int b) const {
    return (at(a)[0] - at(end)[0]) * (at(b)[0] - at(end)[0]) <= 0 && (at(a)[1] - at(end)[1]) * (at(b)[1] - at(end)[1]) <= 0;
  }

  std::vector<std::array<double, 2>> points_;
  std::vector<edge> edges_;
  std::vector<int> before_, after_;
  std::vector<std::array<int, 3>> triangles_;
};

class planar_triangulation {
 public:
  explicit planar_triangulation(const planar_input& input) : in_(input) {
    start();
    const long n = static_cast<long>(in_.edges.size());
    for (long left = 1000 + 50 * n * n; !collapses_.empty();) {
      const collapse c = collapses_.top();
      collapses_.pop();
      const triangle& t = at(c.triangle);
      if (!t.alive || t.stamp != c.stamp) continue;
      if (--left < 0) throw planar_give_up("triangles flip for ever");
      now_ = std::max(now_, c.time);
      pass(c.triangle);
    }
    const bool held = std::any_of(in_.edges.begin(), in_.edges.end(), [](const planar_edge& e) { return e.weight == 0; });
    for (const triangle& t : triangles_)
      if (t.alive && !held) throw planar_give_up("a triangle does not vanish");
  }

  std::vector<planar_node> nodes() const {
    std::vector<planar_node> result;
    for (const meeting& m : meetings_) result.push_back(in_.node(m.place, m.time, m.lines));
    sort_by_time(result);
    return result;
  }

 private:
  struct vertex {
    int in, out;  // lines
    moving_spot path;
  };
  struct triangle {
    std::array<int, 3> corners;             // counter-clockwise
    std::array<int, 3> beyond{-1, -1, -1};  // the neighbour opposite each corner; -1: that side is the wavefront's
    bool alive = true;
    int stamp = 0;
  };
  struct collapse {
    real time;
    int triangle, stamp;
  };
  struct later {
    bool operator()(const collapse& a, const collapse& b) const { return a.time > b.time; }
  };
  struct meeting {
    spot place;
    real time;
    std::vector<int> lines;
  };

  triangle& at(int i) { return triangles_[static_cast<std::size_t>(i)]; }
  const vertex& corner(const triangle& t, std::size_t k) const { return vertices_[static_cast<std::size_t>(t.corners[k % 3])]; }
  const front_line& line(int i) const { return in_.lines[static_cast<std::size_t>(i)]; }

  void start() {
    std::vector<std::array<double, 2>> points;
    std::vector<planar_diagonals::edge> sides;
    std::size_t first = 0;
    std::size_t rings = 0;
    while (first < in_.edges.size()) {
      std::size_t end = first;
      while (static_cast<std::size_t>(in_.next[end]) != first) end = static_cast<std::size_t>(in_.next[end]);
      const int base = static_cast<int>(points.size());
      for (std::size_t e = first, before = end; e <= end; before = e++)
        if (in_.line[before] != in_.line[e]) {
          points.push_back(in_.edges[e].from);
          vertices_.push_back({in_.line[before], in_.line[e], in_.meeting(in_.line[before], in_.line[e])});
        }
      const int n = static_cast<int>(points.size()) - base;
      if (n < 3) throw std::invalid_argument("a ring without area");
      for (int i = 0; i < n; ++i) sides.push_back({base + i, base + (i + 1) % n});
      first = end + 1;
      ++rings;
    }
    const planar_diagonals cut(points, sides);
    for (const auto& corners : cut.triangles()) triangles_.push_back({corners});
    if (triangles_.size() + 4 != points.size() + 2 * rings) throw planar_give_up("no triangulation");
    for (std::size_t a = 0; a < triangles_.size(); ++a)
      for (std::size_t b = 0; b < triangles_.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const auto& p = triangles_[a].corners;
            const auto& q = triangles_[b].corners;
            if (p[(i + 1) % 3] == q[(j + 2) % 3] && p[(i + 2) % 3] == q[(j + 1) % 3]) triangles_[a].beyond[i] = static_cast<int>(b);
          }
    for (std::size_t i = 0; i < triangles_.size(); ++i) expect(static_cast<int>(i));
  }

  // Finds when a triangle collapses next.
  void expect(int i) {
    triangle& t = at(i);
    ++t.stamp;
    if (!t.alive) return;
    if (const auto time = next_collapse(t)) collapses_.push({*time, i, t.stamp});
  }

  std::optional<real> next_collapse(const triangle& t) const {
    // Twice its area is a s^2 + b s + c, s from now on.
    const auto& [p, q, r] = std::array{corner(t, 0).path, corner(t, 1).path, corner(t, 2).path};
    const spot u = q.at(now_) - p.at(now_);
    const spot v = r.at(now_) - p.at(now_);
    const spot du = q.velocity - p.velocity;
    const spot dv = r.velocity - p.velocity;
    const real a = cross(du, dv);
    const real b = cross(u, dv) + cross(du, v);
    const real c = cross(u, v);
    const real speed = abs(du.x) + abs(du.y) + abs(dv.x) + abs(dv.y);
    const real flat = in_.tiny * in_.size;
    if (c < -flat) throw planar_give_up("a triangle is turned over");
    const bool steady = abs(a) <= real("1e-40") * (1 + speed * speed);
    if (c <= flat) {
      for (std::size_t k = 0; k < 3; ++k)
        if (t.beyond[k] < 0 && is_closed(t, k)) return now_;
      const real still = in_.tiny * (1 + speed);
      if (b < -still || (b <= still && a < 0 && !steady)) return now_;
      if (b <= still && steady) throw planar_give_up("a triangle stays flat");
      if (steady || a > 0) return {};
      return now_ - b / a;
    }
    if (steady) return b < 0 ? std::optional<real>(now_ - c / b) : std::nullopt;
    const real square = b * b;
    real under = square - 4 * a * c;
    if (abs(under) <= real("1e-50") * square) under = 0;  // the whole wavefront of a part vanishes: a double root
    if (under < 0) return {};
    const real root = sqrt(under);
    // Of both roots the first positive one, without cancellation.
    const real h = b > 0 ? real(-(b + root) / 2) : real((root - b) / 2);
    std::optional<real> result;
    for (const real& s : {real(h / a), h == 0 ? real(-1) : real(c / h)})
      if (s > 0 && (!result || s < *result)) result = s;
    if (!result) return {};
    return refined(t, now_ + *result);
  }

  // Sides of the wavefront vanish and are hit at times that are linear, so known more exactly.
  real refined(const triangle& t, const real& time) const {
    const real near = in_.tiny_time * real("1e20");
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.beyond[k] >= 0) continue;
      const moving_spot& from = corner(t, k + 1).path;
      const moving_spot& to = corner(t, k + 2).path;
      const front_line& l = line(corner(t, k + 1).out);
      const real growth = dot(to.velocity - from.velocity, l.direction);
      if (growth < 0) {
        const real end = -dot(to.start - from.start, l.direction) / growth;
        if (abs(real(end - time)) <= near) return end;
      }
      const moving_spot& tip = corner(t, k).path;
      const real speed = l.weight - dot(l.normal, tip.velocity);
      if (speed > 0) {
        const real hit = (dot(l.normal, tip.start) - l.offset) / speed;
        if (abs(real(hit - time)) <= near) return hit;
      }
    }
    return time;
  }

  // Whether the side opposite a corner has no length now.
  bool is_closed(const triangle& t, std::size_t k) const {
    const spot d = corner(t, k + 2).path.at(now_) - corner(t, k + 1).path.at(now_);
    return abs(d.x) <= in_.tiny && abs(d.y) <= in_.tiny;
  }

  void meet(const spot& place, std::vector<int> lines) {
    for (meeting& m : meetings_)
      if (abs(m.place.x - place.x) <= in_.tiny && abs(m.place.y - place.y) <= in_.tiny) {
        m.lines.insert(m.lines.end(), lines.begin(), lines.end());
        return;
      }
    meetings_.push_back({place, now_, std::move(lines)});
  }

  void pass(int i) {
    const triangle t = at(i);
    int closed = 0;
    std::size_t side = 3;  // of the wavefront, closed
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_closed(t, k)) continue;
      ++closed;
      if (t.beyond[k] < 0) side = k;
    }
    if (closed > 0) {
      if (side == 3) throw planar_give_up("two vertices meet");
      close_side(i, side, closed == 3);
      return;
    }
    std::size_t longest = 0;
    std::array<real, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      const spot d = corner(t, k + 2).path.at(now_) - corner(t, k + 1).path.at(now_);
      length[k] = dot(d, d);
      if (length[k] > length[longest]) longest = k;
    }
    if (t.beyond[longest] < 0) {
      split(i, longest);
    } else {
      flip(i, longest);
    }
  }

  // An edge of the wavefront vanishes: its ends become one vertex, and what was beyond the other two sides meets.
  void close_side(int i, std::size_t k, bool wholly) {
    const triangle t = at(i);
    const int p = t.corners[(k + 1) % 3];
    const int q = t.corners[(k + 2) % 3];
    const vertex from = corner(t, k + 1);
    const vertex to = corner(t, k + 2);
    const spot place = from.path.at(now_);
    meet(place, {from.in, from.out, to.out});
    at(i).alive = false;
    const int left = t.beyond[(k + 1) % 3];
    const int right = t.beyond[(k + 2) % 3];
    if (left < 0 && right < 0) {
      if (!wholly) throw planar_give_up("two edges lie on each other");
      return;
    }
    const int w = add({from.in, to.out, in_.meeting(from.in, to.out)});
    relink(left, i, right);
    relink(right, i, left);
    for (std::size_t j = 0; j < triangles_.size(); ++j) {
      if (!triangles_[j].alive) continue;
      bool touched = static_cast<int>(j) == left || static_cast<int>(j) == right;
      for (int& c : triangles_[j].corners)
        if (c == p || c == q) c = w, touched = true;
      if (touched) expect(static_cast<int>(j));
    }
  }

  // A vertex cuts an edge of the wavefront in two.
  void split(int i, std::size_t k) {
    const triangle t = at(i);
    const vertex tip = corner(t, k);
    const int cut = corner(t, k + 1).out;
    meet(tip.path.at(now_), {tip.in, tip.out, cut});
    at(i).alive = false;
    const int towards_from = add({cut, tip.out, in_.meeting(cut, tip.out)});
    const int towards_to = add({tip.in, cut, in_.meeting(tip.in, cut)});
    const int beyond_from = t.beyond[(k + 2) % 3];  // across the side from the tip to the edge's beginning
    const int beyond_to = t.beyond[(k + 1) % 3];
    if (beyond_from < 0 || beyond_to < 0) throw planar_give_up("two edges lie on each other");
    relink(beyond_from, i, -1);
    relink(beyond_to, i, -1);
    hand_over(beyond_from, t.corners[k], towards_from, 2);
    hand_over(beyond_to, t.corners[k], towards_to, 1);
  }

  // Replaces a corner in all triangles around it, to one side.
  void hand_over(int i, int old, int fresh, std::size_t turn) {
    while (i >= 0) {
      triangle& t = at(i);
      const auto k = static_cast<std::size_t>(std::find(t.corners.begin(), t.corners.end(), old) - t.corners.begin());
      if (k == 3) throw planar_give_up("the triangulation is torn");
      t.corners[k] = fresh;
      const int next = t.beyond[(k + turn) % 3];
      expect(i);
      i = next;
    }
  }

  // A vertex passes through a diagonal: the other diagonal of the quadrangle replaces it.
  void flip(int i, std::size_t k) {
    triangle& t = at(i);
    const int j = t.beyond[k];
    triangle& u = at(j);
    const auto m = static_cast<std::size_t>(std::find(u.beyond.begin(), u.beyond.end(), i) - u.beyond.begin());
    if (m == 3) throw planar_give_up("the triangulation is torn");
    const int r = t.corners[k];
    const int p = t.corners[(k + 1) % 3];
    const int q = t.corners[(k + 2) % 3];
    const int s = u.corners[m];
    const int qr = t.beyond[(k + 1) % 3];
    const int rp = t.beyond[(k + 2) % 3];
    const int ps = u.beyond[(m + 1) % 3];
    const int sq = u.beyond[(m + 2) % 3];
    t.corners = {p, s, r};
    t.beyond = {j, rp, ps};
    u.corners = {s, q, r};
    u.beyond = {qr, i, sq};
    relink(ps, j, i);
    relink(qr, i, j);
    expect(i);
    expect(j);
  }

  void relink(int i, int old, int fresh) {
    if (i >= 0) std::replace(at(i).beyond.begin(), at(i).beyond.end(), old, fresh);
  }
  int add(const vertex& v) {
    vertices_.push_back(v);
    return static_cast<int>(vertices_.size()) - 1;
  }

  planar_lines in_;
  std::vector<vertex> vertices_;
  std::vector<triangle> triangles_;
  std::priority_queue<collapse, std::vector<collapse>, later> collapses_;
  std::vector<meeting> meetings_;
  real now_ = 0;
};

/// The skeleton's nodes by a moving triangulation, with or without weights. Throws planar_give_up where two vertices meet, where parallel edges do,
/// and where other coincidences leave it without a way on: no answer for most symmetric polygons. O(n^3) to begin with, then O(n) an event.
inline std::vector<planar_node> nodes_by_triangulation(const planar_input& input) { return planar_triangulation(input).nodes(); }

}  // namespace osteon::oracles
