// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The shells of a surface, which of them enclose which, and whether their normals point outwards.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/rough_points.hpp"
#include "osteon/input/surface.hpp"

namespace osteon {

/// The check of orientation. A shell is a set of facets that edges connect. A shell that an even
/// number of others encloses must enclose material, another one a void.
template <class Int>
class shells {
 public:
  /// *Requires* a surface with planes and half-edges that does not meet itself but in points.
  explicit shells(const surface<Int>& s) : s_(s) {
    collect();
    find_depths();
  }

  /// Refuses with input_error(inverted) where a shell's normals point to the wrong side.
  void check() const {
    std::size_t wrong = 0;
    std::size_t example = 0;
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if ((six_volumes(i) > 0) == (depth_[i] % 2 == 0)) continue;
      ++wrong;
      example = static_cast<std::size_t>(shells_[i][0]);
    }
    if (wrong > 0 && wrong == shells_.size())
      s_.input.refuse_facet(input_fault::inverted, example, " and all others are inside-out: their normals point inwards",
                            "reverse all facets (--flip)");
    if (wrong > 0)
      s_.input.refuse_facet(input_fault::inverted, example, " and the shell it belongs to are inside-out",
                            "reverse that shell: outer shells run counter-clockwise seen from outside, voids seen from inside");
  }

 private:
  void collect() {
    std::vector<bool> done(s_.input.facets.size());
    std::vector<int> stack;
    for (std::size_t f = 0; f < done.size(); ++f) {
      if (done[f]) continue;
      auto& members = shells_.emplace_back();
      stack.push_back(static_cast<int>(f));
      done[f] = true;
      while (!stack.empty()) {
        const int g = stack.back();
        stack.pop_back();
        members.push_back(g);
        const int start = s_.edges.first(g);
        int h = start;
        do {
          const int next = s_.edges[s_.edges[h].twin].facet;
          if (!done[next]) stack.push_back(next);
          done[next] = true;
          h = s_.edges[h].next;
        } while (h != start);
      }
    }
  }

  // How many other shells enclose each one. One point of a shell tells, if it does not belong to
  // the other one as well.
  void find_depths() {
    std::vector<box3> boxes;
    for (const auto& members : shells_) {
      std::vector<int> corners;
      for (const int f : members) corners.insert(corners.end(), loop(f).begin(), loop(f).end());
      boxes.emplace_back(s_.rough, corners);
    }
    depth_.resize(shells_.size());
    std::vector<bool> marked(s_.points.size());  // the points of shell j
    for (std::size_t j = 0; j < shells_.size(); ++j) {
      mark(j, true, marked);
      for (std::size_t i = 0; i < shells_.size(); ++i) {
        if (i == j || !boxes[i].overlaps(boxes[j])) continue;
        const int p = point_without_mark(i, marked);
        if (box3(s_.rough, std::span(&p, 1)).overlaps(boxes[j]) && encloses(shells_[j], s_.points[p])) ++depth_[i];
      }
      mark(j, false, marked);
    }
  }

  void mark(std::size_t shell, bool value, std::vector<bool>& marked) const {
    for (const int f : shells_[shell])
      for (const int p : loop(f)) marked[p] = value;
  }

  int point_without_mark(std::size_t shell, const std::vector<bool>& marked) const {
    for (const int f : shells_[shell])
      for (const int p : loop(f))
        if (!marked[p]) return p;
    s_.input.refuse_facet(input_fault::non_manifold_vertex, static_cast<std::size_t>(shells_[shell][0]),
                          " belongs to a shell all points of which are points of another one", "move some of them a little away");
  }

  // Counts the facets that a ray from p crosses, in a direction in which it meets no edge.
  bool encloses(const std::vector<int>& shell, const vec<Int>& p) const {
    for (int attempt = 1;; ++attempt) {
      const vec<Int> r = {Int(attempt * 97 + 4), Int(attempt * attempt + 10), Int(attempt * 31 - 17)};
      bool inside = false;
      bool clean = true;
      for (const int f : shell) {
        const auto& plane = s_.plane(static_cast<std::size_t>(f));
        Int speed = dot(plane.n, r);
        Int distance = plane.d - dot(plane.n, p);
        if (speed == 0) {
          clean = clean && distance != 0;
          continue;
        }
        if (speed < 0) {
          speed = -speed;
          distance = -distance;
        }
        if (distance <= 0) continue;
        const auto axes = projection(plane.n);
        const point2<Int> hit = {p[axes[0]] * speed + r[axes[0]] * distance, p[axes[1]] * speed + r[axes[1]] * distance, speed};
        const auto where = locate_in_polygon<Int>(s_.points, loop(f), hit, axes);
        if (where == location::border) clean = false;
        if (where == location::inside) inside = !inside;
      }
      if (clean) return inside;
    }
  }

  // Six times the volume that a shell encloses, negative where its normals point inwards.
  Int six_volumes(std::size_t shell) const {
    Int sum = 0;
    for (const int f : shells_[shell]) sum += dot(s_.area(static_cast<std::size_t>(f)), s_.points[loop(f)[0]]);
    return sum;
  }

  const std::vector<int>& loop(int f) const { return s_.loop(static_cast<std::size_t>(f)); }

  const surface<Int>& s_;
  std::vector<std::vector<int>> shells_;  // their facets
  std::vector<int> depth_;                // by shell: how many others enclose it
};

}  // namespace osteon
