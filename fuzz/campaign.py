#!/usr/bin/env python3
"""Runs all fuzz targets for some minutes: campaign.py MINUTES OPTIMISED SANITIZED WORK

OPTIMISED and SANITIZED are the folders of two builds. Half of the time goes to each:

- optimised: random programs, the same ones on every instruction set, whose digests must be equal;
- sanitized: libFuzzer, which looks for inputs that reach new code, with clang's address and undefined-behaviour
  sanitizers, starting from the committed corpus and what earlier runs left in WORK.

What libFuzzer has found is then replayed by the optimised build on every instruction set. Inputs that break
something are kept in WORK/findings. The last line is "N passed, N failed".
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time

targets = ["shapes", "mesh", "world", "snapshot"]
here = pathlib.Path(__file__).resolve().parent
minutes, optimised, sanitized, work = float(sys.argv[1]), *map(pathlib.Path, sys.argv[2:5])
findings = work / "findings"
findings.mkdir(parents=True, exist_ok=True)
cores = os.cpu_count() or 1
passed = failed = 0
operations = {"optimised": 0, "sanitized": 0}


def instruction_sets():
    """Those that this processor has; the programs take an unknown name for the best."""
    flags = pathlib.Path("/proc/cpuinfo").read_text() if os.path.exists("/proc/cpuinfo") else ""
    have = [name for name in ("sse2", "avx2") if re.search(rf"\b{name}\b", flags)]
    if all(re.search(rf"\bavx512{part}\b", flags) for part in ("f", "vl", "dq", "bw")):
        have.append("avx512")
    return have or ["default"]


def report(name, good, text):
    global passed, failed
    passed, failed = passed + good, failed + (not good)
    print(f"{'ok    ' if good else 'FAILED'} {name}: {text}", flush=True)


def run_optimised(target, isa, *arguments):
    """(digest, operations, programs, findings, standard error); digest None if the process died."""
    command = [optimised / "fuzz" / f"fuzz_{target}", "--keep", findings, *map(str, arguments)]
    done = subprocess.run(command, env={**os.environ, "GAMEPHYS_ISA": isa}, capture_output=True, text=True)
    counted = re.search(r"(\d+) inputs replayed, (\d+) random programs, (\d+) operations, digest (\w+)", done.stdout)
    broken = set(re.findall(r"does not hold in \d+ programs: (.*)", done.stdout))
    if not counted:
        return None, 0, 0, {f"the process ended with {done.returncode}"}, done.stderr
    return counted[4], int(counted[3]), int(counted[1]) + int(counted[2]), broken, done.stderr


def compare(target, runs, broken):
    """Runs of the same programs on all instruction sets."""
    for digest, count, _, found, _ in runs:
        operations["optimised"] += count
        broken |= found
    if len({digest for digest, *_ in runs}) != 1:
        broken.add("instruction sets differ")


def random_programs(seconds):
    isas = instruction_sets()
    broken = {target: set() for target in targets}
    totals = {target: [0, 0] for target in targets}
    # As many programs as take some ten seconds.
    sizes = {target: max(100, run_optimised(target, isas[0], "--seconds", 2)[2] * 4) for target in targets}
    end, seed = time.monotonic() + seconds, int(time.time()) & 0xFFFFFF
    print(f"optimised: random programs on {' '.join(isas)}, seeds from {seed}", flush=True)
    with concurrent.futures.ThreadPoolExecutor(cores) as pool:
        while time.monotonic() < end:
            for target in targets:
                jobs = [pool.submit(run_optimised, target, isa, "--seed", seed, "--programs", sizes[target])
                        for isa in isas]
                runs = [job.result() for job in jobs]
                compare(target, runs, broken[target])
                totals[target][0] += sum(run[1] for run in runs)
                totals[target][1] += sum(run[2] for run in runs)
            seed += 1
    for target in targets:
        text = f"{totals[target][0]:,} operations in {totals[target][1]:,} programs"
        report(f"optimised {target}", not broken[target], "; ".join([text, *sorted(broken[target])]))
    return isas


def search(target, isa, seconds):
    """libFuzzer for so long: it ends at a finding and is started again, a few times at most."""
    corpus = work / "corpus" / target
    corpus.mkdir(parents=True, exist_ok=True)
    end, count, covered, points, broken = time.monotonic() + seconds, 0, 0, 0, set()
    for _ in range(8):
        left = int(end - time.monotonic())
        if left < 2:
            break
        command = [sanitized / "fuzz" / f"fuzz_{target}", f"-max_total_time={left}", "-timeout=60", "-max_len=4096",
                   "-rss_limit_mb=4096", f"-artifact_prefix={findings}/{target}-", "-print_final_stats=1",
                   corpus, here / "corpus" / target]
        done = subprocess.run(command, env={**os.environ, "GAMEPHYS_ISA": isa}, capture_output=True, text=True,
                              errors="replace")
        count += sum(map(int, re.findall(rf"^{target}: (\d+) operations", done.stderr, re.M)))
        covered = max([covered, *map(int, re.findall(r"cov: (\d+)", done.stderr))])
        points = max([points, *map(int, re.findall(r"\((\d+) inline 8-bit counters\)", done.stderr))])
        if done.returncode == 0:
            break
        why = re.search(r"does not hold: .*|ERROR: \w+Sanitizer: \S+.*|runtime error: .*|ERROR: libFuzzer: .*",
                        done.stderr)
        broken.add(why[0] if why else f"the process ended with {done.returncode}")
        (findings / f"{target}-{isa}.log").write_text(done.stderr)
    return target, isa, count, covered, points, broken


def coverage_guided(seconds, isas):
    # The widest and the plainest instruction set: what lies between them is compared by digests.
    pairs = [(target, isa) for target in targets for isa in (isas[-1], isas[0])]
    each = seconds * cores / len(pairs)
    print(f"sanitized: libFuzzer, {each:.0f} s for each target and instruction set", flush=True)
    with concurrent.futures.ThreadPoolExecutor(cores) as pool:
        for target, isa, count, covered, points, broken in pool.map(lambda pair: search(*pair, each), pairs):
            operations["sanitized"] += count
            text = f"{count:,} operations, {covered:,} of {points:,} edges covered"
            report(f"sanitized {target} {isa}", not broken, "; ".join([text, *sorted(broken)]))


def replays(isas):
    for target in targets:
        broken = set()
        found = [work / "corpus" / target] if any((work / "corpus" / target).iterdir()) else []
        runs = [run_optimised(target, isa, *found, here / "corpus" / target) for isa in isas]
        compare(target, runs, broken)
        report(f"replayed {target}", not broken, "; ".join([f"{runs[0][2]:,} inputs", *sorted(broken)]))


isas = random_programs(minutes * 30)
coverage_guided(minutes * 30, isas)
replays(isas)
total = sum(operations.values())
print(f"operations: {operations['optimised']:,} optimised + {operations['sanitized']:,} sanitized = {total:,}")
if failed:
    print(f"inputs are kept in {findings}")
print(f"{passed} passed, {failed} failed")
sys.exit(failed != 0)
