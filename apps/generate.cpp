// SPDX-License-Identifier: MIT

/// \file
/// osteon generate.

#include "commands.hpp"
#include "common.hpp"
#include "osteon/input/write_obj.hpp"
#include "osteon/input/write_xy.hpp"
#include "osteon/models/registry.hpp"

namespace osteon::app {
namespace {

struct generate_command {
  std::string name;
  std::string output;
  std::optional<int> size;
  std::uint64_t seed = 1;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("generate", "write a model of the project: a polyhedron as OBJ or a polygon as .xy text");
    std::vector<std::string> known;
    std::string list = "Polyhedra, and the meaning of --size:\n";
    const auto add = [&](const auto& k) {
      known.emplace_back(k.name);
      list += fmt::format("  {:20} {} (default {})\n", k.name, k.size, k.default_size);
    };
    for (const auto& k : models::kinds()) add(k);
    list += "Polygons:\n";
    for (const auto& k : plane::models::kinds()) add(k);
    c->add_option("KIND", name, "what to make")->required()->check(CLI::IsMember(known));
    c->add_option("--size", size, "see below")->check(CLI::PositiveNumber);
    c->add_option("--seed", seed, "for the random ones")->capture_default_str();
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->footer(list + "Examples:\n  osteon generate voxels --size 6 --seed 7 -o voxels.obj\n  osteon generate comb --size 10000 -o comb.xy");
    c->callback([this] { run(); });
  }

  void run() const {
    if (const auto* polyhedron = models::find_kind(models::kinds(), name))
      write(*polyhedron, [](std::ostream& out, const models::builder& model) { write_obj(out, model.take<integer>()); });
    else if (const auto* polygon = models::find_kind(plane::models::kinds(), name))
      write(*polygon, [](std::ostream& out, const plane::models::region& model) { plane::write_xy(out, model); });
  }

  // Makes a model of a kind and writes it behind a line that tells how it was made.
  template <class Kind, class Writer>
  void write(const Kind& kind, Writer writer) const {
    const int n = size.value_or(kind.default_size);
    if (n < kind.least_size || n > kind.greatest_size)
      throw CLI::ValidationError("--size", fmt::format("{} needs a size between {} and {}", name, kind.least_size, kind.greatest_size));
    const auto model = kind.make(n, seed);
    const auto print = [&](std::ostream& out) {
      out << fmt::format("# osteon generate {} --size {} --seed {}\n", name, n, seed);
      writer(out, model);
    };
    output.empty() ? print(std::cout) : write_file(output, print);
  }
};

}  // namespace

void add_generate(CLI::App& program) {
  static generate_command command;
  command.add_to(program);
}

}  // namespace osteon::app
