// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Words for messages.

#include <cstddef>
#include <string>
#include <string_view>

namespace osteon {

/// Returns a word of a file in quotes, for a message: short, and nothing in it that a terminal
/// would obey.
inline std::string quote(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c < ' ' || c > '~' ? '?' : c;
  return text + (word.size() > 40 ? "...'" : "'");
}

/// Returns "1 point" or "7 points", from the number and the two forms of what is counted.
inline std::string counted(std::size_t n, const std::string& one, const std::string& many) { return std::to_string(n) + ' ' + (n == 1 ? one : many); }

}  // namespace osteon
