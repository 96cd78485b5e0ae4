// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Opens what a command reads, tells polygons from polyhedra, and says what the command takes
/// where the text is something else.

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

#include "osteon/door/polygon.hpp"

namespace osteon::app {

/// Lists, for `--help` and messages, the forms in which a polygon may come.
inline constexpr const char* polygon_formats =
    "a polygon as .xy text (x y [weight] a line, rings after blank lines), WKT, GeoJSON or an OBJ file with one flat face";

/// What a command takes.
enum class subject : std::uint8_t { polyhedron, polygon, either };

/// A text that is open for reading: a file, or standard input where the name is "-".
class input_text {
 public:
  /// Opens a text for the command of this name. The text's first word tells its form, or else the
  /// end of the file's name. *Throws* input_error where there is no such file, where the form
  /// cannot be told, and where the text is not what the command takes.
  input_text(const std::string& file, const std::string& command, subject takes);

  /// Returns the text's name for messages.
  const std::string& name() const { return name_; }
  /// Returns the text's form, never `guessed`; polyhedra have the form `obj`.
  polygon_format format() const { return format_; }
  /// Returns whether it is a polygon's: an OBJ text is where it has a single facet. Of an OBJ text
  /// that cannot be read twice, like standard input, the command decides: a polyhedron where it
  /// takes both.
  bool is_polygon() const { return is_polygon_; }
  /// Returns the stream, at the text's beginning.
  std::istream& stream() { return *stream_; }

 private:
  std::string name_;
  std::unique_ptr<std::istream> stream_;
  polygon_format format_ = polygon_format::obj;
  bool is_polygon_ = false;
};

/// Opens any other file. *Throws* input_error.
std::unique_ptr<std::istream> open_file(const std::string& file);

}  // namespace osteon::app
