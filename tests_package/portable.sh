#!/usr/bin/env bash
# Each C test compiles with tests_c/portable in place of cmocka, as it has to for other platforms.
source "$SOURCE/tests_package/common.sh"

options=(-std=c99 -pedantic-errors -Wall -Wextra -Werror -fsyntax-only -I"$SOURCE/tests_c/portable" -I"$INSTALLED/include")
for test in "$SOURCE"/tests_c/test_*.c; do
    "$CC" "${options[@]}" "$test" || fail "${test##*/} needs more than tests_c/portable has"
done
