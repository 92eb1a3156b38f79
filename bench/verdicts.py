"""What one pays and what one gets: a sentence for each panel of a figure, and the table of all kinds of work.

A point is (cost, the ends of its bar or None, error, library, label), as in panels.py.
"""
from panels import WRONG, rows_of, solver_points, unstable, usual
from marks import shown
from report import number, table

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
    ("a random ray at convex hulls, in a batch", "hull_ray_random"),
    ("a random ray at a mesh, by triangles, one call", "mesh_single_random"),
    ("the same in a batch", "mesh_ray_random"),
    ("the same, the mesh a model of a scene", "mesh_model_ray_random"),
    ("a ray of a camera at a mesh, in a batch", "mesh_ray_rows"),
    ("which boxes a sphere overlaps, in a batch", "overlap_sphere"),
    ("which boxes a box overlaps, in a batch", "overlap_box"),
    ("which hulls contain a point, in a batch", "hull_contains"),
    ("the nearest box to a point, one call", "nearest_box_single"),
    ("the same in a batch", "nearest_box"),
    ("the nearest point to a point, one call", "nearest_point_single"),
    ("the same in a batch", "nearest_point"),
    ("the nearest point of a mesh, one call", "mesh_nearest_scan_single"),
    ("the same in a batch", "mesh_nearest_scan"),
    ("a segment at boxes, in a batch", "segment"),
    ("a sphere swept at boxes, in a batch", "sweep_sphere"),
    ("a capsule swept at boxes, in a batch", "sweep_capsule"),
    ("a box swept at boxes, in a batch", "sweep_box"),
    ("a capsule swept at convex hulls, in a batch", "hull_sweep_capsule"),
    ("culling boxes, per box", "cull"),
    ("moving all boxes, per box", "update_all"),
    ("building a scene of boxes, per box", "build_scene"),
]
# Of the solver: what it is, the case, and the number of particles.
SOLVER_SUMMARY = [
    ("a swinging chain, per frame", "chain_30", 31),
    ("a rope with a weight of 1000 links, per frame", "rope_1e3", 1001),
    ("a rope with a weight of 1,000,000 links, per frame", "rope_1e6", 1001),
    ("1000 ropes, per frame", "ropes_1000x30", 31000),
    ("cloth on two corners, per frame", "cloth_100", 10000),
    ("particles that land on boxes, per frame", "free_100k_landing", 100000),
    ("balls poured into a pit, per frame", "ball_pit", 2000),
    ("a rope over a post, per frame", "rope_over_post", 121),
]


def cost(point):
    return point[0]


def percent(share):
    return "0" if share == 0 else f"{100 * share:.2g} %"


def plain(error):
    return "0" if error == 0 else f"{error:.2g}"


# What a sentence calls the error of an axis.
NOUNS = {"wrong answers": "share of wrong answers", "false answers": "share of false answers", "distance, m": "distance from the reference",
         "depth in a box, m": "depth in a box", "overlap, m": "largest overlap", "largest error, part of the way": "largest error"}


def writer(label):
    """How the errors of an axis are written."""
    if label.endswith("answers") or label.endswith("strain"):
        return percent
    return (lambda error: f"{plain(error)} m" if error else "0") if label.endswith(", m") else plain


def takes(point, other):
    """What a point costs beside another one."""
    ratio = point[0] / other[0]
    return f"takes as long as {other[4]}" if 0.98 < ratio < 1.02 else f"takes {number(ratio)} times the time of {other[4]}"


def split(points):
    """Points of gamephys, without its variant that is not exact, and those of others."""
    own = [point for point in points if point[3].startswith("gamephys") and point[3] != "gamephys_float"]
    return own, [point for point in points if not point[3].startswith("gamephys")]


def against_fastest(points, label):
    """gamephys beside the fastest other, and beside the fastest as exact as it is."""
    own, others = split(points)
    same_work = [point for point in own if point[3] == "gamephys"]
    if not same_work or not others:
        return None
    show, best, fastest = writer(label), min(same_work, key=cost), min(others, key=cost)
    text = f"{best[4]} {takes(best, fastest)}, the fastest other; "
    if fastest[2] == best[2]:
        what = label if label.endswith("answers") else "an error"
        return text + (f"neither has {what}." if best[2] == 0 else f"both have {what}, {show(best[2])}.")
    text += f"its {NOUNS.get(label, label)} is {show(best[2])} instead of {show(fastest[2])}."
    exact = [point for point in others if point[2] <= best[2]]
    if exact:
        other = min(exact, key=cost)
        text += f" It {takes(best, other)}, the fastest that is as exact."
    return text


def pair(points):
    """Of a panel in which each library has several settings: the most exact other, and the cheapest of ours that is as
    exact, or the most exact of ours if none is."""
    own, others = split(points)
    if not own or not others:
        return None
    other = min(others, key=lambda point: (point[2], point[0]))
    exact = [point for point in own if point[2] <= other[2]]
    return min(exact, key=cost) if exact else min(own, key=lambda point: (point[2], point[0])), other


def against_most_exact(points, label):
    both = pair(points)
    if not both:
        return None
    show, (best, other) = writer(label), both
    return f"{best[4]} {takes(best, other)}, the most exact other; its {NOUNS.get(label, label)} is {show(best[2])} instead of {show(other[2])}."


def sentences(panels, labels, compare):
    """A list with a sentence for each panel; labels are those of the error axes."""
    found = [(title, compare(points, label)) for (title, points), label in zip(panels, labels)]
    return "".join(f"- **{title}**: {text}\n" for title, text in found if text)


def hard_input(panels):
    """What the README says of hard input: the largest share of false answers, its library and panel, and the range of times."""
    both = [(title, *split(points)) for title, points in panels]
    mistakes = max(point[2] for _, own, _ in both for point in own)
    share, library, title = max(((point[2], point[4], title) for title, _, others in both for point in others), key=lambda found: found[0])
    ratios = [min(own, key=cost)[0] / min(others, key=cost)[0] for _, own, others in both if own and others]
    return {"others": percent(share), "library": library, "title": title, "own": percent(mistakes) if mistakes else "none",
            "least": number(min(ratios)), "most": number(max(ratios))}


def unstable_methods(rows):
    """A sentence about the methods of the solver that have no points."""
    parts = [f"{', '.join(names)} ({title})" for title, names in unstable(rows).items() if names]
    return f"Unstable, and therefore without a point: {'; '.join(parts)}.\n" if parts else ""


def verdict(ratio, own, other):
    """Green where gamephys is ahead in time and not behind in error, red where it is behind in either."""
    faster, slower = ratio <= 0.98, ratio >= 1.02
    words = "faster" if faster else "slower" if slower else "as fast"
    if own is not None:
        words += ", more exact" if own < other else ", less exact" if own > other else ", as exact"
    behind = slower or (own is not None and own > other)
    return f"{'🔴' if behind else '🟢' if faster else '⚪'} {words}"


def line(what, count, unit, own, other, show):
    """own and other: (time, error or None, label)."""
    ratio = own[0] / other[0]
    errors = ["" if error is None else show(error) for error in (own[1], other[1])]
    of_errors = number(own[1] / other[1]) if own[1] and other[1] else ""
    return [what, f"{count:,}", f"{number(own[0])} {unit}", other[2], f"{number(other[0])} {unit}", number(ratio), *errors, of_errors,
            verdict(ratio, own[1], other[1])]


def query_line(rows, what, case):
    """The fastest of the others that answers right; of all others where none does."""
    by = rows_of(rows, case)
    others = {name: row for name, row in by.items() if not name.startswith("gamephys")}
    if "gamephys" not in by or not others:
        return None
    right = {name: row for name, row in others.items() if row["error_unit"] not in WRONG}
    name = min(right or others, key=lambda name: others[name]["value"])
    own, other = by["gamephys"], others[name]
    checked = own["error_unit"] != "unchecked"

    def measured(row, label):
        return row["value"], row["error"] if checked else None, label

    show = plain if right else lambda error: "0" if error == 0 else f"{percent(error)} wrong"
    return line(what, usual(rows, case), "ns", measured(own, "gamephys"), measured(other, shown(name)), show)


def solver_line(rows, what, case, count):
    """The most exact of the others, and the cheapest setting of gamephys that is as exact."""
    points, label = solver_points(rows, [case])
    both = pair(points)
    if not both:
        return None
    own, other = ((point[0], point[2], point[4]) for point in both)
    return line(f"{what}, {own[2]}", count, "ms", own, other, writer(label))


def summary(rows, solver):
    lines = [query_line(rows, *entry) for entry in SUMMARY] + [solver_line(solver, *entry) for entry in SOLVER_SUMMARY]
    return table(["work", "objects", "gamephys", "best other", "its time", "ratio of times", "our error", "its error", "ratio of errors", ""],
                 [cells for cells in lines if cells])
