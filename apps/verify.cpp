// SPDX-License-Identifier: MIT

/// \file
/// osteon verify.

#include "certify.hpp"
#include "commands.hpp"
#include "documents.hpp"
#include "output.hpp"
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
        "Examples:\n  osteon generate star -o star.obj\n  osteon skeleton star.obj --output star.json\n  osteon verify star.obj star.json");
    c->callback([this] {
      input_text text(input.file, "verify", subject::either);
      text.is_polygon() ? run_plane(std::move(text)) : run(std::move(text));
    });
  }

  template <class Names, class Refutation>
  void report(const Names& names, const std::optional<Refutation>& broken) {
    holds = !broken;
    json doc = {{"certified", holds}};
    if (broken) {
      doc["rule"] = names[static_cast<std::size_t>(broken->broken)];
      doc["witness"] = broken->witness;
    }
    standard_output() << doc.dump() << '\n';
  }

  void run(input_text text) {
    const solid<integer> s = input.read(std::move(text));
    report(rule_names, check(s, skeleton_reader(file, s).read(*open_file(file))));
  }

  void run_plane(input_text text) {
    const planar_file given = planar_reader(file).read(*open_file(file));
    const plane::polygon<integer> p = read_polygon_text(std::move(text), given.by.outside);
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
