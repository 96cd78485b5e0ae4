// SPDX-License-Identifier: MIT
#include "kernel_laws.hpp"

#include <cmath>
#include <string>

#include "osteon/kernel/estimate.hpp"
#include "osteon/kernel/formulas.hpp"
#include "osteon/space/split.hpp"

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

// ---- kernels agree

// The answers of one kernel to some random questions, in order.
template <class K>
class questions {
 public:
  questions(const K& k, const planes& p, bool common) : k_(k), p_(p), common_(common) {}

  sign orientation(const triple& t) const { return k_.orientation(t[0], t[1], t[2]); }
  std::optional<sign> closing(const quadruple& q) const {
    const auto m = k_.meet(q);
    return m ? std::optional(k_.closing(*m)) : std::nullopt;
  }
  std::optional<sign> compare(const quadruple& q, const quadruple& r) const {
    const auto m = k_.meet(q);
    const auto n = k_.meet(r);
    return m && n ? std::optional(k_.compare(*m, *n)) : std::nullopt;
  }
  std::optional<sign> after_start(const quadruple& q) const {
    const auto m = k_.meet(q);
    return m ? std::optional(k_.compare(*m, k_.start())) : std::nullopt;
  }
  // Corners made by a perturbation alone are not asked for: the base kernel has no answer.
  std::optional<sign> side(const quadruple& q, const quadruple& r) const {
    const auto m = k_.meet(r);
    if (!m || true_orientation(p_, q[0], q[1], q[2]) == sign::zero) return std::nullopt;
    return k_.side(q[3], q[0], q[1], q[2], *m);
  }
  std::optional<sign> side_at_start(const quadruple& q) const {
    if (!common_ || true_orientation(p_, q[0], q[1], q[2]) == sign::zero) return std::nullopt;
    return k_.side(q[3], q[0], q[1], q[2], k_.start());
  }
  sign angle(const quadruple& q) const { return k_.compare(k_.bisector(q[0], q[1]), k_.bisector(q[2], q[3])); }

 private:
  const K& k_;
  const planes& p_;
  bool common_;
};

// Asks two kernels the same; `same` judges each pair of answers.
template <class K, class L, class Same>
void interview(const K& k, const L& l, const planes& p, bool common, dice& r, int count, Same same) {
  const questions<K> a(k, p, common);
  const questions<L> b(l, p, common);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const triple t = r.distinct<3>(k.size());
    const quadruple q = r.distinct<4>(k.size());
    const quadruple s = r.distinct<4>(k.size());
    if (ascending(q) == ascending(s)) continue;  // simultaneous whatever the perturbation
    same("orientation", a.orientation(t), b.orientation(t));
    same("closing", a.closing(q), b.closing(q));
    same("start", a.after_start(q), b.after_start(q));
    same("compare", a.compare(q, s), b.compare(q, s));
    same("side", a.side(q, s), b.side(q, s));
    same("side at start", a.side_at_start(q), b.side_at_start(q));
    same("angle", a.angle(q), b.angle(q));
  }
}

const auto equal = [](const char* what, std::optional<sign> a, std::optional<sign> b) { EXPECT_EQ(a, b) << what; };

TEST(Agreement, RationalAndRootsWhereAllRootsAreRational) {
  for (const bool common : {false, true})
    for (const family f : {family::voxel, family::pythagorean, family::long_pythagorean}) {
      SCOPED_TRACE(trace(f));
      dice r(200 + static_cast<std::uint64_t>(f));
      for (int round = 0; round < 10; ++round) {
        const planes p = random_planes(f, 12, r, common);
        interview(make_rational_kernel(p), make_sqrt_kernel(p), p, common, r, 100, equal);
      }
    }
}

template <class K>
void agree_at_all_grades(const K& fast, dice& r, int count) {
  const auto& slow = fast.base();
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const int grade = r.between(0, highest_grade);
    const quadruple q = r.distinct<4>(fast.size());
    const quadruple s = r.distinct<4>(fast.size());
    EXPECT_EQ(fast.orientation_at(grade, {q[0], q[1], q[2]}), slow.orientation_at(grade, {q[0], q[1], q[2]})) << grade;
    EXPECT_EQ(fast.offset_at(grade, q), slow.offset_at(grade, q)) << grade;
    EXPECT_EQ(fast.closing_at(grade, q), slow.closing_at(grade, q)) << grade;
    EXPECT_EQ(fast.cross_at(grade, q, s), slow.cross_at(grade, q, s)) << grade;
  }
}

// Seven questions and four graded ones per turn: more than 20,000 of each per kernel.
template <class Base>
void expect_filter_to_agree() {
  constexpr int rounds = 24;
  constexpr int turns = 50;
  for (const bool common : {false, true})
    for (const family f : all_families) {
      SCOPED_TRACE(trace(f));
      dice r(300 + static_cast<std::uint64_t>(f));
      for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
        const planes p = random_planes(f, 12, r, common);
        const auto fast = with_filter<Base>{}(p);
        interview(fast, fast.base(), p, common, r, turns, equal);
        agree_at_all_grades(fast, r, turns);
      }
    }
}

TEST(Agreement, FilteredIsRational) { expect_filter_to_agree<rationals>(); }
TEST(Agreement, FilteredIsRoots) { expect_filter_to_agree<roots>(); }

// Numbers of very different lengths, so that scaling them to machine numbers underflows or overflows.
TEST(Agreement, FilteredIsRootsForNumbersBeyondDoubles) {
  dice r(400);
  const auto length = [&r] {
    static constexpr std::array<unsigned, 8> lengths = {1, 3, 20, 53, 99, 101, 1100, 2500};
    return lengths[r.between(0, 7)];
  };
  for (int round = 0; round < 60 && !testing::Test::HasFailure(); ++round) {
    planes p;
    while (p.size() < 9) {
      plane one{{r.bits(length()), r.bits(length()), r.bits(length())}, r.bits(length())};
      if (r.one_in(4)) one.weight = abs(r.bits(length())) + 1;
      if (dot(one.n, one.n) != 0) p.push_back(one);
    }
    const auto fast = with_filter<roots>{}(p);
    interview(fast, fast.base(), p, false, r, 40, equal);
    agree_at_all_grades(fast, r, 20);
  }
}

// Two coordinates of a normal whose scaled values are the two least machine numbers: 3 : 2 must not become 2 : 1.
TEST(Agreement, FilteredSurvivesUnderflow) {
  const integer one = 1;
  for (unsigned length = 1060; length < 1080; ++length) {
    const planes p = {{{one << length, integer(3), integer(2)}, one},
                      {{integer(0), one << 99, integer(0)}, one << 199},
                      {{integer(0), integer(0), one << 99}, one << 199},
                      {{integer(1) << 99, integer(4) << 96, integer(-7) << 96}, one << 198},
                      {{integer(1) << 99, integer(-4) << 96, integer(7) << 96}, one << 198}};
    const auto fast = with_filter<roots>{}(p);
    dice r(length);
    interview(fast, fast.base(), p, false, r, 60, equal);
    agree_at_all_grades(fast, r, 60);
    // Offsets share one scale: a long one must not grind short ones to dust.
    planes far = {{{one << 99, one << 98, integer(1)}, integer(3)},       {{one << 97, integer(3), one << 99}, integer(2)},
                  {{integer(5), one << 99, one << 98}, integer(-1)},      {{-(one << 99), -(one << 97), -(one << 98)}, integer(5)},
                  {{-(one << 98), -(one << 99), one << 97}, integer(-2)}, {{integer(1), integer(0), integer(0)}, one << (length + 198)}};
    const auto distant = with_filter<roots>{}(far);
    interview(distant, distant.base(), far, false, r, 60, equal);
    agree_at_all_grades(distant, r, 60);
  }
}

template <class Base>
void expect_perturbation_to_break_ties_only() {
  int ties = 0;
  for (const bool common : {false, true})
    for (const family f : all_families) {
      SCOPED_TRACE(trace(f));
      dice r(500 + static_cast<std::uint64_t>(f));
      for (int round = 0; round < 3; ++round) {
        const planes p = random_planes(f, 12, r, common);
        const auto base = Base{}(p);
        interview(base, with_perturbation<Base>{}(p), p, common, r, 60,
                  [&ties](const std::string& what, std::optional<sign> a, std::optional<sign> b) {
                    if (a && *a != sign::zero) {
                      EXPECT_EQ(a, b) << what;
                    } else if (what != "angle") {
                      ++ties;
                      EXPECT_NE(b, sign::zero) << what;
                    }
                  });
      }
    }
  EXPECT_GT(ties, 1000) << "the inputs are degenerate enough to mean something";
}

TEST(Agreement, PerturbedRootsBreakTiesOnly) { expect_perturbation_to_break_ties_only<roots>(); }
TEST(Agreement, PerturbedRationalsBreakTiesOnly) { expect_perturbation_to_break_ties_only<rationals>(); }
TEST(Agreement, PerturbedFilteredRootsBreakTiesOnly) { expect_perturbation_to_break_ties_only<with_filter<roots>>(); }
TEST(Agreement, PerturbedFilteredRationalsBreakTiesOnly) { expect_perturbation_to_break_ties_only<with_filter<rationals>>(); }

TEST(Agreement, AllPerturbedKernelsBreakTiesAlike) {
  for (const bool common : {false, true})
    for (const family f : all_families) {
      SCOPED_TRACE(trace(f));
      dice r(600 + static_cast<std::uint64_t>(f));
      const planes p = random_planes(f, 12, r, common);
      interview(with_perturbation<roots>{}(p), with_perturbation<with_filter<roots>>{}(p), p, common, r, 150, equal);
      if (rational_lengths(f)) interview(with_perturbation<roots>{}(p), with_perturbation<rationals>{}(p), p, common, r, 150, equal);
    }
}

// ---- zero without looking so

// All lengths are whole multiples of the root of two, so every sign is that of the rational kernel's form with those
// multiples: sqrt2 + sqrt8 - sqrt18 and its like are zero.
TEST(HiddenZeros, DifferentRadicandsOfOneClass) {
  dice r(700);
  int hidden = 0;
  int simultaneous = 0;
  for (int round = 0; round < 20; ++round) {
    const planes p = random_planes(family::doubled, 14, r);
    std::vector<integer> multiple;
    for (const plane& one : p) multiple.push_back(isqrt(dot(one.n, one.n) / 2));
    const auto closing = [&](const quadruple& q) {
      return determinant4(p, q, {rational(multiple[q[0]]), rational(multiple[q[1]]), rational(multiple[q[2]]), rational(multiple[q[3]])});
    };
    const auto k = make_sqrt_kernel(p);
    const auto fast = with_filter<roots>{}(p);
    const auto strict = with_perturbation<with_filter<roots>>{}(p);
    for (int i = 0; i < 500; ++i) {
      const quadruple q = ascending(r.distinct<4>(k.size()));
      const quadruple t = ascending(r.distinct<4>(k.size()));
      const rational sq = closing(q);
      const rational st = closing(t);
      bool alike = true;
      for (int s = 1; s < 4; ++s) alike = alike && multiple[q[s]] == multiple[q[0]];
      const auto m = k.meet(q);
      EXPECT_EQ(m.has_value(), sq != 0);
      EXPECT_EQ(fast.meet(q).has_value(), sq != 0);
      EXPECT_TRUE(strict.meet(q).has_value());
      bool dependent = true;
      for (int s = 0; s < 4; ++s) dependent = dependent && lambda(k, q, s) == sign::zero;
      if (sq == 0 && !alike && !dependent) ++hidden;
      if (sq == 0 || st == 0) continue;
      EXPECT_EQ(k.closing(*m), sign_of(sq));
      const sign truth = sign_of(rational(true_offset(p, q) / sq - true_offset(p, t) / st));
      if (truth == sign::zero && q != t && true_offset(p, q) != 0) ++simultaneous;
      EXPECT_EQ(k.compare(*m, *k.meet(t)), truth);
      EXPECT_EQ(fast.compare(*fast.meet(q), *fast.meet(t)), truth);
    }
  }
  EXPECT_GT(hidden, 10);
  EXPECT_GT(simultaneous, 10);
}

// ---- the filter's claims

struct checked_number {
  estimate rounded;
  rational truth;
  int roundings;  // on the longest path
};

checked_number random_expression(dice& r, int depth) {
  if (depth == 0 || r.one_in(6)) {
    const integer x = r.bits(static_cast<unsigned>(r.one_in(2) ? r.between(1, 20) : r.between(54, 120)));
    return {estimate::input(to_double(x, 0), bit_length(x) <= 53), rational(x), 2};
  }
  const checked_number a = random_expression(r, depth - 1);
  checked_number b = random_expression(r, depth - 1);
  if (r.one_in(3)) {  // near cancellation
    const checked_number small = random_expression(r, 0);
    b = {a.rounded + small.rounded, a.truth + small.truth, std::max(a.roundings, small.roundings) + 1};
  }
  switch (r.between(0, 2)) {
    case 0:
      return {a.rounded + b.rounded, a.truth + b.truth, std::max(a.roundings, b.roundings) + 1};
    case 1:
      return {a.rounded - b.rounded, a.truth - b.truth, std::max(a.roundings, b.roundings) + 1};
    default:
      return {a.rounded * b.rounded, a.truth * b.truth, a.roundings + b.roundings + 1};
  }
}

TEST(Filter, ErrorBoundHoldsForRandomExpressions) {
  dice r(800);
  int certain = 0;
  int exact = 0;
  for (int i = 0; i < 20000; ++i) {
    const checked_number x = random_expression(r, 5);
    if (x.roundings > 95 || !(x.rounded.scale < 1e290)) continue;
    EXPECT_LE(abs(rational(x.rounded.value) - x.truth), rational(x.rounded.error()));
    if (const auto s = x.rounded.certain_sign()) {
      EXPECT_EQ(*s, osteon::sign_of(x.truth));
      ++certain;
      exact += *s == sign::zero ? 1 : 0;
    }
  }
  EXPECT_GT(certain, 5000);
  EXPECT_GT(exact, 5);
}

TEST(Filter, ErrorBoundHoldsForTheFormulas) {
  for (const family f : {family::small, family::long_normals, family::nearly_dependent, family::weighted}) {
    SCOPED_TRACE(trace(f));
    dice r(900 + static_cast<std::uint64_t>(f));
    const planes p = random_planes(f, 12, r);
    const formulas<filter_arithmetic> fast{filter_arithmetic(p)};
    const formulas<sqrt_arithmetic> slow{sqrt_arithmetic(p)};
    const auto within = [](const estimate& x, const integer& truth) { return abs(rational(x.value) - rational(truth)) <= rational(x.error()); };
    for (int i = 0; i < 1000; ++i) {
      const quadruple q = r.distinct<4>(12);
      const int grade = r.between(0, 7);
      EXPECT_TRUE(within(fast.offset(grade, q), slow.offset(grade, q)));
      const auto lambdas = fast.lambda(grade / 2, q);
      const auto truths = slow.lambda(grade / 2, q);
      for (int s = 0; s < 4; ++s) EXPECT_TRUE(within(lambdas[s], truths[s]));
    }
  }
}

// A kernel that counts how often it is asked.
class counted_roots {
 public:
  static constexpr bool exact = true;
  static constexpr int dimension = 3;
  using meeting = sqrt_kernel::meeting;
  using bisector_type = sqrt_kernel::bisector_type;

  counted_roots(std::span<const plane> p, int& asked) : k_(make_sqrt_kernel(p)), asked_(&asked) {}
  plane_id size() const { return k_.size(); }
  sign orientation_at(int grade, const triple& t) const { return counted(k_.orientation_at(grade, t)); }
  sign offset_at(int grade, const quadruple& q) const { return counted(k_.offset_at(grade, q)); }
  sign closing_at(int grade, const quadruple& q) const { return counted(k_.closing_at(grade, q)); }
  sign cross_at(int grade, const quadruple& q, const quadruple& r) const { return counted(k_.cross_at(grade, q, r)); }
  bisector_type bisector(plane_id a, plane_id b) const { return k_.bisector(a, b); }
  sign compare(const bisector_type& e, const bisector_type& f) const { return k_.compare(e, f); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const { return k_.compare_volume(s, t); }

 private:
  sign counted(sign s) const {
    ++*asked_;
    return s;
  }
  sqrt_kernel k_;
  int* asked_;
};

int questions_to_the_base(family f, bool common) {
  dice r(1000 + static_cast<std::uint64_t>(f));
  int asked = 0;
  for (int round = 0; round < 10; ++round) {
    const planes p = random_planes(f, 14, r, common);
    const filtered fast(p, counted_roots(p, asked));
    interview(fast, fast, p, common, r, 100, equal);
    for (int i = 0; i < 100; ++i) {
      const quadruple q = r.distinct<4>(fast.size());
      fast.offset_at(0, q);
      fast.cross_at(0, q, r.distinct<4>(fast.size()));
    }
  }
  return asked;
}

TEST(Filter, VoxelsNeverReachTheExactKernel) {
  for (const bool common : {false, true}) {
    EXPECT_EQ(questions_to_the_base(family::voxel, common), 0);
    EXPECT_EQ(questions_to_the_base(family::pythagorean, common), 0);
  }
  EXPECT_GT(questions_to_the_base(family::symmetric, true), 0) << "the counter counts";
}

// ---- volumes and angles

// A corner as the graph of a function: edges at ascending angles with random slopes. Its planes pass through the origin.
struct random_corner {
  planes p;
  corner c;
};

random_corner make_corner(dice& r, int degree, bool pythagorean = false) {
  static constexpr std::array<std::array<int, 2>, 8> around = {{{7, 0}, {5, 5}, {0, 7}, {-5, 5}, {-7, 0}, {-5, -5}, {0, -7}, {5, -5}}};
  for (;;) {
    std::vector<vector3> edges;
    for (int e = 0; e < degree; ++e) {
      const auto& a = around[degree <= 4 ? 2 * e : e];
      const int jitter = pythagorean ? 0 : 1;
      edges.push_back({integer(a[0] + r.between(-jitter, jitter)), integer(a[1] + r.between(-jitter, jitter)), integer(r.between(-6, 6))});
    }
    random_corner result;
    for (int m = 0; m < degree; ++m) {
      const vector3& x = edges[m];
      const vector3& y = edges[(m + 1) % degree];
      const vector3 n = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
      result.p.push_back({n, integer(0)});
      result.c.facets.push_back(m);
    }
    bool generic_corner = true;
    for (int m = 0; m < degree; ++m) {
      const integer below = dot(result.p[m].n, edges[(m + 2) % degree]);
      result.c.convex.push_back(below < 0);
      generic_corner = generic_corner && below != 0;
      for (int a = 0; a < m; ++a)
        for (int b = 0; b < a; ++b) generic_corner = generic_corner && true_orientation(result.p, m, a, b) != sign::zero;
    }
    if (generic_corner) return result;
  }
}

std::vector<triple> triangles(const split_tree& t) { return {t.vertices.begin(), t.vertices.end()}; }

TEST(Volume, OrderOfTreesAndAgreement) {
  dice r(1100);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    const random_corner x = make_corner(r, r.between(4, 7));
    const auto exact = make_sqrt_kernel(x.p);
    const auto rounded = make_rational_kernel(x.p);
    const auto machine = make_double_kernel(x.p);
    std::vector<std::vector<triple>> trees;
    for_each_triangulation(x.c.degree(), [&](std::span<const std::pair<int, int>> diagonals) {
      if (trees.size() == 8) return;
      trees.emplace_back();  // of all triangulations, whether a boundary or not: the formula is the same
      const auto joined = [&](int a, int b) {
        return b == a + 1 || (a == 0 && b == x.c.degree() - 1) || std::find(diagonals.begin(), diagonals.end(), std::pair(a, b)) != diagonals.end();
      };
      for (int a = 0; a < x.c.degree(); ++a)
        for (int b = a + 1; b < x.c.degree(); ++b)
          for (int c = b + 1; c < x.c.degree(); ++c)
            if (joined(a, b) && joined(b, c) && joined(a, c)) trees.back().push_back({a, b, c});
      ASSERT_EQ(static_cast<int>(trees.back().size()), x.c.degree() - 2);
    });
    const std::size_t n = trees.size();
    std::vector<std::vector<sign>> order(n, std::vector<sign>(n));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        order[a][b] = exact.compare_volume(trees[a], trees[b]);
        EXPECT_EQ(order[a][b] == sign::zero, a == b);
        EXPECT_EQ(rounded.compare_volume(trees[a], trees[b]), order[a][b]);
        if (a != b) {
          EXPECT_EQ(machine.compare_volume(trees[a], trees[b]), order[a][b]);
        }
        ++compared;
      }
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        EXPECT_EQ(order[a][b], -order[b][a]);
        for (std::size_t c = 0; c < n; ++c) {
          if (order[a][b] == sign::negative && order[b][c] == sign::negative) {
            EXPECT_EQ(order[a][c], sign::negative);
          }
        }
      }
  }
  EXPECT_GT(compared, 500);
}

// The two ways to split four planes differ by the tetrahedron between them, whose signed volume is -S^3 / (6 l0 l1 l2 l3)
// at time one; it is empty where the planes keep a common point.
TEST(Volume, TwoTreesOfFourPlanesDifferByATetrahedron) {
  for (const family f : {family::small, family::pythagorean, family::symmetric, family::doubled, family::weighted, family::long_normals}) {
    SCOPED_TRACE(trace(f));
    dice r(1200 + static_cast<std::uint64_t>(f));
    int seen = 0;
    for (int round = 0; round < 400 && seen < 60; ++round) {
      const planes p = random_planes(f, 4, r, true);
      const auto k = make_sqrt_kernel(p);
      sign tetrahedron = -k.closing_at(0, {0, 1, 2, 3});
      bool corners = true;
      for (int s = 0; s < 4; ++s) {
        corners = corners && lambda(k, {0, 1, 2, 3}, s) != sign::zero;
        tetrahedron = tetrahedron * lambda(k, {0, 1, 2, 3}, s);
      }
      if (!corners) continue;
      ++seen;
      const std::vector<triple> s = {{0, 1, 2}, {0, 2, 3}};
      const std::vector<triple> t = {{0, 1, 3}, {1, 2, 3}};
      EXPECT_EQ(k.compare_volume(s, t), tetrahedron);
      EXPECT_EQ(with_filter<roots>{}(p).compare_volume(t, s), -tetrahedron);
      if (rational_lengths(f)) {
        EXPECT_EQ(make_rational_kernel(p).compare_volume(s, t), tetrahedron);
      }
    }
    EXPECT_GE(seen, 30);
  }
}

TEST(Volume, TheReflexSplitOfASaddleIsTheSmaller) {
  dice r(1300);
  int saddles = 0;
  for (int round = 0; round < 500 && saddles < 60; ++round) {
    const random_corner x = make_corner(r, 4);
    const auto k = make_sqrt_kernel(x.p);
    std::vector<split_tree> trees;
    try {
      trees = splitter<sqrt_kernel>(k, x.c).all();
    } catch (const degenerate_error&) {
      continue;  // S = 0
    }
    ASSERT_FALSE(trees.empty());
    if (trees.size() != 2) continue;
    ++saddles;
    ASSERT_NE(trees[0].convex_edges(), trees[1].convex_edges());
    if (trees[0].convex_edges() == 0) std::swap(trees[0], trees[1]);
    EXPECT_EQ(k.compare_volume(triangles(trees[1]), triangles(trees[0])), sign::negative);
    const splitter<sqrt_kernel> split(k, x.c);
    EXPECT_EQ(split.best(split_preference::min_volume)->convex_edges(), 0);
    EXPECT_EQ(split.best(split_preference::max_volume)->convex_edges(), 1);
  }
  EXPECT_GE(saddles, 20);
}

TEST(Angle, SortsLikeTheArcCosine) {
  for (const family f : {family::small, family::pythagorean, family::symmetric, family::long_normals}) {
    SCOPED_TRACE(trace(f));
    dice r(1400 + static_cast<std::uint64_t>(f));
    const planes p = random_planes(f, 14, r);
    const auto k = make_sqrt_kernel(p);
    const auto machine = make_double_kernel(p);
    const auto angle = [&](plane_id a, plane_id b) {
      const auto real = [](const integer& x) { return to_double(x, 0); };
      return std::acos(
          std::clamp(real(dot(p[a].n, p[b].n)) / std::sqrt(real(dot(p[a].n, p[a].n))) / std::sqrt(real(dot(p[b].n, p[b].n))), -1.0, 1.0));
    };
    for (int i = 0; i < 2000; ++i) {
      const quadruple q = r.distinct<4>(14);
      const double difference = angle(q[0], q[1]) - angle(q[2], q[3]);
      const sign s = k.compare(k.bisector(q[0], q[1]), k.bisector(q[2], q[3]));
      if (std::abs(difference) > 1e-6) {
        EXPECT_EQ(s, signed_if(difference > 0));
        EXPECT_EQ(machine.compare(machine.bisector(q[0], q[1]), machine.bisector(q[2], q[3])), s);
      }
      if (s == sign::zero) {
        EXPECT_LT(std::abs(difference), 1e-6);
      }
      EXPECT_EQ(k.compare(k.bisector(q[0], q[1]), k.bisector(q[1], q[0])), sign::zero);
    }
  }
}

}  // namespace
}  // namespace osteon::laws
