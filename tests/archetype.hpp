// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The weakest kernels of the plane and of space: they satisfy the concept `kernel` and can do nothing else.

#include <array>
#include <optional>
#include <span>

#include "osteon/core/kernel.hpp"
#include "osteon/core/sign.hpp"

namespace osteon::test {

/// Converts to Target and does nothing else.
template <class Target>
struct convertible {
  Target value;
  constexpr operator Target() const { return value; }  // NOLINT(google-explicit-constructor): that is all it has
  convertible& operator=(const convertible&) = delete;
};

/// What archetypes of both dimensions have. They always give the same answer. No default constructor, no copies, no
/// comparison of meetings, nothing beyond the concept.
template <int D, bool IsExact>
struct archetype_of_meetings {
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
    friend archetype_of_meetings;
    explicit meeting(const meeting_planes<D>& q) : planes(q) {}
    meeting_planes<D> planes;
  };

  archetype_of_meetings() = delete;
  explicit archetype_of_meetings(sign s) : answer(s) {}
  archetype_of_meetings(const archetype_of_meetings&) = delete;
  archetype_of_meetings& operator=(const archetype_of_meetings&) = delete;
  ~archetype_of_meetings() = default;

  plane_id size() const { return 0; }
  std::optional<meeting> meet(const meeting_planes<D>& q) const { return meeting(q); }
  const meeting_planes<D>& planes(const meeting& m) const { return m.planes; }
  sign closing(const meeting&) const { return answer; }
  meeting start() const {
    meeting_planes<D> none{};
    none.fill(-1);
    return meeting(none);
  }
  sign compare(const meeting&, const meeting&) const { return answer; }

 protected:
  sign answer;
};

template <int D, bool IsExact>
struct archetype;

template <bool IsExact>
struct archetype<2, IsExact> : archetype_of_meetings<2, IsExact> {
  using base = archetype_of_meetings<2, IsExact>;
  using base::base;
  using typename base::meeting;

  sign orientation(line_id, line_id) const { return this->answer; }
  bool transversal(line_id, line_id) const { return true; }
  sign side(line_id, line_id, line_id, const meeting&) const { return this->answer; }
};

template <bool IsExact>
struct archetype<3, IsExact> : archetype_of_meetings<3, IsExact> {
  using base = archetype_of_meetings<3, IsExact>;
  using base::base;
  using base::compare;
  using typename base::meeting;

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

  sign orientation(plane_id, plane_id, plane_id) const { return this->answer; }
  bool transversal(plane_id, plane_id, plane_id) const { return true; }
  sign side(plane_id, plane_id, plane_id, plane_id, const meeting&) const { return this->answer; }
  bisector_type bisector(plane_id, plane_id) const { return bisector_type(0); }
  sign compare(const bisector_type&, const bisector_type&) const { return this->answer; }
  sign compare_volume(std::span<const triple>, std::span<const triple>) const { return this->answer; }
};

/// The weakest kernel that calls itself exact.
template <int D>
using weakest = archetype<D, true>;

}  // namespace osteon::test
