// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Whether the contracted skeletons of two images of one solid are the same complex.

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "osteon/evaluate/meeting.hpp"
#include "osteon/space/contract.hpp"
#include "support.hpp"

namespace osteon::test {

/// A contracted skeleton with the places of its nodes in the units of the input.
struct placed_skeleton {
  contracted_skeleton complex;
  std::vector<std::array<double, 3>> points;
};

inline placed_skeleton placed(const input_mesh<integer>& m, const skeleton_options& o = {}) {
  const auto s = make_solid(m);
  const auto k = default_kernel(s);
  const auto raw = straight_skeleton(k, s.boundary, o);
  placed_skeleton result{contract(k.base(), s.boundary, raw), {}};
  const locator where(s.planes);
  const double unit = std::pow(10.0, s.ten) * std::pow(2.0, s.two);
  for (const auto& n : result.complex.nodes) {
    const auto& node = raw.nodes[static_cast<std::size_t>(n.raw.front())];
    std::array<rational, 3> p;
    if (node.vertex >= 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = rational(s.points[static_cast<std::size_t>(node.vertex)][axis]);
    } else {
      p = where.meeting(node.planes)->point;
    }
    auto& point = result.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = static_cast<double>(rational(p[axis] + s.shift[axis])) * unit;
  }
  return result;
}

/// Empty where `image` is `original` with every point mapped by `map`, else what differs. Places only propose which
/// node is which; nodes, arcs and sheets are then compared as a complex.
template <class Map>
std::string difference(const placed_skeleton& original, const placed_skeleton& image, Map map) {
  const auto& a = original.complex;
  const auto& b = image.complex;
  if (a.nodes.size() != b.nodes.size() || a.arcs.size() != b.arcs.size() || a.sheets.size() != b.sheets.size()) {
    const auto counts = [](const contracted_skeleton& s) {
      return std::to_string(s.nodes.size()) + " " + std::to_string(s.arcs.size()) + " " + std::to_string(s.sheets.size());
    };
    return "counts " + counts(a) + " and " + counts(b);
  }
  std::vector<int> to(a.nodes.size(), -1);
  std::set<int> taken;
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    const std::array<double, 3> p = map(original.points[n]);
    double best = 1e300;
    for (std::size_t m = 0; m < b.nodes.size(); ++m) {
      const double d = std::hypot(p[0] - image.points[m][0], p[1] - image.points[m][1], p[2] - image.points[m][2]);
      if (d < best) {
        best = d;
        to[n] = static_cast<int>(m);
      }
    }
    if (!taken.insert(to[n]).second) return "node " + std::to_string(n) + " has no partner of its own";
  }
  std::map<std::pair<int, int>, std::vector<int>> arcs;
  const auto ordered = [](int x, int y) { return std::pair(std::min(x, y), std::max(x, y)); };
  for (std::size_t i = 0; i < b.arcs.size(); ++i) arcs[ordered(b.arcs[i].source, b.arcs[i].target)].push_back(static_cast<int>(i));
  std::vector<int> arc_to(a.arcs.size(), -1);
  for (std::size_t i = 0; i < a.arcs.size(); ++i) {
    const auto found = arcs.find(ordered(to[static_cast<std::size_t>(a.arcs[i].source)], to[static_cast<std::size_t>(a.arcs[i].target)]));
    if (found == arcs.end() || found->second.size() != 1) return "arc " + std::to_string(i) + " has no image";
    arc_to[i] = found->second[0];
    if (a.arcs[i].sheets.size() != b.arcs[static_cast<std::size_t>(arc_to[i])].sheets.size())
      return "arc " + std::to_string(i) + " has another degree";
  }
  std::multiset<std::set<int>> sheets;
  for (const auto& s : b.sheets) sheets.emplace(s.arcs.begin(), s.arcs.end());
  for (std::size_t i = 0; i < a.sheets.size(); ++i) {
    std::set<int> arcs_of;
    for (const int x : a.sheets[i].arcs) arcs_of.insert(arc_to[static_cast<std::size_t>(x)]);
    const auto found = sheets.find(arcs_of);
    if (found == sheets.end()) return "sheet " + std::to_string(i) + " has no image";
    sheets.erase(found);
  }
  return "";
}

}  // namespace osteon::test
