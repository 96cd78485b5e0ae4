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

inline auto planar_kernel_of(const planar::polygon<integer>& p, bool mirrored = false) {
  const std::span<const moving_line<integer>> lines(p.lines);
  return perturbed(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)), mirrored);
}

template <planar::planar_kernel K>
planar::skeleton raw_skeleton(const K& k, const planar::polygon<integer>& p, bool outside) {
  const planar::motion motion(p.lines, p.points, outside);
  planar::options o;
  o.outside = outside;
  return planar::propagation(k, p.outline, motion, o).run();
}

inline void require_holds(const std::optional<planar::refutation>& r, const char* of) {
  if (r) broken(std::string(of) + ": " + std::string(planar::rule_names[static_cast<std::size_t>(r->broken)]) + ": " + r->witness);
}

/// Raw and contracted, both certified. Throws unsupported_error.
struct planar_pair {
  planar::skeleton raw;
  planar::contracted_skeleton exact;
};
template <planar::planar_kernel K>
planar_pair certified(const K& k, const planar::polygon<integer>& p, bool outside) {
  planar_pair s{raw_skeleton(k, p, outside), {}};
  require_holds(planar::verify(k, p.outline, s.raw, outside, has_held_edge(p)), "certificate");
  s.exact = planar::contract(k.base(), p.outline.line, s.raw);
  require_holds(planar::verify_contraction(k.base(), p.outline, s.raw, s.exact), "certificate of the contraction");
  return s;
}

}  // namespace osteon::fuzz
