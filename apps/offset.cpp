// SPDX-License-Identifier: MIT

/// \file
/// osteon offset.

#include <fmt/ostream.h>

#include <algorithm>
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

struct offset_command {
  std::string file;
  std::string kernel = "sqrt";
  std::string format = "geojson";
  std::string output;
  std::vector<std::string> distances;
  bool outside = false;
  bool certified = false;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("offset", "move the edges of a polygon by distances: all offsets from one skeleton");
    c->add_option("FILE", file, std::string(polygon_formats) + "; - for standard input")->required();
    c->add_option("--by", distances, "distances, exact decimals of at least 0; an edge of weight w moves w times as far")->required()->delimiter(',');
    c->add_flag("--outside", outside, "move the edges outwards: the polygon grows and its holes shrink");
    c->add_option("--format", format, "geojson: one FeatureCollection; wkt: one MULTIPOLYGON a line; xy: rings, for one distance with one part")
        ->check(CLI::IsMember({"geojson", "wkt", "xy"}))
        ->capture_default_str();
    add_kernel(*c, kernel, "as for osteon skeleton");
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->add_flag("--verify", certified, "check the skeleton's certificate first, and say so; ends with status 5 should it be refuted");
    c->footer(
        "Examples:\n  osteon generate gear -o gear.xy\n  osteon offset gear.xy --by 0.5,1,1.5 --format wkt\n"
        "  osteon offset gear.xy --by 2 --outside --format xy -o grown.xy");
    c->callback([this] { run(); });
  }

  void run() const {
    const std::vector<decimal> times(distances.begin(), distances.end());
    for (const decimal& t : times) check(t);
    const destination to(output);
    polygon p = read_polygon_text(input_text(file, "offset", subject::polygon), checking::later);
    polygon_options o{.region = outside ? region::exterior : region::interior, .kernel = kernels.at(kernel)};
    if (outside && !certified) o.until = *std::max_element(times.begin(), times.end());
    const polygon_skeleton s = skeletonize(std::move(p), o);
    print_notes(s.notes());
    if (certified) {  // the whole skeleton: there is no certificate of a part
      demand_certified(s.verify());
      fmt::print(stderr, "osteon: note: the skeleton's certificate holds\n");
    }
    const std::vector<offset_polygon> results = s.offsets(times);
    if (format == "xy" && (results.size() != 1 || results[0].parts > 1))
      throw CLI::ValidationError("--format", "xy text holds one distance and one part; take wkt or geojson");
    to.write([&](std::ostream& out) {
      format == "wkt" ? write_wkt(out, results) : format == "xy" ? write_xy(out, results[0]) : write_geojson(out, results);
    });
  }

  static void check(const decimal& t) {
    bool negative = false;
    try {
      negative = t < 0;
    } catch (const input_error& e) {
      throw CLI::ValidationError("--by", e.what());
    }
    if (negative) throw CLI::ValidationError("--by", t.text() + " is less than 0");
  }

  static std::string number(double x) { return nlohmann::json(x).dump(); }

  // The rings of each part in parentheses or brackets, closed.
  static void write_rings(std::ostream& out, const offset_polygon& p, const char* open, const char* close, const char* separator,
                          const char* point_open, const char* point_close) {
    for (std::size_t r = 0; r < p.rings.size(); ++r) {
      const bool first = r == 0 || p.rings[r].part != p.rings[r - 1].part;
      fmt::print(out, "{}{}", r == 0 ? "" : first ? std::string(close) + "," : ",", first ? open : "");
      fmt::print(out, "{}", open);
      const auto& points = p.rings[r].points;
      for (std::size_t i = 0; i <= points.size(); ++i) {
        const auto& q = points[i % points.size()];
        fmt::print(out, "{}{}{}{}{}{}", i == 0 ? "" : ",", point_open, number(q[0]), separator, number(q[1]), point_close);
      }
      fmt::print(out, "{}", close);
    }
    if (!p.rings.empty()) fmt::print(out, "{}", close);
  }

  static void write_wkt(std::ostream& out, const std::vector<offset_polygon>& results) {
    for (const auto& p : results) {
      if (p.rings.empty()) {
        fmt::print(out, "MULTIPOLYGON EMPTY\n");
        continue;
      }
      fmt::print(out, "MULTIPOLYGON (");
      write_rings(out, p, "(", ")", " ", "", "");
      fmt::print(out, ")\n");
    }
  }

  void write_geojson(std::ostream& out, const std::vector<offset_polygon>& results) const {
    fmt::print(out, "{{\"type\":\"FeatureCollection\",\"features\":[");
    for (std::size_t i = 0; i < results.size(); ++i) {
      fmt::print(out, "{}\n{{\"type\":\"Feature\",\"properties\":{{\"distance\":{}}},\"geometry\":{{\"type\":\"MultiPolygon\",\"coordinates\":[",
                 i == 0 ? "" : ",", number(std::stod(distances[i])));
      write_rings(out, results[i], "[", "]", ",", "[", "]");
      fmt::print(out, "]}}}}");
    }
    fmt::print(out, "\n]}}\n");
  }

  static void write_xy(std::ostream& out, const offset_polygon& p) {
    for (std::size_t r = 0; r < p.rings.size(); ++r) {
      if (r > 0) fmt::print(out, "\n");
      for (const auto& q : p.rings[r].points) fmt::print(out, "{} {}\n", number(q[0]), number(q[1]));
    }
  }
};

}  // namespace

void add_offset(CLI::App& program) {
  static offset_command command;
  command.add_to(program);
}

}  // namespace osteon::app
