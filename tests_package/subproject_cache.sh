#!/usr/bin/env bash
# What gamephys leaves in the cache of a project above it: nothing that changes the project's own
# targets. Whether the library is shared is asked for by BUILD_SHARED_LIBS or by GAMEPHYS_SHARED.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"

# expected NAME OWN GAMEPHYS OPTION...: the kinds that the library of the parent and gamephys have.
expected() {
    local name=$1 own=$2 gamephys=$3
    shift 3
    parent "$name" "$@" || fail "$(cat "$name.log")"
    ninja -C "$name" -t targets all >"$name.txt"
    grep -q "^libown\.$own:" "$name.txt" || fail "$name: the parent's library is not a .$own"
    if grep -q '^gamephys/libgamephys\.so:' "$name.txt"; then
        [ "$gamephys" = so ] || fail "$name: gamephys is shared"
    else
        [ "$gamephys" = a ] || fail "$name: gamephys is not shared"
    fi
}
expected default a so
expected shared so so -DBUILD_SHARED_LIBS=ON
expected static a a -DBUILD_SHARED_LIBS=OFF
expected own_static so a -DBUILD_SHARED_LIBS=ON -DGAMEPHYS_SHARED=OFF
expected own_shared a so -DBUILD_SHARED_LIBS=OFF -DGAMEPHYS_SHARED=ON

# Options are named after the project; others are CMake's, or say where something was found.
sed -n '/^# INTERNAL/,$d; s/^\([A-Za-z0-9_]*\):[A-Z]*=.*/\1/p' default/CMakeCache.txt >keys.txt
grep -q '^GAMEPHYS_WERROR$' keys.txt || fail "the cache was not read"
expect_no_match "in the parent's cache" -vE '^(GAMEPHYS_|gamephys_|parent_|CMAKE_|own_)' keys.txt
grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=$' default/CMakeCache.txt || fail "the build type was changed"
