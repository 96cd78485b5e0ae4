// SPDX-License-Identifier: MIT

// Every algorithm of space compiles with the weakest kernel, which can do nothing but what the concept says.

#include <gtest/gtest.h>

#include "archetype.hpp"
#include "osteon/core/error.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/split.hpp"
#include "osteon/space/verify.hpp"

namespace osteon {

using test::archetype;
using test::weakest;

template class splitter<weakest<3>>;
template class propagation<weakest<3>>;
template skeleton straight_skeleton<weakest<3>>(const weakest<3>&, const boundary&, const skeleton_options&);
template class splitter<archetype<3, false>>;
template class propagation<archetype<3, false>>;
template skeleton straight_skeleton<archetype<3, false>>(const archetype<3, false>&, const boundary&, const skeleton_options&);

namespace {

// Four facets in a ring around one vertex: enough to be asked, never a solid.
boundary one_vertex() {
  boundary b;
  b.planes = 4;
  b.vertices.push_back({{0, 1, 2, 3}, {0, 1, 2, 3}});
  for (plane_id p = 0; p < 4; ++p) b.edges.push_back({{0, 0}, {p, (p + 1) % 4}, p % 2 == 0});
  return b;
}

TEST(Archetype, NothingHasAnEmptySkeleton) {
  EXPECT_TRUE(straight_skeleton(weakest<3>(sign::positive), boundary{}).nodes.empty());
  EXPECT_TRUE(straight_skeleton(archetype<3, false>(sign::zero), boundary{}).nodes.empty());
}

// A kernel that always gives one answer contradicts itself; who is to blame depends on what it says of itself.
TEST(Archetype, NonsenseEndsWithTheRightError) {
  for (const sign s : {sign::positive, sign::negative}) {
    EXPECT_THROW(straight_skeleton(weakest<3>(s), one_vertex()), invariant_error);
    EXPECT_THROW(straight_skeleton(archetype<3, false>(s), one_vertex()), undecided_error);
  }
  EXPECT_THROW(straight_skeleton(weakest<3>(sign::zero), one_vertex()), degenerate_error);
}

TEST(Archetype, NothingIsContractedAndCertified) {
  const weakest<3> k(sign::positive);
  const skeleton nothing;
  const contracted_skeleton exact = contract(k, boundary{}, nothing);
  EXPECT_TRUE(exact.nodes.empty());
  EXPECT_FALSE(verify(k, boundary{}, nothing));
  EXPECT_FALSE(verify_contraction(k, boundary{}, nothing, exact));
  EXPECT_TRUE(verify(k, one_vertex(), nothing));
}

}  // namespace
}  // namespace osteon
