#!/usr/bin/env bash
# Builds gamephys.wasm, which the package's entry wasm.js loads and which npm pack packs. It takes
# CMake, Ninja and Emscripten.
set -euo pipefail
cd "$(dirname "$0")/../.."
for tool in cmake ninja; do
    command -v $tool >/dev/null || { echo "gamephys.wasm cannot be built: $tool is not installed" >&2 && exit 1; }
done
cmake --preset wasm32
cmake --build --preset wasm32 --target gamephys_module
