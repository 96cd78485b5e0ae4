// SPDX-License-Identifier: MIT

// The laws of kernels in the plane.

#include "kernel_laws.hpp"

namespace osteon::laws {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Plane, kernel_laws, all_kernels<2>);

using perturbed_kernels = testing::Types<with_perturbation<roots<2>>, with_perturbation<rationals<2>>, with_perturbation<with_filter<roots<2>>>,
                                         with_perturbation<with_filter<rationals<2>>>, with_mirrored_perturbation<with_filter<roots<2>>>>;
template <class Factory>
class limit_laws : public kernel_laws<Factory> {};
TYPED_TEST_SUITE(limit_laws, perturbed_kernels);
TYPED_TEST(limit_laws, LimitsAreTheUnperturbedAnswers) { this->limits_are_the_unperturbed_answers(); }

}  // namespace
}  // namespace osteon::laws
