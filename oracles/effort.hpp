// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How long the oracles run, and from where their random numbers start.

#include <cstdint>
#include <cstdlib>
#include <string>

namespace osteon::oracles {

/// OSTEON_ORACLES=full asks for the full numbers.
inline bool full_effort() {
  const char* value = std::getenv("OSTEON_ORACLES");
  return value != nullptr && std::string(value) == "full";
}

template <class Number>
Number effort(Number brief, Number full) {
  return full_effort() ? full : brief;
}

/// OSTEON_ORACLE_SEED, or the same one always.
inline std::uint64_t seed() {
  const char* value = std::getenv("OSTEON_ORACLE_SEED");
  return value != nullptr ? std::strtoull(value, nullptr, 10) : 20250117;
}

}  // namespace osteon::oracles
