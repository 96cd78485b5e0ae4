// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reads polygons as GeoJSON, decimals exactly. Source: RFC 7946.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/json_source.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/rings.hpp"

namespace osteon::plane {

namespace detail {

/// The reader of GeoJSON, without recursion.
template <class Int>
class geojson_reader {
 public:
  geojson_reader(std::istream& in, const std::string& name, std::string_view expected) : json_(in, name, expected) { result_.file = name; }

  /// Reads the whole text. To be called once.
  rings<Int> read() {
    if (json_.next() != token::begin_object) fail(input_fault::not_polygon, "the text does not begin with an object", json_.source().hint());
    objects_.emplace_back();
    while (!objects_.empty()) {
      const token t = json_.next();
      if (objects_.back().in_list) {
        read_item(t);
      } else if (t == token::end_object) {
        finish(objects_.back());
        objects_.pop_back();
      } else {
        read_member(json_.text());  // t is a key: nothing else can come
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

  // An item of a list of features or geometries, or its end.
  void read_item(token t) {
    if (t == token::end_array)
      objects_.back().in_list = false;
    else if (t == token::begin_object)
      objects_.emplace_back();
    else
      fail(input_fault::not_polygon, "a list of features or geometries with something else in it", json_.source().hint());
  }

  void read_member(std::string key) {
    object& o = objects_.back();
    const token value = json_.next();
    if (key == "type") {
      if (value != token::string || !o.type.empty()) fail(input_fault::not_polygon, "a type that is no text, or a second one", json_.source().hint());
      o.type = json_.text();
    } else if (key == "coordinates") {
      if (value != token::begin_array || !o.rings.empty())
        fail(input_fault::not_polygon, "coordinates that are no list, or a second list", json_.source().hint());
      read_coordinates(o);
    } else if (key == "geometry" && value == token::begin_object) {
      objects_.emplace_back();
    } else if ((key == "features" || key == "geometries") && value == token::begin_array) {
      o.in_list = true;
    } else {
      json_.skip(value);
    }
  }

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
            if (!in_ring) o.rings.emplace_back().part = part;
            in_ring = true;
          }
          read_coordinate(o.rings.back(), count++);
          empty = false;
          break;
        case token::end_array:
          if (empty) fail(input_fault::empty, "an empty list of coordinates", "leave out what is empty");
          if (depth == o.depth && count < 2) fail(input_fault::bad_number, "a point with one coordinate", "give x and y");
          if (depth + 1 == o.depth) {
            drop_closing_point(o.rings.back());
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

  // The number just read is coordinate `count` of a point.
  void read_coordinate(ring& r, std::size_t count) {
    if (count == 0) {
      json_.source().count_point(json_.source().line());
      r.points.emplace_back();
      r.lines.push_back(json_.source().line());
    }
    if (count < 2) r.points.back()[count] = json_.source().template number<Int>(json_.text());
    if (count == 2) ++heights_;
  }

  // The rings of a polygon's object go to the result, as parts of their own.
  void finish(object& o) {
    if (o.type.empty()) fail(input_fault::not_polygon, "an object without a type", json_.source().hint());
    if (o.type == "Feature" || o.type == "FeatureCollection" || o.type == "GeometryCollection") return;
    const bool several = o.type == "MultiPolygon";
    if (!several && o.type != "Polygon") fail(input_fault::not_polygon, quote(o.type) + " is no polygon", json_.source().hint());
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
  std::vector<object> objects_;  // from the outermost one to that being read
  rings<Int> result_;
  int parts_ = 0;
  std::size_t heights_ = 0;
};

}  // namespace detail

/// Reads GeoJSON: a Polygon, a MultiPolygon, or a Feature, FeatureCollection or GeometryCollection
/// of these; every polygon becomes a part. Heights and members that are no geometry are left out.
/// Closing points are dropped. `name` of the text and what is `expected` in it are for messages.
/// *Throws* input_error.
/// *Complexity* linear.
template <class Int>
rings<Int> read_geojson(std::istream& in, const std::string& name,
                        std::string_view expected = "GeoJSON: Polygon, MultiPolygon or features of these") {
  return detail::geojson_reader<Int>(in, name, expected).read();
}

}  // namespace osteon::plane
