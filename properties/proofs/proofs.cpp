// SPDX-License-Identifier: MIT

/// \file
/// Proofs by exhaustion: see `proofs --help`.

#include <iostream>
#include <string_view>

#include "arrangement.hpp"
#include "classes.hpp"
#include "events.hpp"
#include "report.hpp"
#include "splits.hpp"
#include "triangulations.hpp"

namespace {

struct claim {
  const char* statement;
  void (*prove)(osteon::proofs::proof&);
};

constexpr claim claims[] = {
    {"Four planes in coordinates: the small cell, the cell that is missing, the labels of all pieces; all 24 orders of arrival occur",
     osteon::proofs::prove_local_picture},
    {"Existence: every local event has an admissible successor, and the catalogue agrees", osteon::proofs::prove_existence},
    {"Uniqueness: every local event has one successor, but for two saddles; these are E1 and make a convex or a reflex edge",
     osteon::proofs::prove_uniqueness},
    {"Reading off: no two states look the same on the boundary", osteon::proofs::prove_reading},
    {"Inverse events: reversing time gives table 3.1 of the thesis", osteon::proofs::prove_inverse_events},
    {"Classes: each of the thirteen has members", osteon::proofs::prove_classes},
    {"Corners: the monotone functions of three variables that depend on all are and, or, x(y+z), x+yz and majority: nine",
     osteon::proofs::prove_nine_corners},
    {"Candidates: every event is met by a candidate of the event loop", osteon::proofs::prove_candidates},
    {"Link: before and after make one monotone function; each of the 24 orders of arrival belongs to one facet; its corners are the arcs",
     osteon::proofs::prove_link},
    {"Trees: a vertex of degree k has Catalan(k - 2); the thesis's lists of operations are a bijection, in lexicographic order",
     osteon::proofs::prove_catalan},
};

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const bool help = std::string_view(argv[1]) == "--help";
    (help ? std::cout : std::cerr) << "usage: proofs [--help]\n"
                                      "Proves what Osteon rests on by going through all cases: the events of four planes, the trees that split a\n"
                                      "vertex, the thesis's table of inverse events. Each statement is derived anew and compared with the library.\n"
                                      "Prints a line per statement: PROVED, or REFUTED with a counterexample; below it, what was found on the way.\n"
                                      "Statements that say 'examined' hold for all corners of the stated families, not for all there are.\n"
                                      "Exit status: 0 all proved, 1 not all, 2 bad usage.\n";
    return help ? 0 : 2;
  }
  bool all = true;
  for (const claim& c : claims) {
    osteon::proofs::proof p(c.statement);
    c.prove(p);
    all = p.print(std::cout) && all;
  }
  for (const osteon::proofs::proof& p : osteon::proofs::split_survey().run()) all = p.print(std::cout) && all;
  return all ? 0 : 1;
}
