// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Lists of a few elements, without memory of their own on the heap.

#include <algorithm>
#include <array>
#include <cstddef>

namespace osteon {

/// At most `Room` elements in order of their insertion.
template <class T, std::size_t Room>
class short_list {
 public:
  /// Appends an element.
  /// *Requires* fewer than `Room` elements in the list.
  void push_back(const T& x) { all_[size_++] = x; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return all_.data(); }
  T* end() { return all_.data() + size_; }
  const T* begin() const { return all_.data(); }
  const T* end() const { return all_.data() + size_; }

  /// Sorts the elements and keeps one of those that are equal.
  void sort_unique() {
    std::sort(begin(), end());
    size_ = static_cast<std::size_t>(std::unique(begin(), end()) - begin());
  }

 private:
  std::array<T, Room> all_{};
  std::size_t size_ = 0;
};

}  // namespace osteon
