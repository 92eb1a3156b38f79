#!/usr/bin/env python3
"""What a run of the report promises, with programs that measure nothing: test_run_report.py"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

RUN = Path(__file__).parent / "run_report.py"
PROGRAM = """#!/bin/sh
for argument; do case $argument in --out=*) folder=${argument#--out=} ;; esac; done
case "$*" in *"$(cat %s)"*) echo broken off; exit 1 ;; esac
echo row >"$folder/rows.csv"
"""


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "build/bench").mkdir(parents=True)
        self.breaks_at("nowhere")
        (self.root / "build/libgamephys.so.1").write_text("a library")
        for name in ("gamephys_bench", "gamephys_bench_solver"):
            (self.root / "build/bench" / name).write_text(PROGRAM % (self.root / "breaks"))
            (self.root / "build/bench" / name).chmod(0o755)

    def breaks_at(self, what):
        (self.root / "breaks").write_text(what)

    def run_report(self):
        done = subprocess.run([sys.executable, RUN, self.root / "build/bench", self.root / "work", "--quick"],
                              stderr=subprocess.PIPE, text=True)
        return done.returncode, done.stderr

    def test_an_interrupted_run_goes_on_where_it_was(self):
        self.breaks_at("chain_30")
        status, said = self.run_report()
        self.assertNotEqual(status, 0)
        self.assertIn("chain_30 --quick failed:\nbroken off", said)
        kept = sorted(path.parent.name for path in self.root.glob("work/*/took.json"))
        self.assertEqual(kept, ["accuracy", "scene_1000", "scene_10000"])
        self.breaks_at("nowhere")
        status, said = self.run_report()
        self.assertEqual(status, 0)
        self.assertEqual(said.count("measured before"), len(kept))
        self.assertEqual(self.run_report()[1].count("measured before"), said.count("\n"))

    def test_another_library_is_measured_anew(self):
        self.run_report()
        (self.root / "build/libgamephys.so.1").write_text("another library")
        status, said = self.run_report()
        self.assertEqual((status, said.count("measured before")), (0, 0))

    def test_a_log_has_a_line_for_each_part_and_no_progress_bar(self):
        said = self.run_report()[1]
        self.assertNotRegex(said, "[\r\033#]")
        self.assertEqual(said.count("\n"), len(list(self.root.glob("work/*/took.json"))))


unittest.main()
