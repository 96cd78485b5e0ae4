// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The corner of a vertex and the signs that decide how it splits, by the numbers of the facets
/// around it (docs/theory/vertex-splitting.md).

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/segment.hpp"

namespace osteon {

/// The corner of a vertex: the planes around it in their order, and how they meet.
struct corner {
  std::vector<plane_id> facets;  ///< counter-clockwise seen from outside
  std::vector<bool> convex;      ///< the edge between facets m and m + 1

  /// Returns the number of facets around the vertex.
  int degree() const { return static_cast<int>(facets.size()); }
};

/// Returns the corner of a vertex of a solid.
inline corner corner_at(const boundary& b, int vertex) {
  const auto& v = b.vertices[static_cast<std::size_t>(vertex)];
  corner c{v.facets, {}};
  for (const int e : v.edges) c.convex.push_back(b.edges[static_cast<std::size_t>(e)].convex);
  return c;
}

/// Returns whether all facets lie in different planes.
inline bool has_different_planes(const corner& c) {
  std::vector<plane_id> planes = c.facets;
  std::sort(planes.begin(), planes.end());
  return std::adjacent_find(planes.begin(), planes.end()) == planes.end();
}

/// The greatest degree at which the signs of a corner are remembered: a byte for every four facets,
/// 330 MB at this degree.
inline constexpr int greatest_remembered_degree = 300;

/// The signs of one corner, just after the start. Facets are numbers 0 .. degree - 1 around the
/// corner. Up to greatest_remembered_degree the kernel is asked each predicate once.
template <kernel<3> K>
class corner_signs {
 public:
  /// `bounded` demands that all vertices stay near, as a solid needs it. Without it three planes
  /// that share a line may make a vertex too, which is infinitely far away; a perturbed kernel
  /// tells where.
  corner_signs(const K& k, corner c, bool bounded = true) : k_(k), c_(std::move(c)), start_(k.start()), bounded_(bounded) {
    if (degree() > greatest_remembered_degree) return;
    orientations_.assign(choose(degree(), 3), unknown);
    lifts_.assign(choose(degree(), 4), unknown);
  }

  /// Returns the kernel that is asked.
  const K& kernel() const { return k_; }
  /// Returns the moment just after the start.
  const typename K::meeting& start() const { return start_; }
  /// Returns the corner that the signs are of.
  const corner& of() const { return c_; }
  /// Returns the number of facets around the vertex.
  int degree() const { return c_.degree(); }
  /// Returns the plane of a facet.
  plane_id plane(int facet) const { return c_.facets[static_cast<std::size_t>(facet)]; }

  /// Returns whether the kernel knows that all planes move at the same speed.
  bool has_unit_speeds() const {
    if constexpr (requires { k_.has_unit_speeds(); }) return k_.has_unit_speeds();
    return false;
  }

  /// Returns whether the corner's edge between facet m and m + 1 is convex.
  bool ray_is_convex(int m) const { return c_.convex[static_cast<std::size_t>(m)]; }

  /// Returns whether the planes of three facets make a vertex.
  bool meets(int a, int b, int c) const { return meet(plane(a), plane(b), plane(c)); }
  /// Returns whether three planes make a vertex.
  bool meet(plane_id p, plane_id q, plane_id r) const { return bounded_ ? k_.transversal(p, q, r) : k_.orientation(p, q, r) != sign::zero; }

  /// Returns the sign of det(n_a, n_b, n_c); zero where two facets are of one plane or the three
  /// share a line.
  sign orientation(int a, int b, int c) const {
    sign order = sign::positive;
    if (a > b) std::swap(a, b), order = -order;
    if (b > c) std::swap(b, c), order = -order;
    if (a > b) std::swap(a, b), order = -order;
    if (a == b || b == c) return sign::zero;
    if (orientations_.empty()) return k_.orientation(plane(a), plane(b), plane(c)) * order;
    signed char& known = orientations_[choose(c, 3) + choose(b, 2) + static_cast<std::size_t>(a)];
    if (known == unknown) known = static_cast<signed char>(k_.orientation(plane(a), plane(b), plane(c)));
    return static_cast<sign>(known) * order;
  }

  /// Returns the side of facet d on which the vertex (a,b,c) lies just after the start: the sign of
  /// S / lambda_d, with S remembered for the four.
  /// *Requires* that the three meet. *Throws* as generic_side.
  sign side(int d, int a, int b, int c) const {
    const auto q = sorted(std::array{a, b, c, d});
    if (lifts_.empty()) return generic_side(k_, plane(d), plane(a), plane(b), plane(c), start_);
    const std::size_t r = position(q, d);
    const std::array<int, 3> v = omit(q, r);
    const sign lambda_d = lambda(q, r, [this](int f, int g, int h) { return orientation(f, g, h); });
    signed char& known = lifts_[choose(q[3], 4) + choose(q[2], 3) + choose(q[1], 2) + static_cast<std::size_t>(q[0])];
    if (known == unknown || lambda_d == sign::zero)
      known = static_cast<signed char>(generic_side(k_, plane(d), plane(v[0]), plane(v[1]), plane(v[2]), start_) * lambda_d);
    return static_cast<sign>(known) * lambda_d;
  }

  /// Returns whether three facets, in any order, have an orientation that is positive in ascending
  /// order: around such a vertex all edges run inside their third facet, or none.
  bool positive(int a, int b, int c) const {
    const auto v = sorted(std::array{a, b, c});
    return orientation(v[0], v[1], v[2]) == sign::positive;
  }

  /// Returns whether the edge between the vertices (a,b,below) and (a,b,above) is convex: iff (det
  /// > 0) == (it runs inside), at either end (docs/theory/vertex-splitting.md).
  /// *Requires* that below and above are of different planes: else the vertices are one point.
  bool is_convex(int a, int b, int below, int above) const { return positive(a, b, below) == (side(below, a, b, above) == sign::positive); }

  /// An edge of a facet, as part of its border.
  struct border {
    int facet, other;
    std::array<int, 2> ends;  ///< third facets of its vertices; -1: it runs on for ever
    bool convex;
  };

  /// Returns whether two edges of one facet, or of facets in one plane, cross. Two of which one
  /// ends on the line of the other do not.
  bool cross(const border& x, const border& y) const {
    const auto ends_on = [this](const border& e, int other) {
      return std::any_of(e.ends.begin(), e.ends.end(), [&](int end) { return end >= 0 && plane(end) == plane(other); });
    };
    if (ends_on(x, y.other) || ends_on(y, x.other)) return false;
    return x.other != y.other && meets(x.facet, x.other, y.other) && runs_through(x, y.other) && runs_through(y, x.other);
  }

 private:
  static constexpr signed char unknown = 2;

  static std::size_t choose(int n, int r) {
    const auto m = static_cast<std::size_t>(n);
    if (n < r) return 0;
    return r == 2 ? m * (m - 1) / 2 : (r == 3 ? m * (m - 1) * (m - 2) / 6 : m * (m - 1) * (m - 2) / 6 * (m - 3) / 4);
  }

  // Whether the line of x meets that with facet y between the ends of x.
  bool runs_through(const border& x, int y) const {
    for (const int end : x.ends)
      if (end >= 0 && end != y && (side(end, x.facet, x.other, y) == sign::positive) != (x.convex == positive(x.facet, x.other, end))) return false;
    return true;
  }

  const K& k_;
  corner c_;
  typename K::meeting start_;
  bool bounded_;
  mutable std::vector<signed char> orientations_;  // by three facets, ascending
  mutable std::vector<signed char> lifts_;         // by four: the sign of S just after the start
};

}  // namespace osteon
