// Which instruction set the kernels use. A file *_kernels.cpp is compiled once for each set,
// with its own compiler options, into a namespace named after the set (GPHYS_ISA, given by the
// build); a table of function pointers leads to each of them. All sets give the same answers.
//
// Kernels call nothing outside of their own namespace, so that no function compiled for a newer
// processor can be taken for its namesake elsewhere. What they are handed is plain data, prepared
// by ordinary code.
//
// Some are for the wide sets only, whose registers hold four doubles or more (GAMEPHYS_WIDE_KERNELS in
// cmake/gamephys_targets.cmake): with narrower ones, what they do takes longer than going without.
#pragma once

#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64) || defined(_M_IX86)
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...) X(avx2, __VA_ARGS__) X(avx512, __VA_ARGS__)
#define GPHYS_FOR_EACH_ISA(X, ...) X(scalar, __VA_ARGS__) X(sse2, __VA_ARGS__) GPHYS_FOR_EACH_WIDE_ISA(X, __VA_ARGS__)
#elif defined(__aarch64__) || defined(_M_ARM64)
#define GPHYS_FOR_EACH_ISA(X, ...) X(scalar, __VA_ARGS__) X(neon, __VA_ARGS__)
#elif defined(__wasm_simd128__)
#define GPHYS_FOR_EACH_ISA(X, ...) X(scalar, __VA_ARGS__) X(wasm, __VA_ARGS__)
#else
#define GPHYS_FOR_EACH_ISA(X, ...) X(scalar, __VA_ARGS__)
#endif
#ifndef GPHYS_FOR_EACH_WIDE_ISA
#define GPHYS_FOR_EACH_WIDE_ISA(X, ...)
#endif

namespace gphys {

enum class Isa {
#define GPHYS_ISA_NAME(set, ...) set,
    GPHYS_FOR_EACH_ISA(GPHYS_ISA_NAME, )
#undef GPHYS_ISA_NAME
};

/// Whether this processor has it.
bool has(Isa isa);
/// The best that this processor has, or the one that the environment variable GAMEPHYS_ISA names.
/// Looked up once, so that no object changes sides.
Isa chosen_isa();
const char* name_of(Isa isa);

/// Declares the tables of a kind, one for each set, and table(isa), which gives the one of a set.
#define GPHYS_DECLARE_KERNELS(Table, table)                     \
    GPHYS_FOR_EACH_ISA(GPHYS_DECLARE_TABLE, Table, table)       \
    inline const Table& table(Isa isa) {                        \
        GPHYS_FOR_EACH_ISA(GPHYS_RETURN_TABLE_IF, Table, table) \
        return scalar::table;                                   \
    }
#define GPHYS_DECLARE_TABLE(set, Table, table) \
    namespace set {                            \
    extern const Table table;                  \
    }
#define GPHYS_RETURN_TABLE_IF(set, Table, table) \
    if (isa == Isa::set) return set::table;

/// The same for the wide sets; null for the others.
#define GPHYS_DECLARE_WIDE_KERNELS(Table, table)                           \
    GPHYS_FOR_EACH_WIDE_ISA(GPHYS_DECLARE_TABLE, Table, table)             \
    inline const Table* table([[maybe_unused]] Isa isa) {                  \
        GPHYS_FOR_EACH_WIDE_ISA(GPHYS_RETURN_TABLE_PLACE_IF, Table, table) \
        return nullptr;                                                    \
    }
#define GPHYS_RETURN_TABLE_PLACE_IF(set, Table, table) \
    if (isa == Isa::set) return &set::table;

}  // namespace gphys
