// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Polygons as a caller has them: rings of points, and a weight for each edge.

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/door/decimal.hpp"

namespace osteon {

/// Which side of a polygon's boundary is meant.
enum class region : std::uint8_t {
  interior,  ///< edges move inwards
  /// edges move outwards: the polygon grows and its holes shrink; some vertices move for ever
  exterior
};

/// When a polygon is checked.
enum class checking : std::uint8_t {
  now,   ///< at once
  later  ///< by skeletonize, which spares a copy of the input: for very large polygons
};

/// A polygon with holes, or several that have no common interior. A value: copies are independent.
/// Coordinates and weights are exact.
///
/// Points and edges are numbered from 0 through all rings, as they were given: edge i starts at
/// point i of its ring. An edge of weight w moves w times as fast as one of weight 1, which all
/// have at first; an edge of weight 0 stands still. *Repaired*, and said by notes(): points that
/// repeat their predecessor, points on a straight side, rings of the wrong orientation, boundaries
/// that touch without crossing.
///
/// *Threads*: const members may be called from several threads at once.
class polygon {
 public:
  using point = std::array<double, 2>;

  /// Makes a polygon without holes. *Throws* input_error naming the fault, the element and a hint.
  explicit polygon(const std::vector<point>& ring, checking when = checking::now);
  /// Makes a polygon from an outer ring and holes. *Throws* input_error.
  explicit polygon(const std::vector<std::vector<point>>& rings, checking when = checking::now);

  polygon(const polygon& other);
  polygon(polygon&& other) noexcept;
  polygon& operator=(const polygon& other);
  polygon& operator=(polygon&& other) noexcept;
  ~polygon();

  /// Returns the number of edges, which is that of the points.
  int edges() const;
  /// Returns the rings as they were given, rounded to doubles.
  std::vector<std::vector<point>> rings() const;
  /// Returns the weight of an edge, rounded to a double. *Throws* input_error(bad_index).
  double weight(int edge) const;
  /// Sets the weight of an edge; see weight_of_angle for roofs. *Throws* input_error: bad_index,
  /// bad_number, or bad_weight where it is less than zero.
  void set_weight(int edge, const decimal& weight);
  /// Sets the weight of all edges. *Throws* as set_weight.
  void set_weights(const decimal& weight);

  /// Checks that this is a polygon, which skeletonize does too. *Throws* input_error. *Complexity*:
  /// n log n.
  void check();
  /// Returns what was left out, and, once the polygon is checked, what was repaired: one sentence
  /// each.
  std::vector<std::string> notes() const;

  /// What the library has made of the rings. Opaque.
  struct data;
  /// Returns it.
  const data& access() const { return *data_; }
  /// Returns it for moving from.
  data& access() { return *data_; }
  /// Takes it.
  explicit polygon(std::unique_ptr<data> d);

 private:
  std::unique_ptr<data> data_;
};

/// The form of a polygon's text.
enum class polygon_format : std::uint8_t {
  guessed,  ///< by the end of the name, else by the first characters of the text
  xy,
  wkt,
  geojson,
  obj
};

/// Reads a polygon: .xy text (`x y [weight]` a line, rings after blank lines), WKT, GeoJSON, or OBJ
/// with one flat facet; by the end of the name, else by the text. Decimals are taken exactly.
/// *Throws* input_error naming the line.
polygon read_polygon(const std::string& file, checking when = checking::now);
/// Reads a polygon from a stream; `name` is for messages, and its end may tell the format.
polygon read_polygon(std::istream& in, const std::string& name, checking when = checking::now, polygon_format format = polygon_format::guessed);

/// Returns whether a file or text holds a polygon and no polyhedron, by its name's end (an OBJ
/// file: whether it has one facet only), else by the first characters of the text. Nothing is
/// checked.
bool is_polygon_file(const std::string& file);
/// Returns whether a text begins like a polygon in any format but OBJ.
bool is_polygon_text(std::string_view text);

/// Returns the weight of an edge whose roof rises at this angle against the horizontal, where the
/// roof's slope is 1: the cotangent; 90 gives 0, a gable. *Throws* input_error unless 0 < degrees
/// <= 90.
double weight_of_angle(double degrees);

}  // namespace osteon
