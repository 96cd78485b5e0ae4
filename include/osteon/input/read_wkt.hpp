// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads polygons as well-known text, decimals exactly.
/// Source: OGC 06-103r4 (Simple features, part 1), section 7.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/rings.hpp"
#include "osteon/input/text_source.hpp"

namespace osteon::plane {

namespace detail {

/// The words of well-known text: in capitals, numbers and signs, without comments.
class wkt_words {
 public:
  wkt_words(std::istream& in, const std::string& name, std::string_view expected) : source_(in, name, expected, input_fault::not_polygon) {}

  /// Reads the next word; it is empty at the end.
  void next() {
    word_.clear();
    for (int c = source_.peek(); c != text_source::end && (std::isspace(c) != 0 || c == '#'); c = source_.peek())
      if (source_.get() == '#')
        while (source_.peek() != text_source::end && source_.peek() != '\n') source_.get();
    line_ = source_.line();
    const auto is_sign = [](int c) { return c == '(' || c == ')' || c == ',' || c == ';' || c == '='; };
    if (is_sign(source_.peek())) {
      word_ = static_cast<char>(source_.get());
    } else {
      for (int c = source_.peek(); c != text_source::end && std::isspace(c) == 0 && !is_sign(c); c = source_.peek())
        source_.append(word_, source_.get());
    }
    original_ = word_.substr(0, 64);
    for (char& c : word_) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }

  /// Returns the word that was read.
  const std::string& word() const { return word_; }
  /// Returns the line where the word begins.
  std::size_t line() const { return line_; }
  /// Returns whether the word is the one given.
  bool is(std::string_view word) const { return word_ == word; }
  /// Returns the word as it was written, in quotes.
  std::string quoted() const { return quote(original_); }

  /// Reads on where the word is the one given.
  bool accept(std::string_view word) {
    if (word_ != word) return false;
    next();
    return true;
  }
  /// Reads on where the word is the one given, and throws input_error where it is not.
  void expect(std::string_view sign) {
    if (accept(sign)) return;
    source_.fail(input_fault::not_polygon, (word_.empty() ? "the text ends" : quoted() + " stands") + " where '" + std::string(sign) + "' must be",
                 "write POLYGON ((x y, x y, ...), (...))");
  }

  /// Returns the text that the words come from.
  text_source& source() { return source_; }

 private:
  text_source source_;
  std::string word_;
  std::string original_;
  std::size_t line_ = 0;
};

/// The reader of well-known text.
template <class Int>
class wkt_reader {
 public:
  wkt_reader(std::istream& in, const std::string& name, std::string_view expected) : words_(in, name, expected) { result_.file = name; }

  /// Reads the whole text. To be called once.
  rings<Int> read() {
    words_.next();
    if (words_.accept("SRID")) {  // PostGIS: SRID=4326;POLYGON ...
      words_.expect("=");
      number();
      words_.expect(";");
    }
    const bool several = starts_polygons("MULTIPOLYGON");
    if (!several && !starts_polygons("POLYGON")) fail(input_fault::not_polygon, words_.quoted() + " is no polygon", words_.source().hint());
    words_.next();
    if (words_.is("Z") || words_.is("M") || words_.is("ZM")) words_.next();
    if (words_.is("EMPTY")) fail(input_fault::empty, "the polygon is empty", "give at least three points");
    if (several) {
      int part = 0;
      read_list([&] { read_polygon(part++); });
    } else {
      read_polygon(0);
    }
    words_.accept(";");
    if (!words_.is("")) fail(input_fault::not_polygon, words_.quoted() + " after the end", "give one MULTIPOLYGON for several polygons");
    note_heights(result_, heights_);
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) { words_.source().fail(fault, what, hint); }

  bool starts_polygons(const std::string& word) const {
    return words_.is(word) || words_.is(word + "Z") || words_.is(word + "M") || words_.is(word + "ZM");
  }

  // A list in brackets of what `item` reads.
  template <class Item>
  void read_list(Item item) {
    words_.expect("(");
    do item();
    while (words_.accept(","));
    words_.expect(")");
  }

  void read_polygon(int part) {
    if (words_.is("EMPTY")) fail(input_fault::empty, "a part of the polygon is empty", "leave it out");
    read_list([&] { read_ring(part); });
  }

  void read_ring(int part) {
    if (words_.is("EMPTY")) fail(input_fault::empty, "a ring of the polygon is empty", "leave it out");
    auto& r = result_.all.emplace_back();
    r.part = part;
    read_list([&] { read_point(r); });
    drop_closing_point(r);
  }

  void read_point(typename rings<Int>::ring& r) {
    words_.source().count_point(words_.line());
    auto& p = r.points.emplace_back();
    r.lines.push_back(words_.line());
    std::size_t count = 0;
    for (; !words_.is(",") && !words_.is(")") && !words_.is(""); ++count) {
      auto x = number();
      if (count < 2) p[count] = std::move(x);
    }
    if (count < 2 || count > 4) fail(input_fault::bad_number, "a point with " + std::to_string(count) + " coordinates", "give x and y");
    if (count > 2) ++heights_;
  }

  exact_number<Int> number() {
    auto value = words_.source().template number<Int>(words_.word());
    words_.next();
    return value;
  }

  wkt_words words_;
  rings<Int> result_;
  std::size_t heights_ = 0;
};

}  // namespace detail

/// Reads well-known text: one POLYGON or MULTIPOLYGON, in any case. Z and M values are left out
/// (see rings::notes), and comments from '#' to the end of the line. Closing points are dropped.
/// `name` of the text and what is `expected` in it are for messages.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
rings<Int> read_wkt(std::istream& in, const std::string& name, std::string_view expected = "POLYGON ((x y, x y, ...), (...)) or MULTIPOLYGON") {
  return detail::wkt_reader<Int>(in, name, expected).read();
}

}  // namespace osteon::plane
