// SPDX-License-Identifier: MIT
/// \file
/// osteon ambiguity: how many skeletons a solid may have, and a walk through some of them.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "commands.hpp"
#include "common.hpp"
#include "documents.hpp"
#include "osteon/evaluate/volume.hpp"
#include "osteon/space/ambiguity.hpp"
#include "osteon/space/propagate.hpp"
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
    c->add_option("--offset", offsets, "also print the offset's volume at this time; may be given often")->check(finite_from(0));
    c->footer(
        "Prints one JSON object: the vertices with several valid splits and their product, \"exact\" unless there are more,\n"
        "and the saddles that the skeleton of most convex edges meets, each with two outcomes.\n"
        "With --explore a table: the seed of the choices, the sizes of the raw skeleton, events, saddles, volumes.\n"
        "Examples:\n  osteon generate arms -o arms.obj\n  osteon ambiguity arms.obj\n"
        "  osteon ambiguity arms.obj --explore 3 --offset 0.5 --offset 1");
    c->callback([this] { run(); });
  }

  void run() const {
    const solid<integer> s = input.read("ambiguity");
    const auto k = default_kernel(s);
    if (explore > 0) {
      walk(s, k);
      return;
    }
    json doc;
    doc["vertices"] = json::array();
    integer product = 1;
    bool exact = true;
    for (std::size_t v = 0; v < s.boundary.vertices.size(); ++v) {
      const split_count counted = count_splits(k, s.boundary, static_cast<int>(v));
      integer ways = 1;
      for (const std::uint64_t f : counted.factors) ways *= f;
      product *= ways;
      exact = exact && counted.exact;
      if (ways != 1)
        doc["vertices"].push_back(
            {{"vertex", s.input_points[v] + 1}, {"degree", s.boundary.vertices[v].facets.size()}, {"valid", ways.str()}, {"exact", counted.exact}});
    }
    doc["splits"] = product.str();
    doc["exact"] = exact;
    doc["saddles"] = straight_skeleton(k, s.boundary, skeleton_options{}).ambiguous;
    standard_output() << doc.dump() << '\n';
  }

 private:
  template <class K>
  void walk(const solid<integer>& s, const K& k) const {
    const rational unit = unit_of(s);
    const std::vector<rational> speeds = rounded_speeds(s.planes);
    fmt::print(standard_output(), "seed\tnodes\tarcs\tsheets\tevents\tsaddles");
    for (const double t : offsets) fmt::print(standard_output(), "\tvolume@{}", t);
    fmt::print(standard_output(), "\n");
    std::set<std::vector<quadruple>> seen;
    const std::uint64_t last = seed + 20 * static_cast<std::uint64_t>(explore) + 100;
    std::uint64_t at = seed;
    for (; at < last && seen.size() < static_cast<std::size_t>(explore); ++at) {
      skeleton_options o;
      o.explore = at;
      const skeleton raw = straight_skeleton(k, s.boundary, o);
      std::vector<quadruple> nodes;
      for (const auto& n : raw.nodes) nodes.push_back(n.planes);
      std::sort(nodes.begin(), nodes.end());
      if (!seen.insert(std::move(nodes)).second) continue;
      int events = 0;
      for (const int n : raw.events) events += n;
      fmt::print(standard_output(), "{}\t{}\t{}\t{}\t{}\t{}", at, raw.nodes.size(), raw.arcs.size(), raw.sheets.size(), events, raw.ambiguous);
      if (!offsets.empty()) {
        const rational_offsets volumes(s.planes, raw, speeds);
        for (const double t : offsets)
          fmt::print(standard_output(), "\t{}", static_cast<double>(rational(volumes.volume(rational(t) / unit) * unit * unit * unit)));
      }
      fmt::print(standard_output(), "\n");
    }
    if (seen.size() < static_cast<std::size_t>(explore))
      fmt::print(stderr, "osteon: {} seeds led to {} different skeletons only\n", at - seed, seen.size());
  }
};

}  // namespace

void add_ambiguity(CLI::App& program) {
  static ambiguity_command command;
  command.add_to(program);
}

}  // namespace osteon::app
