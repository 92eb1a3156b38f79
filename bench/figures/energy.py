#!/usr/bin/env python3
"""Energy over a million steps: energy.py CSV PICTURE, which gets the suffixes .svg and .png."""
import csv
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

# Name, colour (Okabe and Ito), style; labels stand at the right end of a line, explicit Euler's at its top.
METHODS = {
    "explicit_euler": ("explicit Euler", "#CC79A7", "-"), "semi_implicit_euler": ("semi-implicit Euler", "#0072B2", "-"),
    "verlet": ("Verlet", "#009E73", "-"), "gamephys_1": ("gamephys, 1 substep", "#D55E00", "--"),
    "gamephys_8": ("gamephys, 8 substeps", "#D55E00", "-"),
}
TITLES = {"spring": "A mass on a spring", "pendulum": "A pendulum of a rigid link"}


def share(value, _):
    return f"{100 * value:.6g} %"


def main():
    lines = {}
    with open(sys.argv[1], newline="") as file:
        for row in csv.DictReader(file):
            lines.setdefault(row["case"], {}).setdefault(row["method"], []).append((int(row["steps"]), float(row["change"])))
    plt.style.use(str(Path(__file__).parent / "style.mplstyle"))
    drawing, grid = plt.subplots(1, 2, figsize=(12, 4.2), sharey=True, layout="constrained")
    for axes, (case, title) in zip(grid, TITLES.items()):
        ends = []
        for method, points in lines[case].items():
            name, colour, style = METHODS[method]
            points = [(n, max(change, 2e-6)) for n, change in points if math.isfinite(change)]
            axes.loglog(*zip(*points), style, color=colour, linewidth=1.8)
            inside = [point for point in points if point[1] < 12]
            x, y = inside[-1]
            if x < 5e5:
                axes.annotate(name, (x, y), xytext=(8, -4), textcoords="offset points", color=colour)
            else:
                ends.append((y, name, colour))
        below = math.inf
        for y, name, colour in sorted(ends, reverse=True):  # apart by a line's height
            y = below = min(y, below / 2.6)
            axes.annotate(name, (1e6, y), xytext=(6, 0), textcoords="offset points", color=colour, va="center", annotation_clip=False)
        axes.set_xlim(1, 1e6)
        axes.set_ylim(2e-6, 20)
        axes.set_title(title, loc="left")
        axes.set_xlabel("steps of 1/60 s")
        axes.yaxis.set_major_locator(LogLocator(numticks=8))
        axes.yaxis.set_minor_locator(NullLocator())
        axes.yaxis.set_major_formatter(FuncFormatter(share))
        axes.tick_params(labelleft=True)
    grid[0].set_ylabel("largest change of the energy so far")
    drawing.savefig(sys.argv[2] + ".svg", metadata={"Date": None})
    drawing.savefig(sys.argv[2] + ".png")


main()
