// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Roofs: the faces of a skeleton raised to the height at which the wavefront passes, closed below
/// by the polygon.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "osteon/core/error.hpp"
#include "osteon/evaluate/cut_rings.hpp"
#include "osteon/evaluate/locate.hpp"
#include "osteon/evaluate/triangulate.hpp"
#include "osteon/input/polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/faces.hpp"
#include "osteon/plane/skeleton.hpp"

namespace osteon::plane {

/// How a roof is built.
struct roof_options {
  double slope = 1;          ///< height for each unit of time; greater than zero
  double eaves = 0;          ///< height of the polygon
  bool walls = false;        ///< down from the eaves to height 0; requires eaves greater than zero
  bool triangulate = false;  ///< every face, not only those with holes
  /// A floor with more corners times holes than this is not cut from the polygon, but consists of
  /// the roof's faces, projected (those of weight zero have no area there).
  std::size_t most_effort = 1'000'000'000;
};

/// A closed surface: every edge belongs to two faces, which pass it in opposite directions. Faces
/// are counter-clockwise seen from outside.
struct roof_mesh {
  /// What a face of a roof is.
  enum class kind : unsigned char { roof, wall, floor };
  /// A face of a roof, by the numbers of its corners.
  struct face {
    std::vector<int> corners;
    kind what;
    int edge;  ///< of the polygon, the first of those whose faces have merged; -1 for a floor
  };
  std::vector<std::array<double, 3>> points;
  std::vector<face> faces;
};

/// Returns the weight (horizontal way for each unit of height) of an edge whose roof rises at this
/// angle against the horizontal: the cotangent; 90 gives 0, a gable. Throws input_error unless 0 <
/// degrees <= 90. The heights of a roof with such weights are right for slope 1.
inline double weight_of_slope(double degrees) {
  if (!(degrees > 0 && degrees <= 90))
    throw input_error(input_fault::bad_weight, 0, "a roof cannot rise at this angle", "give an angle above 0 and up to 90 degrees");
  if (degrees == 90) return 0;
  if (degrees == 45) return 1;
  return std::tan((90 - degrees) * (3.14159265358979323846 / 180));
}

namespace detail {

class roof_builder {
 public:
  roof_builder(const polygon<integer>& p, const skeleton& raw, const contracted_skeleton& s, const roof_options& options)
      : polygon_(p), s_(s), options_(options), locator_(p) {
    for (const auto& n : s.nodes) places_.push_back(n.vertex >= 0 ? locator_.vertex(n.vertex) : locator_.meeting(n.lines));
    loops_ = trace_faces(p.boundary, raw, s, [this](int face, int node, int other) {
      const flat_point a = in_face(face, places_[node]);
      const flat_point b = in_face(face, places_[other]);
      return std::atan2(b[1] - a[1], b[0] - a[0]);
    });
  }

  roof_mesh run() {
    const int nodes = static_cast<int>(places_.size());
    for (const located& p : places_) result_.points.push_back({p.x, p.y, options_.eaves + options_.slope * p.time});
    ground_.assign(places_.size(), -1);
    for (int v = 0; v < s_.vertices; ++v) {
      ground_[v] = options_.walls ? nodes + v : v;
      if (options_.walls) result_.points.push_back({places_[v].x, places_[v].y, 0});
    }
    std::size_t i = 0;
    for (; i < loops_.loops.size() && loops_.loops[i].face >= 0;) {
      const int face = loops_.loops[i].face;
      std::vector<std::vector<int>> rings;
      for (; i < loops_.loops.size() && loops_.loops[i].face == face; ++i) rings.push_back(loops_.loops[i].nodes);
      add_face(face, std::move(rings));
    }
    if (options_.walls)
      for (const auto& s : loops_.sides) add_wall(s);
    std::map<int, std::vector<std::vector<int>>> pieces;
    for (std::size_t r = 0; i < loops_.loops.size(); ++i, ++r) pieces[loops_.rings[r]].push_back(loops_.loops[i].nodes);
    bool easy = true;
    for (const auto& [piece, rings] : pieces) {
      std::size_t corners = 0;
      for (const auto& r : rings) corners += r.size();
      easy = easy && corners * (rings.size() - 1) <= options_.most_effort;
    }
    if (!easy) mirror_faces();
    for (auto& [piece, rings] : pieces)
      if (easy) add_floor(std::move(rings));
    return std::move(result_);
  }

 private:
  // Place along the face's line, and time, in comparable units.
  flat_point in_face(int face, const located& p) const {
    const auto& n = locator_.lines()[polygon_.boundary.line[face]].n;
    const located& origin = places_[0];
    return {n[0].high * (p.y - origin.y) - n[1].high * (p.x - origin.x), p.time};
  }

  void add(std::vector<int> corners, roof_mesh::kind what, int edge) { result_.faces.push_back({std::move(corners), what, edge}); }

  void add_face(int face, std::vector<std::vector<int>> rings) {
    if (rings.size() == 1 && !options_.triangulate && is_simple(rings[0])) {
      add(std::move(rings[0]), roof_mesh::kind::roof, face);
      return;
    }
    flat_.resize(places_.size());
    for (const auto& r : rings)
      for (const int v : r) flat_[v] = in_face(face, places_[v]);
    cut(rings, [&](const std::array<int, 3>& t) { add({t[0], t[1], t[2]}, roof_mesh::kind::roof, face); });
  }

  // The rings of one piece of the polygon, backwards.
  void add_floor(std::vector<std::vector<int>> rings) {
    if (rings.size() == 1 && !options_.triangulate) {
      for (int& v : rings[0]) v = ground_[v];
      add(std::move(rings[0]), roof_mesh::kind::floor, -1);
      return;
    }
    flat_.resize(places_.size());
    for (const auto& r : rings)
      for (const int v : r) flat_[v] = {-places_[v].x, places_[v].y};  // seen from below
    cut(rings, [&](const std::array<int, 3>& t) { add({ground_[t[0]], ground_[t[1]], ground_[t[2]]}, roof_mesh::kind::floor, -1); });
  }

  // A floor of the roof's faces, seen from below.
  void mirror_faces() {
    for (std::size_t v = 0; v < places_.size(); ++v)
      if (ground_[v] < 0) {
        ground_[v] = static_cast<int>(result_.points.size());
        result_.points.push_back({places_[v].x, places_[v].y, options_.walls ? 0 : options_.eaves});
      }
    for (std::size_t i = 0, n = result_.faces.size(); i < n; ++i) {
      if (result_.faces[i].what != roof_mesh::kind::roof) continue;
      std::vector<int> corners(result_.faces[i].corners.rbegin(), result_.faces[i].corners.rend());
      for (int& c : corners) c = ground_[c];
      add(std::move(corners), roof_mesh::kind::floor, -1);
    }
  }

  void add_wall(const face_loops::side& s) {
    const int a = ground_[s.from];
    const int b = ground_[s.to];
    if (!options_.triangulate) {
      add({a, b, s.to, s.from}, roof_mesh::kind::wall, s.face);
    } else {
      add({a, b, s.to}, roof_mesh::kind::wall, s.face);
      add({a, s.to, s.from}, roof_mesh::kind::wall, s.face);
    }
  }

  // Every counter-clockwise ring with the clockwise ones in it.
  template <class Body>
  void cut(const std::vector<std::vector<int>>& rings, Body body) const {
    std::vector<std::vector<int>> outer;
    std::vector<std::vector<int>> inner;
    for (const auto& r : rings) (rings.size() == 1 || doubled_area(flat_, r) > 0 ? outer : inner).push_back(r);
    if (outer.empty()) {  // too flat to tell
      outer.push_back(inner.back());
      inner.pop_back();
    }
    std::vector<std::vector<std::vector<int>>> holes(outer.size());
    for (auto& h : inner) {
      std::size_t in = 0;
      for (std::size_t o = 0; o < outer.size() && outer.size() > 1; ++o) {
        std::vector<flat_point> ring;
        for (const int v : outer[o]) ring.push_back(flat_[v]);
        if (is_inside(ring, flat_[h[0]])) in = o;
      }
      holes[in].push_back(std::move(h));
    }
    for (std::size_t o = 0; o < outer.size(); ++o)
      for (const auto& t : ear_clipping(flat_).run(std::move(outer[o]), std::move(holes[o]))) body(t);
  }

  const polygon<integer>& polygon_;
  const contracted_skeleton& s_;
  const roof_options& options_;
  fast_locator locator_;
  std::vector<located> places_;  // by node
  face_loops loops_;
  std::vector<int> ground_;  // point below a vertex
  std::vector<flat_point> flat_;
  roof_mesh result_;
};

}  // namespace detail

/// Returns the roof over a polygon: one face for each edge that sweeps an area, walls where the
/// weight is zero (gables), a floor, in the units of the input. Faces are flat but for rounding,
/// and not cut into triangles unless they have holes or `options` ask for it. Points are the
/// skeleton's nodes: heights are times multiplied by the slope. `s` is the contraction of `raw`.
/// Throws unsupported_error for unbounded skeletons, input_error for options without sense. Cost:
/// sorting; a floor with holes, and all triangles, the square of their rings' sizes.
inline roof_mesh make_roof(const polygon<integer>& p, const skeleton& raw, const contracted_skeleton& s, const roof_options& options = {}) {
  if (!(options.slope > 0) || !std::isfinite(options.slope) || !std::isfinite(options.eaves) || (options.walls && !(options.eaves > 0)))
    throw input_error(input_fault::bad_number, 0, "a roof needs a slope greater than zero and, with walls, eaves above zero",
                      "give positive finite numbers");
  return detail::roof_builder(p, raw, s, options).run();
}

/// Writes a mesh as Wavefront OBJ: roof, walls and floor in groups. Doubles are written so that
/// they are read back the same.
inline void write_obj(std::ostream& out, const roof_mesh& m) {
  const auto precision = out.precision(17);
  for (const auto& p : m.points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  constexpr std::array names = {"roof", "walls", "floor"};
  const char* group = nullptr;
  for (const auto& f : m.faces) {
    const char* name = names[static_cast<std::size_t>(f.what)];
    if (name != group) out << "g " << (group = name) << '\n';
    out << 'f';
    for (const int c : f.corners) out << ' ' << c + 1;
    out << '\n';
  }
  out.precision(precision);
}

}  // namespace osteon::plane
