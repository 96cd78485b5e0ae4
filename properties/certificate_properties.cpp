// SPDX-License-Identifier: MIT

/// \file
/// Every generated solid's skeleton is certified, by every exact kernel.

#include <optional>
#include <span>
#include <string>

#include "laws.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/space/verify.hpp"

namespace osteon::properties {
namespace {

template <kernel<3> K>
void certify(const char* name, const K& k, const solid<integer>& s, const skeleton_options& o) {
  require(name, [&]() -> std::string {
    const auto broken = verify(k, s.boundary, straight_skeleton(k, s.boundary, o));
    if (!broken) return "";
    return std::string(rule_names[static_cast<std::size_t>(broken->broken)]) + ": " + broken->witness;
  });
}

RC_GTEST_PROP(certificate, every_skeleton_is_certified, ()) {
  const skeleton_options o = *gen::any_options();
  const auto s = *rc::gen::oneOf(gen::unweighted(), gen::unweighted(), gen::unweighted(), gen::unweighted(), gen::weighted(gen::convex()),
                                 gen::weighted(gen::stars()));
  RC_TAG(s.kind);
  const auto& planes = s.solid->planes;
  const std::span<const moving_plane<integer>> span(planes);
  certify("perturbed<filtered<sqrt>>", perturbed(filtered(span, make_sqrt_kernel(planes))), *s.solid, o);
  certify("perturbed<sqrt>", perturbed(make_sqrt_kernel(planes)), *s.solid, o);
  certify("perturbed<filtered<rational>>", perturbed(filtered(span, make_rational_kernel(planes))), *s.solid, o);
  certify("perturbed<rational>", perturbed(make_rational_kernel(planes)), *s.solid, o);
}

}  // namespace
}  // namespace osteon::properties
