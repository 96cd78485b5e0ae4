#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that no class is above 350 lines and no function above 70.

    tests/static/sizes.py ROOT               checks the repository at ROOT; prints every class and function that is too long
    tests/static/sizes.py ROOT --longest     prints the twenty longest of each kind instead
    tests/static/sizes.py ROOT --self-test   plants a class and a function that are too long; both must be found

Lines count from that of the name to that of the closing brace. EXCEPTIONS names at most three; docs/architecture.md argues for each in a list under a
heading with the word "Exceptions", an item beginning with the name as `osteon::name`. The two lists must agree.
"""
import argparse
import pathlib
import re
import sys
import tempfile

import cpp_source

HOMES = ("include", "kernels", "src", "apps", "examples")
LIMITS = {"class": 350, "function": 70}
EXCEPTIONS = ()
MOST_EXCEPTIONS = 3
PAGE = "docs/architecture.md"


def measured(root):
    """Yields (kind, lines, qualified name, file, line) of every class and function that has a body."""
    for home in HOMES:
        for path in sorted((root / home).rglob("*.[ch]pp")):
            text = path.read_text()
            numbers = cpp_source.Lines(text)
            for declaration in cpp_source.declarations(text):
                kind = {"friend": "function", "specialisation": "class"}.get(declaration.kind, declaration.kind)
                if kind in LIMITS and declaration.defined:
                    first = numbers.of(declaration.start)
                    if declaration.template:  # the template head is no part of it
                        core, _ = cpp_source.core_of(cpp_source.code_of(text)[declaration.start:declaration.head_end])
                        first = numbers.of(declaration.head_end - len(core))
                    yield kind, numbers.of(declaration.end - 1) - first + 1, declaration.qualified(), path.relative_to(root), first


def argued(root):
    """Returns the names that the page of the architecture gives as exceptions."""
    page = root / PAGE
    if not page.exists():
        return []
    found = re.search(r"^#+ .*\bexceptions\b.*?$(.*?)(?=^#|\Z)", page.read_text(), re.MULTILINE | re.DOTALL | re.IGNORECASE)
    return re.findall(r"^\s*[*-] `([\w:~]+)`", found.group(1), re.MULTILINE) if found else []


def breaches(root, exceptions=EXCEPTIONS):
    """Yields a message for each breach of the rules in a repository."""
    if len(exceptions) > MOST_EXCEPTIONS:
        yield f"{len(exceptions)} exceptions; {MOST_EXCEPTIONS} are the most"
    if set(exceptions) != set(argued(root)):
        yield f"{PAGE} argues for {sorted(argued(root))}, this script excepts {sorted(exceptions)}"
    too_long = set()
    for kind, lines, name, file, line in measured(root):
        if lines > LIMITS[kind]:
            too_long.add(name)
            if name not in exceptions:
                yield f"{file}:{line}: {kind} {name} has {lines} lines, more than {LIMITS[kind]}"
    for name in exceptions:
        if name not in too_long:
            yield f"{name} is excepted and is not too long"


def self_test():
    """Plants what is too long; returns the number of mistakes."""
    function = "int f() {\n" + "  g();\n" * (LIMITS["function"] - 1) + "}\n"
    member = "class s {\n  template <class T>\n  " + function.replace("g();", "g();") + "};\n"
    long_class = "class s {\n" + "  int f();\n" * (LIMITS["class"] - 1) + "};\n"
    cases = [("a long function", function, (), "", 1), ("a long member", member, (), "", 1), ("a long class", long_class, (), "", 1),
             ("short enough", function.replace("  g();\n", "", 1) + long_class.replace("  int f();\n", "", 1), (), "", 0),
             ("an exception", function, ("osteon::f",), "## Exceptions of size\n\n* `osteon::f` is long.\n\n## Next\n\n* `other` thing\n", 0),
             ("an exception without a reason", function, ("osteon::f",), "", 1),
             ("a reason without an exception", "int f();", (), "## Exceptions\n\n* `osteon::f`: no.\n", 1),
             ("an exception that is none", "int f() { return 1; }", ("osteon::f",), "## Exceptions\n\n* `osteon::f`: no.\n", 1),
             ("four exceptions", "", ("a", "b", "c", "d"), "", 6)]
    missed = 0
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch)
        (root / "include").mkdir()
        (root / "docs").mkdir()
        for name, code, exceptions, page, count in cases:
            (root / "include/planted.hpp").write_text("namespace osteon {\n" + code + "}\n")
            (root / PAGE).write_text(page)
            found = list(breaches(root, exceptions))
            if len(found) != count:
                missed += 1
                print(f"{name}: {found}")
    print(f"{len(cases)} planted cases, {missed} taken wrongly")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--longest", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.root / "include/osteon").is_dir():
        parser.error(f"{arguments.root} is not the repository")
    if arguments.self_test:
        return 1 if self_test() else 0
    if arguments.longest:
        for kind in LIMITS:
            for _, lines, name, file, line in sorted((m for m in measured(arguments.root) if m[0] == kind), key=lambda m: -m[1])[:20]:
                print(f"{lines:5} {kind} {name} ({file}:{line})")
        return 0
    found = list(breaches(arguments.root))
    for text in found:
        print(text)
    print(f"{len(found)} breaches of the rules for sizes")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
