// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The certificate of a skeleton in the plane (design 05, 06). It repeats no search and shares no code with the event loop: it replays the
/// events that the skeleton claims, from the polygon and the skeleton alone.
///
/// Why no search for contacts is needed. The replay shows that at every time t the wavefront W(t) is a cycle of edges on their lines, that it
/// changes continuously (at an event edges are linked anew in the one point in which they end), that no edge ever has a negative length, and that
/// in the end nothing is left. Let w(x,t) be the winding number of W(t) around a point x. It changes only where an edge passes x; an edge of
/// positive length that moves to its left lowers it by one. So w falls, from w(x,0), one inside of the polygon and zero outside, to zero: every
/// point inside is passed once, every point outside never. Hence
///  - the faces, which the edges sweep, cover the polygon once;
///  - w is 0 or 1 at all times, so W(t) never crosses itself (where two edges cross, w takes three values). A contact that was missed, or a
///    split that did not happen, would let it cross itself.
/// What W(t) does is then forced: at an event in general position two of the ways to link the edges in the point are without crossings, what was
/// before and what must come (catalogue.hpp enumerates them), and the replay demands a change.
///
/// An edge's length is a linear function of time while its neighbours are the same. So it is enough to look at it when one of its ends changes.
///
/// Some nodes are late (skeleton::node): an edge goes whose length is zero in the limit only. There W jumps, but by something infinitely small;
/// that edges keep a positive length is shown anew for its neighbours. What is said above then holds in the limit.
///
/// Outside of a polygon w falls from 0 to -1 and the wavefront goes on for ever. Far away, its edges are tangents around one point that lies on
/// their right; so w ends at minus the number of turns that the wavefront makes, and one turn is what must be left. Edges of weight zero are no such
/// tangents, and several rings may be left; then that they do not cross and how often they go around is shown pair by pair (forever.hpp). What
/// happens infinitely late in the limit (edges of one direction and one speed are neighbours then) is no event of the skeleton.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "osteon/plane/boundary.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/core/kernel.hpp"
#include "osteon/plane/skeleton.hpp"
#include "osteon/plane/terminal_wavefront.hpp"

namespace osteon::plane {

/// What a skeleton can break. structure: something named does not exist, or not once; order: not in order of time; start: what begins at the
/// vertices; place: an arc ends where its lines do not meet; event: what happens at a node is no event; length: an edge has vanished before;
/// face: edges share a face that do not merge, or the reverse; count: of events; end: what is left in the end; contraction.
enum class rule : std::uint8_t { structure, order, start, place, event, length, face, count, end, contraction };
inline constexpr std::array<std::string_view, 10> rule_names = {"structure", "order", "start", "place", "event",
                                                                "length",    "face",  "count", "end",   "contraction"};

/// The first broken rule and where.
struct refutation {
  rule broken;
  std::string witness;
};

namespace certificate {

inline void demand(bool holds, rule r, const char* what, std::size_t number, const char* why) {
  if (!holds) throw refutation{r, std::string(what) + " " + std::to_string(number) + ": " + why};
}
inline void demand(bool holds, rule r, const char* what, int number, const char* why) {
  if (!holds) throw refutation{r, std::string(what) + " " + std::to_string(number) + ": " + why};
}

/// Whether `id` counts something in a list of this size.
inline bool exists(int id, std::size_t size) { return id >= 0 && static_cast<std::size_t>(id) < size; }

/// Rings of edges on lines of the kernel.
template <kernel<2> K>
void check_boundary(const K& k, const boundary& polygon) {
  const std::size_t n = polygon.next.size();
  demand(n <= std::numeric_limits<int>::max() / 4 && polygon.line.size() == n && polygon.rank.size() == n, rule::structure, "polygon of edges", n,
         "its lists have different lengths");
  std::vector<bool> entered(n);
  for (std::size_t e = 0; e < n; ++e) {
    demand(exists(polygon.next[e], n) && !entered[polygon.next[e]] && polygon.next[e] != static_cast<int>(e), rule::structure, "edge", e,
           "is not in a ring");
    entered[polygon.next[e]] = true;
    demand(polygon.line[e] >= 0 && polygon.line[e] < k.size(), rule::structure, "edge", e, "names a line that is not there");
  }
}

}  // namespace certificate

/// Replays a raw skeleton under a kernel that never answers zero for different lines (perturbed<K>).
template <kernel<2> K>
class verifier {
 public:
  verifier(const K& k, const boundary& polygon, const skeleton& s, bool outside, bool stationary)
      : k_(k), polygon_(polygon), s_(s), outside_(outside), stationary_(stationary), now_(k.start()), crowd_(in_order{this}) {}
  verifier(const verifier&) = delete;
  verifier& operator=(const verifier&) = delete;

  /// The first refutation, or nothing: certified.
  std::optional<refutation> run() {
    try {
      certificate::check_boundary(k_, polygon_);
      check_structure();
      begin();
      for (std::size_t n = polygon_.next.size(); n < s_.nodes.size(); ++n) {
        if (s_.nodes[n].zero_length)
          replay_zero_length(static_cast<int>(n));
        else
          replay(static_cast<int>(n));
      }
      check_shifted();
      check_faces();
      check_counts();
      check_end();
    } catch (const refutation& r) {
      return r;
    }
    return std::nullopt;
  }

 private:
  using meeting = typename K::meeting;

  // An edge of the wavefront; the vertex at its head moves along an arc.
  struct edge {
    line_id line;
    int face;  // an edge of the polygon
    int before;
    int after;
    int arc;
  };

  static void demand(bool holds, rule r, const char* what, int number, const char* why) { certificate::demand(holds, r, what, number, why); }

  // ---- structure: everything that is named exists

  void check_structure() {
    using certificate::exists;
    const std::size_t n = polygon_.next.size();
    constexpr std::size_t most = std::numeric_limits<int>::max() / 4;
    certificate::demand(s_.nodes.size() >= n && s_.nodes.size() <= most, rule::structure, "nodes", s_.nodes.size(), "are too few or too many");
    certificate::demand(s_.arcs.size() <= most, rule::structure, "arcs", s_.arcs.size(), "are too many");
    certificate::demand(s_.faces.size() == n, rule::structure, "faces", s_.faces.size(), "are not one for each edge");
    node_of_.assign(n, -1);
    for (int i = 0; i < static_cast<int>(s_.nodes.size()); ++i) {
      const auto& node = s_.nodes[i];
      const auto& q = node.lines;
      if (static_cast<std::size_t>(i) < n) {
        demand(exists(node.vertex, n) && node_of_[node.vertex] < 0, rule::structure, "node", i, "is no vertex, or one for the second time");
        node_of_[node.vertex] = i;
        continue;
      }
      demand(node.vertex == -1, rule::structure, "node", i, "is a vertex behind the first event");
      demand(q[0] >= 0 && q[0] < q[1] && q[1] < q[2] && q[2] < k_.size(), rule::structure, "node", i, "needs three lines, ascending");
      demand(node.event == event_class::edge || node.event == event_class::split, rule::structure, "node", i, "has no class of event");
    }
    for (const auto& p : s_.interior_nodes) {
      demand(exists(p.arc, s_.arcs.size()) && exists(p.node, s_.nodes.size()) && s_.nodes[p.node].vertex < 0, rule::structure, "arc", p.arc,
             "is none, or passes through no event");
      demand(s_.arcs[p.arc].source < p.node && (s_.arcs[p.arc].target < 0 || p.node < s_.arcs[p.arc].target), rule::order, "arc", p.arc,
             "passes through a node before or after its time");
    }
    for (int f = 0; f < static_cast<int>(n); ++f)
      demand(exists(s_.faces[f], n) && s_.faces[s_.faces[f]] == s_.faces[f], rule::structure, "face", f, "has no representative");
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      demand(exists(arc.source, s_.nodes.size()) && (arc.target == -1 || exists(arc.target, s_.nodes.size())), rule::structure, "arc", a,
             "names a node that is not there");
      for (const int f : arc.faces)
        demand(exists(f, n) && s_.faces[f] == f, rule::structure, "arc", a, "names a face that is not there or no representative");
      demand(arc.target == -1 || arc.source < arc.target, rule::order, "arc", a, "does not run forwards in time");
      demand(arc.target == -1 || static_cast<std::size_t>(arc.target) >= n, rule::order, "arc", a, "ends in a vertex");
    }
    starts_ = incidence([](const skeleton::arc& arc) { return arc.source; });
    ends_ = incidence([](const skeleton::arc& arc) { return arc.target; });
  }

  // Arcs by node: those of node i are list[first[i]] .. list[first[i + 1] - 1].
  struct arcs_by_node {
    std::vector<int> first;
    std::vector<int> list;
    const int* begin(int node) const { return list.data() + first[node]; }
    const int* end(int node) const { return list.data() + first[node + 1]; }
    int size(int node) const { return first[node + 1] - first[node]; }
  };

  template <class Node>
  arcs_by_node incidence(Node node) const {
    arcs_by_node result;
    result.first.assign(s_.nodes.size() + 1, 0);
    for (const auto& arc : s_.arcs)
      if (node(arc) >= 0) ++result.first[node(arc) + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    result.list.resize(static_cast<std::size_t>(result.first.back()));
    auto next = result.first;
    for (std::size_t a = 0; a < s_.arcs.size(); ++a)
      if (const int i = node(s_.arcs[a]); i >= 0) result.list[next[i]++] = static_cast<int>(a);
    return result;
  }

  // ---- the start: the polygon, and one arc from each vertex

  void begin() {
    const int n = static_cast<int>(polygon_.next.size());
    edges_.resize(polygon_.next.size());
    for (int e = 0; e < n; ++e) {
      edges_[e].line = polygon_.line[e];
      edges_[e].face = e;
      edges_[e].after = polygon_.next[e];
      edges_[e].arc = -1;
      edges_[polygon_.next[e]].before = e;
    }
    union_.resize(polygon_.next.size());
    std::iota(union_.begin(), union_.end(), 0);
    for (int v = 0; v < n; ++v) {
      const line_id a = edges_[edges_[v].before].line;
      const line_id b = edges_[v].line;
      demand(s_.nodes[node_of_[v]].lines == triple{std::min(a, b), std::max(a, b), -1}, rule::start, "node", node_of_[v],
             "does not name the two lines of its vertex");
    }
    straighten();
    edge_of_.assign(s_.arcs.size(), -1);
    for (int v = 0; v < n; ++v) {
      const int node = node_of_[v];
      if (vanished_[v]) {
        demand(starts_.size(node) == 0, rule::start, "node", node, "has an arc although its edges are one from the start");
        continue;
      }
      demand(starts_.size(node) == 1, rule::start, "node", node, "does not have one arc");
      const int a = *starts_.begin(node);
      const int in = head_at_[v];
      const int out = edges_[in].after;
      demand(s_.arcs[a].faces == std::array<int, 2>{s_.faces[in], s_.faces[out]}, rule::start, "arc", a,
             "does not begin between the edges of its vertex");
      edges_[in].arc = a;
      edge_of_[a] = in;
    }
    head_at_ = {};
    vanished_ = {};
    begin_order();
  }

  // Where a boundary is straight there is no vertex. Edges on one line are one; of two on parallel lines one vanishes at once: the slower one
  // where the perturbation makes the vertex convex, else the faster one (as the event loop documents). Where several do so beside each other
  // the outcome depends on the order; it is from the last vertex to the first, but the next vertex behind a vanished edge comes at once.
  void straighten() {
    const int n = static_cast<int>(edges_.size());
    head_at_.resize(edges_.size());
    std::vector<int> tail_at(edges_.size());  // the edge that starts at a vertex
    vanished_.assign(edges_.size(), false);
    std::iota(tail_at.begin(), tail_at.end(), 0);
    for (int v = 0; v < n; ++v) head_at_[v] = edges_[v].before;
    std::vector<int> tail(tail_at);  // the vertex where an edge starts
    std::vector<int> waiting(tail_at);
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (vanished_[v]) continue;
      const int in = head_at_[v];
      const int out = tail_at[v];
      demand(in != out, rule::structure, "edge", in, "is a ring of its own");
      const line_id a = edges_[in].line;
      const line_id b = edges_[out].line;
      if (a != b && k_.transversal(a, b)) continue;
      const bool in_stays = a == b || (k_.orientation(a, b) == sign::positive) == is_faster(a, b);
      const int gone = in_stays ? out : in;
      const int stays = in_stays ? in : out;
      const int head = tail[edges_[out].after];
      const int far = in_stays ? head : tail[in];
      edges_[edges_[gone].before].after = edges_[gone].after;
      edges_[edges_[gone].after].before = edges_[gone].before;
      edges_[gone].before = edges_[gone].after = -1;
      if (in_stays) {
        head_at_[far] = stays;
      } else {
        tail_at[far] = stays;
        tail[stays] = far;
      }
      vanished_[v] = true;
      waiting.push_back(far);
      if (a == b) unite(in, out, "edge", out);
    }
  }

  // Whether line a is faster than the parallel line b: with any line c across, S = lambda_a (sigma_a - sigma_b), lambda_a = det(n_b, n_c).
  bool is_faster(line_id a, line_id b) {
    if (across_[0] < 0) find_across();
    const line_id c = k_.transversal(a, across_[0]) ? across_[0] : across_[1];
    triple q = {a, b, c};
    std::sort(q.begin(), q.end());
    const auto m = k_.meet(q);
    demand(m.has_value(), rule::structure, "line", a, "touches a parallel line of the same speed");
    const bool odd = a > std::min(b, c) && a < std::max(b, c);  // lambda of the middle one has the other sign
    const line_id first = std::min(b, c);
    const line_id last = std::max(b, c);
    const sign lambda = odd ? -k_.orientation(first, last) : k_.orientation(first, last);
    return k_.closing(*m) == lambda;
  }

  // Two lines that cross: every line crosses one of them.
  void find_across() {
    line_id c = 1;
    while (c < k_.size() && !k_.transversal(0, c)) ++c;
    demand(c < k_.size(), rule::structure, "line", 0, "is parallel to all others");
    across_ = {0, c};
  }

  // ---- one event

  void replay(int node) {
    const triple& q = s_.nodes[node].lines;
    const auto found = k_.meet(q);
    demand(found.has_value(), rule::order, "node", node, "its lines do not meet");
    const meeting& m = *found;
    demand(k_.compare(m, now_) == sign::positive, rule::order, "node", node, "is not later than what comes before it");
    const int ending = ends_.size(node);
    demand(ending >= 1 && ending <= 3, rule::event, "node", node, "ends no arc, or more than three");
    demand(starts_.size(node) <= 3, rule::event, "node", node, "begins more than three arcs");

    // What each line contributes: an edge that comes into the point, one that goes out of it, and one that vanishes.
    struct pieces {
      int in = -1;
      int out = -1;
      int gone = -1;
    };
    std::array<pieces, 3> at;
    bool vanishes = false;
    const auto index = [&q](line_id l) { return static_cast<std::size_t>(std::find(q.begin(), q.end(), l) - q.begin()); };
    const auto set = [node](int& to, int e) {
      demand(to < 0 || to == e, rule::event, "node", node, "two edges lie on one another");
      to = e;
    };
    for (const int* a = ends_.begin(node); a != ends_.end(node); ++a) {
      const int e = edge_of_[*a];
      const int f = edges_[e].after;
      const std::size_t r = index(edges_[e].line);
      const std::size_t s = index(edges_[f].line);
      demand(r < 3 && s < 3, rule::place, "arc", *a, "ends where its lines do not meet");
      const bool whole_e = s_.arcs[edges_[edges_[e].before].arc].target == node;
      const bool whole_f = s_.arcs[edges_[f].arc].target == node;
      set(whole_e ? at[r].gone : at[r].in, e);
      set(whole_f ? at[s].gone : at[s].out, f);
      vanishes = vanishes || whole_e;
    }
    bool cut = false;
    for (std::size_t r = 0; r < 3; ++r) {
      auto& [in, out, gone] = at[r];
      demand(gone < 0 || (in < 0 && out < 0), rule::event, "node", node, "two edges lie on one another");
      if (in >= 0 || out >= 0 || gone >= 0) continue;
      demand(ending == 1, rule::event, "node", node, "an edge on one of its lines is not concerned");
      in = out = edge_through(q[r], partner(q, r), m);
      demand(in >= 0, rule::event, "node", node, "no edge is there to be cut");
      cut = true;
    }
    demand(ending > 1 || cut, rule::event, "node", node, "an arc ends and nothing happens");
    for (std::size_t r = 0; r < 3; ++r) {
      const auto& [in, out, gone] = at[r];
      if (in >= 0)
        demand(is_beyond(q[r], edges_[edges_[in].before].line, partner(q, r), q, m) == sign::positive, rule::length, "node", node,
               "an edge that ends here has vanished before");
      if (out >= 0)
        demand(is_beyond(q[r], edges_[edges_[out].after].line, partner(q, r), q, m) == sign::negative, rule::length, "node", node,
               "an edge that starts here has vanished before");
    }

    // What goes on: every arc links an edge that came in to one that goes out; what is left over is one line's and becomes one edge.
    struct link {
      int arc;
      std::size_t in;
      std::size_t out;
    };
    std::array<link, 3> links{};
    int count = 0;
    std::array<bool, 3> in_used{};
    std::array<bool, 3> out_used{};
    for (const int* a = starts_.begin(node); a != starts_.end(node); ++a) {
      const auto& faces = s_.arcs[*a].faces;
      const std::size_t r = index(polygon_.line[faces[0]]);
      const std::size_t s = index(polygon_.line[faces[1]]);
      demand(r < 3 && s < 3, rule::place, "arc", *a, "begins where its lines do not meet");
      demand(r != s && at[r].in >= 0 && at[s].out >= 0 && !in_used[r] && !out_used[s], rule::event, "arc", *a,
             "begins between edges that do not end and start there");
      demand(s_.faces[edges_[at[r].in].face] == faces[0] && s_.faces[edges_[at[s].out].face] == faces[1], rule::face, "arc", *a,
             "begins between edges of other faces");
      demand(edges_[at[r].in].after != at[s].out, rule::event, "arc", *a, "begins between the same edges as one that ends");
      in_used[r] = out_used[s] = true;
      links[count++] = {*a, r, s};
    }
    int through = -1;
    for (int r = 0; r < 3; ++r) {
      const auto& [in, out, gone] = at[r];
      if ((in < 0 || in_used[r]) && (out < 0 || out_used[r])) continue;
      demand(in >= 0 && out >= 0 && !in_used[r] && !out_used[r] && in != out && through < 0, rule::event, "node", node,
             "edges that come in do not go on");
      through = r;
    }
    demand((s_.nodes[node].event == event_class::edge) == vanishes, rule::event, "node", node, "is of the other class");

    // The replacement.
    check_shifted();
    now_ = m;
    if constexpr (limit_kernel<K>)
      if (k_.has_moment(m)) moment_ = m;
    for (auto& p : at) {
      if (p.gone >= 0) leave_order(p.gone);
      if (cut && p.in >= 0 && p.in == p.out) {
        p.out = static_cast<int>(edges_.size());
        edges_.push_back(edges_[p.in]);
        edge_of_[edges_[p.out].arc] = p.out;
        edges_[edges_[p.out].after].before = p.out;
      }
    }
    for (const int* a = ends_.begin(node); a != ends_.end(node); ++a) edge_of_[*a] = -1;
    for (int i = 0; i < count; ++i) {
      const int e = at[links[i].in].in;
      const int f = at[links[i].out].out;
      edges_[e].after = f;
      edges_[e].arc = links[i].arc;
      edges_[f].before = e;
      edge_of_[links[i].arc] = e;
    }
    if (through >= 0) {
      const int e = at[through].in;
      const int f = at[through].out;
      unite(edges_[e].face, edges_[f].face, "node", node);
      edges_[e].after = edges_[f].after;
      edges_[e].arc = edges_[f].arc;
      edges_[edges_[f].after].before = e;
      edge_of_[edges_[f].arc] = e;
      leave_order(f);
    }
    if (cut)
      for (const auto& p : at)
        if (p.out == static_cast<int>(edges_.size()) - 1) enter_order(p.in, p.out);
  }

  // An edge goes that in the limit, but not before, has length zero at the last moment.
  void replay_zero_length(int node) {
    const int ending = ends_.size(node);
    demand(ending == 2 || ending == 3, rule::event, "node", node, "is late and does not end two arcs or three");
    int e = -1;
    bool vanishes = false;
    for (const int* a = ends_.begin(node); a != ends_.end(node) && !vanishes; ++a) {
      const int f = edges_[edge_of_[*a]].after;
      if (s_.arcs[edges_[f].arc].target != node) continue;
      e = f;
      vanishes = is_short(f);
    }
    demand(e >= 0, rule::event, "node", node, "is late and no edge is between the arcs that end");
    const int in = edges_[e].before;
    const int out = edges_[e].after;
    triple q = {edges_[in].line, edges_[e].line, edges_[out].line};
    std::sort(q.begin(), q.end());
    demand(q == s_.nodes[node].lines && q[0] != q[1] && q[1] != q[2], rule::place, "node", node, "is not on the lines of the edge that vanishes");
    demand(vanishes, rule::length, "node", node, "is late, but no edge has length zero in the limit");
    demand(s_.nodes[node].event == event_class::edge, rule::event, "node", node, "is of the other class");
    for (const int* a = ends_.begin(node); a != ends_.end(node); ++a) edge_of_[*a] = -1;
    leave_order(e);
    if (ending == 3) {
      demand(edges_[out].after == in && starts_.size(node) == 0, rule::event, "node", node, "ends three arcs that are not those of a triangle");
      leave_order(in);
      leave_order(out);
      return;
    }
    demand(starts_.size(node) == 1 && edges_[out].after != in, rule::event, "node", node, "is late and does not begin one arc");
    const int a = *starts_.begin(node);
    demand(s_.arcs[a].faces == std::array<int, 2>{s_.faces[edges_[in].face], s_.faces[edges_[out].face]}, rule::face, "arc", a,
           "begins between edges of other faces");
    edges_[in].after = out;
    edges_[in].arc = a;
    edges_[out].before = in;
    edges_[e].after = -1;
    edge_of_[a] = in;
    shifted_.push_back(in);
    shifted_.push_back(out);
  }

  // Whether an edge has length zero in the limit at the last moment.
  bool is_short(int e) const {
    if constexpr (limit_kernel<K>) {
      const line_id out = edges_[edges_[e].after].line;
      return moment_ && k_.transversal(edges_[e].line, out) && k_.touches(out, edges_[edges_[e].before].line, edges_[e].line, *moment_);
    } else {
      return false;
    }
  }

  // Edges with an end that has jumped have a positive length, if they are still there.
  void check_shifted() {
    for (const int e : shifted_) {
      const edge& x = edges_[e];
      if (x.after < 0 || edge_of_[x.arc] != e) continue;
      demand(is_beyond(x.line, edges_[x.before].line, edges_[x.after].line, now_) == sign::positive, rule::length, "edge on line", x.line,
             "is turned round by a late event");
    }
    shifted_.clear();
  }

  // Another line through the point of an event, not parallel to line r.
  line_id partner(const triple& q, std::size_t r) const {
    const line_id j = q[r == 0 ? 1 : 0];
    return k_.transversal(q[r], j) ? j : q[r == 2 ? 1 : 2];
  }

  // Where the point in which line `l` meets line y lies at the moment m, seen in the direction of l from the point where it meets line x.
  sign is_beyond(line_id l, line_id x, line_id y, const meeting& m) const {
    if (x == y) return sign::zero;
    return -(k_.orientation(l, x) * k_.side(x, l, y, m));
  }
  // The same where l and y meet in the point of an event of the lines q.
  sign is_beyond(line_id l, line_id x, line_id y, const triple& q, const meeting& m) const {
    return std::find(q.begin(), q.end(), x) != q.end() ? sign::zero : is_beyond(l, x, y, m);
  }

  // ---- the order of edges along their lines: needed to find the edge that is cut, never to trust it

  struct point {
    line_id line;
    line_id across;
    const meeting* when;
  };
  struct in_order {
    using is_transparent = void;
    const verifier* v;
    bool operator()(int e, int f) const { return v->comes_before(e, f); }
    bool operator()(int e, const point& p) const { return v->ends_before(e, p); }
  };

  bool comes_before(int e, int f) const {
    const edge& a = edges_[e];
    const edge& b = edges_[f];
    if (a.line != b.line) return a.line < b.line;
    if (!events_begun_) return polygon_.rank[e] < polygon_.rank[f];
    return e != f && is_beyond(a.line, edges_[a.after].line, edges_[b.before].line, now_) != sign::negative;
  }
  bool ends_before(int e, const point& p) const {
    const edge& a = edges_[e];
    if (a.line != p.line) return a.line < p.line;
    return is_beyond(a.line, edges_[a.after].line, p.across, *p.when) == sign::positive;
  }

  using crowd = std::multiset<int, in_order>;
  static constexpr int none = -1;
  static constexpr int many = -2;

  void begin_order() {
    only_.assign(static_cast<std::size_t>(k_.size()), none);
    std::vector<int> several;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      if (edges_[e].after < 0) continue;
      int& only = only_[edges_[e].line];
      if (only >= 0) several.push_back(only);
      if (only != none) several.push_back(e);
      only = only == none ? e : many;
    }
    std::sort(several.begin(), several.end(), [this](int e, int f) { return comes_before(e, f); });
    for (const int e : several) in_crowd(e) = crowd_.insert(crowd_.end(), e);
    events_begun_ = true;
  }

  typename crowd::iterator& in_crowd(int e) {
    if (in_crowd_.size() < edges_.size()) in_crowd_.resize(edges_.size(), crowd_.end());
    return in_crowd_[e];
  }

  void leave_order(int e) {
    int& only = only_[edges_[e].line];
    if (only == e) {
      only = none;
    } else {
      crowd_.erase(in_crowd(e));
      in_crowd(e) = crowd_.end();
    }
  }

  // The new edge f comes right after e.
  void enter_order(int e, int f) {
    int& only = only_[edges_[e].line];
    if (only >= 0) in_crowd(e) = crowd_.insert(e);
    only = many;
    const auto after = std::next(in_crowd(e));
    in_crowd(f) = crowd_.insert(after, f);
  }

  // The edge that contains the point where line l meets line y, or none.
  int edge_through(line_id l, line_id y, const meeting& m) const {
    if (only_[l] != many) return only_[l];
    const auto e = crowd_.lower_bound(point{l, y, &m});
    return e == crowd_.end() || edges_[*e].line != l ? none : *e;
  }

  // ---- faces, counts, the end

  int root(int f) {
    while (union_[f] != f) f = union_[f] = union_[union_[f]];
    return f;
  }
  void unite(int f, int g, const char* what, int number) {
    demand(s_.faces[f] == s_.faces[g], rule::face, what, number, "edges become one, but not their faces");
    f = root(f);
    g = root(g);
    union_[std::max(f, g)] = std::min(f, g);
  }

  void check_faces() {
    std::vector<int> owner(union_.size(), -1);
    for (int f = 0; f < static_cast<int>(union_.size()); ++f) {
      int& o = owner[s_.faces[f]];
      demand(o < 0 || o == root(f), rule::face, "face", f, "is one with another although their edges never become one");
      o = root(f);
    }
  }

  void check_counts() const {
    std::array<int, 2> events{};
    for (std::size_t n = polygon_.next.size(); n < s_.nodes.size(); ++n) ++events[static_cast<std::size_t>(s_.nodes[n].event)];
    demand(events == s_.events, rule::count, "events", events[0] + events[1], "are counted wrongly");
  }

  void check_end() const {
    std::vector<int> left;
    for (std::size_t a = 0; a < edge_of_.size(); ++a)
      if (edge_of_[a] >= 0) left.push_back(static_cast<int>(a));
    demand(left.empty() || outside_, rule::end, "arc", left.empty() ? 0 : left.front(), "never ends");
    demand(!left.empty() || !outside_ || polygon_.next.empty(), rule::end, "node", static_cast<int>(s_.nodes.size()) - 1,
           "ends what goes on for ever");
    if (left.empty()) return;
    for (const int a : left) {
      const int e = edge_of_[a];
      triple q = {edges_[edges_[e].before].line, edges_[e].line, edges_[edges_[e].after].line};
      std::sort(q.begin(), q.end());
      demand(q[0] != q[1] && q[1] != q[2], rule::end, "arc", a, "has an edge without length beside it");
      const auto m = k_.meet(q);
      demand(!m || k_.compare(*m, now_) != sign::positive || is_never(*m), rule::end, "arc", a, "never ends, but an edge beside it vanishes");
    }
    if (stationary_)
      check_rings(left);
    else
      check_turns(left);
  }

  void check_rings(const std::vector<int>& left) const {
    std::vector<int> number(edges_.size(), -1);
    std::vector<typename last_wavefront<K>::edge> rings;
    for (const int a : left) {
      number[edge_of_[a]] = static_cast<int>(rings.size());
      const edge& e = edges_[edge_of_[a]];
      rings.push_back({e.line, e.before, e.after});
    }
    for (auto& e : rings) {
      e.before = number[e.before];
      e.after = number[e.after];
      demand(e.before >= 0 && e.after >= 0, rule::end, "edge on line", e.line, "goes on for ever beside one that does not");
    }
    if (const auto e = last_wavefront<K>(k_, std::move(rings)).find_crossing())
      demand(false, rule::end, "arc", left[*e], "never ends, but an edge beside it meets another one, or rings lie wrongly in one another");
  }

  // One ring, and it turns right once in all: count how often its direction passes that of one edge.
  void check_turns(const std::vector<int>& left) const {
    const int first = edge_of_[left.front()];
    const line_id direction = edges_[first].line;
    std::size_t length = 0;
    int turns = 0;
    int e = first;
    do {
      const int f = edges_[e].after;
      const bool from = k_.orientation(direction, edges_[e].line) == sign::negative;
      const bool to = k_.orientation(direction, edges_[f].line) == sign::negative;
      const bool left_turn = k_.orientation(edges_[e].line, edges_[f].line) == sign::positive;
      if (from && !to && left_turn) ++turns;
      if (!from && to && !left_turn) --turns;
      ++length;
      e = f;
    } while (e != first);
    demand(length == left.size() && turns == -1, rule::end, "arc", left.front(), "what never ends does not go once around");
  }

  bool is_never(const meeting& m) const {
    if constexpr (limit_kernel<K>) return k_.is_never(m);
    return false;
  }

  const K& k_;
  const boundary& polygon_;
  const skeleton& s_;
  const bool outside_;
  const bool stationary_;
  meeting now_;
  std::optional<meeting> moment_;  // the last one that has a moment in the limit
  std::vector<int> shifted_;       // edges whose ends a late event has moved
  std::vector<int> node_of_;       // by vertex
  arcs_by_node starts_;
  arcs_by_node ends_;
  std::vector<edge> edges_;
  std::vector<int> head_at_;    // by vertex: the edge that ends there, at the start
  std::vector<bool> vanished_;  // by vertex, at the start
  std::vector<int> edge_of_;    // by arc: the edge that ends at the moving vertex, -1 unless it moves now
  std::vector<int> union_;      // of edges of the polygon that share a face
  std::array<line_id, 2> across_ = {-1, -1};
  bool events_begun_ = false;
  std::vector<int> only_;  // by line: its only edge, or none, or many
  crowd crowd_;            // the edges of all other lines
  std::vector<typename crowd::iterator> in_crowd_;
};

/// Certifies a raw skeleton of a checked polygon, or refutes it. `k` is a perturbed kernel with the polygon's lines. With `outside` the interior is
/// not bounded (see make_polygon), and what never ends is checked too; `held` tells that edges of weight zero may be among it. No skeleton, however
/// wrong, does harm. Time O(n log n), about ten predicates for each event, and with `outside` and `held` quadratic in the number of edges that never
/// vanish; memory linear.
template <kernel<2> K>
std::optional<refutation> verify(const K& k, const boundary& polygon, const skeleton& raw, bool outside = false, bool stationary = false) {
  return verifier<K>(k, polygon, raw, outside, stationary).run();
}

/// Checks a contracted skeleton against a certified raw one, under the kernel below the perturbation.
template <kernel<2> K>
class contraction_verifier {
 public:
  contraction_verifier(const K& k, const boundary& polygon, const skeleton& raw, const contracted_skeleton& given)
      : k_(k), polygon_(polygon), raw_(raw), s_(given) {}

  std::optional<refutation> run() {
    try {
      certificate::check_boundary(k_, polygon_);
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

  // Arcs run between different places, forwards or along a ridge, and both ends lie on the lines of both faces.
  void check_arcs() {
    using certificate::exists;
    std::vector<bool> seen(raw_.faces.size());
    int faces = 0;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a) {
      const auto& arc = s_.arcs[a];
      demand(exists(arc.source, s_.nodes.size()) && (arc.target == -1 || exists(arc.target, s_.nodes.size())), rule::structure, "arc", a,
             "names a node that is not there");
      demand(arc.source != arc.target && arc.target != arc.source && (arc.target == -1 || arc.target >= s_.vertices), rule::order, "arc", a,
             "ends where it begins, or in a vertex");
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

  // Around every inner node there are at least three arcs, and their faces are one round: each face lies between two arcs, or four, ...
  void check_links() const {
    struct side {
      int node;
      int face;
      int arc;
    };
    std::vector<side> sides;
    for (int a = 0; a < static_cast<int>(s_.arcs.size()); ++a)
      for (const int n : {s_.arcs[a].source, s_.arcs[a].target})
        if (n >= s_.vertices)
          for (const int f : s_.arcs[a].faces) sides.push_back({n, f, a});
    std::sort(sides.begin(), sides.end(), [](const side& x, const side& y) { return x.node != y.node ? x.node < y.node : x.face < y.face; });
    std::vector<int> arcs_at(s_.nodes.size());
    std::vector<int> parent(s_.arcs.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int a) {
      while (parent[a] != a) a = parent[a] = parent[parent[a]];
      return a;
    };
    for (std::size_t i = 0; i < sides.size();) {
      const int node = sides[i].node;
      const std::size_t first = i;
      int rounds = 0;
      while (i < sides.size() && sides[i].node == node) {
        std::size_t same = i;
        while (same < sides.size() && sides[same].node == node && sides[same].face == sides[i].face) ++same;
        demand((same - i) % 2 == 0, rule::event, "node", node, "has a face that is not closed there");
        for (std::size_t j = i + 1; j < same; ++j) parent[root(sides[j].arc)] = root(sides[i].arc);
        i = same;
      }
      for (std::size_t j = first; j < i; ++j) rounds += root(sides[j].arc) == sides[j].arc ? 1 : 0;
      arcs_at[node] = static_cast<int>(i - first) / 2;
      demand(rounds == 2, rule::event, "node", node, "has arcs that are not one round");
      for (std::size_t j = first; j < i; ++j) parent[sides[j].arc] = sides[j].arc;
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

/// Certifies a contracted skeleton, or refutes it. `k` is the kernel below the perturbation; `raw` must have been certified. It is looked at
/// by itself first (places, times, faces around each node) and then compared with what contraction makes of the raw skeleton. Expected linear time,
/// but for sorting.
template <kernel<2> K>
std::optional<refutation> verify_contraction(const K& k, const boundary& polygon, const skeleton& raw, const contracted_skeleton& contracted) {
  return contraction_verifier<K>(k, polygon, raw, contracted).run();
}

}  // namespace osteon::plane
