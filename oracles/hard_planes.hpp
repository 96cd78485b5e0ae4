// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Planes, or lines, for asking kernels: random ones, and ones whose predicates are zero or almost zero on purpose.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "osteon/core/planes.hpp"
#include "osteon/core/random.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon::oracles {

/// Planes in a space of dimension D with, for each, another one that is almost or exactly interchangeable with it (or itself).
template <int D>
struct plane_set {
  std::vector<moving_plane<integer, D>> planes;
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
  nearly_parallel,  ///< all normals within 2^-40 of a line or, in space, of a plane
  one_ball,         ///< tangent to a ball with an irrational radius: all meet in its middle at once; some off in the 20th digit
  mirrored,         ///< images of one another under the cube's symmetries: different planes meet at equal times
  one_cone,         ///< all move through one moving point, as planes tangent to a cone do: S is zero; some off in the 20th digit
};
inline constexpr int random_families = 4;
inline constexpr int all_families = 10;
inline constexpr std::array<std::string_view, all_families> family_names = {
    "short_numbers", "middle_numbers", "long_numbers", "weighted", "square_classes", "scaled", "nearly_parallel", "one_ball", "mirrored", "one_cone"};

template <int D>
class plane_maker {
 public:
  plane_maker(family f, std::uint64_t seed) : family_(f), roll_(seed) {}

  /// Sixteen planes at most.
  plane_set<D> make(bool through_one_point) {
    const vector apex = filled([this] { return bits(6); });
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
        for (int i = 0; i < 7; ++i) add(filled([this] { return bits(12); }), bits(16));
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
      for (auto& p : made_) p.d = dot(p.n, apex);
    return {made_, twins_, through_one_point};
  }

 private:
  using vector = std::array<integer, D>;

  template <class Draw>
  static vector filled(Draw draw) {
    vector v;
    for (integer& x : v) x = draw();
    return v;
  }
  static integer dot(const vector& a, const vector& b) {
    integer sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += a[axis] * b[axis];
    return sum;
  }

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
    for (int i = D - 1; i > 0; --i) std::swap(v[i], v[roll_.between(0, i)]);
    for (auto& x : v)
      if (roll_.between(0, 1) == 0) x = -x;
    return v;
  }

  void add(const vector& n, const integer& d, const integer& weight = 1) {
    if (n == vector{}) return;
    twins_.push_back(static_cast<plane_id>(made_.size()));
    made_.push_back({n, d, weight});
  }
  void pair_up(std::size_t i, const moving_plane<integer, D>& p) {
    twins_[i] = static_cast<plane_id>(made_.size());
    twins_.push_back(static_cast<plane_id>(i));
    made_.push_back(p);
  }

  void random(int n) {
    const auto draw = [this, n] { return bits(n); };
    while (made_.size() < 14) {
      const vector v = filled(draw);
      add(v, bits(n));
    }
  }

  // The same plane times some number up to 2^70; sometimes the last digit of the offset is another one.
  moving_plane<integer, D> scaled(const moving_plane<integer, D>& p) {
    const integer factor = roll_.between(0, 1) == 0 ? integer(roll_.between(2, 9)) : (integer(1) << 66U) + bits(66);
    moving_plane<integer, D> q{times(p.n, factor), p.d * factor, p.weight};
    if (factor > 9 && roll_.between(0, 1) == 0) q.d += roll_.between(0, 1) == 0 ? 1 : -1;
    return q;
  }

  // Squared lengths are the radicands times squares.
  static constexpr std::array<int, 5> radicands = D == 3 ? std::array{2, 3, 6, 1, 5} : std::array{2, 5, 10, 1, 13};
  vector class_normal() {
    static constexpr std::array<std::array<int, 3>, 14> normals =
        D == 3 ? std::array<std::array<int, 3>, 14>{{{1, 1, 0},
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
                                                     {6, 5, 8}}}
               : std::array<std::array<int, 3>, 14>{
                     {{1, 1}, {7, 1}, {7, 7}, {17, 7}, {2, 1}, {11, 2}, {4, 2}, {3, 1}, {13, 9}, {3, 4}, {5, 12}, {1, 0}, {3, 2}, {17, 6}}};
    const auto& n = normals[static_cast<std::size_t>(roll_.between(0, 13))];
    vector v;
    std::copy_n(n.begin(), D, v.begin());
    return symmetric(v);
  }

  void nearly_parallel() {
    vector a = filled([this] { return bits(12); });
    vector b = filled([this] { return bits(12); });
    a[D - 1] += 5000;
    b[D - 2] += 5000;
    const bool line = D == 2 || roll_.between(0, 1) == 0;
    for (int i = 0; i < 7; ++i) {
      const integer x = (integer(1) << 41U) + bits(40);
      const integer y = line ? integer(0) : bits(41);
      vector n{};
      for (std::size_t axis = 0; axis < D; ++axis) n[axis] = x * a[axis] + y * b[axis] + roll_.between(-2, 2);
      add(n, bits(50));
    }
    for (std::size_t i = 0; i < 7; ++i) {
      auto p = made_[i];
      p.n[static_cast<std::size_t>(roll_.between(0, D - 1))] += roll_.between(-1, 1);
      p.d += roll_.between(-1, 1);
      pair_up(i, p);
    }
  }

  // sigma = m sqrt(r) and the radius k sqrt(r), so that t sigma = k r m.
  void one_ball(const vector& middle) {
    const auto c = static_cast<std::size_t>(roll_.between(0, 4));
    const long radius = roll_.between(1, 50);
    while (made_.size() < 8) {
      vector n{};
      integer length;
      do {
        n = times(class_normal(), roll_.between(1, 4));
        const integer square = dot(n, n);
        length = square % radicands[c] == 0 && is_square(square / radicands[c]) ? isqrt(square / radicands[c]) : integer(0);
      } while (length == 0);
      const long weight = roll_.between(0, 3) == 0 ? 2 : 1;
      add(n, dot(n, middle) + radius * radicands[c] * weight * length, weight);
    }
    for (std::size_t i = 0; i < 6; ++i) pair_up(i, scaled(made_[i]));
  }

  void mirrored() {
    for (int i = 0; i < 7; ++i) {
      const vector n = filled([this] { return bits(20); });
      add(n, bits(20));
    }
    const auto shift = static_cast<std::size_t>(roll_.between(0, D - 1));
    std::array<long, D> signs;
    for (long& x : signs) x = roll_.between(0, 1) * 2 - 1;
    for (std::size_t i = 0; i < 7; ++i) {
      auto p = made_[i];
      for (std::size_t axis = 0; axis < D; ++axis) p.n[axis] = made_[i].n[(axis + shift) % D] * signs[axis];
      pair_up(i, p);
    }
  }

  void one_cone() {
    for (int cone = 0; cone < 2; ++cone) {
      if constexpr (D == 3) {
        const vector n = filled([this] { return bits(12) + 5000; });
        for (const long x : {-1, 1})
          for (const long y : {-1, 1}) add({n[0] * x, n[1] * y, n[2]}, bits(16));
      } else {
        add_moving_as_one(cone == 0);
      }
    }
    for (std::size_t i = 0; i < 8; ++i) {
      auto p = scaled(made_[i]);
      if (p.n[D - 1] > (integer(1) << 60U) && roll_.between(0, 1) == 0) p.n[D - 1] += 1;
      pair_up(i, p);
    }
  }

  // Four lines n of lengths m, or m times the root of two, with speeds  w |n| = n_0 times a number that is the same for all:
  // they move as one along the axis.
  void add_moving_as_one(bool whole) requires(D == 2) {
    struct normal {
      int x, y, m;
    };
    static constexpr std::array<normal, 6> lengths = {{{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}, {8, 15, 17}, {7, 24, 25}}};
    static constexpr std::array<normal, 6> with_roots = {{{1, 1, 1}, {7, 1, 5}, {1, 7, 5}, {17, 7, 13}, {7, 17, 13}, {23, 7, 17}}};
    constexpr int common = 25 * 13 * 17;
    for (int i = 0; i < 4; ++i) {
      const normal& n = (whole ? lengths : with_roots)[static_cast<std::size_t>(roll_.between(0, 5))];
      const integer y = roll_.between(0, 1) == 0 ? n.y : -n.y;
      add({integer(n.x), y}, bits(16), integer(n.x * common / n.m));
    }
  }

  family family_;
  random_stream roll_;
  std::vector<moving_plane<integer, D>> made_;
  std::vector<plane_id> twins_;
};

}  // namespace osteon::oracles
