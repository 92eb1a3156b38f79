#!/usr/bin/env bash
# The header keeps to the rules that let every language use it: types, descs, a comment of its own for
# each function, with what it refuses. Every function is called by name in the C tests.
source "$SOURCE/tests_package/common.sh"

python3 "$SOURCE/cmake/interface/describe.py" "$SOURCE/include/gamephys_c.h" >gamephys_api.json
python3 "$SOURCE/cmake/interface/rules.py" gamephys_api.json "$SOURCE"/tests_c/*.c "$SOURCE"/tests_cpp/*.cpp >wrong.txt || fail "$(cat wrong.txt)"
