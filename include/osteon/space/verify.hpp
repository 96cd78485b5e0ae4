// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate of a skeleton (docs/theory/skeleton-and-certificate.md). It does not repeat the
/// computation, and has in common with it only the definition of a facet from nowhere
/// (core/local_events.hpp). It asks the kernel whether the complex that is there is a skeleton of
/// the solid.
///
/// Why the rules suffice. Let u_i(x) be the time at which plane i passes the point x. Around a node
/// the u of its four planes, up to a common summand, are coordinates of space, and the cells are
/// determined by the order of the u.
///  1. `link`: at every node the arcs and sheets are those of one monotone function F of four bits
///     ("not yet passed"): x belongs to the cell at whose plane's passing F falls from 1 to 0. So
///     cells fill the sphere of directions once.
///  2. `border`: every sheet's border is closed over arcs and the solid's edges, and the edges are
///     those of the solid; so every cell's surface is closed, its floor being the facet.
///  3. `overlap`: along the line of every triple of planes, the sheets of each pair lie where their
///     arcs say, once, and two sheets of one cell never cross. So every cell's surface is embedded.
///  4. `floor`: every part of a cell's surface touches the facet. So its inside is the inside
///     everywhere.
/// The cells' indicators then add up to that of the solid (sheets cancel), each is 0 or 1, and the
/// cells are a partition; their volumes add up to the solid's. Cells are monotone (thesis 3.1.1) by
/// 1 and 3, for unit speeds: where a perpendicular of the facet leaves the cell it meets a convex
/// sheet, where it enters a reflex one.
///  5. `nowhere`: no event makes a facet out of nothing, which makes the partition a skeleton.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/certificate.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/skeleton.hpp"
#include "osteon/space/verify_link.hpp"
#include "osteon/space/verify_overlap.hpp"
#include "osteon/space/verify_structure.hpp"
#include "osteon/space/verify_surface.hpp"

namespace osteon {

/// Returns the first rule that a raw skeleton of a solid breaks, or nothing: the skeleton is
/// certified. Exact, for unit and other weights.
/// *Requires* a kernel with the solid's planes that never answers zero for different planes
/// (perturbed<K>).
/// *Throws* degenerate_error where the kernel answers zero. No skeleton, however wrong, makes it
/// fail otherwise.
/// *Complexity* about the sum over cells of the squared number of their sheets.
template <kernel<3> K>
std::optional<refutation> verify(const K& k, const boundary& solid, const skeleton& s) {
  try {
    certificate::structure_check(solid, s).run();
    const auto moments = certificate::check_order(k, s);
    certificate::incidence_check<K>(k, solid, s).run();
    certificate::check_borders(solid, s);
    certificate::link_check<K>(k, solid, s, moments).run();
    certificate::overlap_check<K>(k, solid, s, moments).run();
    certificate::check_floors(s);
  } catch (const refutation& r) {
    return r;
  }
  return std::nullopt;
}

/// Returns where a contracted skeleton differs from the contraction of a certified raw one, or
/// nothing.
/// *Requires* a kernel with the solid's planes.
template <contracting_kernel<3> K>
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

}  // namespace osteon
