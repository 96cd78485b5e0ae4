// SPDX-License-Identifier: MIT

// Every algorithm of the plane compiles with the weakest kernel, which can do nothing but what the concept says.

#include <gtest/gtest.h>

#include <vector>

#include "archetype.hpp"
#include "osteon/core/box_tree.hpp"
#include "osteon/core/error.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/verify.hpp"

namespace osteon::plane {

using test::archetype;
using test::weakest;

namespace {

// Bounds on motion that bound nothing and can do nothing else.
struct archetype_of_bounds {
  struct path {
    box start;
  };
  box frame() const { return box::at({0, 0}); }
  double speed() const { return 1; }
  bool is_stationary(line_id) const { return false; }
  interval time(const triple&) const { return {0, 1}; }
  interval sharp_time(const triple&) const { return {0, 1}; }
  box place(const triple&) const { return frame(); }
  path begin(line_id, line_id, const triple*) const { return {frame()}; }
  box swept(const path&, double, double) const { return frame(); }
};
static_assert(motion_bounds<archetype_of_bounds>);

}  // namespace

// ---- every member of every algorithm compiles with the archetype

template class propagation<weakest<2>, archetype_of_bounds>;
template class propagation<archetype<2, false>, archetype_of_bounds>;
template contracted_skeleton contract<weakest<2>>(const weakest<2>&, const std::vector<int>&, const skeleton&);
template contracted_skeleton contract<archetype<2, false>>(const archetype<2, false>&, const std::vector<int>&, const skeleton&);

namespace {

boundary triangle() { return {{1, 2, 0}, {0, 1, 2}, {0, 1, 2}, 3}; }

template <bool IsExact>
skeleton run(const archetype<2, IsExact>& k, const boundary& b) {
  const archetype_of_bounds bounds;
  return propagation(k, b, bounds).run();
}

// A kernel that always gives one answer contradicts itself; who is to blame depends on what it says of itself. It ends anyhow.
TEST(PlanarArchetype, NonsenseEnds) {
  for (const sign s : {sign::positive, sign::negative, sign::zero}) {
    SCOPED_TRACE(static_cast<int>(s));
    try {
      const skeleton raw = run(weakest<2>(s), triangle());
      EXPECT_TRUE(verify(weakest<2>(s), triangle(), raw)) << "what nonsense has made is refuted";
    } catch (const invariant_error&) {
    } catch (const unsupported_error&) {
    }
    try {
      const skeleton raw = run(archetype<2, false>(s), triangle());
      EXPECT_TRUE(verify(archetype<2, false>(s), triangle(), raw));
    } catch (const undecided_error&) {
    } catch (const unsupported_error&) {
    }
  }
}

TEST(PlanarArchetype, NothingIsContractedAndCertified) {
  const weakest<2> k(sign::positive);
  const skeleton nothing;
  const contracted_skeleton exact = contract(k, {}, nothing);
  EXPECT_TRUE(exact.nodes.empty());
  EXPECT_FALSE(verify(k, boundary{}, nothing));
  EXPECT_FALSE(verify_contraction(k, boundary{}, nothing, exact));
  EXPECT_TRUE(verify(k, triangle(), nothing));
}

}  // namespace
}  // namespace osteon::plane
