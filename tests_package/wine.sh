#!/usr/bin/env bash
# Tests on Windows run in a Windows of Wine's below their build, which one test makes before the others.
source "$SOURCE/tests_package/common.sh"

printf 'include("%s")\nmessage(STATUS "${CMAKE_CROSSCOMPILING_EMULATOR}")\n' "$SOURCE/cmake/toolchains/x86_64-w64-mingw32.cmake" >show.cmake
"$CMAKE" -P show.cmake >emulator.txt 2>&1
grep -qF "WINEPREFIX=$WORK/wine;" emulator.txt || fail "Wine would write elsewhere: $(cat emulator.txt)"

command -v x86_64-w64-mingw32-g++-posix >/dev/null || exit 0
(cd "$SOURCE" && "$CMAKE" --preset windows -B "$WORK/build") >build.log 2>&1 || fail "$(cat build.log)"
ctest --test-dir build --show-only=json-v1 >tests.json
cat >check.py <<'END'
import json
import sys

prefix = f"WINEPREFIX={sys.argv[2]}/build/wine"
with open(sys.argv[1]) as file:
    tests = json.load(file)["tests"]
makers = 0
for test in tests:
    properties = {entry["name"]: entry["value"] for entry in test["properties"]}
    assert prefix in test["command"], f"{test['name']} is not run in {prefix}: {test['command']}"
    makers += "wine" in properties.get("FIXTURES_SETUP", [])
    assert ("wine" in properties.get("FIXTURES_SETUP", [])) != ("wine" in properties.get("FIXTURES_REQUIRED", [])), test["name"]
assert makers == 1 and len(tests) > 10, f"{makers} of {len(tests)} tests make the prefix"
END
python3 check.py tests.json "$WORK"
