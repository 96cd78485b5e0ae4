// SPDX-License-Identifier: MIT

/// \file
/// The window: what surrounds an event.

#include "osteon/inspect.hpp"

#include <array>

#include "osteon/core/error.hpp"
#include "osteon/core/planes.hpp"
#include "osteon/space/catalogue.hpp"
#include "polyhedron_skeleton_data.hpp"
#include "space_kernels.hpp"

namespace osteon::inspect {
namespace {

// The corners of an event by the plane that they omit; 0, which is none, where there is no vertex.
using corners = std::array<std::uint8_t, 4>;

corners corners_of(local::state f, local::cell tiny) {
  corners result{};
  for (unsigned r = 0; r < 4; ++r) {
    const auto c = local::corner_at(f, r, (tiny >> r & 1U) != 0);
    if (local::is_corner(c)) result[r] = c;
  }
  return result;
}

corners corners_at(const skeleton& s, int node, bool before) {
  const auto& n = s.nodes[node];
  corners result{};
  for (const int a : n.arcs)
    if ((before ? s.arcs[a].target : s.arcs[a].source) == node)
      for (unsigned r = 0; r < 4; ++r)
        if (omit(n.planes, r) == s.arcs[a].planes) result[r] = s.arcs[a].corner;
  return result;
}

// The small tetrahedron lies inside the planes whose lambda has the sign of S.
local::cell small_cell(const any_kernel<3>& k, const quadruple& q) {
  const auto m = k.meet(q);
  if (!m) throw unsupported_error("four planes of a node do not meet");
  local::cell small = 0;
  for (unsigned r = 0; r < 4; ++r)
    if (lambda(k, q, r) * k.closing(*m) == sign::positive) small |= 1U << r;
  return small;
}

event_picture drawn(const skeleton::node& n, event_kind kind, const local::event& e, bool fill) {
  event_picture p{kind, n.ambiguous, n.planes, static_cast<int>(e.small), {}, {}};
  const local::state after = local::successor(e, fill);
  for (unsigned c = 0; c < 16; ++c) {
    p.before[c] = local::solid(e.before, c);
    p.after[c] = local::solid(after, c);
  }
  return p;
}

}  // namespace

event_picture picture_of(const polyhedron_skeleton::node& event) {
  const auto raw = event.raw_nodes();
  if (raw.size() != 1 || event.event() == event_kind::vertex) throw unsupported_error("only a node that is one event has a picture; ask raw()");
  const polyhedron_skeleton::data& d = event.access();
  const int id = raw[0].id();
  const auto& n = d.result.raw.nodes[id];
  const local::cell small = small_cell(make_kernels(d.body(), d.options.kernel).perturbed, n.planes);
  const corners before = corners_at(d.result.raw, id, true);
  const corners after = corners_at(d.result.raw, id, false);
  // The corners before and after tell the event.
  for (const auto& [key, e] : local::catalogue::get().events(small))
    for (const bool fill : {false, true})
      if ((fill ? e.may_fill : e.may_empty) && corners_of(e.before, small) == before && corners_of(local::successor(e, fill), small ^ 15U) == after)
        return drawn(n, event.event(), e, fill);
  throw unsupported_error("the arcs around the node are those of no event");
}

}  // namespace osteon::inspect
