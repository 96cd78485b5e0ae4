// SPDX-License-Identifier: MIT

/// \file
/// Generated models of the door.

#include "osteon/door/models.hpp"

#include <algorithm>
#include <ostream>

#include "osteon/core/error.hpp"
#include "osteon/input/write_obj.hpp"
#include "osteon/input/write_xy.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/registry.hpp"

namespace osteon {
namespace {

template <class Kinds>
void list(std::vector<model_kind>& to, const Kinds& kinds, bool polygons) {
  for (const auto& k : kinds) to.push_back({k.name, k.size, k.default_size, k.least_size, k.greatest_size, polygons});
}

}  // namespace

const std::vector<model_kind>& model_kinds() {
  static const std::vector<model_kind> all = [] {
    std::vector<model_kind> kinds;
    list(kinds, models::kinds(), false);
    list(kinds, plane::models::kinds(), true);
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
    plane::write_xy(out, models::find_kind(plane::models::kinds(), kind)->make(size, seed));
  else
    write_obj(out, models::find_kind(models::kinds(), kind)->make(size, seed).template take<integer>());
}

}  // namespace osteon
