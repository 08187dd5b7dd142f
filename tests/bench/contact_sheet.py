#!/usr/bin/env python3
"""Renders every model of a folder of test models, and puts the pictures on a sheet.

usage: contact_sheet.py GLIMT MODELS SHEET.jpg [SECONDS]     (needs python3-pil and xz-utils)

Prints a line for each model: how it ended, samples, pixels that were not finite, and the warnings.
Models whose licence does not let their pictures be passed on are rendered, and left out of the sheet.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw, ImageFont

FOLDERS = ["cornell", "obj", "gltf", "gltf-blender-io", "vehicles", "xmas"]
KINDS = {".obj", ".gltf", ".glb", ".xz"}
# Not stated, for research only, or with a trademark in them.
NOT_SHOWN = ["CornellBox-Glossy", "CornellBox-Empty-Squashed", "stanford-", "suzanne", "motorcycle",
             "BoxTextured"]
SIDE, GAP, TEXT, COLUMNS = 128, 6, 16, 8


def models(folder):
    for name in FOLDERS:
        for file in sorted((folder / name).rglob("*")):
            if file.suffix in KINDS and ".bin" not in file.name:
                yield file


def render(glimt, file, seconds, work):
    source = file
    if file.suffix == ".xz":
        source = work / file.stem
        source.write_bytes(subprocess.run(["xz", "-dc", file], capture_output=True, check=True).stdout)
    picture = work / f"{len(list(work.glob('*.png')))}.png"
    report = work / "report.json"
    report.unlink(missing_ok=True)
    command = [glimt, "render", source, "-o", picture, "--size", "256x256", "--time", str(seconds),
               "--tone", "agx", "--json", report]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return None, f"exit status {done.returncode}: {done.stderr.strip()}"
    facts = json.loads(report.read_text())
    said = "; ".join(facts["warnings"])
    return picture, f"{facts['samples']} samples, {facts['nonfinite_pixels']} not finite. {said}"


def sheet(pictures, file):
    try:
        font = ImageFont.truetype("DejaVuSans.ttf", 10)
    except OSError:
        font = ImageFont.load_default()
    rows = (len(pictures) + COLUMNS - 1) // COLUMNS
    whole = Image.new("RGB", (COLUMNS * (SIDE + GAP) - GAP, rows * (SIDE + TEXT + GAP) - GAP), "white")
    draw = ImageDraw.Draw(whole)
    for i, (name, picture) in enumerate(pictures):
        x, y = i % COLUMNS * (SIDE + GAP), i // COLUMNS * (SIDE + TEXT + GAP)
        whole.paste(Image.open(picture).convert("RGB").resize((SIDE, SIDE), Image.LANCZOS), (x, y))
        draw.text((x, y + SIDE + 2), name[:23], "#222222", font=font)
    whole.save(file, quality=88)


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    glimt, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    seconds = float(sys.argv[4]) if len(sys.argv) > 4 else 10
    shown = []
    with tempfile.TemporaryDirectory() as work:
        for file in models(folder):
            picture, said = render(glimt, file, seconds, pathlib.Path(work))
            print(f"{file.relative_to(folder)}: {said}", flush=True)
            if picture and not any(name in str(file) for name in NOT_SHOWN):
                shown.append((file.name.split(".")[0], picture))
        sheet(shown, sys.argv[3])


main()
