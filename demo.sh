#!/usr/bin/env bash
# Draws pictures of a mesh, or opens a window with it. Without a file it takes a duck from a distribution package.
#   ./demo.sh [MESH]                      builds the viewer, which draws build/demo/scene.png, pick.png and cloth.png, and
#                                         examples/04_character.c, which draws its path, character.svg
#   ./demo.sh --window [MESH] [OPTION...] opens a window instead. Options are those of the window:
#                                         --preset 1-8, --size WxH, --frames N, --record DIR, --log
# Installs what is missing.
set -euo pipefail
usage="usage: ./demo.sh [--window] [MESH] [options of the window]; ./demo.sh --help describes them"
window=
mesh=
options=()
while [ $# -gt 0 ]; do
    case $1 in
        --help | -h)
            sed -n '2,/^set /s/^# //p' "$0"
            exit ;;
        --window) window=yes ;;
        --log) options+=("$1") ;;
        --preset | --size | --frames | --record)
            [ $# -gt 1 ] || { echo "$usage" >&2; exit 2; }
            options+=("$1" "$2")
            shift ;;
        -*) echo "$usage" >&2; exit 2 ;;
        *)
            [ -z "$mesh" ] || { echo "$usage" >&2; exit 2; }
            mesh=$(realpath -e -- "$1") ;;
    esac
    shift
done
[ -n "$window" ] || [ ${#options[@]} -eq 0 ] || { echo "$usage" >&2; exit 2; }
called_from=$PWD
cd "$(dirname "$0")"
source cmake/install_packages.sh

install_packages g++ cmake ninja-build libassimp-dev libstb-dev ${window:+libsdl2-dev libgl-dev}
if [ -z "$mesh" ]; then
    install_packages assimp-testmodels
    mesh=/usr/share/assimp/models/Collada/duck.dae
fi

cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=ON \
    -DGAMEPHYS_BENCH=OFF
if [ -n "$window" ]; then
    cmake --build build/release --target window
    program=$PWD/build/release/examples/window
    cd "$called_from" # the folder of --record may be relative
    exec "$program" "${options[@]}" "$mesh"
fi
cmake --build build/release --target viewer example_04_character
mkdir -p build/demo
build/release/examples/viewer "$mesh" --out build/demo
build/release/examples/example_04_character build/demo/character.svg
echo "pictures: build/demo/scene.png build/demo/pick.png build/demo/cloth.png build/demo/character.svg"
