// Eight floats side by side, for kernels (isa.h), and the one place with intrinsics. Everything is
// plain IEEE arithmetic without fused operations, so each instruction set gives the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "foundation/floating_point.h"

#define GPHYS_ISA_IS_scalar 1
#define GPHYS_ISA_IS_sse2 2
#define GPHYS_ISA_IS_avx2 3
#define GPHYS_ISA_IS_avx512 4
#define GPHYS_ISA_IS_neon 5
#define GPHYS_ISA_IS_wasm 6
#define GPHYS_ISA_JOIN(prefix, set) prefix##set
#define GPHYS_ISA_NUMBER(set) GPHYS_ISA_JOIN(GPHYS_ISA_IS_, set)
#define GPHYS_ISA_IS(set) (GPHYS_ISA_NUMBER(GPHYS_ISA) == GPHYS_ISA_NUMBER(set))
// The wider set has the instructions of the narrower one.
#define GPHYS_HAS_AVX2 (GPHYS_ISA_IS(avx2) || GPHYS_ISA_IS(avx512))

#if GPHYS_ISA_IS(sse2) || GPHYS_HAS_AVX2
#include <immintrin.h>
#elif GPHYS_ISA_IS(neon)
#include <arm_neon.h>
#elif GPHYS_ISA_IS(wasm)
#include <wasm_simd128.h>
#endif

/// Before a loop that is to be written out as often as it runs.
#ifdef __clang__
#define GPHYS_UNROLLED _Pragma("unroll")
#else
#define GPHYS_UNROLLED _Pragma("GCC unroll 8")
#endif

namespace gphys::GPHYS_ISA {

// Vectors of the compilers' own extension, as wide as the registers of the set.
#if GPHYS_HAS_AVX2
constexpr int register_lanes = 8;
#else
constexpr int register_lanes = 4;
#endif
constexpr int register_count = 8 / register_lanes;
using FloatRegister = float __attribute__((vector_size(4 * register_lanes)));
using MaskRegister = int32_t __attribute__((vector_size(4 * register_lanes)));

struct Float8 {
    FloatRegister part[register_count];
};

#if GPHYS_ISA_IS(avx512)
/// Bit i is set if lane i is.
struct Mask8 {
    __mmask8 lanes;
};
#else
/// All bits of a lane are set or none.
struct Mask8 {
    MaskRegister part[register_count];
};
#endif

inline Float8 load(const float* from) {
    Float8 v;
    for (int i = 0; i < register_count; ++i) {
        std::memcpy(&v.part[i], from + register_lanes * i, sizeof v.part[i]);
    }
    return v;
}
/// The same from where a register would be stored. What is not known to be so, gcc 12 loads apart with AVX-512.
inline Float8 load_aligned(const float* from) {
    return load(static_cast<const float*>(__builtin_assume_aligned(from, sizeof(FloatRegister))));
}
inline void store(float* to, Float8 v) {
    for (int i = 0; i < register_count; ++i) std::memcpy(to + register_lanes * i, &v.part[i], sizeof v.part[i]);
}
inline Float8 splat(float value) {
    Float8 v;
    for (FloatRegister& part : v.part) part = value - FloatRegister{};
    return v;
}
/// Floats of eight places: at(i) is where.
template <class At>
[[gnu::always_inline]] inline Float8 load_lanes(const At& at) {
#if GPHYS_HAS_AVX2
    return {{FloatRegister{*at(0), *at(1), *at(2), *at(3), *at(4), *at(5), *at(6), *at(7)}}};
#else
    return {{FloatRegister{*at(0), *at(1), *at(2), *at(3)}, FloatRegister{*at(4), *at(5), *at(6), *at(7)}}};
#endif
}
/// Eight doubles less one, then rounded.
inline Float8 narrowed_differences(const double* from, double less) {
#if GPHYS_ISA_IS(avx512)
    return {{_mm512_cvtpd_ps(_mm512_sub_pd(_mm512_loadu_pd(from), _mm512_set1_pd(less)))}};
#elif GPHYS_HAS_AVX2
    const auto half = [&](int i) {
        return _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(from + 4 * i), _mm256_set1_pd(less)));
    };
    return {{_mm256_insertf128_ps(_mm256_castps128_ps256(half(0)), half(1), 1)}};
#else
    float narrowed[8];
    for (int i = 0; i < 8; ++i) narrowed[i] = static_cast<float>(from[i] - less);
    return load(narrowed);
#endif
}

inline FloatRegister minimum(FloatRegister a, FloatRegister b) {
#if GPHYS_HAS_AVX2
    return _mm256_min_ps(a, b);
#elif GPHYS_ISA_IS(sse2)
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
inline FloatRegister maximum(FloatRegister a, FloatRegister b) {
#if GPHYS_HAS_AVX2
    return _mm256_max_ps(a, b);
#elif GPHYS_ISA_IS(sse2)
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}
inline FloatRegister square_root(FloatRegister a) {
#if GPHYS_HAS_AVX2
    return _mm256_sqrt_ps(a);
#elif GPHYS_ISA_IS(sse2)
    return _mm_sqrt_ps(a);
#elif GPHYS_ISA_IS(neon)
    return vsqrtq_f32(reinterpret_cast<float32x4_t>(a));
#elif GPHYS_ISA_IS(wasm)
    return reinterpret_cast<FloatRegister>(wasm_f32x4_sqrt(reinterpret_cast<v128_t>(a)));
#else
    for (int i = 0; i < register_lanes; ++i) a[i] = __builtin_sqrtf(a[i]);
    return a;
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
inline Float8 operator/(Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] /= b.part[i];
    return a;
}
inline Float8 sqrt(Float8 a) {
    for (FloatRegister& part : a.part) part = square_root(part);
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
/// The least of all lanes, and the greatest, in each.
template <class Better>
inline Float8 best_lane(Float8 a, const Better& better) {
    FloatRegister best = a.part[0];
    for (int i = 1; i < register_count; ++i) best = better(best, a.part[i]);
#if GPHYS_HAS_AVX2
    best = better(best, __builtin_shufflevector(best, best, 4, 5, 6, 7, 0, 1, 2, 3));
    best = better(best, __builtin_shufflevector(best, best, 2, 3, 0, 1, 6, 7, 4, 5));
    best = better(best, __builtin_shufflevector(best, best, 1, 0, 3, 2, 5, 4, 7, 6));
#else
    best = better(best, __builtin_shufflevector(best, best, 2, 3, 0, 1));
    best = better(best, __builtin_shufflevector(best, best, 1, 0, 3, 2));
#endif
    for (FloatRegister& part : a.part) part = best;
    return a;
}
inline Float8 least_lane(Float8 a) {
    return best_lane(a, [](FloatRegister p, FloatRegister q) { return minimum(p, q); });
}
inline Float8 greatest_lane(Float8 a) {
    return best_lane(a, [](FloatRegister p, FloatRegister q) { return maximum(p, q); });
}
inline float first_lane(Float8 a) { return a.part[0][0]; }

inline Float8 abs(Float8 a) { return max(a, splat(0) - a); }

/// Whole numbers as they are in memory as integers.
inline Float8 integer_bits(Float8 a) {
    for (FloatRegister& part : a.part) {
        part = reinterpret_cast<FloatRegister>(__builtin_convertvector(part, MaskRegister));
    }
    return a;
}

#if GPHYS_ISA_IS(avx512)
/// In lanes that are set a, else b.
inline Float8 choose(Mask8 mask, Float8 a, Float8 b) {
    return {{_mm256_mask_blend_ps(mask.lanes, b.part[0], a.part[0])}};
}
/// In lanes that are set a, else b, as they are in memory.
inline Float8 choose_bits(Mask8 mask, int32_t a, int32_t b) {
    return {{_mm256_castsi256_ps(_mm256_mask_blend_epi32(mask.lanes, _mm256_set1_epi32(b), _mm256_set1_epi32(a)))}};
}
/// Set where the sign is, even of zero.
inline Mask8 signs(Float8 a) { return {_mm256_movepi32_mask(_mm256_castps_si256(a.part[0]))}; }
inline Mask8 operator<=(Float8 a, Float8 b) { return {_mm256_cmp_ps_mask(a.part[0], b.part[0], _CMP_LE_OS)}; }
/// Also of numbers that hosts take for zero.
inline Mask8 equal_bits(Float8 a, Float8 b) {
    return {_mm256_cmpeq_epi32_mask(_mm256_castps_si256(a.part[0]), _mm256_castps_si256(b.part[0]))};
}
inline Mask8 operator&(Mask8 a, Mask8 b) { return {_kand_mask8(a.lanes, b.lanes)}; }
inline Mask8 operator|(Mask8 a, Mask8 b) { return {_kor_mask8(a.lanes, b.lanes)}; }
/// Bit i is set if lane i is.
inline uint32_t bits(Mask8 mask) { return mask.lanes; }
#else
/// In lanes that are set a, else b.
inline Float8 choose(Mask8 mask, Float8 a, Float8 b) {
    for (int i = 0; i < register_count; ++i) a.part[i] = mask.part[i] ? a.part[i] : b.part[i];
    return a;
}

/// Set where the sign is, even of zero.
inline Mask8 signs(Float8 a) {
    Mask8 mask;
    for (int i = 0; i < register_count; ++i) mask.part[i] = reinterpret_cast<MaskRegister>(a.part[i]) >> 31;
    return mask;
}
/// In lanes that are set a, else b, as they are in memory.
inline Float8 choose_bits(Mask8 mask, int32_t a, int32_t b) {
    Float8 v;
    for (int i = 0; i < register_count; ++i) {
        v.part[i] = reinterpret_cast<FloatRegister>((mask.part[i] & (a ^ b)) ^ b);
    }
    return v;
}

inline Mask8 operator<=(Float8 a, Float8 b) {
    Mask8 mask;
    for (int i = 0; i < register_count; ++i) mask.part[i] = a.part[i] <= b.part[i];
    return mask;
}
/// Also of numbers that hosts take for zero.
inline Mask8 equal_bits(Float8 a, Float8 b) {
    Mask8 mask;
    for (int i = 0; i < register_count; ++i) {
        mask.part[i] = reinterpret_cast<MaskRegister>(a.part[i]) == reinterpret_cast<MaskRegister>(b.part[i]);
    }
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
/// Of all eight lanes.
inline uint32_t bits(Mask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < register_count; ++i) result |= lane_bits(mask.part[i]) << (register_lanes * i);
    return result;
}
#endif

/// Eight quadruples of floats, each at a place of its own, component by component: at(i) is where.
struct Quads8 {
    Float8 x, y, z, w;
};

#if GPHYS_HAS_AVX2
/// Within each half of the registers, which hold four quadruples twice: rows become columns, and back.
inline void transpose(FloatRegister (&v)[4]) {
    const FloatRegister a = _mm256_unpacklo_ps(v[0], v[1]), b = _mm256_unpackhi_ps(v[0], v[1]);
    const FloatRegister c = _mm256_unpacklo_ps(v[2], v[3]), d = _mm256_unpackhi_ps(v[2], v[3]);
    v[0] = _mm256_shuffle_ps(a, c, 0x44);
    v[1] = _mm256_shuffle_ps(a, c, 0xee);
    v[2] = _mm256_shuffle_ps(b, d, 0x44);
    v[3] = _mm256_shuffle_ps(b, d, 0xee);
}
template <class At>
[[gnu::always_inline]] inline Quads8 load_quads(const At& at) {
    FloatRegister v[4];
    for (int i = 0; i < 4; ++i) {
        v[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(at(i))), _mm_loadu_ps(at(i + 4)), 1);
    }
    transpose(v);
    return {{{v[0]}}, {{v[1]}}, {{v[2]}}, {{v[3]}}};
}
template <class At>
[[gnu::always_inline]] inline void store_quads(const At& at, const Quads8& quads) {
    FloatRegister v[4] = {quads.x.part[0], quads.y.part[0], quads.z.part[0], quads.w.part[0]};
    transpose(v);
    for (int i = 0; i < 4; ++i) {
        _mm_storeu_ps(at(i), _mm256_castps256_ps128(v[i]));
        _mm_storeu_ps(at(i + 4), _mm256_extractf128_ps(v[i], 1));
    }
}
#else
inline void transpose(FloatRegister (&v)[4]) {
    const FloatRegister a = __builtin_shufflevector(v[0], v[1], 0, 4, 1, 5);
    const FloatRegister b = __builtin_shufflevector(v[0], v[1], 2, 6, 3, 7);
    const FloatRegister c = __builtin_shufflevector(v[2], v[3], 0, 4, 1, 5);
    const FloatRegister d = __builtin_shufflevector(v[2], v[3], 2, 6, 3, 7);
    v[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    v[1] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    v[2] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    v[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}
template <class At>
[[gnu::always_inline]] inline Quads8 load_quads(const At& at) {
    Quads8 quads;
    for (int half = 0; half < 2; ++half) {
        FloatRegister v[4];
        for (int i = 0; i < 4; ++i) std::memcpy(&v[i], at(4 * half + i), sizeof v[i]);
        transpose(v);
        quads.x.part[half] = v[0], quads.y.part[half] = v[1], quads.z.part[half] = v[2], quads.w.part[half] = v[3];
    }
    return quads;
}
template <class At>
[[gnu::always_inline]] inline void store_quads(const At& at, const Quads8& quads) {
    for (int half = 0; half < 2; ++half) {
        FloatRegister v[4] = {quads.x.part[half], quads.y.part[half], quads.z.part[half], quads.w.part[half]};
        transpose(v);
        for (int i = 0; i < 4; ++i) std::memcpy(at(4 * half + i), &v[i], sizeof v[i]);
    }
}
#endif
/// The same of an array of quadruples, by their indices.
[[gnu::always_inline]] inline Quads8 load_quads(const float* from, const uint32_t* index) {
    return load_quads([&](int i) { return from + 4 * size_t{index[i]}; });
}
[[gnu::always_inline]] inline void store_quads(float* to, const uint32_t* index, const Quads8& quads) {
    store_quads([&](int i) { return to + 4 * size_t{index[i]}; }, quads);
}

/// Of two quadruples behind each other: the last float of each four times, and 0 in its place.
inline Float8 last_of_quads(Float8 a) {
    for (FloatRegister& part : a.part) {
#if GPHYS_HAS_AVX2
        part = __builtin_shufflevector(part, part, 3, 3, 3, 3, 7, 7, 7, 7);
#else
        part = __builtin_shufflevector(part, part, 3, 3, 3, 3);
#endif
    }
    return a;
}
inline Float8 without_last_of_quads(Float8 a) {
    for (FloatRegister& part : a.part) {
#if GPHYS_HAS_AVX2
        part = __builtin_shufflevector(part, FloatRegister{}, 0, 1, 2, 11, 4, 5, 6, 15);
#else
        part = __builtin_shufflevector(part, FloatRegister{}, 0, 1, 2, 7);
#endif
    }
    return a;
}

}  // namespace gphys::GPHYS_ISA
