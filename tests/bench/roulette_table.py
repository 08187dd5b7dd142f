#!/usr/bin/env python3
"""What Russian roulette saves: the rows of a table in docs/accuracy.md.

usage: roulette_table.py GLIMT SCENE...

Renders each scene with and without it, in turn, with two seeds. Work is counted in rays, which no other
program on the machine changes, and in seconds; noise and work to an equal noise are those with roulette
over those without.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SEEDS = (1, 2)


def report(glimt, scene, roulette, seed, picture):
    command = [glimt, "render", scene, "--size", "160x160", "--spp", "64", "--seed", str(seed),
               "--roulette", roulette, "-o", picture, "--json", "-", "--quiet"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def figures(glimt, scene, picture):
    sums = {"on": [0, 0, 0], "off": [0, 0, 0]}
    for seed in SEEDS:
        for roulette, sum_ in sums.items():
            facts = report(glimt, scene, roulette, seed, picture)
            sum_[0] += facts["noise"]["likely"] ** 2
            sum_[1] += sum(facts["rays"].values())
            sum_[2] += facts["seconds"]["render"]
    return [on / off for on, off in zip(sums["on"], sums["off"])]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for scene in sys.argv[2:]:
            squared, rays, seconds = figures(sys.argv[1], scene, f"{folder}/picture.pfm")
            print(f"| {pathlib.Path(scene).name.split('.')[0]} | {squared:.3f} | {rays:.3f} "
                  f"| {seconds:.2f} | {squared * rays:.3f} | {squared * seconds:.2f} |", flush=True)


main()
