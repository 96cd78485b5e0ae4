#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants known faults, one at a time, into a copy of the library and shows that the harness catches each.

    properties/mutation_check.py [--jobs N] [NAME ...]      all faults, or those whose names contain a NAME

For each fault the named test programs are compiled against the copy and run until one fails. A fault that no program notices, or that
does not compile, ends the script with status 1. First every program must pass without a fault. Needs a C++ compiler ($CXX), GoogleTest and
GMP; takes about a minute a fault on one core.
"""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CATALOGUE, VERIFY, KERNEL, VOXEL, DEGENERATE, ROOTS, SOLID, SEARCH = (
    ("catalogue_test", "*"), ("verify_test", "Certificate.OfEvery*:Certificate.OfTheThesis*:Corrupted*"), ("kernel_test", "*"), ("voxel_test", "*"),
    ("degenerate_test", "*"), ("square_classes_test", "*"), ("regression_test", "*"), ("split_search_test", "*"))
PLANE = ("planar_skeleton_test", "*")
OUTSIDE = ("planar_verify_test", "*Outside*")
INCLUDE, KERNELS = "include/osteon/", "kernels/osteon/kernel/"

# name, file, what is there, what is put in its place, the programs that should notice
FAULTS = [
    ("a facet may appear from nowhere", INCLUDE + "space/catalogue.hpp", "if (!attached) return false;", "if (!attached) return true;", [CATALOGUE]),
    ("states need not stay monotone", INCLUDE + "space/catalogue.hpp", "const bool ok = monotone(after, small) && ", "const bool ok = ", [CATALOGUE]),
    ("the wrong cell is filled", INCLUDE + "space/catalogue.hpp", "return fill ? kept | state{1} << (e.small ^ 15U) : kept;",
     "return fill ? kept : kept | state{1} << (e.small ^ 15U);", [CATALOGUE]),
    ("planes without edges are not looked at", INCLUDE + "space/catalogue.hpp", "if ((with_edge >> q & 1U) == 0 && involved",
     "if ((with_edge >> q & 1U) != 0 && involved", [CATALOGUE, VERIFY]),
    ("edges collapse unseen", INCLUDE + "space/propagate.hpp", "collapse_[e] = m;\n    consider(m, std::nullopt);", "collapse_[e] = m;", [VERIFY]),
    ("mixed vertices hit borders unseen", INCLUDE + "space/propagate.hpp", "for (const plane_id l : neighbours) consider_contact(v, l);", "", [VERIFY]),
    ("reflex vertices hit facets unseen", INCLUDE + "space/propagate.hpp", "if (corner_of(v) != local::reflex) return;", "return;", [VERIFY]),
    ("reflex edges cross unseen", INCLUDE + "space/propagate.hpp", "if (!enclose(q)) continue;", "continue;", [VERIFY]),
    ("new neighbours are not watched", INCLUDE + "space/propagate.hpp", "if (makes_contacts(v)) consider_contact(v, planes[1 - side]);", "(void)v;", [VERIFY, VOXEL]),
    ("a tetrahedron is recognised by the wrong signs", INCLUDE + "space/propagate.hpp", "(r % 2 == 0) ? 0 : 1] = true;", "(r % 2 != 3) ? 0 : 1] = true;",
     [VERIFY]),
    ("vertices are watched once", INCLUDE + "space/propagate.hpp",
     "if (until && (!*until || (horizon && k_.compare(*horizon, **until) != sign::positive))) return;", "if (until) return;", [VERIFY, VOXEL]),
    ("the saddle takes the other way", INCLUDE + "space/propagate.hpp", "if (options_.saddle == saddle_rule::convex) return true;",
     "if (options_.saddle == saddle_rule::convex) return false;", [VERIFY, VOXEL]),
    ("collinear edges keep two polygons", INCLUDE + "space/propagate.hpp",
     "result_.sheets[polygon_of(gone.sheet)].polygon = polygon_of(front_.edges()[at_k].sheet);", "", [VERIFY]),
    ("an event's ambiguity is not counted", INCLUDE + "space/propagate.hpp", "result_.ambiguous += ambiguous ? 1 : 0;", "", [VERIFY]),
    ("facets never run along edges", INCLUDE + "space/propagate.hpp", "static constexpr int most_floods = 3;", "static constexpr int most_floods = 0;",
     [VERIFY, SOLID]),
    ("every tree is valid", INCLUDE + "space/split.hpp", "if (pierces(e, p, facet)) return false;", "if (pierces(e, p, facet)) break;", [VERIFY]),
    ("the local rule is turned round", INCLUDE + "space/split.hpp", "if (up != (inside == 0 || inside == 3)) return false;",
     "if (up == (inside == 0 || inside == 3)) return false;", [VERIFY]),
    ("new edges have the other bend", INCLUDE + "space/split.hpp", "e.convex = positive(t.vertices[v]) == (signs_.side(third", "e.convex = positive(t.vertices[v]) != (signs_.side(third",
     [VERIFY]),
    ("borders may turn round", INCLUDE + "space/split_search.hpp", "l.turns + r.turns + between == whole_turns(m);", "l.turns + r.turns + between <= whole_turns(m) + 9;", [SEARCH]),
    ("convex edges need not follow each other", INCLUDE + "space/split_search.hpp", "return x == 0 || y == 0 || (x == 1 && y == 1);", "return x >= 0 || y >= 0;", [SEARCH]),
    ("the search jumps back too far", INCLUDE + "space/split_search.hpp", "if (t.level >= 0) blame[t.level] = true;", "", [SEARCH]),
    ("edges of a facet may cross", INCLUDE + "space/corner.hpp", "(x.convex == positive(x.facet, x.other, end))) return false;",
     "(x.convex == positive(x.facet, x.other, end))) return true;", [SEARCH]),
    ("a convex corner is split anyhow", INCLUDE + "space/preferred_split.hpp", "if (across == apex.end() || !cuts(f, a, b, across->second)) {",
     "if (across == apex.end() || cuts(f, a, b, across->second)) {", [SEARCH]),
    ("nodes of one place stay apart", INCLUDE + "space/contract.hpp", "if (on_planes(p, places_[q].corner)) found = static_cast<int>(q);", "", [DEGENERATE]),
    ("arcs run through places", INCLUDE + "space/contract.hpp", "for (const int p : between(a.planes, from, to)) stops.push_back(p);", "", [DEGENERATE]),
    ("a minor has the wrong sign", KERNELS + "formulas.hpp", "return {-minor(m, {q[1], q[2], q[3]}), minor(m, {q[0], q[2], q[3]})",
     "return {-minor(m, {q[1], q[2], q[3]}), -minor(m, {q[0], q[2], q[3]})", [KERNEL]),
    ("the filter is too sure", KERNELS + "estimate.hpp", "bound = 100 * 0x1p-53", "bound = 0.01 * 0x1p-53", [KERNEL, VERIFY]),
    ("the start is before time zero", KERNELS + "perturbed.hpp", "if (const sign s = at(g, k_.closing_at(g, q)); s != sign::zero) return -s;",
     "if (const sign s = at(g, k_.closing_at(g, q)); s != sign::zero) return s;", [KERNEL, VERIFY]),
    ("roots of one class are taken for independent", KERNELS + "square_classes.hpp", "if (level == 0 && is_zero(terms, size)) return sign::zero;",
     "if (level == 3) return sign::positive;", [ROOTS]),
    ("the certificate does not look for overlaps", INCLUDE + "space/verify.hpp", "      check_overlaps();\n", "", [VERIFY]),
    ("the certificate does not look around nodes", INCLUDE + "space/verify.hpp", "if (s_.nodes[n].vertex < 0) check_event(n);", "", [VERIFY]),
    ("plane: edges without length stay", INCLUDE + "plane/propagate.hpp", "|| !k_.touches(h, t, line, moment_)) continue;", "|| true) continue;", [PLANE]),
    ("plane: edges without length are not looked for", INCLUDE + "plane/propagate.hpp", "if (when.first <= when_.last) fresh_.push_back(e);", "", [PLANE]),
    ("plane: arcs pass through nodes unseen", INCLUDE + "plane/propagate.hpp", "result_.passes.push_back({front_.vertices[v].arc, m.node});", "{}", [PLANE]),
    ("plane: changed edges are not looked at", INCLUDE + "plane/propagate.hpp", "look_from_edge(changed[i]);", "", [PLANE]),
    ("plane: new reflex vertices are not looked at", INCLUDE + "plane/propagate.hpp", "look_from_vertex(vertices[i]);", "", [PLANE]),
    ("plane: merged edges are not looked at", INCLUDE + "plane/propagate.hpp", "touched[count++] = merged[r];", "", [PLANE]),
    ("plane: windows without contacts", INCLUDE + "plane/propagate.hpp", "contacts_ = std::ranges::any_of(", "contacts_ = !std::ranges::any_of(", [PLANE]),
    ("plane: other edges on the line are not seen", INCLUDE + "plane/propagate.hpp", "return l != n.q[r] && std::find(", "return false && std::find(", [PLANE]),
    ("plane: an old candidate counts as a new one", INCLUDE + "plane/propagate.hpp", "if (!is_current(c) || lines_of(c) != triple(k_.planes(m)) ||",
     "if (!front_.edges[c.edge].alive || lines_of(c) != triple(k_.planes(m)) ||", [PLANE]),
    ("plane: slices begin too late", INCLUDE + "plane/event_queue.hpp", "(heap_.empty() || heap_.front().when.last >= next_begin())", "heap_.empty()", [PLANE]),
    ("plane: renumbered edges are alone on their line", INCLUDE + "plane/wavefront.hpp", "if (e.next >= 0) e.next = now.edges[e.next];", "e.next = -1;", [PLANE]),
    ("plane: renumbering forgets what was expected", INCLUDE + "plane/propagate.hpp", "return c.edge >= 0 && (c.arc < 0 || c.vertex >= 0) && is_current(c);",
     "return false;", [PLANE]),
    ("plane: a box in two parts is put into one", INCLUDE + "core/box_tree.hpp", "for (std::uint32_t j = from[1]; j <= to[1]; ++j)",
     "for (std::uint32_t j = from[1]; j <= from[1]; ++j)", [PLANE]),
    ("plane: the side of a convex tail is turned round", INCLUDE + "plane/propagate.hpp", "== front_.vertices[front_.edges[e].tail].reflex) return false;",
     "!= front_.vertices[front_.edges[e].tail].reflex) return false;", [PLANE]),
    ("plane: all are taken for neighbours", INCLUDE + "plane/propagate.hpp", "return front_.edges[e].tail == front_.edges[vertex.out].head ||",
     "return front_.edges[e].alive ||", [PLANE]),
    ("plane: what is infinitely late happens", INCLUDE + "plane/propagate.hpp", " && collapse_[e].first < infinity &&", " &&", [OUTSIDE]),
    ("plane: the outside is linked as the inside", INCLUDE + "input/make_polygon.hpp", "if (touching && outside_) link_sectors(true);", "", [OUTSIDE]),
    ("plane: rings that are left may cross", INCLUDE + "plane/terminal_wavefront.hpp", "if (e < f && touch(e, f)) return e;", "", [OUTSIDE]),
    ("plane: rings that are left may lie in one another", INCLUDE + "plane/terminal_wavefront.hpp", "if (winding != 0) return e;", "", [OUTSIDE]),
    ("the anchors' differences are forgotten", KERNELS + "estimate.hpp", "if (i == origin) return sum;", "return sum;", [PLANE]),
    ("drifts count where times differ", KERNELS + "perturbed.hpp", "      if (s != sign::zero) return s;\n      if constexpr (requires { k_.compare_drift",
     "      if constexpr (requires { k_.compare_drift", [PLANE]),
]


def run(command, seconds):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None


def failing_program(tree, programs):
    """The first program that fails or takes ten minutes, or None. Raises RuntimeError where one does not compile."""
    for name, selected in programs:
        binary = tree / name
        built = run([os.environ.get("CXX", "g++"), "-std=c++20", "-O1", f"-I{tree}/include", f"-I{tree}/kernels", f"-I{ROOT}/oracles",
                     f'-DOSTEON_CORPUS="{ROOT}/../shared/corpus"', f'-DOSTEON_MODELS="{ROOT}/tests/models"', str(ROOT / "tests" / (name + ".cpp")),
                     "-o", str(binary), "-lgtest", "-lgtest_main", "-lgmp"], 1200)
        if built is None or built.returncode != 0:
            raise RuntimeError(f"{name} does not compile\n{built.stderr.decode(errors='replace') if built else ''}")
        result = run([str(binary), f"--gtest_filter={selected}", "--gtest_brief=1"], 600)
        if result is None or result.returncode != 0:
            return name
    return None


def examine(fault):
    name, file, old, new, programs = fault
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        for part in ("include", "kernels"):
            shutil.copytree(ROOT / part, tree / part)
        if file:
            text = (tree / file).read_text()
            if text.count(old) != 1:
                return False, f"{name}: the place is not there once; hint: bring this script up to date"
            (tree / file).write_text(text.replace(old, new))
        try:
            by = failing_program(tree, programs)
        except RuntimeError as error:
            return False, f"{name}: {error}"
    if not file:
        return by is None, f"{name}: " + ("pass" if by is None else f"{by} fails without a fault")
    return by is not None, f"{name}: " + (f"caught by {by}" if by else "NOT CAUGHT")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("name", nargs="*")
    arguments = parser.parse_args()
    chosen = [f for f in FAULTS if not arguments.name or any(n in f[0] for n in arguments.name)]
    needed = sorted({p for f in chosen for p in f[4]})
    tasks = [("without a fault", None, None, None, needed)] + chosen
    good = True
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for ok, message in pool.map(examine, tasks):
            print(message, flush=True)
            good = good and ok
    print(f"{len(chosen)} faults, " + ("all caught" if good else "NOT all caught"))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
