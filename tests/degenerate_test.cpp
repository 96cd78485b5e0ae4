// SPDX-License-Identifier: MIT

// Boxes, stairs, houses, voxels: planes in special position, exactly.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "isomorphism.hpp"
#include "osteon/input/mesh_repair.hpp"
#include "osteon/models/registry.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/space/contract.hpp"
#include "osteon/space/verify.hpp"
#include "support.hpp"

namespace osteon::test {
namespace {

using counts = std::array<std::size_t, 3>;

counts contracted(const input_mesh<integer>& m, const skeleton_options& o = {}) {
  const auto s = make_solid(m);
  const auto k = default_kernel(s);
  const auto c = contract(k, s.boundary, straight_skeleton(k, s.boundary, o));
  return {c.nodes.size(), c.arcs.size(), c.sheets.size()};
}

TEST(Contraction, KnownSkeletons) {
  using namespace models;
  EXPECT_EQ(contracted(box(1, 1, 1).take<integer>()), (counts{9, 8, 12}));
  EXPECT_EQ(contracted(box(1, 2, 3).take<integer>()), (counts{12, 12, 13}));
  EXPECT_EQ(contracted(box(1, 1, 2).take<integer>()), (counts{10, 9, 12}));
  for (const long height : {1, 2, 3, 7, 1000})
    EXPECT_EQ(contracted(pyramid({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, height).take<integer>()), (counts{6, 5, 8})) << height;
  EXPECT_EQ(contracted(octahedron(1).take<integer>()), (counts{7, 6, 12}));
  EXPECT_EQ(contracted(tetrahedron().take<integer>()), (counts{5, 4, 6}));
}

// ---- who may contract: a kernel whose zeros say what coincides, or one that has such a base

template <class K>
concept may_contract = requires(const K& k, const boundary& b, const skeleton& raw) {
  contract(k, b, raw);
};
template <class K>
concept may_verify_contraction = requires(const K& k, const boundary& b, const skeleton& raw, const contracted_skeleton& c) {
  verify_contraction(k, b, raw, c);
};
template <class K>
concept has_contraction = requires {
  typename contraction<K>;
};
template <class K>
concept may_contract_lines = requires(const K& k, const std::vector<int>& lines, const plane::skeleton& raw) {
  plane::contract(k, lines, raw);
};
template <class K>
concept has_contraction_of_lines = requires {
  typename plane::contraction<K>;
};

// Breaks ties, and hides what is below.
template <class K>
struct without_base : K {
 private:
  using K::base;
};

using limit = filtered<sqrt_kernel>;
static_assert(may_contract<limit> && has_contraction<limit> && may_verify_contraction<limit>);
static_assert(may_contract<sqrt_kernel> && may_contract<rational_kernel>);
static_assert(may_contract<perturbed<limit>> && may_verify_contraction<perturbed<limit>>);
static_assert(!has_contraction<perturbed<limit>>);
static_assert(kernel<without_base<perturbed<limit>>, 3>);
static_assert(!may_contract<without_base<perturbed<limit>>> && !may_verify_contraction<without_base<perturbed<limit>>>);

using line_limit = filtered<decltype(make_sqrt_kernel(std::span<const moving_line<integer>>()))>;
static_assert(may_contract_lines<line_limit> && has_contraction_of_lines<line_limit>);
static_assert(may_contract_lines<perturbed<line_limit>> && !has_contraction_of_lines<perturbed<line_limit>>);
static_assert(kernel<without_base<perturbed<line_limit>>, 2> && !may_contract_lines<without_base<perturbed<line_limit>>>);

TEST(Contraction, OfAPerturbedKernelIsThatOfItsBase) {
  const auto s = make_solid(models::box(1, 1, 1).take<integer>());
  const auto k = default_kernel(s);
  const auto raw = straight_skeleton(k, s.boundary);
  EXPECT_GT(raw.nodes.size(), 9U);
  EXPECT_EQ(contract(k, s.boundary, raw).nodes.size(), 9U);
  EXPECT_EQ(contract(k.base(), s.boundary, raw).nodes.size(), 9U);
  EXPECT_FALSE(verify_contraction(k, s.boundary, raw, contract(k.base(), s.boundary, raw)));
}

// A box with sides a <= b <= c keeps at time a/2 a rectangle of sides b - a and c - a: a point, a segment or a rectangle with an area.
TEST(Contraction, ThousandBoxes) {
  models::dice roll(1);
  for (int i = 0; i < 1000; ++i) {
    std::array<long, 3> side = {roll.between(1, 5), roll.between(1, 5), roll.between(1, 1000)};
    if (i % 2 == 0) side[2] = roll.between(1, 5);
    const auto found = contracted(models::box(side[0], side[1], side[2]).take<integer>());
    std::sort(side.begin(), side.end());
    const bool wide = side[1] > side[0];
    const bool longer = side[2] > side[0];
    const counts expected = wide ? counts{12, 12, 13} : (longer ? counts{10, 9, 12} : counts{9, 8, 12});
    EXPECT_EQ(found, expected) << side[0] << " " << side[1] << " " << side[2];
  }
}

TEST(Contraction, OfSolidsInGeneralPositionKeepsNodesAndArcs) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const auto s = make_solid(models::star(5, seed).take<integer>());
    const auto k = default_kernel(s);
    const auto raw = straight_skeleton(k, s.boundary);
    const auto c = contract(k.base(), s.boundary, raw);
    EXPECT_EQ(c.nodes.size(), raw.nodes.size());
    EXPECT_EQ(c.arcs.size(), raw.arcs.size());
    EXPECT_LE(c.sheets.size(), raw.sheets.size());
  }
}

// ---- invariance

input_mesh<integer> mapped(const input_mesh<integer>& m, const std::array<std::array<long, 3>, 3>& matrix) {
  input_mesh<integer> result = m;
  for (std::size_t p = 0; p < m.points.size(); ++p)
    for (std::size_t r = 0; r < 3; ++r) {
      auto& x = result.points[p][r];
      x = {0, 0, 0};
      for (std::size_t c = 0; c < 3; ++c) x.mantissa += matrix[r][c] * m.points[p][c].mantissa;
    }
  return result;
}

input_mesh<integer> shuffled(const input_mesh<integer>& m, std::uint64_t seed) {
  models::dice roll(seed);
  const auto permutation = [&](std::size_t n) {
    std::vector<int> p(n);
    std::iota(p.begin(), p.end(), 0);
    for (std::size_t i = n; i > 1; --i) std::swap(p[i - 1], p[static_cast<std::size_t>(roll.between(0, static_cast<long>(i) - 1))]);
    return p;
  };
  input_mesh<integer> result;
  const auto points = permutation(m.points.size());
  result.points.resize(m.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.points[static_cast<std::size_t>(points[i])] = m.points[i];
  for (const int f : permutation(m.facets.size())) {
    auto loop = m.facets[static_cast<std::size_t>(f)];
    for (int& p : loop) p = points[static_cast<std::size_t>(p)];
    std::rotate(loop.begin(), loop.begin() + roll.between(0, static_cast<long>(loop.size()) - 1), loop.end());
    result.facets.push_back(loop);
  }
  return result;
}

class Invariance : public testing::TestWithParam<std::string> {};

void expect_invariant(const input_mesh<integer>& m) {
  const auto original = placed(m);
  // A rotation with rational entries (quaternion 1 + 2i + 2j), times 9.
  const std::array<std::array<long, 3>, 3> turn = {{{1, 8, 4}, {8, 1, -4}, {-4, 4, -7}}};
  const std::array<std::array<long, 3>, 3> mirror = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto by = [](const std::array<std::array<long, 3>, 3>& matrix) {
    return [&matrix](const std::array<double, 3>& p) {
      std::array<double, 3> q{};
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) q[r] += static_cast<double>(matrix[r][c]) * p[c];
      return q;
    };
  };
  EXPECT_EQ(difference(original, placed(mapped(m, turn)), by(turn)), "") << "rotated";
  auto mirrored = mapped(m, mirror);
  reverse_facets(mirrored);
  EXPECT_EQ(difference(original, placed(mirrored), by(mirror)), "") << "mirrored";
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_EQ(difference(original, placed(shuffled(m, seed)), [](const auto& p) { return p; }), "") << "permuted with seed " << seed;
  for (const int ten : {-6, 6}) {
    auto scaled = m;
    for (auto& p : scaled.points)
      for (auto& x : p) x.ten += ten;
    const double factor = std::pow(10.0, ten);
    EXPECT_EQ(difference(original, placed(scaled),
                         [factor](const auto& p) {
                           return std::array<double, 3>{p[0] * factor, p[1] * factor, p[2] * factor};
                         }),
              "")
        << "scaled by 10^" << ten;
  }
}

TEST_P(Invariance, OfTheContractedSkeleton) {
  const auto& kinds = models::kinds();
  const auto& kind = *std::find_if(kinds.begin(), kinds.end(), [](const auto& k) { return k.name == GetParam(); });
  const int variants = kind.name == "voxels" ? 100 : 2;
  for (int seed = 1; seed <= variants; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_invariant(kind.make(kind.default_size, static_cast<std::uint64_t>(seed)).take<integer>());
  }
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const auto& k : models::kinds()) names.push_back(k.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Invariance, testing::ValuesIn(kind_names()), [](const auto& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace osteon::test
