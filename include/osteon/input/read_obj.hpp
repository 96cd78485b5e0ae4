// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads Wavefront OBJ: points and polygons, decimals exactly.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/mesh.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/obj_lines.hpp"
#include "osteon/input/text_source.hpp"

namespace osteon {

namespace obj {

/// Returns the point of a statement `v`: three coordinates, and a weight or a colour that are left
/// out.
template <class Int>
std::array<exact_number<Int>, 3> read_point(const line_reader& lines, std::string_view rest) {
  std::array<exact_number<Int>, 3> point;
  std::size_t count = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest), ++count) {
    auto value = lines.decimal<Int>(word);
    if (count < 3) point[count] = std::move(value);
  }
  if (count < 3 || count == 5 || count > 7)
    lines.fail(input_fault::bad_number, "a point with " + std::to_string(count) + " coordinates", "give x, y and z");
  return point;
}

/// Returns whether a text is the rest of a corner after its point: "", "/7", "/7/8", "//8". The
/// numbers are not looked at.
inline bool is_texture_and_normal(std::string_view text) {
  return text.empty() ||
         (text[0] == '/' && std::count(text.begin(), text.end(), '/') <= 2 && text.find_first_not_of("/-0123456789") == std::string_view::npos);
}

/// Returns the points of a statement `f`, from 0. Negative numbers count backwards from the last of
/// `points` so far.
inline std::vector<int> read_facet(const line_reader& lines, std::string_view rest, long points) {
  std::vector<int> facet;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    long index = 0;
    const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool whole = ec == std::errc() && is_texture_and_normal(word.substr(static_cast<std::size_t>(end - word.data())));
    if (!whole || index == 0)
      lines.fail(input_fault::bad_index, quote(word) + " is not the number of a point", "count points from 1, or from -1 backwards");
    if (index < -points)
      lines.fail(input_fault::bad_index, "there is no point " + std::to_string(index) + " before this line",
                 "name one of the " + std::to_string(points) + " points");
    if (index > static_cast<long>(most_points))
      lines.fail(input_fault::bad_index, "there is no point " + std::to_string(index), "name a point of the file");
    facet.push_back(static_cast<int>(index > 0 ? index - 1 : points + index));
  }
  if (facet.size() < 3)
    lines.fail(input_fault::short_facet, "a facet with " + std::to_string(facet.size()) + " corners", "give at least three, or delete the line");
  return facet;
}

}  // namespace obj

/// Reads points (`v`) and polygons (`f`, with texture and normal indices, negative indices).
/// Groups, materials, normals and textures are skipped; lines, curves and surfaces are refused.
/// Facets may name points that do not exist: make_solid looks at that. `name` of the text is for
/// messages.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
input_mesh<Int> read_obj(std::istream& in, const std::string& name) {
  input_mesh<Int> m;
  m.file = name;
  std::size_t corners = 0;
  bool any = false;
  obj::line_reader lines(in, name);
  while (lines.next()) {
    any = true;
    std::string_view rest = lines.text();
    const std::string_view keyword = obj::next_word(rest);
    if (keyword.empty() || obj::is_ignored(keyword)) continue;
    if (keyword == "v") {
      lines.count_point();
      m.points.push_back(obj::read_point<Int>(lines, rest));
      m.point_lines.push_back(lines.number());
    } else if (keyword == "f") {
      m.facets.push_back(obj::read_facet(lines, rest, static_cast<long>(m.points.size())));
      m.facet_lines.push_back(lines.number());
      corners += m.facets.back().size();
      if (corners > most_corners) lines.fail(input_fault::absurd_size, "more than sixty million corners", "give a smaller model");
    } else if (obj::is_other_geometry(keyword)) {
      lines.fail(input_fault::not_obj, quote(keyword) + " is no polygon", "export the model as polygons only");
    } else {
      lines.fail(input_fault::not_obj, quote(keyword) + " is no statement of an OBJ file", lines.hint());
    }
  }
  const auto refuse = [&](const std::string& what, const std::string& hint) { throw input_error(input_fault::empty, 0, name + ": " + what, hint); };
  if (!any) refuse("the file is empty", lines.hint());
  if (m.points.empty() && m.facets.empty()) refuse("there are neither points nor facets", lines.hint());
  if (m.facets.empty()) refuse("there are no facets", "give facets (f)");
  if (m.points.empty()) refuse("there are no points", "give points (v)");
  return m;
}

}  // namespace osteon
