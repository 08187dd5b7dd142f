#!/usr/bin/env python3
"""The pictures of docs/accuracy.md, from folders that glimt accuracy has written.

usage: accuracy_figures.py DOCS_IMAGES FOLDER...     (needs python3-numpy and python3-pil)

Writes accuracy-curves.svg, the error of every folder's scene against time, and accuracy-glance.png, the
picture of the most exact one after more and more time. Prints the rows of the tables.
"""
import json
import math
import pathlib
import sys

import numpy
from PIL import Image, ImageDraw, ImageFont

COLORS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00"]


def read_pfm(path):
    data = path.read_bytes()
    _, size, _, pixels = data.split(b"\n", 3)
    width, height = map(int, size.split())
    return numpy.frombuffer(pixels, "<f4").reshape(height, width, 3)[::-1]


def displayed(radiance):
    x = numpy.clip(radiance, 0, 1)
    x = numpy.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
    return Image.fromarray((255 * x + 0.5).astype("uint8"))


def duration(seconds):
    if seconds < 10:
        return f"{seconds:.2g} s"
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min"


class Report:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.json = json.loads((self.folder / "report.json").read_text())
        self.name = pathlib.Path(self.json["scene"]).name.split(".")[0]
        self.curves = self.json["curves"]
        self.factor = self.json["time_factor"]

    def points(self):
        return [(p["seconds"] * self.factor, p["error"]) for p in self.curves[0]["points"]]


def glance(report, file):
    side, gap, text = 180, 8, 46
    points = report.curves[0]["points"]
    chosen = [points[round(i * (len(points) - 1) / 4)] for i in range(5)]
    font = ImageFont.load_default()
    for name in ("DejaVuSans.ttf", "LiberationSans-Regular.ttf"):
        try:
            font = ImageFont.truetype(name, 14)
            break
        except OSError:
            continue
    strip = Image.new("RGB", (len(chosen) * (side + gap) - gap, side + text), "white")
    draw = ImageDraw.Draw(strip)
    for i, point in enumerate(chosen):
        picture = displayed(read_pfm(report.folder / f"as-asked-{point['samples']}.pfm"))
        strip.paste(picture.resize((side, side), Image.NEAREST), (i * (side + gap), 0))
        lines = f"after {duration(point['seconds'] * report.factor)}\nwrong by {100 * point['error']:.0f}%"
        draw.multiline_text((i * (side + gap) + 4, side + 6), lines, "#222222", font=font)
    strip.save(file)


def curves(reports, file):
    left, top, right, bottom, width = 58, 16, 540, 380, 700
    times = [t for r in reports for t, _ in r.points()]
    errors = [e for r in reports for _, e in r.points()]
    t0, t1 = min(times) / 1.2, max(times) * 1.2
    e0, e1 = min(errors) / 1.2, max(errors) * 1.2

    def place(t, e):
        return (
            left + (right - left) * math.log(t / t0) / math.log(t1 / t0),
            bottom - (bottom - top) * math.log(e / e0) / math.log(e1 / e0),
        )

    def ticks(low, high):
        for power in range(-6, 7):
            for factor in (1, 2, 5):
                value = factor * 10.0**power
                if low <= value <= high:
                    yield value

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} 425" font-family="sans-serif" '
        f'font-size="12"><rect width="{width}" height="425" fill="#fff"/>'
    ]
    for t in ticks(t0, t1):
        x = place(t, e0)[0]
        out.append(f'<path d="M{x:.1f} {top}V{bottom}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle" fill="#555">{t:g} s</text>')
    for e in ticks(e0, e1):
        y = place(t0, e)[1]
        out.append(f'<path d="M{left} {y:.1f}H{right}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end" fill="#555">{100 * e:g}%</text>')
    out.append(f'<text x="{(left + right) / 2}" y="{bottom + 34}" text-anchor="middle" fill="#555">time</text>')
    taken = []
    for report, color in zip(reports, COLORS):
        points = [place(t, e) for t, e in report.points()]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in points]
        x, y = points[-1]
        while any(abs(y - other) < 14 for other in taken):
            y += 14
        taken.append(y)
        out.append(f'<text x="{right + 8}" y="{y + 4:.1f}" fill="{color}">{report.name}</text>')
    out.append("</svg>")
    file.write_text("\n".join(out) + "\n")


def percent(share):
    return f"{100 * share:.2g}%" if share < 0.1 else f"{100 * share:.0f}%"


def print_tables(reports):
    print("| scene | samples | noise | truncation | together | measured | together / measured |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for report in reports:
        b = report.json["budget"]
        together = math.hypot(b["noise"], b["limits"])
        print(
            f"| {report.name} | {b['samples']} | {percent(b['noise'])} | {percent(b['truncation'])} | "
            f"{percent(together)} | {percent(b['measured'])} | {together / b['measured']:.2f} |"
        )
    print("\n| scene | error | time | command |\n|---|---:|---:|---|")
    for report in reports:
        for way in report.json["recommended"]:
            options = way["command"].split(" -o picture.png ")[1]
            print(f"| {report.name} | {percent(way['error'])} | {duration(way['seconds'])} | `{options}` |")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    images = pathlib.Path(sys.argv[1])
    reports = [Report(folder) for folder in sys.argv[2:]]
    curves(reports, images / "accuracy-curves.svg")
    glance(min(reports, key=lambda report: report.points()[-1][1]), images / "accuracy-glance.png")
    print_tables(reports)


main()
