// SPDX-License-Identifier: MIT

/// \file
/// Names, and the version.

#include "osteon/door/choices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace osteon {
namespace {

constexpr std::array<std::string_view, 18> kinds = {"vertex", "edge",  "split",  "E1",      "E2",       "E3",  "E4",  "E5",    "E6",
                                                    "V-E",    "V-V-I", "V-V-II", "V-V-E-I", "V-V-E-II", "E-E", "V-F", "other", "merged"};

}  // namespace

std::string_view name_of(number_kernel k) {
  constexpr std::array<std::string_view, 3> names = {"sqrt", "rational", "double"};
  return names[static_cast<std::size_t>(k)];
}

std::string_view name_of(event_kind k) { return kinds[static_cast<std::size_t>(k)]; }

std::optional<event_kind> event_of_name(std::string_view name) {
  const auto found = std::find(kinds.begin(), kinds.end(), name);
  if (found == kinds.end()) return std::nullopt;
  return static_cast<event_kind>(found - kinds.begin());
}

std::string_view version() { return OSTEON_VERSION; }

}  // namespace osteon
