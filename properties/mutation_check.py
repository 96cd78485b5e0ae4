#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants known faults, one at a time, into a copy of the library and shows that the tests catch each.

    properties/mutation_check.py [--jobs N] [NAME ...]      all faults of faults.py, or those whose names contain a NAME
    properties/mutation_check.py --list                     where each fault would be planted
    properties/mutation_check.py --check                    only whether each fault finds its place; takes seconds, compiles nothing

For each fault the named test programs are compiled against the copy and run until one fails. A fault that no program notices, that finds its place not
exactly once, or that does not compile, ends the script with status 1. First every program must pass without a fault. A program that a fault does not
reach is neither compiled nor run again. Needs a C++ compiler ($CXX), GoogleTest and GMP; takes about a minute a fault on one core.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "static"))
import cpp_source  # noqa: E402
from faults import FAULTS  # noqa: E402

HOMES = ("include", "kernels")


class Misplaced(Exception):
    """A fault does not find its place exactly once."""


class Library:
    """The headers of a repository, and the definitions in them by identifier."""

    def __init__(self, root):
        self.root = root
        self.texts = {path: path.read_text() for home in HOMES for path in sorted((root / home).rglob("*.hpp"))}
        self.definitions = {}
        for path, text in self.texts.items():
            for declaration in cpp_source.declarations(text):
                if declaration.kind in ("function", "friend", "variable") and declaration.defined:
                    self.definitions.setdefault(declaration.name.split("::")[-1], []).append((path, declaration))

    def named(self, function):
        """Yields (file, declaration) of all definitions of a name: "run", "verifier::run"; alternatives are separated by |."""
        for alternative in function.split("|"):
            *outer, name = alternative.split("::")
            for path, declaration in self.definitions.get(name, []):
                around = iter([part for name in declaration.scope for part in name.split("::")] + declaration.name.split("::")[:-1])
                if all(part in around for part in outer):
                    yield path, declaration

    def place(self, fault):
        """Returns (file, declaration, match, text without comments) of a fault. Throws Misplaced."""
        pattern = re.compile(re.sub(r" +", r"\\s+", fault.pattern), re.DOTALL)
        found = []
        functions = 0
        for path, declaration in self.named(fault.function):
            functions += 1
            code = cpp_source.without_comments(self.texts[path])
            found += [(path, declaration, match, code) for match in pattern.finditer(code, declaration.start, declaration.end)]
        if not functions:
            raise Misplaced(f"no function {fault.function}")
        if len(found) != 1:
            raise Misplaced(f"{len(found)} matches in {functions} functions {fault.function}")
        return found[0]

    def with_fault(self, fault):
        """Returns (file, its text with the fault in it). Throws Misplaced."""
        path, _, match, code = self.place(fault)
        return path, self.texts[path][:match.start()] + match.expand(fault.replacement) + self.texts[path][match.end():]


class Workshop:
    """Compiles and runs test programs; a program whose text after preprocessing is known is not compiled, or run, again."""

    def __init__(self, root, folder):
        self.root = root
        self.folder = folder
        self.compiler = os.environ.get("CXX", "g++")
        self.lock = threading.Lock()
        self.busy = {}    # a lock for each program
        self.passed = {}  # by program and selected tests

    def run(self, command, seconds, **options):
        try:
            return subprocess.run(command, stderr=subprocess.PIPE, timeout=seconds, check=False, **{"stdout": subprocess.DEVNULL, **options})
        except subprocess.TimeoutExpired:
            return None

    def preprocessed(self, tree, source):
        command = [self.compiler, "-std=c++20", "-E", "-P", *(f"-I{tree / home}" for home in HOMES), f"-I{self.root}/oracles",
                   f'-DOSTEON_CORPUS="{self.root}/../shared/corpus"', f'-DOSTEON_MODELS="{self.root}/tests/models"', f"{self.root}/tests/{source}.cpp"]
        result = self.run(command, 120, stdout=subprocess.PIPE)
        if result is None or result.returncode != 0:
            raise RuntimeError(f"{source} is not preprocessed\n{result.stderr.decode(errors='replace') if result else ''}")
        return result.stdout.replace(str(tree).encode(), b"library")

    def passes(self, tree, program):
        """Returns whether a program compiled against a copy of the library ends well within ten minutes. Throws RuntimeError where it does not compile."""
        text = self.preprocessed(tree, program.source)
        key = hashlib.sha256(text).hexdigest()[:20]
        with self.lock:
            busy = self.busy.setdefault(key, threading.Lock())
        with busy:
            if (key, program.tests) not in self.passed:
                binary = self.folder / key
                if not binary.exists():
                    source = self.folder / (key + ".ii")
                    source.write_bytes(text)
                    built = self.run([self.compiler, "-std=c++20", "-O1", "-w", "-x", "c++-cpp-output", str(source), "-o", str(binary), "-lgtest_main", "-lgtest", "-lgmp"], 1200)
                    source.unlink()
                    if built is None or built.returncode != 0:
                        raise RuntimeError(f"{program.source} does not compile\n{built.stderr.decode(errors='replace')[:4000] if built else ''}")
                result = self.run([str(binary), f"--gtest_filter={program.tests}", "--gtest_brief=1"], 600)
                self.passed[key, program.tests] = result is not None and result.returncode == 0
            return self.passed[key, program.tests]

    def forget(self, tree):
        shutil.rmtree(tree)


def without_fault(library, workshop, program):
    """Returns (whether a program passes as it should, message)."""
    try:
        good = workshop.passes(library.root, program)
    except RuntimeError as error:
        return False, f"without a fault: {error}"
    return good, f"without a fault: {program.source} " + ("passes" if good else "FAILS")


def examine(library, workshop, fault):
    """Returns (whether a fault is caught, message)."""
    try:
        path, text = library.with_fault(fault)
    except Misplaced as error:
        return False, f"{fault.name}: {error}; hint: bring faults.py up to date"
    with tempfile.TemporaryDirectory(dir=workshop.folder) as folder:
        tree = pathlib.Path(folder)
        for home in HOMES:
            shutil.copytree(library.root / home, tree / home)
        (tree / path.relative_to(library.root)).write_text(text)
        try:
            by = next((p.source for p in fault.programs if not workshop.passes(tree, p)), None)
        except RuntimeError as error:
            return False, f"{fault.name}: {error}"
    return by is not None, f"{fault.name}: " + (f"caught by {by}" if by else "NOT CAUGHT")


def list_places(library, faults, quiet):
    """Prints where the faults would be planted, or only those that find no place; returns the number of these."""
    missed = 0
    for fault in faults:
        try:
            path, declaration, match, code = library.place(fault)
            missing = [p.source for p in fault.programs if not (library.root / "tests" / (p.source + ".cpp")).exists()]
            if missing:
                raise Misplaced(f"no tests/{missing[0]}.cpp")
            if match.expand(fault.replacement) == match.group():
                raise Misplaced("the replacement changes nothing")
            if not quiet:
                print(f"{fault.name}: {path.relative_to(library.root)}:{cpp_source.Lines(code).of(match.start())}: {declaration.qualified()}")
        except Misplaced as error:
            missed += 1
            print(f"{fault.name}: {error}")
    print(f"{len(faults)} faults, {missed} without a place")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the repository (default: the one of this script)")
    parser.add_argument("--list", action="store_true", help="print where each fault would be planted, and stop")
    parser.add_argument("--check", action="store_true", help="print the faults that do not find their place, and stop")
    parser.add_argument("name", nargs="*")
    arguments = parser.parse_args()
    chosen = [f for f in FAULTS if not arguments.name or any(n in f.name for n in arguments.name)]
    library = Library(arguments.root.resolve())
    if arguments.list or arguments.check:
        return 1 if list_places(library, chosen, arguments.check) else 0

    good = True
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        workshop = Workshop(library.root, pathlib.Path(folder))
        tasks = [pool.submit(without_fault, library, workshop, p) for p in sorted({p for f in chosen for p in f.programs})]
        tasks += [pool.submit(examine, library, workshop, f) for f in chosen]
        for task in tasks:
            ok, message = task.result()
            print(message, flush=True)
            good = good and ok
    print(f"{len(chosen)} faults, " + ("all caught" if good else "NOT all caught"))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
