// SPDX-License-Identifier: MIT

/// \file
/// Laws of the offset solids P(t), read off the skeleton and checked by brute force in rationals.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "laws.hpp"

namespace osteon::properties {
namespace {

// Times between two moments, as places in the list of moments: shrinks towards the beginning.
using choice = std::vector<long>;
rc::Gen<choice> choices(std::size_t n) { return rc::gen::container<choice>(n, gen::between(0, 999)); }

// A short number in the interval number `c` (modulo their number).
rational time_in(const std::vector<rational>& moments, long c) {
  const std::size_t i = static_cast<std::size_t>(c) % (moments.size() - 1);
  return simple_between(moments[i], moments[i + 1]);
}

// ---- no self-intersection

// Whether plane f passes through an end of edge e, as it does through both where the edge bounds facet f.
bool touches(const placed_skeleton& s, const offset_solid& p, int e, plane_id f) {
  for (const int v : p.edges[e].ends) {
    const auto& planes = s.raw.arcs[p.vertices[v].arc].planes;
    if (std::count(planes.begin(), planes.end(), f) > 0) return true;
  }
  return false;
}

// Two facets that meet where they should not do so along a segment, an end of which lies on an edge of one of them: so it is enough to
// look at all edges and all facets that they do not bound. Planes are met at most once by an edge; if an end lies there, that is all.
std::string does_not_intersect_itself(const placed_skeleton& s, const rational& t) {
  const offset_solid p(s, t);
  const auto area = area_vectors(s, t);
  for (const auto& [f, edges] : p.facets)
    if (dot(area[f], p.planes.n(f)) <= 0) return "a facet looks outwards: facet " + std::to_string(f);
  for (int e = 0; e < static_cast<int>(p.edges.size()); ++e)
    for (const auto& [f, edges] : p.facets) {
      if (touches(s, p, e, f)) continue;
      if (p.pierced(f, p.end(e, 0), p.end(e, 1)))
        return "at time " + t.str() + " an edge between facets " + std::to_string(p.edges[e].facets[0]) + " and " +
               std::to_string(p.edges[e].facets[1]) + " meets facet " + std::to_string(f);
    }
  return "";
}

RC_GTEST_PROP(offsets, do_not_intersect_themselves, ()) {
  const auto o = *gen::any_options();
  const auto s = *gen::unweighted_general(o);
  const auto times = *choices(4);
  for_every_kernel(
      s,
      [&](const placed_skeleton& p) -> std::string {
        const auto moments = p.moments();
        for (const long c : times)
          if (auto broken = does_not_intersect_itself(p, time_in(moments, c)); !broken.empty()) return broken;
        // Just after the start: the splits. Just after the first events.
        return does_not_intersect_itself(p, simple_between(moments[0], moments[1]));
      },
      o);
}

// ---- nested

std::string lies_inside(const placed_skeleton& s, const rational& early, const rational& late) {
  const offset_solid outer(s, early);
  const offset_solid inner(s, late);
  const auto meet = [](const offset_solid& edges, const offset_solid& facets) {
    for (int e = 0; e < static_cast<int>(edges.edges.size()); ++e)
      for (const auto& [f, list] : facets.facets)
        if (facets.pierced(f, edges.end(e, 0), edges.end(e, 1))) return true;
    return false;
  };
  const std::string when = " at times " + early.str() + " and " + late.str();
  for (const auto& v : inner.vertices)
    if (!outer.contains(v.point)) return "a vertex of the later offset lies outside the earlier one" + when;
  if (meet(inner, outer) || meet(outer, inner)) return "two offsets meet" + when;
  return "";
}

RC_GTEST_PROP(offsets, are_nested, ()) {
  const auto o = *gen::any_options();
  const auto s = *gen::unweighted_general(o);
  const auto times = *choices(3);
  for_every_kernel(
      s,
      [&](const placed_skeleton& p) -> std::string {
        const auto moments = p.moments();
        std::vector<rational> t;
        for (const long c : times) t.push_back(time_in(moments, c));
        std::sort(t.begin(), t.end());
        for (std::size_t i = 1; i < t.size(); ++i)
          if (t[i - 1] != t[i])
            if (auto broken = lies_inside(p, t[i - 1], t[i]); !broken.empty()) return broken;
        return "";
      },
      o);
}

// ---- volume and area

// A polynomial by its coefficients, from its values.
using polynomial = std::array<rational, 4>;

rational value(const polynomial& p, const rational& t) { return p[0] + t * (p[1] + t * (p[2] + t * p[3])); }
polynomial derivative(const polynomial& p) { return {p[1], 2 * p[2], 3 * p[3], 0}; }

polynomial interpolate(const std::array<rational, 4>& t, const std::array<rational, 4>& v) {
  polynomial sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    polynomial basis = {1, 0, 0, 0};
    rational scale = 1;
    std::size_t degree = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == i) continue;
      for (std::size_t k = ++degree; k > 0; --k) basis[k] = basis[k - 1] - t[j] * basis[k];
      basis[0] = -t[j] * basis[0];
      scale *= t[i] - t[j];
    }
    for (std::size_t k = 0; k < 4; ++k) sum[k] += v[i] / scale * basis[k];
  }
  return sum;
}

struct piece {
  polynomial volume;
  bool exact;  ///< V' = -(weighted area) at four places: both are polynomials of degree at most 3, so everywhere
};

piece volume_between(const placed_skeleton& s, const rational& from, const rational& to) {
  std::array<rational, 4> t;
  t[0] = simple_between(from, to);
  t[1] = simple_between(t[0], to);
  t[2] = simple_between(from, t[0]);
  t[3] = simple_between(t[1], to);
  std::array<measures, 4> m;
  std::array<rational, 4> v;
  for (std::size_t i = 0; i < 4; ++i) {
    m[i] = measure(s, t[i]);
    v[i] = m[i].volume;
  }
  piece p{interpolate(t, v), true};
  const polynomial slope = derivative(p.volume);
  for (std::size_t i = 0; i < 4; ++i) p.exact = p.exact && value(slope, t[i]) == -m[i].weighted_area;
  return p;
}

// Between two moments V is a cubic whose derivative is minus the weighted area; at an event it changes by a multiple of (t - tau)^3, the
// tetrahedron; it begins with the solid's volume and ends with 0.
std::string volume_shrinks_by_the_area(const placed_skeleton& s, const choice& where, bool generic) {
  const auto moments = s.moments();
  const std::size_t last = moments.size() - 1;
  if (value(volume_between(s, moments[0], moments[1]).volume, 0) != input_volume(s)) return "the offset's volume begins with the solid's";
  for (const long c : where) {
    const std::size_t i = 1 + static_cast<std::size_t>(c) % last;  // around moment i
    const piece before = volume_between(s, moments[i - 1], moments[i]);
    const piece after = i == last ? piece{{0, 0, 0, 0}, true} : volume_between(s, moments[i], moments[i + 1]);
    if (!before.exact || !after.exact) return "the volume's derivative is minus the weighted area next to time " + moments[i].str();
    polynomial v = before.volume;
    polynomial w = after.volume;
    for (int order = 0; order < (generic ? 3 : 1); ++order) {
      if (value(v, moments[i]) != value(w, moments[i]))
        return "the volume's derivative of order " + std::to_string(order) + " is continuous at time " + moments[i].str();
      v = derivative(v);
      w = derivative(w);
    }
  }
  return "";
}

RC_GTEST_PROP(offsets, volume_shrinks_by_the_weighted_area, ()) {
  const auto s = *rc::gen::oneOf(gen::unweighted(), gen::unweighted(), gen::weighted(gen::convex()), gen::weighted(gen::stars()));
  const auto where = *choices(5);
  const auto o = *gen::any_options();
  const bool generic = in_general_position(*s.solid, o);
  RC_CLASSIFY(generic, "general position");
  for_every_kernel(
      s, [&](const placed_skeleton& p) { return volume_shrinks_by_the_area(p, where, generic); }, o);
}

}  // namespace
}  // namespace osteon::properties
