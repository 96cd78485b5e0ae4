// SPDX-License-Identifier: MIT
// The concept `kernel` is what the algorithms use, no more and no less: an archetype that satisfies it and can do nothing
// else compiles with all of them, and types that miss one clause do not satisfy it.
#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/space/boundary.hpp"
#include "osteon/space/propagate.hpp"
#include "osteon/space/split.hpp"

namespace osteon {
namespace {

// Converts to Target and does nothing else.
template <class Target>
struct convertible {
  Target value;
  constexpr operator Target() const { return value; }  // NOLINT(google-explicit-constructor): that is all it has
  convertible& operator=(const convertible&) = delete;
};

// Always the same answer. No default constructor, no copies, no comparison of meetings, nothing beyond the concept.
template <bool IsExact>
struct archetype {
  static constexpr convertible<bool> exact{IsExact};

  // Meetings are kept in queues and optionals, so they can be copied; they cannot be made, compared or hashed.
  struct meeting {
    meeting() = delete;
    meeting(const meeting&) = default;
    meeting(meeting&&) = default;
    meeting& operator=(const meeting&) = default;
    meeting& operator=(meeting&&) = default;
    ~meeting() = default;
    void operator&() const = delete;
    template <class T>
    void operator,(T&&) const = delete;

   private:
    friend archetype;
    explicit meeting(const quadruple& q) : planes(q) {}
    quadruple planes;
  };

  // Bisectors are compared where they are made.
  struct bisector_type {
    bisector_type() = delete;
    bisector_type(const bisector_type&) = delete;
    bisector_type& operator=(const bisector_type&) = delete;
    ~bisector_type() = default;

   private:
    friend archetype;
    explicit bisector_type(int) {}
  };

  archetype() = delete;
  explicit archetype(sign s) : answer(s) {}
  archetype(const archetype&) = delete;
  archetype& operator=(const archetype&) = delete;
  ~archetype() = default;

  plane_id size() const { return 0; }
  sign orientation(plane_id, plane_id, plane_id) const { return answer; }
  bool transversal(plane_id, plane_id, plane_id) const { return true; }
  std::optional<meeting> meet(const quadruple& q) const { return meeting(q); }
  const quadruple& planes(const meeting& m) const { return m.planes; }
  sign closing(const meeting&) const { return answer; }
  meeting start() const { return meeting({-1, -1, -1, -1}); }
  sign compare(const meeting&, const meeting&) const { return answer; }
  sign side(plane_id, plane_id, plane_id, plane_id, const meeting&) const { return answer; }
  bisector_type bisector(plane_id, plane_id) const { return bisector_type(0); }
  sign compare(const bisector_type&, const bisector_type&) const { return answer; }
  sign compare_volume(std::span<const triple>, std::span<const triple>) const { return answer; }

 private:
  sign answer;
};

using weakest = archetype<true>;
static_assert(kernel<weakest, 3>);
static_assert(kernel<archetype<false>, 3>);
static_assert(!graded_kernel<weakest>);

// ---- near misses, one per clause. Each hides one member of the archetype, in which a reader finds what is wrong.

struct exact_is_no_bool : weakest {
  struct text {};
  static constexpr text exact{};
};
struct without_exact : weakest {
 private:
  using weakest::exact;
};
struct without_meeting : weakest {
 private:
  using weakest::meeting;
};
struct without_bisector_type : weakest {
 private:
  using weakest::bisector_type;
};
struct size_is_unsigned : weakest {
  unsigned size() const;
};
struct size_of_a_variable : weakest {
  plane_id size();
};
struct orientation_is_int : weakest {
  int orientation(plane_id, plane_id, plane_id) const;
};
struct orientation_may_be_open : weakest {
  std::optional<sign> orientation(plane_id, plane_id, plane_id) const;
};
struct orientation_of_two : weakest {
  sign orientation(plane_id, plane_id) const;
};
struct transversal_is_a_sign : weakest {
  sign transversal(plane_id, plane_id, plane_id) const;
};
struct without_transversal : weakest {
 private:
  using weakest::transversal;
};
struct meet_always_meets : weakest {
  meeting meet(const quadruple&) const;
};
struct meet_of_four : weakest {
  std::optional<meeting> meet(plane_id, plane_id, plane_id, plane_id) const;
};
struct planes_is_a_triple : weakest {
  triple planes(const meeting&) const;
};
struct closing_is_bool : weakest {
  bool closing(const meeting&) const;
};
struct closing_changes_the_meeting : weakest {
  sign closing(meeting&) const;
};
struct start_may_be_missing : weakest {
  std::optional<meeting> start() const;
};
struct compare_is_bool : weakest {
  bool compare(const meeting&, const meeting&) const;
  sign compare(const bisector_type&, const bisector_type&) const;
};
struct compares_no_meetings : weakest {
  sign compare(const bisector_type&, const bisector_type&) const;
};
struct compares_no_bisectors : weakest {
  sign compare(const meeting&, const meeting&) const;
};
struct compares_bisectors_as_bool : weakest {
  sign compare(const meeting&, const meeting&) const;
  bool compare(const bisector_type&, const bisector_type&) const;
};
struct side_is_int : weakest {
  int side(plane_id, plane_id, plane_id, plane_id, const meeting&) const;
};
struct side_at_no_moment : weakest {
  sign side(plane_id, plane_id, plane_id, plane_id) const;
};
struct bisector_is_a_pointer : weakest {
  const bisector_type* bisector(plane_id, plane_id) const;
};
struct compare_volume_is_a_number : weakest {
  double compare_volume(std::span<const triple>, std::span<const triple>) const;
};
struct compare_volume_changes_the_tree : weakest {
  sign compare_volume(std::span<triple>, std::span<triple>) const;
};

template <class... Types>
inline constexpr bool none_is_a_kernel = (!kernel<Types, 3> && ...);

static_assert(none_is_a_kernel<int, exact_is_no_bool, without_exact, without_meeting, without_bisector_type, size_is_unsigned, size_of_a_variable,
                               orientation_is_int, orientation_may_be_open, orientation_of_two, transversal_is_a_sign, without_transversal,
                               meet_always_meets, meet_of_four, planes_is_a_triple, closing_is_bool, closing_changes_the_meeting,
                               start_may_be_missing, compare_is_bool, compares_no_meetings, compares_no_bisectors, compares_bisectors_as_bool,
                               side_is_int, side_at_no_moment, bisector_is_a_pointer, compare_volume_is_a_number, compare_volume_changes_the_tree>);

// The hiding as such is not what fails.
struct hides_nothing_wrong : weakest {
  sign orientation(plane_id, plane_id, plane_id) const;
  std::optional<meeting> meet(const quadruple&) const;
};
static_assert(kernel<hides_nothing_wrong, 3>);

// ---- the graded archetype: what the adaptors need. They keep a kernel, so it can be moved.

struct graded_archetype {
  static constexpr bool exact = true;
  static constexpr int dimension = 3;
  using meeting = weakest::meeting;
  using bisector_type = weakest::bisector_type;

  graded_archetype() = delete;
  graded_archetype(graded_archetype&&) = default;

  plane_id size() const;
  sign orientation(plane_id, plane_id, plane_id) const;
  bool transversal(plane_id, plane_id, plane_id) const;
  std::optional<meeting> meet(const quadruple&) const;
  quadruple planes(const meeting&) const;
  sign closing(const meeting&) const;
  meeting start() const;
  sign compare(const meeting&, const meeting&) const;
  sign side(plane_id, plane_id, plane_id, plane_id, const meeting&) const;
  bisector_type bisector(plane_id, plane_id) const;
  sign compare(const bisector_type&, const bisector_type&) const;
  sign compare_volume(std::span<const triple>, std::span<const triple>) const;
  sign orientation_at(int, const triple&) const;
  sign offset_at(int, const quadruple&) const;
  sign closing_at(int, const quadruple&) const;
  sign cross_at(int, const quadruple&, const quadruple&) const;
  meeting meeting_of(const quadruple&) const;
};
static_assert(graded_kernel<graded_archetype>);
static_assert(graded_kernel<filtered<graded_archetype>>);
static_assert(kernel<perturbed<graded_archetype>, 3>);
static_assert(kernel<perturbed<filtered<graded_archetype>>, 3>);
static_assert(!graded_kernel<perturbed<graded_archetype>>);

struct without_offset : graded_archetype {
 private:
  using graded_archetype::offset_at;
};
struct closing_at_may_be_open : graded_archetype {
  std::optional<sign> closing_at(int, const quadruple&) const;
};
struct meeting_of_may_be_missing : graded_archetype {
  std::optional<meeting> meeting_of(const quadruple&) const;
};
struct cross_of_one : graded_archetype {
  sign cross_at(int, const quadruple&) const;
};
struct orientation_at_is_int : graded_archetype {
  int orientation_at(int, const triple&) const;
};
static_assert(kernel<without_offset, 3> && !graded_kernel<without_offset>);
static_assert(kernel<closing_at_may_be_open, 3> && !graded_kernel<closing_at_may_be_open>);
static_assert(kernel<meeting_of_may_be_missing, 3> && !graded_kernel<meeting_of_may_be_missing>);
static_assert(kernel<cross_of_one, 3> && !graded_kernel<cross_of_one>);
static_assert(kernel<orientation_at_is_int, 3> && !graded_kernel<orientation_at_is_int>);

}  // namespace

// ---- every member of every algorithm compiles with the archetype

template class splitter<weakest>;
template class propagation<weakest>;
template skeleton straight_skeleton<weakest>(const weakest&, const boundary&, const skeleton_options&);
template class splitter<archetype<false>>;
template class propagation<archetype<false>>;
template skeleton straight_skeleton<archetype<false>>(const archetype<false>&, const boundary&, const skeleton_options&);

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
  EXPECT_TRUE(straight_skeleton(weakest(sign::positive), boundary{}).nodes.empty());
  EXPECT_TRUE(straight_skeleton(archetype<false>(sign::zero), boundary{}).nodes.empty());
}

// A kernel that always gives one answer contradicts itself; who is to blame depends on what it says of itself.
TEST(Archetype, NonsenseEndsWithTheRightError) {
  for (const sign s : {sign::positive, sign::negative}) {
    EXPECT_THROW(straight_skeleton(weakest(s), one_vertex()), invariant_error);
    EXPECT_THROW(straight_skeleton(archetype<false>(s), one_vertex()), undecided_error);
  }
  EXPECT_THROW(straight_skeleton(weakest(sign::zero), one_vertex()), degenerate_error);
}

}  // namespace
}  // namespace osteon
