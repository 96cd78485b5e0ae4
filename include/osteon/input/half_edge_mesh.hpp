// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The incidences of a closed surface of polygons: half-edges, and the fans of facets around
/// points.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/mesh.hpp"

namespace osteon {

/// Half-edges, numbered facet by facet, corner by corner. A half-edge leads from a corner of its
/// facet to the next one; its twin is the same edge in the facet beyond it, in the other direction.
class half_edge_mesh {
 public:
  /// A half-edge: the point it starts at, its facet, its neighbours in the facet, and its twin (-1
  /// before it is known).
  struct half_edge {
    int from;
    int facet;
    int next;
    int previous;
    int twin;
  };

  half_edge_mesh() = default;
  /// Makes the half-edges of facets, still without twins.
  explicit half_edge_mesh(const std::vector<std::vector<int>>& facets) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const auto& loop = facets[f];
      const int n = static_cast<int>(loop.size());
      const int first = size();
      first_.push_back(first);
      for (int i = 0; i < n; ++i) edges_.push_back({loop[i], static_cast<int>(f), first + (i + 1) % n, first + (i + n - 1) % n, -1});
    }
  }

  /// Returns the number of half-edges.
  int size() const { return static_cast<int>(edges_.size()); }
  /// Returns a half-edge.
  const half_edge& operator[](int h) const { return edges_[h]; }
  /// Returns the range of all half-edges.
  auto begin() const { return edges_.begin(); }
  /// Returns its end.
  auto end() const { return edges_.end(); }

  /// Returns the point that a half-edge leads to.
  int to(int h) const { return edges_[edges_[h].next].from; }
  /// Returns the half-edge that starts at the first corner of a facet.
  int first(int facet) const { return first_[facet]; }

  /// Makes two half-edges each other's twin.
  void join(int g, int h) {
    edges_[g].twin = h;
    edges_[h].twin = g;
  }

  /// Returns the half-edges out of a point that facets connect with h, counter-clockwise, h first.
  /// *Requires* that all twins are known.
  std::vector<int> fan(int h) const {
    std::vector<int> result;
    int g = h;
    do {
      result.push_back(g);
      g = edges_[edges_[g].previous].twin;
    } while (g != h);
    return result;
  }

  /// Numbers the fans; a point has several where parts of the surface touch.
  /// *Requires* that all twins are known.
  void find_fans() {
    fan_of_.assign(edges_.size(), -1);
    for (int h = 0; h < size(); ++h) {
      if (fan_of_[h] >= 0) continue;
      for (const int g : fan(h)) fan_of_[g] = static_cast<int>(fans_.size());
      fans_.push_back(h);
    }
  }
  /// Returns a half-edge out of each fan that find_fans has numbered.
  const std::vector<int>& fans() const { return fans_; }
  /// Returns the number of the fan that a half-edge starts in.
  int fan_of(int h) const { return fan_of_[h]; }

 private:
  std::vector<half_edge> edges_;
  std::vector<int> first_;   // by facet
  std::vector<int> fans_;    // by fan: a half-edge out of it
  std::vector<int> fan_of_;  // by half-edge
};

/// Returns the half-edges of a mesh, each with its twin, and the fans.
/// *Requires* facets of at least three points that exist and differ from their successors.
/// *Throws* input_error for an edge with one facet (not_closed), with more than two
/// (non_manifold_edge), or with two that run along it in one direction (inconsistent).
/// *Complexity* expected linear.
template <class Int>
half_edge_mesh make_half_edge_mesh(const input_mesh<Int>& m) {
  half_edge_mesh result(m.facets);
  struct sides {
    int count = 0;
    int first = -1;
    int second = -1;
  };
  std::unordered_map<std::uint64_t, sides> by_ends;
  const auto sides_of = [&](int h) -> sides& {
    const auto [low, high] = std::minmax({result[h].from, result.to(h)});
    return by_ends[static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint32_t>(high)];
  };
  for (int h = 0; h < result.size(); ++h) {
    sides& s = sides_of(h);
    ++s.count;
    (s.first < 0 ? s.first : s.second) = h;  // the second of more than two does not matter
  }
  for (int h = 0; h < result.size(); ++h) {
    if (result[h].twin >= 0) continue;
    const sides& s = sides_of(h);
    const auto f = static_cast<std::size_t>(result[h].facet);
    const auto refuse = [&](input_fault fault, const std::string& what, const std::string& hint) {
      m.refuse_facet(fault, f, ": the edge between points " + std::to_string(result[h].from + 1) + " and " + std::to_string(result.to(h) + 1) + what,
                     hint);
    };
    if (s.count == 1) refuse(input_fault::not_closed, " has no second facet, so the surface is not closed", "close the hole");
    if (s.count > 2)
      refuse(input_fault::non_manifold_edge, " has " + std::to_string(s.count) + " facets", "use separate points for the parts that touch there");
    const int other = s.first == h ? s.second : s.first;
    if (result[other].from == result[h].from)
      refuse(input_fault::inconsistent, " runs in the same direction in facet " + std::to_string(result[other].facet + 1),
             "reverse one of the two facets");
    result.join(h, other);
  }
  result.find_fans();
  return result;
}

}  // namespace osteon
