// SPDX-License-Identifier: MIT
#include "kernel_laws.hpp"

namespace osteon::laws {
namespace {

// Every kernel obeys the laws; a new one is a new line.
using all_kernels = testing::Types<doubles,                                    //
                                   rationals,                                  //
                                   roots,                                      //
                                   with_filter<rationals>,                     //
                                   with_filter<roots>,                         //
                                   with_perturbation<roots>,                   //
                                   with_perturbation<rationals>,               //
                                   with_perturbation<with_filter<roots>>,      //
                                   with_perturbation<with_filter<rationals>>,  //
                                   with_mirrored_perturbation<with_filter<roots>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(All, kernel_laws, all_kernels);

}  // namespace
}  // namespace osteon::laws
