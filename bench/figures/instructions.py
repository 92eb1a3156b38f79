#!/usr/bin/env python3
"""The instructions of a ray as bars: instructions.py PAGE PICTURE, which gets the suffixes .svg and .png. The numbers
are those of the first table "instructions per ray" of the page."""
import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Of the parts, from the left: Okabe and Ito's colours.
COLOURS = ["#999999", "#E69F00", "#56B4E9", "#F0E442", "#D55E00"]


def main():
    table = Path(sys.argv[1]).read_text().split("| instructions per ray |", 1)[1].split("\n\n", 1)[0].splitlines()
    columns = [cell.strip() for cell in table[0].split("|") if cell.strip()]
    rows = {}
    for line in table[2:]:
        name, *cells = [cell.strip().replace("*", "") for cell in line.strip("|").split("|")]
        rows[name] = [float(cell.replace(",", "")) if re.fullmatch(r"[\d.,]+", cell) else 0 for cell in cells]
    parts = list(rows)[:5]
    embree = next(name for name in rows if name.startswith("Embree"))
    plt.style.use(str(Path(__file__).parent / "style.mplstyle"))
    drawing, axes = plt.subplots(figsize=(10, 5.4), layout="constrained")
    for i in range(len(columns)):
        left = 0
        for part, colour in zip(parts, COLOURS):
            axes.barh(i - 0.18, rows[part][i], 0.34, left=left, color=colour, label=part if i == 0 else None)
            left += rows[part][i]
        axes.barh(i + 0.2, rows[embree][i], 0.3, color="#0072B2", label="Embree, all" if i == 0 else None)
        axes.text(left + 60, i - 0.18, f"{rows['gamephys'][i]:,.0f}", va="center")
        axes.text(rows[embree][i] + 60, i + 0.2, f"{rows[embree][i]:,.0f}", va="center", color="#0072B2")
    axes.set_yticks(range(len(columns)), columns)
    axes.invert_yaxis()
    axes.set_xlim(0, 7200)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("instructions per ray")
    axes.legend(loc="lower right")
    drawing.savefig(sys.argv[2] + ".svg", metadata={"Date": None})
    drawing.savefig(sys.argv[2] + ".png")


main()
