// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Memory for GMP from lists of free blocks. GMP's own code is not instrumented, so that a sanitizer's
/// allocator would cost half of the time there and see nothing.

#include <gmp.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace osteon::fuzz {

/// Blocks for the whole run, in classes of eight bytes; large ones go to the system at once. For one thread.
class gmp_memory {
 public:
  /// Makes GMP use the lists from now on. Blocks that it has already are taken over when it frees them.
  static bool install() {
    mp_set_memory_functions(allocate, reallocate, release);
    return true;
  }

 private:
  struct block {
    block* next;
  };
  static constexpr std::size_t unit = sizeof(block);
  static constexpr std::size_t classes = 128;

  static std::size_t class_of(std::size_t size) { return (size + unit - 1) / unit; }
  static block*& head(std::size_t c) {
    static std::array<block*, classes> heads{};
    return heads[c];
  }

  static void* allocate(std::size_t size) {
    const std::size_t c = class_of(size);
    if (c >= classes) return checked(std::malloc(size));
    block*& first = head(c);
    if (first == nullptr) return checked(std::malloc(c == 0 ? unit : c * unit));
    block* taken = first;
    first = taken->next;
    return taken;
  }
  static void release(void* p, std::size_t size) {
    const std::size_t c = class_of(size);
    if (c >= classes) {
      std::free(p);
    } else if (p != nullptr && c > 0) {
      block*& first = head(c);
      first = new (p) block{first};
    }
  }
  static void* reallocate(void* p, std::size_t old_size, std::size_t size) {
    if (class_of(old_size) >= classes && class_of(size) >= classes) return checked(std::realloc(p, size));
    void* fresh = allocate(size);
    std::memcpy(fresh, p, old_size < size ? old_size : size);
    release(p, old_size);
    return fresh;
  }
  static void* checked(void* p) {
    if (p == nullptr) std::abort();
    return p;
  }
};

inline const bool gmp_memory_is_installed = gmp_memory::install();

}  // namespace osteon::fuzz
