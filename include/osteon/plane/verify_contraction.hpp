// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate of a contracted skeleton in the plane.

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_set>
#include <vector>

#include "osteon/core/certificate.hpp"
#include "osteon/core/disjoint_sets.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/boundary.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/rule.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/structure.hpp"

namespace osteon::plane {

/// Checks a contracted skeleton against a certified raw one, under the kernel below the
/// perturbation.
template <kernel<2> K>
class contraction_verifier {
 public:
  contraction_verifier(const K& k, const boundary& polygon, const skeleton& raw, const contracted_skeleton& given)
      : k_(k), polygon_(polygon), raw_(raw), s_(given) {}

  /// Returns the first broken rule, or nothing: the contracted skeleton is right.
  std::optional<refutation> run() {
    try {
      check_boundary(k_.size(), polygon_);
      check_nodes();
      check_arcs();
      check_vertices();
      check_links();
      compare();
    } catch (const refutation& r) {
      return r;
    }
    return std::nullopt;
  }

 private:
  using meeting = typename K::meeting;

  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  // Nodes are vertices of the polygon, or lie where and when raw nodes do.
  void check_nodes() {
    using certificate::exists;
    constexpr std::size_t most = std::numeric_limits<int>::max() / 4;
    certificate::demand(s_.nodes.size() <= raw_.nodes.size(), rule::structure, "nodes", s_.nodes.size(), "are more than before the contraction");
    certificate::demand(s_.arcs.size() <= most, rule::structure, "arcs", s_.arcs.size(), "are too many");
    std::unordered_set<triple, plane_hash> events;
    for (const auto& node : raw_.nodes)
      if (node.vertex < 0) events.insert(node.lines);
    std::vector<bool> seen(polygon_.next.size());
    for (int i = 0; i < static_cast<int>(s_.nodes.size()); ++i) {
      const auto& node = s_.nodes[i];
      when_.push_back(k_.start());
      if (i < s_.vertices) {
        demand(exists(node.vertex, seen.size()) && !seen[node.vertex], rule::structure, "node", i, "is no vertex, or one for the second time");
        seen[node.vertex] = true;
        continue;
      }
      demand(node.vertex == -1, rule::structure, "node", i, "is a vertex behind the first event");
      demand(events.contains(node.lines), rule::place, "node", i, "is not the place of an event");
      for (const line_id l : node.corner)
        demand(std::find(node.lines.begin(), node.lines.end(), l) != node.lines.end(), rule::structure, "node", i, "has a corner of other lines");
      demand(k_.transversal(node.corner[0], node.corner[1]), rule::place, "node", i, "has a corner of parallel lines");
      const auto m = k_.meet(node.lines);
      demand(m.has_value(), rule::place, "node", i, "is nowhere in the limit");
      when_.back() = *m;
    }
    demand(s_.vertices >= 0 && s_.vertices <= static_cast<int>(s_.nodes.size()), rule::structure, "vertices", s_.vertices, "are counted wrongly");
  }

  bool lies_on(int node, line_id l) const {
    const auto& n = s_.nodes[node];
    return std::find(n.lines.begin(), n.lines.end(), l) != n.lines.end() || k_.side(l, n.corner[0], n.corner[1], when_[node]) == sign::zero;
  }

  // Arcs run between different places, forwards or along a ridge, and both ends lie on the lines of
  // both faces.
  void check_arcs() {
    using certificate::exists;
    std::vector<bool> seen(raw_.faces.size());
    int faces = 0;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      demand(exists(arc.source, s_.nodes.size()) && (arc.target == -1 || exists(arc.target, s_.nodes.size())), rule::structure, "arc", a,
             "names a node that is not there");
      // Nodes come in the order of time, those of one moment in an order of their own.
      demand(arc.target == -1 || (arc.source < arc.target && arc.target >= s_.vertices), rule::order, "arc", a,
             "ends in a vertex, or not behind the node where it begins");
      if (arc.source >= s_.vertices && arc.target >= 0)
        demand(k_.compare(when_[arc.source], when_[arc.target]) != sign::positive, rule::order, "arc", a, "does not run forwards in time");
      demand(arc.faces[0] != arc.faces[1], rule::structure, "arc", a, "has the same face on both sides");
      bool apart = arc.source < s_.vertices || arc.target < 0 || k_.compare(when_[arc.source], when_[arc.target]) != sign::zero;
      for (const int f : arc.faces) {
        demand(exists(f, seen.size()) && raw_.faces[f] == f, rule::structure, "arc", a, "names a face that is not there or no representative");
        faces += seen[f] ? 0 : 1;
        seen[f] = true;
        for (const int n : {arc.source, arc.target})
          if (n >= s_.vertices) demand(lies_on(n, polygon_.line[f]), rule::place, "arc", a, "does not lie on the lines of its faces");
      }
      if (!apart)
        for (const line_id l : s_.nodes[arc.source].lines) apart = apart || !lies_on(arc.target, l);
      demand(apart, rule::place, "arc", a, "has no length");
    }
    faces_ = faces;
  }

  // One arc goes on from each vertex, between the same faces as before the contraction.
  void check_vertices() const {
    std::vector<std::array<int, 2>> at(polygon_.next.size(), {-1, -1});
    int expected = 0;
    for (const auto& arc : raw_.arcs)
      if (const int v = raw_.nodes[arc.source].vertex; v >= 0) {
        at[v] = {std::min(arc.faces[0], arc.faces[1]), std::max(arc.faces[0], arc.faces[1])};
        ++expected;
      }
    int found = 0;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      if (arc.source >= s_.vertices) continue;
      auto& faces = at[s_.nodes[arc.source].vertex];
      demand(faces == std::array<int, 2>{std::min(arc.faces[0], arc.faces[1]), std::max(arc.faces[0], arc.faces[1])}, rule::start, "arc", a,
             "does not begin between the faces of its vertex, or is its second one");
      faces = {-1, -1};
      ++found;
    }
    demand(found == expected && found == s_.vertices, rule::start, "vertices", found, "have an arc, and others should");
  }

  // An end of an arc at an inner node, and one of the faces beside it. Ends are numbered: 2 a is
  // the source of arc a, 2 a + 1 its target.
  struct side {
    int node;
    int face;
    int end;
  };

  // Around every inner node there are at least three arcs, and their faces are one round: each face
  // lies between two arcs, or four, ...
  void check_links() const {
    std::vector<side> sides;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a)
      for (const int n : {s_.arcs[a].source, s_.arcs[a].target})
        if (n >= s_.vertices)
          for (const int f : s_.arcs[a].faces) sides.push_back({n, f, 2 * a + (n == s_.arcs[a].target ? 1 : 0)});
    std::sort(sides.begin(), sides.end(), [](const side& x, const side& y) { return x.node != y.node ? x.node < y.node : x.face < y.face; });
    disjoint_sets linked(2 * s_.arcs.size());
    std::vector<int> arcs_at(s_.nodes.size());
    for (std::size_t i = 0; i < sides.size();) {
      const int node = sides[i].node;
      const std::size_t first = i;
      int links = 0;
      while (i < sides.size() && sides[i].node == node) {
        std::size_t same = i;
        while (same < sides.size() && sides[same].node == node && sides[same].face == sides[i].face) ++same;
        demand((same - i) % 2 == 0, rule::event, "node", node, "has a face that is not closed there");
        for (std::size_t j = i + 1; j < same; ++j) links += linked.unite(sides[j].end, sides[i].end) ? 1 : 0;
        i = same;
      }
      arcs_at[node] = static_cast<int>(i - first) / 2;
      demand(links == arcs_at[node] - 1, rule::event, "node", node, "has arcs that are not one round");
    }
    for (int n = s_.vertices; n < static_cast<int>(s_.nodes.size()); ++n)
      demand(arcs_at[n] >= 3, rule::event, "node", n, "has fewer than three arcs");
  }

  // What is left to be wrong is that something is missing or not joined.
  void compare() const {
    demand(faces_ == s_.faces, rule::count, "faces", faces_, "are counted wrongly");
    const contracted_skeleton right = contract(k_, polygon_.line, raw_);
    certificate::demand(right.nodes.size() == s_.nodes.size(), rule::contraction, "nodes", s_.nodes.size(), "are too few or too many");
    certificate::demand(right.arcs.size() == s_.arcs.size(), rule::contraction, "arcs", s_.arcs.size(), "are too few or too many");
    for (int n = 0; n < static_cast<int>(s_.nodes.size()); ++n) {
      const auto& x = right.nodes[n];
      const auto& y = s_.nodes[n];
      demand(x.vertex == y.vertex && x.lines == y.lines && x.corner == y.corner, rule::contraction, "node", n, "is another one");
    }
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& x = right.arcs[a];
      const auto& y = s_.arcs[a];
      demand(x.source == y.source && x.target == y.target && x.faces == y.faces, rule::contraction, "arc", a, "is another one");
    }
  }

  const K& k_;
  const boundary& polygon_;
  const skeleton& raw_;
  const contracted_skeleton& s_;
  std::vector<meeting> when_;
  int faces_ = 0;  // that arcs name
};

/// Certifies a contracted skeleton, or refutes it. `k` is the kernel below the perturbation; `raw`
/// must have been certified. It is looked at by itself first (places, times, faces around each
/// node) and then compared with what contraction makes of the raw skeleton. Expected linear time,
/// but for sorting.
template <kernel<2> K>
std::optional<refutation> verify_contraction(const K& k, const boundary& polygon, const skeleton& raw, const contracted_skeleton& contracted) {
  return contraction_verifier<K>(k, polygon, raw, contracted).run();
}

}  // namespace osteon::plane
