#!/usr/bin/env python3
"""Ratios of a benchmark run: report.py DIRECTORY [--docs-solver]

Reads the CSV files of gamephys_bench in DIRECTORY and prints Markdown: for each suite a table of ratios, time of
gamephys / time of the other. --docs-solver prints docs/solver_figures.md instead: the rows of each solver.csv, with
machine.txt. Every number comes from those files.
"""
import csv
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "figures"))
from cases import CALLS, SOLVER, words
from marks import shown

SUITES = ["scene", "mesh", "query", "update", "accuracy"]
OTHERS = ["gamephys_fresh", "gamephys_plain", "gamephys_multiplied", "gamephys_mesh",
          "embree", "embree_robust", "embree_packets", "embree_packets_robust",
          "bullet", "fcl", "nanoflann", "simd_sweep", "simd_blocks"]
WRONG = ("WRONG_FRACTION", "DIFFERS")
TITLES = {"scene": "Rays at scenes", "mesh": "Meshes", "query": "Other queries", "update": "Scenes that change"}
QUANTILES = {"p50": "median", "p99": "99 % are shorter", "p99_9": "99.9 % are shorter", "max": "longest"}
# Calls that one thread answers.
ONE_THREAD = ("cull", "update_all", "update_some", "replace_some", "save_scene", "save_scene_bytes", "load_scene")

SOLVER_PAGE = """# Figures of the solver

{machine}

Written by `./bench.sh --report`. Each row is one case simulated by one method; [solver.md](solver.md) describes the cases.

- **substeps** are those of a 60 Hz frame; iterations for Bullet and Jakobsen.
- **ms a frame** is the processor time of the median frame. For one and several threads it is wall time; independent threads have a solver each, and the time is that of all together.
- **stretch** and **compression** are relative to the length of rigid links: the largest of the run for cases that begin in free space.
- The error of particles is the depth of the deepest one in a box or the ground at the end; that of the chain is the distance from a reference solution after a second; that of balls in a pit is the largest overlap of the run, and that of a rope over a post how far its heavier end is from the exact place after 0.6 s. Bullet with substeps makes as many steps a frame, of ten iterations each.
- Frames differ in length by a rounding error, so that every frame is computed. In the rows with steps of equal length, steps that would change nothing are skipped ([Steady bodies](solver/rest.md#steady-bodies)).
- Cloth within 2 % strain has `max_strain` set: the row has the mean of all frames of ten seconds and its average substeps, or the longest frame and the maximum of substeps.

"""


def read(directory):
    """{suite: {(case, n): {implementation: row}}} of the CSV files there and one folder below, in the order of the suites."""
    suites = {}
    for suite in SUITES:
        for path in sorted([*directory.glob(f"{suite}.csv"), *directory.glob(f"*/{suite}.csv")]):
            with path.open(newline="") as file:
                for row in csv.DictReader(file):
                    for field in ("value", "error", "lower_quartile", "median", "upper_quartile"):
                        row[field] = float(row[field] or 0)
                    suites.setdefault(suite, {}).setdefault((row["case"], int(row["n"])), {})[row["implementation"]] = row
    return suites


def number(value):
    """Three digits, without an exponent."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def rough(value):
    """An error, to two digits."""
    return f"{value:,.0f}" if value >= 10 else f"{value:.2g}"


def linked_from(page, text):
    """The text of docs/report.md for a page that may be in another folder: links to what only docs has lead there."""
    docs = pathlib.Path(__file__).resolve().parent.parent / "docs"

    def target(match):
        name = match[1]
        if (page.parent / name).exists() or not (docs / name).exists():
            return match[0]
        return f"]({os.path.relpath(docs / name, page.parent.resolve())}"
    return re.sub(r"\]\(([\w./]+)", target, text)


def put_between(page, marks, text):
    """Replaces what is between two marks of a page."""
    before, rest = page.read_text().split(marks[0])
    page.write_text(before + marks[0] + text + marks[1] + rest.split(marks[1])[1])


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1)] + rows
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def own_ratio(by, name):
    """The time of gamephys / that of another, with a mark where the other's answers differ."""
    if name not in by:
        return ""
    return number(by["gamephys"]["value"] / by[name]["value"]) + (" †" if by[name]["error_unit"] in WRONG and by[name]["error"] else "")


def ratios(cases):
    cases = {key: by for key, by in cases.items() if "gamephys" in by and not quantile(key[0])}
    others = [name for name in OTHERS if any(name in by for by in cases.values())]
    rows = [[words(case), f"{n:,}", f"{number(by['gamephys']['value'])} {by['gamephys']['unit']}", *(own_ratio(by, name) for name in others)]
            for (case, n), by in cases.items()]
    return table(["work", "objects", "gamephys", *map(shown, others)], rows) if rows else ""


def quantile(case):
    """(call, quantile) of a case that is a quantile of the times of single calls, or None."""
    return next(((case[:-len(end) - 1], end) for end in QUANTILES if case.endswith("_" + end)), None)


def latencies(suites):
    """{(call, n): {quantile: ns}}"""
    found = {}
    for (case, n), by in suites.get("update", {}).items():
        if quantile(case):
            call, end = quantile(case)
            found.setdefault((call, n), {})[end] = by["gamephys"]["value"]
    return found


def latency_table(suites):
    rows = [[CALLS.get(call, call), f"{n:,}", *(f"{number(times[end])} ns" for end in QUANTILES)]
            for (call, n), times in latencies(suites).items()]
    return table(["single call", "objects", *QUANTILES.values()], rows) if rows else ""


def thread_table(suites, solver):
    """The speed-up by several threads, beside that of as many independent threads: what the machine allows."""
    found = []  # (work, objects, {number of threads and how: speed-up})
    for cases in suites.values():
        for (case, n), by in cases.items():
            times = {name.removeprefix("gamephys_"): row["value"] for name, row in by.items()}
            if case not in ONE_THREAD:
                found.append((words(case), f"{n:,}", speed_ups(times, times.get("gamephys"))))
    ms = {}
    for row in solver:
        ms.setdefault(row["case"], {})[row["method"]] = float(row["ms"])
    found += [(SOLVER[case], "", speed_ups(times, times["1_thread"])) for case, times in ms.items() if "1_thread" in times]
    counts = sorted({count for *_, ups in found for count, _ in ups})
    columns = [(count, how) for count in counts for how in ("threads", "apart")]
    rows = [[work, n, *(number(ups[key]) if key in ups else "" for key in columns)] for work, n, ups in found if ups]
    heads = [f"{count} threads" if how == "threads" else f"{count} independent threads" for count, how in columns]
    return table(["speed-up of work", "objects", *heads], rows) if rows else ""


def speed_ups(times, one):
    """{(number of threads, "threads" or "apart"): how many times as fast as one}"""
    names = (re.fullmatch("([0-9]+)_(threads|apart)", name) for name in times)
    return {(int(name[1]), name[2]): one / times[name[0]] for name in names if name}


def tables(suites, solver=()):
    parts = [(title, ratios(suites.get(suite, {}))) for suite, title in TITLES.items()]
    parts += [("Single calls", latency_table(suites)), ("Several threads", thread_table(suites, solver))]
    return "".join(f"## {title}\n\n{rows}" for title, rows in parts if rows)


def solver_page(directory):
    def percent(text):
        return "unstable" if text == "inf" else f"{rough(100 * float(text))} %" if text else ""

    measured = []
    for path in directory.glob("*/solver.csv"):
        with path.open(newline="") as file:
            measured += csv.DictReader(file)
    order = list(SOLVER)
    measured.sort(key=lambda row: order.index(row["case"]))
    rows = [[SOLVER[row["case"]], shown(row["method"]), row["substeps"], number(float(row["ms"])), percent(row["strain_max"]),
             percent(row["compression_max"]), percent(row["strain_rms"]), row["position_error"]] for row in measured]
    machine = "  \n".join((directory / "machine.txt").read_text().splitlines())
    head = ["case", "method", "substeps", "ms a frame", "largest stretch", "largest compression", "rms strain", "error, m"]
    return SOLVER_PAGE.format(machine=machine) + table(head, rows).rstrip() + "\n"


def main():
    directory = pathlib.Path(sys.argv[1])
    if "--docs-solver" in sys.argv[2:]:
        print(solver_page(directory), end="")
        return
    print(tables(read(directory)), end="")


if __name__ == "__main__":
    main()
