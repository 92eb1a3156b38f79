// Registers of four floats or two doubles for targets without an instruction set of their own here, and as a reference
// for the others. Plain C++; gcc and clang use their vector types, which they compile to the SIMD instructions of the
// target. The functions are described in simd.h, simd_double.h and float4.h.
#pragma once

#include <cmath>
#include <cstring>

#include "foundation/compiler.h"

namespace gphys::simd_plain {

constexpr int register_lanes = 4, double_register_lanes = 2;

#if defined(__GNUC__)
using Floats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(16)));
using Integers = int32_t __attribute__((vector_size(16)));
using LongIntegers = int64_t __attribute__((vector_size(16)));
#else
using Floats = float[4];
using Doubles = double[2];
using Integers = int32_t[4];
using LongIntegers = int64_t[2];
#endif

/// All bits of a lane are set or none.
struct MaskRegister {
    Integers lane;
};
struct DoubleMaskRegister {
    LongIntegers lane;
};

struct FloatRegister {
    Floats lane;

    FloatRegister() = default;
    GPHYS_INLINE FloatRegister(float all) : lane{all, all, all, all} {}
    GPHYS_INLINE FloatRegister(float a, float b, float c, float d) : lane{a, b, c, d} {}
    GPHYS_INLINE float operator[](int i) const { return lane[i]; }
};
struct DoubleRegister {
    Doubles lane;

    DoubleRegister() = default;
    GPHYS_INLINE DoubleRegister(double all) : lane{all, all} {}
    GPHYS_INLINE DoubleRegister(double a, double b) : lane{a, b} {}
    GPHYS_INLINE double operator[](int i) const { return lane[i]; }
};

/// Lane i is to(i).
template <class Register, class To>
GPHYS_INLINE Register each(const To& to) {
    Register result;
    for (int i = 0; i < static_cast<int>(sizeof result.lane / sizeof result.lane[0]); ++i) result.lane[i] = to(i);
    return result;
}
/// operation(a, b) for each lane.
template <class Register, class Operation>
GPHYS_INLINE Register combine(const Register& a, const Register& b, const Operation& operation) {
#if defined(__GNUC__)
    Register result;
    result.lane = operation(a.lane, b.lane);
    return result;
#else
    return each<Register>([&](int i) { return operation(a.lane[i], b.lane[i]); });
#endif
}
/// A mask of the lanes for which comparison(a, b).
template <class Mask, class Lanes, class Comparison>
GPHYS_INLINE Mask compare(const Lanes& a, const Lanes& b, const Comparison& comparison) {
#if defined(__GNUC__)
    return {comparison(a, b)};
#else
    return each<Mask>([&](int i) { return comparison(a[i], b[i]) ? -1 : 0; });
#endif
}
/// Define functions of two registers: the expression of their lanes x and y, and a mask of the lanes for which it
/// holds.
#define GPHYS_COMBINE(Register, function, expression)                    \
    GPHYS_INLINE Register function(Register a, Register b) {             \
        return combine(a, b, [](auto x, auto y) { return expression; }); \
    }
#define GPHYS_COMPARE(Mask, Register, function, expression)                              \
    GPHYS_INLINE Mask function(Register a, Register b) {                                 \
        return compare<Mask>(a.lane, b.lane, [](auto x, auto y) { return expression; }); \
    }
/// Blend: a in the lanes that are set, else b.
template <class Register, class Mask>
GPHYS_INLINE Register choose_lanes(const Mask& mask, const Register& a, const Register& b) {
#if defined(__GNUC__)
    Register result;
    result.lane = mask.lane ? a.lane : b.lane;
    return result;
#else
    return each<Register>([&](int i) { return mask.lane[i] != 0 ? a.lane[i] : b.lane[i]; });
#endif
}

// --- Floats --------------------------------------------------------------------------------------

GPHYS_INLINE FloatRegister load_register(const float* from) {
    FloatRegister a;
    std::memcpy(&a.lane, from, sizeof a.lane);
    return a;
}
GPHYS_INLINE void store_register(float* to, FloatRegister a) { std::memcpy(to, &a.lane, sizeof a.lane); }
GPHYS_INLINE FloatRegister as_floats(MaskRegister a) {
    FloatRegister result;
    std::memcpy(&result.lane, &a.lane, sizeof a.lane);
    return result;
}
GPHYS_INLINE MaskRegister as_mask(FloatRegister a) {
    MaskRegister result;
    std::memcpy(&result.lane, &a.lane, sizeof a.lane);
    return result;
}
GPHYS_INLINE MaskRegister set_mask(int32_t a, int32_t b, int32_t c, int32_t d) {
    MaskRegister result;
    const int32_t lanes[4] = {a, b, c, d};
    std::memcpy(&result.lane, lanes, sizeof lanes);
    return result;
}

/// Masks as integers: addition, shift, conversion to floats.
GPHYS_COMBINE(MaskRegister, add_integers, x + y)
template <int count>
GPHYS_INLINE MaskRegister shift_right(MaskRegister a) {
    return combine(a, a, [](auto x, auto) { return x >> count; });
}
GPHYS_INLINE FloatRegister to_floats(MaskRegister a) {
    return each<FloatRegister>([&](int i) { return static_cast<float>(a.lane[i]); });
}

GPHYS_COMBINE(FloatRegister, operator+, x + y)
GPHYS_COMBINE(FloatRegister, operator-, x - y)
GPHYS_COMBINE(FloatRegister, operator*, x* y)
GPHYS_COMBINE(FloatRegister, operator/, x / y)
GPHYS_COMBINE(FloatRegister, minimum, x < y ? x : y)
GPHYS_COMBINE(FloatRegister, maximum, x > y ? x : y)
GPHYS_INLINE FloatRegister square_root(FloatRegister a) {
    return each<FloatRegister>([&](int i) { return ::sqrtf(a.lane[i]); });
}
GPHYS_INLINE FloatRegister integer_bits(FloatRegister a) {
    return as_floats(each<MaskRegister>([&](int i) { return static_cast<int32_t>(a.lane[i]); }));
}

GPHYS_COMPARE(MaskRegister, FloatRegister, operator<, x < y)
GPHYS_COMPARE(MaskRegister, FloatRegister, operator<=, x <= y)
GPHYS_COMPARE(MaskRegister, FloatRegister, operator!=, x != y)
GPHYS_INLINE MaskRegister equal_bits(FloatRegister a, FloatRegister b) {
    return compare<MaskRegister>(as_mask(a).lane, as_mask(b).lane, [](auto x, auto y) { return x == y; });
}
GPHYS_INLINE MaskRegister greater_bits(FloatRegister a, FloatRegister b) {
    return compare<MaskRegister>(as_mask(a).lane, as_mask(b).lane, [](auto x, auto y) { return x > y; });
}
GPHYS_INLINE MaskRegister signs(FloatRegister a) { return shift_right<31>(as_mask(a)); }
GPHYS_COMBINE(MaskRegister, operator&, x& y)
GPHYS_COMBINE(MaskRegister, operator|, x | y)
GPHYS_COMBINE(MaskRegister, operator^, x ^ y)
GPHYS_INLINE uint32_t bits(MaskRegister a) {
    uint32_t result = 0;
    for (int i = 0; i < 4; ++i) result |= static_cast<uint32_t>(a.lane[i] & 1) << i;
    return result;
}
GPHYS_INLINE FloatRegister choose(MaskRegister mask, FloatRegister a, FloatRegister b) {
    return choose_lanes(mask, a, b);
}

/// Lanes a and b of x, then c and d of y.
template <int a, int b, int c, int d>
GPHYS_INLINE FloatRegister shuffle(FloatRegister x, FloatRegister y) {
    return {x.lane[a], x.lane[b], y.lane[c], y.lane[d]};
}
GPHYS_INLINE void transpose(FloatRegister (&v)[4]) {
    for (int i = 0; i < 4; ++i) {
        for (int k = i + 1; k < 4; ++k) {
            const float kept = v[i].lane[k];
            v[i].lane[k] = v[k].lane[i];
            v[k].lane[i] = kept;
        }
    }
}

// --- Doubles -------------------------------------------------------------------------------------

GPHYS_INLINE DoubleRegister load_register(const double* from) {
    DoubleRegister a;
    std::memcpy(&a.lane, from, sizeof a.lane);
    return a;
}
GPHYS_INLINE void store_register(double* to, DoubleRegister a) { std::memcpy(to, &a.lane, sizeof a.lane); }

GPHYS_COMBINE(DoubleRegister, operator+, x + y)
GPHYS_COMBINE(DoubleRegister, operator-, x - y)
GPHYS_COMBINE(DoubleRegister, operator*, x* y)
GPHYS_COMBINE(DoubleRegister, operator/, x / y)
GPHYS_INLINE DoubleRegister operator-(DoubleRegister a) {
    return combine(a, a, [](auto x, auto) { return -x; });
}
GPHYS_COMBINE(DoubleRegister, least, x < y ? x : y)
GPHYS_COMBINE(DoubleRegister, largest, x < y ? y : x)
GPHYS_INLINE DoubleRegister square_root(DoubleRegister a) {
    return each<DoubleRegister>([&](int i) { return ::sqrt(a.lane[i]); });
}
GPHYS_INLINE DoubleRegister absolute(DoubleRegister a) {
    return each<DoubleRegister>([&](int i) { return ::fabs(a.lane[i]); });
}
GPHYS_INLINE DoubleRegister with_sign(DoubleRegister a, DoubleRegister sign) {
    return each<DoubleRegister>([&](int i) { return ::copysign(a.lane[i], sign.lane[i]); });
}

GPHYS_COMPARE(DoubleMaskRegister, DoubleRegister, operator<, x < y)
GPHYS_COMPARE(DoubleMaskRegister, DoubleRegister, operator<=, x <= y)
GPHYS_COMBINE(DoubleMaskRegister, operator|, x | y)
GPHYS_COMBINE(DoubleMaskRegister, operator&, x& y)
GPHYS_INLINE DoubleMaskRegister operator!(DoubleMaskRegister a) {
    return combine(a, a, [](auto x, auto) { return ~x; });
}
GPHYS_INLINE uint32_t bits(DoubleMaskRegister a) { return static_cast<uint32_t>((a.lane[0] & 1) | (a.lane[1] & 2)); }
GPHYS_INLINE DoubleRegister select(DoubleMaskRegister mask, DoubleRegister a, DoubleRegister b) {
    return choose_lanes(mask, a, b);
}

/// Two registers of doubles rounded to floats, and floats widened to two registers. Through memory, because gcc 12
/// optimizes a pair of lane conversions away.
GPHYS_INLINE FloatRegister narrowed(const DoubleRegister (&a)[2]) {
    float lanes[4];
    for (int i = 0; i < 4; ++i) lanes[i] = static_cast<float>(a[i / 2].lane[i % 2]);
    return load_register(lanes);
}
GPHYS_INLINE void widen_to(DoubleRegister (&to)[2], FloatRegister a) {
    double lanes[4];
    for (int i = 0; i < 4; ++i) lanes[i] = static_cast<double>(a.lane[i]);
    for (int k = 0; k < 2; ++k) to[k] = load_register(lanes + 2 * k);
}

}  // namespace gphys::simd_plain
