// SPDX-License-Identifier: MIT

// The splits of one vertex: a corner that is a terrain over the plane, z = f(x, y) with f linear on sectors, so that it is valid by
// construction; flat, steep, convex, reflex or mixed, with facets of one plane and straight edges.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "check.hpp"
#include "decode.hpp"
#include "effort.hpp"
#include "gmp_memory.hpp"
#include "osteon/core/error.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"
#include "split_oracle.hpp"

namespace osteon::fuzz {
namespace {

using vector = vec<integer>;
using planes = std::vector<moving_plane<integer>>;

// Edges outwards, counter-clockwise seen from above; the solid is below.
std::vector<vector> decode_rays(decoder& d, bool small) {
  static constexpr std::array<std::array<long, 2>, 16> circle = {
      {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}}};
  const int degree = 4 + static_cast<int>(d.between(0, small ? 2 : 4));
  const bool fine = d.flag();  // any directions instead of the sixteen
  const int steep = std::array{1, 3, 12, 127}[d.index(4)];
  std::vector<vector> rays;
  std::size_t at = d.index(16);
  int left = 16;
  for (int i = 0; i < degree; ++i) {
    const auto& a = circle[at];
    const auto& b = circle[(at + 1) % 16];
    const long u = fine ? d.between(1, 50) : 1;
    const long v = fine ? d.between(0, 50) : 0;
    const long stretch = d.between(1, 4);
    rays.push_back({integer((u * a[0] + v * b[0]) * stretch), integer((u * a[1] + v * b[1]) * stretch), integer(d.between(-steep, steep))});
    const int rest = degree - 1 - i;
    if (rest == 0) break;
    // Below half a turn also between the finer directions.
    const int least = std::max(1, left - 6 * rest);
    const int step = static_cast<int>(d.between(least, std::min(6, left - rest)));
    at = (at + static_cast<std::size_t>(step)) % 16;
    left -= step;
  }
  return rays;
}

struct cone {
  std::vector<moving_plane<integer>> planes;
  osteon::corner corner;
  bool collinear = false;  // three planes that share an edge's line
  bool repeated = false;   // two facets of one plane
};

// Nothing where two neighbours are coplanar, so that there is an edge less.
std::optional<cone> make_cone(const std::vector<vector>& rays) {
  cone c;
  std::map<vector, plane_id> ids;
  const std::size_t n = rays.size();
  for (std::size_t i = 0; i < n; ++i) {
    vector normal = cross(rays[i], rays[(i + 1) % n]);
    const integer g = gcd(normal[0], gcd(normal[1], normal[2]));
    for (integer& x : normal) x /= g;
    const auto [found, fresh] = ids.emplace(normal, static_cast<plane_id>(c.planes.size()));
    if (fresh) c.planes.push_back({normal, integer(0)});
    c.corner.facets.push_back(found->second);
    c.repeated = c.repeated || !fresh;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const vector& ray = rays[(i + 1) % n];
    const auto& p = c.planes[c.corner.facets[i]].n;
    const auto& q = c.planes[c.corner.facets[(i + 1) % n]].n;
    if (p == q) return std::nullopt;
    c.corner.convex.push_back(dot(ray, cross(q, p)) > 0);  // outwards, the next facet is on the left
    for (std::size_t k = 0; k < c.planes.size(); ++k)
      if (c.planes[k].n != p && c.planes[k].n != q && dot(c.planes[k].n, ray) == 0) c.collinear = true;
  }
  return c;
}

// ---- checks

bool majority(const osteon::corner& c) { return boundary::vertex{c.facets, {}}.is_majority(); }

// Where all planes differ: edges once more from their vertices (design 03), and the rule that their kinds obey.
template <kernel<3> K>
void check_local_rule(const K& k, const cone& c, const split_tree& t) {
  const auto plane = [&](int facet) { return c.corner.facets[static_cast<std::size_t>(facet)]; };
  const auto orientation = [&](const std::array<int, 3>& v) { return k.orientation(plane(v[0]), plane(v[1]), plane(v[2])); };
  for (std::size_t v = 0; v < t.vertices.size(); ++v) {
    const auto& corner = t.vertices[v];
    const bool up = orientation(corner) == sign::positive;
    int inside = 0;
    for (int r = 0; r < 3; ++r) {
      const int e = t.vertex_edges[v][r];
      const split_edge& edge = t.edges[static_cast<std::size_t>(e)];
      const std::set<int> ends = {edge.a, edge.b};
      require(ends == std::set<int>{corner[(r + 1) % 3], corner[(r + 2) % 3]}, "edge r of a vertex lies opposite its facet r");
      inside += edge.convex == up ? 1 : 0;
      if (edge.rays[0] >= 0) {
        require(edge.convex == c.corner.convex[static_cast<std::size_t>(edge.rays[0])], "an edge of the corner keeps its kind");
        continue;
      }
      // Convex iff (det > 0) == (the edge runs inside the third plane), that is, iff the other end lies inside.
      for (std::size_t w = 0; w < t.vertices.size(); ++w) {
        const auto& other = t.vertices[w];
        if (w == v || std::find(t.vertex_edges[w].begin(), t.vertex_edges[w].end(), e) == t.vertex_edges[w].end()) continue;
        const sign side = k.side(plane(corner[r]), plane(other[0]), plane(other[1]), plane(other[2]), k.start());
        require(side != sign::zero && edge.convex == (up == (side == sign::positive)), "a new edge is as convex as its ends say");
      }
    }
    require(up == (inside == 0 || inside == 3), "the local rule holds");
  }
}

void check_shape(const cone& c, const split_tree& t) {
  const std::size_t n = c.corner.facets.size();
  require(t.operations.size() == n - 3, "a tree has degree - 3 operations");
  require(std::is_sorted(t.operations.begin(), t.operations.end()), "operations ascend");
  require(t.vertex_edges.size() == t.vertices.size(), "every vertex has edges");
  std::vector<int> uses(n);
  for (const split_edge& e : t.edges)
    for (const int r : e.rays)
      if (r >= 0) ++uses[static_cast<std::size_t>(r)];
  require(std::all_of(uses.begin(), uses.end(), [](int u) { return u == 1; }), "every edge of the corner goes on in one edge");
  if (c.repeated) {
    require(t.vertices.size() <= n - 2, "a tree has at most degree - 2 vertices");
    return;
  }
  require(t.vertices.size() == n - 2, "a tree has degree - 2 vertices");
  require(t.edges.size() == 2 * n - 3, "a tree has 2 degree - 3 edges");
}

std::vector<triple> triples(const cone& c, const split_tree& t) {
  std::vector<triple> result;
  for (const auto& v : t.vertices) {
    auto& one = result.emplace_back();
    for (std::size_t r = 0; r < 3; ++r) one[r] = c.corner.facets[static_cast<std::size_t>(v[r])];
  }
  return result;
}

template <kernel<3> K>
void check_volumes(const K& k, const cone& c, const std::vector<split_tree>& trees) {
  std::vector<std::vector<triple>> some;
  for (std::size_t i = 0; i < std::min<std::size_t>(trees.size(), 6); ++i)
    some.push_back(triples(c, trees[i * trees.size() / std::min<std::size_t>(trees.size(), 6)]));
  const std::size_t n = some.size();
  std::vector<std::vector<sign>> order(n, std::vector<sign>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) order[i][j] = k.compare_volume(some[i], some[j]);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      require(order[i][j] == -order[j][i], "volumes are antisymmetric");
      for (std::size_t l = 0; l < n; ++l)
        if (order[i][j] != sign::positive && order[j][l] != sign::positive) require(order[i][l] != sign::positive, "volumes are transitive");
    }
}

// Every tree against brute force, for speeds that are rational.
void check_embedding(const std::vector<vector>& rays, const cone& c, const rational_kernel& k) {
  std::vector<vector> normals;
  std::vector<integer> speeds;
  for (const plane_id f : c.corner.facets) {
    normals.push_back(c.planes[f].n);
    speeds.push_back(k.arithmetic().speed(f));
  }
  const split_oracle oracle(rays, normals, speeds);
  const perturbed strict(k);
  std::set<std::vector<std::pair<int, int>>> valid;
  for (const auto& t : splitter(strict, c.corner).all()) valid.insert(t.operations);
  for_each_triangulation(c.corner.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
    if (const auto embedded = oracle.embedded(diagonals))
      require(*embedded == valid.contains({diagonals.begin(), diagonals.end()}), "a split is valid iff its offset is embedded");
  });
}

// The tree that is taken is a valid one, and none is worth more.
template <kernel<3> K>
void check_chosen(const K& k, const cone& c, const splitter<K>& s, const std::vector<split_tree>& all) {
  const auto is_valid = [&](const split_tree& t) {
    return std::any_of(all.begin(), all.end(), [&t](const split_tree& other) { return other.operations == t.operations; });
  };
  using enum split_preference;
  for (const auto p : {convex, reflex, min_volume, max_volume, first}) {
    const auto chosen = preferred_split(k, c.corner, p);
    require(chosen.has_value() == !all.empty(), "a tree is taken iff any is valid");
    if (!chosen) continue;
    require(chosen->proven && is_valid(chosen->tree), "the tree that is taken is valid, and known to be best");
    const auto best = s.best(p);
    if (p == convex) require(chosen->tree.convex_edges() == best->convex_edges(), "it has most convex edges");
    if (p == reflex) require(chosen->tree.reflex_edges() == best->reflex_edges(), "it has most reflex edges");
    if (p == min_volume || p == max_volume)
      require(k.compare_volume(triples(c, chosen->tree), triples(c, *best)) == sign::zero, "its volume is extreme");
  }
  const auto drawn = random_split(k, c.corner, all.size());
  require(drawn.has_value() == !all.empty() && (!drawn || is_valid(drawn->tree)), "the tree that is drawn is valid");
}

// The dynamic program finds the valid trees, once each.
template <kernel<3> K>
void check_search(const K& k, const cone& c, const splitter<K>& s, const std::vector<split_tree>& all,
                  const std::set<std::vector<std::pair<int, int>>>& candidates) {
  split_search<K, edge_count, std::uint64_t> search(s.signs(), edge_count(true));
  std::set<searched_split::diagonals> found;
  search.for_each([&](const auto& diagonals) {
    if (c.repeated) {
      const auto t = s.tree(diagonals);
      if (!t || !s.valid(*t)) return false;
    }
    require(found.insert(diagonals).second, "the search finds every tree once");
    return false;
  });
  require(found.size() == all.size() && std::all_of(all.begin(), all.end(), [&found](const auto& t) { return found.contains(t.operations); }),
          "the search finds the valid trees");
  const auto is_valid = [&found](const auto& diagonals) { return found.contains(diagonals); };
  for (const std::uint64_t steps : {1U, 5U, 25U}) {
    const searched_split hasty = search.best(is_valid, steps);
    require(hasty.end == search_end::unknown || (hasty.end == search_end::none ? found.empty() : found.contains(hasty.tree)),
            "a hasty search gives up or finds a valid tree");
  }
  if (search.count() > 0) {
    std::uint64_t drawn = c.corner.facets.size();
    const auto below = [&drawn](std::uint64_t n) { return (drawn = drawn * 6364136223846793005U + 1442695040888963407U) % n; };
    require(c.repeated || candidates.contains(search.sample(below)), "a drawn tree is a candidate");
  }
  const auto alike = [&c](bool convex) { return convex == c.corner.convex.front(); };
  if (std::all_of(c.corner.convex.begin(), c.corner.convex.end(), alike) && !all.empty() && !c.repeated)
    require(only_split(k, c.corner) == all.front().operations, "a corner of one kind splits fast");
}

// The laws that are not looked at for every input (effort.hpp).
enum dear_law : unsigned { embedding = 1, volumes, chosen_trees };

// The number of valid trees.
template <kernel<3> K>
std::size_t check(const effort& e, const K& k, const cone& c) {
  const splitter<K> s(k, c.corner);
  const auto candidates = s.candidates();
  const auto all = s.all();
  require(!all.empty() || c.collinear, "a corner has a valid split");
  std::set<std::vector<std::pair<int, int>>> lists;
  for (const auto& t : candidates) {
    check_shape(c, t);
    if (!c.repeated) check_local_rule(k, c, t);
    require(lists.insert(t.operations).second, "trees differ");
  }
  require(std::is_sorted(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.operations < b.operations; }),
          "trees come in the thesis's order");
  for (const auto& t : all) require(s.valid(t) && lists.contains(t.operations), "all trees are valid candidates");
  if (std::all_of(c.corner.convex.begin(), c.corner.convex.end(), [](bool b) { return b; }) && !c.collinear)
    require(all.size() == 1, "a convex corner has one valid split");

  check_search(k, c, s, all, lists);
  for (const auto p : {split_preference::convex, split_preference::reflex, split_preference::min_volume, split_preference::max_volume}) {
    const auto best = s.best(p);
    require(best.has_value() == !all.empty(), "the best tree is there iff any is");
    if (!best) continue;
    require(std::any_of(all.begin(), all.end(), [&](const auto& t) { return t.operations == best->operations; }), "the best tree is a valid one");
    const auto chosen = triples(c, *best);
    for (const auto& t : all) {
      const bool first = t.operations < best->operations;
      if (p == split_preference::convex) {
        require(t.convex_edges() + (first ? 1 : 0) <= best->convex_edges(), "the convex tree has most convex edges");
      } else if (p == split_preference::reflex) {
        require(t.reflex_edges() + (first ? 1 : 0) <= best->reflex_edges(), "the reflex tree has most reflex edges");
      } else {
        const sign order = k.compare_volume(chosen, triples(c, t)) * signed_if(p == split_preference::min_volume);
        require(order == sign::negative || (order == sign::zero && !first), "the tree of extreme volume has it");
      }
    }
  }
  if (e.law(volumes)) check_volumes(k, c, all);
  if (e.law(chosen_trees)) check_chosen(k, c, s, all);
  return all.size();
}

void run(decoder d) {
  const effort e(d);
  const unsigned mode = d.byte();
  const auto rays = decode_rays(d, e.small());
  const auto c = make_cone(rays);
  if (!c) {
    tally::add("neighbours are coplanar");
    return;
  }
  if (majority(c->corner)) {
    tally::add("majority");
    return;
  }
  const std::span<const moving_plane<integer>> p(c->planes);
  std::size_t number = 0;
  if (e.law(embedding) && c->corner.degree() <= 7 && !c->repeated) check_embedding(rays, *c, make_rational_kernel(p));
  if (mode % 4 == 1)
    number = check(e, perturbed(make_sqrt_kernel(p)), *c);
  else if (mode % 4 == 2)
    number = check(e, perturbed(filtered(p, make_rational_kernel(p))), *c);
  else
    number = check(e, perturbed(filtered(p, make_sqrt_kernel(p)), mode % 4 == 3), *c);
  tally::add(number == 0 ? "no valid split" : number == 1 ? "one valid split" : "many valid splits");
  if (c->collinear) tally::add("(with three planes through an edge)");
  if (c->repeated) tally::add("(with a repeated plane)");
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder({data, size}));
  return 0;
}
