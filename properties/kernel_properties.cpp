// SPDX-License-Identifier: MIT

/// \file
/// Kernels agree: a filter changes nothing, a perturbation changes nothing where nothing is degenerate, and speeds rounded to 2^-64 give the
/// same skeleton there.

#include <string>

#include "laws.hpp"

namespace osteon::properties {
namespace {

void require_same(const run& a, const run& b) {
  require(a.kernel + " and " + b.kernel, [&] { return difference(a.raw, b.raw); });
}

RC_GTEST_PROP(kernels, a_filter_changes_nothing, ()) {
  const auto s = *rc::gen::oneOf(gen::unweighted(), gen::weighted(gen::stars()));
  RC_TAG(s.kind);
  const auto runs = run_all(*s.solid, *gen::any_options());
  require_same(runs[0], runs[1]);
  require_same(runs[2], runs[3]);
}

RC_GTEST_PROP(kernels, agree_in_general_position, ()) {
  const auto o = *gen::any_options();
  const auto s = *gen::unweighted_general(o);
  RC_TAG(s.kind);
  const auto runs = run_all(*s.solid, o);
  for (const run& r : runs) require_same(runs[0], r);
  for (const run& r : run_unperturbed(*s.solid, o)) require_same(runs[0], r);
}

}  // namespace
}  // namespace osteon::properties
