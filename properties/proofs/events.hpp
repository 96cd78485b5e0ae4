// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Statements about local events: existence, uniqueness, reading off, what the event loop looks for, and the link.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "local_picture.hpp"
#include "report.hpp"

namespace osteon::proofs {

inline void prove_existence(proof& p) {
  const std::vector<moment> events = all_events();
  std::size_t entries = 0;
  for (cell small = 1; small <= every_plane; ++small) entries += local::catalogue::get().events(small).size();
  for (const moment& m : events) {
    p.check(m.monotone() && (admissible(after(m, false)) || admissible(after(m, true))), [&] { return text(m) + " has no successor"; });
    const local::event* e = in_catalogue(m);
    p.check(e != nullptr, [&] { return text(m) + " is not in the catalogue"; });
    for (const bool fill : {false, true})
      p.check(e != nullptr && may(*e, fill) == admissible(after(m, fill)) && local::successor(*e, fill) == after(m, fill).f,
              [&] { return text(m) + (fill ? ", filled" : ", emptied") + ": the catalogue decides otherwise"; });
  }
  p.check(entries == events.size(), [&] { return "the catalogue has " + std::to_string(entries) + " entries"; });
  const auto different = events_up_to_renaming().size();
  p.check(different == 105, [&] { return std::to_string(different) + " events up to renaming"; });
  p.note(std::to_string(events.size()) + " events, " + std::to_string(different) + " up to renaming of planes");
}

/// An E1 as thesis 3.9.1 describes it: one edge shrinks to nothing, another one grows.
inline bool flips_an_edge(const moment& before, const moment& then) {
  return before.vertices() == 2 && then.vertices() == 2 && before.short_edges() == 1 && then.short_edges() == 1 && !before.passing_edge();
}

/// How many edges of each kind end at the vertex of the planes other than q, inside and outside the third plane.
inline std::pair<int, int> edges_at_vertex(const moment& m, unsigned q) {
  int convex = 0;
  int reflex = 0;
  for (const line& n : lines) {
    if (n.k != q && n.l != q) continue;
    const section beyond = n.l == q ? local::far_k : local::far_l;  // the other piece at this vertex is the segment
    for (const section w : {beyond, local::segment}) {
      convex += m.edge(n, w) == piece::convex ? 1 : 0;
      reflex += m.edge(n, w) == piece::reflex ? 1 : 0;
    }
  }
  return {convex, reflex};
}

inline void prove_uniqueness(proof& p) {
  int saddles = 0;
  for (const moment& m : events_up_to_renaming()) {
    const moment empty = after(m, false);
    const moment full = after(m, true);
    const bool two = admissible(empty) && admissible(full);
    if (!two) {
      p.check(admissible(empty) != admissible(full), [&] { return text(m) + " has no successor"; });
      continue;
    }
    ++saddles;
    const auto grown = [](const moment& then) {
      const auto at = std::find_if(lines.begin(), lines.end(), [&](const line& n) { return then.short_edge(n); });
      return at == lines.end() ? piece::none : then.edge(*at, local::segment);
    };
    p.check(flips_an_edge(m, empty) && flips_an_edge(m, full) && grown(full) == piece::convex && grown(empty) == piece::reflex,
            [&] { return text(m) + " is ambiguous but no E1 with a convex and a reflex outcome"; });
    const local::event* e = in_catalogue(m);
    p.check(e != nullptr && classify(*e, false) == event_class::E1 && classify(*e, true) == event_class::E1,
            [&] { return text(m) + " is ambiguous and the catalogue does not call it E1"; });
    std::string corners;
    for (unsigned q = 0; q < planes; ++q) {
      if (!m.vertex(q)) continue;
      const auto [convex, reflex] = edges_at_vertex(m, q);
      p.check(convex + reflex == 3 && convex > 0 && reflex > 0, [&] { return text(m) + " has a vertex that is not mixed"; });
      corners += (corners.empty() ? "" : " and ") + std::string(convex == 2 ? "convex-convex-reflex" : "convex-reflex-reflex");
    }
    p.note("saddle: " + text(m) + ", between corners " + corners);
  }
  p.check(saddles == 2, [&] { return std::to_string(saddles) + " ambiguous events"; });
}

/// What can be read off the boundary: the kinds of the 18 pieces; for a plane without edges whether its facet is there.
using appearance = std::pair<std::array<piece, 18>, std::array<bool, planes>>;
inline appearance look_at(const moment& m) {
  appearance seen{};
  std::array<bool, planes> has_edge{};
  std::size_t at = 0;
  for (const line& n : lines)
    for (const section w : sections) {
      seen.first[at] = m.edge(n, w);
      if (seen.first[at++] != piece::none) has_edge[n.i] = has_edge[n.j] = true;
    }
  for (unsigned q = 0; q < planes; ++q) seen.second[q] = !has_edge[q] && m.involves(q);
  return seen;
}

inline void prove_reading(proof& p) {
  std::map<std::pair<cell, appearance>, state> seen;
  for (const moment& m : all_events()) {
    const appearance a = look_at(m);
    const auto [at, fresh] = seen.emplace(std::pair(m.tiny, a), m.f);
    p.check(fresh, [&] { return text(m) + " looks like state " + std::to_string(at->second); });
    std::uint64_t key = 0;
    for (unsigned w = 0; w < 18; ++w) key |= static_cast<std::uint64_t>(a.first[w]) << (2 * w);
    for (unsigned q = 0; q < planes; ++q) key |= static_cast<std::uint64_t>(a.second[q]) << (36 + q);
    const local::event* e = local::catalogue::get().find(m.tiny, key);
    p.check(key == local::key(m.f, m.tiny) && e != nullptr && e->before == m.f, [&] { return text(m) + " is not found by its boundary"; });
  }
  p.note(std::to_string(seen.size()) + " states; the catalogue finds each by the key derived here");
}

/// The event loop's candidates (osteon/propagate.hpp): an edge that collapses; a reflex or mixed corner and a plane that has an edge with
/// one of the corner's facets; where the four planes enclose a tetrahedron, a reflex corner and any plane, and two reflex edges.
struct candidates {
  bool collapse = false;
  bool contact = false;
  bool pierce = false;
  bool crossing = false;
  bool any() const { return collapse || contact || pierce || crossing; }
};

inline candidates looked_for(const moment& m) {
  candidates c;
  const bool enclosed = m.tiny == every_plane;
  const auto has = [&](unsigned i, unsigned j, auto kind) {
    for (const line& n : lines)
      if ((n.i == i && n.j == j) || (n.i == j && n.j == i))
        return std::any_of(sections.begin(), sections.end(), [&](section w) { return kind(m.edge(n, w)); });
    return false;
  };
  const auto reflex = [](piece e) { return e == piece::reflex; };
  for (const line& n : lines) {
    c.collapse = c.collapse || m.short_edge(n);
    c.crossing = c.crossing || (enclosed && has(n.i, n.j, reflex) && has(n.k, n.l, reflex));
  }
  for (unsigned q = 0; q < planes; ++q) {
    if (!m.vertex(q)) continue;
    const auto [convex_edges, reflex_edges] = edges_at_vertex(m, q);
    if (convex_edges + reflex_edges != 3 || reflex_edges == 0) continue;  // majority, convex
    for (unsigned r = 0; r < planes; ++r) c.contact = c.contact || (r != q && has(q, r, [](piece e) { return e != piece::none; }));
    c.pierce = c.pierce || (enclosed && convex_edges == 0);
  }
  return c;
}

inline void prove_candidates(proof& p) {
  int only_collapse = 0;
  int only_contact = 0;
  int only_enclosed = 0;
  for (const moment& m : all_events()) {
    const candidates c = looked_for(m);
    p.check(c.any(), [&] { return text(m) + " is met by no candidate"; });
    only_collapse += c.collapse && !c.contact && !c.pierce && !c.crossing ? 1 : 0;
    only_contact += !c.collapse && c.contact && !c.pierce && !c.crossing ? 1 : 0;
    only_enclosed += !c.collapse && !c.contact ? 1 : 0;
  }
  p.note("no other candidate finds: " + std::to_string(only_collapse) + " collapses, " + std::to_string(only_contact) + " contacts, " +
         std::to_string(only_enclosed) + " of enclosed tetrahedra");
}

/// Before and after as one function F of four variables: between them all 16 cells have been.
inline void prove_link(proof& p) {
  for (const moment& m : all_events())
    for (const bool fill : {false, true}) {
      const moment then = after(m, fill);
      if (!admissible(then)) continue;
      const auto what = [&] { return text(m) + (fill ? ", filled" : ", emptied"); };
      const state f = m.f | then.f;
      bool monotone = true;
      for (cell c = 0; c <= every_plane; ++c)
        for (unsigned q = 0; q < planes; ++q) monotone = monotone && (!solid_at(f, c) || solid_at(f, c | bit(q)));
      p.check(monotone && depends_on_all(f, planes) && !solid_at(f, 0) && solid_at(f, every_plane), what);

      // A direction is passed by the planes in some order; F switches when the plane of the facet that owns it passes.
      std::array<unsigned, planes> order = {0, 1, 2, 3};
      std::array<int, planes> share{};
      do {
        int switches = 0;
        cell c = every_plane;
        for (const unsigned q : order) {
          if (solid_at(f, c) != solid_at(f, c ^ bit(q))) {
            ++switches;
            ++share[q];
          }
          c ^= bit(q);
        }
        p.check(switches == 1, what);
      } while (std::next_permutation(order.begin(), order.end()));
      p.check(share[0] + share[1] + share[2] + share[3] == 24 && std::find(share.begin(), share.end(), 0) == share.end(), what);

      // An arc of the skeleton is a direction in which three planes arrive together, the fourth earlier or later. The vertex that traces
      // it is seen on the boundary: three edges end there, six at a majority corner; none, or one that runs through, otherwise.
      for (unsigned q = 0; q < planes; ++q)
        for (const bool past : {true, false}) {
          const moment& now = past ? m : then;
          const state link = restricted(f, planes, q, in(m.tiny, q) == past);
          const auto [convex, reflex] = edges_at_vertex(now, q);
          const int degree = convex + reflex;
          const bool through = degree == 0 || (degree == 2 && convex != 1);
          p.check(depends_on_all(link, 3) ? degree == 3 || (degree == 6 && convex == 3) : through, what);
          const local::event e{m.f, m.tiny, false, false};
          const state stored = past ? e.before : local::successor(e, fill);
          p.check(local::corner_at(stored, q, in(now.tiny, q)) == link, what);
        }
    }
}

}  // namespace osteon::proofs
