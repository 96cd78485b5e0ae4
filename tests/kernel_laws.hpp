// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The laws of core/kernel.hpp as one suite of typed tests, for the plane and for space. A kernel joins by
/// adding its factory to the list in kernel_planes.hpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "kernel_planes.hpp"

namespace osteon::laws {

template <std::size_t N>
sign parity(const std::array<int, N>& order) {
  int inversions = 0;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j) inversions += order[i] > order[j] ? 1 : 0;
  return signed_if(inversions % 2 == 0);
}

/// Calls visit(permuted list, sign) for every permutation of a list.
template <std::size_t N, class Visit>
void for_each_order(const std::array<plane_id, N>& list, Visit visit) {
  std::array<int, N> order{};
  std::iota(order.begin(), order.end(), 0);
  do {
    std::array<plane_id, N> permuted{};
    for (std::size_t i = 0; i < N; ++i) permuted[i] = list[order[i]];
    visit(permuted, parity(order));
  } while (std::next_permutation(order.begin(), order.end()));
}

template <class Factory>
class kernel_laws : public testing::Test {
 protected:
  using kernel_type = kernel_of<Factory>;
  using meeting = typename kernel_type::meeting;
  static constexpr int D = Factory::dimension;
  using planes = planes_in<D>;
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;
  // Whether the kernel breaks all ties: its laws say "never zero" where others say "zero iff".
  static constexpr bool strict = tie_breaking_kernel<kernel_type>;
  static constexpr plane_id count = 14;

  // Calls check(kernel, planes, dice, family) for every family that the kernel can be held to.
  template <class Check>
  static void for_each_family(bool common_point, Check check) {
    for (const family f : all_families) {
      if (!kernel_type::exact && !exact_in_doubles(f)) continue;
      SCOPED_TRACE(trace(f));
      dice r(static_cast<std::uint64_t>(f) + (common_point ? 100 : 0));
      const planes p = random_planes<D>(f, count, r, common_point);
      const kernel_type k = Factory{}(p);
      check(k, p, r, f);
      if (testing::Test::HasFailure()) return;
    }
  }

  static corner draw_corner(dice& r) { return r.distinct<D>(count); }
  static support draw_support(dice& r) { return r.distinct<D + 1>(count); }
  static support sorted_support(dice& r) { return sorted(draw_support(r)); }

  // Some meetings of different planes, as many as exist of those tried.
  static std::vector<meeting> some_meetings(const kernel_type& k, dice& r, int tries) {
    std::vector<meeting> result;
    std::vector<support> seen;
    for (int i = 0; i < tries; ++i) {
      const support q = draw_support(r);
      const auto m = k.meet(q);
      if (!m || std::find(seen.begin(), seen.end(), sorted(q)) != seen.end()) continue;
      seen.push_back(sorted(q));
      result.push_back(*m);
    }
    return result;
  }

  static void satisfies_the_concept() {
    static_assert(kernel<kernel_type, D>);
    for_each_family(false, [](const auto& k, const planes& p, dice&, family) { EXPECT_EQ(k.size(), static_cast<plane_id>(p.size())); });
  }

  static void orientation_is_alternating() {
    for_each_family(false, [](const auto& k, const planes& p, dice& r, family) {
      for (int i = 0; i < 200; ++i) {
        const auto c = draw_corner(r);
        const sign truth = true_orientation<D>(p, c);
        const sign s = orientation(k, c);
        EXPECT_EQ(transversal(k, c), truth != sign::zero);
        if (truth != sign::zero || !strict) {
          EXPECT_EQ(s, truth);
        }
        if (strict) {
          EXPECT_NE(s, sign::zero);
        }
        for_each_order(c, [&](const auto& permuted, sign parity) { EXPECT_EQ(orientation(k, permuted), s * parity); });
      }
    });
  }

  static void meet_and_closing_forget_the_order() {
    for_each_family(false, [](const auto& k, const planes& p, dice& r, family f) {
      for (int i = 0; i < 40; ++i) {
        const support q = draw_support(r);
        const auto m = k.meet(q);
        if (strict) {
          EXPECT_TRUE(m.has_value());
        }
        if (rational_lengths(f)) {
          const sign truth = sign_of(true_closing<D>(p, sorted(q)));
          if (!strict) {
            EXPECT_EQ(m.has_value(), truth != sign::zero);
          }
          if (truth != sign::zero && m) {
            EXPECT_EQ(k.closing(*m), truth);
          }
        }
        for_each_order(q, [&](const support& permuted, sign) {
          const auto n = k.meet(permuted);
          ASSERT_EQ(n.has_value(), m.has_value());
          if (!m) return;
          EXPECT_EQ(support(k.planes(*n)), sorted(q));
          EXPECT_NE(k.closing(*n), sign::zero);
          EXPECT_EQ(k.closing(*n), k.closing(*m));
          EXPECT_EQ(k.compare(*n, *m), sign::zero);
        });
      }
    });
  }

  static void side_forgets_the_order() {
    for_each_family(false, [](const auto& k, const planes&, dice& r, family) {
      const auto meetings = some_meetings(k, r, 10);
      for (int i = 0; i < 40 && !meetings.empty(); ++i) {
        const support q = draw_support(r);
        const auto c = all_but_last(q);
        if (orientation(k, c) == sign::zero) continue;
        const auto& m = meetings[r.between(0, static_cast<int>(meetings.size()) - 1)];
        const sign s = side(k, q.back(), c, m);
        for_each_order(c, [&](const auto& permuted, sign) { EXPECT_EQ(side(k, q.back(), permuted, m), s); });
      }
    });
  }

  static void compare_is_a_total_preorder() {
    for_each_family(false, [](const auto& k, const planes& p, dice& r, family f) {
      auto meetings = some_meetings(k, r, 40);
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
          if (a != b && strict) {
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
        const support q = k.planes(meetings[a]);
        const rational s = true_closing<D>(p, q);
        times.push_back(s == 0 ? std::nullopt : std::optional<rational>(true_offset<D>(p, q) / s));
      }
      for (std::size_t a = 0; a + 1 < n; ++a) {
        if (!times[a]) continue;
        EXPECT_EQ(order[a][n - 1], signed_if(*times[a] > 0));
        for (std::size_t b = 0; b + 1 < n; ++b) {
          if (!times[b]) continue;
          const sign truth = sign_of(rational(*times[a] - *times[b]));
          if (truth != sign::zero || !strict) {
            EXPECT_EQ(order[a][b], truth);
          }
        }
      }
    });
  }

  static void angles_are_a_total_preorder() {
    for_each_family(false, [](const auto& k, const planes&, dice& r, family) {
      std::vector<std::pair<plane_id, plane_id>> edges;
      for (int i = 0; i < 20; ++i) {
        const auto e = r.distinct<2>(k.size());
        edges.emplace_back(e[0], e[1]);
      }
      const auto order = [&](const auto& x, const auto& y) {
        const sign s = k.compare(k.bisector(x.first, x.second), k.bisector(y.first, y.second));
        if (kernel_type::exact) {
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

  // Perturbation moves an equation and its multiple by different amounts, so kernels that break ties
  // are held to the law only where there is no tie; so is arithmetic that is exact only by the size of
  // its numbers.
  static void multiples_of_an_equation_are_the_same_plane() {
    constexpr bool exact = kernel_type::exact;
    for (const bool common : {false, true})
      for_each_family(common, [common](const auto& k, const planes& p, dice& r, family) {
        planes multiples = p;
        for (auto& one : multiples) {
          integer factor = r.between(1, 3);
          if (exact && r.one_in(4)) factor = abs(r.bits(90)) + 1;
          for (integer& x : one.n) x *= factor;
          one.d *= factor;
        }
        const kernel_type l = Factory{}(multiples);
        const auto judge = make_sqrt_kernel(p);
        const auto comparable = [](sign truth) { return truth != sign::zero || !strict; };
        for (int i = 0; i < 100; ++i) {
          const support q = draw_support(r);
          const support s = draw_support(r);
          const auto c = all_but_last(q);
          const sign corner = orientation(judge, c);
          if (comparable(corner)) {
            EXPECT_EQ(orientation(l, c), orientation(k, c));
          }
          if (common && corner != sign::zero && comparable(side(judge, q.back(), c, judge.start()))) {
            EXPECT_EQ(side(l, q.back(), c, l.start()), side(k, q.back(), c, k.start()));
          }
          if constexpr (D == 3) {
            const auto angle = judge.compare(judge.bisector(q[0], q[1]), judge.bisector(s[0], s[1]));
            if (exact || angle != sign::zero) {
              EXPECT_EQ(l.compare(l.bisector(q[0], q[1]), l.bisector(s[0], s[1])), k.compare(k.bisector(q[0], q[1]), k.bisector(s[0], s[1])));
            }
          }
          const auto jq = judge.meet(q);
          const auto js = judge.meet(s);
          const auto km = k.meet(q);
          const auto lm = l.meet(q);
          if (jq || !strict) {
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
          if (corner != sign::zero && comparable(side(judge, q.back(), c, *js))) {
            EXPECT_EQ(side(l, q.back(), c, *ln), side(k, q.back(), c, *kn));
          }
        }
      });
  }

  // L(t) = D - t S changes its sign at the meeting: with tau = D / S,
  // sign L(t) = - sign S * sign(t - tau).
  static void side_flips_at_the_meeting() {
    for_each_family(false, [](const auto& k, const planes& p, dice& r, family) {
      const auto meetings = some_meetings(k, r, 12);
      for (int i = 0; i < 80; ++i) {
        const support q = sorted_support(r);
        const int last = r.between(0, D);
        const sign l = lambda_of(k, q, last);
        if (l == sign::zero) continue;
        const auto c = without(q, last);
        const auto tau = k.meet(q);
        // A perturbed kernel is not asked for what is zero by its planes alone.
        if (tau && !strict) {
          EXPECT_EQ(side(k, q[last], c, *tau), sign::zero) << "a vertex at its meeting";
        }
        for (const auto& m : meetings) {
          if (support(k.planes(m)) == q) continue;
          const sign s = side(k, q[last], c, m);
          if (tau) {
            EXPECT_EQ(s, -k.compare(m, *tau) * k.closing(*tau) * l);
          } else {
            EXPECT_EQ(s, sign_of(true_offset<D>(p, q)) * l) << "planes that close in no time keep their distance";
          }
        }
      }
    });
  }

  static void the_start_is_just_after_zero() {
    for_each_family(false, [](const auto& k, const planes& p, dice& r, family) {
      EXPECT_EQ(k.compare(k.start(), k.start()), sign::zero);
      for (const auto& m : some_meetings(k, r, 100)) {
        EXPECT_EQ(k.compare(m, k.start()), -k.compare(k.start(), m));
        if (!strict) {
          EXPECT_EQ(k.compare(m, k.start()), signed_if(sign_of(true_offset<D>(p, k.planes(m))) * k.closing(m) == sign::positive));
        }
      }
    });
  }

  static void at_the_start_of_a_corner_only_speeds_count() {
    for_each_family(true, [](const auto& k, const planes&, dice& r, family) {
      for (int i = 0; i < 150; ++i) {
        const support q = sorted_support(r);
        const int last = r.between(0, D);
        const sign l = lambda_of(k, q, last);
        if (l == sign::zero) continue;
        const sign s = side(k, q[last], without(q, last), k.start());
        const auto tau = k.meet(q);
        if (strict) {
          EXPECT_NE(s, sign::zero);
        }
        EXPECT_EQ(s, tau ? -k.compare(k.start(), *tau) * k.closing(*tau) * l : sign::zero);
        if (tau && !strict) {
          EXPECT_EQ(k.compare(*tau, k.start()), sign::negative) << "the common point belongs to the past";
        }
      }
    });
  }

  // In the limit, when the perturbation has gone, a kernel's answers are those of its base.
  static void limits_are_the_unperturbed_answers() {
    int never = 0;
    int always = 0;
    int simultaneous = 0;
    int touching = 0;
    for_each_family(false, [&](const auto& k, const planes& p, dice& r, family) {
      const auto& base = k.base();
      EXPECT_EQ(&unperturbed(k), &base);
      EXPECT_EQ(&unperturbed(base), &base);
      for (int i = 0; i < 200; ++i) {
        const support q = draw_support(r);
        const support s = draw_support(r);
        const auto m = k.meet(q);
        const auto n = k.meet(s);
        ASSERT_TRUE(m && n);
        const auto bm = base.meet(q);
        const auto bn = base.meet(s);
        EXPECT_EQ(k.has_moment(*m), bm.has_value());
        const bool apart = true_offset<D>(p, q) != 0;
        EXPECT_EQ(k.is_never(*m), !bm && apart);
        never += !bm && apart ? 1 : 0;
        always += !bm && !apart ? 1 : 0;
        if (!bm) continue;
        if (bn) {
          EXPECT_EQ(k.same_moment(*m, *n), base.compare(*bm, *bn) == sign::zero);
          simultaneous += sorted(q) != sorted(s) && k.same_moment(*m, *n) ? 1 : 0;
        }
        const bool on = base.transversal(s[0], s[1]) && base.side(s[2], s[0], s[1], *bm) == sign::zero;
        EXPECT_EQ(k.touches(s[2], s[0], s[1], *m), on);
        touching += sorted(q) != sorted(s) && on ? 1 : 0;
      }
    });
    EXPECT_GT(never, 100);
    EXPECT_GT(always, 10);
    EXPECT_GT(simultaneous, 10);
    EXPECT_GT(touching, 10);
  }
};

TYPED_TEST_SUITE_P(kernel_laws);
TYPED_TEST_P(kernel_laws, SatisfiesTheConcept) { this->satisfies_the_concept(); }
TYPED_TEST_P(kernel_laws, K1OrientationIsAlternating) { this->orientation_is_alternating(); }
TYPED_TEST_P(kernel_laws, K2MeetAndClosingForgetTheOrder) { this->meet_and_closing_forget_the_order(); }
TYPED_TEST_P(kernel_laws, K2SideForgetsTheOrder) { this->side_forgets_the_order(); }
TYPED_TEST_P(kernel_laws, K3CompareIsATotalPreorder) { this->compare_is_a_total_preorder(); }
TYPED_TEST_P(kernel_laws, K4MultiplesOfAnEquationAreTheSamePlane) { this->multiples_of_an_equation_are_the_same_plane(); }
TYPED_TEST_P(kernel_laws, SideFlipsAtTheMeeting) { this->side_flips_at_the_meeting(); }
TYPED_TEST_P(kernel_laws, TheStartIsJustAfterZero) { this->the_start_is_just_after_zero(); }
TYPED_TEST_P(kernel_laws, AtTheStartOfACornerOnlySpeedsCount) { this->at_the_start_of_a_corner_only_speeds_count(); }

REGISTER_TYPED_TEST_SUITE_P(kernel_laws, SatisfiesTheConcept, K1OrientationIsAlternating, K2MeetAndClosingForgetTheOrder, K2SideForgetsTheOrder,
                            K3CompareIsATotalPreorder, K4MultiplesOfAnEquationAreTheSamePlane, SideFlipsAtTheMeeting, TheStartIsJustAfterZero,
                            AtTheStartOfACornerOnlySpeedsCount);

}  // namespace osteon::laws
