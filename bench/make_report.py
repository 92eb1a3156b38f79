#!/usr/bin/env python3
"""The report from its measurements: make_report.py DIRECTORY PAGE IMAGES [README]

Reads what run_report.py measured in DIRECTORY, and machine.txt there; writes the page (Markdown), its figures (SVG
and PNG) into IMAGES, and the table of the README between the marks in that file. Every number comes from those files.
Fails if a label of a figure has no room.
"""
import csv
import json
import math
import os
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).parent / "figures"))
from cost_error import figure as cost_error_figure
from marks import look, shown
from report import number, read, table, tables

WRONG = ("WRONG_FRACTION", "DIFFERS", "FALSE_FRACTION")
# Panels of ordinary work: title, then (case, what its label says behind the name of the library).
ORDINARY = [
    ("A random ray at boxes", [("scene_ray_random", "batch"), ("scene_single_random", "")]),
    ("A ray of a camera at boxes", [("scene_ray_rows", "batch"), ("scene_single_rows", "")]),
    ("A ray at spheres", [("sphere_ray_random", "batch")]),
    ("A ray at copies of a mesh", [("instance_ray_random", "batch")]),
    ("A random ray at a mesh", [("mesh_ray_random", "batch"), ("mesh_single_random", "")]),
    ("The nearest box to a point", [("nearest_box", "batch")]),
    ("A segment at boxes", [("segment", "batch")]),
    ("A sphere swept at boxes", [("sweep_sphere", "batch")]),
]
HARD = {
    "boxes_random": "Random rays, many boxes", "leaks_near": "Rays out of a closed mesh",
    "leaks_far": "The same, 370 km from the origin", "leaks_slivers": "The same, triangles of 1e6 : 1",
    "ray_box_edges": "Rays at faces, edges and corners", "ray_sphere_tangent": "Tangents of a sphere from 1000 km",
    "sphere_touches_box": "Spheres that touch a corner",
}
SOLVER = {"chain_30": "Swinging chain: error after a second", "rope_1e3": "Rope of 1000 links, weight of 1000 links",
          "ropes_1000x30": "1000 ropes of 30 links", "cloth_100": "Cloth of 100 x 100 on two corners"}


# Rows of the summary: what it is, and the case.
SUMMARY = [
    ("a random ray at boxes, one call", "scene_single_random"),
    ("the same in a batch", "scene_ray_random"),
    ("a ray of a camera at boxes, one call", "scene_single_rows"),
    ("the same in a batch", "scene_ray_rows"),
    ("whether a random ray meets a box, one call", "scene_single_any"),
    ("the same in a batch", "scene_ray_any"),
    ("a random ray at spheres, in a batch", "sphere_ray_random"),
    ("a random ray at copies of a mesh, in a batch", "instance_ray_random"),
    ("a random ray at a mesh, by triangles, one call", "mesh_single_random"),
    ("the same in a batch", "mesh_ray_random"),
    ("the same, the mesh a model of a scene", "mesh_model_ray_random"),
    ("a ray of a camera at a mesh, in a batch", "mesh_ray_rows"),
    ("which boxes a sphere overlaps, in a batch", "overlap_sphere"),
    ("which boxes a box overlaps, in a batch", "overlap_box"),
    ("the nearest box to a point, in a batch", "nearest_box"),
    ("the nearest point to a point, in a batch", "nearest_point"),
    ("a segment at boxes, in a batch", "segment"),
    ("a sphere swept at boxes, in a batch", "sweep_sphere"),
    ("culling boxes, per box", "cull"),
    ("moving all boxes, per box", "update_all"),
    ("building a scene of boxes, per box", "build_scene"),
]
MARKS = ("<!-- summary: written by ./bench.sh --report -->\n", "<!-- end of summary -->\n")


def load(directory):
    """(rows of gamephys_bench by suite, rows of the solver, seconds, largest load)"""
    solver, seconds, load_average = [], 0.0, 0.0
    for part in sorted(directory.glob("*/took.json")):
        took = json.loads(part.read_text())
        seconds += took["seconds"]
        load_average = max(load_average, took["load"])
        if (part.parent / "solver.csv").exists():
            with (part.parent / "solver.csv").open(newline="") as file:
                solver += csv.DictReader(file)
    return read(directory), solver, seconds, load_average


def largest(rows, case):
    return max((n for name, n in rows if name == case), default=None)


def percent(share):
    return "0" if share == 0 else f"{100 * share:.2g} %"


def ordinary_panels(rows):
    """The panels, and a row for each library that gave wrong answers. Work that only gamephys does right has no panel:
    nothing would be compared there."""
    panels, wrong = [], []
    for title, cases in ORDINARY:
        points, n = [], 0
        for case, how in cases:
            n = largest(rows, case) or n
            for name, row in rows.get((case, n), {}).items():
                if name.startswith("gamephys_2") or row["unit"] != "ns":
                    continue
                own_batch = name == "gamephys" or "packets" in name
                singly = any(name in rows.get((other, largest(rows, other)), {}) for other, what in cases if not what)
                if how and singly and not own_batch:
                    continue  # a loop of single calls, which the other case has
                if row["error_unit"] in WRONG:
                    if row["error"]:
                        own = rows[case, n]["gamephys"]
                        wrong.append([title + (", " + how if how else ""), shown(name), f"{number(row['value'])} ns", percent(row["error"]),
                                      f"{number(own['value'])} ns", percent(own["error"]) if own["error_unit"] in WRONG else "0"])
                    continue
                points.append((row["value"], row["median"], row["error"], name, shown(name) + (f", {how}" if how and len(cases) > 1 and name == "gamephys" else "")))
        if any(not library.startswith("gamephys") for *_, library, _ in points):
            panels.append((f"{title} ({n:,})", points))
    return panels, wrong


def hard_panels(rows):
    panels = []
    for case, title in HARD.items():
        n = largest(rows, case)
        points = [(row["value"], row["median"], row["error"], name, shown(name)) for name, row in rows.get((case, n), {}).items()]
        if points:
            panels.append((title, points))
    return panels


def solver_panels(rows):
    panels = []
    for case, title in SOLVER.items():
        points = []
        for row in rows:
            if row["case"] != case or row["method"] == "2_apart":
                continue
            error = row["position_error"] if case == "chain_30" else row["strain_max"]
            if error:
                points.append((float(row["ms"]), 0, float(error), row["method"], f"{shown(row['method'])} {row['substeps']}"))
        if points:
            panels.append((title, points))
    return panels


def growth(rows, path):
    """Time of a ray against the number of boxes: single and batch, random and of a camera."""
    drawing, grid = plt.subplots(1, 2, figsize=(12, 4.3), layout="constrained", sharey=True)
    for axes, title, batch, single in ((grid[0], "Random rays", "scene_ray_random", "scene_single_random"),
                                       (grid[1], "Rays of a camera", "scene_ray_rows", "scene_single_rows")):
        for name in ("gamephys", "embree", "bullet"):
            for case, style, how in ((batch, "-", "batch"), (single, "--", "single calls")):
                if how == "batch" and name == "embree":
                    continue  # a loop of single calls
                points = sorted((n, by[name]["value"]) for (this, n), by in rows.items() if this == case and name in by)
                if points:
                    colour, marker = look(name)
                    axes.loglog(*zip(*points), style, marker=marker, color=colour, label=f"{shown(name)}, {how}",
                                markeredgecolor="white")
        axes.set_title(title, loc="left")
        axes.set_xlabel("boxes")
    grid[0].set_ylabel("ns per ray")
    grid[1].legend(loc="center left", bbox_to_anchor=(1, 0.5), handlelength=3.5)
    drawing.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    drawing.savefig(path.with_suffix(".png"))
    plt.close(drawing)


def summary(rows):
    """Each kind of work beside the fastest of the others that gives no false answer: time and error."""
    lines = []
    for what, case in SUMMARY:
        n = largest(rows, case)
        by = rows.get((case, n), {})
        others = {name: row for name, row in by.items() if not name.startswith("gamephys") and row["error_unit"] not in WRONG}
        if "gamephys" not in by or not others:
            continue
        own = by["gamephys"]
        name = min(others, key=lambda other: others[other]["value"])
        other = others[name]
        ratio = own["value"] / other["value"]
        checked = own["error_unit"] != "unchecked"
        exact = own["error"] <= other["error"]
        verdict = ("🟢 faster" if ratio <= 0.98 else "⚪ as fast" if ratio < 1.02 else "🔴 slower")
        if checked:
            verdict += ", more exact" if own["error"] < other["error"] else ", as exact" if exact else ", less exact"

        def error(row):
            return "" if not checked else "0" if row["error"] == 0 else f"{row['error']:.2g}"

        lines.append([what, f"{n:,}", f"{number(own['value'])} ns", shown(name), f"{number(other['value'])} ns", number(ratio),
                      error(own), error(other), verdict])
    return table(["work", "objects", "gamephys", "fastest other", "its time", "ratio", "our error", "its error", ""], lines)


def price(rows):
    """What one pays and gets, case by case, in sentences of the figures."""
    lines = []
    for case, title in HARD.items():
        by = rows.get((case, largest(rows, case)), {})
        others = {name: row for name, row in by.items() if not name.startswith("gamephys")}
        if "gamephys" not in by or not others:
            continue
        own = by["gamephys"]
        name = min(others, key=lambda other: others[other]["value"])
        ratio = own["value"] / others[name]["value"]
        same = own["error"] == others[name]["error"]
        get = "the same share" if same else f"{percent(own['error'])} instead of {percent(others[name]['error'])}"
        lines.append([title, shown(name), number(ratio), get])
    return table(["work", "fastest other", "time of gamephys / its time", "false answers"], lines)


PAGE = """# Report: speed against error

{machine}
Measured in: {minutes:.0f} minutes; load average of other programs up to {load:.1f}{busy}

Written by `./bench.sh --report{quick}`: all numbers and figures on this page are from one run, in which the libraries did the same work, interleaved. Run it on your machine to replace the page.

## How to read the figures

Each panel is one kind of work. Left is faster, down is more exact; both axes are logarithmic. The grey line is the Pareto front: the points that no other point beats in both. The band at the bottom, below the axis break, is *no error*. The bar to the right of a point reaches from the fastest repetition to the median. All times are of one thread.

## Ordinary work

The error is the largest relative error of a distance, in a sample compared with a loop in double precision. "0" means that every distance is the true one, rounded to float32.

![Cost against error, ordinary work](images/report_ordinary.png)

{wrong}## Hard cases

On this input floating-point formulas fail. The error is the share of wrong answers: a false hit or a missed one. The truth is known because the input consists of whole numbers, or because no ray leaves a closed surface.

![Cost against false answers, hard cases](images/report_hard.png)

The cost of exact answers, compared with the fastest other library:

{price}
## The solver

The error is the largest strain of rigid links, or the distance from a reference solution; the cost is the time of a frame of 1/60 s. The number after a name is the number of substeps a frame, or of iterations for Bullet and Jakobsen.

![Cost against error, solver](images/report_solver.png)

## Growth

![Time of a ray against the number of boxes](images/report_growth.png)

## All kinds of work

gamephys compared with the fastest other library that gave no wrong answer. The ratio is the time of gamephys divided by that of the other: below 1 gamephys is faster. The error is as in *Ordinary work*. An empty error means that nothing is answered, or that the answers are not distances and were all right.

{summary}
## Every row

The time of gamephys, and its ratio to that of each other library. † marks libraries whose answers differ from those of a loop over all objects in double precision.

gamephys is built with the flags that users get and called through its C interface, in batches where they exist. The time ends when the answers are in memory. The box tests that a user writes for Embree are compiled for this processor; Embree's packets have sixteen rays and its flag for coherent rays.

- `_camera` are the rays of an image in tiles of 8 by 8 pixels, `_rows` the same row by row, `_single_` calls for one ray each, `_miss` rays that point away from everything. `mesh_model_` are rays at a mesh that is the only model of a scene; other libraries have the mesh without a scene.
- Bytes are all memory allocated through the libraries' allocator hooks, plus the boxes that Embree's tests read; `memory_peak_` is the maximum during the build.
- `simd_blocks` is a linear scan over blocks of 64 neighbouring boxes, with a box around each block.
- `gamephys_fresh` is a scene built from the same boxes in one batch, compared with one that grew or changed by single calls (`after_`).
- `gamephys_plain` is the same query without a filter, compared with one that leaves out a model.
- `add_`, `churn_` and `latency_` are single calls, each the fastest of three runs, with the default allocator: the median, the 99th and 99.9th percentile, and the longest.
- `gamephys_2_apart` are two independent threads, each with half of the queries: the limit of the machine.

[What limits the speed](limits_of_speed.md) explains the rows in which gamephys is slower.

{rows}
Each figure exists as SVG, too, beside the PNG. [accuracy.md](accuracy.md) has the promises, [solver.md](solver.md) the solver's cases.
"""

WRONG_ANSWERS = """These libraries are not drawn, because some of their answers were wrong: a false or missed hit, another model at another distance, or another number of models. An error of distance would be meaningless for them.

"""


def put_summary(readme, text):
    before, rest = readme.read_text().split(MARKS[0])
    readme.write_text(before + MARKS[0] + "\n" + text + MARKS[1] + rest.split(MARKS[1])[1])


def main():
    directory, page, images = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    images.mkdir(parents=True, exist_ok=True)
    plt.style.use(str(Path(__file__).parent / "figures/style.mplstyle"))
    suites, solver, seconds, load_average = load(directory)
    rows = {key: by for cases in suites.values() for key, by in cases.items()}
    ordinary, wrong = ordinary_panels(rows)
    lost = cost_error_figure(images / "report_ordinary", ordinary, "ns per operation", "largest relative error")
    lost += cost_error_figure(images / "report_hard", hard_panels(rows), "ns per operation", "false answers", percent=True)
    solver_work = solver_panels(solver)
    if not (ordinary and rows and solver_work):
        sys.exit("the measurements are not complete: run_report.py goes on with them")
    lost += cost_error_figure(images / "report_solver", solver_work, "ms per frame",
                              ["distance, m" if "chain" in title else "largest strain" for title, _ in solver_work])
    growth(rows, images / "report_growth")
    if lost:
        sys.exit("no room for these labels:\n" + "\n".join(lost))
    machine = (directory / "machine.txt").read_text().splitlines()
    quick = any(line.startswith("Work: a part") for line in machine)
    busy = ", so times are too long and ratios less certain: repeat it on a quiet machine" if load_average > 0.7 * os.cpu_count() else ""
    wrong_table = WRONG_ANSWERS + table(["work", "library", "time", "wrong answers", "gamephys", "wrong answers"], wrong) + "\n" if wrong else ""
    page.write_text(PAGE.format(machine="  \n".join(machine) + "  ", minutes=math.ceil(seconds / 60), load=load_average, busy=busy,
                                quick=" --quick" if quick else "", wrong=wrong_table, price=price(rows), summary=summary(rows),
                                rows=tables(suites).replace("## ", "### ")))
    for readme in sys.argv[4:]:
        put_summary(Path(readme), "  \n".join(machine) + "\n\n" + summary(rows))


main()
