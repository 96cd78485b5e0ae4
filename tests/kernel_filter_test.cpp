// SPDX-License-Identifier: MIT

// What kernels decide where it is hard: zeros that do not look so, bounds of rounding errors, numbers that
// underflow; and that a filter leaves nothing to its base where doubles are exact.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "kernel_interview.hpp"
#include "osteon/kernel/estimate.hpp"
#include "osteon/kernel/formulas.hpp"

namespace osteon::laws {
namespace {

// ---- expressions

struct checked_number {
  estimate rounded;
  rational truth;
  int roundings;  // on the longest path
};

checked_number random_expression(dice& r, int depth) {
  if (depth == 0 || r.one_in(6)) {
    const integer x = r.bits(static_cast<unsigned>(r.one_in(2) ? r.between(1, 20) : r.between(54, 120)));
    return {estimate::input(to_double(x, 0), bit_length(x) <= 53), rational(x), 2};
  }
  const checked_number a = random_expression(r, depth - 1);
  checked_number b = random_expression(r, depth - 1);
  if (r.one_in(3)) {  // near cancellation
    const checked_number small = random_expression(r, 0);
    b = {a.rounded + small.rounded, a.truth + small.truth, std::max(a.roundings, small.roundings) + 1};
  }
  switch (r.between(0, 2)) {
    case 0:
      return {a.rounded + b.rounded, a.truth + b.truth, std::max(a.roundings, b.roundings) + 1};
    case 1:
      return {a.rounded - b.rounded, a.truth - b.truth, std::max(a.roundings, b.roundings) + 1};
    default:
      return {a.rounded * b.rounded, a.truth * b.truth, a.roundings + b.roundings + 1};
  }
}

TEST(Filter, ErrorBoundHoldsForRandomExpressions) {
  dice r(800);
  int certain = 0;
  int exact = 0;
  for (int i = 0; i < 20000; ++i) {
    const checked_number x = random_expression(r, 5);
    if (x.roundings > 95 || !(x.rounded.scale < 1e290)) continue;
    EXPECT_LE(abs(rational(x.rounded.value) - x.truth), rational(x.rounded.error()));
    if (const auto s = x.rounded.certain_sign()) {
      EXPECT_EQ(*s, osteon::sign_of(x.truth));
      ++certain;
      exact += *s == sign::zero ? 1 : 0;
    }
  }
  EXPECT_GT(certain, 5000);
  EXPECT_GT(exact, 5);
}

// ---- formulas and kernels, each test for the plane and for space

// A kernel that counts how often it is asked.
template <int D>
class counted_roots {
 public:
  using base_kernel = kernel_of<roots<D>>;
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;
  static constexpr bool exact = true;
  static constexpr int dimension = D;
  using meeting = typename base_kernel::meeting;
  using bisector_type = typename base_kernel::bisector_type;

  counted_roots(std::span<const plane_in<D>> p, int& asked) : k_(make_sqrt_kernel(p)), asked_(&asked) {}
  plane_id size() const { return k_.size(); }
  sign orientation_at(int grade, const corner& c) const { return counted(k_.orientation_at(grade, c)); }
  sign offset_at(int grade, const support& q) const { return counted(k_.offset_at(grade, q)); }
  sign closing_at(int grade, const support& q) const { return counted(k_.closing_at(grade, q)); }
  sign cross_at(int grade, const support& q, const support& r) const { return counted(k_.cross_at(grade, q, r)); }
  bisector_type bisector(plane_id a, plane_id b) const { return k_.bisector(a, b); }
  sign compare(const bisector_type& e, const bisector_type& f) const { return k_.compare(e, f); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const { return k_.compare_volume(s, t); }

 private:
  sign counted(sign s) const {
    ++*asked_;
    return s;
  }
  base_kernel k_;
  int* asked_;
};

template <class Dimension>
class Hard : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  using planes = planes_in<D>;
  using support = meeting_planes<D>;

  // All lengths are whole multiples of the root of two, so every sign is that of the rational kernel's form
  // with those multiples: sqrt2 + sqrt8 - sqrt18 and its like are zero.
  static void radicands_of_one_class() {
    dice r(700);
    int hidden = 0;
    int simultaneous = 0;
    for (int round = 0; round < 20; ++round) {
      const planes p = random_planes<D>(family::doubled, 14, r);
      std::vector<integer> multiple;
      for (const auto& one : p) multiple.push_back(isqrt(dot(one.n, one.n) / 2));
      const auto closing = [&](const support& q) { return bordered<D>(p, q, [&](plane_id i) { return rational(multiple[i]); }); };
      const auto k = make_sqrt_kernel(p);
      const auto fast = with_filter<roots<D>>{}(p);
      const auto strict = with_perturbation<with_filter<roots<D>>>{}(p);
      for (int i = 0; i < 500; ++i) {
        const support q = sorted(r.distinct<D + 1>(k.size()));
        const support t = sorted(r.distinct<D + 1>(k.size()));
        const rational sq = closing(q);
        const rational st = closing(t);
        const bool alike = std::all_of(q.begin(), q.end(), [&](plane_id s) { return multiple[s] == multiple[q[0]]; });
        const auto m = k.meet(q);
        EXPECT_EQ(m.has_value(), sq != 0);
        EXPECT_EQ(fast.meet(q).has_value(), sq != 0);
        EXPECT_TRUE(strict.meet(q).has_value());
        bool dependent = true;
        for (int s = 0; s <= D; ++s) dependent = dependent && lambda_of(k, q, s) == sign::zero;
        if (sq == 0 && !alike && !dependent) ++hidden;
        if (sq == 0 || st == 0) continue;
        EXPECT_EQ(k.closing(*m), sign_of(sq));
        const sign truth = sign_of(rational(true_offset<D>(p, q) / sq - true_offset<D>(p, t) / st));
        if (truth == sign::zero && q != t && true_offset<D>(p, q) != 0) ++simultaneous;
        EXPECT_EQ(k.compare(*m, *k.meet(t)), truth);
        EXPECT_EQ(fast.compare(*fast.meet(q), *fast.meet(t)), truth);
      }
    }
    EXPECT_GT(hidden, 10);
    EXPECT_GT(simultaneous, 10);
  }

  static void error_bounds_of_formulas() {
    using fast_arithmetic = basic_filter_arithmetic<D>;
    using slow_arithmetic = basic_sqrt_arithmetic<D>;
    for (const family f : {family::small, family::long_normals, family::nearly_dependent, family::weighted}) {
      SCOPED_TRACE(trace(f));
      dice r(900 + static_cast<std::uint64_t>(f));
      const planes p = random_planes<D>(f, 12, r);
      const formulas<fast_arithmetic> fast{fast_arithmetic(p)};
      const formulas<slow_arithmetic> slow{slow_arithmetic(p)};
      const auto within = [](const estimate& x, const integer& truth) { return abs(rational(x.value) - rational(truth)) <= rational(x.error()); };
      for (int i = 0; i < 1000; ++i) {
        const support q = r.distinct<D + 1>(12);
        const int grade = r.between(0, 2 * D + 1);
        EXPECT_TRUE(within(fast.offset(grade, q), slow.offset(grade, q)));
        const auto estimates = fast.lambda(grade / 2, q);
        const auto truths = slow.lambda(grade / 2, q);
        for (int s = 0; s <= D; ++s) EXPECT_TRUE(within(estimates[s], truths[s]));
      }
    }
  }

  static void expect_filter_of_roots(const planes& p, dice& r, int turns) {
    const auto fast = with_filter<roots<D>>{}(p);
    interview<D>(fast, fast.base(), p, false, r, turns, equal);
    agree_at_all_grades<D>(fast, fast.base(), r, turns);
  }

  // Two coordinates of a normal whose scaled values are the two least machine numbers: 3 : 2 must not become 2 : 1.
  // And offsets share one scale: a long one must not grind short ones to dust.
  static void underflow() {
    const integer one = 1;
    for (unsigned length = 1060; length < 1080; ++length) {
      dice r(length);
      const integer zero = 0;
      if constexpr (D == 3) {
        expect_filter_of_roots({{{one << length, integer(3), integer(2)}, one},
                                {{zero, one << 99, zero}, one << 199},
                                {{zero, zero, one << 99}, one << 199},
                                {{one << 99, integer(4) << 96, integer(-7) << 96}, one << 198},
                                {{one << 99, integer(-4) << 96, integer(7) << 96}, one << 198}},
                               r, 60);
        expect_filter_of_roots({{{one << 99, one << 98, one}, integer(3)},
                                {{one << 97, integer(3), one << 99}, integer(2)},
                                {{integer(5), one << 99, one << 98}, integer(-1)},
                                {{-(one << 99), -(one << 97), -(one << 98)}, integer(5)},
                                {{-(one << 98), -(one << 99), one << 97}, integer(-2)},
                                {{one, zero, zero}, one << (length + 198)}},
                               r, 60);
      } else {
        expect_filter_of_roots({{{one << length, integer(3)}, one},
                                {{one << length, integer(2)}, one},
                                {{integer(2), one << length}, one << 199},
                                {{integer(4) << 96, integer(-7) << 96}, one << 198},
                                {{one << 99, integer(7) << 96}, one << 198}},
                               r, 60);
        expect_filter_of_roots({{{one << 99, one << 98}, integer(3)},
                                {{one << 97, integer(3)}, integer(2)},
                                {{integer(5), one << 99}, integer(-1)},
                                {{-(one << 99), -(one << 97)}, integer(5)},
                                {{one, zero}, one << (length + 198)}},
                               r, 60);
      }
    }
  }

  static int questions_to_the_base(family f, bool common) {
    dice r(1000 + static_cast<std::uint64_t>(f));
    int asked = 0;
    for (int round = 0; round < 10; ++round) {
      const planes p = random_planes<D>(f, 14, r, common);
      const filtered fast(std::span<const plane_in<D>>(p), counted_roots<D>(p, asked));
      interview<D>(fast, fast, p, common, r, 100, equal);
      for (int i = 0; i < 100; ++i) {
        const support q = r.distinct<D + 1>(fast.size());
        fast.offset_at(0, q);
        fast.cross_at(0, q, r.distinct<D + 1>(fast.size()));
      }
    }
    return asked;
  }
};

template <int D>
using dimension = std::integral_constant<int, D>;
struct name_of {
  template <class Dimension>
  static std::string GetName(int) {
    return Dimension::value == 2 ? "Plane" : "Space";
  }
};
using both = testing::Types<dimension<2>, dimension<3>>;
TYPED_TEST_SUITE(Hard, both, name_of);

TYPED_TEST(Hard, HiddenZerosOfDifferentRadicandsOfOneClass) { this->radicands_of_one_class(); }
TYPED_TEST(Hard, ErrorBoundHoldsForTheFormulas) { this->error_bounds_of_formulas(); }
TYPED_TEST(Hard, FilteredSurvivesUnderflow) { this->underflow(); }
TYPED_TEST(Hard, ExactDoublesNeverReachTheExactKernel) {
  for (const bool common : {false, true}) {
    EXPECT_EQ(this->questions_to_the_base(family::voxel, common), 0);
    EXPECT_EQ(this->questions_to_the_base(family::pythagorean, common), 0);
  }
  EXPECT_GT(this->questions_to_the_base(family::symmetric, true), 0) << "the counter counts";
}

}  // namespace
}  // namespace osteon::laws
