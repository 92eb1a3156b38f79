// Registers of WebAssembly SIMD. The functions are described in simd.h, simd_double.h and float4.h.
#pragma once

#include <wasm_simd128.h>

#include <cstring>

#include "foundation/compiler.h"

namespace gphys::simd_wasm {

constexpr int register_lanes = 4, double_register_lanes = 2;

/// All bits of a lane are set or none.
struct MaskRegister {
    v128_t v;
};
struct DoubleMaskRegister {
    v128_t v;
};

struct FloatRegister {
    v128_t v;

    FloatRegister() = default;
    GPHYS_INLINE FloatRegister(v128_t value) : v(value) {}
    GPHYS_INLINE FloatRegister(float all) : v(wasm_f32x4_splat(all)) {}
    GPHYS_INLINE FloatRegister(float a, float b, float c, float d) : v(wasm_f32x4_make(a, b, c, d)) {}
    GPHYS_INLINE float operator[](int i) const {
        float lanes[4];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};
struct DoubleRegister {
    v128_t v;

    DoubleRegister() = default;
    GPHYS_INLINE DoubleRegister(v128_t value) : v(value) {}
    GPHYS_INLINE DoubleRegister(double all) : v(wasm_f64x2_splat(all)) {}
    GPHYS_INLINE DoubleRegister(double a, double b) : v(wasm_f64x2_make(a, b)) {}
    GPHYS_INLINE double operator[](int i) const {
        double lanes[2];
        std::memcpy(lanes, &v, sizeof v);
        return lanes[i];
    }
};

// --- Floats --------------------------------------------------------------------------------------

GPHYS_INLINE FloatRegister load_register(const float* from) { return wasm_v128_load(from); }
GPHYS_INLINE void store_register(float* to, FloatRegister a) { wasm_v128_store(to, a.v); }
GPHYS_INLINE FloatRegister as_floats(MaskRegister a) { return a.v; }
GPHYS_INLINE MaskRegister as_mask(FloatRegister a) { return {a.v}; }
GPHYS_INLINE MaskRegister set_mask(int32_t a, int32_t b, int32_t c, int32_t d) { return {wasm_i32x4_make(a, b, c, d)}; }

GPHYS_INLINE FloatRegister operator+(FloatRegister a, FloatRegister b) { return wasm_f32x4_add(a.v, b.v); }
GPHYS_INLINE FloatRegister operator-(FloatRegister a, FloatRegister b) { return wasm_f32x4_sub(a.v, b.v); }
GPHYS_INLINE FloatRegister operator*(FloatRegister a, FloatRegister b) { return wasm_f32x4_mul(a.v, b.v); }
GPHYS_INLINE FloatRegister operator/(FloatRegister a, FloatRegister b) { return wasm_f32x4_div(a.v, b.v); }
// pmin(x, y) is y < x ? y : x.
GPHYS_INLINE FloatRegister minimum(FloatRegister a, FloatRegister b) { return wasm_f32x4_pmin(b.v, a.v); }
GPHYS_INLINE FloatRegister maximum(FloatRegister a, FloatRegister b) { return wasm_f32x4_pmax(b.v, a.v); }
GPHYS_INLINE FloatRegister square_root(FloatRegister a) { return wasm_f32x4_sqrt(a.v); }
GPHYS_INLINE FloatRegister integer_bits(FloatRegister a) { return wasm_i32x4_trunc_sat_f32x4(a.v); }

GPHYS_INLINE MaskRegister operator<(FloatRegister a, FloatRegister b) { return {wasm_f32x4_lt(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator<=(FloatRegister a, FloatRegister b) { return {wasm_f32x4_le(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator!=(FloatRegister a, FloatRegister b) { return {wasm_f32x4_ne(a.v, b.v)}; }
GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) { return {wasm_i32x4_eq(a.v, b.v)}; }
GPHYS_INLINE MaskRegister greater_bits(FloatRegister a, FloatRegister b) { return {wasm_i32x4_gt(a.v, b.v)}; }
GPHYS_INLINE MaskRegister signs(FloatRegister a) { return {wasm_i32x4_shr(a.v, 31)}; }
GPHYS_INLINE MaskRegister operator&(MaskRegister a, MaskRegister b) { return {wasm_v128_and(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator|(MaskRegister a, MaskRegister b) { return {wasm_v128_or(a.v, b.v)}; }
GPHYS_INLINE MaskRegister operator^(MaskRegister a, MaskRegister b) { return {wasm_v128_xor(a.v, b.v)}; }
/// Masks as integers: addition, shift, conversion to floats.
GPHYS_INLINE MaskRegister add_integers(MaskRegister a, MaskRegister b) { return {wasm_i32x4_add(a.v, b.v)}; }
template <int count>
GPHYS_INLINE MaskRegister shift_right(MaskRegister a) {
    return {wasm_i32x4_shr(a.v, count)};
}
GPHYS_INLINE FloatRegister to_floats(MaskRegister a) { return wasm_f32x4_convert_i32x4(a.v); }
GPHYS_INLINE uint32_t bits(MaskRegister a) { return wasm_i32x4_bitmask(a.v); }
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return wasm_v128_bitselect(a.v, b.v, mask.v);
}

/// Lanes a and b of x, then c and d of y.
template <int a, int b, int c, int d>
GPHYS_INLINE FloatRegister shuffle(FloatRegister x, FloatRegister y) {
    return wasm_i32x4_shuffle(x.v, y.v, a, b, 4 + c, 4 + d);
}
GPHYS_INLINE void transpose(FloatRegister (&v)[4]) {
    const v128_t a = wasm_i32x4_shuffle(v[0].v, v[1].v, 0, 4, 1, 5), b = wasm_i32x4_shuffle(v[0].v, v[1].v, 2, 6, 3, 7);
    const v128_t c = wasm_i32x4_shuffle(v[2].v, v[3].v, 0, 4, 1, 5), d = wasm_i32x4_shuffle(v[2].v, v[3].v, 2, 6, 3, 7);
    v[0] = wasm_i32x4_shuffle(a, c, 0, 1, 4, 5);
    v[1] = wasm_i32x4_shuffle(a, c, 2, 3, 6, 7);
    v[2] = wasm_i32x4_shuffle(b, d, 0, 1, 4, 5);
    v[3] = wasm_i32x4_shuffle(b, d, 2, 3, 6, 7);
}

// --- Doubles -------------------------------------------------------------------------------------

GPHYS_INLINE DoubleRegister load_register(const double* from) { return wasm_v128_load(from); }
GPHYS_INLINE void store_register(double* to, DoubleRegister a) { wasm_v128_store(to, a.v); }

GPHYS_INLINE DoubleRegister operator+(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_add(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_sub(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator*(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_mul(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator/(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_div(a.v, b.v); }
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a) { return wasm_f64x2_neg(a.v); }
GPHYS_INLINE DoubleRegister least(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_pmin(b.v, a.v); }
GPHYS_INLINE DoubleRegister largest(DoubleRegister a, DoubleRegister b) { return wasm_f64x2_pmax(a.v, b.v); }
GPHYS_INLINE DoubleRegister square_root(DoubleRegister a) { return wasm_f64x2_sqrt(a.v); }
GPHYS_INLINE DoubleRegister absolute(DoubleRegister a) { return wasm_f64x2_abs(a.v); }
GPHYS_INLINE DoubleRegister with_sign(DoubleRegister a, DoubleRegister sign) {
    return wasm_v128_bitselect(sign.v, a.v, wasm_f64x2_splat(-0.0));
}

GPHYS_INLINE DoubleMaskRegister operator<(DoubleRegister a, DoubleRegister b) { return {wasm_f64x2_lt(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator<=(DoubleRegister a, DoubleRegister b) { return {wasm_f64x2_le(a.v, b.v)}; }
GPHYS_INLINE DoubleMaskRegister operator|(DoubleMaskRegister a, DoubleMaskRegister b) {
    return {wasm_v128_or(a.v, b.v)};
}
GPHYS_INLINE DoubleMaskRegister operator&(DoubleMaskRegister a, DoubleMaskRegister b) {
    return {wasm_v128_and(a.v, b.v)};
}
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) { return {wasm_v128_not(a.v)}; }
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) { return wasm_i64x2_bitmask(a.v); }
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return wasm_v128_bitselect(a.v, b.v, mask.v);
}

/// Two registers of doubles rounded to floats, and floats widened to two registers.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[2]) {
    return wasm_i32x4_shuffle(wasm_f32x4_demote_f64x2_zero(a[0].v), wasm_f32x4_demote_f64x2_zero(a[1].v), 0, 1, 4, 5);
}
GPHYS_INLINE void widen_to(DoubleRegister (&to)[2], FloatRegister a) {
    to[0] = wasm_f64x2_promote_low_f32x4(a.v);
    to[1] = wasm_f64x2_promote_low_f32x4(wasm_i32x4_shuffle(a.v, a.v, 2, 3, 2, 3));
}

}  // namespace gphys::simd_wasm
