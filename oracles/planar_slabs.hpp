// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The roof of a polygon without weights as the lower envelope of slabs (Eppstein, Erickson 1999; Cheng, Vigneron 2002; thesis 2.4.1, 2.5): no
/// process, no order of events. Each edge has a slab over the strip before it; each reflex vertex has two more, in the planes of its edges, above the
/// track that its motorcycle leaves until it crashes. The motorcycle graph is found by brute force. Motorcycles that crash into each other at one
/// moment go on as one if what is left of their edges is reflex (Huber, Held 2012).

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "planar_lines.hpp"
#include "planar_node.hpp"

namespace osteon::oracles {

class planar_slabs {
 public:
  explicit planar_slabs(const planar_input& input) : in_(input) {
    if (in_.weighted || in_.lines[0].weight <= 0) throw planar_give_up("with weights the roof is no lower envelope of slabs");
    by_line_.resize(in_.edges.size());
    for (std::size_t e = 0; e < in_.edges.size(); ++e) {
      const spot& d = in_.lines[e].direction;
      add({in_.line[e], dot(d, in_.point(in_.edges[e].from)), dot(d, in_.point(in_.edges[e].to)), 0, 0});
    }
    ride();
    for (const motorcycle& m : motorcycles_)
      for (const int e : {m.in, m.out}) {
        const spot& d = line(e).direction;
        slab s = {in_.line[static_cast<std::size_t>(e)], dot(d, m.start), dot(d, m.end), m.started, m.crashed};
        if (s.low > s.high) std::swap(s.low, s.high), std::swap(s.low_time, s.high_time);
        add(s);
      }
  }

  /// When the wavefront reaches a place (in the polygon's coordinates): the roof's height over it. Nothing outside of the polygon. O(n).
  std::optional<double> height(double x, double y) const {
    const auto h = lowest(spot{real(x), real(y)} - in_.origin, in_.tiny);
    if (!h) return {};
    return h->convert_to<double>();
  }

  /// The edges (one for each line) whose faces contain a place: whose slabs are the lowest somewhere arbitrarily near. Slabs that pass within
  /// `tolerance`, a length, pass through it.
  std::vector<int> faces_at(double x, double y, double tolerance) const {
    return faces(spot{real(x), real(y)} - in_.origin, std::max(real(tolerance), in_.tiny));
  }

  /// Whether the roof is as high as the node says, and whether its edges are exactly those whose faces lie there. O(n).
  bool agrees(const planar_node& node, double tolerance) const {
    const spot p = spot{real(node.x), real(node.y)} - in_.origin;
    const real near = std::max(real(tolerance), in_.tiny);
    const auto h = lowest(p, near);
    if (!h || abs(real(*h - node.time)) * line(0).weight > near) return false;
    std::vector<int> edges;
    for (const int e : node.edges) {
      if (e < 0 || e >= static_cast<int>(in_.line.size())) return false;
      edges.push_back(in_.line[static_cast<std::size_t>(e)]);
    }
    return in_.node(p, *h, edges).edges == faces(p, near);
  }

  /// All nodes: every triple of lines, where it meets on the envelope. O(n^3) and more for the few that do.
  std::vector<planar_node> nodes() const {
    std::vector<int> lines;
    for (std::size_t e = 0; e < in_.line.size(); ++e)
      if (in_.line[e] == static_cast<int>(e)) lines.push_back(static_cast<int>(e));
    std::vector<planar_node> result;
    std::vector<spot> known;
    const auto look = [&](const moving_spot& m, int a, int b, int c) {
      const real closing = line(c).weight - dot(line(c).normal, m.velocity);
      if (abs(closing) < real("1e-45")) return;
      const real t = (dot(line(c).normal, m.start) - line(c).offset) / closing;
      if (t <= in_.tiny_time) return;
      const spot p = m.at(t);
      for (const int e : {c, a, b})
        if (!covers(e, p)) return;
      if (std::any_of(known.begin(), known.end(), [&](const spot& q) { return abs(p.x - q.x) <= in_.tiny && abs(p.y - q.y) <= in_.tiny; })) return;
      const auto h = lowest(p, in_.tiny);
      if (!h || *h < t - in_.tiny_time) return;
      known.push_back(p);
      planar_node n = in_.node(p, t, faces(p, in_.tiny));
      if (n.edges.size() >= 3) result.push_back(std::move(n));
    };
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = i + 1; j < lines.size(); ++j) {
        const int a = lines[i];
        const int b = lines[j];
        const bool parallel = are_parallel(a, b);
        std::optional<moving_spot> m;
        if (!parallel) m = in_.meeting(a, b);
        for (std::size_t k = j + 1; k < lines.size(); ++k) {
          if (!parallel) {
            look(*m, a, b, lines[k]);
          } else if (!are_parallel(a, lines[k])) {
            look(in_.meeting(a, lines[k]), a, lines[k], b);
          }
        }
      }
    sort_by_time(result);
    return result;
  }

 private:
  // A part of the plane in which a line rises: over low <= direction . x <= high, and not below the line from low_time to high_time.
  struct slab {
    int line;
    real low, high, low_time, high_time;

    real slope() const { return high > low ? real((high_time - low_time) / (high - low)) : real(0); }
    real bottom(const real& s) const { return low_time + slope() * (s - low); }
  };
  struct motorcycle {
    int in, out;  // edges
    spot start, velocity;
    real started;
    bool rides = true;
    spot end{};
    real crashed = 0;

    spot at(const real& t) const { return start + (t - started) * velocity; }
  };
  struct crash {
    real time;
    int rider;
    int other;  // a motorcycle that has been there, or -1: a wall
    real other_time;
  };
  struct later {
    bool operator()(const crash& a, const crash& b) const { return a.time > b.time; }
  };

  const front_line& line(int i) const { return in_.lines[static_cast<std::size_t>(i)]; }
  motorcycle& rider(int i) { return motorcycles_[static_cast<std::size_t>(i)]; }
  bool are_parallel(int a, int b) const { return abs(cross(line(a).normal, line(b).normal)) < real("1e-40"); }
  void add(const slab& s) { by_line_[static_cast<std::size_t>(s.line)].push_back(s); }

  // The slab's height over a place, above its bottom; nothing beside it.
  std::optional<real> rise(const slab& s, const spot& p, const real& near) const {
    const real along = dot(line(s.line).direction, p);
    if (along < s.low - near || along > s.high + near) return {};
    const real h = in_.height(s.line, p, 0) / line(s.line).weight;
    if ((h - s.bottom(along)) * line(s.line).weight < -near) return {};
    return h;
  }
  bool covers(int e, const spot& p) const {
    const auto& slabs = by_line_[static_cast<std::size_t>(e)];
    return std::any_of(slabs.begin(), slabs.end(), [&](const slab& s) { return rise(s, p, in_.tiny).has_value(); });
  }

  // By the number of edges to the right. Places on the boundary may be anything: an edge's slab has height zero there.
  bool inside(const spot& p) const {
    bool result = false;
    for (const planar_edge& e : in_.edges) {
      const spot from = in_.point(e.from) - p;
      const spot to = in_.point(e.to) - p;
      if ((from.y > 0) != (to.y > 0) && (cross(from, to) > 0) == (to.y > from.y)) result = !result;
    }
    return result;
  }

  std::optional<real> lowest(const spot& p, const real& near) const {
    if (!inside(p)) return {};
    std::optional<real> result;
    for (const auto& slabs : by_line_)
      for (const slab& s : slabs)
        if (const auto h = rise(s, p, near); h && (!result || *h < *result)) result = h;
    return result;
  }

  // Cuts the directions around p where the order of the slabs can change, and asks for the lowest in the middle of each sector.
  std::vector<int> faces(const spot& p, const real& near) const {
    struct local {
      int line;
      std::vector<spot> limits;  // the slab lies where all products with these are positive
    };
    const auto h = lowest(p, near);
    if (!h) return {};
    const real& weight = line(0).weight;
    std::vector<local> slabs;
    for (const auto& of_line : by_line_)
      for (const slab& s : of_line) {
        const auto r = rise(s, p, near);
        if (!r || (*r - *h) * weight > near) continue;
        const spot& d = line(s.line).direction;
        const real along = dot(d, p);
        local& fresh = slabs.emplace_back(local{s.line, {}});
        if (abs(along - s.low) <= near) fresh.limits.push_back(d);
        if (abs(along - s.high) <= near) fresh.limits.push_back(real(-1) * d);
        if (abs(*r - s.bottom(along)) * weight <= near) fresh.limits.push_back(line(s.line).normal - weight * s.slope() * d);
      }
    const real flat("1e-30");
    std::vector<spot> cuts;
    const auto cut = [&](const spot& across) {
      const real length = sqrt(dot(across, across));
      if (length <= flat) return;
      const spot u = real(1 / length) * spot{-across.y, across.x};
      cuts.push_back(u);
      cuts.push_back(real(-1) * u);
    };
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      for (const spot& l : slabs[i].limits) cut(l);
      for (std::size_t j = 0; j < i; ++j) cut(line(slabs[i].line).normal - line(slabs[j].line).normal);
    }
    if (cuts.empty()) return slabs.empty() ? std::vector<int>() : std::vector<int>{slabs[0].line};
    const auto lower = [&flat](const spot& d) { return d.y < -flat || (abs(d.y) <= flat && d.x < 0); };
    std::sort(cuts.begin(), cuts.end(), [&](const spot& a, const spot& b) {
      if (lower(a) != lower(b)) return lower(b);
      return cross(a, b) > flat;
    });
    std::vector<int> result;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const spot& a = cuts[i];
      const spot& b = cuts[(i + 1) % cuts.size()];
      if (abs(cross(a, b)) <= flat && dot(a, b) > 0) continue;
      const spot middle = abs(cross(a, b)) <= flat ? spot{-a.y, a.x} : a + b;
      std::optional<real> least;
      std::vector<int> at;
      for (const local& s : slabs) {
        if (std::any_of(s.limits.begin(), s.limits.end(), [&](const spot& l) { return dot(l, middle) < 0; })) continue;
        const real rate = dot(line(s.line).normal, middle);
        if (!least || rate < *least - flat) least = rate, at.clear();
        if (rate <= *least + flat) at.push_back(s.line);
      }
      std::sort(at.begin(), at.end());
      result = united(result, at);
    }
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // ---- the motorcycle graph

  void ride() {
    for (std::size_t e = 0; e < in_.edges.size(); ++e) {
      const int next = in_.next[e];
      if (in_.line[e] != in_.line[static_cast<std::size_t>(next)] && is_reflex(static_cast<int>(e), next))
        launch(static_cast<int>(e), next, in_.point(in_.edges[e].to), 0);
    }
    while (!crashes_.empty()) {
      const real now = crashes_.top().time;
      std::vector<crash> together;
      while (!crashes_.empty() && crashes_.top().time <= now + in_.tiny_time) {
        const crash& c = crashes_.top();
        if (rider(c.rider).rides && (c.other < 0 || has_been(rider(c.other), c.other_time))) together.push_back(c);
        crashes_.pop();
      }
      while (!together.empty()) {
        const spot place = rider(together[0].rider).at(together[0].time);
        const auto here = std::partition(together.begin(), together.end(), [&](const crash& c) {
          const spot q = rider(c.rider).at(c.time);
          return abs(q.x - place.x) > in_.tiny || abs(q.y - place.y) > in_.tiny;
        });
        const std::vector<crash> group(here, together.end());
        together.erase(here, together.end());
        end(group, place, now);
      }
    }
    for (const motorcycle& m : motorcycles_)
      if (m.rides) throw planar_give_up("a motorcycle leaves the polygon");
  }

  bool is_reflex(int a, int b) const { return cross(line(a).direction, line(b).direction) < real("-1e-40"); }
  bool has_been(const motorcycle& m, const real& t) const { return m.rides || m.crashed >= t - in_.tiny_time; }

  void launch(int in, int out, const spot& start, const real& now) {
    if (motorcycles_.size() > 4 * in_.edges.size()) throw planar_give_up("too many motorcycles");
    const int id = static_cast<int>(motorcycles_.size());
    motorcycles_.push_back({in, out, start, in_.meeting(in, out).velocity, now});
    const motorcycle& m = motorcycles_.back();
    for (std::size_t e = 0; e < in_.edges.size(); ++e) {
      const front_line& l = in_.lines[e];
      const real speed = -dot(l.normal, m.velocity);
      if (speed <= 0) continue;
      const real height = dot(l.normal, start) - l.offset;
      if (height <= in_.tiny) continue;
      const real time = now + height / speed;
      const real along = dot(l.direction, m.at(time));
      if (along < dot(l.direction, in_.point(in_.edges[e].from)) - in_.tiny || along > dot(l.direction, in_.point(in_.edges[e].to)) + in_.tiny)
        continue;
      crashes_.push({time, id, -1, 0});
    }
    for (int i = 0; i < id; ++i) meet(i, id);
  }

  // Where two tracks cross, the later one crashes.
  void meet(int i, int j) {
    const motorcycle& a = rider(i);
    const motorcycle& b = rider(j);
    const spot between = b.start - a.start;
    const real det = cross(a.velocity, b.velocity);
    const real size = sqrt(dot(a.velocity, a.velocity) * dot(b.velocity, b.velocity));
    if (abs(det) <= size * real("1e-40")) {  // towards each other on one line, or not at all
      if (dot(a.velocity, b.velocity) > 0 || abs(cross(between, a.velocity)) > in_.tiny * sqrt(size) || dot(between, a.velocity) <= 0) return;
      const spot closing = a.velocity - b.velocity;
      const real started = std::max(a.started, b.started);
      const real time = started + dot(b.at(started) - a.at(started), closing) / dot(closing, closing);
      if (time < started) return;
      crashes_.push({time, i, j, time});
      crashes_.push({time, j, i, time});
      return;
    }
    const real ta = a.started + cross(between, b.velocity) / det;
    const real tb = b.started + cross(between, a.velocity) / det;
    if (ta < a.started - in_.tiny_time || tb < b.started - in_.tiny_time) return;
    if (ta <= a.started + in_.tiny_time || tb <= b.started + in_.tiny_time) {
      // A track that begins on another: at a vertex there is a wall, and where motorcycles were joined their ends are there.
      return;
    }
    if (ta >= tb - in_.tiny_time) crashes_.push({ta, i, j, tb});
    if (tb >= ta - in_.tiny_time) crashes_.push({tb, j, i, ta});
  }

  void end(const std::vector<crash>& group, const spot& place, const real& now) {
    std::vector<int> riders;
    bool onto_old = false;
    for (const crash& c : group) {
      motorcycle& m = rider(c.rider);
      m.rides = false;
      m.end = place;
      m.crashed = now;
      if (std::find(riders.begin(), riders.end(), c.rider) == riders.end()) riders.push_back(c.rider);
      onto_old = onto_old || c.other < 0 || c.other_time < now - in_.tiny_time;
    }
    if (onto_old || riders.size() < 2) return;
    // Around the place, counter-clockwise, by where they come from; behind each follows its outgoing edge, before the next one's incoming edge.
    const auto lower = [](const spot& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
    std::sort(riders.begin(), riders.end(), [&](int i, int j) {
      const spot a = real(-1) * rider(i).velocity;
      const spot b = real(-1) * rider(j).velocity;
      return lower(a) != lower(b) ? lower(b) : cross(a, b) > 0;
    });
    for (std::size_t k = 0; k < riders.size(); ++k) {
      const motorcycle& a = rider(riders[k]);
      const motorcycle& b = rider(riders[(k + 1) % riders.size()]);
      if (cross(a.velocity, b.velocity) > real("-1e-40")) continue;  // they close this side between them
      const int out = a.out;
      const int in = b.in;
      if (in_.line[static_cast<std::size_t>(in)] == in_.line[static_cast<std::size_t>(out)] || !is_reflex(in, out)) continue;
      launch(in, out, place, now);
      return;
    }
  }

  planar_lines in_;
  std::vector<std::vector<slab>> by_line_;
  std::vector<motorcycle> motorcycles_;
  std::priority_queue<crash, std::vector<crash>, later> crashes_;
};

/// The skeleton's nodes from the envelope, without weights. O(n^3): for up to about a hundred edges.
inline std::vector<planar_node> nodes_by_slabs(const planar_input& input) { return planar_slabs(input).nodes(); }

}  // namespace osteon::oracles
