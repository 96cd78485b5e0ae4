// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Outer rings and holes: whether each hole lies where it must, and which way rings run.

#include <algorithm>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/input/messages.hpp"
#include "osteon/input/plane_sweep.hpp"
#include "osteon/input/ring_cleaning.hpp"
#include "osteon/input/rings.hpp"

namespace osteon::plane {

/// The parts of a polygon, numbered in the order of their first rings, which are their outer ones.
struct ring_parts {
  std::vector<int> part;   ///< by ring
  std::vector<int> outer;  ///< by part: its outer ring

  /// Returns whether a ring is the outer one of its part.
  bool is_outer(int ring) const { return outer[part[ring]] == ring; }
};

/// Returns the parts that rings name.
template <class Int>
ring_parts parts_of(const rings<Int>& r) {
  ring_parts result;
  std::unordered_map<int, int> numbers;
  for (std::size_t i = 0; i < r.all.size(); ++i) {
    const auto [found, fresh] = numbers.emplace(r.all[i].part, static_cast<int>(result.outer.size()));
    if (fresh) result.outer.push_back(static_cast<int>(i));
    result.part.push_back(found->second);
  }
  return result;
}

/// Checks that each hole lies directly inside the outer ring of its part, and no outer ring
/// directly inside that of another part.
/// *Throws* input_error(misplaced_ring).
template <class Int>
void check_nesting(const ring_parts& parts, const ring_chains& chains, const ring_relations& relations, const ring_names<Int>& names) {
  for (int r = 0; r < chains.rings(); ++r) {
    const int outer = parts.outer[parts.part[r]];
    const int around = relations.parents[r];
    const auto refuse = [&](const std::string& what, int other, const std::string& hint) {
      names.refuse(input_fault::misplaced_ring, chains.input[chains.first[r]], what + names.ring_name(other), hint);
    };
    if (r == outer) {
      if (around >= 0 && parts.is_outer(around))
        refuse(": the ring is the outer one of its part, but lies inside of another part, ", around, "make it a hole, or keep the parts apart");
    } else if (around < 0 || parts.part[around] != parts.part[r]) {
      refuse(": the hole lies outside of its outer ring, ", outer, "give the outer ring first, and a part of its own for what lies apart");
    } else if (around != outer) {
      refuse(": the hole lies inside of another hole, ", around, "delete it, or give it as a part of its own");
    }
  }
}

/// Which rings were reversed.
struct reversed_rings {
  std::vector<bool> reversed;  ///< by ring
  std::string repair;          ///< a sentence that says so; empty where there is none
};

/// Reverses outer rings that run clockwise and holes that run counter-clockwise. A reversed edge
/// starts where it ended: its number changes, its weight stays with it.
inline reversed_rings orient(ring_chains& chains, const ring_parts& parts, const ring_relations& relations) {
  reversed_rings result;
  std::size_t outers = 0;
  std::size_t holes = 0;
  int first = -1;
  for (int r = 0; r < chains.rings(); ++r) {
    const bool outer = parts.is_outer(r);
    result.reversed.push_back(relations.counterclockwise[r] != outer);
    if (!result.reversed[r]) continue;
    (outer ? outers : holes) += 1;
    if (first < 0) first = r;
    const int begin = chains.first[r];
    const int end = chains.end(r);
    for (int i = begin; i < end; ++i) chains.next[i] = i > begin ? i - 1 : end - 1;
    std::rotate(chains.weight.begin() + begin, chains.weight.begin() + end - 1, chains.weight.begin() + end);
  }
  chains.previous.resize(chains.next.size());
  for (int i = 0; i < chains.size(); ++i) chains.previous[chains.next[i]] = i;
  if (first < 0) return result;
  if (outers > 0) result.repair = counted(outers, "clockwise outer ring", "clockwise outer rings");
  if (holes > 0) result.repair += (outers > 0 ? " and " : "") + counted(holes, "counter-clockwise hole", "counter-clockwise holes");
  result.repair += (outers + holes == 1 ? " was" : " were");
  result.repair += " reversed, the first: ring " + std::to_string(first + 1);
  return result;
}

}  // namespace osteon::plane
