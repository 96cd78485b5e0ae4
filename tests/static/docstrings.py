#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every public declaration has a docstring, and how comments look.

    tests/static/docstrings.py ROOT               checks the repository at ROOT; prints every breach with file and line, and how many there are
    tests/static/docstrings.py ROOT --count       only how many, by file and by rule
    tests/static/docstrings.py ROOT --self-test   plants one breach of each kind into a copy; each must be found

Public are, in include and kernels: types, functions, templates, concepts, aliases and constants of namespaces (but not of `detail`), and the public
members of public classes. A docstring is a comment `///` right above, or `///<` behind on the line. One docstring speaks for overloads that follow each
other without an empty line, and for a group: a docstring, `///@{`, declarations, `///@}`. The docstring of a class speaks for its data members,
aliases, constructors, operators, and for begin, end, size and empty, but not for calls. Needing none: what is forward-declared, defaulted or deleted, enumerators, specialisations, and
definitions outside of their class. The docstring of a function that is no constructor begins with a verb in the third person
("Returns whether ..."). Comment lines end at column 100.
"""
import argparse
import collections
import pathlib
import re
import shutil
import sys
import tempfile

import cpp_source

DOCUMENTED = ("include", "kernels")
NARROW = ("include", "kernels", "src", "apps", "examples")
WIDTH = 100
NOT_PUBLIC = {"detail", "internal"}
KINDS = {"class": "class", "enum": "enumeration", "function": "function", "friend": "function", "variable": "variable", "alias": "alias", "concept": "concept"}
# What every container has.
CONTAINER = {"begin", "end", "size", "empty"}
# Words in -s that are no verbs in the third person.
NO_VERBS = {"this", "its", "thus", "always", "as", "less", "plus", "minus", "besides", "afterwards", "perhaps", "unless", "across", "towards", "inwards", "outwards",
            "his", "theirs", "yes", "points", "edges", "lines", "planes", "vertices", "facets", "faces", "nodes", "arcs", "sheets", "cells", "rings", "coordinates",
            "signs", "times", "numbers", "weights", "speeds", "places", "ids", "indices", "events", "sides", "ends", "corners", "polygons", "solids", "holes",
            "others", "triangles", "directions", "options", "bounds", "boxes", "candidates", "windows", "meetings", "values", "lists", "pairs", "kernels",
            "lengths", "normals", "distances", "positions", "parts", "pieces", "names", "bits", "bytes", "digits", "powers", "previous", "various", "across"}

Breach = collections.namedtuple("Breach", "file line rule text")


def docstring_of(lines, first, last):
    """Returns the docstring of a declaration on lines first .. last (from 1), or None."""
    above = []
    number = first - 2
    while number >= 0 and lines[number].lstrip().startswith("///") and not lines[number].lstrip().startswith(("///<", "///@")):
        above.insert(0, lines[number].strip()[3:].strip())
        number -= 1
    if above and not above[0].startswith("\\file"):
        return " ".join(above)
    for line in lines[first - 1:last]:
        if found := re.search(r"///<\s*(.*)", line):
            return found.group(1)
    return None


def begins_with_verb(docstring):
    """Returns whether the first word looks like a verb in the third person."""
    found = re.match(r"([A-Za-z]+) ?(the |an? |all |each |its )?", docstring)
    return bool(found) and found.group(1).lower().endswith("s") and (bool(found.group(2)) or found.group(1).lower() not in NO_VERBS)


def is_public(declaration):
    """Returns whether a declaration is one that needs a docstring."""
    if declaration.kind not in KINDS or declaration.access != "public" or not declaration.name:
        return False
    if any(part in NOT_PUBLIC for name in declaration.scope for part in name.split("::")):
        return False
    return "" not in declaration.scope and "::" not in declaration.name


def is_spoken_for(declaration):
    """Returns whether the docstring of its class speaks for a member."""
    if not declaration.scope or declaration.depth == "namespace":
        return False
    name = declaration.name
    if declaration.kind in ("variable", "alias") or name in CONTAINER:
        return True
    is_constructor = name == declaration.scope[-1].split("::")[-1] or name.startswith("~")
    return is_constructor or (name.startswith("operator") and name.replace(" ", "") != "operator()")


def grouped_lines(lines):
    """Returns the numbers of the lines in groups, from 1."""
    inside, found = False, set()
    for number, line in enumerate(lines, 1):
        if line.strip() == "///@{":
            inside = lines[number - 2].lstrip().startswith("/// ")
        elif line.strip() == "///@}":
            inside = False
        elif inside:
            found.add(number)
    return found


def undocumented(name, text):
    """Yields the breaches of one header."""
    lines = text.splitlines()
    grouped = grouped_lines(lines)
    numbers = cpp_source.Lines(text)
    before = None  # (name, scope, last line) of the declaration before, if it has a docstring
    for declaration in cpp_source.declarations(text):
        if not is_public(declaration):
            continue
        code = text[declaration.start:declaration.end]
        if declaration.kind in ("class", "enum", "friend") and not declaration.defined:
            continue
        if re.search(r"=\s*(default|delete)\s*;\s*$", code):
            continue
        if declaration.depth == "namespace" and declaration.kind in ("function", "variable") and re.match(r"template\s*(<\s*>)?\s*(class|struct|\w+\s+\w+<)", code):
            continue
        first, last = numbers.of(declaration.start), numbers.of(declaration.end - 1)
        # A comment behind the head speaks for a whole class; members' comments do not.
        docstring = docstring_of(lines, first, numbers.of(declaration.head_end) if declaration.kind in ("class", "enum") else last)
        if docstring is None and before and before[:2] == (declaration.name, declaration.scope) and first == before[2] + 1:
            before = (*before[:2], last)
            continue
        before = (declaration.name, declaration.scope, last) if docstring is not None else None
        kind = KINDS[declaration.kind]
        if docstring is None and (first in grouped or is_spoken_for(declaration)):
            continue
        if docstring is None:
            yield Breach(name, first, "no docstring", f"the {kind} {declaration.qualified()} has no docstring")
        elif kind == "function" and not is_spoken_for(declaration) and not begins_with_verb(docstring):
            yield Breach(name, first, "no verb", f"the docstring of {declaration.qualified()} does not begin with a verb: {docstring[:40]}")


def wide_comments(name, text):
    """Yields the comment lines of one source that are too wide."""
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("//") and len(line) > WIDTH:
            yield Breach(name, number, "wide comment", f"a comment line of {len(line)} columns; hint: break it at {WIDTH}")


def breaches(root):
    """Yields all breaches of a repository."""
    for homes, rule in ((DOCUMENTED, undocumented), (NARROW, wide_comments)):
        for home in homes:
            for path in sorted((root / home).rglob("*.[ch]pp")):
                yield from rule(path.relative_to(root), path.read_text())


# What is planted, and how many breaches it makes.
PLANTED = [
    ("a function", "int f();", 1), ("a template", "template <class T>\nint f(T t) { return t; }", 1), ("a class", "struct s {};", 1), ("an alias", "using t = int;", 1),
    ("a constant", "inline constexpr int c = 3;", 1), ("a concept", "template <class T>\nconcept c = requires(T t) { t.f(); };", 1), ("an enumeration", "enum class e { a, b };", 1),
    ("a member function", "/// A class.\nclass s {\n public:\n  int f() const { return 1; }\n};", 1), ("a group without a docstring", "///@{\nint f();\n///@}", 1),
    ("behind a group", "/// Return numbers.\n///@{\nint f();\n///@}\n\nint g();", 1),
    ("a nested class", "/// A class.\nstruct s {\n  struct t {};\n};", 1), ("an operator", "/// A class.\nstruct s {\n  bool operator()(int x) const { return x > 0; }\n};", 1),
    ("a hidden friend", "/// A class.\nclass s {\n public:\n  friend bool f(const s&) { return false; }\n};", 1),
    ("no verb", "/// The number of edges.\nint f();", 1), ("a noun in -s", "/// Edges of a ring.\nint f();", 1),
    ("a docstring far away", "/// Returns nothing.\n\nint f();", 1), ("an overload far away", "/// Returns nothing.\nint f();\n\nint f(int);", 1),
    ("a plain comment", "// Returns nothing.\nint f();", 1), ("a wide comment", "// " + "x" * WIDTH, 1), ("a wide docstring", "/// Returns " + "x" * WIDTH + "\nint f();", 1),
    ("behind a requires clause", "template <class T>\nrequires(sizeof(T) > 1)\nint f(T) { return 1; }", 1),
]
HARMLESS = [
    "/// A class.\nstruct s {\n  int x;\n};", "/// A class.\nclass s {\n public:\n  explicit s(int x) : x_{x} {}\n  bool operator<(int y) const { return x_ < y; }\n\n private:\n  int x_;\n};",
    "/// What the concept asks for.\n///@{\nint f();\n\nint g();\n///@}",
    "/// Returns nothing.\nint f();\nint f(int);", "class s;", "/// A class.\nclass s {\n  int f();\n\n public:\n  s() = default;\n  s(const s&) = delete;\n};",
    "/// A class.\nstruct s {\n  int x;  ///< its place\n};", "namespace detail {\nint f();\n}", "/// A class.\nclass s {\n  struct t {\n    int x;\n  };\n};",
    "/// A class.\nstruct s {\n  friend bool operator==(const s&, const s&) = default;\n};", "/// Returns nothing.\ntemplate <class T>\nint f(T t) {\n  int x = t;\n  return x;\n}",
    "/// An enumeration.\nenum class e { a, b };", "/// Returns nothing (\"{\").\ninline char f() { return '{'; }", "static_assert(1'000 > 1);",
    "/// A class.\ntemplate <class T>\nclass s {\n public:\n  /// Takes a number.\n  explicit s(int x) : x_{x}, y_(x) {}\n\n private:\n  int x_;\n  int y_;\n};",
]


def self_test(root):
    """Plants every kind of breach, one at a time; returns how many were not found, or found where there is none."""
    missed = 0
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch)
        for home in NARROW:
            if (root / home).is_dir():
                shutil.copytree(root / home, copy / home)
        planted = copy / "include/osteon/core/planted.hpp"
        for name, code, count in PLANTED + [(repr(code), code, 0) for code in HARMLESS]:
            planted.write_text(f"#pragma once\n\n/// \\file\n/// Planted.\n\nnamespace osteon {{\n\n{code}\n\n}}  // namespace osteon\n")
            found = [b for rule in (undocumented, wide_comments) for b in rule("planted.hpp", planted.read_text())]
            if len(found) != count:
                missed += 1
                print(f"{name}: {len(found)} breaches instead of {count}")
        planted.write_text("namespace osteon {\nint f();\n}\n")
        if not any(b.file.name == "planted.hpp" for b in breaches(copy)):
            missed += 1
            print("the repository's own folders are not searched")
    print(f"{len(PLANTED)} planted breaches and {len(HARMLESS)} harmless texts, {missed} taken wrongly")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--count", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.root / "include/osteon").is_dir():
        parser.error(f"{arguments.root} is not the repository")
    if arguments.self_test:
        return 1 if self_test(arguments.root) else 0
    found = list(breaches(arguments.root))
    if arguments.count:
        for file, count in sorted(collections.Counter(str(b.file) for b in found).items()):
            rules = collections.Counter(b.rule for b in found if str(b.file) == file)
            print(f"{count:5} {file}: " + ", ".join(f"{n} {rule}" for rule, n in sorted(rules.items())))
    else:
        for breach in found:
            print(f"{breach.file}:{breach.line}: {breach.text}")
    rules = collections.Counter(b.rule for b in found)
    print(f"{len(found)} breaches of the rules for comments" + (": " if found else "") + ", ".join(f"{n} {rule}" for rule, n in sorted(rules.items())))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
