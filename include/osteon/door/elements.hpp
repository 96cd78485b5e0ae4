// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Ranges of views: the nodes, arcs, faces, sheets and cells of a skeleton.

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

namespace osteon {

/// What a view holds on to: the data of a result, shared and never changed, and whether the raw
/// skeleton is meant.
template <class Data>
struct shared_view {
  std::shared_ptr<const Data> data;
  bool raw = false;
};

/// A random-access range of views, made as they are asked for. Ranges, iterators and views share
/// the data of the skeleton and keep it alive: none of them dangles, whatever becomes of the
/// skeleton. Copying one copies a shared pointer.
template <class Element>
class element_range {
 public:
  using handle = typename Element::handle;

  /// Points to one of the elements.
  class iterator {
   public:
    using iterator_concept = std::random_access_iterator_tag;
    using iterator_category = std::input_iterator_tag;  // `*i` is a value and no reference
    using value_type = Element;
    using difference_type = std::ptrdiff_t;
    using reference = Element;

    iterator() = default;
    iterator(handle of, int at) : of_(std::move(of)), at_(at) {}

    Element operator*() const { return Element(of_, at_); }
    Element operator[](difference_type n) const { return *(*this + n); }
    iterator& operator++() { return *this += 1; }
    iterator& operator--() { return *this -= 1; }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    iterator operator--(int) {
      iterator old = *this;
      --*this;
      return old;
    }
    iterator& operator+=(difference_type n) {
      at_ += static_cast<int>(n);
      return *this;
    }
    iterator& operator-=(difference_type n) { return *this += -n; }
    friend iterator operator+(iterator i, difference_type n) { return i += n; }
    friend iterator operator+(difference_type n, iterator i) { return i += n; }
    friend iterator operator-(iterator i, difference_type n) { return i -= n; }
    friend difference_type operator-(const iterator& i, const iterator& j) { return difference_type{i.at_} - j.at_; }
    /// Compares positions; both must be of one range.
    friend bool operator==(const iterator& i, const iterator& j) { return i.at_ == j.at_; }
    friend auto operator<=>(const iterator& i, const iterator& j) { return i.at_ <=> j.at_; }

   private:
    handle of_;
    int at_ = 0;
  };

  element_range(handle of, int size) : of_(std::move(of)), size_(size) {}

  iterator begin() const { return {of_, 0}; }
  iterator end() const { return {of_, size_}; }
  /// Returns how many elements there are.
  std::size_t size() const { return static_cast<std::size_t>(size_); }
  /// Returns whether there are none.
  bool empty() const { return size_ == 0; }
  /// Returns an element by its number. *Requires* i < size().
  Element operator[](std::size_t i) const { return Element(of_, static_cast<int>(i)); }

 private:
  handle of_;
  int size_;
};

}  // namespace osteon
