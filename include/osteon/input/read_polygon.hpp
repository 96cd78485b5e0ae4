// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads polygons: lines of points (.xy), well-known text, GeoJSON and OBJ, decimals exactly.
/// Sources: OGC 06-103r4 (Simple features, part 1), section 7; RFC 7946 (GeoJSON); RFC 8259 (JSON).

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <istream>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/input/read_obj.hpp"

namespace osteon::plane {

/// How deep brackets of JSON may be nested.
inline constexpr std::size_t deepest_nesting = 500;

enum class format : std::uint8_t { xy, wkt, geojson, obj };

namespace detail {

/// The characters of a text, with line ends of any system as '\n', and the number of the line.
class text_source {
 public:
  static constexpr int end = -1;

  text_source(std::istream& in, const std::string& file, std::string_view kind) : in_(in), file_(file), kind_(kind), buffer_(1U << 16U, '\0') {
    if (!in_.good()) fail(input_fault::unreadable, "the file cannot be read", "check the file");
    fill();
    if (std::string_view(buffer_).substr(0, size_).starts_with("\xEF\xBB\xBF")) at_ = 3;  // UTF-8's byte order mark
  }

  int peek() {
    if (at_ == size_ && !fill()) return end;
    const char c = buffer_[at_];
    if (c == '\0') fail(input_fault::not_polygon, "a zero byte, so this is not a text file", "give " + std::string(kind_));
    return c == '\r' ? '\n' : static_cast<unsigned char>(c);
  }
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

  std::size_t line() const { return line_; }

  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) const {
    throw input_error(fault, line_, file_ + ":" + std::to_string(line_) + ": " + what, hint);
  }

  /// Appends to a word, which must not become absurdly long.
  void append(std::string& word, int c) const {
    if (word.size() == longest_line) fail(input_fault::absurd_size, "a word longer than a mebibyte", "give " + std::string(kind_));
    word += static_cast<char>(c);
  }

  template <class Int>
  exact_number<Int> number(std::string_view word) const {
    exact_number<Int> value;
    switch (read_decimal(word, value)) {
      case number_fault::malformed:
        fail(input_fault::bad_number, obj::quote(word) + " is not a finite decimal number", "write numbers like -1.25 or 3e-2");
      case number_fault::too_long:
        fail(input_fault::absurd_size, obj::quote(word) + " is beyond 1e400, below 1e-400 or longer than 1000 digits", "scale or round the polygon");
      case number_fault::none:
        break;
    }
    return value;
  }

  void count_point() {
    if (++points_ > most_points) fail(input_fault::absurd_size, "more than ten million points", "give a smaller polygon");
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
  const std::string& file_;
  std::string_view kind_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t size_ = 0;
  std::size_t line_ = 1;
  std::size_t points_ = 0;
};

template <class Int>
bool same(const exact_number<Int>& a, const exact_number<Int>& b) {
  return a.ten == b.ten && a.two == b.two && a.mantissa == b.mantissa;  // decimals and doubles are read without trailing zeros
}

/// The last point of a ring may repeat its first.
template <class Int>
void drop_closing_point(typename rings<Int>::ring& r) {
  if (r.points.size() < 2 || !same(r.points.front()[0], r.points.back()[0]) || !same(r.points.front()[1], r.points.back()[1])) return;
  r.points.pop_back();
  if (!r.weights.empty()) r.weights.pop_back();
  if (!r.lines.empty()) r.lines.pop_back();
}

template <class Int>
void note_heights(rings<Int>& r, std::size_t heights) {
  if (heights > 0)
    r.notes.push_back("third coordinates and measures were left out, those of " + std::to_string(heights) + (heights == 1 ? " point" : " points"));
}

// ---- well-known text

template <class Int>
class wkt_reader {
 public:
  wkt_reader(std::istream& in, const std::string& file) : source_(in, file, "well-known text like POLYGON ((0 0, 1 0, 0 1))") { result_.file = file; }

  rings<Int> read() {
    next();
    if (word_ == "SRID") {  // PostGIS: SRID=4326;POLYGON ...
      next(), expect("=");
      source_.template number<Int>(word_);
      next(), expect(";");
    }
    const std::string kind = word_;
    const bool several = kind == "MULTIPOLYGON" || kind == "MULTIPOLYGONZ" || kind == "MULTIPOLYGONM" || kind == "MULTIPOLYGONZM";
    if (!several && kind != "POLYGON" && kind != "POLYGONZ" && kind != "POLYGONM" && kind != "POLYGONZM")
      source_.fail(input_fault::not_polygon, obj::quote(original_) + " is no polygon", "give POLYGON or MULTIPOLYGON");
    next();
    if (word_ == "Z" || word_ == "M" || word_ == "ZM") next();
    if (word_ == "EMPTY") source_.fail(input_fault::empty, "the polygon is empty", "give at least three points");
    if (several) {
      expect("(");
      for (int part = 0;; ++part) {
        polygon(part);
        if (word_ != ",") break;
        next();
      }
      expect(")");
    } else {
      polygon(0);
    }
    if (word_ == ";") next();
    if (!word_.empty())
      source_.fail(input_fault::not_polygon, obj::quote(original_) + " after the end", "give one MULTIPOLYGON for several polygons");
    note_heights(result_, heights_);
    return std::move(result_);
  }

 private:
  // Reads a word in capitals, a number or a sign; empty at the end.
  void next() {
    word_.clear();
    for (int c = source_.peek(); c != text_source::end && (std::isspace(c) != 0 || c == '#'); c = source_.peek())
      if (source_.get() == '#')
        while (source_.peek() != text_source::end && source_.peek() != '\n') source_.get();
    line_ = source_.line();
    const auto sign = [](int c) { return c == '(' || c == ')' || c == ',' || c == ';' || c == '='; };
    if (sign(source_.peek())) {
      word_ = static_cast<char>(source_.get());
    } else {
      for (int c = source_.peek(); c != text_source::end && std::isspace(c) == 0 && !sign(c); c = source_.peek())
        source_.append(word_, source_.get());
    }
    original_ = word_.substr(0, 64);
    for (char& c : word_) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  void expect(std::string_view sign) {
    if (word_ == sign) return next();
    source_.fail(input_fault::not_polygon,
                 (word_.empty() ? "the text ends" : obj::quote(original_) + " stands") + " where '" + std::string(sign) + "' must be",
                 "write POLYGON ((x y, x y, ...), (...))");
  }

  void polygon(int part) {
    if (word_ == "EMPTY") source_.fail(input_fault::empty, "a part of the polygon is empty", "leave it out");
    expect("(");
    for (;;) {
      ring(part);
      if (word_ != ",") break;
      next();
    }
    expect(")");
  }

  void ring(int part) {
    if (word_ == "EMPTY") source_.fail(input_fault::empty, "a ring of the polygon is empty", "leave it out");
    expect("(");
    auto& r = result_.all.emplace_back();
    r.part = part;
    for (;;) {
      source_.count_point();
      auto& p = r.points.emplace_back();
      r.lines.push_back(line_);
      int count = 0;
      for (; word_ != "," && word_ != ")" && !word_.empty(); ++count, next()) {
        auto x = source_.template number<Int>(word_);
        if (count < 2) p[static_cast<std::size_t>(count)] = std::move(x);
      }
      if (count < 2 || count > 4) source_.fail(input_fault::bad_number, "a point with " + std::to_string(count) + " coordinates", "give x and y");
      if (count > 2) ++heights_;
      if (word_ != ",") break;
      next();
    }
    expect(")");
    drop_closing_point<Int>(r);
  }

  text_source source_;
  rings<Int> result_;
  std::string word_;
  std::string original_;
  std::size_t line_ = 0;  // where the word begins
  std::size_t heights_ = 0;
};

// ---- GeoJSON

/// JSON token by token, strict, without recursion.
class json_source {
 public:
  enum class token : std::uint8_t { begin_object, end_object, begin_array, end_array, key, string, number, word, end };

  json_source(std::istream& in, const std::string& file) : source_(in, file, "GeoJSON") {}

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
    state_ = after_value;
    if (c == '{' || c == '[') {
      source_.get();
      if (open_.size() == deepest_nesting)
        source_.fail(input_fault::absurd_size, "brackets nested deeper than " + std::to_string(deepest_nesting), "give GeoJSON");
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
    if (!is_number(text_)) source_.fail(input_fault::bad_number, obj::quote(text_) + " is no number of JSON", "write numbers like -1.25 or 3e-2");
    return token::number;
  }

  /// Skips a value whose first token was just read.
  void skip(token first) {
    if (first != token::begin_object && first != token::begin_array) return;
    const std::size_t depth = open_.size();
    while (open_.size() >= depth) next();
  }

  const std::string& text() const { return text_; }  ///< of a key, string, number or word; escapes of strings as they stand
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
                 (c == text_source::end ? "the text ends" : obj::quote(std::string(1, static_cast<char>(c))) + " stands") + ' ' + where,
                 "give valid JSON");
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
      if (c == text_source::end || c < ' ') source_.fail(input_fault::not_polygon, "a string without its closing quote", "give valid JSON");
      source_.get();
      if (c == '"') return;
      source_.append(text_, c);
      if (c == '\\') source_.append(text_, source_.get());  // not decoded: names of members and types have no escapes
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

template <class Int>
class geojson_reader {
 public:
  geojson_reader(std::istream& in, const std::string& file) : json_(in, file) { result_.file = file; }

  rings<Int> read() {
    std::vector<object> objects;  // from the outermost one to that being read
    if (json_.next() != token::begin_object) fail(input_fault::not_polygon, "the text does not begin with an object", "give GeoJSON");
    objects.emplace_back();
    while (!objects.empty()) {
      object& o = objects.back();
      const token t = json_.next();
      if (o.in_list) {  // features or geometries
        if (t == token::end_array)
          o.in_list = false;
        else if (t == token::begin_object)
          objects.emplace_back();
        else
          fail(input_fault::not_polygon, "a list of features or geometries with something else in it", "give GeoJSON");
      } else if (t == token::end_object) {
        finish(o);
        objects.pop_back();
      } else {
        const std::string key = json_.text();  // t is a key: nothing else can come
        const token value = json_.next();
        if (key == "type") {
          if (value != token::string || !o.type.empty()) fail(input_fault::not_polygon, "a type that is no text, or a second one", "give GeoJSON");
          o.type = json_.text();
        } else if (key == "coordinates") {
          if (value != token::begin_array || !o.rings.empty())
            fail(input_fault::not_polygon, "coordinates that are no list, or a second list", "give GeoJSON");
          read_coordinates(o);
        } else if (key == "geometry" && value == token::begin_object) {
          objects.emplace_back();
        } else if ((key == "features" || key == "geometries") && value == token::begin_array) {
          o.in_list = true;
        } else {
          json_.skip(value);
        }
      }
    }
    json_.next();  // refuses what follows
    if (result_.all.empty()) throw input_error(input_fault::empty, 0, result_.file + ": there is no polygon", "give at least one");
    note_heights(result_, heights_);
    return std::move(result_);
  }

 private:
  using token = json_source::token;
  using ring = typename rings<Int>::ring;

  struct object {
    std::string type;
    std::size_t depth = 0;  ///< of the numbers in the coordinates
    std::vector<ring> rings;
    bool in_list = false;
  };

  [[noreturn]] void fail(input_fault fault, const std::string& what, const std::string& hint) { json_.source().fail(fault, what, hint); }

  // Lists of lists of points, as deep as the first number.
  void read_coordinates(object& o) {
    std::size_t depth = 1;
    std::size_t count = 0;  // coordinates of the point
    int part = 0;
    bool empty = true;  // the list just begun
    bool in_ring = false;
    while (depth > 0) {
      switch (json_.next()) {
        case token::begin_array:
          ++depth;
          count = 0;
          empty = true;
          break;
        case token::number:
          if (o.depth == 0) o.depth = depth;
          if (depth != o.depth || depth > 4) fail(input_fault::not_polygon, "a number among lists of points", "nest coordinates as GeoJSON does");
          if (count == 0) {
            json_.source().count_point();
            if (!in_ring) o.rings.emplace_back().part = part;
            in_ring = true;
            o.rings.back().points.emplace_back();
            o.rings.back().lines.push_back(json_.source().line());
          }
          if (count < 2) o.rings.back().points.back()[count] = json_.source().template number<Int>(json_.text());
          if (count == 2) ++heights_;
          ++count;
          empty = false;
          break;
        case token::end_array:
          if (empty) fail(input_fault::empty, "an empty list of coordinates", "leave out what is empty");
          if (depth == o.depth && count < 2) fail(input_fault::bad_number, "a point with one coordinate", "give x and y");
          if (depth + 1 == o.depth) {
            drop_closing_point<Int>(o.rings.back());
            in_ring = false;
          }
          if (depth + 2 == o.depth) ++part;
          --depth;
          break;
        default:
          fail(input_fault::bad_number, "a coordinate that is no number", "write numbers like -1.25 or 3e-2");
      }
    }
  }

  void finish(object& o) {
    if (o.type.empty()) fail(input_fault::not_polygon, "an object without a type", "give GeoJSON");
    if (o.type == "Feature" || o.type == "FeatureCollection" || o.type == "GeometryCollection") return;
    const bool several = o.type == "MultiPolygon";
    if (!several && o.type != "Polygon")
      fail(input_fault::not_polygon, obj::quote(o.type) + " is no polygon", "give Polygon, MultiPolygon or features of these");
    if (o.rings.empty()) fail(input_fault::empty, "a polygon without coordinates", "give coordinates");
    if (o.depth != (several ? 4U : 3U))
      fail(input_fault::not_polygon, "coordinates nested " + std::to_string(o.depth) + " deep",
           several ? "a MultiPolygon's are nested 4 deep" : "a Polygon's are nested 3 deep");
    const int first = parts_;
    for (auto& r : o.rings) {
      r.part += first;
      parts_ = r.part + 1;
      result_.all.push_back(std::move(r));
    }
  }

  json_source json_;
  rings<Int> result_;
  int parts_ = 0;
  std::size_t heights_ = 0;
};

/// A stream whose first characters were looked at already.
class rewound : public std::streambuf {
 public:
  rewound(std::string head, std::streambuf* rest) : head_(std::move(head)), rest_(rest) {
    setg(head_.data(), head_.data(), head_.data() + head_.size());
  }

 protected:
  int_type underflow() override {
    head_.resize(1U << 16U);
    const auto n = rest_->sgetn(head_.data(), static_cast<std::streamsize>(head_.size()));
    setg(head_.data(), head_.data(), head_.data() + n);
    return n > 0 ? traits_type::to_int_type(head_[0]) : traits_type::eof();
  }

 private:
  std::string head_;
  std::streambuf* rest_;
};

}  // namespace detail

/// Reads lines `x y` or `x y weight`, the weight being that of the edge that starts at the point, 1 where it is missing. Blank lines separate rings;
/// the first ring is the outer one, all others are holes. '#' begins a comment; a line with nothing else is no blank line. A last point that
/// repeats the first of its ring is dropped. `file` is for messages. Throws input_error. Linear time.
template <class Int>
rings<Int> read_xy(std::istream& in, const std::string& file) {
  rings<Int> result;
  result.file = file;
  detail::text_source source(in, file, "one point x y in each line");
  bool in_ring = false;
  std::string word;
  while (source.peek() != detail::text_source::end) {
    std::size_t length = 0;
    int count = 0;
    bool comment = false;
    std::array<exact_number<Int>, 3> values;
    const std::size_t line = source.line();
    for (;;) {
      int c = source.peek();
      if (++length > longest_line) source.fail(input_fault::absurd_size, "a line longer than a mebibyte", "give one point x y in each line");
      if (c == '\n' || c == detail::text_source::end) break;
      comment = comment || c == '#';
      if (comment || c == ' ' || c == '\t' || c == '\v' || c == '\f') {
        source.get();
        continue;
      }
      word.clear();
      for (; c != detail::text_source::end && c > ' ' && c != '#'; c = source.peek()) source.append(word, source.get());
      if (word.empty()) source.fail(input_fault::bad_number, "a character that no text has", "give one point x y in each line");
      length += word.size();
      auto value = source.template number<Int>(word);
      if (count < 3) values[static_cast<std::size_t>(count)] = std::move(value);
      ++count;
    }
    if (count == 1 || count > 3)
      source.fail(input_fault::bad_number, "a line with " + std::to_string(count) + (count == 1 ? " number" : " numbers"),
                  "give x and y, and a weight or none");
    if (count == 0) {
      if (!comment) in_ring = false;
    } else {
      if (!in_ring) {
        if (!result.all.empty()) detail::drop_closing_point<Int>(result.all.back());
        result.all.emplace_back();
      }
      in_ring = true;
      auto& r = result.all.back();
      source.count_point();
      if (count == 3 && r.weights.empty()) r.weights.assign(r.points.size(), {Int(1), 0, 0});
      r.points.push_back({std::move(values[0]), std::move(values[1])});
      r.lines.push_back(line);
      if (count == 3)
        r.weights.push_back(std::move(values[2]));
      else if (!r.weights.empty())
        r.weights.push_back({Int(1), 0, 0});
    }
    source.get();
  }
  if (result.all.empty()) throw input_error(input_fault::empty, 0, file + ": there are no points", "give one point x y in each line");
  detail::drop_closing_point<Int>(result.all.back());
  return result;
}

/// Reads well-known text: one POLYGON or MULTIPOLYGON, in any case; Z and M values are left out (see rings::notes), and comments from '#' to the end
/// of the line. Closing points are dropped. Throws input_error. Linear time.
template <class Int>
rings<Int> read_wkt(std::istream& in, const std::string& file) {
  return detail::wkt_reader<Int>(in, file).read();
}

/// Reads GeoJSON: a Polygon, a MultiPolygon, or a Feature, FeatureCollection or GeometryCollection of these; every polygon becomes a part. Heights
/// and members that are no geometry are left out. Closing points are dropped. Throws input_error. Linear time.
template <class Int>
rings<Int> read_geojson(std::istream& in, const std::string& file) {
  return detail::geojson_reader<Int>(in, file).read();
}

/// Reads OBJ with one facet in a plane z = constant. Throws input_error. Linear time.
template <class Int>
rings<Int> read_flat_obj(std::istream& in, const std::string& file) {
  input_mesh<Int> m = read_obj<Int>(in, file);
  if (m.facets.size() != 1)
    throw input_error(input_fault::not_polygon, 2,
                      m.name_facet(1) + " is one of " + std::to_string(m.facets.size()) + ", and only one can be a polygon",
                      "join the facets to one");
  rings<Int> result;
  result.file = file;
  auto& r = result.all.emplace_back();
  for (const int p : m.facets[0]) {
    if (p < 0 || static_cast<std::size_t>(p) >= m.points.size())
      throw input_error(input_fault::bad_index, 1,
                        m.name_facet(0) + " names point " + std::to_string(long{p} + 1) + " of " + std::to_string(m.points.size()),
                        "name a point that is there");
    const auto i = static_cast<std::size_t>(p);
    if (!detail::same(m.points[i][2], m.points[static_cast<std::size_t>(m.facets[0][0])][2]))
      throw input_error(input_fault::not_planar, i + 1, m.name_point(i) + " is not as high as point " + std::to_string(m.facets[0][0] + 1),
                        "give all points of the facet the same z");
    r.points.push_back({m.points[i][0], m.points[i][1]});
    r.lines.push_back(m.point_lines[i]);
  }
  return result;
}

/// The format of a file by the end of its name, or else by the first characters of its text.
inline format guess_format(std::string_view name, std::string_view text) {
  const auto ends = [&](std::string_view extension) {
    if (name.size() < extension.size()) return false;
    const std::string_view last = name.substr(name.size() - extension.size());
    return std::equal(last.begin(), last.end(), extension.begin(), [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  };
  if (ends(".xy") || ends(".txt")) return format::xy;
  if (ends(".wkt")) return format::wkt;
  if (ends(".geojson") || ends(".json")) return format::geojson;
  if (ends(".obj")) return format::obj;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    const char c = text.front();
    if (c == '#') {  // a comment of .xy or OBJ
      const std::size_t line = text.find_first_of("\r\n");
      text.remove_prefix(line == std::string_view::npos ? text.size() : line);
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      text.remove_prefix(1);
    } else if (c == '{' || c == '[') {
      return format::geojson;
    } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
      return word == "v" || word == "f" || obj::ignored(word) ? format::obj : format::wkt;
    } else {
      break;
    }
  }
  return format::xy;
}

/// Reads a polygon in the format of guess_format. `name` is the file's, for messages. Throws input_error. Linear time.
template <class Int>
rings<Int> read_polygon(std::istream& in, const std::string& name) {
  if (!in.good()) throw input_error(input_fault::unreadable, 0, name + ": the file cannot be read", "check the file");
  std::string head(1U << 16U, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw input_error(input_fault::unreadable, 0, name + ": reading failed", "check the file");
  const format f = guess_format(name, head);
  detail::rewound whole(std::move(head), in.rdbuf());
  std::istream text(&whole);
  switch (f) {
    case format::wkt:
      return read_wkt<Int>(text, name);
    case format::geojson:
      return read_geojson<Int>(text, name);
    case format::obj:
      return read_flat_obj<Int>(text, name);
    case format::xy:
      break;
  }
  return read_xy<Int>(text, name);
}

/// Rings from doubles, taken exactly; the first is the outer one, all others are holes. `weights`, if any, are those of the edges that start at
/// the points. A last point that repeats the first of its ring is dropped. Throws input_error(bad_number) for NaN and infinities.
template <class Int>
rings<Int> make_rings(const std::vector<std::vector<std::array<double, 2>>>& points, const std::vector<std::vector<double>>& weights = {}) {
  rings<Int> result;
  if (!weights.empty() && weights.size() != points.size())
    throw input_error(input_fault::bad_weight, 0,
                      "there are weights for " + std::to_string(weights.size()) + " of " + std::to_string(points.size()) + " rings",
                      "give every ring its weights, or none any");
  for (std::size_t r = 0; r < points.size(); ++r) {
    auto& ring = result.all.emplace_back();
    const auto exact = [&](double x, std::size_t i, const char* what) {
      auto value = from_double<Int>(x);
      if (!value)
        throw input_error(input_fault::bad_number, i + 1,
                          "ring " + std::to_string(r + 1) + ", point " + std::to_string(i + 1) + " has a " + what + " that is not finite",
                          "give finite numbers");
      return std::move(*value);
    };
    for (std::size_t i = 0; i < points[r].size(); ++i)
      ring.points.push_back({exact(points[r][i][0], i, "coordinate"), exact(points[r][i][1], i, "coordinate")});
    if (!weights.empty() && !weights[r].empty()) {
      if (weights[r].size() != points[r].size())
        throw input_error(input_fault::bad_weight, r + 1,
                          "ring " + std::to_string(r + 1) + " has " + std::to_string(weights[r].size()) + " weights for " +
                              std::to_string(points[r].size()) + " points",
                          "give every point the weight of the edge that starts there, or none any");
      for (std::size_t i = 0; i < weights[r].size(); ++i) ring.weights.push_back(exact(weights[r][i], i, "weight"));
    }
    detail::drop_closing_point<Int>(ring);
  }
  return result;
}

}  // namespace osteon::plane
