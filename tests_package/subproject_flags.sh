#!/usr/bin/env bash
# What a project above switches on or off for itself, and the library cannot be built with, or not
# as it was tested, does not reach it: no exceptions, a unity build, another language standard.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"

parent flags -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-fno-exceptions -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_STANDARD=20 \
    -DCMAKE_CXX_EXTENSIONS=ON || fail "$(cat flags.log)"
everywhere flags ' -fno-exceptions .* -fexceptions'
everywhere flags ' -std=c\+\+17 '
sed -n 's/.*"file": "\(.*\)".*/\1/p' flags/compile_commands.json >files.txt
grep -q 'memory\.cpp' files.txt || fail "the files were not found"
expect_no_match "joined with others" 'unity.*_cxx' files.txt
ninja -C flags gamephys/CMakeFiles/gamephys_core.dir/src/foundation/memory.cpp.o >flags.log || fail "$(cat flags.log)"

# Optimisation at link time, which some compilers need another linker for.
if parent lto -DCMAKE_BUILD_TYPE=Release -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON -DCMAKE_POLICY_DEFAULT_CMP0069=NEW; then
    everywhere lto ' -flto'
    everywhere lto ' -ffp-contract=off'
else
    grep -qi 'interprocedural\|IPO' lto.log || fail "$(cat lto.log)"
fi
