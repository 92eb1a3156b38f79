#!/usr/bin/env bash
# ./demo.sh [mesh file]: builds the viewer and lets it draw build/demo/scene.png, pick.png and
# cloth.png; examples/04_character.c draws its path, character.svg. Without a file the viewer takes a duck from a
# distribution package. Installs what is missing.
# ./demo.sh --window [mesh file]: opens the viewer in a window instead.
set -euo pipefail
window=
if [ "${1:-}" = --window ]; then
    window=yes
    shift
fi
mesh=${1:+$(realpath "$1")}
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
    exec build/release/examples/window "$mesh"
fi
cmake --build build/release --target viewer example_04_character
mkdir -p build/demo
build/release/examples/viewer "$mesh" --out build/demo
build/release/examples/example_04_character build/demo/character.svg
echo "pictures: build/demo/scene.png build/demo/pick.png build/demo/cloth.png build/demo/character.svg"
