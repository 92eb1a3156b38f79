#!/usr/bin/env bash
# src is C++17 that another compiler takes: extensions of gcc and clang are for these two, in compiler.h and
# simd_plain.h alone.
# clang looks at src as Microsoft's compiler would: with the branches for that one, vectors without
# operators (microsoft/intrin.h), and what a GNU extension is told by -pedantic-errors and -Wgnu is an error.
# -fms-extensions is for __forceinline and __declspec; -fms-compatibility would refuse this system's C++
# library, and allows more than it forbids.
# Without the argument "all" it looks at the kernels, all other headers at once, and the files that name a vector or
# a system: the rest has no such branches, and each build by clang finds its GNU extensions with the same warnings.
source "$SOURCE/tests_package/common.sh"
command -v clang++ >/dev/null || {
    echo "clang is not installed"
    exit 77
}
cd "$SOURCE"

# extensions FILE...: words by which they are told where clang has no warning.
extensions() { grep -nE '__builtin_|__attribute__|__extension__|__int128|__restrict|\[\[(gnu|clang)::|_Pragma|#pragma [^o]|\b(__)?asm(__)?\b|vector_size' "$@"; }
if found=$(extensions -r src --exclude=compiler.h --exclude=simd_plain.h); then fail "extensions outside of src/foundation/compiler.h and simd_plain.h: $found"; fi

flags=(-std=c++17 -fms-extensions -pedantic-errors -Wgnu -Werror -Wno-microsoft -Wno-language-extension-token
    -Isrc -Iinclude -DGAMEPHYS_STATIC -isystem tests_package/microsoft)
clang++ "${flags[@]}" -x c++-header tests_package/microsoft/prelude.h -o "$WORK/prelude.pch"
flags+=(-fsyntax-only -include-pch "$WORK/prelude.pch")
check() { clang++ "${flags[@]}" "$@"; }
# Kernels with the narrowest and the widest registers, or with all: float4.h has those of SSE2 anyway.
sets=(scalar avx512) special='Float|Double|Mask|Vec<|simd|_mm_|__m[0-9]|^#if'
[ "${1:-}" != all ] || sets=(scalar sse2 avx2 avx512) special=
for set in "${sets[@]}"; do
    find src -name '*_kernels.cpp' -printf "-DGPHYS_ISA=$set %p\n"
done >"$WORK/units.txt"
[ -s "$WORK/units.txt" ] || fail "no kernels found"
find src -name '*.cpp' ! -name '*_kernels.cpp' -exec grep -lE "$special" {} + >>"$WORK/units.txt"
find src -name '*.h' ! -path '*/simd*' -exec grep -L GPHYS_ISA {} + | sed 's|^src/\(.*\)|#include "\1"|' >"$WORK/headers.cpp"
[ "$(wc -l <"$WORK/headers.cpp")" -ge 100 ] || fail "no headers found"
echo "$WORK/headers.cpp" >>"$WORK/units.txt"
xargs -d '\n' -P 2 -I{} sh -c 'clang++ "$@" $0' {} "${flags[@]}" <"$WORK/units.txt"

# refused NAME CODE: in a function of a file with the registers of SSE2.
refused() {
    printf '#include "foundation/simd_sse2.h"\n%s\n' "$2" >"$WORK/$1.cpp"
    if check "$WORK/$1.cpp" 2>"$WORK/$1.log"; then fail "$1 is taken"; fi
}
refused operators '__m128 twice(__m128 a) { return a + a; }'
refused elements 'float first(__m128 a) { return a[0]; }'
refused conversions '__m128i bits(__m128 a) { return (__m128i)a; }'
refused attributes '__attribute__((noinline)) void f() {}'
refused int128 'unsigned long high(__int128 a) { return (unsigned long)(a >> 64); }'
refused statements 'int one() { return ({ int a = 1; a; }); }'
refused arrays 'int sum(int n) { int all[n]; return all[0]; }'
refused conditionals 'int either(int a, int b) { return a ?: b; }'
printf 'int place(unsigned a) { return __builtin_ctz(a); }\n' >"$WORK/builtin.cpp"
extensions "$WORK/builtin.cpp" >/dev/null || fail "a builtin is taken"
printf 'void stop() { __asm__ volatile("hlt"); }\n' >"$WORK/assembly.cpp"
extensions "$WORK/assembly.cpp" >/dev/null || fail "inline assembly is taken"
printf '#include "foundation/simd_sse2.h"\n__m128 twice(__m128 a) { return _mm_add_ps(a, a); }\n' >"$WORK/intrinsics.cpp"
check "$WORK/intrinsics.cpp"
