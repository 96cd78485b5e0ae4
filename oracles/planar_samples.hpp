// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Polygons to compare the planar oracles on: small ones by hand, and random ones with and without coincidences. Shares nothing with the library.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planar_node.hpp"

namespace osteon::oracles {

/// Reproducible random numbers (splitmix64).
class planar_dice {
 public:
  explicit planar_dice(std::uint64_t seed) : state_(seed) {}
  long between(long low, long high) {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
    z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
    return low + static_cast<long>((z ^ z >> 31U) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

using planar_ring = std::vector<std::array<double, 2>>;

struct planar_sample {
  std::string name;
  planar_input input;
};

/// Corner i of n on a circle around a place, rounded to integers.
inline std::array<double, 2> on_circle(int i, int n, double radius, double x = 0, double y = 0) {
  const double angle = 2 * 3.14159265358979323846 * i / n;
  return {std::round(x + radius * std::cos(angle)), std::round(y + radius * std::sin(angle))};
}

/// A polygon that sees the origin from everywhere, as large as a million.
inline planar_ring star_ring(int n, std::uint64_t seed) {
  planar_dice roll(seed);
  planar_ring ring;
  for (int i = 0; i < n; ++i) ring.push_back(on_circle(i, n, static_cast<double>(roll.between(300'000, 1'000'000))));
  return ring;
}

/// A star with holes, which are stars that touch nothing: in a middle that the outer ring leaves free.
inline planar_input starred_plate(int n, int holes, std::uint64_t seed) {
  planar_dice roll(seed);
  planar_input result;
  planar_ring outer = star_ring(n, seed);
  for (auto& p : outer)
    for (double& x : p) x = 3 * x;  // n >= 8 leaves a circle of 0.6 million
  result.rings.push_back(outer);
  for (int h = 0; h < holes; ++h) {
    const auto middle = holes == 1 ? std::array<double, 2>{0, 0} : on_circle(h, holes, 350'000);
    const double radius = holes == 1 ? 500'000 : std::min(240'000.0, 1'000'000.0 / holes);
    const int k = static_cast<int>(roll.between(3, 7));
    planar_ring ring;
    for (int i = 0; i < k; ++i) ring.push_back(on_circle(-i, k, radius * static_cast<double>(roll.between(300, 999)) / 1000, middle[0], middle[1]));
    result.rings.push_back(ring);
  }
  return result;
}

/// Whether segments pq and rs have a point in common (small integers only).
inline bool segments_meet(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r,
                          const std::array<double, 2>& s) {
  const auto turn = [](const auto& a, const auto& b, const auto& c) {
    const double d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  };
  for (const std::size_t axis : {0U, 1U})
    if (std::max(p[axis], q[axis]) < std::min(r[axis], s[axis]) || std::max(r[axis], s[axis]) < std::min(p[axis], q[axis])) return false;
  return turn(p, q, r) * turn(p, q, s) <= 0 && turn(r, s, p) * turn(r, s, q) <= 0;
}

/// A simple polygon of at most n corners with integer coordinates in 0 .. extent, grown a corner at a time across random edges, seldom star-shaped. A
/// small extent makes many coincidences: collinear and parallel edges, equal angles.
inline planar_ring grown_ring(int n, long extent, std::uint64_t seed) {
  planar_dice roll(seed);
  const auto top = static_cast<double>(extent);
  planar_ring ring = {{0, 0}, {top, 0}, {std::floor(top / 2), top}};
  for (int tries = 0; static_cast<int>(ring.size()) < n && tries < 60 * n; ++tries) {
    const std::array<double, 2> fresh = {static_cast<double>(roll.between(0, extent)), static_cast<double>(roll.between(0, extent))};
    const auto at = static_cast<std::size_t>(roll.between(0, static_cast<long>(ring.size()) - 1));
    const std::size_t next = (at + 1) % ring.size();
    bool free = true;
    for (std::size_t i = 0; i < ring.size() && free; ++i) {
      const std::size_t j = (i + 1) % ring.size();
      free = ring[i] != fresh && !segments_meet(ring[i], ring[j], fresh, fresh);
      if (i != at && j != at) free = free && !segments_meet(ring[at], fresh, ring[i], ring[j]);
      if (i != next && j != next) free = free && !segments_meet(ring[next], fresh, ring[i], ring[j]);
      // The new edges may not lie on the old ones that they meet in a corner.
      for (const std::size_t end : {at, next}) {
        const std::size_t other = i == end ? j : i;
        if ((i == end || j == end) && other != at && other != next) free = free && !segments_meet(ring[other], ring[other], ring[end], fresh);
      }
    }
    if (free) ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at) + 1, fresh);
  }
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& p = ring[i];
    const auto& q = ring[(i + 1) % ring.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  if (area < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// The outline of connected unit squares that meet in no corner only, with holes: full of coincidences. With `all`, corners lie on straight sides
/// too. May be empty.
inline planar_input grid_outline(int width, int height, int percent, bool all, std::uint64_t seed) {
  planar_dice roll(seed);
  std::vector<std::vector<char>> full(static_cast<std::size_t>(width) + 2, std::vector<char>(static_cast<std::size_t>(height) + 2));
  auto body = full;
  for (std::size_t x = 1; x + 1 < full.size(); ++x)
    for (std::size_t y = 1; y + 1 < full[x].size(); ++y) full[x][y] = roll.between(0, 99) < percent ? 1 : 0;
  std::vector<std::array<std::size_t, 2>> stack = {{1, 1}};
  full[1][1] = 1;
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    if (full[x][y] == 0 || body[x][y] != 0) continue;
    body[x][y] = 1;
    stack.insert(stack.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
  }
  using corner = std::array<int, 2>;
  std::map<corner, corner> next;
  for (int x = 0; x <= width; ++x)
    for (int y = 0; y <= height; ++y) {
      const auto at = [&](int dx, int dy) { return body[static_cast<std::size_t>(x + dx)][static_cast<std::size_t>(y + dy)] != 0; };
      if (at(0, 0) == at(1, 1) && at(1, 0) == at(0, 1) && at(0, 0) != at(1, 0)) return {};
      if (!at(0, 0)) continue;
      if (!at(0, -1)) next[{x, y}] = {x + 1, y};
      if (!at(1, 0)) next[{x + 1, y}] = {x + 1, y + 1};
      if (!at(0, 1)) next[{x + 1, y + 1}] = {x, y + 1};
      if (!at(-1, 0)) next[{x, y + 1}] = {x, y};
    }
  planar_input result;
  while (!next.empty()) {  // the lowest corner is on the outer ring
    std::vector<corner> ring;
    for (auto p = next.begin()->first; next.count(p) != 0;) {
      ring.push_back(p);
      const corner q = next[p];
      next.erase(p);
      p = q;
    }
    planar_ring& points = result.rings.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const corner& a = ring[(i + ring.size() - 1) % ring.size()];
      const corner& b = ring[i];
      const corner& c = ring[(i + 1) % ring.size()];
      if (all || (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0]))
        points.push_back({static_cast<double>(b[0]), static_cast<double>(b[1])});
    }
  }
  return result;
}

/// Small polygons whose skeletons can be drawn by hand, and regular ones, rounded to integers.
inline std::vector<planar_sample> plain_samples() {
  std::vector<planar_sample> result = {
      {"triangle", {{{{0, 0}, {4, 0}, {0, 3}}}, {}}},
      {"square", {{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {}}},
      {"rectangle", {{{{0, 0}, {5, 0}, {5, 2}, {0, 2}}}, {}}},
      {"L", {{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}}, {}}},
      {"uneven L", {{{{0, 0}, {7, 0}, {7, 2}, {3, 2}, {3, 6}, {0, 6}}}, {}}},
      {"U", {{{{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}}, {}}},
      {"T", {{{{0, 4}, {2, 4}, {2, 0}, {4, 0}, {4, 4}, {6, 4}, {6, 6}, {0, 6}}}, {}}},
      {"plus", {{{{2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 4}, {4, 4}, {4, 6}, {2, 6}, {2, 4}, {0, 4}, {0, 2}, {2, 2}}}, {}}},
      {"frame", {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}, {}}},
      {"off the middle", {{{{0, 0}, {10, 0}, {10, 9}, {0, 9}}, {{2, 3}, {2, 6}, {5, 6}, {5, 3}}}, {}}},
      {"dent", {{{{0, 0}, {10, 0}, {10, 6}, {6, 6}, {5, 3}, {4, 6}, {0, 6}}}, {}}},
      {"two dents that meet", {{{{0, 0}, {4, 0}, {5, 2}, {6, 0}, {10, 0}, {10, 6}, {6, 6}, {5, 4}, {4, 6}, {0, 6}}}, {}}},
      {"tooth", {{{{0, 0}, {4, 0}, {5, -1}, {6, 0}, {10, 0}, {10, 6}, {0, 6}}}, {}}},
      {"straight corners", {{{{0, 0}, {3, 0}, {6, 0}, {6, 2}, {6, 4}, {0, 4}}}, {}}},
      {"star", {{{{0, 10}, {-2, 3}, {-9, 3}, {-4, -1}, {-6, -8}, {0, -4}, {6, -8}, {4, -1}, {9, 3}, {2, 3}}}, {}}},
  };
  for (const int n : {5, 6, 7, 8, 12}) {
    planar_ring ring;
    for (int i = 0; i < n; ++i) ring.push_back(on_circle(i, n, 1'000'000));
    result.push_back({std::to_string(n) + " corners on a circle", {{ring}, {}}});
  }
  for (const int n : {3, 4, 6, 8}) {
    planar_ring ring;
    for (int i = 0; i < 2 * n; ++i) ring.push_back(on_circle(i, 2 * n, i % 2 == 0 ? 1'000'000 : 400'000));
    result.push_back({"star of " + std::to_string(n), {{ring}, {}}});
  }
  return result;
}

/// Random weights of a few tenths to a few units, exact in binary.
inline planar_input weighted(planar_input input, std::uint64_t seed) {
  planar_dice roll(seed);
  input.weights.clear();
  for (const auto& ring : input.rings) {
    auto& w = input.weights.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) w.push_back(static_cast<double>(roll.between(16, 128)) / 32);
  }
  return input;
}

}  // namespace osteon::oracles
