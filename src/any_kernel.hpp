// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// One kernel in place of all: its type says nothing of the numbers behind it, so that algorithms
/// are compiled once for all kernels. A predicate costs one virtual call more. Only the default
/// kernel has algorithms of its own.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "osteon/core/kernel.hpp"

namespace osteon {

/// How often each predicate was asked.
struct predicate_counts {
  std::uint64_t orientation = 0;
  std::uint64_t side = 0;
  std::uint64_t compare = 0;
  std::uint64_t meet = 0;
  std::uint64_t compare_volume = 0;
};

/// A kernel of any kind that is exact. In the plane it is a limit_kernel; there the kernel behind
/// it must be one where it is asked so.
template <int Dimension>
class any_kernel {
 public:
  static constexpr bool exact = true;
  static constexpr int dimension = Dimension;
  using corner = corner_planes<Dimension>;
  using support = meeting_planes<Dimension>;
  /// The edge between two facets.
  struct bisector_type {
    plane_id a, b;
  };
  struct meeting {
    alignas(double) std::array<std::byte, 160> state;
  };

  /// Takes a kernel, or a part of what `k` owns. *Requires* one whose meetings can be copied as
  /// bytes.
  template <kernel<Dimension> K>
  explicit any_kernel(std::shared_ptr<const K> k) : behind_(std::make_shared<const model<K>>(std::move(k))) {}

  /// Counts the questions from now on. `counts` must outlive the kernel.
  void count(predicate_counts& counts) { counts_ = &counts; }

  plane_id size() const { return behind_->size(); }
  bool has_unit_speeds() const { return behind_->has_unit_speeds(); }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == Dimension) sign orientation(Planes... of)
  const {
    note(&predicate_counts::orientation);
    return behind_->orientation({of...});
  }
  template <std::same_as<plane_id>... Planes>
  requires(sizeof...(Planes) == Dimension) bool transversal(Planes... of) const {
    note(&predicate_counts::orientation);
    return behind_->transversal({of...});
  }
  std::optional<meeting> meet(const support& q) const {
    note(&predicate_counts::meet);
    std::optional<meeting> m(std::in_place);
    if (!behind_->meet(q, *m)) m.reset();
    return m;
  }
  support planes(const meeting& m) const { return behind_->planes(m); }
  sign closing(const meeting& m) const { return behind_->closing(m); }
  meeting start() const { return behind_->start(); }
  sign compare(const meeting& m, const meeting& n) const {
    note(&predicate_counts::compare);
    return behind_->compare(m, n);
  }
  sign side(plane_id d, plane_id a, plane_id b, plane_id c, const meeting& m) const requires(Dimension == 3) {
    note(&predicate_counts::side);
    return behind_->side({d, a, b, c}, m);
  }
  sign side(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(Dimension == 2) {
    note(&predicate_counts::side);
    return behind_->side({c, a, b}, m);
  }

  bisector_type bisector(plane_id a, plane_id b) const { return {a, b}; }
  sign compare(const bisector_type& e, const bisector_type& f) const requires(Dimension == 3) { return behind_->compare_bisectors(e, f); }
  sign compare_volume(std::span<const triple> s, std::span<const triple> t) const requires(Dimension == 3) {
    note(&predicate_counts::compare_volume);
    return behind_->compare_volume(s, t);
  }

  bool has_moment(const meeting& m) const requires(Dimension == 2) { return behind_->has_moment(m); }
  bool is_never(const meeting& m) const requires(Dimension == 2) { return behind_->is_never(m); }
  bool same_moment(const meeting& m, const meeting& n) const requires(Dimension == 2) { return behind_->same_moment(m, n); }
  bool touches(plane_id c, plane_id a, plane_id b, const meeting& m) const requires(Dimension == 2) { return behind_->touches({c, a, b}, m); }

 private:
  struct questions {
    virtual ~questions() = default;
    virtual plane_id size() const = 0;
    virtual bool has_unit_speeds() const = 0;
    virtual sign orientation(const corner& c) const = 0;
    virtual bool transversal(const corner& c) const = 0;
    virtual bool meet(const support& q, meeting& m) const = 0;
    virtual support planes(const meeting& m) const = 0;
    virtual sign closing(const meeting& m) const = 0;
    virtual meeting start() const = 0;
    virtual sign compare(const meeting& m, const meeting& n) const = 0;
    virtual sign side(const support& q, const meeting& m) const = 0;
    virtual sign compare_bisectors(const bisector_type& e, const bisector_type& f) const = 0;
    virtual sign compare_volume(std::span<const triple> s, std::span<const triple> t) const = 0;
    virtual bool has_moment(const meeting& m) const = 0;
    virtual bool is_never(const meeting& m) const = 0;
    virtual bool same_moment(const meeting& m, const meeting& n) const = 0;
    virtual bool touches(const support& q, const meeting& m) const = 0;
  };

  template <class K>
  class model final : public questions {
   public:
    explicit model(std::shared_ptr<const K> k) : owner_(std::move(k)), k_(*owner_) {}

    plane_id size() const override { return k_.size(); }
    bool has_unit_speeds() const override {
      if constexpr (requires { k_.has_unit_speeds(); }) return k_.has_unit_speeds();
      return false;
    }
    sign orientation(const corner& c) const override {
      return std::apply([this](auto... p) { return k_.orientation(p...); }, c);
    }
    bool transversal(const corner& c) const override {
      return std::apply([this](auto... p) { return k_.transversal(p...); }, c);
    }
    bool meet(const support& q, meeting& m) const override {
      const auto found = k_.meet(q);
      if (found) m = packed(*found);
      return found.has_value();
    }
    support planes(const meeting& m) const override { return k_.planes(unpacked(m)); }
    sign closing(const meeting& m) const override { return k_.closing(unpacked(m)); }
    meeting start() const override { return packed(k_.start()); }
    sign compare(const meeting& m, const meeting& n) const override { return k_.compare(unpacked(m), unpacked(n)); }
    sign side(const support& q, const meeting& m) const override {
      return std::apply([&](auto... p) { return k_.side(p..., unpacked(m)); }, q);
    }
    sign compare_bisectors(const bisector_type& e, const bisector_type& f) const override {
      if constexpr (Dimension == 3) return k_.compare(k_.bisector(e.a, e.b), k_.bisector(f.a, f.b));
      return sign::zero;
    }
    sign compare_volume(std::span<const triple> s, std::span<const triple> t) const override {
      if constexpr (Dimension == 3) return k_.compare_volume(s, t);
      return sign::zero;
    }
    bool has_moment(const meeting& m) const override {
      if constexpr (knows_limits) return k_.has_moment(unpacked(m));
      return true;
    }
    bool is_never(const meeting& m) const override {
      if constexpr (knows_limits) return k_.is_never(unpacked(m));
      return false;
    }
    bool same_moment(const meeting& m, const meeting& n) const override {
      if constexpr (knows_limits) return k_.same_moment(unpacked(m), unpacked(n));
      return compare(m, n) == sign::zero;
    }
    bool touches(const support& q, const meeting& m) const override {
      if constexpr (knows_limits && Dimension == 2) return k_.touches(q[0], q[1], q[2], unpacked(m));
      return side(q, m) == sign::zero;
    }

   private:
    using inner = typename K::meeting;
    static_assert(std::is_trivially_copyable_v<inner> && sizeof(inner) <= sizeof(meeting) && alignof(inner) <= alignof(meeting));
    static constexpr bool knows_limits = requires(const K& k, const inner& m) {
      k.has_moment(m);
      k.is_never(m);
      k.same_moment(m, m);
    };

    static meeting packed(const inner& m) {
      meeting result;
      std::memcpy(result.state.data(), &m, sizeof(inner));
      return result;
    }
    static const inner& unpacked(const meeting& m) { return *std::launder(reinterpret_cast<const inner*>(m.state.data())); }

    std::shared_ptr<const K> owner_;
    const K& k_;
  };

  void note(std::uint64_t predicate_counts::*counter) const {
    if (counts_ != nullptr) ++(counts_->*counter);
  }

  std::shared_ptr<const questions> behind_;
  predicate_counts* counts_ = nullptr;
};

/// A perturbed kernel and the exact one below the perturbation.
template <int Dimension>
struct kernel_pair {
  any_kernel<Dimension> perturbed;
  any_kernel<Dimension> base;
};

/// Returns both for a perturbed kernel.
template <int Dimension, class Perturbed>
kernel_pair<Dimension> erased(Perturbed k) {
  const auto whole = std::make_shared<const Perturbed>(std::move(k));
  using base = std::remove_cvref_t<decltype(whole->base())>;
  return {any_kernel<Dimension>(whole), any_kernel<Dimension>(std::shared_ptr<const base>(whole, &whole->base()))};
}

}  // namespace osteon
