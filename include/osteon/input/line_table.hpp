// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The lines that a polygon's edges move on, each one once.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "osteon/core/random.hpp"
#include "osteon/input/exact_points.hpp"
#include "osteon/input/moving_plane.hpp"

namespace osteon::plane {

/// Returns the line from point a to point b, its normal to the right, without common divisors; of
/// weight 1.
template <class Int>
moving_line<Int> line_through(const exact_points<Int>& points, int a, int b) {
  moving_line<Int> line;
  const auto& p = points.rough(a);
  const auto& q = points.rough(b);
  if (points.exact()) {
    auto nx = static_cast<std::int64_t>(q[1] - p[1]);
    auto ny = static_cast<std::int64_t>(p[0] - q[0]);
    const std::int64_t g = std::gcd(nx, ny);
    nx /= g;
    ny /= g;
    line.n = {Int(nx), Int(ny)};
    if (std::abs(static_cast<double>(nx) * p[0]) + std::abs(static_cast<double>(ny) * p[1]) < 0x1p62) {
      line.d = Int(nx * static_cast<std::int64_t>(p[0]) + ny * static_cast<std::int64_t>(p[1]));
      return line;
    }
  } else {
    line.n = {points[b][1] - points[a][1], points[a][0] - points[b][0]};
    Int g = gcd(line.n[0], line.n[1]);
    if (g < 0) g = -g;
    if (g != 1)
      for (Int& x : line.n) x /= g;
  }
  line.d = line.n[0] * points[a][0] + line.n[1] * points[a][1];
  return line;
}

/// Lines in the order in which they were first asked for; equal ones have one number. A hash table
/// with open addresses: for a million edges, lists are too slow.
template <class Int>
class line_table {
 public:
  /// Makes an empty table with room for the lines of so many edges.
  explicit line_table(std::size_t edges) {
    std::size_t size = 16;
    while (size < 2 * edges) size *= 2;
    table_.assign(size, -1);
  }

  /// Returns the number of a line, a new one where it was not there.
  /// *Complexity* expected constant.
  int number(moving_line<Int>&& line) {
    const std::size_t mask = table_.size() - 1;
    for (std::size_t at = hash(line) & mask;; at = (at + 1) & mask) {
      if (table_[at] < 0) {
        table_[at] = static_cast<int>(lines_.size());
        lines_.push_back(std::move(line));
        return table_[at];
      }
      if (lines_[table_[at]] == line) return table_[at];
    }
  }

  /// Returns the lines by number, and leaves the table useless.
  std::vector<moving_line<Int>> take() { return std::move(lines_); }

 private:
  // A number of 64 bits that is equal for equal integers.
  static std::uint64_t residue(const Int& x) {
    if (std::abs(static_cast<double>(x)) < 0x1p62) return static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(Int(x % Int((std::int64_t{1} << 61) - 1))));
  }
  static std::size_t hash(const moving_line<Int>& line) {
    std::uint64_t h = 0;
    for (const Int* x : {&line.n[0], &line.n[1], &line.d, &line.weight}) h = random_stream::mixed(h ^ residue(*x));
    return static_cast<std::size_t>(h);
  }

  std::vector<moving_line<Int>> lines_;
  std::vector<int> table_;  // numbers of lines, by hash; -1: free
};

}  // namespace osteon::plane
