// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How much is done with one input: most inputs are small and see the cheap laws alone, so that there are many of them.

#include <cstdint>
#include <cstdlib>

#include "decode.hpp"

namespace osteon::fuzz {

/// The effort for one input, a hash of all its bytes. So the share of large inputs stays what it is, whatever the fuzzer finds worth keeping.
/// An input that begins with the byte `K` (kept) is large, and all laws are looked at.
class effort {
 public:
  /// Takes a byte, which is there for `K`.
  explicit effort(decoder& d) {
    std::uint32_t hash = 2166136261U;  // FNV-1a
    for (const std::uint8_t b : d.rest()) hash = (hash ^ b) * 16777619U;
    hash ^= hash >> 15U;
    kept_ = d.byte() == 'K';
    small_ = !kept_ && hash % 16 != 0;
    law_ = hash / 16 % 16;
  }

  /// Returns whether the input is small, as fifteen in sixteen are.
  bool small() const { return small_; }

  /// Returns whether the dear law of this number, 1 .. 15, is looked at: for one input in eight. Where OSTEON_FUZZ_ALL_LAWS is set, as by every
  /// replay, all laws are; what an input decodes to is the same.
  bool law(unsigned number) const {
    static const bool all = std::getenv("OSTEON_FUZZ_ALL_LAWS") != nullptr;
    return all || kept_ || law_ == 0 || law_ == number;
  }

 private:
  bool kept_ = false;
  bool small_ = false;
  unsigned law_ = 0;
};

}  // namespace osteon::fuzz
