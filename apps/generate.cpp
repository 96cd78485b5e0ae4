// SPDX-License-Identifier: MIT

/// \file
/// osteon generate.

#include "commands.hpp"
#include "common.hpp"
#include "osteon/models/polygons.hpp"
#include "osteon/models/polyhedra.hpp"
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
    std::vector<std::string> known;
    std::string list = "Polyhedra, and the meaning of --size:\n";
    const auto add = [&](const auto& k) {
      known.emplace_back(k.name);
      list += fmt::format("  {:20} {} (default {})\n", k.name, k.size, k.default_size);
    };
    for (const auto& k : models::kinds()) add(k);
    list += "Polygons:\n";
    for (const auto& k : plane::models::kinds()) add(k);
    c->add_option("KIND", kind, "what to make")
        ->required()
        ->check(CLI::Validator(
            [known](const std::string& name) {
              return std::find(known.begin(), known.end(), name) != known.end() ? "" : name + " is no kind of model";
            },
            ""));
    c->add_option("--size", size, "see below");
    c->add_option("--seed", seed, "for the random ones")->capture_default_str();
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->footer(list + "Examples:\n  osteon generate voxels --size 6 --seed 7 -o voxels.obj\n  osteon generate comb --size 10000 -o comb.xy");
    c->callback([this] { run(); });
  }

  void run() const {
    const destination to(output);
    to.write(polyhedron().value_or(polygon().value_or("")));
  }

  // The kind's entry in a table and the size wanted, if the table has it.
  template <class Kinds>
  auto find(const Kinds& all, int greatest) const -> std::optional<std::pair<typename Kinds::value_type, int>> {
    const auto k = std::find_if(all.begin(), all.end(), [this](const auto& x) { return x.name == kind; });
    if (k == all.end()) return std::nullopt;
    if constexpr (requires { k->greatest_size; }) greatest = k->greatest_size;
    const int n = size.value_or(k->default_size);
    if (n < k->least_size || n > greatest)
      throw CLI::ValidationError("--size", fmt::format("{} needs a size between {} and {}", kind, k->least_size, greatest));
    return std::pair(*k, n);
  }
  std::string heading(int n) const { return fmt::format("# osteon generate {} --size {} --seed {}\n", kind, n, seed); }

  std::optional<std::string> polygon() const {
    const auto k = find(plane::models::kinds(), 0);
    if (!k) return std::nullopt;
    return heading(k->second) + plane::models::to_xy(k->first.make(k->second, seed));
  }

  std::optional<std::string> polyhedron() const {
    const auto k = find(models::kinds(), 1000);
    if (!k) return std::nullopt;
    std::string text = heading(k->second);
    const auto m = k->first.make(k->second, seed).template take<integer>();
    for (const auto& p : m.points) text += fmt::format("v {} {} {}\n", p[0].mantissa.str(), p[1].mantissa.str(), p[2].mantissa.str());
    for (const auto& f : m.facets) {
      text += "f";
      for (const int corner : f) text += fmt::format(" {}", corner + 1);
      text += "\n";
    }
    return text;
  }
};

}  // namespace

void add_generate(CLI::App& program) {
  static generate_command command;
  command.add_to(program);
}

}  // namespace osteon::app
