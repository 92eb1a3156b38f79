// Doubles, one or eight side by side, for kernels (isa.h) that are written once for both: what a lane
// computes does not depend on the others, nor on how many there are.
#pragma once

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_ISA_IS(avx2)
constexpr int double_register_lanes = 4;
#else
constexpr int double_register_lanes = 2;
#endif
constexpr int double_register_count = 8 / double_register_lanes;
using DoubleRegister = double __attribute__((vector_size(8 * double_register_lanes)));
using DoubleMaskRegister = int64_t __attribute__((vector_size(8 * double_register_lanes)));

struct Double8 {
    DoubleRegister part[double_register_count];
};
/// All bits of a lane are set or none.
struct DoubleMask8 {
    DoubleMaskRegister part[double_register_count];
};

template <int lanes>
struct DoublesOf;
template <>
struct DoublesOf<1> {
    using Value = double;
    using Mask = bool;
};
template <>
struct DoublesOf<8> {
    using Value = Double8;
    using Mask = DoubleMask8;
};
template <int lanes>
using Doubles = typename DoublesOf<lanes>::Value;

inline double load(const double (&from)[1]) { return from[0]; }
inline void store(double (&to)[1], double value) { to[0] = value; }
inline double square_root(double a) { return __builtin_sqrt(a); }
inline double select(bool mask, double a, double b) { return mask ? a : b; }
inline bool any(bool mask) { return mask; }

inline Double8 load_doubles(const double* from) {
    Double8 v;
    for (int i = 0; i < double_register_count; ++i) {
        std::memcpy(&v.part[i], from + double_register_lanes * i, sizeof v.part[i]);
    }
    return v;
}
inline void store_doubles(double* to, Double8 v) {
    for (int i = 0; i < double_register_count; ++i) {
        std::memcpy(to + double_register_lanes * i, &v.part[i], sizeof v.part[i]);
    }
}
inline Double8 load(const double (&from)[8]) { return load_doubles(from); }
inline void store(double (&to)[8], Double8 v) { store_doubles(to, v); }
template <int lanes>
Doubles<lanes> all_of(double value) {
    if constexpr (lanes == 1) {
        return value;
    } else {
        Double8 v;
        for (DoubleRegister& part : v.part) part = value - DoubleRegister{};
        return v;
    }
}

inline Double8 operator+(Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] += b.part[i];
    return a;
}
inline Double8 operator-(Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] -= b.part[i];
    return a;
}
inline Double8 operator*(Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] *= b.part[i];
    return a;
}
inline Double8 operator/(Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] /= b.part[i];
    return a;
}
inline Double8 operator-(Double8 a) {
    for (DoubleRegister& part : a.part) part = -part;
    return a;
}
inline Double8 square_root(Double8 a) {
    for (DoubleRegister& part : a.part) {
#if GPHYS_ISA_IS(avx2)
        part = _mm256_sqrt_pd(part);
#elif GPHYS_ISA_IS(sse2)
        part = _mm_sqrt_pd(part);
#elif GPHYS_ISA_IS(neon)
        part = vsqrtq_f64(part);
#elif GPHYS_ISA_IS(wasm)
        part = reinterpret_cast<DoubleRegister>(wasm_f64x2_sqrt(reinterpret_cast<v128_t>(part)));
#else
        for (int i = 0; i < double_register_lanes; ++i) part[i] = __builtin_sqrt(part[i]);
#endif
    }
    return a;
}

inline DoubleMask8 operator<(Double8 a, Double8 b) {
    DoubleMask8 mask;
    for (int i = 0; i < double_register_count; ++i) mask.part[i] = a.part[i] < b.part[i];
    return mask;
}
inline DoubleMask8 operator<=(Double8 a, Double8 b) {
    DoubleMask8 mask;
    for (int i = 0; i < double_register_count; ++i) mask.part[i] = a.part[i] <= b.part[i];
    return mask;
}
inline DoubleMask8 operator|(DoubleMask8 a, DoubleMask8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] |= b.part[i];
    return a;
}
inline DoubleMask8 operator&(DoubleMask8 a, DoubleMask8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] &= b.part[i];
    return a;
}
inline Double8 select(DoubleMask8 mask, Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) a.part[i] = mask.part[i] ? a.part[i] : b.part[i];
    return a;
}
/// Bit i is set if lane i is.
inline uint32_t bits(DoubleMask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < double_register_count; ++i) {
#if GPHYS_ISA_IS(avx2)
        const int part = _mm256_movemask_pd(reinterpret_cast<__m256d>(mask.part[i]));
#elif GPHYS_ISA_IS(sse2)
        const int part = _mm_movemask_pd(reinterpret_cast<__m128d>(mask.part[i]));
#else
        const int part = static_cast<int>((mask.part[i][0] & 1) | (mask.part[i][1] & 2));
#endif
        result |= static_cast<uint32_t>(part) << (double_register_lanes * i);
    }
    return result;
}
inline bool any(DoubleMask8 mask) {
    DoubleMaskRegister all = mask.part[0];
    for (int i = 1; i < double_register_count; ++i) all |= mask.part[i];
    int64_t bits = 0;
    for (int i = 0; i < double_register_lanes; ++i) bits |= all[i];
    return bits != 0;
}

inline double least(double a, double b) { return a < b ? a : b; }
inline double largest(double a, double b) { return a < b ? b : a; }
inline Double8 least(Double8 a, Double8 b) {
#if GPHYS_ISA_IS(avx2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm256_min_pd(a.part[i], b.part[i]);
    return a;
#elif GPHYS_ISA_IS(sse2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm_min_pd(a.part[i], b.part[i]);
    return a;
#else
    return select(a < b, a, b);
#endif
}
inline Double8 largest(Double8 a, Double8 b) {
#if GPHYS_ISA_IS(avx2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm256_max_pd(b.part[i], a.part[i]);
    return a;
#elif GPHYS_ISA_IS(sse2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm_max_pd(b.part[i], a.part[i]);
    return a;
#else
    return select(a < b, b, a);
#endif
}

}  // namespace gphys::GPHYS_ISA
