// SPDX-License-Identifier: MIT

/// \file
/// Polygons of the door: from rings and files, with weights.

#include "osteon/door/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <utility>

#include "decimals.hpp"
#include "osteon/evaluate/roof.hpp"
#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "polygon_data.hpp"

namespace osteon {
namespace {

std::unique_ptr<polygon::data> data_of(plane::rings<integer> rings) {
  auto d = std::make_unique<polygon::data>();
  d->input = std::move(rings);
  return d;
}

plane::rings<integer> rings_in(std::istream& in, const std::string& name, polygon_format format) {
  switch (format) {
    case polygon_format::xy:
      return plane::read_xy<integer>(in, name);
    case polygon_format::wkt:
      return plane::read_wkt<integer>(in, name);
    case polygon_format::geojson:
      return plane::read_geojson<integer>(in, name);
    case polygon_format::obj:
      return plane::read_flat_obj<integer>(in, name);
    case polygon_format::guessed:
      break;
  }
  return plane::read_polygon<integer>(in, name);
}

polygon finished(polygon p, checking when) {
  if (when == checking::now) p.check();
  return p;
}

double rounded(const exact_number<integer>& x) {
  if (x.mantissa == 0) return 0;
  return rational(rational(x.mantissa) * power_of(x.ten, x.two)).convert_to<double>();
}

// The ring of an edge, and its place there.
template <class Rings>
auto ring_of(Rings& rings, int edge) {
  std::size_t at = edge < 0 ? static_cast<std::size_t>(-1) : static_cast<std::size_t>(edge);
  for (auto& r : rings.all) {
    if (at < r.points.size()) return std::pair(&r, at);
    at -= r.points.size();
  }
  throw input_error(input_fault::bad_index, static_cast<std::size_t>(std::max(edge, -1) + 1), "there is no edge " + std::to_string(edge),
                    "edges are counted from 0 through all rings");
}

exact_number<integer> weight_value(const decimal& weight, int edge) {
  const std::string what = edge < 0 ? "the weight" : "the weight of edge " + std::to_string(edge);
  auto w = exact_value(weight, what);
  if (w.mantissa < 0)
    throw input_error(input_fault::bad_weight, static_cast<std::size_t>(edge + 1), what + " is less than zero", "give a weight of zero or more");
  return w;
}

}  // namespace

polygon::polygon(const std::vector<point>& ring, checking when) : polygon(std::vector<std::vector<point>>{ring}, when) {}
polygon::polygon(const std::vector<std::vector<point>>& rings, checking when) : data_(data_of(plane::make_rings<integer>(rings))) {
  if (when == checking::now) check();
}
polygon::polygon(std::unique_ptr<data> d) : data_(std::move(d)) {}
polygon::polygon(const polygon& other) : data_(std::make_unique<data>(*other.data_)) {}
polygon::polygon(polygon&& other) noexcept = default;
polygon& polygon::operator=(const polygon& other) {
  if (this != &other) data_ = std::make_unique<data>(*other.data_);
  return *this;
}
polygon& polygon::operator=(polygon&& other) noexcept = default;
polygon::~polygon() = default;

int polygon::edges() const {
  std::size_t n = 0;
  for (const auto& r : data_->input.all) n += r.points.size();
  return static_cast<int>(n);
}

std::vector<std::vector<polygon::point>> polygon::rings() const {
  std::vector<std::vector<point>> result;
  for (const auto& r : data_->input.all) {
    auto& to = result.emplace_back();
    for (const auto& p : r.points) to.push_back({rounded(p[0]), rounded(p[1])});
  }
  return result;
}

double polygon::weight(int edge) const {
  const auto [ring, at] = ring_of(data_->input, edge);
  return ring->weights.empty() ? 1 : rounded(ring->weights[at]);
}

void polygon::set_weight(int edge, const decimal& weight) {
  const auto [ring, at] = ring_of(data_->input, edge);
  auto w = weight_value(weight, edge);
  if (ring->weights.empty()) ring->weights.assign(ring->points.size(), {integer(1), 0, 0});
  ring->weights[at] = std::move(w);
  data_->checked.reset();
}

void polygon::set_weights(const decimal& weight) {
  const auto w = weight_value(weight, -1);
  for (auto& r : data_->input.all) r.weights.assign(r.points.size(), w);
  data_->checked.reset();
}

void polygon::check() { data_->checked = checked_polygon(*this, region::interior); }

std::vector<std::string> polygon::notes() const { return data_->checked ? data_->checked->repairs : data_->input.notes; }

std::shared_ptr<const plane::polygon<integer>> checked_polygon(const polygon& p, region r) {
  if (r == region::interior && p.access().checked) return p.access().checked;
  return std::make_shared<const plane::polygon<integer>>(plane::make_polygon(p.access().input, r == region::exterior));
}

std::shared_ptr<const plane::polygon<integer>> checked_polygon(polygon&& p, region r) {
  polygon::data& d = p.access();
  if (r == region::interior && d.checked) {
    d.input = {};
    return std::move(d.checked);
  }
  return std::make_shared<const plane::polygon<integer>>(plane::make_polygon(std::move(d.input), r == region::exterior));
}

polygon read_polygon(const std::string& file, checking when) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw input_error(input_fault::unreadable, 0, file + ": cannot be opened", "check the name");
  return read_polygon(in, file, when);
}

polygon read_polygon(std::istream& in, const std::string& name, checking when, polygon_format format) {
  return finished(polygon(data_of(rings_in(in, name, format))), when);
}

bool is_polygon_file(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".obj") return extension == ".xy" || extension == ".txt" || extension == ".wkt" || extension == ".geojson" || extension == ".json";
  std::ifstream in(file, std::ios::binary);
  int faces = 0;
  for (std::string line; faces < 2 && std::getline(in, line);)
    if (const std::size_t at = line.find_first_not_of(" \t");
        at != std::string::npos && line[at] == 'f' && at + 1 < line.size() && line[at + 1] <= ' ')
      ++faces;
  return faces == 1;
}

bool is_polygon_text(std::string_view text) { return plane::guess_format("", text) != plane::format::obj; }

double weight_of_angle(double degrees) { return plane::weight_of_slope(degrees); }

}  // namespace osteon
