// SPDX-License-Identifier: MIT

// Every predicate of the exact kernels, in the plane and in space, with and without filter, against CORE::Expr.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ask.hpp"
#include "core_signs.hpp"
#include "effort.hpp"
#include "hard_planes.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"

namespace osteon::oracles {
namespace {

enum class question : std::uint8_t {
  orientation,
  meet,
  compare,
  compare_with_start,
  side,
  side_at_start,
  bisectors,
  volume,
  orientation_at,
  offset_at,
  closing_at,
  cross_at,
  perturbed_compare,
  perturbed_side,
  number
};
constexpr std::array<std::string_view, static_cast<std::size_t>(question::number)> question_names = {
    "orientation", "meet",           "compare",   "compare_with_start", "side",     "side_at_start",     "bisectors",
    "volume",      "orientation_at", "offset_at", "closing_at",         "cross_at", "perturbed_compare", "perturbed_side"};

/// Whether a question is one of kernels in this dimension.
constexpr bool is_asked_in(int dimension, question q) { return dimension == 3 || (q != question::bisectors && q != question::volume); }

/// What the filter leaves to the exact kernel.
inline long left_to_the_exact_kernel = 0;

template <int D>
using sqrt_kernel_in = arithmetic_kernel<basic_sqrt_arithmetic<D>>;

/// The square-root kernel, counting.
template <int D>
class watched_kernel : public sqrt_kernel_in<D> {
 public:
  using base_kernel = sqrt_kernel_in<D>;
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;
  explicit watched_kernel(base_kernel k) : base_kernel(std::move(k)) {}

  sign orientation_at(int grade, const corner& c) const { return ++left_to_the_exact_kernel, base_kernel::orientation_at(grade, c); }
  sign offset_at(int grade, const support& q) const { return ++left_to_the_exact_kernel, base_kernel::offset_at(grade, q); }
  sign closing_at(int grade, const support& q) const { return ++left_to_the_exact_kernel, base_kernel::closing_at(grade, q); }
  sign cross_at(int grade, const support& q, const support& r) const { return ++left_to_the_exact_kernel, base_kernel::cross_at(grade, q, r); }
  sign rough_side(plane_id d, const support& q) const requires(D == 3) { return ++left_to_the_exact_kernel, base_kernel::rough_side(d, q); }
};

struct tally {
  long asked = 0;
  long zero = 0;
};

/// Asks all kernels and the oracle about one set of planes.
template <int D>
class examination {
 public:
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;

  examination(const plane_set<D>& set, std::uint64_t seed)
      : set_(set),
        roll_(seed),
        exact_(make_sqrt_kernel(std::span<const moving_plane<integer, D>>(set.planes))),
        quick_(set.planes, watched_kernel<D>(make_sqrt_kernel(std::span<const moving_plane<integer, D>>(set.planes)))),
        tilted_(quick_),
        oracle_(set.planes) {}

  /// One question. False where it cannot be asked of the planes drawn for it.
  bool ask(question what, tally& t) {
    const auto answer = dispatch(what);
    if (!answer) return false;
    ++t.asked;
    t.zero += *answer == sign::zero ? 1 : 0;
    return true;
  }

 private:
  template <std::size_t N>
  std::array<plane_id, N> draw() {
    std::array<plane_id, N> result{};
    for (std::size_t i = 0; i < N;) {
      result[i] = static_cast<plane_id>(roll_.between(0, static_cast<long>(set_.planes.size()) - 1));
      if (std::find(result.begin(), result.begin() + i, result[i]) == result.begin() + i) ++i;
    }
    return result;
  }

  plane_id twin(plane_id i) const { return set_.twins[static_cast<std::size_t>(i)]; }

  // Any planes, or for each plane of q itself or its twin, or all their twins, in any order.
  support draw_near(const support& q) {
    const long kind = roll_.between(0, 3);
    support result = draw<D + 1>();
    if (kind == 0 || twin(q[0]) == q[0]) return result;
    for (std::size_t i = 0; i <= D; ++i) result[i] = kind == 1 || roll_.between(0, 1) == 0 ? twin(q[i]) : q[i];
    if (repeats(result)) return draw<D + 1>();
    for (std::size_t i = D + 1; i-- > 1;) std::swap(result[i], result[static_cast<std::size_t>(roll_.between(0, static_cast<long>(i)))]);
    return result;
  }

  // Of each pair of twins the first one, where that leaves enough planes; half of the time.
  support maybe_first_twins(const support& q) {
    if (roll_.between(0, 1) == 0) return q;
    support result{};
    for (std::size_t i = 0; i <= D; ++i) result[i] = std::min(q[i], twin(q[i]));
    return repeats(result) ? q : result;
  }

  static bool repeats(const support& q) {
    const support s = sorted(q);
    return std::adjacent_find(s.begin(), s.end()) != s.end();
  }

  // Triangles sorted, each with its smallest plane first.
  std::vector<triple> random_triangulation(const std::vector<plane_id>& cycle) {
    std::vector<plane_id> rest = cycle;
    std::vector<triple> result;
    while (rest.size() > 2) {
      const auto n = rest.size();
      const auto ear = static_cast<std::size_t>(roll_.between(0, static_cast<long>(n) - 1));
      triple t = {rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.push_back(t);
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  template <std::size_t... N>
  std::string describe(const std::string& what, const std::array<plane_id, N>&... groups) const {
    std::ostringstream out;
    out << what << "\n";
    const auto show = [&](const auto& group) {
      for (const plane_id i : group) {
        if (i < 0) continue;
        const auto& p = set_.planes[static_cast<std::size_t>(i)];
        out << "  plane " << i << ": n =";
        for (const integer& x : p.n) out << " " << x;
        out << ", d = " << p.d << ", weight " << p.weight << "\n";
      }
      out << "\n";
    };
    (show(groups), ...);
    return out.str();
  }

  template <std::size_t... N>
  sign check(const std::string& what, sign truth, sign unfiltered, sign with_filter, const std::array<plane_id, N>&... groups) const {
    if (unfiltered != truth || with_filter != truth)
      ADD_FAILURE() << describe(what, groups...) << "CORE " << static_cast<int>(truth) << ", sqrt " << static_cast<int>(unfiltered) << ", filtered "
                    << static_cast<int>(with_filter);
    return truth;
  }

  std::optional<sign> dispatch(question what) {
    const support q = maybe_first_twins(draw<D + 1>());
    const support r = draw_near(q);
    const corner c = all_but_last(r);
    const plane_id last = r.back();
    const auto grade = [this](int most) { return static_cast<int>(roll_.between(0, most)); };
    switch (what) {
      case question::orientation: {
        const sign truth = oracle_.orientation(c);
        EXPECT_EQ(transversal(exact_, c), truth != sign::zero) << describe("transversal", c);
        return check("orientation", truth, orientation(exact_, c), orientation(quick_, c), c);
      }
      case question::meet: {
        const auto m = exact_.meet(r);
        const auto n = quick_.meet(r);
        EXPECT_TRUE(!m || exact_.planes(*m) == sorted(r)) << describe("planes", r);
        return check("closing", oracle_.closing(sorted(r)), m ? exact_.closing(*m) : sign::zero, n ? quick_.closing(*n) : sign::zero, sorted(r));
      }
      case question::compare: {
        if (oracle_.closing(q) == sign::zero || oracle_.closing(r) == sign::zero) return std::nullopt;
        return check("compare", oracle_.compare(q, r), exact_.compare(exact_.meeting_of(q), exact_.meeting_of(r)),
                     quick_.compare(quick_.meeting_of(q), quick_.meeting_of(r)), q, r);
      }
      case question::compare_with_start: {
        if (oracle_.closing(r) == sign::zero) return std::nullopt;
        return check("compare with start", oracle_.compare_with_start(r), -exact_.compare(exact_.start(), exact_.meeting_of(r)),
                     quick_.compare(quick_.meeting_of(r), quick_.start()), r);
      }
      case question::side: {
        if (oracle_.closing(q) == sign::zero || oracle_.orientation(c) == sign::zero) return std::nullopt;
        return check("side of the last", oracle_.side(last, c, q), side(exact_, last, c, exact_.meeting_of(q)),
                     side(quick_, last, c, quick_.meeting_of(q)), q, r);
      }
      case question::side_at_start: {
        if (!set_.through_one_point || oracle_.orientation(c) == sign::zero) return std::nullopt;
        return check("side of the last at the start", oracle_.side_at_start(last, c), side(exact_, last, c, exact_.start()),
                     side(quick_, last, c, quick_.start()), r);
      }
      case question::bisectors:
        if constexpr (D == 3)
          return check("compare bisectors", oracle_.compare_angles(q[0], q[1], r[0], r[1]),
                       exact_.compare(exact_.bisector(q[0], q[1]), exact_.bisector(r[0], r[1])),
                       quick_.compare(quick_.bisector(q[0], q[1]), quick_.bisector(r[0], r[1])), q, r);
        break;
      case question::volume:
        if constexpr (D == 3) return set_.through_one_point ? ask_volume() : std::nullopt;
        break;
      case question::orientation_at: {
        const int g = grade(2 * D + 1);
        return check("orientation at grade " + std::to_string(g), oracle_.orientation_at(g, c), exact_.orientation_at(g, c),
                     quick_.orientation_at(g, c), c);
      }
      case question::offset_at: {
        const int g = grade(2 * D + 2);
        return check("offset at grade " + std::to_string(g), oracle_.offset_at(g, r), exact_.offset_at(g, r), quick_.offset_at(g, r), r);
      }
      case question::closing_at: {
        const int g = grade(2 * D + 1);
        return check("closing at grade " + std::to_string(g), oracle_.closing_at(g, r), exact_.closing_at(g, r), quick_.closing_at(g, r), r);
      }
      case question::cross_at: {
        const int g = grade(highest_grade_in<D>);
        return check("cross at grade " + std::to_string(g), oracle_.cross_at(g, q, r), exact_.cross_at(g, q, r), quick_.cross_at(g, q, r), q, r);
      }
      case question::perturbed_compare: {
        if (sorted(q) == sorted(r)) return std::nullopt;
        const sign truth = leading([&](int g) { return oracle_.cross_at(g, q, r); }) * closing(q) * closing(r);
        const sign answer = tilted_.compare(*tilted_.meet(q), *tilted_.meet(r));
        return check("compare, perturbed", truth, answer, answer, q, r);
      }
      case question::perturbed_side: {
        if (sorted(q) == sorted(r)) return std::nullopt;
        const sign truth =
            leading([&](int g) { return oracle_.cross_at(g, r, q); }) * closing(q) * leading([&](int g) { return oracle_.orientation_at(g, c); });
        const sign answer = side(tilted_, last, c, *tilted_.meet(q));
        return check("side of the last, perturbed", truth, answer, answer, q, r);
      }
      case question::number:
        break;
    }
    return std::nullopt;
  }

  template <class Coefficient>
  static sign leading(Coefficient coefficient) {
    for (int g = 0; g <= highest_grade_in<D>; ++g)
      if (const sign s = coefficient(g); s != sign::zero) return s;
    return sign::zero;
  }
  sign closing(const support& q) const {
    return leading([&](int g) { return oracle_.closing_at(g, q); });
  }

  std::optional<sign> ask_volume() requires(D == 3) {
    const auto five = draw<5>();
    std::vector<plane_id> cycle(five.begin(), five.begin() + roll_.between(4, 5));
    if (roll_.between(0, 2) == 0) cycle = {0, 1, 3, 2};  // where there is a cone, it begins with these
    const auto s = random_triangulation(cycle);
    auto t = random_triangulation(cycle);
    while (t == s) t = random_triangulation(cycle);
    for (const auto& tree : {s, t})
      for (const auto& c : tree)
        if (oracle_.orientation(c) == sign::zero) return std::nullopt;
    const auto truth = oracle_.compare_volume(s, t);
    if (!truth) return std::nullopt;
    return check("compare volume of two triangulations", *truth, exact_.compare_volume(s, t), quick_.compare_volume(s, t), flat(s), flat(t));
  }

  // Three triangles at most, as many planes.
  static std::array<plane_id, 9> flat(const std::vector<triple>& tree) {
    std::array<plane_id, 9> result{};
    result.fill(-1);
    for (std::size_t i = 0; i < 3 * tree.size(); ++i) result[i] = tree[i / 3][i % 3];
    return result;
  }

  const plane_set<D>& set_;
  random_stream roll_;
  sqrt_kernel_in<D> exact_;
  filtered<watched_kernel<D>> quick_;
  perturbed<filtered<watched_kernel<D>>> tilted_;
  core_signs<D> oracle_;
};

// How often each question is asked, in hundredths; of kernels that do not know it, another one instead.
question draw_question(int dimension, bool through_one_point, long percent) {
  static constexpr std::array<std::pair<long, question>, 12> usual = {{{6, question::orientation},
                                                                       {18, question::meet},
                                                                       {42, question::compare},
                                                                       {47, question::compare_with_start},
                                                                       {72, question::side},
                                                                       {80, question::bisectors},
                                                                       {83, question::orientation_at},
                                                                       {86, question::offset_at},
                                                                       {89, question::closing_at},
                                                                       {96, question::cross_at},
                                                                       {98, question::perturbed_compare},
                                                                       {100, question::perturbed_side}}};
  const auto known = [dimension](question q, question instead) { return is_asked_in(dimension, q) ? q : instead; };
  if (through_one_point)
    return percent < 40 ? question::side_at_start : (percent < 75 ? known(question::volume, question::side_at_start) : question::closing_at);
  for (const auto& [below, q] : usual)
    if (percent < below) return known(q, question::cross_at);
  return question::side;
}

constexpr long questions_per_set = 40;

template <int D>
void examine(int first_family, int families, long total, std::uint64_t stream) {
  std::array<std::array<tally, static_cast<std::size_t>(question::number)>, all_families> tallies{};
  std::array<double, all_families> seconds{};
  left_to_the_exact_kernel = 0;
  const std::uint64_t start = seed() + stream;
  long asked = 0;
  for (std::uint64_t set = 0; asked < total; ++set) {
    const int f = first_family + static_cast<int>(set % static_cast<std::uint64_t>(families));
    const std::uint64_t set_seed = start + set * 7919;
    SCOPED_TRACE(std::string("family ") + std::string(family_names[static_cast<std::size_t>(f)]) + ", set " + std::to_string(set) +
                 ", OSTEON_ORACLE_SEED=" + std::to_string(seed()));
    const auto before = std::chrono::steady_clock::now();
    const bool through_one_point = set / static_cast<std::uint64_t>(families) % 6 == 5;
    const plane_set<D> planes = plane_maker<D>(static_cast<family>(f), set_seed).make(through_one_point);
    examination<D> e(planes, ~set_seed);
    random_stream choose(set_seed ^ 0x5555U);
    for (long i = 0; i < questions_per_set && asked < total; ++i) {
      const question what = draw_question(D, through_one_point, choose.between(0, 99));
      if (e.ask(what, tallies[static_cast<std::size_t>(f)][static_cast<std::size_t>(what)])) ++asked;
    }
    seconds[static_cast<std::size_t>(f)] += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    if (testing::Test::HasFailure()) break;  // one set with its seed is enough
  }
  double all_seconds = 0;
  for (const double s : seconds) all_seconds += s;
  std::cout << "seed " << seed() << ": " << asked << " questions in " << all_seconds << " s; the filter left " << left_to_the_exact_kernel
            << " to the exact kernel\n";
  for (int f = first_family; f < first_family + families; ++f) {
    std::cout << family_names[static_cast<std::size_t>(f)] << " (" << seconds[static_cast<std::size_t>(f)] << " s):";
    for (std::size_t q = 0; q < question_names.size(); ++q)
      if (const auto& t = tallies[static_cast<std::size_t>(f)][q]; t.asked > 0)
        std::cout << " " << question_names[q] << " " << t.asked << " (" << t.zero << " zero)";
    std::cout << "\n";
  }
  if (testing::Test::HasFailure()) return;
  for (std::size_t q = 0; q < question_names.size(); ++q) {
    if (!is_asked_in(D, static_cast<question>(q))) continue;
    tally all;
    for (const auto& t : tallies) all.asked += t[q].asked, all.zero += t[q].zero;
    EXPECT_GT(all.asked, 0) << question_names[q] << " was never asked";
    // What is made to be zero must be zero often enough; a moment after the start and perturbed planes know no ties.
    const auto what = static_cast<question>(q);
    const bool strict = what == question::compare_with_start || what == question::perturbed_compare || what == question::perturbed_side;
    if (strict) {
      EXPECT_EQ(all.zero, 0) << question_names[q];
    } else if (first_family >= random_families) {
      EXPECT_GT(all.zero * 50, all.asked) << question_names[q] << " was hardly ever zero";
    }
  }
}

TEST(CoreExpr, RandomPlanes) { examine<3>(0, random_families, effort(20'000L, 1'000'000L), 0); }
TEST(CoreExpr, AdversarialPlanes) { examine<3>(random_families, all_families - random_families, effort(2'000L, 100'000L), 1'000'000'007); }
TEST(CoreExpr, RandomLines) { examine<2>(0, random_families, effort(20'000L, 1'000'000L), 0); }
TEST(CoreExpr, AdversarialLines) { examine<2>(random_families, all_families - random_families, effort(5'000L, 250'000L), 1'000'000'007); }

// The oracle itself, by hand: planes x <= 1, -x <= 1 (twice as fast), y <= 1, z <= 1, and the diagonal x + y + z <= 0.
TEST(CoreExpr, KnowsSimpleAnswersInSpace) {
  const std::vector<moving_plane<integer>> planes = {{{1, 0, 0}, 1, 1}, {{-1, 0, 0}, 1, 2}, {{0, 1, 0}, 1, 1},
                                                     {{0, 0, 1}, 1, 1}, {{1, 1, 1}, 0, 1},  {{-1, -1, -1}, 1, 1}};
  const core_signs<3> core(planes);
  EXPECT_EQ(core.orientation({0, 2, 3}), sign::positive);
  EXPECT_EQ(core.orientation({2, 0, 3}), sign::negative);
  EXPECT_EQ(core.orientation({0, 1, 3}), sign::zero);
  EXPECT_EQ(core.compare({0, 1, 2, 3}, {0, 2, 3, 5}), sign::negative);  // at 2/3 and (3 + 1) / (3 + sqrt 3) = 0.85
  EXPECT_EQ(core.compare_with_start({0, 1, 2, 3}), sign::positive);
  EXPECT_EQ(core.side(5, {0, 2, 3}, {0, 1, 2, 3}), sign::positive);  // (1/3, 1/3, 1/3) there
  EXPECT_EQ(core.side(4, {0, 2, 3}, {0, 1, 2, 3}), sign::negative);
  EXPECT_EQ(core.compare_angles(0, 1, 0, 2), sign::positive);
  // A corner of degree four, symmetric: all splits have the same volume; then one facet leans more.
  const std::vector<moving_plane<integer>> tent = {{{3, 0, 4}, 0, 1}, {{0, 3, 4}, 0, 1}, {{-3, 0, 4}, 0, 1}, {{0, -3, 4}, 0, 1}, {{0, -4, 3}, 0, 1}};
  const std::vector<triple> one = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<triple> other = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(core_signs<3>(tent).compare_volume(one, other), sign::zero);
  // Facet 4 sinks faster along the axis, so the four half-spaces meet in a roof with the ridge between 1 and 4. The other surface, with an
  // edge between 0 and 2, passes through itself and bounds a tetrahedron from inside.
  const std::vector<triple> crossed = {{0, 1, 2}, {0, 2, 4}};
  const std::vector<triple> roof = {{0, 1, 4}, {1, 2, 4}};
  EXPECT_EQ(core_signs<3>(tent).compare_volume(crossed, roof), sign::negative);
}

// Lines x <= 4, -x <= 4 (twice as fast), y <= 3, and the diagonal x + y <= 8.
TEST(CoreExpr, KnowsSimpleAnswersInThePlane) {
  const std::vector<moving_line<integer>> lines = {{{1, 0}, 4, 1}, {{-1, 0}, 4, 2}, {{0, 1}, 3, 1}, {{1, 1}, 8, 1}, {{0, -1}, 3, 0}};
  const core_signs<2> core(lines);
  EXPECT_EQ(core.orientation({0, 2}), sign::positive);
  EXPECT_EQ(core.orientation({2, 0}), sign::negative);
  EXPECT_EQ(core.orientation({0, 1}), sign::zero);
  EXPECT_EQ(core.compare({0, 1, 2}, {0, 1, 3}), sign::zero);      // 0 and 1 meet at 8/3, whoever is with them
  EXPECT_EQ(core.compare({0, 2, 4}, {0, 1, 2}), sign::positive);  // 2 and 4, which stands still, at 6
  EXPECT_EQ(core.compare_with_start({0, 2, 3}), sign::negative);  // at (7 - 8) / (2 - sqrt 2)
  EXPECT_EQ(core.side(3, {0, 2}, {0, 1, 2}), sign::positive);     // (4/3, 1/3) there
  EXPECT_EQ(core.side(1, {0, 2}, {0, 2, 4}), sign::negative);     // (-2, -3) there, and line 1 at 8
  EXPECT_EQ(core.offset_at(0, {0, 1, 2}), core.closing({0, 1, 2}));
}

}  // namespace
}  // namespace osteon::oracles
