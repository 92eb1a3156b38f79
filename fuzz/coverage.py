#!/usr/bin/env python3
"""Which lines and branches of src the tests reach: coverage.py BUILD [--ctest | --write | --missing | --by-test]

BUILD is a build by the preset "coverage", in which only the library counts. Runs the C tests, the C++ tests (each file
alone), on each instruction set the fuzz targets and tests of kernels, and the short soak, and prints a line for each
file of src. Lines of other platforms are not compiled and do not count, nor do those that only the
compiler runs. Each file and all together need 95 % of their lines, and each is a test; the last line is "N passed,
N failed". --ctest runs nothing: it reads BUILD/profiles, which the tests of test.sh have filled, and demands the 95 % of all
files together, as some parts are tested in the release build only. --write puts the table into
docs/reliability.md, --missing prints the lines that nothing reaches, --by-test writes BUILD/by_test.json: the time of
each test, and which tests enter each function, for mutate.py.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

least = 95.0
source = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1]).resolve()
profiles = build / "profiles"
by_ctest = "--ctest" in sys.argv
if not by_ctest:
    shutil.rmtree(profiles, ignore_errors=True)
    profiles.mkdir()


def tool(name):
    for found in (shutil.which(name), shutil.which(f"{name}-14")):
        if found:
            return found
    sys.exit(f"{name} is missing")


def run(job):
    index, (name, command, isa) = job
    environment = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / f"{index}.profraw")}
    if isa:
        environment["GAMEPHYS_ISA"] = isa
    begin = time.monotonic()
    done = subprocess.run(list(map(str, command)), env=environment, capture_output=True, text=True, errors="replace")
    seconds = time.monotonic() - begin
    return f"{name} {isa or ''}".strip(), seconds, done.returncode == 0, done.stdout[-400:] + done.stderr[-400:]


def reached_lines(text):
    """(file, line, how often) of an lcov trace."""
    file = ""
    for entry in text.splitlines():
        kind, _, rest = entry.partition(":")
        if kind == "SF":
            file = os.path.normpath(rest)
        elif kind == "DA":
            line, count = rest.split(",")[:2]
            yield file, int(line), int(count)


# What is compiled for each instruction set; the states of test_golden.c are of all of the solver.
kernels = ("scene", "closest_features", "triangle_packet", "box_kernels", "hit_kernels", "cloth_kernels",
           "rope_kernels", "float4")
programs = {"shapes": 30000, "mesh": 5000, "world": 8000, "snapshot": 4000}  # as in CMakeLists.txt: a few reach rare lines
# Of these what counts is the number of attempts, of which others make some: the words of a snapshot are changed by a
# fuzz target, and fast particles meet walls in other cases. "[.]" are those that only run when they are asked for.
left_to_others = ("test_solver_hostile_snapshot",)
many_attempts = ("[.]", '"nothing passes through a wall*"', '"cloth with a rope at a corner gains no energy*"',
                 '"of triangles of a mesh at equal t or distance*"')
tests_cpp = build / "tests_cpp/tests_cpp"
files = sorted(path.stem for path in (source / "tests_cpp").glob("test_*.cpp") if path.stem not in left_to_others)


def test_file(name, isa=None):
    chosen = f"[#{name}]" + "".join(f"~{left_out}" for left_out in many_attempts)
    return (name, [tests_cpp, "--filenames-as-tags", chosen], isa)


# The long ones first.
jobs = [test_file(name) for name in sorted(files, key=lambda name: not name.startswith("test_solver"))]
jobs += [(path.name, [path], None) for path in sorted((build / "tests_c").glob("c_test_*"))
         if os.access(path, os.X_OK) and path.is_file()]
for isa in ("scalar", "sse2", "avx2"):
    jobs += [test_file(f"test_{name}", isa) for name in kernels]
    jobs.append(("c_test_golden", [build / "tests_c/c_test_golden"], isa))
for target, count in programs.items():
    for isa, part in ((None, count), *((isa, count // 4) for isa in ("scalar", "sse2", "avx2"))):
        replay = [build / f"fuzz/fuzz_{target}", "--programs", part, "--keep", profiles, source / "fuzz/corpus" / target]
        jobs.append((f"fuzz_{target}", replay, isa))
jobs.append(("soak", [build / "fuzz/soak", "10000"], None))
passed = failed = 0
times = []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for name, seconds, good, text in pool.map(run, enumerate([] if by_ctest else jobs)):
        passed, failed = passed + good, failed + (not good)
        times.append((seconds, name))
        if not good:
            print(f"FAILED {name}: {text}", flush=True)
if times:
    print("seconds: " + ", ".join(f"{name} {seconds:.0f}" for seconds, name in sorted(times, reverse=True)[:8]))

data = build / "coverage.profdata"
subprocess.run([tool("llvm-profdata"), "merge", "-sparse", "-o", data, *sorted(profiles.glob("*.profraw"))], check=True)
binaries = sorted({str(command[0]) for _, command, _ in jobs})
objects = [binaries[0]] + [word for binary in binaries[1:] for word in ("-object", binary)]
sources = sorted(path for path in (source / "src").rglob("*") if path.is_file())


def llvm_cov(form, profile=data, binaries=objects):
    command = [tool("llvm-cov"), "export", f"-format={form}", "-instr-profile", profile, *binaries, *sources]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


functions = json.loads(llvm_cov("text"))["data"][0]["functions"]


def run_by_the_compiler():
    """(file, line) of the constexpr functions that no program enters: tables, which the compiler makes."""
    entered, ranges, text, lines = {}, {}, {}, set()
    for function in functions:
        first, last = function["regions"][0][0], function["regions"][0][2]
        where = (os.path.normpath(function["filenames"][0]), first)
        entered[where] = entered.get(where, 0) + function["count"]
        ranges[where] = last
    for (file, first), count in entered.items():
        if file not in text:
            text[file] = pathlib.Path(file).read_text().split("\n")
        if count == 0 and re.search(r"(?<!if )constexpr", " ".join(text[file][max(first - 2, 0):first])):
            lines |= {(file, line) for line in range(first, ranges[file, first] + 1)}
    return lines


def percent(part):
    return 100.0 * part[0] / part[1] if part[1] else 100.0


def row(name, lines, branches):
    return f"| {name} | {lines[1]:,} | {percent(lines):.1f} | {branches[1]:,} | {percent(branches):.1f} |"


def branches():
    """(file, line), and whether it is taken, of each way of each branch, in whatever instance of a template."""
    ways = {}
    for function in functions:
        for *place, if_true, if_false, file, _, _ in function["branches"]:
            for way, count in ((True, if_true), (False, if_false)):
                key = (os.path.normpath(function["filenames"][file]), *place, way)
                ways[key] = ways.get(key, 0) + count
    return [(key[0], key[1], count > 0) for key, count in ways.items()]


# Of each file: [reached, all] lines and branches, and the lines that nothing reaches.
left_out = run_by_the_compiler()
found, missing = {}, {}
for file, line, count in reached_lines(llvm_cov("lcov")):
    parts = found.setdefault(file, ([0, 0], [0, 0]))
    if (file, line) not in left_out:
        parts[0][0] += count > 0
        parts[0][1] += 1
        if count == 0:
            missing.setdefault(file, []).append(line)
for file, line, reached in branches():
    if (file, line) not in left_out and file in found:
        found[file][1][0] += reached
        found[file][1][1] += 1

rows = []
totals = ([0, 0], [0, 0])
for file, parts in found.items():
    if parts[0][1] == 0 or source / "src" not in pathlib.Path(file).parents:
        continue
    name = str(pathlib.Path(file).relative_to(source / "src"))
    good = by_ctest or percent(parts[0]) >= least
    if not by_ctest:
        passed, failed = passed + good, failed + (not good)
    rows.append((name, row(f"`{name}`", *parts), good))
    for total, part in zip(totals, parts):
        total[0] += part[0]
        total[1] += part[1]
good = percent(totals[0]) >= least
passed, failed = passed + good, failed + (not good)
rows.sort()
rows.insert(0, ("", row("all", *totals), good))
table = ["| file of `src` | lines | reached, % | branches | reached, % |", "|---|---:|---:|---:|---:|"]
table += [text for _, text, _ in rows]
print("\n".join(table))
for name, _, good in rows:
    if not good:
        print(f"FAILED {name or 'all'}: less than {least:.0f} % of the lines")

if "--missing" in sys.argv:
    for file, lines in sorted(missing.items()):
        if source / "src" not in pathlib.Path(file).parents:
            continue
        text = pathlib.Path(file).read_text().split("\n")
        for line in lines:
            print(f"{pathlib.Path(file).relative_to(source)}:{line}: {text[line - 1].strip()}")
if "--by-test" in sys.argv:
    # Of each test on the widest instruction set, its time; of each function of src its lines, and the tests that enter it.
    places = {}
    for function in functions:
        regions = [region for region in function["regions"] if region[5] == 0]
        file = pathlib.Path(os.path.normpath(function["filenames"][0]))
        if source / "src" in file.parents:
            place = (str(file.relative_to(source)), min(region[0] for region in regions), max(region[2] for region in regions))
            places[function["name"]] = place
    by_test = {"seconds": {}, "functions": {}}
    for (index, (name, _, isa)), (seconds, _) in zip(enumerate(jobs), times):
        if isa:
            continue
        by_test["seconds"][name] = seconds
        command = [tool("llvm-profdata"), "show", "--all-functions", profiles / f"{index}.profraw"]
        function, entered = "", set()
        for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
            if line.startswith("    Function count: ") and line[20:] != "0" and function in places:
                entered.add(places[function])
            elif line.startswith("  ") and line[2] != " " and line.endswith(":"):
                function = line[2:-1]
        for file, first, last in entered:
            by_test["functions"].setdefault(file, {}).setdefault(f"{first} {last}", []).append(name)
    (build / "by_test.json").write_text(json.dumps(by_test))
if "--write" in sys.argv:
    page = source / "docs/reliability.md"
    begin, end = "<!-- coverage -->\n", "<!-- /coverage -->"
    before, rest = page.read_text().split(begin)
    page.write_text(before + begin + "\n".join(table) + "\n" + end + rest.split(end)[1])
print(f"{passed} passed, {failed} failed")
sys.exit(failed != 0)
