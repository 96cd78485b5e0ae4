// SPDX-License-Identifier: MIT

#include "input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "osteon/osteon.hpp"

namespace osteon::app {
namespace {

constexpr std::size_t head_size = 1U << 16U;

/// A stream whose first characters have been taken already.
class resumed : public std::istream {
 public:
  resumed(std::string head, std::unique_ptr<std::istream> owned, std::istream& rest)
      : std::istream(nullptr), owned_(std::move(owned)), text_(std::move(head), *rest.rdbuf()) {
    rdbuf(&text_);
  }

 private:
  class buffer : public std::streambuf {
   public:
    buffer(std::string head, std::streambuf& rest) : text_(std::move(head)), rest_(rest) {
      setg(text_.data(), text_.data(), text_.data() + text_.size());
    }

   protected:
    int_type underflow() override {
      text_.resize(head_size);
      const auto size = rest_.sgetn(text_.data(), static_cast<std::streamsize>(text_.size()));
      setg(text_.data(), text_.data(), text_.data() + size);
      return size > 0 ? traits_type::to_int_type(text_[0]) : traits_type::eof();
    }

   private:
    std::string text_;
    std::streambuf& rest_;
  };

  std::unique_ptr<std::istream> owned_;
  buffer text_;
};

/// The rest of a text behind blanks and comments.
std::string_view skip_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // UTF-8's byte order mark
  while (!text.empty() && (text[0] == '#' || std::isspace(static_cast<unsigned char>(text[0])) != 0)) {
    const std::size_t end = text[0] == '#' ? text.find_first_of("\r\n") : 1;
    text.remove_prefix(std::min(end, text.size()));
  }
  return text;
}

/// The form that the first word of a text has, where no other form begins like that.
std::optional<polygon_format> format_of_text(std::string_view text) {
  static constexpr std::array<std::string_view, 8> geometries = {"POINT",           "LINESTRING",         "POLYGON", "MULTIPOINT", "MULTIPOLYGON",
                                                                 "MULTILINESTRING", "GEOMETRYCOLLECTION", "SRID"};
  static constexpr std::array<std::string_view, 14> statements = {"v", "vt", "vn", "vp", "f",      "l",      "p",
                                                                  "g", "o",  "s",  "mg", "usemtl", "mtllib", "usemap"};
  text = skip_blanks(text);
  if (text.empty()) return std::nullopt;
  if (text[0] == '{') return polygon_format::geojson;
  const std::size_t digit = text.find_first_not_of("+-.");
  if (digit < 3 && std::isdigit(static_cast<unsigned char>(text[digit])) != 0) return polygon_format::xy;
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n(=;"));
  if (std::find(statements.begin(), statements.end(), word) != statements.end()) return polygon_format::obj;
  std::string capitals(word.substr(0, 40));
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string_view geometry : geometries)  // Z, M or ZM may follow
    if (capitals.starts_with(geometry) && capitals.find_first_not_of("ZM", geometry.size()) == std::string::npos) return polygon_format::wkt;
  return std::nullopt;
}

std::optional<polygon_format> format_of_name(const std::string& file) {
  static constexpr std::array<std::pair<std::string_view, polygon_format>, 6> endings = {{{".obj", polygon_format::obj},
                                                                                          {".xy", polygon_format::xy},
                                                                                          {".txt", polygon_format::xy},
                                                                                          {".wkt", polygon_format::wkt},
                                                                                          {".geojson", polygon_format::geojson},
                                                                                          {".json", polygon_format::geojson}}};
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto* found = std::find_if(endings.begin(), endings.end(), [&](const auto& e) { return e.first == ending; });
  return found == endings.end() ? std::nullopt : std::optional(found->second);
}

/// How many facets an OBJ text has: 0, 1, or 2 for more.
int count_facets(std::istream& in) {
  int facets = 0;
  for (std::string line; facets < 2 && std::getline(in, line);)
    if (const std::size_t at = line.find_first_not_of(" \t");
        at != std::string::npos && line[at] == 'f' && at + 1 < line.size() && line[at + 1] <= ' ')
      ++facets;
  return facets;
}

std::string what_is_taken(subject takes) {
  const std::string solid = "a closed polyhedron as Wavefront OBJ";
  return takes == subject::polyhedron ? solid : takes == subject::polygon ? polygon_formats : solid + ", or " + polygon_formats;
}

}  // namespace

std::unique_ptr<std::istream> open_file(const std::string& file) {
  errno = 0;
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  std::error_code ignored;
  const int cause = !*in ? errno : std::filesystem::is_directory(file, ignored) ? EISDIR : 0;
  if (cause != 0 || !*in)
    throw input_error(input_fault::unreadable, 0, file + ": cannot be opened (" + std::generic_category().message(cause) + ")", "check the name");
  return in;
}

input_text::input_text(const std::string& file, const std::string& command, subject takes) : name_(file == "-" ? "standard input" : file) {
  const auto refuse = [&](input_fault fault, const std::string& what) {
    throw input_error(fault, 0, name_ + ": " + what, "give " + what_is_taken(takes));
  };
  std::unique_ptr<std::istream> opened = file == "-" ? nullptr : open_file(file);
  std::istream& in = opened ? *opened : std::cin;
  std::string head(head_size, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));

  const std::optional<polygon_format> told = format_of_text(head);
  const std::optional<polygon_format> named = file == "-" ? std::nullopt : format_of_name(file);
  if (!told && !named && head.size() < head_size && skip_blanks(head).empty()) refuse(input_fault::empty, "there is nothing in it");
  if (!told && !named) refuse(input_fault::unreadable, "this is nothing that `osteon " + command + "` can read");
  format_ = told ? *told : *named;

  const bool is_file = opened && std::filesystem::is_regular_file(file);
  const auto rewind = [&in] {
    in.clear();
    in.seekg(0);
  };
  int facets = 2;  // of an OBJ text, as far as can be seen
  if (format_ == polygon_format::obj && is_file) {
    rewind();
    facets = count_facets(in);
  } else if (takes == subject::polygon) {
    std::istringstream beginning(head);
    facets = count_facets(beginning);
  }
  is_polygon_ = format_ != polygon_format::obj || facets == 1 || (takes == subject::polygon && facets == 0);
  if (takes == subject::polygon && !is_polygon_)
    refuse(input_fault::not_polygon, "an OBJ file with several facets is a solid, and `osteon " + command + "` takes polygons");
  if (takes == subject::polyhedron && is_polygon_)
    refuse(input_fault::not_obj, (format_ == polygon_format::obj ? "an OBJ file with one facet" : "this") +
                                     std::string(" is a polygon, and `osteon ") + command + "` takes polyhedra");
  if (is_file) {
    rewind();
    stream_ = std::move(opened);
  } else {
    stream_ = std::make_unique<resumed>(std::move(head), std::move(opened), in);
  }
}

}  // namespace osteon::app
