#!/usr/bin/env bash
# clang takes the C++ tests and the fuzz targets as gcc does: ./test.sh --coverage, --fuzz and --long build them with it.
source "$SOURCE/tests_package/common.sh"
command -v clang++ >/dev/null || {
    echo "clang is not installed"
    exit 77
}
cd "$SOURCE"
printf '%s\n' tests_cpp/*.cpp fuzz/*.cpp |
    xargs -P 2 -I{} clang++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only -DGAMEPHYS_STATIC -Isrc -Iinclude -Itests_cpp {}
