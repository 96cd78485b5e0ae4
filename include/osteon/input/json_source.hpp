// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The tokens of a JSON text. Source: RFC 8259.

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "osteon/core/error.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/text_source.hpp"

namespace osteon {

/// The limit of how deep brackets of JSON may be nested.
inline constexpr std::size_t deepest_nesting = 500;

/// JSON token by token, strict, without recursion.
class json_source {
 public:
  /// The kinds of tokens. A key is a string that names a member of an object; words are true, false
  /// and null.
  enum class token : std::uint8_t { begin_object, end_object, begin_array, end_array, key, string, number, word, end };

  /// `name` of the text and what is `expected` in it are for messages.
  json_source(std::istream& in, const std::string& name, std::string_view expected) : source_(in, name, expected, input_fault::not_polygon) {}

  /// Reads the next token and returns its kind: `end` behind a whole value at the end of the text.
  /// *Throws* input_error where there is no valid token.
  token next() {
    int c = skip_blanks();
    if (c == ',' && state_ == after_value && !open_.empty()) {
      source_.get();
      c = skip_blanks();
      state_ = open_.back() == '{' ? want_key : want_value;
    } else if (state_ == after_value) {
      if (open_.empty()) {
        if (c != text_source::end) unexpected("after the end");
        return token::end;
      }
      return close(c);
    } else if (state_ == first_key || state_ == first_value) {
      if (c == (state_ == first_key ? '}' : ']')) return close(c);
      state_ = state_ == first_key ? want_key : want_value;
    }
    if (state_ == want_key) {
      if (c != '"') unexpected("where a key must be");
      read_string();
      if (skip_blanks() != ':') unexpected("where a colon must be");
      source_.get();
      state_ = want_value;
      return token::key;
    }
    return read_value(c);
  }

  /// Skips the rest of a value whose first token was just read.
  void skip(token first) {
    if (first != token::begin_object && first != token::begin_array) return;
    const std::size_t depth = open_.size();
    while (open_.size() >= depth) next();
  }

  /// Returns the text of the key, string, number or word that was read; escapes of strings as they
  /// stand.
  const std::string& text() const { return text_; }
  /// Returns the text that the tokens come from.
  text_source& source() { return source_; }

 private:
  enum state : std::uint8_t { want_value, want_key, first_key, first_value, after_value };

  int skip_blanks() {
    int c = source_.peek();
    for (; c == ' ' || c == '\t' || c == '\n'; c = source_.peek()) source_.get();
    return c;
  }
  [[noreturn]] void unexpected(const std::string& where) {
    const int c = source_.peek();
    source_.fail(input_fault::not_polygon,
                 (c == text_source::end ? "the text ends" : quote(std::string(1, static_cast<char>(c))) + " stands") + ' ' + where,
                 "give valid JSON");
  }
  token read_value(int c) {
    state_ = after_value;
    if (c == '{' || c == '[') {
      source_.get();
      if (open_.size() == deepest_nesting)
        source_.fail(input_fault::absurd_size, "brackets nested deeper than " + std::to_string(deepest_nesting), source_.hint());
      open_ += static_cast<char>(c);
      state_ = c == '{' ? first_key : first_value;
      return c == '{' ? token::begin_object : token::begin_array;
    }
    if (c == '"') {
      read_string();
      return token::string;
    }
    text_.clear();
    while (std::isalnum(source_.peek()) != 0 || source_.peek() == '-' || source_.peek() == '+' || source_.peek() == '.')
      source_.append(text_, source_.get());
    if (text_ == "true" || text_ == "false" || text_ == "null") return token::word;
    if (text_.empty()) unexpected("where a value must be");
    if (!is_number(text_)) source_.fail(input_fault::bad_number, quote(text_) + " is no number of JSON", "write numbers like -1.25 or 3e-2");
    return token::number;
  }
  token close(int c) {
    if (c != (open_.back() == '{' ? '}' : ']')) unexpected(open_.back() == '{' ? "where ',' or '}' must be" : "where ',' or ']' must be");
    source_.get();
    open_.pop_back();
    state_ = after_value;
    return c == '}' ? token::end_object : token::end_array;
  }
  void read_string() {
    text_.clear();
    source_.get();
    for (;;) {
      const int c = source_.peek();
      if (c < ' ') source_.fail(input_fault::not_polygon, "a string without its closing quote", "give valid JSON");
      source_.get();
      if (c == '"') return;
      source_.append(text_, c);
      // not decoded: names of members and types have no escapes
      if (c == '\\') source_.append(text_, source_.get());
    }
  }
  static bool is_number(std::string_view s) {
    const auto digits = [&] {
      std::size_t n = 0;
      while (n < s.size() && s[n] >= '0' && s[n] <= '9') ++n;
      s.remove_prefix(n);
      return n;
    };
    if (s.starts_with('-')) s.remove_prefix(1);
    const bool zero = s.starts_with('0');
    const std::size_t n = digits();
    if (n == 0 || (zero && n > 1)) return false;
    if (s.starts_with('.')) {
      s.remove_prefix(1);
      if (digits() == 0) return false;
    }
    if (s.starts_with('e') || s.starts_with('E')) {
      s.remove_prefix(1);
      if (s.starts_with('+') || s.starts_with('-')) s.remove_prefix(1);
      if (digits() == 0) return false;
    }
    return s.empty();
  }

  text_source source_;
  std::string open_;  // brackets
  std::string text_;
  state state_ = want_value;
};

}  // namespace osteon
