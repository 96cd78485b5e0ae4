// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate of a skeleton (design 05). It does not repeat the computation and shares no code with it; it asks the kernel
/// whether the complex that is there is a skeleton of the solid.
///
/// Why the rules suffice. Let u_i(x) be the time at which plane i passes the point x. Around a node the u of its four
/// planes, up to a common summand, are coordinates of space, and the cells are determined by the order of the u.
///  1. `link`: at every node the arcs and sheets are those of one monotone function F of four bits ("not yet passed"): x belongs to
///     the cell at whose plane's passing F falls from 1 to 0. So cells fill the sphere of directions once.
///  2. `border`: every sheet's border is closed over arcs and the solid's edges, and the edges are those of the solid; so
///     every cell's surface is closed, its floor being the facet.
///  3. `overlap`: along the line of every triple of planes, the sheets of each pair lie where their arcs say, once, and two sheets of
///     one cell never cross. So every cell's surface is embedded.
///  4. `floor`: every part of a cell's surface touches the facet. So its inside is the inside everywhere.
/// The cells' indicators then add up to that of the solid (sheets cancel), each is 0 or 1, and the cells are a partition; their
/// volumes add up to the solid's. Cells are monotone (thesis 3.1.1) by 1 and 3, for unit speeds: where a perpendicular of the facet
/// leaves the cell it meets a convex sheet, where it enters a reflex one.
///  5. `nowhere`: no event makes a facet out of nothing, which makes the partition a skeleton.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/skeleton.hpp"

namespace osteon {

/// What a skeleton can break, in the order in which it is checked.
enum class rule : std::uint8_t { structure, order, incidence, border, link, nowhere, count, overlap, floor, contraction };
inline constexpr std::array<std::string_view, 10> rule_names = {"structure", "order", "incidence", "border", "link",
                                                                "nowhere",   "count", "overlap",   "floor",  "contraction"};

/// The first broken rule and where.
struct refutation {
  rule broken;
  std::string witness;
};

namespace certificate {

/// A Boolean function of n <= 4 bits, one bit a cell.
using function = std::uint32_t;

constexpr bool at(function f, unsigned cell) { return (f >> cell & 1U) != 0; }

constexpr bool is_monotone(function f, unsigned bits) {
  for (unsigned c = 0; c < 1U << bits; ++c)
    for (unsigned b = 0; b < bits; ++b)
      if (at(f, c) && !at(f, c | 1U << b)) return false;
  return true;
}

constexpr bool depends(function f, unsigned bits, unsigned b) {
  for (unsigned c = 0; c < 1U << bits; ++c)
    if (at(f, c) != at(f, c ^ 1U << b)) return true;
  return false;
}

constexpr bool depends_on_all(function f, unsigned bits) {
  for (unsigned b = 0; b < bits; ++b)
    if (!depends(f, bits, b)) return false;
  return true;
}

/// F with bit b fixed.
constexpr function restricted(function f, unsigned b, bool value) {
  function result = 0;
  for (unsigned c = 0; c < 8; ++c) {
    const unsigned low = c & ((1U << b) - 1U);
    if (at(f, low | (c - low) << 1U | (value ? 1U << b : 0U))) result |= 1U << c;
  }
  return result;
}

enum class bend : std::uint8_t { none, convex, reflex };

/// The edge between planes i and j where all other bits are as in `rest`.
constexpr bend edge_at(function f, unsigned i, unsigned j, unsigned rest) {
  const bool one = at(f, rest | 1U << i);
  if (one != at(f, rest | 1U << j) || at(f, rest) == at(f, rest | 1U << i | 1U << j)) return bend::none;
  return one ? bend::reflex : bend::convex;
}

/// The monotone functions of four bits that depend on all of them.
inline const std::vector<function>& monotone_functions() {
  static const std::vector<function> all = [] {
    std::vector<function> result;
    for (function f = 0; f < 1U << 16U; ++f)
      if (is_monotone(f, 4) && depends_on_all(f, 4)) result.push_back(f);
    return result;
  }();
  return all;
}

/// Whether the cell `created` makes a facet of its own on some plane: no neighbour across another plane continues it.
constexpr bool makes_facet_from_nowhere(function f, unsigned created) {
  for (unsigned q = 0; q < 4; ++q) {
    if (at(f, created) == at(f, created ^ 1U << q)) continue;
    bool continued = false;
    for (unsigned r = 0; r < 4; ++r)
      if (r != q && at(f, created ^ 1U << r) != at(f, created ^ 1U << r ^ 1U << q)) continued = true;
    if (!continued) return true;
  }
  return false;
}

}  // namespace certificate

/// Checks a raw skeleton under a kernel that never answers zero for different planes (perturbed<K>): exactly, for unit and other
/// weights, in time about the sum over cells of the squared number of their sheets.
template <kernel<3> K>
class verifier {
 public:
  verifier(const K& k, const boundary& solid, const skeleton& s) : k_(k), solid_(solid), s_(s) {}

  /// The first refutation, or nothing: certified. No skeleton, however wrong, makes it fail otherwise; a kernel that answers
  /// zero throws degenerate_error.
  std::optional<refutation> run() {
    try {
      check_structure();
      check_order();
      check_incidence();
      check_borders();
      for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n)
        if (s_.nodes[n].vertex < 0) check_event(n);
      check_polygons();
      check_counts();
      check_overlaps();
      check_floors();
    } catch (const refutation& r) {
      return r;
    }
    return std::nullopt;
  }

 private:
  using meeting = typename K::meeting;
  using bend = certificate::bend;
  using function = certificate::function;

  [[noreturn]] static void refute(rule r, const std::string& witness) { throw refutation{r, witness}; }
  static void demand(bool holds, rule r, const char* what, int number, const char* why) {
    if (!holds) refute(r, std::string(what) + " " + std::to_string(number) + ": " + why);
  }

  // ---- structure: everything that is named exists

  void check_structure() const {
    const auto valid = [](const auto& list, int id) { return id >= 0 && id < static_cast<int>(list.size()); };
    const auto plane = [&](plane_id p) { return p >= 0 && p < solid_.planes; };
    std::vector<bool> seen(solid_.vertices.size());
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n) {
      const auto& node = s_.nodes[n];
      for (const int a : node.arcs) demand(valid(s_.arcs, a), rule::structure, "node", n, "names an arc that is not there");
      if (node.vertex < 0) {
        for (int r = 0; r < 4; ++r)
          demand(plane(node.planes[r]) && (r == 0 || node.planes[r - 1] < node.planes[r]), rule::structure, "node", n,
                 "needs four planes, ascending");
        demand(static_cast<int>(node.event) < event_classes, rule::structure, "node", n, "has no class of event");
        continue;
      }
      demand(valid(solid_.vertices, node.vertex) && !seen[node.vertex], rule::structure, "node", n,
             "is no vertex of the solid, or one for the second time");
      seen[node.vertex] = true;
      for (int r = 0; r < 3; ++r)
        demand(plane(node.planes[r]) && (r == 0 || node.planes[r - 1] <= node.planes[r]), rule::structure, "node", n,
               "needs three planes, ascending");
      demand(node.planes[3] == -1, rule::structure, "node", n, "has a fourth plane at a vertex");
    }
    demand(std::find(seen.begin(), seen.end(), false) == seen.end(), rule::structure, "vertex",
           static_cast<int>(std::find(seen.begin(), seen.end(), false) - seen.begin()), "has no node");
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      demand(valid(s_.nodes, arc.source) && valid(s_.nodes, arc.target), rule::structure, "arc", a, "names a node that is not there");
      for (int r = 0; r < 3; ++r)
        demand(plane(arc.planes[r]) && (r == 0 || arc.planes[r - 1] < arc.planes[r]), rule::structure, "arc", a, "needs three planes, ascending");
      for (const int s : arc.sheets) demand(valid(s_.sheets, s), rule::structure, "arc", a, "names a sheet that is not there");
    }
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s) {
      const auto& sheet = s_.sheets[s];
      demand(plane(sheet.facets[0]) && plane(sheet.facets[1]) && sheet.facets[0] < sheet.facets[1], rule::structure, "sheet", s,
             "needs two facets, ascending");
      demand(valid(s_.sheets, sheet.representative) && s_.sheets[sheet.representative].representative == sheet.representative, rule::structure,
             "sheet", s, "has no polygon");
      demand(sheet.input_edge == -1 || valid(solid_.edges, sheet.input_edge), rule::structure, "sheet", s, "names an edge that is not there");
      for (const int a : sheet.arcs) demand(valid(s_.arcs, a), rule::structure, "sheet", s, "names an arc that is not there");
    }
    demand(static_cast<plane_id>(s_.cells.size()) == solid_.planes, rule::structure, "cell", solid_.planes, "there must be one for each facet");
    for (int c = 0; c < static_cast<int>(s_.cells.size()); ++c)
      for (const int s : s_.cells[c]) demand(valid(s_.sheets, s), rule::structure, "cell", c, "names a sheet that is not there");
  }

  // ---- order: every node has a moment, nodes come in order of time, arcs run forwards

  void check_order() {
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n) {
      if (s_.nodes[n].vertex >= 0) {
        when_.push_back(k_.start());
      } else {
        const auto m = k_.meet(s_.nodes[n].planes);
        demand(m.has_value(), rule::order, "node", n, "its planes do not meet");
        demand(k_.compare(*m, k_.start()) == sign::positive, rule::order, "node", n, "its planes meet before the start");
        when_.push_back(*m);
      }
      if (n > 0) demand(k_.compare(when_[n - 1], when_[n]) != sign::positive, rule::order, "node", n, "is earlier than the node before it");
    }
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a)
      demand(k_.compare(when_[s_.arcs[a].source], when_[s_.arcs[a].target]) == sign::negative, rule::order, "arc", a,
             "does not run forwards in time");
  }

  // ---- incidence: what lies on what, and both know it

  void check_incidence() {
    std::vector<std::vector<int>> of_node(s_.nodes.size());
    std::vector<std::vector<int>> of_sheet(s_.sheets.size());
    bend_.assign(s_.sheets.size(), bend::none);
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      for (const int n : {arc.source, arc.target}) {
        of_node[n].push_back(a);
        for (const plane_id p : arc.planes) demand(passes(n, p), rule::incidence, "arc", a, "one of its planes does not pass through its end");
      }
      demand(certificate::is_monotone(arc.corner, 3) && certificate::depends_on_all(arc.corner, 3), rule::incidence, "arc", a, "has no corner");
      std::size_t next = 0;
      for (unsigned t = 0; t < 3; ++t)
        for (const bool inside : {false, true}) {
          const bend kind = bend_at(arc.corner, t, inside);
          if (kind == bend::none) continue;
          demand(next < arc.sheets.size(), rule::incidence, "arc", a, "misses a sheet");
          const int s = arc.sheets[next++];
          demand(s_.sheets[s].facets == others(arc.planes, t), rule::incidence, "arc", a, "lies on the border of a sheet of other facets");
          of_sheet[s].push_back(a);
          bend& known = bend_[s_.sheets[s].representative];
          demand(known == bend::none || known == kind, rule::incidence, "sheet", s, "is convex at one arc and reflex at another");
          known = kind;
        }
      demand(next == arc.sheets.size(), rule::incidence, "arc", a, "has a sheet too many");
    }
    const auto same = [](std::vector<int> x, std::vector<int> y) {
      std::sort(x.begin(), x.end());
      std::sort(y.begin(), y.end());
      return x == y;
    };
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n)
      for (int r = 0; r < 3 && s_.nodes[n].vertex >= 0; ++r)
        demand(passes(n, s_.nodes[n].planes[r]), rule::incidence, "node", n, "names a plane that does not pass through its vertex");
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n)
      demand(same(of_node[n], s_.nodes[n].arcs), rule::incidence, "node", n, "does not list the arcs that end in it");
    std::vector<std::vector<int>> of_cell(s_.cells.size());
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s) {
      const auto& sheet = s_.sheets[s];
      demand(same(of_sheet[s], sheet.arcs), rule::incidence, "sheet", s, "does not list the arcs on its border");
      demand(s_.sheets[sheet.representative].facets == sheet.facets, rule::incidence, "sheet", s, "is part of a polygon of other facets");
      for (const plane_id f : sheet.facets) of_cell[f].push_back(s);
    }
    for (int c = 0; c < static_cast<int>(s_.cells.size()); ++c)
      demand(same(of_cell[c], s_.cells[c]), rule::incidence, "cell", c, "does not list its sheets");
  }

  // Whether a plane passes through a node; through a vertex of the solid also when it contains the line of an edge that ends there.
  bool passes(int n, plane_id p) const {
    const auto& node = s_.nodes[n];
    if (node.vertex < 0) return std::find(node.planes.begin(), node.planes.end(), p) != node.planes.end();
    std::vector<int> reached = {node.vertex};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const auto& v = solid_.vertices[reached[i]];
      if (std::find(v.facets.begin(), v.facets.end(), p) != v.facets.end()) return true;
      for (const int e : v.edges) {
        const auto& edge = solid_.edges[e];
        if (k_.transversal(edge.planes[0], edge.planes[1], p)) continue;
        for (const int w : edge.ends)
          if (std::find(reached.begin(), reached.end(), w) == reached.end()) reached.push_back(w);
      }
    }
    return false;
  }

  static bend bend_at(std::uint8_t corner, unsigned t, bool inside) {
    return certificate::edge_at(corner, t == 0 ? 1 : 0, t == 2 ? 1 : 2, inside ? 1U << t : 0U);
  }
  static std::array<plane_id, 2> others(const triple& planes, unsigned t) { return {planes[t == 0 ? 1 : 0], planes[t == 2 ? 1 : 2]}; }

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

  // ---- border: at the solid's vertices every polygon's border is closed, and its edges are those of the solid

  void check_borders() const {
    std::map<std::pair<int, int>, int> ends;  // of a polygon's border, by vertex
    std::map<std::pair<int, plane_id>, int> sides;
    for (const auto& sheet : s_.sheets) {
      if (sheet.input_edge < 0) continue;
      for (const int v : solid_.edges[sheet.input_edge].ends) ++ends[{sheet.representative, v}];
      for (const plane_id f : sheet.facets) ++sides[{sheet.input_edge, f}];
    }
    for (const auto& a : s_.arcs) {
      const int v = s_.nodes[a.source].vertex;
      if (v < 0) continue;
      for (const int s : a.sheets) ++ends[{s_.sheets[s].representative, v}];
    }
    for (const auto& [at, times] : ends)
      demand(times % 2 == 0, rule::border, "sheet", at.first, ("has an open border at vertex " + std::to_string(at.second)).c_str());
    for (int e = 0; e < static_cast<int>(solid_.edges.size()); ++e)
      for (const plane_id f : solid_.edges[e].planes) ++sides[{e, f}];
    for (const auto& [at, times] : sides)
      demand(times % 2 == 0, rule::border, "edge", at.first, ("bounds no sheet, or a wrong one, of facet " + std::to_string(at.second)).c_str());
  }

  // ---- link, nowhere, count: the neighbourhood of an event

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
    for (const function f : certificate::monotone_functions()) {
      if (!has_arcs(at, f)) continue;
      arcs_fit = true;
      const auto joined = has_sheets(at, f);
      if (!joined) continue;
      joined_.insert(joined_.end(), joined->begin(), joined->end());
      demand(!certificate::makes_facet_from_nowhere(f, created), rule::nowhere, "node", n, "makes a facet out of nothing");
      const function other = f ^ function { 1 } << created;
      const bool ambiguous = certificate::is_monotone(other, 4) && !certificate::makes_facet_from_nowhere(other, created);
      demand(node.ambiguous == ambiguous, rule::count, "node", n, ambiguous ? "is ambiguous" : "is not ambiguous");
      demand(node.event == class_of(at, f), rule::count, "node", n, "belongs to another class of events");
      return;
    }
    refute(rule::link,
           "node " + std::to_string(n) + (arcs_fit ? ": the sheets around it do not lead from arc to arc" : ": no cells around it fit its arcs"));
  }

  star star_of(int n) const {
    star at{s_.nodes[n].planes, {}, {-1, -1, -1, -1}, {-1, -1, -1, -1}};
    for (unsigned r = 0; r < 4; ++r) at.in[r] = lambda(at.planes, r) * k_.closing(when_[n]) == sign::positive;
    for (const int a : s_.nodes[n].arcs) {
      const auto& arc = s_.arcs[a];
      unsigned r = 0;
      while (r < 3 && arc.planes[r] == at.planes[r]) ++r;
      int& place = arc.target == n ? at.past[r] : at.future[r];
      demand(place < 0, rule::link, "node", n, "has two arcs in one direction");
      place = a;
    }
    return at;
  }

  bool has_arcs(const star& at, function f) const {
    for (unsigned r = 0; r < 4; ++r)
      for (const bool inside : {false, true}) {
        const function corner = certificate::restricted(f, r, inside);
        const int a = at.arc(r, inside);
        if (certificate::depends_on_all(corner, 3) ? a < 0 || s_.arcs[a].corner != corner : a >= 0) return false;
      }
    return true;
  }

  // In the plane of two facets four quadrants, by the sides of the two other planes, surround the node, each in a sheet or not. Where
  // there is an arc between two quadrants, it names the sheets; where there is none, one sheet goes on. Gives the sheets that are found to
  // be one, or nothing where they are said not to be.
  std::optional<std::vector<std::pair<int, int>>> has_sheets(const star& at, function f) const {
    std::vector<std::pair<int, int>> joined;
    const auto are_one = [&](int s, int t) {
      if (s < 0 || t < 0) return true;
      joined.emplace_back(s, t);
      return s_.sheets[s].representative == s_.sheets[t].representative;
    };
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j) {
        const unsigned k = i == 0 ? (j == 1 ? 2 : 1) : 0;
        const unsigned l = 6 - i - j - k;
        struct quadrant {
          bool in_k, in_l;
        };
        constexpr std::array<quadrant, 4> around = {{{true, true}, {false, true}, {false, false}, {true, false}}};
        std::array<int, 4> sheet = {-1, -1, -1, -1};
        std::array<bool, 4> open{};  // no arc between this quadrant and the next
        for (unsigned d = 0; d < 4; ++d) {
          const bool crosses_k = d % 2 == 0;  // the ray between lies on plane k and has one side of l, or the other way round
          const unsigned on = crosses_k ? k : l;
          const unsigned omitted = crosses_k ? l : k;
          const int a = at.arc(omitted, crosses_k ? around[d].in_l : around[d].in_k);
          open[d] = a < 0;
          if (a < 0) continue;
          const unsigned t = on < omitted ? on : on - 1;
          for (const unsigned e : {d, (d + 1) % 4}) {
            const int named = sheet_at(s_.arcs[a], t, crosses_k ? around[e].in_k : around[e].in_l);
            if (!are_one(sheet[e], named)) return std::nullopt;
            sheet[e] = named;
          }
        }
        for (unsigned d = 0; d < 8; ++d) {  // twice around
          if (!open[d % 4]) continue;
          int& here = sheet[d % 4];
          int& next = sheet[(d + 1) % 4];
          if (!are_one(here, next)) return std::nullopt;
          here = next = std::max(here, next);
        }
        for (unsigned d = 0; d < 4; ++d) {
          const unsigned rest = (around[d].in_k ? 1U << k : 0U) | (around[d].in_l ? 1U << l : 0U);
          if (certificate::edge_at(f, i, j, rest) == bend::none && sheet[d] >= 0) return std::nullopt;
        }
      }
    return joined;
  }

  // Thesis 3.9: vertices before and after, edges between two of them that vanish and appear, and whether an edge passes through.
  event_class class_of(const star& at, function f) const {
    int vanish = 0;
    int appear = 0;
    bool passing = false;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j) {
        const unsigned k = i == 0 ? (j == 1 ? 2 : 1) : 0;
        const unsigned l = 6 - i - j - k;
        const auto edge = [&](bool before) {
          return certificate::edge_at(f, i, j, (at.in[k] == before ? 1U << k : 0U) | (at.in[l] == before ? 1U << l : 0U)) != bend::none;
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
    std::vector<int> parent(s_.sheets.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int s) {
      while (parent[s] != s) s = parent[s] = parent[parent[s]];
      return s;
    };
    for (const auto& [s, t] : joined_) parent[root(s)] = root(t);
    std::map<std::pair<int, int>, int> at_vertex;  // by polygon and vertex
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s)
      if (const int e = s_.sheets[s].input_edge; e >= 0)
        for (const int v : solid_.edges[e].ends) parent[root(s)] = root(at_vertex.try_emplace({s_.sheets[s].representative, v}, s).first->second);
    for (int s = 0; s < static_cast<int>(s_.sheets.size()); ++s)
      demand(root(s) == root(s_.sheets[s].representative), rule::link, "sheet", s, "belongs to a polygon that it has no connection with");
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

  // ---- overlap: sheets lie side by side

  // A stretch of the line of three planes, by time, inside a sheet; from the start where there is no beginning.
  struct stretch {
    std::optional<meeting> begin;
    meeting end;
  };

  void check_overlaps() {
    std::map<std::array<plane_id, 2>, std::vector<int>> borders;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a)
      for (unsigned t = 0; t < 3; ++t) borders[others(s_.arcs[a].planes, t)].push_back(a);
    std::vector<std::vector<plane_id>> neighbours(solid_.planes);
    for (const auto& [pair, arcs] : borders)
      for (const int side : {0, 1}) neighbours[pair[side]].push_back(pair[1 - side]);
    std::map<triple, std::vector<std::vector<stretch>>> inside;  // by line; one list for each pair with sheets there
    for (plane_id k = 0; k < solid_.planes; ++k) {
      height_of_node_.assign(s_.nodes.size(), unknown);
      for (const plane_id i : neighbours[k])
        for (const plane_id j : neighbours[i]) {
          if (j == k || (i > j && std::binary_search(neighbours[k].begin(), neighbours[k].end(), j))) continue;  // seen from j
          const std::array<plane_id, 2> pair = {std::min(i, j), std::max(i, j)};
          auto within = sheets_along(borders[pair], pair, k);
          if (within.empty()) continue;
          triple line = {i, j, k};
          std::sort(line.begin(), line.end());
          inside[line].push_back(std::move(within));
        }
    }
    for (const auto& [line, lists] : inside)
      for (std::size_t x = 0; x < lists.size(); ++x)
        for (std::size_t y = 0; y < x; ++y)
          if (overlap(lists[x], lists[y]))
            refute(rule::overlap, "two sheets of one cell cross on the line of planes " + std::to_string(line[0]) + ", " + std::to_string(line[1]) +
                                      " and " + std::to_string(line[2]));
  }

  bool overlap(const std::vector<stretch>& x, const std::vector<stretch>& y) const {
    const auto before = [&](const stretch& s, const stretch& t) { return t.begin && k_.compare(s.end, *t.begin) != sign::positive; };
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

  // Where the line of a pair's plane and a third plane k lies inside the pair's sheets: w counts the sheets just inside and just
  // outside k, and changes where an arc on the sheets' border crosses the line or begins on it.
  std::vector<stretch> sheets_along(const std::vector<int>& arcs, const std::array<plane_id, 2>& pair, plane_id k) {
    struct change {
      std::optional<meeting> when;
      std::array<int, 2> w;  // outside k, inside k
    };
    std::map<plane_id, change> changes;  // by the plane that crosses the line there
    std::vector<int> on_line;
    triple line = {pair[0], pair[1], k};
    std::sort(line.begin(), line.end());
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
      if ((from == sign::positive) != (to == sign::positive)) here.w[1] += enters ? 1 : -1;
      if ((from == sign::negative) != (to == sign::negative)) here.w[0] += enters ? 1 : -1;
    }
    std::vector<change> sorted;
    for (auto& [l, c] : changes) {
      c.when = meet({line[0], line[1], line[2], l});
      sorted.push_back(c);
    }
    std::sort(sorted.begin(), sorted.end(), [&](const change& x, const change& y) { return k_.compare(*x.when, *y.when) == sign::negative; });
    std::vector<stretch> within;
    std::array<int, 2> w = {0, 0};
    for (std::size_t g = sorted.size(); g-- > 0;) {
      for (const int side : {0, 1}) w[side] -= sorted[g].w[side];
      const stretch here = {g == 0 ? std::nullopt : sorted[g - 1].when, *sorted[g].when};
      bool arc_here = false;
      for (const int a : on_line) {
        const auto& arc = s_.arcs[a];
        if (k_.compare(when_[arc.source], here.end) != sign::negative || (here.begin && k_.compare(when_[arc.target], *here.begin) != sign::positive))
          continue;
        demand(!arc_here, rule::overlap, "arc", a, "runs along another arc");
        arc_here = true;
        const unsigned t = third(arc.planes, pair);
        for (const int side : {0, 1})
          demand(w[side] == (bend_at(arc.corner, t, side == 1) != bend::none ? 1 : 0), rule::overlap, "arc", a,
                 "has sheets beside it that are not its own");
      }
      if (w[0] < 0 || w[0] > 1 || w[1] < 0 || w[1] > 1 || (!arc_here && w[0] != w[1]))
        refute(rule::overlap,
               "sheets of facets " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]) + " overlap beside plane " + std::to_string(k));
      if (!arc_here && w[0] == 1) within.insert(within.begin(), here);
    }
    return within;
  }

  // Sign of the distance of an arc's end from plane k; at a node on plane k zero.
  sign height(const skeleton::arc& arc, bool source, plane_id k) {
    const int n = source ? arc.source : arc.target;
    if (s_.nodes[n].vertex >= 0) return height(arc.planes, k, when_[n]);
    signed char& known = height_of_node_[n];
    if (known == unknown) {
      const auto& q = s_.nodes[n].planes;
      known = static_cast<signed char>(std::find(q.begin(), q.end(), k) != q.end() ? sign::zero : height(arc.planes, k, when_[n]));
    }
    return static_cast<sign>(known);
  }

  // h_k at the moving vertex of three planes is (D - t S) / lambda_k, and D - t S has the sign of S (D / S - t).
  sign height(const triple& corner, plane_id k, const meeting& t) const {
    const meeting m = meet({corner[0], corner[1], corner[2], k});
    return k_.closing(m) * k_.compare(m, t) * lambda_of(m, k);
  }

  // Whether the vertex of a line's three planes lies inside plane l before it meets it.
  bool inside_before(const triple& line, plane_id l) const {
    const meeting m = meet({line[0], line[1], line[2], l});
    return k_.closing(m) * lambda_of(m, l) == sign::positive;
  }

  meeting meet(const quadruple& q) const {
    const auto m = k_.meet(q);
    if (!m) throw degenerate_error({q[0], q[1], q[2], q[3]}, "whether four planes meet");
    return *m;
  }

  sign lambda_of(const meeting& m, plane_id k) const {
    const quadruple q = k_.planes(m);
    return lambda(q, static_cast<unsigned>(std::find(q.begin(), q.end(), k) - q.begin()));
  }

  // The signed minor of three of four planes (kernel.hpp).
  sign lambda(const quadruple& q, unsigned r) const {
    const sign s = k_.orientation(q[r == 0 ? 1 : 0], q[r <= 1 ? 2 : 1], q[r <= 2 ? 3 : 2]);
    if (s == sign::zero) throw degenerate_error({q[0], q[1], q[2], q[3]}, "the orientation");
    return r % 2 == 0 ? -s : s;
  }

  static unsigned third(const triple& planes, const std::array<plane_id, 2>& pair) {
    unsigned t = 0;
    while (planes[t] == pair[0] || planes[t] == pair[1]) ++t;
    return t;
  }
  static plane_id fourth(const quadruple& q, const triple& line) {
    return *std::find_if(q.begin(), q.end(), [&line](plane_id p) { return std::find(line.begin(), line.end(), p) == line.end(); });
  }

  // ---- floor: no part of a cell's surface floats

  void check_floors() const {
    for (plane_id f = 0; f < solid_.planes; ++f) {
      std::map<int, int> parent;
      const auto root = [&parent](int p) {
        while (parent.at(p) != p) p = parent.at(p);
        return p;
      };
      std::set<int> arcs;
      for (const int s : s_.cells[f]) {
        parent.emplace(s_.sheets[s].representative, s_.sheets[s].representative);
        arcs.insert(s_.sheets[s].arcs.begin(), s_.sheets[s].arcs.end());
      }
      std::set<int> low;
      for (const int s : s_.cells[f])
        if (s_.sheets[s].input_edge >= 0) low.insert(s_.sheets[s].representative);
      for (const int a : arcs) {
        int first = -1;
        for (const int s : s_.arcs[a].sheets) {
          const auto& sheet = s_.sheets[s];
          if (sheet.facets[0] != f && sheet.facets[1] != f) continue;
          if (first >= 0) parent[root(sheet.representative)] = root(first);
          first = sheet.representative;
          if (s_.nodes[s_.arcs[a].source].vertex >= 0) low.insert(sheet.representative);
        }
      }
      std::set<int> grounded;
      for (const int p : low) grounded.insert(root(p));
      for (const auto& [p, up] : parent) demand(grounded.contains(root(p)), rule::floor, "cell", f, "has a part that does not touch its facet");
    }
  }

  static constexpr signed char unknown = 2;

  const K& k_;
  const boundary& solid_;
  const skeleton& s_;
  std::vector<meeting> when_;
  std::vector<bend> bend_;                   // by polygon
  std::vector<std::pair<int, int>> joined_;  // sheets that events show to be one
  std::vector<signed char> height_of_node_;  // over the plane at hand
};

/// Compares a contracted skeleton with the contraction of a certified raw one. `k` is the kernel below the perturbation.
template <kernel<3> K>
std::optional<refutation> verify_contraction(const K& k, const boundary& solid, const skeleton& raw, const contracted_skeleton& given) {
  const contracted_skeleton right = contract(k, solid, raw);
  const auto differs = [](const auto& x, const auto& y, const char* what, auto same) -> std::optional<refutation> {
    for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i)
      if (i >= x.size() || i >= y.size() || !same(x[i], y[i]))
        return refutation{rule::contraction, std::string(what) + " " + std::to_string(i) + " is wrong"};
    return std::nullopt;
  };
  using c = contracted_skeleton;
  if (auto r = differs(right.nodes, given.nodes, "node", [](const c::node& x, const c::node& y) { return x.raw == y.raw && x.arcs == y.arcs; }))
    return r;
  if (auto r = differs(right.arcs, given.arcs, "arc", [](const c::arc& x, const c::arc& y) {
        return x.source == y.source && x.target == y.target && x.cells == y.cells && x.sheets == y.sheets;
      }))
    return r;
  if (auto r = differs(right.sheets, given.sheets, "sheet",
                       [](const c::sheet& x, const c::sheet& y) { return x.facets == y.facets && x.raw == y.raw && x.arcs == y.arcs; }))
    return r;
  if (right.cells != given.cells) return refutation{rule::contraction, "the number of cells is wrong"};
  return std::nullopt;
}

/// Certifies a raw skeleton of a solid, or refutes it. `k` is a perturbed kernel with the solid's planes.
template <kernel<3> K>
std::optional<refutation> verify(const K& k, const boundary& solid, const skeleton& s) {
  return verifier<K>(k, solid, s).run();
}

}  // namespace osteon
