#!/usr/bin/env python3
"""Renders the demo scenes for a gallery, and prints a row of its table for each.

usage, after ./dev assets: gallery.py BUILD IMAGES [OPTION]...
    (needs python3-pil)

BUILD is build/release, IMAGES the folder for the pictures; options are those of glimt render that end
a picture: --noise 2, --time 600. They hold for each scene; the strip's pictures are a third as wide,
and end at the same limit.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

SCENES = ["christmas", "motorcycle", "watch"]
STRIP = "motorcycle"
SIZE, STRIP_SIZE = "1280x720", "432x243"
GAP = 4


def render(build, scene, picture, *options):
    report = picture.with_suffix(".json")
    command = [build / "glimt", "render", build / "assets" / f"{scene}.scene.json", "-o", picture,
               "--json", report, *options]
    subprocess.run(command, check=True)
    return json.loads(report.read_text())


def row(scene, facts):
    noise = f"{100 * facts['noise']['likely']:.2g}%" if facts["noise"] else "not measured"
    return (f"| {scene} | {facts['triangles']:,} | {facts['samples']:,} "
            f"| {facts['seconds']['render']:.0f} | {noise} |")


def strip(pictures, file):
    opened = [Image.open(picture).convert("RGB") for picture in pictures]
    width, height = opened[0].size
    whole = Image.new("RGB", (len(opened) * (width + GAP) - GAP, height), "white")
    for i, picture in enumerate(opened):
        whole.paste(picture, (i * (width + GAP), 0))
    whole.save(file, quality=90)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build, images, limits = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        for scene in SCENES:
            picture = work / f"{scene}.png"
            facts = render(build, scene, picture, "--size", SIZE, *limits)
            Image.open(picture).convert("RGB").save(images / f"{scene}.jpg", quality=92)
            print(row(scene, facts), flush=True)
        variants = []
        model = json.loads((build / "assets" / f"{STRIP}.gltf").read_text())
        for variant in model["extensions"]["KHR_materials_variants"]["variants"]:
            variants.append(work / f"variant {len(variants)}.png")
            render(build, STRIP, variants[-1], "--size", STRIP_SIZE, "--variant", variant["name"],
                   *limits)
        strip(variants, images / f"{STRIP}-variants.jpg")


main()
