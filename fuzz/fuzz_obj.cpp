// SPDX-License-Identifier: MIT

// The OBJ reader on any bytes: a mesh that keeps its promises or an input error that a terminal can print, and what the reader
// takes does not crash the builder either.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "check.hpp"
#include "input_error.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon::fuzz {
namespace {

void check_mesh(const input_mesh<integer>& m, std::size_t bytes) {
  require(!m.points.empty() && !m.facets.empty(), "a mesh has points and facets");
  require(m.points.size() <= bytes && m.facets.size() <= bytes, "a mesh is not larger than its file");
  require(m.point_lines.size() == m.points.size() && m.facet_lines.size() == m.facets.size(), "every element has a line");
  require(std::is_sorted(m.point_lines.begin(), m.point_lines.end()) && std::is_sorted(m.facet_lines.begin(), m.facet_lines.end()), "lines ascend");
  for (const auto& f : m.facets) {
    require(f.size() >= 3, "a facet has three corners");
    require(std::all_of(f.begin(), f.end(), [](int p) { return p >= 0; }), "indices are counted from zero");
  }
}

void run(const std::string& text) {
  input_mesh<integer> m;
  try {
    std::istringstream in(text);
    m = read_obj<integer>(in, "input.obj");
  } catch (const input_error& e) {
    check_error(e);
    tally::add("refused by the reader");
    return;
  }
  check_mesh(m, text.size());
  // Numbers of a thousand digits are slow to build with.
  if (m.points.size() > 64 || m.facets.size() > 64 || text.size() > 8192) {
    tally::add("read");
    return;
  }
  try {
    make_solid(std::move(m));
    tally::add("a solid");
  } catch (const input_error& e) {
    check_error(e);
    tally::add("refused by the builder");
  }
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(std::string(data, data + size));
  return 0;
}
