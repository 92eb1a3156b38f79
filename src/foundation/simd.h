// Eight floats side by side, for kernels (isa.h), and the one place with intrinsics. Everything is
// plain IEEE arithmetic without fused operations, so each instruction set gives the same bits.
#pragma once

#include <cstdint>

#define GPHYS_ISA_IS_scalar 1
#define GPHYS_ISA_IS_sse2 2
#define GPHYS_ISA_IS_avx2 3
#define GPHYS_ISA_IS_neon 4
#define GPHYS_ISA_IS_wasm 5
#define GPHYS_ISA_JOIN(prefix, set) prefix##set
#define GPHYS_ISA_NUMBER(set) GPHYS_ISA_JOIN(GPHYS_ISA_IS_, set)
#define GPHYS_ISA_IS(set) (GPHYS_ISA_NUMBER(GPHYS_ISA) == GPHYS_ISA_NUMBER(set))

#if GPHYS_ISA_IS(sse2) || GPHYS_ISA_IS(avx2)
#include <immintrin.h>
#elif GPHYS_ISA_IS(neon)
#include <arm_neon.h>
#elif GPHYS_ISA_IS(wasm)
#include <wasm_simd128.h>
#endif

namespace gphys::GPHYS_ISA {

// Vectors of the compilers' own extension, as wide as the registers of the set.
#if GPHYS_ISA_IS(avx2)
constexpr int register_lanes = 8;
#else
constexpr int register_lanes = 4;
#endif
constexpr int register_count = 8 / register_lanes;
using FloatRegister = float __attribute__((vector_size(4 * register_lanes)));
using MaskRegister = int32_t __attribute__((vector_size(4 * register_lanes)));
/// The same anywhere in an array of floats.
using FloatsInMemory = float __attribute__((vector_size(4 * register_lanes), aligned(4), may_alias));

struct Float8 {
    FloatRegister part[register_count];
};

/// All bits of a lane are set or none.
struct Mask8 {
    MaskRegister part[register_count];
};

inline Float8 load(const float* from) {
    Float8 v;
    for (int i = 0; i < register_count; ++i) {
        v.part[i] = *reinterpret_cast<const FloatsInMemory*>(from + register_lanes * i);
    }
    return v;
}
inline void store(float* to, Float8 v) {
    for (int i = 0; i < register_count; ++i) *reinterpret_cast<FloatsInMemory*>(to + register_lanes * i) = v.part[i];
}
inline Float8 splat(float value) {
    Float8 v;
    for (FloatRegister& part : v.part) part = value - FloatRegister{};
    return v;
}

inline FloatRegister minimum(FloatRegister a, FloatRegister b) {
#if GPHYS_ISA_IS(avx2)
    return _mm256_min_ps(a, b);
#elif GPHYS_ISA_IS(sse2)
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
inline FloatRegister maximum(FloatRegister a, FloatRegister b) {
#if GPHYS_ISA_IS(avx2)
    return _mm256_max_ps(a, b);
#elif GPHYS_ISA_IS(sse2)
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}
/// Bit i is set if lane i is.
inline uint32_t lane_bits(MaskRegister mask) {
#if GPHYS_ISA_IS(avx2)
    return static_cast<uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif GPHYS_ISA_IS(sse2)
    return static_cast<uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#elif GPHYS_ISA_IS(neon)
    return vaddvq_u32(reinterpret_cast<uint32x4_t>(mask & MaskRegister{1, 2, 4, 8}));
#elif GPHYS_ISA_IS(wasm)
    return wasm_i32x4_bitmask(reinterpret_cast<v128_t>(mask));
#else
    uint32_t bits = 0;
    for (int i = 0; i < register_lanes; ++i) bits |= static_cast<uint32_t>(mask[i] & 1) << i;
    return bits;
#endif
}

inline Float8 operator+(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] += b.part[i];
    return a;
}
inline Float8 operator-(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] -= b.part[i];
    return a;
}
inline Float8 operator*(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] *= b.part[i];
    return a;
}
inline Float8 min(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] = minimum(a.part[i], b.part[i]);
    return a;
}
inline Float8 max(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] = maximum(a.part[i], b.part[i]);
    return a;
}
inline Float8 abs(Float8 a) { return max(a, splat(0) - a); }

inline Mask8 operator<=(Float8 a, Float8 b) {
    Mask8 mask;
    for (int i = 0; i < register_count; ++i) mask.part[i] = a.part[i] <= b.part[i];
    return mask;
}
inline Mask8 operator&(Mask8 a, Mask8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] &= b.part[i];
    return a;
}
inline Mask8 operator|(Mask8 a, Mask8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] |= b.part[i];
    return a;
}
/// Bit i is set if lane i is.
inline uint32_t bits(Mask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < register_count; ++i) result |= lane_bits(mask.part[i]) << (register_lanes * i);
    return result;
}

}  // namespace gphys::GPHYS_ISA
