// SPDX-License-Identifier: MIT

/// \file
/// osteon verify.

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "commands.hpp"
#include "documents.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

struct verify_command {
  model input;
  std::string file;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("verify", "check the certificate of a skeleton");
    input.add_to(*c, std::string("the closed polyhedron as Wavefront OBJ, or ") + polygon_formats);
    c->add_option("SKELETON", file, "what osteon skeleton --output has written")->required();
    c->footer(
        "Prints one JSON object. Exit status 0: certified; 1: refuted, with the broken rule and a witness; 3: unreadable.\n"
        "Examples:\n  osteon generate star -o star.obj\n  osteon skeleton star.obj --output star.json\n  osteon verify star.obj star.json");
    c->callback([this] {
      input_text text(input.file, "verify", subject::either);
      report(text.is_polygon() ? check_polygon(std::move(text)) : check_polyhedron(std::move(text)));
    });
  }

  std::optional<skeleton_refutation> check_polyhedron(input_text text) const {
    const polyhedron p = input.read(std::move(text));
    return osteon::verify(p, read_polyhedron_document(*open_file(file), file));
  }

  std::optional<skeleton_refutation> check_polygon(input_text text) const {
    const polygon_document d = read_polygon_document(*open_file(file), file);
    const polygon p = read_polygon_text(std::move(text), d.region == region::interior ? checking::now : checking::later);
    print_notes(p.notes());
    return osteon::verify(p, d);
  }

  static void report(const std::optional<skeleton_refutation>& refuted) {
    nlohmann::ordered_json doc = {{"certified", !refuted}};
    if (refuted) {
      doc["rule"] = refuted->rule;
      doc["witness"] = refuted->witness;
    }
    standard_output() << doc.dump() << '\n';
    if (refuted) throw CLI::RuntimeError(static_cast<int>(exit_status::refuted));
  }
};

}  // namespace

void add_verify(CLI::App& program) {
  static verify_command command;
  command.add_to(program);
}

}  // namespace osteon::app
