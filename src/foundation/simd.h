// Eight floats side by side, and the one place with intrinsics. Everything is plain IEEE arithmetic
// without fused operations, so each instruction set gives the same bits.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace gphys {

// Vectors of the compilers' own extension, as wide as the registers of the target.
#if defined(__AVX__)
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

/// All bits of a lane are set or none.
struct Mask8 {
    MaskRegister part[register_count];
};

inline Float8 load(const float* from) {
    Float8 v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store(float* to, Float8 v) { std::memcpy(to, &v, sizeof v); }
inline Float8 splat(float value) {
    Float8 v;
    for (FloatRegister& part : v.part) part = value - FloatRegister{};
    return v;
}

inline FloatRegister minimum(FloatRegister a, FloatRegister b) {
#if defined(__AVX__)
    return _mm256_min_ps(a, b);
#elif defined(__SSE2__)
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
inline FloatRegister maximum(FloatRegister a, FloatRegister b) {
#if defined(__AVX__)
    return _mm256_max_ps(a, b);
#elif defined(__SSE2__)
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}
/// Bit i is set if lane i is.
inline uint32_t lane_bits(MaskRegister mask) {
#if defined(__AVX__)
    return static_cast<uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
    return static_cast<uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
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
/// Bit i is set if lane i is.
inline uint32_t bits(Mask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < register_count; ++i) result |= lane_bits(mask.part[i]) << (register_lanes * i);
    return result;
}

}  // namespace gphys
