// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Straight skeletons by shrinking the polygon event by event (Aichholzer, Aurenhammer, Alberts, Gaertner 1995; thesis 2.1), with brute force: every
/// reflex vertex is tried against every edge. Events at one moment are taken together: the wavefront is cut at all places where something happens,
/// what lies on both sides of a vanished sliver cancels, and at each place the edges that are left are joined anew, each with its neighbour across a
/// wedge of the interior. This covers all coincidences of polygons without weights.

#include <algorithm>
#include <cstddef>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "planar_lines.hpp"
#include "planar_node.hpp"

namespace osteon::oracles {

class planar_simulation {
 public:
  explicit planar_simulation(const planar_input& input) : in_(input) {
    start();
    long rounds = 100 + 20 * static_cast<long>(in_.edges.size());
    while (next_moment()) {
      if (--rounds < 0) throw planar_give_up("the simulation does not come to an end");
      rebuild();
    }
    const bool held = std::any_of(in_.edges.begin(), in_.edges.end(), [](const planar_edge& e) { return e.weight == 0; });
    for (const segment& s : segments_)
      if (s.alive && !held) throw planar_give_up("a part of the wavefront does not vanish");
    sort_by_time(nodes_);
  }

  const std::vector<planar_node>& nodes() const { return nodes_; }

 private:
  struct vertex {
    int in, out;  // segments
    moving_spot path;
    bool alive = true;
  };
  struct segment {
    int line, from, to;  // vertices
    bool alive = true;
  };
  struct event {
    real time;
    int vertex;  // that hits `what`, a line; or -1: `what` is a segment that vanishes
    int what;
  };
  struct later {
    bool operator()(const event& a, const event& b) const { return a.time > b.time; }
  };

  void start() {
    std::size_t first = 0;
    while (first < in_.edges.size()) {
      std::vector<int> ring;  // lines of its wavefront edges
      for (std::size_t e = first;; e = static_cast<std::size_t>(in_.next[e])) {
        if (ring.empty() || ring.back() != in_.line[e]) ring.push_back(in_.line[e]);
        if (static_cast<std::size_t>(in_.next[e]) == first) {
          first = e + 1;
          break;
        }
      }
      if (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
      if (ring.size() < 3) throw std::invalid_argument("a ring without area");
      const int n = static_cast<int>(ring.size());
      const int base = static_cast<int>(segments_.size());
      for (int i = 0; i < n; ++i) {
        segments_.push_back({ring[static_cast<std::size_t>(i)], base + i, base + (i + 1) % n});
        vertices_.push_back({base + (i + n - 1) % n, base + i, in_.meeting(ring[static_cast<std::size_t>((i + n - 1) % n)], segments_.back().line)});
      }
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      expect_end(static_cast<int>(i));
      expect_hits(static_cast<int>(i));
    }
  }

  vertex& v(int i) { return vertices_[static_cast<std::size_t>(i)]; }
  segment& s(int i) { return segments_[static_cast<std::size_t>(i)]; }
  const front_line& line(int i) const { return in_.lines[static_cast<std::size_t>(i)]; }

  void expect_end(int i) {
    const segment& e = s(i);
    const moving_spot& from = v(e.from).path;
    const moving_spot& to = v(e.to).path;
    const real growth = dot(to.velocity - from.velocity, line(e.line).direction);
    if (growth >= 0) return;
    const real time = -dot(to.start - from.start, line(e.line).direction) / growth;
    if (time <= now_) throw planar_give_up("an edge without length");
    events_.push({time, -1, i});
  }

  // Only reflex vertices hit edges: a convex one is caught between edges that vanish first.
  void expect_hits(int i) {
    const vertex& w = v(i);
    const int a = s(w.in).line;
    const int b = s(w.out).line;
    if (cross(line(a).direction, line(b).direction) > 0) return;
    const spot place = w.path.at(now_);
    for (std::size_t e = 0; e < in_.line.size(); ++e) {
      const int c = static_cast<int>(e);
      if (in_.line[e] != c || c == a || c == b) continue;
      const front_line& l = in_.lines[e];
      const real speed = l.weight - dot(l.normal, w.path.velocity);
      if (speed <= 0) continue;
      const real height = dot(l.normal, place) - l.offset - now_ * l.weight;
      if (height <= in_.tiny) continue;
      events_.push({now_ + height / speed, i, c});
    }
  }

  bool holds(const segment& e, const spot& p, const real& t) {
    const spot& d = line(e.line).direction;
    return dot(p - v(e.from).path.at(t), d) >= -in_.tiny && dot(v(e.to).path.at(t) - p, d) >= -in_.tiny;
  }

  std::size_t place_at(const spot& p) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (abs(places_[i].x - p.x) <= in_.tiny && abs(places_[i].y - p.y) <= in_.tiny) return i;
    return none;
  }
  void add_place(const spot& p) {
    if (place_at(p) == none) places_.push_back(p);
  }

  // Finds the next time at which something happens, and all places where.
  bool next_moment() {
    places_.clear();
    while (!events_.empty() && (places_.empty() || events_.top().time <= now_ + in_.tiny_time)) {
      const event e = events_.top();
      events_.pop();
      spot place;
      if (e.vertex < 0) {
        if (!s(e.what).alive) continue;
        place = v(s(e.what).from).path.at(e.time);
      } else {
        const vertex& w = v(e.vertex);
        if (!w.alive) continue;
        place = w.path.at(e.time);
        const bool hit =
            std::any_of(segments_.begin(), segments_.end(), [&](const segment& g) { return g.alive && g.line == e.what && holds(g, place, e.time); });
        if (!hit) continue;
      }
      if (places_.empty()) {
        if (e.time < now_) throw planar_give_up("time runs backwards");
        now_ = e.time;
      }
      add_place(place);
    }
    return !places_.empty();
  }

  // A part of a wavefront edge between places where something happens (numbers of places) or old vertices (-1 - vertex).
  struct piece {
    int line, from, to;
    bool cancelled = false;
    int before = -1, after = -1;  // pieces of the same line that continue it
    int segment = -1;
  };

  void rebuild() {
    std::vector<std::vector<int>> lines(places_.size());
    std::vector<piece> pieces;
    std::vector<int> dying;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (segments_[i].alive && cut(segments_[i], lines, pieces)) {
        segments_[i].alive = false;
        dying.push_back(segments_[i].from);
        dying.push_back(segments_[i].to);
      }
    for (std::size_t p = 0; p < places_.size(); ++p) nodes_.push_back(in_.node(places_[p], now_, lines[p]));
    // A node is where at least three lines meet.
    nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), [](const planar_node& n) { return n.edges.size() < 3; }), nodes_.end());
    cancel(pieces);
    std::vector<std::array<int, 2>> wedges;  // a piece that comes in and one that goes out
    for (std::size_t p = 0; p < places_.size(); ++p) join(static_cast<int>(p), pieces, wedges);
    replace(pieces, wedges, dying);
  }

  // Appends what is left of a segment, if it meets a place.
  bool cut(const segment& e, std::vector<std::vector<int>>& lines, std::vector<piece>& pieces) {
    const front_line& l = line(e.line);
    std::vector<std::pair<real, int>> stops;
    const spot from = v(e.from).path.at(now_);
    const real length = dot(v(e.to).path.at(now_) - from, l.direction);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (abs(dot(l.normal, places_[p]) - l.offset - now_ * l.weight) > in_.tiny) continue;
      const real along = dot(places_[p] - from, l.direction);
      if (along < -in_.tiny || along > length + in_.tiny) continue;
      stops.emplace_back(along, static_cast<int>(p));
      lines[p].push_back(e.line);
    }
    if (stops.empty()) return false;
    std::sort(stops.begin(), stops.end());
    if (stops.front().first > in_.tiny) pieces.push_back({e.line, -1 - e.from, stops.front().second});
    for (std::size_t k = 1; k < stops.size(); ++k) pieces.push_back({e.line, stops[k - 1].second, stops[k].second});
    if (stops.back().first < length - in_.tiny) pieces.push_back({e.line, stops.back().second, -1 - e.to});
    return true;
  }

  static void cancel(std::vector<piece>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = i + 1; j < pieces.size(); ++j) {
        piece& a = pieces[i];
        piece& b = pieces[j];
        if (a.cancelled || b.cancelled || a.from < 0 || a.to < 0) continue;
        if (a.from == b.from && a.to == b.to) throw planar_give_up("two edges lie on each other");
        if (a.from == b.to && a.to == b.from) a.cancelled = b.cancelled = true;
      }
  }

  // Pairs the pieces at a place: after each one that goes out, counter-clockwise, follows the one that comes in on the other side of the wedge.
  void join(int place, std::vector<piece>& pieces, std::vector<std::array<int, 2>>& wedges) {
    struct ray {
      spot direction;
      int piece;
      bool out;
    };
    std::vector<ray> rays;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].cancelled) continue;
      const spot& d = line(pieces[i].line).direction;
      if (pieces[i].from == place) rays.push_back({d, static_cast<int>(i), true});
      if (pieces[i].to == place) rays.push_back({real(-1) * d, static_cast<int>(i), false});
    }
    const real flat("1e-40");
    const auto lower = [&flat](const spot& d) { return d.y < -flat || (abs(d.y) <= flat && d.x < 0); };
    std::sort(rays.begin(), rays.end(), [&](const ray& a, const ray& b) {
      if (lower(a.direction) != lower(b.direction)) return lower(b.direction);
      return cross(a.direction, b.direction) > flat;
    });
    if (in_.weighted && rays.size() > 2) {
      std::vector<int> passing;
      for (const ray& a : rays)
        for (const ray& b : rays)
          if (a.out && !b.out && pieces[static_cast<std::size_t>(a.piece)].line == pieces[static_cast<std::size_t>(b.piece)].line)
            passing.push_back(a.piece);
      if (rays.size() != 4 || passing.size() != 1) throw planar_give_up("with weights, vertices that meet are ambiguous");
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const ray& a = rays[i];
      const ray& b = rays[(i + 1) % rays.size()];
      if (a.out == b.out) throw planar_give_up("the wavefront passes through itself");
      if (!a.out) continue;
      const real turn = cross(a.direction, b.direction);
      if (abs(turn) <= flat && dot(a.direction, b.direction) > 0) throw planar_give_up("a wedge without angle");
      piece& in = pieces[static_cast<std::size_t>(b.piece)];
      piece& out = pieces[static_cast<std::size_t>(a.piece)];
      if (in.line != out.line) {
        wedges.push_back({b.piece, a.piece});
        continue;
      }
      in.after = a.piece;
      out.before = b.piece;
    }
  }

  void replace(std::vector<piece>& pieces, const std::vector<std::array<int, 2>>& wedges, const std::vector<int>& dying) {
    for (const int w : dying) v(w).alive = false;
    std::vector<int> fresh;
    for (piece& first : pieces) {
      if (first.cancelled || first.before >= 0) continue;
      const int id = static_cast<int>(segments_.size());
      piece* last = &first;
      last->segment = id;
      while (last->after >= 0) {
        last = &pieces[static_cast<std::size_t>(last->after)];
        last->segment = id;
      }
      segments_.push_back({first.line, -1, -1});
      fresh.push_back(id);
      if (first.from < 0) keep(-1 - first.from).out = id, s(id).from = -1 - first.from;
      if (last->to < 0) keep(-1 - last->to).in = id, s(id).to = -1 - last->to;
    }
    std::vector<int> born;
    for (const auto& [in, out] : wedges) {
      const int before = pieces[static_cast<std::size_t>(in)].segment;
      const int after = pieces[static_cast<std::size_t>(out)].segment;
      const int id = static_cast<int>(vertices_.size());
      vertices_.push_back({before, after, in_.meeting(s(before).line, s(after).line)});
      s(before).to = s(after).from = id;
      born.push_back(id);
    }
    for (const int id : fresh) {
      if (s(id).from < 0 || s(id).to < 0) throw planar_give_up("a loop of the wavefront is open");
      expect_end(id);
    }
    for (const int id : born) expect_hits(id);
  }

  vertex& keep(int i) {
    v(i).alive = true;
    return v(i);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  planar_lines in_;
  std::vector<vertex> vertices_;
  std::vector<segment> segments_;
  std::priority_queue<event, std::vector<event>, later> events_;
  std::vector<spot> places_;
  real now_ = 0;
  std::vector<planar_node> nodes_;
};

/// The skeleton's nodes by simulation, with or without weights. Throws planar_give_up where, with weights, parallel edges or several vertices meet,
/// which is ambiguous (Huber 2011), and where the input is not valid in a way that shows. O(n r log n) for r reflex vertices, and O(n) an event.
inline std::vector<planar_node> nodes_by_simulation(const planar_input& input) { return planar_simulation(input).nodes(); }

}  // namespace osteon::oracles
