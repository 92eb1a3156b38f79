#!/usr/bin/env bash
# Every function of the header is described and is called by name in the C tests.
source "$SOURCE/tests_package/common.sh"

for function in $("$here/functions.sh"); do
    grep -qwF "$function" "$SOURCE"/tests_c/*.c || echo "$function is named by no test in tests_c"
done >gaps.txt

# A comment describes the declarations of its paragraph. The conventions at the header's top
# describe all _desc_init and _destroy functions.
awk '
    /^$/ { described = 0 }
    /\*\/ *$/ { described = 1 }
    /^GPHYS_API/ && !described && !/_desc_init\(|_destroy\(/ { print "line " FNR " has no comment: " $0 }
' "$SOURCE/include/gamephys_c.h" >>gaps.txt
[ ! -s gaps.txt ] || fail "$(cat gaps.txt)"
