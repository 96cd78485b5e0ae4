// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Small tools for flat polygons in doubles, taken exactly: side of a line, point in ring,
/// triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// A point of the plane in doubles.
using flat_point = std::array<double, 2>;

/// Returns positive where a, b, c turn left; exact but for overflow. Doubles decide unless they
/// cancel (Shewchuk 1997, 4.3).
inline sign turn_of(const flat_point& a, const flat_point& b, const flat_point& c) {
  const auto [left, right] = area_products(c, a, b);
  const double det = left - right;
  if (std::abs(det) > 4e-16 * (std::abs(left) + std::abs(right)) && std::abs(det) > 1e-290) return sign_of(det);
  for (const auto& p : {a, b, c})
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) return sign::zero;
  const auto exact = [](const flat_point& p) { return std::array{rational(p[0]), rational(p[1])}; };
  return turn(exact(a), exact(b), exact(c));
}

/// Returns whether a point is inside of a ring; arbitrary on it. Linear.
inline bool is_inside(const std::vector<flat_point>& ring, const flat_point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if ((ring[i][1] > p[1]) != (ring[j][1] > p[1]) && turn_of(ring[j], ring[i], p) == (ring[i][1] > ring[j][1] ? sign::positive : sign::negative))
      inside = !inside;
  return inside;
}

/// Cuts polygons with holes into triangles by ears (Meisters 1975), holes joined by bridges first
/// (Eberly 2008). Corners that may be in the way are looked for in a grid: in practice a little
/// more than linear; and number of holes times number of corners.
class ear_clipping {
 public:
  /// `points` by number; rings are lists of numbers.
  explicit ear_clipping(const std::vector<flat_point>& points) : points_(points) {}

  /// Returns the triangles of an outer ring, counter-clockwise, and clockwise holes. Rings that
  /// cross (after rounding, say) give triangles that overlap, but always ones whose sides are those
  /// of the rings and pairs of opposite ones.
  std::vector<std::array<int, 3>> run(std::vector<int> outer, std::vector<std::vector<int>> holes) {
    const auto rightmost = [this](std::vector<int>& r) {
      return std::max_element(r.begin(), r.end(), [this](int a, int b) { return points_[a] < points_[b]; });
    };
    for (auto& h : holes) std::rotate(h.begin(), rightmost(h), h.end());
    std::sort(holes.begin(), holes.end(), [this](const auto& a, const auto& b) { return points_[a[0]] > points_[b[0]]; });
    for (const auto& h : holes) join(outer, h);
    clip(outer);
    return std::move(triangles_);
  }

 private:
  const flat_point& at(int i) const { return points_[i]; }

  // Walks along the hole from a corner of the ring that its rightmost point sees.
  void join(std::vector<int>& ring, const std::vector<int>& hole) {
    const flat_point& p = at(hole[0]);
    const std::size_t n = ring.size();
    std::size_t best = n;  // the side that a ray to the right meets first
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const flat_point& a = at(ring[i]);
      const flat_point& b = at(ring[(i + 1) % n]);
      if (!(a[1] <= p[1] && b[1] >= p[1] && a[1] < b[1])) continue;
      const double x = a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      if (turn_of(a, b, p) == sign::negative || x >= nearest) continue;
      nearest = x;
      best = i;
    }
    std::size_t see = best == n ? 0 : at(ring[best])[0] > at(ring[(best + 1) % n])[0] ? best : (best + 1) % n;
    if (best != n) {  // reflex corners in the triangle hide it: the smallest angle to the ray
      const flat_point hit = {nearest, p[1]};
      const flat_point far = at(ring[see]);
      const bool above = far[1] > p[1];
      const auto slope = [&](const flat_point& q) { return std::abs(q[1] - p[1]) / (q[0] - p[0]); };
      for (std::size_t i = 0; i < n; ++i) {
        const flat_point& q = at(ring[i]);
        if (q == far ? !opens(ring, i, p) : !(q[0] > p[0] && in_triangle(above ? std::array{p, hit, far} : std::array{p, far, hit}, q))) continue;
        const flat_point& s = at(ring[see]);
        const bool better = q == s ? opens(ring, i, p) && !opens(ring, see, p) : slope(q) < slope(s) || (slope(q) == slope(s) && q[0] < s[0]);
        if (better && opens(ring, i, p)) see = i;
      }
    }
    std::vector<int> bridge;
    bridge.reserve(hole.size() + 2);
    bridge.insert(bridge.end(), hole.begin(), hole.end());
    bridge.push_back(hole[0]);
    bridge.push_back(ring[see]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(see) + 1, bridge.begin(), bridge.end());
  }

  // Whether the interior at a corner is towards a point.
  bool opens(const std::vector<int>& ring, std::size_t i, const flat_point& to) const {
    const std::size_t n = ring.size();
    const flat_point& before = at(ring[(i + n - 1) % n]);
    const flat_point& corner = at(ring[i]);
    const flat_point& after = at(ring[(i + 1) % n]);
    const bool left_of_in = turn_of(before, corner, to) == sign::positive;
    const bool left_of_out = turn_of(corner, after, to) == sign::positive;
    return turn_of(before, corner, after) == sign::negative ? left_of_in || left_of_out : left_of_in && left_of_out;
  }

  static bool in_triangle(const std::array<flat_point, 3>& t, const flat_point& p) {
    return turn_of(t[0], t[1], p) != sign::negative && turn_of(t[1], t[2], p) != sign::negative && turn_of(t[2], t[0], p) != sign::negative;
  }

  // Cuts off corners whose triangle contains no reflex one, first come, first served; if rounding
  // leaves none, any.
  void clip(const std::vector<int>& ring) {
    const int n = static_cast<int>(ring.size());
    next_.resize(ring.size());
    before_.resize(ring.size());
    for (int i = 0; i < n; ++i) next_[i] = (i + 1) % n, before_[i] = (i + n - 1) % n;
    gone_.assign(ring.size(), false);
    const auto turn = [&](int i) { return turn_of(at(ring[before_[i]]), at(ring[i]), at(ring[next_[i]])); };
    std::vector<int> reflex;
    std::vector<int> waiting;
    for (int i = 0; i < n; ++i) (turn(i) == sign::positive ? waiting : reflex).push_back(i);
    const grid near(points_, ring, reflex);
    bool stuck = false;  // nothing has been cut since all were looked at
    int start = 0;
    std::size_t head = 0;
    for (int left = n; left >= 3;) {
      int i = start;
      if (head < waiting.size()) {
        i = waiting[head++];
        if (gone_[i] || (left > 3 && (turn(i) != sign::positive || !is_ear(ring, near, i)))) continue;
      } else if (!stuck) {
        stuck = true;
        head = 0;
        waiting.clear();
        int j = start;
        for (int k = 0; k < left; ++k, j = next_[j]) waiting.push_back(j);
        continue;
      }
      triangles_.push_back({ring[before_[i]], ring[i], ring[next_[i]]});
      next_[before_[i]] = next_[i];
      before_[next_[i]] = before_[i];
      gone_[i] = true;
      start = next_[i];
      stuck = false;
      if (--left == 2) break;
      waiting.push_back(before_[i]);
      waiting.push_back(next_[i]);
    }
  }

  bool is_ear(const std::vector<int>& ring, const auto& near, int i) const {
    const std::array<flat_point, 3> t = {at(ring[before_[i]]), at(ring[i]), at(ring[next_[i]])};
    return near.none_of(t, [&](int r) {
      if (gone_[r] || r == i || r == before_[i] || r == next_[i]) return false;
      const flat_point& p = at(ring[r]);
      bool corner = false;
      for (std::size_t k = 0; k < 3; ++k) {
        if (p != t[k]) continue;
        corner = true;  // a bridge's other end, say: in the way if its sides lead into the triangle
        for (const int side : {before_[r], next_[r]})
          if (turn_of(t[k], t[(k + 1) % 3], at(ring[side])) == sign::positive && turn_of(t[(k + 2) % 3], t[k], at(ring[side])) == sign::positive)
            return true;
      }
      return !corner && in_triangle(t, p);
    });
  }

  // Some corners of a ring in square cells.
  class grid {
   public:
    grid(const std::vector<flat_point>& points, const std::vector<int>& ring, const std::vector<int>& some)
        : side_(1 + static_cast<int>(std::sqrt(static_cast<double>(some.size()) / 2))) {
      low_ = points[ring[0]];
      flat_point high = low_;
      for (const int v : ring)
        for (std::size_t axis = 0; axis < 2; ++axis) {
          low_[axis] = std::min(low_[axis], points[v][axis]);
          high[axis] = std::max(high[axis], points[v][axis]);
        }
      for (std::size_t axis = 0; axis < 2; ++axis) scale_[axis] = high[axis] > low_[axis] ? side_ / (high[axis] - low_[axis]) : 0;
      first_.assign(static_cast<std::size_t>(side_) * side_ + 1, 0);
      const auto cell = [&](int i) { return cell_of(points[ring[i]][0], 0) * side_ + cell_of(points[ring[i]][1], 1); };
      for (const int i : some) ++first_[cell(i) + 1];
      std::partial_sum(first_.begin(), first_.end(), first_.begin());
      std::vector<int> fill(first_.begin(), first_.end() - 1);
      all_.resize(some.size());
      for (const int i : some) all_[fill[cell(i)]++] = i;
    }

    /// Whether the predicate holds for none of the corners in the box of a triangle.
    template <class Predicate>
    bool none_of(const std::array<flat_point, 3>& t, Predicate predicate) const {
      const auto range = [&](std::size_t axis) {
        return std::array{cell_of(std::min({t[0][axis], t[1][axis], t[2][axis]}), axis),
                          cell_of(std::max({t[0][axis], t[1][axis], t[2][axis]}), axis)};
      };
      const auto x = range(0);
      const auto y = range(1);
      for (int i = x[0]; i <= x[1]; ++i)
        if (std::any_of(all_.begin() + first_[i * side_ + y[0]], all_.begin() + first_[i * side_ + y[1] + 1], predicate)) return false;
      return true;
    }

   private:
    int cell_of(double x, std::size_t axis) const {
      const double c = (x - low_[axis]) * scale_[axis];
      return c > 0 ? static_cast<int>(std::min(c, side_ - 1.0)) : 0;
    }

    int side_;
    flat_point low_;
    flat_point scale_;
    std::vector<int> first_;
    std::vector<int> all_;
  };

  const std::vector<flat_point>& points_;
  std::vector<int> next_;
  std::vector<int> before_;
  std::vector<bool> gone_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace osteon
