// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Before anything moves: how every vertex of the solid splits into vertices of three facets.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/corner.hpp"
#include "osteon/space/facet_insertion.hpp"
#include "osteon/space/preferred_split.hpp"
#include "osteon/space/skeleton_options.hpp"

namespace osteon {

/// A solid all of whose vertices have a split.
struct split_solid {
  boundary solid;                 ///< after facet insertions
  std::vector<int> origin;        ///< by edge: the input's edge that it was
  std::vector<split_tree> trees;  ///< by vertex; empty where it needs none
  int unproven = 0;               ///< vertices whose split was not proven to be the preferred one
};

/// Finds the preferred tree of every vertex, after facet insertions where there is none without.
template <kernel<3> K>
class initial_split {
 public:
  /// `solid` is the input.
  initial_split(const K& k, const boundary& solid, const skeleton_options& o) : k_(k), options_(o), result_{solid, {}, {}, 0} {
    for (const auto& v : solid.vertices) input_degrees_.push_back(v.facets.size());
  }

  /// Splits all vertices.
  /// *Throws* unsupported_error where a vertex cannot be split, and the errors of preferred_split.
  /// *Complexity* that of preferred_split for each vertex; facet insertions ask for several splits
  /// more.
  split_solid run() {
    boundary& solid = result_.solid;
    result_.origin.resize(solid.edges.size());
    std::iota(result_.origin.begin(), result_.origin.end(), 0);
    result_.trees.resize(solid.vertices.size());
    std::vector<bool> unproven(solid.vertices.size());
    std::vector<int> waiting(solid.vertices.size());
    std::iota(waiting.begin(), waiting.end(), 0);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (auto tree = split(solid, v)) {
        result_.trees[v] = std::move(tree->tree);
        unproven[v] = !tree->proven;
        continue;
      }
      waiting.push_back(v);
      for (const facet_insertion& f : insertions_for(v)) {
        const int e = solid.vertices[v].edges[f.side];
        waiting.push_back(other_end(solid, v, f.side));
        result_.origin.push_back(result_.origin[e]);
        solid = after_insertion(std::move(solid), f);
      }
    }
    result_.unproven = static_cast<int>(std::count(unproven.begin(), unproven.end(), true));
    return std::move(result_);
  }

 private:
  static constexpr int most_insertions = 3;  // at one vertex

  static int other_end(const boundary& b, int v, std::size_t side) {
    const auto& ends = b.edges[b.vertices[v].edges[side]].ends;
    return ends[ends[0] == v ? 1 : 0];
  }

  // The preferred tree of a vertex, empty where it needs none; nothing where it has none.
  std::optional<chosen_split> split(const boundary& b, int v) const {
    if (b.vertices[v].facets.size() == 3 || b.vertices[v].is_majority()) return chosen_split{{}, true};
    if (b.vertices[v].facets.size() > input_degrees_[v] + most_insertions) return std::nullopt;
    const corner c = corner_at(b, v);
    return options_.explore ? random_split(k_, c, drawn_number(*options_.explore, v)) : preferred_split(k_, c, options_.prefer);
  }

  // The fewest insertions after which a vertex has a split, if possible such that the edges' other
  // ends have one too.
  std::vector<facet_insertion> insertions_for(int v) const {
    for (const bool calm : {true, false})
      for (int most = 1; most <= most_insertions; ++most)
        if (auto found = find_insertions(result_.solid, v, most, calm); !found.empty()) return found;
    const auto& f = result_.solid.vertices[v].facets;
    if (f.size() == input_degrees_[v] && facet_insertions_at(k_, result_.solid, v).empty())
      broken_invariant<K>("a vertex of degree " + std::to_string(f.size()) + " has a valid split");
    // Facets chase each other along an edge for ever.
    throw unsupported_error("not yet: the vertex of planes " + std::to_string(f[0]) + ", " + std::to_string(f[1]) + " and " + std::to_string(f[2]) +
                            " cannot be split, because a third facet contains the line of one of its edges; hint: move that facet a little");
  }

  // So many insertions, one after the other, after which a vertex has a valid split and, if `calm`,
  // the other ends have one too; empty where there are none.
  std::vector<facet_insertion> find_insertions(const boundary& b, int v, int number, bool calm) const {
    for (const facet_insertion& f : facet_insertions_at(k_, b, v)) {
      const boundary next = after_insertion(b, f);
      if (calm && !split(next, other_end(b, v, f.side))) continue;
      if (number == 1) {
        if (split(next, v)) return {f};
        continue;
      }
      std::vector<facet_insertion> more = find_insertions(next, v, number - 1, calm);
      if (more.empty()) continue;
      more.insert(more.begin(), f);
      return more;
    }
    return {};
  }

  const K& k_;
  skeleton_options options_;
  std::vector<std::size_t> input_degrees_;  // of the vertices, before insertions
  split_solid result_;
};

}  // namespace osteon
