// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How a law meets RapidCheck: it returns what is broken, in words, or nothing.

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "generators.hpp"
#include "offset.hpp"
#include "run.hpp"

namespace osteon::properties {

/// Checks a law of one run; the message names the kernel.
template <class Law>
void require(const std::string& kernel, Law law) {
  std::string broken;
  try {
    broken = law();
  } catch (const std::domain_error& e) {  // of placed_skeleton
    broken = e.what();
  }
  if (!broken.empty()) RC_FAIL(kernel + ": " + broken);
}

/// A law of placed skeletons, for every exact kernel.
template <class Law>
void for_every_kernel(const specimen& s, Law law, const skeleton_options& o = {}) {
  RC_TAG(s.kind);
  for (const run& r : distinct(run_all(*s.solid, o))) require(r.kernel, [&] { return law(placed_skeleton(*s.solid, r)); });
}

}  // namespace osteon::properties
