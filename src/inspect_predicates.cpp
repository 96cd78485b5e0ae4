// SPDX-License-Identifier: MIT

/// \file
/// The window: what the predicates are asked.

#include "osteon/inspect.hpp"

#include <span>
#include <utility>

#include "decimals.hpp"
#include "osteon/core/error.hpp"
#include "osteon/evaluate/anchors.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "plane_run.hpp"
#include "polygon_data.hpp"
#include "polyhedron_data.hpp"
#include "space_run.hpp"

namespace osteon::inspect {
namespace {

/// An exact kernel that counts what comes through the filter.
template <class K>
class counted : public K {
 public:
  counted(K k, predicate_statistics& counts) : K(std::move(k)), counts_(&counts) {}

  sign orientation_at(int grade, const typename K::corner& c) const {
    ++counts_->exact_orientation;
    return K::orientation_at(grade, c);
  }
  sign offset_at(int grade, const typename K::support& q) const {
    ++counts_->exact_offset;
    return K::offset_at(grade, q);
  }
  sign closing_at(int grade, const typename K::support& q) const {
    ++counts_->exact_closing;
    return K::closing_at(grade, q);
  }
  sign cross_at(int grade, const typename K::support& q, const typename K::support& r) const {
    ++counts_->exact_cross;
    return K::cross_at(grade, q, r);
  }

 private:
  predicate_statistics* counts_;
};

// Calls run(kernel) with a kernel that counts, made by filter(exact kernel).
template <int Dimension, class Exact, class Filter, class Run>
predicate_statistics counting(Exact exact, Filter filter, Run run) {
  predicate_statistics result;
  any_kernel<Dimension> any = erased<Dimension>(perturbed(filter(counted(std::move(exact), result)))).perturbed;
  predicate_counts asked;
  any.count(asked);
  run(any);
  result.orientation = asked.orientation;
  result.side = asked.side;
  result.compare = asked.compare;
  result.meetings = asked.meet;
  result.compare_volume = asked.compare_volume;
  return result;
}

[[noreturn]] void not_counted() { throw unsupported_error("machine numbers have no filter to count; hint: take an exact kernel"); }

}  // namespace

predicate_statistics count_predicates(const polyhedron& p, const polyhedron_options& options) {
  const solid<integer>& s = p.access()->checked;
  const skeleton_options o{options.prefer, options.saddle.value_or(default_saddle(options.prefer)), options.explore};
  const auto filter = [&s](auto exact) { return filtered(std::span<const moving_plane<integer>>(s.planes), std::move(exact)); };
  const auto run = [&](const any_kernel<3>& k) { raw_skeleton(k, s, o); };
  switch (options.kernel) {
    case number_kernel::sqrt:
      return counting<3>(make_sqrt_kernel(s.planes), filter, run);
    case number_kernel::rational:
      return counting<3>(make_rational_kernel(s.planes), filter, run);
    case number_kernel::floating:
      break;
  }
  not_counted();
}

predicate_statistics count_predicates(const polygon& p, const polygon_options& options) {
  const auto checked = checked_polygon(p, options.region);
  plane_question q{*checked, options.region == region::exterior};
  if (options.until) q.until = time_value(*options.until);
  const std::span<const moving_line<integer>> lines(checked->lines);
  const auto anchors = anchors_of(*checked);
  const auto filter = [&](auto exact) { return filtered(lines, std::move(exact), anchors); };
  const auto run = [&](const any_kernel<2>& k) { raw_skeleton(k, q); };
  switch (options.kernel) {
    case number_kernel::sqrt:
      return counting<2>(make_sqrt_kernel(lines), filter, run);
    case number_kernel::rational:
      return counting<2>(make_rational_kernel(lines), filter, run);
    case number_kernel::floating:
      break;
  }
  not_counted();
}

}  // namespace osteon::inspect
