// Registers of SSE2. The functions are described in simd.h, simd_double.h and float4.h.
#pragma once

#include <cstring>

#include "foundation/compiler.h"

namespace gphys::simd_sse2 {

constexpr int register_lanes = 4, double_register_lanes = 2;

/// All bits of a lane are set or none.
struct MaskRegister {
    __m128 v;
};
struct DoubleMaskRegister {
    __m128d v;
};

struct FloatRegister {
    __m128 v;

    FloatRegister() = default;
    GPHYS_INLINE FloatRegister(__m128 value) : v(value) {}
    GPHYS_INLINE FloatRegister(float all) : v(_mm_set1_ps(all)) {}
    GPHYS_INLINE FloatRegister(float a, float b, float c, float d) : v(_mm_setr_ps(a, b, c, d)) {}
    GPHYS_INLINE float operator[](int i) const {
        float lanes[4];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};
struct DoubleRegister {
    __m128d v;

    DoubleRegister() = default;
    GPHYS_INLINE DoubleRegister(__m128d value) : v(value) {}
    GPHYS_INLINE DoubleRegister(double all) : v(_mm_set1_pd(all)) {}
    GPHYS_INLINE DoubleRegister(double a, double b) : v(_mm_setr_pd(a, b)) {}
    GPHYS_INLINE double operator[](int i) const {
        double lanes[2];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};

// --- Floats --------------------------------------------------------------------------------------

GPHYS_INLINE FloatRegister load_register(const float* from) { return _mm_loadu_ps(from); }
GPHYS_INLINE void store_register(float* to, FloatRegister a) { _mm_storeu_ps(to, a.v); }
GPHYS_INLINE FloatRegister as_floats(MaskRegister a) { return a.v; }
GPHYS_INLINE MaskRegister as_mask(FloatRegister a) { return {a.v}; }
GPHYS_INLINE MaskRegister set_mask(int32_t a, int32_t b, int32_t c, int32_t d) {
    return {_mm_castsi128_ps(_mm_setr_epi32(a, b, c, d))};
}

GPHYS_INLINE FloatRegister operator+(FloatRegister a, FloatRegister b) { return _mm_add_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator-(FloatRegister a, FloatRegister b) { return _mm_sub_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator*(FloatRegister a, FloatRegister b) { return _mm_mul_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister operator/(FloatRegister a, FloatRegister b) { return _mm_div_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister minimum(FloatRegister a, FloatRegister b) { return _mm_min_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister maximum(FloatRegister a, FloatRegister b) { return _mm_max_ps(a.v, b.v); }
GPHYS_INLINE FloatRegister square_root(FloatRegister a) { return _mm_sqrt_ps(a.v); }
GPHYS_INLINE FloatRegister integer_bits(FloatRegister a) { return _mm_castsi128_ps(_mm_cvttps_epi32(a.v)); }

GPHYS_INLINE MaskRegister operator<(FloatRegister a, FloatRegister b) { return {_mm_cmplt_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator<=(FloatRegister a, FloatRegister b) { return {_mm_cmple_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator!=(FloatRegister a, FloatRegister b) { return {_mm_cmpneq_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) {
    return {_mm_castsi128_ps(_mm_cmpeq_epi32(_mm_castps_si128(a.v), _mm_castps_si128(b.v)))};
}
GPHYS_INLINE MaskRegister greater_bits(FloatRegister a, FloatRegister b) {
    return {_mm_castsi128_ps(_mm_cmpgt_epi32(_mm_castps_si128(a.v), _mm_castps_si128(b.v)))};
}
GPHYS_INLINE MaskRegister signs(FloatRegister a) {
    return {_mm_castsi128_ps(_mm_srai_epi32(_mm_castps_si128(a.v), 31))};
}
GPHYS_INLINE MaskRegister operator&(MaskRegister a, MaskRegister b) { return {_mm_and_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator|(MaskRegister a, MaskRegister b) { return {_mm_or_ps(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator^(MaskRegister a, MaskRegister b) { return {_mm_xor_ps(a.v, b.v)}; }
/// Masks as integers: addition, shift, conversion to floats.
GPHYS_INLINE MaskRegister add_integers(MaskRegister a, MaskRegister b) {
    return {_mm_castsi128_ps(_mm_add_epi32(_mm_castps_si128(a.v), _mm_castps_si128(b.v)))};
}
template <int count>
GPHYS_INLINE MaskRegister shift_right(MaskRegister a) {
    return {_mm_castsi128_ps(_mm_srai_epi32(_mm_castps_si128(a.v), count))};
}
GPHYS_INLINE FloatRegister to_floats(MaskRegister a) { return _mm_cvtepi32_ps(_mm_castps_si128(a.v)); }
GPHYS_INLINE uint32_t bits(MaskRegister a) { return static_cast<uint32_t>(_mm_movemask_ps(a.v)); }
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return _mm_or_ps(_mm_and_ps(mask.v, a.v), _mm_andnot_ps(mask.v, b.v));
}

/// Lanes a and b of x, then c and d of y.
template <int a, int b, int c, int d>
GPHYS_INLINE FloatRegister shuffle(FloatRegister x, FloatRegister y) {
    return _mm_shuffle_ps(x.v, y.v, _MM_SHUFFLE(d, c, b, a));
}
GPHYS_INLINE void transpose(FloatRegister (&v)[4]) {
    const __m128 a = _mm_unpacklo_ps(v[0].v, v[1].v), b = _mm_unpackhi_ps(v[0].v, v[1].v);
    const __m128 c = _mm_unpacklo_ps(v[2].v, v[3].v), d = _mm_unpackhi_ps(v[2].v, v[3].v);
    v[0] = _mm_movelh_ps(a, c);
    v[1] = _mm_movehl_ps(c, a);
    v[2] = _mm_movelh_ps(b, d);
    v[3] = _mm_movehl_ps(d, b);
}

// --- Doubles -------------------------------------------------------------------------------------

GPHYS_INLINE DoubleRegister load_register(const double* from) { return _mm_loadu_pd(from); }
GPHYS_INLINE void store_register(double* to, DoubleRegister a) { _mm_storeu_pd(to, a.v); }

GPHYS_INLINE DoubleRegister operator+(DoubleRegister a, DoubleRegister b) { return _mm_add_pd(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a, DoubleRegister b) { return _mm_sub_pd(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator*(DoubleRegister a, DoubleRegister b) { return _mm_mul_pd(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator/(DoubleRegister a, DoubleRegister b) { return _mm_div_pd(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a) { return _mm_xor_pd(a.v, _mm_set1_pd(-0.0)); }
GPHYS_INLINE DoubleRegister least(DoubleRegister a, DoubleRegister b) { return _mm_min_pd(a.v, b.v); }
GPHYS_INLINE DoubleRegister largest(DoubleRegister a, DoubleRegister b) { return _mm_max_pd(b.v, a.v); }
GPHYS_INLINE DoubleRegister square_root(DoubleRegister a) { return _mm_sqrt_pd(a.v); }
GPHYS_INLINE DoubleRegister absolute(DoubleRegister a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a.v); }
GPHYS_INLINE DoubleRegister with_sign(DoubleRegister a, DoubleRegister sign) {
    return _mm_or_pd(absolute(a).v, _mm_and_pd(_mm_set1_pd(-0.0), sign.v));
}

GPHYS_INLINE DoubleMaskRegister operator<(DoubleRegister a, DoubleRegister b) { return {_mm_cmplt_pd(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator<=(DoubleRegister a, DoubleRegister b) { return {_mm_cmple_pd(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator|(DoubleMaskRegister a, DoubleMaskRegister b) { return {_mm_or_pd(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator&(DoubleMaskRegister a, DoubleMaskRegister b) { return {_mm_and_pd(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) {
    return {_mm_xor_pd(a.v, _mm_castsi128_pd(_mm_set1_epi32(-1)))};
}
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) { return static_cast<uint32_t>(_mm_movemask_pd(a.v)); }
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return _mm_or_pd(_mm_and_pd(mask.v, a.v), _mm_andnot_pd(mask.v, b.v));
}

/// Two registers of doubles rounded to floats, and floats widened to two registers.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[2]) {
    return _mm_movelh_ps(_mm_cvtpd_ps(a[0].v), _mm_cvtpd_ps(a[1].v));
}
GPHYS_INLINE void widen_to(DoubleRegister (&to)[2], FloatRegister a) {
    to[0] = _mm_cvtps_pd(a.v);
    to[1] = _mm_cvtps_pd(_mm_movehl_ps(a.v, a.v));
}

}  // namespace gphys::simd_sse2
