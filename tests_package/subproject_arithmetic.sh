#!/usr/bin/env bash
# Flags of a project above do not change what the library computes: signs of exact arithmetic are
# right when it asks for -ffast-math, for parts of it, for fused operations or for no optimisation.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"

"$CXX" -std=c++17 -O1 -I"$SOURCE/src" -I"$SOURCE/include" -c "$here/orientation.cpp" -o orientation.o

object=gamephys/CMakeFiles/gamephys_core.dir/src/foundation/exact.cpp.o
# signs NAME OPTION...: right with exact.cpp compiled in such a project, and linked with $link_options.
link_options=
signs() {
    local name=$1
    shift
    # One file is compiled: the precompiled headers of all would take longer.
    parent "$name" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON "$@" || fail "$(cat "$name.log")"
    ninja -C "$name" $object >"$name.log" || fail "$(cat "$name.log")"
    "$CXX" $link_options orientation.o $name/$object -o "$name.run"
    "./$name.run" || fail "$name"
}
signs fast_math -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-ffast-math
signs ofast -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-Ofast
signs parts -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="-O3 -funsafe-math-optimizations -fassociative-math \
    -freciprocal-math -ffinite-math-only -fno-signed-zeros -fno-trapping-math"
signs unoptimised -DCMAKE_CXX_FLAGS=-O0
if grep -qw fma /proc/cpuinfo; then
    signs fused -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="-march=haswell -mfma -ffp-contract=fast"
fi
# What is optimised at link time keeps its options. clang would need another linker.
"$CXX" --version >version.txt
if ! grep -qi clang version.txt; then
    link_options='-O3 -ffast-math -flto'
    signs link_time -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="$link_options"
fi

# The linker's driver adds an object that flushes denormals to zero, wherever the library is loaded.
# linked NAME OPTION...: it does not in the command that links the library, given another object.
printf 'int gphys_version(void) { return 1; }\n' >one.c
"$CC" -fPIC -c one.c -o one.o
linked() {
    local name=$1
    shift
    parent "$name" "$@" || fail "$(cat "$name.log")"
    ninja -C "$name" -t commands gamephys/libgamephys.so >commands.txt
    grep -m 1 -- ' -shared ' commands.txt >link.txt
    sed -E 's/^: && //; s/ && :$//; s/ [^ ]*\.cpp\.o//g; s|-o [^ ]*|one.o -o '"$name.so"'|; s/-Wl,--dependency-file=[^ ]*//' \
        link.txt >link.sh
    sh -e link.sh || fail "$name: $(cat link.sh)"
    objdump -d "$name.so" >"$name.txt"
    grep -q '<gphys_version' "$name.txt" || fail "$name: the object was not linked"
    expect_no_match "$name: the floating-point mode is changed" -E '\b(ldmxcsr|fldcw|fldenv|msr +fpcr)\b' "$name.txt"
}
linked linked_fast_math -DCMAKE_CXX_FLAGS=-ffast-math -DCMAKE_SHARED_LINKER_FLAGS=-ffast-math
linked linked_ofast -DCMAKE_CXX_FLAGS=-Ofast
