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
from matplotlib.ticker import FuncFormatter

sys.path.insert(0, str(Path(__file__).parent / "figures"))
from cases import CALLS, HARD
from cost_error import figure as cost_error_figure
from marks import look, shown
from report import QUANTILES, latencies, number, read, table, tables

WRONG = ("WRONG_FRACTION", "DIFFERS", "FALSE_FRACTION")
# Panels of ordinary work: title, then (case, what its label says behind the name of the library).
ORDINARY = [
    ("A random ray at boxes", [("scene_ray_random", "batch"), ("scene_single_random", "")]),
    ("A ray of a camera at boxes", [("scene_ray_rows", "batch"), ("scene_single_rows", "")]),
    ("A ray at spheres", [("sphere_ray_random", "batch")]),
    ("A ray at copies of a mesh", [("instance_ray_random", "batch")]),
    ("A random ray at a mesh", [("mesh_ray_random", "batch"), ("mesh_single_random", "")]),
    ("A ray of a camera at a mesh", [("mesh_ray_rows", "batch"), ("mesh_single_rows", "")]),
    ("The nearest box to a point", [("nearest_box", "batch")]),
    ("A segment at boxes", [("segment", "batch")]),
]
# Panels of the share of wrong answers. Where the answer is a number of models, the error is that share already.
ANSWERS = [
    ("A random ray at boxes", "scene_ray_random"), ("A ray at spheres", "sphere_ray_random"), ("A ray at convex hulls", "hull_ray_random"),
    ("A segment at boxes", "segment"), ("Which boxes a sphere overlaps", "overlap_sphere"), ("Which boxes a box overlaps", "overlap_box"),
    ("Which hulls contain a point", "hull_contains"), ("Culling, per box", "cull"), ("A sphere swept at boxes", "sweep_sphere"),
    ("A capsule swept at boxes", "sweep_capsule"), ("A box swept at boxes", "sweep_box"), ("A capsule swept at convex hulls", "hull_sweep_capsule"),
]
COUNTED = ("overlap_sphere", "overlap_box", "hull_contains", "cull")
SOLVER = {"chain_30": "Swinging chain: error after a second", "rope_1e3": "Rope of 1000 links, weight of 1000 links",
          "ropes_1000x30": "1000 ropes of 30 links", "cloth_100": "Cloth of 100 x 100 on two corners",
          "cloth_100_bend": "The cloth, stiff against bending", "free_100k_landing": "100,000 particles landing on boxes"}
# The error of a panel of the solver, if it is not the strain: the column, and the label of the axis.
SOLVER_ERRORS = {"chain_30": ("position_error", "distance, m"), "free_100k_landing": ("position_error", "depth in a box, m")}


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


def usual(rows, case):
    """Of the numbers of objects that were measured, the one nearest to 100,000."""
    return min((n for name, n in rows if name == case), key=lambda n: abs(math.log(n / 100000)), default=None)


def percent(share):
    return "0" if share == 0 else f"{100 * share:.2g} %"


def ordinary_panels(rows):
    """Libraries with wrong answers are left out: an error of distance would be meaningless for them. So is work where
    nobody else is left."""
    panels = []
    for title, cases in ORDINARY:
        points, n = [], 0
        for case, how in cases:
            n = usual(rows, case) or n
            for name, row in rows.get((case, n), {}).items():
                if name.startswith("gamephys_") or row["unit"] != "ns" or row["error_unit"] in WRONG:
                    continue
                own_batch = name == "gamephys" or "packets" in name
                singly = any(name in rows.get((other, usual(rows, other)), {}) for other, what in cases if not what)
                if how and singly and not own_batch:
                    continue  # a loop of single calls, which the other case has
                points.append((row["value"], row["median"], row["error"], name, shown(name) + (f", {how or 'one call'}" if len(cases) > 1 and name == "gamephys" else "")))
        if any(library != "gamephys" for *_, library, _ in points):
            panels.append((f"{title} ({n:,})", points))
    return panels


def answer_panels(rows):
    panels = []
    for title, case in ANSWERS:
        n = usual(rows, case)
        points = [(row["value"], row["median"], row["error"] if case in COUNTED or row["error_unit"] in WRONG else 0, name, shown(name))
                  for name, row in rows.get((case, n), {}).items() if not name.startswith("gamephys_") and "packets" not in name]
        if len(points) > 1:
            panels.append((f"{title} ({n:,})", points))
    return panels


def hard_panels(rows):
    panels = []
    for case, title in HARD.items():
        n = usual(rows, case)
        points = [(row["value"], row["median"], row["error"], name, shown(name)) for name, row in rows.get((case, n), {}).items()]
        if points:
            panels.append((title, points))
    return panels


def solver_panels(rows):
    """(panels, the labels of their error axes)"""
    panels, labels = [], []
    for case, title in SOLVER.items():
        column, label = SOLVER_ERRORS.get(case, ("strain_max", "largest strain"))
        points = [(float(row["ms"]), 0, float(row[column]), row["method"], f"{shown(row['method'])} {row['substeps']}")
                  for row in rows if row["case"] == case and row[column]]
        if points:
            panels.append((title, points))
            labels.append(label)
    return panels, labels


def save(drawing, path):
    drawing.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    drawing.savefig(path.with_suffix(".png"))
    plt.close(drawing)


def growth(rows, path):
    """Time of a ray against the number of boxes: single calls and batches, random rays and those of a camera."""
    lines = [("gamephys", "batch", "-", "gamephys, batch"), ("gamephys", "single", "--", "gamephys, single calls"),
             ("embree", "single", "--", "Embree, single calls"), ("embree_packets", "batch", "-", "Embree, packets"),
             ("bullet", "batch", "--", "Bullet, single calls")]
    drawing, grid = plt.subplots(1, 2, figsize=(12, 4.3), layout="constrained", sharey=True)
    legend = {}
    for axes, title, of in ((grid[0], "Random rays", {"batch": "scene_ray_random", "single": "scene_single_random"}),
                            (grid[1], "Rays of a camera", {"batch": "scene_ray_rows", "single": "scene_single_rows"})):
        for name, how, style, label in lines:
            points = sorted((n, by[name]["value"]) for (this, n), by in rows.items() if this == of[how] and name in by)
            if points:
                colour, marker = look(name)
                legend[label], = axes.loglog(*zip(*points), style, marker=marker, color=colour, markeredgecolor="white")
        axes.set_title(title, loc="left")
        axes.set_xlabel("boxes")
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    grid[0].set_ylabel("ns per ray")
    grid[1].legend(legend.values(), legend, loc="center left", bbox_to_anchor=(1, 0.5), handlelength=3.5)
    save(drawing, path)


def latency_figure(suites, path):
    """The distribution of the times of single calls, at the usual number of objects."""
    found = latencies(suites)
    n = usual(found, next(iter(found))[0])
    calls = [call for call in CALLS if (call, n) in found][::-1]
    drawing, axes = plt.subplots(figsize=(12, 0.5 * len(calls) + 1.2), layout="constrained")
    shades = dict(zip(QUANTILES, ("#D55E00", "#E69F00", "#56B4E9", "#0072B2")))
    for y, call in enumerate(calls):
        times = found[call, n]
        axes.plot([times["p50"], times["max"]], [y, y], color="#bbbbbb", zorder=1)
        for end, marker in zip(QUANTILES, "osD^"):
            axes.plot([times[end]], [y], marker, color=shades[end], markeredgecolor="white", label=QUANTILES[end] if y == 0 else None)
    axes.set_xscale("log")
    axes.set_yticks(range(len(calls)), [CALLS[call] for call in calls])
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value / 1000:,g} µs"))
    axes.set_title(f"One call among {n:,} boxes", loc="left")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    save(drawing, path)


def summary(rows):
    """Each kind of work beside the fastest of the others that gives no false answer: time and error."""
    lines = []
    for what, case in SUMMARY:
        n = usual(rows, case)
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
        by = rows.get((case, usual(rows, case)), {})
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

Written by `./bench.sh --report{quick}`: in each part of the run the libraries did the same work, interleaved. Run it on your machine to replace the page.

## How to read the figures

Each panel is one kind of work. Left is faster, down is more exact; both axes are logarithmic. The grey line is the Pareto front: the points that no other point beats in both. The band at the bottom, below the axis break, is *no error*. The bar to the right of a point reaches from the fastest repetition to the median. All times are of one thread. The number of objects is the measured one that is nearest to 100,000; the growth of times with it is in a figure of its own, and *Every row* has all numbers.

## Ordinary work

The error is the largest relative error of a distance, in a sample compared with a loop in double precision. "0" means that every distance is the true one, rounded to float32. Libraries with wrong answers are in the next figure only: an error of distance would be meaningless for them.

![Cost against error, ordinary work](images/report_ordinary.png)

Here the error is the share of wrong answers: a false or missed hit, another model at another distance, or another number of models.

![Cost against wrong answers, ordinary work](images/report_answers.png)

## Hard cases

On most of this input floating-point formulas fail; the first four panels are plain work beside it. The error is the share of wrong answers: a false hit or a missed one. The truth is known because the input consists of whole numbers, or because no ray leaves a closed surface.

![Cost against false answers, hard cases](images/report_hard.png)

The cost of exact answers, compared with the fastest other library:

{price}
## The solver

The error is the largest strain of rigid links, or the distance from a reference solution; the cost is the time of a frame of 1/60 s. The number after a name is the number of substeps a frame, or of iterations for Bullet and Jakobsen.

![Cost against error, solver](images/report_solver.png)

Energy over a million steps, beside the integrators of the *Game Physics Cookbook*. This figure does not depend on the machine; `./bench.sh energy` draws it.

![Energy over a million steps](images/energy.png)

## Growth

![Time of a ray against the number of boxes](images/report_growth.png)

## Latency

Each call is timed alone, in three runs, of which the fastest counts: the median, the times below which 99 % and 99.9 % of the calls stay, and the longest.

![Latency of single calls](images/report_latency.png)

## All kinds of work

gamephys compared with the fastest other library that gave no wrong answer. The ratio is the time of gamephys divided by that of the other: below 1 gamephys is faster. The error is as in *Ordinary work*. An empty error means that nothing is answered, or that the answers are not distances and were all right.

{summary}
## Every row

The time of gamephys, and its ratio to that of each other library. † marks libraries whose answers differ from those of a loop over all objects in double precision.

gamephys is built with the flags that users get and called through its C interface, in batches where they exist. The time ends when the answers are in memory. The box tests that a user writes for Embree are compiled for this processor; Embree's packets have sixteen rays and its flag for coherent rays.

- Rays of a camera come in tiles of 8 by 8 pixels, or row by row. A mesh is taken by itself, or as the only model of a scene; other libraries have it without a scene.
- Memory is all that was allocated through the libraries' allocator hooks, plus the boxes that Embree's tests read.
- "Linear scan of blocks" tests a box around each 64 neighbouring boxes first.
- "Built anew" is a scene built from the same boxes in one batch, compared with one that grew or changed by single calls.
- "Without a filter" is the same query, compared with one that leaves out a model.
- "Multiplied vertices" is a mesh whose vertices were multiplied by the scale, compared with a model that has that scale. "As a mesh" are the hulls as meshes, which have no inside.
- "Two independent threads" each have half of the work: the limit of the machine. Culling, moving, saving and loading use one thread.

What a call costs from each language is in [bindings.md](bindings.md).

[What limits the speed](limits_of_speed.md) explains the rows in which gamephys is slower.

{rows}
Each figure exists as SVG, too, beside the PNG. [accuracy.md](accuracy.md) has the promises, [solver.md](solver.md) the solver's cases.
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
    ordinary, (solver_work, solver_errors) = ordinary_panels(rows), solver_panels(solver)
    if not (ordinary and latencies(suites) and solver_work):
        sys.exit("the measurements are not complete: run_report.py goes on with them")
    lost = cost_error_figure(images / "report_ordinary", ordinary, "ns per operation", "largest relative error")
    lost += cost_error_figure(images / "report_answers", answer_panels(rows), "ns per operation", "wrong answers", percent=True)
    lost += cost_error_figure(images / "report_hard", hard_panels(rows), "ns per operation", "false answers", percent=True)
    lost += cost_error_figure(images / "report_solver", solver_work, "ms per frame", solver_errors)
    growth(rows, images / "report_growth")
    latency_figure(suites, images / "report_latency")
    if lost:
        sys.exit("no room for these labels:\n" + "\n".join(lost))
    machine = (directory / "machine.txt").read_text().splitlines()
    quick = any(line.startswith("Work: a part") for line in machine)
    busy = ", so times are too long and ratios less certain: repeat it on a quiet machine" if load_average > 0.7 * os.cpu_count() else ""
    page.write_text(PAGE.format(machine="  \n".join(machine) + "  ", minutes=math.ceil(seconds / 60), load=load_average, busy=busy,
                                quick=" --quick" if quick else "", price=price(rows), summary=summary(rows),
                                rows=tables(suites, solver).replace("## ", "### ")))
    for readme in sys.argv[4:]:
        put_summary(Path(readme), "  \n".join(machine) + "\n\n" + summary(rows))


main()
