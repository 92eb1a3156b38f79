// Eight floats in SIMD registers, for kernels (isa.h). The registers are those of simd_plain.h, simd_sse2.h,
// simd_avx.h, simd_neon.h or simd_wasm.h, which implement the differences between instruction sets. Plain IEEE
// arithmetic without fused operations, so all sets give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "foundation/compiler.h"
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
// AVX-512 includes AVX2.
#define GPHYS_HAS_AVX2 (GPHYS_ISA_IS(avx2) || GPHYS_ISA_IS(avx512))

#if GPHYS_HAS_AVX2
#include "foundation/simd_avx.h"
#elif GPHYS_ISA_IS(sse2)
#include "foundation/simd_sse2.h"
namespace gphys::GPHYS_ISA {
using namespace simd_sse2;
}
#elif GPHYS_ISA_IS(neon)
#include "foundation/simd_neon.h"
namespace gphys::GPHYS_ISA {
using namespace simd_neon;
}
#elif GPHYS_ISA_IS(wasm)
#include "foundation/simd_wasm.h"
namespace gphys::GPHYS_ISA {
using namespace simd_wasm;
}
#else
#include "foundation/simd_plain.h"
namespace gphys::GPHYS_ISA {
using namespace simd_plain;
}
#endif

namespace gphys::GPHYS_ISA {

constexpr int register_count = 8 / register_lanes;

struct Float8 {
    FloatRegister part[register_count];
};
struct Mask8 {
    MaskRegister part[register_count];
};

/// Defines a function of eight lanes: register i of its result is the expression.
#define GPHYS_BY_REGISTER(Result, function, expression)                   \
    GPHYS_INLINE Result function {                                        \
        Result result;                                                    \
        constexpr int count = sizeof result.part / sizeof result.part[0]; \
        for (int i = 0; i < count; ++i) result.part[i] = expression;      \
        return result;                                                    \
    }

#if !GPHYS_HAS_AVX2
GPHYS_INLINE float first_lane(FloatRegister a) { return a[0]; }
/// Horizontal reduction: the best of all lanes, in all lanes.
template <class Better>
GPHYS_INLINE FloatRegister best_lane(FloatRegister a, const Better& better) {
    a = better(a, shuffle<2, 3, 0, 1>(a, a));
    return better(a, shuffle<1, 0, 3, 2>(a, a));
}
GPHYS_INLINE FloatRegister last_of_quads(FloatRegister a) { return shuffle<3, 3, 3, 3>(a, a); }
GPHYS_INLINE FloatRegister without_last_of_quads(FloatRegister a) {
    return as_floats(as_mask(a) & set_mask(-1, -1, -1, 0));
}
GPHYS_INLINE FloatRegister choose_bits(MaskRegister mask, int32_t a, int32_t b) {
    const int32_t other = a ^ b;
    return as_floats((mask & set_mask(other, other, other, other)) ^ set_mask(b, b, b, b));
}
#endif

GPHYS_BY_REGISTER(Float8, load(const float* from), load_register(from + register_lanes * i))
/// The same from aligned memory. gcc 12 splits AVX-512 loads whose alignment it does not know.
GPHYS_INLINE Float8 load_aligned(const float* from) { return load(assume_aligned<sizeof(FloatRegister)>(from)); }
GPHYS_INLINE void store(float* to, Float8 v) {
    for (int i = 0; i < register_count; ++i) store_register(to + register_lanes * i, v.part[i]);
}
GPHYS_INLINE Float8 splat(float value) {
    Float8 v;
    for (FloatRegister& part : v.part) part = FloatRegister(value);
    return v;
}
#if GPHYS_HAS_AVX2
/// Permutation: lane i is row[lanes[i]].
GPHYS_INLINE Float8 load_permuted(const float row[8], const uint32_t lanes[8]) { return {{permuted(row, lanes)}}; }
#endif

GPHYS_BY_REGISTER(Float8, operator+(Float8 a, Float8 b), a.part[i] + b.part[i])
GPHYS_BY_REGISTER(Float8, operator-(Float8 a, Float8 b), a.part[i] - b.part[i])
GPHYS_BY_REGISTER(Float8, operator*(Float8 a, Float8 b), a.part[i] * b.part[i])
GPHYS_BY_REGISTER(Float8, operator/(Float8 a, Float8 b), a.part[i] / b.part[i])
GPHYS_BY_REGISTER(Float8, sqrt(Float8 a), square_root(a.part[i]))
/// a < b ? a : b, and a > b ? a : b.
GPHYS_BY_REGISTER(Float8, min(Float8 a, Float8 b), minimum(a.part[i], b.part[i]))
GPHYS_BY_REGISTER(Float8, max(Float8 a, Float8 b), maximum(a.part[i], b.part[i]))
/// Horizontal reduction: the best of all lanes, in all lanes.
template <class Better>
GPHYS_INLINE Float8 best_of_all(Float8 a, const Better& better) {
    FloatRegister best = a.part[0];
    for (int i = 1; i < register_count; ++i) best = better(best, a.part[i]);
    best = best_lane(best, better);
    for (FloatRegister& part : a.part) part = best;
    return a;
}
GPHYS_INLINE Float8 least_lane(Float8 a) {
    return best_of_all(a, [](FloatRegister p, FloatRegister q) GPHYS_INLINE_LAMBDA { return minimum(p, q); });
}
GPHYS_INLINE Float8 greatest_lane(Float8 a) {
    return best_of_all(a, [](FloatRegister p, FloatRegister q) GPHYS_INLINE_LAMBDA { return maximum(p, q); });
}
GPHYS_INLINE float first_lane(Float8 a) { return first_lane(a.part[0]); }

GPHYS_INLINE Float8 abs(Float8 a) { return max(a, splat(0) - a); }

/// Floats with integer values to the bits of these integers.
GPHYS_BY_REGISTER(Float8, integer_bits(Float8 a), integer_bits(a.part[i]))

/// Blend: a in the lanes that are set, else b.
GPHYS_BY_REGISTER(Float8, choose(Mask8 mask, Float8 a, Float8 b), choose(mask.part[i], a.part[i], b.part[i]))
/// Blend of integers.
GPHYS_BY_REGISTER(Float8, choose_bits(Mask8 mask, int32_t a, int32_t b), choose_bits(mask.part[i], a, b))
/// The sign bits, also of zeros.
GPHYS_BY_REGISTER(Mask8, signs(Float8 a), signs(a.part[i]))
GPHYS_BY_REGISTER(Mask8, operator<=(Float8 a, Float8 b), a.part[i] <= b.part[i])
/// Compares bits, so that denormals are distinct even in a host that flushes them to zero.
GPHYS_BY_REGISTER(Mask8, equal_bits(Float8 a, Float8 b), equal_bits(a.part[i], b.part[i]))
GPHYS_BY_REGISTER(Mask8, operator&(Mask8 a, Mask8 b), a.part[i] & b.part[i])
GPHYS_BY_REGISTER(Mask8, operator|(Mask8 a, Mask8 b), a.part[i] | b.part[i])
/// Movemask: bit i is lane i.
GPHYS_INLINE uint32_t bits(Mask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < register_count; ++i) result |= bits(mask.part[i]) << (register_lanes * i);
    return result;
}

// The function names of other numbers (numbers.h).
inline Float8 absolute(Float8 a) { return abs(a); }
inline Float8 square_root(Float8 a) { return sqrt(a); }
inline Float8 least(Float8 a, Float8 b) { return min(a, b); }
inline Float8 largest(Float8 a, Float8 b) { return max(b, a); }
inline Float8 select(Mask8 mask, Float8 a, Float8 b) { return choose(mask, a, b); }
inline Float8 splat_as(Float8, float value) { return splat(value); }

/// Eight quadruples of floats as four registers, one for each component (structure of arrays).
struct Quads8 {
    Float8 x, y, z, w;
};

template <class At>
GPHYS_INLINE Quads8 load_quads(const At& at) {
#if GPHYS_HAS_AVX2
    FloatRegister v[4];
    for (int i = 0; i < 4; ++i) v[i] = load_pair(at(i), at(i + 4));
    transpose(v);
    return {{{v[0]}}, {{v[1]}}, {{v[2]}}, {{v[3]}}};
#else
    Quads8 quads;
    for (int half = 0; half < 2; ++half) {
        FloatRegister v[4];
        for (int i = 0; i < 4; ++i) v[i] = load_register(at(4 * half + i));
        transpose(v);
        quads.x.part[half] = v[0], quads.y.part[half] = v[1], quads.z.part[half] = v[2], quads.w.part[half] = v[3];
    }
    return quads;
#endif
}
template <class At>
GPHYS_INLINE void store_quads(const At& at, const Quads8& quads) {
#if GPHYS_HAS_AVX2
    FloatRegister v[4] = {quads.x.part[0], quads.y.part[0], quads.z.part[0], quads.w.part[0]};
    transpose(v);
    for (int i = 0; i < 4; ++i) store_pair(at(i), at(i + 4), v[i]);
#else
    for (int half = 0; half < 2; ++half) {
        FloatRegister v[4] = {quads.x.part[half], quads.y.part[half], quads.z.part[half], quads.w.part[half]};
        transpose(v);
        for (int i = 0; i < 4; ++i) store_register(at(4 * half + i), v[i]);
    }
#endif
}
/// The same from an array of quadruples, by index.
GPHYS_INLINE Quads8 load_quads(const float* from, const uint32_t* index) {
    return load_quads([&](int i) GPHYS_INLINE_LAMBDA { return from + 4 * size_t{index[i]}; });
}
GPHYS_INLINE void store_quads(float* to, const uint32_t* index, const Quads8& quads) {
    store_quads([&](int i) GPHYS_INLINE_LAMBDA { return to + 4 * size_t{index[i]}; }, quads);
}

/// From two consecutive quadruples: the last float of each in its four lanes, 0 in the last.
GPHYS_BY_REGISTER(Float8, last_of_quads(Float8 a), last_of_quads(a.part[i]))
GPHYS_BY_REGISTER(Float8, without_last_of_quads(Float8 a), without_last_of_quads(a.part[i]))

}  // namespace gphys::GPHYS_ISA
