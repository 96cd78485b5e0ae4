// SPDX-License-Identifier: MIT

// A polygon around cells of a grid, straight, stretched or with all vertices moved, turned exactly or not, weighted or not, from inside or outside:
// its skeleton ends, the certificates hold, faces are a decomposition, a filter changes nothing, offsets shrink.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "check.hpp"
#include "decode.hpp"
#include "effort.hpp"
#include "gmp_memory.hpp"
#include "osteon/core/error.hpp"
#include "osteon/evaluate/offset.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/models/polygons.hpp"
#include "planar_ours.hpp"
#include "planar_skeletons.hpp"

namespace osteon::fuzz {
namespace {

using plane::models::point;
using plane::models::region;

constexpr int width = 6;
constexpr long unit = 8;

struct sample {
  plane::rings<integer> rings;
  bool touching = false;
  bool weighted = false;
};

// A path that may visit cells again.
plane::models::cell_grid cells(decoder& d, int most_steps) {
  plane::models::cell_grid grid(width);
  int x = 3;
  int y = 3;
  grid.fill(x, y);
  for (int left = d.byte() % most_steps; left > 0; --left) {
    const unsigned step = d.byte();
    const int to_x = x + (step % 4 == 0 ? 1 : step % 4 == 2 ? -1 : 0);
    const int to_y = y + (step % 4 == 1 ? 1 : step % 4 == 3 ? -1 : 0);
    if (!grid.within(to_x, to_y)) continue;
    x = to_x;
    y = to_y;
    grid.fill(x, y);
  }
  return grid;
}

sample decode(decoder& d, bool small) {
  const unsigned shape = d.byte() % 3;
  const unsigned weights = d.byte() % 3;
  const auto grid = cells(d, small ? 10 : 40);
  region r = grid.outline();
  sample s;
  for (int x = 1; x <= width + 1; ++x)
    for (int y = 1; y <= width + 1; ++y) s.touching = s.touching || grid.corners(x, y) == 2;

  std::array<std::array<long, width + 1>, 2> lines{};  // of the grid
  for (auto& axis : lines)
    for (std::size_t i = 1; i < axis.size(); ++i) axis[i] = axis[i - 1] + (shape == 1 ? d.between(1, 40) : unit);
  std::map<point, point> moved;
  for (auto& ring : r)
    for (point& p : ring) {
      const auto [at, fresh] = moved.try_emplace(p);
      if (fresh) {
        for (std::size_t axis = 0; axis < 2; ++axis)
          at->second[axis] = lines[axis][static_cast<std::size_t>(p[axis])] + (shape == 2 ? d.between(-3, 3) : 0);
      }
      p = at->second;
    }

  // Turned by a Gaussian integer: Pythagorean angles keep the lengths of axis-parallel edges rational, others do not.
  static constexpr std::array<point, 5> turns = {{{1, 0}, {3, 4}, {-5, 12}, {1, 1}, {2, 5}}};
  const point by = turns[d.index(turns.size())];
  for (auto& ring : r)
    for (point& p : ring) p = {p[0] * by[0] - p[1] * by[1], p[0] * by[1] + p[1] * by[0]};

  s.rings = plane::models::take<integer>(r);
  if (weights != 0) {
    for (auto& ring : s.rings.all)
      for (std::size_t i = 0; i < ring.points.size(); ++i) ring.weights.push_back({integer(weights == 1 ? d.between(1, 4) : d.between(0, 2)), 0, 0});
    s.weighted = true;
  }
  return s;
}

void require_same(const plane::skeleton& x, const plane::skeleton& y) {
  require(x.nodes.size() == y.nodes.size() && x.arcs.size() == y.arcs.size() && x.faces == y.faces, "a filter changes no count");
  for (std::size_t i = 0; i < x.nodes.size(); ++i)
    require(x.nodes[i].lines == y.nodes[i].lines && x.nodes[i].event == y.nodes[i].event, "a filter changes no node");
}

double area(const plane::offset_polygon<double>& p) {
  double sum = 0;
  for (const auto& r : p.rings)
    for (std::size_t i = 0, j = r.points.size() - 1; i < r.points.size(); j = i++)
      sum += r.points[j][0] * r.points[i][1] - r.points[j][1] * r.points[i][0];
  return sum / 2;
}

void check_offsets(const plane::polygon<integer>& p, const plane::skeleton& raw) {
  const plane::offsets offsets(p, raw);
  double last = 0;
  for (const auto& n : raw.nodes)
    if (n.vertex < 0) last = std::max(last, offsets.places().meeting(n.lines).time);
  const double whole = area(offsets.at(0));
  double before = whole;
  for (const double part : {0.25, 0.5, 0.75, 1.001}) {
    const double now = area(offsets.at(last * part));
    require(now <= before + 1e-9 * whole && now >= -1e-9 * whole, "offsets shrink");
    before = now;
  }
  require(before <= 1e-9 * whole, "in the end nothing is left");
}

// The laws that are not looked at for every input (effort.hpp).
enum dear_law : unsigned { unfiltered = 1, shrinking, decomposition, in_doubles };

// Throws unsupported_error.
void check_skeleton(const effort& e, const plane::polygon<integer>& p, bool outside, bool mirrored, bool touching) {
  const auto k = planar_kernel_of(p, mirrored);
  auto [raw, exact] = certified(k, p, outside);
  if (e.law(unfiltered)) require_same(raw, raw_skeleton(perturbed(k.base().base(), mirrored), p, outside));
  if (outside || has_stationary_edge(p)) return;
  if (e.law(shrinking)) check_offsets(p, raw);
  if (touching || !e.law(decomposition)) return;
  const auto fault = oracles::fault_of({p, std::move(raw), std::move(exact)});
  if (!fault.empty()) broken(fault);
}

void run(decoder d) {
  const effort e(d);
  const unsigned plan = d.byte();
  const bool outside = (plan & 1U) != 0;
  const sample s = decode(d, e.small());
  plane::polygon<integer> p;
  try {
    p = plane::make_polygon(s.rings, outside);
  } catch (const input_error&) {
    require(s.touching, "cells of a grid that do not touch make a polygon");
    tally::add("refused");
    return;
  }
  try {
    check_skeleton(e, p, outside, (plan & 2U) != 0, s.touching);
    tally::add(outside ? "outside" : "inside");
  } catch (const unsupported_error&) {
    require(has_stationary_edge(p), "only held edges enclose what never vanishes");
    tally::add("never vanishes");
  }
  if (!e.law(in_doubles)) return;
  try {
    raw_skeleton(make_double_kernel(std::span<const moving_line<integer>>(p.lines)), p, outside);
  } catch (const undecided_error&) {
  } catch (const unsupported_error&) {
  }
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder(std::span(data, size)));
  return 0;
}
