#!/usr/bin/env python3
"""Renders the demo scenes for a gallery, and prints a row of its table for each.

usage, after ./dev assets: gallery.py BUILD IMAGES [OPTION]...
    (needs python3-pil)

BUILD is build/release; IMAGES is the folder for the pictures, one of each scene and gallery.jpg, a
strip of them all. Options are those of glimt render that end a picture, --noise 2 or --time 600;
they hold for each scene.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

SCENES = ["christmas", "motorcycle", "watch"]
SIZE = "1280x720"
STRIP_SIZE, GAP = (416, 234), 4


def render(build, scene, picture, limits):
    report = picture.with_suffix(".json")
    command = [build / "glimt", "render", build / "assets" / f"{scene}.scene.json", "-o", picture,
               "--json", report, "--size", SIZE, *limits]
    subprocess.run(command, check=True)
    return json.loads(report.read_text())


def row(scene, facts):
    noise = facts["noise"]
    told = ([f"{100 * noise[key]:.1f}%" for key in ("relative", "likely")] if noise
            else ["not measured"] * 2)
    return (f"| {scene} | {facts['triangles']:,} | {facts['mean_samples']:,.0f} "
            f"| {facts['samples']:,} | {facts['seconds']['render']:.0f} | {told[0]} | {told[1]} |")


def strip(pictures, file):
    width, height = STRIP_SIZE
    whole = Image.new("RGB", (len(pictures) * (width + GAP) - GAP, height), "white")
    for i, picture in enumerate(pictures):
        whole.paste(picture.resize(STRIP_SIZE, Image.LANCZOS), (i * (width + GAP), 0))
    whole.save(file, quality=90)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build, images, limits = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
    pictures = []
    with tempfile.TemporaryDirectory() as work:
        for scene in SCENES:
            file = pathlib.Path(work) / f"{scene}.png"
            facts = render(build, scene, file, limits)
            pictures.append(Image.open(file).convert("RGB"))
            pictures[-1].save(images / f"{scene}.jpg", quality=92)
            print(row(scene, facts), flush=True)
    strip(pictures, images / "gallery.jpg")


main()
