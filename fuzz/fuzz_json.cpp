// SPDX-License-Identifier: MIT

// The reader of skeleton documents, and the certificate on what it reads: any text, or the document of a small solid with a few values
// changed. Either an input error that a terminal can print, or a skeleton that the certificate judges without failing; what it certifies
// is the skeleton that was written.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "osteon/osteon.hpp"

#include "check.hpp"
#include "decode.hpp"
#include "documents.hpp"
#include "osteon/input/write_obj.hpp"
#include "osteon/inspect.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::fuzz {
namespace {

using json = nlohmann::json;

std::string written(const polyhedron_document& d) {
  std::ostringstream out;
  app::write_document(out, d);
  return out.str();
}

polyhedron polyhedron_of(const models::builder& model) {
  std::stringstream text;
  write_obj(text, model.take<integer>());
  return read_polyhedron(text, "model.obj");
}

// A solid and what the program writes for it.
struct example {
  explicit example(const models::builder& of) : p(polyhedron_of(of)), skeleton(skeletonize(p).document()), doc(json::parse(written(skeleton))) {}
  polyhedron p;
  polyhedron_document skeleton;
  json doc;
};

const std::vector<example>& examples() {
  static const std::vector<example> all = [] {
    std::vector<example> result;
    result.emplace_back(models::tetrahedron());
    result.emplace_back(models::box(1, 2, 3));
    result.emplace_back(models::notched_box(3));
    result.emplace_back(models::saddle());
    models::voxels v({2, 2, 2});  // a majority corner and its like
    for (const auto& [x, y, z] : {std::tuple(0, 0, 0), std::tuple(1, 0, 0), std::tuple(0, 1, 0), std::tuple(0, 0, 1)}) v.set(x, y, z, true);
    result.emplace_back(v.surface());
    return result;
  }();
  return all;
}

// Changes one value somewhere in a document.
void change(json& doc, decoder& d) {
  json* at = &doc;
  json* in = nullptr;
  while ((at->is_object() || at->is_array()) && !at->empty()) {
    const std::size_t child = d.index(at->size());
    if (in != nullptr && d.one_in(12)) break;
    in = at;
    at = at->is_array() ? &(*at)[child] : &std::next(at->begin(), static_cast<std::ptrdiff_t>(child)).value();
  }
  if (in == nullptr) return;
  switch (d.between(0, 9)) {
    case 0:
    case 1:
    case 2:
      if (at->is_number_integer()) {
        *at = at->get<std::int64_t>() + d.between(-2, 2);
        break;
      }
      [[fallthrough]];
    case 3:
      *at = d.between(-2, 60);
      break;
    case 4:
      if (in->is_array()) {
        const json other = (*in)[d.index(in->size())];
        in->push_back(other);
        break;
      }
      [[fallthrough]];
    case 5:
      if (in->is_array()) {
        std::swap(*at, (*in)[d.index(in->size())]);
        break;
      }
      [[fallthrough]];
    case 6:
      if (in->is_array())
        in->erase(static_cast<std::size_t>(at - &(*in)[0]));
      else
        for (auto i = in->begin(); i != in->end(); ++i)
          if (&i.value() == at) {
            in->erase(i);
            break;
          }
      break;
    case 7:
      *at = static_cast<std::int64_t>(static_cast<std::uint64_t>(d.between(0, 0xFFFFFFF)) << static_cast<unsigned>(d.between(0, 40)));
      break;
    case 8:
      *at = std::to_string(d.between(-1000, 1000));
      break;
    default:
      *at = std::array{json(nullptr), json(true), json(1.5), json::array(), json::object(), json(""), json("-"), json(~std::uint64_t{0})}[d.index(8)];
  }
}

// A skeleton up to the order of what has none.
polyhedron_document ordered(polyhedron_document s) {
  const auto sort = [](auto& list) { std::sort(list.begin(), list.end()); };
  for (auto& n : s.nodes) {
    sort(n.arcs);
    if (n.vertex >= 0) n.planes = {};  // any three of the vertex's
  }
  std::vector<int> least(s.sheets.size(), -1);
  for (std::size_t i = 0; i < s.sheets.size(); ++i) {
    sort(s.sheets[i].arcs);
    int& first = least[static_cast<std::size_t>(s.sheets[i].representative)];
    if (first < 0) first = static_cast<int>(i);
    s.sheets[i].representative = first;
  }
  for (auto& c : s.cells) sort(c);
  return s;
}

bool same(const polyhedron_document& x, const polyhedron_document& y) {
  const auto all = [](const auto& a, const auto& b, auto parts) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& l, const auto& r) { return parts(l) == parts(r); });
  };
  using d = polyhedron_document;
  return all(x.nodes, y.nodes, [](const d::node& n) { return std::tie(n.vertex, n.planes, n.event, n.ambiguous, n.arcs); }) &&
         all(x.arcs, y.arcs, [](const d::arc& a) { return std::tie(a.source, a.target, a.planes, a.corner, a.sheets); }) &&
         all(x.sheets, y.sheets, [](const d::sheet& s) { return std::tie(s.planes, s.edge, s.representative, s.arcs); }) && x.cells == y.cells &&
         x.events == y.events && x.ambiguous == y.ambiguous;
}

void run(decoder d) {
  const unsigned plan = d.byte();
  const example& of = examples()[plan % examples().size()];
  const bool any_text = plan >= 240;
  std::string text;
  long changes = 0;
  if (any_text) {
    while (!d.empty()) text += static_cast<char>(d.byte());
  } else {
    json doc = of.doc;
    changes = d.between(0, 3);
    for (long i = 0; i < changes; ++i) change(doc, d);
    text = doc.dump();
  }

  polyhedron_document read;
  try {
    std::istringstream in(text);
    read = app::read_polyhedron_document(in, "input.json");
  } catch (const input_error& e) {
    const std::string what = e.what();
    require(changes > 0 || any_text, "what was written is read");
    require(e.fault == input_fault::not_skeleton && !e.hint.empty(), "an input error says that this is no skeleton");
    require(std::all_of(what.begin(), what.end(), [](char c) { return c >= ' ' && c <= '~'; }), "a message is printable");
    tally::add(any_text ? "text, refused" : "document, refused");
    return;
  }
  const auto refuted = verify(of.p, read);
  if (changes == 0 && !any_text) require(!refuted, "what was written is certified");
  if (refuted) {
    require(!refuted->witness.empty(), "a refutation has a witness");
    tally::add("document, refuted: " + std::string(refuted->rule));
    return;
  }
  for (const auto& n : read.nodes) {
    if (n.vertex < 0) continue;
    const auto planes = inspect::vertex_splits(of.p, of.p.vertex_at(n.vertex)).planes();
    for (std::size_t r = 0; r < 3; ++r)
      require(std::find(planes.begin(), planes.end(), n.planes[r]) != planes.end(), "the planes of a certified vertex pass through it");
  }
  require(same(ordered(read), ordered(of.skeleton)), "what is certified is what was written");
  require(json::parse(written(read))["nodes"].size() == of.doc["nodes"].size(), "what is read can be written");
  tally::add("document, certified");
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder({data, size}));
  return 0;
}
