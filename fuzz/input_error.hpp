// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What every message about bad input keeps to.

#include <algorithm>
#include <string>

#include "check.hpp"
#include "osteon/core/error.hpp"

namespace osteon::fuzz {

inline void check_error(const input_error& e) {
  const std::string what = e.what();
  require(what.find("; hint: ") != std::string::npos && !e.hint.empty(), "an input error names a hint");
  require(std::all_of(what.begin(), what.end(), [](char c) { return c >= ' ' && c <= '~'; }), "a message is printable");
  require(what.size() < 1000, "a message is short");
}

}  // namespace osteon::fuzz
