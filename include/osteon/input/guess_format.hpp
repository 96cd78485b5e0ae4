// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Finds the format of a polygon's text.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "osteon/input/obj_lines.hpp"

namespace osteon::plane {

/// The formats in which polygons are read.
enum class format : std::uint8_t { xy, wkt, geojson, obj };

/// Returns the format that the ending of a file's name stands for, in any case: .xy or .txt, .wkt,
/// .geojson or .json, .obj; nothing for other names.
inline std::optional<format> format_of_name(std::string_view name) {
  const auto ends = [&](std::string_view extension) {
    if (name.size() < extension.size()) return false;
    const std::string_view last = name.substr(name.size() - extension.size());
    return std::equal(last.begin(), last.end(), extension.begin(), [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  };
  if (ends(".xy") || ends(".txt")) return format::xy;
  if (ends(".wkt")) return format::wkt;
  if (ends(".geojson") || ends(".json")) return format::geojson;
  if (ends(".obj")) return format::obj;
  return std::nullopt;
}

/// Returns the rest of a text behind blanks and comments (from '#' to the end of the line).
inline std::string_view skip_blanks_and_comments(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // UTF-8's byte order mark
  while (!text.empty() && (text[0] == '#' || std::isspace(static_cast<unsigned char>(text[0])) != 0)) {
    const std::size_t size = text[0] == '#' ? text.find_first_of("\r\n") : 1;
    text.remove_prefix(std::min(size, text.size()));
  }
  return text;
}

/// Returns the format that the first word of a text tells: GeoJSON begins with a bracket, OBJ with
/// a statement, well-known text with the name of a geometry, lines of points with a number; nothing
/// where the word is none of these.
inline std::optional<format> format_of_text(std::string_view text) {
  static constexpr std::array<std::string_view, 8> geometries = {"MULTIPOLYGON",    "POLYGON", "POINT",      "LINESTRING",
                                                                 "MULTILINESTRING", "SRID",    "MULTIPOINT", "GEOMETRYCOLLECTION"};
  text = skip_blanks_and_comments(text);
  if (text.empty()) return std::nullopt;
  if (text[0] == '{' || text[0] == '[') return format::geojson;
  const std::size_t digit = text.find_first_not_of("+-.");
  if (digit < 3 && std::isdigit(static_cast<unsigned char>(text[digit])) != 0) return format::xy;
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n(=;"));
  if (obj::is_keyword(word) || obj::is_other_geometry(word)) return format::obj;
  const auto begins_with = [&](std::string_view name) {  // Z, M or ZM may follow
    return word.size() >= name.size() && word.size() <= name.size() + 2 &&
           std::equal(name.begin(), name.end(), word.begin(), [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); }) &&
           word.find_first_not_of("zmZM", name.size()) == std::string_view::npos;
  };
  return std::any_of(geometries.begin(), geometries.end(), begins_with) ? std::optional(format::wkt) : std::nullopt;
}

/// Returns the format of a file by the ending of its name, or else by the first word of its text; a
/// text that tells nothing is taken for lines of points.
inline format guess_format(std::string_view name, std::string_view text) {
  const auto named = format_of_name(name);
  return named ? *named : format_of_text(text).value_or(format::xy);
}

}  // namespace osteon::plane
