#!/usr/bin/env python3
"""Ratios of a benchmark run: report.py DIRECTORY [--docs-solver]

Reads the CSV files of gamephys_bench in DIRECTORY and prints Markdown: for each suite a table of ratios, time of
gamephys / time of the other. --docs-solver prints docs/solver_figures.md instead: the rows of solver.csv, with
machine.txt. Every number comes from those files.
"""
import csv
import pathlib
import sys

SUITES = ["scene", "mesh", "query", "update", "accuracy"]
OTHERS = ["gamephys_fresh", "gamephys_plain", "embree", "embree_robust", "embree_packets", "embree_packets_robust", "bullet", "fcl", "nanoflann", "simd_sweep", "simd_blocks"]
WRONG = ("WRONG_FRACTION", "DIFFERS")

SOLVER_PAGE = """# Figures of the solver

{machine}

Written by `./bench.sh solver --peers --docs`. A row is a case moved by a method; [solver.md](solver.md) describes the cases.

- **substeps** are those of a 60 Hz frame; iterations for Bullet and Jakobsen.
- **ms a frame** is the processor time of the median frame. For cases of threads it is wall time; `2_apart` are two independent threads with a solver each, and the time is that of both together.
- **stretch** and **compression** are relative to the length of rigid links: the largest of the run for cases that begin in free space.
- `free_...` are particles that rain on boxes: all fly, land, or lie, and the mean of three seconds. Their error is the depth of the deepest particle in a box or the ground at the end.
- `drape_within_2_percent` is `drape_over_mesh` with `max_strain` set to 2 %, over ten seconds: the mean of all frames and its average substeps, or the longest frame and the maximum of substeps.

"""


def read(directory):
    """{suite: {(case, n): {implementation: row}}} of the CSV files there and one folder below, in the order of the suites."""
    suites = {}
    for suite in SUITES:
        for path in sorted([*directory.glob(f"{suite}.csv"), *directory.glob(f"*/{suite}.csv")]):
            with path.open(newline="") as file:
                for row in csv.DictReader(file):
                    for field in ("value", "error", "median"):
                        row[field] = float(row[field] or 0)
                    suites.setdefault(suite, {}).setdefault((row["case"], int(row["n"])), {})[row["implementation"]] = row
    return suites


def number(value):
    """Three digits, without an exponent."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1)] + rows
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def ratios(cases):
    others = [name for name in OTHERS if any(name in case for case in cases.values())]
    rows = []
    for (case, n), by in cases.items():
        if "gamephys" not in by:
            continue
        own = by["gamephys"]
        row = [f"`{case}`", f"{n:,}", f"{number(own['value'])} {own['unit']}"]
        for name in others:
            if name in by:
                mark = " †" if by[name]["error_unit"] in WRONG else ""
                row.append(number(own["value"] / by[name]["value"]) + mark)
            else:
                row.append("")
        rows.append(row)
    return table(["case", "objects", "gamephys"] + others, rows)


def within(suites):
    """gamephys beside itself."""
    rows = []

    def compare(what, suite, case, name, other_case, other_name, invert=False):
        for (this, n), by in suites.get(suite, {}).items():
            other = suites[suite].get((other_case, n), {}).get(other_name)
            if this == case and name in by and other:
                ratio = by[name]["value"] / other["value"]
                apart = by.get("gamephys_2_apart") if invert else None
                rows.append([what, f"{n:,}", number(1 / ratio if invert else ratio),
                             number(other["value"] / apart["value"]) if apart else ""])

    compare("any hit / closest hit", "scene", "scene_ray_any", "gamephys", "scene_ray_random", "gamephys")
    compare("rays after 100 frames of motion / after a build", "update", "ray_after_update", "gamephys",
            "ray_after_update", "gamephys_fresh")
    for suite, cases in suites.items():
        for case in dict.fromkeys(case for case, _ in cases):
            if case != "cull":  # a single call, which one thread answers
                compare(f"speed-up of `{case}` by a second thread", suite, case, "gamephys_2_threads", case,
                        "gamephys", invert=True)
    return table(["gamephys beside itself", "objects", "ratio", "two callers apart"], rows) if rows else ""


def tables(suites):
    text = "".join(f"## {suite}\n\n{ratios(cases)}" for suite, cases in suites.items() if suite != "accuracy")
    own = within(suites)
    return text + (f"## gamephys compared with itself\n\n{own}" if own else "")


def solver_page(directory):
    def percent(text):
        return f"{100 * float(text):.2g} %" if text else ""

    with (directory / "solver.csv").open(newline="") as file:
        rows = [[f"`{row['case']}`", row["method"], row["substeps"], number(float(row["ms"])),
                 percent(row["strain_max"]), percent(row["compression_max"]), percent(row["strain_rms"]), row["position_error"]]
                for row in csv.DictReader(file)]
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
