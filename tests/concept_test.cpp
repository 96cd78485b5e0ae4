// SPDX-License-Identifier: MIT

// The concept `kernel` is what the algorithms use, no more and no less. Here: types that miss one clause are no kernels, in
// the plane and in space. That the algorithms need no more show archetype_test.cpp and planar_archetype_test.cpp.

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <span>

#include "archetype.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"

namespace osteon {
namespace {

using test::archetype;
using test::weakest;

static_assert(kernel<weakest<2>, 2> && kernel<archetype<2, false>, 2>);
static_assert(kernel<weakest<3>, 3> && kernel<archetype<3, false>, 3>);
static_assert(!kernel<weakest<2>, 3> && !kernel<weakest<3>, 2> && !kernel<weakest<2>, 4>);
static_assert(!perturbed_kernel<weakest<2>, 2> && !perturbed_kernel<weakest<3>, 3> && !limit_kernel<weakest<2>>);

// ---- near misses, one per clause. Each hides one member of the archetype, in which a reader finds what is wrong. Those that
// concern planes one by one have the member for lines and for planes.

template <int D>
struct exact_is_no_bool : weakest<D> {
  struct text {};
  static constexpr text exact{};
};
template <int D>
struct without_exact : weakest<D> {
 private:
  using weakest<D>::exact;
};
template <int D>
struct without_meeting : weakest<D> {
 private:
  using typename weakest<D>::meeting;
};
template <int D>
struct meeting_cannot_be_copied : weakest<D> {
  struct meeting {
    meeting(const meeting&) = delete;
  };
};
template <int D>
struct size_is_unsigned : weakest<D> {
  unsigned size() const;
};
template <int D>
struct size_of_a_variable : weakest<D> {
  plane_id size();
};
template <int D>
struct meet_always_meets : weakest<D> {
  typename weakest<D>::meeting meet(const meeting_planes<D>&) const;
};
template <int D>
struct meet_of_a_corner : weakest<D> {
  std::optional<typename weakest<D>::meeting> meet(const corner_planes<D>&) const;
};
template <int D>
struct meet_of_planes_apart : weakest<D> {
  std::optional<typename weakest<D>::meeting> meet(plane_id, plane_id, plane_id) const;
  std::optional<typename weakest<D>::meeting> meet(plane_id, plane_id, plane_id, plane_id) const;
};
template <int D>
struct planes_are_a_corner : weakest<D> {
  corner_planes<D> planes(const typename weakest<D>::meeting&) const;
};
template <int D>
struct closing_is_bool : weakest<D> {
  bool closing(const typename weakest<D>::meeting&) const;
};
template <int D>
struct closing_changes_the_meeting : weakest<D> {
  sign closing(typename weakest<D>::meeting&) const;
};
template <int D>
struct start_may_be_missing : weakest<D> {
  std::optional<typename weakest<D>::meeting> start() const;
};
template <int D>
struct compare_is_bool : weakest<D> {
  using weakest<D>::compare;
  bool compare(const typename weakest<D>::meeting&, const typename weakest<D>::meeting&) const;
};
template <int D>
struct compares_no_meetings : weakest<D> {
  template <class Bisector>
  sign compare(const Bisector&, const Bisector&) const requires(!std::same_as<Bisector, typename weakest<D>::meeting>);
};
template <int D>
struct orientation_is_int : weakest<D> {
  int orientation(plane_id, plane_id) const;
  int orientation(plane_id, plane_id, plane_id) const;
};
template <int D>
struct orientation_may_be_open : weakest<D> {
  std::optional<sign> orientation(plane_id, plane_id) const;
  std::optional<sign> orientation(plane_id, plane_id, plane_id) const;
};
template <int D>
struct orientation_of_a_meeting : weakest<D> {
  sign orientation(const meeting_planes<D>&) const;
};
template <int D>
struct transversal_is_a_sign : weakest<D> {
  sign transversal(plane_id, plane_id) const;
  sign transversal(plane_id, plane_id, plane_id) const;
};
template <int D>
struct without_transversal : weakest<D> {
 private:
  using weakest<D>::transversal;
};
template <int D>
struct side_is_int : weakest<D> {
  int side(plane_id, plane_id, plane_id, const typename weakest<D>::meeting&) const;
  int side(plane_id, plane_id, plane_id, plane_id, const typename weakest<D>::meeting&) const;
};
template <int D>
struct side_at_no_moment : weakest<D> {
  sign side(plane_id, plane_id, plane_id) const;
  sign side(plane_id, plane_id, plane_id, plane_id) const;
};

template <int D>
inline constexpr bool all_miss =
    !(kernel<int, D> || kernel<exact_is_no_bool<D>, D> || kernel<without_exact<D>, D> || kernel<without_meeting<D>, D> ||
      kernel<meeting_cannot_be_copied<D>, D> || kernel<size_is_unsigned<D>, D> || kernel<size_of_a_variable<D>, D> ||
      kernel<meet_always_meets<D>, D> || kernel<meet_of_a_corner<D>, D> || kernel<meet_of_planes_apart<D>, D> || kernel<planes_are_a_corner<D>, D> ||
      kernel<closing_is_bool<D>, D> || kernel<closing_changes_the_meeting<D>, D> || kernel<start_may_be_missing<D>, D> ||
      kernel<compare_is_bool<D>, D> || kernel<compares_no_meetings<D>, D> || kernel<orientation_is_int<D>, D> ||
      kernel<orientation_may_be_open<D>, D> || kernel<orientation_of_a_meeting<D>, D> || kernel<transversal_is_a_sign<D>, D> ||
      kernel<without_transversal<D>, D> || kernel<side_is_int<D>, D> || kernel<side_at_no_moment<D>, D>);
static_assert(all_miss<2> && all_miss<3>);

// ---- clauses of space alone

using bisector_type = weakest<3>::bisector_type;
struct without_bisector_type : weakest<3> {
 private:
  using weakest<3>::bisector_type;
};
struct compares_no_bisectors : weakest<3> {
  sign compare(const meeting&, const meeting&) const;
};
struct compares_bisectors_as_bool : weakest<3> {
  sign compare(const meeting&, const meeting&) const;
  bool compare(const bisector_type&, const bisector_type&) const;
};
struct bisector_is_a_pointer : weakest<3> {
  const bisector_type* bisector(plane_id, plane_id) const;
};
struct compare_volume_is_a_number : weakest<3> {
  double compare_volume(std::span<const triple>, std::span<const triple>) const;
};
struct compare_volume_changes_the_tree : weakest<3> {
  sign compare_volume(std::span<triple>, std::span<triple>) const;
};

template <class... Types>
inline constexpr bool none_is_a_kernel_of_space = (!kernel<Types, 3> && ...);
static_assert(none_is_a_kernel_of_space<without_bisector_type, compares_no_bisectors, compares_bisectors_as_bool, bisector_is_a_pointer,
                                        compare_volume_is_a_number, compare_volume_changes_the_tree>);

// The hiding as such is not what fails.
template <int D>
struct hides_nothing_wrong : weakest<D> {
  using meeting = typename weakest<D>::meeting;
  using weakest<D>::compare;
  plane_id size() const;
  std::optional<meeting> meet(const meeting_planes<D>&) const;
  meeting_planes<D> planes(const meeting&) const;
  sign closing(const meeting&) const;
  meeting start() const;
  sign compare(const meeting&, const meeting&) const;
  sign orientation(plane_id, plane_id) const;
  sign orientation(plane_id, plane_id, plane_id) const;
  bool transversal(plane_id, plane_id) const;
  bool transversal(plane_id, plane_id, plane_id) const;
  sign side(plane_id, plane_id, plane_id, const meeting&) const;
  sign side(plane_id, plane_id, plane_id, plane_id, const meeting&) const;
};
static_assert(kernel<hides_nothing_wrong<2>, 2> && kernel<hides_nothing_wrong<3>, 3>);

// ---- kernels that break ties, and that know limits

template <int D>
struct tie_breaker : hides_nothing_wrong<D> {
  static constexpr bool breaks_ties = true;
  const weakest<D>& base() const;
};
template <int D>
struct breaks_no_ties : tie_breaker<D> {
  static constexpr bool breaks_ties = false;
};
template <int D>
struct base_is_no_kernel : tie_breaker<D> {
  int base() const;
};
template <int D>
struct base_of_the_other_dimension : tie_breaker<D> {
  const weakest<5 - D>& base() const;
};
template <int D>
struct without_breaks_ties : hides_nothing_wrong<D> {
  const weakest<D>& base() const;
};
template <int D>
inline constexpr bool only_the_first_breaks_ties =
    perturbed_kernel<tie_breaker<D>, D> && !perturbed_kernel<breaks_no_ties<D>, D> && !perturbed_kernel<base_is_no_kernel<D>, D> &&
    !perturbed_kernel<base_of_the_other_dimension<D>, D> && !perturbed_kernel<without_breaks_ties<D>, D>;
static_assert(only_the_first_breaks_ties<2> && only_the_first_breaks_ties<3>);

struct knows_limits : hides_nothing_wrong<2> {
  bool has_moment(const meeting&) const;
  bool is_never(const meeting&) const;
  bool same_moment(const meeting&, const meeting&) const;
  bool touches(line_id, line_id, line_id, const meeting&) const;
};
struct has_moment_is_a_sign : knows_limits {
  sign has_moment(const meeting&) const;
};
struct without_never : knows_limits {
 private:
  using knows_limits::is_never;
};
struct same_moment_of_one : knows_limits {
  bool same_moment(const meeting&) const;
};
struct touches_at_no_moment : knows_limits {
  bool touches(line_id, line_id, line_id) const;
};
static_assert(limit_kernel<knows_limits> && !limit_kernel<has_moment_is_a_sign> && !limit_kernel<without_never> &&
              !limit_kernel<same_moment_of_one> && !limit_kernel<touches_at_no_moment>);

// ---- the graded archetype: what the adaptors need. They keep a kernel, so it can be moved.

template <int D>
struct graded_archetype {
  static constexpr bool exact = true;
  static constexpr int dimension = D;
  using corner = corner_planes<D>;
  using support = meeting_planes<D>;
  using meeting = typename weakest<D>::meeting;
  using bisector_type = osteon::bisector_type;

  graded_archetype() = delete;
  graded_archetype(graded_archetype&&) = default;

  plane_id size() const;
  sign orientation(plane_id, plane_id) const requires(D == 2);
  sign orientation(plane_id, plane_id, plane_id) const requires(D == 3);
  bool transversal(plane_id, plane_id) const requires(D == 2);
  bool transversal(plane_id, plane_id, plane_id) const requires(D == 3);
  std::optional<meeting> meet(const support&) const;
  support planes(const meeting&) const;
  sign closing(const meeting&) const;
  meeting start() const;
  sign compare(const meeting&, const meeting&) const;
  sign side(plane_id, plane_id, plane_id, const meeting&) const requires(D == 2);
  sign side(plane_id, plane_id, plane_id, plane_id, const meeting&) const requires(D == 3);
  bisector_type bisector(plane_id, plane_id) const;
  sign compare(const bisector_type&, const bisector_type&) const;
  sign compare_volume(std::span<const triple>, std::span<const triple>) const;
  sign orientation_at(int, const corner&) const;
  sign offset_at(int, const support&) const;
  sign closing_at(int, const support&) const;
  sign cross_at(int, const support&, const support&) const;
  meeting meeting_of(const support&) const;
};

template <int D>
struct without_offset : graded_archetype<D> {
 private:
  using graded_archetype<D>::offset_at;
};
template <int D>
struct closing_at_may_be_open : graded_archetype<D> {
  std::optional<sign> closing_at(int, const meeting_planes<D>&) const;
};
template <int D>
struct meeting_of_may_be_missing : graded_archetype<D> {
  std::optional<typename weakest<D>::meeting> meeting_of(const meeting_planes<D>&) const;
};
template <int D>
struct cross_of_one : graded_archetype<D> {
  sign cross_at(int, const meeting_planes<D>&) const;
};
template <int D>
struct orientation_at_is_int : graded_archetype<D> {
  int orientation_at(int, const corner_planes<D>&) const;
};
template <template <int> class Type, int D>
inline constexpr bool is_ungraded_kernel = kernel<Type<D>, D> && !graded_kernel<Type<D>>;
template <int D>
inline constexpr bool adaptors_need_grades =
    graded_kernel<graded_archetype<D>>&& graded_kernel<filtered<graded_archetype<D>>>&& kernel<perturbed<graded_archetype<D>>, D>&&
        kernel<perturbed<filtered<graded_archetype<D>>>, D>&& perturbed_kernel<perturbed<graded_archetype<D>>, D> &&
    !graded_kernel<perturbed<graded_archetype<D>>> && is_ungraded_kernel<without_offset, D> && is_ungraded_kernel<closing_at_may_be_open, D> &&
    is_ungraded_kernel<meeting_of_may_be_missing, D> && is_ungraded_kernel<cross_of_one, D> && is_ungraded_kernel<orientation_at_is_int, D>;
static_assert(adaptors_need_grades<2> && adaptors_need_grades<3>);
static_assert(!graded_kernel<weakest<2>> && !graded_kernel<weakest<3>>);
static_assert(limit_kernel<perturbed<graded_archetype<2>>> && !limit_kernel<graded_archetype<2>>);

// The checks are made by the compiler.
TEST(Concept, IsCheckedAtCompileTime) { SUCCEED(); }

}  // namespace
}  // namespace osteon
