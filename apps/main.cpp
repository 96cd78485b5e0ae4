// SPDX-License-Identifier: MIT

/// \file
/// The program osteon. Results on standard output, messages on standard error, exit status by kind of error.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ambiguity.hpp"
#include "common.hpp"
#include "documents.hpp"
#include "osteon/contract.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/models.hpp"
#include "osteon/obj.hpp"
#include "osteon/propagate.hpp"
#include "osteon/solid.hpp"
#include "osteon/verify.hpp"
#include "splits.hpp"

namespace osteon::app {
namespace {

enum status : int { done = 0, refuted = 1, usage = 2, bad_input = 3, undecided = 4, broken = 5 };

/// The certificate of a skeleton by the named kernel (double: by the exact one), contracted where it is given.
std::optional<refutation> certify(const solid<integer>& s, const std::string& name, const skeleton& raw,
                                  const std::optional<contracted_skeleton>& exact) {
  const auto check = [&](const auto& k) -> std::optional<refutation> {
    if (auto broken = verify(k, s.boundary, raw)) return broken;
    return exact ? verify_contraction(k.base(), s.boundary, raw, *exact) : std::nullopt;
  };
  if (name == "rational") return check(perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_rational_kernel(s.planes))));
  return check(perturbed(filtered(std::span<const moving_plane<integer>>(s.planes), make_sqrt_kernel(s.planes))));
}

struct skeleton_command {
  model input;
  std::string kernel = "sqrt";
  std::string prefer = "convex";
  std::string saddle;
  std::string output;
  bool summary = false;
  bool certified = false;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("skeleton", "compute the straight skeleton of a polyhedron");
    input.add_to(*c);
    c->add_option("--kernel", kernel, "numbers: sqrt (exact), rational (exact, speeds rounded to 2^-64), double (may fail)")
        ->check(CLI::IsMember({"sqrt", "rational", "double"}))
        ->capture_default_str();
    c->add_option("--prefer", prefer, "which way to split a vertex of high degree")->check(CLI::IsMember(names(preferences)))->capture_default_str();
    c->add_option("--saddle", saddle, "which way to take at a saddle; convex with --prefer convex and max-volume, else reflex")
        ->check(CLI::IsMember(names(saddles)));
    c->add_option("--output", output, "write the skeleton as JSON to this file");
    c->add_flag("--summary", summary, "print one JSON object with counts instead of the skeleton");
    c->add_flag("--verify", certified, "check the result's certificate; ends with status 5 should it be refuted");
    c->footer(
        "Examples:\n  osteon skeleton bunny.obj --summary\n  osteon skeleton bunny.obj --prefer min-volume --saddle faster --output bunny.json");
    c->callback([this] { run(); });
  }

  void run() const {
    const solid<integer> s = input.read();
    options o;
    o.prefer = preferences.at(prefer);
    o.saddle = saddle.empty() ? default_saddle(o.prefer) : saddles.at(saddle);
    const auto begin = std::chrono::steady_clock::now();
    const both_skeletons both = with_kernel(kernel, s.planes, [&](const auto& k) { return compute(k, s.boundary, o); });
    const skeleton& result = both.raw;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (certified)
      if (const auto broken = certify(s, kernel, result, both.exact))
        throw invariant_error(
            fmt::format("the certificate is refuted: {}: {}", rule_names[static_cast<std::size_t>(broken->broken)], broken->witness));
    if (result.unproven_splits > 0)
      fmt::print(stderr, "osteon: note: vertices of high degree whose split is valid but perhaps not the preferred one: {}\n",
                 result.unproven_splits);
    const provenance by = {kernel, prefer, name_of(o.saddle)};
    if (!output.empty()) write_file(output, skeleton_document(s, result, both.exact, by).dump() + "\n");
    if (summary) {
      json doc;
      doc["input"] = {{"vertices", s.boundary.vertices.size()}, {"edges", s.boundary.edges.size()}, {"facets", s.facets}};
      doc["kernel"] = kernel;
      doc["prefer"] = prefer;
      doc["raw"] = {{"nodes", result.nodes.size()}, {"arcs", result.arcs.size()}, {"sheets", result.sheets.size()}};
      if (both.exact) doc["skeleton"] = counts_document(*both.exact);
      doc["events"] = events_document(result);
      doc["ambiguous"] = result.ambiguous;
      if (certified) doc["certified"] = true;
      doc["seconds"] = took.count();
      fmt::print("{}\n", doc.dump());
    } else if (output.empty()) {
      fmt::print("{}\n", skeleton_document(s, result, both.exact, by).dump());
    }
  }
};

struct verify_command {
  model input;
  std::string file;
  bool holds = true;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("verify", "check the certificate of a skeleton");
    input.add_to(*c);
    c->add_option("SKELETON", file, "what osteon skeleton --output has written")->required();
    c->footer(
        "Prints one JSON object. Exit status 0: certified; 1: refuted, with the broken rule and a witness; 3: unreadable.\n"
        "Example:\n  osteon skeleton bunny.obj --output bunny.json && osteon verify bunny.obj bunny.json");
    c->callback([this] { run(); });
  }

  void run() {
    const solid<integer> s = input.read();
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) throw input_error(input_fault::unreadable, 0, file + ": cannot be opened", "check the name");
    const skeleton_file given = skeleton_reader(file, s).read(in);
    const auto broken = check(s, given);
    holds = !broken;
    json doc = {{"certified", holds}};
    if (broken) {
      doc["rule"] = rule_names[static_cast<std::size_t>(broken->broken)];
      doc["witness"] = broken->witness;
    }
    fmt::print("{}\n", doc.dump());
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

struct generate_command {
  std::string kind;
  std::string output;
  std::optional<int> size;
  std::uint64_t seed = 1;

  void add_to(CLI::App& program) {
    CLI::App* c = program.add_subcommand("generate", "write a model of the project as OBJ");
    std::vector<std::string> known;
    std::string list = "Kinds and the meaning of --size:\n";
    for (const auto& k : models::kinds()) {
      known.push_back(k.name);
      list += fmt::format("  {:15} {} (default {})\n", k.name, k.size, k.default_size);
    }
    c->add_option("KIND", kind, "what to make")->required()->check(CLI::IsMember(known));
    c->add_option("--size", size, "see below")->check(CLI::Range(1, 1000));
    c->add_option("--seed", seed, "for the random ones")->capture_default_str();
    c->add_option("-o,--output", output, "the file; standard output where it is missing");
    c->footer(list + "Example:\n  osteon generate voxels --size 6 --seed 7 -o voxels.obj");
    c->callback([this] { run(); });
  }

  void run() const {
    const auto& all = models::kinds();
    const auto& k = *std::find_if(all.begin(), all.end(), [this](const auto& x) { return x.name == kind; });
    const int n = size.value_or(k.default_size);
    if (n < k.least_size) throw CLI::ValidationError("--size", fmt::format("{} needs a size of at least {}", kind, k.least_size));
    std::string text = fmt::format("# osteon generate {} --size {} --seed {}\n", kind, n, seed);
    const auto m = k.make(n, seed).take<integer>();
    for (const auto& p : m.points) text += fmt::format("v {} {} {}\n", p[0].mantissa.str(), p[1].mantissa.str(), p[2].mantissa.str());
    for (const auto& f : m.facets) {
      text += "f";
      for (const int corner : f) text += fmt::format(" {}", corner + 1);
      text += "\n";
    }
    if (output.empty())
      fmt::print("{}", text);
    else
      write_file(output, text);
  }
};

int run(int argc, char** argv) {
  CLI::App program("Exact straight skeletons of polyhedra.", "osteon");
  program.require_subcommand(1);
  program.set_version_flag("--version", "osteon 0.1.0");
  program.footer(
      "Exit status: 0 done, 1 refuted (verify), 2 wrong usage, 3 bad input, 4 the kernel could not decide, 5 internal invariant "
      "violated.\nExample:\n  osteon skeleton "
      "model.obj --summary");
  skeleton_command skeletons;
  skeletons.add_to(program);
  verify_command verification;
  verification.add_to(program);
  splits_command splits;
  splits.add_to(program);
  ambiguity_command ambiguity;
  ambiguity.add_to(program);
  generate_command generate;
  generate.add_to(program);
  try {
    program.parse(argc, argv);
    return verification.holds ? done : refuted;
  } catch (const CLI::ParseError& e) {
    return program.exit(e) == 0 ? done : usage;
  } catch (const input_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return bad_input;
  } catch (const degenerate_error& e) {
    fmt::print(stderr, "osteon: {}, as the sqrt and rational kernels are\n", e.what());
    return undecided;
  } catch (const unsupported_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return bad_input;
  } catch (const undecided_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return undecided;
  } catch (const invariant_error& e) {
    fmt::print(stderr, "osteon: {}\nThis is a defect of osteon; please report it with the input.\n", e.what());
    return broken;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "osteon: the input needs more memory than there is; cure: give a smaller model\n");
    return bad_input;
  } catch (const std::exception& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return broken;
  }
}

}  // namespace
}  // namespace osteon::app

int main(int argc, char** argv) { return osteon::app::run(argc, argv); }
