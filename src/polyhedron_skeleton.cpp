// SPDX-License-Identifier: MIT

/// \file
/// The skeleton of a polyhedron: runs, views, certificate.

#include "polyhedron_skeleton_data.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "osteon/core/error.hpp"
#include "osteon/evaluate/meeting.hpp"
#include "osteon/evaluate/place_digits.hpp"

namespace osteon {
namespace {

constexpr event_kind kind_of(event_class c) { return static_cast<event_kind>(static_cast<int>(event_kind::E1) + static_cast<int>(c)); }
static_assert(kind_of(event_class::other) == event_kind::other);

template <class View, class Handle>
std::vector<View> views(const Handle& of, const std::vector<int>& ids) {
  std::vector<View> result;
  result.reserve(ids.size());
  for (const int i : ids) result.emplace_back(of, i);
  return result;
}

[[noreturn]] void no_place() { throw unsupported_error("the planes of a node do not meet in one point"); }

}  // namespace

polyhedron_skeleton skeletonize(const polyhedron& p, const polyhedron_options& options) {
  auto d = std::make_shared<polyhedron_skeleton::data>();
  d->input = p.access();
  d->options = options;
  d->options.saddle = options.saddle.value_or(default_saddle(options.prefer));
  const skeleton_options o{options.prefer, *d->options.saddle, options.explore};
  d->result = run(d->body(), o, options.kernel);
  return polyhedron_skeleton({std::move(d), false});
}

const std::vector<std::optional<rounded_place>>& polyhedron_skeleton::data::places() const {
  return places_.get([this] {
    const solid<integer>& s = body();
    const locator where(s.planes);
    const rational unit = unit_of(s);
    const auto rounded = [&](const std::array<rational, 3>& p, const rational& time) {
      rounded_place r{{}, static_cast<double>(rational(time * unit))};
      for (std::size_t axis = 0; axis < 3; ++axis) r.point[axis] = static_cast<double>(rational((p[axis] + s.shift[axis]) * unit));
      return r;
    };
    std::vector<std::optional<rounded_place>> all;
    for (const auto& n : result.raw.nodes) {
      if (n.vertex >= 0) {
        const auto& p = s.points[n.vertex];
        all.emplace_back(rounded({rational(p[0]), rational(p[1]), rational(p[2])}, 0));
      } else if (const auto at = where.meeting(n.planes)) {
        all.emplace_back(rounded(at->point, at->time));
      } else {
        all.emplace_back();
      }
    }
    return all;
  });
}

int polyhedron_skeleton::data::raw_node(bool raw, int node) const {
  if (is_raw(raw)) return node;
  const auto& all = result.exact->nodes[node].raw;
  for (const int n : all)
    if (places()[n]) return n;
  return all.front();
}

const plane_speeds& polyhedron_skeleton::data::speeds() const {
  return speeds_.get([this] {
    auto given = given_speeds(body(), options.kernel);
    return given ? plane_speeds(std::move(*given)) : plane_speeds(body().planes);
  });
}

const rational_offsets& polyhedron_skeleton::data::volumes() const {
  return volumes_.get([this] {
    auto given = given_speeds(body(), options.kernel);
    return rational_offsets(body().planes, result.raw, given ? std::move(*given) : rounded_speeds(body().planes));
  });
}

// ---- the skeleton

element_range<polyhedron_skeleton::node> polyhedron_skeleton::nodes() const {
  return {view_, view_.data->at(view_.raw, [](const auto& s) { return static_cast<int>(s.nodes.size()); })};
}
element_range<polyhedron_skeleton::arc> polyhedron_skeleton::arcs() const {
  return {view_, view_.data->at(view_.raw, [](const auto& s) { return static_cast<int>(s.arcs.size()); })};
}
element_range<polyhedron_skeleton::sheet> polyhedron_skeleton::sheets() const {
  return {view_, view_.data->at(view_.raw, [](const auto& s) { return static_cast<int>(s.sheets.size()); })};
}
element_range<polyhedron_skeleton::cell> polyhedron_skeleton::cells() const { return {view_, static_cast<int>(view_.data->result.raw.cells.size())}; }
polyhedron_skeleton polyhedron_skeleton::raw() const { return polyhedron_skeleton({view_.data, true}); }

std::optional<skeleton_refutation> polyhedron_skeleton::verify() const {
  const data& d = *view_.data;
  return certify(d.body(), d.result, d.options.kernel);
}

polyhedron polyhedron_skeleton::input() const { return polyhedron(view_.data->input); }
const polyhedron_options& polyhedron_skeleton::options() const& { return view_.data->options; }
int polyhedron_skeleton::events(event_kind k) const {
  const int c = static_cast<int>(k) - static_cast<int>(event_kind::E1);
  return c >= 0 && c < event_classes ? view_.data->result.raw.events[static_cast<std::size_t>(c)] : 0;
}
int polyhedron_skeleton::ambiguous() const { return view_.data->result.raw.ambiguous; }
int polyhedron_skeleton::unproven_splits() const { return view_.data->result.raw.unproven_splits; }

// ---- nodes

std::array<double, 3> polyhedron_skeleton::node::point() const {
  const auto& at = of_.data->places()[of_.data->raw_node(of_.raw, id_)];
  if (!at) no_place();
  return at->point;
}
double polyhedron_skeleton::node::time() const {
  const auto& at = of_.data->places()[of_.data->raw_node(of_.raw, id_)];
  if (!at) no_place();
  return at->time;
}
bool polyhedron_skeleton::node::has_place() const { return of_.data->places()[of_.data->raw_node(of_.raw, id_)].has_value(); }

std::array<std::string, 3> polyhedron_skeleton::node::point_exact(int digits) const {
  const auto& s = of_.data->body();
  const auto& n = of_.data->result.raw.nodes[of_.data->raw_node(of_.raw, id_)];
  const rational unit = unit_of(s);
  std::array<std::string, 3> text;
  if (n.vertex >= 0) {
    const auto& p = s.points[n.vertex];
    for (std::size_t axis = 0; axis < 3; ++axis) text[axis] = decimal_digits(rational(p[axis] + s.shift[axis]) * unit, digits);
    return text;
  }
  const place_digits<3> at(s.planes, n.planes);
  if (!at.exists()) no_place();
  for (int axis = 0; axis < 3; ++axis) text[axis] = at.digits_of(at.coordinate(axis), s.shift[axis], unit, digits);
  return text;
}

std::string polyhedron_skeleton::node::time_exact(int digits) const {
  const auto& n = of_.data->result.raw.nodes[of_.data->raw_node(of_.raw, id_)];
  if (n.vertex >= 0) return decimal_digits(0, digits);
  const place_digits<3> at(of_.data->body().planes, n.planes);
  if (!at.exists()) no_place();
  return at.digits_of(at.time(), 0, unit_of(of_.data->body()), digits);
}

event_kind polyhedron_skeleton::node::event() const {
  const auto& r = of_.data->result;
  if (vertex() >= 0) return event_kind::vertex;
  if (of_.data->is_raw(of_.raw)) return kind_of(r.raw.nodes[id_].event);
  const auto& raw = r.exact->nodes[id_].raw;
  return raw.size() == 1 ? kind_of(r.raw.nodes[raw[0]].event) : event_kind::merged;
}

bool polyhedron_skeleton::node::is_ambiguous() const {
  for (const node& n : raw_nodes())
    if (of_.data->result.raw.nodes[n.id()].ambiguous) return true;
  return false;
}

int polyhedron_skeleton::node::vertex() const {
  for (const node& n : raw_nodes())
    if (const int v = of_.data->result.raw.nodes[n.id()].vertex; v >= 0) return of_.data->body().input_points[v];
  return -1;
}

std::vector<int> polyhedron_skeleton::node::planes() const {
  std::vector<int> all;
  for (const node& n : raw_nodes()) {
    const auto& raw = of_.data->result.raw.nodes[n.id()];
    if (raw.vertex >= 0)
      for (const plane_id p : of_.data->body().boundary.vertices[raw.vertex].facets) all.push_back(p);
    else
      all.insert(all.end(), raw.planes.begin(), raw.planes.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<polyhedron_skeleton::arc> polyhedron_skeleton::node::arcs() const {
  return views<arc>(of_, of_.data->at(of_.raw, [this](const auto& s) { return s.nodes[id_].arcs; }));
}

std::vector<polyhedron_skeleton::node> polyhedron_skeleton::node::raw_nodes() const {
  const handle raw{of_.data, true};
  if (of_.data->is_raw(of_.raw)) return {node(raw, id_)};
  return views<node>(raw, of_.data->result.exact->nodes[id_].raw);
}

// ---- arcs

polyhedron_skeleton::node polyhedron_skeleton::arc::source() const {
  return {of_, of_.data->at(of_.raw, [this](const auto& s) { return s.arcs[id_].source; })};
}
polyhedron_skeleton::node polyhedron_skeleton::arc::target() const {
  return {of_, of_.data->at(of_.raw, [this](const auto& s) { return s.arcs[id_].target; })};
}
std::vector<int> polyhedron_skeleton::arc::planes() const {
  const auto& r = of_.data->result;
  if (!of_.data->is_raw(of_.raw)) return r.exact->arcs[id_].cells;
  return {r.raw.arcs[id_].planes.begin(), r.raw.arcs[id_].planes.end()};
}
std::vector<polyhedron_skeleton::sheet> polyhedron_skeleton::arc::sheets() const {
  std::vector<int> ids = of_.data->at(of_.raw, [this](const auto& s) { return s.arcs[id_].sheets; });
  std::sort(ids.begin(), ids.end());
  return views<sheet>(of_, ids);
}

// ---- sheets and cells

std::array<int, 2> polyhedron_skeleton::sheet::planes() const {
  return of_.data->at(of_.raw, [this](const auto& s) { return s.sheets[id_].facets; });
}
std::vector<polyhedron_skeleton::arc> polyhedron_skeleton::sheet::arcs() const {
  return views<arc>(of_, of_.data->at(of_.raw, [this](const auto& s) { return s.sheets[id_].arcs; }));
}
std::optional<std::array<int, 2>> polyhedron_skeleton::sheet::input_edge() const {
  if (!of_.data->is_raw(of_.raw)) return std::nullopt;
  const int e = of_.data->result.raw.sheets[id_].input_edge;
  if (e < 0) return std::nullopt;
  const auto& ends = of_.data->body().boundary.edges[e].ends;
  const auto& points = of_.data->body().input_points;
  return std::array{points[ends[0]], points[ends[1]]};
}
int polyhedron_skeleton::sheet::representative() const { return of_.data->is_raw(of_.raw) ? of_.data->result.raw.sheets[id_].representative : id_; }

std::vector<int> polyhedron_skeleton::cell::facets() const { return polyhedron(of_.data->input).facets_in(id_); }
std::vector<polyhedron_skeleton::sheet> polyhedron_skeleton::cell::sheets() const {
  const auto& r = of_.data->result;
  if (of_.data->is_raw(of_.raw)) return views<sheet>(of_, r.raw.cells[id_]);
  std::vector<int> ids;
  for (std::size_t s = 0; s < r.exact->sheets.size(); ++s)
    if (r.exact->sheets[s].facets[0] == id_ || r.exact->sheets[s].facets[1] == id_) ids.push_back(static_cast<int>(s));
  return views<sheet>(of_, ids);
}

}  // namespace osteon
