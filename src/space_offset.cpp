// SPDX-License-Identifier: MIT

/// \file
/// Offsets of solids.

#include "polyhedron_skeleton_data.hpp"

#include "decimals.hpp"
#include "osteon/core/error.hpp"
#include "osteon/kernel/rational.hpp"
#include "space_kernels.hpp"

namespace osteon {

std::optional<std::vector<rational>> given_speeds(const solid<integer>& s, number_kernel k) {
  if (k != number_kernel::rational) return std::nullopt;
  const rational_arithmetic a(s.planes);
  std::vector<rational> speeds;
  for (plane_id p = 0; p < a.size(); ++p) speeds.emplace_back(a.speed(p), integer(1) << 64U);
  return speeds;
}

solid_surface surface_of(const polyhedron_skeleton::data& d, const rational& time, bool triangulate) {
  const solid<integer>& s = d.body();
  return offset_surface(make_kernels(s, d.options.kernel).perturbed, s.planes, d.speeds(), d.result.raw, time, triangulate);
}

mesh polyhedron_skeleton::offset(const decimal& time, const offset_options& options) const {
  const data& d = *view_.data;
  if (d.options.kernel == number_kernel::floating) throw unsupported_error("an offset of a skeleton that is not exact; hint: take an exact kernel");
  const rational unit = unit_of(d.body());
  const solid_surface s = surface_of(d, time_value(time) / unit, options.triangulate);
  mesh m;
  for (const auto& p : s.points) {
    auto& to = m.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) to[axis] = rational((p[axis] + d.body().shift[axis]) * unit).convert_to<double>();
  }
  std::vector<int> source(d.body().planes.size(), -1);  // by plane
  for (std::size_t f = d.body().facet_planes.size(); f-- > 0;)
    source[static_cast<std::size_t>(d.body().facet_planes[f])] = d.input->given_facet(static_cast<int>(f));
  for (const auto& f : s.facets) {
    m.facets.push_back(f.corners);
    m.source.push_back(source[static_cast<std::size_t>(f.plane)]);
  }
  m.kinds.assign(m.facets.size(), facet_kind::solid);
  return m;
}

double polyhedron_skeleton::volume(const decimal& time) const {
  const rational unit = unit_of(view_.data->body());
  return rational(view_.data->volumes().volume(time_value(time) / unit) * unit * unit * unit).convert_to<double>();
}

}  // namespace osteon
