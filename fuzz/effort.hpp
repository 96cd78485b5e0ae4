// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How much is done with one input, told by its first byte: most inputs are small and see the cheap laws alone, so that there are many of them.

#include <cstdint>
#include <cstdlib>

#include "decode.hpp"

namespace osteon::fuzz {

/// The effort for one input. A byte of zero, and an empty input, means large and all laws.
class effort {
 public:
  /// Takes a byte.
  explicit effort(decoder& d) : byte_(d.byte()) {}

  /// Returns whether the input is small; fifteen in sixteen bytes say so.
  bool small() const { return byte_ % 16 != 0; }

  /// Returns whether the dear law of this number, 1 .. 15, is looked at: for a byte in eight. Where OSTEON_FUZZ_ALL_LAWS is set, as by every replay,
  /// all laws are; what an input decodes to is the same.
  bool law(unsigned number) const {
    static const bool all = std::getenv("OSTEON_FUZZ_ALL_LAWS") != nullptr;
    return all || byte_ / 16 == 0 || byte_ / 16U == number;
  }

 private:
  std::uint8_t byte_;
};

}  // namespace osteon::fuzz
