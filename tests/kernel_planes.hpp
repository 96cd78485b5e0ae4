// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What tests of kernels share, for the plane and for space: factories of kernels, random planes, and what is
/// true of them. The geometry here is determinants by elimination over rationals, written apart from the
/// kernels' formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ask.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"

namespace osteon {

/// Signs in failure messages.
inline void PrintTo(sign s, std::ostream* out) { *out << (s == sign::zero ? "zero" : s == sign::positive ? "positive" : "negative"); }

}  // namespace osteon

namespace osteon::laws {

using oracles::all_but_last;
using oracles::orientation;
using oracles::side;
using oracles::transversal;

template <int D>
using plane_in = moving_plane<integer, D>;
template <int D>
using planes_in = std::vector<plane_in<D>>;
template <int D>
using vector_in = std::array<integer, D>;

// ---- kernels from planes

template <int D>
struct doubles {
  static constexpr int dimension = D;
  auto operator()(std::span<const plane_in<D>> p) const { return make_double_kernel(p); }
};
template <int D>
struct rationals {
  static constexpr int dimension = D;
  auto operator()(std::span<const plane_in<D>> p) const { return make_rational_kernel(p); }
};
template <int D>
struct roots {
  static constexpr int dimension = D;
  auto operator()(std::span<const plane_in<D>> p) const { return make_sqrt_kernel(p); }
};
template <class Base>
struct with_filter {
  static constexpr int dimension = Base::dimension;
  auto operator()(std::span<const plane_in<dimension>> p) const { return filtered(p, Base{}(p)); }
};
template <class Base>
struct with_perturbation {
  static constexpr int dimension = Base::dimension;
  auto operator()(std::span<const plane_in<dimension>> p) const { return perturbed(Base{}(p)); }
};
template <class Base>
struct with_mirrored_perturbation {
  static constexpr int dimension = Base::dimension;
  auto operator()(std::span<const plane_in<dimension>> p) const { return perturbed(Base{}(p), true); }
};

template <class Factory>
using kernel_of = decltype(Factory{}(std::span<const plane_in<Factory::dimension>>{}));

/// Every kernel obeys the laws; a new one is a new line.
template <int D>
using all_kernels = testing::Types<doubles<D>,                                    //
                                   rationals<D>,                                  //
                                   roots<D>,                                      //
                                   with_filter<rationals<D>>,                     //
                                   with_filter<roots<D>>,                         //
                                   with_perturbation<roots<D>>,                   //
                                   with_perturbation<rationals<D>>,               //
                                   with_perturbation<with_filter<roots<D>>>,      //
                                   with_perturbation<with_filter<rationals<D>>>,  //
                                   with_mirrored_perturbation<with_filter<roots<D>>>>;

// ---- random planes

inline constexpr std::uint64_t seed = 20250117;

/// Random numbers that are the same everywhere (the standard's distributions are not).
class dice {
 public:
  explicit dice(std::uint64_t stream) : engine_(seed + stream) {}
  int between(int least, int greatest) { return least + static_cast<int>(engine_() % (static_cast<std::uint64_t>(greatest - least) + 1)); }
  bool one_in(int n) { return between(1, n) == 1; }
  /// Of at most so many bits, with either sign.
  integer bits(unsigned n) {
    integer x = 0;
    for (unsigned done = 0; done < n; done += 64) x = (x << 64) + integer(engine_());
    x = x % (integer(1) << n);
    return one_in(2) ? integer(-x) : x;
  }
  template <std::size_t N>
  std::array<plane_id, N> distinct(plane_id below) {
    std::array<plane_id, N> result{};
    for (std::size_t i = 0; i < N;) {
      result[i] = between(0, below - 1);
      if (std::find(result.begin(), result.begin() + i, result[i]) == result.begin() + i) ++i;
    }
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

/// Kinds of normals. In the first two every |n| is an integer and so small that machine numbers are exact.
enum class family : std::uint8_t { voxel, pythagorean, long_pythagorean, small, symmetric, doubled, weighted, long_normals, nearly_dependent };
inline constexpr std::array all_families = {family::voxel,    family::pythagorean,  family::long_pythagorean,
                                            family::small,    family::symmetric,    family::doubled,
                                            family::weighted, family::long_normals, family::nearly_dependent};
inline constexpr std::array family_names = {"voxel",   "pythagorean", "long_pythagorean", "small",           "symmetric",
                                            "doubled", "weighted",    "long_normals",     "nearly_dependent"};
inline bool exact_in_doubles(family f) { return f == family::voxel || f == family::pythagorean; }
inline bool rational_lengths(family f) { return exact_in_doubles(f) || f == family::long_pythagorean; }
inline std::string trace(family f) { return std::string("family ") + family_names[static_cast<std::size_t>(f)] + ", seed " + std::to_string(seed); }

template <std::size_t N>
integer dot(const std::array<integer, N>& a, const std::array<integer, N>& b) {
  integer sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// Squares and products of integers whose length is an integer: of a complex number in the plane, in space the
/// first column of a quaternion's rotation matrix (Euler, Rodrigues).
template <int D, class Draw>
vector_in<D> pythagorean_normal(Draw draw) {
  const integer a = draw();
  const integer b = draw();
  if constexpr (D == 2) {
    return {a * a - b * b, 2 * a * b};
  } else {
    const integer c = draw();
    const integer d = draw();
    return {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  }
}

/// Squared lengths 2, 8, 18, 32, 50, 72, 98: all lengths are multiples of the root of two.
template <int D>
inline constexpr std::array<std::array<int, 3>, 7> doubled_normals = {{{1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {4, 1, 1}, {4, 4, 0}, {6, 6, 0}, {8, 2, 2}}};
template <>
inline constexpr std::array<std::array<int, 3>, 7> doubled_normals<2> = {{{1, 1}, {2, 2}, {3, 3}, {7, 1}, {4, 4}, {6, 6}, {7, 7}}};

template <int D>
vector_in<D> random_normal(family f, dice& r, const planes_in<D>& before) {
  const auto filled = [](auto draw) {
    vector_in<D> n;
    for (integer& x : n) x = draw();
    return n;
  };
  const auto shuffled = [&r](vector_in<D> n) {
    for (int i = D - 1; i > 0; --i) std::swap(n[i], n[r.between(0, i)]);
    for (integer& x : n)
      if (r.one_in(2)) x = -x;
    return n;
  };
  const auto long_bits = [&r] { return r.bits(40); };
  switch (f) {
    case family::voxel: {
      vector_in<D> n{};
      n.back() = 1;
      return shuffled(n);
    }
    case family::pythagorean:
      return pythagorean_normal<D>([&r] { return integer(r.between(-1, 2)); });
    case family::long_pythagorean:
      return pythagorean_normal<D>([&r] { return r.bits(20); });
    case family::small:
    case family::weighted:
      return filled([&r] { return integer(r.between(-3, 3)); });
    case family::symmetric: {
      vector_in<D> n = filled([] { return integer(1); });
      n.back() = r.between(1, 2);
      return shuffled(n);
    }
    case family::doubled: {
      const auto& n = doubled_normals<D>[r.between(0, 6)];
      vector_in<D> result;
      std::copy_n(n.begin(), D, result.begin());
      return shuffled(result);
    }
    case family::long_normals:
      return filled(long_bits);
    case family::nearly_dependent: {
      if (before.size() < D || r.one_in(3)) return filled(long_bits);
      vector_in<D> n{};
      for (int k = 1; k < D; ++k) {
        const auto& other = before[r.between(0, static_cast<int>(before.size()) - 1)].n;
        const int factor = r.between(1, 2);
        for (int axis = 0; axis < D; ++axis) n[axis] += factor * other[axis];
      }
      if (r.one_in(2)) n[r.between(0, D - 1)] += r.between(-1, 1);
      return n;
    }
  }
  return {};
}

/// Planes in the usual disorder, or all through one point (nearly, for the nearly dependent ones if not `common`).
template <int D>
planes_in<D> random_planes(family f, int count, dice& r, bool common = false) {
  planes_in<D> result;
  const bool large = f == family::long_normals || f == family::nearly_dependent || f == family::long_pythagorean;
  vector_in<D> apex;
  for (integer& x : apex) x = r.between(-3, 3);
  while (static_cast<int>(result.size()) < count) {
    const vector_in<D> n = random_normal<D>(f, r, result);
    if (dot(n, n) == 0) continue;
    plane_in<D> p{n, dot(n, apex)};
    if (!common && f == family::nearly_dependent) p.d += r.between(-1, 1);
    if (!common && f != family::nearly_dependent) p.d = large ? r.bits(44) : integer(r.between(-5, 5));
    // In the plane a line may stand still; of three at least one moves.
    if (f == family::weighted) p.weight = D == 2 && result.size() < 2 ? 0 : r.between(1, 3);
    result.push_back(p);
  }
  return result;
}

// ---- what is true

/// By elimination.
template <std::size_t N>
rational determinant(std::array<std::array<rational, N>, N> m) {
  rational result = 1;
  for (std::size_t column = 0; column < N; ++column) {
    std::size_t pivot = column;
    while (pivot < N && m[pivot][column] == 0) ++pivot;
    if (pivot == N) return 0;
    if (pivot != column) {
      std::swap(m[pivot], m[column]);
      result = -result;
    }
    result *= m[column][column];
    for (std::size_t row = column + 1; row < N; ++row) {
      const rational factor = m[row][column] / m[column][column];
      for (std::size_t k = column; k < N; ++k) m[row][k] -= factor * m[column][k];
    }
  }
  return result;
}

template <int D>
sign true_orientation(const planes_in<D>& p, const corner_planes<D>& c) {
  std::array<std::array<rational, D>, D> m;
  for (int r = 0; r < D; ++r)
    for (int axis = 0; axis < D; ++axis) m[r][axis] = rational(p[c[r]].n[axis]);
  return sign_of(determinant(m));
}

/// The determinant with rows (n_r, last(r)).
template <int D, class Last>
rational bordered(const planes_in<D>& p, const meeting_planes<D>& q, Last last) {
  std::array<std::array<rational, D + 1>, D + 1> m;
  for (int r = 0; r <= D; ++r) {
    for (int axis = 0; axis < D; ++axis) m[r][axis] = rational(p[q[r]].n[axis]);
    m[r][D] = last(q[r]);
  }
  return determinant(m);
}

/// D; and S where all lengths are rational.
template <int D>
rational true_offset(const planes_in<D>& p, const meeting_planes<D>& q) {
  return bordered<D>(p, q, [&](plane_id i) { return rational(p[i].d); });
}
template <int D>
rational true_closing(const planes_in<D>& p, const meeting_planes<D>& q) {
  return bordered<D>(p, q, [&](plane_id i) { return rational(p[i].weight * isqrt(dot(p[i].n, p[i].n))); });
}

/// The sign of lambda of the plane number r of an ascending meeting, and the corner of the others.
template <std::size_t N>
std::array<plane_id, N - 1> without(const std::array<plane_id, N>& q, int r) {
  std::array<plane_id, N - 1> c{};
  for (int s = 0, n = 0; s < static_cast<int>(N); ++s)
    if (s != r) c[n++] = q[s];
  return c;
}
template <class K, std::size_t N>
sign lambda_of(const K& k, const std::array<plane_id, N>& q, int r) {
  return orientation(k, without(q, r)) * signed_if((static_cast<int>(N) - 1 - r) % 2 == 0);
}

}  // namespace osteon::laws
