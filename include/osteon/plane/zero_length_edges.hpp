// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Edges whose length is zero in the limit of the perturbation. Where two reflex vertices
/// meet, the edges between them vanish together; perturbed, one goes first and another one, of
/// length zero in the limit, would grow again. The skeleton is discontinuous there, and by its
/// definition edges of length zero go (AAAG95, 2). So they do at the end of each moment: what that
/// changes is infinitely small.

#include <cstddef>
#include <vector>

#include "osteon/core/kernel.hpp"
#include "osteon/plane/front_surgery.hpp"
#include "osteon/plane/traced_front.hpp"

namespace osteon::plane {

/// Collects edges that may have length zero at the present moment, and lets them collapse at its
/// end. A moment is all meetings that are simultaneous in the limit. Kernels that know no limit
/// have no such edges.
template <kernel<2> K>
class zero_length_edges {
 public:
  using meeting = typename K::meeting;

  zero_length_edges(const K& k, traced_front& traced) : k_(k), traced_(traced), front_(traced.front), moment_(k.start()) {}

  /// Makes the time of a meeting the present one.
  void enter([[maybe_unused]] const meeting& m) {
    if constexpr (limit_kernel<K>)
      if (k_.has_moment(m)) moment_ = m;
  }
  /// Remembers an edge that has a new end and may have no length.
  void note([[maybe_unused]] int e) {
    if constexpr (limit_kernel<K>) edges_.push_back(e);
  }
  /// Remembers an edge that two have become.
  void note([[maybe_unused]] const merged_edge& m) {
    if constexpr (limit_kernel<K>) mergers_.push_back(m);
  }
  /// Returns whether nothing has been remembered at this moment.
  bool empty() const { return edges_.empty() && mergers_.empty(); }

  /// Returns whether a meeting belongs to the present moment, as far as it matters to collapse().
  bool is_same_moment([[maybe_unused]] const meeting& m) const {
    if constexpr (limit_kernel<K>) return !k_.has_moment(m) || k_.same_moment(m, moment_);
    return true;
  }

  /// Calls remove(edge) for each living edge of length zero, which may call note(); then notes the
  /// arcs that pass through nodes on their way, and forgets all that was remembered. Returns
  /// whether an edge had length zero.
  template <class Remove>
  bool collapse(Remove remove) {
    bool any = false;
    if constexpr (limit_kernel<K>) {
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        if (!has_length_zero(edges_[i])) continue;
        remove(edges_[i]);
        any = true;
      }
      for (const merged_edge& m : mergers_) trace_interior_node(m);
    }
    mergers_.clear();
    edges_.clear();
    return any;
  }

  /// Follows a renumbering of the wavefront.
  void renumber(const wavefront::numbering& now) {
    for (int& e : edges_) e = now.edges[e];
    for (merged_edge& m : mergers_) m.edge = now.edges[m.edge];
    std::erase(edges_, -1);
    std::erase_if(mergers_, [](const merged_edge& m) { return m.edge < 0; });
  }

 private:
  bool has_length_zero(int e) const requires limit_kernel<K> {
    if (!front_.edges[e].alive) return false;
    const line_id t = front_.tail_line(e);
    const line_id h = front_.head_line(e);
    const line_id line = front_.edges[e].line;
    // Between parallel edges of different speed it is needed as their step.
    return k_.transversal(t, h) && k_.transversal(line, h) && k_.touches(h, t, line, moment_);
  }

  // An edge of length zero that became part of another one at a node: the arc of that edge's end
  // passes through the node in the limit.
  void trace_interior_node(const merged_edge& m) requires limit_kernel<K> {
    const auto& e = front_.edges[m.edge];
    if (!e.alive) return;
    skeleton& trace = traced_.trace;
    for (const int v : {e.tail, e.head}) {
      const int arc = front_.vertices[v].arc;
      if (trace.arcs[arc].source < m.node && k_.touches(m.across, front_.line_before(v), front_.line_after(v), moment_))
        trace.interior_nodes.push_back({arc, m.node});
    }
  }

  const K& k_;
  traced_front& traced_;
  const wavefront& front_;
  meeting moment_;          // the last one that has a moment in the limit
  std::vector<int> edges_;  // that have changed at this moment and may have no length
  std::vector<merged_edge> mergers_;
};

}  // namespace osteon::plane
