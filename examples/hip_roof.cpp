// SPDX-License-Identifier: MIT

/// \file
/// A house from its outline: walls, and a hip roof that rises from every edge at the same angle.
///   hip_roof FILE [DEGREES [GABLE]]
/// DEGREES is the angle of the roof, 45 unless given. GABLE is the number of the point in the file, counted from 1, where the edge starts whose wall
/// goes up to the ridge instead: that edge gets the weight 0, it does not move. The house comes as OBJ, its sizes on standard error.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <string>

#include "osteon/evaluate/anchors.hpp"
#include "osteon/evaluate/roof.hpp"
#include "osteon/evaluate/vertex_enclosures.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/sqrt.hpp"
#include "osteon/plane/contract.hpp"
#include "osteon/plane/propagate.hpp"

namespace {

using namespace osteon;

constexpr double eaves = 3;

/// The edge that starts at a point of the file, counted from 1 through all rings, does not move.
void hold(plane::rings<integer>& r, std::size_t point) {
  for (auto& ring : r.all) {
    if (ring.weights.empty()) ring.weights.assign(ring.points.size(), *from_double<integer>(1));
    if (point >= 1 && point <= ring.points.size()) {
      ring.weights[point - 1] = {};
      return;
    }
    point -= ring.points.size();
  }
  throw input_error(input_fault::bad_index, 0, "there is no such point to start a gable", "count the points of the file from 1");
}

plane::roof_mesh build(const plane::polygon<integer>& p, double degrees) {
  const std::span<const moving_line<integer>> lines(p.lines);
  const perturbed kernel(filtered(lines, make_sqrt_kernel(lines), anchors_of(p)));
  const auto raw = plane::propagation(kernel, p.boundary, plane::vertex_enclosures(lines, p.points)).run();
  const auto exact = plane::contract(kernel.base(), p.boundary.line, raw);
  return plane::make_roof(p, raw, exact, {.slope = std::tan(degrees * std::atan(1.0) / 45), .eaves = eaves, .walls = true});
}

/// Twice the area of a flat face, as a vector, from triangles; and six times the volume between it and the origin.
std::array<double, 4> measure(const plane::roof_mesh& m, const plane::roof_mesh::face& f) {
  std::array<double, 4> sum{};
  const auto& o = m.points[f.corners[0]];
  for (std::size_t i = 1; i + 1 < f.corners.size(); ++i) {
    const auto& a = m.points[f.corners[i]];
    const auto& b = m.points[f.corners[i + 1]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3;
      const std::size_t z = (axis + 2) % 3;
      const double x = (a[y] - o[y]) * (b[z] - o[z]) - (a[z] - o[z]) * (b[y] - o[y]);
      sum[axis] += x;
      sum[3] += x * o[axis];
    }
  }
  return sum;
}

void report(const plane::roof_mesh& m) {
  double ridge = 0;
  double area = 0;
  double volume = 0;
  for (const auto& p : m.points) ridge = std::max(ridge, p[2]);
  for (const auto& f : m.faces) {
    const auto x = measure(m, f);
    if (f.what == plane::roof_mesh::kind::roof && x[2] > 0) area += std::hypot(x[0], x[1], x[2]) / 2;  // a gable is upright
    volume += x[3] / 6;
  }
  std::fprintf(stderr, "ridge at %.10g, %.10g of roof to cover, volume %.10g\n", ridge, area, volume);
}

}  // namespace

int main(int argc, char** argv) {
  const double degrees = argc > 2 ? std::atof(argv[2]) : 45;
  if (argc < 2 || argc > 4 || !(degrees > 0 && degrees < 90)) {
    std::fprintf(stderr, "usage: hip_roof FILE [DEGREES [GABLE]], with DEGREES between 0 and 90\n");
    return 2;
  }
  try {
    std::ifstream in(argv[1], std::ios::binary);
    auto rings = plane::read_polygon<integer>(in, argv[1]);
    if (argc > 3) hold(rings, std::strtoul(argv[3], nullptr, 10));
    const auto polygon = plane::make_polygon(std::move(rings));
    for (const auto& repair : polygon.repairs) std::fprintf(stderr, "hip_roof: note: %s\n", repair.c_str());
    const auto mesh = build(polygon, degrees);
    plane::write_obj(std::cout, mesh);
    report(mesh);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "hip_roof: %s\n", e.what());
    return dynamic_cast<const input_error*>(&e) != nullptr ? 3 : 5;
  }
}
