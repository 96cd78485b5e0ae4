// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The laws of kernel.hpp as one suite of typed tests. A kernel joins by adding its factory to the list in
/// kernel_test.cpp. The suite's own geometry is a 4x4 determinant over rationals, written apart from the kernels' formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <ostream>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

using plane = moving_plane<integer>;
using planes = std::vector<plane>;

// ---- kernels from planes

struct doubles {
  auto operator()(std::span<const plane> p) const { return make_double_kernel(p); }
};
struct rationals {
  auto operator()(std::span<const plane> p) const { return make_rational_kernel(p); }
};
struct roots {
  auto operator()(std::span<const plane> p) const { return make_sqrt_kernel(p); }
};
template <class Base>
struct with_filter {
  auto operator()(std::span<const plane> p) const { return filtered(p, Base{}(p)); }
};
template <class Base>
struct with_perturbation {
  auto operator()(std::span<const plane> p) const { return perturbed(Base{}(p)); }
};
template <class Base>
struct with_mirrored_perturbation {
  auto operator()(std::span<const plane> p) const { return perturbed(Base{}(p), true); }
};

template <class Factory>
using kernel_of = decltype(Factory{}(std::span<const plane>{}));

/// Whether a kernel breaks all ties: its laws say "never zero" where others say "zero iff".
template <class K>
inline constexpr bool never_zero = false;
template <class K>
inline constexpr bool never_zero<perturbed<K>> = true;

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
inline bool exact_in_doubles(family f) { return f == family::voxel || f == family::pythagorean; }
inline bool rational_lengths(family f) { return exact_in_doubles(f) || f == family::long_pythagorean; }

inline const char* name_of(family f) {
  switch (f) {
    case family::voxel:
      return "voxel";
    case family::pythagorean:
      return "pythagorean";
    case family::long_pythagorean:
      return "long_pythagorean";
    case family::small:
      return "small";
    case family::symmetric:
      return "symmetric";
    case family::doubled:
      return "doubled";
    case family::weighted:
      return "weighted";
    case family::long_normals:
      return "long_normals";
    case family::nearly_dependent:
      return "nearly_dependent";
  }
  return "";
}

using vector3 = std::array<integer, 3>;

inline integer dot(const vector3& a, const vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The first column of a quaternion's rotation matrix: its length is a^2 + b^2 + c^2 + d^2 (Euler, Rodrigues).
inline vector3 quaternion_normal(const integer& a, const integer& b, const integer& c, const integer& d) {
  return {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
}

inline vector3 random_normal(family f, dice& r, const planes& before) {
  const auto small = [&r](int most) {
    return vector3{integer(r.between(-most, most)), integer(r.between(-most, most)), integer(r.between(-most, most))};
  };
  const auto shuffled = [&r](vector3 n) {
    for (int i = 2; i > 0; --i) std::swap(n[i], n[r.between(0, i)]);
    for (integer& x : n)
      if (r.one_in(2)) x = -x;
    return n;
  };
  switch (f) {
    case family::voxel:
      return shuffled({integer(0), integer(0), integer(1)});
    case family::pythagorean:
      return quaternion_normal(integer(r.between(-1, 2)), integer(r.between(-1, 2)), integer(r.between(-1, 2)), integer(r.between(-1, 2)));
    case family::long_pythagorean:
      return quaternion_normal(r.bits(20), r.bits(20), r.bits(20), r.bits(20));
    case family::small:
    case family::weighted:
      return small(3);
    case family::symmetric:
      return shuffled({integer(1), integer(1), integer(r.between(1, 2))});
    case family::doubled: {  // squared lengths 2, 8, 18, 32, 72: all lengths are multiples of the root of two
      static constexpr std::array<std::array<int, 3>, 8> normals = {
          {{1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {4, 1, 1}, {4, 4, 0}, {6, 6, 0}, {8, 2, 2}, {7, 4, 3}}};
      const auto& n = normals[r.between(0, 6)];
      return shuffled({integer(n[0]), integer(n[1]), integer(n[2])});
    }
    case family::long_normals:
      return {r.bits(40), r.bits(40), r.bits(40)};
    case family::nearly_dependent: {
      if (before.size() < 3 || r.one_in(3)) return {r.bits(40), r.bits(40), r.bits(40)};
      vector3 n = {integer(0), integer(0), integer(0)};
      for (int k = 0; k < 2; ++k) {
        const vector3& other = before[r.between(0, static_cast<int>(before.size()) - 1)].n;
        const int factor = r.between(1, 2);
        for (int axis = 0; axis < 3; ++axis) n[axis] += factor * other[axis];
      }
      if (r.one_in(2)) n[r.between(0, 2)] += r.between(-1, 1);
      return n;
    }
  }
  return {};
}

/// Planes in the usual disorder, or all through one point (nearly, for the nearly dependent ones if not `common`).
inline planes random_planes(family f, int count, dice& r, bool common = false) {
  planes result;
  const bool large = f == family::long_normals || f == family::nearly_dependent || f == family::long_pythagorean;
  const vector3 apex = {integer(r.between(-3, 3)), integer(r.between(-3, 3)), integer(r.between(-3, 3))};
  while (static_cast<int>(result.size()) < count) {
    const vector3 n = random_normal(f, r, result);
    if (dot(n, n) == 0) continue;
    plane p{n, dot(n, apex)};
    if (!common && f == family::nearly_dependent) p.d += r.between(-1, 1);
    if (!common && f != family::nearly_dependent) p.d = large ? r.bits(44) : integer(r.between(-5, 5));
    if (f == family::weighted) p.weight = r.between(1, 3);
    result.push_back(p);
  }
  return result;
}

inline std::string trace(family f) { return std::string("family ") + name_of(f) + ", seed " + std::to_string(seed); }

// ---- what is true

inline integer determinant(const vector3& a, const vector3& b, const vector3& c) {
  return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[1] * b[0] * c[2] - a[0] * b[2] * c[1];
}
inline sign true_orientation(const planes& p, plane_id a, plane_id b, plane_id c) { return sign_of(determinant(p[a].n, p[b].n, p[c].n)); }

/// Determinant with rows (n_r, last_r), by elimination.
inline rational determinant4(const planes& p, const quadruple& q, const std::array<rational, 4>& last) {
  std::array<std::array<rational, 4>, 4> m;
  for (int r = 0; r < 4; ++r) m[r] = {rational(p[q[r]].n[0]), rational(p[q[r]].n[1]), rational(p[q[r]].n[2]), last[r]};
  rational result = 1;
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    while (pivot < 4 && m[pivot][column] == 0) ++pivot;
    if (pivot == 4) return 0;
    if (pivot != column) {
      std::swap(m[pivot], m[column]);
      result = -result;
    }
    result *= m[column][column];
    for (int row = column + 1; row < 4; ++row) {
      const rational factor = m[row][column] / m[column][column];
      for (int k = column; k < 4; ++k) m[row][k] -= factor * m[column][k];
    }
  }
  return result;
}

/// D; and S where all four lengths are rational.
inline rational true_offset(const planes& p, const quadruple& q) {
  return determinant4(p, q, {rational(p[q[0]].d), rational(p[q[1]].d), rational(p[q[2]].d), rational(p[q[3]].d)});
}
inline rational true_closing(const planes& p, const quadruple& q) {
  std::array<rational, 4> speeds;
  for (int r = 0; r < 4; ++r) speeds[r] = rational(p[q[r]].weight * isqrt(dot(p[q[r]].n, p[q[r]].n)));
  return determinant4(p, q, speeds);
}

template <std::size_t N>
sign parity(const std::array<int, N>& order) {
  int inversions = 0;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j) inversions += order[i] > order[j] ? 1 : 0;
  return signed_if(inversions % 2 == 0);
}

/// Calls visit(positions, sign) for every permutation of N positions.
template <std::size_t N, class Visit>
void for_each_order(Visit visit) {
  std::array<int, N> order{};
  std::iota(order.begin(), order.end(), 0);
  do visit(order, parity(order));
  while (std::next_permutation(order.begin(), order.end()));
}

/// Sign of lambda of the plane number r of an ascending quadruple.
template <class K>
sign lambda(const K& k, const quadruple& q, int r) {
  triple t{};
  for (int s = 0, n = 0; s < 4; ++s)
    if (s != r) t[n++] = q[s];
  return k.orientation(t[0], t[1], t[2]) * signed_if(r % 2 == 1);
}

// ---- the laws

template <class Factory>
class kernel_laws : public testing::Test {
 protected:
  using kernel_type = kernel_of<Factory>;
  using meeting = typename kernel_type::meeting;
  static constexpr bool strict = never_zero<kernel_type>;
  static constexpr plane_id count = 14;

  // Calls check(kernel, planes, dice, family) for every family that the kernel can be held to.
  template <class Check>
  static void for_each_family(bool common_point, Check check) {
    for (const family f : all_families) {
      if (!kernel_type::exact && !exact_in_doubles(f)) continue;
      SCOPED_TRACE(trace(f));
      dice r(static_cast<std::uint64_t>(f) + (common_point ? 100 : 0));
      const planes p = random_planes(f, count, r, common_point);
      const kernel_type k = Factory{}(p);
      check(k, p, r, f);
      if (testing::Test::HasFailure()) return;
    }
  }

  // Some meetings of different planes, as many as exist of those tried.
  static std::vector<meeting> some_meetings(const kernel_type& k, dice& r, int tries) {
    std::vector<meeting> result;
    std::vector<quadruple> seen;
    for (int i = 0; i < tries; ++i) {
      quadruple q = r.distinct<4>(k.size());
      const auto m = k.meet(q);
      std::sort(q.begin(), q.end());
      if (!m || std::find(seen.begin(), seen.end(), q) != seen.end()) continue;
      seen.push_back(q);
      result.push_back(*m);
    }
    return result;
  }
};

TYPED_TEST_SUITE_P(kernel_laws);

TYPED_TEST_P(kernel_laws, SatisfiesTheConcept) {
  static_assert(kernel<kernel_of<TypeParam>, 3>);
  this->for_each_family(false, [](const auto& k, const planes& p, dice&, family) { EXPECT_EQ(k.size(), static_cast<plane_id>(p.size())); });
}

TYPED_TEST_P(kernel_laws, K1OrientationIsAlternating) {
  this->for_each_family(false, [](const auto& k, const planes& p, dice& r, family) {
    for (int i = 0; i < 200; ++i) {
      const triple t = r.distinct<3>(k.size());
      const sign truth = true_orientation(p, t[0], t[1], t[2]);
      const sign s = k.orientation(t[0], t[1], t[2]);
      EXPECT_EQ(k.transversal(t[0], t[1], t[2]), truth != sign::zero);
      if (truth != sign::zero || !TestFixture::strict) {
        EXPECT_EQ(s, truth);
      }
      if (TestFixture::strict) {
        EXPECT_NE(s, sign::zero);
      }
      for_each_order<3>([&](const auto& o, sign parity) { EXPECT_EQ(k.orientation(t[o[0]], t[o[1]], t[o[2]]), s * parity); });
    }
  });
}

TYPED_TEST_P(kernel_laws, K2MeetAndClosingForgetTheOrder) {
  this->for_each_family(false, [](const auto& k, const planes& p, dice& r, family f) {
    for (int i = 0; i < 40; ++i) {
      const quadruple q = r.distinct<4>(k.size());
      quadruple sorted = q;
      std::sort(sorted.begin(), sorted.end());
      const auto m = k.meet(q);
      if (TestFixture::strict) {
        EXPECT_TRUE(m.has_value());
      }
      if (rational_lengths(f)) {
        const sign truth = sign_of(true_closing(p, sorted));
        if (!TestFixture::strict) {
          EXPECT_EQ(m.has_value(), truth != sign::zero);
        }
        if (truth != sign::zero && m) {
          EXPECT_EQ(k.closing(*m), truth);
        }
      }
      for_each_order<4>([&](const auto& o, sign) {
        const auto n = k.meet({q[o[0]], q[o[1]], q[o[2]], q[o[3]]});
        ASSERT_EQ(n.has_value(), m.has_value());
        if (!m) return;
        EXPECT_EQ(quadruple(k.planes(*n)), sorted);
        EXPECT_NE(k.closing(*n), sign::zero);
        EXPECT_EQ(k.closing(*n), k.closing(*m));
        EXPECT_EQ(k.compare(*n, *m), sign::zero);
      });
    }
  });
}

TYPED_TEST_P(kernel_laws, K2SideForgetsTheOrder) {
  this->for_each_family(false, [this](const auto& k, const planes&, dice& r, family) {
    const auto meetings = this->some_meetings(k, r, 10);
    for (int i = 0; i < 40 && !meetings.empty(); ++i) {
      const quadruple q = r.distinct<4>(k.size());
      if (k.orientation(q[0], q[1], q[2]) == sign::zero) continue;
      const auto& m = meetings[r.between(0, static_cast<int>(meetings.size()) - 1)];
      const sign s = k.side(q[3], q[0], q[1], q[2], m);
      for_each_order<3>([&](const auto& o, sign) { EXPECT_EQ(k.side(q[3], q[o[0]], q[o[1]], q[o[2]], m), s); });
    }
  });
}

TYPED_TEST_P(kernel_laws, K3CompareIsATotalPreorder) {
  this->for_each_family(false, [this](const auto& k, const planes& p, dice& r, family f) {
    auto meetings = this->some_meetings(k, r, 40);
    meetings.push_back(k.start());
    const std::size_t n = meetings.size();
    std::vector<std::vector<sign>> order(n, std::vector<sign>(n));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) order[a][b] = k.compare(meetings[a], meetings[b]);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        EXPECT_EQ(order[a][b], -order[b][a]);
        if (a == b) {
          EXPECT_EQ(order[a][b], sign::zero);
        }
        if (a != b && TestFixture::strict) {
          EXPECT_NE(order[a][b], sign::zero);
        }
        bool transitive = true;
        for (std::size_t c = 0; c < n; ++c) {
          if (order[a][b] == sign::zero) transitive = transitive && order[a][c] == order[b][c];
          if (order[a][b] == sign::negative && order[b][c] == sign::negative) transitive = transitive && order[a][c] == sign::negative;
        }
        EXPECT_TRUE(transitive);
      }
    if (!rational_lengths(f)) return;
    // The true times; the start is after zero and before all else. Infinitesimal differences are the kernel's own affair.
    std::vector<std::optional<rational>> times;
    for (std::size_t a = 0; a + 1 < n; ++a) {
      const quadruple q = k.planes(meetings[a]);
      const rational s = true_closing(p, q);
      times.push_back(s == 0 ? std::nullopt : std::optional<rational>(true_offset(p, q) / s));
    }
    for (std::size_t a = 0; a + 1 < n; ++a) {
      if (!times[a]) continue;
      EXPECT_EQ(order[a][n - 1], signed_if(*times[a] > 0));
      for (std::size_t b = 0; b + 1 < n; ++b) {
        if (!times[b]) continue;
        const sign truth = sign_of(rational(*times[a] - *times[b]));
        if (truth != sign::zero || !TestFixture::strict) {
          EXPECT_EQ(order[a][b], truth);
        }
      }
    }
  });
}

TYPED_TEST_P(kernel_laws, K3AnglesAreATotalPreorder) {
  this->for_each_family(false, [](const auto& k, const planes&, dice& r, family) {
    std::vector<std::pair<plane_id, plane_id>> edges;
    for (int i = 0; i < 20; ++i) {
      const auto e = r.distinct<2>(k.size());
      edges.emplace_back(e[0], e[1]);
    }
    const auto order = [&](const auto& x, const auto& y) {
      const sign s = k.compare(k.bisector(x.first, x.second), k.bisector(y.first, y.second));
      if (kernel_of<TypeParam>::exact) {
        EXPECT_EQ(s, k.compare(k.bisector(x.second, x.first), k.bisector(y.second, y.first)));
      }
      return s;
    };
    for (const auto& a : edges)
      for (const auto& b : edges) {
        EXPECT_EQ(order(a, b), -order(b, a));
        if (order(a, b) != sign::negative) continue;
        for (const auto& c : edges)
          if (order(b, c) == sign::negative) {
            EXPECT_EQ(order(a, c), sign::negative);
          }
      }
  });
}

// Perturbation moves an equation and its multiple by different amounts, so kernels that break ties are held to the law
// only where there is no tie; so is arithmetic that is exact only by the size of its numbers.
TYPED_TEST_P(kernel_laws, K4MultiplesOfAnEquationAreTheSamePlane) {
  for (const bool common : {false, true})
    this->for_each_family(common, [common](const auto& k, const planes& p, dice& r, family) {
      planes multiples = p;
      for (plane& one : multiples) {
        integer factor = r.between(1, 3);
        if (TestFixture::kernel_type::exact && r.one_in(4)) factor = abs(r.bits(90)) + 1;
        for (integer& x : one.n) x *= factor;
        one.d *= factor;
      }
      const typename TestFixture::kernel_type l = TypeParam{}(multiples);
      const auto judge = make_sqrt_kernel(p);
      const auto comparable = [](sign truth) { return truth != sign::zero || !TestFixture::strict; };
      for (int i = 0; i < 100; ++i) {
        const quadruple q = r.distinct<4>(k.size());
        const quadruple s = r.distinct<4>(k.size());
        const sign corner = judge.orientation(q[0], q[1], q[2]);
        if (comparable(corner)) {
          EXPECT_EQ(l.orientation(q[0], q[1], q[2]), k.orientation(q[0], q[1], q[2]));
        }
        if (common && corner != sign::zero && comparable(judge.side(q[3], q[0], q[1], q[2], judge.start()))) {
          EXPECT_EQ(l.side(q[3], q[0], q[1], q[2], l.start()), k.side(q[3], q[0], q[1], q[2], k.start()));
        }
        const auto angle = judge.compare(judge.bisector(q[0], q[1]), judge.bisector(s[0], s[1]));
        if (TestFixture::kernel_type::exact || angle != sign::zero) {
          EXPECT_EQ(l.compare(l.bisector(q[0], q[1]), l.bisector(s[0], s[1])), k.compare(k.bisector(q[0], q[1]), k.bisector(s[0], s[1])));
        }
        const auto jq = judge.meet(q);
        const auto js = judge.meet(s);
        const auto km = k.meet(q);
        const auto lm = l.meet(q);
        if (jq || !TestFixture::strict) {
          ASSERT_EQ(km.has_value(), lm.has_value());
          if (km) {
            EXPECT_EQ(l.closing(*lm), k.closing(*km));
          }
        }
        const auto kn = k.meet(s);
        const auto ln = l.meet(s);
        if (!jq || !js || !km || !lm || !kn || !ln) continue;
        EXPECT_EQ(l.compare(*lm, l.start()), k.compare(*km, k.start()));
        if (comparable(judge.compare(*jq, *js))) {
          EXPECT_EQ(l.compare(*lm, *ln), k.compare(*km, *kn));
        }
        if (corner != sign::zero && comparable(judge.side(q[3], q[0], q[1], q[2], *js))) {
          EXPECT_EQ(l.side(q[3], q[0], q[1], q[2], *ln), k.side(q[3], q[0], q[1], q[2], *kn));
        }
      }
    });
}

// L(t) = D - t S changes its sign at the meeting: with tau = D / S, sign L(t) = - sign S * sign(t - tau).
TYPED_TEST_P(kernel_laws, SideFlipsAtTheMeeting) {
  this->for_each_family(false, [this](const auto& k, const planes& p, dice& r, family) {
    const auto meetings = this->some_meetings(k, r, 12);
    for (int i = 0; i < 80; ++i) {
      quadruple q = r.distinct<4>(k.size());
      std::sort(q.begin(), q.end());
      const int last = r.between(0, 3);
      const sign l = lambda(k, q, last);
      if (l == sign::zero) continue;
      triple t{};
      for (int s = 0, n = 0; s < 4; ++s)
        if (s != last) t[n++] = q[s];
      const auto tau = k.meet(q);
      // A perturbed kernel is not asked for what is zero by its planes alone.
      if (tau && !TestFixture::strict) {
        EXPECT_EQ(k.side(q[last], t[0], t[1], t[2], *tau), sign::zero) << "a vertex at its meeting";
      }
      for (const auto& m : meetings) {
        if (quadruple(k.planes(m)) == q) continue;
        const sign side = k.side(q[last], t[0], t[1], t[2], m);
        if (tau) {
          EXPECT_EQ(side, -k.compare(m, *tau) * k.closing(*tau) * l);
        } else {
          EXPECT_EQ(side, sign_of(true_offset(p, q)) * l) << "planes that close in no time keep their distance";
        }
      }
    }
  });
}

TYPED_TEST_P(kernel_laws, TheStartIsJustAfterZero) {
  this->for_each_family(false, [this](const auto& k, const planes& p, dice& r, family) {
    EXPECT_EQ(k.compare(k.start(), k.start()), sign::zero);
    for (const auto& m : this->some_meetings(k, r, 100)) {
      EXPECT_EQ(k.compare(m, k.start()), -k.compare(k.start(), m));
      if (!TestFixture::strict) {
        EXPECT_EQ(k.compare(m, k.start()), signed_if(sign_of(true_offset(p, k.planes(m))) * k.closing(m) == sign::positive));
      }
    }
  });
}

TYPED_TEST_P(kernel_laws, AtTheStartOfACornerOnlySpeedsCount) {
  this->for_each_family(true, [](const auto& k, const planes&, dice& r, family) {
    for (int i = 0; i < 150; ++i) {
      quadruple q = r.distinct<4>(k.size());
      std::sort(q.begin(), q.end());
      const int last = r.between(0, 3);
      const sign l = lambda(k, q, last);
      if (l == sign::zero) continue;
      triple t{};
      for (int s = 0, n = 0; s < 4; ++s)
        if (s != last) t[n++] = q[s];
      const sign side = k.side(q[last], t[0], t[1], t[2], k.start());
      const auto tau = k.meet(q);
      if (TestFixture::strict) {
        EXPECT_NE(side, sign::zero);
      }
      EXPECT_EQ(side, tau ? -k.compare(k.start(), *tau) * k.closing(*tau) * l : sign::zero);
      if (tau && !TestFixture::strict) {
        EXPECT_EQ(k.compare(*tau, k.start()), sign::negative) << "the common point belongs to the past";
      }
    }
  });
}

REGISTER_TYPED_TEST_SUITE_P(kernel_laws, SatisfiesTheConcept, K1OrientationIsAlternating, K2MeetAndClosingForgetTheOrder, K2SideForgetsTheOrder,
                            K3CompareIsATotalPreorder, K3AnglesAreATotalPreorder, K4MultiplesOfAnEquationAreTheSamePlane, SideFlipsAtTheMeeting,
                            TheStartIsJustAfterZero, AtTheStartOfACornerOnlySpeedsCount);

}  // namespace osteon::laws
