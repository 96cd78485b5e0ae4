// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Asks two kernels the same questions.

#include <gtest/gtest.h>

#include <optional>

#include "kernel_planes.hpp"

namespace osteon::laws {

/// The answers of one kernel to some questions.
template <int D, class K>
class questions {
 public:
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;

  questions(const K& k, const planes_in<D>& p, bool common) : k_(k), p_(p), common_(common) {}

  sign orientation(const corner& c) const { return laws::orientation(k_, c); }
  std::optional<sign> closing(const support& q) const {
    const auto m = k_.meet(q);
    return m ? std::optional(k_.closing(*m)) : std::nullopt;
  }
  std::optional<sign> compare(const support& q, const support& r) const {
    const auto m = k_.meet(q);
    const auto n = k_.meet(r);
    return m && n ? std::optional(k_.compare(*m, *n)) : std::nullopt;
  }
  std::optional<sign> after_start(const support& q) const {
    const auto m = k_.meet(q);
    return m ? std::optional(k_.compare(*m, k_.start())) : std::nullopt;
  }
  // Corners made by a perturbation alone are not asked for: the base kernel has no answer.
  std::optional<sign> side(const support& q, const support& r) const {
    const auto m = k_.meet(r);
    if (!m || true_orientation<D>(p_, all_but_last(q)) == sign::zero) return std::nullopt;
    return laws::side(k_, q.back(), all_but_last(q), *m);
  }
  std::optional<sign> side_at_start(const support& q) const {
    if (!common_ || true_orientation<D>(p_, all_but_last(q)) == sign::zero) return std::nullopt;
    return laws::side(k_, q.back(), all_but_last(q), k_.start());
  }
  sign angle(const support& q) const requires(D == 3) { return k_.compare(k_.bisector(q[0], q[1]), k_.bisector(q[2], q[3])); }

 private:
  const K& k_;
  const planes_in<D>& p_;
  bool common_;
};

/// Asks two kernels `count` times; `same(question, answer, answer)` judges each pair of answers.
template <int D, class K, class L, class Same>
void interview(const K& k, const L& l, const planes_in<D>& p, bool common, dice& r, int count, Same same) {
  const questions<D, K> a(k, p, common);
  const questions<D, L> b(l, p, common);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const auto c = r.distinct<D>(k.size());
    const auto q = r.distinct<D + 1>(k.size());
    const auto s = r.distinct<D + 1>(k.size());
    if (sorted(q) == sorted(s)) continue;  // simultaneous whatever the perturbation
    same("orientation", a.orientation(c), b.orientation(c));
    same("closing", a.closing(q), b.closing(q));
    same("start", a.after_start(q), b.after_start(q));
    same("compare", a.compare(q, s), b.compare(q, s));
    same("side", a.side(q, s), b.side(q, s));
    same("side at start", a.side_at_start(q), b.side_at_start(q));
    if constexpr (D == 3) same("angle", a.angle(q), b.angle(q));
  }
}

inline const auto equal = [](const char* what, std::optional<sign> a, std::optional<sign> b) { EXPECT_EQ(a, b) << what; };

/// Asks two graded kernels for random coefficients `count` times; they must be equal.
template <int D, class K, class L>
void agree_at_all_grades(const K& k, const L& l, dice& r, int count) {
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const int grade = r.between(0, highest_grade_in<D>);
    const auto q = r.distinct<D + 1>(k.size());
    const auto s = r.distinct<D + 1>(k.size());
    EXPECT_EQ(k.orientation_at(grade, all_but_last(q)), l.orientation_at(grade, all_but_last(q))) << grade;
    EXPECT_EQ(k.offset_at(grade, q), l.offset_at(grade, q)) << grade;
    EXPECT_EQ(k.closing_at(grade, q), l.closing_at(grade, q)) << grade;
    EXPECT_EQ(k.cross_at(grade, q, s), l.cross_at(grade, q, s)) << grade;
  }
}

}  // namespace osteon::laws
