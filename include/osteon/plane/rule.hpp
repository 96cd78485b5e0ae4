// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The rules of the plane's certificate.

#include <array>
#include <cstdint>
#include <string_view>

#include "osteon/core/certificate.hpp"

namespace osteon::plane {

/// What a skeleton can break. structure: something named does not exist, or not once; order: not in
/// order of time; start: what begins at the vertices; place: an arc ends where its lines do not
/// meet; event: what happens at a node is no event; length: an edge has vanished before; face:
/// edges share a face that do not merge, or the reverse; count: of events; end: what is left in the
/// end; contraction.
enum class rule : std::uint8_t { structure, order, start, place, event, length, face, count, end, contraction };
/// Names of the rules, by their numbers.
inline constexpr std::array<std::string_view, 10> rule_names = {"structure", "order", "start", "place", "event",
                                                                "length",    "face",  "count", "end",   "contraction"};

/// The first broken rule and where.
using refutation = broken_rule<rule>;

}  // namespace osteon::plane
