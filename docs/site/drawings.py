#!/usr/bin/env python3
"""Draws the pictures of the guide and of the essays: drawings.py [NAME...], into docs/images/NAME.png."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, FancyArrowPatch, FancyBboxPatch, Rectangle

ROOT = Path(__file__).resolve().parents[2]
INK, OURS, OTHER, GREEN, PALE, STONE = "#333333", "#D55E00", "#0072B2", "#009E73", "#f1f5f0", "#b9bec6"


def canvas(width, height, xs, ys, columns=1):
    """Axes without a frame, with one unit as long in both directions."""
    drawing, grid = plt.subplots(1, columns, figsize=(width, height), layout="constrained", squeeze=False)
    for axes in grid[0]:
        axes.set(xlim=xs, ylim=ys, aspect="equal")
        axes.axis("off")
    return drawing, (grid[0][0] if columns == 1 else grid[0])


def arrow(axes, start, end, colour=INK, style="-|>", curve=0.0, width=1.6, dashed=False):
    axes.add_patch(FancyArrowPatch(start, end, arrowstyle=style, mutation_scale=14, color=colour, linewidth=width, shrinkA=0, shrinkB=0,
                                   connectionstyle=f"arc3,rad={curve}", linestyle="--" if dashed else "-", zorder=4))


def dot(axes, at, colour=OURS, size=7):
    axes.plot(*at, "o", color=colour, markersize=size, markeredgecolor="white", zorder=5)


def box(axes, low, high, colour=STONE, edge=INK, **more):
    axes.add_patch(Rectangle(low, high[0] - low[0], high[1] - low[1], facecolor=colour, edgecolor=edge, linewidth=1, **more))


def label(axes, at, text, colour=INK, **more):
    axes.text(*at, text, color=colour, **{"ha": "center", "va": "center", "fontsize": 10.5, **more})


def note(axes, at, text, width, height, colour=PALE):
    """A box with words in it."""
    axes.add_patch(FancyBboxPatch((at[0] - width / 2, at[1] - height / 2), width, height, boxstyle="round,pad=0.02,rounding_size=0.12",
                                  facecolor=colour, edgecolor=INK, linewidth=1, zorder=2))
    label(axes, at, text, zorder=6)


def guide_first_scene():
    drawing, axes = canvas(9, 4.2, (-6, 37), (-2.2, 12.4))
    box(axes, (-6, -2.2), (37, 0), "#dfe6d8", "none")
    axes.plot([-6, 37], [0, 0], color=INK)
    for i in range(4):
        axes.plot([10 * i] * 2, [0, 4], color=STONE, linewidth=6, solid_capstyle="round", zorder=1)
    axes.plot([-2, 2], [3, 3], color=OTHER, linewidth=4)
    axes.plot([18, 22], [3, 3], color=OTHER, linewidth=4, alpha=0.35)
    arrow(axes, (2.6, 3.6), (17.4, 3.6), OTHER, curve=-0.25, dashed=True)
    arrow(axes, (1, 10), (1, 3), OURS)
    arrow(axes, (1, 3), (1, 0), OURS, dashed=True)
    for at in ((1, 3), (1, 0)):
        dot(axes, at)
    label(axes, (1, 11), "ray down from (1, 10, 1)", OURS, ha="left")
    label(axes, (1.8, 2.1), "1: the roof, at height 3", OURS, ha="left")
    label(axes, (1.8, -1.1), "2: the ground, after the roof has moved", OURS, ha="left")
    label(axes, (10, 7.1), "gphys_scene_set_transform", OTHER)
    label(axes, (32.5, 5), "100 posts, one shape")
    return drawing


def guide_queries():
    drawing, grid = plt.subplots(2, 3, figsize=(9.6, 4.4), layout="constrained")
    titles = ["raycast: the first hit", "raycast_all: all hits in order", "overlap: what touches a shape", "nearest: the closest point",
              "sweep: how far a solid moves", "penetration: the shortest way out"]
    for axes, title in zip(grid.flat, titles):
        axes.set(xlim=(-1, 9), ylim=(-2.2, 2.2), aspect="equal")
        axes.axis("off")
        axes.set_title(title, fontsize=10.5)
        box(axes, (3, -1.6), (4.2, 1.1))
        axes.add_patch(Circle((6.7, 0.1), 1, facecolor=STONE, edgecolor=INK))
    ray, every, touch, near, sweep, deep = grid.flat
    arrow(ray, (-0.6, 0.1), (3, 0.1), OURS)
    ray.plot([3, 8.8], [0.1, 0.1], color=OURS, linestyle=":", zorder=4)
    dot(ray, (3, 0.1))
    arrow(ray, (3, -0.7), (1.9, -0.7), GREEN, width=2.4)
    label(ray, (1, -0.7), "normal", GREEN)
    arrow(every, (-0.6, 0.1), (8.8, 0.1), OURS)
    for i, x in enumerate((3, 5.7)):
        dot(every, (x, 0.1))
        label(every, (x - 0.3, 0.6), str(i + 1), OURS)
    touch.add_patch(Circle((4.9, -0.6), 1.3, facecolor=OURS, alpha=0.25, edgecolor=OURS))
    box(touch, (3, -1.6), (4.2, 1.1), "none", OURS, zorder=5)
    touch.add_patch(Circle((6.7, 0.1), 1, facecolor="none", edgecolor=OURS, linewidth=2, zorder=5))
    dot(near, (1.2, 1.6), OTHER)
    dot(near, (3, 1.1))
    near.plot([1.2, 3], [1.6, 1.1], color=OURS)
    sweep.add_patch(Circle((0, -0.6), 0.6, facecolor="none", edgecolor=OURS))
    sweep.add_patch(Circle((2.4, -0.6), 0.6, facecolor=OURS, alpha=0.3, edgecolor=OURS))
    sweep.plot([0, 2.4], [0, 0], color=OURS, linewidth=0.8)
    sweep.plot([0, 2.4], [-1.2, -1.2], color=OURS, linewidth=0.8)
    arrow(sweep, (0, -0.6), (2.4, -0.6), OURS)
    dot(sweep, (3, -0.6))
    deep.add_patch(Circle((2.8, -0.3), 0.7, facecolor=OURS, alpha=0.3, edgecolor=OURS))
    deep.add_patch(Circle((2.3, -0.3), 0.7, facecolor="none", edgecolor=OURS, linestyle="--"))
    arrow(deep, (2.8, -0.3), (2.3, -0.3), OURS, width=2.4)
    return drawing


def guide_batches():
    drawing, axes = canvas(11, 3, (-0.6, 25.2), (-1.9, 4.4))
    fields = [("owner", 1, STONE), ("origin", 3, OURS), ("direction", 3, OURS), ("t_max", 1, OURS)]
    for item in range(3):
        x = 8 * item
        for name, words, colour in fields:
            box(axes, (x, 0), (x + words, 1), colour, "white", alpha=0.85 if colour == OURS else 1)
            label(axes, (x + words / 2, 0.5), name if words > 1 else "", "white" if colour == OURS else INK)
            x += words
        label(axes, (8 * item + 4, -0.6), f"bullets[{item}]")
    arrow(axes, (1, 1.9), (9, 1.9), style="<|-|>")
    label(axes, (5, 2.5), "stride: sizeof(bullet), 32 bytes")
    arrow(axes, (1, 3.9), (1, 1.1), OURS)
    label(axes, (1.3, 3.7), "rays: &bullets[0].path", OURS, ha="left")
    axes.plot([9, 9], [1.1, 2.2], color=INK, linewidth=0.8)
    label(axes, (12.3, -1.5), "One call reads every path where it lies; nothing is copied.")
    return drawing


def guide_large_worlds():
    drawing, axes = plt.subplots(figsize=(9, 3.8), layout="constrained")
    far = np.logspace(0, 7.2, 400)
    axes.loglog(far, np.spacing(far.astype(np.float32)), color=OTHER, label="float coordinates from a fixed origin")
    axes.loglog(far, np.spacing(np.minimum(far, 3000).astype(np.float32)), color=OURS, linewidth=2.6,
                label="the origin follows the player, within 3 km")
    for x, name in ((1e3, "a village"), (1e5, "a country"), (6.371e6, "from the centre\nof the Earth")):
        axes.axvline(x, color="#bbbbbb", linewidth=0.8, zorder=0)
        axes.text(x, 6e-8, " " + name, fontsize=9.5, va="bottom", ha="left" if x < 1e6 else "right", color="#666666")
    axes.set(xlabel="distance, m", ylabel="step between coordinates, m", xlim=(1, 1.6e7), ylim=(4e-8, 3))
    axes.legend(loc="upper left")
    return drawing


def guide_threads():
    drawing, axes = canvas(11, 3.4, (-4.6, 21), (-1.2, 5.6))
    for row, name in enumerate(["your thread", "worker 1", "worker 2", "worker 3"]):
        y = 4 - row
        label(axes, (-0.4, y + 0.35), name, ha="right")
        axes.plot([0, 14.6], [y + 0.35] * 2, color="#dddddd", zorder=0)
    box(axes, (0, 4), (3.6, 4.7), STONE)
    label(axes, (1.8, 4.35), "your code")
    parts = {4: [(4, 2.1), (6.2, 1.7), (8, 2.2)], 3: [(4.1, 1.6), (5.8, 2.4), (8.3, 1.8)], 2: [(4.1, 2.3), (6.5, 1.9), (8.5, 1.6)], 1: [(4.2, 1.9), (6.2, 2.2), (8.5, 1.5)]}
    for y, row in parts.items():
        for x, length in row:
            box(axes, (x, y), (x + length, y + 0.7), OURS, "white", alpha=0.85)
    box(axes, (10.5, 4), (14, 4.7), STONE)
    label(axes, (12.25, 4.35), "your code")
    for x in (4, 10.4):
        axes.plot([x, x], [0.7, 5], color=INK, linewidth=0.9, linestyle="--")
    label(axes, (7.2, 5.2), "one call of a batch, in parts", OURS)
    label(axes, (7.2, 0.1), "worker_count = 4")
    label(axes, (18, 2.8), "The answers have\nthe same bits for\nany number of threads.")
    return drawing


def guide_saving():
    drawing, axes = canvas(11, 2.8, (-1, 21.6), (-3.6, 2.9))
    for frame in range(8):
        axes.add_patch(Circle((2.6 * frame, 0), 0.75, facecolor=PALE if frame < 4 else "#fbe6d8", edgecolor=INK))
        label(axes, (2.6 * frame, 0), str(frame + 100))
        if frame < 7:
            arrow(axes, (2.6 * frame + 0.8, 0), (2.6 * frame + 1.8, 0))
    arrow(axes, (7.8, 1), (7.8, 2.3), GREEN, style="<|-|>")
    label(axes, (8.2, 2.1), "snapshot of frame 103", GREEN, ha="left")
    arrow(axes, (18.2, -0.8), (7.9, -0.8), OURS, curve=-0.28)
    label(axes, (12, -3.1), "an input for frame 103 comes late: restore, and step again; the bits are those of everyone else", OURS)
    return drawing


def guide_engine():
    drawing, axes = canvas(11, 4, (-1.6, 21.6), (-1.4, 6.8))
    steps = [((2, 5.4), "1  set transforms\nof your models"), ((9.6, 5.4), "2  step the solver"), ((17.2, 5.4), "3  impulses\nto your bodies"),
             ((17.2, 1), "4  queries of\nthe game"), ((9.6, 1), "5  cull and draw")]
    for at, text in steps:
        note(axes, at, text, 4.8, 1.9)
    for (a, _), (b, _) in zip(steps, steps[1:]):
        if a[1] == b[1]:
            side = 2.5 if b[0] > a[0] else -2.5
            arrow(axes, (a[0] + side, a[1]), (b[0] - side, b[1]))
        else:
            arrow(axes, (a[0], a[1] - 1), (b[0], b[1] + 1))
    note(axes, (2, 1), "your rigid bodies\nand animation", 4.8, 1.9, "#fbe6d8")
    arrow(axes, (7.1, 1), (4.5, 1))
    arrow(axes, (2, 2), (2, 4.4))
    label(axes, (9.6, 3.2), "one frame", "#888888", fontsize=13)
    return drawing


def guide_cluster():
    drawing, axes = canvas(10, 3.6, (-1.2, 19.2), (-0.6, 6.6))
    note(axes, (2, 3), "counter:\nnext unit", 3.4, 1.9, "#fbe6d8")
    for i, y in enumerate((5.4, 3, 0.6)):
        note(axes, (9, y), f"process {i + 1}\nthe same scene", 4.6, 1.6)
        arrow(axes, (3.8, 3 + 0.25 * (1 - i)), (6.6, y))
        arrow(axes, (11.4, y), (14.2, 3 + 0.25 * (1 - i)))
    note(axes, (16.2, 3), "one file,\nthe same bytes", 3.8, 1.9)
    return drawing


def bvh():
    """Eight boxes of a node, and of one of its children."""
    drawing, grid = canvas(11, 4.6, (-0.3, 8.3), (-0.3, 6.3), 2)
    numbers = np.random.default_rng(4)
    spots = np.array([(0.9 + 2.1 * (i % 4), 1.4 + 3.2 * (i // 4)) for i in range(8)])
    things = [spot + numbers.normal(0, [0.42, 0.6], (8, 2)) for spot in spots]
    things = [np.clip(group, [0.1, 0.1], [7.9, 5.9]) for group in things]

    def around(group, margin=0.1):
        return group.min(0) - margin, group.max(0) + margin

    node, child = grid
    for i, group in enumerate(things):
        low, high = around(group)
        for axes in grid:
            axes.plot(*group.T, "s", color="#888888", markersize=5, zorder=3)
        hit = high[1] > 4.6 > low[1]
        box(node, low, high, "#fbe6d8" if hit else "none", OURS if hit else "#aaaaaa")
        if i == 5:
            for k in range(8):
                box(child, *around(group[k:k + 1], 0.11), "#fbe6d8", OURS)
        box(child, low, high, "none", OURS if i == 5 else "#dddddd")
    for axes in grid:
        arrow(axes, (-0.3, 4.6), (8.3, 4.6), OTHER)
    node.set_title("one test of a ray and eight boxes in a register")
    child.set_title("then the eight children of a box that was hit")
    return drawing


def exactness():
    drawing, axes = canvas(11, 2.6, (-11, 11), (-2.4, 2.6))
    for low, high, colour in ((-10, -2, "#d8e8f4"), (-2, 2, "#fbe6d8"), (2, 10, "#d8efe6")):
        box(axes, (low, -0.5), (high, 0.5), colour, "white")
    axes.plot([0, 0], [0.5, 0.9], color=INK)
    label(axes, (0, 1.2), "0")
    label(axes, (-6, 0), "certainly negative: a miss")
    label(axes, (6, 0), "certainly positive: a hit")
    label(axes, (0, 0), "cannot tell", ha="center")
    arrow(axes, (-2, 1.75), (2, 1.75), style="<|-|>")
    label(axes, (0, 2.25), "bound of the rounding errors")
    arrow(axes, (0, -0.55), (0, -1.5), OURS)
    label(axes, (0, -1.95), "the sign by exact arithmetic: few candidates come here", OURS)
    return drawing


def cloth_chains():
    """Threads of a sheet that are solved side by side: those of one colour share no particle."""
    drawing, grid = canvas(10, 3.6, (-0.6, 7.6), (-0.6, 5.6), 3)
    for axes, title in zip(grid, ("threads across: one batch", "threads along: the next batch", "a pinned corner: limits of distance")):
        axes.set_title(title)
        for x in range(8):
            for y in range(6):
                axes.plot(x, y, "o", color=INK, markersize=4, zorder=3)
    for y in range(6):
        grid[0].plot([0, 7], [y, y], color=OURS, linewidth=2.5)
        grid[1].plot([0, 7], [y, y], color="#dddddd", linewidth=1)
    for x in range(8):
        grid[0].plot([x, x], [0, 5], color="#dddddd", linewidth=1)
        grid[1].plot([x, x], [0, 5], color=OTHER, linewidth=2.5)
    reach = grid[2]
    for x in range(8):
        for y in range(6):
            if x + 5 - y:
                reach.plot([0, x], [5, y], color=GREEN, linewidth=0.5, alpha=0.6, zorder=1)
    reach.plot(0, 5, "s", color=OURS, markersize=10, zorder=4)
    return drawing


DRAWINGS = [guide_first_scene, guide_queries, guide_batches, guide_large_worlds, guide_threads, guide_saving, guide_engine, guide_cluster,
            bvh, exactness, cloth_chains]


def main():
    plt.style.use(str(ROOT / "bench/figures/style.mplstyle"))
    for draw in DRAWINGS:
        if len(sys.argv) < 2 or draw.__name__ in sys.argv[1:]:
            drawing = draw()
            drawing.savefig(ROOT / f"docs/images/{draw.__name__}.png", bbox_inches="tight", pad_inches=0.1)
            plt.close(drawing)


main()
