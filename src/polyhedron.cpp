// SPDX-License-Identifier: MIT

/// \file
/// Polyhedra of the door: from points and facets, and from files.

#include "osteon/door/polyhedron.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <utility>

#include "osteon/input/mesh_repair.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/solid.hpp"
#include "polyhedron_data.hpp"

namespace osteon {
namespace {

std::shared_ptr<const polyhedron::data> data_of(input_mesh<integer> m, const mesh_repairs& repairs) {
  if (repairs.flip) reverse_facets(m);
  auto d = std::make_shared<polyhedron::data>();
  if (repairs.triangulate) {
    const auto facets = m.facets;
    triangulate_facets(m);
    // The pieces of a facet with n corners have n - 2 corners more than twice their number.
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (std::size_t left = facets[f].size() - 2; left > 0; left -= m.facets[d->given.size() - 1].size() - 2)
        d->given.push_back(static_cast<int>(f));
  }
  d->checked = make_solid(std::move(m));
  return d;
}

[[noreturn]] void bad_index(const char* what, int number) {
  throw input_error(input_fault::bad_index, 0, std::string("there is no ") + what + " " + std::to_string(number), "count from 0");
}

template <class List>
auto& at(const List& list, int i, const char* what) {
  if (i < 0 || static_cast<std::size_t>(i) >= list.size()) bad_index(what, i);
  return list[static_cast<std::size_t>(i)];
}

}  // namespace

polyhedron::polyhedron(const std::vector<point>& points, std::vector<std::vector<int>> facets, const mesh_repairs& repairs)
    : data_(data_of(make_input_mesh<integer>(points, std::move(facets)), repairs)) {}

int polyhedron::vertices() const { return static_cast<int>(data_->checked.boundary.vertices.size()); }
int polyhedron::edges() const { return static_cast<int>(data_->checked.boundary.edges.size()); }
int polyhedron::facets() const { return data_->checked.facets; }
int polyhedron::planes() const { return static_cast<int>(data_->checked.planes.size()); }
int polyhedron::point_of(int vertex) const { return at(data_->checked.input_points, vertex, "vertex"); }

int polyhedron::vertex_at(int number) const {
  const auto& points = data_->checked.input_points;
  const auto found = std::find(points.begin(), points.end(), number);
  if (found == points.end())
    throw input_error(input_fault::bad_index, static_cast<std::size_t>(std::max(number, -1) + 1),
                      "point " + std::to_string(number) + " is no vertex of the solid", "name a point where at least three planes meet");
  return static_cast<int>(found - points.begin());
}

int polyhedron::degree(int vertex) const { return static_cast<int>(at(data_->checked.boundary.vertices, vertex, "vertex").facets.size()); }

int polyhedron::plane_of(int facet) const {
  const auto& given = data_->given;
  if (given.empty()) return at(data_->checked.facet_planes, facet, "facet");
  const auto found = std::lower_bound(given.begin(), given.end(), facet);
  if (found == given.end() || *found != facet) bad_index("facet", facet);
  return data_->checked.facet_planes[static_cast<std::size_t>(found - given.begin())];
}

std::vector<int> polyhedron::facets_in(int plane) const {
  at(data_->checked.planes, plane, "plane");
  std::vector<int> facets;
  for (std::size_t f = 0; f < data_->checked.facet_planes.size(); ++f)
    if (data_->checked.facet_planes[f] == plane) facets.push_back(data_->given_facet(static_cast<int>(f)));
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

polyhedron read_polyhedron(const std::string& file, const mesh_repairs& repairs) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw input_error(input_fault::unreadable, 0, file + ": cannot be opened", "check the name");
  return read_polyhedron(in, file, repairs);
}

polyhedron read_polyhedron(std::istream& in, const std::string& name, const mesh_repairs& repairs) {
  return polyhedron(data_of(read_obj<integer>(in, name), repairs));
}

rational unit_of(const solid<integer>& s) {
  const auto power = [](int base, int exponent) {
    const integer p = pow(integer(base), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
    return exponent < 0 ? rational(1, p) : rational(p);
  };
  return power(10, s.ten) * power(2, s.two);
}

}  // namespace osteon
