#!/usr/bin/env bash
# Below a project without a build type the library is optimised all the same, and that is said. A
# level that the project asks for is kept. The project itself is compiled as ever.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"
unset CMAKE_BUILD_TYPE CXXFLAGS CFLAGS

optimised=' -O[23]( |$)'
for type in '' None Misspelt; do
    parent "type_$type" -DCMAKE_BUILD_TYPE="$type" || fail "$(cat "type_$type.log")"
    everywhere "type_$type" "$optimised"
    grep -q "build type \"$type\" does not optimise" "type_$type.log" || fail "type '$type': nothing is said"
    compiled "type_$type" client.c >own.txt
    [ -s own.txt ] || fail "the parent's own file was not found"
    expect_no_match "the parent's own file is optimised" -E -- ' -O' own.txt
done
grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=$' type_/CMakeCache.txt || fail "the build type was changed"

parent debug -DCMAKE_BUILD_TYPE=Debug
nowhere debug ' -O'
parent level -DCMAKE_CXX_FLAGS=-O1
nowhere level "$optimised"
