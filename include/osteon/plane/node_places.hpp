// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Which nodes of a raw skeleton lie at one place at one moment in the limit of the perturbation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// Where and when nodes are in the limit.
struct place {
  int raw;                        ///< its first node
  int moment;                     ///< -1: all nodes of its moment are here
  std::array<line_id, 2> across;  ///< two lines that cross here
};

/// The places of a raw skeleton's nodes under the *unperturbed* kernel, whose zeros say what
/// coincides. Places are numbered in order of time; of those that turn out to be one, the first
/// stands for all.
template <kernel<2> K>
class node_places {
 public:
  node_places(const K& k, const skeleton& raw) : k_(k), raw_(raw) {}

  /// Finds the places of all nodes.
  /// *Throws* unsupported_error where stationary edges on one line face each other, invariant_error
  /// where nodes are none.
  /// *Complexity* linear, but for sorting what happens at one moment on one line.
  void find() {
    place_of_.resize(raw_.nodes.size());
    places_.reserve(raw_.nodes.size());
    std::optional<meeting> moment;
    std::size_t first = 0;  // node of the moment
    for (std::size_t n = 0; n < raw_.nodes.size(); ++n) {
      const auto& node = raw_.nodes[n];
      if (n + ahead < raw_.nodes.size()) prefetch_lines(raw_.nodes[n + ahead].lines);
      if (node.vertex >= 0) {
        place_of_[n] = add({static_cast<int>(n), -1, {node.lines[0], node.lines[1]}});
        continue;
      }
      const auto when = k_.meet(node.lines);
      if (!when)
        throw unsupported_error("held edges on one line face each other at the lines " + std::to_string(node.lines[0]) + ", " +
                                std::to_string(node.lines[1]) + " and " + std::to_string(node.lines[2]) +
                                ": whether the polygon is open between them cannot be told; hint: move one of them a little");
      if (!moment || k_.compare(*moment, *when) != sign::zero) {
        if (moment) find_at(*moment, first, n);
        moment = when;
        first = n;
      }
    }
    if (moment) find_at(*moment, first, raw_.nodes.size());
    refresh();
  }

  /// Returns the number of places, those that have become part of others included.
  std::size_t size() const { return places_.size(); }
  /// Returns place p.
  const place& operator[](int p) const { return places_[p]; }
  /// Returns the place of a node, which stands for all that are one with it, as of the last
  /// refresh().
  int of_node(std::size_t node) const { return place_of_[node]; }
  /// Returns the place that stands for all that are one with p.
  int find(int p) { return same_.find(p); }
  /// Makes one place of two.
  void merge(int p, int q) {
    p = find(p);
    q = find(q);
    same_.unite(std::max(p, q), std::min(p, q));
  }
  /// Brings of_node() up to date with merge().
  void refresh() {
    for (int& p : place_of_) p = find(p);
  }

  /// Returns whether other nodes are of the same moment as this one.
  bool shares_moment(int node) const { return !shared_.empty() && shared_[node]; }

  /// Returns on which side of line l a place is; zero: on the line.
  sign side(line_id l, const place& p) const {
    if (l == p.across[0] || l == p.across[1]) return sign::zero;
    return k_.side(l, p.across[0], p.across[1], p.moment < 0 ? *k_.meet(raw_.nodes[p.raw].lines) : moments_[p.moment]);
  }

  /// Returns whether place p comes before q on a line on which both lie, in the direction of the
  /// line.
  bool comes_first(line_id along, const place& p, const place& q) const {
    for (const line_id x : p.across)
      if (k_.transversal(along, x)) {
        const sign s = side(x, q);
        return s != sign::zero && (s == sign::positive) == (k_.orientation(along, x) == sign::negative);
      }
    broken_invariant<K>("two lines cross at a place");
  }

 private:
  using meeting = typename K::meeting;
  // so many nodes before their turn their lines are asked for
  static constexpr std::size_t ahead = 16;

  int add(const place& p) {
    places_.push_back(p);
    return same_.add();
  }

  void prefetch_lines(const triple& lines) const {
    if constexpr (requires { k_.prefetch(lines[0]); })
      for (const line_id l : lines)
        if (l >= 0) k_.prefetch(l);
  }

  // Places for the nodes from first to last, which are those of one moment.
  void find_at(const meeting& when, std::size_t first, std::size_t last) {
    if (last - first == 1) {
      place_of_[first] = add({static_cast<int>(first), -1, crossing_of(raw_.nodes[first].lines)});
      return;
    }
    const int moment = static_cast<int>(moments_.size());
    moments_.push_back(when);
    shared_.resize(raw_.nodes.size());
    std::fill(shared_.begin() + static_cast<std::ptrdiff_t>(first), shared_.begin() + static_cast<std::ptrdiff_t>(last), true);
    std::unordered_map<line_id, std::vector<int>> here;  // places on each line, in their order
    for (std::size_t n = first; n < last; ++n) {
      const auto& node = raw_.nodes[n];
      const place fresh{static_cast<int>(n), moment, crossing_of(node.lines)};
      int found = -1;
      std::array<std::ptrdiff_t, 3> at{};
      for (int r = 0; r < 3; ++r) {
        const line_id line = node.lines[r];
        const auto& places = here[line];
        const auto behind = std::partition_point(places.begin(), places.end(), [&](int q) { return comes_first(line, places_[q], fresh); });
        at[r] = behind - places.begin();
        if (behind == places.end() || comes_first(line, fresh, places_[*behind])) continue;
        // Several, so far without a common line, may turn out to be one.
        if (found >= 0) merge(found, *behind);
        found = find(*behind);
      }
      place_of_[n] = found >= 0 ? found : add(fresh);
      for (int r = 0; r < 3; ++r) {
        auto& places = here[node.lines[r]];
        if (at[r] == std::ssize(places) || find(places[at[r]]) != place_of_[n]) places.insert(places.begin() + at[r], place_of_[n]);
      }
    }
  }

  std::array<line_id, 2> crossing_of(const triple& lines) const {
    for (const std::array<int, 2> pair : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}})
      if (k_.transversal(lines[pair[0]], lines[pair[1]])) return {lines[pair[0]], lines[pair[1]]};
    broken_invariant<K>("two lines of an event cross in the limit");
  }

  const K& k_;
  const skeleton& raw_;
  std::vector<meeting> moments_;  // those of several nodes
  std::vector<place> places_;     // in order of time
  disjoint_sets same_;            // places that have turned out to be one
  std::vector<int> place_of_;     // by node
  std::vector<bool> shared_;      // by node: others are of the same moment; empty: none
};

}  // namespace osteon::plane
