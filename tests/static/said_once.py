#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that what is the same for both dimensions is said once in include, kernels and src.

    tests/static/said_once.py ROOT               checks the repository at ROOT; prints every place where something is said again
    tests/static/said_once.py ROOT --self-test   plants every thing a second time, in each of its known forms; each must be found

ONCE has a line for each thing: its one file, and how copies of it have looked. Comments are not seen. The oracles share nothing and keep their own.
"""
import argparse
import collections
import pathlib
import re
import sys
import tempfile

import cpp_source

HOMES = ("include", "kernels", "src")
INDEX = r"(?:static_cast<[\w:]+>\(\s*|std::size_t\()?"  # of a list; the names in it are groups of their own

# name, file, patterns, copies that the patterns must find
Once = collections.namedtuple("Once", "name file patterns copies")
ONCE = [
    Once("union-find", "include/osteon/core/disjoint_sets.hpp",
         [rf"while \((\w+)\[{INDEX}(\w+)\)?\] != \2\)", r"\.(\w+) = [\w.\[\]]*\.\1\]\.\1\b", rf"if \((\w+)\[{INDEX}(\w+)\)?\] != \2\) \1\["],
         ["while (parent[a] != a) a = parent[a] = parent[parent[a]];", "while (up[static_cast<std::size_t>(x)] != x) x = up[static_cast<std::size_t>(x)];",
          "sheet = s[sheet].polygon = s[s[sheet].polygon].polygon;", "if (up[x] != x) up[x] = root(up[x]);", "while (up_[std::size_t(x)] != x) x = up_[std::size_t(x)];"]),
    Once("omit", "include/osteon/core/planes.hpp",
         [r"if \(\w+ != \w+\) \w+\[\w+\+\+\] = [\w.]+\[\w+\];", r"\bomit\w*\((?:const )?(?:triple|quadruple|std::array)[^)]*\)\s*\{"],
         ["for (int r = 0, n = 0; r < 4; ++r)\n  if (r != best) t[n++] = q[r];", "triple omit(const quadruple& q, unsigned r) {", "if (i != r)\n  rest[size++] = n.q[i];"]),
    Once("the sign of lambda", "include/osteon/core/planes.hpp",
         [r"\bsign lambda\w*\([^;{}]*\)[\w\s]*\{(?![^}]*\blambda\w*\()", r"\bstd::array<sign, \d> lambda = [^;]*orientation", r"% 2 [!=]= [01]\)? \? -?[\w.]*orientation",
          r"\bsign lambda\b = [^;]*\borientation"],
         ["sign lambda(const triple& q, unsigned r) const {", "const sign lambda = odd ? -k_.orientation(a, b) : k_.orientation(a, b);",
          "const std::array<sign, 4> lambda = {-generic_orientation(k_, q[1], q[2], q[3]), generic_orientation(k_, q[0], q[2], q[3])};",
          "return r % 2 == 0 ? -orientation(a, b, c) : orientation(a, b, c);"]),
    Once("lambda in numbers", "include/osteon/core/planes.hpp",
         [r"\{-minor\(", r"\{cross\(q\[1\], q\[2\]\), cross\(q\[2\], q\[0\]\)", r"\{-[\w.]+\(q\[1\], q\[2\], q\[3\]\), [\w.]+\(q\[0\], q\[2\], q\[3\]\)"],
         ["const std::array<integer, 4> lambda = {-minor(1, 2, 3), minor(0, 2, 3)};", "lambda = {cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1])};",
          "lambda = {-det(q[1], q[2], q[3]), det(q[0], q[2], q[3])};"]),
    Once("splitmix64", "include/osteon/core/random.hpp", [r"(?i)0xBF58476D1CE4E5B9", r"(?i)0x94D049BB133111EB"],
         ["x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;", "x = (x ^ x >> 27U) * 0x94D049BB133111EBU;"]),
    Once("the turn of three points", "include/osteon/input/geometry.hpp",
         [r"\((\w+)(\[0\]|\.x\b) - (\w+)\2\) \* \((?!\1\b)(\w+)(\[1\]|\.y\b) - \3\5\) - ", r"\((\w+)(\[x\]) - (\w+)\2\) \* \((\w+)(\[y\]|\.y) - \3\[y\](?: \* \w+\.w)?\) - ",
          r"\((\w+)(\[1\]|\.y\b) - (\w+)\2\) \* \((?!\1\b)(\w+)(\[0\]|\.x\b) - \3\5\)"],
         ["return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);", "(q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)",
          "(b[x] - a[x]) * (p.y - a[y] * p.w) - (b[y] - a[y]) * (p.x - a[x] * p.w)"]),
    Once("a separation bound", "kernels/osteon/evaluate/separation_bound.hpp",
         [r"\b[2-9]\d* \* \((?:\w+ \+ \d+|\w+)\) \+ (?:bit_length|\d{2,})", r"\bprecision > most\b", r"\b[78] \* size \+ bit_length"],
         ["const auto most = static_cast<unsigned>(8 * (bits + 4) + 128);", "if (precision > most) return std::nullopt;", "7 * size + bit_length(error) + 2"]),
]


def compiled(pattern):
    """Returns a pattern in which a space stands for any white space."""
    return re.compile(re.sub(r"(?<!\[\^)(?<!\\) ", r"\\s+", pattern), re.DOTALL)


def breaches(root, table=ONCE):
    """Yields a message for each thing that is said again, or not where it should be."""
    texts = {path.relative_to(root).as_posix(): path.read_text() for home in HOMES for path in sorted((root / home).rglob("*.[ch]pp"))}
    for once in table:
        if once.file not in texts:
            yield f"{once.file}: is not there, and should be the one place of {once.name}"
        for file, text in texts.items():
            if file == once.file:
                continue
            code = cpp_source.without_comments(text)
            lines = sorted({cpp_source.Lines(text).of(match.start()) for pattern in once.patterns for match in compiled(pattern).finditer(code)})
            for line in lines:
                yield f"{file}:{line}: {once.name} is said again; hint: use {once.file}"


def self_test():
    """Plants a copy of everything; returns the number of those that were not found."""
    missed = 0
    count = 0
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch)
        for once in ONCE:
            (root / once.file).parent.mkdir(parents=True, exist_ok=True)
            (root / once.file).write_text("")
        (root / "src").mkdir()
        for once in ONCE:
            for copy in once.copies:
                count += 1
                (root / "src/planted.cpp").write_text(f"void f() {{\n{copy}\n}}\n// {copy.splitlines()[0]}\n")
                found = [text for text in breaches(root) if once.name in text]
                if len(found) != 1:
                    missed += 1
                    print(f"{once.name}: {len(found)} times found in: {copy}")
                (root / once.file).write_text(copy)
                (root / "src/planted.cpp").write_text("")
                if [text for text in breaches(root) if once.name in text]:
                    missed += 1
                    print(f"{once.name}: not allowed in its own file")
                (root / once.file).write_text("")
        (root / ONCE[0].file).unlink()
        if not any("is not there" in text for text in breaches(root)):
            missed += 1
            print("a file that is not there is not missed")
    print(f"{count} planted copies, {missed} taken wrongly")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.root / "include/osteon").is_dir():
        parser.error(f"{arguments.root} is not the repository")
    if arguments.self_test:
        return 1 if self_test() else 0
    found = list(breaches(arguments.root))
    for text in found:
        print(text)
    print(f"{len(found)} things that are said again")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
