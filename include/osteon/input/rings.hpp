// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Rings of points: polygons as they come in, from memory or a file, exact and unchecked.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/exact_number.hpp"
#include "osteon/input/messages.hpp"

namespace osteon::plane {

/// Closed rings of points; the last point of a ring is joined to its first. Messages number the
/// points of all rings from 0, through all rings.
template <class Int>
struct rings {
  /// A ring, with what is known of its edges.
  struct ring {
    std::vector<std::array<exact_number<Int>, 2>> points;
    /// of the edge that starts at each point; empty: all 1
    std::vector<exact_number<Int>> weights;
    std::vector<std::size_t> lines;  ///< of the file, by point; or empty
    /// polygon of a multipolygon; the first ring of a part is its outer one
    int part = 0;
  };
  std::vector<ring> all;
  std::string file;                ///< for messages; empty for memory
  std::vector<std::string> notes;  ///< what the reader left out, one sentence each
};

/// Removes the last point of a ring where it repeats the first, together with its weight.
template <class Ring>
void drop_closing_point(Ring& r) {
  if (r.points.size() < 2 || r.points.front() != r.points.back()) return;
  r.points.pop_back();
  if (!r.weights.empty()) r.weights.pop_back();
  if (!r.lines.empty()) r.lines.pop_back();
}

/// Notes that third coordinates of so many points were left out.
template <class Int>
void note_heights(rings<Int>& r, std::size_t points) {
  if (points > 0) r.notes.push_back("third coordinates and measures were left out, those of " + counted(points, "point", "points"));
}

/// Returns rings from doubles, taken exactly; the first is the outer one, all others are holes.
/// `weights`, if any, are those of the edges that start at the points. A last point that repeats
/// the first of its ring is dropped.
/// *Throws* input_error for NaN and infinities (bad_number), and where weights and points are not
/// equally many (bad_weight).
template <class Int>
rings<Int> make_rings(const std::vector<std::vector<std::array<double, 2>>>& points, const std::vector<std::vector<double>>& weights = {}) {
  rings<Int> result;
  if (!weights.empty() && weights.size() != points.size())
    throw input_error(input_fault::bad_weight, 0,
                      "there are weights for " + std::to_string(weights.size()) + " of " + std::to_string(points.size()) + " rings",
                      "give every ring its weights, or none any");
  for (std::size_t r = 0; r < points.size(); ++r) {
    auto& ring = result.all.emplace_back();
    const std::string name = "ring " + std::to_string(r + 1);
    const auto exact = [&](double x, std::size_t i, const char* what) {
      auto value = from_double<Int>(x);
      if (!value)
        throw input_error(input_fault::bad_number, i + 1, name + ", point " + std::to_string(i + 1) + " has a " + what + " that is not finite",
                          "give finite numbers");
      return std::move(*value);
    };
    for (std::size_t i = 0; i < points[r].size(); ++i)
      ring.points.push_back({exact(points[r][i][0], i, "coordinate"), exact(points[r][i][1], i, "coordinate")});
    if (!weights.empty() && !weights[r].empty()) {
      if (weights[r].size() != points[r].size())
        throw input_error(input_fault::bad_weight, r + 1,
                          name + " has " + std::to_string(weights[r].size()) + " weights for " + std::to_string(points[r].size()) + " points",
                          "give every point the weight of the edge that starts there, or none any");
      for (std::size_t i = 0; i < weights[r].size(); ++i) ring.weights.push_back(exact(weights[r][i], i, "weight"));
    }
    drop_closing_point(ring);
  }
  return result;
}

/// The points of rings, numbered from 0 through all rings: to which ring they belong, and what
/// messages call them.
template <class Int>
class ring_names {
 public:
  /// *Requires* rings that live longer; their coordinates do not matter.
  explicit ring_names(const rings<Int>& r) : rings_(r) {
    for (const auto& ring : r.all) {
      first_.push_back(size_);
      size_ += static_cast<int>(ring.points.size());
    }
  }

  /// Returns the number of rings.
  int rings() const { return static_cast<int>(first_.size()); }
  /// Returns the number of points.
  int points() const { return size_; }
  /// Returns the first point of a ring; that of the next ring is behind its last.
  int first(int ring) const { return ring < rings() ? first_[ring] : size_; }
  /// Returns the ring of a point.
  int ring_of(int point) const { return static_cast<int>(std::upper_bound(first_.begin(), first_.end(), point) - first_.begin()) - 1; }

  /// Returns "ring 2, point 5", counted from one within the ring.
  std::string short_name(int point) const {
    const int r = ring_of(point);
    return ring_name(r) + ", point " + std::to_string(point - first_[r] + 1);
  }
  /// Returns the same behind the file and the line where the point was read: "FILE:12: ring 2,
  /// point 5".
  std::string name(int point) const {
    const int r = ring_of(point);
    const auto i = static_cast<std::size_t>(point - first_[r]);
    const auto& lines = rings_.all[r].lines;
    std::string text = rings_.file;
    if (!text.empty() && i < lines.size()) text += ":" + std::to_string(lines[i]);
    if (!text.empty()) text += ": ";
    return text + short_name(point);
  }
  /// Returns "ring 2", counted from one.
  static std::string ring_name(int ring) { return "ring " + std::to_string(ring + 1); }

  /// Throws input_error for a point: its name, followed by `what`, and the hint.
  [[noreturn]] void refuse(input_fault fault, int point, const std::string& what, const std::string& hint) const {
    throw input_error(fault, static_cast<std::size_t>(point) + 1, name(point) + what, hint);
  }
  /// Throws input_error for a ring: where it begins, its name, `what`, and the hint.
  [[noreturn]] void refuse_ring(input_fault fault, int ring, const std::string& what, const std::string& hint) const {
    const auto& lines = rings_.all[ring].lines;
    const std::string line = lines.empty() ? "" : ":" + std::to_string(lines.front());
    throw input_error(fault, static_cast<std::size_t>(ring) + 1, (rings_.file.empty() ? "" : rings_.file + line + ": ") + ring_name(ring) + what,
                      hint);
  }

 private:
  const plane::rings<Int>& rings_;
  std::vector<int> first_;  // by ring
  int size_ = 0;
};

}  // namespace osteon::plane
