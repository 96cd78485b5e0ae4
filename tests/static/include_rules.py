#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks who may include what: each folder may know the folders that the table names, and nothing else.

    tests/static/include_rules.py ROOT               checks the repository at ROOT; prints every breach with file and line
    tests/static/include_rules.py ROOT --self-test   plants one forbidden include of each kind into a copy; each must be found

Only the oracles include CGAL. Every header has a guard, and no headers include each other in a circle.
"""
import argparse
import pathlib
import re
import shutil
import sys
import tempfile

# Where a folder's headers are found, and what its files may include beside the standard library and themselves.
HOMES = {
    "core": "include/osteon/core", "space": "include/osteon/space", "plane": "include/osteon/plane",
    "input": "include/osteon/input", "models": "include/osteon/models",
    "kernel": "kernels/osteon/kernel", "evaluate": "kernels/osteon/evaluate",
    "door": "include/osteon/door",
}
ALLOWED = {
    "core": set(),
    "space": {"core"},
    "plane": {"core"},
    "input": {"core", "space", "plane"},
    "models": {"core", "input"},
    "kernel": {"core", "input/moving_plane.hpp"},
    "evaluate": {"core", "kernel", "space", "plane", "input"},
    "door": {"core/error.hpp", "core/sign.hpp", "space/preference.hpp"},
}
# Libraries of others, by the folder that may name them.
OUTSIDE = {"kernel": ("boost/", "gmp.h"), "evaluate": ("boost/", "gmp.h")}
# The program and the examples use the door and the window alone.
USERS = ("apps", "examples")
ENTRANCES = ("osteon/osteon.hpp", "osteon/inspect.hpp", "osteon/door/")
BEHIND = ("osteon/", "boost/", "gmp")
OURS = ("apps", "bench", "examples", "fuzz", "include", "kernels", "properties", "tests")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_0-9]+$")


def folder_of(header):
    """Returns the folder of the table that a header "osteon/FOLDER/NAME.hpp" lives in, or None."""
    parts = header.split("/")
    return parts[1] if len(parts) == 3 and parts[0] == "osteon" and parts[1] in HOMES else None


def includes_of(path):
    """Yields (line number, kind of quotation, header) for each include of a file."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if found := INCLUDE.match(line):
            yield number, found.group(1), found.group(2)


def fault_of(folder, quotation, header):
    """Returns why a file of a folder may not include a header, or None where it may."""
    if quotation == "<" and (STANDARD.match(header) or header.startswith(OUTSIDE.get(folder, ()))):
        return None
    other = folder_of(header) if quotation == '"' else None
    if other == folder or other in ALLOWED[folder] or header.removeprefix("osteon/") in ALLOWED[folder]:
        return None
    known = ", ".join(sorted(ALLOWED[folder])) or "nothing else"
    return f"{folder} may include the standard library, itself and: {known}"


def circle_from(root):
    """Returns the headers of one circle of includes, or None."""
    files = {f"osteon/{folder}/{path.name}": path for folder, home in HOMES.items() for path in sorted((root / home).glob("*.hpp"))}
    arrows = {name: [header for _, _, header in includes_of(path) if header in files] for name, path in files.items()}
    done, trail = set(), []

    def visit(name):
        if name in trail:
            return trail[trail.index(name):] + [name]
        if name in done:
            return None
        trail.append(name)
        for other in arrows[name]:
            if circle := visit(other):
                return circle
        done.add(trail.pop())
        return None

    return next((circle for name in files if (circle := visit(name))), None)


def breaches(root):
    """Yields a message for each breach of the rules in a repository."""
    for folder, home in HOMES.items():
        for path in sorted((root / home).rglob("*")):
            name = path.relative_to(root)
            if path.is_dir():
                continue
            for number, quotation, header in includes_of(path):
                if fault := fault_of(folder, quotation, header):
                    yield f"{name}:{number}: {header}: {fault}"
            if path.suffix == ".hpp" and "#pragma once" not in path.read_text():
                yield f"{name}:1: a header needs #pragma once"
    for top in USERS:
        for path in sorted((root / top).rglob("*.[ch]pp")):
            for number, _, header in includes_of(path):
                if header.startswith(BEHIND) and not header.startswith(ENTRANCES):
                    yield f"{path.relative_to(root)}:{number}: {header}: {top} may include the door and the window only"
    for home in ("include", "kernels"):
        for path in sorted((root / home).rglob("*.hpp")):
            if len(path.relative_to(root).parts) == 4 and path.relative_to(root).parts[2] not in HOMES:
                yield f"{path.relative_to(root)}: no folder of the table"
    for top in OURS:
        for path in sorted((root / top).rglob("*.[ch]pp")):
            for number, _, header in includes_of(path):
                if header.startswith("CGAL"):
                    yield f"{path.relative_to(root)}:{number}: {header}: only the oracles include CGAL"
    if circle := circle_from(root):
        yield "a circle of includes: " + " -> ".join(circle)


def planted():
    """Yields (folder, include) for each kind of forbidden arrow."""
    for folder in HOMES:
        for other, home in HOMES.items():
            if other != folder and other not in ALLOWED[folder]:
                yield folder, f'"osteon/{other}/planted.hpp"'
        for library in ("<boost/version.hpp>", "<gmp.h>", "<CGAL/version.h>", "<fmt/format.h>"):
            if not library[1:].startswith(OUTSIDE.get(folder, ("?",))):
                yield folder, library
    for top in USERS:
        for header in ('"osteon/core/error.hpp"', '"osteon/input/read_obj.hpp"', "<osteon/kernel/sqrt.hpp>", "<boost/version.hpp>", "<gmpxx.h>"):
            yield top, header


def self_test(root):
    """Plants every forbidden arrow, one at a time; returns the number of those that were not found."""
    missed = 0
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch)
        for home in ("include", "kernels"):
            shutil.copytree(root / home, copy / home)
        count = 0
        for folder, include in planted():
            path = copy / HOMES.get(folder, folder) / "planted_here.hpp"
            path.parent.mkdir(exist_ok=True)
            path.write_text(f"#pragma once\n#include {include}\n")
            found = any("planted_here.hpp:2" in text for text in breaches(copy))
            path.unlink()
            count += 1
            if not found:
                missed += 1
                print(f"not found: {folder} includes {include}")
        for name, other in (("one", "two"), ("two", "one")):
            (copy / HOMES["core"] / f"planted_{name}.hpp").write_text(f'#pragma once\n#include "osteon/core/planted_{other}.hpp"\n')
        if not any("circle" in text for text in breaches(copy)):
            missed += 1
            print("not found: a circle")
    print(f"{count + 1} planted arrows, {missed} not found")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.root / "include/osteon").is_dir():
        parser.error(f"{arguments.root} is not the repository")
    if arguments.self_test:
        return 1 if self_test(arguments.root) else 0
    found = list(breaches(arguments.root))
    for text in found:
        print(text)
    print(f"{len(found)} breaches of the include rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
