#!/usr/bin/env python3
# Error against time beside Blender's Cycles, for docs/accuracy.md: the same scene on the same two cores, in
# turn and in random order. Needs Debian's blender, python3-numpy and the test data's reference scenes.
#
#   tests/bench/beside_cycles.py GLIMT SCENE.scene.json [SIDE [ROUNDS]]
#
# The error is relMSE, the mean of (I - R)^2 / (R^2 + 0.01), without the light and 3 pixels around it. It is
# half of what two pictures of other seeds differ by, so that neither program is judged by the other's.
# Times are the render alone: not loading, nor compiling that is done before, nor building the tree.
import json
import os
import random
import re
import statistics
import subprocess
import sys
import tempfile

import numpy

SAMPLES = [1, 4, 16, 64]


def read_pfm(path):
    with open(path, "rb") as file:
        assert file.readline().strip() == b"PF"
        width, height = map(int, file.readline().split())
        file.readline()
        return numpy.frombuffer(file.read(), "<f4").reshape(height, width, 3)


def glimt(program, scene, side, samples, seed, folder):
    picture, report = folder + "/glimt.pfm", folder + "/glimt.json"
    subprocess.run([program, "render", scene, "--size", f"{side}x{side}", "--spp", str(samples), "--seed",
                    str(seed), "-o", picture, "--json", report, "--quiet"], check=True)
    with open(report) as file:
        return json.load(file)["seconds"]["render"], read_pfm(picture)


def cycles(scene, side, samples, seed, folder):
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "cycles_scene.py")
    out = folder + "/cycles.npy"
    # Another seed for each number of samples: its first points are the same otherwise.
    printed = subprocess.run(["blender", "-b", "-t", "2", "--python", script, "--", scene, str(side),
                              str(samples), str(1000 * seed + samples), out],
                             check=True, capture_output=True, text=True).stdout
    return float(re.search(r"^seconds (\S+)$", printed, re.M)[1]), numpy.load(out)


def away_from_light(picture):
    """Where neither the light nor a pixel within 3 of it is."""
    bright = picture.max(2) > 3.9
    near = bright.copy()
    for y in range(-3, 4):
        for x in range(-3, 4):
            near |= numpy.roll(bright, (y, x), (0, 1))
    return ~near


def error(pictures, mean, mask):
    first, second = pictures[:2]
    return float(((first - second) ** 2 / 2 / (mean ** 2 + 0.01)).mean(2)[mask].mean())


def main(program, scene, side=512, rounds=3):
    times, pictures = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, int(rounds) + 1):
            for samples in SAMPLES:
                runs = [("glimt", lambda: glimt(program, scene, side, samples, seed, folder)),
                        ("Cycles", lambda: cycles(scene, side, samples, seed, folder))]
                random.shuffle(runs)
                for name, run in runs:
                    seconds, picture = run()
                    times.setdefault((name, samples), []).append(seconds)
                    pictures.setdefault((name, samples), []).append(picture)
                    print(f"{name} {samples} samples: {seconds:.2f} s", file=sys.stderr, flush=True)
    print("| samples | Cycles | glimt | median of the pairs' ratios |\n|---:|---:|---:|---:|")
    mask = away_from_light(pictures["glimt", SAMPLES[-1]][0])
    means = {name: numpy.mean(pictures[name, SAMPLES[-1]], 0) for name in ("Cycles", "glimt")}
    for samples in SAMPLES:
        cells = []
        for name in ("Cycles", "glimt"):
            relmse = error(pictures[name, samples], means[name], mask)
            cells.append(f"{statistics.median(times[name, samples]):.2f} s, {relmse:.5f}")
        ratio = statistics.median(a / b for a, b in zip(times["glimt", samples], times["Cycles", samples]))
        print(f"| {samples} | {cells[0]} | {cells[1]} | {ratio:.2f} |")


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5:
        sys.exit("usage: beside_cycles.py GLIMT SCENE.scene.json [SIDE [ROUNDS]]")
    main(*sys.argv[1:])
