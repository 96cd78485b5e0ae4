#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A record of what the program says, which protects a refactoring: hashes of its results in many cases.

  tests/digests.py record                                # build the old program, run and record all cases
  tests/digests.py check --program build/osteon          # run the recorded cases with a program
  tests/digests.py check --program build/osteon --brief  # a fixed part of them, in seconds
  tests/digests.py compare --program build/osteon        # time and memory against the old program, in pairs

A case is what follows the program's name on a command line, and its own name in digests.json. `A && B` runs B
after A. In a file's name the first folder is one of PLACES or CORPUS; `made/KIND-SIZE-SEED` is what `generate
KIND --size SIZE --seed SEED` of the same program has written, and `out/NAME` is a file that the case writes.

Of every case the exit status is recorded and, with status 0 (done) and 1 (refuted), the hash of standard
output and of the files written, byte for byte but for the number in the field `seconds` of a summary.
Messages are free to change. Cases whose files are missing are skipped and counted.

A deliberate change gets an entry in digests_exceptions.json, {"PATTERN OF CASES": "THE REASON"}, with *, ?
and [] as in the shell: "skeleton models/*" are all that start so. When COMMIT has moved to the change and a
new record is made, its entry goes.

The decisions of the program are exact, but some results are doubles: they are those of a machine without
fused multiplication (x86-64) and of one C library's sine and tangent. On another kind of machine `check` ends
with status 77, without a comparison.
"""

import argparse
import collections
import concurrent.futures
import contextlib
import decimal
import fnmatch
import hashlib
import json
import math
import os
import pathlib
import platform
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

COMMIT = "6fa13f5"  # of the old program
ROOT = pathlib.Path(__file__).resolve().parent.parent
RECORD = ROOT / "tests" / "digests.json"
EXCEPTIONS = ROOT / "tests" / "digests_exceptions.json"

# Where the files of cases lie, in this repository and in the corpus; a folder that moves changes here only.
PLACES = {
    "models": "tests/models",
    "regressions": "tests/regressions",
    "bad": "tests/bad_input",
    "polygons": "tests/polygons",
    "bad-polygons": "tests/planar_bad_input",
    "examples": "examples",
}
CORPUS = {"thesis": "thesis", "events": "events", "real": "real"}

# The sizes of generated models, each with every seed; what several sizes or seeds give alike is used once.
SEEDS = (1, 2, 3)
SOLIDS = {
    "box": (3, 10, 1000), "cube": (1, 7, 1000), "prism": (3, 12, 200), "stairs": (2, 5, 60),
    "notched-box": (1, 3, 5), "house-l": (1, 2, 3), "house-t": (1, 2, 3), "house-u": (1, 2, 3),
    "house-x": (1, 2, 3), "towers": (2, 4, 8), "voxels": (3, 6, 10), "tetrahedron": (1, 2, 3),
    "octahedron": (1, 2, 9), "antiprism": (3, 6, 50), "twisted-prism": (3, 5, 40), "cut-cube": (2, 3, 9),
    "stellated-cube": (1, 2, 9), "frame": (1, 2, 3), "held": (2, 5, 40), "pizza-box": (1, 3, 12),
    "crossing-bars": (1, 2, 5), "spiked-plate": (1, 2, 5), "saddle": (1, 2, 3), "star": (3, 5, 16),
    "cone": (5, 8, 60), "spire": (5, 8, 60), "peak": (5, 8, 24), "arms": (3, 4, 10),
}
POLYGONS = {
    "noisy-star": (12, 100, 1000), "noisy-loop": (20, 300, 4000), "comb": (12, 300, 4000),
    "spiral": (12, 300, 4000), "random": (12, 100, 4000), "random-with-holes": (40, 300, 4000),
    "jittered-holes": (2, 8, 30), "hilbert": (16, 300, 4000), "jittered-cells": (20, 300, 4000),
    "rectilinear-hilbert": (16, 300, 4000), "rectilinear": (20, 300, 4000),
    "stretched-cells": (20, 300, 4000), "touching-cells": (20, 300, 4000), "grid-of-holes": (2, 6, 20),
    "staircase": (8, 40, 120), "symmetric": (12, 80, 1000), "regular": (3, 12, 500), "gear": (8, 48, 1000),
}
MANY_POINTS = 500  # a polygon with more has fewer cases
FEW_POINTS = 60  # a polygon with no more has its roof's skeleton computed
MANY_FACETS = 300  # a solid with more has fewer cases
FEW_FACETS = 60  # a solid with no more has several of its skeletons compared
MOST_FACETS = 3000  # real solids with as many are left out
MOST_LISTED = 9  # the greatest degree of vertices whose splits are listed
MOST_BY_VOLUME = 15  # the greatest degree where splits are compared by volume, which takes long
BRIEF_SIZE = 1000  # of generated models in the brief check
BRIEF_PART = 6  # the brief check takes one case of so many

# Usage, choices and refutations that no model needs to be tried with.
SINGLE_CASES = """
generate star --size 2
generate comb --size 7
skeleton models/star.obj --kernel float
skeleton out/missing.obj
skeleton models/star.obj --outside
skeleton models/star.obj --flip
skeleton examples/letter.xy --prefer first
skeleton examples/letter.xy --output out/no/such/folder.json
skeleton - < models/star.obj
skeleton - < examples/letter.xy
skeleton - --summary < polygons/symmetric_cross.wkt
skeleton - --summary < polygons/courtyard.geojson
offset - --by 0.25 --format wkt < examples/streets.xy
roof - --walls < examples/outline.xy
offset examples/outline.xy --by 0
offset examples/outline.xy --by nan
offset examples/outline.xy --by 0.5,1 --format xy
offset examples/outline.xy --by 0.5,1,1.5,2.25 --kernel double
offset examples/outline.xy --by 1 --verify -o out/offset.geojson
roof examples/outline.xy --slope 0
roof examples/outline.xy --edge-angle 2:90
roof examples/outline.xy --edge-angle 1=90 --edge-angle 4=30 --edge-angle 6=75.5 --eaves 2.5
roof examples/outline.xy --angle 90
splits models/star.obj --vertex 99
splits models/star.obj --vertex 1 --spherical --eye 0 0 1
splits models/star.obj --vertex 1 --spherical --eye 0 0 0
splits made/arms-10-1.obj --vertex 3 --count
splits made/arms-4-1.obj --vertex 3 --all
splits made/arms-4-1.obj --vertex 3 --summary
splits made/cone-60-1.obj --vertex 1 --sample 20 --seed 11
ambiguity made/arms-4-1.obj --explore 4 --offset 10 --offset 1000
ambiguity made/arms-4-1.obj --explore 2 --offset nan
skeleton made/cone-150-1.obj
skeleton made/star-40-1.obj
skeleton made/arms-4-1.obj --prefer min-volume
skeleton made/staircase-4000-1.xy
skeleton models/star.obj --output out/s.json && verify models/saddle.obj out/s.json
skeleton examples/star.xy --output out/s.json && verify examples/plus.xy out/s.json
skeleton examples/star.xy --output out/s.json && verify models/saddle.obj out/s.json
verify models/star.obj models/star.obj
verify examples/star.xy examples/star.xy
skeleton made/noisy-loop-100000-1.xy
skeleton made/comb-100000-1.xy --outside
skeleton made/rectilinear-hilbert-100000-1.xy --kernel rational
skeleton made/hilbert-100000-1.xy --summary --verify
skeleton made/touching-cells-50000-1.xy
skeleton made/rectilinear-50000-1.xy
skeleton made/jittered-holes-120-1.xy
skeleton made/grid-of-holes-80-1.xy
skeleton made/random-with-holes-20000-1.xy
offset made/spiral-50000-1.xy --by 0,1,2.5,100 --format wkt
roof made/jittered-cells-50000-1.xy --angle 35 --eaves 2 --walls
""".strip().splitlines()

# What is timed: a case and how often it runs for one measurement.
COMPARED = [
    ("skeleton thesis/14-bunny_small.obj --prefer min-volume --saddle faster --summary", 6),
    ("skeleton thesis/21-venus_267.obj", 6),
    ("skeleton real/mikedh_quadknot.obj --triangulate --summary", 1),
    ("skeleton real/libigl_horse_quad.obj --triangulate --summary", 1),
    ("skeleton real/spot.obj --summary", 1),
    ("skeleton made/star-40-1.obj --summary", 2),
    ("skeleton made/noisy-loop-100000-1.xy --summary", 1),
    ("skeleton made/rectilinear-hilbert-100000-1.xy", 1),
    ("skeleton made/jittered-holes-120-1.xy --outside --summary", 5),
    ("offset made/comb-100000-1.xy --by 1,10,100 --format wkt", 1),
]

Outcome = collections.namedtuple("Outcome", "text seconds")  # what is recorded; None beyond the time limit


# --- Cases and their files ---


def commands_of(case):
    """A case's commands: the words of each, and the word of the file for standard input or None."""
    for command in case.split(" && "):
        arguments, _, given = command.partition(" < ")
        yield arguments.split(), given or None


def made_word(kind, size, seed):
    """The word for a generated model."""
    return f"made/{kind}-{size}-{seed}.{'obj' if kind in SOLIDS else 'xy'}"


def made_words(cases):
    """The generated models that cases use."""
    return sorted({word for case in cases for word in case.split() if word.startswith("made/")})


def making(word):
    """The arguments that generate a model, without the file's."""
    kind, size, seed = pathlib.PurePath(word).stem.rsplit("-", 2)
    return ["generate", kind, "--size", size, "--seed", seed]


class Files:
    """The folders that the words of cases point to; generated models are in one of their own."""

    def __init__(self, corpus, made):
        self.folders = {name: ROOT / path for name, path in PLACES.items()}
        self.folders |= {name: corpus / path for name, path in CORPUS.items()}
        self.folders["made"] = made

    def path(self, word):
        """The path of a word that names a file of these folders, or None."""
        place, slash, name = word.partition("/")
        return self.folders[place] / name if slash and place in self.folders else None

    def listed(self, place, *endings):
        """The files of a folder as words, sorted."""
        names = sorted(path.name for path in self.folders[place].iterdir() if path.suffix in endings)
        return [f"{place}/{name}" for name in names]

    def missing(self, case):
        """Whether a file of a case, which is not generated, is not there."""
        paths = [self.path(word) for word in case.split() if not word.startswith("made/")]
        return any(path is not None and not path.exists() for path in paths)


SECONDS = re.compile(rb'"seconds":[-+.0-9eE]+')


def without_time(text):
    """A JSON object with the number of its field `seconds` set to zero, and every other text as it is."""
    if b'"seconds":' not in text:
        return text
    try:
        summary = json.loads(text)
    except ValueError:
        return text
    return SECONDS.sub(b'"seconds":0', text) if isinstance(summary, dict) and "seconds" in summary else text


class Program:
    """A program that runs cases with these files, several at a time."""

    def __init__(self, path, files, jobs):
        if not os.access(path, os.X_OK):
            sys.exit(f"{path} is no program")
        self.path = str(pathlib.Path(path).resolve())
        self.files = files
        self.jobs = jobs

    def in_parallel(self, function, over):
        """The function's results in order."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(function, over))

    def make(self, words):
        """Generates the models that are not there yet. A refused one stays missing."""
        def one(word):
            if not self.files.path(word).exists():
                command = [self.path, *making(word), "-o", self.files.path(word)]
                subprocess.run(command, stderr=subprocess.DEVNULL, check=False)

        self.in_parallel(one, words)

    def command(self, words, out=None):
        """The command line of words; `out` is the folder of files that are written."""
        def resolved(word):
            return out / word[len("out/"):] if word.startswith("out/") else self.files.path(word) or word

        return [self.path, *(str(resolved(word)) for word in words)]

    def run(self, case, limit=60):
        """The outcome of a case, within so many seconds."""
        begin = time.monotonic()
        try:
            with tempfile.TemporaryDirectory() if " out/" in case else contextlib.nullcontext() as out:
                text = self.told(case, pathlib.Path(out) if out else None, begin + limit)
        except subprocess.TimeoutExpired:
            text = None
        return Outcome(text, time.monotonic() - begin)

    def told(self, case, out, end):
        """What is recorded of a case: the status of its last command that ran and the hash of its results."""
        digest = hashlib.sha256()
        status = 0
        for words, given in commands_of(case):
            with open(self.files.path(given) if given else os.devnull, "rb") as stdin:
                left = max(end - time.monotonic(), 0.001)
                done = subprocess.run(self.command(words, out), stdin=stdin, stdout=subprocess.PIPE,
                                      stderr=subprocess.DEVNULL, timeout=left, check=False)
            digest.update(without_time(done.stdout))
            status = done.returncode
            if status != 0:
                break
        for path in sorted(out.iterdir()) if out else []:
            digest.update(path.name.encode() + b"\n" + path.read_bytes())
        return f"{status} {digest.hexdigest()[:16]}" if status in (0, 1) else str(status)

    def run_all(self, cases, limit):
        """The outcomes of cases by their names. Large models begin, so that none is alone at the end."""
        self.make(made_words(cases))
        ordered = sorted(cases, key=lambda case: -largest(case))
        return dict(zip(ordered, self.in_parallel(lambda case: self.run(case, limit), ordered)))

    def replay(self, case):
        """A line for a shell that repeats a case; what it writes goes to the folders `made` and `out`."""
        program = os.path.relpath(self.path)
        program = program if os.sep in program else f"./{program}"

        def shown(word):
            path = None if word.startswith("made/") else self.files.path(word)
            return os.path.relpath(path) if path else word

        folders = [folder for folder in ("made", "out") if f" {folder}/" in case]
        lines = [shlex.join(["mkdir", "-p", *folders])] if folders else []
        lines += [shlex.join([program, *making(word), "-o", word]) for word in made_words([case])]
        for words, given in commands_of(case):
            line = shlex.join([program, *map(shown, words)])
            lines.append(f"{line} < {shlex.quote(shown(given))}" if given else line)
        return " && ".join(lines)


def largest(case):
    """The greatest size of the generated models of a case; real solids count as large."""
    sizes = [int(size) for size in re.findall(r"\bmade/\S+-(\d+)-\d+\.", case)]
    return max(sizes + [100_000 if " real/" in case else 0])


# --- Which cases there are ---


def facet_count(path):
    """The number of facets of an OBJ file."""
    return sum(line.startswith("f ") for line in path.read_text(errors="replace").splitlines())


def point_count(path):
    """The number of points of a polygon's file, about: lines that start with a number."""
    return len(re.findall(r"^[-+.\d]", path.read_text(), re.MULTILINE))


def degrees(path):
    """The number of facets at each point of an OBJ file, counted from 1; as vertices they may have fewer."""
    count = collections.Counter()
    for line in path.read_text().splitlines():
        if line.startswith("f "):
            count.update({int(corner.split("/")[0]) for corner in line.split()[1:]})
    return count


def split_points(solid, degree, old):
    """Two points of a solid whose splits are looked at: of least and greatest degree above three, if any."""
    def is_vertex(point):
        return old.run(f"splits {solid} --vertex {point} --count").text.startswith("0 ")

    points = [point for point in degree if degree[point] > 3] or [1]
    least = sorted(points, key=lambda point: (degree[point], point))
    greatest = sorted(points, key=lambda point: (-degree[point], point))
    found = [next(filter(is_vertex, order[:10]), None) for order in (least, greatest)]
    return sorted({point for point in found if point is not None})


def splits_cases(solid, degree, old):
    """The cases of `splits` of a solid."""
    for point in split_points(solid, degree, old):
        at = f"splits {solid} --vertex {point}"
        yield at
        yield f"{at} --count"
        yield f"{at} --sample 5 --seed 7"
        yield f"{at} --spherical"
        if degree[point] <= MOST_BY_VOLUME:
            yield f"{at} --spherical --prefer min-volume --eye 1 2 3"
        if degree[point] <= MOST_LISTED:
            yield f"{at} --summary"
            yield f"{at} --all"


def volume_cases(solid, full):
    """The cases of a solid that compare volumes."""
    yield f"skeleton {solid} --prefer min-volume --saddle faster"
    if full:
        yield f"skeleton {solid} --summary --verify --prefer min-volume"
        yield f"skeleton {solid} --prefer max-volume --saddle convex --summary"


def solid_cases(solid, old, full=True):
    """The cases of a solid; `full` asks for more than the main ones."""
    path = old.files.path(solid.split()[0])
    facets, degree = facet_count(path), degrees(path)
    few = facets <= MANY_FACETS
    yield f"skeleton {solid}"
    yield f"skeleton {solid} --kernel rational --summary"
    if max(degree.values()) <= MOST_BY_VOLUME:
        yield from volume_cases(solid, full and few)
    if not few:
        return
    yield f"skeleton {solid} --kernel rational"
    yield f"skeleton {solid} --output out/s.json && verify {solid} out/s.json"
    if not full:
        return
    yield f"skeleton {solid} --summary"
    yield f"skeleton {solid} --kernel double"
    yield f"skeleton {solid} --prefer reflex --saddle slower"
    yield f"skeleton {solid} --prefer first --saddle reflex --kernel rational --summary"
    yield f"ambiguity {solid}"
    if facets <= FEW_FACETS and not solid.startswith("made/"):
        yield f"ambiguity {solid} --explore 2 --seed 5 --offset 0.05 --offset 0.2"
    yield from splits_cases(solid, degree, old)


def is_taken(solid, old):
    """Whether the program computes a solid's skeleton."""
    return old.run(f"skeleton {solid} --summary").text.startswith("0 ")


def file_solid_cases(word, old):
    """The cases of an OBJ file; where it is refused, that it is, and the cases of its triangulation."""
    if is_taken(word, old):
        yield from solid_cases(word, old)
        return
    yield f"skeleton {word}"
    if is_taken(f"{word} --triangulate", old):
        yield from solid_cases(f"{word} --triangulate", old)


def real_solid_cases(word, old):
    """The cases of a real solid that is taken, and none of others."""
    if facet_count(old.files.path(word)) >= MOST_FACETS:
        return
    for solid in (word, f"{word} --triangulate"):
        if is_taken(solid, old):
            yield from solid_cases(solid, old)
            return


def distances(polygon, old):
    """Three distances within a polygon as text: parts of the last event's time, of three digits."""
    command = old.command(["skeleton", polygon])
    document = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True).stdout
    times = [node["time"] for node in json.loads(document)["nodes"]]
    last = max(t for t in times if t is not None and math.isfinite(t))
    return [f"{decimal.Decimal(f'{last * part:.3g}'):f}" for part in (0.07, 0.31, 0.83)]


def main_polygon_cases(polygon, by):
    """The cases of every polygon."""
    yield f"skeleton {polygon}"
    yield f"skeleton {polygon} --outside"
    yield f"skeleton {polygon} --kernel rational"
    yield f"offset {polygon} --by 0,{','.join(by)} --format wkt"
    yield f"offset {polygon} --by {by[1]},{by[2]} --outside"
    yield f"roof {polygon} --angle 40 --edge-angle 2=90 --eaves 3 --walls"


def more_polygon_cases(polygon, by):
    """More cases, which a large polygon can have, too."""
    yield f"skeleton {polygon} --output out/s.json && verify {polygon} out/s.json"
    yield f"skeleton {polygon} --outside --kernel rational"
    yield f"offset {polygon} --by {by[0]} --format xy"
    yield f"roof {polygon}"


def most_polygon_cases(polygon, by):
    """Still more cases, which would take long with a large polygon."""
    yield f"skeleton {polygon} --kernel double"
    yield f"skeleton {polygon} --summary --verify"
    yield f"skeleton {polygon} --outside --output out/s.json && verify {polygon} out/s.json"
    yield f"skeleton {polygon} --outside --summary --verify --kernel rational"
    yield f"offset {polygon} --by {by[2]},{by[0]}"
    yield f"offset {polygon} --by {by[0]} --outside --format xy"
    yield f"offset {polygon} --by {','.join(by)} --outside --format wkt --kernel rational"
    yield f"roof {polygon} --slope 0.7 --triangulate --summary -o out/roof.obj"


def polygon_cases(polygon, old, full=True):
    """The cases of a polygon; `full` asks for more than the main ones."""
    by = distances(polygon, old)
    points = point_count(old.files.path(polygon))
    yield from main_polygon_cases(polygon, by)
    if full:
        yield from more_polygon_cases(polygon, by)
    if full and points <= MANY_POINTS:
        yield from most_polygon_cases(polygon, by)
    if full and points <= FEW_POINTS:
        roof = f"roof {polygon} --angle 50 --walls --triangulate -o out/roof.obj"
        yield f"{roof} && skeleton out/roof.obj --summary"


def different(words, files):
    """Generated models without those that are the same as an earlier one but for their first line."""
    seen = set()
    for word in words:
        text = files.path(word).read_text().partition("\n")[2]
        if text not in seen:
            seen.add(text)
            yield word


def generated_cases(kinds, cases, old):
    """The cases of `generate`, and cases(model, old, full) of all that it makes; `full` is the first seed."""
    for kind, sizes in kinds.items():
        words = [made_word(kind, size, seed) for size in sizes for seed in SEEDS]
        old.make(words)
        for word in words:
            yield " ".join(making(word))
        for word in different(words, old.files):
            yield from cases(word, old, making(word)[-1] == str(SEEDS[0]))


def all_cases(old):
    """The names of all cases; some names depend on what the old program answers."""
    yield from SINGLE_CASES
    files = old.files
    polygon_endings = (".xy", ".wkt", ".geojson", ".obj")
    for word in files.listed("bad", ".obj") + files.listed("bad-polygons", *polygon_endings):
        yield f"skeleton {word} --summary"
    for place in ("models", "regressions", "thesis", "events"):
        for word in files.listed(place, ".obj"):
            yield from file_solid_cases(word, old)
    for word in files.listed("real", ".obj"):
        yield from real_solid_cases(word, old)
    for word in files.listed("examples", *polygon_endings) + files.listed("polygons", *polygon_endings):
        yield from polygon_cases(word, old)
    yield from generated_cases(SOLIDS, solid_cases, old)
    yield from generated_cases(POLYGONS, polygon_cases, old)


# --- The old program ---


def build_old(folder, jobs):
    """Builds the program of COMMIT in a worktree that is removed afterwards."""
    tree, build = folder / "tree", folder / "build"
    git = ["git", "-C", str(ROOT), "worktree"]
    subprocess.run([*git, "add", "--detach", "--force", str(tree), COMMIT], check=True, stdout=sys.stderr)
    try:
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DOSTEON_BUILD_TESTS=OFF", "-DOSTEON_BUILD_EXAMPLES=OFF"]
        subprocess.run(["cmake", "-S", tree, "-B", build, *options], check=True, stdout=sys.stderr)
        subprocess.run(["cmake", "--build", build, "-j", str(jobs)], check=True, stdout=sys.stderr)
        shutil.copy2(build / "osteon", folder / "osteon")
    finally:
        subprocess.run([*git, "remove", "--force", str(tree)], check=False)
        shutil.rmtree(build, ignore_errors=True)


def old_program(options, files):
    """The old program, which is built where it is missing."""
    folder = options.build_directory.resolve()
    path = options.old or folder / "osteon"
    if not options.old and not path.exists():
        print(f"building the program of commit {COMMIT}", file=sys.stderr)
        folder.mkdir(parents=True, exist_ok=True)
        try:
            build_old(folder, options.jobs)
        except subprocess.CalledProcessError as failed:
            reason = f"{failed.cmd[0]} failed; give it with --old"
            sys.exit(f"the program of commit {COMMIT} cannot be built: {reason}")
    return Program(path, files, options.jobs)


# --- The commands ---


def write_record(cases):
    """Writes digests.json, one case a line."""
    lines = [f"{json.dumps(name)}: {json.dumps(text)}" for name, text in sorted(cases.items())]
    head = f'{{"commit": {json.dumps(COMMIT)}, "machine": {json.dumps(platform.machine())}, "cases": {{\n'
    RECORD.write_text(head + ",\n".join(lines) + "\n}}\n")


def record(options, files):
    """Runs all cases with the old program and writes their outcomes."""
    absent = [str(folder) for folder in files.folders.values() if not folder.is_dir()]
    if absent:
        sys.exit("a record needs all models; missing: " + ", ".join(absent))
    old = old_program(options, files)
    begin = time.monotonic()
    outcomes = old.run_all(list(dict.fromkeys(all_cases(old))), options.time_limit)
    done = {case: outcome.text for case, outcome in outcomes.items() if outcome.text is not None}
    write_record(done)
    for case in sorted(outcomes.keys() - done.keys()):
        print(f"not recorded, beyond {options.time_limit:g} s: {case}")
    for case in sorted(done, key=lambda case: -outcomes[case].seconds)[: options.slowest]:
        print(f"{outcomes[case].seconds:7.2f} s  {case}")
    print(f"{len(done)} cases recorded in {time.monotonic() - begin:.0f} s")
    return 0


def is_brief(case):
    """Whether a case belongs to the brief check: one of so many, drawn by its name, without large models."""
    drawn = int(hashlib.sha256(case.encode()).hexdigest()[:8], 16) % BRIEF_PART == 0
    return drawn and largest(case) <= BRIEF_SIZE


def reason_of(case, exceptions):
    """The pattern of the exceptions that a case matches, or None."""
    return next((pattern for pattern in exceptions if fnmatch.fnmatchcase(case, pattern)), None)


def wanted_cases(recorded, options):
    """The names of the recorded cases that are asked for."""
    return [case for case in recorded
            if (is_brief(case) or not options.brief) and fnmatch.fnmatchcase(case, options.only)]


def check(options, files):
    """Runs the recorded cases with a program and tells what differs."""
    document, exceptions = json.loads(RECORD.read_text()), json.loads(EXCEPTIONS.read_text())
    if document["machine"] != platform.machine():
        print(f"recorded on {document['machine']}, this is {platform.machine()}: nothing is compared")
        return 77
    recorded, program = document["cases"], Program(options.program, files, options.jobs)
    begin = time.monotonic()
    wanted = wanted_cases(recorded, options)
    cases = [case for case in wanted if not files.missing(case)]
    outcomes = program.run_all(cases, options.time_limit)
    differing = [case for case in cases if outcomes[case].text != recorded[case]]
    wrong = [case for case in differing if reason_of(case, exceptions) is None]
    for case in wrong:
        now = outcomes[case].text or "no answer in time"
        print(f"differs: {case}\n  recorded {recorded[case]}, now {now}\n  {program.replay(case)}")
    excepted = collections.Counter(reason_of(case, exceptions) for case in differing if case not in wrong)
    for pattern, count in excepted.items():
        print(f"{count} differ on purpose, {pattern}: {exceptions[pattern]}")
    print(f"{len(cases)} cases in {time.monotonic() - begin:.0f} s: {len(cases) - len(differing)} the same, "
          f"{len(wrong)} differ, {excepted.total()} differ on purpose; "
          f"{len(wanted) - len(cases)} skipped without their files")
    return 1 if wrong else 0


Usage = collections.namedtuple("Usage", "wall user memory")

# Runs a command so often, with nothing read or written; prints seconds, seconds of the processor, KB, status.
# A process's greatest memory begins with its parent's, so the parent is an interpreter without libraries.
MEASURING = """
import posix, sys, time
quiet = [(posix.POSIX_SPAWN_OPEN, number, "/dev/null", posix.O_RDWR, 0) for number in (0, 1, 2)]
command, user, memory, worst, begin = sys.argv[2:], 0, 0, 0, time.monotonic()
for _ in range(int(sys.argv[1])):
    child = posix.posix_spawn(command[0], command, posix.environ, file_actions=quiet)
    _, status, usage = posix.wait4(child, 0)
    user, memory, worst = user + usage.ru_utime, max(memory, usage.ru_maxrss), max(worst, status)
print(time.monotonic() - begin, user, memory, worst)
"""


def measure(command, repeat):
    """Seconds of the clock and of the processor for one run, whole process, and the greatest memory in MB."""
    measuring = [sys.executable, "-I", "-S", "-c", MEASURING, str(repeat), *command]
    answer = subprocess.run(measuring, stdout=subprocess.PIPE, check=True).stdout
    wall, user, memory, status = map(float, answer.split())
    if status != 0:
        sys.exit(f"{shlex.join(command)}: status {os.waitstatus_to_exitcode(int(status))}")
    return Usage(wall / repeat, user / repeat, memory / 1024)


def ratios(case, repeat, programs, pairs):
    """The medians over pairs of new by old, and the old program's medians."""
    both = [[measure(p.command(case.split()), repeat) for p in programs] for _ in range(pairs)]
    quotients = [[b / max(a, 1e-9) for a, b in zip(old, new)] for old, new in both]
    return tuple(Usage(*map(statistics.median, zip(*runs))) for runs in (quotients, [old for old, _ in both]))


def compare(options, files):
    """Runs the old and a new program in turn and compares their times and memory."""
    programs = [old_program(options, files), Program(options.program, files, options.jobs)]
    listed = [(case, repeat) for case, repeat in COMPARED if not files.missing(case)]
    programs[0].make(made_words(case for case, _ in listed))
    floor = measure(programs[0].command(["--version"]), 1).memory
    print(f"new by old, medians of {options.pairs} pairs; less memory than {floor:.1f} MB is not seen\n"
          f"{'wall':>6}{'user':>7}{'memory':>8}{'old: user':>12}{'memory':>11}")
    exceeded = 0
    for case, repeat in listed:
        ratio, old = ratios(case, repeat, programs, options.pairs)
        above = ratio.user > options.user_limit or ratio.memory > options.memory_limit
        exceeded += above
        print(f"{ratio.wall:6.3f}{ratio.user:7.3f}{ratio.memory:8.3f}{old.user:10.3f} s{old.memory:8.1f} MB  "
              f"{case}{'  ABOVE THE LIMIT' if above else ''}", flush=True)
    print(f"{exceeded} of {len(listed)} above {options.user_limit} times the user time or "
          f"{options.memory_limit} times the memory; "
          f"{len(COMPARED) - len(listed)} skipped without their files")
    return 1 if exceeded else 0


def parser():
    """The command line."""
    raw = argparse.RawDescriptionHelpFormatter
    result = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    commands = result.add_subparsers(dest="command", required=True)

    def command(function, help_text):
        added = commands.add_parser(function.__name__, help=help_text)
        added.set_defaults(function=function)
        added.add_argument("--jobs", type=int, default=os.cpu_count(), help="how many processes at a time")
        added.add_argument("--corpus", type=pathlib.Path, default=ROOT.parent / "shared" / "corpus",
                           help="the folder of the corpus; only a record needs it")
        return added

    def add_old(to):
        to.add_argument("--build-directory", type=pathlib.Path, default=ROOT / "build" / "digests",
                        help="where the old program is built and kept")
        to.add_argument("--old", help=f"the program of commit {COMMIT}, if it is built already")

    to = command(record, "run all cases with the old program and write digests.json")
    add_old(to)
    to.add_argument("--time-limit", type=float, default=60, help="seconds; slower cases are not recorded")
    to.add_argument("--slowest", type=int, default=0, help="print the slowest cases")
    to = command(check, "compare a program with digests.json")
    to.add_argument("--program", required=True)
    to.add_argument("--brief", action="store_true", help="only a fixed part of the cases")
    to.add_argument("--only", default="*", metavar="PATTERN", help="only the cases that match")
    to.add_argument("--time-limit", type=float, default=600, help="seconds; slower cases differ")
    to = command(compare, "time and memory of a program against the old one")
    add_old(to)
    to.add_argument("--program", required=True)
    to.add_argument("--pairs", type=int, default=5)
    to.add_argument("--user-limit", type=float, default=1.05, help="greatest ratio of user times")
    to.add_argument("--memory-limit", type=float, default=1.02, help="greatest ratio of memory")
    return result


def main():
    """Runs a command with a folder for generated models."""
    options = parser().parse_args()
    with tempfile.TemporaryDirectory() as made:
        return options.function(options, Files(options.corpus, pathlib.Path(made)))


if __name__ == "__main__":
    sys.exit(main())
