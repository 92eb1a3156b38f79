#!/usr/bin/env bash
# Every C entry point is guarded by its form, and one that is not is noticed.
source "$SOURCE/tests_package/common.sh"
python3 "$here/entry_points.py" "$SOURCE"

# refused NAME SED_SCRIPT FILE: with FILE of src/c_api changed so.
refused() {
    rm -rf broken
    mkdir -p broken/src broken/include
    cp -r "$SOURCE/src/c_api" broken/src
    cp "$SOURCE/include/gamephys_c.h" broken/include
    sed -i "$2" "broken/src/c_api/$3"
    cmp -s "$SOURCE/src/c_api/$3" "broken/src/c_api/$3" && fail "$1: nothing was changed"
    if python3 "$here/entry_points.py" broken 2>message.txt; then fail "$1 is taken"; fi
    grep -q 'is more than its guard\|no definition' message.txt || fail "$1: another message: $(cat message.txt)"
}
refused "an entry point without a guard" 's/return guarded(__func__, \[&\] { return unwrap(solver)->unjoin(joint); });/return unwrap(solver)->unjoin(joint);/;/gphys_solver_unjoin/,/^}/s/guarded(__func__, \[&\]() -> gphys_status {/unguarded(__func__, [\&]() -> gphys_status {/' solver_state.cpp
refused "a check before the guard" 's/^gphys_status gphys_scene_raycast(.*{$/&\n    if (!scene) throw 1;/' scene_queries.cpp
refused "a statement behind it" '/^void gphys_scene_destroy/,/^}/s/^}/    throw 1;\n}/' scene.cpp
refused "no definition" 's/^gphys_status gphys_shape_validate(/gphys_status gphys_shape_validated(/' shapes.cpp
