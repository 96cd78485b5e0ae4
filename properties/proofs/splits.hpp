// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Statements about the splits of corners, examined on large families of corners in small integers: see design 03.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cone.hpp"
#include "offset_surface.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/models/polyhedra.hpp"
#include "osteon/space/split.hpp"
#include "report.hpp"
#include "triangulations.hpp"

namespace osteon::proofs {

class split_survey {
 public:
  std::vector<proof> run() {
    for (int k = 4; k <= greatest_degree; ++k)
      for (triangulation& t : triangulations(k)) {
        operations list = encode(k, t);
        trees_[static_cast<std::size_t>(k)].push_back({std::move(t), std::move(list)});
      }
    for (auto& list : trees_) std::sort(list.begin(), list.end(), [](const tree& s, const tree& t) { return s.list < t.list; });
    all_walks(4, {1, 2, 3});
    all_walks(5, {1, 3});
    const std::size_t exhaustive = corners_;
    random_corners();
    oracle_.note(std::to_string(corners_) + " corners with speeds, " + std::to_string(exhaustive) +
                 " of them by enumeration: all walks of 4 of the 26 " +
                 "directions with coordinates -1, 0, 1, and of 5 of the 14 axes and diagonals, with at most one facet of more than half a turn");
    for (const auto& [kind, count] : kinds_) oracle_.note(kind + ": " + std::to_string(count));
    oracle_.note("left out: " + std::to_string(coplanar_) + " with a plane twice, " + std::to_string(degenerate_) +
                 " with four planes that stay concurrent");
    rule_.note(std::to_string(trees_seen_) + " trees, " + std::to_string(passed_) + " obey the rule, " + std::to_string(valid_) + " are valid");
    existence_.note(std::to_string(without_) + " corners with three planes through one line have no valid tree (a vertex at infinity)");
    return {rule_, oracle_, facets_, existence_};
  }

 private:
  struct tree {
    triangulation triangles;
    operations list;
  };
  static constexpr int greatest_degree = 9;

  // ---- families

  // All closed walks of k of the directions in {-1,0,1}^3 with the given numbers of coordinates that are not zero. The symmetries of the
  // cube bring the first to one of each kind.
  void all_walks(int k, const std::vector<int>& sizes) {
    std::vector<vec<long>> directions;
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y)
        for (long z = -1; z <= 1; ++z)
          if (std::find(sizes.begin(), sizes.end(), std::abs(x) + std::abs(y) + std::abs(z)) != sizes.end()) directions.push_back({x, y, z});
    for (const int size : sizes) {
      std::vector<vec<long>> walk = {{1, size > 1 ? 1 : 0, size > 2 ? 1 : 0}};
      extend(walk, k, directions);
    }
  }
  void extend(std::vector<vec<long>>& walk, int k, const std::vector<vec<long>>& directions) {
    if (static_cast<int>(walk.size()) == k) {
      examine_all(walk, 2);
      return;
    }
    for (const auto& r : directions) {
      if (std::find(walk.begin(), walk.end(), r) != walk.end()) continue;
      walk.push_back(r);
      extend(walk, k, directions);
      walk.pop_back();
    }
  }

  // Walks grown ray by ray, which winds them; stars around an axis; convex cones and, walked the other way, reflex ones.
  void random_corners() {
    for (int k = 4; k <= greatest_degree; ++k)
      for (int n = 0; n < (k <= 7 ? 1500 : most_trees / static_cast<int>(trees_[static_cast<std::size_t>(k)].size())); ++n) {
        examine_all(grown(k), 1);
        examine_all(star(k, -3, 3, false), 1);
        examine_all(star(k, 1, 3, false), 1);
        std::vector<vec<long>> round = star(k, 2, 2, true);
        if (n % 2 != 0) std::reverse(round.begin(), round.end());
        examine_all(round, 1);
      }
  }
  std::vector<vec<long>> grown(int k) {
    const auto any = [this] { return vec<long>{roll_.between(-3, 3), roll_.between(-3, 3), roll_.between(-3, 3)}; };
    std::vector<vec<long>> walk;
    while (walk.size() < 3 || !cone(walk, -1).simple()) walk = {any(), any(), any()};
    while (static_cast<int>(walk.size()) < k) {
      std::vector<vec<long>> longer = walk;
      longer.insert(longer.begin() + roll_.between(0, static_cast<long>(walk.size())), any());
      if (cone(longer, -1).simple()) walk = std::move(longer);
    }
    return walk;
  }
  std::vector<vec<long>> star(int k, long low, long high, bool round) {
    std::vector<vec<long>> walk;
    while (static_cast<int>(walk.size()) < k) {
      const vec<long> r = {roll_.between(-3, 3), roll_.between(-3, 3), roll_.between(low, high)};
      const long far = r[0] * r[0] + r[1] * r[1];
      if (far == 0 || (round && far != 9 && far != 10)) continue;
      const bool taken =
          std::any_of(walk.begin(), walk.end(), [&](const vec<long>& s) { return s[0] * r[1] == s[1] * r[0] && s[0] * r[0] + s[1] * r[1] > 0; });
      if (!taken) walk.push_back(r);
    }
    std::sort(walk.begin(), walk.end(), [](const vec<long>& s, const vec<long>& t) {
      return std::atan2(static_cast<double>(s[1]), static_cast<double>(s[0])) < std::atan2(static_cast<double>(t[1]), static_cast<double>(t[0]));
    });
    return walk;
  }

  // ---- one corner

  // Every facet may take the long way; two cannot, for two arcs of more than half a turn meet.
  void examine_all(const std::vector<vec<long>>& walk, int speeds) {
    for (int facet = -1; facet < static_cast<int>(walk.size()); ++facet) {
      const cone c(walk, facet);
      if (!c.simple()) continue;
      if (plane_twice(c)) {
        ++coplanar_;
        continue;
      }
      for (int s = 0; s < speeds; ++s) {
        const bool unit = speeds == 1 ? corners_ % 2 == 0 : s == 0;
        std::vector<long> speed;
        for (const auto& n : c.normal)  // 64 times the length, or anything
          speed.push_back(unit ? static_cast<long>(std::sqrt(static_cast<double>(4096 * inner_product(n, n)))) : roll_.between(1, 99));
        const cone_kernel k(c, speed);
        if (stays_concurrent(c, k)) {
          ++degenerate_;
          continue;
        }
        examine(c, k, std::vector<wide>(speed.begin(), speed.end()), unit ? "unit speeds" : "weights");
        if (corners_ % 20 == 0) examine_with_library_kernel(c);
      }
    }
  }

  static bool plane_twice(const cone& c) {
    for (int a = 0; a < c.degree(); ++a)
      for (int b = a + 1; b < c.degree(); ++b)
        if (c.normal[c.at(a)] == c.normal[c.at(b)]) return true;
    return false;
  }

  template <class Visit>
  static bool any_quadruple(int k, Visit&& visit) {
    for (plane_id a = 0; a < k; ++a)
      for (plane_id b = a + 1; b < k; ++b)
        for (plane_id d = b + 1; d < k; ++d)
          for (plane_id e = d + 1; e < k; ++e)
            if (visit(quadruple{a, b, d, e})) return true;
    return false;
  }
  template <class K>
  static bool shares_a_line(const K& k, const quadruple& q) {
    return k.orientation(q[0], q[1], q[2]) == sign::zero || k.orientation(q[0], q[1], q[3]) == sign::zero ||
           k.orientation(q[0], q[2], q[3]) == sign::zero || k.orientation(q[1], q[2], q[3]) == sign::zero;
  }
  template <class K>
  static bool parallel_to_a_line(const K& k, const quadruple& q) {
    return k.orientation(q[0], q[1], q[2]) == sign::zero && k.orientation(q[0], q[1], q[3]) == sign::zero &&
           k.orientation(q[0], q[2], q[3]) == sign::zero && k.orientation(q[1], q[2], q[3]) == sign::zero;
  }
  template <class K>
  static bool stays_concurrent(const cone& c, const K& k) {
    return any_quadruple(c.degree(), [&](const quadruple& q) { return !k.meet(q) && !parallel_to_a_line(k, q); });
  }

  // The true kernel of the library: unit speeds to 64 bits, in integers of any size.
  void examine_with_library_kernel(const cone& c) {
    std::vector<moving_plane<integer>> facets;
    for (const auto& n : c.normal) facets.push_back({{integer(n[0]), integer(n[1]), integer(n[2])}, integer(0)});
    const rational_kernel k = make_rational_kernel(facets);
    if (stays_concurrent(c, k)) return;
    std::vector<integer> speed;
    for (plane_id i = 0; i < k.size(); ++i) speed.push_back(k.arithmetic().speed(i));
    examine(c, k, speed, "the library's rational kernel");
  }

  template <class K, class Int>
  void examine(const cone& c, const K& k, const std::vector<Int>& speeds, const std::string& kind) {
    ++corners_;
    const int convex = c.convex_edges();
    const bool round = convex == c.degree() || convex == 0;
    ++kinds_["degree " + std::to_string(c.degree()) + ", " +
             (round ? (convex == 0 ? "reflex" : "convex") : (c.pointed() ? "mixed, pointed" : "mixed, not pointed"))];
    ++kinds_["with " + kind];
    const auto what = [&](const operations& list) {
      std::string s = c.text() + "; speeds";
      for (const Int& v : speeds) s += ' ' + std::to_string(static_cast<long>(v >> (kind.front() == 't' ? 58U : 0U)));
      return s + (list.empty() ? "" : "; tree " + proofs::text(list));
    };

    std::vector<operations> valid;
    std::vector<operations> obedient;
    for (const tree& t : trees_[static_cast<std::size_t>(c.degree())]) {
      const offset_surface<Int> surface(c, speeds, t.triangles);
      ++trees_seen_;
      if (!surface.well_made()) continue;
      const bool on_sphere = surface.free_of_crossings_on_the_sphere();
      oracle_.check(on_sphere == surface.free_of_intersections_in_space(), [&] { return what(t.list) + ": sphere and space disagree"; });
      const bool obeys = surface.obeys_local_rule();
      rule_.check((obeys || !on_sphere) && surface.kinds_agree(), [&] { return what(t.list) + " is valid and breaks the local rule"; });
      if (obeys) obedient.push_back(t.list);
      if (on_sphere) valid.push_back(t.list);
      // An immersion of a disk in the sphere whose border is a simple curve is one to one: over the two sides of the curve lie d + 1 and d
      // disks, and 2 d + 1 is the disk's Euler characteristic.
      if (obeys)
        facets_.check(on_sphere == surface.facets_are_simple(), [&] { return what(t.list) + " has simple facets and an edge that pierces one"; });
    }
    passed_ += static_cast<long>(obedient.size());
    valid_ += static_cast<long>(valid.size());

    const splitter<K> s(k, c.as_corner());
    const auto lists = [](const std::vector<split_tree>& trees) {
      std::vector<operations> result;
      for (const split_tree& t : trees) result.push_back(t.operations);
      return result;
    };
    rule_.check(lists(s.candidates()) == obedient, [&] { return what({}) + ": the splitter's candidates are not those that obey the rule"; });
    oracle_.check(lists(s.all()) == valid, [&] { return what({}) + ": the splitter lists other trees"; });

    const bool general = !any_quadruple(c.degree(), [&](const quadruple& q) { return shares_a_line(k, q); });
    if (!general) {
      without_ += valid.empty() ? 1 : 0;
      return;
    }
    existence_.check(round ? valid.size() == 1 : !valid.empty(), [&] { return what({}) + " has " + std::to_string(valid.size()) + " valid trees"; });
  }

  static constexpr int most_trees = 60000;  ///< a family of great degree

  proof rule_{"Local rule: no valid tree of the corners examined breaks it; the splitter's candidates are the trees that obey it"};
  proof oracle_{"Splits: for the corners examined the splitter's list of valid trees is that of two brute-force oracles, on the sphere and in space"};
  proof facets_{"Facets suffice: for the corners examined a tree that obeys the local rule is valid iff each of its facets is a simple polygon"};
  proof existence_{"Splits exist: every corner examined in general position has a valid tree; convex and reflex ones have one only"};
  std::array<std::vector<tree>, greatest_degree + 1> trees_;
  models::dice roll_{2026};
  std::map<std::string, long> kinds_;
  std::size_t corners_ = 0;
  long coplanar_ = 0;
  long degenerate_ = 0;
  long trees_seen_ = 0;
  long passed_ = 0;
  long valid_ = 0;
  long without_ = 0;
};

}  // namespace osteon::proofs
