// SPDX-License-Identifier: MIT

/// \file
/// osteon generate.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "osteon/osteon.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

struct generate_command {
  std::string kind;
  std::string output;
  std::optional<int> size;
  std::uint64_t seed = 1;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("generate", "write a model of the project: a polyhedron as OBJ or a polygon as .xy text");
    std::string list = "Polyhedra, and the meaning of --size:\n";
    bool polygons = false;
    for (const model_kind& k : model_kinds()) {
      if (k.is_polygon && !polygons) list += "Polygons:\n";
      polygons = k.is_polygon;
      list += fmt::format("  {:20} {} (default {})\n", k.name, k.size, k.default_size);
    }
    c->add_option("KIND", kind, "what to make")
        ->required()
        ->check(CLI::Validator([](const std::string& name) { return find(name) != nullptr ? "" : name + " is no kind of model"; }, ""));
    c->add_option("--size", size, "see below");
    c->add_option("--seed", seed, "for the random ones")->capture_default_str();
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->footer(list + "Examples:\n  osteon generate voxels --size 6 --seed 7 -o voxels.obj\n  osteon generate comb --size 10000 -o comb.xy");
    c->callback([this] { run(); });
  }

  void run() const {
    const destination to(output);
    const model_kind& k = *find(kind);
    const int n = size.value_or(k.default_size);
    if (n < k.least_size || n > k.greatest_size)
      throw CLI::ValidationError("--size", fmt::format("{} needs a size between {} and {}", kind, k.least_size, k.greatest_size));
    to.write([&](std::ostream& out) {
      out << fmt::format("# osteon generate {} --size {} --seed {}\n", kind, n, seed);
      write_model(out, kind, n, seed);
    });
  }

  static const model_kind* find(const std::string& name) {
    const auto& all = model_kinds();
    const auto found = std::find_if(all.begin(), all.end(), [&](const model_kind& k) { return k.name == name; });
    return found == all.end() ? nullptr : &*found;
  }
};

}  // namespace

void add_generate(CLI::App& program) {
  static generate_command command;
  command.add_to(program);
}

}  // namespace osteon::app
