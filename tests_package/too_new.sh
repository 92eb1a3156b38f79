#!/usr/bin/env bash
# find_package refuses a version that this one is too old for, and another major version.
source "$SOURCE/tests_package/common.sh"

configure() {
    "$CMAKE" -S "$here/consumer" -B "build-$1" -DHOW=find_package -DTARGET=gamephys::gamephys -DWANTED="$1" \
        -DCMAKE_PREFIX_PATH="$INSTALLED" >"$1.log" 2>&1
}
configure 1.0 || fail "version 1.0 is refused: $(cat 1.0.log)"
for wanted in 1.999 2.0 0.9; do
    if configure $wanted; then fail "version $wanted is taken"; fi
    grep -q 'not compatible\|considered' $wanted.log || fail "another reason than the version: $(cat $wanted.log)"
done
