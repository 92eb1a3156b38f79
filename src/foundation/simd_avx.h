// Registers of AVX2, and of AVX-512 for masks and doubles. The functions are described in simd.h and simd_double.h.
#pragma once

#include <cstring>

#include "foundation/compiler.h"
#if !defined(_MSC_VER) || defined(__clang__)
#include <immintrin.h>
#endif

namespace gphys::GPHYS_ISA {

constexpr int register_lanes = 8;

struct FloatRegister {
    __m256 v;

    FloatRegister() = default;
    GPHYS_INLINE FloatRegister(__m256 value) : v(value) {}
    GPHYS_INLINE FloatRegister(float all) : v(_mm256_set1_ps(all)) {}
};

GPHYS_INLINE FloatRegister load_register(const float* from) { return _mm256_loadu_ps(from); }
GPHYS_INLINE void store_register(float* to, FloatRegister a) { _mm256_storeu_ps(to, a.v); }

GPHYS_INLINE FloatRegister operator+(FloatRegister a, FloatRegister b) { return _mm256_add_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator-(FloatRegister a, FloatRegister b) { return _mm256_sub_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator*(FloatRegister a, FloatRegister b) { return _mm256_mul_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator/(FloatRegister a, FloatRegister b) { return _mm256_div_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister minimum(FloatRegister a, FloatRegister b) { return _mm256_min_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister maximum(FloatRegister a, FloatRegister b) { return _mm256_max_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister square_root(FloatRegister a) { return _mm256_sqrt_ps(a.v); }
GPHYS_INLINE FloatRegister integer_bits(FloatRegister a) { return _mm256_castsi256_ps(_mm256_cvttps_epi32(a.v)); }
GPHYS_INLINE float first_lane(FloatRegister a) { return _mm256_cvtss_f32(a.v); }
/// Lane i is row[lanes[i]].
GPHYS_INLINE FloatRegister permuted(const float row[8], const uint32_t lanes[8]) {
    return _mm256_permutevar8x32_ps(_mm256_loadu_ps(row), _mm256_loadu_si256(reinterpret_cast<const __m256i*>(lanes)));
}

/// Horizontal reduction: the best of all lanes, in all lanes.
template <class Better>
GPHYS_INLINE FloatRegister best_lane(FloatRegister a, const Better& better) {
    a = better(a, FloatRegister(_mm256_permute2f128_ps(a.v, a.v, 1)));
    a = better(a, FloatRegister(_mm256_permute_ps(a.v, 0x4e)));
    return better(a, FloatRegister(_mm256_permute_ps(a.v, 0xb1)));
}
GPHYS_INLINE FloatRegister last_of_quads(FloatRegister a) { return _mm256_permute_ps(a.v, 0xff); }
GPHYS_INLINE FloatRegister without_last_of_quads(FloatRegister a) {
    return _mm256_blend_ps(a.v, _mm256_setzero_ps(), 0x88);
}
/// 4x4 transposition in each half of the registers.
GPHYS_INLINE void transpose(FloatRegister (&v)[4]) {
    const __m256 a = _mm256_unpacklo_ps(v[0].v, v[1].v), b = _mm256_unpackhi_ps(v[0].v, v[1].v);
    const __m256 c = _mm256_unpacklo_ps(v[2].v, v[3].v), d = _mm256_unpackhi_ps(v[2].v, v[3].v);
    v[0] = _mm256_shuffle_ps(a, c, 0x44);
    v[1] = _mm256_shuffle_ps(a, c, 0xee);
    v[2] = _mm256_shuffle_ps(b, d, 0x44);
    v[3] = _mm256_shuffle_ps(b, d, 0xee);
}
/// Two quadruples in one register.
GPHYS_INLINE FloatRegister load_pair(const float* low, const float* high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}
GPHYS_INLINE void store_pair(float* low, float* high, FloatRegister a) {
    _mm_storeu_ps(low, _mm256_castps256_ps128(a.v));
    _mm_storeu_ps(high, _mm256_extractf128_ps(a.v, 1));
}

#if GPHYS_ISA_IS(avx512)
using RawDoubles = __m512d;
#define GPHYS_DOUBLES(operation) _mm512_##operation
#else
using RawDoubles = __m256d;
#define GPHYS_DOUBLES(operation) _mm256_##operation
#endif

constexpr int double_register_lanes = sizeof(RawDoubles) / sizeof(double);

struct DoubleRegister {
    RawDoubles v;

    DoubleRegister() = default;
    GPHYS_INLINE DoubleRegister(RawDoubles value) : v(value) {}
    GPHYS_INLINE DoubleRegister(double all) : v(GPHYS_DOUBLES(set1_pd)(all)) {}
    GPHYS_INLINE double operator[](int i) const {
        double lanes[double_register_lanes];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};

GPHYS_INLINE DoubleRegister load_register(const double* from) { return GPHYS_DOUBLES(loadu_pd)(from); }
GPHYS_INLINE void store_register(double* to, DoubleRegister a) { GPHYS_DOUBLES(storeu_pd)(to, a.v); }
GPHYS_INLINE DoubleRegister operator+(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(add_pd)(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(sub_pd)(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator*(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(mul_pd)(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator/(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(div_pd)(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a) {
    return GPHYS_DOUBLES(xor_pd)(a.v, GPHYS_DOUBLES(set1_pd)(-0.0));
}
GPHYS_INLINE DoubleRegister least(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(min_pd)(a.v, b.v); }
GPHYS_INLINE DoubleRegister largest(DoubleRegister a, DoubleRegister b) { return GPHYS_DOUBLES(max_pd)(b.v, a.v); }
GPHYS_INLINE DoubleRegister square_root(DoubleRegister a) { return GPHYS_DOUBLES(sqrt_pd)(a.v); }
GPHYS_INLINE DoubleRegister absolute(DoubleRegister a) {
    return GPHYS_DOUBLES(andnot_pd)(GPHYS_DOUBLES(set1_pd)(-0.0), a.v);
}
GPHYS_INLINE DoubleRegister with_sign(DoubleRegister a, DoubleRegister sign) {
    return GPHYS_DOUBLES(or_pd)(absolute(a).v, GPHYS_DOUBLES(and_pd)(GPHYS_DOUBLES(set1_pd)(-0.0), sign.v));
}

#if GPHYS_ISA_IS(avx512)

/// A mask register: bit i is lane i.
struct MaskRegister {
    __mmask8 v;
};
struct DoubleMaskRegister {
    __mmask8 v;
};

GPHYS_INLINE MaskRegister operator<=(FloatRegister a, FloatRegister b) {
    return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OS)};
}
GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) {
    return {_mm256_cmpeq_epi32_mask(_mm256_castps_si256(a.v), _mm256_castps_si256(b.v))};
}
GPHYS_INLINE MaskRegister signs(FloatRegister a) { return {_mm256_movepi32_mask(_mm256_castps_si256(a.v))}; }
GPHYS_INLINE MaskRegister operator&(MaskRegister a, MaskRegister b) { return {_kand_mask8(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator|(MaskRegister a, MaskRegister b) { return {_kor_mask8(a.v, b.v)}; }
GPHYS_INLINE uint32_t bits(MaskRegister a) { return a.v; }
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return _mm256_mask_blend_ps(mask.v, b.v, a.v);
}
GPHYS_INLINE FloatRegister choose_bits(MaskRegister mask, int32_t a, int32_t b) {
    return _mm256_castsi256_ps(_mm256_mask_blend_epi32(mask.v, _mm256_set1_epi32(b), _mm256_set1_epi32(a)));
}

template <class At>
GPHYS_INLINE DoubleRegister load_doubles_from(const At& at, int first) {
    return _mm512_setr_pd(*at(first), *at(first + 1), *at(first + 2), *at(first + 3), *at(first + 4), *at(first + 5),
                          *at(first + 6), *at(first + 7));
}
GPHYS_INLINE DoubleMaskRegister operator<(DoubleRegister a, DoubleRegister b) {
    return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OS)};
}
GPHYS_INLINE DoubleMaskRegister operator<=(DoubleRegister a, DoubleRegister b) {
    return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OS)};
}
GPHYS_INLINE DoubleMaskRegister operator|(DoubleMaskRegister a, DoubleMaskRegister b) { return {_kor_mask8(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator&(DoubleMaskRegister a, DoubleMaskRegister b) {
    return {_kand_mask8(a.v, b.v)};
}
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) { return {_knot_mask8(a.v)}; }
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) { return a.v; }
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return _mm512_mask_blend_pd(mask.v, b.v, a.v);
}

/// Rounded to floats, and widened.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[1]) { return _mm512_cvtpd_ps(a[0].v); }
GPHYS_INLINE void widen_to(DoubleRegister (&to)[1], FloatRegister a) { to[0] = _mm512_cvtps_pd(a.v); }

/// 4x4 transposition in each half of the registers.
GPHYS_INLINE void transpose(DoubleRegister (&v)[4]) {
    const __m512d a = _mm512_unpacklo_pd(v[0].v, v[1].v), b = _mm512_unpackhi_pd(v[0].v, v[1].v);
    const __m512d c = _mm512_unpacklo_pd(v[2].v, v[3].v), d = _mm512_unpackhi_pd(v[2].v, v[3].v);
    const __m512i even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    v[0] = _mm512_permutex2var_pd(a, even, c);
    v[1] = _mm512_permutex2var_pd(b, even, d);
    v[2] = _mm512_permutex2var_pd(a, odd, c);
    v[3] = _mm512_permutex2var_pd(b, odd, d);
}
/// Load and store row(i) and row(i + 4), of four doubles each, as one register.
template <class Row>
GPHYS_INLINE DoubleRegister join_rows(const Row& row, int i) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(row(i)), row(i + 4), 1);
}
template <class Put>
GPHYS_INLINE void scatter_rows(DoubleRegister a, const Put& put, int i) {
    put(i, _mm512_castpd512_pd256(a.v));
    put(i + 4, _mm512_extractf64x4_pd(a.v, 1));
}

#else

/// All bits of a lane are set or none.
struct MaskRegister {
    __m256 v;
};
struct DoubleMaskRegister {
    __m256d v;
};

GPHYS_INLINE MaskRegister operator<=(FloatRegister a, FloatRegister b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OS)}; }
GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) {
    return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_castps_si256(a.v), _mm256_castps_si256(b.v)))};
}
GPHYS_INLINE MaskRegister signs(FloatRegister a) {
    return {_mm256_castsi256_ps(_mm256_srai_epi32(_mm256_castps_si256(a.v), 31))};
}
GPHYS_INLINE MaskRegister operator&(MaskRegister a, MaskRegister b) { return {_mm256_and_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator|(MaskRegister a, MaskRegister b) { return {_mm256_or_ps(a.v, b.v)}; }
GPHYS_INLINE uint32_t bits(MaskRegister a) { return static_cast<uint32_t>(_mm256_movemask_ps(a.v)); }
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return _mm256_blendv_ps(b.v, a.v, mask.v);
}
GPHYS_INLINE FloatRegister choose_bits(MaskRegister mask, int32_t a, int32_t b) {
    const __m256 all_b = _mm256_castsi256_ps(_mm256_set1_epi32(b));
    return _mm256_xor_ps(_mm256_and_ps(mask.v, _mm256_castsi256_ps(_mm256_set1_epi32(a ^ b))), all_b);
}

template <class At>
GPHYS_INLINE DoubleRegister load_doubles_from(const At& at, int first) {
    return _mm256_setr_pd(*at(first), *at(first + 1), *at(first + 2), *at(first + 3));
}
GPHYS_INLINE DoubleMaskRegister operator<(DoubleRegister a, DoubleRegister b) {
    return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OS)};
}
GPHYS_INLINE DoubleMaskRegister operator<=(DoubleRegister a, DoubleRegister b) {
    return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OS)};
}
GPHYS_INLINE DoubleMaskRegister operator|(DoubleMaskRegister a, DoubleMaskRegister b) {
    return {_mm256_or_pd(a.v, b.v)};
}
GPHYS_INLINE DoubleMaskRegister operator&(DoubleMaskRegister a, DoubleMaskRegister b) {
    return {_mm256_and_pd(a.v, b.v)};
}
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) {
    return {_mm256_xor_pd(a.v, _mm256_castsi256_pd(_mm256_set1_epi32(-1)))};
}
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) { return static_cast<uint32_t>(_mm256_movemask_pd(a.v)); }
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return _mm256_blendv_pd(b.v, a.v, mask.v);
}

/// Two registers of doubles rounded to floats, and floats widened to two registers.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[2]) {
    return _mm256_set_m128(_mm256_cvtpd_ps(a[1].v), _mm256_cvtpd_ps(a[0].v));
}
GPHYS_INLINE void widen_to(DoubleRegister (&to)[2], FloatRegister a) {
    to[0] = _mm256_cvtps_pd(_mm256_castps256_ps128(a.v));
    to[1] = _mm256_cvtps_pd(_mm256_extractf128_ps(a.v, 1));
}

/// 4x4 transposition.
GPHYS_INLINE void transpose(DoubleRegister (&v)[4]) {
    const __m256d a = _mm256_unpacklo_pd(v[0].v, v[1].v), b = _mm256_unpackhi_pd(v[0].v, v[1].v);
    const __m256d c = _mm256_unpacklo_pd(v[2].v, v[3].v), d = _mm256_unpackhi_pd(v[2].v, v[3].v);
    v[0] = _mm256_permute2f128_pd(a, c, 0x20);
    v[1] = _mm256_permute2f128_pd(b, d, 0x20);
    v[2] = _mm256_permute2f128_pd(a, c, 0x31);
    v[3] = _mm256_permute2f128_pd(b, d, 0x31);
}
/// Load and store row(i), of four doubles, as a register.
template <class Row>
GPHYS_INLINE DoubleRegister join_rows(const Row& row, int i) {
    return row(i);
}
template <class Put>
GPHYS_INLINE void scatter_rows(DoubleRegister a, const Put& put, int i) {
    put(i, a.v);
}

#endif

GPHYS_INLINE __m256d load_four(const double* from) { return _mm256_loadu_pd(from); }
GPHYS_INLINE void store_four(double* to, __m256d a) { _mm256_storeu_pd(to, a); }
/// Reads no memory behind the third double.
GPHYS_INLINE __m256d load_three(const double* from) {
    return _mm256_maskload_pd(from, _mm256_setr_epi64x(-1, -1, -1, 0));
}
GPHYS_INLINE void store_three(double* to, __m256d a) {
    _mm_storeu_pd(to, _mm256_castpd256_pd128(a));
    _mm_store_sd(to + 2, _mm256_extractf128_pd(a, 1));
}

}  // namespace gphys::GPHYS_ISA
