#!/usr/bin/env python3
"""Draws a solid, its straight skeleton and its offsets, side by side, as one SVG.

From the root of a built checkout, this writes the picture of the README:

    python3 docs/draw_skeleton.py

The script reads the OBJ and runs `build/osteon skeleton` on it (or reads that command's output, with --json). It needs nothing but the
standard library, and the same input always gives the same bytes.

Left: the edges of the solid; the hidden parts are dashed. Edges between coplanar facets are left out.
Middle: the exact (contracted) skeleton. Of its sheets, those that do not reach the surface (orange) and those that start at a reflex edge
(violet) are drawn; an arc behind one of them is paler. Every line is clipped against what is in front of it.
Right: the solid at some later times. A vertex at time t lies on a raw arc, at linear interpolation between its nodes; an edge is a raw sheet cut
at t; a facet is bounded by the cuts of the sheets of its plane.
"""

import argparse
import json
import math
import subprocess
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

INK, MUTED, RULE = "#1b2433", "#5b6678", "#d5dae2"
EDGE, HIDDEN = "#1b2433", "#8b96a8"
ARC = "#d01257"
SHEETS = {"inner": ("#f59a23", 0.45), "reflex": ("#7a5cf0", 0.22)}
FACE_DARK, FACE_LIGHT = (176, 190, 210), (244, 247, 251)
OFFSETS = [(120, 175, 240), (60, 135, 225), (28, 92, 190)]


# ---- vectors ----------------------------------------------------------------------------------------------------------------------------------

def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def lerp(a, b, s):
    return tuple(x + (y - x) * s for x, y in zip(a, b))


def newell(loop):
    n = (0.0, 0.0, 0.0)
    for a, b in zip(loop, loop[1:] + loop[:1]):
        c = cross(a, b)
        n = (n[0] + c[0], n[1] + c[1], n[2] + c[2])
    return n


# ---- solids -----------------------------------------------------------------------------------------------------------------------------------

class Body:
    """Faces as (outward unit normal, edges), an edge being two points."""

    def __init__(self, faces, size):
        self.faces = faces
        self.key = lambda p: tuple(round(x / size * 1e6) for x in p)
        found = {}
        for _, edges in faces:
            for a, b in edges:
                ends = tuple(sorted((self.key(a), self.key(b))))
                if ends[0] != ends[1]:
                    found.setdefault(ends, tuple(sorted((a, b))))
        self.edges = [found[k] for k in sorted(found)]

    def loops(self, edges):
        """Chains the edges of a face into closed loops."""
        at = defaultdict(list)
        for i, (a, b) in enumerate(edges):
            at[self.key(a)].append((i, b))
            at[self.key(b)].append((i, a))
        used, result = set(), []
        for i, (a, b) in enumerate(edges):
            if i in used:
                continue
            used.add(i)
            loop = [a, b]
            while True:
                step = next(((j, p) for j, p in at[self.key(loop[-1])] if j not in used), None)
                if step is None:
                    break
                used.add(step[0])
                loop.append(step[1])
            if self.key(loop[0]) == self.key(loop[-1]):
                loop.pop()
            if len(loop) > 2:
                result.append(loop)
        return result


def read_obj(path):
    points, facets = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(float(w) for w in words[1:4]))
        elif words[:1] == ["f"]:
            facets.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return points, facets


def solid_body(points, facets, size):
    """The solid of an OBJ, its coplanar neighbours joined."""
    normal = [unit(newell([points[v] for v in f])) for f in facets]
    side, parent = {}, list(range(len(facets)))
    for i, f in enumerate(facets):
        for a, b in zip(f, f[1:] + f[:1]):
            side[a, b] = i

    def root(i):
        while parent[i] != i:
            i = parent[i]
        return i

    for (a, b), i in side.items():
        j = side[b, a]
        if dot(normal[i], normal[j]) > 1 - 1e-9:
            low, high = sorted((root(i), root(j)))
            parent[high] = low
    border = defaultdict(list)
    around = defaultdict(set)
    for (a, b), i in side.items():
        if root(i) != root(side[b, a]):
            border[root(i)].append((a, b))
            around[a].add(b)
            around[b].add(a)
    # A vertex in the middle of a straight edge is no corner: follow the edge past it.
    smooth = {v for v, n in around.items() if len(n) == 2}
    faces = []
    for i in sorted(border):
        follow = dict(border[i])
        edges = []
        for a, b in border[i]:
            if a not in smooth:
                while b in smooth:
                    b = follow[b]
                edges.append((points[a], points[b]))
        faces.append((normal[i], edges))
    return Body(faces, size)


def offset_body(data, time, size):
    """The solid at a time, from the raw skeleton."""
    nodes, arcs = data["nodes"], data["arcs"]
    normals = [unit([float(x) for x in plane["n"]]) for plane in data["planes"]]
    faces = defaultdict(list)
    for sheet in data["sheets"]:
        cuts = []
        for i in sheet["arcs"]:
            a, b = nodes[arcs[i]["source"]], nodes[arcs[i]["target"]]
            if a["time"] <= time < b["time"]:
                cuts.append(lerp(a["point"], b["point"], (time - a["time"]) / (b["time"] - a["time"])))
        line = cross(*(normals[f] for f in sheet["facets"]))
        cuts.sort(key=lambda p: dot(line, p))
        for edge in zip(cuts[::2], cuts[1::2]):
            for f in sheet["facets"]:
                faces[f].append(edge)
    return Body([(normals[f], faces[f]) for f in sorted(faces)], size)


def sheet_patches(data, body):
    """The contracted sheets as (kind, normal, loops); the kind is 'inner', 'reflex' or 'outer'. A sheet is the union of its raw parts."""
    nodes, arcs = data["nodes"], data["arcs"]
    place = [tuple(n["point"]) for n in nodes]
    result = []
    for sheet in data["contracted"]["sheets"]:
        n, m = (unit([float(x) for x in data["planes"][f]["n"]]) for f in sheet["facets"])
        line = cross(n, m)
        kind, edges, loops = "inner", [], []
        for raw in sheet["raw"]:
            edges = [(place[arcs[i]["source"]], place[arcs[i]["target"]]) for i in data["sheets"][raw]["arcs"]]
            edges = [(a, b) for a, b in edges if body.key(a) != body.key(b)]
            starts = [arcs[i]["source"] for i in data["sheets"][raw]["arcs"] if nodes[arcs[i]["source"]]["time"] == 0]
            starts.sort(key=lambda v: dot(line, place[v]))
            for a, b in zip(starts[::2], starts[1::2]):  # closed by edges of the solid
                edges.append((place[a], place[b]))
                kind = "reflex" if is_reflex(body, place[a], place[b]) else "outer"
            loops += body.loops(edges)
        if loops:
            normal = unit(newell(loops[0]))
            loops = [loop if dot(newell(loop), normal) > 0 else loop[::-1] for loop in loops]
            result.append((kind, normal, loops))
    return result


def is_reflex(body, a, b):
    """Whether the solid is concave along the edge ab: one face then has points above the plane of the other, next to the edge."""
    ends = {body.key(a), body.key(b)}
    sides = [(n, edges) for n, edges in body.faces if any({body.key(p), body.key(q)} == ends for p, q in edges)]
    if len(sides) != 2:
        return False
    (n, edges), (m, _) = sides
    inward = unit(cross(n, sub(b, a)))  # one of the two directions in the face; choose the one that points into it
    frame = lambda p: (dot(unit(sub(b, a)), sub(p, a)), dot(inward, sub(p, a)))
    middle, reach = lerp(a, b, 0.5), 1e-3 * math.dist(a, b)
    probe = tuple(x + reach * d for x, d in zip(middle, inward))
    flat = [(frame(p), frame(q)) for p, q in edges]
    if not covers(flat, frame(probe)):
        inward = tuple(-x for x in inward)
    return dot(m, inward) > 1e-9


# ---- what hides what --------------------------------------------------------------------------------------------------------------------------

def covers(edges, p):
    """Even-odd test in the plane."""
    inside = False
    for (ax, ay), (bx, by) in edges:
        if (ay > p[1]) != (by > p[1]) and p[0] < ax + (p[1] - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


class View:
    """Orthographic: maps to (right, up, towards the viewer)."""

    def __init__(self, azimuth, elevation):
        a, e = math.radians(azimuth), math.radians(elevation)
        self.front = (math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e))
        self.right = (-math.sin(a), math.cos(a), 0.0)
        self.up = cross(self.front, self.right)

    def __call__(self, p):
        return (dot(self.right, p), dot(self.up, p), dot(self.front, p))

    def pieces(self, a, b, screens):
        """Splits a segment where the number of screens in front of it changes: (from, to, number)."""
        a, b = self(a), self(b)
        d = sub(b, a)
        size = max(abs(x) for x in d) or 1.0
        stops = {0.0, 1.0}
        for edges, normal, level in screens:
            for p, q in edges:
                ex, ey = q[0] - p[0], q[1] - p[1]
                den = d[0] * ey - d[1] * ex
                if abs(den) > 1e-12:
                    wx, wy = p[0] - a[0], p[1] - a[1]
                    s, r = (wx * ey - wy * ex) / den, (wx * d[1] - wy * d[0]) / den
                    if 0 < s < 1 and -1e-9 <= r <= 1 + 1e-9:
                        stops.add(round(s, 9))
            den = dot(normal, d)
            if abs(den) > 1e-12:
                s = (level - dot(normal, a)) / den
                if 0 < s < 1:
                    stops.add(round(s, 9))
        stops = sorted(stops)
        result = []
        for s, e in zip(stops, stops[1:]):
            if e - s < 1e-6:
                continue
            m = lerp(a, b, (s + e) / 2)
            count = 0
            for edges, normal, level in screens:
                depth = (level - normal[0] * m[0] - normal[1] * m[1]) / normal[2]
                if depth > m[2] + 1e-6 * size and covers(edges, m[:2]):
                    count += 1
            if result and result[-1][2] == count:
                result[-1][1] = e
            else:
                result.append([s, e, count])
        return [(lerp(a, b, s), lerp(a, b, e), count) for s, e, count in result]

    def screen(self, edges, normal):
        """A flat patch ready for pieces(), or None if it is seen edge on."""
        n = self(normal)
        flat = [(self(a), self(b)) for a, b in edges]
        if abs(n[2]) < 1e-6:
            return None
        return ([(p[:2], q[:2]) for p, q in flat], n, dot(n, flat[0][0]))

    def screens(self, body):
        return [s for s in (self.screen(edges, n) for n, edges in body.faces if dot(n, self.front) > 1e-6) if s]


# ---- the picture ------------------------------------------------------------------------------------------------------------------------------

class Panel:
    """One panel: collects SVG elements; group(...) shares a style."""

    def __init__(self, view, scale, origin):
        self.view, self.scale, self.origin, self.out = view, scale, origin, []

    def at(self, flat):
        x, y = self.origin[0] + self.scale * flat[0], self.origin[1] - self.scale * flat[1]
        return f"{x:.1f} {y:.1f}".replace("-0.0", "0.0").replace(".0 ", " ").removesuffix(".0")

    def path(self, loops):
        return "".join("M" + "L".join(self.at(self.view(p)) for p in loop) + "Z" for loop in loops)

    def group(self, style, elements):
        if elements:
            self.out += [f"<g {style}>", *elements, "</g>"]

    def lines(self, style, segments):
        if segments:
            self.out.append(f'<path {style} d="' + "".join(f"M{self.at(a)}L{self.at(b)}" for a, b in segments) + '"/>')


def shade(normal, view, dark, light):
    sun = unit(tuple(0.55 * f + 0.75 * u - 0.45 * r for f, u, r in zip(view.front, view.up, view.right)))
    s = max(0.0, min(1.0, 0.5 + 0.5 * dot(normal, sun))) ** 1.3
    return "#" + "".join(f"{round(x):02x}" for x in lerp(dark, light, s))


def split(view, segments, screens):
    seen, hidden = [], []
    for a, b in segments:
        for p, q, count in view.pieces(a, b, screens):
            (hidden if count else seen).append((p, q))
    return seen, hidden


def in_order(view, faces):
    """Front faces of a body, the far ones first (good for the pictures here; the edges are clipped exactly in any case)."""
    front = [f for f in faces if dot(f[0], view.front) > 1e-6]
    depth = lambda f: sum(dot(view.front, p) + dot(view.front, q) for p, q in f[1]) / len(f[1])
    return sorted(front, key=depth)


def crossing(near, far, reach):
    """The piece of `near`, of the given reach, where it passes in front of `far`: none or one."""
    (a, b), (p, q) = near, far
    d, e, w = sub(b, a), sub(q, p), sub(p, a)
    den, length, other = d[0] * e[1] - d[1] * e[0], math.hypot(*d[:2]), math.hypot(*e[:2])
    if abs(den) < 0.15 * length * other or length == 0 or other == 0:
        return []
    s, r = (w[0] * e[1] - w[1] * e[0]) / den, (w[0] * d[1] - w[1] * d[0]) / den
    room, slack = reach / length, reach / other
    if not (room < s < 1 - room and slack < r < 1 - slack) or lerp(a, b, s)[2] <= lerp(p, q, r)[2]:
        return []
    return [(lerp(a, b, s - room), lerp(a, b, s + room))]


def draw_solid(panel, body):
    view = panel.view
    seen, hidden = split(view, body.edges, view.screens(body))
    for normal, edges in in_order(view, body.faces):
        panel.out.append(f'<path fill="{shade(normal, view, FACE_DARK, FACE_LIGHT)}" fill-rule="evenodd" d="{panel.path(body.loops(edges))}"/>')
    panel.lines(f'stroke="{HIDDEN}" stroke-width="1.1" stroke-dasharray="4 4"', hidden)
    panel.lines(f'stroke="{EDGE}" stroke-width="2.2"', seen)


def draw_skeleton(panel, body, data):
    view, nodes, parts = panel.view, data["nodes"], data["contracted"]
    seen, hidden = split(view, body.edges, view.screens(body))
    panel.lines(f'stroke="{HIDDEN}" stroke-width="1.1" stroke-dasharray="4 4"', hidden)
    sheets = [s for s in sheet_patches(data, body) if s[0] != "outer"]
    middle = lambda loop: sum(dot(view.front, p) for p in loop) / len(loop)
    for kind, _, loops in sorted(sheets, key=lambda s: middle([p for loop in s[2] for p in loop])):
        colour, opacity = SHEETS[kind]
        panel.out.append(f'<path fill="{colour}" fill-opacity="{opacity}" d="{panel.path(loops)}"/>')
    screens = [view.screen([e for loop in loops for e in zip(loop, loop[1:] + loop[:1])], n) for _, n, loops in sheets]
    place = [tuple(nodes[n["raw"][0]]["point"]) for n in parts["nodes"]]
    start = [nodes[n["raw"][0]]["time"] == 0 for n in parts["nodes"]]
    segments = [(place[a["source"]], place[a["target"]]) for a in parts["arcs"]]
    front, back = split(view, sorted(segments, key=middle), [s for s in screens if s])
    panel.lines(f'stroke="{ARC}" stroke-opacity=".6" stroke-width="1.7"', back)
    panel.lines(f'stroke="{ARC}" stroke-width="2.6"', front)
    bridges = [bridge for near in front for far in front + back for bridge in crossing(near, far, 4 / panel.scale)]
    panel.lines('stroke="#fff" stroke-width="5.8" stroke-linecap="butt"', bridges)
    panel.lines(f'stroke="{ARC}" stroke-width="2.6" stroke-linecap="butt"', [(lerp(*b, -0.1), lerp(*b, 1.1)) for b in bridges])
    panel.group(f'fill="{ARC}"', [dot_at(panel, view(p), 3.4) for p, s in zip(place, start) if not s])
    panel.lines(f'stroke="{EDGE}" stroke-width="1.4"', seen)
    return len(sheets)


def dot_at(panel, flat, radius):
    x, y = panel.at(flat).split()
    return f'<circle cx="{x}" cy="{y}" r="{radius}"/>'


def draw_offsets(panel, body, data, times, size):
    """Nested shells of glass: the last one is opaque, the earlier ones are laid over it."""
    view = panel.view
    seen, hidden = split(view, body.edges, view.screens(body))
    panel.lines(f'stroke="{HIDDEN}" stroke-width="1.1" stroke-dasharray="4 4"', hidden)
    for i, time in reversed(list(enumerate(times))):
        colour, core = OFFSETS[i % len(OFFSETS)], i == len(times) - 1
        shell = offset_body(data, time, size)
        lines, _ = split(view, shell.edges, view.screens(shell))
        panel.out.append('<g>' if core else '<g opacity=".22">')
        for normal, edges in in_order(view, shell.faces):
            fill = shade(normal, view, lerp(colour, (0, 0, 0), 0.05), lerp(colour, (255, 255, 255), 0.7))
            panel.out.append(f'<path fill="{fill}" fill-rule="evenodd" d="{panel.path(shell.loops(edges))}"/>')
        panel.out.append("</g>")
        dark = "#" + "".join(f"{round(x):02x}" for x in lerp(colour, (0, 0, 0), 0.25))
        panel.lines(f'stroke="{dark}" stroke-width="{1.8 if core else 1.1}" stroke-opacity="{1 if core else .75}"', lines)
    panel.lines(f'stroke="{EDGE}" stroke-width="1.4"', seen)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0],
                                     epilog="Without arguments: writes docs/skeleton.svg, the picture of the README.")
    parser.add_argument("model", nargs="?", type=Path, default=ROOT / "tests/models/house-t.obj", help="OBJ file (default: tests/models/house-t.obj)")
    parser.add_argument("--json", type=Path, help="output of 'osteon skeleton MODEL'; without it the program is run")
    parser.add_argument("--osteon", type=Path, default=ROOT / "build/osteon", help="the program (default: build/osteon)")
    parser.add_argument("--azimuth", type=float, default=56, help="of the viewer, in degrees from x towards y (default: %(default)s)")
    parser.add_argument("--elevation", type=float, default=24, help="of the viewer, in degrees (default: %(default)s)")
    parser.add_argument("--times", type=float, nargs="+", default=[0.25, 0.5, 0.75],
                        help="of the offsets, as parts of the last event's time (default: 0.25 0.5 0.75)")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs/skeleton.svg", help="SVG file (default: docs/skeleton.svg)")
    args = parser.parse_args()

    points, facets = read_obj(args.model)
    if args.json:
        data = json.loads(args.json.read_text())
    else:
        data = json.loads(subprocess.run([args.osteon, "skeleton", args.model], check=True, stdout=subprocess.PIPE).stdout)
    size = max(max(c) - min(c) for c in zip(*points))
    body = solid_body(points, facets, size)
    last = max(n["time"] for n in data["nodes"])
    times = sorted(t * last for t in args.times)

    view = View(args.azimuth, args.elevation)
    flat = [view(p) for p in points]
    left, right = min(p[0] for p in flat), max(p[0] for p in flat)
    low, high = min(p[1] for p in flat), max(p[1] for p in flat)
    pitch, margin, gap = 360, 30, 44
    scale = (pitch - gap) / (right - left)
    tall = scale * (high - low)
    top, width = 34, 3 * pitch + 2 * margin - gap
    height = round(top + tall + 74)

    shown = [f"{t:.3g}" for t in times]
    stamps = " and ".join([", ".join(shown[:-1]), shown[-1]] if len(shown) > 1 else shown)
    panels = []
    for i in range(3):
        panels.append(Panel(view, scale, (margin + i * pitch - scale * left, top + scale * high)))
    draw_solid(panels[0], body)
    drawn = draw_skeleton(panels[1], body, data)
    draw_offsets(panels[2], body, data, times, size)
    captions = [("Solid", f"{len(body.faces)} facets, {len(body.edges)} edges"),
                ("Straight skeleton", f"{len(data['contracted']['arcs'])} arcs; {drawn} of {len(data['contracted']['sheets'])} sheets shown"),
                ("Offsets", f"at times {stamps}; gone at {last:.3g}")]

    title = f"{args.model.stem}: the solid, its straight skeleton and its offsets"
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
             f' role="img" aria-label="{title}">',
             f"<title>{title}</title>",
             f'<rect x=".5" y=".5" width="{width - 1}" height="{height - 1}" rx="16" fill="#fff" stroke="{RULE}"/>',
             '<g stroke-linecap="round" stroke-linejoin="round">']
    for panel in panels:
        lines += panel.out
    lines.append("</g>")
    lines.append('<g font-family="system-ui,-apple-system,Segoe UI,Helvetica,Arial,sans-serif" text-anchor="middle">')
    for i, (head, text) in enumerate(captions):
        x = margin + i * pitch + (pitch - gap) / 2
        lines.append(f'<text x="{x:g}" y="{height - 40}" font-size="20" font-weight="600" fill="{INK}">{head}</text>')
        lines.append(f'<text x="{x:g}" y="{height - 17}" font-size="15" fill="{MUTED}">{text}</text>')
    lines += ["</g>", "</svg>"]
    args.output.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
