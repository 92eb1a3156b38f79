#!/usr/bin/env bash
# The toolchain file for WebAssembly finds Emscripten as emsdk, the PATH or Homebrew have it, and says
# what to do where there is none. What it finds here only tells where it was found.
source "$SOURCE/tests_package/common.sh"

# emscripten_in FOLDER
emscripten_in() {
    mkdir -p "$1/cmake/Modules/Platform"
    echo 'message(STATUS "found ${CMAKE_CURRENT_LIST_FILE}")' >"$1/cmake/Modules/Platform/Emscripten.cmake"
}
# found FOLDER VARIABLE=VALUE...: with these in the environment it is found there.
found() {
    local folder=$1
    shift
    env -u EMSDK -u HOMEBREW_PREFIX "$@" "$CMAKE" -P "$SOURCE/cmake/toolchains/wasm32.cmake" >found.txt 2>&1 || fail "$* $(cat found.txt)"
    grep -qxF -- "-- found $WORK/$folder/cmake/Modules/Platform/Emscripten.cmake" found.txt || fail "$*: $(cat found.txt)"
}
emscripten_in emsdk/upstream/emscripten
found emsdk/upstream/emscripten EMSDK="$WORK/emsdk"

emscripten_in "own place"
printf '#!/bin/sh\n' >"own place/emcc"
chmod +x "own place/emcc"
mkdir bin
ln -s "$WORK/own place/emcc" bin/emcc
found "own place" PATH="$WORK/bin:$PATH"
found emsdk/upstream/emscripten EMSDK="$WORK/emsdk" PATH="$WORK/bin:$PATH"

emscripten_in brew/opt/emscripten/libexec
mkdir scripts
printf '#!/bin/sh\n' >scripts/emcc
chmod +x scripts/emcc
found brew/opt/emscripten/libexec HOMEBREW_PREFIX="$WORK/brew" PATH="$WORK/scripts:$PATH"

if [ ! -e /usr/share/emscripten ] && [ ! -e /opt/homebrew ]; then
    if env -u EMSDK -u HOMEBREW_PREFIX PATH="$WORK/scripts:$PATH" "$CMAKE" -P "$SOURCE/cmake/toolchains/wasm32.cmake" >none.txt 2>&1; then
        fail "found where there is none: $(cat none.txt)"
    fi
    grep -q 'Activate emsdk' none.txt || fail "no advice: $(cat none.txt)"
fi

# A C++ library that has <memory_resource> keeps it.
mkdir library
echo 'using of_the_library = int;' >library/memory_resource
printf '#include <memory_resource>\nof_the_library value;\n' >resource.cpp
"$CXX" -fsyntax-only -isystem "$SOURCE/cmake/toolchains/wasm32" -isystem library resource.cpp
