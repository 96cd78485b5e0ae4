// SPDX-License-Identifier: MIT

/// \file
/// The skeleton does not depend on where the solid lies, how large it is, or how its points and facets are numbered. In general position even
/// the raw skeletons correspond, node by node.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "laws.hpp"

namespace osteon::properties {
namespace {

// A rotation by the quaternion q (times |q|^2, which makes it integer), mirrored or not, a translation, and new numbers.
struct image {
  specimen made;
  std::vector<int> facet_of;  // by facet of the original: the image's
  std::vector<int> point_of;
};

vector3 rotated(const std::array<long, 4>& q, const vector3& x) {
  const auto& [a, b, c, d] = q;
  const std::array<std::array<long, 3>, 3> m = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                                                 {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                                                 {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
  vector3 y = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) y[i] += m[i][j] * x[j];
  return y;
}

// The order of random keys.
std::vector<int> permutation(std::size_t n, const std::vector<long>& keys) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return keys[static_cast<std::size_t>(a) % keys.size()] < keys[static_cast<std::size_t>(b) % keys.size()]; });
  return order;
}

image image_of(const specimen& s, const std::array<long, 4>& q, bool mirror, const models::point& shift, const std::vector<long>& keys) {
  image result;
  input_mesh<integer> m;
  const std::vector<int> points = permutation(s.input.points.size(), keys);
  const std::vector<int> facets = permutation(s.input.facets.size(), keys);
  result.point_of.resize(points.size());
  result.facet_of.resize(facets.size());
  for (const int p : points) {
    result.point_of[p] = static_cast<int>(m.points.size());
    vector3 x;
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = rational(s.input.points[p][axis].mantissa);
    x = rotated(q, x);
    if (mirror) x[0] = -x[0];
    auto& y = m.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) y[axis].mantissa = numerator(x[axis]) + shift[axis];
  }
  for (const int f : facets) {
    result.facet_of[f] = static_cast<int>(m.facets.size());
    auto loop = s.input.facets[f];
    if (mirror) std::reverse(loop.begin(), loop.end());
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(keys[0]) % loop.size()), loop.end());
    for (int& p : loop) p = result.point_of[p];
    m.facets.push_back(loop);
  }
  result.made = specimen_of("image", std::move(m));
  return result;
}

// Empty where raw skeleton b is that of the image of a's solid.
std::string correspondence(const solid<integer>& original, const skeleton& a, const image& to, const skeleton& b) {
  if (a.nodes.size() != b.nodes.size() || a.arcs.size() != b.arcs.size() || a.sheets.size() != b.sheets.size()) return "counts differ";
  const solid<integer>& moved = *to.made.solid;
  std::vector<plane_id> plane_to(original.planes.size(), -1);
  for (std::size_t f = 0; f < original.facet_planes.size(); ++f) plane_to[original.facet_planes[f]] = moved.facet_planes[to.facet_of[f]];
  std::vector<int> vertex_at(to.point_of.size(), -1);
  for (std::size_t v = 0; v < moved.input_points.size(); ++v) vertex_at[moved.input_points[v]] = static_cast<int>(v);
  const auto planes_to = [&](auto planes) {
    for (plane_id& p : planes) p = plane_to[p];
    std::sort(planes.begin(), planes.end());
    return planes;
  };
  std::vector<int> node_to;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const auto& n = a.nodes[i];
    if (n.vertex >= 0) {
      node_to.push_back(vertex_at[to.point_of[original.input_points[n.vertex]]]);
      continue;
    }
    const auto& m = b.nodes[i];  // the same order of events
    if (m.vertex >= 0 || m.planes != planes_to(n.planes) || m.event != n.event || m.ambiguous != n.ambiguous)
      return "event " + std::to_string(i) + " has another image";
    node_to.push_back(static_cast<int>(i));
  }
  std::map<std::tuple<int, int, triple>, int> arcs;
  for (std::size_t i = 0; i < b.arcs.size(); ++i) arcs.emplace(std::tuple(b.arcs[i].source, b.arcs[i].target, b.arcs[i].planes), static_cast<int>(i));
  std::vector<int> arc_to;
  for (std::size_t i = 0; i < a.arcs.size(); ++i) {
    const auto& x = a.arcs[i];
    const auto found = arcs.find({node_to[x.source], node_to[x.target], planes_to(x.planes)});
    if (found == arcs.end()) return "arc " + std::to_string(i) + " has no image";
    arc_to.push_back(found->second);
  }
  if (std::set<int>(arc_to.begin(), arc_to.end()).size() != arc_to.size()) return "two arcs have one image";
  // By polygon: which of two collinear edges goes on when they merge is a matter of numbering.
  using description = std::pair<std::array<plane_id, 2>, std::multiset<int>>;
  const auto polygons = [](const skeleton& x, const auto& facets, const auto& arc) {
    std::map<int, description> by_polygon;
    for (const auto& sheet : x.sheets) {
      auto& [names, border] = by_polygon[sheet.representative];
      names = facets(sheet.facets);
      for (const int i : sheet.arcs) border.insert(arc(i));
    }
    std::multiset<description> result;
    for (const auto& [id, d] : by_polygon) result.insert(d);
    return result;
  };
  const auto images = polygons(a, planes_to, [&](int i) { return arc_to[i]; });
  const auto sheets = polygons(
      b, [](const auto& f) { return f; }, [](int i) { return i; });
  return images == sheets ? "" : "the polygons of sheets differ";
}

// Among trees with equally many convex edges the numbering decides; volumes differ in general position.
rc::Gen<skeleton_options> by_volume() {
  return rc::gen::map(gen::any_options(), [](skeleton_options o) {
    const bool least = o.prefer == split_preference::reflex || o.prefer == split_preference::min_volume;
    o.prefer = least ? split_preference::min_volume : split_preference::max_volume;
    return o;
  });
}

RC_GTEST_PROP(invariance, raw_skeletons_correspond, ()) {
  const auto o = *by_volume();
  const auto s = *rc::gen::oneOf(gen::unweighted_general(o), gen::general(gen::rings(), o));  // rings have many saddles
  RC_TAG(s.kind);
  auto q = *rc::gen::container<std::array<long, 4>>(gen::within(3));
  if (q == std::array<long, 4>{0, 0, 0, 0}) q[0] = 1;
  const auto mirror = *rc::gen::arbitrary<bool>();
  const auto shift = *gen::point_within(1000);
  const auto keys = *rc::gen::container<std::vector<long>>(32, gen::between(0, 1000));
  const image to = image_of(s, q, mirror, shift, keys);
  if (to.made.solid == nullptr) RC_FAIL("the image of a solid is a solid");
  const auto before = run_all(*s.solid, o);
  RC_CLASSIFY(before[0].raw.ambiguous > 0, "with a saddle");
  const auto after = run_all(*to.made.solid, o);
  for (std::size_t k = 0; k < before.size(); ++k)
    require(before[k].kernel, [&] { return correspondence(*s.solid, before[k].raw, to, after[k].raw); });
}

// Degenerate or not: the volume of P(t) over time is the same function up to the scale |q|^2, since the perturbation vanishes in the limit.
// Where a solid has several skeletons the numbering may choose another one; convex solids have one.
RC_GTEST_PROP(invariance, convex_offsets_keep_their_volume, ()) {
  const auto s = *gen::convex();
  RC_TAG(s.kind);
  auto q = *rc::gen::container<std::array<long, 4>>(gen::within(2));
  if (q == std::array<long, 4>{0, 0, 0, 0}) q[0] = 1;
  const auto keys = *rc::gen::container<std::vector<long>>(32, gen::between(0, 1000));
  const rational scale = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  // Speeds are rounded relative to each plane's own equation; only rational lengths are compared exactly.
  const image to = image_of(s, q, false, {0, 0, 0}, keys);
  if (to.made.solid == nullptr) RC_FAIL("the image of a solid is a solid");
  const run before = run_rational(s.solid->planes, s.solid->boundary)[0];
  const run after = run_rational(to.made.solid->planes, to.made.solid->boundary)[0];
  require(before.kernel, [&]() -> std::string {
    const placed_skeleton a(*s.solid, before);
    const placed_skeleton b(*to.made.solid, after);
    const rational end = a.moments().back();
    const rational image_end = b.moments().back();
    const rational error = abs(rational(image_end - scale * end)) / image_end;
    if (error > rational(1, integer(1) << 40)) return "the skeleton ends at another time";
    for (const int part : {1, 2, 3}) {
      const rational t = part * end / 4;
      const rational v = measure(a, t).volume * scale * scale * scale;
      const rational w = measure(b, t * scale).volume;
      if (abs(rational(v - w)) > input_volume(b) / rational(integer(1) << 40)) return "an offset has another volume";
    }
    return "";
  });
}

}  // namespace
}  // namespace osteon::properties
