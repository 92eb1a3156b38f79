#!/usr/bin/env python3
"""Ratios of a benchmark run: report.py DIRECTORY [--docs | --docs-solver | --summary README]

Reads the CSV files of gamephys_bench and machine.txt in DIRECTORY and prints Markdown: for each
suite a table of ratios, time of gamephys / time of the other. --docs puts the page of
docs/benchmarks.md around it. --docs-solver prints docs/solver_figures.md alone: the rows of solver.csv.
--summary puts the table of the README between the marks in that file.
Every number comes from those files.
"""
import csv
import pathlib
import sys

SUITES = ["scene", "mesh", "query", "update"]
OTHERS = ["gamephys_fresh", "gamephys_plain", "embree", "embree_robust", "embree_packets", "embree_packets_robust", "bullet", "fcl", "nanoflann", "simd_sweep", "simd_blocks"]
WRONG = ("WRONG_FRACTION", "DIFFERS")

PAGE = """# Benchmarks

{machine}

Written by `./bench.sh scene mesh query update --peers --docs`, which measures all libraries in one run on the same work, in interleaved repetitions of which the fastest counts. gamephys is built with the flags that users get and called through its C interface, in batches where there are some. The time ends when the answers are in memory. Times are of one thread unless the row says otherwise.

A ratio is the time of gamephys divided by that of the other: below 1, gamephys is faster. † marks those whose answers are not those of a loop over everything in double precision. `_rows` are the rays of `_camera` as its picture is stored, row by row; those are in tiles of 8 by 8 pixels. `_single_` are calls for one ray each, `_miss` rays that point away from everything, `mesh_model_` rays at a mesh that is the one model of a scene, beside others that have the mesh without a scene. Embree's packets are of sixteen rays with its flag for coherent ones; what a user writes for Embree, the tests of boxes, is compiled for this processor. Bytes are all that is allocated, by the allocators that the libraries offer, and the boxes that Embree's tests read; `memory_peak_` is the most while it is built. `simd_blocks` is a sweep over blocks of 64 boxes that are near each other, with a box around each. `gamephys_fresh` is a scene built of the same boxes in one batch, beside one that was added to or changed a call at a time (`after_`). `add_`, `churn_` and `latency_` are single calls, the fastest of three runs of each, and of all of a row those that a half, 99 % and 99.9 % of them do not exceed, and the longest; the library's own allocator serves them. `gamephys_2_apart` are two independent threads, each with half of the queries: what the machine allows. [What limits the speed](limits_of_speed.md) has the profiles of rows in which gamephys is not as far ahead as was aimed for.

![Time of a ray against the number of boxes](images/growth.png)

"""


SOLVER_PAGE = """# Figures of the solver

{machine}

Written by `./bench.sh solver --peers --docs`. A row is a case moved by a method in so many substeps a 60 Hz frame (iterations, of Bullet and Jakobsen). A frame is the median of processor time, by the clock for cases of threads, where `2_apart` are two threads with a solver of their own each, what both make together: two that have nothing to tell each other; stretch and compression are by how much rigid links are too long and too short, over the whole run for those that begin in free space. [solver.md](solver.md) says what the cases are. `free_...` are particles that rain on boxes: all fly, land, or lie, and the mean of three seconds; their error is how deep the deepest is in a box or the ground at the end. `drape_within_2_percent` is `drape_over_mesh` with `max_strain` set to 2 %, over ten seconds: the mean of all frames, or the longest of them, beside the substeps that they took on average, or at most.

"""


def read(directory):
    """{suite: {(case, n): {implementation: row}}}, in the order of the files."""
    suites = {}
    for suite in SUITES:
        path = directory / f"{suite}.csv"
        if not path.exists():
            continue
        cases = suites.setdefault(suite, {})
        with path.open(newline="") as file:
            for row in csv.DictReader(file):
                row["value"] = float(row["value"])
                cases.setdefault((row["case"], int(row["n"])), {})[row["implementation"]] = row
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
MARKS = ("<!-- summary: written by ./bench.sh --docs -->\n", "<!-- end of summary -->\n")


def summary(suites):
    """At the largest number of objects, beside the fastest of the others that does not give wrong answers."""
    cases = {key: by for suite in suites.values() for key, by in suite.items()}
    rows = []
    for what, case in SUMMARY:
        n = max((count for name, count in cases if name == case), default=0)
        by = cases.get((case, n), {})
        others = {name: by[name] for name in OTHERS if name in by and by[name]["error_unit"] not in WRONG}
        if "gamephys" not in by or not others:
            continue
        fastest = min(others, key=lambda name: others[name]["value"])
        ratio = by["gamephys"]["value"] / others[fastest]["value"]
        verdict = "ahead" if ratio <= 0.98 else "behind" if ratio >= 1.02 else "level"

        def error(row):
            return "" if row["error_unit"] == "unchecked" else "0" if float(row["error"]) == 0 else row["error"]

        rows.append([what, f"{n:,}", f"{number(by['gamephys']['value'])} ns", f"`{fastest}`", number(ratio), verdict,
                     error(by["gamephys"]), error(others[fastest])])
    return table(["work", "objects", "gamephys", "fastest other", "ratio", "gamephys is", "its error", "of the other"], rows)


def put_summary(path, suites, machine):
    text = path.read_text()
    before, rest = text.split(MARKS[0])
    path.write_text(before + MARKS[0] + "\n" + machine + "\n\n" + summary(suites) + MARKS[1] + rest.split(MARKS[1])[1])


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
    suites = read(directory)
    if "--summary" in sys.argv[2:]:
        put_summary(pathlib.Path(sys.argv[3]), suites, "  \n".join((directory / "machine.txt").read_text().splitlines()))
        return
    if "--docs" in sys.argv[2:]:
        machine = (directory / "machine.txt").read_text().splitlines()
        print(PAGE.format(machine="  \n".join(machine)), end="")
    for suite, cases in suites.items():
        print(f"## {suite}\n\n{ratios(cases)}", end="")
    if within(suites):
        print(f"## One thread and two, and other ratios of our own\n\n{within(suites)}", end="")


if __name__ == "__main__":
    main()
