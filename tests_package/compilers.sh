#!/usr/bin/env bash
# A compiler that cannot build the library is refused at once, with a message that names those that can.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"

# refused NAME: with what NAME.cmake sets once gamephys has its compiler.
refused() {
    if parent "$1" -DCMAKE_PROJECT_gamephys_INCLUDE="$WORK/$1.cmake"; then fail "$1 is taken"; fi
    tr -s ' \n' ' ' <"$1.log" >message.txt
    grep -q 'is not supported. gcc and clang are' message.txt || fail "$1: another message: $(cat "$1.log")"
}
printf 'set(CMAKE_CXX_COMPILER_ID MSVC)\nset(MSVC TRUE)\n' >msvc.cmake
printf 'set(CMAKE_CXX_COMPILER_ID Clang)\nset(MSVC TRUE)\n' >clang_cl.cmake
printf 'set(CMAKE_CXX_COMPILER_ID Clang)\nset(CMAKE_CXX_SIMULATE_ID MSVC)\n' >clang_msvc.cmake
printf 'set(CMAKE_CXX_COMPILER_ID IntelLLVM)\n' >intel.cmake
for compiler in msvc clang_cl clang_msvc intel; do refused $compiler; done
printf 'set(CMAKE_CXX_COMPILER_ID AppleClang)\n' >apple.cmake
parent apple -DCMAKE_PROJECT_gamephys_INCLUDE="$WORK/apple.cmake" || fail "$(cat apple.log)"
