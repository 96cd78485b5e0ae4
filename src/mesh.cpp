// SPDX-License-Identifier: MIT

/// \file
/// Roofs, and meshes as text.

#include "polygon_skeleton_data.hpp"

#include <ostream>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/evaluate/roof.hpp"

namespace osteon {

mesh polygon_skeleton::roof(const roof_options& options) const {
  const data& d = *view_.data;
  if (!d.result.exact) throw unsupported_error("a roof needs the contracted skeleton; hint: take an exact kernel");
  plane::roof_options o;
  o.slope = options.slope;
  o.eaves = options.eaves;
  o.walls = options.walls;
  o.triangulate = options.triangulate;
  auto built = plane::make_roof(*d.input, d.result.raw, *d.result.exact, o);
  mesh m;
  m.points = std::move(built.points);
  for (auto& f : built.faces) {
    m.facets.push_back(std::move(f.corners));
    m.source.push_back(f.edge < 0 ? -1 : d.input->input_edges[f.edge]);
    m.kinds.push_back(f.what == plane::roof_mesh::kind::roof   ? facet_kind::roof
                      : f.what == plane::roof_mesh::kind::wall ? facet_kind::wall
                                                               : facet_kind::floor);
  }
  return m;
}

void write_obj(std::ostream& out, const mesh& m) {
  const auto precision = out.precision(17);
  for (const auto& p : m.points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  const char* group = nullptr;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const facet_kind k = f < m.kinds.size() ? m.kinds[f] : facet_kind::solid;
    const char* name = k == facet_kind::roof ? "roof" : k == facet_kind::wall ? "walls" : k == facet_kind::floor ? "floor" : nullptr;
    if (name != group && name != nullptr) out << "g " << name << '\n';
    group = name;
    out << 'f';
    for (const int c : m.facets[f]) out << ' ' << c + 1;
    out << '\n';
  }
  out.precision(precision);
}

}  // namespace osteon
