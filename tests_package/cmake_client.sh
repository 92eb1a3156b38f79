#!/usr/bin/env bash
# The consumer project, built and run: cmake_client.sh find_package|add_subdirectory|fetch_content TARGET
source "$SOURCE/tests_package/common.sh"

# -O0 compiles soonest; how a subproject is optimised is another test's business.
"$CMAKE" -S "$here/consumer" -B build -G Ninja -DGAMEPHYS_WERROR=ON -DCMAKE_CXX_FLAGS=-O0 -DHOW="$1" -DTARGET="$2" -DWANTED=1.0 \
    -DGAMEPHYS_SOURCE="$SOURCE" -DCMAKE_PREFIX_PATH="$INSTALLED"
"$CMAKE" --build build --target client --parallel 2
build/client
