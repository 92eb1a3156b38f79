// Rotations of the vectors of simd_axes.h, for kernels that have a single query, with the bits of rotation.h. A model
// stores its position, rotation and scale as eight floats.
#pragma once

#include "foundation/compiler.h"
#include "foundation/rotation.h"
#include "foundation/simd_axes.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_HAS_AVX2

GPHYS_INLINE Axes splat_axes(double value) { return _mm256_set1_pd(value); }
/// Three of four floats, and the first of them again.
template <int x, int y, int z>
GPHYS_INLINE Axes widened(const float* four) {
    return _mm256_cvtps_pd(_mm_permute_ps(_mm_loadu_ps(four), x | y << 2 | z << 4 | x << 6));
}
template <int k>
GPHYS_INLINE Axes component(Axes v) {
    return permuted<k, k, k, k>(v);
}
/// The lanes of `mask` from b, the others from a.
template <int mask>
GPHYS_INLINE Axes blended(Axes a, Axes b) {
    return _mm256_blend_pd(a.v, b.v, mask);
}

/// By columns.
struct AxesMatrix {
    Axes x, y, z;

    GPHYS_INLINE Axes operator*(Axes v) const {
        return by_component(x, component<0>(v)) + by_component(y, component<1>(v)) + by_component(z, component<2>(v));
    }
    GPHYS_INLINE Axes operator*(const Vec<double>& v) const { return x * v.x + y * v.y + z * v.z; }
};
GPHYS_INLINE AxesMatrix operator*(const AxesMatrix& a, const AxesMatrix& b) { return {a * b.x, a * b.y, a * b.z}; }
GPHYS_INLINE AxesMatrix transposed(const AxesMatrix& m) {
    const Axes low = _mm256_unpacklo_pd(m.x.v, m.y.v), high = _mm256_unpackhi_pd(m.x.v, m.y.v);
    return {blended<0xc>(low, component<0>(m.z)), blended<0xc>(high, component<1>(m.z)),
            _mm256_permute2f128_pd(low.v, m.z.v, 0x31)};
}

/// Scalar form: rotation_matrix (rotation.h).
GPHYS_INLINE AxesMatrix rotation_matrix(const float* quaternion) {
    const Axes q = _mm256_cvtps_pd(_mm_loadu_ps(quaternion)), squares = by_component(q, q);
    const __m128d xy = _mm256_castpd256_pd128(squares.v), zw = _mm256_extractf128_pd(squares.v, 1);
    const auto second = [](__m128d pair) { return _mm_cvtsd_f64(_mm_unpackhi_pd(pair, pair)); };
    const double norm_squared = _mm_cvtsd_f64(xy) + second(xy) + _mm_cvtsd_f64(zw) + second(zw);
    const Axes p = q * (2.0 / norm_squared), same = by_component(p, q);
    const Axes diagonal = splat_axes(1) - permuted<1, 0, 0, 1>(same) - permuted<2, 2, 1, 2>(same);
    // xy, xz, yz and wz, wy, wx
    const Axes products = by_component(permuted<0, 0, 1, 0>(p), permuted<1, 2, 2, 1>(q));
    const Axes turns = by_component(component<3>(p), permuted<2, 1, 0, 2>(q));
    const Axes sums = products + turns, differences = products - turns;
    const Axes swapped_sums = _mm256_permute_pd(sums.v, 0x5), moved = permuted<0, 2, 1, 3>(differences);
    return {blended<4>(blended<2>(diagonal, swapped_sums), moved), blended<4>(blended<1>(diagonal, differences), sums),
            blended<2>(blended<1>(diagonal, swapped_sums), moved)};
}

/// The fourth lane repeats the first again.
GPHYS_INLINE Axes repeated(Axes a) { return permuted<0, 1, 2, 0>(a); }

#else

using AxesMatrix = Matrix<double>;

GPHYS_INLINE AxesMatrix rotation_matrix(const float* quaternion) {
    return gphys::rotation_matrix(Quaternion<double>{quaternion[0], quaternion[1], quaternion[2], quaternion[3]});
}
template <int x, int y, int z>
GPHYS_INLINE Axes widened(const float* four) {
    return {four[x], four[y], four[z]};
}
GPHYS_INLINE const Axes& repeated(const Axes& a) { return a; }

#endif

}  // namespace gphys::GPHYS_ISA
