// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Whether the loop of a facet is the oriented boundary of one region of its plane.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "osteon/input/geometry.hpp"
#include "osteon/input/projected_facet.hpp"
#include "osteon/input/rough_points.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

namespace detail {

/// Returns two edges of a facet that meet where they must not, or nothing. Sweeps the loop along
/// the longer of its axes.
template <class Int>
std::optional<bad_contact> find_edges_that_meet(const surface<Int>& s, int f) {
  const projected_facet<Int> facet(s, f);
  const auto& loop = facet.loop();
  const auto& axes = facet.axes();
  const box3 all(s.rough, loop);
  const int along = all.hi[axes[0]] - all.lo[axes[0]] >= all.hi[axes[1]] - all.lo[axes[1]] ? axes[0] : axes[1];
  struct stretch {
    double lo, hi;
    int a, b;
  };
  std::vector<stretch> sides;
  sides.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i];
    const int b = loop[(i + 1) % loop.size()];
    const auto [lo, hi] = std::minmax({s.rough[a][along], s.rough[b][along]});
    sides.push_back({lo, hi, a, b});
  }
  std::sort(sides.begin(), sides.end(), [](const stretch& x, const stretch& y) { return std::tie(x.lo, x.a, x.b) < std::tie(y.lo, y.a, y.b); });
  for (auto x = sides.begin(); x != sides.end(); ++x)
    for (auto y = x + 1; y != sides.end() && y->lo <= x->hi; ++y)
      if (facet.edges_meet(x->a, x->b, y->a, y->b)) return bad_contact{bad_contact::kind::edge, f, x->a, x->b};
  return std::nullopt;
}

/// The edges between a point that a loop passes and another point of the loop, by the number of the
/// pass: the one by which the loop leaves, and the one by which it arrives; -1 where there is none.
struct passes_along {
  int leaving = -1;
  int arriving = -1;
};

/// Returns whether the inside of a loop has disjoint sectors around point v, which the loop passes
/// several times. Then, counter-clockwise, the edge by which a pass leaves is followed by the one
/// by which it arrived.
template <class Int>
bool has_disjoint_sectors(const surface<Int>& s, const std::array<int, 2>& axes, int v, const std::map<int, passes_along>& ends) {
  const auto direction = [&](int w) {
    return std::array<Int, 2>{s.points[w][axes[0]] - s.points[v][axes[0]], s.points[w][axes[1]] - s.points[v][axes[1]]};
  };
  std::vector<std::pair<int, passes_along>> order(ends.begin(), ends.end());
  std::sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
    const auto u = direction(x.first);
    const auto w = direction(y.first);
    const bool lower_u = u[1] < 0 || (u[1] == 0 && u[0] < 0);
    const bool lower_w = w[1] < 0 || (w[1] == 0 && w[0] < 0);
    return lower_u != lower_w ? lower_w : u[0] * w[1] > u[1] * w[0];
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int leaving = order[k].second.leaving;
    if (leaving >= 0 && order[(k + 1) % order.size()].second.arriving != leaving) return false;
  }
  return true;
}

/// Returns a point that the loop of a facet passes more than once and around which its inside's
/// sectors are not disjoint, or nothing.
template <class Int>
std::optional<bad_contact> find_bad_corner(const surface<Int>& s, int f) {
  const projected_facet<Int> facet(s, f);
  const auto& loop = facet.loop();
  const int n = static_cast<int>(loop.size());
  std::vector<int> visits(loop.size());
  std::iota(visits.begin(), visits.end(), 0);
  std::sort(visits.begin(), visits.end(), [&](int i, int j) { return loop[i] < loop[j]; });
  std::optional<bad_contact> found;
  for (int i = 0, j = 0; i < n; i = j) {
    const int v = loop[visits[i]];
    for (j = i + 1; j < n && loop[visits[j]] == v;) ++j;
    if (j == i + 1) continue;
    std::map<int, passes_along> ends;
    for (int k = i; k < j; ++k) {
      ends[loop[(visits[k] + 1) % n]].leaving = k;
      ends[loop[(visits[k] + n - 1) % n]].arriving = k;
    }
    if (!has_disjoint_sectors(s, facet.axes(), v, ends)) found = bad_contact{bad_contact::kind::corner, f, v};
  }
  return found;
}

}  // namespace detail

/// Returns where a facet's loop is not the oriented boundary of one region, or nothing. Edges of
/// the loop may meet in ends and run along each other as a whole (slits to holes lie inside); at a
/// point that the loop passes more than once, the inside's sectors must be disjoint. Both together
/// suffice.
/// *Requires* a surface with planes.
/// *Complexity* about n log n, and the number of pairs of edges that overlap along the longer axis.
template <class Int>
std::optional<bad_contact> find_fault_of_loop(const surface<Int>& s, int f) {
  if (s.loop(static_cast<std::size_t>(f)).size() == 3) return std::nullopt;
  const auto found = detail::find_edges_that_meet(s, f);
  return found ? found : detail::find_bad_corner(s, f);
}

}  // namespace osteon
