// SPDX-License-Identifier: MIT

// The builder on meshes that are valid, or were before a few of their elements changed: a solid that keeps its promises and is the one the
// mesh describes, or an input error. A valid mesh is taken, turned inside out refused, and renumbering changes nothing.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "check.hpp"
#include "decode.hpp"
#include "osteon/core/error.hpp"
#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/solid.hpp"
#include "shapes.hpp"
#include "solid_invariants.hpp"

namespace osteon::fuzz {
namespace {

std::optional<solid<integer>> build(const shape& m) {
  try {
    return make_solid(m);
  } catch (const input_error& e) {
    require(!e.hint.empty(), "an input error names a hint");
    require(e.element <= std::max(m.points.size(), m.facets.size()), "an input error names an element");
    return std::nullopt;
  }
}

// One change that mostly breaks the mesh.
void corrupt(shape& m, decoder& d) {
  auto& facet = m.facets[d.index(m.facets.size())];
  auto& point = m.points[d.index(m.points.size())];
  const std::size_t corner = d.index(std::max<std::size_t>(facet.size(), 1));
  if (facet.empty()) return;
  switch (d.between(0, 13)) {
    case 0:
      point[d.index(3)].mantissa += d.between(-2, 2);
      break;
    case 1:
      point = m.points[d.index(m.points.size())];
      break;
    case 2:
      facet[corner] = static_cast<int>(d.index(m.points.size()));
      break;
    case 3:
      facet[corner] = static_cast<int>(d.between(-3, 127));
      break;
    case 4:
      std::swap(facet[corner], facet[d.index(facet.size())]);
      break;
    case 5:
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(corner));
      break;
    case 6:
      facet.insert(facet.begin() + static_cast<std::ptrdiff_t>(corner), static_cast<int>(d.index(m.points.size())));
      break;
    case 7:
      std::reverse(facet.begin(), facet.end());
      break;
    case 8:
      facet = m.facets.back();
      m.facets.pop_back();
      break;
    case 9: {
      const auto copy = facet;
      m.facets.push_back(copy);
      break;
    }
    case 10: {  // one point instead of two
      const int from = facet[corner];
      const int to = static_cast<int>(d.index(m.points.size()));
      for (auto& f : m.facets) std::replace(f.begin(), f.end(), from, to);
      break;
    }
    case 11: {  // two facets become one
      const auto other = m.facets.back();
      facet.insert(facet.end(), other.begin(), other.end());
      break;
    }
    case 12:
      point[d.index(3)].ten += static_cast<int>(d.between(-2, 2));
      break;
    default:
      point[d.index(3)].two += static_cast<int>(d.between(-60, 60));
  }
}

// Points in another order, facets begun at another corner.
void renumber(shape& m, decoder& d) {
  const auto n = m.points.size();
  const std::size_t shift = d.index(n);
  std::rotate(m.points.begin(), m.points.begin() + static_cast<std::ptrdiff_t>(shift), m.points.end());
  for (auto& f : m.facets) {
    for (int& p : f)
      if (p >= 0 && static_cast<std::size_t>(p) < n) p = static_cast<int>((static_cast<std::size_t>(p) + n - shift) % n);
    if (!f.empty()) std::rotate(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(d.index(f.size())), f.end());
  }
}

void weigh(shape& m, decoder& d) {
  const long most = d.between(-1, 3);
  for (std::size_t f = 0; f < m.facets.size(); ++f) m.weights.push_back(most <= 1 ? integer(most) : integer(d.between(1, most)));
}

void run(decoder d) {
  const unsigned plan = d.byte();
  decoded shape = decode_shape(d, 120);
  auto& m = shape.mesh;
  const auto corruptions = plan % 4 < 2 ? 0U : plan % 4 - 1;
  const bool triangulated = (plan & 16U) != 0;
  const bool weighted = (plan & 32U) != 0 && (plan & 64U) != 0;
  for (unsigned i = 0; i < corruptions; ++i) corrupt(m, d);
  if (weighted) weigh(m, d);
  if (triangulated) {
    try {
      triangulate_facets(m);
    } catch (const input_error&) {
      tally::add("refused by triangulate");
      return;
    }
    for (const auto& f : m.facets) require(f.size() >= 3, "a piece of a facet has three corners");
  }

  keep(m);
  const auto s = build(m);
  if (shape.valid && corruptions == 0 && !weighted) require(s.has_value(), "a valid mesh is taken");
  if (s) {
    const solid_check check(*s);
    check.run();
    check.check_against(m);
    auto inverted = m;
    reverse_facets(inverted);
    try {
      make_solid(inverted);
      broken("a solid turned inside out is refused");
    } catch (const input_error& e) {
      require(e.fault == input_fault::inverted, "a solid turned inside out is called that");
    }
  }
  auto renumbered = m;
  renumber(renumbered, d);
  const auto t = build(renumbered);
  require(s.has_value() == t.has_value(), "renumbering does not matter");
  if (s) {
    require(s->planes.size() == t->planes.size() && s->boundary.vertices.size() == t->boundary.vertices.size() &&
                s->boundary.edges.size() == t->boundary.edges.size() && s->facets == t->facets,
            "renumbering makes the same solid");
  }
  tally::add(s ? (corruptions > 0 ? "a solid, corrupted" : "a solid")
               : (corruptions > 0 ? "refused, corrupted" : "refused, turned or moved or weighted"));
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder({data, size}));
  return 0;
}
