// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Taking numbers and lists out of JSON texts of strangers: what is not of the expected shape
/// is an error that names the element.

#include <algorithm>
#include <array>
#include <cstdint>
#include <istream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "options.hpp"
#include "osteon/osteon.hpp"

namespace osteon::app {

using json = nlohmann::ordered_json;

/// The formats of documents, as their member `format` names them: of polyhedra and of polygons.
inline constexpr const char* skeleton_format = "osteon skeleton 2";
inline constexpr const char* planar_format = "osteon planar skeleton 1";

/// Base of the readers of skeleton documents. All throw input_error(not_skeleton).
class json_reader {
 public:
  /// `name`: the file's.
  explicit json_reader(std::string name) : name_(std::move(name)) {}

 protected:
  json parse(std::istream& in, const std::string& format) const {
    json doc = json::parse(in, nullptr, false);
    if (doc.is_discarded()) wrong("", "this is no JSON text");
    const std::string found = text(doc, "format", "");
    if (found != format && found == planar_format) wrong("", "this is the skeleton of a polygon, and the model is a polyhedron");
    if (found != format && found == skeleton_format) wrong("", "this is the skeleton of a polyhedron, and the model is a polygon");
    if (found != format) wrong("format", "is not \"" + format + '"');
    return doc;
  }

  [[noreturn]] void wrong(const std::string& at, const std::string& what) const {
    throw input_error(input_fault::not_skeleton, 0, name_ + ": " + (at.empty() ? "" : at + " ") + what,
                      "give a file that `osteon skeleton --output` has written");
  }

  const json& member(const json& of, const char* key, const std::string& at) const {
    if (!of.is_object() || !of.contains(key)) wrong(at.empty() ? key : at + "." + key, "is missing");
    return of[key];
  }
  std::string text(const json& of, const char* key, const std::string& at) const {
    const json& value = member(of, key, at);
    if (!value.is_string()) wrong(at.empty() ? key : at + "." + key, "is no text");
    return value.get<std::string>();
  }
  int whole(const json& value, const std::string& at) const {
    if (!value.is_number_integer() || (value.is_number_unsigned() && value.get<std::uint64_t>() > std::numeric_limits<int>::max()) ||
        value.get<std::int64_t>() > std::numeric_limits<int>::max() || value.get<std::int64_t>() < std::numeric_limits<int>::min())
      wrong(at, "is no whole number of 32 bits");
    return value.get<int>();
  }
  int whole(const json& of, const char* key, const std::string& at) const { return whole(member(of, key, at), at + "." + key); }
  std::vector<int> list(const json& of, const char* key, const std::string& at) const { return list(member(of, key, at), at + "." + key); }
  std::vector<int> list(const json& value, const std::string& at) const {
    if (!value.is_array()) wrong(at, "is no list");
    std::vector<int> result;
    for (std::size_t i = 0; i < value.size(); ++i) result.push_back(whole(value[i], at + "[" + std::to_string(i) + "]"));
    return result;
  }
  template <std::size_t N>
  std::array<int, N> tuple(const json& of, const char* key, const std::string& at) const {
    const std::vector<int> numbers = list(of, key, at);
    if (numbers.size() != N) wrong(at + "." + key, "needs " + std::to_string(N) + " numbers");
    std::array<int, N> result{};
    std::copy(numbers.begin(), numbers.end(), result.begin());
    return result;
  }
  bool truth(const json& of, const char* key, const std::string& at) const {
    const json& value = member(of, key, at);
    if (!value.is_boolean()) wrong(at.empty() ? key : at + "." + key, "is neither true nor false");
    return value.get<bool>();
  }
  template <class Value>
  Value choice(const json& of, const char* key, const std::map<std::string, Value>& choices) const {
    const auto found = choices.find(text(of, key, ""));
    if (found == choices.end()) wrong(key, "is no choice of this program");
    return found->second;
  }
  /// Digits of a whole number of any size.
  std::string exact_number(const json& value, const std::string& at) const {
    const std::string digits = value.is_string() ? value.get<std::string>() : "";
    const std::size_t sign = digits.starts_with('-') ? 1 : 0;
    if (digits.size() == sign || digits.find_first_not_of("0123456789", sign) != std::string::npos) wrong(at, "is no whole number in quotes");
    return digits;
  }
  /// A line or plane.
  template <int D>
  exact_plane<D> plane(const json& of, const std::string& at) const {
    const json& n = member(of, "n", at);
    if (!n.is_array() || n.size() != D) wrong(at + ".n", "needs " + std::to_string(D) + " numbers");
    exact_plane<D> result;
    for (std::size_t axis = 0; axis < D; ++axis) result.n[axis] = exact_number(n[axis], at + ".n");
    result.d = exact_number(member(of, "d", at), at + ".d");
    result.weight = exact_number(member(of, "weight", at), at + ".weight");
    return result;
  }
  template <class Visit>
  void for_each(const json& of, const char* key, Visit visit, const std::string& at = "") const {
    const json& all = member(of, key, at);
    const std::string path = at.empty() ? key : at + "." + key;
    if (!all.is_array()) wrong(path, "is no list");
    for (std::size_t i = 0; i < all.size(); ++i) visit(all[i], path + "[" + std::to_string(i) + "]");
  }

 private:
  std::string name_;
};

}  // namespace osteon::app
