// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What certificates of both dimensions share: a demand that holds or ends the check with a
/// refutation.

#include <concepts>
#include <cstddef>
#include <string>

namespace osteon {

/// The first rule that a skeleton breaks, and where. `Rule` enumerates the rules of one
/// certificate.
template <class Rule>
struct broken_rule {
  Rule broken;
  std::string witness;  ///< the element and what is wrong with it
};

namespace certificate {

/// Ends the check: throws broken_rule with this witness.
template <class Rule>
[[noreturn]] void refute(Rule rule, const std::string& witness) {
  throw broken_rule<Rule>{rule, witness};
}

/// Throws broken_rule with the witness "WHAT NUMBER: WHY" where the demand does not hold.
template <class Rule, std::integral Number>
void demand(bool holds, Rule rule, const char* what, Number number, const char* why) {
  if (!holds) refute(rule, std::string(what) + " " + std::to_string(number) + ": " + why);
}

/// Returns whether `id` counts something in a list of this size.
inline bool exists(int id, std::size_t size) { return id >= 0 && static_cast<std::size_t>(id) < size; }

}  // namespace certificate
}  // namespace osteon
