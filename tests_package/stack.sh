#!/usr/bin/env bash
# No call takes more stack than the header states under "Threads", whatever the instruction set: measured for each
# function around all calls that the C tests make (stack_probe.py).
source "$SOURCE/tests_package/common.sh"
skip() {
    echo "$1"
    exit 77
}
[ "$(uname -sm)" = "Linux x86_64" ] || skip "the probe is for Linux on x86-64"
[ -e "$INSTALLED/$LIBDIR/libgamephys.so" ] || skip "there is no shared library"
[[ $CONFIG =~ ^Rel ]] || skip "the stack of code that is not optimised is not bounded"
grep -q 'fsanitize' "$BUILD/CMakeCache.txt" && skip "sanitizers put room between variables"

python3 "$SOURCE/cmake/interface/describe.py" "$SOURCE/include/gamephys_c.h" --quick >api.json
python3 "$here/stack_probe.py" api.json >probe.c
"$CC" -O2 -w -fPIC -shared -fno-omit-frame-pointer -I"$SOURCE/include" probe.c -o probe.so -ldl

# measure ISA TEST...: appends the depths of their calls to depths.txt.
measure() {
    local isa=$1 test
    shift
    for test; do
        # The test of stacks looks at those of its own threads, and finds the probe there: it is to print them only.
        GPHYS_PRINT_STACK=1 GAMEPHYS_ISA=$isa STACK_DEPTHS=depths.txt LD_PRELOAD=$PWD/probe.so "$BUILD/tests_c/c_test_$test" >run.txt 2>&1 ||
            fail "$test on $isa: $(tail -n 5 run.txt)"
    done
}
all=()
for test in "$BUILD"/tests_c/c_test_*; do
    # Those in which memory runs out make the calls of others thousands of times.
    case $test in *_faults_*) ;; *) all+=("${test##*/c_test_}") ;; esac
done
[ ${#all[@]} -ge 10 ] || fail "no tests in $BUILD/tests_c"
measure "" "${all[@]}"
for isa in sse2 avx2; do measure $isa stack batches scene_queries shape_rays camera_pick mesh solver; done

cat >compare.py <<'END'
import json, re, sys
share = float(sys.argv[2])
stated = re.search(r"at most (\d+) KiB of stack, a batch of rays or nearest points (\d+), a step (\d+)",
                   re.sub(r"\s*\n \*\s*", " ", open(sys.argv[1]).read()))
call, batch, step = (int(number) * 1024 * share for number in stated.groups())
depths = {}
for line in open("depths.txt"):
    name, depth = line.split()
    depths[name] = max(depths.get(name, 0), int(depth))
for name in (f["name"] for f in json.load(open("api.json"))["functions"]):
    most = batch if re.search("(ray|pick|segment|nearest|closest).*_batch$", name) else call
    if name in ("gphys_solver_step", "gphys_solver_advance"):
        most = step
    if name not in depths:
        print(f"{name} is called by no test that was measured")
    elif depths[name] > most:
        print(f"{name} takes {depths[name]} bytes of stack")
END
python3 compare.py "$SOURCE/include/gamephys_c.h" 1 >wrong.txt
[ ! -s wrong.txt ] || fail "$(cat wrong.txt)"
python3 compare.py "$SOURCE/include/gamephys_c.h" 0.25 >wrong.txt
[ "$(wc -l <wrong.txt)" -ge 10 ] || fail "limits of a quarter are kept, too"
