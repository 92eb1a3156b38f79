#!/usr/bin/env python3
"""Changes the library in small ways and looks whether the tests notice: mutate.py BUILD SECONDS [SEED [FILE...]]

BUILD is a finished build by the preset "release". Until the time is over, one token of one file is changed at random
(an operator, a comparison, a constant, a condition), the file compiled, the tests linked with that object before the
archive, and run. Prints each change that no test noticed, and in the end how many there were. FILEs: of src; by default
src/geometry, src/bvh, src/mesh and the checks of snapshots.
Which tests are run says build/coverage/by_test.json (coverage.py --by-test): those that enter the function around the
changed line, the quickest first, the C tests of recorded bits last. For a line outside of all functions, such as that
of a constant, they are the tests that enter any function of the file.
A change that compiles to the same bits as before is left out. One by which a test takes several times the processor
time that it takes otherwise, which may be an endless loop, is counted apart, and so is one that no test reaches.
"""

import concurrent.futures
import itertools
import json
import os
import pathlib
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import time

source = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1]).resolve()
by_test = json.loads((source / "build/coverage/by_test.json").read_text())
end = time.monotonic() + float(sys.argv[2])
chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)

default = [*source.glob("src/geometry/*.cpp"), *source.glob("src/bvh/*.cpp"), *source.glob("src/mesh/*.cpp"),
           source / "src/solver/snapshot/snapshot_check.cpp"]
files = [source / name for name in sys.argv[4:]] or sorted(default)

programs = {"shapes": 2000, "mesh": 300, "world": 600, "snapshot": 60}

# clang-format puts spaces around binary operators, and around nothing else.
swaps = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" < ", " > "), (" == ", " != "),
         (" != ", " == "), (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "), (" * ", " + "),
         (" | ", " & "), (" & ", " | "), ("std::min(", "std::max("), ("std::max(", "std::min("), ("true", "false"),
         ("false", "true"), ("return false;", "return true;"), (" += ", " -= ")]
rules = [(re.compile(re.escape(old)), new) for old, new in swaps]
rules += [(re.compile(r"(?<![\w.])([0-9])(?![\w.])"), lambda m: str(int(m[1]) + 1)),
          (re.compile(r"0x1p-(\d+)"), lambda m: f"0x1p-{int(m[1]) * 2}"),
          (re.compile(r"(?<![\w.])(\d+\.\d+)(?![\w.])"), lambda m: str(float(m[1]) * 2)),
          (re.compile(r"\bif \((?!constexpr)"), "if (!("), (re.compile(r"\bbreak;"), ";"), (re.compile(r"\bcontinue;"), ";")]


def mutants(text):
    """(line number, old line, new line) of all changes."""
    for number, line in enumerate(text.split("\n")):
        code = line.split("//")[0]
        if not code.strip() or code.lstrip().startswith("#") or "static_assert" in code or "template" in code:
            continue
        for pattern, new in rules:
            for match in pattern.finditer(code):
                changed = code[:match.start()] + (new(match) if callable(new) else new) + code[match.end():]
                if new == "if (!(":
                    closing = re.search(r"\)(?= \{|( [a-z]| return).*;$)", changed[match.start():])
                    if not closing:
                        continue
                    at = match.start() + closing.end()
                    changed = changed[:at] + ")" + changed[at:]
                yield number, line, changed


database = json.loads(subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout)
compilers = {}
for entry in database:
    if entry["file"].endswith(".cpp") and "/src/" in str(pathlib.Path(build, entry["file"]).resolve()):
        compilers.setdefault(pathlib.Path(build, entry["file"]).resolve(), []).append(entry["command"])


def link_command(target):
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True, text=True, check=True).stdout
    return lines.strip().split("\n")[-1]


def program_of(test):
    if test.startswith("fuzz_") or test == "soak":
        return f"fuzz/{test}"
    return f"tests_c/{test}" if test.startswith("c_") else "tests_cpp/tests_cpp"


links = {name: link_command(name) for name in {program_of(test) for test in by_test["seconds"]}}


def best(commands):
    """Of a kernel, that of the widest instruction set, which runs here; its peers stay as they were."""
    for isa in ("avx512", "avx2", "sse2"):
        for command in commands:
            if f"GPHYS_ISA={isa}" in command:
                return command
    return commands[0]


def run(arguments, seconds, folder):
    """The status that the program ended with, or None if it took more processor time, or waited for ever."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        done = subprocess.run(list(map(str, arguments)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=20 * seconds, cwd=folder, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return None
    return None if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else done.returncode


def findings(target):
    command = [build / f"fuzz/fuzz_{target}", "--programs", programs[target], "--seed", 7, "--keep", tempfile.gettempdir()]
    text = subprocess.run(list(map(str, command)), capture_output=True, text=True, errors="replace").stdout
    return re.findall(r"does not hold in \d+ programs: (.*)", text)


ignored = {target: [word for check in findings(target) for word in ("--ignore", check)] for target in programs}


def compiled(file, text, folder, name):
    changed = folder / file.name
    changed.write_text(text)
    command = best(compilers[file])
    words = shlex.split(command)
    words = words[:words.index("&&")] if "&&" in words else words
    words[words.index("-o") + 1] = str(folder / name)
    words[words.index("-c") + 1] = str(changed)
    for option in ("-MF", "-MT"):
        if option in words:
            words[words.index(option) + 1] = str(folder / "ignored.d")
    # Headers beside the file are found as they are by the others; warnings matter to nobody here.
    words += ["-I", str(file.parent), "-w", "-O1", "-g0"]
    good = run(words, 400, build) == 0
    return folder / name if good else None


def linked(name, object_file, folder):
    command = links[name].split("&&")
    words = shlex.split(command[1] if len(command) > 1 and ":" in command[0] else command[0])
    out = folder / pathlib.Path(name).name
    at = words.index("-o")
    words[at + 1] = str(out)
    words.insert(at + 2, str(object_file))
    # The C tests are linked with an installed copy, which takes no other object.
    words = [word for word in words if not word.startswith("-Wl,-rpath")]
    words = ["libgamephys.a" if word.startswith("stage/") else word for word in words]
    words += ["-lstdc++", "-pthread"]
    return out if run(words, 200, build) == 0 else None


originals, lock = {}, threading.Lock()


def code_of(object_file):
    """What the object does, without the names of files."""
    stripped = object_file.with_suffix(".bin")
    subprocess.run(["objcopy", "--strip-debug", object_file, stripped], check=True)
    return subprocess.run(["objdump", "-d", "-s", "-j", ".text", "-j", ".rodata", stripped], capture_output=True, text=True,
                          errors="replace").stdout.split("\n", 3)[-1]


def tests_of(file, number):
    """The tests that enter the function around the line, the quickest first, the recorded bits last."""
    functions = by_test["functions"].get(str(file.relative_to(source)), {})
    around = [tests for place, tests in functions.items()
              if int(place.split()[0]) <= number + 1 <= int(place.split()[1])] or functions.values()
    return sorted(set().union(*around), key=lambda test: ("golden" in test, by_test["seconds"][test]))


def judge(mutant):
    """What came of it: "same", "broken", "took too long", "not reached", who noticed, or None if nobody did."""
    file, number, _, new_line = mutant
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with lock:
            if file not in originals:
                made = compiled(file, file.read_text(), folder, "original.o")
                originals[file] = code_of(made) if made else None
        lines = file.read_text().split("\n")
        lines[number] = new_line
        object_file = compiled(file, "\n".join(lines), folder, "mutant.o")
        if not object_file:
            return "broken"
        if code_of(object_file) == originals[file]:
            return "same"
        tests = tests_of(file, number)
        made = {}
        for test in tests:
            program = program_of(test)
            if program not in made:
                made[program] = linked(program, object_file, folder)
            if not made[program]:
                return "broken"
            arguments = [made[program]]
            target = test.removeprefix("fuzz_")
            if target in programs:
                arguments += ["--programs", programs[target], "--seed", 7, "--keep", folder, *ignored[target],
                              source / "fuzz/corpus" / target]
            elif test == "soak":
                arguments += [2000]
            elif program == "tests_cpp/tests_cpp":
                arguments += ["--filenames-as-tags", "-a", f"[#{test}]~[.]"]
            status = run(arguments, int(10 + 5 * by_test["seconds"][test]), folder)
            if status != 0:
                return "took too long" if status is None else "C tests of recorded bits" if "golden" in test else (
                    "fuzz targets" if program.startswith("fuzz") else "C++ tests" if program.startswith("tests_cpp") else "C tests")
        return None if tests else "not reached"


def sample():
    """Each file in turn, so that large ones do not take all."""
    known = {}
    for file in files:
        all_of_it = [(file, *mutant) for mutant in mutants(file.read_text())]
        chance.shuffle(all_of_it)
        known[file] = iter(all_of_it)
    for mutant in itertools.chain.from_iterable(itertools.zip_longest(*known.values())):
        if time.monotonic() > end:
            return
        if mutant:
            yield mutant


counts = {}
workers = os.cpu_count() or 1
with concurrent.futures.ThreadPoolExecutor(workers) as pool:
    waiting, mutant_stream = {}, sample()
    for mutant in itertools.islice(mutant_stream, workers):
        waiting[pool.submit(judge, mutant)] = mutant
    while waiting:
        done, _ = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
        for job in done:
            mutant = waiting.pop(job)
            verdict = job.result() or "survived"
            counts[verdict] = counts.get(verdict, 0) + 1
            if verdict == "survived":
                file, number, old, new = mutant
                print(f"survived {file.relative_to(source)}:{number + 1}\n  - {old.strip()}\n  + {new.strip()}", flush=True)
            following = next(mutant_stream, None)
            if following:
                waiting[pool.submit(judge, following)] = following
noticed = sum(count for verdict, count in counts.items() if verdict not in ("survived", "same", "broken", "took too long", "not reached"))
print(", ".join(f"{verdict}: {count}" for verdict, count in sorted(counts.items())))
print(f"{noticed} of {noticed + counts.get('survived', 0)} changes noticed")
