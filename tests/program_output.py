#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the program does where its results cannot be written: every command, every way to write.

    program_output.py OSTEON MODELS [TEST...]

A result that is lost must be told: status 6 and a message that names the output. A file appears whole or not at all.
"""

import os
import resource
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

UNWRITTEN = 6
WORK = tempfile.mkdtemp()


def path(name):
    return os.path.join(WORK, name)


OSTEON = path("osteon")
STAR = path("star.obj")
L = path("l.xy")
ARMS = path("arms.obj")


# To root no folder is read-only, and a wrong program could replace what is in /dev: so another user runs it.
USER = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}


def run(*arguments, **options):
    options.setdefault("stdout", subprocess.PIPE)
    return subprocess.run([OSTEON, *arguments], stderr=subprocess.PIPE, timeout=60, check=False, **USER, **options)


def make(*arguments):
    """Runs what must succeed."""
    subprocess.run([OSTEON, *arguments], check=True, **USER)


def give(name):
    """Makes a file of this test the program's user's."""
    if USER:
        os.chown(name, USER["user"], USER["group"], follow_symlinks=False)


def put(name, text):
    with open(name, "w", encoding="ascii") as f:
        f.write(text)
    give(name)


def get(name):
    with open(name, encoding="ascii") as f:
        return f.read()


def prepare(program, models):
    """Copies all that is needed to where every user can reach it."""
    os.chmod(WORK, 0o755)
    give(WORK)
    shutil.copy(program, OSTEON)
    shutil.copy(os.path.join(models, "star.obj"), STAR)
    os.chmod(OSTEON, 0o755)
    os.chmod(STAR, 0o644)
    put(L, "0 0\n4 0\n4 1\n1 1\n1 3\n0 3\n")
    make("skeleton", STAR, "--output", path("star.json"))
    make("skeleton", L, "--output", path("l.json"))
    make("generate", "arms", "--size", "4", "-o", ARMS)


# Every kind of result on standard output.
PRINTS = [
    ["skeleton", STAR],
    ["skeleton", STAR, "--summary"],
    ["skeleton", L],
    ["skeleton", L, "--summary"],
    ["verify", STAR, path("star.json")],
    ["verify", L, path("l.json")],
    ["verify", ARMS, path("star.json")],  # refuted
    ["offset", L, "--by", "0.1,0.2"],
    ["offset", L, "--by", "0.1", "--format", "wkt"],
    ["offset", L, "--by", "0.1", "--format", "xy", "--outside"],
    ["roof", L],
    ["roof", L, "--summary"],
    ["splits", ARMS, "--vertex", "3"],
    ["splits", ARMS, "--vertex", "3", "--all"],
    ["splits", ARMS, "--vertex", "3", "--summary"],
    ["splits", ARMS, "--vertex", "3", "--count"],
    ["splits", ARMS, "--vertex", "3", "--sample", "5"],
    ["splits", ARMS, "--vertex", "3", "--spherical"],
    ["ambiguity", ARMS],
    ["ambiguity", ARMS, "--explore", "2", "--offset", "0.1"],
    ["generate", "star"],
    ["generate", "comb"],
    ["--help"],
    ["--version"],
    *([c, "--help"] for c in ("skeleton", "verify", "offset", "roof", "splits", "ambiguity", "generate")),
]

# Every kind of result in a file; the file's name comes last.
FILES = [
    ["skeleton", STAR, "--output"],
    ["skeleton", STAR, "--summary", "--output"],
    ["skeleton", L, "--output"],
    ["skeleton", L, "--summary", "--output"],
    ["offset", L, "--by", "0.1,0.2", "-o"],
    ["offset", L, "--by", "0.1", "--format", "wkt", "-o"],
    ["offset", L, "--by", "0.1", "--format", "xy", "--outside", "-o"],
    ["roof", L, "-o"],
    ["roof", L, "--summary", "-o"],
    ["generate", "star", "-o"],
    ["generate", "comb", "-o"],
]


class Output(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(dir=WORK)
        give(self.folder)
        self.file = os.path.join(self.folder, "result")

    def tearDown(self):
        os.chmod(self.folder, 0o700)
        shutil.rmtree(self.folder)

    def expect_unwritten(self, done, name="standard output"):
        message = done.stderr.decode()
        self.assertEqual(done.returncode, UNWRITTEN, message)
        self.assertRegex(message, f"osteon: {name}: cannot be written.*; hint: ")

    def expect_alone(self, *names):
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(names))

    # ---- standard output

    def test_full_disk(self):
        for arguments in PRINTS:
            with self.subTest(command=" ".join(arguments)):
                with open("/dev/full", "wb") as full:
                    self.expect_unwritten(run(*arguments, stdout=full))

    def test_pipe_that_nobody_reads(self):
        for arguments in PRINTS:
            with self.subTest(command=" ".join(arguments)):
                read, write = os.pipe()
                os.close(read)
                self.expect_unwritten(run(*arguments, stdout=write))
                os.close(write)

    def test_head(self):
        # Ends long before the list would: the trees of this vertex would take hours.
        make("generate", "arms", "--size", "8", "-o", self.file)
        command = subprocess.Popen([OSTEON, "splits", self.file, "--vertex", "3", "--all"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, **USER)
        self.assertIn(b"<", command.stdout.readline())
        command.stdout.close()
        self.assertEqual(command.wait(60), UNWRITTEN)
        command.stderr.close()

    def test_closed(self):
        for arguments in PRINTS:
            with self.subTest(command=" ".join(arguments)):
                self.expect_unwritten(run(*arguments, stdout=None, preexec_fn=lambda: os.close(1)))

    def test_closed_but_not_needed(self):
        done = run("generate", "star", "-o", self.file, stdout=None, preexec_fn=lambda: os.close(1))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_bad_input_stays_the_error_where_nothing_can_be_written(self):
        with open("/dev/full", "wb") as full:
            self.assertEqual(run("skeleton", path("missing.obj"), stdout=full).returncode, 3)

    # ---- files

    def test_full_device(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                self.expect_unwritten(run(*arguments, "/dev/full"), "/dev/full")
                self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    def test_no_space_for_a_file(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (40, 40))

        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                put(self.file, "before")
                self.expect_unwritten(run(*arguments, self.file, preexec_fn=limit), self.file)
                self.expect_alone("result")
                self.assertEqual(get(self.file), "before")

    def test_unwritable_folders(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                for name in (os.path.join(self.folder, "missing", "result"), os.path.join(L, "result"), "/proc/result", self.folder):
                    self.expect_unwritten(run(*arguments, name), name)
                self.expect_alone()

    def test_read_only_folder(self):
        os.chmod(self.folder, 0o555)
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                self.expect_unwritten(run(*arguments, self.file), self.file)
                self.expect_alone()

    def test_files(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                done = run(*arguments, self.file)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.expect_alone("result")
                os.remove(self.file)

    def test_a_file_holds_what_would_have_been_printed(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                if "--summary" in arguments:
                    continue
                printed = run(*arguments[:-1]).stdout
                run(*arguments, self.file)
                with open(self.file, "rb") as f:
                    self.assertEqual(f.read(), printed)
                os.remove(self.file)

    def test_permissions(self):
        mask = os.umask(0)
        os.umask(mask)
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                run(*arguments, self.file)
                self.assertEqual(stat.S_IMODE(os.stat(self.file).st_mode), 0o666 & ~mask)
                for mode in (0o600, 0o640, 0o755):
                    os.chmod(self.file, mode)
                    self.assertEqual(run(*arguments, self.file).returncode, 0)
                    self.assertEqual(stat.S_IMODE(os.stat(self.file).st_mode), mode)
                os.remove(self.file)

    def test_links_are_followed(self):
        link = os.path.join(self.folder, "link")
        inner = os.path.join(self.folder, "inner")
        os.mkdir(inner)
        give(inner)
        os.symlink("inner/middle", link)
        os.symlink("../result", os.path.join(inner, "middle"))
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                for existing in (False, True):
                    if existing:
                        put(self.file, "before")
                    self.assertEqual(run(*arguments, link).returncode, 0)
                    self.assertTrue(os.path.islink(link))
                    self.assertFalse(os.path.islink(self.file))
                    self.assertNotIn("before", get(self.file))
                    self.expect_alone("inner", "link", "result")
                    self.assertEqual(os.listdir(inner), ["middle"])
                os.remove(self.file)

    def test_link_to_itself(self):
        os.symlink("result", self.file)
        self.expect_unwritten(run("generate", "star", "-o", self.file), self.file)
        self.expect_alone("result")

    def test_other_files_stay(self):
        neighbour = self.file + ".part"
        put(neighbour, "mine")
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                self.assertEqual(run(*arguments, self.file).returncode, 0)
                self.expect_alone("result", "result.part")
                self.assertEqual(get(neighbour), "mine")

    def test_devices_and_pipes(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                self.assertEqual(run(*arguments, "/dev/null").returncode, 0)
                self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
                os.mkfifo(self.file)
                give(self.file)
                with subprocess.Popen(["cat", self.file], stdout=subprocess.PIPE) as reader:
                    self.assertEqual(run(*arguments, self.file).returncode, 0)
                    self.assertNotEqual(reader.stdout.read(), b"")
                self.assertTrue(stat.S_ISFIFO(os.stat(self.file).st_mode))
                os.remove(self.file)

    def test_standard_output_by_name(self):
        for arguments in FILES:
            with self.subTest(command=" ".join(arguments)):
                run(*arguments, self.file)
                with open(self.file, "rb") as f:
                    expected = f.read()
                for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
                    self.assertTrue(run(*arguments, name).stdout.startswith(expected))
                    for mode in ("wb", "ab"):
                        with open(self.file, "wb") as f:
                            f.write(b"before\n")
                        with open(self.file, mode) as f:
                            self.assertEqual(run(*arguments, name, stdout=f).returncode, 0)
                        with open(self.file, "rb") as f:
                            self.assertTrue(f.read().startswith((b"before\n" if mode == "ab" else b"") + expected))
                    with open("/dev/full", "wb") as full:
                        self.assertEqual(run(*arguments, name, stdout=full).returncode, UNWRITTEN)
                self.expect_alone("result")

    def test_signals(self):
        comb = path("comb.xy")
        make("generate", "comb", "--size", "100000", "-o", comb)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            put(self.file, "before")
            command = subprocess.Popen([OSTEON, "skeleton", comb, "--output", self.file], **USER)
            while len(os.listdir(self.folder)) < 2 and command.poll() is None:
                time.sleep(0.001)
            self.assertIsNone(command.poll(), "ended before the signal came")
            command.send_signal(number)
            self.assertEqual(command.wait(60), -number)
            self.expect_alone("result")
            self.assertEqual(get(self.file), "before")


if __name__ == "__main__":
    try:
        prepare(sys.argv[1], sys.argv[2])
        unittest.main(argv=sys.argv[:1] + sys.argv[3:])
    finally:
        shutil.rmtree(WORK)
