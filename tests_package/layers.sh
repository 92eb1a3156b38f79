#!/usr/bin/env bash
# Every #include in src points to its own layer or to one that it may know:
#   foundation -> shapes -> intersect -> mesh, scene -> solver;  shapes -> octree -> mesh
#   shapes -> camera;  pick joins camera and scene;  c_api sits on top
# The octree knows boxes and integers, not the questions; camera and scene do not know each other.
source "$SOURCE/tests_package/common.sh"

layer_of() {
    case $1 in
        c_api/*) echo c_api ;;
        solver/* | solver.*) echo solver ;;
        math.* | memory.* | status.* | simd.* | ids.* | pool.* | results.* | strided.* | exact.*) echo foundation ;;
        shapes.* | halfspaces.*) echo shapes ;;
        intersect.* | heights.* | closest* | overlap* | classify* | raycast* | sweep*) echo intersect ;;
        box8.* | octree*) echo octree ;;
        mesh*) echo mesh ;;
        scene*) echo scene ;;
        camera.* | orbit.* | projection.* | clip_space.*) echo camera ;;
        pick*) echo pick ;;
        *) echo unknown ;;
    esac
}

declare -A knows=(
    [foundation]=""
    [shapes]="foundation"
    [intersect]="foundation shapes"
    [octree]="foundation shapes"
    [mesh]="foundation shapes intersect octree"
    [scene]="foundation shapes intersect octree mesh"
    [solver]="foundation shapes intersect octree mesh scene"
    [camera]="foundation shapes"
    [pick]="foundation shapes intersect octree mesh scene camera"
    [c_api]="foundation shapes intersect octree mesh scene solver camera pick"
)

cd "$SOURCE/src"
includes=0
for file in $(find . -name '*.h' -o -name '*.cpp' | sed 's,^\./,,'); do
    layer=$(layer_of "$file")
    [ "$layer" != unknown ] || echo "$file belongs to no layer: name it in tests_package/layers.sh"
    for include in $(sed -n 's/^#include "\(.*\)"$/\1/p' "$file"); do
        [ "$include" != gamephys_c.h ] || continue
        target=$(realpath --relative-to=. "$(dirname "$file")/$include")
        includes=$((includes + 1))
        case " ${knows[$layer]-} $layer " in
            *" $(layer_of "$target") "*) ;;
            *) echo "$file ($layer) must not include $target ($(layer_of "$target"))" ;;
        esac
    done
done >"$WORK/wrong.txt"
[ $includes -gt 0 ] || fail "no includes found"
[ ! -s "$WORK/wrong.txt" ] || fail "$(cat "$WORK/wrong.txt")"
