// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// From a fuzzer's bytes to numbers and choices. Bytes are taken from the front and never run out: what is missing is zero, so every
/// input decodes and a shorter one is a simpler one.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "osteon/kernel/integer.hpp"

namespace osteon::fuzz {

class decoder {
 public:
  explicit decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return next_ >= bytes_.size(); }
  /// The bytes that have not been taken.
  std::span<const std::uint8_t> rest() const { return bytes_.subspan(next_); }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[next_++]; }
  bool flag() { return (byte() & 1U) != 0; }
  /// About one byte value in n.
  bool one_in(int n) { return byte() % n == 1; }

  /// lo .. hi, from as few bytes as the range needs. Zero bytes give the number nearest to zero or lo.
  long between(long lo, long hi) {
    const auto range = static_cast<std::uint64_t>(hi - lo) + 1;
    std::uint64_t x = 0;
    for (std::uint64_t covered = 1; covered < range && covered != 0; covered <<= 8U) x = x << 8U | byte();
    const long first = lo <= 0 && hi >= 0 ? 0 : lo;
    return lo + static_cast<long>((x + static_cast<std::uint64_t>(first - lo)) % range);
  }
  std::size_t index(std::size_t size) { return static_cast<std::size_t>(between(0, static_cast<long>(size) - 1)); }

  /// A number of at most 8 * bytes bits, with either sign.
  integer wide(int bytes) {
    const bool minus = flag();
    integer x = 0;
    for (int i = 0; i < bytes; ++i) x = (x << 8U) + byte();
    return minus ? integer(-x) : x;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace osteon::fuzz
