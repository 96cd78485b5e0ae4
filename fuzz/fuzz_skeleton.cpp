// SPDX-License-Identifier: MIT

// A whole skeleton, under any options and exact kernel: it ends, the certificate holds, filter and base agree, the contraction is a complex, and
// where speeds are rational the offsets' volumes begin with the solid's and fall to zero; voxel solids erode.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "check.hpp"
#include "decode.hpp"
#include "effort.hpp"
#include "gmp_memory.hpp"
#include "osteon/core/error.hpp"
#include "osteon/evaluate/volume.hpp"
#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/verify.hpp"
#include "shapes.hpp"
#include "solid_invariants.hpp"
#include "voxel_erosion.hpp"

namespace osteon::fuzz {
namespace {

// Keeps a run below a second under sanitizers, and most runs at a few milliseconds.
struct size_limits {
  std::size_t facets;  // of what is changed further
  std::size_t edges;
};
constexpr size_limits large = {60, 110};
constexpr size_limits small = {11, 36};
constexpr std::size_t most_degree = 8;

void check_contraction(const boundary& b, const skeleton& raw, const contracted_skeleton& c) {
  const auto is_id = [](int id, const auto& list) { return id >= 0 && static_cast<std::size_t>(id) < list.size(); };
  require(c.cells == b.planes, "every facet has a cell");
  require(c.nodes.size() <= raw.nodes.size(), "a contraction has no new nodes");  // but an arc that others cross becomes several
  std::vector<int> arc_ends(c.nodes.size());
  std::vector<std::vector<int>> arc_sheets(c.sheets.size());
  for (std::size_t i = 0; i < c.arcs.size(); ++i) {
    const auto& a = c.arcs[i];
    require(is_id(a.source, c.nodes) && is_id(a.target, c.nodes), "the ends of an arc are there");
    for (const int n : {a.source, a.target}) {
      const auto& arcs = c.nodes[static_cast<std::size_t>(n)].arcs;
      require(std::find(arcs.begin(), arcs.end(), static_cast<int>(i)) != arcs.end(), "a node knows its arcs");
      ++arc_ends[static_cast<std::size_t>(n)];
    }
    require(a.source != a.target, "an arc has length");
    require(a.cells.size() >= 3 && std::is_sorted(a.cells.begin(), a.cells.end()), "three cells meet at an arc");
    for (const int s : a.sheets) {
      require(is_id(s, c.sheets), "the sheets of an arc are there");
      for (const plane_id f : c.sheets[static_cast<std::size_t>(s)].facets)
        require(std::binary_search(a.cells.begin(), a.cells.end(), f), "a sheet of an arc separates two of its cells");
      arc_sheets[static_cast<std::size_t>(s)].push_back(static_cast<int>(i));
    }
  }
  std::set<int> seen;
  for (std::size_t n = 0; n < c.nodes.size(); ++n) {
    require(static_cast<int>(c.nodes[n].arcs.size()) == arc_ends[n], "a node lists the arcs that end there");
    require(!c.nodes[n].raw.empty(), "a node comes from nodes");
    for (const int r : c.nodes[n].raw) require(is_id(r, raw.nodes) && seen.insert(r).second, "a raw node becomes part of one node");
  }
  for (std::size_t s = 0; s < c.sheets.size(); ++s) {
    const auto& sheet = c.sheets[s];
    require(sheet.facets[0] >= 0 && sheet.facets[0] < sheet.facets[1] && sheet.facets[1] < b.planes, "a sheet separates two cells");
    for (const int r : sheet.raw) require(is_id(r, raw.sheets), "a sheet comes from sheets");
    std::set<int> on_border(arc_sheets[s].begin(), arc_sheets[s].end());
    require(on_border == std::set<int>(sheet.arcs.begin(), sheet.arcs.end()), "sheets and arcs know each other");
  }
}

// Where all speeds are rational.
void check_volumes(const solid<integer>& s, const skeleton& raw, const models::voxels* voxels) {
  std::optional<rational_offsets> offsets;
  try {
    offsets.emplace(s.planes, raw);
  } catch (const unsupported_error&) {
    return;
  }
  tally::add("(with rational speeds)");
  require(offsets->volume(0) * 6 == rational(solid_check(s).volume()), "the first offset is the solid");
  std::vector<rational> times = offsets->times();
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const rational last = times.back();
  require(offsets->volume(last) == 0, "the last offset is empty");
  rational before = offsets->volume(0);
  rational then = 0;
  for (std::size_t i = 1; i <= 4; ++i) {
    const rational event = times[i * (times.size() - 1) / 4];
    const rational t = (event + then) / 2;
    if (t == then) continue;
    const rational v = offsets->volume(t);
    require(v > 0 && v < before, "offsets shrink");
    before = v;
    then = t;
  }
  if (voxels == nullptr) return;
  const rational unit = value({1, s.ten, s.two});
  const auto full = [&](int x, int y, int z) { return (*voxels)(x, y, z); };
  for (const auto& [p, q] : {std::pair(1, 3), std::pair(1, 2), std::pair(3, 4), std::pair(1, 1)}) {
    const rational eroded = rational(oracles::eroded_cells(voxels->size(), full, p, q)) / (q * q * q);
    require(offsets->volume(rational(p, q) / unit) * unit * unit * unit == eroded, "voxels erode");
  }
}

// Whether a third facet of some vertex contains the line of one of its edges: then, and only then, facets may flood edges for ever.
bool may_insert(const solid<integer>& s) {
  for (const auto& v : s.boundary.vertices)
    for (const int e : v.edges) {
      const auto& [p, q] = s.boundary.edges[static_cast<std::size_t>(e)].planes;
      const auto line = cross(s.planes[p].n, s.planes[q].n);
      for (const plane_id r : v.facets)
        if (r != p && r != q && dot(s.planes[r].n, line) == 0) return true;
    }
  return false;
}

template <kernel<3> K>
skeleton certified(const K& k, const solid<integer>& s, const skeleton_options& o) {
  skeleton raw = straight_skeleton(k, s.boundary, o);
  if (const auto r = verify(k, s.boundary, raw))
    broken("certificate: " + std::string(rule_names[static_cast<std::size_t>(r->broken)]) + ": " + r->witness);
  check_contraction(s.boundary, raw, contract(k.base(), s.boundary, raw));
  return raw;
}

void require_same(const skeleton& x, const skeleton& y) {
  require(x.nodes.size() == y.nodes.size() && x.arcs.size() == y.arcs.size() && x.sheets.size() == y.sheets.size() && x.cells == y.cells,
          "a filter changes no count");
  for (std::size_t i = 0; i < x.nodes.size(); ++i)
    require(x.nodes[i].planes == y.nodes[i].planes && x.nodes[i].event == y.nodes[i].event && x.nodes[i].arcs == y.nodes[i].arcs,
            "a filter changes no node");
}

// The laws that are not looked at for every input (effort.hpp).
enum dear_law : unsigned { unfiltered = 1, in_doubles, volumes };

skeleton compute(const effort& e, const solid<integer>& s, const skeleton_options& o, unsigned kernels) {
  const std::span<const moving_plane<integer>> planes(s.planes);
  if (e.law(in_doubles)) {
    try {
      straight_skeleton(make_double_kernel(planes), s.boundary, o);
    } catch (const undecided_error&) {
    } catch (const unsupported_error&) {
    }
  }
  if (kernels == 1) return certified(perturbed(filtered(planes, make_rational_kernel(planes))), s, o);
  const bool mirrored = kernels == 2;
  skeleton raw = certified(perturbed(filtered(planes, make_sqrt_kernel(planes)), mirrored), s, o);
  if (e.law(unfiltered) && s.boundary.edges.size() <= 40)
    require_same(raw, straight_skeleton(perturbed(make_sqrt_kernel(planes), mirrored), s.boundary, o));
  return raw;
}

void run(decoder d) {
  const effort e(d);
  const unsigned plan = d.byte();
  const size_limits& limits = e.small() ? small : large;
  const skeleton_options o = {static_cast<split_preference>(plan & 3U), static_cast<saddle_rule>(plan >> 2U & 3U)};
  decoded shape = decode_shape(d, limits.facets, e.small());
  if (!shape.valid && (plan & 128U) == 0) {  // nearly always only because facets are bent
    try {
      triangulate_facets(shape.mesh);
    } catch (const input_error&) {
    }
  }
  keep(shape.mesh);
  std::optional<solid<integer>> s;
  try {
    s = make_solid(shape.mesh);
  } catch (const input_error&) {
    require(!shape.valid, "a valid mesh is taken");
    tally::add("no solid");
    return;
  }
  std::size_t degree = 0;
  for (const auto& v : s->boundary.vertices) degree = std::max(degree, v.facets.size());
  if (s->boundary.edges.size() > limits.edges || degree > most_degree) {
    tally::add("too large");
    return;
  }

  skeleton raw;
  try {
    raw = compute(e, *s, o, plan >> 4U & 7U);
  } catch (const degenerate_error&) {
    throw;
  } catch (const unsupported_error&) {
    require(may_insert(*s), "a vertex of low degree is split, or flooded");
    tally::add("refused: floods without end");
    return;
  }
  const bool greatest = o.prefer == split_preference::convex && o.saddle == saddle_rule::convex;
  if (e.law(volumes)) check_volumes(*s, raw, shape.voxels && greatest ? &*shape.voxels : nullptr);
  tally::add("a skeleton");
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder({data, size}));
  return 0;
}
