// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Planes for asking kernels: random ones, and ones whose predicates are zero or almost zero on purpose.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::oracles {

/// Planes with, for each, another one that is almost or exactly interchangeable with it (or itself).
struct plane_set {
  std::vector<moving_plane<integer>> planes;
  std::vector<plane_id> twins;
  bool through_one_point;  ///< at time zero
};

enum class family : std::uint8_t {
  // random
  short_numbers,   ///< of 4 bits
  middle_numbers,  ///< of 20 bits
  long_numbers,    ///< of 60 bits
  weighted,        ///< of 10 bits, speeds 1 to 5
  // adversarial
  square_classes,   ///< lengths in few square classes
  scaled,           ///< multiples of one another, exact or off by one in the 20th digit
  nearly_parallel,  ///< all normals within 2^-40 of a line or of a plane
  one_ball,         ///< tangent to a ball with an irrational radius: all meet in its middle at once; some off in the 20th digit
  mirrored,         ///< images of one another under the cube's symmetries: different planes meet at equal times
  one_cone,         ///< tangent to a cone: S is zero; some off in the 20th digit
};
inline constexpr int random_families = 4;
inline constexpr int all_families = 10;
inline constexpr std::array<std::string_view, all_families> family_names = {
    "short_numbers", "middle_numbers", "long_numbers", "weighted", "square_classes", "scaled", "nearly_parallel", "one_ball", "mirrored", "one_cone"};

class plane_maker {
 public:
  plane_maker(family f, std::uint64_t seed) : family_(f), roll_(seed) {}

  /// Sixteen planes at most.
  plane_set make(bool through_one_point) {
    const vector apex = {bits(6), bits(6), bits(6)};
    switch (family_) {
      case family::short_numbers:
        random(4);
        break;
      case family::middle_numbers:
        random(20);
        break;
      case family::long_numbers:
        random(60);
        break;
      case family::weighted:
        random(10);
        for (auto& p : made_) p.weight = roll_.between(1, 5);
        break;
      case family::square_classes:
        while (made_.size() < 14) add(times(class_normal(), roll_.between(1, 6)), bits(5));
        break;
      case family::scaled:
        for (int i = 0; i < 7; ++i) add({bits(12), bits(12), bits(12)}, bits(16));
        for (std::size_t i = 0; i < 7; ++i) pair_up(i, scaled(made_[i]));
        break;
      case family::nearly_parallel:
        nearly_parallel();
        break;
      case family::one_ball:
        one_ball(apex);
        break;
      case family::mirrored:
        mirrored();
        break;
      case family::one_cone:
        one_cone();
        break;
    }
    if (through_one_point)
      for (auto& p : made_) p.d = p.n[0] * apex[0] + p.n[1] * apex[1] + p.n[2] * apex[2];
    return {made_, twins_, through_one_point};
  }

 private:
  using vector = std::array<integer, 3>;

  integer bits(int n) {
    integer x = 0;
    for (int done = 0; done < n; done += 30) x = (x << 30U) + roll_.between(0, (1L << 30U) - 1);
    x >>= static_cast<unsigned>((n + 29) / 30 * 30 - n);
    return roll_.between(0, 1) == 0 ? integer(-x) : x;
  }
  static vector times(vector v, const integer& factor) {
    for (auto& x : v) x *= factor;
    return v;
  }
  vector symmetric(vector v) {
    for (int i = 2; i > 0; --i) std::swap(v[i], v[roll_.between(0, i)]);
    for (auto& x : v)
      if (roll_.between(0, 1) == 0) x = -x;
    return v;
  }

  void add(const vector& n, const integer& d, const integer& weight = 1) {
    if (n == vector{0, 0, 0}) return;
    twins_.push_back(static_cast<plane_id>(made_.size()));
    made_.push_back({n, d, weight});
  }
  void pair_up(std::size_t i, const moving_plane<integer>& p) {
    twins_[i] = static_cast<plane_id>(made_.size());
    twins_.push_back(static_cast<plane_id>(i));
    made_.push_back(p);
  }

  void random(int n) {
    while (made_.size() < 14) add({bits(n), bits(n), bits(n)}, bits(n));
  }

  // The same plane times some number up to 2^70; sometimes the last digit of the offset is another one.
  moving_plane<integer> scaled(const moving_plane<integer>& p) {
    const integer factor = roll_.between(0, 1) == 0 ? integer(roll_.between(2, 9)) : (integer(1) << 66U) + bits(66);
    moving_plane<integer> q{times(p.n, factor), p.d * factor, p.weight};
    if (factor > 9 && roll_.between(0, 1) == 0) q.d += roll_.between(0, 1) == 0 ? 1 : -1;
    return q;
  }

  // Squared lengths 2, 3, 6, 1 and 5 times squares.
  vector class_normal() {
    static constexpr std::array<std::array<int, 3>, 14> normals = {{{1, 1, 0},
                                                                    {4, 1, 1},
                                                                    {7, 4, 3},
                                                                    {1, 1, 1},
                                                                    {5, 1, 1},
                                                                    {7, 7, 7},
                                                                    {2, 1, 1},
                                                                    {7, 2, 1},
                                                                    {5, 5, 2},
                                                                    {2, 2, 1},
                                                                    {6, 3, 2},
                                                                    {2, 1, 0},
                                                                    {5, 4, 2},
                                                                    {6, 5, 8}}};
    const auto& n = normals[static_cast<std::size_t>(roll_.between(0, 13))];
    return symmetric({n[0], n[1], n[2]});
  }

  void nearly_parallel() {
    const vector a = {bits(12), bits(12), bits(12) + 5000};
    const vector b = {bits(12), bits(12) + 5000, bits(12)};
    const bool line = roll_.between(0, 1) == 0;
    for (int i = 0; i < 7; ++i) {
      const integer x = (integer(1) << 41U) + bits(40);
      const integer y = line ? integer(0) : bits(41);
      vector n{};
      for (int axis = 0; axis < 3; ++axis) n[axis] = x * a[axis] + y * b[axis] + roll_.between(-2, 2);
      add(n, bits(50));
    }
    for (std::size_t i = 0; i < 7; ++i) {
      auto p = made_[i];
      p.n[static_cast<std::size_t>(roll_.between(0, 2))] += roll_.between(-1, 1);
      p.d += roll_.between(-1, 1);
      pair_up(i, p);
    }
  }

  // sigma = m sqrt(r) and the radius k sqrt(r), so that t sigma = k r m.
  void one_ball(const vector& middle) {
    static constexpr std::array<int, 5> radicands = {2, 3, 6, 1, 5};
    const auto c = static_cast<std::size_t>(roll_.between(0, 4));
    const long radius = roll_.between(1, 50);
    while (made_.size() < 8) {
      vector n{};
      integer length;
      do {
        n = times(class_normal(), roll_.between(1, 4));
        const integer square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        length = square % radicands[c] == 0 && is_square(square / radicands[c]) ? isqrt(square / radicands[c]) : integer(0);
      } while (length == 0);
      const long weight = roll_.between(0, 3) == 0 ? 2 : 1;
      add(n, n[0] * middle[0] + n[1] * middle[1] + n[2] * middle[2] + radius * radicands[c] * weight * length, weight);
    }
    for (std::size_t i = 0; i < 6; ++i) pair_up(i, scaled(made_[i]));
  }

  void mirrored() {
    for (int i = 0; i < 7; ++i) add({bits(20), bits(20), bits(20)}, bits(20));
    const auto shift = static_cast<std::size_t>(roll_.between(0, 2));
    const std::array<long, 3> signs = {roll_.between(0, 1) * 2 - 1, roll_.between(0, 1) * 2 - 1, roll_.between(0, 1) * 2 - 1};
    for (std::size_t i = 0; i < 7; ++i) {
      auto p = made_[i];
      for (std::size_t axis = 0; axis < 3; ++axis) p.n[axis] = made_[i].n[(axis + shift) % 3] * signs[axis];
      pair_up(i, p);
    }
  }

  void one_cone() {
    for (int cone = 0; cone < 2; ++cone) {
      const vector n = {bits(12) + 5000, bits(12) + 5000, bits(12) + 5000};
      for (const long x : {-1, 1})
        for (const long y : {-1, 1}) add({n[0] * x, n[1] * y, n[2]}, bits(16));
    }
    for (std::size_t i = 0; i < 8; ++i) {
      auto p = scaled(made_[i]);
      if (p.n[2] > (integer(1) << 60U) && roll_.between(0, 1) == 0) p.n[2] += 1;
      pair_up(i, p);
    }
  }

  family family_;
  models::dice roll_;
  std::vector<moving_plane<integer>> made_;
  std::vector<plane_id> twins_;
};

}  // namespace osteon::oracles
