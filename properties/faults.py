# SPDX-License-Identifier: MIT
"""The faults that mutation_check.py plants, and the programs that should notice each.

To add one, append a line: what is wrong then, the function (or constant) that it is planted in, a regular expression, what takes the place of what the
expression finds, and the programs. The function is named by its identifier alone, with a class or namespace before it where that is not enough; it may
stand in any header. A space in the expression stands for any white space, so that line breaks do not matter; comments are not seen. The expression
must match exactly once in all functions of that name. `mutation_check.py --check` says so within seconds.
"""
import collections

Fault = collections.namedtuple("Fault", "name function pattern replacement programs")
# A program of tests/ and the tests of it that are run.
Program = collections.namedtuple("Program", "source tests")

CATALOGUE = Program("catalogue_test", "*")
VERIFY = Program("verify_test", "Certificate.OfEvery*:Certificate.OfTheThesis*:Corrupted*")
KERNEL = Program("kernel_test", "*")
VOXEL = Program("voxel_test", "*")
DEGENERATE = Program("degenerate_test", "*")
ROOTS = Program("square_classes_test", "*")
SOLID = Program("regression_test", "*")
SEARCH = Program("split_search_test", "*")
PLANE = Program("planar_skeleton_test", "*")
OUTSIDE = Program("planar_verify_test", "*Outside*")

FAULTS = [Fault(*fault) for fault in [
    # ---- local events
    ("a facet may appear from nowhere", "no_facet_from_nowhere|makes_facet_from_nowhere", r"if \(!attached\)", "if (!attached && q > 99)", [CATALOGUE]),
    ("states need not stay monotone", "catalogue::catalogue|for_each_event", r"monotone(<Planes>)?\(after, small\) && ", "", [CATALOGUE]),
    ("the wrong cell is filled", "successor", r"return fill \? kept \| (.*?) : kept;", r"return fill ? kept : kept | \1;", [CATALOGUE]),
    ("planes without edges are not looked at", "key", r"\(with_edge >> q & 1U\) == 0 && involved", "(with_edge >> q & 1U) != 0 && involved", [CATALOGUE, VERIFY]),

    # ---- the event loop of solids
    ("edges collapse unseen", "watch_collapse", r"(collapse_\[e\] = m;) consider\(m, std::nullopt\);", r"\1", [VERIFY]),
    ("mixed vertices hit borders unseen", "watch_contacts", r"for \(const plane_id l : neighbours\) consider_contact\(v, l\);", "", [VERIFY]),
    ("reflex vertices hit facets unseen", "watch_contacts", r"if \((corner_of\(v\)|vertex\.corner) != local::reflex\) return;", "return;", [VERIFY]),
    ("reflex edges cross unseen", "watch_crossings", r"if \(!enclose\(q\)\) continue;", "continue;", [VERIFY]),
    ("new neighbours are not watched", "watch_neighbours", r"if \(makes_contacts\(v\)\) consider_contact\(v, [^;]*;", "(void)v;", [VERIFY, VOXEL]),
    ("a tetrahedron is recognised by the wrong signs", "enclose", r"seen\[(.*?) \? 0 : 1\] = true;", r"seen[(\1) == (r % 2 == 0) ? 0 : 1] = true;", [VERIFY]),
    ("vertices are watched once", "watch_contacts", r"if \(until && \(!\*until \|\| [^;]*\) return;", "if (until) return;", [VERIFY, VOXEL]),
    ("the saddle takes the other way", "choose|propagation::fills", r"if \((\w+\.)?saddle == saddle_rule::convex\) return true;", r"if (\1saddle == saddle_rule::convex) return false;",
     [VERIFY, VOXEL]),
    ("collinear edges keep two polygons", "relink",
     r"(result_\.sheets\[\w+\(gone\.sheet\)\]\.representative = |merge_sheets\(gone\.sheet)[^;]*;", "", [VERIFY]),
    ("an event's ambiguity is not counted", "propagation::replace|front_surgery::record_event", r"result_\.ambiguous \+= ambiguous \? 1 : 0;", "", [VERIFY]),
    ("facets never run along edges", "most_insertions", r"most_insertions = 3", "most_insertions = 0", [VERIFY, SOLID]),

    # ---- splits of vertices
    ("every tree is valid", "valid", r"if \(pierces\(e, p, facet\)\) return false;", "if (pierces(e, p, facet)) break;", [VERIFY]),
    ("the local rule is turned round", "obeys_local_rule", r"if \(up != \(inside == 0 \|\| inside == 3\)\) return false;",
     "if (up == (inside == 0 || inside == 3)) return false;", [VERIFY]),
    ("new edges have the other bend", "set_convexity", r"(e\.convex = positive\(t\.vertices\[v\]\)) ==", r"\1 !=", [VERIFY]),
    ("borders may turn round", "borders_meet|facet_turns::meet", r"(\w+\.turns \+ \w+\.turns \+ between) == whole_turns\(m\);", r"\1 <= whole_turns(m) + 9;", [SEARCH]),
    ("convex edges need not follow each other", "phases_meet", r"return x == 0 \|\| y == 0 \|\| \(x == 1 && y == 1\);", "return x >= 0 || y >= 0;", [SEARCH]),
    ("the search jumps back too far", "descend", r"if \(t\.level >= 0\) blame\[t\.level\] = true;", "", [SEARCH]),
    ("edges of a facet may cross", "runs_through", r"(\(x\.convex == positive\(x\.facet, x\.other, end\)\)\)) return false;", r"\1 return true;", [SEARCH]),
    ("a convex corner is split anyhow", "only_split", r"if \(across == apex\.end\(\) \|\| !cuts\(", "if (across == apex.end() || cuts(", [SEARCH]),

    # ---- contraction and certificate of solids
    ("nodes of one place stay apart", "contraction::merge_nodes|limit_points::limit_points", r"if \(on_planes\(p, \w+\[q\]\.\w+\)\) found = [^;]*;", "", [DEGENERATE]),
    ("arcs run through places", "subdivide_arcs", r"for \(const int p : [\w.]*between\(a\.planes, from, to\)\) stops\.push_back\(p\);", "", [DEGENERATE]),
    ("the certificate does not look for overlaps", "verifier::run|osteon::verify", r"(check_overlaps\(\)|certificate::overlap_check<K>\(.*?\)\.run\(\));", ";", [VERIFY]),
    ("the certificate does not look around nodes", "verifier::run|link_check::run", r"if \(s_\.nodes\[n\]\.vertex < 0\) check_event\(n\);", "", [VERIFY]),

    # ---- kernels
    ("a minor has the wrong sign", "osteon::lambda", r"return \(N - 1 - r\) % 2 == 0 \? (\w+) : [^;]*;", r"return \1;", [KERNEL, VERIFY]),
    ("the filter is too sure", "bound", r"bound = 100 \* 0x1p-53", "bound = 0.01 * 0x1p-53", [KERNEL, VERIFY]),
    ("the start is before time zero", "perturbed::at_start", r"(k_\.closing_at\(g, q\)\); s != sign::zero\)) return -s;", r"\1 return s;", [KERNEL, VERIFY]),
    ("drifts count where times differ", "perturbed::compare", r"if \(s != sign::zero\) return s; (if constexpr \(requires \{ k_\.compare_drift)", r"\1", [PLANE]),
    ("roots of one class are taken for independent", "sign_of_form", r"if \(level == 0 && is_zero\(terms, size\)\) return sign::zero;",
     "if (level == 3) return sign::positive;", [ROOTS]),
    ("the anchors' differences are forgotten", "d_from", r"if \(i == origin\) return sum;", "return sum;", [PLANE]),

    # ---- the event loop of polygons
    ("plane: edges without length stay", "collapse_zero_length_edges|has_length_zero", r"(\|\| !|&& )k_\.touches\(h, t, line, moment_\)", r"\1false", [PLANE]),
    ("plane: edges without length are not looked for", "watch_collapse|schedule::watch", r"(if \(|return )(when\.first <= )(when_|present_)\.last", r"\1\2-1.0", [PLANE]),
    ("plane: arcs pass through nodes unseen", "collapse_zero_length_edges|trace_interior_node",
     r"\w+\.interior_nodes\.push_back\(\{[^;]*, m\.node\}\);", "{}", [PLANE]),
    ("plane: changed edges are not looked at", "watch_contacts|contact_search::watch", r"(look_from_edge\(changed\[i\]\)|search_from_edge\(e\)|boxes_\.vertices_near_edge\(.*?\}\));", "", [PLANE]),
    ("plane: new reflex vertices are not looked at", "watch_contacts|contact_search::watch", r"(look_from_vertex\(vertices\[i\]\)|search_from_vertex\(v\));", "", [PLANE]),
    ("plane: merged edges are not looked at", "replace", r"(touched\[count\+\+\] = merged\[r\]|change\.edges\.push_back\(merged\));", "", [PLANE]),
    ("plane: windows without contacts", "open_window|are_contacts_possible", r"(contacts_ =|return) std::ranges::any_of\(", r"\1 !std::ranges::any_of(", [PLANE]),
    ("plane: other edges on the line are not seen", "is_other", r"return l != [\w.]+\[r\] && ", "return false && ", [PLANE]),
    ("plane: an old candidate counts as a new one", "plane::propagation::run|schedule::take", r"if \(!is_current\(c\) \|\| (lines_of\(c\) != triple\(k_\.planes\(m\)\) \|\|)",
     r"if (!front_.edges[c.edge].alive || \1", [PLANE]),
    ("plane: slices begin too late", "event_queue::advance", r"\(heap_\.empty\(\) \|\| heap_\.front\(\)\.when\.last >= next_begin\(\)\)", "heap_.empty()", [PLANE]),
    ("plane: renumbered edges are alone on their line", "renumber", r"if \(e\.next >= 0\) e\.next = now\.edges\[e\.next\];", "e.next = -1;", [PLANE]),
    ("plane: renumbering forgets what was expected", "renumber", r"return c\.edge >= 0 && \(c\.arc < 0 \|\| c\.vertex >= 0\) && is_current\(c\);",
     "return false;", [PLANE]),
    ("plane: a box in two parts is put into one", "each_part", r"j <= to\[1\]; \+\+j", "j <= from[1]; ++j", [PLANE]),
    ("plane: the side of a convex tail is turned round", "plane::contains|contains_point", r"== (front_?\.vertices\[[^;]*\.tail\]\.reflex\) return false;)", r"!= \1", [PLANE]),
    ("plane: all are taken for neighbours", "are_neighbours", r"return front_\.edges\[e\]\.tail == front_\.edges\[vertex\.out\]\.head \|\|", "return front_.edges[e].alive ||", [PLANE]),
    ("plane: what is infinitely late happens", "open_window|queue_until", r" && collapse_\[e\]\.first < infinity &&", " &&", [OUTSIDE]),

    # ---- polygons: input, and the certificate of what never ends
    ("plane: the outside is linked as the inside", "polygon_builder::build", r"if \((touching && )?outside_\) (touching->)?link_sectors\(true\);", "", [OUTSIDE]),
    ("plane: rings that are left may cross", "find_crossing", r"if \(e < f && touch\(e, f\)\) return e;", "", [OUTSIDE]),
    ("plane: rings that are left may lie in one another", "find_crossing", r"if \(winding != 0\) return e;", "", [OUTSIDE]),
]]
