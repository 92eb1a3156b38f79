#!/usr/bin/env python3
"""The measured part of docs/accuracy.md from the measurements of a report: accuracy.py DIRECTORY SCORES PAGE

Reads accuracy/accuracy.csv and machine.txt in DIRECTORY, and SCORES as scores.py writes it; replaces PAGE from the
heading "Scores" on. Every number there comes from those files.
"""
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "figures"))
from marks import shown

CASES = {
    "boxes_random": "random rays through {n:,} boxes",
    "boxes_camera": "rays of a camera that sees them",
    "mesh_random": "random rays around a mesh of {n:,} triangles",
    "mesh_camera": "rays of a camera that sees it",
    "leaks_near": "rays out of a closed mesh, through edges and vertices",
    "leaks_far": "the same 370 km from the origin, 1 km large",
    "leaks_slivers": "the same stretched to slivers of 1e6 : 1",
    "ray_box_edges": "rays at faces, edges and corners of a box",
    "ray_sphere_tangent": "tangents of a sphere from 1000 km",
    "sphere_touches_box": "spheres that touch a corner of a box or miss it by an ulp (errors that cancel do not show)",
}

# The page from this heading on; what is above is written by hand.
MEASURED = """## Scores

The sums of the scores of all runs of the exact suite (`bench/scores.py`). `./test.sh --long` runs all cases: 10 million for each function that returns yes or no, a million for each closest point, sweep, penetration and camera function, and 120 million rays out of closed meshes. That takes several hours of processor time. There is also a short run with gcc and clang, unoptimised and for Haswell, on each instruction set. The scores are in `build/*/exact_scores.csv`.

{scores}
The worst errors came from these inputs (`%a`):

{inputs}
{builds}
## The price of exactness

The same queries on the same trees, with plain float tests in place of the exact ones (`bench/gamephys_float.cpp`).

{price}
## Beside others

{machine}

Written by `./bench.sh --report`: time of one operation and share of false answers on the same hard cases. The correct answer is known because the input consists of whole numbers, or because no ray leaves a closed surface.

{table}
[The report](report.md#hard-cases) draws these cases.

![Cost against false answers on hard cases](images/report_hard.png)
"""


def number(value):
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def table(head, right, rows):
    """Markdown; the columns from `right` on hold numbers."""
    lines = [head, ["---"] * right + ["---:"] * (len(head) - right)] + rows
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def score_tables(rows):
    """Scores of the usual build, the inputs of their worst errors, and a sum for each other build."""
    usual = [row for row in rows if row["build"] == "gcc optimised" and row["isa"] == "best"]
    scores, inputs = [], []
    for row in usual:
        worst = f"{float(row['worst']):.3g} of {float(row['bound']):g} {row['unit']}" if row["unit"] else ""
        scores.append([row["function"], f"{int(row['cases']):,}", row["false"], worst])
        if worst:
            inputs.append(f"- {row['function']}: `{row['input'].strip()}`\n")
    builds = {}
    for row in rows:
        if row not in usual:
            of = builds.setdefault((row["build"], row["isa"]), [0, 0, 0])
            of[0] += 1
            of[1] += int(row["cases"])
            of[2] += int(row["false"])
    others = [[build, isa, str(of[0]), f"{of[1]:,}", str(of[2])] for (build, isa), of in builds.items()]
    return (table(["function", "cases", "false answers", "worst error"], 1, scores), "".join(inputs),
            table(["other build", "instruction set", "functions", "cases", "false answers"], 2, others) if others else "")


def price_table(cases):
    rows = []
    for case, implementations in cases.items():
        by = {row["implementation"]: row for row in implementations}
        own, rough = by["gamephys"], by["gamephys_float"]
        times = float(own["value"]), float(rough["value"])
        rows.append([what(own), number(times[0]), number(times[1]), f"{times[0] / times[1]:.2f}", share(rough)])
    return table(["work", "gamephys, ns", "plain float tests, ns", "ratio", "their false answers"], 1, rows)


def what(row):
    return CASES[row["case"]].format(n=int(row["n"]))


def share(row):
    error = float(row["error"])
    return "0" if error == 0 else f"{100 * error:.3g} %"


def main():
    directory = pathlib.Path(sys.argv[1])
    cases = {}
    with (directory / "accuracy/accuracy.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            cases.setdefault(row["case"], []).append(row)
    lines = []
    for rows in cases.values():
        for i, row in enumerate(rows):
            first = what(row) if i == 0 else ""
            lines.append([first, shown(row["implementation"]), number(float(row["value"])), share(row)])
    with pathlib.Path(sys.argv[2]).open(newline="") as file:
        scores, inputs, builds = score_tables(list(csv.DictReader(file)))
    machine = "  \n".join((directory / "machine.txt").read_text().splitlines())
    measured = MEASURED.format(machine=machine, table=table(["work", "library", "ns", "false answers"], 2, lines), scores=scores, inputs=inputs,
                               builds=builds, price=price_table(cases))
    page = pathlib.Path(sys.argv[3])
    page.write_text(page.read_text().split("## Scores\n")[0] + measured)


main()
