// SPDX-License-Identifier: MIT

/// \file
/// osteon verify.

#include <filesystem>
#include <fstream>

#include "certify.hpp"
#include "commands.hpp"
#include "documents.hpp"
#include "planar_documents.hpp"

namespace osteon::app {
namespace {

struct verify_command {
  model input;
  std::string file;
  bool holds = true;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("verify", "check the certificate of a skeleton");
    input.add_to(*c, std::string("the closed polyhedron as Wavefront OBJ, or ") + polygon_formats);
    c->add_option("SKELETON", file, "what osteon skeleton --output has written")->required();
    c->footer(
        "Prints one JSON object. Exit status 0: certified; 1: refuted, with the broken rule and a witness; 3: unreadable.\n"
        "Example:\n  osteon skeleton bunny.obj --output bunny.json && osteon verify bunny.obj bunny.json");
    c->callback([this] { is_polygon_file(input.file) ? run_plane() : run(); });
  }

  std::ifstream open() const {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) throw input_error(input_fault::unreadable, 0, file + ": cannot be opened", "check the name");
    return in;
  }

  template <class Names, class Refutation>
  void report(const Names& names, const std::optional<Refutation>& broken) {
    holds = !broken;
    json doc = {{"certified", holds}};
    if (broken) {
      doc["rule"] = names[static_cast<std::size_t>(broken->broken)];
      doc["witness"] = broken->witness;
    }
    fmt::print("{}\n", doc.dump());
  }

  void run() {
    const solid<integer> s = input.read();
    std::ifstream in = open();
    report(rule_names, check(s, skeleton_reader(file, s).read(in)));
  }

  void run_plane() {
    std::ifstream in = open();
    const planar_file given = planar_reader(file).read(in);
    const plane::polygon<integer> p = read_polygon_file(input.file, given.by.outside);
    report(plane::rule_names, given.lines == p.lines && given.boundary.next == p.boundary.next && given.boundary.line == p.boundary.line
                                  ? certify(p, given.by.kernel, given.skeletons, given.by.outside)
                                  : plane::refutation{plane::rule::structure, "the lines and edges are not those of the polygon"});
  }

  static std::optional<refutation> check(const solid<integer>& s, const skeleton_file& given) {
    for (std::size_t p = 0; p < std::max(s.planes.size(), given.planes.size()); ++p) {
      const bool same = p < s.planes.size() && p < given.planes.size() && s.planes[p].n == given.planes[p].n && s.planes[p].d == given.planes[p].d &&
                        s.planes[p].weight == given.planes[p].weight;
      if (!same) return refutation{rule::structure, fmt::format("plane {} is not that of the solid", p)};
    }
    return certify(s, given.by.kernel, given.raw, given.exact);
  }
};

}  // namespace

const bool& add_verify(CLI::App& program) {
  static verify_command command;
  command.add_to(program);
  return command.holds;
}

}  // namespace osteon::app
