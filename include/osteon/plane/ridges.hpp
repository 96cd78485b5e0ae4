// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Where lines coincide at a moment: arcs without duration, and what lies on them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/node_places.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// Lines that coincide at one moment. Those of one set have a line that stands for all.
class coincident_lines {
 public:
  /// Notes that two lines coincide; the one that stands for b stands for both.
  void unite(line_id a, line_id b) { sets_.unite(number_of(a), number_of(b)); }
  /// Returns whether a line has been noted.
  bool contains(line_id l) const { return number_.contains(l); }
  /// Returns the line that stands for all that coincide with l.
  /// *Requires* contains(l).
  line_id find(line_id l) { return lines_[sets_.find(number_.at(l))]; }

 private:
  int number_of(line_id l) {
    const auto [found, fresh] = number_.try_emplace(l, static_cast<int>(lines_.size()));
    if (fresh) {
      lines_.push_back(l);
      sets_.add();
    }
    return found->second;
  }

  std::unordered_map<line_id, int> number_;
  std::vector<line_id> lines_;  // by number
  disjoint_sets sets_;          // of numbers
};

/// The ridges of a raw skeleton. The lines of an arc without duration coincide, and with them
/// perhaps others of that moment. A ridge is such a line with the places on it in their order;
/// places that fall together there become one.
template <kernel<2> K>
class ridges {
 public:
  ridges(const K& k, const std::vector<int>& line_of_edge, const skeleton& raw, node_places<K>& places)
      : k_(k), line_(line_of_edge), raw_(raw), places_(places) {}

  /// Finds all ridges, and the places that fall together on them.
  void find() {
    merge_ends();
    collect_lines();
    if (lines_.empty()) return;
    collect_places();
    for (auto& [key, all] : on_) sort_and_merge(static_cast<line_id>(key & 0xFFFFFFFFU), all);
    places_.refresh();
    for (auto& [key, all] : on_) {
      for (int& p : all) p = places_.find(p);
      all.erase(std::unique(all.begin(), all.end()), all.end());
    }
  }

  /// Returns whether an arc begins and ends at one moment, but not at one place.
  bool has_no_duration(const skeleton::arc& arc) {
    if (arc.target < 0 || !places_.shares_moment(arc.source) || !places_.shares_moment(arc.target)) return false;
    const int from = places_.find(places_.of_node(arc.source));
    const int to = places_.find(places_.of_node(arc.target));
    return from != to && places_[from].moment == places_[to].moment;
  }

  /// Calls body(p, q) for the pieces into which the places on its ridge cut an arc without
  /// duration, between two places on it.
  /// *Throws* invariant_error where these are not on the ridge.
  template <class Body>
  void cut(const skeleton::arc& arc, int source, int target, Body body) {
    const int moment = places_[source].moment;
    const line_id along = lines_[moment].find(line_[arc.faces[0]]);
    const auto& on = on_[key(moment, along)];
    const auto find = [&](int p) {
      return std::partition_point(on.begin(), on.end(), [&](int q) { return places_.comes_first(along, places_[q], places_[p]); });
    };
    auto from = find(source);
    auto to = find(target);
    if (to < from) std::swap(from, to);
    if (to == on.end() || std::minmax(*from, *to) != std::minmax(source, target)) broken_invariant<K>("an arc ends on its lines");
    for (; from != to; ++from) body(*from, *(from + 1));
  }

 private:
  // Places without a common line are one where an arc of no length joins them.
  void merge_ends() {
    for (const auto& arc : raw_.arcs) {
      if (!has_no_duration(arc)) continue;
      const int p = places_.find(places_.of_node(arc.source));
      const int q = places_.find(places_.of_node(arc.target));
      const auto& across = places_[q].across;
      if (places_.side(across[0], places_[p]) == sign::zero && places_.side(across[1], places_[p]) == sign::zero) places_.merge(p, q);
    }
    places_.refresh();
  }

  void collect_lines() {
    for (const auto& arc : raw_.arcs)
      if (has_no_duration(arc)) lines_[places_[places_.of_node(arc.source)].moment].unite(line_[arc.faces[0]], line_[arc.faces[1]]);
  }

  void collect_places() {
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const int p = places_.of_node(n);
      const auto here = lines_.find(places_[p].moment);
      if (here == lines_.end()) continue;
      for (const line_id l : raw_.nodes[n].lines)
        if (here->second.contains(l)) on_[key(here->first, here->second.find(l))].push_back(p);
    }
  }

  void sort_and_merge(line_id along, std::vector<int>& on) {
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    const auto comes_first = [&](int p, int q) { return places_.comes_first(along, places_[p], places_[q]); };
    std::sort(on.begin(), on.end(), comes_first);
    for (std::size_t i = 1; i < on.size(); ++i)
      if (!comes_first(on[i - 1], on[i])) places_.merge(on[i - 1], on[i]);
  }

  static std::uint64_t key(int moment, line_id line) { return static_cast<std::uint64_t>(moment) << 32U | static_cast<std::uint32_t>(line); }

  const K& k_;
  const std::vector<int>& line_;
  const skeleton& raw_;
  node_places<K>& places_;
  std::unordered_map<int, coincident_lines> lines_;         // by moment
  std::unordered_map<std::uint64_t, std::vector<int>> on_;  // places on a ridge, in their order
};

}  // namespace osteon::plane
