// SPDX-License-Identifier: MIT

/// \file
/// osteon roof.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "options.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

struct roof_command {
  std::string file;
  std::string output;
  double slope = 1;
  double eaves = 0;
  double angle = 45;
  std::vector<std::string> angles;
  bool walls = false;
  bool triangulate = false;
  bool summary = false;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("roof", "the roof over a polygon as a closed mesh: one face for each edge");
    c->add_option("FILE", file, std::string(polygon_formats) + "; - for standard input")->required();
    c->add_option("-o,--output", output, "the OBJ file; standard output where it is missing");
    auto* s = c->add_option("--slope", slope, "height for each unit that an edge of weight 1 has moved inwards")
                  ->check(number_that([](double x) { return std::isfinite(x) && x > 0; }, "finite number greater than 0"))
                  ->capture_default_str();
    auto* a = c->add_option("--angle", angle, "slope of all faces in degrees, above 0 and up to 90, in place of the file's weights")
                  ->check(number_that(is_angle, "angle above 0 and up to 90 degrees"));
    auto* e =
        c->add_option("--edge-angle", angles,
                      "N=DEGREES: slope of the face of the edge that starts at point N of the file, counted from 1 through all rings; 90 is a gable");
    c->add_option("--eaves", eaves, "height of the polygon")->check(finite_number(0))->capture_default_str();
    c->add_flag("--walls", walls, "walls from the eaves down to height 0");
    c->add_flag("--triangulate", triangulate, "cut all faces into triangles");
    c->add_flag("--summary", summary, "print one JSON object with counts and the greatest height");
    a->excludes(s);
    e->excludes(s);
    c->footer(
        "Without angles an edge of weight w rises by slope / w; weight 0 is a gable.\n"
        "Examples:\n  osteon generate rectilinear -o plan.xy\n  osteon roof plan.xy -o roof.obj\n"
        "  osteon roof plan.xy --angle 40 --edge-angle 2=90 --eaves 3 --walls -o house.obj");
    c->callback([this, a] { run(a->count() > 0); });
  }

  void run(bool one_angle) const {
    const destination to(output);
    polygon p = read_polygon_text(input_text(file, "roof", subject::polygon), checking::later);
    if (one_angle || !angles.empty()) set_angles(p);
    const polygon_skeleton s = skeletonize(std::move(p));
    print_notes(s.notes());
    const mesh roof = s.roof({.slope = slope, .eaves = eaves, .walls = walls, .triangulate = triangulate});
    if (!output.empty() || !summary) to.write([&](std::ostream& out) { write_obj(out, roof); });
    if (!summary) return;
    double top = eaves;
    for (const auto& point : roof.points) top = std::max(top, point[2]);
    const nlohmann::ordered_json doc = {{"points", roof.points.size()}, {"faces", roof.facets.size()}, {"height", top}};
    standard_output() << doc.dump() << '\n';
  }

  static bool is_angle(double degrees) { return degrees > 0 && degrees <= 90; }

  // Angles become weights; they take the place of those in the file.
  void set_angles(polygon& p) const {
    p.set_weights(weight_of_angle(angle));
    for (const auto& text : angles) {
      int point = 0;
      double degrees = 0;
      char rest = 0;
      if (std::sscanf(text.c_str(), "%d=%lf%c", &point, &degrees, &rest) != 2 || point < 1 || point > p.edges())
        throw CLI::ValidationError("--edge-angle", fmt::format("{} is not N=DEGREES with a point N from 1 to {}", text, p.edges()));
      if (!is_angle(degrees)) throw CLI::ValidationError("--edge-angle", text + ": the angle is not above 0 and up to 90 degrees");
      p.set_weight(point - 1, weight_of_angle(degrees));
    }
  }
};

}  // namespace

void add_roof(CLI::App& program) {
  static roof_command command;
  command.add_to(program);
}

}  // namespace osteon::app
