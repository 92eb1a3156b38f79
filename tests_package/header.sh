#!/usr/bin/env bash
# The header compiles alone, twice, under every standard of both compilers, without a warning; and
# what it hands to foreign-function parsers is plain C.
source "$SOURCE/tests_package/common.sh"
header=$INSTALLED/include/gamephys_c.h

printf '#include <gamephys_c.h>\n#include <gamephys_c.h>\nint gphys_unit;\n' >twice.c
cp twice.c twice.cpp
options=(-I"$INSTALLED/include" -pedantic-errors -Wall -Wextra -Wstrict-prototypes -Werror -fsyntax-only)
for compiler in gcc clang; do
    for standard in c99 c11 c17 c2x; do
        $compiler -std=$standard "${options[@]}" twice.c || fail "$compiler -std=$standard"
    done
done
options=("${options[@]/-Wstrict-prototypes/-Wold-style-cast}")
for compiler in g++ clang++; do
    for standard in c++98 c++11 c++14 c++17 c++20; do
        $compiler -std=$standard "${options[@]}" twice.cpp || fail "$compiler -std=$standard"
    done
done

# Only this header's own lines: the standard ones hold attributes.
gcc -E "$header" | awk '/^# [0-9]+ "/ { ours = index($0, "gamephys_c.h") > 0; next } ours' >plain.txt
grep -q gphys_version plain.txt || fail "the header's own lines were not found"
expect_no_match "not plain C for a parser" -E '__attribute__|__declspec|__extension__|inline|static' plain.txt
grep '^#include' "$header" >includes.txt
expect_no_match "more than stddef.h and stdint.h" -vE '<(stddef|stdint)\.h>' includes.txt
