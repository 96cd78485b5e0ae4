// SPDX-License-Identifier: MIT

/// \file
/// Generated models of the door.

#include "osteon/door/models.hpp"

#include <algorithm>
#include <ostream>

#include "osteon/core/error.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polygons.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon {
namespace {

constexpr int greatest_polyhedron = 1000;

template <class Kinds>
const auto& find(const Kinds& kinds, std::string_view name) {
  return *std::find_if(kinds.begin(), kinds.end(), [name](const auto& k) { return k.name == name; });
}

void write_obj(std::ostream& out, const input_mesh<integer>& m) {
  for (const auto& p : m.points) out << "v " << p[0].mantissa << ' ' << p[1].mantissa << ' ' << p[2].mantissa << '\n';
  for (const auto& f : m.facets) {
    out << 'f';
    for (const int corner : f) out << ' ' << corner + 1;
    out << '\n';
  }
}

}  // namespace

const std::vector<model_kind>& model_kinds() {
  static const std::vector<model_kind> all = [] {
    std::vector<model_kind> kinds;
    for (const auto& k : models::kinds())
      kinds.push_back({std::string(k.name), std::string(k.size), k.default_size, k.least_size, greatest_polyhedron, false});
    for (const auto& k : plane::models::kinds())
      kinds.push_back({std::string(k.name), std::string(k.size), k.default_size, k.least_size, k.greatest_size, true});
    return kinds;
  }();
  return all;
}

void write_model(std::ostream& out, std::string_view kind, int size, std::uint64_t seed) {
  const auto& all = model_kinds();
  const auto found = std::find_if(all.begin(), all.end(), [kind](const model_kind& k) { return k.name == kind; });
  if (found == all.end()) throw input_error(input_fault::bad_index, 0, "there is no model '" + std::string(kind) + "'", "take one of model_kinds()");
  if (size < found->least_size || size > found->greatest_size)
    throw input_error(input_fault::absurd_size, 0, found->name + " has no size " + std::to_string(size),
                      "give one from " + std::to_string(found->least_size) + " to " + std::to_string(found->greatest_size));
  if (found->is_polygon)
    out << plane::models::to_xy(find(plane::models::kinds(), kind).make(size, seed));
  else
    write_obj(out, find(models::kinds(), kind).make(size, seed).template take<integer>());
}

}  // namespace osteon
