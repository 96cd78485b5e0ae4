// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"

namespace osteon::properties {
namespace {

using planes = std::vector<moving_plane<integer>>;

template <kernel<3> K>
run run_by(const char* name, const K& k, const boundary& b, const skeleton_options& o) {
  run r{name, straight_skeleton(k, b, o), {}};
  for (const auto& a : r.raw.arcs) r.orientations.push_back(k.orientation(a.planes[0], a.planes[1], a.planes[2]));
  return r;
}

auto sqrt_filtered(const planes& p) { return filtered(std::span<const moving_plane<integer>>(p), make_sqrt_kernel(p)); }
auto rational_filtered(const planes& p) { return filtered(std::span<const moving_plane<integer>>(p), make_rational_kernel(p)); }

}  // namespace

run run_default(const solid<integer>& s, const skeleton_options& o) {
  return run_by("perturbed<filtered<sqrt>>", perturbed(sqrt_filtered(s.planes)), s.boundary, o);
}

std::vector<run> run_rational(const planes& p, const boundary& b, const skeleton_options& o) {
  std::vector<run> result;
  result.push_back(run_by("perturbed<filtered<rational>>", perturbed(rational_filtered(p)), b, o));
  result.push_back(run_by("perturbed<rational>", perturbed(make_rational_kernel(p)), b, o));
  return result;
}

std::vector<run> run_all(const solid<integer>& s, const skeleton_options& o) {
  std::vector<run> result = run_rational(s.planes, s.boundary, o);
  result.insert(result.begin(), run_by("perturbed<sqrt>", perturbed(make_sqrt_kernel(s.planes)), s.boundary, o));
  result.insert(result.begin(), run_default(s, o));
  return result;
}

std::vector<run> run_unperturbed(const solid<integer>& s, const skeleton_options& o) {
  std::vector<run> result;
  result.push_back(run_by("filtered<sqrt>", sqrt_filtered(s.planes), s.boundary, o));
  result.push_back(run_by("sqrt", make_sqrt_kernel(s.planes), s.boundary, o));
  result.push_back(run_by("filtered<rational>", rational_filtered(s.planes), s.boundary, o));
  result.push_back(run_by("rational", make_rational_kernel(s.planes), s.boundary, o));
  return result;
}

bool in_general_position(const solid<integer>& s, const skeleton_options& o) {
  try {
    run_by("", sqrt_filtered(s.planes), s.boundary, o);
    return true;
  } catch (const degenerate_error&) {
    return false;
  }
}

std::string difference(const skeleton& a, const skeleton& b) {
  const auto sizes = [](const skeleton& s) {
    return std::to_string(s.nodes.size()) + " nodes, " + std::to_string(s.arcs.size()) + " arcs, " + std::to_string(s.sheets.size()) + " sheets";
  };
  if (sizes(a) != sizes(b)) return sizes(a) + " against " + sizes(b);
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const auto& x = a.nodes[i];
    const auto& y = b.nodes[i];
    if (x.vertex != y.vertex || x.planes != y.planes || x.ambiguous != y.ambiguous || x.arcs != y.arcs || (x.vertex < 0 && x.event != y.event))
      return "node " + std::to_string(i);
  }
  for (std::size_t i = 0; i < a.arcs.size(); ++i) {
    const auto& x = a.arcs[i];
    const auto& y = b.arcs[i];
    if (x.source != y.source || x.target != y.target || x.planes != y.planes || x.corner != y.corner || x.sheets != y.sheets)
      return "arc " + std::to_string(i);
  }
  for (std::size_t i = 0; i < a.sheets.size(); ++i) {
    const auto& x = a.sheets[i];
    const auto& y = b.sheets[i];
    if (x.facets != y.facets || x.input_edge != y.input_edge || x.representative != y.representative || x.arcs != y.arcs)
      return "sheet " + std::to_string(i);
  }
  if (a.cells != b.cells) return "cells";
  if (a.events != b.events || a.ambiguous != b.ambiguous) return "counts of events";
  return "";
}

std::vector<run> distinct(std::vector<run> runs) {
  std::vector<run> result;
  for (run& r : runs) {
    const auto same = std::find_if(result.begin(), result.end(),
                                   [&](const run& s) { return difference(s.raw, r.raw).empty() && s.orientations == r.orientations; });
    if (same == result.end())
      result.push_back(std::move(r));
    else
      same->kernel += ", " + r.kernel;
  }
  return result;
}

}  // namespace osteon::properties
