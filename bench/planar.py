#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Times the skeletons of polygons family by family: seconds (the field of the summary: kernel, wavefront and contraction; not the reading), microseconds
per vertex, the exponent of growth between the sizes, and the greatest memory of the whole program. Each number is the least of --repeat runs.

  bench/planar.py --program build/osteon --sizes 10000 1000000
  bench/planar.py --families jittered-holes grid-of-holes --sizes 40000
"""

import argparse
import json
import math
import os
import subprocess
import tempfile

FAMILIES = ["noisy-loop", "comb", "hilbert", "rectilinear-hilbert", "jittered-holes", "grid-of-holes"]


def generate(program, family, size, path):
    if family.endswith("-holes"):  # their size is the number of holes in a row, with four vertices each
        size = round(math.sqrt(size / 4))
    subprocess.run([program, "generate", family, "--size", str(size), "-o", path], check=True)


def run(program, path):
    """The summary of one run, and the memory of its process in KB."""
    child = subprocess.Popen([program, "skeleton", path, "--summary"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    text = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        raise SystemExit(f"{program} skeleton {path}: status {os.waitstatus_to_exitcode(status)}")
    return json.loads(text), usage.ru_maxrss


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/osteon")
    parser.add_argument("--families", nargs="+", default=FAMILIES, metavar="KIND", help="kinds of `osteon generate`")
    parser.add_argument("--sizes", nargs="+", type=int, default=[10000, 100000], help="numbers of vertices, about")
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    print(f"{'family':22}{'vertices':>10}{'seconds':>10}{'us/vertex':>11}{'exponent':>10}{'MB':>8}")
    with tempfile.TemporaryDirectory() as folder:
        for family in options.families:
            first = None
            for size in sorted(options.sizes):
                path = os.path.join(folder, "polygon.xy")
                generate(options.program, family, size, path)
                runs = [run(options.program, path) for _ in range(options.repeat)]
                seconds = min(summary["seconds"] for summary, _ in runs)
                vertices = runs[0][0]["input"]["vertices"]
                exponent = f"{math.log(seconds / first[1]) / math.log(vertices / first[0]):10.3f}" if first else f"{'':10}"
                first = first or (vertices, seconds)
                print(f"{family:22}{vertices:10}{seconds:10.3f}{seconds / vertices * 1e6:11.2f}{exponent}{min(kb for _, kb in runs) / 1024:8.0f}", flush=True)


if __name__ == "__main__":
    main()
