// SPDX-License-Identifier: MIT
/// \file
/// osteon splits: the ways to split one vertex.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "common.hpp"
#include "documents.hpp"
#include "osteon/evaluate/spherical.hpp"
#include "osteon/space/ambiguity.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/split_search.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

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
        ->check(finite);
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
  using operations = searched_split::diagonals;
  static constexpr std::size_t most_listed = 10;

  static std::string text_of(const operations& t) {
    std::string text;
    for (const auto& [a, b] : t) text += fmt::format("{}<{},{}>", text.empty() ? "" : ",", a, b);
    return text;
  }

  // Catalan(degree - 2).
  static integer trees_of(int degree) {
    integer c = 1;
    for (int i = 0; i < degree - 2; ++i) c = c * 2 * (2 * i + 1) / (i + 2);
    return c;
  }

  static bool listed(const corner& c) { return c.degree() <= greatest_split_degree; }

  template <class K, class Body>
  static auto search_of(const K& k, const corner& c, Body body) {
    if (c.degree() > greatest_remembered_degree)
      throw unsupported_error(fmt::format("not yet: the trees of a vertex of degree {} (at most {})", c.degree(), greatest_remembered_degree));
    const corner_signs<K> signs(k, c);
    split_search<K, edge_count, integer> search(signs, edge_count(true));
    return body(search);
  }

  // Calls visit(tree, near) for every valid tree until it answers true. Up to degree greatest_split_degree in the thesis's order, with those of
  // both perturbations and with vertices at infinity.
  template <class Visit>
  static void for_each_tree(const solid<integer>& s, const corner& c, Visit visit) {
    if (!listed(c)) {
      const auto k = default_kernel(s);
      const splitter trees(k, c);
      const bool different = has_different_planes(c);
      search_of(k, c, [&](auto& search) {
        return search.for_each([&](const operations& t) {
          if (!different) {
            const auto tree = trees.tree(t);
            if (!tree || !trees.valid(*tree)) return false;
          }
          return visit(t, true);
        });
      });
      return;
    }
    std::map<operations, bool> trees;  // whether all vertices stay near
    for (const bool mirrored : {false, true}) {
      const perturbed k(filtered(std::span<const moving_plane<integer>>(s.planes), make_sqrt_kernel(s.planes)), mirrored);
      for (const bool bounded : {false, true})
        for (const auto& t : splitter(k, c, bounded).all()) trees[t.operations] |= bounded;
    }
    for (const auto& [tree, near] : trees)
      if (visit(tree, near)) return;
  }

  void list(const solid<integer>& s, const corner& c) const {
    std::size_t found = 0;
    for_each_tree(s, c, [&](const operations& t, bool near) {
      if (!all && found == most_listed) {
        fmt::print(stderr, "and more; give --all to list them\n");
        return true;
      }
      ++found;
      fmt::print(standard_output(), "{}{}\n", text_of(t), near ? "" : " #");
      return false;
    });
    if (all || found < most_listed) fmt::print(stderr, "{} valid\n", found);
  }

  void draw(const solid<integer>& s, const corner& c) const {
    const auto k = default_kernel(s);
    const splitter trees(k, c);
    std::mt19937_64 random(seed);
    search_of(k, c, [&](const auto& search) {
      if (search.count() == 0) return false;
      for (int n = 0; n < sample; ++n) {
        const operations t = search.sample([&random](const integer& below) {
          for (;;) {  // as many bits as needed, and again where they are too many
            integer drawn = 0;
            for (unsigned bits = 0; bits <= msb(below); bits += 64) drawn = (drawn << 64U) + random();
            drawn >>= (msb(below) / 64 + 1) * 64 - (msb(below) + 1);
            if (drawn < below) return drawn;
          }
        });
        const auto tree = trees.tree(t);
        fmt::print(standard_output(), "{}{}\n", text_of(t), tree && trees.valid(*tree) ? "" : " !");
      }
      return true;
    });
  }

  void draw_sphere(const solid<integer>& s, const corner& c) const {
    const auto t = preferred_split(default_kernel(s), c, preferences.at(prefer));
    if (!t || t->tree.vertices.size() + 2 != c.facets.size())
      throw unsupported_error("not yet: the spherical skeleton of a vertex with several facets in one plane; hint: list its splits with --all");
    const spherical_skeleton sphere = make_spherical_skeleton(s.planes, c, t->tree);
    spherical_skeleton::vector from{};
    const double longest = eye.empty() ? 1 : std::max({std::abs(eye[0]), std::abs(eye[1]), std::abs(eye[2])});
    for (std::size_t x = 0; x < 3; ++x) {
      if (!eye.empty())
        from[x] = eye[x] / longest;
      else
        for (std::size_t m = 0; m < c.facets.size(); ++m) from[x] += sphere.nodes[m][x];
    }
    json doc = {{"vertex", vertex}, {"eye", from}, {"planes", c.facets}, {"nodes", sphere.nodes}, {"arcs", json::array()}};
    for (const auto& a : sphere.arcs) {
      json arc = {{"facets", a.facets}, {"nodes", a.nodes}, {"parts", json::array()}};
      if (a.facets[1] >= 0) arc["convex"] = a.convex;
      for (const auto& part : parts_of(a, from)) arc["parts"].push_back({{"front", part.front}, {"points", part.points}});
      doc["arcs"].push_back(std::move(arc));
    }
    standard_output() << doc.dump() << '\n';
  }

 public:
  void run() const {
    if (!eye.empty() && eye[0] == 0 && eye[1] == 0 && eye[2] == 0) throw CLI::ValidationError("--eye", "0 0 0 is no direction");
    const solid<integer> s = input.read("splits");
    const int id = vertex_at(s, input.file, vertex);
    const corner c = corner_at(s.boundary, id);
    const bool whole = c.degree() == 3 || s.boundary.vertices[static_cast<std::size_t>(id)].is_majority();  // never splits
    json doc = {{"vertex", vertex}, {"degree", c.degree()}, {"trees", whole ? "1" : trees_of(c.degree()).str()}};
    if (summary) {
      std::uint64_t valid = 0;
      if (!whole) for_each_tree(s, c, [&valid](const operations&, bool) { return ++valid == 0; });
      doc["valid"] = whole ? 1 : valid;
      doc["method"] = whole ? "none" : (listed(c) ? "enumeration" : "search");
      standard_output() << doc.dump() << '\n';
    } else if (count) {
      const auto k = default_kernel(s);
      const split_count counted = count_splits(k, s.boundary, id);
      integer valid = 1;
      for (const std::uint64_t f : counted.factors) valid *= f;
      if (!whole) doc["candidates"] = search_of(k, c, [](const auto& found) { return found.count().str(); });
      doc["valid"] = valid.str();
      doc["exact"] = counted.exact;
      standard_output() << doc.dump() << '\n';
    } else {
      std::string facets;
      for (const plane_id f : c.facets) facets += fmt::format(" {}", f);
      fmt::print(stderr, "vertex {}, degree {}, planes{}, {} trees\n", vertex, c.degree(), facets, doc["trees"].get<std::string>());
      if (whole) return;
      if (spherical)
        draw_sphere(s, c);
      else if (sample > 0)
        draw(s, c);
      else
        list(s, c);
    }
  }
};

}  // namespace

void add_splits(CLI::App& program) {
  static splits_command command;
  command.add_to(program);
}

}  // namespace osteon::app
