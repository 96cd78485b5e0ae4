// SPDX-License-Identifier: MIT

// Kernels agree with each other: exact ones where all roots are rational, a filter with its base, a
// perturbation with its base where that is not zero, perturbed kernels among each other.

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "kernel_interview.hpp"

namespace osteon::laws {
namespace {

// Each law is a test for the plane and one for space.
template <class Dimension>
class Agreement : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  using planes = planes_in<D>;

  static void rational_is_roots() {
    for (const bool common : {false, true})
      for (const family f : {family::voxel, family::pythagorean, family::long_pythagorean}) {
        SCOPED_TRACE(trace(f));
        dice r(200 + static_cast<std::uint64_t>(f));
        for (int round = 0; round < 10; ++round) {
          const planes p = random_planes<D>(f, 12, r, common);
          interview<D>(make_rational_kernel(p), make_sqrt_kernel(p), p, common, r, 100, equal);
        }
      }
  }

  // Seven questions and four graded ones per turn: more than 20,000 of each per kernel.
  template <class Base>
  static void filter_is_its_base() {
    constexpr int rounds = 24;
    constexpr int turns = 50;
    for (const bool common : {false, true})
      for (const family f : all_families) {
        SCOPED_TRACE(trace(f));
        dice r(300 + static_cast<std::uint64_t>(f));
        for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
          const planes p = random_planes<D>(f, 12, r, common);
          const auto fast = with_filter<Base>{}(p);
          interview<D>(fast, fast.base(), p, common, r, turns, equal);
          agree_at_all_grades<D>(fast, fast.base(), r, turns);
        }
      }
  }

  static void expect_filter_of_roots(const planes& p, dice& r, int turns, int graded) {
    const auto fast = with_filter<roots<D>>{}(p);
    interview<D>(fast, fast.base(), p, false, r, turns, equal);
    agree_at_all_grades<D>(fast, fast.base(), r, graded);
  }

  // Numbers of very different lengths, so that scaling them to machine numbers underflows or overflows.
  static void filter_is_its_base_beyond_doubles() {
    dice r(400);
    const auto length = [&r] {
      static constexpr std::array<unsigned, 8> lengths = {1, 3, 20, 53, 99, 101, 1100, 2500};
      return lengths[r.between(0, 7)];
    };
    for (int round = 0; round < 60 && !testing::Test::HasFailure(); ++round) {
      planes p;
      while (p.size() < 9) {
        plane_in<D> one;
        for (integer& x : one.n) x = r.bits(length());
        one.d = r.bits(length());
        if (r.one_in(4)) one.weight = abs(r.bits(length())) + 1;
        if (dot(one.n, one.n) != 0) p.push_back(one);
      }
      expect_filter_of_roots(p, r, 40, 20);
    }
  }

  template <class Base>
  static void perturbation_breaks_ties_only() {
    int ties = 0;
    for (const bool common : {false, true})
      for (const family f : all_families) {
        SCOPED_TRACE(trace(f));
        dice r(500 + static_cast<std::uint64_t>(f));
        for (int round = 0; round < 3; ++round) {
          const planes p = random_planes<D>(f, 12, r, common);
          const auto base = Base{}(p);
          interview<D>(base, with_perturbation<Base>{}(p), p, common, r, 60,
                       [&ties](const std::string& what, std::optional<sign> a, std::optional<sign> b) {
                         if (a && *a != sign::zero) {
                           EXPECT_EQ(a, b) << what;
                         } else if (what != "angle") {
                           ++ties;
                           EXPECT_NE(b, sign::zero) << what;
                         }
                       });
        }
      }
    EXPECT_GT(ties, 1000) << "the inputs are degenerate enough to mean something";
  }

  static void perturbed_kernels_break_ties_alike() {
    for (const bool common : {false, true})
      for (const family f : all_families) {
        SCOPED_TRACE(trace(f));
        dice r(600 + static_cast<std::uint64_t>(f));
        const planes p = random_planes<D>(f, 12, r, common);
        const auto k = with_perturbation<roots<D>>{}(p);
        interview<D>(k, with_perturbation<with_filter<roots<D>>>{}(p), p, common, r, 150, equal);
        if (rational_lengths(f)) interview<D>(k, with_perturbation<rationals<D>>{}(p), p, common, r, 150, equal);
      }
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
TYPED_TEST_SUITE(Agreement, both, name_of);

TYPED_TEST(Agreement, RationalIsRootsWhereAllRootsAreRational) { this->rational_is_roots(); }
TYPED_TEST(Agreement, FilteredIsRational) { this->template filter_is_its_base<rationals<TypeParam::value>>(); }
TYPED_TEST(Agreement, FilteredIsRoots) { this->template filter_is_its_base<roots<TypeParam::value>>(); }
TYPED_TEST(Agreement, FilteredIsRootsForNumbersBeyondDoubles) { this->filter_is_its_base_beyond_doubles(); }
TYPED_TEST(Agreement, PerturbedRootsBreakTiesOnly) { this->template perturbation_breaks_ties_only<roots<TypeParam::value>>(); }
TYPED_TEST(Agreement, PerturbedRationalsBreakTiesOnly) { this->template perturbation_breaks_ties_only<rationals<TypeParam::value>>(); }
TYPED_TEST(Agreement, PerturbedFilteredRootsBreakTiesOnly) { this->template perturbation_breaks_ties_only<with_filter<roots<TypeParam::value>>>(); }
TYPED_TEST(Agreement, PerturbedFilteredRationalsBreakTiesOnly) {
  this->template perturbation_breaks_ties_only<with_filter<rationals<TypeParam::value>>>();
}
TYPED_TEST(Agreement, AllPerturbedKernelsBreakTiesAlike) { this->perturbed_kernels_break_ties_alike(); }

}  // namespace
}  // namespace osteon::laws
