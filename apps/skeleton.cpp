// SPDX-License-Identifier: MIT

/// \file
/// osteon skeleton.

#include <chrono>

#include "certify.hpp"
#include "commands.hpp"
#include "documents.hpp"
#include "output.hpp"
#include "planar.hpp"
#include "planar_documents.hpp"

namespace osteon::app {
namespace {

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
    c->add_option("--kernel", kernel, "numbers: sqrt (exact), rational (exact, speeds rounded to 2^-64), double (may fail)")
        ->check(CLI::IsMember({"sqrt", "rational", "double"}))
        ->capture_default_str();
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
                                        std::pair("--flip", input.flip), std::pair("--triangulate", input.triangulate)})
      if (given) throw CLI::ValidationError(option, "is for polyhedra, and " + text.name() + " is a polygon");
    const destination to(output);
    const plane::polygon<integer> p = read_polygon_text(std::move(text), outside);
    plane::skeleton_options o;
    o.outside = outside;
    const auto begin = std::chrono::steady_clock::now();
    const planar_skeletons both = compute_planar(kernel, p, o);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (certified) demand_certified(plane::rule_names, certify(p, kernel, both, outside));
    const planar_provenance by = {kernel, outside};
    if (!output.empty() || !summary) to.write([&](std::ostream& out) { write_planar_skeleton(out, p, both, by); });
    if (summary) {
      json doc = {{"dimension", 2}, {"input", {{"vertices", p.points.size()}, {"holes", p.holes}}}, {"kernel", kernel}};
      const json raw = {{"nodes", both.raw.nodes.size() - p.points.size()}, {"arcs", both.raw.arcs.size()}, {"faces", faces_of(both.raw)}};
      doc["raw"] = raw;
      doc["skeleton"] = raw;
      if (both.exact)
        doc["skeleton"] = {{"nodes", both.exact->nodes.size() - static_cast<std::size_t>(both.exact->vertices)},
                           {"arcs", both.exact->arcs.size()},
                           {"faces", both.exact->faces}};
      doc["events"] = {{"edge", both.raw.events[0]}, {"split", both.raw.events[1]}};
      if (certified) doc["certified"] = true;
      doc["seconds"] = took.count();
      standard_output() << doc.dump() << '\n';
    }
  }

  void run(input_text text) const {
    if (outside) throw CLI::ValidationError("--outside", "is for polygons, and " + text.name() + " is a polyhedron");
    const destination to(output);
    const solid<integer> s = input.read(std::move(text));
    skeleton_options o;
    o.prefer = preferences.at(prefer);
    o.saddle = saddle.empty() ? default_saddle(o.prefer) : saddles.at(saddle);
    const auto begin = std::chrono::steady_clock::now();
    const both_skeletons both = with_kernel(kernel, s.planes, [&](const auto& k) { return compute(k, s.boundary, o); });
    const skeleton& result = both.raw;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (certified) demand_certified(rule_names, certify(s, kernel, result, both.exact));
    if (result.unproven_splits > 0)
      fmt::print(stderr, "osteon: note: vertices of high degree whose split is valid but perhaps not the preferred one: {}\n",
                 result.unproven_splits);
    const provenance by = {kernel, prefer, name_of(o.saddle)};
    if (!output.empty() || !summary) to.write(skeleton_document(s, result, both.exact, by).dump() + "\n");
    if (summary) {
      json doc;
      doc["input"] = {{"vertices", s.boundary.vertices.size()}, {"edges", s.boundary.edges.size()}, {"facets", s.facets}};
      doc["kernel"] = kernel;
      doc["prefer"] = prefer;
      doc["raw"] = {{"nodes", result.nodes.size()}, {"arcs", result.arcs.size()}, {"sheets", result.sheets.size()}};
      if (both.exact) doc["skeleton"] = counts_document(*both.exact);
      doc["events"] = events_document(result);
      doc["ambiguous"] = result.ambiguous;
      if (certified) doc["certified"] = true;
      doc["seconds"] = took.count();
      standard_output() << doc.dump() << '\n';
    }
  }
};

}  // namespace

void add_skeleton(CLI::App& program) {
  static skeleton_command command;
  command.add_to(program);
}

}  // namespace osteon::app
