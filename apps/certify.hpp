// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificates of skeletons, by the kernel they were made with.

#include <optional>
#include <span>
#include <string>

#include "common.hpp"
#include "osteon/verify.hpp"

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

}  // namespace osteon::app
