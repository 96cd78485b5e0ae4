// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What the parts of a solid's certificate share: the rules, Boolean functions of the cells around
/// a point, and signs that must not be zero.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"

namespace osteon {

/// What a skeleton can break, in the order in which it is checked (space/verify.hpp tells what each
/// rule demands).
enum class rule : std::uint8_t { structure, order, incidence, border, link, nowhere, count, overlap, floor, contraction };
/// The names of the rules, as documents and messages have them.
inline constexpr std::array<std::string_view, 10> rule_names = {"structure", "order", "incidence", "border", "link",
                                                                "nowhere",   "count", "overlap",   "floor",  "contraction"};

/// The first rule that a solid's skeleton breaks, and where.
using refutation = broken_rule<rule>;

namespace certificate {

/// A Boolean function of n <= 4 bits, as its set of cells: bit c is its value where the arguments
/// are the bits of c.
using function = std::uint32_t;

/// Returns the function's value at a cell.
constexpr bool at(function f, unsigned cell) { return (f >> cell & 1U) != 0; }

/// Returns whether no argument that becomes true makes the function false.
constexpr bool is_monotone(function f, unsigned bits) {
  for (unsigned c = 0; c < 1U << bits; ++c)
    for (unsigned b = 0; b < bits; ++b)
      if (at(f, c) && !at(f, c | 1U << b)) return false;
  return true;
}

/// Returns whether argument b ever matters.
constexpr bool depends(function f, unsigned bits, unsigned b) {
  for (unsigned c = 0; c < 1U << bits; ++c)
    if (at(f, c) != at(f, c ^ 1U << b)) return true;
  return false;
}

/// Returns whether every argument matters somewhere.
constexpr bool depends_on_all(function f, unsigned bits) {
  for (unsigned b = 0; b < bits; ++b)
    if (!depends(f, bits, b)) return false;
  return true;
}

/// Returns the function of three bits that a function of four is where argument b is fixed.
constexpr function restricted(function f, unsigned b, bool value) {
  function result = 0;
  for (unsigned c = 0; c < 8; ++c) {
    const unsigned low = c & ((1U << b) - 1U);
    if (at(f, low | (c - low) << 1U | (value ? 1U << b : 0U))) result |= 1U << c;
  }
  return result;
}

/// How two facets meet along a line: not in an edge, or in an edge of either kind.
enum class bend : std::uint8_t { none, convex, reflex };

/// Returns how planes i and j meet where all other arguments are as in `rest`.
constexpr bend edge_at(function f, unsigned i, unsigned j, unsigned rest) {
  const bool one = at(f, rest | 1U << i);
  if (one != at(f, rest | 1U << j) || at(f, rest) == at(f, rest | 1U << i | 1U << j)) return bend::none;
  return one ? bend::reflex : bend::convex;
}

/// Returns how the two planes of a corner other than number t (0..2) meet inside or outside plane
/// t.
constexpr bend bend_at(std::uint8_t corner, unsigned t, bool inside) {
  return edge_at(corner, t == 0 ? 1 : 0, t == 2 ? 1 : 2, inside ? 1U << t : 0U);
}

/// Returns the monotone functions of four bits that depend on all of them.
inline const std::vector<function>& monotone_functions() {
  static const std::vector<function> all = [] {
    std::vector<function> result;
    for (function f = 0; f < 1U << 16U; ++f)
      if (is_monotone(f, 4) && depends_on_all(f, 4)) result.push_back(f);
    return result;
  }();
  return all;
}

/// Returns the sign of lambda_r of four planes (core/kernel.hpp).
/// *Throws* degenerate_error where it is zero.
template <kernel<3> K>
sign lambda_of(const K& k, const quadruple& q, std::size_t r) {
  const sign s = lambda(q, r, [&k](plane_id a, plane_id b, plane_id c) { return k.orientation(a, b, c); });
  if (s == sign::zero) throw degenerate_error({q[0], q[1], q[2], q[3]}, "the orientation");
  return s;
}

/// Returns the meeting of four planes.
/// *Throws* degenerate_error where there is none.
template <kernel<3> K>
typename K::meeting meeting_of(const K& k, const quadruple& q) {
  const auto m = k.meet(q);
  if (!m) throw degenerate_error({q[0], q[1], q[2], q[3]}, "whether four planes meet");
  return *m;
}

}  // namespace certificate
}  // namespace osteon
