// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificates of skeletons, by the kernel they were made with.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common.hpp"
#include "osteon/plane/verify.hpp"
#include "osteon/space/verify.hpp"
#include "planar.hpp"

namespace osteon::app {

/// The certificate of a skeleton by the named kernel (double: by the exact one), contracted where it is given.
inline std::optional<refutation> certify(const solid<integer>& s, const std::string& name, const skeleton& raw,
                                         const std::optional<contracted_skeleton>& exact) {
  const auto check = [&](const auto& k) -> std::optional<refutation> {
    if (auto broken = verify(k, s.boundary, raw)) return broken;
    return exact ? verify_contraction(k.base(), s.boundary, raw, *exact) : std::nullopt;
  };
  if (name == "rational") return check(perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_rational_kernel(s.planes))));
  return check(perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_sqrt_kernel(s.planes))));
}

/// The same for a polygon.
inline std::optional<plane::refutation> certify(const plane::polygon<integer>& p, const std::string& name, const planar_skeletons& s, bool outside) {
  const auto check = [&](const auto& k) -> std::optional<plane::refutation> {
    if (auto broken = plane::verify(k, p.boundary, s.raw, outside, has_stationary_edge(p))) return broken;
    return s.exact ? plane::verify_contraction(k.base(), p.boundary, s.raw, *s.exact) : std::nullopt;
  };
  const std::span<const moving_line<integer>> lines(p.lines);
  const std::vector<std::array<double, 2>> anchors = anchors_of(p);
  if (name == "rational") return check(perturbed(filtered(lines, make_rational_kernel(lines), anchors)));
  return check(perturbed(filtered(lines, make_sqrt_kernel(lines), anchors)));
}

/// As an error of the program: a result that it has just computed must hold.
template <class Names, class Refutation>
void demand_certified(const Names& names, const std::optional<Refutation>& broken) {
  if (broken)
    throw invariant_error(fmt::format("the certificate is refuted: {}: {}", names[static_cast<std::size_t>(broken->broken)], broken->witness));
}

}  // namespace osteon::app
