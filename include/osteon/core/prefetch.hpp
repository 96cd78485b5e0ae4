// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A hint to the processor's memory.

#include <cstddef>

namespace osteon {

/// Tells the processor that x will be needed soon. Does nothing where the compiler has no such
/// hint; x need not be initialised.
template <class T>
void prefetch([[maybe_unused]] const T& x) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64;  // bytes that come together, on most processors
  const char* begin = reinterpret_cast<const char*>(&x);
  for (std::size_t at = 0; at < sizeof(T); at += line) __builtin_prefetch(begin + at);
  if (alignof(T) < line) __builtin_prefetch(begin + sizeof(T) - 1);
#endif
}

}  // namespace osteon
