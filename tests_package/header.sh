#!/usr/bin/env bash
# The header compiles alone, twice, under every standard of both compilers, without a warning; and
# what it hands to foreign-function parsers is plain C.
source "$SOURCE/tests_package/common.sh"
source "$here/headers.sh"
header=$INSTALLED/include/gamephys_c.h

header_compiles "$INSTALLED/include"

# Only this header's own lines: the standard ones hold attributes.
gcc -E "$header" | awk '/^# [0-9]+ "/ { ours = index($0, "gamephys_c.h") > 0; next } ours' >plain.txt
grep -q gphys_version plain.txt || fail "the header's own lines were not found"
expect_no_match "not plain C for a parser" -wE '__attribute__|__declspec|__extension__|inline|static' plain.txt
grep '^#include' "$header" >includes.txt
expect_no_match "more than stddef.h and stdint.h" -vE '<(stddef|stdint)\.h>' includes.txt
