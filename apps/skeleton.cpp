// SPDX-License-Identifier: MIT

/// \file
/// osteon skeleton.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "commands.hpp"
#include "documents.hpp"
#include "options.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

using json = nlohmann::ordered_json;

class stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

struct skeleton_command {
  model input;
  std::string kernel = "sqrt";
  std::string prefer = "convex";
  std::string saddle;
  std::string output;
  bool summary = false;
  bool certified = false;
  bool outside = false;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("skeleton", "compute the straight skeleton of a polyhedron or a polygon");
    input.add_to(*c, std::string("a closed polyhedron as Wavefront OBJ, or ") + polygon_formats);
    add_kernel(*c, kernel, "numbers: sqrt (exact), rational (exact, speeds rounded to 2^-64), double (may fail)");
    c->add_option("--prefer", prefer, "polyhedra: which way to split a vertex of high degree")
        ->check(CLI::IsMember(names(preferences)))
        ->capture_default_str();
    c->add_option("--saddle", saddle, "polyhedra: which way to take at a saddle; convex with --prefer convex and max-volume, else reflex")
        ->check(CLI::IsMember(names(saddles)));
    c->add_option("--output", output, "write the skeleton as JSON to this file");
    c->add_flag("--summary", summary, "print one JSON object with counts instead of the skeleton");
    c->add_flag("--verify", certified, "check the result's certificate; ends with status 5 should it be refuted");
    c->add_flag("--outside", outside, "polygons: the skeleton of what is not in the polygon; some of its vertices move for ever");
    c->footer(
        "The counts of a polygon's skeleton are of nodes inside of it, arcs, and faces; \"raw\" are those of the polygon moved infinitely little so "
        "that\n"
        "no two events coincide.\n"
        "Examples:\n  osteon generate gear -o gear.xy\n  osteon skeleton gear.xy --summary --verify\n  osteon generate star -o star.obj\n"
        "  osteon skeleton star.obj --prefer min-volume --saddle faster --output star.json");
    c->callback([this] {
      input_text text(input.file, "skeleton", subject::either);
      text.is_polygon() ? run_plane(std::move(text)) : run(std::move(text));
    });
  }

  void run_plane(input_text text) const {
    for (const auto& [option, given] : {std::pair("--prefer", prefer != "convex"), std::pair("--saddle", !saddle.empty()),
                                        std::pair("--flip", input.repairs.flip), std::pair("--triangulate", input.repairs.triangulate)})
      if (given) throw CLI::ValidationError(option, "is for polyhedra, and " + text.name() + " is a polygon");
    const destination to(output);
    polygon p = read_polygon_text(std::move(text), outside ? checking::later : checking::now);
    const stopwatch time;
    const polygon_skeleton s = skeletonize(std::move(p), {.region = outside ? region::exterior : region::interior, .kernel = kernels.at(kernel)});
    const double seconds = time.seconds();
    print_notes(s.notes());
    if (certified) demand_certified(s.verify());
    write(to, s);
    if (!summary) return;
    const polygon_skeleton raw = s.raw();
    json doc = {{"dimension", 2}, {"input", {{"vertices", s.vertices()}, {"holes", s.holes()}}}, {"kernel", kernel}};
    doc["raw"] = counts(raw);
    doc["skeleton"] = counts(s);
    doc["events"] = {{"edge", s.events(event_kind::edge)}, {"split", s.events(event_kind::split)}};
    print(std::move(doc), seconds);
  }

  void run(input_text text) const {
    if (outside) throw CLI::ValidationError("--outside", "is for polygons, and " + text.name() + " is a polyhedron");
    const destination to(output);
    const polyhedron p = input.read(std::move(text));
    polyhedron_options o{.prefer = preferences.at(prefer), .kernel = kernels.at(kernel)};
    if (!saddle.empty()) o.saddle = saddles.at(saddle);
    const stopwatch time;
    const polyhedron_skeleton s = skeletonize(p, o);
    const double seconds = time.seconds();
    if (certified) demand_certified(s.verify());
    if (s.unproven_splits() > 0)
      fmt::print(stderr, "osteon: note: vertices of high degree whose split is valid but perhaps not the preferred one: {}\n", s.unproven_splits());
    write(to, s);
    if (!summary) return;
    const polyhedron_skeleton raw = s.raw();
    json doc = {{"input", {{"vertices", p.vertices()}, {"edges", p.edges()}, {"facets", p.facets()}}}, {"kernel", kernel}, {"prefer", prefer}};
    doc["raw"] = counts(raw);
    if (!s.is_raw()) {
      doc["skeleton"] = counts(s);
      const auto cells = raw.cells();
      doc["skeleton"]["cells"] = std::count_if(cells.begin(), cells.end(), [](const auto& c) { return !c.sheets().empty(); });
    }
    for (auto kind = event_kind::E1; kind <= event_kind::other; kind = static_cast<event_kind>(static_cast<int>(kind) + 1))
      doc["events"][std::string(name_of(kind))] = s.events(kind);
    doc["ambiguous"] = s.ambiguous();
    print(std::move(doc), seconds);
  }

  template <class Skeleton>
  void write(const destination& to, const Skeleton& s) const {
    if (!output.empty() || !summary) to.write([&](std::ostream& out) { write_document(out, s.document()); });
  }

  // Vertices of the polygon, which come first, are no nodes inside of it.
  static json counts(const polygon_skeleton& s) {
    const auto nodes = s.nodes();
    std::size_t vertices = 0;
    while (vertices < nodes.size() && nodes[vertices].vertex() >= 0) ++vertices;
    return {{"nodes", nodes.size() - vertices}, {"arcs", s.arcs().size()}, {"faces", s.faces().size()}};
  }
  static json counts(const polyhedron_skeleton& s) { return {{"nodes", s.nodes().size()}, {"arcs", s.arcs().size()}, {"sheets", s.sheets().size()}}; }

  void print(json doc, double seconds) const {
    if (certified) doc["certified"] = true;
    doc["seconds"] = seconds;
    standard_output() << doc.dump() << '\n';
  }
};

}  // namespace

void add_skeleton(CLI::App& program) {
  static skeleton_command command;
  command.add_to(program);
}

}  // namespace osteon::app
