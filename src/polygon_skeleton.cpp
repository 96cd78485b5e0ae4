// SPDX-License-Identifier: MIT

/// \file
/// The skeleton of a polygon: runs, views, offsets, certificate.

#include "polygon_skeleton_data.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "decimals.hpp"
#include "osteon/evaluate/place_digits.hpp"
#include "osteon/kernel/to_double.hpp"
#include "polygon_data.hpp"

namespace osteon {
namespace {

polygon_skeleton finished(std::shared_ptr<const plane::polygon<integer>> input, const polygon_options& options) {
  auto d = std::make_shared<polygon_skeleton::data>();
  d->input = std::move(input);
  d->options = options;
  if (options.until) d->until = time_value(*options.until);
  d->result = run(d->question(), options.kernel);
  return polygon_skeleton({std::move(d), false});
}

// Sorted by key; `size` keys.
template <class Visit>
plane_incidences::lists gathered(int size, Visit visit) {
  plane_incidences::lists result;
  result.first.assign(static_cast<std::size_t>(size) + 1, 0);
  visit([&](int key, int) { ++result.first[key + 1]; });
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<int> at(result.first.begin(), result.first.end() - 1);
  result.all.resize(static_cast<std::size_t>(result.first.back()));
  visit([&](int key, int value) { result.all[at[key]++] = value; });
  return result;
}

template <class View, class Handle>
std::vector<View> views(const Handle& of, std::span<const int> ids) {
  std::vector<View> result;
  result.reserve(ids.size());
  for (const int i : ids) result.emplace_back(of, i);
  return result;
}

}  // namespace

polygon_skeleton skeletonize(const polygon& p, const polygon_options& options) { return finished(checked_polygon(p, options.region), options); }
polygon_skeleton skeletonize(polygon&& p, const polygon_options& options) { return finished(checked_polygon(std::move(p), options.region), options); }

const plane_incidences& polygon_skeleton::data::incidences(bool raw) const {
  return incidences_[is_raw(raw) ? 1 : 0].get([&] {
    plane_incidences i;
    const int arcs_here = arcs(raw);
    std::vector<bool> has_face(result.raw.faces.size(), false);
    for (std::size_t f = 0; f < has_face.size() && is_raw(raw); ++f) has_face[f] = result.raw.faces[f] == static_cast<int>(f);
    for (int a = 0; a < arcs_here; ++a)
      for (int side = 2; side < 4; ++side) has_face[arc(raw, a)[side]] = true;
    i.face_of.assign(has_face.size(), -1);
    for (std::size_t f = 0; f < has_face.size(); ++f) {
      if (!has_face[f]) continue;
      i.face_of[f] = static_cast<int>(i.faces.size());
      i.faces.push_back(static_cast<int>(f));
    }
    i.arcs_of_node = gathered(nodes(raw), [&](auto add) {
      for (int a = 0; a < arcs_here; ++a) {
        const auto x = arc(raw, a);
        add(x[0], a);
        if (x[1] >= 0) add(x[1], a);
      }
    });
    i.arcs_of_face = gathered(static_cast<int>(i.faces.size()), [&](auto add) {
      for (int a = 0; a < arcs_here; ++a) {
        const auto x = arc(raw, a);
        add(i.face_of[x[2]], a);
        if (x[3] != x[2]) add(i.face_of[x[3]], a);
      }
    });
    return i;
  });
}

std::array<double, 2> polygon_skeleton::data::inwards(int edge) const {
  const auto& n = input->lines[input->boundary.line[edge]].n;
  const int bits = std::max(bit_length(n[0]), bit_length(n[1]));
  const double x = to_double(n[0], bits);
  const double y = to_double(n[1], bits);
  const double length = std::hypot(x, y);
  return {-x / length, -y / length};
}

const plane::face_loops& polygon_skeleton::data::loops() const {
  return loops_.get([this] {
    if (!result.exact) throw unsupported_error("the boundaries of faces are known for the contracted skeleton only");
    const plane::located origin = place(false, 0);
    // Place along the face's line, and time.
    const auto in_face = [&](int face, int node) {
      const auto inner = inwards(face);
      const plane::located p = place(false, node);
      return std::array{inner[1] * (p.x - origin.x) - inner[0] * (p.y - origin.y), p.time};
    };
    return plane::trace_faces(input->boundary, result.raw, *result.exact, [&](int face, int node, int other) {
      const auto a = in_face(face, node);
      const auto b = in_face(face, other);
      return std::atan2(b[1] - a[1], b[0] - a[0]);
    });
  });
}

// ---- the skeleton

element_range<polygon_skeleton::node> polygon_skeleton::nodes() const { return {view_, view_.data->nodes(view_.raw)}; }
element_range<polygon_skeleton::arc> polygon_skeleton::arcs() const { return {view_, view_.data->arcs(view_.raw)}; }
element_range<polygon_skeleton::face> polygon_skeleton::faces() const {
  return {view_, static_cast<int>(view_.data->incidences(view_.raw).faces.size())};
}
polygon_skeleton polygon_skeleton::raw() const { return polygon_skeleton({view_.data, true}); }

offset_polygon polygon_skeleton::offset(const decimal& time) const {
  const data& d = *view_.data;
  const rational t = time_value(time);
  if (d.until && t > *d.until)
    throw input_error(input_fault::bad_number, 0, "an offset at a time after the end of the run", "compute the skeleton until then");
  auto found = d.offsets().at(t);
  if (d.is_exterior()) found = complement(std::move(found));
  offset_polygon result;
  result.parts = found.parts;
  result.rings.reserve(found.rings.size());
  for (auto& r : found.rings) {
    for (int& e : r.edges) e = d.input->input_edges[e];
    result.rings.push_back({std::move(r.points), std::move(r.edges), r.hole, r.part});
  }
  return result;
}

std::vector<offset_polygon> polygon_skeleton::offsets(std::span<const decimal> times) const {
  std::vector<offset_polygon> result;
  for (const decimal& t : times) result.push_back(offset(t));
  return result;
}
std::vector<offset_polygon> polygon_skeleton::offsets(std::initializer_list<decimal> times) const {
  return offsets(std::span<const decimal>(times.begin(), times.size()));
}

std::optional<skeleton_refutation> polygon_skeleton::verify() const {
  const data& d = *view_.data;
  if (d.until) throw unsupported_error("a run that was stopped has no certificate; hint: compute the skeleton without `until`");
  return certify(d.question(), d.result, d.options.kernel);
}

int polygon_skeleton::vertices() const { return static_cast<int>(view_.data->input->points.size()); }
int polygon_skeleton::holes() const { return view_.data->input->holes; }
int polygon_skeleton::parts() const { return view_.data->input->parts; }
const std::vector<std::string>& polygon_skeleton::notes() const& { return view_.data->input->repairs; }
const polygon_options& polygon_skeleton::options() const& { return view_.data->options; }

int polygon_skeleton::events(event_kind k) const {
  const auto& events = view_.data->result.raw.events;
  return k == event_kind::edge ? events[0] : k == event_kind::split ? events[1] : 0;
}

// ---- nodes

std::array<double, 2> polygon_skeleton::node::point() const {
  const plane::located p = of_.data->place(of_.raw, id_);
  return {p.x, p.y};
}
double polygon_skeleton::node::time() const { return vertex() >= 0 ? 0 : of_.data->place(of_.raw, id_).time; }

std::array<std::string, 2> polygon_skeleton::node::point_exact(int digits) const {
  const auto& p = *of_.data->input;
  const rational scale = power_of(p.ten, p.two);
  const int v = of_.data->vertex(of_.raw, id_);
  if (v >= 0)
    return {decimal_digits(rational(p.points[v][0] + p.shift[0]) * scale, digits),
            decimal_digits(rational(p.points[v][1] + p.shift[1]) * scale, digits)};
  const place_digits<2> at(p.lines, of_.data->lines(of_.raw, id_));
  if (!at.exists()) throw unsupported_error("three lines of a node do not meet");
  return {at.digits_of(at.coordinate(0), p.shift[0], scale, digits), at.digits_of(at.coordinate(1), p.shift[1], scale, digits)};
}

std::string polygon_skeleton::node::time_exact(int digits) const {
  const auto& p = *of_.data->input;
  if (vertex() >= 0) return decimal_digits(0, digits);
  const place_digits<2> at(p.lines, of_.data->lines(of_.raw, id_));
  if (!at.exists()) throw unsupported_error("three lines of a node do not meet");
  return at.digits_of(at.time(), 0, power_of(p.ten - p.weight_ten, p.two - p.weight_two), digits);
}

bool polygon_skeleton::node::has_place() const {
  return vertex() >= 0 || place_digits<2>(of_.data->input->lines, of_.data->lines(of_.raw, id_)).exists();
}

event_kind polygon_skeleton::node::event() const {
  const data& d = *of_.data;
  if (d.vertex(of_.raw, id_) >= 0) return event_kind::vertex;
  if (d.is_raw(of_.raw)) return d.result.raw.nodes[id_].event == plane::event_class::edge ? event_kind::edge : event_kind::split;
  // Two vertices of the wavefront that become one, or three that vanish; one that becomes two.
  const auto arcs = d.incidences(false).arcs_of_node[id_];
  const auto coming = std::count_if(arcs.begin(), arcs.end(), [&](int a) { return d.arc(false, a)[1] == id_; });
  if (arcs.size() != 3 || coming == 0) return event_kind::merged;
  return coming == 1 ? event_kind::split : event_kind::edge;
}

int polygon_skeleton::node::vertex() const {
  const int v = of_.data->vertex(of_.raw, id_);
  return v >= 0 ? of_.data->input->input_points[v] : -1;
}

std::vector<polygon_skeleton::arc> polygon_skeleton::node::arcs() const { return views<arc>(of_, of_.data->incidences(of_.raw).arcs_of_node[id_]); }

// ---- arcs

polygon_skeleton::node polygon_skeleton::arc::source() const { return {of_, of_.data->arc(of_.raw, id_)[0]}; }
polygon_skeleton::node polygon_skeleton::arc::target() const {
  const int to = of_.data->arc(of_.raw, id_)[1];
  if (to < 0) throw unsupported_error("an endless arc has no target");
  return {of_, to};
}
bool polygon_skeleton::arc::is_endless() const { return of_.data->arc(of_.raw, id_)[1] < 0; }

std::array<polygon_skeleton::face, 2> polygon_skeleton::arc::faces() const {
  const auto a = of_.data->arc(of_.raw, id_);
  const auto& face_of = of_.data->incidences(of_.raw).face_of;
  return {face(of_, face_of[a[2]]), face(of_, face_of[a[3]])};
}

std::array<double, 2> polygon_skeleton::arc::velocity() const {
  const data& d = *of_.data;
  const auto a = d.arc(of_.raw, id_);
  const auto u = d.inwards(a[2]);
  const auto v = d.inwards(a[3]);
  const rational unit = power_of(d.input->weight_ten, d.input->weight_two);
  const auto speed = [&](int face) { return rational(rational(d.input->lines[d.input->boundary.line[face]].weight) * unit).convert_to<double>(); };
  const double s = speed(a[2]);
  const double t = speed(a[3]);
  const double det = u[0] * v[1] - u[1] * v[0];
  if (det == 0) throw unsupported_error("an arc between parallel edges has no velocity");
  return {(s * v[1] - t * u[1]) / det, (t * u[0] - s * v[0]) / det};
}

// ---- faces

int polygon_skeleton::face::edge() const { return of_.data->input->input_edges[of_.data->incidences(of_.raw).faces[id_]]; }

std::vector<int> polygon_skeleton::face::edges() const {
  const data& d = *of_.data;
  const int first = d.incidences(of_.raw).faces[id_];
  std::vector<int> result;
  for (std::size_t e = 0; e < d.result.raw.faces.size(); ++e)
    if (d.result.raw.faces[e] == first) result.push_back(d.input->input_edges[e]);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::vector<polygon_skeleton::node>> polygon_skeleton::face::boundary() const {
  const data& d = *of_.data;
  if (d.is_raw(of_.raw)) throw unsupported_error("the boundaries of faces are known for the contracted skeleton only");
  const int first = d.incidences(false).faces[id_];
  const auto& loops = d.loops().loops;  // by face, and those of the polygon last
  std::vector<std::vector<node>> result;
  const auto end = std::find_if(loops.rbegin(), loops.rend(), [](const auto& l) { return l.face >= 0; }).base();
  for (auto l = std::lower_bound(loops.begin(), end, first, [](const auto&x, int f) { return x.face < f; }); l != end && l->face == first; ++l)
    result.push_back(views<node>(of_, l->nodes));
  return result;
}

std::vector<polygon_skeleton::arc> polygon_skeleton::face::arcs() const { return views<arc>(of_, of_.data->incidences(of_.raw).arcs_of_face[id_]); }

std::array<double, 2> polygon_skeleton::face::inwards() const { return of_.data->inwards(of_.data->incidences(of_.raw).faces[id_]); }

}  // namespace osteon
