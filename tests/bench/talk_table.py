#!/usr/bin/env python3
"""The talk's benchmark: 512 x 512, 4 secondary bounces, each traversal.

usage: talk_table.py GLIMT ROUNDS SCENE...

Prints a row for each traversal: seconds per sample of each scene, and millions of rays a second, medians of
that many rounds. In a round all traversals take their turn, so that a busy moment does not hit one alone.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

# The last three need OpenGL ES 3.0. "linear" takes hours with half a million triangles.
TRAVERSALS = {"octant-ahead": 2, "octant": 2, "stack": 2, "trail": 2, "parent": 2, "skip": 2,
              "trail-bits": 3, "short-stack": 3, "array-stack": 3}
SAMPLES = 4
USAGE = 2  # an exit status of glimt


def run(glimt, scene, traversal, picture):
    command = [glimt, "render", scene, "--size", "512x512", "--bounces", "4", "--spp", str(SAMPLES),
               "--roulette", "off", "--traversal", traversal, "--gles", str(TRAVERSALS[traversal]),
               "-o", picture, "--json", "-", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == USAGE:  # the tree is too deep for it
        return None
    done.check_returncode()
    facts = json.loads(done.stdout)
    seconds = facts["seconds"]["render"]
    return seconds / facts["samples"], 1e-6 * sum(facts["rays"].values()) / seconds


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    glimt, rounds, scenes = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    names = [pathlib.Path(scene).name.split(".")[0] for scene in scenes]
    found = {(scene, traversal): [] for scene in scenes for traversal in TRAVERSALS}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(rounds):
            for scene, traversal in found:
                found[scene, traversal].append(run(glimt, scene, traversal, f"{folder}/x.pfm"))
    print("| traversal | " + " | ".join(f"{n}, s a sample | M rays/s" for n in names) + " |")
    print("|---|" + "---:|---:|" * len(names))
    for traversal in TRAVERSALS:
        cells = []
        for scene in scenes:
            if None in found[scene, traversal]:
                cells.append("too deep | –")
                continue
            seconds, rate = (statistics.median(x) for x in zip(*found[scene, traversal]))
            cells.append(f"{seconds:.2f} | {rate:.2f}")
        print(f"| {traversal} | " + " | ".join(cells) + " |")


main()
