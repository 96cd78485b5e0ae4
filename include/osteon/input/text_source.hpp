// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The characters of a text that a reader reads one by one, the line they stand in, and the errors
/// that name it.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/messages.hpp"

namespace osteon {

/// The limit of characters of a line or a word, so that no input can push memory beyond.
inline constexpr std::size_t longest_line = 1U << 20U;
/// The limit of points of a text.
inline constexpr std::size_t most_points = 10'000'000;
/// The limit of corners of all facets of a text together.
inline constexpr std::size_t most_corners = 60'000'000;

/// The characters of a text: line ends of any system are '\n', and UTF-8's byte order mark is left
/// out.
class text_source {
 public:
  /// The value that stands for the end of the text; less than all characters.
  static constexpr int end = -1;

  /// `name` of the text and what is `expected` in it are for messages ("give EXPECTED"); a text
  /// with a zero byte has the fault `other_kind`.
  /// *Throws* input_error(unreadable) where nothing can be read from the stream.
  text_source(std::istream& in, const std::string& name, std::string_view expected, input_fault other_kind)
      : in_(in), name_(name), hint_("give " + std::string(expected)), other_kind_(other_kind), buffer_(1U << 16U, '\0') {
    if (!in_.good()) fail(input_fault::unreadable, "the file cannot be read", "check the file");
    fill();
    if (std::string_view(buffer_).substr(0, size_).starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  /// Returns the next character, and leaves it there.
  int peek() {
    if (at_ == size_ && !fill()) return end;
    const char c = buffer_[at_];
    if (c == '\0') fail(other_kind_, "a zero byte, so this is not a text file", hint_);
    return c == '\r' ? '\n' : static_cast<unsigned char>(c);
  }

  /// Returns the next character, and goes on to the one after it.
  int get() {
    const int c = peek();
    if (c == end) return c;
    const bool carriage_return = buffer_[at_++] == '\r';
    if (c == '\n') {
      ++line_;
      if (carriage_return && (at_ < size_ || fill()) && buffer_[at_] == '\n') ++at_;
    }
    return c;
  }

  /// Returns the number of the line in which the next character stands, from 1.
  std::size_t line() const { return line_; }
  /// Returns the hint that names what is expected.
  const std::string& hint() const { return hint_; }

  /// Throws input_error for a line: name and line, `what`, and the hint.
  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint, std::size_t line) const {
    throw input_error(fault, line, name_ + ":" + std::to_string(line) + ": " + what, hint);
  }
  /// Does the same for the line of the next character.
  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) const { fail(fault, what, hint, line_); }

  /// Appends a character to a word, which must not become absurdly long.
  void append(std::string& word, int c) const {
    if (word.size() == longest_line) fail(input_fault::absurd_size, "a word longer than a mebibyte", hint_);
    word += static_cast<char>(c);
  }

  /// Returns the number that a word is.
  /// *Throws* input_error for a line where it is none (bad_number) or beyond the limits
  /// (absurd_size).
  template <class Int>
  exact_number<Int> number(std::string_view word, std::size_t line) const {
    exact_number<Int> value;
    switch (read_decimal(word, value)) {
      case number_fault::malformed:
        fail(input_fault::bad_number, quote(word) + " is not a finite decimal number", "write numbers like -1.25 or 3e-2", line);
      case number_fault::too_long:
        fail(input_fault::absurd_size, quote(word) + " is beyond 1e400, below 1e-400 or longer than 1000 digits", "scale or round the coordinates",
             line);
      case number_fault::none:
        break;
    }
    return value;
  }
  /// Does the same for a word in the line of the next character.
  template <class Int>
  exact_number<Int> number(std::string_view word) const {
    return number<Int>(word, line_);
  }

  /// Counts a point, read in a line; there must not be too many.
  void count_point(std::size_t line) {
    if (++points_ > most_points) fail(input_fault::absurd_size, "more than ten million points", "give fewer points", line);
  }

 private:
  bool fill() {
    at_ = 0;
    in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    size_ = static_cast<std::size_t>(in_.gcount());
    if (in_.bad()) fail(input_fault::unreadable, "reading failed", "check the file");
    return size_ > 0;
  }

  std::istream& in_;
  const std::string& name_;
  const std::string hint_;
  const input_fault other_kind_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t size_ = 0;
  std::size_t line_ = 1;
  std::size_t points_ = 0;
};

}  // namespace osteon
