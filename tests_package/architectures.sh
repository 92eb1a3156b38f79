#!/usr/bin/env bash
# On macOS the instruction sets are those of CMAKE_OSX_ARCHITECTURES, whatever processor compiles; of
# several architectures each gets its own, in one compilation.
source "$SOURCE/tests_package/common.sh"
source "$here/parent.sh"

# mac NAME ARCHITECTURES: the kernels' instruction sets for them, as gamephys sees them on a Mac.
mac() {
    printf 'set(APPLE TRUE)\nset(CMAKE_OSX_ARCHITECTURES "%s")\n' "$2" >"$1.cmake"
    parent "$1" -DCMAKE_PROJECT_gamephys_INCLUDE="$WORK/$1.cmake" -DCMAKE_CXX_FLAGS= || fail "$(cat "$1.log")"
    compiled "$1" scene_kernels.cpp >"$1.txt"
}
mac arm arm64
[ "$(wc -l <arm.txt)" = 1 ] || fail "arm64: not neon: $(cat arm.txt)"
expect_no_match "x86 options for arm64" -E -- ' -m(sse|avx)' arm.txt
mac intel x86_64
[ "$(wc -l <intel.txt)" = 3 ] || fail "x86_64: not sse2, avx2 and avx512: $(cat intel.txt)"
expect_no_match "neon for x86_64" neon intel.txt

# Apple's linker and headers are not here, but clang tells what it would hand to its compiler for
# each architecture.
mac universal 'arm64;x86_64'
[ "$(wc -l <universal.txt)" = 4 ] || fail "universal: not four sets: $(cat universal.txt)"
command -v clang >/dev/null || exit 0
while read -r command; do
    options=$(grep -oE -- '-Xarch_[a-z0-9_]+ [^ ]+|-DGPHYS_ISA=[^ ]+' <<<"$command" | tr '\n' ' ')
    clang++ -### --target=arm64-apple-macos11 -arch arm64 -arch x86_64 $options -c -x c++ /dev/null -o /dev/null 2>&1 |
        grep -- '"-cc1"' | tr -d '"' >invocations.txt
    [ "$(wc -l <invocations.txt)" = 2 ] || fail "not one compiler for each architecture: $(cat invocations.txt)"
    for triple in arm64 x86_64; do
        grep -- "-triple $triple-" invocations.txt | grep -oE 'GPHYS_ISA=[a-z0-9_]+|-target-feature \+(avx512vl|avx2)' |
            tr '\n' ' ' | sed "s/^/$triple: /; s/-target-feature //g; s/ $/\n/"
    done
done <universal.txt | sort >sets.txt
cat >expected.txt <<'END'
arm64: GPHYS_ISA=neon
arm64: GPHYS_ISA=without_avx2
arm64: GPHYS_ISA=without_avx512
arm64: GPHYS_ISA=without_sse2
x86_64: +avx2 +avx512vl GPHYS_ISA=avx512
x86_64: +avx2 GPHYS_ISA=avx2
x86_64: GPHYS_ISA=sse2
x86_64: GPHYS_ISA=without_neon
END
diff expected.txt sets.txt || fail "not the sets of each architecture: < expected, > found"

# What an architecture gets for a set that it lacks is plain code.
"$CXX" -std=c++17 -DGPHYS_ISA=without_neon -I"$SOURCE/src" -I"$SOURCE/include" -fsyntax-only "$SOURCE/src/scene/hit_kernels.cpp"
