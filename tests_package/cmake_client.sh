#!/usr/bin/env bash
# The consumer project, built and run: cmake_client.sh find_package|add_subdirectory|fetch_content TARGET [compiled]
# "compiled": the client is compiled and what would be built for it is listed, but the library is not compiled again.
source "$SOURCE/tests_package/common.sh"

# -O0 compiles soonest; how a subproject is optimised is another test's business.
"$CMAKE" -S "$here/consumer" -B build -G Ninja -DGAMEPHYS_WERROR=ON -DCMAKE_CXX_FLAGS=-O0 -DHOW="$1" -DTARGET="$2" -DWANTED=1.0 \
    -DGAMEPHYS_SOURCE="$SOURCE" -DCMAKE_PREFIX_PATH="$INSTALLED"
if [ "${3:-}" = compiled ]; then
    ninja -C build -t commands client >commands.txt
    grep -q -- '-o client .*libgamephys' commands.txt || fail "the client is not linked with the library"
    ninja -C build "$(ninja -C build -t targets all | sed -n 's/: C_COMPILER.*//p' | grep client.c)"
    exit
fi
"$CMAKE" --build build --target client --parallel 2
build/client
