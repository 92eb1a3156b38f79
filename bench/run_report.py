#!/usr/bin/env python3
"""Measures for the report, part by part: run_report.py PROGRAMS DIRECTORY [--quick]

PROGRAMS is the folder of the benchmarks in a build; calls from other languages are measured if the build has their
packages. Each part writes its rows into DIRECTORY/PART; a part that is there already,
measured by the same programs, is not measured again, so an interrupted run goes on where it was. On a terminal a line
shows how far it is and how long it will take; otherwise each part that is done gets a line.
"""
import hashlib
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

# Case, and whether a quick report has it.
SOLVER = {"chain_30": True, "rope_1e3": True, "rope_1e6": False, "ropes_1000x30": True, "cloth_100": True, "cloth_100_bend": True,
          "ropes_threads": True, "cloth_300_threads": True, "free_1M": False, "free_100k": True, "ball_pit": True, "rope_over_post": True,
          "drape_over_mesh": False, "drape_within_2_percent": False}


OVERHEAD = Path(__file__).resolve().parent.parent / "bindings/overhead/measure.py"


def parts(quick, commands):
    """(name, program, arguments, seconds that it takes on a machine of two cores: for the first estimate)"""
    sizes = {1000: 15, 10000: 25} if quick else {1000: 65, 10000: 75, 100000: 340, 1000000: 430, 4000000: 260}
    extra = ["--quick"] if quick else []
    found = [(f"scene_{n}", "gamephys_bench", ["scene", f"--objects={n}", *extra], seconds) for n, seconds in sizes.items()]
    suites = {"accuracy": (25, 230), "mesh": (15, 390), "query": (25, 330), "update": (15, 480)}
    ordinary = [(suite, "gamephys_bench", [suite, *extra], seconds[not quick]) for suite, seconds in suites.items()]
    solver = [(f"solver_{case}", "gamephys_bench_solver", [case, *extra], 12 if quick else 35)
              for case, is_quick in SOLVER.items() if is_quick or not quick]
    # What the first figures show comes first, for those who look before the end.
    found += ordinary[:1] + solver + ordinary[1:]
    if commands.exists():
        found.append(("overhead", OVERHEAD, [str(commands), *extra], 15 if quick else 75))
    return found


def fingerprint(programs):
    """Of what is measured: the programs and the library."""
    digest = hashlib.sha256()
    for path in [programs / "gamephys_bench", programs / "gamephys_bench_solver", programs.parent / "libgamephys.so.1"]:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def span(seconds):
    return f"{seconds / 60:.0f} min" if seconds >= 90 else f"{seconds:.0f} s"


class Progress:
    def __init__(self, total):
        self.total, self.start, self.live = total, time.monotonic(), sys.stderr.isatty()

    def show(self, number, name, done, left):
        if self.live:
            filled = int(30 * done / max(done + left, 1e-9))
            print(f"\r\033[K[{'#' * filled}{'.' * (30 - filled)}] {number}/{self.total} {name}, {span(left)} left",
                  end="", file=sys.stderr, flush=True)

    def finished(self, number, name, seconds, kept):
        if not self.live:
            print(f"{number}/{self.total} {name}: {'measured before' if kept else span(seconds)}", file=sys.stderr, flush=True)


def measure(program, arguments, folder, is_first):
    """Runs one part in a folder that takes its name only when it is complete."""
    work = folder.with_name(folder.name + ".part")
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    load = 0 if is_first else os.getloadavg()[0] - 1  # at first that of the programs' own compilation
    start = time.monotonic()
    with (work / "log.txt").open("w") as log:
        status = subprocess.run([program, *arguments, f"--out={work}"], stdout=log, stderr=subprocess.STDOUT).returncode
    if status:
        print(file=sys.stderr)
        sys.exit(f"{program.name} {' '.join(arguments)} failed:\n{(work / 'log.txt').read_text()[-2000:]}")
    took = time.monotonic() - start
    # What others did to the machine: one is this run itself.
    (work / "took.json").write_text(json.dumps({"seconds": took, "load": max(load, os.getloadavg()[0] - 1)}))
    shutil.rmtree(folder, ignore_errors=True)
    work.rename(folder)
    return took


def main():
    programs, directory = Path(sys.argv[1]), Path(sys.argv[2])
    quick = "--quick" in sys.argv[3:]
    directory.mkdir(parents=True, exist_ok=True)
    mark, now = directory / "programs.txt", fingerprint(programs)
    if not mark.exists() or mark.read_text() != now:
        for folder in directory.glob("*/took.json"):
            shutil.rmtree(folder.parent)
        mark.write_text(now)
    todo = parts(quick, programs.parent / "bindings/overheads.txt")
    kept = {name for name, *_ in todo if (directory / name / "took.json").exists()}
    progress = Progress(len(todo))
    expected, passed = sum(part[3] for part in todo if part[0] not in kept), 0.0
    pace = 1.0
    for number, (name, program, arguments, seconds) in enumerate(todo, 1):
        progress.show(number, name, sum(p[3] for p in todo) - expected, expected * pace)
        took = 0
        if name not in kept:
            took = measure(programs / program, arguments, directory / name, passed == 0)
            passed += took
            expected -= seconds
            begun = sum(p[3] for p in todo[:number] if p[0] not in kept)
            pace = passed / begun
        progress.finished(number, name, took, name in kept)
    if progress.live:
        print(file=sys.stderr)


main()
