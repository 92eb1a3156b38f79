"""What the figures of cost against error show: panels of (title, points), from the rows of the benchmarks.

A point is (cost, the ends of its bar or None, error, library, label).
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "figures"))
from cases import HARD
from marks import shown
from report import ONE_THREAD

WRONG = ("WRONG_FRACTION", "DIFFERS", "FALSE_FRACTION")
# Panels of ordinary work: title, then (case, what its label says behind the name of the library).
ORDINARY = [
    ("A random ray at boxes", [("scene_ray_random", "batch"), ("scene_single_random", ""), ("scene_distance_random", "distance only")]),
    ("A ray of a camera at boxes", [("scene_ray_rows", "batch"), ("scene_single_rows", ""), ("scene_distance_camera", "distance only, in tiles")]),
    ("A ray at spheres", [("sphere_ray_random", "batch")]),
    ("A ray at copies of a mesh", [("instance_ray_random", "batch")]),
    ("A random ray at a mesh", [("mesh_ray_random", "batch"), ("mesh_single_random", ""), ("mesh_distance_random", "distance only")]),
    ("A ray of a camera at a mesh", [("mesh_ray_rows", "batch"), ("mesh_single_rows", ""), ("mesh_distance_camera", "distance only, in tiles")]),
    ("The nearest box to a point", [("nearest_box", "batch"), ("nearest_box_single", "")]),
    ("The nearest point to a point", [("nearest_point", "batch"), ("nearest_point_single", "")]),
    ("The nearest point of a mesh", [("mesh_nearest_scan", "batch"), ("mesh_nearest_scan_single", "")]),
    ("A segment at boxes", [("segment", "batch")]),
    ("A sphere swept at boxes", [("sweep_sphere", "batch")]),
    ("A capsule swept at boxes", [("sweep_capsule", "batch")]),
    ("A box swept at boxes", [("sweep_box", "batch")]),
    ("A capsule swept at convex hulls", [("hull_sweep_capsule", "batch")]),
    ("A box swept at convex hulls", [("hull_sweep_box", "batch")]),
]
# Panels of the share of wrong answers. Where the answer is a number of models, the error is that share already.
ANSWERS = [
    ("A random ray at boxes", "scene_ray_random"), ("A ray of a camera at boxes", "scene_ray_rows"), ("A ray at spheres", "sphere_ray_random"),
    ("A ray at convex hulls", "hull_ray_random"), ("A random ray at a mesh", "mesh_ray_random"), ("A ray of a camera at a mesh", "mesh_ray_rows"),
    ("The nearest box to a point", "nearest_box"), ("The nearest point to a point", "nearest_point"),
    ("The nearest point of a mesh", "mesh_nearest_scan"), ("A segment at boxes", "segment"),
    ("Which boxes a sphere overlaps", "overlap_sphere"), ("Which boxes a box overlaps", "overlap_box"),
    ("Which hulls contain a point", "hull_contains"), ("Culling, per box", "cull"), ("A sphere swept at boxes", "sweep_sphere"),
    ("A capsule swept at boxes", "sweep_capsule"), ("A box swept at boxes", "sweep_box"), ("A capsule swept at convex hulls", "hull_sweep_capsule"),
    ("A box swept at convex hulls", "hull_sweep_box"),
]
COUNTED = ("overlap_sphere", "overlap_box", "hull_contains", "cull")
# Panels of the solver: title, and the cases whose rows it has.
SOLVER = {
    "Swinging chain: error after a second": ["chain_30"],
    "Rope of 1000 links, weight of 1000 links": ["rope_1e3"],
    "The same, weight of 1,000,000 links": ["rope_1e6"],
    "1000 ropes of 30 links": ["ropes_1000x30"],
    "Cloth of 100 x 100 on two corners": ["cloth_100"],
    "The cloth, stiff against bending": ["cloth_100_bend"],
    "Cloth that falls on a mesh": ["drape_over_mesh", "drape_within_2_percent_mean", "drape_within_2_percent_longest"],
    "100,000 particles landing on boxes": ["free_100k_landing"],
    "2000 balls poured into a pit": ["ball_pit"],
    "Rope over a post, 1 kg against 3 kg": ["rope_over_post"],
}
# The error of a case of the solver, if it is not the strain: the column, and the label of the axis.
SOLVER_ERRORS = {"chain_30": ("position_error", "distance, m"), "free_100k_landing": ("position_error", "depth in a box, m"),
                 "free_100k_all": ("position_error", "depth in a box, m"), "ball_pit": ("position_error", "overlap, m"),
                 "rope_over_post": ("position_error", "distance, m")}
STRAIN = ("strain_max", "largest strain")
# What a label says instead of a number of substeps, where that is not the setting.
SOLVER_SETTINGS = {"drape_within_2_percent_mean": "max_strain 2 %", "drape_within_2_percent_longest": "max_strain 2 %, longest frame",
                   "free_100k_landing": "", "free_100k_all": ""}


def usual(rows, case):
    """Of the numbers of objects that were measured, the one nearest to 100,000."""
    return min((n for name, n in rows if name == case), key=lambda n: abs(math.log(n / 100000)), default=None)


def rows_of(rows, case):
    """{implementation: row} at the usual number of objects: of other libraries, and of gamephys with one
    thread and with the most. Others of gamephys, such as a scene built anew, are in the tables."""
    by = rows.get((case, usual(rows, case)), {})
    threads = {int(name.split("_")[1]): name for name in by if name.endswith("_threads") and case not in ONE_THREAD}
    most = threads[max(threads)] if threads else None
    return {name: row for name, row in by.items() if not name.startswith("gamephys_") or name == most}


def bar(row):
    """From the lower to the upper quartile of the repetitions, or None where there was one."""
    return (row["lower_quartile"], row["upper_quartile"]) if row["upper_quartile"] > 0 else None


def ordinary_panels(rows):
    """(panels, the labels of their error axes). Libraries with wrong answers are left out: an error of distance would be
    meaningless for them. So is work where nobody else is left."""
    panels, labels = [], []
    for title, cases in ORDINARY:
        points, n, unit = [], 0, ""
        batch = {name for case, what in cases if what == "batch" for name in rows_of(rows, case)}
        for case, how in cases:
            n = usual(rows, case) or n
            for name, row in rows_of(rows, case).items():
                if row["unit"] != "ns" or row["error_unit"] in WRONG:
                    continue
                own = name.startswith("gamephys")
                if not how and name in batch and not own:
                    continue  # a loop of single calls, as in the batch, whose row the tables compare too
                distance_only = how.startswith("distance only")
                if distance_only and name != "gamephys":
                    continue
                library = "gamephys_distance" if distance_only else name
                label = f", {how or 'one call'}" if len(cases) > 1 and name == "gamephys" else ""
                points.append((row["value"], bar(row), row["error"], library, shown(name) + label))
                unit = row["error_unit"]
        if any(not library.startswith("gamephys") for *_, library, _ in points):
            panels.append((f"{title} ({n:,})", points))
            labels.append("largest error, part of the way" if unit == "of the way" else "largest relative error")
    return panels, labels


def answer_panels(rows):
    """(panels, titles of the work in which nobody is wrong and whose error of distance is in the ordinary panels)"""
    panels, right = [], []
    for title, case in ANSWERS:
        points = [(row["value"], bar(row), row["error"] if case in COUNTED or row["error_unit"] in WRONG else 0, name, shown(name))
                  for name, row in rows_of(rows, case).items()]
        if not any(not name.startswith("gamephys") for *_, name, _ in points):
            continue
        if case in COUNTED or any(error for _, _, error, *_ in points):
            panels.append((f"{title} ({usual(rows, case):,})", points))
        else:
            right.append(title[0].lower() + title[1:])
    return panels, right


def hard_panels(rows):
    panels = []
    for case, title in HARD.items():
        by = rows.get((case, usual(rows, case)), {})
        points = [(row["value"], bar(row), row["error"], name, shown(name)) for name, row in by.items()]
        if points:
            panels.append((title, points))
    return panels


def solver_label(row):
    return f"{shown(row['method'])} {SOLVER_SETTINGS.get(row['case'], row['substeps'])}".rstrip()


def unstable(rows):
    """{title of a panel: labels of the methods that are unstable there}"""
    return {title: [solver_label(row) for row in rows if row["case"] in cases and row["strain_max"] == "inf"]
            for title, cases in SOLVER.items()}


def solver_points(rows, cases):
    """The points of cases of the solver, without unstable methods, and the label of their error."""
    points, label = [], ""
    for case in cases:
        column, label = SOLVER_ERRORS.get(case, STRAIN)
        for row in rows:
            if row["case"] == case and row[column] and row["strain_max"] != "inf":
                frames = (float(row["ms_lower_quartile"]), float(row["ms_upper_quartile"])) if row["ms_upper_quartile"] else None
                points.append((float(row["ms"]), frames, float(row[column]), row["method"], solver_label(row)))
    return points, label


def solver_panels(rows):
    """(panels, the labels of their error axes)"""
    panels, labels = [], []
    for title, cases in SOLVER.items():
        points, label = solver_points(rows, cases)
        if points:
            panels.append((title, points))
            labels.append(label)
    return panels, labels
