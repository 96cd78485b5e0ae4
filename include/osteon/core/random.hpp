// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reproducible pseudo-random numbers, the same on every machine.

#include <cstdint>

namespace osteon {

/// A stream of pseudo-random numbers. The same seed gives the same numbers.
/// *Source* Steele, Lea, Flood: Fast splittable pseudorandom number generators. OOPSLA 2014
/// (splitmix64).
class random_stream {
 public:
  static constexpr std::uint64_t step = 0x9E3779B97F4A7C15U;

  explicit constexpr random_stream(std::uint64_t seed) : state_(seed) {}

  /// Returns the next number, uniform in 0 .. 2^64 - 1.
  constexpr std::uint64_t operator()() {
    state_ += step;
    return mixed(state_);
  }

  /// Returns an integer that is uniform in low .. high, up to a bias below 2^-32 for ranges below
  /// 2^32.
  /// *Requires* low <= high.
  constexpr long between(long low, long high) { return low + static_cast<long>((*this)() % static_cast<std::uint64_t>(high - low + 1)); }

  /// Returns a number in which every bit depends on every bit of x; no two x have the same.
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30U) * 0xBF58476D1CE4E5B9U;
    x = (x ^ x >> 27U) * 0x94D049BB133111EBU;
    return x ^ x >> 31U;
  }

 private:
  std::uint64_t state_;
};

}  // namespace osteon
