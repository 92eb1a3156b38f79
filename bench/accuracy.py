#!/usr/bin/env python3
"""The page docs/accuracy.md from a run of the accuracy suite: accuracy.py DIRECTORY SCORES

Reads accuracy.csv and machine.txt in DIRECTORY, and SCORES as scores.py writes it. Every measured
number comes from them.
"""
import csv
import pathlib
import sys

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

PAGE = """# Accuracy

Answers refer to the exact objects that the float bits of the input denote. W is the largest coordinate of the input, S the largest coordinate difference, D the distance, an ulp that of float32. Sets are closed: touching counts. Where a band is named, an answer may be wrong only for input that closer to the border than the band; where none is, there is no false answer.

| function | bound | band | method |
|---|---|---|---|
| containment in sphere, capsule, AABB, plane, triangle, segment, ray, frustum | 0 false | | exact signs: Shewchuk 1997 |
| containment in an OBB; within a tolerance of an OBB | 0 false beyond the band | 2^-40 S | axes of the rotation in double |
| within a tolerance of the others | 0 false beyond the band | 2^-46 S | squared distances in double, relative to the point |
| triangle, AABB, frustum, plane among each other | 0 false | | Guigue and Devillers 2003; Akenine-Moeller 2001; points and proofs of emptiness guessed in double (Matousek, Sharir, Welzl 1996), then decided by exact signs, else Helly and Farkas on exact determinants |
| sphere or capsule with AABB or triangle | 0 false beyond the band | 2^-48 S | Arvo 1990; Ericson 2005 |
| pairs with an OBB | 0 false beyond the band | 2^-40 S | Gottschalk 1996 |
| ray with sphere | 0 false; t within 1 ulp | | exact sign of the discriminant; the root that adds numbers of one sign: Haines, Guenther, Akenine-Moeller 2019 |
| ray with capsule | 0 false beyond the band; t within 1 ulp | 2^-48 D | the same for the cylinder between the ends |
| ray with AABB, plane | 0 false; t within 1 ulp | | slabs by division: Williams et al. 2005; products where quotients are too close |
| ray with triangle | 0 false; t within 1 ulp | | Woop, Benthin, Wald 2013; where that is not certain, volumes in 128-bit integers or expansions (Shewchuk 1997) |
| ray with OBB | 0 false beyond the band; t within 1 ulp of a time at which the band is crossed | 2^-40 S | Majercik et al. 2018, in double |
| ray with mesh, alone or as an instance in a scene | no leak through edges and vertices | | the triangle's; trees are walked with a margin |
| sphere sweep | 0 false beyond the band; t within 1 ulp of a time at which the band is crossed | 2^-40 S | rays against the grown shape |
| closest point | 1 ulp of W on each axis | | Ericson 2005, in double, relative to the point |
| distance | 1 ulp + 2^-40 S | | the same |
| camera: project | 1e-3 pixel + 1 ulp; depth 4 * 2^-24 + 1 ulp | | camera basis and tangents, in double: Upchurch and Desbrun 2012 |
| camera: unproject | 2 ulps of W on each axis | | the same |
| camera: pick | the first hit of the exact line of sight; t within 1 ulp and the band | an angle of 2^-46 | the double ray of the pixel, never rounded to float |
| camera: pick ray as floats | 1e-3 pixel, or half an ulp of the direction where the field of view is below about 3 degrees | | |

`tests_cpp/exact` holds each line against arithmetic that is not ours (CGAL's exact kernel, linear and quadratic programs, MPFR with 300 digits), on whole numbers, coordinates moved by an ulp, slivers, tangents, shapes far out and below the smallest normal float, and shows that each check notices a spoiled function. `ctest -R exact: -V` prints the score of each function.

Coordinates beyond some kilometres: see `gphys_scene_set_origin`, which keeps places in double precision.

Scene and mesh queries compute their distances in double precision from absolute coordinates: theirs are within 1 ulp + 2^-52 W.

## Scores

Of runs of the exact suite, added up by `bench/scores.py`. `./test.sh --long` asks all: 10 million cases of each function that says yes or no, a million of closest points, sweeps and cameras, and 120 million rays out of closed meshes, which takes about an hour of a processor; and a short form with gcc and clang, unoptimised and for Haswell, on each instruction set. Its scores are in `build/*/exact_scores.csv`.

{scores}
The worst errors came from these inputs (`%a`):

{inputs}
{builds}
## The price of exactness

`gamephys_float` asks the same queries of the same trees with plain float tests in place of the exact ones (`bench/gamephys_float.cpp`).

{price}
## Beside others

{machine}

Written by `./bench.sh accuracy --peers --docs`: time of one operation and share of false answers on the same hard cases. The truth is known from whole numbers, or because no ray leaves a closed surface.

{table}
{plots}
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
    return table(["case", "gamephys, ns", "gamephys_float, ns", "ratio", "its false answers"], 1, rows)


def what(row):
    return CASES[row["case"]].format(n=int(row["n"]))


def share(row):
    error = float(row["error"])
    return "0" if error == 0 else f"{100 * error:.3g} %"


def main():
    directory = pathlib.Path(sys.argv[1])
    cases = {}
    with (directory / "accuracy.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            cases.setdefault(row["case"], []).append(row)
    lines = []
    for case, rows in cases.items():
        for i, row in enumerate(rows):
            first = f"`{case}`: {what(row)}" if i == 0 else ""
            lines.append([first, row["implementation"], number(float(row["value"])), share(row)])
    with pathlib.Path(sys.argv[2]).open(newline="") as file:
        scores, inputs, builds = score_tables(list(csv.DictReader(file)))
    plots = "\n".join(f"![{what(rows[0])}](images/accuracy_{case}.png)" for case, rows in cases.items())
    machine = "  \n".join((directory / "machine.txt").read_text().splitlines())
    print(PAGE.format(machine=machine, table=table(["case", "library", "ns", "false answers"], 2, lines), plots=plots,
                      scores=scores, inputs=inputs, builds=builds, price=price_table(cases)), end="")


main()
