// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate of a skeleton in the plane (docs/theory/plane.md). It repeats no search
/// and shares no code with the event loop: it replays the events that the skeleton claims, from the
/// polygon and the skeleton alone.
///
/// Why no search for contacts is needed. The replay shows that at every time t the wavefront W(t)
/// is a cycle of edges on their lines, that it changes continuously (at an event edges are linked
/// anew in the one point in which they end), that no edge ever has a negative length, and that in
/// the end nothing is left. Let w(x,t) be the winding number of W(t) around a point x. It changes
/// only where an edge passes x; an edge of positive length that moves to its left lowers it by one.
/// So w falls, from w(x,0), one inside of the polygon and zero outside, to zero: every point inside
/// is passed once, every point outside never. Hence - the faces, which the edges sweep, cover the
/// polygon once; - w is 0 or 1 at all times, so W(t) never crosses itself (where two edges cross, w
/// takes three values). A contact that was missed, or a
///    split that did not happen, would let it cross itself. What W(t) does is then forced: at an
///    event in general position two of the ways to link the edges in the point are without
///    crossings, what was before and what must come (catalogue.hpp enumerates them), and the replay
///    demands a change.
///
/// An edge's length is a linear function of time while its neighbours are the same. So it is enough
/// to look at it when one of its ends changes.
///
/// Some nodes are of zero length (skeleton::node): an edge goes whose length is zero in the limit
/// only. There W jumps, but by something infinitely small; that edges keep a positive length is
/// shown anew for its neighbours. What is said above then holds in the limit.
///
/// Outside of a polygon w falls from 0 to -1 and the wavefront goes on for ever. Far away, its
/// edges are tangents around one point that lies on their right; so w ends at minus the number of
/// turns that the wavefront makes, and one turn is what must be left. Edges of weight zero are no
/// such tangents, and several rings may be left; then that they do not cross and how often they go
/// around is shown pair by pair (terminal_wavefront.hpp). What happens infinitely late in the limit
/// (edges of one direction and one speed are neighbours then) is no event of the skeleton.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/replay.hpp"
#include "osteon/plane/replay_start.hpp"
#include "osteon/plane/replayed_front.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/structure.hpp"
#include "osteon/plane/terminal_wavefront.hpp"
#include "osteon/plane/verify_contraction.hpp"

namespace osteon::plane {

/// Checks a raw skeleton under a kernel that never answers zero for different lines (perturbed<K>).
template <kernel<2> K>
class verifier {
 public:
  verifier(const K& k, const boundary& polygon, const skeleton& s, bool outside, bool stationary)
      : k_(k), polygon_(polygon), s_(s), outside_(outside), stationary_(stationary), front_{{}, {}, disjoint_sets{}, k.start()} {}

  /// Returns the first refutation, or nothing: certified.
  std::optional<refutation> run() {
    try {
      check_boundary(k_.size(), polygon_);
      const skeleton_index index = structure_check(k_.size(), polygon_, s_).run();
      replay_start<K>(k_, polygon_, s_, index, front_).run();
      replay<K>(k_, polygon_, s_, index, front_).run();
      check_faces();
      check_counts();
      check_end();
    } catch (const refutation& r) {
      return r;
    }
    return std::nullopt;
  }

 private:
  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  // Edges share a face only if they have become one.
  void check_faces() {
    std::vector<int> owner(s_.faces.size(), -1);
    for (int f = 0; f < static_cast<int>(owner.size()); ++f) {
      int& o = owner[s_.faces[f]];
      demand(o < 0 || o == front_.faces.find(f), rule::face, "face", f, "is one with another although their edges never become one");
      o = front_.faces.find(f);
    }
  }

  void check_counts() const {
    std::array<int, 2> events{};
    for (std::size_t n = polygon_.next.size(); n < s_.nodes.size(); ++n) ++events[static_cast<std::size_t>(s_.nodes[n].event)];
    demand(events == s_.events, rule::count, "events", events[0] + events[1], "are counted wrongly");
  }

  // Nothing is left, or what goes on for ever outside of a polygon.
  void check_end() const {
    std::vector<int> left;
    for (std::size_t a = 0; a < front_.edge_of.size(); ++a)
      if (front_.edge_of[a] >= 0) left.push_back(static_cast<int>(a));
    demand(left.empty() || outside_, rule::end, "arc", left.empty() ? 0 : left.front(), "never ends");
    demand(!left.empty() || !outside_ || polygon_.next.empty(), rule::end, "node", static_cast<int>(s_.nodes.size()) - 1,
           "ends what goes on for ever");
    if (left.empty()) return;
    for (const int a : left) check_endless(a);
    const terminal_wavefront<K> rings(k_, rings_of(left));
    if (stationary_) {
      if (const auto e = rings.find_crossing())
        demand(false, rule::end, "arc", left[*e], "never ends, but an edge beside it meets another one, or rings lie wrongly in one another");
    } else {
      demand(rings.goes_once_around(), rule::end, "arc", left.front(), "what never ends does not go once around");
    }
  }

  // The edge that ends at an arc never vanishes.
  void check_endless(int arc) const {
    const auto& edges = front_.edges;
    const auto& e = edges[front_.edge_of[arc]];
    const triple q = sorted(triple{edges[e.before].line, e.line, edges[e.after].line});
    demand(q[0] != q[1] && q[1] != q[2], rule::end, "arc", arc, "has an edge without length beside it");
    const auto m = k_.meet(q);
    demand(!m || k_.compare(*m, front_.now) != sign::positive || is_never(*m), rule::end, "arc", arc, "never ends, but an edge beside it vanishes");
  }

  // The edges that end at these arcs, which are all that are left.
  std::vector<typename terminal_wavefront<K>::edge> rings_of(const std::vector<int>& left) const {
    std::vector<int> number(front_.edges.size(), -1);
    std::vector<typename terminal_wavefront<K>::edge> rings;
    for (const int a : left) {
      number[front_.edge_of[a]] = static_cast<int>(rings.size());
      const auto& e = front_.edges[front_.edge_of[a]];
      rings.push_back({e.line, e.before, e.after});
    }
    for (auto& e : rings) {
      e.before = number[e.before];
      e.after = number[e.after];
      demand(e.before >= 0 && e.after >= 0, rule::end, "edge on line", e.line, "goes on for ever beside one that does not");
    }
    return rings;
  }

  bool is_never([[maybe_unused]] const typename K::meeting& m) const {
    if constexpr (limit_kernel<K>) return k_.is_never(m);
    return false;
  }

  const K& k_;
  const boundary& polygon_;
  const skeleton& s_;
  const bool outside_;
  const bool stationary_;
  replayed_front<K> front_;
};

/// Certifies a raw skeleton of a checked polygon, or refutes it: returns the first broken rule, or
/// nothing. With `outside` the interior is not bounded (see make_polygon), and what never ends is
/// checked too; `stationary` tells that edges of weight zero may be among it. No skeleton, however
/// wrong, does harm. *Requires* a perturbed kernel with the polygon's lines. *Complexity* O(n log
/// n), about ten predicates for each event; with `outside` and `stationary` quadratic in the number
/// of edges that never vanish. Memory linear.
template <kernel<2> K>
std::optional<refutation> verify(const K& k, const boundary& polygon, const skeleton& raw, bool outside = false, bool stationary = false) {
  return verifier<K>(k, polygon, raw, outside, stationary).run();
}

}  // namespace osteon::plane
