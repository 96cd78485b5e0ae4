// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads Wavefront OBJ: points and polygons, decimals exactly.

#include <algorithm>
#include <array>
#include <charconv>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/mesh.hpp"

namespace osteon {

/// Limits that no input can push memory beyond.
inline constexpr std::size_t longest_line = 1U << 20U;
inline constexpr std::size_t most_points = 10'000'000;
inline constexpr std::size_t most_corners = 60'000'000;

namespace obj {

inline bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The next word of a line, removed from it; empty at the end.
inline std::string_view next_word(std::string_view& line) {
  std::size_t a = 0;
  while (a < line.size() && blank(line[a])) ++a;
  std::size_t b = a;
  while (b < line.size() && !blank(line[b])) ++b;
  const std::string_view word = line.substr(a, b - a);
  line.remove_prefix(b);
  return word;
}

/// The lines of a text: ends of any system, without comments, joined where a backslash ends one.
class line_reader {
 public:
  line_reader(std::istream& in, const std::string& file) : in_(in), file_(file) {}

  /// False at the end of the file.
  bool next() {
    text_.clear();
    number_ = lines_ + 1;
    bool any = false;
    bool comment = false;
    std::size_t length = 0;
    for (char c = 0; in_.get(c);) {
      any = true;
      if (c == '\0') fail(input_fault::not_obj, "a zero byte, so this is not a text file", "give a Wavefront OBJ file");
      if (c == '\r' || c == '\n') {
        if (c == '\r' && in_.peek() == '\n') in_.get();
        ++lines_;
        if (comment || text_.empty() || text_.back() != '\\') return true;  // a comment's last backslash may be a path's
        text_.back() = ' ';
        continue;
      }
      if (++length > longest_line)
        fail(input_fault::absurd_size, "a line longer than a mebibyte", "give a Wavefront OBJ file, whose lines are at most that long");
      comment = comment || c == '#';
      if (!comment) text_ += c;
      if (text_ == "\xEF\xBB\xBF" && lines_ == 0) text_.clear();  // UTF-8's byte order mark
    }
    return any;
  }

  std::string_view text() const { return text_; }
  std::size_t number() const { return number_; }  ///< of the first line of those joined, from 1

  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) const {
    throw input_error(fault, number_, file_ + ":" + std::to_string(number_) + ": " + what, hint);
  }

 private:
  std::istream& in_;
  const std::string& file_;
  std::string text_;
  std::size_t lines_ = 0;
  std::size_t number_ = 0;
};

/// A word for a message: short, and nothing in it that a terminal would obey.
inline std::string quote(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c < ' ' || c > '~' ? '?' : c;
  return text + (word.size() > 40 ? "...'" : "'");
}

/// Whether text is the rest of a corner after its point: "", "/7", "/7/8", "//8". The numbers are not looked at.
inline bool texture_and_normal(std::string_view text) {
  return text.empty() ||
         (text[0] == '/' && std::count(text.begin(), text.end(), '/') <= 2 && text.find_first_not_of("/-0123456789") == std::string_view::npos);
}

/// Statements that carry no geometry of polygons.
inline bool ignored(std::string_view word) {
  static constexpr std::array<std::string_view, 16> words = {"vt",     "vn",     "vp",     "g",     "o",        "s",        "mg",  "usemtl",
                                                             "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace obj

/// Reads points (`v`) and polygons (`f`, with texture and normal indices, negative indices). Groups, materials, normals and
/// textures are skipped; lines, curves and surfaces are refused. `file` is for messages. Throws input_error. Linear time.
template <class Int>
input_mesh<Int> read_obj(std::istream& in, const std::string& file) {
  input_mesh<Int> m;
  m.file = file;
  std::size_t corners = 0;
  obj::line_reader lines(in, file);
  const auto fail = [&](input_fault fault, const std::string& what, const std::string& hint) { lines.fail(fault, what, hint); };
  while (lines.next()) {
    std::string_view line = lines.text();
    const std::string_view keyword = obj::next_word(line);
    if (keyword.empty() || obj::ignored(keyword)) continue;
    if (keyword == "v") {
      if (m.points.size() == most_points) fail(input_fault::absurd_size, "more than ten million points", "give a smaller model");
      auto& point = m.points.emplace_back();
      m.point_lines.push_back(lines.number());
      int count = 0;
      for (std::string_view word = obj::next_word(line); !word.empty(); word = obj::next_word(line), ++count) {
        exact_number<Int> value;
        switch (read_decimal(word, value)) {
          case number_fault::malformed:
            fail(input_fault::bad_number, obj::quote(word) + " is not a finite decimal number", "write coordinates like -1.25 or 3e-2");
            break;
          case number_fault::too_long:
            fail(input_fault::absurd_size, obj::quote(word) + " is beyond 1e400, below 1e-400 or longer than 1000 digits",
                 "scale or round the model");
            break;
          case number_fault::none:
            break;
        }
        if (count < 3) point[static_cast<std::size_t>(count)] = value;
      }
      if (count < 3 || count == 5 || count > 7)  // a weight or a colour may follow
        fail(input_fault::bad_number, "a point with " + std::to_string(count) + " coordinates", "give x, y and z");
    } else if (keyword == "f") {
      auto& facet = m.facets.emplace_back();
      m.facet_lines.push_back(lines.number());
      for (std::string_view word = obj::next_word(line); !word.empty(); word = obj::next_word(line)) {
        long index = 0;
        const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), index);
        const bool whole = ec == std::errc() && obj::texture_and_normal(word.substr(static_cast<std::size_t>(end - word.data())));
        if (!whole || index == 0)
          fail(input_fault::bad_index, obj::quote(word) + " is not the number of a point", "count points from 1, or from -1 backwards");
        const auto points = static_cast<long>(m.points.size());
        if (index < -points)
          fail(input_fault::bad_index, "there is no point " + std::to_string(index) + " before this line",
               "name one of the " + std::to_string(points) + " points");
        if (index > static_cast<long>(most_points))
          fail(input_fault::bad_index, "there is no point " + std::to_string(index), "name a point of the file");
        facet.push_back(static_cast<int>(index > 0 ? index - 1 : points + index));
        if (++corners == most_corners) fail(input_fault::absurd_size, "more than sixty million corners", "give a smaller model");
      }
      if (facet.size() < 3)
        fail(input_fault::short_facet, "a facet with " + std::to_string(facet.size()) + " corners", "give at least three, or delete the line");
    } else if (keyword == "l" || keyword == "p" || keyword == "curv" || keyword == "curv2" || keyword == "surf" || keyword == "cstype" ||
               keyword == "deg") {
      fail(input_fault::not_obj, obj::quote(keyword) + " is no polygon", "export the model as polygons only");
    } else {
      fail(input_fault::not_obj, obj::quote(keyword) + " is no statement of an OBJ file", "give a Wavefront OBJ file");
    }
  }
  if (in.bad() || !in.eof()) throw input_error(input_fault::unreadable, lines.number(), file + ": reading failed", "check the file");
  if (m.points.empty() && m.facets.empty())
    throw input_error(input_fault::empty, 0, file + (lines.number() == 1 ? ": the file is empty" : ": there are neither points nor facets"),
                      "give points (v) and facets (f)");
  if (m.facets.empty()) throw input_error(input_fault::empty, 0, file + ": there are no facets", "give facets (f)");
  if (m.points.empty()) throw input_error(input_fault::empty, 0, file + ": there are no points", "give points (v)");
  return m;
}

}  // namespace osteon
