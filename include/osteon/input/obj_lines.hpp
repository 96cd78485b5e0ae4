// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The lines and words of Wavefront OBJ.

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/text_source.hpp"

namespace osteon::obj {

/// Returns the next word of a line, removed from it; empty at the end.
inline std::string_view next_word(std::string_view& line) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::size_t a = 0;
  while (a < line.size() && blank(line[a])) ++a;
  std::size_t b = a;
  while (b < line.size() && !blank(line[b])) ++b;
  const std::string_view word = line.substr(a, b - a);
  line.remove_prefix(b);
  return word;
}

/// Returns whether a word begins a statement that carries no geometry of polygons: groups,
/// materials, normals, textures.
inline bool is_ignored(std::string_view word) {
  static constexpr std::array<std::string_view, 16> words = {"vt",     "vn",     "vp",     "g",     "o",        "s",        "mg",  "usemtl",
                                                             "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns whether a word begins a statement of OBJ that this library reads or skips.
inline bool is_keyword(std::string_view word) { return word == "v" || word == "f" || is_ignored(word); }

/// Returns whether a word begins a statement of points, lines, curves or surfaces, which no
/// polyhedron has.
inline bool is_other_geometry(std::string_view word) {
  static constexpr std::array<std::string_view, 7> words = {"l", "p", "curv", "curv2", "surf", "cstype", "deg"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The lines of a text: without comments, joined where a backslash ends one.
class line_reader {
 public:
  /// What a text must be, for hints.
  static constexpr const char* expected = "a Wavefront OBJ file: points (v x y z) and facets (f 1 2 3)";

  /// *Throws* input_error(unreadable) where nothing can be read from the stream.
  line_reader(std::istream& in, const std::string& name) : source_(in, name, expected, input_fault::not_obj) {}

  /// Reads the next line. Returns false at the end of the text.
  bool next() {
    text_.clear();
    number_ = source_.line();
    std::size_t length = 0;
    bool comment = false;
    int c = source_.get();
    const bool any = c != text_source::end;
    for (; c != text_source::end; c = source_.get()) {
      if (c == '\n') {
        // a comment's last backslash may be a path's
        if (comment || text_.empty() || text_.back() != '\\') break;
        text_.back() = ' ';
        continue;
      }
      if (++length > longest_line) fail(input_fault::absurd_size, "a line longer than a mebibyte", hint());
      comment = comment || c == '#';
      if (!comment) text_ += static_cast<char>(c);
    }
    return any;
  }

  /// Returns the line that was read.
  std::string_view text() const { return text_; }
  /// Returns the number of the first of the lines that were joined, from 1.
  std::size_t number() const { return number_; }
  /// Returns the hint that names what is expected.
  const std::string& hint() const { return source_.hint(); }

  /// Throws input_error for the line.
  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) const { source_.fail(fault, what, hint, number_); }

  /// Returns the number that a word of the line is.
  /// *Throws* input_error as text_source::number does.
  template <class Int>
  exact_number<Int> decimal(std::string_view word) const {
    return source_.number<Int>(word, number_);
  }

  /// Counts a point; there must not be too many.
  void count_point() { source_.count_point(number_); }

 private:
  text_source source_;
  std::string text_;
  std::size_t number_ = 0;
};

}  // namespace osteon::obj
