// Doubles, one or eight side by side, for kernels (isa.h) that are written once for both: what a lane
// computes does not depend on the others, nor on how many there are.
#pragma once

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_ISA_IS(avx512)
constexpr int double_register_lanes = 8;
#elif GPHYS_ISA_IS(avx2)
constexpr int double_register_lanes = 4;
#else
constexpr int double_register_lanes = 2;
#endif
constexpr int double_register_count = 8 / double_register_lanes;
using DoubleRegister = double __attribute__((vector_size(8 * double_register_lanes)));
using DoubleMaskRegister = int64_t __attribute__((vector_size(8 * double_register_lanes)));

struct Double8 {
    DoubleRegister part[double_register_count];

    Double8() = default;
    [[gnu::always_inline]] Double8(double all) {
        for (DoubleRegister& p : part) p = all - DoubleRegister{};
    }
};
#if GPHYS_ISA_IS(avx512)
/// Bit i is set if lane i is.
struct DoubleMask8 {
    __mmask8 lanes;
};
#else
/// All bits of a lane are set or none.
struct DoubleMask8 {
    DoubleMaskRegister part[double_register_count];
};
#endif

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
#if GPHYS_ISA_IS(avx512)
        part = _mm512_sqrt_pd(part);
#elif GPHYS_ISA_IS(avx2)
        part = _mm256_sqrt_pd(part);
#elif GPHYS_ISA_IS(sse2)
        part = _mm_sqrt_pd(part);
#elif GPHYS_ISA_IS(neon)
        part = vsqrtq_f64(part);
#elif GPHYS_ISA_IS(wasm)
        part = reinterpret_cast<DoubleRegister>(wasm_f64x2_sqrt(reinterpret_cast<v128_t>(part)));
#else
        part = DoubleRegister{__builtin_sqrt(part[0]), __builtin_sqrt(part[1])};
#endif
    }
    return a;
}

/// Without their signs; and with the signs of others, which may be those of zeros.
inline Double8 absolute(Double8 a) {
    for (DoubleRegister& part : a.part) {
        part = reinterpret_cast<DoubleRegister>(reinterpret_cast<DoubleMaskRegister>(part) & INT64_MAX);
    }
    return a;
}
inline Double8 with_sign(Double8 a, Double8 sign) {
    a = absolute(a);
    for (int i = 0; i < double_register_count; ++i) {
        const DoubleMaskRegister bits = reinterpret_cast<DoubleMaskRegister>(sign.part[i]) & INT64_MIN;
        a.part[i] = reinterpret_cast<DoubleRegister>(reinterpret_cast<DoubleMaskRegister>(a.part[i]) | bits);
    }
    return a;
}

#if GPHYS_ISA_IS(avx512)
inline DoubleMask8 operator<(Double8 a, Double8 b) { return {_mm512_cmp_pd_mask(a.part[0], b.part[0], _CMP_LT_OS)}; }
inline DoubleMask8 operator<=(Double8 a, Double8 b) { return {_mm512_cmp_pd_mask(a.part[0], b.part[0], _CMP_LE_OS)}; }
inline DoubleMask8 operator|(DoubleMask8 a, DoubleMask8 b) { return {_kor_mask8(a.lanes, b.lanes)}; }
inline DoubleMask8 operator&(DoubleMask8 a, DoubleMask8 b) { return {_kand_mask8(a.lanes, b.lanes)}; }
inline DoubleMask8 operator!(DoubleMask8 a) { return {_knot_mask8(a.lanes)}; }
inline Double8 select(DoubleMask8 mask, Double8 a, Double8 b) {
    a.part[0] = _mm512_mask_blend_pd(mask.lanes, b.part[0], a.part[0]);
    return a;
}
/// Bit i is set if lane i is.
inline uint32_t bits(DoubleMask8 mask) { return mask.lanes; }
inline bool any(DoubleMask8 mask) { return mask.lanes != 0; }
#else
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
inline DoubleMask8 operator!(DoubleMask8 a) {
    for (DoubleMaskRegister& part : a.part) part = ~part;
    return a;
}
inline Double8 select(DoubleMask8 mask, Double8 a, Double8 b) {
    for (int i = 0; i < double_register_count; ++i) {
#if GPHYS_ISA_IS(avx2)
        a.part[i] = _mm256_blendv_pd(b.part[i], a.part[i], reinterpret_cast<__m256d>(mask.part[i]));
#else
        a.part[i] = mask.part[i] ? a.part[i] : b.part[i];
#endif
    }
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
#endif

inline double least(double a, double b) { return a < b ? a : b; }
inline double largest(double a, double b) { return a < b ? b : a; }
inline Double8 least(Double8 a, Double8 b) {
#if GPHYS_ISA_IS(avx512)
    a.part[0] = _mm512_min_pd(a.part[0], b.part[0]);
    return a;
#elif GPHYS_ISA_IS(avx2)
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
#if GPHYS_ISA_IS(avx512)
    a.part[0] = _mm512_max_pd(b.part[0], a.part[0]);
    return a;
#elif GPHYS_ISA_IS(avx2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm256_max_pd(b.part[i], a.part[i]);
    return a;
#elif GPHYS_ISA_IS(sse2)
    for (int i = 0; i < double_register_count; ++i) a.part[i] = _mm_max_pd(b.part[i], a.part[i]);
    return a;
#else
    return select(a < b, b, a);
#endif
}

/// Rounded to floats, and floats as they are.
inline Float8 narrowed(Double8 a) {
#if GPHYS_ISA_IS(avx512)
    return {{_mm512_cvtpd_ps(a.part[0])}};
#elif GPHYS_ISA_IS(avx2)
    return {{_mm256_set_m128(_mm256_cvtpd_ps(a.part[1]), _mm256_cvtpd_ps(a.part[0]))}};
#elif GPHYS_ISA_IS(sse2)
    const auto half = [&](int i) {
        return _mm_movelh_ps(_mm_cvtpd_ps(a.part[2 * i]), _mm_cvtpd_ps(a.part[2 * i + 1]));
    };
    return {{half(0), half(1)}};
#else
    float narrow[8];
    for (int i = 0; i < 8; ++i) {
        narrow[i] = static_cast<float>(a.part[i / double_register_lanes][i % double_register_lanes]);
    }
    return load(narrow);
#endif
}
inline Double8 widened(Float8 a) {
    Double8 wide;
#if GPHYS_ISA_IS(avx512)
    wide.part[0] = _mm512_cvtps_pd(a.part[0]);
#elif GPHYS_ISA_IS(avx2)
    wide.part[0] = _mm256_cvtps_pd(_mm256_castps256_ps128(a.part[0]));
    wide.part[1] = _mm256_cvtps_pd(_mm256_extractf128_ps(a.part[0], 1));
#elif GPHYS_ISA_IS(sse2)
    for (int i = 0; i < 2; ++i) {
        wide.part[2 * i] = _mm_cvtps_pd(a.part[i]);
        wide.part[2 * i + 1] = _mm_cvtps_pd(_mm_movehl_ps(a.part[i], a.part[i]));
    }
#else
    for (int i = 0; i < 8; ++i) {
        wide.part[i / double_register_lanes][i % double_register_lanes] =
            static_cast<double>(a.part[i / register_lanes][i % register_lanes]);
    }
#endif
    return wide;
}

inline Double8 rounded_to_float(Double8 a) { return widened(narrowed(a)); }

#if GPHYS_ISA_IS(avx512)
/// Within each half of the registers, which hold four rows twice: rows become columns, and back.
inline void transpose(__m512d (&v)[4]) {
    const __m512d a = _mm512_unpacklo_pd(v[0], v[1]), b = _mm512_unpackhi_pd(v[0], v[1]);
    const __m512d c = _mm512_unpacklo_pd(v[2], v[3]), d = _mm512_unpackhi_pd(v[2], v[3]);
    const __m512i even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    v[0] = _mm512_permutex2var_pd(a, even, c);
    v[1] = _mm512_permutex2var_pd(b, even, d);
    v[2] = _mm512_permutex2var_pd(a, odd, c);
    v[3] = _mm512_permutex2var_pd(b, odd, d);
}
#elif GPHYS_ISA_IS(avx2)
/// Rows become columns, and back.
inline void transpose(__m256d (&v)[4]) {
    const __m256d a = _mm256_unpacklo_pd(v[0], v[1]), b = _mm256_unpackhi_pd(v[0], v[1]);
    const __m256d c = _mm256_unpacklo_pd(v[2], v[3]), d = _mm256_unpackhi_pd(v[2], v[3]);
    v[0] = _mm256_permute2f128_pd(a, c, 0x20);
    v[1] = _mm256_permute2f128_pd(b, d, 0x20);
    v[2] = _mm256_permute2f128_pd(a, c, 0x31);
    v[3] = _mm256_permute2f128_pd(b, d, 0x31);
}
#endif

#if GPHYS_ISA_IS(avx512) || GPHYS_ISA_IS(avx2)
/// Eight rows of four doubles, row(i), as four columns of eight.
template <class Row>
[[gnu::always_inline]] inline void columns_of(const Row& row, Double8 (&to)[4]) {
#if GPHYS_ISA_IS(avx512)
    __m512d v[4];
    for (int i = 0; i < 4; ++i) v[i] = _mm512_insertf64x4(_mm512_castpd256_pd512(row(i)), row(i + 4), 1);
    transpose(v);
    for (int k = 0; k < 4; ++k) to[k].part[0] = v[k];
#else
    for (int half = 0; half < 2; ++half) {
        __m256d v[4];
        for (int i = 0; i < 4; ++i) v[i] = row(4 * half + i);
        transpose(v);
        for (int k = 0; k < 4; ++k) to[k].part[half] = v[k];
    }
#endif
}
/// And back: give(i, row).
template <class Give>
[[gnu::always_inline]] inline void give_rows_of(const Double8 (&from)[4], const Give& give) {
#if GPHYS_ISA_IS(avx512)
    __m512d v[4] = {from[0].part[0], from[1].part[0], from[2].part[0], from[3].part[0]};
    transpose(v);
    for (int i = 0; i < 4; ++i) give(i, _mm512_castpd512_pd256(v[i])), give(i + 4, _mm512_extractf64x4_pd(v[i], 1));
#else
    for (int half = 0; half < 2; ++half) {
        __m256d v[4];
        for (int k = 0; k < 4; ++k) v[k] = from[k].part[half];
        transpose(v);
        for (int i = 0; i < 4; ++i) give(4 * half + i, v[i]);
    }
#endif
}
#endif

/// Doubles behind one another at each of eight places, component by component: at(i) is where.
template <int count, class At>
[[gnu::always_inline]] inline void load_components(const At& at, Double8 (&to)[count]) {
    for (int k = 0; k < count; ++k) {
        for (int i = 0; i < double_register_count; ++i) {
            const int first = double_register_lanes * i;
#if GPHYS_ISA_IS(avx512)
            to[k].part[i] = DoubleRegister{at(first)[k],     at(first + 1)[k], at(first + 2)[k], at(first + 3)[k],
                                           at(first + 4)[k], at(first + 5)[k], at(first + 6)[k], at(first + 7)[k]};
#elif GPHYS_ISA_IS(avx2)
            to[k].part[i] = DoubleRegister{at(first)[k], at(first + 1)[k], at(first + 2)[k], at(first + 3)[k]};
#else
            to[k].part[i] = DoubleRegister{at(first)[k], at(first + 1)[k]};
#endif
        }
    }
}
template <int count, class At>
[[gnu::always_inline]] inline void store_components(const At& at, const Double8 (&from)[count]) {
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < count; ++k) at(i)[k] = from[k].part[i / double_register_lanes][i % double_register_lanes];
    }
}
/// One at a single place.
template <int count, class At>
[[gnu::always_inline]] inline void load_components(const At& at, double (&to)[count]) {
    for (int k = 0; k < count; ++k) to[k] = at(0)[k];
}
template <int count, class At>
[[gnu::always_inline]] inline void store_components(const At& at, const double (&from)[count]) {
    for (int k = 0; k < count; ++k) at(0)[k] = from[k];
}

#if GPHYS_ISA_IS(avx512) || GPHYS_ISA_IS(avx2)
template <class At>
[[gnu::always_inline]] inline void load_components(const At& at, Double8 (&to)[4]) {
    columns_of([&](int i) { return _mm256_loadu_pd(at(i)); }, to);
}
template <class At>
[[gnu::always_inline]] inline void store_components(const At& at, const Double8 (&from)[4]) {
    give_rows_of(from, [&](int i, __m256d row) { _mm256_storeu_pd(at(i), row); });
}
/// Nothing behind the third is touched.
template <class At>
[[gnu::always_inline]] inline void load_components(const At& at, Double8 (&to)[3]) {
    const __m256i three = _mm256_setr_epi64x(-1, -1, -1, 0);
    Double8 all[4];
    columns_of([&](int i) { return _mm256_maskload_pd(at(i), three); }, all);
    for (int k = 0; k < 3; ++k) to[k] = all[k];
}
template <class At>
[[gnu::always_inline]] inline void store_components(const At& at, const Double8 (&from)[3]) {
    const Double8 all[4] = {from[0], from[1], from[2], from[2]};
    give_rows_of(all, [&](int i, __m256d row) {
        _mm_storeu_pd(at(i), _mm256_castpd256_pd128(row));
        _mm_store_sd(at(i) + 2, _mm256_extractf128_pd(row, 1));
    });
}
#endif

}  // namespace gphys::GPHYS_ISA
