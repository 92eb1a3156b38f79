#!/usr/bin/env bash
# Valgrind finds nothing in the C tests: no uninitialised value that decides, no leak, no bad access. Users run it over
# their programs, and would see what it holds against the library. It emulates processors up to AVX2.
source "$SOURCE/tests_package/common.sh"
command -v valgrind >/dev/null || {
    echo "valgrind is not installed"
    exit 77
}
check() { valgrind -q --leak-check=full --error-exitcode=9 "$@"; }

printf 'int main(int count, char** names) { int a[2]; a[count < 5] = 1; return names && a[0] > 3 ? 3 : 0; }\n' >wrong.c
"$CC" -O0 -w wrong.c -o wrong
if check ./wrong 2>/dev/null; then fail "an uninitialised value is not found"; fi

# Not those of a minute and more in its emulation, nor the one that reads how much of the stack was written, nor the
# one of floating-point modes, of which it emulates some for some instructions. Of the scenes in which memory runs out
# it sees each twelfth.
tests=("$BUILD"/tests_c/c_test_*)
[ ${#tests[@]} -ge 10 ] || fail "no tests in $BUILD/tests_c"
for test in "${tests[@]}"; do
    case $test in *_faults_solvers | *_golden | *_workers | *_stack | *_host_modes) continue ;; esac
    GPHYS_FAULTS_EVERY=12 check "$test" >"$(basename "$test").log" 2>&1 || {
        grep '^==' "$(basename "$test").log" | head -n 30
        fail "$(basename "$test")"
    }
done
