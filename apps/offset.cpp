// SPDX-License-Identifier: MIT

/// \file
/// osteon offset.

#include <fmt/ostream.h>

#include <algorithm>
#include <iterator>

#include "certify.hpp"
#include "commands.hpp"
#include "json_reader.hpp"
#include "osteon/evaluate/offset.hpp"
#include "planar.hpp"

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
    c->add_option("--kernel", kernel, "as for osteon skeleton")->check(CLI::IsMember({"sqrt", "rational", "double"}))->capture_default_str();
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->add_flag("--verify", certified, "check the skeleton's certificate first");
    c->footer("Examples:\n  osteon offset plan.xy --by 0.5,1,1.5 --format wkt\n  osteon offset plan.wkt --by 2 --outside --format xy -o grown.xy");
    c->callback([this] { run(); });
  }

  void run() const {
    const plane::polygon<integer> p = read_polygon_file(file, outside);
    std::vector<rational> times;
    for (const auto& d : distances) {
      exact_number<integer> x;
      if (read_decimal(d, x) != number_fault::none || x.mantissa < 0) throw CLI::ValidationError("--by", d + " is no decimal number of at least 0");
      times.push_back(rational(x.mantissa) * power_of(x.ten, x.two));
    }
    plane::skeleton_options o;
    o.outside = outside;
    if (outside) o.until = until(p, *std::max_element(times.begin(), times.end()));
    const planar_skeletons both = compute_planar(kernel, p, o);
    if (certified && !outside) demand_certified(plane::rule_names, certify(p, kernel, both, outside));
    const plane::offsets offsets(p, both.raw);
    std::vector<plane::offset_polygon<double>> results;
    for (const auto& t : times) results.push_back(outside ? complement(offsets.at(t)) : offsets.at(t));
    if (format == "xy" && (results.size() != 1 || results[0].parts > 1))
      throw CLI::ValidationError("--format", "xy text holds one distance and one part; take wkt or geojson");
    const auto write = [&](std::ostream& out) {
      format == "wkt" ? write_wkt(out, results) : format == "xy" ? write_xy(out, results[0]) : write_geojson(out, results);
    };
    output.empty() ? write(std::cout) : write_file(output, write);
  }

  // The wavefront is followed a little longer than to the last offset.
  static double until(const plane::polygon<integer>& p, const rational& last) {
    const plane::vertex_enclosures motion(p.lines, p.points, true);
    return motion.own_time(plane::input_scale(p).to_integers(last).convert_to<double>()) * (1 + 1e-9) + 1e-300;
  }

  static std::string number(double x) { return json(x).dump(); }

  // The rings of each part in parentheses or brackets, closed.
  static void write_rings(std::ostream& out, const plane::offset_polygon<double>& p, const char* open, const char* close, const char* separator,
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

  static void write_wkt(std::ostream& out, const std::vector<plane::offset_polygon<double>>& results) {
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

  void write_geojson(std::ostream& out, const std::vector<plane::offset_polygon<double>>& results) const {
    fmt::print(out, "{{\"type\":\"FeatureCollection\",\"features\":[");
    for (std::size_t i = 0; i < results.size(); ++i) {
      fmt::print(out, "{}\n{{\"type\":\"Feature\",\"properties\":{{\"distance\":{}}},\"geometry\":{{\"type\":\"MultiPolygon\",\"coordinates\":[",
                 i == 0 ? "" : ",", number(std::stod(distances[i])));
      write_rings(out, results[i], "[", "]", ",", "[", "]");
      fmt::print(out, "]}}}}");
    }
    fmt::print(out, "\n]}}\n");
  }

  static void write_xy(std::ostream& out, const plane::offset_polygon<double>& p) {
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
