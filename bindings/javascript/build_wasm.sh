#!/usr/bin/env bash
# Builds gamephys.wasm, which the package's entry wasm.js loads. It takes Emscripten and CMake.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset wasm32
cmake --build --preset wasm32 --target gamephys_module
