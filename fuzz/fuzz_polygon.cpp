// SPDX-License-Identifier: MIT

// The readers of polygons on any bytes: rings that keep their promises or an input error that a terminal can print; what is then accepted as a
// polygon has a skeleton with a certificate, or encloses a part that never vanishes.

#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include "check.hpp"
#include "input_error.hpp"
#include "osteon/core/error.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "planar_skeletons.hpp"

namespace osteon::fuzz {
namespace {

std::size_t points_of(const plane::rings<integer>& r) {
  std::size_t count = 0;
  for (const auto& ring : r.all) {
    require(ring.weights.empty() || ring.weights.size() == ring.points.size(), "a ring has as many weights as points");
    require(ring.lines.empty() || ring.lines.size() == ring.points.size(), "a ring has as many lines as points");
    count += ring.points.size();
  }
  return count;
}

void check_polygon(const plane::polygon<integer>& p) {
  const std::size_t n = p.points.size();
  require(n >= 3 && p.parts >= 1 && p.holes >= 0, "a polygon has three vertices");
  require(p.boundary.next.size() == n && p.boundary.line.size() == n && p.boundary.rank.size() == n && p.input_points.size() == n,
          "lists are complete");
  for (std::size_t e = 0; e < n; ++e) {
    const auto& l = p.lines[static_cast<std::size_t>(p.boundary.line[e])];
    for (const std::size_t end : {e, static_cast<std::size_t>(p.boundary.next[e])})
      require(l.n[0] * p.points[end][0] + l.n[1] * p.points[end][1] == l.d, "an edge lies on its line");
  }
}

void run(const std::string& text) {
  plane::rings<integer> rings;
  try {
    std::istringstream in(text);
    rings = plane::read_polygon<integer>(in, "input");
  } catch (const input_error& e) {
    check_error(e);
    tally::add("refused by the reader");
    return;
  }
  const std::size_t count = points_of(rings);
  require(count <= text.size(), "a polygon is not larger than its file");
  // Numbers of a thousand digits are slow to build with.
  if (count > 64 || text.size() > 2048) {
    tally::add("read");
    return;
  }
  for (const bool outside : {false, true}) {
    plane::polygon<integer> p;
    try {
      p = plane::make_polygon(rings, outside);
    } catch (const input_error& e) {
      check_error(e);
      tally::add("refused as a polygon");
      continue;
    }
    check_polygon(p);
    try {
      certified(planar_kernel_of(p), p, outside);
      tally::add("a skeleton");
    } catch (const unsupported_error&) {
      require(has_stationary_edge(p), "only held edges enclose what never vanishes");
      tally::add("never vanishes");
    }
  }
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(std::string(data, data + size));
  return 0;
}
