// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Offsets as exact meshes of CGAL.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "offset_mesh.hpp"
#include "osteon/input/moving_plane.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon::oracles {

using exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using exact_mesh = CGAL::Surface_mesh<exact_kernel::Point_3>;

inline exact_kernel::FT to_cgal(const rational& x) { return exact_kernel::FT(exact_kernel::FT::ET(x.backend().data())); }
inline exact_kernel::Point_3 to_cgal(const std::array<rational, 3>& p) { return {to_cgal(p[0]), to_cgal(p[1]), to_cgal(p[2])}; }

/// The triangles of one facet, without new points. Throws where two of its edges cross.
inline std::vector<std::array<std::size_t, 3>> triangulate(const offset_mesh& m, const offset_mesh::facet& f, const std::array<integer, 3>& normal) {
  using vertices = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, exact_kernel>;
  using faces = CGAL::Constrained_triangulation_face_base_2<exact_kernel, CGAL::Triangulation_face_base_with_info_2<int, exact_kernel>>;
  using triangulation = CGAL::Constrained_Delaunay_triangulation_2<exact_kernel, CGAL::Triangulation_data_structure_2<vertices, faces>,
                                                                   CGAL::No_constraint_intersection_tag>;
  // Along the axis in which the normal is longest, so that orientations stay.
  std::size_t along = 0;
  for (const std::size_t axis : {1U, 2U})
    if (abs(normal[axis]) > abs(normal[along])) along = axis;
  const std::size_t x = normal[along] > 0 ? (along + 1) % 3 : (along + 2) % 3;
  const std::size_t y = normal[along] > 0 ? (along + 2) % 3 : (along + 1) % 3;
  triangulation t;
  for (const auto& ring : f.rings) {
    std::vector<triangulation::Vertex_handle> handles;
    for (const int p : ring) {
      const auto& at = m.points[static_cast<std::size_t>(p)];
      handles.push_back(t.insert({to_cgal(at[x]), to_cgal(at[y])}));
      handles.back()->info() = static_cast<std::size_t>(p);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) t.insert_constraint(handles[i], handles[(i + 1) % ring.size()]);
  }
  // Faces are inside or outside in turn, beginning at infinity.
  for (const auto face : t.all_face_handles()) face->info() = -1;
  std::vector<triangulation::Face_handle> stack = {t.infinite_face()};
  t.infinite_face()->info() = 0;
  while (!stack.empty()) {
    const auto face = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
      if (const auto next = face->neighbor(i); next->info() < 0) {
        next->info() = face->is_constrained(i) ? 1 - face->info() : face->info();
        stack.push_back(next);
      }
  }
  std::vector<std::array<std::size_t, 3>> result;
  for (const auto face : t.finite_face_handles())
    if (face->info() == 1) result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return result;
}

/// The offset as a closed triangulated surface; nothing where it is none (that is, where facets do not fit together).
inline std::optional<exact_mesh> to_cgal(const offset_mesh& m, std::span<const moving_plane<integer>> planes) {
  std::vector<exact_kernel::Point_3> points;
  for (const auto& p : m.points) points.push_back(to_cgal(p));
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& f : m.facets) {
    const auto some = triangulate(m, f, planes[static_cast<std::size_t>(f.plane)].n);
    triangles.insert(triangles.end(), some.begin(), some.end());
  }
  namespace processing = CGAL::Polygon_mesh_processing;
  if (!processing::is_polygon_soup_a_polygon_mesh(triangles)) return std::nullopt;
  exact_mesh result;
  processing::polygon_soup_to_polygon_mesh(points, triangles, result);
  if (!CGAL::is_closed(result)) return std::nullopt;
  return result;
}

}  // namespace osteon::oracles
