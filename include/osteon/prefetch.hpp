// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A hint to the processor's memory.

namespace osteon {

/// What p points at will be needed soon. Does nothing where the compiler has no such hint; p may be anything.
inline void prefetch([[maybe_unused]] const void* p) {
#if defined(__GNUC__)
  __builtin_prefetch(p);
#endif
}

}  // namespace osteon
