// SPDX-License-Identifier: MIT
/// \file
/// osteon ambiguity: how many skeletons a solid may have, and a walk through some of them.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "commands.hpp"
#include "options.hpp"
#include "osteon/inspect.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

struct ambiguity_command {
  model input;
  int explore = 0;
  std::uint64_t seed = 1;
  std::vector<double> offsets;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("ambiguity", "count the choices that a skeleton has, or compare skeletons that choose otherwise");
    input.add_to(*c);
    c->add_option("--explore", explore, "compute that many different skeletons, choosing at random")->check(CLI::Range(1, 1'000'000));
    c->add_option("--seed", seed, "of the first choice")->capture_default_str();
    c->add_option("--offset", offsets, "also print the offset's volume at this time; may be given often")->check(finite_number(0));
    c->footer(
        "Prints one JSON object: the vertices with several valid splits and their product, \"exact\" unless there are more,\n"
        "and the saddles that the skeleton of most convex edges meets, each with two outcomes.\n"
        "With --explore a table: the seed of the choices, the sizes of the raw skeleton, events, saddles, volumes.\n"
        "Examples:\n  osteon generate arms -o arms.obj\n  osteon ambiguity arms.obj\n"
        "  osteon ambiguity arms.obj --explore 3 --offset 0.5 --offset 1");
    c->callback([this] {
      const polyhedron p = input.read("ambiguity");
      explore > 0 ? walk(p) : count(p);
    });
  }

  static void count(const polyhedron& p) {
    const inspect::ambiguity all = inspect::count_ambiguity(p);
    nlohmann::ordered_json doc;
    doc["vertices"] = nlohmann::ordered_json::array();
    for (const auto& v : all.vertices)
      doc["vertices"].push_back({{"vertex", v.point + 1}, {"degree", v.degree}, {"valid", v.splits.valid}, {"exact", v.splits.exact}});
    doc["splits"] = all.splits.valid;
    doc["exact"] = all.splits.exact;
    doc["saddles"] = all.saddles;
    standard_output() << doc.dump() << '\n';
  }

  void walk(const polyhedron& p) const {
    std::ostream& out = standard_output();
    out << "seed\tnodes\tarcs\tsheets\tevents\tsaddles";
    for (const double t : offsets) fmt::print(out, "\tvolume@{}", t);
    out << '\n';
    int found = 0;
    const auto print = [&](const inspect::explored_skeleton& s) {
      ++found;
      fmt::print(out, "{}\t{}\t{}\t{}\t{}\t{}", s.seed, s.nodes, s.arcs, s.sheets, s.events, s.saddles);
      for (const double volume : s.volumes) fmt::print(out, "\t{}", volume);
      out << '\n';
    };
    const std::uint64_t seeds = inspect::explore(p, {explore, seed, {offsets.begin(), offsets.end()}}, print);
    if (found < explore) fmt::print(stderr, "osteon: {} seeds led to {} different skeletons only\n", seeds, found);
  }
};

}  // namespace

void add_ambiguity(CLI::App& program) {
  static ambiguity_command command;
  command.add_to(program);
}

}  // namespace osteon::app
