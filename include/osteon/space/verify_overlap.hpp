// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate's rule `overlap`: sheets lie side by side.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/certificate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::certificate {

/// Rule `overlap`: along the line of every triple of planes the sheets of each pair of facets lie
/// where their arcs say, once, and two sheets of one cell never cross. A point of the line is the
/// moving vertex of the three planes, so places on it are told by time.
template <kernel<3> K>
class overlap_check {
 public:
  /// `moments`: of the nodes, from check_order.
  overlap_check(const K& k, const boundary& solid, const skeleton& s, const std::vector<typename K::meeting>& moments)
      : k_(k), solid_(solid), s_(s), moments_(moments) {}

  /// Checks all lines on which sheets of two facets may lie.
  /// *Requires* rules `structure`, `order` and `incidence`. *Throws* refutation; degenerate_error
  /// where the kernel answers zero.
  /// *Complexity* about the sum over cells of the squared number of their sheets.
  void run() {
    // arcs on the borders of the sheets of two facets
    std::map<std::array<plane_id, 2>, std::vector<int>> borders;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a)
      for (unsigned t = 0; t < 3; ++t) borders[omit(s_.arcs[a].planes, t)].push_back(a);
    std::vector<std::vector<plane_id>> neighbours(solid_.planes);
    for (const auto& [pair, arcs] : borders)
      for (const int side : {0, 1}) neighbours[pair[side]].push_back(pair[1 - side]);
    // by line; one list for each pair with sheets there
    std::map<triple, std::vector<std::vector<period>>> inside;
    for (plane_id k = 0; k < solid_.planes; ++k) {
      height_of_node_.assign(s_.nodes.size(), unknown);
      for (const plane_id i : neighbours[k])
        for (const plane_id j : neighbours[i]) {
          // seen from j
          if (j == k || (i > j && std::binary_search(neighbours[k].begin(), neighbours[k].end(), j))) continue;
          const std::array<plane_id, 2> pair = {std::min(i, j), std::max(i, j)};
          auto within = periods_inside(borders[pair], pair, k);
          if (!within.empty()) inside[sorted(triple{i, j, k})].push_back(std::move(within));
        }
    }
    for (const auto& [line, lists] : inside)
      for (std::size_t x = 0; x < lists.size(); ++x)
        for (std::size_t y = 0; y < x; ++y)
          if (overlap(lists[x], lists[y]))
            refute(rule::overlap, "two sheets of one cell cross on the line of planes " + std::to_string(line[0]) + ", " + std::to_string(line[1]) +
                                      " and " + std::to_string(line[2]));
  }

 private:
  using meeting = typename K::meeting;

  // A time during which the moving vertex of a line lies inside a sheet; from the start where there
  // is no beginning.
  struct period {
    std::optional<meeting> begin;
    meeting end;
  };
  // Where plane l crosses a line: the moment, and by how much the number of sheets changes there,
  // just outside and just inside plane k.
  struct change {
    std::optional<meeting> moment;
    std::array<int, 2> sheets;
  };

  bool overlap(const std::vector<period>& x, const std::vector<period>& y) const {
    const auto before = [&](const period& s, const period& t) { return t.begin && k_.compare(s.end, *t.begin) != sign::positive; };
    for (std::size_t i = 0, j = 0; i < x.size() && j < y.size();) {
      if (before(x[i], y[j])) {
        ++i;
      } else if (before(y[j], x[i])) {
        ++j;
      } else {
        return true;
      }
    }
    return false;
  }

  // When the moving vertex of a pair's planes and a third plane k lies inside the pair's sheets,
  // whose borders have these arcs.
  std::vector<period> periods_inside(const std::vector<int>& arcs, const std::array<plane_id, 2>& pair, plane_id k) {
    const triple line = sorted(triple{pair[0], pair[1], k});
    std::vector<int> on_line;
    const std::vector<change> changes = changes_along(line, arcs, pair, k, on_line);
    std::vector<period> within;
    std::array<int, 2> sheets = {0, 0};  // just outside plane k, just inside
    for (std::size_t g = changes.size(); g-- > 0;) {
      for (const int side : {0, 1}) sheets[side] -= changes[g].sheets[side];
      const period here = {g == 0 ? std::nullopt : changes[g - 1].moment, *changes[g].moment};
      const bool arc_here = has_arc(on_line, here, pair, sheets);
      if (sheets[0] < 0 || sheets[0] > 1 || sheets[1] < 0 || sheets[1] > 1 || (!arc_here && sheets[0] != sheets[1]))
        refute(rule::overlap,
               "sheets of facets " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]) + " overlap beside plane " + std::to_string(k));
      if (!arc_here && sheets[0] == 1) within.insert(within.begin(), here);
    }
    return within;
  }

  // The changes in order of time: where an arc on the sheets' border crosses the line or begins on
  // it. Collects the arcs on the line.
  std::vector<change> changes_along(const triple& line, const std::vector<int>& arcs, const std::array<plane_id, 2>& pair, plane_id k,
                                    std::vector<int>& on_line) {
    std::map<plane_id, change> changes;  // by the plane that crosses the line there
    for (const int a : arcs) {
      const auto& arc = s_.arcs[a];
      if (arc.planes == line) {
        on_line.push_back(a);
        for (const int n : {arc.source, arc.target})
          if (s_.nodes[n].vertex < 0) changes.try_emplace(fourth(s_.nodes[n].planes, line));
        continue;
      }
      const sign from = height(arc, true, k);
      const sign to = height(arc, false, k);
      if (from == to) continue;
      const unsigned t = third(arc.planes, pair);
      const plane_id l = arc.planes[t];
      const std::array<bool, 2> covers = {bend_at(arc.corner, t, false) != bend::none, bend_at(arc.corner, t, true) != bend::none};
      change& here = changes[l];
      if (covers[0] == covers[1]) continue;
      const bool enters = covers[inside_before(line, l) ? 0 : 1];
      if ((from == sign::positive) != (to == sign::positive)) here.sheets[1] += enters ? 1 : -1;
      if ((from == sign::negative) != (to == sign::negative)) here.sheets[0] += enters ? 1 : -1;
    }
    std::vector<change> result;
    for (auto& [l, c] : changes) {
      c.moment = meeting_of(k_, {line[0], line[1], line[2], l});
      result.push_back(c);
    }
    std::sort(result.begin(), result.end(), [&](const change& x, const change& y) { return k_.compare(*x.moment, *y.moment) == sign::negative; });
    return result;
  }

  // Whether an arc runs along the line during a period. It must be alone, and the sheets beside it
  // must be its own.
  bool has_arc(const std::vector<int>& on_line, const period& during, const std::array<plane_id, 2>& pair, const std::array<int, 2>& sheets) const {
    bool found = false;
    for (const int a : on_line) {
      const auto& arc = s_.arcs[a];
      if (k_.compare(moments_[arc.source], during.end) != sign::negative) continue;
      if (during.begin && k_.compare(moments_[arc.target], *during.begin) != sign::positive) continue;
      demand(!found, rule::overlap, "arc", a, "runs along another arc");
      found = true;
      const unsigned t = third(arc.planes, pair);
      for (const int side : {0, 1})
        demand(sheets[side] == (bend_at(arc.corner, t, side == 1) != bend::none ? 1 : 0), rule::overlap, "arc", a,
               "has sheets beside it that are not its own");
    }
    return found;
  }

  // Sign of the distance of an arc's end from plane k; at a node on plane k zero.
  sign height(const skeleton::arc& arc, bool source, plane_id k) {
    const int n = source ? arc.source : arc.target;
    if (s_.nodes[n].vertex >= 0) return height(arc.planes, k, moments_[n]);
    signed char& known = height_of_node_[n];
    if (known == unknown) {
      const auto& q = s_.nodes[n].planes;
      known = static_cast<signed char>(position(q, k) < q.size() ? sign::zero : height(arc.planes, k, moments_[n]));
    }
    return static_cast<sign>(known);
  }

  // h_k at the moving vertex of three planes is (D - t S) / lambda_k, and D - t S has the sign of S
  // (D / S - t).
  sign height(const triple& planes, plane_id k, const meeting& t) const {
    const meeting m = meeting_of(k_, {planes[0], planes[1], planes[2], k});
    return k_.closing(m) * k_.compare(m, t) * lambda_in(m, k);
  }

  // Whether the vertex of a line's three planes lies inside plane l before it meets it.
  bool inside_before(const triple& line, plane_id l) const {
    const meeting m = meeting_of(k_, {line[0], line[1], line[2], l});
    return k_.closing(m) * lambda_in(m, l) == sign::positive;
  }

  // Sign of lambda_p of a meeting.
  sign lambda_in(const meeting& m, plane_id p) const {
    const quadruple q = k_.planes(m);
    return lambda_of(k_, q, position(q, p));
  }

  static unsigned third(const triple& planes, const std::array<plane_id, 2>& pair) {
    unsigned t = 0;
    while (planes[t] == pair[0] || planes[t] == pair[1]) ++t;
    return t;
  }
  static plane_id fourth(const quadruple& q, const triple& line) {
    return *std::find_if(q.begin(), q.end(), [&line](plane_id p) { return position(line, p) == line.size(); });
  }

  static constexpr signed char unknown = 2;

  const K& k_;
  const boundary& solid_;
  const skeleton& s_;
  const std::vector<meeting>& moments_;      // of the nodes
  std::vector<signed char> height_of_node_;  // over the plane at hand
};

}  // namespace osteon::certificate
