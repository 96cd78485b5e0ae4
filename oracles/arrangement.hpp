// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The ways to split a vertex as thesis 3.11 sees them: its planes, moved on, cut space into cells, and a split is a selection of them. Exponential.
/// Shares no code with the library but its numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "osteon/kernel/integer.hpp"

namespace osteon::oracles {

/// A corner whose facet i lies between rays i and i + 1, with the angle below half a turn, and moves by `speeds[i]` along -normals[i].
/// Requires general position.
class arrangement {
 public:
  using vector = std::array<integer, 3>;
  using tree = std::set<std::array<int, 3>>;  // the three facets of each vertex, ascending

  arrangement(std::vector<vector> rays, std::vector<vector> normals, std::vector<integer> speeds)
      : rays_(std::move(rays)), n_(std::move(normals)), speeds_(std::move(speeds)), k_(n_.size()) {
    find_cells();
    find_inside();
  }

  /// The selections that are monotone seen from the vertex, whose facets are connected and whose vertices have three of them.
  std::set<tree> selections() const {
    std::vector<cell> free;  // those with more planes in front of them come first: what lies behind a cell comes before it
    for (std::size_t passed = k_ + 1; passed-- > 0;)
      for (const cell c : cells_)
        if (unbounded_.count(c) == 0 && count(c) == passed) free.push_back(c);
    std::set<tree> result;
    std::set<cell> chosen;
    for (const auto& [c, inside] : unbounded_)
      if (inside) chosen.insert(c);
    const std::function<void(std::size_t)> choose = [&](std::size_t at) {
      if (at == free.size()) {
        if (!is_monotone(chosen)) return;
        if (const tree t = tree_of(chosen); t.size() == k_ - 2) result.insert(t);
        return;
      }
      choose(at + 1);
      if (!may_join(free[at], chosen)) return;
      chosen.insert(free[at]);
      choose(at + 1);
      chosen.erase(free[at]);
    };
    choose(0);
    return result;
  }

 private:
  // A cell by the planes on whose inner side it lies. The vertex, where it was, is on the outer side of all: a ray from there passes from the outer
  // to the inner side of a plane or not at all.
  using cell = std::uint32_t;

  static vector cross(const vector& a, const vector& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
  static integer dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static cell bit(std::size_t plane) { return cell{1} << plane; }
  std::size_t count(cell c) const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < k_; ++i) n += c >> i & 1U;
    return n;
  }

  // Every cell has a vertex or, before the planes move, a ray.
  void find_cells() {
    for (std::size_t a = 0; a < k_; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const vector line = cross(n_[a], n_[b]);
        for (const int way : {1, -1}) {
          cell others = 0;
          for (std::size_t i = 0; i < k_; ++i)
            if (i != a && i != b && way * dot(n_[i], line) < 0) others |= bit(i);
          for (const cell c : {cell{0}, bit(a), bit(b), bit(a) | bit(b)}) unbounded_[others | c] = false;
        }
        for (std::size_t c = 0; c < b; ++c) {
          const integer det = dot(n_[c], line);
          vector p{};  // n . p = -speed * det for the three
          for (std::size_t axis = 0; axis < 3; ++axis)
            p[axis] = -(speeds_[c] * line[axis] + speeds_[a] * cross(n_[b], n_[c])[axis] + speeds_[b] * cross(n_[c], n_[a])[axis]);
          cell others = 0;
          for (std::size_t i = 0; i < k_; ++i)
            if (i != a && i != b && i != c && (dot(n_[i], p) + speeds_[i] * det < 0) == (det > 0)) others |= bit(i);
          for (cell m = 0; m < 8; ++m)
            cells_.insert(others | ((m & 1U) != 0 ? bit(a) : 0) | ((m & 2U) != 0 ? bit(b) : 0) | ((m & 4U) != 0 ? bit(c) : 0));
        }
      }
    for (const auto& [c, inside] : unbounded_) cells_.insert(c);
  }

  // Which unbounded cells belong to the solid: passing a plane in its facet's wedge goes in or out.
  void find_inside() {
    std::map<cell, std::map<std::size_t, bool>> walls;  // by the cell on the outer side and the plane: whether it is in the wedge
    for (std::size_t a = 0; a < k_; ++a) {
      std::map<cell, vector> inner;  // a direction inside each wall of plane a, the sum of its two rays
      for (std::size_t b = 0; b < k_; ++b) {
        if (b == a) continue;
        for (const int way : {1, -1}) {
          vector line = cross(n_[a], n_[b]);
          for (integer& x : line) x *= way;
          cell others = 0;
          for (std::size_t i = 0; i < k_; ++i)
            if (i != a && i != b && dot(n_[i], line) < 0) others |= bit(i);
          for (const cell side : {cell{0}, bit(b)})
            for (std::size_t axis = 0; axis < 3; ++axis) inner[others | side][axis] += line[axis];
        }
      }
      for (const auto& [c, w] : inner) walls[c][a] = dot(n_[a], cross(rays_[a], w)) > 0 && dot(n_[a], cross(w, rays_[(a + 1) % k_])) > 0;
    }
    std::map<cell, bool> known;
    std::vector<cell> waiting;
    for (const auto& [c, by_plane] : walls)
      for (const auto& [a, in_wedge] : by_plane)
        if (in_wedge && known.empty()) {
          known[c] = false;
          waiting.push_back(c);
        }
    while (!waiting.empty()) {
      const cell c = waiting.back();
      waiting.pop_back();
      for (std::size_t a = 0; a < k_; ++a) {
        const cell other = c ^ bit(a);
        const auto wall = walls.find(c & ~bit(a));
        if (wall == walls.end() || wall->second.count(a) == 0 || known.count(other) != 0) continue;
        known[other] = known[c] != wall->second.at(a);
        waiting.push_back(other);
      }
    }
    for (auto& [c, inside] : unbounded_) inside = known.at(c);
  }

  bool may_join(cell c, const std::set<cell>& chosen) const {
    for (std::size_t a = 0; a < k_; ++a)
      if ((c & bit(a)) == 0 && cells_.count(c | bit(a)) != 0 && chosen.count(c | bit(a)) == 0) return false;
    return true;
  }
  bool is_monotone(const std::set<cell>& chosen) const {
    for (const cell c : chosen)
      if (!may_join(c, chosen)) return false;
    return true;
  }

  // The vertices of the selection's surface; nothing where a facet is not connected, or more than three edges end in a vertex.
  tree tree_of(const std::set<cell>& chosen) const {
    const auto is_facet = [&](std::size_t a, cell c) {
      return chosen.count(c | bit(a)) != 0 && chosen.count(c & ~bit(a)) == 0 && cells_.count(c & ~bit(a)) != 0;
    };
    for (std::size_t a = 0; a < k_; ++a) {
      std::set<cell> walls;
      for (const cell c : cells_)
        if ((c & bit(a)) == 0 && cells_.count(c | bit(a)) != 0 && is_facet(a, c)) walls.insert(c);
      if (walls.empty()) return {};
      std::vector<cell> waiting = {*walls.begin()};
      walls.erase(walls.begin());
      while (!waiting.empty()) {
        const cell c = waiting.back();
        waiting.pop_back();
        for (std::size_t b = 0; b < k_; ++b)
          if (b != a && walls.erase(c ^ bit(b)) != 0) waiting.push_back(c ^ bit(b));
      }
      if (!walls.empty()) return {};
    }
    tree result;
    for (std::size_t c = 2; c < k_; ++c)
      for (std::size_t b = 1; b < c; ++b)
        for (std::size_t a = 0; a < b; ++a) {
          const cell all = bit(a) | bit(b) | bit(c);
          for (const cell base : cells_) {
            if ((base & all) != 0) continue;
            bool meet = true;
            std::array<bool, 8> state{};
            for (cell m = 0; m < 8; ++m) {
              const cell at = base | ((m & 1U) != 0 ? bit(a) : 0) | ((m & 2U) != 0 ? bit(b) : 0) | ((m & 4U) != 0 ? bit(c) : 0);
              meet = meet && cells_.count(at) != 0;
              state[m] = chosen.count(at) != 0;
            }
            if (!meet) continue;
            int planes = 0;  // that the surface follows here
            for (const cell plane : {1U, 2U, 4U}) {
              bool there = false;
              for (cell m = 0; m < 8; ++m) there = there || state[m] != state[m ^ plane];
              planes += there ? 1 : 0;
            }
            if (planes < 3) continue;
            const bool majority = state == std::array<bool, 8>{false, false, false, true, false, true, true, true};
            if (majority || !result.insert({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)}).second) return {};
          }
        }
    return result;
  }

  std::vector<vector> rays_, n_;
  std::vector<integer> speeds_;
  std::size_t k_;
  std::set<cell> cells_;
  std::map<cell, bool> unbounded_;  // whether it belongs to the solid
};

}  // namespace osteon::oracles
