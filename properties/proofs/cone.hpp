// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Corners of solids in coordinates: closed walks r_0, r_1, ... of directions on the sphere, and a kernel for their planes with
/// speeds that are integers.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/space/split.hpp"

namespace osteon::proofs {

__extension__ typedef __int128 wide;

template <class Int>
using vec = std::array<Int, 3>;

template <class Int>
vec<Int> cross_product(const vec<Int>& a, const vec<Int>& b) {
  return {Int(a[1] * b[2] - a[2] * b[1]), Int(a[2] * b[0] - a[0] * b[2]), Int(a[0] * b[1] - a[1] * b[0])};
}
template <class Int>
Int inner_product(const vec<Int>& a, const vec<Int>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Int>
int sgn(const Int& x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}
template <class Int>
int det_sign(const vec<Int>& a, const vec<Int>& b, const vec<Int>& c) {
  return sgn(inner_product(a, cross_product(b, c)));
}

/// Whether x, on the great circle of p and q, lies on the closed arc from p to q, which is shorter than half a turn.
template <class Int>
bool on_arc(const vec<Int>& p, const vec<Int>& q, const vec<Int>& x) {
  const vec<Int> axis = cross_product(p, q);
  return inner_product(axis, x) == 0 && inner_product(axis, cross_product(p, x)) >= 0 && inner_product(axis, cross_product(x, q)) >= 0;
}

/// Whether the closed arcs p q and r t on the sphere, each shorter than half a turn, have a point in common.
template <class Int>
bool arcs_meet(const vec<Int>& p, const vec<Int>& q, const vec<Int>& r, const vec<Int>& t) {
  const vec<Int> pq = cross_product(p, q);
  const int a = sgn(inner_product(pq, r));
  const int b = sgn(inner_product(pq, t));
  if (a * b > 0) return false;
  const vec<Int> rt = cross_product(r, t);
  const int c = sgn(inner_product(rt, p));
  const int d = sgn(inner_product(rt, q));
  if (c * d > 0) return false;
  if (a * b * c * d != 0) return a != b && c != d && a == -c;  // else one arc meets the other's antipodes
  return on_arc(p, q, r) || on_arc(p, q, t) || on_arc(r, t, p) || on_arc(r, t, q);
}

/// Whether two arcs that start in one point have more in common.
template <class Int>
bool arcs_overlap(const vec<Int>& p, const vec<Int>& q, const vec<Int>& t) {
  return on_arc(p, q, t) || on_arc(p, t, q);
}

/// A corner: the sector of facet m runs from ray m - 1 to ray m, the short way, or the long way for facet `long_way`. Any closed walk
/// that does not meet itself bounds two solids; its direction says which. Apart from rays, all follows.
struct cone {
  std::vector<vec<long>> ray;
  int long_way = -1;
  std::vector<vec<long>> normal;  ///< outward
  std::vector<bool> convex;       ///< edge m lies on ray m, between facets m and m + 1

  cone(std::vector<vec<long>> rays, int long_facet) : ray(std::move(rays)), long_way(long_facet) {
    for (int m = 0; m < degree(); ++m) {
      vec<long> n = cross_product(before(m), ray[at(m)]);
      const long g = std::gcd(n[0], std::gcd(n[1], n[2])) * (m == long_way ? -1 : 1);
      if (g != 0) n = {n[0] / g, n[1] / g, n[2] / g};
      normal.push_back(n);
    }
    for (int m = 0; m < degree(); ++m) convex.push_back(inner_product(cross_product(normal[at(m)], normal[at(m + 1)]), ray[at(m)]) < 0);
  }

  int degree() const { return static_cast<int>(ray.size()); }
  std::size_t at(int m) const { return static_cast<std::size_t>((m + degree()) % degree()); }
  const vec<long>& before(int m) const { return ray[at(m - 1)]; }

  /// The arcs of the boundary, a long one in two pieces.
  struct arc {
    vec<long> from, to;
    int facet;
  };
  std::vector<arc> arcs() const {
    std::vector<arc> result;
    for (int m = 0; m < degree(); ++m) {
      const vec<long>& r = before(m);
      const vec<long>& s = ray[at(m)];
      if (m != long_way) {
        result.push_back({r, s, m});
        continue;
      }
      const vec<long> half = {-r[0] - s[0], -r[1] - s[1], -r[2] - s[2]};
      result.push_back({r, half, m});
      result.push_back({half, s, m});
    }
    return result;
  }

  /// Whether the walk does not meet itself, no facet is degenerate and no edge is flat.
  bool simple() const {
    for (int m = 0; m < degree(); ++m) {
      if (normal[at(m)] == vec<long>{0, 0, 0}) return false;
      if (inner_product(cross_product(normal[at(m)], normal[at(m + 1)]), ray[at(m)]) == 0) return false;
    }
    const std::vector<arc> all = arcs();
    const std::size_t n = all.size();
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b) {
        // Neighbours share an end; they lie on different great circles (edges are not flat) or are halves of one.
        if (b == a + 1 || (a == 0 && b == n - 1)) continue;
        if (arcs_meet(all[a].from, all[a].to, all[b].from, all[b].to)) return false;
      }
    return true;
  }

  int convex_edges() const { return static_cast<int>(std::count(convex.begin(), convex.end(), true)); }

  /// Whether all rays lie strictly to one side of some plane: by Caratheodory, no 2, 3 or 4 of them have the origin between them.
  bool pointed() const {
    const auto opposite = [](const vec<long>& a, const vec<long>& b) { return cross_product(a, b) == vec<long>{0, 0, 0} && inner_product(a, b) < 0; };
    const std::size_t n = ray.size();
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b) {
        if (opposite(ray[a], ray[b])) return false;
        for (std::size_t c = b + 1; c < n; ++c) {
          const vec<long> u = cross_product(ray[a], ray[b]);
          const vec<long> v = cross_product(ray[b], ray[c]);
          const vec<long> w = cross_product(ray[c], ray[a]);
          const int abc = sgn(inner_product(u, ray[c]));
          if (abc == 0 && inner_product(u, v) > 0 && inner_product(v, w) > 0) return false;
          for (std::size_t d = c + 1; d < n && abc != 0; ++d)
            if (sgn(inner_product(u, ray[d])) == -abc && sgn(inner_product(v, ray[d])) == -abc && sgn(inner_product(w, ray[d])) == -abc) return false;
        }
      }
    return true;
  }

  corner as_corner() const {
    corner c;
    for (int m = 0; m < degree(); ++m) c.facets.push_back(m);
    c.convex = convex;
    return c;
  }

  std::string text() const {
    std::string s = "rays";
    for (const auto& r : ray) s += " (" + std::to_string(r[0]) + ' ' + std::to_string(r[1]) + ' ' + std::to_string(r[2]) + ')';
    return long_way < 0 ? s : s + ", facet " + std::to_string(long_way) + " the long way";
  }
};

/// Planes n . x = -t speed. All meetings but the start are at time zero.
class cone_kernel {
 public:
  static constexpr bool exact = true;
  struct meeting {
    quadruple planes;
    sign closing;
  };
  struct bisector_type {
    plane_id a, b;
  };

  cone_kernel(const cone& c, std::span<const long> speeds) : speed_(speeds.begin(), speeds.end()) {
    for (const auto& n : c.normal) normal_.push_back({n[0], n[1], n[2]});
  }

  plane_id size() const { return static_cast<plane_id>(normal_.size()); }
  sign orientation(plane_id a, plane_id b, plane_id c) const { return static_cast<sign>(det_sign(n(a), n(b), n(c))); }
  bool transversal(plane_id a, plane_id b, plane_id c) const { return orientation(a, b, c) != sign::zero; }
  std::optional<meeting> meet(quadruple q) const {
    std::sort(q.begin(), q.end());
    const sign s = sign_of(closing_sum(q));
    return s == sign::zero ? std::nullopt : std::optional(meeting{q, s});
  }
  quadruple planes(const meeting& m) const { return m.planes; }
  sign closing(const meeting& m) const { return m.closing; }
  meeting start() const { return {{-1, -1, -1, -1}, sign::positive}; }
  sign compare(const meeting& a, const meeting& b) const { return sign_of(rank(a) - rank(b)); }

  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const {
    if (rank(m) == 0) return sign::zero;
    // h_d at the vertex, at time one: -speed_d - n_d . x
    const vec<wide> u = cross_product(n(b), n(c));
    const vec<wide> v = cross_product(n(c), n(a));
    const vec<wide> w = cross_product(n(a), n(b));
    const wide det = inner_product(n(a), u);
    wide x = 0;
    for (std::size_t i = 0; i < 3; ++i) x += n(d)[i] * (speed(a) * u[i] + speed(b) * v[i] + speed(c) * w[i]);
    return sign_of(x - speed(d) * det) * sign_of(det);
  }

  bisector_type bisector(plane_id a, plane_id b) const { return {a, b}; }
  sign compare(const bisector_type&, const bisector_type&) const { throw std::logic_error("no saddle, no bisector"); }
  sign compare_volume(std::span<const triple>, std::span<const triple>) const { throw std::logic_error("all valid trees are wanted, not the best"); }

  /// sum lambda_r speed_r
  wide closing_sum(const quadruple& q) const {
    wide sum = 0;
    for (int r = 0; r < 4; ++r) {
      triple t{};
      std::copy_if(q.begin(), q.end(), t.begin(), [&](plane_id p) { return p != q[static_cast<std::size_t>(r)]; });
      sum += (r % 2 == 0 ? -1 : 1) * speed(q[static_cast<std::size_t>(r)]) * inner_product(n(t[0]), cross_product(n(t[1]), n(t[2])));
    }
    return sum;
  }

 private:
  static int rank(const meeting& m) { return m.planes[0] < 0 ? 1 : 0; }
  const vec<wide>& n(plane_id i) const { return normal_[static_cast<std::size_t>(i)]; }
  wide speed(plane_id i) const { return speed_[static_cast<std::size_t>(i)]; }

  std::vector<vec<wide>> normal_;
  std::vector<long> speed_;
};
static_assert(kernel<cone_kernel, 3>);

}  // namespace osteon::proofs
