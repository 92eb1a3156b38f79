#!/usr/bin/env python3
"""What the figures of the report promise: test_figures.py. The status 77 says that matplotlib is not installed."""
import math
import sys
import unittest

try:
    import matplotlib
except ImportError:
    print("python3-matplotlib is not installed")
    sys.exit(77)
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.path import Path
from matplotlib.text import Text

from cost_error import ErrorAxis, front, panel
from labels import ink, luminance, place_labels
from marks import LOOKS

# Panels as they are measured: names, costs and errors.
CAMERA_AT_BOXES = [("gamephys", 110, 0), ("gamephys_float", 108, 0), ("embree", 236, 0), ("embree_robust", 237, 0),
                   ("embree_packets", 67, 0), ("embree_packets_robust", 66, 0), ("bullet", 12600, 2.3e-2)]
CAMERA_AT_MESH = [("gamephys", 64.4, 0), ("gamephys_float", 90, 0), ("embree", 106, 0), ("embree_robust", 119, 0),
                  ("embree_packets", 31.5, 0), ("embree_packets_robust", 28.6, 0), ("bullet", 1250, 0)]
CALLS_AT_MESH = [("gamephys", 223, 0), ("gamephys, one call", 344, 0), ("embree", 266, 3.5e-7), ("embree_robust", 310, 2.4e-7),
                 ("bullet", 3480, 3.5e-7)]
NO_ROOM_AT_FIRST = [("gamephys", 181, 0), ("gamephys_float", 134, 0), ("embree", 275, 0), ("embree_robust", 113, 0),
                    ("embree_packets", 71, 0), ("embree_packets_robust", 86, 0), ("bullet", 8600, 2.3e-2)]
SWARM = [(f"embree, {column} {row}", 100 * 1.35 ** column, 1e-6 * 4.0 ** row) for column in range(4) for row in range(3)]


class Drawn:
    """A panel with labels, in pixels."""

    def __init__(self, points):
        drawing, axes = plt.subplots(figsize=(6, 4.4))
        parts = panel(axes, "title", points, "ns", "error")
        drawing.canvas.draw()
        self.lost = place_labels(*parts)
        drawing.canvas.draw()  # which brings the labels to their places
        to_pixels = axes.transData.transform
        self.points = {label: tuple(to_pixels((x, y))) for x, y, label, *_ in parts[1]}
        self.boxes = {text.get_text(): Text.get_window_extent(text) for text in axes.texts}
        self.leaders = [to_pixels(line.get_xydata()) for line in axes.lines if line.get_gid() == "leader"]
        plt.close(drawing)


def apart(point, box):
    return math.hypot(max(box.x0 - point[0], 0, point[0] - box.x1), max(box.y0 - point[1], 0, point[1] - box.y1))


def named(points):
    return [(cost, (1.02 * cost, 1.1 * cost), error, name.split(",")[0], name) for name, cost, error in points]


class Figures(unittest.TestCase):
    def test_front_is_what_nobody_beats_in_both(self):
        self.assertEqual(front([(3, 4), (1, 5), (4, 0), (2, 3), (5, 0)]), [(1, 5), (2, 3), (4, 0)])

    def test_no_error_is_below_all_errors_and_shares_end_at_one(self):
        axis = ErrorAxis([0, 1e-7, 1e-4], False)
        self.assertLess(axis(0), axis(1e-7))
        self.assertEqual(axis(1e-4) - axis(1e-7), 3)
        self.assertEqual(ErrorAxis([0.7, 0.2], True).high, 0)
        self.assertFalse(ErrorAxis([1e-3], False).zero)

    def check_labels(self, drawn):
        self.assertEqual(drawn.lost, [])
        for label, box in drawn.boxes.items():
            own = drawn.points[label]
            for other, other_box in drawn.boxes.items():
                self.assertFalse(other != label and box.overlaps(other_box), f"{label} is on {other}")
            for other, (x, y) in drawn.points.items():
                self.assertGreater(apart((x, y), box), 5, f"{label} is on the point of {other}")
            led = [leader for leader in drawn.leaders if abs(leader[1] - own).max() < 0.1 and apart(leader[0], box) < 0.1]
            nearest = min(apart(point, box) for other, point in drawn.points.items() if other != label)
            self.assertTrue(led or apart(own, box) <= nearest, f"{label} is nearer to the point of another")
            for leader in drawn.leaders:  # those to the same place may go behind
                crossed = Path(leader).intersects_bbox(box) and math.dist(leader[1], own) > 4
                self.assertFalse(crossed, f"a line goes through {label}")

    def test_labels_of_crowded_points_tell_which_is_theirs(self):
        for points in (CAMERA_AT_BOXES, CAMERA_AT_MESH, CALLS_AT_MESH, NO_ROOM_AT_FIRST, SWARM):
            with self.subTest(points=points):
                drawn = Drawn(named(points))
                self.assertEqual(len(drawn.boxes), len(points))
                self.check_labels(drawn)

    def test_labels_without_error_have_lines(self):
        drawn = Drawn(named(CAMERA_AT_MESH))
        self.assertEqual(len(drawn.leaders), len(CAMERA_AT_MESH))

    def test_labels_of_points_at_one_place_do_not_overlap(self):
        drawn = Drawn([(100, (110, 130), 1e-6, "embree", f"library number {i}") for i in range(6)])
        self.assertEqual(len(drawn.boxes), 6)
        self.check_labels(drawn)

    def test_a_label_without_room_is_named(self):
        drawn = Drawn([(100, None, 1e-6, "embree", f"library number {i}") for i in range(100)])
        self.assertGreater(len(drawn.lost), 10)
        self.assertEqual(len(drawn.lost) + len(drawn.boxes), 100)

    def test_gamephys_is_above_other_points(self):
        drawing, axes = plt.subplots()
        panel(axes, "title", named(CAMERA_AT_BOXES), "ns", "error")
        order = {(line.get_marker(), line.get_color()): line.get_zorder() for line in axes.lines}
        plt.close(drawing)
        own = order.pop(LOOKS["gamephys"][::-1])
        self.assertGreater(own, max(order.values()))

    def test_text_is_readable_in_each_colour(self):
        for colour, _ in LOOKS.values():
            self.assertGreaterEqual(1.05 / (luminance(ink(colour)) + 0.05), 4.4)
        self.assertEqual(ink("#000000"), "#000000")


unittest.main()
