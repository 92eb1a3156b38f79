// A vector of doubles in one register, for kernels (isa.h) that have a single query: the interface of Vec<double>
// (vec.h) with a third of its instructions. Sets without registers of four doubles take Vec<double> itself.
#pragma once

#include "foundation/compiler.h"
#include "foundation/longest_axis.h"
#include "foundation/simd.h"
#include "foundation/vec.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_HAS_AVX2

/// x, y, z, x: the fourth lane repeats the first, so it raises no other exception and does not change the greatest.
struct Axes {
    __m256d v;

    Axes() = default;
    GPHYS_INLINE Axes(__m256d value) : v(value) {}
    GPHYS_INLINE Axes(double x, double y, double z) : v(_mm256_setr_pd(x, y, z, x)) {}

    GPHYS_INLINE double operator[](int axis) const {
        alignas(32) double all[4];
        _mm256_store_pd(all, v);
        return all[axis];
    }
};

GPHYS_INLINE Axes axes_of(const Vec<double>& a) { return {a.x, a.y, a.z}; }
GPHYS_INLINE Axes operator+(Axes a, Axes b) { return _mm256_add_pd(a.v, b.v); }
GPHYS_INLINE Axes operator-(Axes a, Axes b) { return _mm256_sub_pd(a.v, b.v); }
GPHYS_INLINE Axes operator-(Axes a) { return _mm256_xor_pd(_mm256_set1_pd(-0.0), a.v); }
GPHYS_INLINE Axes operator*(Axes a, double s) { return _mm256_mul_pd(a.v, _mm256_set1_pd(s)); }
GPHYS_INLINE Axes operator/(Axes a, double s) { return _mm256_div_pd(a.v, _mm256_set1_pd(s)); }
GPHYS_INLINE Axes plus(Axes a, double s) { return _mm256_add_pd(a.v, _mm256_set1_pd(s)); }
GPHYS_INLINE Axes minus(Axes a, double s) { return _mm256_sub_pd(a.v, _mm256_set1_pd(s)); }
GPHYS_INLINE Axes by_component(Axes a, Axes b) { return _mm256_mul_pd(a.v, b.v); }
GPHYS_INLINE Axes quotients(double s, Axes a) { return _mm256_div_pd(_mm256_set1_pd(s), a.v); }
GPHYS_INLINE Axes quotients(Axes a, Axes b) { return _mm256_div_pd(a.v, b.v); }
GPHYS_INLINE Axes abs(Axes a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
GPHYS_INLINE Axes with_signs(Axes a, Axes sign) {
    const __m256d mask = _mm256_set1_pd(-0.0);
    return _mm256_or_pd(_mm256_andnot_pd(mask, a.v), _mm256_and_pd(mask, sign.v));
}
GPHYS_INLINE Axes min(Axes a, Axes b) { return _mm256_min_pd(b.v, a.v); }
GPHYS_INLINE Axes max(Axes a, Axes b) { return _mm256_max_pd(b.v, a.v); }
GPHYS_INLINE Axes at_least(Axes a, double b) { return _mm256_max_pd(_mm256_set1_pd(b), a.v); }
GPHYS_INLINE Axes select(bool mask, Axes a, Axes b) { return mask ? a : b; }
GPHYS_INLINE Axes rounded_to_float(Axes a) { return _mm256_cvtps_pd(_mm256_cvtpd_ps(a.v)); }
template <int a, int b, int c, int d>
GPHYS_INLINE Axes permuted(Axes v) {
    return _mm256_permute4x64_pd(v.v, a | b << 2 | c << 4 | d << 6);
}
GPHYS_INLINE __m256d greatest_of(Axes a) {
    const Axes halves = max(a, permuted<2, 3, 0, 1>(a));
    return max(halves, _mm256_permute_pd(halves.v, 0x5)).v;
}
GPHYS_INLINE double max_component(Axes a) { return _mm256_cvtsd_f64(greatest_of(a)); }
GPHYS_INLINE double min_component(Axes a) {
    const Axes halves = min(a, permuted<2, 3, 0, 1>(a));
    return _mm256_cvtsd_f64(min(halves, _mm256_permute_pd(halves.v, 0x5)).v);
}

GPHYS_INLINE double dot(Axes a, Axes b) {
    const __m256d products = _mm256_mul_pd(a.v, b.v);
    const __m128d xy = _mm256_castpd256_pd128(products), z = _mm256_extractf128_pd(products, 1);
    return _mm_cvtsd_f64(xy) + _mm_cvtsd_f64(_mm_unpackhi_pd(xy, xy)) + _mm_cvtsd_f64(z);
}

/// Of the greatest component, the first of equal ones (math.h).
GPHYS_INLINE int longest_axis(Axes a) {
    const Axes size = abs(a);
    return lowest_bit(static_cast<uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(size.v, greatest_of(size), _CMP_EQ_OS))));
}

/// From x, y, z, x.
GPHYS_INLINE void load(const double (&from)[4], Axes& to) { to.v = _mm256_loadu_pd(from); }
/// As floats; the fourth is arbitrary.
GPHYS_INLINE void store_narrowed(float (&to)[4], Axes a) { _mm_storeu_ps(to, _mm256_cvtpd_ps(a.v)); }
GPHYS_INLINE void store(double (&to)[4], Axes a) { _mm256_storeu_pd(to, a.v); }
/// Bit k: whether component k has a minus sign.
GPHYS_INLINE uint32_t signs_of(Axes a) { return static_cast<uint32_t>(_mm256_movemask_pd(a.v)); }

#else

using Axes = Vec<double>;
GPHYS_INLINE const Axes& axes_of(const Vec<double>& a) { return a; }

#endif

}  // namespace gphys::GPHYS_ISA
