// SPDX-License-Identifier: MIT

// The laws of kernels in space.

#include "kernel_laws.hpp"

namespace osteon::laws {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Space, kernel_laws, all_kernels<3>);

template <class Factory>
class angle_laws : public kernel_laws<Factory> {};
TYPED_TEST_SUITE(angle_laws, all_kernels<3>);
TYPED_TEST(angle_laws, K3AnglesAreATotalPreorder) { this->angles_are_a_total_preorder(); }

}  // namespace
}  // namespace osteon::laws
