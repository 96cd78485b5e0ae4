// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The whole numbers of documents.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/door/documents.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {

/// Returns the number that a text says in decimal digits. Throws input_error(not_skeleton).
inline integer whole_number(const std::string& text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  if (text.size() == sign || text.find_first_not_of("0123456789", sign) != std::string::npos)
    throw input_error(input_fault::not_skeleton, 0, "\"" + text + "\" is no whole number", "give decimal digits");
  // a leading zero would mean base eight
  const std::size_t zeros = std::min(text.find_first_not_of('0', sign), text.size() - 1);
  return integer(text.substr(0, sign) + text.substr(zeros));
}

/// Returns planes or lines as texts.
template <int D>
std::vector<exact_plane<D>> texts_of(const std::vector<moving_plane<integer, D>>& planes) {
  std::vector<exact_plane<D>> result;
  result.reserve(planes.size());
  for (const auto& p : planes) {
    auto& to = result.emplace_back();
    for (std::size_t axis = 0; axis < D; ++axis) to.n[axis] = p.n[axis].str();
    to.d = p.d.str();
    to.weight = p.weight.str();
  }
  return result;
}

/// Returns whether a text says a plane.
template <int D>
bool says(const exact_plane<D>& text, const moving_plane<integer, D>& p) {
  bool same = whole_number(text.d) == p.d && whole_number(text.weight) == p.weight;
  for (std::size_t axis = 0; axis < D; ++axis) same = same && whole_number(text.n[axis]) == p.n[axis];
  return same;
}

}  // namespace osteon
