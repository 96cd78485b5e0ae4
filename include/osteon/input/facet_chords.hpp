// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Facets that pass through each other from one common corner to another, where no edge meets the
/// other facet's inside.

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/input/geometry.hpp"
#include "osteon/input/projected_facet.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// The search for such chords. Triangles have none.
template <class Int>
class chord_search {
 public:
  /// *Requires* a surface with planes, on which no edge meets the inside of a facet.
  explicit chord_search(const surface<Int>& s) : s_(s), facets_at_(s.points.size()), met_(s.input.facets.size(), {-1, -1}) {
    for (int f = 0; f < size(); ++f)
      if (loop(f).size() > 3)
        for (const int p : loop(f))
          if (facets_at_[p].empty() || facets_at_[p].back() != f) facets_at_[p].push_back(f);
  }

  /// Returns a chord, or nothing.
  /// *Complexity* the number of pairs of common corners, each located in both facets.
  std::optional<bad_contact> run() {
    for (int f = 0; f < size(); ++f) {
      if (loop(f).size() == 3) continue;
      if (const auto found = chord_of(f, common_corners(f))) return found;
    }
    return std::nullopt;
  }

 private:
  using facet_and_corner = std::pair<int, int>;

  int size() const { return static_cast<int>(s_.input.facets.size()); }
  const std::vector<int>& loop(int f) const { return s_.loop(static_cast<std::size_t>(f)); }

  // The corners that a facet has in common with later ones, if there are two or more; for each of
  // these in order along the common line.
  std::vector<facet_and_corner> common_corners(int f) {
    std::vector<facet_and_corner> common;
    for (const int p : loop(f))
      for (auto g = std::upper_bound(facets_at_[p].begin(), facets_at_[p].end(), f); g != facets_at_[p].end(); ++g) {
        auto& [with, first] = met_[*g];
        if (with == f && first != p) common.insert(common.end(), {{*g, first}, {*g, p}});
        if (with != f) met_[*g] = {f, p};
      }
    std::sort(common.begin(), common.end(),
              [this](const auto& x, const auto& y) { return x.first != y.first ? x.first < y.first : s_.points[x.second] < s_.points[y.second]; });
    common.erase(std::unique(common.begin(), common.end()), common.end());
    return common;
  }

  // A chord between successive common corners whose middle lies inside of both facets.
  std::optional<bad_contact> chord_of(int f, const std::vector<facet_and_corner>& common) const {
    const projected_facet<Int> facet(s_, f);
    std::map<std::pair<int, int>, bool> inside;  // by chord: whether its middle lies inside of f
    for (std::size_t i = 1; i < common.size(); ++i) {
      const auto [g, b] = common[i];
      if (common[i - 1].first != g) continue;
      const int a = common[i - 1].second;
      const auto within_g = [&, g = g, b = b] { return projected_facet<Int>(s_, g).locate_middle(a, b) == location::inside; };
      const bool small = loop(g).size() < loop(f).size();  // ask it first: most chords are edges
      if (small && !within_g()) continue;
      const auto [known, fresh] = inside.try_emplace({a, b});
      if (fresh) known->second = facet.locate_middle(a, b) == location::inside;
      if (known->second && (small || within_g())) return bad_contact{bad_contact::kind::chord, f, a, b, g};
    }
    return std::nullopt;
  }

  const surface<Int>& s_;
  std::vector<std::vector<int>> facets_at_;  // by point
  // by facet: the earlier facet that it last had a corner in common with, and the first such corner
  std::vector<facet_and_corner> met_;
};

}  // namespace osteon
