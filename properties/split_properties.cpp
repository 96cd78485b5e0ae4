// SPDX-License-Identifier: MIT

/// \file
/// Laws of the ways to split a vertex of degree k: there are Catalan(k - 2) trees, each is a tree, and the valid ones are those whose offset
/// surface does not intersect itself, which is found out here once more, by brute force in rationals.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "laws.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"

namespace osteon::properties {
namespace {

using diagonals = std::vector<std::pair<int, int>>;

std::uint64_t catalan_by_recurrence(int n) {
  std::vector<std::uint64_t> c = {1};
  for (int m = 1; m <= n; ++m) {
    c.push_back(0);
    for (int i = 0; i < m; ++i) c.back() += c[static_cast<std::size_t>(i)] * c[static_cast<std::size_t>(m - 1 - i)];
  }
  return c.back();
}

TEST(splits, trees_are_counted_by_catalan_numbers) {
  for (int k = 4; k <= 11; ++k) {
    std::set<diagonals> seen;
    diagonals previous;
    for_each_triangulation(k, [&](std::span<const std::pair<int, int>> given) {
      const diagonals d(given.begin(), given.end());
      EXPECT_EQ(static_cast<int>(d.size()), k - 3);
      EXPECT_TRUE(previous < d);
      previous = d;
      seen.insert(d);
    });
    EXPECT_EQ(seen.size(), catalan_by_recurrence(k - 2));
    EXPECT_EQ(catalan(k - 2), catalan_by_recurrence(k - 2));
  }
}

// ---- trees

std::string is_tree(const corner& c, const split_tree& t) {
  const int k = c.degree();
  const auto inner = std::count_if(t.edges.begin(), t.edges.end(), [](const split_edge& e) { return e.rays[0] < 0; });
  if (static_cast<int>(t.vertices.size()) != k - 2) return "a split has k - 2 vertices";
  if (inner != k - 3 || static_cast<int>(t.edges.size()) != 2 * k - 3) return "a split has k - 3 inner edges and k rays";
  std::vector<std::vector<int>> ends(t.edges.size());
  for (std::size_t v = 0; v < t.vertices.size(); ++v)
    for (std::size_t r = 0; r < 3; ++r) {
      const auto& e = t.edges[static_cast<std::size_t>(t.vertex_edges[v][r])];
      const std::set<int> between = {t.vertices[v][(r + 1) % 3], t.vertices[v][(r + 2) % 3]};
      if (between != std::set<int>{e.a, e.b}) return "the edge opposite a facet lies between the two others";
      ends[static_cast<std::size_t>(t.vertex_edges[v][r])].push_back(static_cast<int>(v));
    }
  for (std::size_t e = 0; e < t.edges.size(); ++e)
    if (ends[e].size() != (t.edges[e].rays[0] < 0 ? 2U : 1U)) return "an inner edge has two ends, a ray one";
  // The vertices of a facet (of all facets: -1) and the inner edges between them: connected, and of a facet a path.
  for (int f = -1; f < k; ++f) {
    std::vector<int> group(t.vertices.size());
    std::iota(group.begin(), group.end(), 0);
    std::vector<int> degree(t.vertices.size(), 0);
    long vertices = 0;
    for (const auto& v : t.vertices) vertices += f < 0 || std::count(v.begin(), v.end(), f) > 0 ? 1 : 0;
    long joined = 0;
    for (std::size_t e = 0; e < t.edges.size(); ++e) {
      if (t.edges[e].rays[0] >= 0 || (f >= 0 && t.edges[e].a != f && t.edges[e].b != f)) continue;
      for (const int v : ends[e]) ++degree[static_cast<std::size_t>(v)];
      const int from = group[static_cast<std::size_t>(ends[e][0])];
      const int to = group[static_cast<std::size_t>(ends[e][1])];
      if (from == to) return "a split has no cycle";
      std::replace(group.begin(), group.end(), from, to);
      ++joined;
    }
    if (joined != vertices - 1) return f < 0 ? "a split is connected" : "the chain of a facet is connected";
    if (f >= 0 && *std::max_element(degree.begin(), degree.end()) > 2) return "the chain of a facet is a path";
  }
  return "";
}

// ---- validity by brute force

// A corner in rationals: planes n . x = -sigma at time 1 around the origin, and the directions of its edges.
struct exact_corner {
  std::vector<half_space> planes;
  std::vector<vector3> rays;  // rays[m] between facets m and m + 1
};

exact_corner exact_corner_at(const solid<integer>& s, int v) {
  const moving_planes planes(s.planes);
  const auto& vertex = s.boundary.vertices[v];
  const auto at = [&](int p) { return vector3{rational(s.points[p][0]), rational(s.points[p][1]), rational(s.points[p][2])}; };
  exact_corner c;
  for (const plane_id p : vertex.facets) c.planes.push_back({planes.n(p), -planes.speed(p)});
  for (const int e : vertex.edges) {
    const auto& ends = s.boundary.edges[e].ends;
    c.rays.push_back(at(ends[ends[0] == v ? 1 : 0]) - at(v));
  }
  return c;
}

class surface {
 public:
  // The tree of a triangulation; `sound` is false where three planes do not meet.
  surface(const exact_corner& c, std::span<const std::pair<int, int>> given) : c_(c), k_(static_cast<int>(c.planes.size())) {
    std::set<std::pair<int, int>> edges(given.begin(), given.end());
    for (int m = 0; m < k_; ++m) edges.insert(std::minmax({m, (m + 1) % k_}));
    const auto joined = [&](int a, int b) { return edges.contains(std::minmax({a, b})); };
    for (int a = 0; a < k_; ++a)
      for (int b = a + 1; b < k_; ++b)
        for (int d = b + 1; d < k_; ++d)
          if (joined(a, b) && joined(b, d) && joined(a, d)) sound = add_vertex({a, b, d}) && sound;
    if (sound) make_facets();
  }

  bool sound = true;

  bool intersects_itself() const {
    for (const edge& e : edges_)
      for (int f = 0; f < k_; ++f) {
        if (e.facets.contains(f)) continue;  // its two facets, and those at its ends
        const auto& plane = c_.planes[static_cast<std::size_t>(f)];
        const rational hx = plane.d - dot(plane.n, e.from);
        const rational hy = plane.d - dot(plane.n, e.to);
        if ((hx > 0 && hy > 0) || (hx < 0 && hy < 0) || hx == hy) continue;
        if (contains(f, e.from + (hx / (hx - hy)) * (e.to - e.from))) return true;
      }
    return false;
  }

 private:
  struct edge {
    std::set<int> facets;
    vector3 from, to;
  };

  bool add_vertex(const std::array<int, 3>& t) {
    const auto& p = c_.planes[static_cast<std::size_t>(t[0])];
    const auto& q = c_.planes[static_cast<std::size_t>(t[1])];
    const auto& r = c_.planes[static_cast<std::size_t>(t[2])];
    const rational whole = det(p.n, q.n, r.n);
    if (whole == 0) return false;
    triangles_.push_back(t);
    points_.push_back((1 / whole) * (p.d * cross(q.n, r.n) + q.d * cross(r.n, p.n) + r.d * cross(p.n, q.n)));
    return true;
  }

  // Rays are cut off so far away that nothing happens beyond.
  vector3 far(const vector3& from, const vector3& direction) const {
    rational size = 1;
    for (const vector3& p : points_)
      for (const rational& x : p) size = std::max(size, rational(abs(x)));
    rational length = 0;
    for (const rational& x : direction) length += abs(x);
    return from + (1'000'000'000 * size / length) * direction;
  }

  void make_facets() {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t u = t + 1; u < triangles_.size(); ++u) {
        std::set<int> all(triangles_[t].begin(), triangles_[t].end());
        all.insert(triangles_[u].begin(), triangles_[u].end());
        if (all.size() == 4) edges_.push_back({all, points_[t], points_[u]});
      }
    for (int m = 0; m < k_; ++m) {
      const std::size_t t = triangle_of(m, (m + 1) % k_);
      edges_.push_back({{triangles_[t].begin(), triangles_[t].end()}, points_[t], far(points_[t], c_.rays[static_cast<std::size_t>(m)])});
    }
    for (int f = 0; f < k_; ++f) {
      const auto before = static_cast<std::size_t>((f + k_ - 1) % k_);
      const auto after = static_cast<std::size_t>(f);
      // From the ray before counter-clockwise through the facet to the ray after; the chain back from there.
      auto& ring = facets_.emplace_back();
      int neighbour = (f + 1) % k_;
      ring.push_back(far(points_[triangle_of(f, neighbour)], c_.rays[after]));
      while (neighbour != static_cast<int>(before)) {
        const std::size_t t = triangle_of(f, neighbour);
        ring.push_back(points_[t]);
        neighbour = *std::find_if(triangles_[t].begin(), triangles_[t].end(), [&](int x) { return x != f && x != neighbour; });
      }
      ring.push_back(far(points_[triangle_of(f, static_cast<int>(before))], c_.rays[before]));
      const vector3& n = c_.planes[after].n;
      const rational turn = det(n, c_.rays[before], c_.rays[after]);
      if (turn <= 0) {  // half a turn or more: around the far side
        const vector3 middle = turn == 0 ? cross(n, c_.rays[before]) : rational(-1) * (unit(c_.rays[before]) + unit(c_.rays[after]));
        ring.push_back(far({0, 0, 0}, middle));
      }
    }
  }

  static vector3 unit(const vector3& x) { return (1 / rational(abs(x[0]) + abs(x[1]) + abs(x[2]))) * x; }

  // The triangle on facets a and b: of a side of the polygon of facets the only one, of a diagonal the one whose third corner comes after b,
  // counter-clockwise from a.
  std::size_t triangle_of(int a, int b) const {
    std::size_t best = triangles_.size();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& all = triangles_[t];
      if (std::count(all.begin(), all.end(), a) == 0 || std::count(all.begin(), all.end(), b) == 0) continue;
      const int third = *std::find_if(all.begin(), all.end(), [&](int x) { return x != a && x != b; });
      const bool after = (third - a + k_) % k_ > (b - a + k_) % k_;
      if (after || best == triangles_.size()) best = t;
    }
    return best;
  }

  bool contains(int f, const vector3& x) const {
    const auto [u, v] = offset_solid::kept_axes(c_.planes[static_cast<std::size_t>(f)].n);
    const auto& ring = facets_[static_cast<std::size_t>(f)];
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const vector3& a = ring[i];
      const vector3& b = ring[(i + 1) % ring.size()];
      const rational turn = (b[u] - a[u]) * (x[v] - a[v]) - (b[v] - a[v]) * (x[u] - a[u]);
      if (turn == 0 && dot(x - a, x - b) <= 0) return true;
      if ((a[v] > x[v]) != (b[v] > x[v]) && (turn > 0) == (b[v] > a[v])) inside = !inside;
    }
    return inside;
  }

  const exact_corner& c_;
  int k_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<vector3> points_;
  std::vector<edge> edges_;
  std::vector<std::vector<vector3>> facets_;
};

std::vector<diagonals> valid_by_brute_force(const exact_corner& c) {
  std::vector<diagonals> result;
  for_each_triangulation(static_cast<int>(c.planes.size()), [&](std::span<const std::pair<int, int>> d) {
    const surface s(c, d);
    if (s.sound && !s.intersects_itself()) result.emplace_back(d.begin(), d.end());
  });
  return result;
}

// ---- laws of one corner

std::vector<diagonals> names(const std::vector<split_tree>& trees) {
  std::vector<diagonals> result;
  for (const auto& t : trees) result.push_back(t.operations);
  return result;
}

std::vector<triple> planes_of(const corner& c, const split_tree& t) {
  std::vector<triple> result;
  for (const auto& v : t.vertices)
    result.push_back({c.facets[static_cast<std::size_t>(v[0])], c.facets[static_cast<std::size_t>(v[1])], c.facets[static_cast<std::size_t>(v[2])]});
  return result;
}

template <kernel<3> K>
std::optional<split_tree> searched_best(const splitter<K>& split, split_preference prefer) {
  const auto accepts = [&split](const diagonals& d) { return split.valid(*split.tree(d)); };
  const bool counts = prefer == split_preference::convex || prefer == split_preference::reflex;
  const bool greatest = prefer == split_preference::max_volume;
  const searched_split found = counts ? split_search<K, edge_count>(split.signs(), edge_count(prefer == split_preference::convex)).best(accepts)
                                      : split_search<K, offset_volume<K>>(split.signs(), offset_volume<K>(split.signs(), greatest)).best(accepts);
  return found.end == search_end::best ? split.tree(found.tree) : std::nullopt;
}

template <kernel<3> K>
std::string corner_laws(const K& k, const corner& c, std::vector<diagonals>& valid) {
  const splitter<K> split(k, c);
  const auto candidates = split.candidates();
  for (const split_tree& t : candidates)
    if (auto broken = is_tree(c, t); !broken.empty()) return broken;
  const auto all = split.all();
  valid = names(all);
  const auto possible = names(candidates);
  if (valid.empty()) return "a vertex has a valid split";
  if (!std::is_sorted(valid.begin(), valid.end()) || !std::includes(possible.begin(), possible.end(), valid.begin(), valid.end()))
    return "valid trees are among those that obey the local rule";
  const auto convex_edges = std::count(c.convex.begin(), c.convex.end(), true);
  if ((convex_edges == c.degree() || convex_edges == 0) && valid.size() != 1) return "a convex or reflex corner has one valid split";
  if (convex_edges == c.degree() || convex_edges == 0)
    if (only_split(k, c) != valid.front()) return "the fast way to split a convex or reflex corner finds its valid split";
  split_search<K, edge_count, std::uint64_t> search(split.signs(), edge_count(true));
  std::vector<diagonals> searched;
  search.for_each([&searched](const diagonals& d) {
    searched.push_back(d);
    return false;
  });
  std::sort(searched.begin(), searched.end());
  if (searched != valid) return "the search over intervals finds the valid splits";
  if (search.count() < valid.size() || search.count() > candidates.size()) return "valid splits are among the search's candidates, these among all";
  using enum split_preference;
  for (const auto prefer : {convex, reflex, min_volume, max_volume}) {
    const auto best = split.best(prefer);
    if (const auto other = searched_best(split, prefer)) {
      const sign volumes = k.compare_volume(planes_of(c, *other), planes_of(c, *best));
      if (prefer == convex || prefer == reflex ? other->convex_edges() != best->convex_edges() : volumes != sign::zero)
        return "the search finds a split as good as the preferred one";
    } else {
      return "the search finds a split";
    }
    if (!best || !std::binary_search(valid.begin(), valid.end(), best->operations)) return "the preferred split is valid";
    for (const split_tree& t : all) {
      const bool better = prefer == convex       ? t.convex_edges() > best->convex_edges()
                          : prefer == reflex     ? t.reflex_edges() > best->reflex_edges()
                          : prefer == min_volume ? k.compare_volume(planes_of(c, t), planes_of(c, *best)) == sign::negative
                                                 : k.compare_volume(planes_of(c, t), planes_of(c, *best)) == sign::positive;
      if (better) return "no valid split is better than the preferred one";
    }
  }
  return "";
}

template <class Visit>
void for_each_high_vertex(const solid<integer>& s, std::size_t greatest, Visit visit) {
  for (int v = 0; v < static_cast<int>(s.boundary.vertices.size()); ++v) {
    const auto& f = s.boundary.vertices[v].facets;
    if (f.size() > 3 && f.size() <= greatest && std::set<plane_id>(f.begin(), f.end()).size() == f.size()) visit(v);
  }
}

rc::Gen<specimen> high_corners() {
  return gen::general(rc::gen::oneOf(gen::cones(4), gen::cones(4, 7), gen::stars(), gen::landscapes(), gen::hulls(1000, 8)));
}

RC_GTEST_PROP(splits, are_trees_and_some_are_valid, ()) {
  const auto s = *high_corners();
  RC_TAG(s.kind);
  const auto& planes = s.solid->planes;
  const std::span<const moving_plane<integer>> span(planes);
  const perturbed fast(filtered(span, make_sqrt_kernel(planes)));
  const perturbed slow(make_sqrt_kernel(planes));
  const perturbed fast_rational(filtered(span, make_rational_kernel(planes)));
  const perturbed slow_rational(make_rational_kernel(planes));
  for_each_high_vertex(*s.solid, greatest_degree, [&](int v) {
    const corner c = corner_at(s.solid->boundary, v);
    std::array<std::vector<diagonals>, exact_kernels> valid;
    require("perturbed<filtered<sqrt>>", [&] { return corner_laws(fast, c, valid[0]); });
    require("perturbed<sqrt>", [&] { return corner_laws(slow, c, valid[1]); });
    require("perturbed<filtered<rational>>", [&] { return corner_laws(fast_rational, c, valid[2]); });
    require("perturbed<rational>", [&] { return corner_laws(slow_rational, c, valid[3]); });
    for (const auto& trees : valid) require("all kernels", [&] { return std::string(trees == valid[0] ? "" : "kernels find other valid splits"); });
  });
}

RC_GTEST_PROP(splits, valid_trees_are_those_without_self_intersection, ()) {
  const auto s = *high_corners();
  RC_TAG(s.kind);
  const perturbed k(make_rational_kernel(s.solid->planes));
  for_each_high_vertex(*s.solid, 7, [&](int v) {
    const corner c = corner_at(s.solid->boundary, v);
    require("perturbed<rational>", [&]() -> std::string {
      const auto found = names(splitter(k, c).all());
      const auto truth = valid_by_brute_force(exact_corner_at(*s.solid, v));
      if (found == truth) return "";
      return std::to_string(found.size()) + " valid splits at point " + std::to_string(s.solid->input_points[v] + 1) + ", by brute force " +
             std::to_string(truth.size());
    });
  });
}

}  // namespace
}  // namespace osteon::properties
