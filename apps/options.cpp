// SPDX-License-Identifier: MIT

#include "options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace osteon::app {

CLI::Validator number_that(std::function<bool(double)> holds, const std::string& what) {
  return CLI::Validator(
      [holds = std::move(holds), what](const std::string& text) {
        double x = 0;
        return CLI::detail::lexical_cast(text, x) && holds(x) ? std::string() : text + " is no " + what;
      },
      "");
}

CLI::Validator finite_number(std::optional<double> least) {
  return number_that([least](double x) { return std::isfinite(x) && (!least || x >= *least); },
                     "finite number" + (least ? fmt::format(" of at least {}", *least) : ""));
}

void add_kernel(CLI::App& command, std::string& kernel, const std::string& what) {
  command.add_option("--kernel", kernel, what)->check(CLI::IsMember({"sqrt", "rational", "double"}))->capture_default_str();
}

void model::add_to(CLI::App& command, const std::string& what) {
  command.add_option("FILE", file, what + "; - for standard input")->required();
  command.add_flag("--flip", repairs.flip, "reverse all facets, for a model whose normals point inwards");
  command.add_flag("--triangulate", repairs.triangulate, "cut facets that are not planar into triangles");
}

polyhedron model::read(const std::string& command) const { return read(input_text(file, command, subject::polyhedron)); }
polyhedron model::read(input_text text) const { return read_polyhedron(text.stream(), text.name(), repairs); }

int vertex_at(const polyhedron& p, const std::string& file, int point) {
  try {
    return p.vertex_at(point - 1);
  } catch (const input_error& e) {  // the library counts from 0
    throw input_error(e.fault, e.element, fmt::format("{}: point {} is no vertex of the solid", file, point), e.hint);
  }
}

polygon read_polygon_text(input_text text, checking when) { return read_polygon(text.stream(), text.name(), when, text.format()); }

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) fmt::print(stderr, "osteon: note: {}\n", note);
}

void demand_certified(const std::optional<skeleton_refutation>& refuted) {
  if (refuted) throw invariant_error(fmt::format("the certificate is refuted: {}: {}", refuted->rule, refuted->witness));
}

}  // namespace osteon::app
