#!/usr/bin/env python3
"""What the figures of the report promise: test_figures.py. The status 77 says that matplotlib is not installed."""
import sys
import unittest

try:
    import matplotlib
except ImportError:
    print("python3-matplotlib is not installed")
    sys.exit(77)
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.text import Text

from cost_error import ErrorAxis, front, panel
from marks import place_labels


def draw(points):
    """Labels without room, and the boxes of the others, of a panel with these points."""
    drawing, axes = plt.subplots(figsize=(6, 3.9))
    parts = panel(axes, "title", points, "ns", "error")
    drawing.canvas.draw()
    lost = place_labels(*parts)
    drawing.canvas.draw()  # which brings the labels to their places
    boxes = [Text.get_window_extent(label) for label in axes.texts]  # without the line to the point
    plt.close(drawing)
    return lost, boxes


class Figures(unittest.TestCase):
    def test_front_is_what_nobody_beats_in_both(self):
        self.assertEqual(front([(3, 4), (1, 5), (4, 0), (2, 3), (5, 0)]), [(1, 5), (2, 3), (4, 0)])

    def test_no_error_is_below_all_errors_and_shares_end_at_one(self):
        axis = ErrorAxis([0, 1e-7, 1e-4], False)
        self.assertLess(axis(0), axis(1e-7))
        self.assertEqual(axis(1e-4) - axis(1e-7), 3)
        self.assertEqual(ErrorAxis([0.7, 0.2], True).high, 0)
        self.assertFalse(ErrorAxis([1e-3], False).zero)

    def test_labels_of_points_at_one_place_do_not_overlap(self):
        lost, boxes = draw([(100, 130, 1e-6, "embree", f"library number {i}") for i in range(6)])
        self.assertEqual((lost, len(boxes)), ([], 6))
        for i, box in enumerate(boxes):
            self.assertFalse(any(box.overlaps(other) for other in boxes[:i]))

    def test_a_label_without_room_is_named(self):
        lost, _ = draw([(100, 0, 1e-6, "embree", f"library number {i}") for i in range(200)])
        self.assertIn("library number 199", lost)


unittest.main()
