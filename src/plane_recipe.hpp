// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The steps of a run and of a certificate in the plane, for any kernel.

#include "plane_run.hpp"

#include <optional>
#include <span>
#include <string>

#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/locate.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"
#include "osteon/plane/verify.hpp"

namespace osteon {

/// Returns the raw skeleton. The wavefront is followed a little longer than asked for, so that what
/// happens at the end has happened.
template <class K>
plane::skeleton propagated(const K& k, const plane_question& q) {
  const auto& p = q.polygon;
  const plane::vertex_enclosures motion(p.lines, p.points, q.exterior);
  plane::skeleton_options o;
  o.outside = q.exterior;
  if (q.until) o.until = motion.own_time(plane::input_scale(p).to_integers(*q.until).template convert_to<double>()) * (1 + 1e-9) + 1e-300;
  return plane::propagation(k, p.boundary, motion, o).run();
}

/// Returns a perturbed kernel over an exact one, floating point in front.
template <class Exact>
auto make_perturbed_kernel(const plane::polygon<integer>& p, Exact exact) {
  return perturbed(filtered(std::span<const moving_line<integer>>(p.lines), std::move(exact), anchors_of(p)));
}

/// Returns what is wrong with a skeleton. `base` is the kernel below the perturbation.
template <class K, class Base>
std::optional<skeleton_refutation> certified(const K& k, const Base& base, const plane_question& q, const plane_result& r) {
  const auto& p = q.polygon;
  auto broken = plane::verify(k, p.boundary, r.raw, q.exterior, plane::has_stationary_edge(p));
  if (!broken && r.exact) broken = plane::verify_contraction(base, p.boundary, r.raw, *r.exact);
  if (!broken) return std::nullopt;
  return skeleton_refutation{plane::rule_names[static_cast<std::size_t>(broken->broken)], broken->witness};
}

}  // namespace osteon
