#!/usr/bin/env python3
"""Which lines and branches of src the tests reach: coverage.py BUILD

BUILD is a build by the preset "coverage". Runs the C tests, the C++ tests (on each instruction set those of what is
compiled for each), the fuzz targets and the short soak, and prints a line for each file of src. Lines of other
platforms are not compiled and do not count. Each file and all together need 95 % of their lines, and each is a test;
the last line is "N passed, N failed".
"""

import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

least = 95.0
source = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1]).resolve()
profiles = build / "profiles"
shutil.rmtree(profiles, ignore_errors=True)
profiles.mkdir()


def tool(name):
    for found in (shutil.which(name), shutil.which(f"{name}-14")):
        if found:
            return found
    sys.exit(f"{name} is missing")


def run(job):
    index, (command, isa) = job
    environment = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / f"{index}.profraw")}
    if isa:
        environment["GAMEPHYS_ISA"] = isa
    done = subprocess.run(list(map(str, command)), env=environment, capture_output=True, text=True, errors="replace")
    name = " ".join([pathlib.Path(command[0]).name, isa or ""]).strip()
    return name, done.returncode == 0, done.stdout[-400:] + done.stderr[-400:]


kernels = "*octree*,*mesh*,*scene*,*solver*,*rope*,*cloth*,*particle*"
jobs = [([path], None) for path in sorted((build / "tests_c").glob("c_test_*")) if os.access(path, os.X_OK) and path.is_file()]
jobs.append(([build / "tests_cpp/tests_cpp"], None))
jobs += [([build / "tests_cpp/tests_cpp", kernels], isa) for isa in ("scalar", "sse2", "avx2")]
for target in ("shapes", "mesh", "world", "snapshot"):
    jobs.append(([build / f"fuzz/fuzz_{target}", "--seconds", "10", "--keep", profiles, source / "fuzz/corpus" / target], None))
jobs.append(([build / "fuzz/soak", "10000"], None))
passed = failed = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for name, good, text in pool.map(run, enumerate(jobs)):
        passed, failed = passed + good, failed + (not good)
        if not good:
            print(f"FAILED {name}: {text}")

data = build / "coverage.profdata"
subprocess.run([tool("llvm-profdata"), "merge", "-sparse", "-o", data, *sorted(profiles.glob("*.profraw"))], check=True)
binaries = sorted({str(command[0]) for command, _ in jobs})
objects = [binaries[0]] + [word for binary in binaries[1:] for word in ("-object", binary)]
exported = subprocess.run([tool("llvm-cov"), "export", "-summary-only", "-instr-profile", data, *objects],
                          capture_output=True, text=True, check=True)
rows = []
for file in json.loads(exported.stdout)["data"][0]["files"]:
    name = pathlib.Path(file["filename"])
    if source / "src" in name.parents:
        summary = file["summary"]
        rows.append((str(name.relative_to(source)), summary["lines"], summary["branches"]))


def percent(part):
    return 100.0 * part["covered"] / part["count"] if part["count"] else 100.0


print(f"{'file':<48} {'lines':>6} {'%':>6} {'branches':>9} {'%':>6}")
totals = ({"covered": 0, "count": 0}, {"covered": 0, "count": 0})
for name, lines, branches in sorted(rows):
    good = percent(lines) >= least
    passed, failed = passed + good, failed + (not good)
    mark = "" if good else "  too few lines"
    print(f"{name:<48} {lines['count']:>6} {percent(lines):>6.1f} {branches['count']:>9} {percent(branches):>6.1f}{mark}")
    for total, part in zip(totals, (lines, branches)):
        total["covered"] += part["covered"]
        total["count"] += part["count"]
lines, branches = totals
good = percent(lines) >= least
passed, failed = passed + good, failed + (not good)
print(f"{'all':<48} {lines['count']:>6} {percent(lines):>6.1f} {branches['count']:>9} {percent(branches):>6.1f}")
print(f"{passed} passed, {failed} failed")
sys.exit(failed != 0)
