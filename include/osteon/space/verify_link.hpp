// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate's rules `link`, `nowhere` and `count`: the neighbourhood of every event.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/local_events.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/certificate.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon::certificate {

/// The rules about events. Around the point where four planes meet, arcs and sheets must be those
/// of one monotone function of four bits, and sheets are one polygon only where events say so.
template <kernel<3> K>
class link_check {
 public:
  /// `moments`: of the nodes, from check_order.
  link_check(const K& k, const boundary& solid, const skeleton& s, const std::vector<typename K::meeting>& moments)
      : k_(k), solid_(solid), s_(s), moments_(moments) {}

  /// Checks all events, polygons and counts.
  /// *Requires* rules `structure`, `order` and `incidence`. *Throws* refutation; degenerate_error
  /// where the kernel answers zero.
  /// *Complexity* n log n.
  void run() {
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n)
      if (s_.nodes[n].vertex < 0) check_event(n);
    check_polygons();
    check_counts();
  }

 private:
  // An event's planes and arcs.
  struct star {
    quadruple planes;
    std::array<bool, 4> in;     // the small tetrahedron before the event lies inside this plane
    std::array<int, 4> past;    // the arc that ends here, by the plane that it omits
    std::array<int, 4> future;  // the arc that starts here
    int arc(unsigned omitted, bool inside) const { return inside == in[omitted] ? past[omitted] : future[omitted]; }
  };

  void check_event(int n) {
    const star at = star_of(n);
    const skeleton::node& node = s_.nodes[n];
    unsigned created = 0;
    for (unsigned r = 0; r < 4; ++r) created |= at.in[r] ? 0U : 1U << r;
    bool arcs_fit = false;
    for (const function f : monotone_functions()) {
      if (!has_arcs(at, f)) continue;
      arcs_fit = true;
      const auto joined = has_sheets(at, f);
      if (!joined) continue;
      joined_.insert(joined_.end(), joined->begin(), joined->end());
      demand(!local::makes_facet_from_nowhere<4>(f, created), rule::nowhere, "node", n, "makes a facet out of nothing");
      const function other = f ^ function { 1 } << created;
      const bool ambiguous = is_monotone(other, 4) && !local::makes_facet_from_nowhere<4>(other, created);
      demand(node.ambiguous == ambiguous, rule::count, "node", n, ambiguous ? "is ambiguous" : "is not ambiguous");
      demand(node.event == class_of(at, f), rule::count, "node", n, "belongs to another class of events");
      return;
    }
    refute(rule::link,
           "node " + std::to_string(n) + (arcs_fit ? ": the sheets around it do not lead from arc to arc" : ": no cells around it fit its arcs"));
  }

  star star_of(int n) const {
    star at{s_.nodes[n].planes, {}, {-1, -1, -1, -1}, {-1, -1, -1, -1}};
    for (unsigned r = 0; r < 4; ++r) at.in[r] = lambda_of(k_, at.planes, r) * k_.closing(moments_[n]) == sign::positive;
    for (const int a : s_.nodes[n].arcs) {
      const auto& arc = s_.arcs[a];
      unsigned r = 0;
      while (r < 3 && arc.planes[r] == at.planes[r]) ++r;
      int& known = arc.target == n ? at.past[r] : at.future[r];
      demand(known < 0, rule::link, "node", n, "has two arcs in one direction");
      known = a;
    }
    return at;
  }

  bool has_arcs(const star& at, function f) const {
    for (unsigned r = 0; r < 4; ++r)
      for (const bool inside : {false, true}) {
        const function corner = restricted(f, r, inside);
        const int a = at.arc(r, inside);
        if (depends_on_all(corner, 3) ? a < 0 || s_.arcs[a].corner != corner : a >= 0) return false;
      }
    return true;
  }

  // An arc's sheet opposite its plane t, inside or outside that plane, or -1.
  int sheet_at(const skeleton::arc& arc, unsigned t, bool inside) const {
    std::size_t next = 0;
    for (unsigned r = 0; r < 3; ++r)
      for (const bool in : {false, true}) {
        if (bend_at(arc.corner, r, in) == bend::none) continue;
        if (r == t && in == inside) return arc.sheets[next];
        ++next;
      }
    return -1;
  }

  // Whether two sheets, where both are there, belong to one polygon; keeps them in `joined`.
  bool are_one(int s, int t, std::vector<std::pair<int, int>>& joined) const {
    if (s < 0 || t < 0) return true;
    joined.emplace_back(s, t);
    return s_.sheets[s].representative == s_.sheets[t].representative;
  }

  // The sheets that are found to be one, or nothing where they are said not to be.
  std::optional<std::vector<std::pair<int, int>>> has_sheets(const star& at, function f) const {
    std::vector<std::pair<int, int>> joined;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j)
        if (!has_sheets_between(at, f, i, j, joined)) return std::nullopt;
    return joined;
  }

  // In the plane of two facets i and j four quadrants, by the sides of the two other planes,
  // surround the node, each in a sheet or not. Where there is an arc between two quadrants, it
  // names the sheets; where there is none, one sheet goes on.
  bool has_sheets_between(const star& at, function f, unsigned i, unsigned j, std::vector<std::pair<int, int>>& joined) const {
    const unsigned k = i == 0 ? (j == 1 ? 2 : 1) : 0;
    const unsigned l = 6 - i - j - k;
    struct quadrant {
      bool in_k, in_l;
    };
    constexpr std::array<quadrant, 4> around = {{{true, true}, {false, true}, {false, false}, {true, false}}};
    std::array<int, 4> sheet = {-1, -1, -1, -1};
    std::array<bool, 4> open{};  // no arc between this quadrant and the next
    for (unsigned d = 0; d < 4; ++d) {
      // the ray between lies on plane k and has one side of l, or the other way round
      const bool crosses_k = d % 2 == 0;
      const unsigned on = crosses_k ? k : l;
      const unsigned omitted = crosses_k ? l : k;
      const int a = at.arc(omitted, crosses_k ? around[d].in_l : around[d].in_k);
      open[d] = a < 0;
      if (a < 0) continue;
      const unsigned t = on < omitted ? on : on - 1;
      for (const unsigned e : {d, (d + 1) % 4}) {
        const int named = sheet_at(s_.arcs[a], t, crosses_k ? around[e].in_k : around[e].in_l);
        if (!are_one(sheet[e], named, joined)) return false;
        sheet[e] = named;
      }
    }
    for (unsigned d = 0; d < 8; ++d) {  // twice around
      if (!open[d % 4]) continue;
      int& here = sheet[d % 4];
      int& next = sheet[(d + 1) % 4];
      if (!are_one(here, next, joined)) return false;
      here = next = std::max(here, next);
    }
    for (unsigned d = 0; d < 4; ++d) {
      const unsigned rest = (around[d].in_k ? 1U << k : 0U) | (around[d].in_l ? 1U << l : 0U);
      if (edge_at(f, i, j, rest) == bend::none && sheet[d] >= 0) return false;
    }
    return true;
  }

  // Thesis 3.9: vertices before and after, edges between two of them that vanish and appear, and
  // whether an edge passes through.
  event_class class_of(const star& at, function f) const {
    int vanish = 0;
    int appear = 0;
    bool passing = false;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j) {
        const unsigned k = i == 0 ? (j == 1 ? 2 : 1) : 0;
        const unsigned l = 6 - i - j - k;
        const auto edge = [&](bool before) {
          return edge_at(f, i, j, (at.in[k] == before ? 1U << k : 0U) | (at.in[l] == before ? 1U << l : 0U)) != bend::none;
        };
        vanish += edge(true) && at.past[k] >= 0 && at.past[l] >= 0 ? 1 : 0;
        appear += edge(false) && at.future[k] >= 0 && at.future[l] >= 0 ? 1 : 0;
        passing = passing || (edge(true) && at.past[k] < 0 && at.past[l] < 0);
      }
    struct row {
      int before, after, vanish, appear, passing;  // -1: any
      event_class name;
    };
    using enum event_class;
    constexpr std::array<row, 13> table = {{{4, 0, 6, -1, -1, E6},
                                            {4, 0, 5, -1, -1, E5},
                                            {4, 0, 4, -1, -1, E4},
                                            {3, 1, 3, -1, -1, E3},
                                            {3, 1, 2, -1, -1, E2},
                                            {2, 2, 1, 1, 0, E1},
                                            {2, 2, 1, 0, 1, V_V_E_I},
                                            {2, 2, 0, -1, 1, V_V_E_II},
                                            {2, 2, 0, 1, 0, V_V_I},
                                            {2, 2, 0, 0, 0, V_V_II},
                                            {1, 3, 0, 2, -1, V_E},
                                            {1, 3, 0, 3, -1, V_F},
                                            {0, 4, -1, 4, -1, E_E}}};
    const auto number = [](const std::array<int, 4>& arcs) {
      return static_cast<int>(std::count_if(arcs.begin(), arcs.end(), [](int a) { return a >= 0; }));
    };
    const auto fits = [](int wanted, int found) { return wanted < 0 || wanted == found; };
    for (const row& r : table)
      if (fits(r.before, number(at.past)) && fits(r.after, number(at.future)) && fits(r.vanish, vanish) && fits(r.appear, appear) &&
          fits(r.passing, passing ? 1 : 0))
        return r.name;
    return other;
  }

  // Sheets are one polygon only where events, or edges of the solid that become one, join them.
  void check_polygons() const {
    disjoint_sets connected(s_.sheets.size());
    for (const auto& [s, t] : joined_) connected.unite(s, t);
    std::map<std::pair<int, int>, int> at_vertex;  // by representative and vertex
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s)
      if (const int e = s_.sheets[s].input_edge; e >= 0)
        for (const int v : solid_.edges[e].ends) connected.unite(s, at_vertex.try_emplace({s_.sheets[s].representative, v}, s).first->second);
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s)
      demand(connected.find(s) == connected.find(s_.sheets[s].representative), rule::link, "sheet", s,
             "belongs to a polygon that it has no connection with");
  }

  void check_counts() const {
    std::array<int, event_classes> events{};
    int ambiguous = 0;
    for (const auto& n : s_.nodes) {
      if (n.vertex >= 0) continue;
      ++events[static_cast<std::size_t>(n.event)];
      ambiguous += n.ambiguous ? 1 : 0;
    }
    for (int c = 0; c < event_classes; ++c) demand(events[c] == s_.events[c], rule::count, "class", c, "is counted wrongly");
    demand(ambiguous == s_.ambiguous, rule::count, "events", ambiguous, "are ambiguous");
  }

  const K& k_;
  const boundary& solid_;
  const skeleton& s_;
  const std::vector<typename K::meeting>& moments_;  // of the nodes
  std::vector<std::pair<int, int>> joined_;          // sheets that events show to be one
};

}  // namespace osteon::certificate
