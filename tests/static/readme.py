#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that the C++ programs of the README are those which the tests compile and run, line for line.

    tests/static/readme.py ROOT               prints what differs
    tests/static/readme.py ROOT --self-test   changes one letter of the README; that must be found
"""
import pathlib
import re
import sys

PROGRAMS = {"tests/door_polygon_example.cpp": 15, "tests/door_polyhedron_example.cpp": 10}  # and the most lines of each


def program_of(text):
    """Returns a source without its leading comments."""
    return re.sub(r"\A(//[^\n]*\n)*", "", text)


def differences(root, readme):
    """Yields what is wrong with the text of a README."""
    blocks = re.findall(r"```cpp\n(.*?)```", readme, re.S)
    programs = {name: program_of((root / name).read_text()) for name in PROGRAMS}
    for name, text in programs.items():
        if text not in blocks:
            yield f"the README does not show {name} as it is"
        if len(text.splitlines()) > PROGRAMS[name]:
            yield f"{name} has more than {PROGRAMS[name]} lines"
    if len(blocks) != len(programs):
        yield f"the README has {len(blocks)} C++ programs, and {len(programs)} are compiled by the tests"


def main():
    root = pathlib.Path(sys.argv[1])
    readme = (root / "README.md").read_text()
    if "--self-test" in sys.argv:
        broken = readme.replace("skeletonize(plan)", "skeletonise(plan)", 1)
        missed = broken == readme or not list(differences(root, broken))
        print("a changed letter is " + ("NOT " if missed else "") + "found")
        return int(missed)
    found = list(differences(root, readme))
    print("\n".join(found) or "the README's programs are those of the tests")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
