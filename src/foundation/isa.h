// Runtime dispatch by instruction set. A file *_kernels.cpp is compiled once for each set, with its own compiler
// options, into a namespace named after the set (GPHYS_ISA, defined by the build). Each kind of kernels has a table of
// function pointers for each set. All sets give the same bits.
//
// Kernels call no function outside of their namespace. Otherwise the linker could keep the copy of an inline function
// that was compiled for a newer processor. Their arguments are plain data, prepared by ordinary code.
//
// Some kernels exist for the wide sets only, whose registers hold four doubles or more (GAMEPHYS_WIDE_KERNELS in
// cmake/gamephys_targets.cmake): with narrower registers they are slower than scalar code.
//
// `scalar`, without SIMD instructions, is built where a processor of the target may have nothing else, and as a
// reference for the other sets where the build defines GPHYS_SCALAR_KERNELS. With GPHYS_ONLY_AVX512 or GPHYS_ONLY_AVX2,
// that is the only other set of x86, for builds that take long to compile.
#pragma once

// The sets of a target, narrowest first, and the first of them that each of its processors has.
#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64) || defined(_M_IX86)
#if defined(GPHYS_ONLY_AVX512) || defined(GPHYS_ONLY_AVX2)
#ifdef GPHYS_ONLY_AVX512
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...) X(avx512, __VA_ARGS__)
#else
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...) X(avx2, __VA_ARGS__)
#endif
#define GPHYS_FOR_EACH_SIMD_ISA GPHYS_FOR_EACH_WIDE_ISA
#else
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...) X(avx2, __VA_ARGS__) X(avx512, __VA_ARGS__)
#define GPHYS_FOR_EACH_SIMD_ISA(X, ...) X(sse2, __VA_ARGS__) GPHYS_FOR_EACH_WIDE_ISA(X, __VA_ARGS__)
#endif
#if defined(__x86_64__) || defined(_M_X64)
#define GPHYS_BASE_ISA sse2
#endif
#elif defined(__aarch64__) || defined(_M_ARM64)
#define GPHYS_FOR_EACH_SIMD_ISA(X, ...) X(neon, __VA_ARGS__)
#define GPHYS_BASE_ISA neon
#elif defined(__wasm_simd128__)
#define GPHYS_FOR_EACH_SIMD_ISA(X, ...) X(wasm, __VA_ARGS__)
#define GPHYS_BASE_ISA wasm
#else
#define GPHYS_FOR_EACH_SIMD_ISA(X, ...)
#endif
#ifndef GPHYS_FOR_EACH_WIDE_ISA
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...)
#endif
#if defined(GPHYS_SCALAR_KERNELS) || !defined(GPHYS_BASE_ISA)
#undef GPHYS_BASE_ISA
#define GPHYS_BASE_ISA scalar
#define GPHYS_FOR_EACH_ISA(X, ...) X(scalar, __VA_ARGS__) GPHYS_FOR_EACH_SIMD_ISA(X, __VA_ARGS__)
#else
#define GPHYS_FOR_EACH_ISA(X, ...) GPHYS_FOR_EACH_SIMD_ISA(X, __VA_ARGS__)
#endif

namespace gphys {

enum class Isa {
#define GPHYS_ISA_NAME(set, ...) set,
    GPHYS_FOR_EACH_ISA(GPHYS_ISA_NAME, )
#undef GPHYS_ISA_NAME
};
constexpr Isa base_isa = Isa::GPHYS_BASE_ISA;

/// Whether this processor supports the set.
bool has(Isa isa);
/// The widest set that this processor supports, or the one named by the environment variable GAMEPHYS_ISA. Determined
/// once, so that all objects use the same.
Isa chosen_isa();
const char* name_of(Isa isa);

/// Declares the tables of one kind of kernels, one for each set, and table(isa), which returns that of a set.
#define GPHYS_DECLARE_KERNELS(Table, table)                     \
    GPHYS_FOR_EACH_ISA(GPHYS_DECLARE_TABLE, Table, table)       \
    inline const Table& table(Isa isa) {                        \
        GPHYS_FOR_EACH_ISA(GPHYS_RETURN_TABLE_IF, Table, table) \
        return GPHYS_BASE_ISA::table;                           \
    }
#define GPHYS_DECLARE_TABLE(set, Table, table) \
    namespace set {                            \
    extern const Table table;                  \
    }
#define GPHYS_RETURN_TABLE_IF(set, Table, table) \
    if (isa == Isa::set) return set::table;

/// The same for the wide sets; table(isa) returns null for the others.
#define GPHYS_DECLARE_WIDE_KERNELS(Table, table)                           \
    GPHYS_FOR_EACH_WIDE_ISA(GPHYS_DECLARE_TABLE, Table, table)             \
    inline const Table* table([[maybe_unused]] Isa isa) {                  \
        GPHYS_FOR_EACH_WIDE_ISA(GPHYS_RETURN_TABLE_PLACE_IF, Table, table) \
        return nullptr;                                                    \
    }
#define GPHYS_RETURN_TABLE_PLACE_IF(set, Table, table) \
    if (isa == Isa::set) return &set::table;

}  // namespace gphys
