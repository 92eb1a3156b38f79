// Registers of NEON on 64-bit ARM. The functions are described in simd.h, simd_double.h and float4.h.
#pragma once

#include <arm_neon.h>

#include <cstring>

#include "foundation/compiler.h"

namespace gphys::simd_neon {

constexpr int register_lanes = 4, double_register_lanes = 2;

/// All bits of a lane are set or none.
struct MaskRegister {
    uint32x4_t v;
};
struct DoubleMaskRegister {
    uint64x2_t v;
};

struct FloatRegister {
    float32x4_t v;

    FloatRegister() = default;
    GPHYS_INLINE FloatRegister(float32x4_t value) : v(value) {}
    GPHYS_INLINE FloatRegister(float all) : v(vdupq_n_f32(all)) {}
    GPHYS_INLINE FloatRegister(float a, float b, float c, float d) {
        const float lanes[4] = {a, b, c, d};
        v = vld1q_f32(lanes);
    }
    GPHYS_INLINE float operator[](int i) const {
        float lanes[4];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};
struct DoubleRegister {
    float64x2_t v;

    DoubleRegister() = default;
    GPHYS_INLINE DoubleRegister(float64x2_t value) : v(value) {}
    GPHYS_INLINE DoubleRegister(double all) : v(vdupq_n_f64(all)) {}
    GPHYS_INLINE DoubleRegister(double a, double b) {
        const double lanes[2] = {a, b};
        v = vld1q_f64(lanes);
    }
    GPHYS_INLINE double operator[](int i) const {
        double lanes[2];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};

// --- Floats --------------------------------------------------------------------------------------

GPHYS_INLINE FloatRegister load_register(const float* from) { return vld1q_f32(from); }
GPHYS_INLINE void store_register(float* to, FloatRegister a) { vst1q_f32(to, a.v); }
GPHYS_INLINE FloatRegister as_floats(MaskRegister a) { return vreinterpretq_f32_u32(a.v); }
GPHYS_INLINE MaskRegister as_mask(FloatRegister a) { return {vreinterpretq_u32_f32(a.v)}; }
GPHYS_INLINE MaskRegister set_mask(int32_t a, int32_t b, int32_t c, int32_t d) {
    const int32_t lanes[4] = {a, b, c, d};
    return {vreinterpretq_u32_s32(vld1q_s32(lanes))};
}

GPHYS_INLINE MaskRegister operator<(FloatRegister a, FloatRegister b) { return {vcltq_f32(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator<=(FloatRegister a, FloatRegister b) { return {vcleq_f32(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator!=(FloatRegister a, FloatRegister b) { return {vmvnq_u32(vceqq_f32(a.v, b.v))}; }
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return vbslq_f32(mask.v, a.v, b.v);
}

GPHYS_INLINE FloatRegister operator+(FloatRegister a, FloatRegister b) { return vaddq_f32(a.v, b.v); }
GPHYS_INLINE FloatRegister operator-(FloatRegister a, FloatRegister b) { return vsubq_f32(a.v, b.v); }
GPHYS_INLINE FloatRegister operator*(FloatRegister a, FloatRegister b) { return vmulq_f32(a.v, b.v); }
GPHYS_INLINE FloatRegister operator/(FloatRegister a, FloatRegister b) { return vdivq_f32(a.v, b.v); }
// Not fmin and fmax, which differ for NaN and for zeros of different sign.
GPHYS_INLINE FloatRegister minimum(FloatRegister a, FloatRegister b) { return choose(a < b, a, b); }
GPHYS_INLINE FloatRegister maximum(FloatRegister a, FloatRegister b) { return choose(b < a, a, b); }
GPHYS_INLINE FloatRegister square_root(FloatRegister a) { return vsqrtq_f32(a.v); }
GPHYS_INLINE FloatRegister integer_bits(FloatRegister a) { return vreinterpretq_f32_s32(vcvtq_s32_f32(a.v)); }

GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) {
    return {vceqq_u32(vreinterpretq_u32_f32(a.v), vreinterpretq_u32_f32(b.v))};
}
GPHYS_INLINE MaskRegister greater_bits(FloatRegister a, FloatRegister b) {
    return {vcgtq_s32(vreinterpretq_s32_f32(a.v), vreinterpretq_s32_f32(b.v))};
}
GPHYS_INLINE MaskRegister signs(FloatRegister a) {
    return {vreinterpretq_u32_s32(vshrq_n_s32(vreinterpretq_s32_f32(a.v), 31))};
}
GPHYS_INLINE MaskRegister operator&(MaskRegister a, MaskRegister b) { return {vandq_u32(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator|(MaskRegister a, MaskRegister b) { return {vorrq_u32(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator^(MaskRegister a, MaskRegister b) { return {veorq_u32(a.v, b.v)}; }
/// Masks as integers: addition, shift, conversion to floats.
GPHYS_INLINE MaskRegister add_integers(MaskRegister a, MaskRegister b) { return {vaddq_u32(a.v, b.v)}; }
template <int count>
GPHYS_INLINE MaskRegister shift_right(MaskRegister a) {
    return {vreinterpretq_u32_s32(vshrq_n_s32(vreinterpretq_s32_u32(a.v), count))};
}
GPHYS_INLINE FloatRegister to_floats(MaskRegister a) { return vcvtq_f32_s32(vreinterpretq_s32_u32(a.v)); }
GPHYS_INLINE uint32_t bits(MaskRegister a) {
    const uint32_t lane_bits[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(a.v, vld1q_u32(lane_bits)));
}

/// Lanes a and b of x, then c and d of y.
template <int a, int b, int c, int d>
GPHYS_INLINE FloatRegister shuffle(FloatRegister x, FloatRegister y) {
    const float32x4_t first = vcopyq_laneq_f32(vdupq_laneq_f32(x.v, a), 1, x.v, b);
    return vcopyq_laneq_f32(vcopyq_laneq_f32(first, 2, y.v, c), 3, y.v, d);
}
GPHYS_INLINE void transpose(FloatRegister (&v)[4]) {
    const auto pairs = [](float32x4_t x) { return vreinterpretq_f64_f32(x); };
    const float64x2_t a = pairs(vtrn1q_f32(v[0].v, v[1].v)), b = pairs(vtrn2q_f32(v[0].v, v[1].v));
    const float64x2_t c = pairs(vtrn1q_f32(v[2].v, v[3].v)), d = pairs(vtrn2q_f32(v[2].v, v[3].v));
    v[0] = vreinterpretq_f32_f64(vtrn1q_f64(a, c));
    v[1] = vreinterpretq_f32_f64(vtrn1q_f64(b, d));
    v[2] = vreinterpretq_f32_f64(vtrn2q_f64(a, c));
    v[3] = vreinterpretq_f32_f64(vtrn2q_f64(b, d));
}

// --- Doubles -------------------------------------------------------------------------------------

GPHYS_INLINE DoubleRegister load_register(const double* from) { return vld1q_f64(from); }
GPHYS_INLINE void store_register(double* to, DoubleRegister a) { vst1q_f64(to, a.v); }

GPHYS_INLINE DoubleMaskRegister operator<(DoubleRegister a, DoubleRegister b) { return {vcltq_f64(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator<=(DoubleRegister a, DoubleRegister b) { return {vcleq_f64(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator|(DoubleMaskRegister a, DoubleMaskRegister b) { return {vorrq_u64(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator&(DoubleMaskRegister a, DoubleMaskRegister b) { return {vandq_u64(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) {
    return {vreinterpretq_u64_u32(vmvnq_u32(vreinterpretq_u32_u64(a.v)))};
}
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) {
    return static_cast<uint32_t>((vgetq_lane_u64(a.v, 0) & 1) | (vgetq_lane_u64(a.v, 1) & 2));
}
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return vbslq_f64(mask.v, a.v, b.v);
}

GPHYS_INLINE DoubleRegister operator+(DoubleRegister a, DoubleRegister b) { return vaddq_f64(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a, DoubleRegister b) { return vsubq_f64(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator*(DoubleRegister a, DoubleRegister b) { return vmulq_f64(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator/(DoubleRegister a, DoubleRegister b) { return vdivq_f64(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a) { return vnegq_f64(a.v); }
GPHYS_INLINE DoubleRegister least(DoubleRegister a, DoubleRegister b) { return select(a < b, a, b); }
GPHYS_INLINE DoubleRegister largest(DoubleRegister a, DoubleRegister b) { return select(a < b, b, a); }
GPHYS_INLINE DoubleRegister square_root(DoubleRegister a) { return vsqrtq_f64(a.v); }
GPHYS_INLINE DoubleRegister absolute(DoubleRegister a) { return vabsq_f64(a.v); }
GPHYS_INLINE DoubleRegister with_sign(DoubleRegister a, DoubleRegister sign) {
    return vbslq_f64(vdupq_n_u64(uint64_t{1} << 63), sign.v, a.v);
}

/// Two registers of doubles rounded to floats, and floats widened to two registers.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[2]) {
    return vcvt_high_f32_f64(vcvt_f32_f64(a[0].v), a[1].v);
}
GPHYS_INLINE void widen_to(DoubleRegister (&to)[2], FloatRegister a) {
    to[0] = vcvt_f64_f32(vget_low_f32(a.v));
    to[1] = vcvt_high_f64_f32(a.v);
}

}  // namespace gphys::simd_neon
