// SPDX-License-Identifier: MIT

/// \file
/// The kernels of space.

#include "space_kernels.hpp"

#include <memory>
#include <span>
#include <utility>

#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"

namespace osteon {

kernel_pair<3> make_kernels(const solid<integer>& s, number_kernel k, bool mirrored) {
  const std::span<const moving_plane<integer>> planes(s.planes);
  switch (k) {
    case number_kernel::sqrt:
      return erased<3>(perturbed(filtered(planes, make_sqrt_kernel(planes)), mirrored));
    case number_kernel::rational:
      return erased<3>(perturbed(filtered(planes, make_rational_kernel(planes)), mirrored));
    case number_kernel::floating:
      break;
  }
  const any_kernel<3> machine(std::make_shared<const double_kernel>(make_double_kernel(planes)));
  return {machine, machine};
}

}  // namespace osteon
