// SPDX-License-Identifier: MIT

/// \file
/// The window: ways to split a vertex.

#include "osteon/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "decimals.hpp"
#include "osteon/core/error.hpp"
#include "osteon/evaluate/spherical.hpp"
#include "osteon/evaluate/volume.hpp"
#include "osteon/space/ambiguity.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"
#include "polyhedron_data.hpp"
#include "space_kernels.hpp"
#include "space_run.hpp"

namespace osteon::inspect {
namespace {

using kernel = any_kernel<3>;

kernel default_kernel(const solid<integer>& s, bool mirrored = false) { return make_kernels(s, number_kernel::sqrt, mirrored).perturbed; }

template <class Body>
auto search_of(const kernel& k, const corner& c, Body body) {
  if (c.degree() > greatest_remembered_degree)
    throw unsupported_error("not yet: the trees of a vertex of degree " + std::to_string(c.degree()) + " (at most " +
                            std::to_string(greatest_remembered_degree) + ")");
  const corner_signs<kernel> signs(k, c);
  split_search<kernel, edge_count, integer> search(signs, edge_count(true));
  return body(search);
}

// Up to greatest_split_degree: in the thesis's order, with the trees of both perturbations and with
// vertices at infinity.
void enumerate(const solid<integer>& s, const corner& c, const std::function<bool(const split_tree&, bool)>& visit) {
  std::map<split_tree, bool> trees;  // whether all vertices stay near
  for (const bool mirrored : {false, true}) {
    const kernel k = default_kernel(s, mirrored);
    for (const bool bounded : {false, true})
      for (const auto& t : splitter(k, c, bounded).all()) trees[t.operations] |= bounded;
  }
  for (const auto& [tree, near] : trees)
    if (visit(tree, near)) return;
}

integer product_of(const std::vector<std::uint64_t>& factors) {
  integer product = 1;
  for (const std::uint64_t f : factors) product *= f;
  return product;
}

// A number below n, from as many bits as needed, and again where they are too many.
integer drawn_below(const integer& n, std::mt19937_64& random) {
  for (;;) {
    integer drawn = 0;
    for (unsigned bits = 0; bits <= msb(n); bits += 64) drawn = (drawn << 64U) + random();
    drawn >>= (msb(n) / 64 + 1) * 64 - (msb(n) + 1);
    if (drawn < n) return drawn;
  }
}

spherical_picture picture_of(const spherical_skeleton& sphere, const spherical_picture::vector& eye) {
  spherical_picture picture{eye, sphere.nodes, {}};
  for (const auto& a : sphere.arcs) {
    auto& to = picture.arcs.emplace_back(spherical_picture::arc{a.facets, a.nodes, a.convex, {}});
    for (auto& part : parts_of(a, eye)) to.parts.push_back({part.front, std::move(part.points)});
  }
  return picture;
}

}  // namespace

vertex_splits::vertex_splits(const polyhedron& p, int vertex) : solid_(p), vertex_(vertex) { solid_.degree(vertex); }

int vertex_splits::degree() const { return solid_.degree(vertex_); }
std::vector<int> vertex_splits::planes() const { return solid_.access()->checked.boundary.vertices[vertex_].facets; }
bool vertex_splits::is_whole() const { return degree() == 3 || solid_.access()->checked.boundary.vertices[vertex_].is_majority(); }
bool vertex_splits::is_enumerated() const { return degree() <= greatest_split_degree; }

std::string vertex_splits::trees() const {
  integer c = 1;
  for (int i = 0; i < degree() - 2; ++i) c = c * 2 * (2 * i + 1) / (i + 2);
  return c.str();
}

void vertex_splits::for_each(const std::function<bool(const split_tree&, bool near)>& visit) const {
  if (is_whole()) return;
  const solid<integer>& s = solid_.access()->checked;
  const corner c = corner_at(s.boundary, vertex_);
  if (is_enumerated()) return enumerate(s, c, visit);
  const kernel k = default_kernel(s);
  const splitter trees(k, c);
  const bool different = has_different_planes(c);
  search_of(k, c, [&](auto& search) {
    return search.for_each([&](const split_tree& t) {
      if (!different) {
        const auto tree = trees.tree(t);
        if (!tree || !trees.valid(*tree)) return false;
      }
      return visit(t, true);
    });
  });
}

std::string vertex_splits::candidates() const {
  if (is_whole()) return "1";
  const solid<integer>& s = solid_.access()->checked;
  return search_of(default_kernel(s), corner_at(s.boundary, vertex_), [](const auto& search) { return search.count().str(); });
}

split_count vertex_splits::count() const {
  const solid<integer>& s = solid_.access()->checked;
  const osteon::split_count counted = count_splits(default_kernel(s), s.boundary, vertex_);
  return {product_of(counted.factors).str(), counted.exact};
}

void vertex_splits::sample(int number, std::uint64_t seed, const std::function<void(const split_tree&, bool valid)>& visit) const {
  if (is_whole()) return;
  const solid<integer>& s = solid_.access()->checked;
  const corner c = corner_at(s.boundary, vertex_);
  const kernel k = default_kernel(s);
  const splitter trees(k, c);
  std::mt19937_64 random(seed);
  search_of(k, c, [&](const auto& search) {
    for (int n = 0; n < number && search.count() != 0; ++n) {
      const split_tree t = search.sample([&random](const integer& below) { return drawn_below(below, random); });
      const auto tree = trees.tree(t);
      visit(t, tree && trees.valid(*tree));
    }
    return true;
  });
}

std::optional<preferred_split> vertex_splits::preferred(split_preference preference) const {
  if (is_whole()) return std::nullopt;
  const solid<integer>& s = solid_.access()->checked;
  auto t = osteon::preferred_split(default_kernel(s), corner_at(s.boundary, vertex_), preference);
  if (!t) return std::nullopt;
  return preferred_split{std::move(t->tree.operations), t->proven};
}

spherical_picture vertex_splits::spherical(split_preference preference, const std::optional<std::array<double, 3>>& eye) const {
  const solid<integer>& s = solid_.access()->checked;
  const corner c = corner_at(s.boundary, vertex_);
  const auto t = is_whole() ? std::nullopt : osteon::preferred_split(default_kernel(s), c, preference);
  if (!t || t->tree.vertices.size() + 2 != c.facets.size())
    throw unsupported_error("not yet: the spherical skeleton of a vertex with several facets in one plane; hint: list its splits with --all");
  const spherical_skeleton sphere = make_spherical_skeleton(s.planes, c, t->tree);
  spherical_picture::vector from{};
  const double longest = eye ? std::max({std::abs((*eye)[0]), std::abs((*eye)[1]), std::abs((*eye)[2])}) : 1;
  for (std::size_t x = 0; x < 3; ++x) {
    if (eye)
      from[x] = (*eye)[x] / longest;
    else
      for (std::size_t m = 0; m < c.facets.size(); ++m) from[x] += sphere.nodes[m][x];
  }
  return picture_of(sphere, from);
}

// ---- all vertices

ambiguity count_ambiguity(const polyhedron& p) {
  const solid<integer>& s = p.access()->checked;
  const kernel k = default_kernel(s);
  ambiguity result;
  integer product = 1;
  result.splits.exact = true;
  for (std::size_t v = 0; v < s.boundary.vertices.size(); ++v) {
    const osteon::split_count counted = count_splits(k, s.boundary, static_cast<int>(v));
    const integer ways = product_of(counted.factors);
    product *= ways;
    result.splits.exact = result.splits.exact && counted.exact;
    if (ways != 1)
      result.vertices.push_back({s.input_points[v], static_cast<int>(s.boundary.vertices[v].facets.size()), {ways.str(), counted.exact}});
  }
  result.splits.valid = product.str();
  result.saddles = raw_skeleton(k, s, {}).ambiguous;
  return result;
}

std::uint64_t explore(const polyhedron& p, const exploration& e, const std::function<void(const explored_skeleton&)>& visit) {
  const solid<integer>& s = p.access()->checked;
  const rational unit = unit_of(s);
  const std::vector<rational> speeds = rounded_speeds(s.planes);
  std::vector<rational> times;
  for (const decimal& t : e.offsets) times.push_back(time_value(t) / unit);
  const kernel k = default_kernel(s);
  std::set<std::vector<quadruple>> seen;
  const std::uint64_t last = e.seed + 20 * static_cast<std::uint64_t>(e.skeletons) + 100;
  std::uint64_t at = e.seed;
  for (; at < last && seen.size() < static_cast<std::size_t>(e.skeletons); ++at) {
    skeleton_options o;
    o.explore = at;
    const skeleton raw = raw_skeleton(k, s, o);
    std::vector<quadruple> nodes;
    for (const auto& n : raw.nodes) nodes.push_back(n.planes);
    std::sort(nodes.begin(), nodes.end());
    if (!seen.insert(std::move(nodes)).second) continue;
    explored_skeleton found{at,
                            static_cast<int>(raw.nodes.size()),
                            static_cast<int>(raw.arcs.size()),
                            static_cast<int>(raw.sheets.size()),
                            std::accumulate(raw.events.begin(), raw.events.end(), 0),
                            raw.ambiguous,
                            {}};
    if (!times.empty()) {
      const rational_offsets volumes(s.planes, raw, speeds);
      for (const rational& t : times) found.volumes.push_back(static_cast<double>(rational(volumes.volume(t) * unit * unit * unit)));
    }
    visit(found);
  }
  return at - e.seed;
}

}  // namespace osteon::inspect
