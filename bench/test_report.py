#!/usr/bin/env python3
"""What the tables and sentences of the report promise: test_report.py"""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from panels import answer_panels, ordinary_panels, solver_panels, unstable
from report import linked_from, thread_table
from solver_comparison import comparison
from verdicts import against_fastest, against_most_exact, hard_input, sentences, summary, unstable_methods, verdict


def row(value, error, unit="relative"):
    return {"value": value, "lower_quartile": value, "median": value, "upper_quartile": 1.1 * value, "unit": "ns", "error": error,
            "error_unit": unit}


def solver_row(case, method, substeps, ms, strain, position=""):
    return {"case": case, "method": method, "substeps": str(substeps), "ms": str(ms), "strain_max": strain, "position_error": position,
            "ms_lower_quartile": str(ms), "ms_upper_quartile": str(ms)}


def cells(table, what):
    """The cells of the row of a Markdown table that begins with a text."""
    return next([cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith(f"| {what}"))


ROPE = [solver_row("rope_1e3", "gamephys", 2, 0.2, "1e-4"), solver_row("rope_1e3", "gamephys", 8, 0.5, "5e-5"),
        solver_row("rope_1e3", "xpbd", 100, 2, "0.4"), solver_row("rope_1e3", "xpbd", 1000, 20, "0.04"),
        solver_row("rope_1e3", "explicit_euler", 100, 1, "inf")]


class Summary(unittest.TestCase):
    def test_others_that_are_wrong_count_only_where_all_are(self):
        rows = {("sweep_sphere", 100000): {"gamephys": row(600, 0), "bullet": row(12000, 5e-4, "WRONG_FRACTION")},
                ("segment", 100000): {"gamephys": row(200, 0), "bullet": row(100, 1e-2, "WRONG_FRACTION"), "embree": row(400, 8e-6)}}
        table = summary(rows, [])
        sweep = cells(table, "a sphere swept")
        self.assertEqual(sweep[3:9], ["Bullet", "12,000 ns", "0.05", "0", "0.05 % wrong", ""])
        self.assertEqual(sweep[9], "🟢 faster, more exact")
        self.assertEqual(cells(table, "a segment")[3], "Embree")

    def test_solver_has_the_most_exact_other_and_our_cheapest_as_exact(self):
        line = cells(summary({}, ROPE), "a rope with a weight of 1000 links")
        self.assertEqual(line[0], "a rope with a weight of 1000 links, per frame, gamephys 2")
        self.assertEqual(line[2:], ["0.2 ms", "XPBD 1000", "20 ms", "0.01", "0.01 %", "4 %", "0.0025", "🟢 faster, more exact"])

    def test_green_is_ahead_in_time_and_not_behind_in_error(self):
        self.assertEqual(verdict(0.5, 0, 0), "🟢 faster, as exact")
        self.assertEqual(verdict(0.5, 1e-3, 0), "🔴 faster, less exact")
        self.assertEqual(verdict(2, 0, 1e-3), "🔴 slower, more exact")
        self.assertEqual(verdict(1, 0, 1e-3), "⚪ as fast, more exact")
        self.assertEqual(verdict(0.5, None, None), "🟢 faster")


class Panels(unittest.TestCase):
    rays = {("scene_ray_rows", 100000): {"gamephys": row(140, 0), "gamephys_2_threads": row(80, 0), "gamephys_16_threads": row(20, 0),
                                         "gamephys_2_apart": row(70, 0),
                                         "embree": row(310, 4e-7), "embree_packets": row(100, 4e-7), "bullet": row(9000, 0.02, "WRONG_FRACTION")},
            ("scene_single_rows", 100000): {"gamephys": row(450, 0), "embree": row(300, 4e-7)},
            ("scene_distance_camera", 100000): {"gamephys": row(130, 0), "gamephys_2_threads": row(70, 0)}}

    def test_ordinary_work_has_settings_and_packets_but_nobody_who_is_wrong(self):
        (panel,), labels = ordinary_panels(self.rays)
        self.assertEqual(panel[0], "A ray of a camera at boxes (100,000)")
        self.assertEqual({label for *_, label in panel[1]},
                         {"gamephys, batch", "gamephys, one call", "gamephys, distance only, in tiles", "gamephys, 16 threads", "Embree",
                          "Embree packets"})
        self.assertEqual([cost for cost, *_, label in panel[1] if label == "Embree"], [310])
        self.assertEqual(labels, ["largest relative error"])

    def test_answers_have_packets_and_leave_out_work_in_which_all_are_right(self):
        panels, right = answer_panels({**self.rays, ("nearest_box", 100000): {"gamephys": row(600, 0), "embree": row(1200, 7e-5)}})
        self.assertEqual([title for title, _ in panels], ["A ray of a camera at boxes (100,000)"])
        errors = {label: error for _, _, error, _, label in panels[0][1]}
        self.assertEqual(errors, {"gamephys": 0, "gamephys, 16 threads": 0, "Embree": 0, "Embree packets": 0, "Bullet": 0.02})
        self.assertEqual(right, ["the nearest box to a point"])

    def test_unstable_methods_have_no_point_and_are_named(self):
        panels, labels = solver_panels(ROPE)
        self.assertEqual([label for *_, label in panels[0][1]], ["gamephys 2", "gamephys 8", "XPBD 100", "XPBD 1000"])
        self.assertEqual(labels, ["largest strain"])
        self.assertEqual(unstable(ROPE)[panels[0][0]], ["explicit Euler 100"])
        self.assertIn("explicit Euler 100 (Rope of 1000 links", unstable_methods(ROPE))
        self.assertEqual(unstable_methods(ROPE[:4]), "")


class Sentences(unittest.TestCase):
    def test_what_one_pays_and_gets(self):
        points = [(300, None, 0, "gamephys", "gamephys"), (200, None, 0.05, "embree", "Embree"), (900, None, 0, "bullet", "Bullet"),
                  (100, None, 0.5, "gamephys_float", "gamephys, float tests")]
        self.assertEqual(against_fastest(points, "false answers"),
                         "gamephys takes 1.5 times the time of Embree, the fastest other; its share of false answers is 0 instead of 5 %. "
                         "It takes 0.333 times the time of Bullet, the fastest that is as exact.")

    def test_of_hard_input(self):
        panels = [("Tangents", [(300, None, 0, "gamephys", "gamephys"), (200, None, 0.05, "embree", "Embree"), (900, None, 0.4, "bullet", "Bullet")]),
                  ("Corners", [(100, None, 0, "gamephys", "gamephys"), (200, None, 0, "fcl", "FCL"), (50, None, 1, "gamephys_float", "float tests")])]
        self.assertEqual(hard_input(panels), {"others": "40 %", "library": "Bullet", "title": "Tangents", "own": "none", "least": "0.5", "most": "1.5"})

    def test_of_the_solver(self):
        panels, labels = solver_panels(ROPE)
        self.assertEqual(sentences(panels, labels, against_most_exact),
                         "- **Rope of 1000 links, weight of 1000 links**: gamephys 2 takes 0.01 times the time of XPBD 1000, the most exact "
                         "other; its largest strain is 0.01 % instead of 4 %.\n")


class Links(unittest.TestCase):
    text = "[speed](limits_of_speed.md#culling), ![energy](images/energy.png), ![drawn](images/drawn.png), [below](#every-row)"

    def test_a_page_in_another_folder_leads_to_docs_for_what_it_lacks(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "report.md"
            (page.parent / "images").mkdir()
            (page.parent / "images/drawn.png").touch()
            targets = [part.split(")")[0] for part in linked_from(page, self.text).split("](")[1:]]
            self.assertTrue((page.parent.resolve() / targets[0].removesuffix("#culling")).is_file())
            self.assertTrue((page.parent.resolve() / targets[1]).is_file())
            self.assertEqual(targets[2:], ["images/drawn.png", "#every-row"])

    def test_the_page_of_docs_stays_as_it_is(self):
        self.assertEqual(linked_from(Path(__file__).parent.parent / "docs/report.md", self.text), self.text)


class Threads(unittest.TestCase):
    def test_each_number_of_threads_has_columns(self):
        by = {"gamephys": row(100, 0), "gamephys_2_threads": row(50, 0), "gamephys_4_threads": row(40, 0), "gamephys_4_apart": row(25, 0)}
        solver = [solver_row("ropes_threads", "1_thread", 8, 6, "0"), solver_row("ropes_threads", "4_threads", 8, 2, "0")]
        table = thread_table({"query": {("segment", 1000): by, ("cull", 1000): by}}, solver)
        self.assertEqual(cells(table, "speed-up")[2:], ["2 threads", "2 independent threads", "4 threads", "4 independent threads"])
        self.assertEqual(cells(table, "a segment")[2:], ["2", "", "2.5", "4"])
        self.assertEqual(cells(table, "1000 ropes")[2:], ["", "", "3", ""])
        self.assertNotIn("cull", table)


class Comparison(unittest.TestCase):
    def test_rows_have_the_settings_and_errors_of_each_library(self):
        rows = [dict(solver_row("rope_1e3", "gamephys", 4, 0.5, "1e-4"), compression_max="0"), dict(solver_row("rope_1e3", "bullet", 10, 0.2, "51"), compression_max="0"),
                dict(solver_row("ball_pit", "gamephys", 8, 27, ""), position_error="0.004"), dict(solver_row("ball_pit", "bullet_substeps", 8, 107, ""), position_error="0.013"),
                dict(solver_row("cloth_100", "gamephys", 20, 4, "0.005"), compression_max="0.017"), dict(solver_row("cloth_100", "bullet", 10, 6, "inf"), compression_max="0.9")]
        text = comparison(rows, "Processor: some, 2 cores\n")
        self.assertEqual(cells(text, "rope of 1000 links")[1:], ["0.01 % in 0.5 ms (4 substeps)", "5,100 % in 0.2 ms", ""])
        self.assertEqual(cells(text, "2000 balls")[1:], ["4 mm in 27 ms (8 substeps)", "", "13 mm in 107 ms (8 substeps)"])
        self.assertEqual(cells(text, "cloth of 100")[2], "unstable in 6 ms")
        self.assertIn("by up to 1.7 %; Bullet's by up to 90 %", text)
        self.assertNotIn("free particles", text)  # which were not measured


unittest.main()
