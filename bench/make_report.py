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
from cases import CALLS
from cost_error import figure as cost_error_figure
from languages import languages
from marks import look
from panels import answer_panels, hard_panels, ordinary_panels, solver_panels, usual
from report import QUANTILES, latencies, linked_from, put_between, read, tables
from verdicts import against_fastest, against_most_exact, hard_input, sentences, summary, unstable_methods

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


PAGE = """# Report: speed against error

{machine}
Measured in: {minutes:.0f} minutes; load average of other programs up to {load:.1f}{busy}

Written by `./bench.sh --report{quick}`: in each part of the run the libraries did the same work, interleaved. Run it to regenerate this page for your machine.

## How to read the figures

Each panel is one kind of work. Points further left are faster, points lower down are more exact; both axes are logarithmic. The grey line is the Pareto front: the points that no other point beats in both respects. The band at the bottom, below the axis break, is *no error*. A point is the fastest repetition, and its bar the middle half of the repetitions; of the solver, a point is the median frame, and its bar the middle half of the frames. All times are of one thread, unless a label has a number of threads. "Distance only" is a call that returns no more than the distance. The number of objects is the measured one closest to 100,000; *Growth* shows how times grow with it, and *Every row* has all numbers.

## Ordinary work

The error is the largest relative error of a distance, in a sample compared with a loop in double precision. "0" means that every distance is the true one, rounded to float32. Libraries with wrong answers are in the next figure only: an error of distance would be meaningless for them. The error of a sweep is that of the part of the way. For capsules and boxes that are swept, and at convex hulls, it is the difference from gamephys, whose answers its tests compare with CGAL's.

![Cost against error, ordinary work](images/report_ordinary.png)

What one pays and gets:

{ordinary}
Here the error is the share of wrong answers: a false or missed hit, another model at another distance, or another number of models.

![Cost against wrong answers, ordinary work](images/report_answers.png)

{answers}
Work in which no library gave a wrong answer: {right}.

## Hard cases

On most of this input floating-point formulas fail; the first four panels show ordinary work for comparison. The error is the share of wrong answers: false or missed hits. The correct answer is known because the input consists of whole numbers, or because no ray leaves a closed surface.

![Cost against false answers, hard cases](images/report_hard.png)

{hard}
## The solver

The error is the largest strain of rigid links, the distance from a reference solution or the exact place, or the largest overlap; the cost is the time of a frame of 1/60 s. The number after a name is the number of substeps a frame, or of iterations for Bullet and Jakobsen; Bullet with substeps has ten iterations in each. The Euler schemes have springs for links, as stiff as the substep allows. Cloth that falls on a mesh has a number of substeps, with the strain at the end; or `max_strain`, with the largest strain of the whole run and the time of the mean or the longest frame. No other library of the comparison has such cloth.

![Cost against error, solver](images/report_solver.png)

{solver}
{unstable}
Energy over a million steps, beside the integrators of the *Game Physics Cookbook*. This figure does not depend on the machine; `./bench.sh energy` draws it.

![Energy over a million steps](images/energy.png)

## Growth

![Time of a ray against the number of boxes](images/report_growth.png)

## Latency

Each call is timed alone, in three runs, of which the fastest counts. So these are times of the calls themselves: interruptions by the machine, which lengthen the slowest calls of a running program, are left out. The figure shows the median, the times below which 99 % and 99.9 % of the calls stay, and the longest.

![Latency of single calls](images/report_latency.png)

## Languages

{languages}
## All kinds of work

gamephys compared with the fastest other library that gave no wrong answer, or with the fastest if each gave some: then its error is the share of them. Ratios are gamephys divided by the other: below 1 gamephys is faster, or more exact. The error is as in *Ordinary work*; it is empty where nothing is answered. Of solvers, which have several settings, the row has the most exact other and the fastest setting of gamephys that is as exact. Green is faster and at least as exact, red is slower or less exact.

{summary}
## Every row

The time of gamephys, and its ratio to that of each other library. † marks libraries whose answers differ from those of a loop over all objects in double precision.

gamephys is built with the flags that users get and called through its C interface, in batches where they exist. The time ends when the answers are in memory. The box tests that a user writes for Embree are compiled for this processor; Embree's packets have sixteen rays and its flag for coherent rays.

- Rays of a camera come in tiles of 8 by 8 pixels, or row by row. A mesh is queried by itself, or as the only model of a scene; other libraries use it without a scene.
- Memory is all that was allocated through the libraries' allocator hooks, plus the boxes that Embree's tests read.
- "Linear scan of blocks" tests a box around each 64 neighbouring boxes first.
- "Built anew" is a scene built from the same boxes in one batch, compared with one that grew or changed by single calls.
- "Without a filter" is the same query, compared with one that leaves out a model.
- "Multiplied vertices" is a mesh whose vertices were multiplied by the scale, compared with a model that has that scale. "As a mesh" means that the hulls are surface meshes, which have no inside.
- Independent threads have an equal part of the work each: the limit of the machine. Threads are those of gamephys: two, four and so on up to the number of processors. Culling, moving, saving and loading use one thread.

[What limits the speed](limits_of_speed.md) explains the rows in which gamephys is slower.

{rows}
An SVG of each figure is stored beside the PNG. [accuracy.md](accuracy.md) states the error bounds, [solver.md](solver.md) describes the solver's cases.
"""

# The part of the README between its marks.
README = """{machine}

{summary}
On hard input other libraries give wrong answers; the largest share is {others}, of {library} in *{title}*. gamephys gives {own}. In these panels it takes {least} to {most} times the time of the fastest other library: [each case](docs/report.md#hard-cases). Left is faster, down is more exact, and the band at the bottom is *no wrong answer*:

![Cost against false answers on hard cases: gamephys has {own}, the worst other {others}](docs/images/report_hard.png)

"""


def main():
    directory, page, images = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    images.mkdir(parents=True, exist_ok=True)
    plt.style.use(str(Path(__file__).parent / "figures/style.mplstyle"))
    suites, solver, seconds, load_average = load(directory)
    rows = {key: by for cases in suites.values() for key, by in cases.items()}
    (ordinary, ordinary_errors), (solver_work, solver_errors) = ordinary_panels(rows), solver_panels(solver)
    (answers, right), hard = answer_panels(rows), hard_panels(rows)
    if not (ordinary and latencies(suites) and solver_work):
        sys.exit("the measurements are not complete: run_report.py goes on with them")
    lost = cost_error_figure(images / "report_ordinary", ordinary, "ns per operation", ordinary_errors)
    lost += cost_error_figure(images / "report_answers", answers, "ns per operation", "wrong answers", percent=True)
    lost += cost_error_figure(images / "report_hard", hard, "ns per operation", "false answers", percent=True)
    lost += cost_error_figure(images / "report_solver", solver_work, "ms per frame", solver_errors)
    growth(rows, images / "report_growth")
    latency_figure(suites, images / "report_latency")
    if lost:
        sys.exit("no room for these labels:\n" + "\n".join(lost))
    machine = (directory / "machine.txt").read_text().splitlines()
    quick = any(line.startswith("Work: a part") for line in machine)
    busy = ", so times are too long and ratios less certain: repeat it on a quiet machine" if load_average > 0.7 * os.cpu_count() else ""
    text = PAGE.format(machine="  \n".join(machine) + "  ", minutes=math.ceil(seconds / 60), load=load_average, busy=busy,
                       quick=" --quick" if quick else "", summary=summary(rows, solver), languages=languages(directory, images),
                       ordinary=sentences(ordinary, ordinary_errors, against_fastest),
                       answers=sentences(answers, ["wrong answers"] * len(answers), against_fastest), right="; ".join(right) or "none",
                       hard=sentences(hard, ["false answers"] * len(hard), against_fastest),
                       solver=sentences(solver_work, solver_errors, against_most_exact), unstable=unstable_methods(solver),
                       rows=tables(suites, solver).replace("## ", "### "))
    page.write_text(linked_from(page, text))
    for readme in sys.argv[4:]:
        put_between(Path(readme), MARKS, "\n" + README.format(machine="  \n".join(machine), summary=summary(rows, solver), **hard_input(hard)))


main()
