// SPDX-License-Identifier: MIT
/// \file
/// osteon splits: the ways to split one vertex.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "options.hpp"
#include "osteon/inspect.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

using json = nlohmann::ordered_json;

struct splits_command {
  model input;
  int vertex = 0;
  bool all = false;
  bool summary = false;
  bool count = false;
  int sample = 0;
  std::uint64_t seed = 1;
  bool spherical = false;
  std::string prefer = "convex";
  std::vector<double> eye;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("splits", "list, count or draw the ways to split a vertex into vertices of degree three");
    input.add_to(*c);
    c->add_option("--vertex", vertex, "the point's number in the file, from 1")->required();
    auto* a = c->add_flag("--all", all, "list every valid tree as it is found, not only the first ten");
    auto* s = c->add_flag("--summary", summary, "list nothing, print one JSON object with the number of valid trees");
    auto* n = c->add_flag("--count", count, "the same without listing: \"exact\" tells whether there are more");
    auto* d = c->add_option("--sample", sample, "draw that many candidates, each with the same chance")->check(CLI::Range(1, 1'000'000));
    c->add_option("--seed", seed, "for --sample")->capture_default_str();
    auto* p = c->add_flag("--spherical", spherical, "print the preferred split's spherical skeleton as JSON, arcs cut into front and back parts");
    c->add_option("--prefer", prefer, "for --spherical")->check(CLI::IsMember(names(preferences)))->capture_default_str();
    c->add_option("--eye", eye, "for --spherical: the direction (three numbers) from which it is seen; the sum of the edges where it is missing")
        ->expected(3)
        ->check(finite_number());
    const std::vector<CLI::Option*> modes = {a, s, n, d, p};
    for (auto* one : modes)
      for (auto* other : modes)
        if (one != other) one->excludes(other);
    c->footer(
        "A tree is a list of split operations <a,b>: the facets a and b of the vertex, counted from 0 counter-clockwise\n"
        "seen from outside, become adjacent. `#` after a tree: one of its vertices lies infinitely far away on an edge\n"
        "of the solid, so that the tree splits the corner but not the solid. Candidates are the trees that obey the\n"
        "rules of single vertices and edges; `!` after a candidate: two edges of a facet cross, so it is not valid.\n"
        "Examples:\n  osteon generate cone -o cone.obj\n  osteon splits cone.obj --vertex 3 --all\n"
        "  osteon splits cone.obj --vertex 3 --sample 5 --seed 7");
    c->callback([this] { run(); });
  }

 private:
  static constexpr std::size_t most_listed = 10;

  static void print(const inspect::split_tree& tree, const char* mark) {
    std::string text;
    for (const auto& [a, b] : tree) text += fmt::format("{}<{},{}>", text.empty() ? "" : ",", a, b);
    standard_output() << text << mark << '\n';
  }

  void list(const inspect::vertex_splits& splits) const {
    std::size_t found = 0;
    splits.for_each([&](const inspect::split_tree& tree, bool near) {
      if (!all && found == most_listed) {
        fmt::print(stderr, "and more; give --all to list them\n");
        return true;
      }
      ++found;
      print(tree, near ? "" : " #");
      return false;
    });
    if (all || found < most_listed) fmt::print(stderr, "{} valid\n", found);
  }

  void draw_sphere(const inspect::vertex_splits& splits) const {
    std::optional<std::array<double, 3>> from;
    if (!eye.empty()) {
      const double longest = std::max({std::abs(eye[0]), std::abs(eye[1]), std::abs(eye[2])});
      from = {eye[0] / longest, eye[1] / longest, eye[2] / longest};
    }
    const inspect::spherical_picture sphere = splits.spherical(preferences.at(prefer), from);
    json doc = {{"vertex", vertex}, {"eye", sphere.eye}, {"planes", splits.planes()}, {"nodes", sphere.nodes}, {"arcs", json::array()}};
    for (const auto& a : sphere.arcs) {
      json arc = {{"facets", a.facets}, {"nodes", a.nodes}, {"parts", json::array()}};
      if (a.facets[1] >= 0) arc["convex"] = a.convex;
      for (const auto& part : a.parts) arc["parts"].push_back({{"front", part.front}, {"points", part.points}});
      doc["arcs"].push_back(std::move(arc));
    }
    standard_output() << doc.dump() << '\n';
  }

  json numbers(const inspect::vertex_splits& splits) const {
    json doc = {{"vertex", vertex}, {"degree", splits.degree()}, {"trees", splits.trees()}};
    if (summary) {
      std::uint64_t valid = splits.is_whole() ? 1 : 0;
      splits.for_each([&valid](const auto&, bool) { return ++valid == 0; });
      doc["valid"] = valid;
      doc["method"] = splits.is_whole() ? "none" : splits.is_enumerated() ? "enumeration" : "search";
    } else {
      if (!splits.is_whole()) doc["candidates"] = splits.candidates();
      const inspect::split_count counted = splits.count();
      doc["valid"] = counted.valid;
      doc["exact"] = counted.exact;
    }
    return doc;
  }

 public:
  void run() const {
    if (!eye.empty() && eye[0] == 0 && eye[1] == 0 && eye[2] == 0) throw CLI::ValidationError("--eye", "0 0 0 is no direction");
    const polyhedron p = input.read("splits");
    const inspect::vertex_splits splits(p, vertex_at(p, input.file, vertex));
    if (summary || count) {
      standard_output() << numbers(splits).dump() << '\n';
      return;
    }
    std::string planes;
    for (const int f : splits.planes()) planes += fmt::format(" {}", f);
    fmt::print(stderr, "vertex {}, degree {}, planes{}, {} trees\n", vertex, splits.degree(), planes, splits.trees());
    if (splits.is_whole()) return;
    if (spherical)
      draw_sphere(splits);
    else if (sample > 0)
      splits.sample(sample, seed, [](const inspect::split_tree& tree, bool valid) { print(tree, valid ? "" : " !"); });
    else
      list(splits);
  }
};

}  // namespace

void add_splits(CLI::App& program) {
  static splits_command command;
  command.add_to(program);
}

}  // namespace osteon::app
