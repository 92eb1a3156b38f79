#!/usr/bin/env python3
"""Runs every program that measures, and writes measured.csv beside this file: measure.py COMMANDS
For a report: measure.py COMMANDS --out=DIRECTORY [--quick]

COMMANDS has a line for each language: its name, a tab, the command. Languages take turns, so that
a slow moment of the machine hits all of them, and the least time of each case counts.
For a report, overhead.csv is written into the directory instead, and a language whose program fails is left out,
with a line on the error stream; --quick is one round.
"""
import csv
import platform
import subprocess
import sys
from pathlib import Path

ROUNDS = 5


def processor():
    """Its name, and its generation: virtual machines shorten the name."""
    said = {}
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        name, _, value = line.partition(":")
        said.setdefault(name.strip(), value.strip())
    if not {"model name", "cpu family", "model"} <= said.keys():
        return said.get("model name") or platform.processor()
    return f"{said['model name']} (family {said['cpu family']}, model {said['model']})"


def measure(commands, rounds, all_must_run):
    """{(language, case): ns}"""
    best, failed = {}, set()
    for _ in range(rounds):
        for language, command in commands:
            if language in failed:
                continue
            run = subprocess.run(command, shell=True, check=all_must_run, stdout=subprocess.PIPE, text=True)
            if run.returncode:
                print(f"left out: {language}", file=sys.stderr)
                failed.add(language)
                continue
            for name, case, ns in csv.reader(run.stdout.splitlines()):
                if name != language:
                    raise SystemExit(f"{command} says that it is {name}")
                best[name, case] = min(float(ns), best.get((name, case), float("inf")))
    return {key: ns for key, ns in best.items() if key[0] not in failed}


def main():
    with open(sys.argv[1]) as file:
        commands = [line.rstrip("\n").split("\t") for line in file if line.strip()]
    directory = next((Path(option[len("--out="):]) for option in sys.argv[2:] if option.startswith("--out=")), None)
    best = measure(commands, 1 if "--quick" in sys.argv[2:] else ROUNDS, directory is None)
    path = directory / "overhead.csv" if directory else Path(__file__).with_name("measured.csv")
    with path.open("w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["language", "case", "ns", "processor"])
        rows.writerows([*key, f"{ns:.2f}", processor()] for key, ns in best.items())


if __name__ == "__main__":
    main()
