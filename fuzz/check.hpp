// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How a target says that a law is broken, and how often its inputs were what.

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "osteon/core/sign.hpp"

namespace osteon::fuzz {

/// Ends the run: the fuzzer keeps the input.
[[noreturn]] inline void broken(const std::string& law) {
  std::fprintf(stderr, "broken: %s\n", law.c_str());
  std::abort();
}
inline void require(bool holds, const char* law) {
  if (!holds) broken(law);
}
inline void require_equal(sign a, sign b, const char* law) {
  if (a != b) broken(std::string(law) + " (" + std::to_string(static_cast<int>(a)) + ", not " + std::to_string(static_cast<int>(b)) + ")");
}

/// Counts inputs by what became of them; printed at the end where OSTEON_FUZZ_TALLY is set.
class tally {
 public:
  static void add(const std::string& what) { ++one().counts_[what]; }
  tally(const tally&) = delete;
  tally& operator=(const tally&) = delete;

 private:
  tally() = default;
  ~tally() {
    if (std::getenv("OSTEON_FUZZ_TALLY") == nullptr) return;
    for (const auto& [what, count] : counts_) std::fprintf(stderr, "tally: %10lu %s\n", count, what.c_str());
  }
  static tally& one() {
    static tally t;
    return t;
  }
  std::map<std::string, unsigned long> counts_;
};

}  // namespace osteon::fuzz
