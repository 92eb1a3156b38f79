# For ./test.sh: reads what ctest wrote, and what the build says that it leaves out.

# count_tests LOG: sets ran_well and ran_badly; fails if ctest did not come to its end. A test that
# was skipped is neither.
count_tests() {
    local missed total
    # ctest: "98% tests passed, 2 tests failed out of 100"
    read -r missed total < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests\{0,1\} failed out of \([0-9]*\)$/\1 \2/p' "$1")
    [ -n "${total:-}" ] || return 1
    ran_badly=$missed
    ran_well=$((total - missed - $(skipped_tests "$1" | wc -l)))
}

# skipped_tests LOG: the names of those that found something missing and said so.
skipped_tests() {
    sed -n 's/^\t *[0-9]* - \(.*\) (Skipped)$/\1/p' "$1"
}

# closing_line PASSED FAILED BUILD...: the last line of a run of tests in those build folders, each
# with the log of its tests beside it.
closing_line() {
    local line="$1 passed, $2 failed" build skipped
    shift 2
    skipped=$(for build in "$@"; do
        [ ! -f "$build/left_out.txt" ] || cat "$build/left_out.txt"
        [ ! -f "$build.log" ] || skipped_tests "$build.log"
    done | sort -u | sed -z 's/\n$//; s/\n/, /g')
    echo "$line${skipped:+, skipped: $skipped}"
}
