// SPDX-License-Identifier: MIT

// The certificate: it holds for what the event loop makes, and refutes what has been tampered with.

#include "osteon/space/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "osteon/models/registry.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

std::string text_of(const std::optional<refutation>& r) {
  return r ? std::string(rule_names[static_cast<std::size_t>(r->broken)]) + ": " + r->witness : "certified";
}

std::string certify(const solid<integer>& s, const skeleton_options& o) {
  const auto k = default_kernel(s);
  const auto raw = straight_skeleton(k, s.boundary, o);
  const auto broken = verify(k, s.boundary, raw);
  return text_of(broken ? broken : verify_contraction(k.base(), s.boundary, raw, contract(k.base(), s.boundary, raw)));
}

TEST(Certificate, OfTheThesisModels) {
  OSTEON_NEEDS_CORPUS();
  for (const auto& entry : std::filesystem::directory_iterator(corpus() / "thesis")) {
    SCOPED_TRACE(entry.path().filename().string());
    const auto s = read_solid(entry.path());
    for (const auto p : {split_preference::convex, split_preference::min_volume}) {
      EXPECT_EQ(certify(s, preferring(p)), "certified");
      EXPECT_EQ(certify(s, as_in_the_thesis(p)), "certified");
    }
  }
}

TEST(Certificate, OfEveryKindOfModelAndOption) {
  for (const auto& kind : models::kinds())
    for (const auto p : {split_preference::convex, split_preference::reflex, split_preference::min_volume, split_preference::max_volume})
      for (const auto saddle : {saddle_rule::convex, saddle_rule::reflex, saddle_rule::slower, saddle_rule::faster}) {
        SCOPED_TRACE(kind.name);
        EXPECT_EQ(certify(make_solid(kind.make(kind.default_size, 5).take<integer>()), {p, saddle}), "certified");
      }
}

// 10,000 generated solids: voxels, stars and cones, some with weights.
TEST(Certificate, OfTenThousandSolids) {
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    models::dice roll(seed);
    input_mesh<integer> m;
    switch (seed % 5) {
      case 0: {
        const auto kind = std::find_if(models::kinds().begin(), models::kinds().end(), [](const auto& k) { return k.name == "star"; });
        m = kind->make(static_cast<int>(roll.between(3, 5)), seed).take<integer>();
        break;
      }
      case 1:
        m = models::cone(static_cast<int>(roll.between(3, 8)), seed).take<integer>();
        break;
      default:
        m = models::random_voxels({static_cast<int>(roll.between(1, 3)), static_cast<int>(roll.between(1, 3)), static_cast<int>(roll.between(1, 3))},
                                  static_cast<int>(roll.between(25, 90)), seed)
                .surface()
                .take<integer>();
    }
    if (seed % 7 == 0) {  // one weight for each plane
      const auto s = make_solid(m);
      std::vector<integer> weight;
      for (plane_id p = 0; p < s.boundary.planes; ++p) weight.emplace_back(roll.between(1, 4));
      for (const plane_id p : s.facet_planes) m.weights.push_back(weight[static_cast<std::size_t>(p)]);
    }
    const auto preference = seed % 2 == 0 ? split_preference::convex : split_preference::min_volume;
    ASSERT_EQ(certify(make_solid(m), preferring(preference)), "certified");
  }
}

// ---- corrupted skeletons

// A solid with events of many classes, and its skeleton.
struct sample {
  solid<integer> of;
  skeleton raw;
  contracted_skeleton exact;
};

const sample& bars() {
  static const sample one = [] {
    const auto& kinds = models::kinds();
    const auto& kind = *std::find_if(kinds.begin(), kinds.end(), [](const auto& k) { return k.name == "crossing-bars"; });
    sample s{make_solid(kind.make(kind.default_size, 3).template take<integer>()), {}, {}};
    const auto k = default_kernel(s.of);
    s.raw = straight_skeleton(k, s.of.boundary);
    s.exact = contract(k.base(), s.of.boundary, s.raw);
    return s;
  }();
  return one;
}

template <class List, class Wanted>
int find(const List& list, Wanted wanted) {
  const auto found = std::find_if(list.begin(), list.end(), wanted);
  if (found == list.end()) throw std::logic_error("the sample has no such element");
  return static_cast<int>(found - list.begin());
}

int an_event(const skeleton& s) {
  return find(s.nodes, [](const auto& n) { return n.vertex < 0; });
}
int an_inner_arc(const skeleton& s) {
  return find(s.arcs, [&](const auto& a) { return s.nodes[static_cast<std::size_t>(a.source)].vertex < 0; });
}
int a_born_sheet(const skeleton& s) {
  return find(s.sheets, [](const auto& t) { return t.input_edge < 0 && !t.arcs.empty(); });
}
void remove(std::vector<int>& list, int value) { list.erase(std::find(list.begin(), list.end(), value)); }

// Lets an arc end in another node, consistently.
void retarget(skeleton& s, int a, int node) {
  auto& arc = s.arcs[static_cast<std::size_t>(a)];
  remove(s.nodes[static_cast<std::size_t>(arc.target)].arcs, a);
  arc.target = node;
  s.nodes[static_cast<std::size_t>(node)].arcs.push_back(a);
}

void drop_last_arc_consistently(skeleton& s, int a) {
  const int last = static_cast<int>(s.arcs.size()) - 1;
  const auto gone = s.arcs[static_cast<std::size_t>(a)];
  for (const int n : {gone.source, gone.target}) remove(s.nodes[static_cast<std::size_t>(n)].arcs, a);
  for (const int t : gone.sheets) remove(s.sheets[static_cast<std::size_t>(t)].arcs, a);
  if (a != last) {
    const auto moved = s.arcs[static_cast<std::size_t>(last)];
    for (const int n : {moved.source, moved.target}) {
      auto& arcs = s.nodes[static_cast<std::size_t>(n)].arcs;
      std::replace(arcs.begin(), arcs.end(), last, a);
    }
    for (const int t : moved.sheets) {
      auto& arcs = s.sheets[static_cast<std::size_t>(t)].arcs;
      std::replace(arcs.begin(), arcs.end(), last, a);
    }
    s.arcs[static_cast<std::size_t>(a)] = moved;
  }
  s.arcs.pop_back();
}

struct corruption {
  const char* name;
  rule broken;
  std::function<void(skeleton&)> apply;
};

std::vector<corruption> corruptions() {
  using enum rule;
  const auto node = [](skeleton& s) -> skeleton::node& { return s.nodes[static_cast<std::size_t>(an_event(s))]; };
  const auto arc = [](skeleton& s) -> skeleton::arc& { return s.arcs[static_cast<std::size_t>(an_inner_arc(s))]; };
  const auto sheet = [](skeleton& s) -> skeleton::sheet& { return s.sheets[static_cast<std::size_t>(a_born_sheet(s))]; };
  const auto edge_sheet = [](skeleton& s) -> skeleton::sheet& {
    return s.sheets[static_cast<std::size_t>(find(s.sheets, [](const auto& t) { return t.input_edge >= 0; }))];
  };
  return {
      {"a node names an arc that is not there", structure, [=](skeleton& s) { node(s).arcs[0] = 1 << 30; }},
      {"a node names a negative arc", structure, [=](skeleton& s) { node(s).arcs[0] = -5; }},
      {"a node's planes descend", structure, [=](skeleton& s) { std::swap(node(s).planes[0], node(s).planes[1]); }},
      {"a node repeats a plane", structure, [=](skeleton& s) { node(s).planes[1] = node(s).planes[0]; }},
      {"a node's plane is not there", structure, [=](skeleton& s) { node(s).planes[3] = 100000; }},
      {"a node has no class", structure, [=](skeleton& s) { node(s).event = static_cast<event_class>(99); }},
      {"a node is a vertex that is not there", structure, [](skeleton& s) { s.nodes[0].vertex = 1 << 30; }},
      {"two nodes are one vertex", structure, [](skeleton& s) { s.nodes[1].vertex = s.nodes[0].vertex; }},
      {"an event says that it is a vertex", structure, [=](skeleton& s) { node(s).vertex = 0; }},
      {"a vertex has no node", structure, [](skeleton& s) { s.nodes[0].vertex = -1; }},
      {"a vertex has a fourth plane", structure, [](skeleton& s) { s.nodes[0].planes[3] = 1 << 20; }},
      {"a vertex's planes descend", structure, [](skeleton& s) { std::swap(s.nodes[0].planes[0], s.nodes[0].planes[1]); }},
      {"a vertex names a plane that is elsewhere", incidence,
       [](skeleton& s) {
         const auto& facets = bars().of.boundary.vertices[0].facets;
         auto& planes = s.nodes[0].planes;
         for (plane_id p = 0; p < bars().of.boundary.planes; ++p)
           if (p > planes[1] && std::find(facets.begin(), facets.end(), p) == facets.end()) planes[2] = p;
       }},
      {"an arc's source is not there", structure, [=](skeleton& s) { arc(s).source = 1 << 30; }},
      {"an arc has no target", structure, [=](skeleton& s) { arc(s).target = -1; }},
      {"an arc repeats a plane", structure, [=](skeleton& s) { arc(s).planes[1] = arc(s).planes[0]; }},
      {"an arc names a sheet that is not there", structure, [=](skeleton& s) { arc(s).sheets[0] = -1; }},
      {"a sheet lies between a facet and itself", structure, [=](skeleton& s) { sheet(s).facets[1] = sheet(s).facets[0]; }},
      {"a sheet's facet is not there", structure, [=](skeleton& s) { sheet(s).facets[1] = 100000; }},
      {"a sheet's polygon is not there", structure, [=](skeleton& s) { sheet(s).representative = -2; }},
      {"a sheet's edge is not there", structure, [=](skeleton& s) { sheet(s).input_edge = 1 << 30; }},
      {"a sheet names an arc that is not there", structure, [=](skeleton& s) { sheet(s).arcs[0] = 1 << 30; }},
      {"a cell is missing", structure, [](skeleton& s) { s.cells.pop_back(); }},
      {"a cell names a sheet that is not there", structure, [](skeleton& s) { s.cells[0][0] = 1 << 30; }},
      {"an event comes before the solid's vertices", order,
       [](skeleton& s) {
         const int n = an_event(s);
         std::swap(s.nodes[0], s.nodes[static_cast<std::size_t>(n)]);
         for (auto& a : s.arcs)
           for (int* end : {&a.source, &a.target}) *end = *end == 0 ? n : (*end == n ? 0 : *end);
       }},
      {"the last event comes first", order,
       [](skeleton& s) {
         const int n = an_event(s);
         const int last = static_cast<int>(s.nodes.size()) - 1;
         std::swap(s.nodes[static_cast<std::size_t>(last)], s.nodes[static_cast<std::size_t>(n)]);
         for (auto& a : s.arcs)
           for (int* end : {&a.source, &a.target}) *end = *end == last ? n : (*end == n ? last : *end);
       }},
      {"an arc runs backwards", order, [=](skeleton& s) { std::swap(arc(s).source, arc(s).target); }},
      {"an arc ends where it starts", order, [=](skeleton& s) { arc(s).target = arc(s).source; }},
      {"two events exchange their planes", order,
       [](skeleton& s) { std::swap(s.nodes[static_cast<std::size_t>(an_event(s))].planes, s.nodes.back().planes); }},
      {"an event has planes that met before", order,
       [](skeleton& s) {
         auto& q = s.nodes.back().planes;
         const auto& early = s.nodes[static_cast<std::size_t>(an_event(s))].planes;
         q = early;
       }},
      {"an arc lies on another plane", incidence,
       [=](skeleton& s) {
         auto& planes = arc(s).planes;
         planes[2] = planes[2] == 0 ? 1 : planes[2] - 1;
         while (planes[2] == planes[1] || planes[2] == planes[0]) --planes[2];
         std::sort(planes.begin(), planes.end());
       }},
      {"a node has lost an arc", incidence, [=](skeleton& s) { node(s).arcs.pop_back(); }},
      {"a node lists an arc twice", incidence, [=](skeleton& s) { node(s).arcs.push_back(node(s).arcs[0]); }},
      {"a node lists a foreign arc", incidence, [=](skeleton& s) { node(s).arcs[0] = s.nodes.back().arcs[0]; }},
      {"a sheet has lost an arc", incidence, [=](skeleton& s) { sheet(s).arcs.pop_back(); }},
      {"a sheet lists a foreign arc", incidence, [=](skeleton& s) { sheet(s).arcs[0] = sheet(s).arcs[0] == 0 ? 1 : 0; }},
      {"a cell has lost a sheet", incidence, [](skeleton& s) { s.cells[0].pop_back(); }},
      {"a cell lists a sheet twice", incidence, [](skeleton& s) { s.cells[0].push_back(s.cells[0][0]); }},
      {"a cell has another's sheets", incidence, [](skeleton& s) { std::swap(s.cells[0], s.cells[1]); }},
      {"an arc's corner is turned inside out", incidence,
       [](skeleton& s) {
         auto& a = s.arcs[static_cast<std::size_t>(find(s.arcs, [](const auto& x) { return x.corner == 0x80; }))];
         a.corner = 0xFE;
       }},
      {"an arc's corner is no corner", incidence, [=](skeleton& s) { arc(s).corner = 0xFF; }},
      {"an arc's corner is not monotone", incidence, [=](skeleton& s) { arc(s).corner = 0x7F; }},
      {"an arc has lost a sheet", incidence, [=](skeleton& s) { arc(s).sheets.pop_back(); }},
      {"an arc has a sheet too many", incidence, [=](skeleton& s) { arc(s).sheets.push_back(arc(s).sheets[0]); }},
      {"an arc's sheets are in another order", incidence, [=](skeleton& s) { std::swap(arc(s).sheets[0], arc(s).sheets[1]); }},
      {"a sheet belongs to a polygon of other facets", incidence,
       [](skeleton& s) {
         const auto t = static_cast<std::size_t>(a_born_sheet(s));
         s.sheets[t].representative = find(s.sheets, [&](const auto& x) {
           return x.facets != s.sheets[t].facets && s.sheets[x.representative].representative == x.representative &&
                  &s.sheets[x.representative] == &x;
         });
       }},
      {"an arc ends in a node of other planes", incidence,
       [](skeleton& s) {
         const int a = an_inner_arc(s);
         const auto& planes = s.arcs[static_cast<std::size_t>(a)].planes;
         retarget(s, a,
                  static_cast<int>(s.nodes.rend() - std::find_if(s.nodes.rbegin(), s.nodes.rend(),
                                                                 [&](const auto& n) {
                                                                   return n.vertex < 0 && !std::includes(n.planes.begin(), n.planes.end(),
                                                                                                         planes.begin(), planes.end());
                                                                 })) -
                      1);
       }},
      {"a sheet has forgotten its edge", border, [=](skeleton& s) { edge_sheet(s).input_edge = -1; }},
      {"two sheets exchange their edges", border,
       [](skeleton& s) {
         const auto a = static_cast<std::size_t>(find(s.sheets, [](const auto& t) { return t.input_edge >= 0; }));
         const auto b = static_cast<std::size_t>(find(s.sheets, [&](const auto& t) { return t.input_edge >= 0 && t.facets != s.sheets[a].facets; }));
         std::swap(s.sheets[a].input_edge, s.sheets[b].input_edge);
       }},
      {"a sheet claims an edge", border, [=](skeleton& s) { sheet(s).input_edge = 0; }},
      {"a vertex's arc is gone", border,
       [](skeleton& s) {
         drop_last_arc_consistently(s, find(s.arcs, [&](const auto& a) { return s.nodes[static_cast<std::size_t>(a.source)].vertex >= 0; }));
       }},
      {"an arc is gone", link, [](skeleton& s) { drop_last_arc_consistently(s, an_inner_arc(s)); }},
      {"an arc is there twice", link,
       [](skeleton& s) {
         const int a = an_inner_arc(s);
         const int copy = static_cast<int>(s.arcs.size());
         s.arcs.push_back(s.arcs[static_cast<std::size_t>(a)]);
         for (const int n : {s.arcs.back().source, s.arcs.back().target}) s.nodes[static_cast<std::size_t>(n)].arcs.push_back(copy);
         for (const int t : s.arcs.back().sheets) s.sheets[static_cast<std::size_t>(t)].arcs.push_back(copy);
       }},
      {"an arc passes its end and stops at the next node of its planes", link,
       [](skeleton& s) {
         for (int a = 0; a < static_cast<int>(s.arcs.size()); ++a)
           for (int n = s.arcs[static_cast<std::size_t>(a)].target + 1; n < static_cast<int>(s.nodes.size()); ++n) {
             const auto& planes = s.arcs[static_cast<std::size_t>(a)].planes;
             const auto& q = s.nodes[static_cast<std::size_t>(n)].planes;
             if (!std::includes(q.begin(), q.end(), planes.begin(), planes.end())) continue;
             retarget(s, a, n);
             return;
           }
         throw std::logic_error("the sample has no such element");
       }},
      {"a sheet that goes on is said to end", link,
       [](skeleton& s) {
         const int t = find(s.sheets, [&](const auto& x) {
           return s.sheets[static_cast<std::size_t>(x.representative)].representative == x.representative &&
                  &s.sheets[static_cast<std::size_t>(x.representative)] != &x && !x.arcs.empty();
         });
         s.sheets[static_cast<std::size_t>(t)].representative = t;
       }},
      {"two sheets apart are said to be one", link,
       [](skeleton& s) {
         for (int t = 0; t < static_cast<int>(s.sheets.size()); ++t)
           for (int u = 0; u < t; ++u)
             if (s.sheets[static_cast<std::size_t>(t)].facets == s.sheets[static_cast<std::size_t>(u)].facets &&
                 s.sheets[static_cast<std::size_t>(t)].representative == t && s.sheets[static_cast<std::size_t>(u)].representative == u) {
               skeleton changed = s;
               for (auto& x : changed.sheets)
                 if (x.representative == t) x.representative = u;
               const auto k = default_kernel(bars().of);
               const auto broken = verify(k, bars().of.boundary, changed);
               if (!broken || broken->broken != link) continue;  // not the kinds of two sheets differ
               s = changed;
               return;
             }
         throw std::logic_error("the sample has no such element");
       }},
      {"an event is in the wrong class", count,
       [=](skeleton& s) { node(s).event = node(s).event == event_class::E6 ? event_class::E5 : event_class::E6; }},
      {"an event is said to be ambiguous", count, [=](skeleton& s) { node(s).ambiguous = !node(s).ambiguous; }},
      {"events are counted wrongly", count, [](skeleton& s) { ++s.events[0]; }},
      {"ambiguous events are counted wrongly", count, [](skeleton& s) { ++s.ambiguous; }},
  };
}

TEST(Corrupted, SkeletonsAreRefutedByTheRightRule) {
  const auto k = default_kernel(bars().of);
  ASSERT_EQ(text_of(verify(k, bars().of.boundary, bars().raw)), "certified");
  std::set<std::string> names;
  for (const corruption& c : corruptions()) {
    SCOPED_TRACE(c.name);
    EXPECT_TRUE(names.insert(c.name).second);
    skeleton s = bars().raw;
    ASSERT_NO_THROW(c.apply(s));
    const auto broken = verify(k, bars().of.boundary, s);
    EXPECT_TRUE(broken && broken->broken == c.broken) << text_of(broken);
    EXPECT_TRUE(!broken || !broken->witness.empty());
  }
  EXPECT_GE(names.size(), 50U);
}

TEST(Corrupted, ContractionsAreRefuted) {
  const auto& b = bars();
  const auto k = default_kernel(b.of);
  const std::vector<std::function<void(contracted_skeleton&)>> changes = {[](auto& c) { c.nodes.pop_back(); },
                                                                          [](auto& c) { c.nodes.back().raw.pop_back(); },
                                                                          [](auto& c) { c.nodes.back().arcs.pop_back(); },
                                                                          [](auto& c) { c.arcs.pop_back(); },
                                                                          [](auto& c) { ++c.arcs[0].source; },
                                                                          [](auto& c) { ++c.arcs[0].target; },
                                                                          [](auto& c) { c.arcs[0].cells.pop_back(); },
                                                                          [](auto& c) { c.arcs[0].sheets.pop_back(); },
                                                                          [](auto& c) { c.sheets.pop_back(); },
                                                                          [](auto& c) { ++c.sheets[0].facets[1]; },
                                                                          [](auto& c) { c.sheets[0].raw.push_back(0); },
                                                                          [](auto& c) { c.sheets[0].arcs.clear(); },
                                                                          [](auto& c) { ++c.cells; }};
  EXPECT_FALSE(verify_contraction(k.base(), b.of.boundary, b.raw, b.exact));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    SCOPED_TRACE(i);
    contracted_skeleton c = b.exact;
    changes[i](c);
    const auto broken = verify_contraction(k.base(), b.of.boundary, b.raw, c);
    EXPECT_TRUE(broken && broken->broken == rule::contraction) << text_of(broken);
  }
}

// A kernel that does not see one meeting: the wavefront runs through itself there.
template <kernel<3> K>
class blind : public K {
 public:
  blind(K k, quadruple unseen) : K(std::move(k)), unseen_(unseen) {}
  std::optional<typename K::meeting> meet(const quadruple& q) const { return sorted(q) == unseen_ ? std::nullopt : K::meet(q); }

 private:
  quadruple unseen_;
};

// Every event is missed once. Runs that end all the same must be refuted.
TEST(Corrupted, MissedEventsDoNotPass) {
  int missed = 0;
  for (const char* name : {"crossing-bars", "spiked-plate", "house-x"}) {
    const auto& kinds = models::kinds();
    const auto& kind = *std::find_if(kinds.begin(), kinds.end(), [&](const auto& x) { return x.name == name; });
    const auto s = make_solid(kind.make(kind.default_size, 1).template take<integer>());
    const auto k = default_kernel(s);
    for (const auto& node : straight_skeleton(k, s.boundary).nodes) {
      if (node.vertex >= 0) continue;
      ++missed;
      try {
        const skeleton wrong = straight_skeleton(blind(k, node.planes), s.boundary);
        EXPECT_TRUE(verify(k, s.boundary, wrong)) << name << ", " << event_names[static_cast<std::size_t>(node.event)];
      } catch (const invariant_error&) {  // the wavefront itself has noticed
      }
    }
  }
  EXPECT_GT(missed, 50);
}

// A column with a pit in its top. The skeleton of a high one has nothing wrong about any node of a low one: only the pit's tip and the floor
// run through each other, and only sheets show it.
solid<integer> column(long floor) {
  const std::vector<std::array<long, 3>> points = {{0, 0, floor}, {20, 1, floor}, {21, 27, floor}, {-1, 25, floor}, {0, 0, 100},
                                                   {20, 1, 100},  {21, 27, 100},  {-1, 25, 100},   {5, 6, 100},     {15, 6, 100},
                                                   {15, 18, 100}, {5, 17, 100},   {10, 12, 90}};
  input_mesh<integer> m;
  for (const auto& p : points) m.points.push_back({exact_number<integer>{p[0], 0, 0}, {p[1], 0, 0}, {p[2], 0, 0}});
  m.facets = {{3, 2, 1, 0},   {0, 1, 5, 4},  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 9, 8}, {5, 6, 10, 9},
              {6, 7, 11, 10}, {7, 4, 8, 11}, {8, 9, 12},   {9, 10, 12},  {10, 11, 12}, {11, 8, 12}};
  return make_solid(m);
}

TEST(Corrupted, SheetsThatOverlapAreRefuted) {
  const auto high = column(0);
  const auto low = column(60);
  const auto k = default_kernel(low);
  const auto raw = straight_skeleton(default_kernel(high), high.boundary);
  const auto broken = verify(k, low.boundary, raw);
  EXPECT_TRUE(broken && broken->broken == rule::overlap) << text_of(broken);
  EXPECT_EQ(certify(low, {}), "certified");
  EXPECT_EQ(certify(high, {}), "certified");
  // In a very low one the tip of the pit comes out at the floor before anything else happens.
  const auto flat = column(85);
  EXPECT_GT(straight_skeleton(default_kernel(flat), flat.boundary).events[static_cast<std::size_t>(event_class::V_F)], 0);
  EXPECT_EQ(certify(flat, {}), "certified");
}

}  // namespace
}  // namespace osteon::test
