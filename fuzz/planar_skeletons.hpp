// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A planar skeleton with its certificates.

#include <optional>
#include <span>
#include <string>

#include "check.hpp"
#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"
#include "osteon/plane/verify.hpp"

namespace osteon::fuzz {

inline auto planar_kernel_of(const plane::polygon<integer>& p, bool mirrored = false) {
  const std::span<const moving_line<integer>> lines(p.lines);
  return perturbed(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)), mirrored);
}

template <kernel<2> K>
plane::skeleton raw_skeleton(const K& k, const plane::polygon<integer>& p, bool outside) {
  const plane::vertex_enclosures motion(p.lines, p.points, outside);
  plane::skeleton_options o;
  o.outside = outside;
  return plane::propagation(k, p.boundary, motion, o).run();
}

inline void require_holds(const std::optional<plane::refutation>& r, const char* of) {
  if (r) broken(std::string(of) + ": " + std::string(plane::rule_names[static_cast<std::size_t>(r->broken)]) + ": " + r->witness);
}

/// Raw and contracted, both certified. Throws unsupported_error.
struct planar_pair {
  plane::skeleton raw;
  plane::contracted_skeleton exact;
};
template <kernel<2> K>
planar_pair certified(const K& k, const plane::polygon<integer>& p, bool outside) {
  planar_pair s{raw_skeleton(k, p, outside), {}};
  require_holds(plane::verify(k, p.boundary, s.raw, outside, has_stationary_edge(p)), "certificate");
  s.exact = plane::contract(k.base(), p.boundary.line, s.raw);
  require_holds(plane::verify_contraction(k.base(), p.boundary, s.raw, s.exact), "certificate of the contraction");
  return s;
}

}  // namespace osteon::fuzz
