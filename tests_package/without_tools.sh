#!/usr/bin/env bash
# Where something is not installed: users can build all the same, developers are told what to install,
# and the last line of ./test.sh names what was skipped.
source "$SOURCE/tests_package/common.sh"
source "$SOURCE/cmake/test_summary.sh"
compilers=(-DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX")

# A program or library that is given as OFF is not looked for.
without_cmocka=(-DCMOCKA_LIBRARY=OFF -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON)
"$CMAKE" -S "$SOURCE" -B plain "${compilers[@]}" "${without_cmocka[@]}" >plain.log 2>&1 || fail "$(cat plain.log)"
grep -q 'tests are left out.*libcmocka-dev catch2' plain.log || fail "what is missing is not said: $(cat plain.log)"

cd "$SOURCE"
if "$CMAKE" --preset debug -B "$WORK/debug" "${compilers[@]}" "${without_cmocka[@]}" >"$WORK/debug.log" 2>&1; then
    fail "a developer is not told what is missing"
fi
"$CMAKE" --preset debug -B "$WORK/debug" "${compilers[@]}" "${without_cmocka[@]}" -DGAMEPHYS_TESTS=OFF >"$WORK/off.log" 2>&1 ||
    fail "the advice does not help: $(cat "$WORK/off.log")"
cd "$WORK"
tr -s ' \n' ' ' <debug.log >debug.txt
for part in 'the Debian packages libcmocka-dev catch2' 'GAMEPHYS_TESTS=OFF'; do
    grep -q -- "$part" debug.txt || fail "the message does not name $part: $(cat debug.log)"
done

# The closing line. What a test finds missing when it runs is in ctest's own list.
"$CMAKE" -S "$SOURCE" -B bare -DGAMEPHYS_TESTS=ON "${compilers[@]}" -D{GO,CARGO,MCS,NODE,LUAJIT,RUBY,JAVAC,LDC,PHP}=OFF \
    -D{ABIDIFF,LINTIAN,STB_INCLUDE_DIR}=OFF >bare.txt 2>&1 || fail "$(cat bare.txt)"
cat >bare.log <<'END'
98% tests passed, 2 tests failed out of 100

The following tests did not run:
	 25 - package: as root (Skipped)
END
count_tests bare.log || fail "the log was not read"
[ "$ran_well $ran_badly" = "97 2" ] || fail "97 passed and 2 failed, not $ran_well and $ran_badly"
closing_line 97 2 bare >line.txt
[ "$(wc -l <line.txt)" = 1 ] || fail "more than one line: $(cat line.txt)"
for part in '^97 passed, 2 failed, skipped: ' 'Go (go ' 'Rust (cargo ' 'C# (' 'JavaScript (' 'WebAssembly (' 'Lua (' 'Ruby (' 'Java (' \
    'D (' 'PHP (' "Debian's checks of its packages (" 'viewer (' 'comparison of binaries (' 'package: as root'; do
    grep -q -- "$part" line.txt || fail "$part is not in: $(cat line.txt)"
done
[ "$(closing_line 3 0 nothing_left_out)" = "3 passed, 0 failed" ] || fail "a run with everything: $(closing_line 3 0 nothing)"
if count_tests bare.txt; then fail "a run that broke off is counted"; fi
