#!/usr/bin/env bash
# The header tells which functions allocate: those that create or add, and those whose comments say so. Each of them is
# called in the tests where memory runs out (tests_c/test_faults_*.c), and what allocates there is one of them.
source "$SOURCE/tests_package/common.sh"

for session in scenes solvers; do
    # They print what the undisturbed run does, whatever fails later.
    GPHYS_PRINT_ALLOCATING=1 GPHYS_FAULTS_EVERY=1000 "$BUILD/tests_c/c_test_faults_$session" >run.txt 2>&1 || fail "$(tail -5 run.txt)"
    sed -nE 's/^allocates: (gphys_\w+)\(.*/\1/p' run.txt
done | sort -u >seen.txt
[ "$(wc -l <seen.txt)" -ge 20 ] || fail "only these are seen to allocate: $(cat seen.txt)"

python3 "$SOURCE/cmake/interface/describe.py" "$SOURCE/include/gamephys_c.h" --quick >api.json
python3 - "$SOURCE"/tests_c/test_faults_*.c "$SOURCE/tests_c/faults.h" >wrong.txt <<'END'
import json, re, sys
functions = json.load(open("api.json"))["functions"]
told = {f["name"] for f in functions if re.search(r"_(create|add)(_|$)", f["name"])
        or re.search(r"[Aa]llocates|OUT_OF_MEMORY|as there is memory", f["doc"])}
told.discard("gphys_mesh_check")  # has no hooks that could fail
called = set(re.findall(r"\bgphys_\w+", "".join(open(name).read() for name in sys.argv[1:])))
for name in sorted(set(open("seen.txt").read().split()) - told):
    print(f"{name} allocates, and its comment does not say so")
for name in sorted(told - called):
    print(f"{name} allocates, and is not called where memory runs out")
END
[ ! -s wrong.txt ] || fail "$(cat wrong.txt)"
