// Everything beyond C++17 that this code needs of a compiler, except the intrinsics of simd_*.h and the vectors of
// simd_plain.h: builtins, attributes and inline assembly for gcc and clang, intrinsics and keywords for Microsoft's
// compiler.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#elif defined(__x86_64__) || defined(__i386__)
#include <emmintrin.h>  // not all of <immintrin.h>, which takes half a second to compile
#endif

#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64) || defined(_M_IX86)
#define GPHYS_X86 1
#else
#define GPHYS_X86 0
#endif

// GPHYS_INLINE            always inlined: a call would pass eight lanes through memory, and the function would exist
//                         outside of the kernels' namespaces (isa.h)
// GPHYS_INLINE_LAMBDA     after the parameters of a lambda: the same
// GPHYS_NOINLINE          never inlined
// GPHYS_FLATTEN           all calls in it are inlined
// GPHYS_UNROLLED          before a loop: unrolled completely
#if defined(__GNUC__)
#define GPHYS_INLINE [[gnu::always_inline]] inline
#define GPHYS_INLINE_LAMBDA __attribute__((always_inline))
#define GPHYS_NOINLINE [[gnu::noinline]]
#define GPHYS_FLATTEN [[gnu::flatten]]
#if defined(__clang__)
#define GPHYS_UNROLLED _Pragma("unroll")
#else
#define GPHYS_UNROLLED _Pragma("GCC unroll 8")
#endif
#else
#define GPHYS_INLINE __forceinline
#define GPHYS_INLINE_LAMBDA
#define GPHYS_NOINLINE __declspec(noinline)
#define GPHYS_FLATTEN
#define GPHYS_UNROLLED
#endif

#if defined(__SIZEOF_INT128__)
#define GPHYS_HAS_INT128 1
#else
#define GPHYS_HAS_INT128 0
#endif

namespace gphys {

#if GPHYS_HAS_INT128
__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;
#endif

#if defined(__GNUC__)

/// Index of the lowest set bit. bits != 0.
GPHYS_INLINE int lowest_bit(uint32_t bits) { return __builtin_ctz(bits); }
GPHYS_INLINE int lowest_bit(uint64_t bits) { return __builtin_ctzll(bits); }
/// bits != 0.
GPHYS_INLINE int leading_zeros(uint64_t bits) { return __builtin_clzll(bits); }
GPHYS_INLINE int popcount(uint32_t bits) { return __builtin_popcount(bits); }

/// Prefetch a cache line to read it or to write it.
GPHYS_INLINE void prefetch(const void* memory) { __builtin_prefetch(memory); }
GPHYS_INLINE void prefetch_to_write(const void* memory) { __builtin_prefetch(memory, 1); }

/// The same pointer. The compiler may assume the alignment.
template <size_t alignment, class T>
GPHYS_INLINE const T* assume_aligned(const T* memory) {
    return static_cast<const T*>(__builtin_assume_aligned(memory, alignment));
}

#if GPHYS_X86
/// Whether the processor and the operating system support an instruction set of isa.h.
inline bool processor_has_sse2() { return __builtin_cpu_supports("sse2"); }
inline bool processor_has_avx2() { return __builtin_cpu_supports("avx2"); }
inline bool processor_has_avx512() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}
#endif

#else

GPHYS_INLINE int lowest_bit(uint32_t bits) {
    unsigned long place;
    _BitScanForward(&place, bits);
    return static_cast<int>(place);
}
GPHYS_INLINE int lowest_bit(uint64_t bits) {
    const auto low = static_cast<uint32_t>(bits);
    return low != 0 ? lowest_bit(low) : 32 + lowest_bit(static_cast<uint32_t>(bits >> 32));
}
GPHYS_INLINE int leading_zeros(uint64_t bits) {
    const auto high = static_cast<uint32_t>(bits >> 32);
    unsigned long place;
    _BitScanReverse(&place, high != 0 ? high : static_cast<uint32_t>(bits));
    return (high != 0 ? 31 : 63) - static_cast<int>(place);
}
/// By sums of pairs, nibbles and bytes (Warren, Hacker's Delight): not every processor has the instruction.
GPHYS_INLINE int popcount(uint32_t bits) {
    bits -= bits >> 1 & 0x55555555;
    bits = (bits & 0x33333333) + (bits >> 2 & 0x33333333);
    return static_cast<int>(((bits + (bits >> 4)) & 0x0f0f0f0f) * 0x01010101 >> 24);
}

GPHYS_INLINE void prefetch(const void* memory) {
#if GPHYS_X86
    _mm_prefetch(static_cast<const char*>(memory), _MM_HINT_T0);
#else
    __prefetch(memory);
#endif
}
GPHYS_INLINE void prefetch_to_write(const void* memory) { prefetch(memory); }

template <size_t alignment, class T>
GPHYS_INLINE const T* assume_aligned(const T* memory) {
    return memory;
}

#if GPHYS_X86
inline bool processor_has_sse2() { return true; }
/// CPUID (Intel's manual, volume 2): `features` in ebx of leaf 7, and `saved`, the registers that the system saves.
inline bool processor_has(uint32_t features, uint64_t saved) {
    int registers[4];
    __cpuidex(registers, 1, 0);
    constexpr int osxsave = 1 << 27;
    if ((registers[2] & osxsave) == 0 || (_xgetbv(0) & saved) != saved) return false;
    __cpuidex(registers, 7, 0);
    return (static_cast<uint32_t>(registers[1]) & features) == features;
}
inline bool processor_has_avx2() { return processor_has(1u << 5, 0x6); }
inline bool processor_has_avx512() { return processor_has(1u << 5 | 1u << 16 | 1u << 17 | 1u << 30 | 1u << 31, 0xe6); }
#endif

#endif

#if GPHYS_X86
/// The control word of the x87 unit, which computes in 32-bit programs only; else 0.
inline uint16_t x87_control() {
    uint16_t control = 0;
#if defined(__i386__)
    __asm__ volatile("fnstcw %0" : "=m"(control));
#endif
    return control;
}
inline void set_x87_control([[maybe_unused]] uint16_t control) {
#if defined(__i386__)
    __asm__ volatile("fldcw %0" : : "m"(control));
#endif
}

/// The same value, opaque to the compiler, which therefore evaluates no expression of it at compile time.
GPHYS_INLINE __m128 opaque(__m128 value) {
#if defined(__GNUC__)
    __asm__ volatile("" : "+x"(value));
#endif
    return value;
}
#elif defined(__aarch64__) && defined(__GNUC__)
#define GPHYS_HAS_FPCR 1
/// The floating-point control register of 64-bit ARM.
inline uint64_t read_fpcr() {
    uint64_t fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    return fpcr;
}
inline void write_fpcr(uint64_t fpcr) { __asm__ volatile("msr fpcr, %0" : : "r"(fpcr)); }
#endif

/// A hint to the processor in a spin loop.
GPHYS_INLINE void pause_briefly() {
#if GPHYS_X86
    _mm_pause();
#endif
}

}  // namespace gphys
