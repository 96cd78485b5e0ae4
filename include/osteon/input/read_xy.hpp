// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads polygons as lines of points (.xy), decimals exactly.

#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/rings.hpp"
#include "osteon/input/text_source.hpp"

namespace osteon::plane {

namespace detail {

/// The reader of lines of points.
template <class Int>
class xy_reader {
 public:
  xy_reader(std::istream& in, const std::string& name, std::string_view expected)
      : source_(in, name, expected, input_fault::not_polygon), name_(name) {}

  /// Reads the whole text. To be called once.
  rings<Int> read() {
    result_.file = name_;
    while (source_.peek() != text_source::end) {
      line l = read_line();
      if (l.numbers == 0) {
        in_ring_ = in_ring_ && l.comment;
        continue;
      }
      if (!in_ring_) begin_ring();
      add_point(l);
    }
    if (result_.all.empty()) throw input_error(input_fault::empty, 0, name_ + ": there are no points", source_.hint());
    drop_closing_point(result_.all.back());
    return std::move(result_);
  }

 private:
  struct line {
    std::array<exact_number<Int>, 3> values;
    std::size_t numbers = 0;
    std::size_t number = 0;
    bool comment = false;
  };

  // Reads a line with its end.
  line read_line() {
    line l;
    l.number = source_.line();
    std::size_t length = 0;
    for (int c = source_.peek(); c != '\n' && c != text_source::end; c = source_.peek()) {
      if (++length > longest_line) source_.fail(input_fault::absurd_size, "a line longer than a mebibyte", source_.hint());
      l.comment = l.comment || c == '#';
      if (l.comment || c == ' ' || c == '\t' || c == '\v' || c == '\f') {
        source_.get();
        continue;
      }
      length += read_number(l);
    }
    if (l.numbers == 1 || l.numbers > 3)
      source_.fail(input_fault::bad_number, "a line with " + std::to_string(l.numbers) + (l.numbers == 1 ? " number" : " numbers"),
                   "give x and y, and a weight or none");
    source_.get();
    return l;
  }

  // Returns the number's length.
  std::size_t read_number(line& l) {
    word_.clear();
    for (int c = source_.peek(); c > ' ' && c != '#'; c = source_.peek()) source_.append(word_, source_.get());
    if (word_.empty()) source_.fail(input_fault::bad_number, "a character that no text has", source_.hint());
    auto value = source_.template number<Int>(word_);
    if (l.numbers < 3) l.values[l.numbers] = std::move(value);
    ++l.numbers;
    return word_.size();
  }

  void begin_ring() {
    if (!result_.all.empty()) drop_closing_point(result_.all.back());
    result_.all.emplace_back();
    in_ring_ = true;
  }

  void add_point(line& l) {
    const exact_number<Int> one = {Int(1), 0, 0};
    auto& r = result_.all.back();
    source_.count_point(l.number);
    if (l.numbers == 3 && r.weights.empty()) r.weights.assign(r.points.size(), one);
    r.points.push_back({std::move(l.values[0]), std::move(l.values[1])});
    r.lines.push_back(l.number);
    if (l.numbers == 3)
      r.weights.push_back(std::move(l.values[2]));
    else if (!r.weights.empty())
      r.weights.push_back(one);
  }

  text_source source_;
  const std::string& name_;
  rings<Int> result_;
  std::string word_;
  bool in_ring_ = false;
};

}  // namespace detail

/// Reads lines `x y` or `x y weight`, the weight being that of the edge that starts at the point, 1
/// where it is missing. Blank lines separate rings; the first ring is the outer one, all others are
/// holes. '#' begins a comment; a line with nothing else is no blank line. A last point that
/// repeats the first of its ring is dropped. `name` of the text and what is `expected` in it are
/// for messages.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
rings<Int> read_xy(std::istream& in, const std::string& name, std::string_view expected = "one point x y in each line") {
  return detail::xy_reader<Int>(in, name, expected).read();
}

}  // namespace osteon::plane
