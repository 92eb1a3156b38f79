#!/usr/bin/env bash
# A folder of src is a layer. Every #include points to its own layer or to one that it may know:
#   foundation -> shapes -> geometry -> bvh -> mesh -> scene -> solver
#   shapes -> camera;  pick joins camera and scene;  c_api sits on top
# The bvh knows boxes and integers, and of the questions those about boxes; camera and scene do not know each other.
source "$SOURCE/tests_package/common.sh"

declare -A knows=(
    [foundation]=""
    [shapes]="foundation"
    [geometry]="foundation shapes"
    [bvh]="foundation shapes geometry"
    [mesh]="foundation shapes geometry bvh"
    [scene]="foundation shapes geometry bvh mesh"
    [solver]="foundation shapes geometry bvh mesh scene"
    [camera]="foundation shapes"
    [pick]="foundation shapes geometry bvh mesh scene camera"
    [c_api]="foundation shapes geometry bvh mesh scene solver camera pick"
)

shopt -s globstar
cd "$SOURCE/src"
includes=0
for file in **/*.*; do
    layer=${file%%/*}
    [ -n "${knows[$layer]+known}" ] || echo "$layer is no layer: name it in tests_package/layers.sh"
    for include in $(sed -n 's/^#include "\(.*\)"$/\1/p' "$file"); do
        [ "$include" != gamephys_c.h ] || continue
        includes=$((includes + 1))
        case " ${knows[$layer]-} $layer " in
            *" ${include%%/*} "*) ;;
            *) echo "$file must not include $include" ;;
        esac
    done
done >"$WORK/wrong.txt"
[ $includes -gt 0 ] || fail "no includes found"
[ ! -s "$WORK/wrong.txt" ] || fail "$(cat "$WORK/wrong.txt")"
